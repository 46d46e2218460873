//! Curves as Bézier pieces in the plane.
//!
//! Polynomial pieces up to degree 3 are exact, above they are cubics with a proven tolerance ([`cubics`]) up to degree
//! 100, and so are rational pieces; still higher degrees, and curves that are neither, are followed by cubics through their own points and
//! tangents, refined until three points between lie within half the tolerance (an estimate). A graph's piece of degree p
//! has the abscissae start + i/p · (end − start), which is exact.

use crate::cubics::{cubics, rational_cubics};
use crate::lens::{Lens, Spot, View};
use crate::path::Point;
use lath::curve::{AnyCurve, Curve, CurveVisitor, RationalPiece};
use lath::knot::Side;
use lath::query::bounds;
use lath::space::{Bounds, Vector, Weighted, distance};

/// Degrees above cost too much to halve.
const MOST_HALVED: usize = 100;

/// Hands out the pieces of the curve, of degree 0 to 3, in order.
pub(crate) fn trace(curve: &AnyCurve, lens: &Lens, tolerance: f64, sink: &mut dyn FnMut(&[Point])) {
    curve.visit(Trace { lens, tolerance, sink });
}

struct Trace<'a> {
    lens: &'a Lens,
    tolerance: f64,
    sink: &'a mut dyn FnMut(&[Point]),
}

impl CurveVisitor for Trace<'_> {
    type Output = ();

    fn visit<const D: usize>(self, curve: &dyn Curve<D>, dimension: usize) {
        let Trace { lens, tolerance, sink } = self;
        let mut points = Vec::new();
        let exact = curve.degree() <= MOST_HALVED
            && curve.bezier_pieces(&mut |piece| {
                points.clear();
                let p = piece.points.len().saturating_sub(1);
                for (i, point) in piece.points.iter().enumerate() {
                    let u = if p == 0 { 0.0 } else { i as f64 / p as f64 };
                    let t = if i == p && p > 0 { piece.end } else { piece.start + u * (piece.end - piece.start) };
                    points.push(lens.plane(&spot(point, dimension, t)));
                }
                if p == 0 && lens.view == View::Graph {
                    points.extend(piece.points.first().map(|b| lens.plane(&spot(b, dimension, piece.end))));
                }
                if points.iter().flatten().all(|x| x.is_finite()) {
                    cubics(&points, tolerance, sink);
                }
            });
        let exact = exact
            || curve.degree() <= MOST_HALVED
                && curve.rational_pieces(&mut |piece| {
                    let points = seen(&piece, dimension, lens);
                    if points.iter().flat_map(|point| &point.point).all(|x| x.is_finite()) {
                        rational_cubics(points, tolerance, sink);
                    }
                });
        if !exact {
            follow(curve, dimension, lens, tolerance, sink);
        }
    }
}

/// The points of a rational piece as the picture sees them, with the same weights. The abscissa of a graph is polynomial and must get
/// the curve's denominator: the degree rises by one.
fn seen<const D: usize>(piece: &RationalPiece<'_, D>, dimension: usize, lens: &Lens) -> Vec<Weighted<2>> {
    if dimension > 1 {
        let place = |item: &Weighted<D>| Weighted {
            point: lens.plane(&spot(&item.point, dimension, 0.0)),
            weight: item.weight,
        };
        return piece.points.iter().map(place).collect();
    }
    let n = piece.points.len();
    let at = |i: usize, t: f64| {
        let item = &piece.points[i];
        Weighted { point: lens.plane(&[t, item.point[0], 0.0]), weight: item.weight }
    };
    let blended = |i: usize| {
        let share = i as f64 / n as f64;
        match i {
            0 => at(0, piece.start),
            i if i == n => at(n - 1, piece.end),
            i => at(i, piece.start).blend(&(1.0 - share), &at(i - 1, piece.end), &share),
        }
    };
    (0..=n).map(blended).collect()
}

/// A point of the curve as the picture sees it.
fn spot<const D: usize>(point: &[f64; D], dimension: usize, t: f64) -> Spot {
    if dimension == 1 {
        return [t, point[0], 0.0];
    }
    core::array::from_fn(|c| if c < dimension { point.get(c).copied().unwrap_or(0.0) } else { 0.0 })
}

