//! Findings in the curve itself, from its Bézier pieces.
//!
//! A derivative at the end of a piece is a multiple of the difference of two of its points: where they coincide, it
//! vanishes, and that is proven. Inside a piece the derivative is searched for a zero: its Bézier points are halved again
//! and again, and halves whose points all lie on one side of a plane through the origin are free of zeros, proven. What is
//! left when its points are smaller than 1e-9 of the greatest is called a cusp or a halt: an estimate.
//!
//! Of a rational piece A/W, A the sum of weighted points, the derivative has the direction of A′W − AW′, a polynomial of degree 2p − 1,
//! which is searched in its place up to degree 100.

use lath::curve::{AnyCurve, Curve, CurveVisitor};
use lath::space::{distance, norm};

use crate::check::finding::Findings;
use crate::check::show;
use crate::error::{Code, Error, Result};

/// How small a derivative must be, of the greatest of its piece, to be called zero.
const ZERO: f64 = 1e-9;
/// How far two ends may be apart, of the size of the curve, and still be called one point.
const MEET: f64 = 1e-12;
/// How near the ends of an open curve make it look like a closed one.
const NEARLY: f64 = 1e-6;
/// How many halves of one piece are looked at.
const HALVES: usize = 2000;

pub(super) fn check(curve: &AnyCurve, pointer: &str, findings: &mut Findings<'_>) -> Result<()> {
    struct Look<'a, 'f>(&'a str, &'a mut Findings<'f>);
    impl CurveVisitor for Look<'_, '_> {
        type Output = Result<()>;
        fn visit<const D: usize>(self, curve: &dyn Curve<D>, dimension: usize) -> Result<()> {
            look(curve, dimension, self.0, self.1)
        }
    }
    curve.visit(Look(pointer, findings))
}

fn look<const D: usize>(
    curve: &dyn Curve<D>,
    dimension: usize,
    pointer: &str,
    findings: &mut Findings<'_>,
) -> Result<()> {
    let mut push = |code: Code, message: String| findings.push(Error::new(code, message).at_pointer(pointer)).err();
    let (mut size, mut origin): (f64, Option<[f64; D]>) = (0.0, None);
    pieces(curve, &mut |piece| {
        for point in piece.points {
            let from = distance(origin.get_or_insert(*point), point);
            size = if from > size { from } else { size };
        }
    });
    if size == 0.0 {
        return Ok(()); // a point: said of its points already
    }
    let (mut failed, mut before, mut halted) = (None, None, None);
    let mut cusps = 0;
    pieces(curve, &mut |piece| {
        let (Some(first), Some(last)) = (piece.points.first(), piece.points.last()) else { return };
        let mut tell = |code, message| {
            if failed.is_none() {
                failed = push(code, message);
            }
        };
        if let Some(end) = before.replace(*last) {
            let gap = distance(&end, first);
            if gap > MEET * size {
                tell(Code::W007, format!("at t = {} the curve jumps by {}", show(piece.start), show(gap)));
            }
        }
        if dimension == 1 || piece.points.len() < 2 {
            return; // the derivative of a function may vanish anywhere
        }
        if piece.points.iter().all(|point| point == first) {
            let (start, end) = (show(piece.start), show(piece.end));
            return tell(Code::W012, format!("all Bézier points from t = {start} to {end} coincide"));
        }
        let n = piece.points.len() - 1;
        for (t, end, inner) in [(piece.start, 0, 1), (piece.end, n, n - 1)] {
            let weightless = piece.weights.get(inner) == Some(&0.0);
            if (piece.points.get(end) == piece.points.get(inner) || weightless) && halted.replace(t) != Some(t) {
                let why = if weightless { "a Bézier point has no weight" } else { "two Bézier points coincide" };
                tell(Code::W010, format!("at t = {} {why}, and the derivative vanishes", show(t)));
            }
        }
        if cusps <= 20
            && let Some(t) = cusp(&piece)
        {
            cusps += 1;
            tell(Code::W011, format!("near t = {} the derivative vanishes (an estimate)", show(t)));
        }
    });
    if let Some(error) = failed {
        return Err(error);
    }
    let (Some(first), Some(last)) = (origin, before) else { return Ok(()) };
    let gap = distance(&first, &last);
    if !curve.is_closed() && dimension > 1 && gap > 0.0 && gap < NEARLY * size {
        let message = format!("the curve ends {} beside its start", show(gap));
        findings.push(Error::new(Code::W007, message).at_pointer(pointer))?;
    }
    Ok(())
}

/// A Bézier piece, polynomial where it has no weights.
struct Piece<'a, const D: usize> {
    start: f64,
    end: f64,
    points: &'a [[f64; D]],
    weights: &'a [f64],
}

