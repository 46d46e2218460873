//! Curves of any family, one after another.

use crate::curve::interval::{Interval, segment};
use crate::curve::protocol::{BezierPiece, Curve, RationalPiece};
use crate::error::{Code, Error, Number, Result};
use crate::knot::Side;
use crate::space::{Weighted, distance};
use alloc::boxed::Box;
use alloc::format;
use alloc::vec::Vec;

/// Curves joined end to start: each keeps the length of its own domain, shifted to begin where the one before it ended; the first
/// keeps its parameters.
///
/// *Invariance:* what its pieces share. *Continuity:* C⁰ where the ends meet; they need not.
///
/// *Cost.* O(log n) and one evaluation of a piece. *Error.* The piece's own, and the rounding of the shift.
///
/// *Closed:* the last end must be the first start, exactly.
///
/// ```
/// use lath::curve::{Bezier, Curve, Path, Polyline};
///
/// let arch = Bezier::new([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]])?;
/// let base = Polyline::new([[2.0, 0.0], [0.0, 0.0]])?;
/// let outline = Path::new([Box::new(arch) as Box<dyn Curve<2>>, Box::new(base)], true)?;
/// assert_eq!(outline.eval(0.5)?, [1.0, 1.0]);
/// assert_eq!(outline.eval(1.5)?, [1.0, 0.0]);
/// # Ok::<(), lath::error::Error>(())
/// ```
#[derive(Debug)]
pub struct Path<const D: usize> {
    pieces: Vec<Box<dyn Curve<D>>>,
    /// Where each piece starts, and where the last ends.
    starts: Vec<f64>,
    closed: bool,
}

impl<const D: usize> Path<D> {
    /// The path of at least one piece.
    ///
    /// # Errors
    /// P001 for no piece; T005 with the piece's index if the sum of the domains swallows one, or a part of it; C002 if a closed path
    /// does not end where it starts.
    pub fn new(pieces: impl IntoIterator<Item = Box<dyn Curve<D>>>, closed: bool) -> Result<Path<D>> {
        let pieces: Vec<_> = pieces.into_iter().collect();
        let (Some(first), Some(last)) = (pieces.first(), pieces.last()) else {
            return Err(Error::new(Code::P001, "a path of no pieces"));
        };
        let (mut start, mut end) = ([[0.0; D]], [[0.0; D]]);
        first.jet_into(first.domain().start, Side::Right, &mut start);
        last.jet_into(last.domain().end, Side::Left, &mut end);
        if closed && start != end {
            let gap = distance(&start[0], &end[0]);
            return Err(Error::new(Code::C002, format!("the path ends {gap:e} away from its start")));
        }
        let mut starts = alloc::vec![first.domain().start];
        for (i, piece) in pieces.iter().enumerate() {
            let Interval { start, end } = piece.domain();
            // The first piece keeps its parameters to the bit.
            let next = if i == 0 { end } else { starts[i] + (end - start) };
            if next <= starts[i] || next.abs() > 1e300 {
                let (length, at) = (Number(end - start), Number(starts[i]));
                let message = format!("piece {i} of length {length} is lost at parameter {at}");
                return Err(Error::new(Code::T005, message).at(i));
            }
            starts.push(next);
        }
        let path = Path { pieces, starts, closed };
        if let Some(i) = (0..path.pieces.len()).find(|&i| !path.is_whole(i)) {
            let message = format!("a part of piece {i} is lost at parameter {}", Number(path.starts[i]));
            return Err(Error::new(Code::T005, message).at(i));
        }
        Ok(path)
    }

    /// The pieces, each with its own domain.
    pub fn pieces(&self) -> &[Box<dyn Curve<D>>] {
        &self.pieces
    }

    /// The path's parameter for piece i's own.
    fn to_path(&self, i: usize, t: f64) -> f64 {
        let own = self.pieces[i].domain();
        match i {
            0 => t,
            _ if t == own.end => self.starts[i + 1],
            _ => self.starts[i] + (t - own.start),
        }
    }

    /// Whether the shift of piece i leaves every part of it some length: what lies between its breaks, and every rational piece.
    fn is_whole(&self, i: usize) -> bool {
        let piece = &self.pieces[i];
        let mut whole = piece.breaks().windows(2).all(|pair| self.to_path(i, pair[0]) < self.to_path(i, pair[1]));
        if i > 0 && piece.is_rational() {
            piece.rational_pieces(&mut |part| whole &= self.to_path(i, part.start) < self.to_path(i, part.end));
        }
        whole
    }
}

