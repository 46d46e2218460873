//! Rational functions over Bernstein polynomials or B-splines: P = Σ wᵢ Pᵢ Nᵢ / Σ wᵢ Nᵢ.
//!
//! Values: P = P_c + Σ Rᵢ (Pᵢ − P_c) with the rational functions Rᵢ = wᵢNᵢ/Σ wⱼNⱼ, about the point P_c that has the greatest of them. Where
//! one function alone is not zero, the curve has its control point to the bit; no product w·P is formed, so weights of any size may
//! meet; and points far from zero lose none of their detail.
//! Derivatives: by the quotient rule, with the value C at t subtracted from the control points first. With A = Σ wᵢ(Pᵢ − C)Nᵢ and W = Σ wᵢNᵢ
//!
//!   W C⁽ᵏ⁾ = A⁽ᵏ⁾ − Σ_{0<i<k} binom(k,i) W⁽ⁱ⁾ C⁽ᵏ⁻ⁱ⁾,
//!
//! which loses the two largest terms of the usual rule, and with them their cancellation where the points lie far from zero.
//!
//! *Source.* L. Piegl and W. Tiller, The NURBS Book (2nd ed. 1997), eq. (4.2) and (4.8).

use crate::basis::{bernstein, blossom, bspline};
use crate::knot::Knots;
use crate::num::Scalar;
use crate::space::{Homogeneous, Vector, Weighted};
use alloc::vec::Vec;

/// The polynomial functions under a rational piece.
#[derive(Clone, Copy, Debug)]
pub enum Functions<'a, S = f64> {
    /// The Bernstein polynomials over [start, end], as many as there are points.
    Bernstein {
        /// The parameter where the piece starts.
        start: &'a S,
        /// The parameter where it ends.
        end: &'a S,
    },
    /// The p + 1 B-splines that are not zero on a span; the points are P_{span−p} … P_span.
    Splines {
        /// The knots, with the degree.
        knots: &'a Knots<S>,
        /// The index of the span, from [`Knots::span`].
        span: usize,
    },
}

impl<S: Scalar> Functions<'_, S> {
    /// Value and derivatives of Σ Vᵢ Nᵢ at t; see [`bernstein::jet`] and [`bspline::jet`].
    pub fn jet<V: Vector<S>>(&self, points: &[V], t: &S, out: &mut [V]) {
        match *self {
            Functions::Bernstein { start, end } => bernstein::jet(points, start, end, t, out),
            Functions::Splines { knots, span } => bspline::jet(knots, span, points, t, out),
        }
    }

    /// The Bernstein points of Σ Vᵢ Nᵢ over the piece.
    pub fn bernstein<V: Vector<S>>(&self, points: &[V]) -> Vec<V> {
        match self {
            Functions::Bernstein { .. } => points.to_vec(),
            Functions::Splines { knots, span } => blossom::span_to_bernstein(knots, *span, points),
        }
    }

    /// The functions' values at t.
    fn values_into(&self, t: &S, out: &mut [S]) {
        match self {
            Functions::Bernstein { start, end } => bernstein::values_into(bernstein::weights::<S>(start, end, t), out),
            Functions::Splines { knots, span } => bspline::values_into(knots.values(), *span, t, out),
        }
    }

    /// Value and derivatives at t of the rational piece of these points and weights, one weight a point: `out[k]` receives the k-th
    /// derivative.
    ///
    /// *Cost.* O(p²) for the value, O(p²) for each order and O(order²) more. *Error.* E ≤ 3(p + 1) for values and 10p for first
    /// derivatives inside the piece, measured to degree 8, with the condition K = Σ |wᵢ|(|Pᵢ| + |C|)|Nᵢ| / |W| for values; for derivatives
    /// with what N′ᵢ adds up in place of |Nᵢ|, and K in place of |C|. For values and positive weights (p + 1)(p + 4.5) is proven: functions
    /// and products are off by 3p + 1, which moves C by as much of Σ |wᵢ||Pᵢ − C|Nᵢ / |W|; the sums and shares are off by 2p + 3 of
    /// Σ |wᵢ||Pᵢ − P_c|Nᵢ / |W|, at most (p + 1)/2 times K because P_c has the greatest share; and the last sum by 1.
    ///
    /// *Degenerate input.* A denominator that is zero at t gives infinities or NaN; points without a weight are left out.
    ///
    /// ```
    /// use lath::basis::rational::Functions;
    ///
    /// // A quarter of the unit circle: weights 1, 1, 2 make the middle rational.
    /// let quarter = Functions::Bernstein { start: &0.0, end: &1.0 };
    /// let mut out = [[0.0; 2]; 2];
    /// quarter.rational_jet(&[[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], &[1.0, 1.0, 2.0], &0.5, &mut out);
    /// assert_eq!(out[0], [0.6, 0.8]);
    /// assert!((out[1][0] * 0.6 + out[1][1] * 0.8).abs() < 1e-15);
    /// ```
    pub fn rational_jet<const D: usize>(&self, points: &[[S; D]], weights: &[S], t: &S, out: &mut [[S; D]]) {
        let Some((value, derivatives)) = out.split_first_mut() else { return };
        *value = self.quotient(points, weights, t);
        if derivatives.is_empty() {
            return;
        }
        let centred: Vec<Homogeneous<D, S>> = points
            .iter()
            .zip(weights)
            .map(|(point, weight)| Homogeneous {
                point: core::array::from_fn(|c| weight.clone() * (point[c].clone() - value[c].clone())),
                weight: weight.clone(),
            })
            .collect();
        let mut jet = alloc::vec![Homogeneous::zero(); derivatives.len() + 1];
        self.jet(&centred, t, &mut jet);
        quotient_rule(&jet, derivatives);
    }

    /// Σ wᵢ Pᵢ Nᵢ / Σ wᵢ Nᵢ at t.
    fn quotient<const D: usize>(&self, points: &[[S; D]], weights: &[S], t: &S) -> [S; D] {
        /// Values of so many functions need no allocation.
        const ROOM: usize = 8;
        let count = points.len();
        let (mut stack, mut heap): ([S; ROOM], Vec<S>);
        let functions: &mut [S] = if count <= ROOM {
            stack = core::array::from_fn(|_| S::zero());
            &mut stack[..count]
        } else {
            heap = alloc::vec![S::zero(); count];
            &mut heap
        };
        self.values_into(t, functions);
        let size = |share: &S| if *share < S::zero() { -share.clone() } else { share.clone() };
        let (mut denominator, mut most) = (S::zero(), 0);
        for (i, weight) in weights.iter().enumerate().take(count) {
            functions[i] = weight.clone() * functions[i].clone();
            denominator = denominator + functions[i].clone();
            if size(&functions[i]) > size(&functions[most]) {
                most = i;
            }
        }
        let Some(centre) = points.get(most) else { return <[S; D]>::zero() };
        let mut value = <[S; D]>::zero();
        for (function, point) in functions.iter().zip(points) {
            let share = function.clone() / denominator.clone();
            for c in 0..D {
                value[c] = value[c].clone() + share.clone() * (point[c].clone() - centre[c].clone());
            }
        }
        core::array::from_fn(|c| centre[c].clone() + value[c].clone())
    }
}

