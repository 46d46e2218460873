//! A curve that counts how often it is asked.

use lath::curve::{BezierPiece, Curve, Interval, RationalPiece};
use lath::knot::Side;
use std::sync::atomic::{AtomicU64, Ordering};

/// How often one question may ask its curve.
const ENOUGH: u64 = 2_000_000;

/// A curve between a question and the real one; it panics where a question does not come to an end.
///
/// It is no guard for work that a question does between two askings.
#[derive(Debug)]
pub struct Counted<C> {
    curve: C,
    asked: AtomicU64,
}

impl<C> Counted<C> {
    /// Counts from 0.
    pub fn new(curve: C) -> Counted<C> {
        Counted { curve, asked: AtomicU64::new(0) }
    }

    fn count(&self) {
        let asked = self.asked.fetch_add(1, Ordering::Relaxed);
        assert!(asked < ENOUGH, "a question asks its curve without end");
    }
}

impl<const D: usize, C: Curve<D>> Curve<D> for Counted<C> {
    fn kind(&self) -> &'static str {
        self.curve.kind()
    }

    fn degree(&self) -> usize {
        self.curve.degree()
    }

    fn domain(&self) -> Interval {
        self.curve.domain()
    }

    fn jet_into(&self, t: f64, side: Side, out: &mut [[f64; D]]) {
        self.count();
        self.curve.jet_into(t, side, out);
    }

    fn breaks(&self) -> Vec<f64> {
        self.curve.breaks()
    }

    fn is_closed(&self) -> bool {
        self.curve.is_closed()
    }

    fn bezier_pieces(&self, visit: &mut dyn FnMut(BezierPiece<'_, D>)) -> bool {
        self.curve.bezier_pieces(&mut |piece| {
            self.count();
            visit(piece);
        })
    }

    fn rational_pieces(&self, visit: &mut dyn FnMut(RationalPiece<'_, D>)) -> bool {
        self.curve.rational_pieces(&mut |piece| {
            self.count();
            visit(piece);
        })
    }
}
