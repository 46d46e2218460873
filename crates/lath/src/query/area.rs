//! The area that a plane curve goes around, and where its middle is.

use crate::curve::Curve;
use crate::error::{Code, Error, Number, Result};
use crate::knot::Side;
use crate::num::Bound;
use crate::num::gauss::RULES;
use crate::query::bounds::bounds;
use crate::query::length::Sum;
use crate::space::distance;
use alloc::format;
use alloc::vec::Vec;

/// The unit of rounding, 2⁻⁵³.
const UNIT: f64 = f64::EPSILON / 2.0;

/// Ends meet if they are no further apart than this part of the size of the box: 2⁻⁴⁰.
const MEETING: f64 = 1.0 / (1u64 << 40) as f64;

/// What [`area`] answers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area {
    /// The area, in squared units of the points: positive where the curve goes around counter-clockwise, negative clockwise; what it goes around
    /// twice counts twice.
    pub signed: f64,
    /// How far that may be off.
    pub bound: Bound,
    /// The centroid of the area, and how far each of its coordinates may be off; none where the area may be zero.
    pub centroid: Option<([f64; 2], Bound)>,
}

/// The signed area inside a closed plane curve, and its centroid.
///
/// *Idea.* The area is ½∮(x dy − y dx), the moments are ⅓∮x(x dy − y dx) and ⅓∮y(x dy − y dx): for a polynomial piece integrals of products,
/// which Bernstein form gives exactly. Coordinates are taken from the first point, so that nothing is lost far from the origin.
///
/// *Cost.* O(p²) a polynomial piece. Others: 96 derivatives a piece for smooth ones, up to 1024 times as many.
///
/// *Error.* Proven for piecewise polynomial curves; the bound contains the rounding of the sums, not that of the pieces. Other curves, rational ones
/// too: Gauss quadrature, and what halving the intervals changed: an estimate.
///
/// *Degenerate input.* A point has the area 0 and no centroid. Gaps up to 2⁻⁴⁰ of the size of the box are closed by straight lines.
///
/// *Source.* G. Green 1828.
///
/// ```
/// use lath::{curve::Bezier, query::area};
///
/// // The drop x = 3u(1 − u), y = 3u(1 − u)(2u − 1) goes counter-clockwise around 3/10.
/// let drop = Bezier::new([[0.0, 0.0], [1.0, -1.0], [1.0, 1.0], [0.0, 0.0]])?;
/// let found = area(&drop)?;
/// assert!((found.signed - 0.3).abs() <= found.bound.value() && found.bound.is_proven());
/// assert!(found.bound.value() < 1e-13);
/// # Ok::<(), lath::error::Error>(())
/// ```
///
/// # Errors
/// C004 if the curve is not closed: its end is away from its start, or it jumps; P003 for an area that overflows.
pub fn area(curve: &dyn Curve<2>) -> Result<Area> {
    let size = bounds(curve).0.size();
    let size = if size[0] > size[1] { size[0] } else { size[1] };
    let mut start = [[0.0; 2]];
    curve.jet_into(curve.domain().start, Side::Right, &mut start);
    let mut ring = Ring { origin: start[0], scale: power_of_two_above(size), ..Ring::default() };
    let polynomial = curve.bezier_pieces(&mut |piece| ring.polynomial(piece.start, piece.points));
    if !polynomial {
        ring.other(curve);
    }
    // Back to the first point.
    ring.join(curve.domain().end, [0.0, 0.0]);
    let (gap, at) = (ring.gap.0 * ring.scale, ring.gap.1);
    if gap > size * MEETING {
        let message = format!("a gap of {} at t = {}", Number(gap), Number(at));
        return Err(Error::new(Code::C004, message));
    }
    ring.answer(polynomial)
}

/// Sums on the way around, of coordinates about the first point divided by a power of two.
#[derive(Debug, Default)]
struct Ring {
    origin: [f64; 2],
    scale: f64,
    area: Sum,
    moments: [Sum; 2],
    /// How far the sums may be off.
    area_error: f64,
    moment_error: f64,
    /// The end of the way so far.
    end: [f64; 2],
    /// The widest gap on the way, and the parameter where it is.
    gap: (f64, f64),
}