/// The derivatives C′, C″, … of a quotient C = A/W from the derivatives of (A, W) with A = 0 at the parameter: `jet[0]` holds W,
/// `jet[k]` the k-th derivatives, `out[k − 1]` receives C⁽ᵏ⁾.
///
/// *Cost.* O(order²). *Degenerate input.* W = 0 gives infinities or NaN.
pub fn quotient_rule<S: Scalar, const D: usize>(jet: &[Homogeneous<D, S>], out: &mut [[S; D]]) {
    let Some(denominator) = jet.first().map(|value| value.weight.clone()) else { return };
    for k in 1..jet.len() {
        if k > out.len() {
            break;
        }
        let mut sum = jet[k].point.clone();
        let mut binomial = S::one();
        for i in 1..k {
            binomial = binomial * S::from_int((k - i + 1) as i64) / S::from_int(i as i64);
            let weight = &jet[i].weight;
            if !weight.is_zero() {
                sum.add_scaled(&-(binomial.clone() * weight.clone()), &out[k - i - 1]);
            }
        }
        out[k - 1] = sum.map(|x| x / denominator.clone());
    }
}

/// Makes both end weights of a rational Bézier piece 1, unless they are equal: wᵢ becomes wᵢ w₀^{−(n−i)/n} w_n^{−i/n}, and the piece is the
/// same set of points at other parameters, v instead of u with u/(1 − u) = ρ v/(1 − v). Gives back ρ = (w₀/w_n)^{1/n}.
///
/// Halves of a balanced piece are halves of its shape, however far apart its weights.
///
/// *Cost.* O(n²). *Error.* The weights are off by a few units in the last place times n, and the points not at all.
/// *Degenerate input.* End weights must be positive. One point alone is left as it is.
///
/// *Source.* R. Patterson, Projective transformations of the parameter of a Bernstein–Bézier curve (1985).
///
/// ```
/// use lath::basis::rational::balance;
/// use lath::space::Weighted;
///
/// let mut quarter = [([1.0, 0.0], 1.0), ([1.0, 1.0], 1.0), ([0.0, 1.0], 2.0)].map(|(point, weight)| Weighted { point, weight });
/// assert!((balance(&mut quarter) - 0.5_f64.sqrt()).abs() < 1e-15);
/// assert!((quarter[1].weight - 0.5_f64.sqrt()).abs() < 1e-15 && (quarter[2].weight - 1.0).abs() < 1e-15);
/// ```
pub fn balance<const D: usize>(points: &mut [Weighted<D>]) -> f64 {
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return 1.0 };
    let n = points.len() - 1;
    if n == 0 || first.weight == last.weight {
        return 1.0;
    }
    let degree = n as f64;
    let (a, b) = (libm::pow(first.weight, -1.0 / degree), libm::pow(last.weight, -1.0 / degree));
    for (i, point) in points.iter_mut().enumerate() {
        let (mut small, mut large) = if a < b { ((a, n - i), (b, i)) } else { ((b, i), (a, n - i)) };
        for _ in 0..n {
            // In an order that keeps the product in range.
            let shrinks = large.1 == 0 || small.1 > 0 && point.weight > 1.0;
            let (factor, left) = if shrinks { &mut small } else { &mut large };
            point.weight *= *factor;
            *left -= 1;
        }
    }
    b / a
}