/// Hands out the pieces of either sort.
fn pieces<const D: usize>(curve: &dyn Curve<D>, visit: &mut dyn FnMut(Piece<'_, D>)) {
    let polynomial = curve.bezier_pieces(&mut |piece| {
        visit(Piece { start: piece.start, end: piece.end, points: piece.points, weights: &[] });
    });
    if !polynomial {
        curve.rational_pieces(&mut |piece| {
            let (points, weights): (Vec<_>, Vec<_>) = piece.points.iter().map(|p| (p.point, p.weight)).unzip();
            visit(Piece { start: piece.start, end: piece.end, points: &points, weights: &weights });
        });
    }
}

/// Degrees of rational pieces above are not searched: their binomials leave the range of numbers.
const SEARCHED: usize = 100;

/// Bézier points of A′W − AW′ for a rational piece, A taken about the first point and weights relative to the greatest.
fn direction<const D: usize>(points: &[[f64; D]], weights: &[f64]) -> Vec<[f64; D]> {
    let (Some(first), n) = (points.first(), points.len().saturating_sub(1)) else { return Vec::new() };
    if n > SEARCHED {
        return Vec::new();
    }
    let most = weights.iter().fold(0.0, |most: f64, w| if *w > most { *w } else { most });
    let w: Vec<f64> = weights.iter().map(|weight| weight / most).collect();
    let a: Vec<[f64; D]> =
        points.iter().zip(&w).map(|(point, w)| core::array::from_fn(|c| w * (point[c] - first[c]))).collect();
    let row = |n: usize| {
        let mut row = vec![1.0];
        for k in 0..n {
            row.push(row[k] * (n - k) as f64 / (k + 1) as f64);
        }
        row
    };
    let (slope, value, product) = (row(n - 1), row(n), row(2 * n - 1));
    let mut out = vec![[0.0; D]; 2 * n];
    for i in 0..n {
        for j in 0..=n {
            let share = slope[i] * value[j] / product[i + j];
            for (c, x) in out[i + j].iter_mut().enumerate() {
                *x += share * ((a[i + 1][c] - a[i][c]) * w[j] - (w[i + 1] - w[i]) * a[j][c]);
            }
        }
    }
    out
}

/// Where the derivative vanishes inside a piece.
fn cusp<const D: usize>(piece: &Piece<'_, D>) -> Option<f64> {
    let differences: Vec<[f64; D]> = match piece.weights {
        [] => piece.points.windows(2).map(|pair| core::array::from_fn(|c| pair[1][c] - pair[0][c])).collect(),
        weights => direction(piece.points, weights),
    };
    let largest = differences.iter().map(norm).fold(0.0, |a: f64, b| if b > a { b } else { a });
    let mut open = vec![(0.0, 1.0, differences)];
    let mut looked = 0;
    while let Some((from, to, points)) = open.pop() {
        looked += 1;
        if looked > HALVES || one_sided(&points) {
            continue;
        }
        let middle = 0.5 * (from + to);
        if points.iter().all(|point| norm(point) <= ZERO * largest) {
            // At the ends of the piece it is known already, and proven.
            if from == 0.0 || to == 1.0 {
                continue;
            }
            let end = |point: Option<&[f64; D]>| point.map_or(0.0, norm);
            let nearest = if end(points.first()) < end(points.last()) { from } else { to };
            return Some(piece.start + nearest * (piece.end - piece.start));
        }
        let (left, right) = halves(points);
        open.push((middle, to, right));
        open.push((from, middle, left));
    }
    None
}

/// True where all points lie strictly on one side of the plane through the origin across their sum.
fn one_sided<const D: usize>(points: &[[f64; D]]) -> bool {
    let mut sum = [0.0; D];
    for point in points {
        // Directions, not lengths: one long vector must not outweigh the others.
        let length = norm(point);
        if length > 0.0 {
            sum = core::array::from_fn(|c| sum[c] + point[c] / length);
        }
    }
    let dot = |point: &[f64; D]| {
        let length = norm(point);
        if length > 0.0 { (0..D).fold(0.0, |dot, c| dot + sum[c] * (point[c] / length)) } else { 0.0 }
    };
    points.iter().all(|point| dot(point) > 0.0)
}

/// Both halves, by de Casteljau's triangle.
fn halves<const D: usize>(mut points: Vec<[f64; D]>) -> (Vec<[f64; D]>, Vec<[f64; D]>) {
    let mut left = Vec::with_capacity(points.len());
    for end in (0..points.len()).rev() {
        left.extend(points.first().copied());
        for i in 0..end {
            points[i] = core::array::from_fn(|c| 0.5 * points[i][c] + 0.5 * points[i + 1][c]);
        }
    }
    (left, points)
}
