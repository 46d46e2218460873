//! How far a level lies from its limit, proven.
//!
//! Level k is a polyline; its vertex i belongs to the parameter (i − (p − 1)/2)/2ᵏ, the middle of the mask that makes it.
//!
//! *Lane–Riesenfeld.* At every parameter the curve is a convex combination of vertices, Σ Pᵢ Nᵢ, whose weights reproduce linear data and have
//! the variance (p + 1)/12 (p ≥ 2). The line through the two vertices around the parameter differs from Pᵢ by at most
//! (i − a)(i − a − 1)/2 second differences, so the curve is within (p + 1)/24 · max |Δ²P| of the polyline: 1/8 for Chaikin, 1/6
//! for cubics. Second differences shrink by four at each level, exactly.
//!
//! *Other schemes.* Two consecutive levels differ by at most C times the greatest first (or second) difference, C being a sum
//! of the mask's partial sums; the differences shrink with the powers of their own scheme, and the geometric series is summed.
//!
//! *Ends.* An open polyline reaches beyond its curve by (p − 1)/2 vertices at each end. Their distance to the curve's end is
//! measured, for it shrinks only by two at each level; kept ends have none.
//!
//! *Rounding.* The points of a level and of the limit are rounded; what that may add is part of the bound.

use crate::error::{Code, Error, Limits, Number, Result};
use crate::num::Bound;
use crate::space::{distance, norm};
use crate::subdivide::convergence::norms;
use crate::subdivide::dyadic::Index;
use crate::subdivide::mask::Target;
use crate::subdivide::polygon::{Ends, MAX_LEVEL, Subdivision};
use crate::subdivide::scheme::{Scheme, divided};
use alloc::format;
use alloc::vec::Vec;
use core::ops::ControlFlow;

/// What the rounding of a bound's own computation may take from it.
const OUTWARD: f64 = 1.0 + 1e-12;

/// The distance between the polyline of a level and the limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Distance {
    /// No point of the curve is farther than this from the polyline, at equal parameters.
    pub inside: f64,
    /// No point of the polyline beyond the curve's ends is farther than this from the end (or than `inside`): 0 for closed
    /// polygons and for kept ends.
    pub ends: f64,
    /// No point as computed is farther than this from the exact one: 0 at level 0, whose points were given.
    pub rounding: f64,
}

impl Distance {
    /// Curve and polyline, as computed, lie within this of each other as point sets: a theorem.
    pub fn bound(self) -> Bound {
        // The ends were measured between rounded points, which may hide as much again.
        let exact = if self.ends > self.inside { self.ends + self.rounding } else { self.inside };
        Bound::Proven((exact + self.rounding) * OUTWARD)
    }
}

impl<const D: usize> Subdivision<D> {
    /// The distance of a level to the limit, bounded from above.
    ///
    /// ```
    /// use lath::subdivide::{Ends, Scheme, Subdivision};
    ///
    /// let corners = [[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]];
    /// let curve = Subdivision::new(Scheme::chaikin(), corners, Ends::Closed)?;
    /// let here = curve.distance(0)?.bound();
    /// assert!(here.is_proven() && (here.value() - 128f64.sqrt() / 8.0).abs() < 1e-9); // and reached at the corners
    /// assert_eq!(curve.distance(3)?.inside, curve.distance(0)?.inside / 64.0);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// S005 for a level above 1000; S003 if the scheme's convergence is not proven.
    pub fn distance(&self, level: usize) -> Result<Distance> {
        self.count(level, Target::Level)?;
        let decay = self.decay()?;
        let rounding = self.rounding().at(level);
        Ok(Distance { inside: decay.at(level), ends: self.beyond_ends(level, f64::INFINITY)?, rounding })
    }

