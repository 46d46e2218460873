//! Levels and ranges as a stream, and the jump to a single point.
//!
//! A Lane–Riesenfeld level is one leap from level 0, whatever its height: every point is a row of weights by blossoms. Other
//! schemes leap ten levels at a time, with the rows of all 1024 residues stored; each leap feeds the next through a window
//! of p + 1 points. The memory is that of the windows and the rows, whatever the level.

use crate::error::{Code, Error, Limits, Result};
use crate::num::Scalar;
use crate::subdivide::dyadic::Index;
use crate::subdivide::mask::{Rows, Target, combine, first};
use crate::subdivide::polygon::{Ends, Subdivision};
use alloc::format;
use alloc::vec::Vec;
use core::ops::ControlFlow;

/// How many points go to a sink at once, and how many rows of weights are held at once.
pub(crate) const BLOCK: usize = 1024;

/// How many levels a scheme without blossoms leaps at once.
const LEAP: usize = 10;

impl<const D: usize, S: Scalar> Subdivision<D, S> {
    /// Sends all points of a level (or of the limit at t = i/2ᵏ) to `sink`, in order, in blocks of at most 1024.
    /// `ControlFlow::Break` from the sink ends the stream; that is no error.
    ///
    /// *Cost.* O(p²) a point for Lane–Riesenfeld schemes, O(p) for others, above level 10; below it O(p) for both. The memory
    /// does not depend on the level. *Error.* As [`Subdivision::level`]; the points are the same, bit for bit.
    ///
    /// ```
    /// use core::ops::ControlFlow;
    /// use lath::error::Limits;
    /// use lath::subdivide::{Ends, Scheme, Subdivision, Target};
    ///
    /// let corners = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];
    /// let curve = Subdivision::new(Scheme::cubic(), corners, Ends::Closed)?;
    /// let mut length = 0;
    /// curve.stream(12, Target::Limit, &Limits::default(), &mut |block| {
    ///     length += block.len();
    ///     ControlFlow::Continue(())
    /// })?;
    /// assert_eq!(length, 4 << 12);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Subdivision::level`]; of the budget only points count.
    pub fn stream(
        &self,
        level: usize,
        target: Target,
        limits: &Limits<'_>,
        sink: &mut dyn FnMut(&[[S; D]]) -> ControlFlow<()>,
    ) -> Result<()> {
        let count = self.count(level, target)?.saturated();
        self.range(level, target, &Index::default(), count, limits, sink)
    }

    /// Sends `count` points of a level to `sink`, in order, from the index `start` on: see [`Subdivision::stream`].
    ///
    /// # Errors
    /// S006 if the range leaves the level; otherwise as [`Subdivision::stream`].
    pub fn range(
        &self,
        level: usize,
        target: Target,
        start: &Index,
        count: u64,
        limits: &Limits<'_>,
        sink: &mut dyn FnMut(&[[S; D]]) -> ControlFlow<()>,
    ) -> Result<()> {
        let all = self.count(level, target)?;
        limits.check_points(count)?;
        if start.plus(&Index::from(count)) > all {
            let message = format!("{count} wanted from index {start} on; level {level} has {all}");
            return Err(Error::new(Code::S006, message));
        }
        if count == 0 {
            return Ok(());
        }
        let leaps = self.leaps(level, target, count)?;
        let q = start.shifted_down(level).saturated() as usize;
        let zero: [S; D] = core::array::from_fn(|_| S::zero());
        let mut buffer = alloc::vec![zero; count.min(BLOCK as u64) as usize];
        if let [rows] = &leaps[..] {
            return self.direct(rows, (q, start.low_bits(level)), count, limits, &mut buffer, sink);
        }
        let mut stages = Vec::with_capacity(leaps.len());
        let mut below = level;
        for rows in leaps {
            below -= rows.bits();
            // What this leap makes lies `below` levels under the last; its first point is an ancestor of the start.
            let from = start.shifted_down(below);
            let real = if below == 0 {
                count
            } else {
                let made = self.count(level - below, Target::Level)?;
                if self.is_closed() { u64::MAX } else { made.minus(&from).unwrap_or_default().saturated() }
            };
            let from = from.low_bits(rows.bits()).saturated() as usize;
            stages.push(Stage { from, real, window: Vec::new(), rows });
        }
        let mut output = Output { buffer, filled: 0, left: count, limits, sink, outcome: Ok(()) };
        for j in q.. {
            if push(&mut stages, self.source(j), &mut output).is_break() {
                break;
            }
        }
        output.outcome
    }