impl Ring {
    fn local(&self, point: &[f64; 2]) -> [f64; 2] {
        core::array::from_fn(|c| (point[c] - self.origin[c]) / self.scale)
    }

    /// Goes straight to where the next piece starts.
    fn join(&mut self, t: f64, next: [f64; 2]) {
        let gap = distance(&self.end, &next);
        if gap == 0.0 {
            return;
        }
        if gap > self.gap.0 {
            self.gap = (gap, t);
        }
        let (from, step) = (self.end, [next[0] - self.end[0], next[1] - self.end[1]]);
        self.add(&[from[0], next[0]], &[from[1], next[1]], &[step[0]], &[step[1]]);
        self.end = next;
    }

    fn polynomial(&mut self, start: f64, points: &[[f64; 2]]) {
        let (Some(first), Some(last)) = (points.first(), points.last()) else { return };
        self.join(start, self.local(first));
        self.end = self.local(last);
        if points.len() == 1 {
            return;
        }
        let values = |c: usize| points.iter().map(|p| self.local(p)[c]).collect::<Vec<f64>>();
        let steps = |c: usize| points.windows(2).map(|p| (p[1][c] - p[0][c]) / self.scale).collect::<Vec<f64>>();
        let (x, y, dx, dy) = (values(0), values(1), steps(0), steps(1));
        self.add(&x, &y, &dx, &dy);
    }

    /// A polynomial piece by its Bernstein points and their differences.
    fn add(&mut self, x: &[f64], y: &[f64], dx: &[f64], dy: &[f64]) {
        // (x y′ − y x′)/p in Bernstein form.
        let cross: Vec<f64> = product(x, dy).iter().zip(product(y, dx)).map(|(a, b)| a - b).collect();
        cross.iter().for_each(|c| self.area.add(0.25 * c));
        for (moment, values) in self.moments.iter_mut().zip([x, y]) {
            product(values, &cross).iter().for_each(|c| moment.add(c / 9.0));
        }
        // Each weight of a product is off by 5p + 2 units, its sum by as many roundings as it has terms.
        let degree = dx.len() as f64;
        let most = |values: &[f64]| values.iter().fold(0.0, |most: f64, x| if x.abs() > most { x.abs() } else { most });
        let sum = |values: &[f64]| values.iter().fold(0.0, |sum: f64, x| sum + x.abs());
        let swept = most(x) * sum(dy) + most(y) * sum(dx);
        self.area_error += (8.0 * degree + 20.0) * UNIT * 0.5 * swept;
        let reach = if most(x) > most(y) { most(x) } else { most(y) };
        self.moment_error += (24.0 * degree + 40.0) * UNIT * reach * swept;
    }

    /// A curve that is not piecewise polynomial, from its derivatives.
    fn other(&mut self, curve: &dyn Curve<2>) {
        let at = |ring: &Ring, t: f64, side: Side| {
            let mut jet = [[0.0; 2]; 2];
            curve.jet_into(t, side, &mut jet);
            (ring.local(&jet[0]), jet[1].map(|x| x / ring.scale))
        };
        for pair in curve.breaks().windows(2) {
            self.join(pair[0], at(self, pair[0], Side::Right).0);
            self.end = at(self, pair[1], Side::Left).0;
            let ring = &*self;
            // The area's integrand, and those of both moments.
            let integrate = |a: f64, b: f64| -> [f64; 3] {
                core::array::from_fn(|k| {
                    RULES[3].integrate(a, b, |t| {
                        let (p, v) = at(ring, t, Side::Right);
                        let cross = p[0] * v[1] - p[1] * v[0];
                        if k == 0 { 0.5 * cross } else { p[k - 1] * cross / 3.0 }
                    })
                })
            };
            let (sums, error) = halved(&integrate, pair[0], pair[1], integrate(pair[0], pair[1]), 10);
            self.area.add(sums[0]);
            self.moments[0].add(sums[1]);
            self.moments[1].add(sums[2]);
            self.area_error += error + 64.0 * UNIT;
            self.moment_error += error + 64.0 * UNIT;
        }
    }

