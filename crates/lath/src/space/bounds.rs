//! Axis-parallel boxes.

/// An axis-parallel box: all x with lo ≤ x ≤ hi in every coordinate.
///
/// ```
/// use lath::space::Bounds;
///
/// let bounds = Bounds::around(&[[1.0, 5.0], [3.0, 2.0]]).unwrap();
/// assert_eq!((bounds.lo, bounds.hi), ([1.0, 2.0], [3.0, 5.0]));
/// assert!(bounds.contains(&[2.0, 2.0]));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds<const D: usize> {
    /// The least coordinates.
    pub lo: [f64; D],
    /// The greatest coordinates.
    pub hi: [f64; D],
}

impl<const D: usize> Bounds<D> {
    /// The box of one point.
    pub fn at(point: [f64; D]) -> Bounds<D> {
        Bounds { lo: point, hi: point }
    }

    /// The smallest box around the points; none for no points.
    pub fn around(points: &[[f64; D]]) -> Option<Bounds<D>> {
        let (first, rest) = points.split_first()?;
        let mut bounds = Bounds::at(*first);
        for point in rest {
            bounds.include(point);
        }
        Some(bounds)
    }

    /// Grows the box to take in a point; NaN coordinates are ignored.
    pub fn include(&mut self, point: &[f64; D]) {
        for c in 0..D {
            if point[c] < self.lo[c] {
                self.lo[c] = point[c];
            }
            if point[c] > self.hi[c] {
                self.hi[c] = point[c];
            }
        }
    }

    /// Whether the point lies inside or on the border.
    pub fn contains(&self, point: &[f64; D]) -> bool {
        (0..D).all(|c| self.lo[c] <= point[c] && point[c] <= self.hi[c])
    }

    /// The extent along each axis.
    pub fn size(&self) -> [f64; D] {
        core::array::from_fn(|c| self.hi[c] - self.lo[c])
    }
}
