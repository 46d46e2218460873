//! The crate `geo`: Chaikin's corner cutting of rings, step by step.

use crate::Result;
use crate::subdivision::{CutsCorners, STEPS};
use geo::{ChaikinSmoothing, Coord, LineString};

pub(crate) struct Geo;

impl CutsCorners for Geo {
    const NAME: &'static str = "geo 0.33";
    /// The first point stands at the end again.
    type Ring = LineString<f64>;
    type Cut = LineString<f64>;

    fn ring(points: &[[f64; 2]]) -> LineString<f64> {
        points.iter().chain(points.first()).map(|[x, y]| Coord { x: *x, y: *y }).collect()
    }

    fn cut(ring: &LineString<f64>) -> Result<LineString<f64>> {
        Ok(ring.chaikin_smoothing(STEPS))
    }

    fn points(cut: &LineString<f64>) -> Vec<[f64; 2]> {
        cut.0[..cut.0.len() - 1].iter().map(|point| [point.x, point.y]).collect()
    }
}
