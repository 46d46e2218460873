//! Bézier pieces of any degree as cubics.
//!
//! The cubic that has a piece's ends and end tangents differs from it nowhere by more than max‖P⁗‖/384 (Hermite's
//! error, applied to the component along the difference), and ‖P⁗‖ ≤ p(p−1)(p−2)(p−3) · max‖Δ⁴bᵢ‖ for degree p and
//! control points bᵢ. A piece that does not meet the tolerance is halved, which divides the bound by 16. So the
//! tolerance is proven, at equal parameters and hence as distance.

use crate::path::Point;

/// Hands out the piece as pieces of degree at most 3 within `tolerance`: itself if its degree is so low.
pub(crate) fn cubics(points: &[Point], tolerance: f64, sink: &mut dyn FnMut(&[Point])) {
    reduce(points, tolerance, 16, sink);
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
}
