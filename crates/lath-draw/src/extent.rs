//! The tight box of what is drawn, in the plane.

use crate::cubics::halves;
use crate::path::Point;

/// A box in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Extent {
    pub(crate) lo: Point,
    pub(crate) hi: Point,
}

impl Extent {
    pub(crate) const EMPTY: Extent = Extent { lo: [f64::INFINITY; 2], hi: [f64::NEG_INFINITY; 2] };

    /// Takes in a point; what is not finite is nowhere.
    pub(crate) fn include(&mut self, p: Point) {
        if !p.iter().all(|x| x.is_finite()) {
            return;
        }
        for c in 0..2 {
            if p[c] < self.lo[c] {
                self.lo[c] = p[c];
            }
            if p[c] > self.hi[c] {
                self.hi[c] = p[c];
            }
        }
    }

    /// Takes in a Bézier piece: control points that lie inside prove that it does; otherwise it is halved.
    pub(crate) fn include_piece(&mut self, points: &[Point]) {
        self.piece(points, 24);
    }

    fn piece(&mut self, points: &[Point], depth: usize) {
        for p in points.first().into_iter().chain(points.last()) {
            self.include(*p);
        }
        let slack = 1e-4 * self.longest();
        let inside = |p: &Point| (0..2).all(|c| self.lo[c] - slack <= p[c] && p[c] <= self.hi[c] + slack);
        if depth == 0 || points.len() < 3 || points.iter().all(inside) {
            return;
        }
        let (left, right) = halves(points);
        self.piece(&left, depth - 1);
        self.piece(&right, depth - 1);
    }

    pub(crate) fn width(&self) -> f64 {
        self.hi[0] - self.lo[0]
    }

    pub(crate) fn height(&self) -> f64 {
        self.hi[1] - self.lo[1]
    }

    pub(crate) fn longest(&self) -> f64 {
        let (w, h) = (self.width(), self.height());
        if w > h { w } else { h }
    }

    pub(crate) fn is_finite(&self) -> bool {
        self.lo.iter().chain(&self.hi).all(|x| x.is_finite())
    }

    /// The box, or one unit around the origin where there is none; a side of no length is given one by `widen`.
    pub(crate) fn or_unit(mut self, widen: [bool; 2]) -> Extent {
        if !self.is_finite() {
            self = Extent { lo: [0.0; 2], hi: [0.0; 2] };
        }
        for c in 0..2 {
            if widen[c] && self.hi[c] == self.lo[c] {
                self.lo[c] -= 0.5;
                self.hi[c] += 0.5;
            }
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_are_boxed_tightly() {
        let mut extent = Extent::EMPTY;
        extent.include_piece(&[[0.0, 0.0], [0.0, 4.0], [4.0, 4.0], [4.0, 0.0]]);
        assert_eq!((extent.lo, extent.hi[0]), ([0.0, 0.0], 4.0));
        assert!((extent.hi[1] - 3.0).abs() < 1e-3, "{extent:?}");
    }
}
