//! Akima's slopes: the mean of the neighbouring chords, each weighted by how little bends beyond the other.

use crate::curve::Hermite;
use crate::error::Result;
use crate::interpolate::chords::Chords;
use crate::space::IntoPoint;
use alloc::vec::Vec;

/// Akima's spline: an outlier disturbs its neighbours only, straight stretches stay straight.
///
/// *Source.* H. Akima, A new method of interpolation and smooth curve fitting based on local procedures (1970). With chords
/// m₁ … m₄ around a point the slope is (|m₄ − m₃| m₂ + |m₂ − m₁| m₃)/(|m₄ − m₃| + |m₂ − m₁|); where that is 0/0 (a corner between two
/// straight stretches) the mean of m₁ and m₄. Beyond open ends chords continue linearly. As scipy's `Akima1DInterpolator`,
/// which also takes the mean where the denominator is below 1e-9 of its greatest value.
///
/// *Invariance:* scaling of each axis by itself, translation. *Cost.* O(n). C¹.
///
/// *Degenerate input.* Two points give the straight line, three the parabola.
///
/// ```
/// use lath::curve::Curve;
/// use lath::interpolate::akima;
///
/// let curve = akima([[0.0], [0.0], [0.0], [1.0], [0.0], [0.0], [0.0]], (0..7).map(f64::from).collect(), false)?;
/// assert_eq!(curve.eval(0.5)?, [0.0]); // the spike does not reach the first piece
/// # Ok::<(), lath::error::Error>(())
/// ```
///
/// # Errors
/// P001 for fewer than two points; T001, T003, T004, T005 for the parameters (one more than points if `closed`); P002, P003 for
/// coordinates.
pub fn akima<const D: usize>(
    points: impl IntoIterator<Item = impl IntoPoint<D>>,
    parameters: Vec<f64>,
    closed: bool,
) -> Result<Hermite<D>> {
    weighted(Chords::new(points, parameters, closed)?, 0.0)
}

/// Akima's spline with the weights |m₄ − m₃| + |m₄ + m₃|/2: less overshoot on flat stretches, no 0/0.
///
/// *Source.* The modification known from MATLAB's `makima`. *Invariance, cost, degenerate input, errors* as [`akima`].
///
/// # Errors
/// As [`akima`].
pub fn makima<const D: usize>(
    points: impl IntoIterator<Item = impl IntoPoint<D>>,
    parameters: Vec<f64>,
    closed: bool,
) -> Result<Hermite<D>> {
    weighted(Chords::new(points, parameters, closed)?, 0.5)
}

/// The weights of a point along one axis and the four chords they belong to.
struct Weighing {
    chords: [f64; 4],
    first: f64,
    second: f64,
}

fn weighted<const D: usize>(chords: Chords<D>, share: f64) -> Result<Hermite<D>> {
    let weigh = |i: usize, axis: usize| {
        let m = [-2, -1, 0, 1].map(|k| continued(&chords, i as isize + k, axis));
        let weight = |a: f64, b: f64| (b - a).abs() + share * (b + a).abs();
        Weighing { chords: m, first: weight(m[2], m[3]), second: weight(m[0], m[1]) }
    };
    let n = chords.points.len();
    let greatest: [f64; D] = core::array::from_fn(|axis| {
        (0..n).fold(0.0, |most: f64, i| {
            let w = weigh(i, axis);
            let sum = w.first + w.second;
            if sum > most { sum } else { most }
        })
    });
    let slopes: Vec<[f64; D]> = (0..n)
        .map(|i| {
            core::array::from_fn(|axis| {
                let Weighing { chords: m, first, second } = weigh(i, axis);
                let sum = first + second;
                if sum > 1e-9 * greatest[axis] {
                    m[1] * (first / sum) + m[2] * (second / sum)
                } else {
                    0.5 * (m[0] + m[3])
                }
            })
        })
        .collect();
    chords.with_slopes(slopes)
}

/// The slope of chord i along one axis; beyond the ends of an open curve continued linearly.
fn continued<const D: usize>(chords: &Chords<D>, i: isize, axis: usize) -> f64 {
    if let Some((_, slope)) = chords.get(i) {
        return slope[axis];
    }
    let n = chords.count() as isize;
    if n == 1 {
        return chords.get(0).map_or(0.0, |(_, slope)| slope[axis]);
    }
    // At most two steps beyond an end.
    let inwards = if i < 0 { 1 } else { -1 };
    2.0 * continued(chords, i + inwards, axis) - continued(chords, i + 2 * inwards, axis)
}