    /// One point of a level, or of the limit at t = i/2ᵏ, without the levels between: the same bits as in the whole level.
    ///
    /// *Cost.* Lane–Riesenfeld: O(p²), once the index is read; other schemes: one product of small matrices for each bit of
    /// the index. Levels up to 1000, indices of any length.
    ///
    /// ```
    /// use lath::subdivide::{Ends, Index, Scheme, Subdivision, Target};
    ///
    /// let line = Subdivision::new(Scheme::cubic(), (0..5).map(|i| [f64::from(i)]), Ends::Open)?;
    /// let half = Index::from(1).shifted_up(999); // i = 2⁹⁹⁹ of level 1000: t = ½
    /// assert_eq!(line.point(1000, Target::Limit, &half)?, [1.5]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// S005 for a level above 1000; S006 for an index beyond the level; S003 for the limit of a scheme whose convergence
    /// is not proven; P003 as [`Subdivision::level`].
    pub fn point(&self, level: usize, target: Target, index: &Index) -> Result<[S; D]> {
        let mut found = None;
        self.range(level, target, index, 1, &Limits::default(), &mut |block| {
            found = block.first().cloned();
            ControlFlow::Continue(())
        })?;
        found.ok_or_else(|| Error::new(Code::S006, format!("index {index} of level {level}")))
    }

    /// The leaps to a level, coarse to fine; `wanted` points decide whether rows are stored.
    pub(crate) fn leaps(&self, level: usize, target: Target, wanted: u64) -> Result<Vec<Rows<S>>> {
        self.check_growth(level)?;
        let scheme = self.scheme();
        if scheme.is_spline() {
            return Ok(alloc::vec![Rows::spline(scheme, level, target, wanted)]);
        }
        let width = scheme.degree() + 1;
        let count = level.div_ceil(LEAP).max(1);
        let mut leaps = Vec::with_capacity(count);
        for place in 0..count {
            // The first leap takes what the others leave.
            let bits = if place == 0 { level - (count - 1) * LEAP } else { LEAP };
            let last = place + 1 == count;
            let seed = if last && target == Target::Limit {
                let mut seed = scheme.limit_mask(0)?;
                seed.push(S::zero());
                seed
            } else {
                first(width)
            };
            let passing = if last { wanted } else { (wanted >> ((count - 1 - place) * LEAP).min(63)).max(1) };
            leaps.push(Rows::product(scheme, bits, seed, passing));
        }
        Ok(leaps)
    }

    /// Fills `out` with the points of a single leap from the index 2ᵏ q + r on; says where it ended.
    pub(crate) fn fill(
        &self,
        rows: &Rows<S>,
        mut q: usize,
        mut r: Index,
        out: &mut [[S; D]],
        scratch: &mut Vec<S>,
    ) -> (usize, Index) {
        let steps = Index::from(1).shifted_up(rows.bits());
        let mut rest = out;
        while !rest.is_empty() {
            let left = steps.minus(&r).unwrap_or_default().saturated();
            let size = left.min(rest.len().min(BLOCK) as u64) as usize;
            let (now, later) = rest.split_at_mut(size);
            combine(rows.rows(&r, size, scratch), self.window(q), now);
            rest = later;
            r = r.plus(&Index::from(size as u64));
            if r == steps {
                (q, r) = (q + 1, Index::default());
            }
        }
        (q, r)
    }

