//! From data to the plane: which two numbers of a point are seen, centred and scaled to the order of one.
//!
//! The centre is subtracted before anything else happens, so that a detail of 1e-3 at an offset of 1e7 keeps all the
//! digits that its coordinates have; and units are divided by, not multiplied with, so that extents down to the
//! smallest numbers work. The plane's y points up; [`Placement`] turns it over on the way to px.

use crate::path::Point;

/// A point of the data as the picture sees it: (x, y, z), zeros where there are fewer; (t, f, 0) for a graph.
pub(crate) type Spot = [f64; 3];

/// What kind of picture it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum View {
    /// One dimension: the graph over t, each axis with its own unit.
    Graph,
    /// Two dimensions, equal aspect.
    Plane,
    /// Three or more: the first three in parallel projection, `right` and `up` on the page.
    Space { right: Spot, up: Spot },
}

impl View {
    /// A parallel projection along the direction in which a camera stands: `azimuth` degrees from x towards y, and
    /// `elevation` degrees above the xy-plane. (−90, 0) looks along y with x to the right and z up; (−90, 90) is the plan.
    pub(crate) fn space(azimuth: f64, elevation: f64) -> View {
        let (sa, ca) = sin_cos(azimuth);
        let (se, ce) = sin_cos(elevation);
        View::Space { right: [-sa, ca, 0.0], up: [-se * ca, -se * sa, ce] }
    }

    /// The direction towards the camera.
    pub(crate) fn towards(&self) -> Spot {
        match self {
            View::Space { right: r, up: u } => {
                [r[1] * u[2] - r[2] * u[1], r[2] * u[0] - r[0] * u[2], r[0] * u[1] - r[1] * u[0]]
            }
            _ => [0.0, 0.0, 1.0],
        }
    }
}

/// Sine and cosine of degrees, exact at multiples of 90.
fn sin_cos(degrees: f64) -> (f64, f64) {
    let turn = degrees % 360.0;
    let quarter = (turn / 90.0).round();
    let rest = (turn - 90.0 * quarter).to_radians();
    let (s, c) = (libm::sin(rest), libm::cos(rest));
    match (quarter as i64).rem_euclid(4) {
        0 => (s, c),
        1 => (c, -s),
        2 => (-s, -c),
        _ => (-c, s),
    }
}

/// The box of spots.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Reach {
    pub(crate) lo: Spot,
    pub(crate) hi: Spot,
}

impl Reach {
    pub(crate) const EMPTY: Reach = Reach { lo: [f64::INFINITY; 3], hi: [f64::NEG_INFINITY; 3] };

    /// Takes in a spot; what is not finite is nowhere.
    pub(crate) fn include(&mut self, spot: &Spot) {
        if !spot.iter().all(|x| x.is_finite()) {
            return;
        }
        for c in 0..3 {
            if spot[c] < self.lo[c] {
                self.lo[c] = spot[c];
            }
            if spot[c] > self.hi[c] {
                self.hi[c] = spot[c];
            }
        }
    }

    pub(crate) fn is_finite(&self) -> bool {
        self.lo.iter().chain(&self.hi).all(|x| x.is_finite())
    }
}

/// The map from data to the plane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lens {
    pub(crate) view: View,
    pub(crate) centre: Spot,
    pub(crate) unit: Spot,
}

impl Lens {
    /// Centred on the box and scaled by its size; what has no size is scaled by its distance from zero.
    pub(crate) fn new(view: View, reach: &Reach) -> Lens {
        let reach = if reach.is_finite() { *reach } else { Reach { lo: [0.0; 3], hi: [0.0; 3] } };
        let middle = |lo: f64, hi: f64| if lo == hi { lo } else { lo / 2.0 + hi / 2.0 };
        let centre: Spot = core::array::from_fn(|c| middle(reach.lo[c], reach.hi[c]));
        let size: Spot = core::array::from_fn(|c| reach.hi[c] - reach.lo[c]);
        let stand_in = |size: f64, place: f64| match (size > 0.0, place != 0.0) {
            (true, _) => size,
            (false, true) => place.abs(),
            (false, false) => 1.0,
        };
        let unit = if view == View::Graph {
            core::array::from_fn(|c| stand_in(size[c], centre[c]))
        } else {
            let largest = |v: Spot| v.into_iter().fold(0.0, |m: f64, x| if x.abs() > m { x.abs() } else { m });
            [stand_in(largest(size), largest(centre)); 3]
        };
        Lens { view, centre, unit }
    }