impl<const D: usize> Curve<D> for Path<D> {
    fn kind(&self) -> &'static str {
        "path"
    }

    /// The greatest degree of a piece.
    fn degree(&self) -> usize {
        self.pieces.iter().map(|piece| piece.degree()).max().unwrap_or(0)
    }

    fn domain(&self) -> Interval {
        Interval { start: self.starts[0], end: self.starts[self.pieces.len()] }
    }

    fn jet_into(&self, t: f64, side: Side, out: &mut [[f64; D]]) {
        let i = segment(&self.starts, t, side);
        let own = self.pieces[i].domain();
        // The shift must not push a parameter of this piece over its end, where the other side would answer.
        let shifted = match i {
            0 => t,
            _ if t == self.starts[i + 1] => own.end,
            _ => own.start + (t - self.starts[i]),
        };
        let inside = t < self.starts[i + 1] && shifted > own.end;
        self.pieces[i].jet_into(if inside { own.end } else { shifted }, side, out);
    }

    fn breaks(&self) -> Vec<f64> {
        let mut breaks = alloc::vec![self.starts[0]];
        for (i, piece) in self.pieces.iter().enumerate() {
            breaks.extend(piece.breaks().into_iter().skip(1).map(|t| self.to_path(i, t)));
        }
        breaks.dedup();
        breaks
    }

    fn is_closed(&self) -> bool {
        self.closed
    }

    fn bezier_pieces(&self, visit: &mut dyn FnMut(BezierPiece<'_, D>)) -> bool {
        // Nothing may be handed out before all have agreed.
        if !self.pieces.iter().all(|piece| piece.bezier_pieces(&mut |_| {})) {
            return false;
        }
        for (i, piece) in self.pieces.iter().enumerate() {
            piece.bezier_pieces(&mut |own| {
                let (start, end) = (self.to_path(i, own.start), self.to_path(i, own.end));
                visit(BezierPiece { start, end, points: own.points });
            });
        }
        true
    }

    /// Whether one of the pieces is.
    fn is_rational(&self) -> bool {
        self.pieces.iter().any(|piece| piece.is_rational())
    }

    fn rational_pieces(&self, visit: &mut dyn FnMut(RationalPiece<'_, D>)) -> bool {
        let known = |piece: &dyn Curve<D>| piece.rational_pieces(&mut |_| {}) || piece.bezier_pieces(&mut |_| {});
        if !self.pieces.iter().all(|piece| known(&**piece)) {
            return false;
        }
        for (i, piece) in self.pieces.iter().enumerate() {
            let rational = piece.rational_pieces(&mut |own| {
                let (start, end) = (self.to_path(i, own.start), self.to_path(i, own.end));
                visit(RationalPiece { start, end, points: own.points });
            });
            if !rational {
                piece.bezier_pieces(&mut |own| {
                    let (start, end) = (self.to_path(i, own.start), self.to_path(i, own.end));
                    let weigh = |point: &[f64; D]| Weighted { point: *point, weight: 1.0 };
                    let points: Vec<Weighted<D>> = own.points.iter().map(weigh).collect();
                    visit(RationalPiece { start, end, points: &points });
                });
            }
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::{Bezier, Polyline};
    use alloc::vec;

    fn boxed<C: Curve<2>>(curve: C) -> Box<dyn Curve<2>> {
        Box::new(curve)
    }

    #[test]
    fn pieces_keep_their_lengths_and_their_sides() {
        let arch = Bezier::on([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]], Interval { start: 3.0, end: 5.0 }).unwrap();
        let stairs = Polyline::new([[2.0, 0.0], [2.0, -1.0], [3.0, -1.0]]).unwrap();
        let path = Path::new([boxed(arch), boxed(stairs)], false).unwrap();
        assert_eq!(path.domain(), Interval { start: 3.0, end: 7.0 });
        assert_eq!(path.breaks(), [3.0, 5.0, 6.0, 7.0]);
        let mut jet = [[0.0; 2]; 2];
        path.jet_into(5.0, Side::Left, &mut jet);
        assert_eq!(jet, [[2.0, 0.0], [1.0, -2.0]]);
        path.jet_into(5.0, Side::Right, &mut jet);
        assert_eq!(jet, [[2.0, 0.0], [0.0, -1.0]]);
        assert_eq!(path.eval(7.0).unwrap(), [3.0, -1.0]);
        let mut ends = vec![];
        assert!(path.bezier_pieces(&mut |piece| ends.push((piece.start, piece.end))));
        assert_eq!(ends, [(3.0, 5.0), (5.0, 6.0), (6.0, 7.0)]);
    }

    #[test]
    fn the_first_piece_keeps_its_parameters_and_no_part_of_another_is_lost() {
        let line = |end: f64| boxed(Bezier::on([[0.0, 0.0], [1.0, 2.0]], Interval { start: 0.1, end }).unwrap());
        let bent = |knee: f64| {
            let points = [[1.0, 2.0], [2.0, 0.0], [3.0, 0.0]];
            boxed(crate::curve::BSpline::over(vec![0.0, 0.0, knee, 1.0, 1.0], 1, points).unwrap())
        };
        let path = Path::new([line(0.7), bent(0.5)], false).unwrap();
        assert_eq!(path.breaks()[..2], [0.1, 0.7]);
        let lost = Path::new([line(0.7), bent(1e-17)], false).unwrap_err();
        assert_eq!((lost.code(), lost.index()), (Code::T005, Some(1)));
        assert!(Path::new([bent(1e-17), line(0.7)], false).is_ok());
    }

    #[test]
    fn a_closed_path_must_close() {
        let open = || boxed(Polyline::new([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]).unwrap());
        assert_eq!(Path::new([open()], true).unwrap_err().code(), Code::C002);
        assert_eq!(Path::<2>::new([], false).unwrap_err().code(), Code::P001);
        let back = boxed(Polyline::new([[1.0, 1.0], [0.0, 0.0]]).unwrap());
        assert!(Path::new([open(), back], true).unwrap().is_closed());
    }
}
