//! Polygons on circles and spheres: midpoints are normalised.
//!
//! A Lane–Riesenfeld step of degree p doubles every point and then takes p times the midpoints of neighbours. On a sphere
//! the midpoint of S and E is (S + E)/|S + E|, seen from the centre: the same steps with it keep every point on the sphere. Degree 1
//! keeps the given points and halves their arcs.
//!
//! *Source.* D. Salomon, Curves and Surfaces for Computer Graphics, exercise 4.97.

use crate::error::{Code, Error, Limits, Result};
use crate::space::{IntoPoint, collect, norm};
use crate::subdivide::dyadic::Index;
use crate::subdivide::mask::Target;
use crate::subdivide::polygon::{Ends, Subdivision};
use crate::subdivide::scheme::Scheme;
use alloc::format;
use alloc::vec::Vec;

/// How far a given point may lie off the sphere, in radii: data are often written with six digits.
const OFF: f64 = 1e-5;

/// Midpoints of directions that sum to less than this are all rounding: 2⁻⁴⁰.
const OPPOSITE: f64 = 1.0 / (1u64 << 40) as f64;

/// A polygon on a circle (D = 2), a sphere (D = 3), or its like in any dimension, under spherical subdivision.
///
/// ```
/// use lath::error::Limits;
/// use lath::subdivide::{Ends, Sphere};
///
/// let quarter = [[2.0, 1.0], [1.0, 2.0]];
/// let arc = Sphere::new([1.0, 1.0], 1.0, 1, quarter, Ends::Open)?;
/// let points = arc.level(1, &Limits::default())?;
/// let half = 0.5f64.sqrt();
/// assert!((points[1][0] - 1.0 - half).abs() < 1e-15 && (points[1][1] - 1.0 - half).abs() < 1e-15);
/// assert_eq!((points[0], points[2]), (quarter[0], quarter[1]));
/// # Ok::<(), lath::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Sphere<const D: usize> {
    centre: [f64; D],
    radius: f64,
    /// The unit vectors towards the points, under the scheme: for its counts and windows.
    polygon: Subdivision<D>,
}

impl<const D: usize> Sphere<D> {
    /// A polygon on the sphere of a centre and radius. Given points may lie off by 10⁻⁵ of the radius, and are put onto it.
    ///
    /// # Errors
    /// S008 for a radius that is not positive and finite, and for a point farther off the sphere (with its index); S007 for
    /// antipodal neighbours, whose midpoint could be anywhere; K006 for the degree; P001 – P003 as [`Subdivision::new`].
    pub fn new(
        centre: [f64; D],
        radius: f64,
        degree: usize,
        points: impl IntoIterator<Item = impl IntoPoint<D>>,
        ends: Ends,
    ) -> Result<Sphere<D>> {
        if !(radius > 0.0 && radius.is_finite()) || centre.iter().any(|x| !x.is_finite()) {
            return Err(Error::new(Code::S008, format!("a sphere of radius {radius} around {centre:?}")));
        }
        let mut directions = collect(points)?;
        for (i, point) in directions.iter_mut().enumerate() {
            let arm: [f64; D] = core::array::from_fn(|c| (point[c] - centre[c]) / radius);
            let length = norm(&arm);
            if !(1.0 - OFF..=1.0 + OFF).contains(&length) {
                let message = format!("point {i} is {length} radii from the centre");
                return Err(Error::new(Code::S008, message).at(i));
            }
            *point = arm.map(|x| x / length);
        }
        let closing = directions.first().copied().filter(|_| ends == Ends::Closed);
        for (i, next) in directions.iter().skip(1).chain(&closing).enumerate() {
            midpoint(&directions[i], next, i)?;
        }
        let polygon = Subdivision::new(Scheme::lane_riesenfeld(degree)?, directions, ends)?;
        Ok(Sphere { centre, radius, polygon })
    }

