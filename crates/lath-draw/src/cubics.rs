//! Bézier pieces of any degree as cubics.
//!
//! The cubic that has a piece's ends and end tangents differs from it nowhere by more than max‖P⁗‖/384 (Hermite's
//! error, applied to the component along the difference), and ‖P⁗‖ ≤ p(p−1)(p−2)(p−3) · max‖Δ⁴bᵢ‖ for degree p and
//! control points bᵢ. A piece that does not meet the tolerance is halved, which divides the bound by 16. So the
//! tolerance is proven, at equal parameters and hence as distance.
//!
//! A rational piece A/W with positive weights differs from a cubic H by (A − W·H)/W. The numerator is a polynomial of degree p + 3, whose
//! Bézier points bound it; the least weight bounds W from below. With the end weights made equal, H has the piece's ends and end
//! tangents, and halving divides the difference by about 16 there too.

use crate::path::Point;
use lath::basis::bernstein::split_in_place;
use lath::basis::rational::balance;
use lath::space::Weighted;

/// Hands out the piece as pieces of degree at most 3 within `tolerance`: itself if its degree is so low.
pub(crate) fn cubics(points: &[Point], tolerance: f64, sink: &mut dyn FnMut(&[Point])) {
    reduce(points, tolerance, 16, sink);
}

/// Hands out a rational piece as cubics within `tolerance`; its weights are not negative, and positive at its ends.
pub(crate) fn rational_cubics(points: Vec<Weighted<2>>, tolerance: f64, sink: &mut dyn FnMut(&[Point])) {
    reduce_rational(points, tolerance, 24, sink);
}

fn reduce_rational(mut points: Vec<Weighted<2>>, tolerance: f64, depth: usize, sink: &mut dyn FnMut(&[Point])) {
    balance(&mut points);
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return };
    let flat = points.iter().all(|point| point.point == first.point);
    let cubic = rational_hermite(&points);
    if depth == 0 || flat || rational_bound(&points, &cubic) <= tolerance {
        // What never came within the tolerance is smaller than any pixel by now.
        return if depth > 0 { sink(&cubic) } else { sink(&[first.point, last.point]) };
    }
    let right = split_in_place(&mut points, (&0.5, &0.5));
    reduce_rational(points, tolerance, depth - 1, sink);
    reduce_rational(right, tolerance, depth - 1, sink);
}

/// The cubic with the ends and end tangents of a piece whose end weights are equal.
fn rational_hermite(points: &[Weighted<2>]) -> [Point; 4] {
    let n = points.len() - 1;
    let third = n as f64 / 3.0;
    let towards = |a: &Weighted<2>, b: &Weighted<2>| -> Point {
        let share = third * (b.weight / a.weight);
        core::array::from_fn(|c| a.point[c] + share * (b.point[c] - a.point[c]))
    };
    let (first, last) = (points[0], points[n]);
    if n == 0 {
        return [first.point; 4];
    }
    [first.point, towards(&first, &points[1]), towards(&last, &points[n - 1]), last.point]
}

/// The greatest distance between a rational piece and a cubic at equal parameters; infinite while a weight is zero.
fn rational_bound(points: &[Weighted<2>], cubic: &[Point; 4]) -> f64 {
    const CUBIC: [f64; 4] = [1.0, 3.0, 3.0, 1.0];
    let n = points.len() - 1;
    let row = |n: usize| {
        let mut row = vec![1.0];
        for k in 0..n {
            row.push(row[k] * (n - k) as f64 / (k + 1) as f64);
        }
        row
    };
    let (own, product) = (row(n), row(n + 3));
    // Bézier points of A·1 − W·H, the sum of all w(P − H) that meet.
    let mut difference = vec![[0.0; 2]; n + 4];
    for (i, item) in points.iter().enumerate() {
        for (j, h) in cubic.iter().enumerate() {
            let share = own[i] * CUBIC[j] / product[i + j] * item.weight;
            for (c, x) in difference[i + j].iter_mut().enumerate() {
                *x += share * (item.point[c] - h[c]);
            }
        }
    }
    let least =
        points.iter().fold(f64::INFINITY, |least, point| if point.weight < least { point.weight } else { least });
    let most = difference.iter().map(lath::space::norm).fold(0.0, |a: f64, b| if b > a || b.is_nan() { b } else { a });
    if least > 0.0 && most.is_finite() { most / least } else { f64::INFINITY }
}

fn reduce(points: &[Point], tolerance: f64, depth: usize, sink: &mut dyn FnMut(&[Point])) {
    if points.len() <= 4 {
        return sink(points);
    }
    if depth == 0 || bound(points) <= tolerance {
        return sink(&hermite(points));
    }
    let (left, right) = halves(points);
    reduce(&left, tolerance, depth - 1, sink);
    reduce(&right, tolerance, depth - 1, sink);
}