/// Cubics through the curve's own points and tangents.
fn follow<const D: usize>(
    curve: &dyn Curve<D>,
    dimension: usize,
    lens: &Lens,
    tolerance: f64,
    sink: &mut dyn FnMut(&[Point]),
) {
    /// About so many pieces in all, whatever the curve does.
    const PIECES: usize = 1 << 18;
    let breaks = curve.breaks();
    let depth_limit = (PIECES / breaks.len().max(1)).max(1).ilog2().min(14);
    let at = |t: f64, side| -> (Point, Point) {
        let mut jet = [[0.0; D]; 2];
        curve.jet_into(t, side, &mut jet);
        let [value, slope] = jet;
        let slope = if dimension == 1 { [1.0, slope[0], 0.0] } else { spot(&slope, dimension, 0.0) };
        (lens.plane(&spot(&value, dimension, t)), lens.vector(&slope))
    };
    for pair in breaks.windows(2) {
        // Stretches still to be drawn, the next on top.
        let middle = pair[0] / 2.0 + pair[1] / 2.0;
        let mut stack = vec![(middle, pair[1], 0), (pair[0], middle, 0)];
        while let Some((a, b, depth)) = stack.pop() {
            let ((p, v), (q, w)) = (at(a, Side::Right), at(b, if b == pair[1] { Side::Left } else { Side::Right }));
            let third = (b - a) / 3.0;
            let piece: [Point; 4] =
                [p, core::array::from_fn(|c| p[c] + third * v[c]), core::array::from_fn(|c| q[c] - third * w[c]), q];
            let middle = a / 2.0 + b / 2.0;
            let off = |u: f64| distance(&at(a + u * (b - a), Side::Right).0, &point_at(&piece, u)) > tolerance / 2.0;
            let rough = [0.25, 0.5, 0.75].into_iter().any(off);
            if piece.iter().flatten().any(|x| !x.is_finite()) {
                if p.iter().chain(&q).all(|x| x.is_finite()) {
                    sink(&[p, q]);
                }
            } else if rough && depth < depth_limit && a < middle && middle < b {
                stack.push((middle, b, depth + 1));
                stack.push((a, middle, depth + 1));
            } else {
                sink(&piece);
            }
        }
    }
}

fn point_at(b: &[Point; 4], u: f64) -> Point {
    let v = 1.0 - u;
    core::array::from_fn(|c| {
        v * v * v * b[0][c] + 3.0 * u * v * v * b[1][c] + 3.0 * u * u * v * b[2][c] + u * u * u * b[3][c]
    })
}

/// Two opposite corners of a box that holds the curve, as far as its numbers are finite.
pub(crate) fn corners(curve: &AnyCurve) -> [Spot; 2] {
    struct Corners;
    impl CurveVisitor for Corners {
        type Output = [Spot; 2];
        fn visit<const D: usize>(self, curve: &dyn Curve<D>, dimension: usize) -> [Spot; 2] {
            let domain = curve.domain();
            // Long intervals times steep tangents may overflow: then the finite control points must do.
            let (mut finite, mut hull) = (true, None::<Bounds<D>>);
            let mut include = |points: &[[f64; D]]| {
                for point in points {
                    match (point.iter().all(|x| x.is_finite()), &mut hull) {
                        (false, _) => finite = false,
                        (true, Some(hull)) => hull.include(point),
                        (true, None) => hull = Some(Bounds::at(*point)),
                    }
                }
            };
            if !curve.bezier_pieces(&mut |piece| include(piece.points)) {
                curve.rational_pieces(&mut |piece| {
                    include(&piece.points.iter().map(|point| point.point).collect::<Vec<_>>());
                });
            }
            let found = if finite { bounds(curve).0 } else { hull.unwrap_or(Bounds::at([0.0; D])) };
            [spot(&found.lo, dimension, domain.start), spot(&found.hi, dimension, domain.end)]
        }
    }
    curve.visit(Corners)
}

/// Value, first and second derivative as the picture sees them; for a graph those of (t, f(t)).
pub(crate) fn jet(curve: &AnyCurve, t: f64, side: Side) -> [Spot; 3] {
    let dimension = curve.dimension();
    let mut flat = [0.0; 3 * lath::curve::MAX_DIMENSION];
    curve.jet_into(t, side, 2, &mut flat[..3 * dimension]);
    let mut out = [[0.0; 3]; 3];
    for (k, row) in flat.chunks_exact(dimension).take(3).enumerate() {
        out[k] = if dimension == 1 {
            [[t, 1.0, 0.0][k], row[0], 0.0]
        } else {
            core::array::from_fn(|c| row.get(c).copied().unwrap_or(0.0))
        };
    }
    out
}