    /// The least level that lies within `tolerance` of the limit, by [`Subdivision::distance`].
    ///
    /// ```
    /// use lath::subdivide::{Ends, Scheme, Subdivision};
    ///
    /// let part = [[0.0, 0.0], [40.0, 0.0], [40.0, 25.0], [0.0, 25.0]]; // millimetres
    /// let curve = Subdivision::new(Scheme::cubic(), part, Ends::Closed)?;
    /// assert_eq!(curve.levels_for(0.01)?, 5);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// Q001 for a tolerance that is not positive and finite; S005 if no level up to 1000 is proven to come so close, as for
    /// tolerances below the rounding of the points; S003 if the scheme's convergence is not proven.
    pub fn levels_for(&self, tolerance: f64) -> Result<usize> {
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(Error::new(Code::Q001, format!("the tolerance is {}", Number(tolerance))));
        }
        let (decay, floor) = (self.decay()?, self.rounding());
        for level in 0..=MAX_LEVEL {
            let (inside, rounding) = (decay.at(level), floor.at(level));
            if rounding > tolerance {
                break; // and it does not become less
            }
            // The ends are looked at only where the inside is close enough.
            if inside <= tolerance {
                let distance = Distance { inside, ends: self.beyond_ends(level, tolerance)?, rounding };
                if distance.bound().value() <= tolerance {
                    return Ok(level);
                }
            }
        }
        let message = format!("no level up to {MAX_LEVEL} is proven to come within {}", Number(tolerance));
        Err(Error::new(Code::S005, message))
    }

    /// How the bound inside the domain shrinks.
    fn decay(&self) -> Result<Decay> {
        let (scheme, p) = (self.scheme(), self.scheme().degree());
        if scheme.is_spline() {
            let factor = if p < 2 { 0.0 } else { (p + 1) as f64 / 24.0 };
            return Ok(Decay::Quarters(factor * self.greatest_difference(2) * OUTWARD));
        }
        if !scheme.convergence().is_proven() {
            let message = format!("convergence of the mask of {} numbers is not proven", p + 2);
            return Err(Error::new(Code::S003, message));
        }
        let series = [1, 2].into_iter().filter_map(|order| {
            let shrinking = powers_of_differences(scheme, order)?;
            Some(Series { size: step_constant(scheme, order)? * self.greatest_difference(order) * OUTWARD, shrinking })
        });
        Ok(Decay::Series(series.collect()))
    }

    /// What rounding may do to the points of a level.
    fn rounding(&self) -> Rounding {
        let largest = self.control_points().iter().map(norm).fold(0.0, |most: f64, x| if x > most { x } else { most });
        let (scheme, p) = (self.scheme(), self.scheme().degree() as f64);
        let unit = f64::EPSILON / 2.0 * largest;
        if scheme.is_spline() {
            return Rounding { once: 5.0 * (p + 1.0) * unit, each: 0.0, single: 1.0 };
        }
        let norm = |levels: usize| scheme.norms(levels).last().copied().unwrap_or(1.0);
        Rounding { once: (p + 2.0) * unit, each: (p / 2.0 + 3.0) * norm(10) * unit, single: norm(1) }
    }

    /// The greatest first or second difference of the polygon.
    fn greatest_difference(&self, order: usize) -> f64 {
        let points = self.control_points();
        let n = points.len();
        let windows = if self.is_closed() { n } else { n.saturating_sub(order) };
        let size = |i: usize| {
            let [a, b, c] = [0, 1, 2].map(|s| &points[(i + s) % n]);
            if order == 1 {
                return distance(a, b);
            }
            norm::<D>(&core::array::from_fn(|axis| (c[axis] - b[axis]) - (b[axis] - a[axis])))
        };
        (0..windows).map(size).fold(0.0, |most, size| if size > most { size } else { most })
    }

    /// The greatest distance of vertices beyond the ends from the curve's ends, or any one that exceeds `enough`.
    fn beyond_ends(&self, level: usize, enough: f64) -> Result<f64> {
        let p = self.scheme().degree();
        let beyond = (p / 2) as u64; // the vertices with i < (p − 1)/2
        if self.ends() != Ends::Open || beyond == 0 {
            return Ok(0.0);
        }
        let all = self.count(level, Target::Level)?;
        let last = self.count(level, Target::Limit)?.minus(&Index::from(1)).unwrap_or_default();
        let right = all.minus(&Index::from(beyond)).unwrap_or_default();
        let mut most = 0.0;
        let outermost = all.minus(&Index::from(1)).unwrap_or_default();
        for (start, outer, end) in [(Index::default(), Index::default(), Index::default()), (right, outermost, last)] {
            let end = self.point(level, Target::Limit, &end)?;
            let away = distance(&self.point(level, Target::Level, &outer)?, &end);
            if away > enough {
                return Ok(away);
            }
            let mut measure = |block: &[[f64; D]]| {
                for point in block {
                    let away = distance(point, &end);
                    if away > most {
                        most = away;
                    }
                }
                ControlFlow::Continue(())
            };
            self.range(level, Target::Level, &start, beyond, &Limits::default(), &mut measure)?;
        }
        Ok(most * OUTWARD)
    }
}