/// The greatest distance between a piece of degree 4 or more and [`hermite`].
fn bound(points: &[Point]) -> f64 {
    let p = points.len() as f64 - 1.0;
    let greatest = points.windows(5).fold(0.0, |most: f64, b| {
        let fourth: Point = core::array::from_fn(|c| (b[0][c] + b[4][c]) - 4.0 * (b[1][c] + b[3][c]) + 6.0 * b[2][c]);
        let length = lath::space::norm(&fourth);
        if length > most { length } else { most }
    });
    p * (p - 1.0) * (p - 2.0) * (p - 3.0) * greatest / 384.0
}

/// The cubic with the piece's ends and end tangents.
fn hermite(points: &[Point]) -> [Point; 4] {
    let n = points.len() - 1;
    let third = n as f64 / 3.0;
    let towards = |a: Point, b: Point| core::array::from_fn(|c| a[c] + third * (b[c] - a[c]));
    [points[0], towards(points[0], points[1]), towards(points[n], points[n - 1]), points[n]]
}

/// De Casteljau's halving.
pub(crate) fn halves(points: &[Point]) -> (Vec<Point>, Vec<Point>) {
    let mut row = points.to_vec();
    let mut left = Vec::with_capacity(row.len());
    for last in (0..row.len()).rev() {
        left.push(row[0]);
        for i in 0..last {
            row[i] = core::array::from_fn(|c| 0.5 * row[i][c] + 0.5 * row[i + 1][c]);
        }
    }
    (left, row)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(points: &[Point], t: f64) -> Point {
        let mut row = points.to_vec();
        for last in (0..row.len()).rev() {
            for i in 0..last {
                row[i] = core::array::from_fn(|c| (1.0 - t) * row[i][c] + t * row[i + 1][c]);
            }
        }
        row[0]
    }

    #[test]
    fn low_degrees_pass_unchanged() {
        for n in 1..=4 {
            let points: Vec<Point> = (0..n).map(|i| [f64::from(i), f64::from(i * i)]).collect();
            let mut seen = Vec::new();
            cubics(&points, 1e-9, &mut |piece| seen.push(piece.to_vec()));
            assert_eq!(seen, [points]);
        }
    }

    /// The promise, over tolerances in a geometric series: true distance at equal parameters ≤ tolerance.
    #[test]
    fn the_tolerance_is_kept() {
        let wild: Vec<Point> = (0..9).map(|i| [f64::from(i), f64::from((i * i * 7) % 11)]).collect();
        let mut before = 0;
        for k in 0..8 {
            let tolerance = libm::pow(10.0, -f64::from(k));
            let mut pieces = Vec::new();
            cubics(&wild, tolerance, &mut |piece| pieces.push(piece.to_vec()));
            assert!(pieces.len() >= before);
            before = pieces.len();
            // Halving is uniform per branch: recover each piece's interval by walking dyadically.
            let mut t = 0.0;
            for piece in &pieces {
                let mut width = 1.0;
                while lath::space::distance(&at(&wild, t + width), &piece[3]) > 1e-12 || t + width > 1.0 {
                    width /= 2.0;
                    assert!(width > 1e-6);
                }
                for s in 0..=16 {
                    let u = f64::from(s) / 16.0;
                    let off = lath::space::distance(&at(&wild, t + u * width), &at(piece, u));
                    assert!(off <= tolerance, "{off} > {tolerance}");
                }
                t += width;
            }
            assert_eq!(t, 1.0);
        }
    }

    /// A circle of 300 pixels by its own quarters: every cubic stays within the tolerance of the circle, and few are needed.
    #[test]
    fn rational_pieces_keep_the_tolerance() {
        let at = |x: f64, y: f64, weight: f64| Weighted { point: [300.0 * x, 300.0 * y], weight };
        for weights in [[1.0, 1.0, 2.0], [4.0, 2.0 * 0.5_f64.sqrt(), 1.0], [1e-12, 1.0 / 2.0_f64.sqrt(), 1e12]] {
            let quarter = vec![at(1.0, 0.0, weights[0]), at(1.0, 1.0, weights[1]), at(0.0, 1.0, weights[2])];
            for k in 0..6 {
                let tolerance = libm::pow(10.0, -f64::from(k));
                let mut pieces: Vec<Vec<Point>> = Vec::new();
                rational_cubics(quarter.clone(), tolerance, &mut |piece| pieces.push(piece.to_vec()));
                assert!(pieces.len() <= 4 << k, "{} pieces at {tolerance}", pieces.len());
                assert!(pieces.windows(2).all(|pair| pair[0][3] == pair[1][0]));
                for piece in &pieces {
                    for s in 0..=16 {
                        let off = (lath::space::norm(&at_cubic(piece, f64::from(s) / 16.0)) - 300.0).abs();
                        assert!(off <= tolerance, "{off} > {tolerance} with {weights:?}");
                    }
                }
            }
        }
    }

    fn at_cubic(piece: &[Point], t: f64) -> Point {
        at(piece, t)
    }
}