    fn answer(&self, proven: bool) -> Result<Area> {
        let bound = |value: f64| if proven { Bound::Proven(value) } else { Bound::Estimate(value) };
        let (area, error) = (self.area.value(), self.area_error * (1.0 + 1e-9) + 2.0 * UNIT * self.area.value().abs());
        let square = |x: f64| x * self.scale * self.scale;
        // Products below the smallest float are lost.
        let off = square(error) + 8.0 * f64::from_bits(1);
        if !(square(area).is_finite() && off.is_finite()) {
            return Err(Error::new(Code::P003, "the area overflows"));
        }
        let mut centroid = None;
        if area.abs() > 2.0 * error {
            let local = [0, 1].map(|c| self.moments[c].value() / area);
            let far = if local[0].abs() > local[1].abs() { local[0].abs() } else { local[1].abs() };
            let off = (self.moment_error * (1.0 + 1e-9) + far * error) / (area.abs() - error) + 4.0 * UNIT * far;
            let point: [f64; 2] = core::array::from_fn(|c| self.origin[c] + local[c] * self.scale);
            let size = if point[0].abs() > point[1].abs() { point[0].abs() } else { point[1].abs() };
            let off = off * self.scale + UNIT * size;
            centroid = (size.is_finite() && off.is_finite()).then(|| (point, bound(off)));
        }
        Ok(Area { signed: square(area), bound: bound(off), centroid })
    }
}

/// The integrals over an interval by halves, halved again until that changes little, and how much it changed.
fn halved(integrate: &dyn Fn(f64, f64) -> [f64; 3], a: f64, b: f64, whole: [f64; 3], depth: usize) -> ([f64; 3], f64) {
    let middle = 0.5 * a + 0.5 * b;
    let (left, right) = (integrate(a, middle), integrate(middle, b));
    let both: [f64; 3] = core::array::from_fn(|k| left[k] + right[k]);
    let changed = (0..3).fold(0.0, |most: f64, k| {
        let change = (both[k] - whole[k]).abs();
        if change <= most { most } else { change }
    });
    if depth == 0 || changed <= 8.0 * UNIT {
        return (both, changed);
    }
    let (left, right) = (halved(integrate, a, middle, left, depth - 1), halved(integrate, middle, b, right, depth - 1));
    (core::array::from_fn(|k| left.0[k] + right.0[k]), left.1 + right.1)
}

/// The product of two polynomials in Bernstein form: each coefficient is a mean of products, with the weights C(p, i) C(q, k)/C(p + q, i + k),
/// which are taken from the largest downwards so that none overflows.
///
/// *Source.* R. Farouki and V. Rajan, Algorithms for polynomials in Bernstein form (1988).
fn product(f: &[f64], g: &[f64]) -> Vec<f64> {
    let (p, q) = (f.len() - 1, g.len() - 1);
    let one = |m: usize| {
        let (low, high) = (m.saturating_sub(q), m.min(p));
        let top = ((m as f64 * p as f64 / ((p + q).max(1)) as f64) as usize).clamp(low, high);
        // The weight of i + 1 over that of i.
        let ratio = |i: usize| (p - i) as f64 * (m - i) as f64 / ((i + 1) as f64 * (q + i + 1 - m) as f64);
        let (mut sum, mut weights) = (f[top] * g[m - top], 1.0);
        let mut weight = 1.0;
        for i in top + 1..=high {
            weight *= ratio(i - 1);
            sum += weight * (f[i] * g[m - i]);
            weights += weight;
        }
        weight = 1.0;
        for i in (low..top).rev() {
            weight /= ratio(i);
            sum += weight * (f[i] * g[m - i]);
            weights += weight;
        }
        sum / weights
    };
    (0..=p + q).map(one).collect()
}

