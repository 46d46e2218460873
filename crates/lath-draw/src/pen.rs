//! Draws joined Bézier pieces as a path, and does not draw what nobody can see.
//!
//! Pieces are written as they are. Only when more than sixteen in a row stay within a strip a quarter of a px wide or
//! high, or more than four within half a px both ways, are they drawn as the lines through their first, extreme and last
//! points: a million pieces in a thousand columns of pixels become some ten thousand lines, off by at most half a px.

use crate::extent::Extent;
use crate::path::{Path, Point};

/// The width of a strip in px.
const STRIP: f64 = 0.25;
/// So many pieces in a strip are written as they are, and so many within twice its width.
const EXACT: usize = 16;
const TINY: usize = 4;
/// Ends closer than this many px are one point: what rounding makes of a joint.
const JOINT: f64 = 1e-3;

/// Receives pieces in px and builds their path.
pub(crate) struct Pen {
    path: Path,
    first: Point,
    last: Option<Point>,
    run: Run,
}

/// Pieces that have not been written yet: exactly, while they are few; as extremes, when they are many.
struct Run {
    extent: Extent,
    pieces: Vec<Vec<Point>>,
    count: usize,
    /// Leftmost, rightmost, highest, lowest points with their places in the run.
    extremes: [(usize, Point); 4],
}

impl Run {
    const EMPTY: Run = Run { extent: Extent::EMPTY, pieces: Vec::new(), count: 0, extremes: [(0, [0.0; 2]); 4] };
}

impl Pen {
    pub(crate) fn new() -> Pen {
        Pen { path: Path::new(), first: [0.0; 2], last: None, run: Run::EMPTY }
    }

    /// Draws a piece of degree 0 to 3, unless it has a point that is not finite; a piece that does not begin where the last ended begins a new subpath.
    pub(crate) fn piece(&mut self, points: &[Point]) {
        let (Some(&start), Some(&end)) = (points.first(), points.last()) else { return };
        if !points.iter().flatten().all(|x| x.is_finite()) {
            return;
        }
        let joined = self.last.is_some_and(|p| (p[0] - start[0]).abs() < JOINT && (p[1] - start[1]).abs() < JOINT);
        if !joined {
            self.flush();
            self.path.move_to(start);
            self.first = start;
        }
        let mut extent = self.run.extent;
        for p in points {
            extent.include(*p);
        }
        if extent.width() > STRIP && extent.height() > STRIP {
            self.flush();
            extent = Extent::EMPTY;
            for p in points {
                extent.include(*p);
            }
        }
        self.run.extent = extent;
        self.run.count += 1;
        let mut tight = Extent::EMPTY;
        tight.include_piece(points);
        let reached = [[tight.lo[0], end[1]], [tight.hi[0], end[1]], [end[0], tight.lo[1]], [end[0], tight.hi[1]]];
        let places = [-tight.lo[0], tight.hi[0], -tight.lo[1], tight.hi[1]];
        for (k, place) in places.into_iter().enumerate() {
            let known = self.run.extremes[k].1;
            let known = [-known[0], known[0], -known[1], known[1]][k];
            if self.run.count == 1 || place > known {
                self.run.extremes[k] = (self.run.count, reached[k]);
            }
        }
        if self.run.count <= EXACT {
            self.run.pieces.push(points.to_vec());
        }
        self.last = Some(end);
    }

    fn flush(&mut self) {
        let run = core::mem::replace(&mut self.run, Run::EMPTY);
        if run.count <= TINY || (run.count <= EXACT && run.extent.longest() > 2.0 * STRIP) {
            for piece in &run.pieces {
                match piece[..] {
                    [_, p] => self.path.line_to(p),
                    [_, a, p] => self.path.quad_to(a, p),
                    [_, a, b, p] => self.path.cubic_to(a, b, p),
                    // A degree of 0: a dot, by the round ends of a line without length.
                    [p] => self.path.line_to(p),
                    _ => {}
                }
            }
            return;
        }
        let mut extremes = run.extremes;
        extremes.sort_by_key(|(place, _)| *place);
        let mut drawn = 0;
        for (place, p) in extremes.into_iter().chain(self.last.map(|p| (run.count, p))) {
            if place > drawn {
                self.path.line_to(p);
                drawn = place;
            }
        }
    }

    /// The path. With `closed`, a last subpath that returns to its beginning is closed, so that its corner is joined.
    pub(crate) fn finish(mut self, closed: bool) -> Path {
        self.flush();
        let returns = |p: Point| (p[0] - self.first[0]).abs() < JOINT && (p[1] - self.first[1]).abs() < JOINT;
        if closed && self.last.is_some_and(returns) {
            self.path.close();
        }
        self.path
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::Segment;

    #[test]
    fn pieces_become_the_commands_of_their_degree() {
        let mut pen = Pen::new();
        pen.piece(&[[0.0, 0.0], [10.0, 5.0]]);
        pen.piece(&[[10.0, 5.0], [20.0, 0.0], [30.0, 5.0]]);
        pen.piece(&[[30.0, 5.0], [30.0, 20.0], [0.0, 20.0], [0.0, 0.0]]);
        assert_eq!(
            pen.finish(true).segments(),
            [
                Segment::Move([0.0, 0.0]),
                Segment::Line([10.0, 5.0]),
                Segment::Quad([20.0, 0.0], [30.0, 5.0]),
                Segment::Cubic([30.0, 20.0], [0.0, 20.0], [0.0, 0.0]),
                Segment::Close,
            ]
        );
    }

    #[test]
    fn a_gap_begins_a_new_subpath() {
        let mut pen = Pen::new();
        pen.piece(&[[0.0, 0.0], [10.0, 0.0]]);
        pen.piece(&[[10.0, 5.0], [20.0, 5.0]]);
        pen.piece(&[[20.0, 9.0]]);
        assert_eq!(
            pen.finish(true).segments(),
            [
                Segment::Move([0.0, 0.0]),
                Segment::Line([10.0, 0.0]),
                Segment::Move([10.0, 5.0]),
                Segment::Line([20.0, 5.0]),
                Segment::Move([20.0, 9.0]),
                Segment::Line([20.0, 9.0]),
                Segment::Close,
            ]
        );
    }

    #[test]
    fn a_million_pieces_keep_their_envelope() {
        let mut pen = Pen::new();
        let noise = |i: usize| ((i * 7919) % 1000) as f64 / 2.0;
        let at = |i: usize| [i as f64 / 1000.0, noise(i)];
        for i in 0..1_000_000 {
            pen.piece(&[at(i), at(i + 1)]);
        }
        let path = pen.finish(false);
        assert!(path.segments().len() < 60_000, "{}", path.segments().len());
        let mut extent = Extent::EMPTY;
        for segment in path.segments() {
            if let Segment::Move(p) | Segment::Line(p) = segment {
                extent.include(*p);
            }
        }
        assert_eq!((extent.lo, extent.hi), ([0.0, 0.0], [1000.0, 499.5]));
        assert_eq!(Pen::new().finish(true).segments(), []);
    }
}
