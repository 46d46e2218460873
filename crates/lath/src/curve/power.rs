//! Piecewise polynomials by ascending powers: the form in which other systems hand over splines.

use crate::curve::interval::{Interval, check_increasing, segment};
use crate::curve::protocol::{BezierPiece, Curve};
use crate::error::{Code, Count, Error, Result};
use crate::knot::Side;
use crate::space::{IntoPoint, collect};
use alloc::format;
use alloc::vec::Vec;

/// On [bᵢ, bᵢ₊₁] the polynomial Σ_k c_{i,k} (t − bᵢ)^k, every piece of the same degree (the pp-form).
///
/// *Invariance:* affine (coefficients above the constant transform as vectors). Nothing makes the pieces join.
///
/// *Cost.* O(log n + p) an evaluation, by Horner's rule. *Error.* At most 2p u Σ|c_k||t − bᵢ|^k: small near a piece's start; near its
/// end it grows with the coefficients, which is the form's own condition.
///
/// *Degenerate input.* One coefficient is a constant piece.
///
/// ```
/// use lath::curve::{Curve, Power};
///
/// // t² on [0, 1], then 1 + 2s: as steep, but no longer bent.
/// let curve = Power::new(vec![0.0, 1.0, 3.0], [vec![[0.0], [0.0], [1.0]], vec![[1.0], [2.0], [0.0]]])?;
/// assert_eq!(curve.eval(2.0)?, [3.0]);
/// assert_eq!(curve.jet(1.0, 2)?[1..], [[2.0], [0.0]]);
/// # Ok::<(), lath::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Power<const D: usize> {
    breaks: Vec<f64>,
    /// p + 1 coefficients a piece, one piece after another.
    coefficients: Vec<[f64; D]>,
}

impl<const D: usize> Power<D> {
    /// Pieces of p + 1 coefficients each, one piece fewer than breaks.
    ///
    /// # Errors
    /// T001, T003, T004 and T005 for the breaks (T004 also for another number of pieces); P001 for a piece without
    /// coefficients; P005 with the index of a piece of another degree than the first; P002, P003 for coordinates;
    /// K006 for a degree above 1000.
    pub fn new<P: IntoIterator<Item = impl IntoPoint<D>>>(
        breaks: Vec<f64>,
        pieces: impl IntoIterator<Item = P>,
    ) -> Result<Power<D>> {
        check_increasing(&breaks)?;
        let mut coefficients = Vec::new();
        let mut width = None;
        let mut count = 0;
        for piece in pieces {
            let piece = collect(piece).map_err(|error| error.at(count))?;
            let wanted = *width.get_or_insert(piece.len());
            if piece.is_empty() {
                return Err(Error::new(Code::P001, format!("piece {count} has no coefficients")).at(count));
            }
            if piece.len() != wanted {
                let message = format!("piece {count} has {} coefficients, the first has {wanted}", piece.len());
                return Err(Error::new(Code::P005, message).at(count));
            }
            if wanted > 1001 {
                return Err(Error::new(Code::K006, format!("degree {} is above 1000", wanted - 1)));
            }
            coefficients.extend(piece);
            count += 1;
        }
        if count + 1 != breaks.len() {
            let message =
                format!("{} for {}, which take {}", Count(breaks.len(), "break"), Count(count, "piece"), count + 1);
            return Err(Error::new(Code::T004, message));
        }
        Ok(Power { breaks, coefficients })
    }

    /// The coefficients of each piece, ascending powers of t − break.
    pub fn coefficients(&self) -> impl Iterator<Item = &[[f64; D]]> {
        self.coefficients.chunks(self.width())
    }

    fn width(&self) -> usize {
        self.coefficients.len() / (self.breaks.len() - 1)
    }

    fn piece(&self, i: usize) -> &[[f64; D]] {
        &self.coefficients[i * self.width()..][..self.width()]
    }
}

