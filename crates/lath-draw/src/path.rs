//! Paths of lines and Béziers, in px, y down.

/// A point of the picture in px, y down.
pub type Point = [f64; 2];

/// One command of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Segment {
    /// Begin a new subpath.
    Move(Point),
    /// A straight line to here.
    Line(Point),
    /// A parabola: control point, end.
    Quad(Point, Point),
    /// A cubic Bézier: two control points, end.
    Cubic(Point, Point, Point),
    /// Back to the subpath's first point.
    Close,
}

/// Subpaths of lines, parabolas and cubic Béziers.
///
/// ```
/// use lath_draw::path::Path;
///
/// let mut path = Path::new();
/// path.move_to([0.0, 0.0]);
/// path.cubic_to([1.0, 0.0], [2.0, 1.0], [2.0, 2.0]);
/// assert_eq!(path.segments().len(), 2);
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Path {
    segments: Vec<Segment>,
}

impl Path {
    /// A path without anything in it.
    pub fn new() -> Path {
        Path::default()
    }

    /// The commands in order.
    pub fn segments(&self) -> &[Segment] {
        &self.segments
    }

    /// Whether there is nothing to draw.
    pub fn is_empty(&self) -> bool {
        self.segments.is_empty()
    }

    /// Begins a new subpath.
    pub fn move_to(&mut self, p: Point) {
        self.segments.push(Segment::Move(p));
    }

    /// Draws a line.
    pub fn line_to(&mut self, p: Point) {
        self.segments.push(Segment::Line(p));
    }

    /// Draws a parabola.
    pub fn quad_to(&mut self, a: Point, p: Point) {
        self.segments.push(Segment::Quad(a, p));
    }

    /// Draws a cubic Bézier.
    pub fn cubic_to(&mut self, a: Point, b: Point, p: Point) {
        self.segments.push(Segment::Cubic(a, b, p));
    }

    /// Closes the subpath.
    pub fn close(&mut self) {
        self.segments.push(Segment::Close);
    }

    /// Adds one straight line as a subpath of its own.
    pub fn line(&mut self, from: Point, to: Point) {
        self.move_to(from);
        self.line_to(to);
    }

    /// Adds lines through the points as a subpath of its own.
    pub fn polyline(&mut self, points: impl IntoIterator<Item = Point>, closed: bool) {
        let mut points = points.into_iter();
        let Some(first) = points.next() else { return };
        self.move_to(first);
        for p in points {
            self.line_to(p);
        }
        if closed {
            self.close();
        }
    }

    /// Adds another path's commands, each point passed through `map`.
    pub fn extend_mapped(&mut self, other: &Path, map: impl Fn(Point) -> Point) {
        self.segments.extend(other.segments.iter().map(|segment| match *segment {
            Segment::Move(p) => Segment::Move(map(p)),
            Segment::Line(p) => Segment::Line(map(p)),
            Segment::Quad(a, p) => Segment::Quad(map(a), map(p)),
            Segment::Cubic(a, b, p) => Segment::Cubic(map(a), map(b), map(p)),
            Segment::Close => Segment::Close,
        }));
    }
}
