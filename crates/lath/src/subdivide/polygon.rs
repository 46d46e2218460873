//! A polygon under a scheme, and the sizes of its levels.

use crate::error::{Code, Count, Error, Result};
use crate::num::Scalar;
use crate::subdivide::dyadic::Index;
use crate::subdivide::mask::Target;
use crate::subdivide::scheme::{Scheme, is_exact, magnitude};
use alloc::format;
use alloc::vec::Vec;
use core::cmp::Ordering;

/// The greatest level: 2⁻¹⁰⁰⁰ is still far above the least float.
pub const MAX_LEVEL: usize = 1000;

/// What happens at the ends of a polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Ends {
    /// The polygon retreats: from n points the next level has 2n − p.
    #[default]
    Open,
    /// The end points count p times, so that curve and levels start and end in them.
    Kept,
    /// The polygon returns from its last point to its first: from n points the next level has 2n.
    Closed,
}

/// A polygon under a scheme: everything about its levels and its limit can be asked of it.
///
/// Point i = 2ᵏ q + r of level k depends on the p + 1 points P_q … P_{q+p} alone. That makes every point of every level a jump
/// ([`Subdivision::point`]), every level a slice ([`Subdivision::level`]) or a stream ([`Subdivision::stream`]) without the levels
/// before it, and the limit a curve with a parameter: t = i/2ᵏ, in units of segments from the first joint. The
/// three ways give the same bits.
///
/// ```
/// use lath::error::Limits;
/// use lath::subdivide::{Ends, Scheme, Subdivision, Target};
///
/// let arch = [[0.0, 0.0], [0.0, 8.0], [8.0, 8.0], [8.0, 0.0]];
/// let cubic = Subdivision::new(Scheme::cubic(), arch, Ends::Open)?;
/// let level = cubic.level(1, Target::Level, &Limits::default())?;
/// assert_eq!(level, [[0.0, 4.0], [1.0, 7.0], [4.0, 8.0], [7.0, 7.0], [8.0, 4.0]]);
/// // One point of level 60, and one of the curve.
/// let i = "123456789".parse()?;
/// let point = cubic.point(60, Target::Level, &i)?;
/// let curve = cubic.point(3, Target::Limit, &6.into())?;
/// assert!((curve[1] - (121.0 * 8.0 + 235.0 * 8.0) / 384.0).abs() < 1e-15); // (1, 121, 235, 27)/384
/// assert!((point[1] - 20.0 / 3.0).abs() < 1e-9); // near the first joint, (0 + 4·8 + 8)/6
/// # Ok::<(), lath::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Subdivision<const D: usize, S = f64> {
    scheme: Scheme<S>,
    /// The n points, kept ends repeated; then p more: the first ones again if closed, else zeros whose weights are zero.
    data: Vec<[S; D]>,
    count: usize,
    ends: Ends,
}

impl<const D: usize, S: Scalar> Subdivision<D, S> {
    /// A polygon under a scheme. Points are arrays of the scheme's scalar.
    ///
    /// *Degenerate input.* p points of an open polygon have levels of p points each and a single joint for a limit; one point
    /// with kept ends, and closed polygons of one point, stay where they are. Equal points are points like any other.
    ///
    /// # Errors
    /// P001 for fewer than p points of an open polygon, or none at all; P002 and P003 for coordinates.
    pub fn new(scheme: Scheme<S>, points: impl IntoIterator<Item = [S; D]>, ends: Ends) -> Result<Subdivision<D, S>> {
        let mut points: Vec<[S; D]> = points.into_iter().collect();
        let limit = (0..10).fold(S::one(), |limit, _| limit * S::from_int(1_000_000_000_000_000));
        let limit = limit.clone() * limit;
        for (index, point) in points.iter().enumerate() {
            for (axis, x) in point.iter().enumerate() {
                if x.is_finite() && magnitude(x) <= limit {
                    continue;
                }
                let code = if x.is_finite() { Code::P003 } else { Code::P002 };
                return Err(Error::new(code, format!("coordinate {axis} of point {index} is {x:?}")).at(index));
            }
        }
        let p = scheme.degree();
        let least = if ends == Ends::Open { p } else { 1 };
        if points.len() < least {
            let message =
                format!("{} for a scheme of degree {p}, which takes at least {least}", Count(points.len(), "point"));
            return Err(Error::new(Code::P001, message));
        }
        if ends == Ends::Kept {
            let (first, last) = (points[0].clone(), points[points.len() - 1].clone());
            let mut kept = alloc::vec![first; p - 1];
            kept.append(&mut points);
            kept.extend(core::iter::repeat_n(last, p - 1));
            points = kept;
        }
        Ok(Subdivision::padded(scheme, points, ends))
    }

    /// From checked points, kept ends already repeated.
    pub(crate) fn padded(scheme: Scheme<S>, mut data: Vec<[S; D]>, ends: Ends) -> Subdivision<D, S> {
        let count = data.len();
        for i in 0..scheme.degree() {
            let more = match ends {
                Ends::Closed => data[i].clone(),
                Ends::Open | Ends::Kept => core::array::from_fn(|_| S::zero()),
            };
            data.push(more);
        }
        Subdivision { scheme, data, count, ends }
    }

