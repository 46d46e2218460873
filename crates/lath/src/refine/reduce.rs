//! Lowering the degree: the nearest curve of one degree less, with the distance that was reached.
//!
//! Elevation is a matrix: its rows say how the control points of degree p come from those of degree p − 1. Reduction solves it
//! backwards, in the sense of least squares over the control points; for a single Bézier piece that is the least-squares
//! approximation of the curve itself (Lutterkort, Peters and Reif 1999). Points that lie on the curve, at clamped ends and
//! corners, are kept. A curve that was elevated comes back.
//!
//! The bound is the greatest distance between the control points given and those of the result elevated again: both are then curves over
//! the same knots.
//!
//! *Source.* D. Lutterkort, J. Peters, U. Reif, Polynomial degree reduction in the L₂-norm equals best Euclidean approximation of
//! Bézier coefficients (1999); M. Eck, Least squares degree reduction of Bézier curves (1995).

use crate::curve::{BSpline, Bezier};
use crate::error::{Code, Error, Number, Result};
use crate::knot::Knots;
use crate::num::{Bound, Scalar};
use crate::refine::compatible::{merged, missing};
use crate::refine::measure::{Measure, Points, check_tolerance};
use crate::refine::spline::Spline;
use crate::space::Vector;
use alloc::format;
use alloc::vec::Vec;

/// A row of a matrix: places and numbers, the places increasing.
#[derive(Clone, Debug)]
struct Row<S>(Vec<(usize, S)>);

impl<S: Scalar> Vector<S> for Row<S> {
    fn zero() -> Self {
        Row(Vec::new())
    }

    fn scale(&mut self, factor: &S) {
        for (_, x) in &mut self.0 {
            *x = factor.clone() * x.clone();
        }
    }

    fn add_scaled(&mut self, factor: &S, other: &Self) {
        for (place, x) in &other.0 {
            let share = factor.clone() * x.clone();
            match self.0.binary_search_by_key(place, |(place, _)| *place) {
                Ok(i) => self.0[i].1 = self.0[i].1.clone() + share,
                Err(i) => self.0.insert(i, (*place, share)),
            }
        }
    }
}

impl<S: Scalar, V: Vector<S>> Spline<V, S> {
    /// The spline of degree p − 1 whose elevation has the nearest control points, and what is left: the differences of the control
    /// points, all zero if the spline is one of degree p − 1. An open spline is clamped first.
    ///
    /// *Cost.* O(n p²), and O(n p) for the matrix over simple knots. *Error.* The system's condition is below p: a few u of the points' size.
    ///
    /// # Errors
    /// K006 for degree 0.
    pub fn reduce(&self) -> Result<(Spline<V, S>, Vec<V>)> {
        let spline = if self.is_closed() { self.canonical()? } else { self.clamp()? };
        let Some(degree) = spline.degree().checked_sub(1) else {
            return Err(Error::new(Code::K006, "degree 0 cannot be lowered"));
        };
        // Every knot once less, but at least once.
        let own = spline.own_knots();
        let mut knots: Vec<S> = Vec::with_capacity(own.len());
        for (i, t) in own.iter().enumerate() {
            let first = i == 0 || own[i - 1] != *t;
            let single = own.get(i + 1) != Some(t);
            if !first || single {
                knots.push(t.clone());
            }
        }
        let count = if spline.is_closed() { knots.len() - 1 } else { knots.len() - degree - 1 };
        let units = (0..count).map(|j| Row(alloc::vec![(j, S::one())])).collect();
        let rows: Spline<Row<S>, S> = if spline.is_closed() {
            Spline::closed(&knots, degree, units)?
        } else {
            Spline::open(Knots::new(knots.clone(), degree)?, units)?
        };
        // Over the same knots as the given spline, which may need more of them: a simple knot became a double one.
        let rows = rows.elevate(1)?;
        let union = merged(rows.own_knots(), own);
        let rows = rows.insert(&missing(&union, rows.own_knots()))?;
        let given = spline.insert(&missing(&union, own))?;
        let points = least_squares(rows.points(), given.points(), count, degree > 0)?;
        let left = (rows.points().iter().zip(given.points()))
            .map(|(row, point)| {
                let mut rest = point.clone();
                row.0.iter().for_each(|(j, x)| rest.add_scaled(&-x.clone(), &points[*j]));
                rest
            })
            .collect();
        Ok((spline.alike(knots, degree, points)?, left))
    }
}

