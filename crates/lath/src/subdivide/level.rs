//! Whole levels into memory.
//!
//! A level is evaluated, never reached by passes: each of its points is one row of p + 1 weights, and the rows depend on the
//! residue i mod 2ᵏ alone. So a block of rows is made once and used for every segment while it lies in the fastest
//! memory; what remains a point are p + 1 multiplications for each coordinate and the write. Passes would write, read and
//! multiply twice as much, and reach beyond the last level's memory.
//!
//! *Measured* (closed cubic polygon of 100 points in the plane, level 20; bench/README.md has the table): a plain fill of the same
//! buffer takes 0.95 of the time of evaluation into it, passes by hand 2.4 times as long (and twice the memory), a stream 2.5 times,
//! a fresh buffer 3.8 times. Passes win by 1 to 2 ns a point up to level 3, where there is little to win; evaluation from level 5
//! on. One way for all levels keeps the promise that slice, stream and jump give the same bits.

use crate::error::{Code, Count, Error, Limits, Result};
use crate::num::Scalar;
use crate::subdivide::dyadic::Index;
use crate::subdivide::mask::{Target, sweep};
use crate::subdivide::polygon::Subdivision;
use crate::subdivide::stream::BLOCK;
use alloc::format;
use alloc::vec::Vec;
use core::ops::ControlFlow;

impl<const D: usize, S: Scalar> Subdivision<D, S> {
    /// All points of a level, or of the limit at t = i/2ᵏ. The memory is that of the answer, asked for once.
    ///
    /// *Cost.* O(p) a point and coordinate. *Error.* E ≤ 3(p + 1) for Lane–Riesenfeld schemes: products of positive weights,
    /// each accurate by itself, at every level. Other schemes add (p + 2) u for every ten levels.
    ///
    /// # Errors
    /// S005 for a level above 1000; B001 before anything is allocated if points or bytes exceed the budget; B002 when
    /// cancelled; S003 for the limit of a scheme whose convergence is not proven; P003 if a scheme that does not converge
    /// may leave the range of floats.
    pub fn level(&self, level: usize, target: Target, limits: &Limits<'_>) -> Result<Vec<[S; D]>> {
        let count = self.count(level, target)?.saturated();
        limits.check_points(count)?;
        limits.check_bytes(count.saturating_mul(size_of::<[S; D]>() as u64))?;
        let Ok(count) = usize::try_from(count) else {
            return Err(Error::new(Code::B001, format!("{count} points do not fit into this machine's memory")));
        };
        let zero: [S; D] = core::array::from_fn(|_| S::zero());
        let mut out = alloc::vec![zero; count];
        self.level_into(level, target, limits, &mut out)?;
        Ok(out)
    }

    /// [`Subdivision::level`] into the caller's buffer, which must have [`Subdivision::count`] places.
    ///
    /// # Errors
    /// P005 for a buffer of another length; otherwise as [`Subdivision::level`], without the budget of bytes.
    pub fn level_into(&self, level: usize, target: Target, limits: &Limits<'_>, out: &mut [[S; D]]) -> Result<()> {
        let count = self.count(level, target)?.saturated();
        limits.check_points(count)?;
        if out.len() as u64 != count {
            return Err(Error::new(Code::P005, format!("{} where {count} are needed", Count(out.len(), "place"))));
        }
        let leaps = self.leaps(level, target, count)?;
        let [rows] = &leaps[..] else {
            let mut rest = out;
            return self.range(level, target, &Index::default(), count, limits, &mut |block| {
                let (filled, left) = core::mem::take(&mut rest).split_at_mut(block.len());
                filled.clone_from_slice(block);
                rest = left;
                ControlFlow::Continue(())
            });
        };
        let (spans, mut scratch) = (self.spans(), Vec::new());
        if spans == 0 {
            self.fill(rows, 0, Index::default(), out, &mut scratch);
            return Ok(());
        }
        // With a segment, a level whose points fit into a slice has an index type to spare.
        let steps = 1usize << level.min(62);
        for base in (0..steps).step_by(BLOCK) {
            let size = BLOCK.min(steps - base);
            let weights = rows.rows(&Index::from(base as u64), size, &mut scratch);
            for q in (0..spans).step_by(64) {
                limits.check_cancel()?;
                let end = (q + 64).min(spans);
                let places = &mut out[q * steps + base..(end - 1) * steps + base + size];
                sweep(weights, rows.width(), &self.data()[q..], steps, places);
            }
        }
        self.fill(rows, spans, Index::default(), &mut out[spans * steps..], &mut scratch);
        Ok(())
    }
}