    /// The scheme.
    pub fn scheme(&self) -> &Scheme<S> {
        &self.scheme
    }

    /// What happens at the ends.
    pub fn ends(&self) -> Ends {
        self.ends
    }

    /// The points of level 0; kept ends appear p times.
    pub fn control_points(&self) -> &[[S; D]] {
        &self.data[..self.count]
    }

    /// The number of segments of the limit: n − p, or n of a closed polygon. The limit's domain is [0, spans].
    pub fn spans(&self) -> usize {
        if self.ends == Ends::Closed { self.count } else { self.count - self.scheme.degree() }
    }

    /// How many points there are: 2ᵏ(n − p) + p of level k and 2ᵏ(n − p) + 1 of the limit, n·2ᵏ of closed ones.
    ///
    /// ```
    /// use lath::subdivide::{Ends, Scheme, Subdivision, Target};
    ///
    /// let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    /// let group = Subdivision::new(Scheme::cubic(), square, Ends::Open)?;
    /// assert_eq!(group.count(4, Target::Level)?.to_u64(), Some(3 + 16));
    /// assert_eq!(group.count(4, Target::Limit)?.to_u64(), Some(17));
    /// assert_eq!(group.count(1000, Target::Limit)?.bit_length(), 1001);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// S005 for a level above 1000.
    pub fn count(&self, level: usize, target: Target) -> Result<Index> {
        if level > MAX_LEVEL {
            return Err(Error::new(Code::S005, format!("level {level} is above {MAX_LEVEL}")));
        }
        let more = match (self.ends, target) {
            (Ends::Closed, _) => 0,
            (_, Target::Level) => self.scheme.degree() as u64,
            (_, Target::Limit) => 1,
        };
        Ok(Index::from(self.spans() as u64).shifted_up(level).plus(&Index::from(more)))
    }

    /// The next level as a polygon of its own: one pass of the rule, the way a student does it.
    ///
    /// The levels themselves are not made this way; see [`Subdivision::level`].
    ///
    /// # Errors
    /// P003 if a wild mask may leave the range of floats.
    pub fn refined(&self) -> Result<Subdivision<D, S>> {
        self.check_growth(1)?;
        let p = self.scheme.degree();
        let made = 2 * self.spans() + if self.ends == Ends::Closed { 0 } else { p };
        let row = |i: usize| -> [S; D] {
            core::array::from_fn(|c| {
                let (from, to) = (i / 2, (i + p) / 2);
                (from..=to).fold(S::zero(), |sum, j| sum + self.scheme.weight(i, j) * self.data[j][c].clone())
            })
        };
        let ends = if self.ends == Ends::Closed { Ends::Closed } else { Ends::Open };
        Ok(Subdivision::padded(self.scheme.clone(), (0..made).map(row).collect(), ends))
    }

    /// All points that windows reach into.
    pub(crate) fn data(&self) -> &[[S; D]] {
        &self.data
    }

    /// The p + 1 points from q on.
    pub(crate) fn window(&self, q: usize) -> &[[S; D]] {
        let end = (q + self.scheme.degree() + 1).min(self.data.len());
        &self.data[q.min(end)..end]
    }

    /// The point j of level 0, indices modulo n if closed, zero beyond the end if open.
    pub(crate) fn source(&self, j: usize) -> [S; D] {
        let j = if self.ends == Ends::Closed { j % self.count } else { j };
        self.data.get(j).cloned().unwrap_or_else(|| core::array::from_fn(|_| S::zero()))
    }

    /// Refuses levels at which the scheme may carry floats out of their range (P003): masks that do not converge can.
    pub(crate) fn check_growth(&self, level: usize) -> Result<()> {
        if self.scheme.is_spline() || is_exact::<S>() {
            return Ok(());
        }
        let largest = self.data.iter().flatten().fold(S::zero(), |most, x| {
            let x = magnitude(x);
            if x > most { x } else { most }
        });
        let limit = S::from_int(1_000_000_000_000);
        let limit = (0..25).fold(S::one(), |product, _| product * limit.clone()); // 1e300
        // One level at a time is quick and coarse; ten at a time tell more, for the norm of a convergent scheme hardly grows
        // beyond its first power.
        let stays = |stride: usize| {
            let norms = self.scheme.norms(stride);
            let mut size = largest.clone();
            for step in (0..level).step_by(stride) {
                let Some(norm) = norms.get((level - step).min(stride) - 1) else { return false };
                size = size * norm.clone();
                if size.partial_cmp(&limit) != Some(Ordering::Less) {
                    return false; // a NaN, too
                }
            }
            true
        };
        if stays(1) || stays(10) {
            return Ok(());
        }
        Err(Error::new(Code::P003, format!("the scheme may enlarge the polygon beyond 1e300 before level {level}")))
    }
}