    /// How many points a level has.
    ///
    /// # Errors
    /// S005 for a level above 1000.
    pub fn count(&self, level: usize) -> Result<Index> {
        self.polygon.count(level, Target::Level)
    }

    /// All points of a level.
    ///
    /// *Cost.* O(p) midpoints a point, by passes. *Error.* A few units of the last place of the radius and of the centre for each level.
    ///
    /// # Errors
    /// S007 for antipodal neighbours, with the index in the level that has them; S005, B001, B002 as [`Subdivision::level`].
    pub fn level(&self, level: usize, limits: &Limits<'_>) -> Result<Vec<[f64; D]>> {
        let count = self.count(level)?.saturated();
        limits.check_points(count)?;
        limits.check_bytes(count.saturating_mul(3 * size_of::<[f64; D]>() as u64))?;
        let degree = self.polygon.scheme().degree();
        let closed = self.polygon.is_closed();
        let mut points = self.polygon.control_points().to_vec();
        for _ in 0..level {
            limits.check_cancel()?;
            let n = points.len();
            if closed {
                points.extend((0..degree).map(|i| i % n).map(|i| points[i]).collect::<Vec<_>>());
            }
            points = refined(&points, degree)?;
            if closed {
                points.truncate(2 * n);
            }
        }
        Ok(points.iter().map(|direction| self.placed(direction)).collect())
    }

    /// One point of a level without the rest of it: the same bits.
    ///
    /// *Cost.* O(p²) midpoints for each level.
    ///
    /// # Errors
    /// S006 for an index beyond the level; S007 for antipodal neighbours on the way; S005 for a level above 1000.
    pub fn point(&self, level: usize, index: &Index) -> Result<[f64; D]> {
        let all = self.count(level)?;
        if *index >= all {
            return Err(Error::new(Code::S006, format!("index {index}; level {level} has {all}")));
        }
        let degree = self.polygon.scheme().degree();
        let q = index.shifted_down(level).saturated() as usize;
        let (count, closed) = (self.polygon.control_points().len(), self.polygon.is_closed());
        // As many of the p + 1 points from q on as there are; the missing ones have no part in the answer.
        let mut points: Vec<[f64; D]> =
            (q..=q + degree).filter(|j| closed || *j < count).map(|j| self.polygon.source(j)).collect();
        for place in (0..level).rev() {
            points = refined(&points, degree)?;
            points.drain(..usize::from(index.bit(place)).min(points.len()));
            points.truncate(degree + 1);
        }
        match points.first() {
            Some(direction) => Ok(self.placed(direction)),
            None => Err(Error::new(Code::S006, format!("index {index} of level {level}"))),
        }
    }

    fn placed(&self, direction: &[f64; D]) -> [f64; D] {
        core::array::from_fn(|c| self.centre[c] + self.radius * direction[c])
    }
}

/// One step: every point twice, then p times the midpoints of neighbours.
fn refined<const D: usize>(points: &[[f64; D]], degree: usize) -> Result<Vec<[f64; D]>> {
    let mut next: Vec<[f64; D]> = points.iter().flat_map(|point| [*point, *point]).collect();
    for _ in 0..degree {
        for i in 1..next.len() {
            next[i - 1] = midpoint(&next[i - 1], &next[i], (i / 2).saturating_sub(1))?;
        }
        next.pop();
    }
    Ok(next)
}

/// (S + E)/|S + E| for unit vectors; equal ones are their own midpoint, bit for bit.
fn midpoint<const D: usize>(s: &[f64; D], e: &[f64; D], index: usize) -> Result<[f64; D]> {
    if s == e {
        return Ok(*s);
    }
    let sum: [f64; D] = core::array::from_fn(|c| s[c] + e[c]);
    let length = norm(&sum);
    if length <= OPPOSITE {
        return Err(Error::new(Code::S007, format!("point {index} and the next are antipodal")).at(index));
    }
    Ok(sum.map(|x| x / length))
}
