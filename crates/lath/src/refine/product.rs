//! Sums and products of splines, as splines.
//!
//! The blossom of a product f·g of degrees p and q is the mean of f(A)·g(B) over all ways to deal p + q arguments out, p to f and q to
//! g. The knots of the product are such that every hand still contains the knots of its factor between its arguments: each term is a product of
//! control points over finer knots (`window.rs`), and nothing but convex combinations of products of control points occurs.
//! Equal arguments make equal terms, which are counted, not repeated.
//!
//! *Source.* K. Mørken, Some identities for products and degree raising of splines (1991).

use crate::curve::BSpline;
use crate::error::{Code, Error, Result};
use crate::knot::check_degree;
use crate::num::Scalar;
use crate::refine::compatible::make_compatible;
use crate::refine::spline::Spline;
use crate::refine::window::blossom;
use crate::space::Vector;
use alloc::format;
use alloc::vec::Vec;

impl<S: Scalar, V: Vector<S>> Spline<V, S> {
    /// The sum of two splines, over the knots of both; see [`make_compatible`].
    ///
    /// # Errors
    /// As [`make_compatible`]; T003 if the domains differ.
    pub fn sum(&self, other: &Spline<V, S>) -> Result<Spline<V, S>> {
        self.check_same_domain(other)?;
        let both = make_compatible(&[self.clone(), other.clone()])?;
        let mut points = both[0].points().to_vec();
        for (a, b) in points.iter_mut().zip(both[1].points()) {
            a.add_scaled(&S::one(), b);
        }
        both[0].alike(both[0].own_knots().to_vec(), both[0].degree(), points)
    }

    /// The product with a spline of numbers, of degree p + q and as smooth as both allow; open and clamped.
    ///
    /// # Errors
    /// T003 if the domains differ; K006 for a degree above 1000.
    pub fn product(&self, factor: &Spline<[S; 1], S>) -> Result<Spline<V, S>> {
        self.check_same_domain(factor)?;
        let (f, g) = (self.clamp()?, factor.clamp()?);
        let (p, q) = (f.degree(), g.degree());
        let degree = p + q;
        check_degree(degree)?;
        // Each break as often as the less smooth factor asks for.
        let mut breaks: Vec<S> = [f.knots().breaks(), g.knots().breaks()].concat();
        breaks.sort_by(|a, b| a.partial_cmp(b).unwrap_or(core::cmp::Ordering::Equal));
        breaks.dedup();
        let last = breaks.len() - 1;
        let mut knots: Vec<S> = Vec::new();
        for (i, t) in breaks.iter().enumerate() {
            let asked = |multiplicity: usize, other: usize| if multiplicity > 0 { multiplicity + other } else { 0 };
            let (a, b) = (asked(f.multiplicity(t), q), asked(g.multiplicity(t), p));
            let copies = if i == 0 || i == last { degree + 1 } else { a.max(b) };
            knots.extend(core::iter::repeat_n(t, copies).cloned());
        }
        let count = knots.len() - degree - 1;
        let mut points = Vec::with_capacity(count);
        for i in 1..=count {
            let window = &knots[i..i + degree];
            let cut = window.first().is_some_and(|t| knots[i - 1] == *t);
            points.push(deal(&f, &g, window, cut, &knots[i - 1]));
        }
        f.alike(knots, degree, points)
    }

    fn check_same_domain<W: Vector<S>>(&self, other: &Spline<W, S>) -> Result<()> {
        let (mine, theirs) = (self.knots().domain(), other.knots().domain());
        if mine == theirs {
            return Ok(());
        }
        let message = format!("the domains {mine:?} and {theirs:?} differ: reparametrise one of them");
        Err(Error::new(Code::T003, message))
    }

    /// The blossom at a window's values, each with its number, none of the spline's knots between them missing. If `cut`, copies of the
    /// first value stand left of the window too.
    fn at(&self, values: &[(S, usize)], cut: bool, below: &S) -> V {
        let t_ = self.knots().values();
        let mut fresh = Vec::new();
        let mut before = None;
        for (k, (t, count)) in values.iter().enumerate() {
            let (from, to) = (t_.partition_point(|knot| knot < t), t_.partition_point(|knot| knot <= t));
            let old = (to - from).min(*count);
            // The last copies where the window starts inside a group, else the first.
            let start = if cut && k == 0 { to - old } else { from };
            before.get_or_insert(start);
            fresh.extend(core::iter::repeat_n(t, count - old).cloned());
        }
        // Without arguments (degree 0) the place left of the window decides.
        let before = before.unwrap_or_else(|| t_.partition_point(|knot| knot <= below));
        blossom(self, before, &fresh)
    }
}