/// The least power of two above the size; 1 where there is none.
fn power_of_two_above(size: f64) -> f64 {
    if size > 0.0 && size.is_finite() { libm::ldexp(1.0, libm::frexp(size).1.clamp(-1020, 1020)) } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::{Bezier, Path, Polyline, RationalBezier};
    use alloc::boxed::Box;

    #[track_caller]
    fn near(found: f64, exact: f64, bound: Bound) {
        assert!((found - exact).abs() <= bound.value(), "{found} for {exact}: {bound:?}");
    }

    #[test]
    fn polygons_far_from_the_origin_keep_their_digits() {
        for (x, y) in [(0.0, 0.0), (1e7, -3e7), (1e15, 1e15)] {
            let corners = [[0.0, 0.0], [3.0, 0.0], [3.0, 4.0], [0.0, 4.0], [0.0, 0.0]];
            let square = Polyline::new(corners.map(|[a, b]| [x + a, y + b])).unwrap();
            let found = area(&square).unwrap();
            assert_eq!(found.signed, 12.0);
            assert!(found.bound.is_proven() && found.bound.value() < 1e-13, "{found:?}");
            let (centroid, bound) = found.centroid.unwrap();
            near(centroid[0], x + 1.5, bound);
            near(centroid[1], y + 2.0, bound);
            let back: Vec<_> = corners.iter().rev().map(|[a, b]| [x + a, y + b]).collect();
            assert_eq!(area(&Polyline::new(back).unwrap()).unwrap().signed, -12.0);
        }
    }

    #[test]
    fn a_parabola_on_its_base() {
        // y = x(2 − x) over [0, 2]: 4/3, its centroid at (1, 2/5). Elevated, it is the same.
        for elevate in 0..40 {
            let mut arch = Bezier::new([[2.0, 0.0], [1.0, 2.0], [0.0, 0.0]]).unwrap();
            for _ in 0..elevate {
                arch = arch.elevate(1).unwrap();
            }
            let base = Polyline::new([[0.0, 0.0], [2.0, 0.0]]).unwrap();
            let path = Path::new([Box::new(arch) as Box<dyn Curve<2>>, Box::new(base)], true).unwrap();
            let found = area(&path).unwrap();
            // The points of the elevated curve are rounded themselves.
            near(found.signed, 4.0 / 3.0, Bound::Proven(found.bound.value() + 1e-15 * f64::from(elevate)));
            assert!(found.bound.is_proven() && found.bound.value() < 2e-13, "{elevate}: {found:?}");
            let (centroid, bound) = found.centroid.unwrap();
            let bound = Bound::Proven(bound.value() + 1e-15 * f64::from(elevate));
            near(centroid[0], 1.0, bound);
            near(centroid[1], 0.4, bound);
        }
    }

    #[test]
    fn a_quarter_of_a_disc_is_an_estimate_that_holds() {
        let half = core::f64::consts::FRAC_1_SQRT_2;
        let arc = RationalBezier::new([[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], [1.0, half, 1.0]).unwrap();
        let rest = Polyline::new([[0.0, 1.0], [0.0, 0.0], [1.0, 0.0]]).unwrap();
        let path = Path::new([Box::new(arc) as Box<dyn Curve<2>>, Box::new(rest)], true).unwrap();
        let found = area(&path).unwrap();
        near(found.signed, core::f64::consts::FRAC_PI_4, found.bound);
        assert!(!found.bound.is_proven() && found.bound.value() < 1e-13, "{found:?}");
        let (centroid, bound) = found.centroid.unwrap();
        centroid.iter().for_each(|c| near(*c, 4.0 / (3.0 * core::f64::consts::PI), bound));
    }

    #[test]
    fn open_curves_points_and_extremes() {
        let open = Bezier::new([[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]]).unwrap();
        assert_eq!(area(&open).unwrap_err().code(), Code::C004);
        let point = Bezier::new([[7.0, 7.0]; 4]).unwrap();
        let found = area(&point).unwrap();
        assert_eq!((found.signed, found.centroid), (0.0, None));
        let square = |s: f64| Polyline::new([[0.0, 0.0], [s, 0.0], [s, s], [0.0, s], [0.0, 0.0]]).unwrap();
        assert_eq!(area(&square(1e200)).unwrap_err().code(), Code::P003);
        let tiny = area(&square(1e-200)).unwrap();
        assert!(tiny.signed.abs() <= tiny.bound.value() && tiny.centroid.is_some(), "{tiny:?}");
        // An eight goes around both of its halves, once each way.
        let eight = [[0.0, 0.0], [1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0], [0.0, 0.0]];
        let found = area(&Polyline::new(eight).unwrap()).unwrap();
        assert!(found.signed.abs() <= found.bound.value() && found.centroid.is_none(), "{found:?}");
    }
}
