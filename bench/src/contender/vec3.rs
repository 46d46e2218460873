//! A point in space for the libraries that blend whatever can be added and scaled.

use std::ops::{Add, Mul};

#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Vec3(pub(crate) [f64; 3]);

impl Add for Vec3 {
    type Output = Vec3;

    fn add(self, other: Vec3) -> Vec3 {
        Vec3([self.0[0] + other.0[0], self.0[1] + other.0[1], self.0[2] + other.0[2]])
    }
}

impl Mul<f64> for Vec3 {
    type Output = Vec3;

    fn mul(self, factor: f64) -> Vec3 {
        Vec3(self.0.map(|x| x * factor))
    }
}
