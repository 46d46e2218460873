//! The weights of the given points in a point of level k.
//!
//! The point i = 2ᵏ q + r of level k is a sum of the p + 1 points P_q … P_{q+p} with weights that depend on r alone. There are
//! two ways to them. For Lane–Riesenfeld schemes the point is the blossom of segment q at p consecutive knots 2⁻ᵏ apart,
//! (r − c)/2ᵏ for c = 0 … p − 1, and at p equal knots r/2ᵏ it is the limit: O(p²) at any level, with the error of one
//! evaluation. For any scheme the weights are the first row of a product of k matrices, one for each bit of r.

use crate::num::Scalar;
use crate::subdivide::dyadic::Index;
use crate::subdivide::scheme::Scheme;
use alloc::vec::Vec;

/// What a row of weights makes: points of the refined polygon, or points of the curve that it tends to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Target {
    /// Point i of level k of the polygon.
    Level,
    /// The point of the limit at t = i/2ᵏ, in units of segments from the first joint.
    Limit,
}

/// The rows of weights for the 2^bits residues of one leap over `bits` levels, p + 1 weights a row.
pub(crate) enum Rows<S> {
    /// By blossoms; `lag` is 1 for level points and 0 for limits.
    Blossom { degree: usize, bits: usize, lag: i64 },
    /// By products of matrices, one row at a time, the first row being `seed`.
    Product { scheme: Scheme<S>, bits: usize, seed: Vec<S> },
    /// By products of matrices, all rows stored.
    Table { width: usize, bits: usize, rows: Vec<S> },
}

impl<S: Scalar> Rows<S> {
    /// The rows of a leap that takes `seed`-weighted sums of the p + 1 points at its end. All of them are stored if it
    /// pays for the number of rows that will be asked for.
    pub(crate) fn product(scheme: &Scheme<S>, bits: usize, seed: Vec<S>, wanted: u64) -> Rows<S> {
        if bits <= 20 && wanted > 1 << bits >> 3 {
            return Rows::Table { width: seed.len(), bits, rows: table(scheme, bits, seed) };
        }
        Rows::Product { scheme: scheme.clone(), bits, seed }
    }

    /// The rows of a Lane–Riesenfeld scheme over all levels at once.
    ///
    /// Where the p knots of a point spread over more than an eighth of a span, the blossom would extrapolate; there the
    /// few bits make few products of positive numbers.
    pub(crate) fn spline(scheme: &Scheme<S>, bits: usize, target: Target, wanted: u64) -> Rows<S> {
        let degree = scheme.degree();
        match target {
            Target::Level if bits < 13 && 1 << bits < 8 * degree => {
                Rows::product(scheme, bits, first(degree + 1), wanted)
            }
            Target::Level => Rows::Blossom { degree, bits, lag: 1 },
            Target::Limit => Rows::Blossom { degree, bits, lag: 0 },
        }
    }

    /// How many levels the leap spans.
    pub(crate) fn bits(&self) -> usize {
        match self {
            Rows::Blossom { bits, .. } | Rows::Product { bits, .. } | Rows::Table { bits, .. } => *bits,
        }
    }

    /// The number of weights a row.
    pub(crate) fn width(&self) -> usize {
        match self {
            Rows::Blossom { degree, .. } => degree + 1,
            Rows::Product { seed, .. } => seed.len(),
            Rows::Table { width, .. } => *width,
        }
    }

    /// The rows of `count` residues from `base` on, one after the other; `scratch` holds them if they are not stored.
    pub(crate) fn rows<'a>(&'a self, base: &Index, count: usize, scratch: &'a mut Vec<S>) -> &'a [S] {
        let width = self.width();
        if let (Rows::Table { rows, .. }, Some(base)) = (self, base.to_u64()) {
            let start = base as usize * width;
            return rows.get(start..start + count * width).unwrap_or(&[]);
        }
        scratch.clear();
        scratch.resize(count * width, S::zero());
        match self {
            Rows::Blossom { bits, lag, .. } => match base.to_u64() {
                Some(base) if *bits <= 52 => near_rows(*bits, base as i64, *lag, width, scratch),
                _ => far_rows(*bits, base, *lag, width, scratch),
            },
            Rows::Product { scheme, bits, seed } => {
                let mut residue = base.clone();
                for row in scratch.chunks_exact_mut(width) {
                    row.clone_from_slice(&product_row(scheme, *bits, seed, &residue));
                    residue = residue.plus(&Index::from(1));
                }
            }
            Rows::Table { .. } => {}
        }
        scratch
    }
}

/// (1, 0, …, 0).
pub(crate) fn first<S: Scalar>(width: usize) -> Vec<S> {
    (0..width).map(|i| if i == 0 { S::one() } else { S::zero() }).collect()
}