impl<const D: usize> Curve<D> for Power<D> {
    fn kind(&self) -> &'static str {
        "power"
    }

    fn degree(&self) -> usize {
        self.width() - 1
    }

    fn domain(&self) -> Interval {
        Interval { start: self.breaks[0], end: self.breaks[self.breaks.len() - 1] }
    }

    fn jet_into(&self, t: f64, side: Side, out: &mut [[f64; D]]) {
        let i = segment(&self.breaks, t, side);
        let (s, mut row) = (t - self.breaks[i], self.piece(i).to_vec());
        for (k, slot) in out.iter_mut().enumerate() {
            if k > 0 {
                // Differentiate: c_j becomes (j + 1) c_{j+1}.
                for j in 1..row.len() {
                    row[j - 1] = row[j].map(|x| x * j as f64);
                }
                row.pop();
            }
            *slot = row.iter().rev().fold([0.0; D], |sum, c| core::array::from_fn(|d| sum[d] * s + c[d]));
        }
    }

    fn breaks(&self) -> Vec<f64> {
        self.breaks.clone()
    }

    fn bezier_pieces(&self, visit: &mut dyn FnMut(BezierPiece<'_, D>)) -> bool {
        for i in 0..self.breaks.len() - 1 {
            let (start, end) = (self.breaks[i], self.breaks[i + 1]);
            let mut points = self.piece(i).to_vec();
            to_bernstein(&mut points, end - start);
            visit(BezierPiece { start, end, points: &points });
        }
        true
    }
}

/// Power coefficients over [0, h] to Bernstein points: b_j = Σ_i C(j,i)/C(p,i) hⁱ cᵢ, the sums of C(j,i) taken by
/// repeated addition as in Pascal's triangle.
fn to_bernstein<const D: usize>(row: &mut [[f64; D]], h: f64) {
    let p = row.len() - 1;
    // hⁱ/C(p,i) grows factor by factor: C(p,i) = C(p,i−1) (p−i+1)/i.
    let mut factor = 1.0;
    for i in 1..=p {
        factor = factor * h * i as f64 / (p - i + 1) as f64;
        row[i] = row[i].map(|x| x * factor);
    }
    for round in 1..=p {
        for j in (round..=p).rev() {
            row[j] = core::array::from_fn(|d| row[j][d] + row[j - 1][d]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec;

    #[test]
    fn a_cubic_becomes_its_bernstein_points() {
        // 1 + 2s + 3s² + 4s³ over [0, 2] by hand: C(j,i)/C(3,i) 2ⁱ cᵢ summed.
        let curve = Power::new(vec![5.0, 7.0], [[[1.0], [2.0], [3.0], [4.0]]]).unwrap();
        let mut found = vec![];
        curve.bezier_pieces(&mut |piece| found = piece.points.to_vec());
        let expected = [1.0, 1.0 + 4.0 / 3.0, 1.0 + 8.0 / 3.0 + 4.0, 49.0];
        for (b, e) in found.iter().zip(expected) {
            assert!((b[0] - e).abs() < 1e-14, "{found:?}");
        }
        assert_eq!(curve.eval(7.0).unwrap(), [49.0]);
        assert_eq!(curve.jet(6.0, 4).unwrap(), [[10.0], [20.0], [30.0], [24.0], [0.0]]);
    }

    #[test]
    fn faults_name_the_piece() {
        let fault = |breaks: Vec<f64>, pieces: Vec<Vec<[f64; 1]>>| {
            let error = Power::new(breaks, pieces).unwrap_err();
            (error.code(), error.index())
        };
        let row = |n: usize| vec![[1.0]; n];
        assert_eq!(fault(vec![0.0, 1.0, 2.0], vec![row(2), row(3)]), (Code::P005, Some(1)));
        assert_eq!(fault(vec![0.0, 1.0], vec![row(0)]), (Code::P001, Some(0)));
        assert_eq!(fault(vec![0.0, 1.0, 2.0], vec![row(2)]), (Code::T004, None));
        assert_eq!(fault(vec![0.0, 1.0, 1.0], vec![row(2), row(2)]), (Code::T003, Some(2)));
        assert_eq!(fault(vec![0.0, 1.0], vec![vec![[f64::NAN]]]), (Code::P002, Some(0)));
    }
}