    /// A point of the data in the plane.
    pub(crate) fn plane(&self, spot: &Spot) -> Point {
        self.vector(&core::array::from_fn(|c| spot[c] - self.centre[c]))
    }

    /// A difference of two points in the plane.
    pub(crate) fn vector(&self, spot: &Spot) -> Point {
        self.project(&core::array::from_fn(|c| spot[c] / self.unit[c]))
    }

    /// What the page sees of a vector in units.
    pub(crate) fn project(&self, v: &Spot) -> Point {
        match &self.view {
            View::Space { right, up } => {
                let dot = |a: &Spot| a[0] * v[0] + a[1] * v[1] + a[2] * v[2];
                [dot(right), dot(up)]
            }
            _ => [v[0], v[1]],
        }
    }

    /// The coordinate `axis` of the data at a coordinate of the plane (graph and plane views).
    pub(crate) fn value(&self, axis: usize, plane: f64) -> f64 {
        self.centre[axis] + self.unit[axis] * plane
    }

    /// The coordinate of the plane for a coordinate of the data (graph and plane views).
    pub(crate) fn coordinate(&self, axis: usize, value: f64) -> f64 {
        (value - self.centre[axis]) / self.unit[axis]
    }
}

/// From the plane to px.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Placement {
    pub(crate) scale: [f64; 2],
    pub(crate) origin: Point,
}

impl Placement {
    pub(crate) fn px(&self, p: Point) -> Point {
        [self.origin[0] + self.scale[0] * p[0], self.origin[1] - self.scale[1] * p[1]]
    }

    /// Back from px to the plane.
    pub(crate) fn plane(&self, p: Point) -> Point {
        [(p[0] - self.origin[0]) / self.scale[0], (self.origin[1] - p[1]) / self.scale[1]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn detail_survives_an_offset() {
        let reach = Reach { lo: [1e7, -1e7, 0.0], hi: [1e7 + 1e-3, -1e7 + 5e-4, 0.0] };
        let lens = Lens::new(View::Plane, &reach);
        let [x, _] = lens.plane(&[1e7 + 1e-3, -1e7, 0.0]);
        assert!((x - 0.5).abs() < 1e-5, "{x}");
    }

    #[test]
    fn nothing_is_divided_by_zero() {
        for lo in [0.0, -3.0, 1e300, 5e-324] {
            for view in [View::Graph, View::Plane, View::space(-60.0, 30.0)] {
                let lens = Lens::new(view, &Reach { lo: [lo; 3], hi: [lo; 3] });
                assert_eq!(lens.plane(&[lo; 3]), [0.0, 0.0]);
            }
        }
        let lens = Lens::new(View::Plane, &Reach { lo: [-1e300; 3], hi: [1e300; 3] });
        assert_eq!(lens.plane(&[1e300, -1e300, 0.0]), [0.5, -0.5]);
        assert_eq!(Lens::new(View::Plane, &Reach::EMPTY).unit, [1.0; 3]);
    }

    #[test]
    fn the_main_views_are_exact() {
        assert_eq!(View::space(-90.0, 0.0), View::Space { right: [1.0, 0.0, 0.0], up: [0.0, 0.0, 1.0] });
        assert_eq!(View::space(270.0, 90.0), View::Space { right: [1.0, 0.0, 0.0], up: [0.0, 1.0, 0.0] });
        assert_eq!(View::space(-90.0, 0.0).towards(), [0.0, -1.0, 0.0]);
    }
}