/// The Q for which Σⱼ rowᵢⱼ Qⱼ are nearest to the Pᵢ; where a row is a single 1 and `keep`, Q is that P.
fn least_squares<S: Scalar, V: Vector<S>>(rows: &[Row<S>], given: &[V], count: usize, keep: bool) -> Result<Vec<V>> {
    let mut kept: Vec<Option<V>> = alloc::vec![None; count];
    for (row, point) in rows.iter().zip(given) {
        match row.0.as_slice() {
            [(j, x)] if keep && *x == S::one() => {
                kept[*j].get_or_insert(point.clone());
            }
            _ => {}
        }
    }
    // The unknowns that are left, numbered.
    let free: Vec<usize> = (0..count).filter(|j| kept[*j].is_none()).collect();
    let mut number = alloc::vec![usize::MAX; count];
    free.iter().enumerate().for_each(|(k, j)| number[*j] = k);
    // Normal equations in the profile below the diagonal: line k holds columns first[k] … k.
    let mut first: Vec<usize> = (0..free.len()).collect();
    for row in rows {
        let least = row.0.iter().map(|(j, _)| number[*j]).min().unwrap_or(usize::MAX);
        for (j, _) in &row.0 {
            if number[*j] < usize::MAX && least < first[number[*j]] {
                first[number[*j]] = least;
            }
        }
    }
    let mut lines: Vec<Vec<S>> = (0..free.len()).map(|k| alloc::vec![S::zero(); k + 1 - first[k]]).collect();
    let mut right: Vec<V> = alloc::vec![V::zero(); free.len()];
    for (row, point) in rows.iter().zip(given) {
        let mut rest = point.clone();
        for (j, x) in &row.0 {
            if let Some(known) = &kept[*j] {
                rest.add_scaled(&-x.clone(), known);
            }
        }
        for (j, x) in row.0.iter().filter(|(j, _)| number[*j] < usize::MAX) {
            let k = number[*j];
            right[k].add_scaled(x, &rest);
            for (i, y) in row.0.iter().filter(|(i, _)| number[*i] <= k) {
                let slot = &mut lines[k][number[*i] - first[k]];
                *slot = slot.clone() + x.clone() * y.clone();
            }
        }
    }
    solve(&mut lines, &first, &mut right)?;
    for (k, j) in free.into_iter().enumerate() {
        kept[j] = Some(right[k].clone());
    }
    Ok(kept.into_iter().flatten().collect())
}

/// Solves a symmetric positive definite system by its profile: A = LDLᵀ, no pivoting needed.
fn solve<S: Scalar, V: Vector<S>>(lines: &mut [Vec<S>], first: &[usize], right: &mut [V]) -> Result<()> {
    let n = right.len();
    for k in 0..n {
        // Line k becomes L times D, then L; its last entry D.
        for i in first[k]..k {
            let mut sum = lines[k][i - first[k]].clone();
            for m in first[k].max(first[i])..i {
                sum = sum - lines[k][m - first[k]].clone() * lines[i][m - first[i]].clone();
            }
            lines[k][i - first[k]] = sum;
        }
        let mut pivot = lines[k][k - first[k]].clone();
        for i in first[k]..k {
            let scaled = lines[k][i - first[k]].clone();
            let factor = scaled.clone() / lines[i][i - first[i]].clone();
            pivot = pivot - scaled * factor.clone();
            lines[k][i - first[k]] = factor;
        }
        if pivot <= S::zero() || !pivot.is_finite() {
            return Err(Error::new(Code::N001, format!("the pivot of row {k} is {pivot:?}")).at(k));
        }
        lines[k][k - first[k]] = pivot;
    }
    for k in 0..n {
        for i in first[k]..k {
            let (above, here) = right.split_at_mut(k);
            here[0].add_scaled(&-lines[k][i - first[k]].clone(), &above[i]);
        }
    }
    for k in 0..n {
        right[k].scale(&(S::one() / lines[k][k - first[k]].clone()));
    }
    for k in (0..n).rev() {
        for i in first[k]..k {
            let (above, here) = right.split_at_mut(k);
            above[i].add_scaled(&-lines[k][i - first[k]].clone(), &here[0]);
        }
    }
    Ok(())
}