/// The mean of f(A)·g(B) over all hands A and B of the window.
fn deal<S: Scalar, V: Vector<S>>(f: &Spline<V, S>, g: &Spline<[S; 1], S>, window: &[S], cut: bool, below: &S) -> V {
    let (p, q) = (f.degree(), g.degree());
    let mut groups: Vec<(S, usize)> = Vec::new();
    for t in window {
        match groups.last_mut() {
            Some((last, count)) if last == t => *count += 1,
            _ => groups.push((t.clone(), 1)),
        }
    }
    let mut sum = V::zero();
    // How many of each group f gets; the first hand gives it the first arguments.
    let mut hand: Vec<usize> = first_hand(&groups, p);
    loop {
        let mut share = S::one();
        let (mut left, mut to_f) = (p + q, p);
        for ((_, count), given) in groups.iter().zip(&hand) {
            // C(count, given) ways, out of C(p + q, p) in all, factor by factor.
            share = share * ways(*count, *given, &mut left, &mut to_f);
        }
        let mine: Vec<(S, usize)> = pick(&groups, |i| hand[i]);
        let rest: Vec<(S, usize)> = pick(&groups, |i| groups[i].1 - hand[i]);
        // Where a hand gets none of the first group, it starts with a whole one.
        let starts = |values: &[(S, usize)]| cut && values.first().map(|(t, _)| t) == window.first();
        let [number] = g.at(&rest, starts(&rest), below);
        sum.add_scaled(&(share * number), &f.at(&mine, starts(&mine), below));
        if !next_hand(&groups, &mut hand) {
            return sum;
        }
    }
}

/// The groups that a hand has something of.
fn pick<S: Scalar>(groups: &[(S, usize)], count: impl Fn(usize) -> usize) -> Vec<(S, usize)> {
    let all = groups.iter().enumerate().map(|(i, (t, _))| (t.clone(), count(i)));
    all.filter(|(_, count)| *count > 0).collect()
}

/// The share of the hands in which `given` of the next `count` arguments go to f, when `left` arguments are left, `to_f` of them for
/// f: hypergeometric, C(count, given) C(left − count, to_f − given) / C(left, to_f), as a product of `count` fractions at most 1 times
/// C(count, given).
fn ways<S: Scalar>(count: usize, given: usize, left: &mut usize, to_f: &mut usize) -> S {
    let int = |n: usize| S::from_int(n as i64);
    let mut share = S::one();
    for k in 0..count {
        // One argument after the other, the first ones to f; the number of orders is put in step by step.
        let (mine, all) = if k < given { (*to_f, *left) } else { (*left - *to_f, *left) };
        share = share * int(mine) / int(all);
        share = if k < given { share } else { share * int(k + 1) / int(k + 1 - given) };
        *to_f -= usize::from(k < given);
        *left -= 1;
    }
    share
}

/// The hand that gives f the first p arguments.
fn first_hand<S>(groups: &[(S, usize)], p: usize) -> Vec<usize> {
    let mut rest = p;
    let take = |(_, count): &(S, usize)| {
        let given = rest.min(*count);
        rest -= given;
        given
    };
    groups.iter().map(take).collect()
}

/// The next hand with as many arguments for f; false after the last.
fn next_hand<S>(groups: &[(S, usize)], hand: &mut [usize]) -> bool {
    // The last group that can give one to a later group with room; behind it, everything starts over from the left.
    let mut behind = 0;
    for i in (0..hand.len()).rev() {
        let room: usize = groups[i + 1..].iter().map(|(_, count)| *count).sum();
        if hand[i] > 0 && behind < room {
            hand[i] -= 1;
            let rest = first_hand(&groups[i + 1..], behind + 1);
            hand[i + 1..].copy_from_slice(&rest);
            return true;
        }
        behind += hand[i];
    }
    false
}

impl<const D: usize> BSpline<D> {
    /// The sum of two curves over the same domain, of the greater degree and over the knots of both.
    ///
    /// ```
    /// use lath::curve::{BSpline, Curve};
    ///
    /// let line = BSpline::clamped(1, [[0.0], [2.0]])?;
    /// let hump = BSpline::clamped(2, [[0.0], [4.0], [0.0]])?;
    /// assert_eq!(line.sum(&hump)?.control_points(), [[0.0], [5.0], [2.0]]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// T003 if the domains differ; C005 for an open and a closed curve.
    pub fn sum(&self, other: &BSpline<D>) -> Result<BSpline<D>> {
        BSpline::from_spline(self.to_spline().sum(&other.to_spline())?)
    }

    /// The product with a function, given as a curve in one dimension over the same domain: of degree p + q, as smooth as both allow;
    /// open and clamped.
    ///
    /// *Cost.* O(min(p, q)²) terms a point where knots are simple, each O(p² + q²). *Error.* E ≤ 5(p + q) + 8 against the product of Σ|Pᵢ|N_i
    /// and Σ|gⱼ|Nⱼ: convex combinations of products of control points.
    ///
    /// *Source.* Mørken 1991.
    ///
    /// ```
    /// use lath::curve::{BSpline, Curve};
    ///
    /// let t = BSpline::clamped(1, [[0.0], [1.0]])?;
    /// let square = t.product(&t)?;
    /// assert_eq!(square.control_points(), [[0.0], [0.0], [1.0]]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// T003 if the domains differ; K006 for a degree above 1000; P003 for values beyond 1e300.
    pub fn product(&self, factor: &BSpline<1>) -> Result<BSpline<D>> {
        BSpline::from_spline(self.to_spline().product(&factor.to_spline())?)
    }
}