/// The row v · A_b, where A_b makes the p + 1 points 2i + b … from the p + 1 points i …
fn times<S: Scalar>(v: &[S], scheme: &Scheme<S>, bit: bool) -> Vec<S> {
    let (mask, shift) = (scheme.mask(), scheme.degree() + usize::from(bit));
    let weight = |j: usize| {
        // Entry i + shift − 2j of the mask, for the i that have one.
        let from = (2 * j).saturating_sub(shift);
        let to = (2 * j + mask.len()).saturating_sub(shift).min(v.len());
        (from..to).fold(S::zero(), |sum, i| sum + v[i].clone() * mask[i + shift - 2 * j].clone())
    };
    (0..v.len()).map(weight).collect()
}

/// The row of one residue: the least significant bit is the last refinement, and its matrix the first to multiply.
fn product_row<S: Scalar>(scheme: &Scheme<S>, bits: usize, seed: &[S], residue: &Index) -> Vec<S> {
    (0..bits).fold(seed.to_vec(), |row, place| times(&row, scheme, residue.bit(place)))
}

/// The rows of all residues: each row of b bits is a row of b − 1 bits times one matrix more.
fn table<S: Scalar>(scheme: &Scheme<S>, bits: usize, seed: Vec<S>) -> Vec<S> {
    let width = seed.len();
    let mut rows = seed;
    for _ in 0..bits {
        let mut next = Vec::with_capacity(2 * rows.len());
        for bit in [false, true] {
            for row in rows.chunks_exact(width) {
                next.extend(times(row, scheme, bit));
            }
        }
        rows = next;
    }
    rows
}

/// The weights of a blossom: `out` receives those of the p + 1 points of a span at p arguments, each given with its complement 1 − u.
///
/// Each argument raises the degree: w_j ← w_j (j + 1 − u) + w_{j−1} (ρ − j + u) in round ρ, all divided by p! in the end.
#[inline(always)]
fn blossom<S: Scalar>(out: &mut [S], argument: impl Fn(usize) -> (S, S)) {
    let degree = out.len() - 1;
    let at_once = degree <= 20; // 20! is the last that fits
    out[0] = S::one();
    for round in 1..=degree {
        let (u, v) = argument(round - 1);
        out[round] = out[round - 1].clone() * u.clone();
        for j in (1..round).rev() {
            let kept = out[j].clone() * (S::from_int(j as i64) + v.clone());
            out[j] = kept + out[j - 1].clone() * (S::from_int((round - j) as i64) + u.clone());
        }
        out[0] = out[0].clone() * v;
        if !at_once {
            out[..=round].iter_mut().for_each(|w| *w = w.clone() / S::from_int(round as i64));
        }
    }
    if at_once {
        let factorial = S::from_int((1..=degree as i64).product());
        out.iter_mut().for_each(|w| *w = w.clone() / factorial.clone());
    }
}

/// Rows at levels whose numerators a float holds exactly.
fn near_rows<S: Scalar>(bits: usize, base: i64, lag: i64, width: usize, out: &mut [S]) {
    match width {
        2 => near_fixed::<S, 2>(bits, base, lag, out),
        3 => near_fixed::<S, 3>(bits, base, lag, out),
        4 => near_fixed::<S, 4>(bits, base, lag, out),
        5 => near_fixed::<S, 5>(bits, base, lag, out),
        6 => near_fixed::<S, 6>(bits, base, lag, out),
        _ => {
            let knots = Grid::new(bits);
            for (r, row) in (base..).zip(out.chunks_exact_mut(width)) {
                blossom(row, |c| knots.at(r - lag * c as i64));
            }
        }
    }
}

/// Eight rows at a time, the same operations for each: lanes hold different residues.
fn near_fixed<S: Scalar, const W: usize>(bits: usize, base: i64, lag: i64, out: &mut [S]) {
    const LANES: usize = 8;
    let knots = Grid::new(bits);
    let factorial = S::from_int((1..W as i64).product());
    let mut r = base;
    let mut blocks = out.chunks_exact_mut(LANES * W);
    for block in &mut blocks {
        let mut w: [[S; LANES]; W] = core::array::from_fn(|_| core::array::from_fn(|_| S::one()));
        for round in 1..W {
            let first = r - lag * (round as i64 - 1);
            let u: [S; LANES] = core::array::from_fn(|l| knots.at(first + l as i64).0);
            let v: [S; LANES] = core::array::from_fn(|l| knots.at(first + l as i64).1);
            w[round] = core::array::from_fn(|l| w[round - 1][l].clone() * u[l].clone());
            for j in (1..round).rev() {
                let (left, right) = (S::from_int(j as i64), S::from_int((round - j) as i64));
                w[j] = core::array::from_fn(|l| {
                    let kept = w[j][l].clone() * (left.clone() + v[l].clone());
                    kept + w[j - 1][l].clone() * (right.clone() + u[l].clone())
                });
            }
            w[0] = core::array::from_fn(|l| w[0][l].clone() * v[l].clone());
        }
        for weights in &mut w {
            *weights = core::array::from_fn(|l| weights[l].clone() / factorial.clone());
        }
        for (l, row) in block.chunks_exact_mut(W).enumerate() {
            for (slot, weights) in row.iter_mut().zip(&w) {
                *slot = weights[l].clone();
            }
        }
        r += LANES as i64;
    }
    for row in blocks.into_remainder().chunks_exact_mut(W) {
        blossom(row, |c| knots.at(r - lag * c as i64));
        r += 1;
    }
}