/// The rounding of a point as a function of its level.
struct Rounding {
    /// By the last sum.
    once: f64,
    /// By each level's product of weights, the leaps above it included.
    each: f64,
    /// How much the rounding of a weight may be enlarged by each of the products in its leap.
    single: f64,
}

impl Rounding {
    fn at(&self, level: usize) -> f64 {
        if level == 0 {
            return 0.0;
        }
        let enlarged = (0..level.min(10)).fold(1.0, |product, _| product * self.single);
        (level.div_ceil(10) as f64 * self.once + level as f64 * self.each) * enlarged
    }
}

/// The bound as a function of the level.
enum Decay {
    /// A quarter at each level.
    Quarters(f64),
    /// The best of some series.
    Series(Vec<Series>),
}

impl Decay {
    fn at(&self, level: usize) -> f64 {
        match self {
            Decay::Quarters(first) => libm::ldexp(*first, -2 * level as i32),
            Decay::Series(all) => all
                .iter()
                .map(|series| series.at(level))
                .fold(f64::INFINITY, |least, x| if x < least { x } else { least }),
        }
    }
}

/// size · Σ μ_j over j ≥ k, where μ_j bounds how much the differences have shrunk at level j.
struct Series {
    size: f64,
    /// μ₀ = 1, μ₁, …, μ_L, the last of them below 1.
    shrinking: Vec<f64>,
}

impl Series {
    fn at(&self, level: usize) -> f64 {
        let Some((last, period)) = self.shrinking.split_last() else { return f64::INFINITY };
        // μ_{j+L} ≤ μ_L μ_j: one period from j = k on, then a geometric series.
        let count = period.len().max(1);
        let mut whole = 1.0;
        for _ in 0..level / count {
            whole *= last;
        }
        let (early, late) = period.split_at(level % count);
        let sum = late.iter().sum::<f64>() + early.iter().sum::<f64>() * last;
        self.size * whole * sum / (1.0 - last) * OUTWARD
    }
}

/// μ₀ … μ_L for the scheme of the first or second differences, L the power that promises the fastest decay; none if no power
/// up to twelve shrinks.
fn powers_of_differences(scheme: &Scheme, order: usize) -> Option<Vec<f64>> {
    let mut symbol = scheme.mask().to_vec();
    for _ in 0..order {
        symbol = divided(&symbol, scheme.mask())?;
    }
    let most = if symbol.len() > 32 { 6 } else { 12 };
    let mut all = alloc::vec![1.0];
    all.extend(norms(&symbol, most));
    let rate = |power: usize| libm::pow(all[power], 1.0 / power as f64);
    let best = (1..all.len()).filter(|&power| all[power] < 1.0 - 1e-9).min_by(|&a, &b| rate(a).total_cmp(&rate(b)))?;
    all.truncate(best + 1);
    Some(all)
}

/// C: the greatest sum of |partial sums| of level k + 1 less level k, both as polylines, over first or second differences.
///
/// Both are linear between multiples of a quarter of the coarser level's steps, so that four places decide.
fn step_constant(scheme: &Scheme, order: usize) -> Option<f64> {
    let p = scheme.degree();
    let mut most = 0.0;
    for quarter in 0..4 {
        // The place x = p + quarter/4 among the coarse vertices is 2x − (p − 1)/2 among the fine ones: in halves,
        // 4p + quarter − (p − 1).
        let halves = 4 * p + quarter + 1 - p;
        let (i, between) = (halves / 2, halves % 2 == 1);
        let share = f64::from(quarter as u32) / 4.0;
        let coefficient = |j: usize| {
            let fine =
                if between { 0.5 * (scheme.weight(i, j) + scheme.weight(i + 1, j)) } else { scheme.weight(i, j) };
            fine - if j == p {
                1.0 - share
            } else if j == p + 1 {
                share
            } else {
                0.0
            }
        };
        let mut sums: Vec<f64> = (0..3 * p + 4).map(coefficient).collect();
        for _ in 0..order {
            let mut total = 0.0;
            for x in &mut sums {
                total += *x;
                *x = total;
            }
            if total.abs() > 1e-12 * (p + 2) as f64 {
                return None; // does not reproduce linear data about these parameters
            }
        }
        let size = sums.iter().map(|x| x.abs()).sum::<f64>();
        if size > most {
            most = size;
        }
    }
    Some(most)
}