impl<V: Vector<f64>> Spline<V> {
    /// The spline with its degree lowered by `by`, and the proven distance.
    pub(crate) fn lower(&self, by: usize, measure: &impl Measure<V>) -> Result<(Spline<V>, f64)> {
        let (mut spline, mut reached) = (self.clone(), 0.0);
        for _ in 0..by {
            let p = spline.degree();
            let (lower, left) = spline.reduce()?;
            let off =
                left.iter().map(|rest| measure.size(rest)).fold(0.0, |most: f64, x| if x > most { x } else { most });
            reached = reached + off + measure.slack(p);
            spline = lower;
        }
        Ok((spline, reached))
    }
}

/// Refuses a bound above the tolerance, where there is one (Q005).
pub(crate) fn check_reached(reached: f64, tolerance: Option<f64>) -> Result<Bound> {
    match tolerance {
        Some(tolerance) if reached > tolerance => {
            let (reached, tolerance) = (Number(reached), Number(tolerance));
            Err(Error::new(Code::Q005, format!("a distance of {reached} was reached, above {tolerance}")))
        }
        _ => Ok(Bound::Proven(reached)),
    }
}

impl<const D: usize> BSpline<D> {
    /// A curve with its degree lowered by `by` near this one, and the distance that was reached; refused if that is above the tolerance,
    /// where one is given.
    ///
    /// Multiplicities fall with the degree, but not below 1, so that the curve bends where it did. Of clamped ends and corners the
    /// points stay. Open curves come back clamped.
    ///
    /// *Cost.* O(n p²) a degree. *Error.* The bound is proven: the greatest distance of control points over the same knots, and what
    /// rounding may add, 16 (p + 1) u of their size. An elevated curve comes back within that.
    ///
    /// *Degenerate input.* A curve that is a polygon at best is lowered to it; degree 0 is one step for each span.
    ///
    /// *Source.* Lutterkort, Peters and Reif 1999; Eck 1995.
    ///
    /// ```
    /// use lath::curve::BSpline;
    ///
    /// let curve = BSpline::clamped(2, [[0.0, 0.0], [2.0, 4.0], [4.0, 0.0], [6.0, 1.0]])?;
    /// let (same, bound) = curve.elevate(1)?.reduce(1, Some(1e-12))?;
    /// assert_eq!(same.knots(), curve.knots());
    /// assert!(bound.is_proven());
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// K006 if the degree would fall below 0; Q001 for a tolerance that is no positive finite number; Q005 if the bound is above it.
    pub fn reduce(&self, by: usize, tolerance: Option<f64>) -> Result<(BSpline<D>, Bound)> {
        tolerance.map_or(Ok(()), check_tolerance)?;
        check_fall(self.knots().degree(), by)?;
        let (spline, reached) = self.to_spline().lower(by, &Points::of(self.control_points()))?;
        Ok((BSpline::from_spline(spline)?, check_reached(reached, tolerance)?))
    }
}

impl<const D: usize> Bezier<D> {
    /// A curve with its degree lowered by `by` near this one, with the same ends, and the distance that was reached; refused if that
    /// is above the tolerance, where one is given.
    ///
    /// *Cost, error.* As [`BSpline::reduce`].
    ///
    /// ```
    /// use lath::curve::Bezier;
    ///
    /// let (line, bound) = Bezier::new([[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]])?.reduce(1, None)?;
    /// assert_eq!(line.control_points(), [[0.0, 0.0], [2.0, 0.0]]);
    /// assert!((bound.value() - 1.0).abs() < 1e-12);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// K006 if the degree would fall below 0; Q001 for a tolerance that is no positive finite number; Q005 if the bound is above it.
    pub fn reduce(&self, by: usize, tolerance: Option<f64>) -> Result<(Bezier<D>, Bound)> {
        tolerance.map_or(Ok(()), check_tolerance)?;
        check_fall(self.control_points().len() - 1, by)?;
        let (spline, reached) = self.to_spline()?.lower(by, &Points::of(self.control_points()))?;
        Ok((Bezier::from_spline(spline)?, check_reached(reached, tolerance)?))
    }
}

/// Refuses to lower the degree by more than there is (K006).
pub(crate) fn check_fall(degree: usize, by: usize) -> Result<()> {
    if by <= degree {
        return Ok(());
    }
    Err(Error::new(Code::K006, format!("degree {degree} cannot be lowered by {by}")))
}