/// The parameters m/2^bits for bits ≤ 52, with their complements: exact.
struct Grid<S> {
    steps: i64,
    step: S,
}

impl<S: Scalar> Grid<S> {
    fn new(bits: usize) -> Grid<S> {
        let steps = 1 << bits;
        Grid { steps, step: S::one() / S::from_int(steps) }
    }

    #[inline(always)]
    fn at(&self, m: i64) -> (S, S) {
        (S::from_int(m) * self.step.clone(), S::from_int(self.steps - m) * self.step.clone())
    }
}

/// Rows at any level: parameter and complement each from their own integer, so that both are accurate to the last place.
fn far_rows<S: Scalar>(bits: usize, base: &Index, lag: i64, width: usize, out: &mut [S]) {
    let whole = Index::from(1).shifted_up(bits);
    let mut residue = base.clone();
    for row in out.chunks_exact_mut(width) {
        blossom(row, |c| {
            let back = Index::from(lag as u64 * c as u64);
            match residue.minus(&back) {
                Some(m) => (m.parameter(bits), whole.minus(&m).unwrap_or_default().parameter(bits)),
                None => {
                    let below = back.minus(&residue).unwrap_or_default();
                    (-below.parameter::<S>(bits), whole.plus(&below).parameter(bits))
                }
            }
        });
        residue = residue.plus(&Index::from(1));
    }
}

/// The sums of the window's points by each row of weights.
///
/// The same additions in the same order for every width and whoever asks, so that all ways to a point give the same bits.
pub(crate) fn combine<S: Scalar, const D: usize>(rows: &[S], window: &[[S; D]], out: &mut [[S; D]]) {
    let steps = out.len();
    sweep(rows, window.len(), window, steps, out);
}

/// The same rows for one window after the other: window q, the points q … of `points`, fills the places from q · `steps` on, as
/// many as there are rows. The windows end where `out` ends.
pub(crate) fn sweep<S: Scalar, const D: usize>(
    rows: &[S],
    width: usize,
    points: &[[S; D]],
    steps: usize,
    out: &mut [[S; D]],
) {
    match width {
        2 => sweep_fixed::<S, D, 2>(rows, points, steps, out),
        3 => sweep_fixed::<S, D, 3>(rows, points, steps, out),
        4 => sweep_fixed::<S, D, 4>(rows, points, steps, out),
        5 => sweep_fixed::<S, D, 5>(rows, points, steps, out),
        6 => sweep_fixed::<S, D, 6>(rows, points, steps, out),
        7 => sweep_fixed::<S, D, 7>(rows, points, steps, out),
        _ => {
            for (window, slots) in points.windows(width.max(1)).zip(out.chunks_mut(steps.max(1))) {
                for (row, slot) in rows.chunks_exact(width.max(1)).zip(slots) {
                    *slot = sum(row, window);
                }
            }
        }
    }
}

fn sweep_fixed<S: Scalar, const D: usize, const W: usize>(
    rows: &[S],
    points: &[[S; D]],
    steps: usize,
    out: &mut [[S; D]],
) {
    for (q, slots) in out.chunks_mut(steps.max(1)).enumerate() {
        let Some(window) = points.get(q..).and_then(<[_]>::first_chunk::<W>) else { return };
        for (row, slot) in rows.chunks_exact(W).zip(slots) {
            *slot = sum(row, window);
        }
    }
}

#[inline(always)]
fn sum<S: Scalar, const D: usize>(row: &[S], window: &[[S; D]]) -> [S; D] {
    core::array::from_fn(|c| {
        let mut sum = row[0].clone() * window[0][c].clone();
        for s in 1..window.len() {
            sum = sum + row[s].clone() * window[s][c].clone();
        }
        sum
    })
}