    /// A stream through a single leap.
    fn direct(
        &self,
        rows: &Rows<S>,
        (mut q, mut r): (usize, Index),
        count: u64,
        limits: &Limits<'_>,
        buffer: &mut [[S; D]],
        sink: &mut dyn FnMut(&[[S; D]]) -> ControlFlow<()>,
    ) -> Result<()> {
        let mut scratch = Vec::new();
        let mut left = count;
        while left > 0 {
            limits.check_cancel()?;
            let size = left.min(buffer.len() as u64) as usize;
            (q, r) = self.fill(rows, q, r, &mut buffer[..size], &mut scratch);
            if sink(&buffer[..size]).is_break() {
                return Ok(());
            }
            left -= size as u64;
        }
        Ok(())
    }

    pub(crate) fn is_closed(&self) -> bool {
        self.ends() == Ends::Closed
    }
}

/// One leap of several: takes points of one level, makes those of a level some ten higher.
struct Stage<S, const D: usize> {
    rows: Rows<S>,
    /// The p + 1 latest points.
    window: Vec<[S; D]>,
    /// The first residue wanted of the next window.
    from: usize,
    /// How many more points this leap makes; after them zeros follow, which meet zero weights only.
    real: u64,
}

/// Where the last leap's points go.
struct Output<'a, S, const D: usize> {
    buffer: Vec<[S; D]>,
    filled: usize,
    left: u64,
    limits: &'a Limits<'a>,
    sink: &'a mut dyn FnMut(&[[S; D]]) -> ControlFlow<()>,
    outcome: Result<()>,
}

impl<S: Scalar, const D: usize> Output<'_, S, D> {
    /// The free places of the buffer, no more than points are wanted.
    fn space(&mut self, most: usize) -> &mut [[S; D]] {
        let wanted = usize::try_from(self.left).unwrap_or(usize::MAX).min(most);
        let end = self.buffer.len().min(self.filled.saturating_add(wanted));
        &mut self.buffer[self.filled..end]
    }

    /// So many places have been filled: hands a full buffer, or the last one, to the sink.
    fn advance(&mut self, count: usize) -> ControlFlow<()> {
        self.filled += count;
        self.left -= count as u64;
        if self.filled < self.buffer.len() && self.left > 0 {
            return ControlFlow::Continue(());
        }
        self.outcome = self.limits.check_cancel();
        if self.outcome.is_err() || (self.sink)(&self.buffer[..self.filled]).is_break() || self.left == 0 {
            return ControlFlow::Break(());
        }
        self.filled = 0;
        ControlFlow::Continue(())
    }
}

/// Hands a point to the first stage, and what it makes of it to the next.
fn push<S: Scalar, const D: usize>(
    stages: &mut [Stage<S, D>],
    point: [S; D],
    output: &mut Output<'_, S, D>,
) -> ControlFlow<()> {
    let Some((stage, rest)) = stages.split_first_mut() else { return ControlFlow::Continue(()) };
    stage.window.push(point);
    if stage.window.len() < stage.rows.width() {
        return ControlFlow::Continue(());
    }
    let steps = 1usize << stage.rows.bits();
    let mut scratch = Vec::new();
    let mut made: Vec<[S; D]> = Vec::new();
    while stage.from < steps {
        // Rows that are stored come in blocks; rows that are not are few.
        let ahead = match stage.rows {
            Rows::Table { .. } => BLOCK,
            _ => stage.rows.width(),
        };
        let size = ahead.min(steps - stage.from);
        if rest.is_empty() {
            let out = output.space(size);
            let size = out.len();
            combine(stage.rows.rows(&Index::from(stage.from as u64), size, &mut scratch), &stage.window, out);
            stage.from += size;
            output.advance(size)?;
            continue;
        }
        let size = size.min(usize::try_from(stage.real.max(1)).unwrap_or(usize::MAX));
        made.clear();
        made.resize_with(size, || core::array::from_fn(|_| S::zero()));
        if stage.real > 0 {
            let weights = stage.rows.rows(&Index::from(stage.from as u64), size, &mut scratch);
            combine(weights, &stage.window, &mut made);
        }
        stage.real = stage.real.saturating_sub(size as u64);
        stage.from += size;
        for point in made.drain(..) {
            push(rest, point, output)?;
        }
    }
    stage.from = 0;
    stage.window.remove(0);
    ControlFlow::Continue(())
}
