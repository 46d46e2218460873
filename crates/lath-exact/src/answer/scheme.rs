//! Subdivision: the matrices of a scheme, its limit, and points far down the levels.

use crate::budget;
use crate::error::{Code, Error, Result};
use crate::matrix::Matrix;
use crate::parse;
use crate::rational::Rational;
use lath::error::Limits;
use lath::subdivide::{self, Descent, Index, MAX_LEVEL, Scheme, Target, descents};

/// Reads the name of a scheme: `chaikin`, `cubic`, `degree:P`, `four-point`, `four-point:W`, `mask:a,b,…`.
///
/// ```
/// let scheme = lath_exact::answer::scheme_named("degree:5")?;
/// assert_eq!(scheme.degree(), 5);
/// # Ok::<(), lath_exact::error::Error>(())
/// ```
///
/// # Errors
/// X003 for another name; X001, X002 for what is no fraction; S001, S002, K006 for what is no scheme.
pub fn scheme_named(text: &str) -> Result<Scheme<Rational>> {
    let unknown = || {
        let message = format!("no scheme `{text}`; there are chaikin, cubic, degree:P, four-point[:W], mask:a,b,…");
        Error::new(Code::X003, message)
    };
    Ok(match text.split_once(':') {
        None if text == "chaikin" => Scheme::chaikin(),
        None if text == "cubic" => Scheme::cubic(),
        None if text == "four-point" => Scheme::four_point(&Rational::from_parts(1.into(), 16u8.into()))?,
        Some(("degree", degree)) => Scheme::lane_riesenfeld(degree.parse().map_err(|_| unknown())?)?,
        Some(("four-point", tension)) => Scheme::four_point(&tension.parse()?)?,
        Some(("mask", mask)) => Scheme::from_mask(parse::fractions(mask)?)?,
        _ => return Err(unknown()),
    })
}

/// Everything that the local matrix of a scheme tells.
#[derive(Clone, Debug, PartialEq)]
pub struct SchemeAnswer {
    /// The scheme.
    pub scheme: Scheme<Rational>,
    /// A: p neighbours of the next level from p neighbours of this one.
    pub matrix: Matrix,
    /// The p + 2 points of the next level that p + 1 neighbours make.
    pub group_matrix: Matrix,
    /// What is known of A's eigenvalues.
    pub spectrum: Spectrum,
    /// The weights of p neighbours in the point they tend to; none if convergence is not proven.
    pub limit: Option<Vec<Rational>>,
    /// Their weights in the tangent there, over 2ᵏ; none if there is none.
    pub tangent: Option<Vec<Rational>>,
    /// Their weights in the second derivative there, over 4ᵏ; none if there is none.
    pub second: Option<Vec<Rational>>,
}

/// The eigenvalues of a local matrix.
#[derive(Clone, Debug, PartialEq)]
pub enum Spectrum {
    /// All rational: A = Q J Q⁻¹.
    Exact(Decomposition),
    /// Some not rational: estimates [real, imaginary] of all, ascending by their real part.
    Numeric(Vec<[f64; 2]>),
    /// Not looked for: the matrix is larger than 64.
    Unknown,
}

/// A = Q J Q⁻¹.
#[derive(Clone, Debug, PartialEq)]
pub struct Decomposition {
    /// Ascending, in the order of Q's columns.
    pub eigenvalues: Vec<Rational>,
    /// The sizes of the Jordan blocks; all 1 if A is diagonalizable.
    pub blocks: Vec<usize>,
    /// Columns are eigenvectors (within a block, generalized ones after the first); each ends in 1 where it can.
    pub q: Matrix,
    /// Rows are left eigenvectors.
    pub q_inverse: Matrix,
    /// J: diagonal, or with ones above the diagonal inside blocks.
    pub jordan: Matrix,
}

impl Decomposition {
    /// Whether there are too few eigenvectors for a diagonal form.
    pub fn is_defective(&self) -> bool {
        self.blocks.iter().any(|size| *size > 1)
    }
}

fn from_rows(rows: Vec<Vec<Rational>>) -> Matrix {
    Matrix::from_rows(rows).unwrap_or_else(|| Matrix::identity(0))
}

/// The local matrix of a scheme with its eigenvectors, and the masks of limit, tangent and second derivative.
///
/// *Cost.* O(p⁴) operations for Lane–Riesenfeld schemes, O(p⁵) for others.
///
/// ```
/// use lath_exact::answer::{scheme, scheme_named, Spectrum};
/// use lath_exact::parse;
///
/// let answer = scheme(&scheme_named("cubic")?, &Default::default())?;
/// let Spectrum::Exact(a) = &answer.spectrum else { unreachable!() };
/// assert_eq!(a.eigenvalues, parse::fractions("1/4,1/2,1")?);
/// assert_eq!(a.q.rows()[1], parse::fractions("-1/2,0,1")?);
/// assert_eq!(answer.limit.as_deref(), Some(&parse::fractions("1/6,2/3,1/6")?[..]));
/// # Ok::<(), lath_exact::error::Error>(())
/// ```
///
/// # Errors
/// B001 where the budget is exceeded.
pub fn scheme(scheme: &Scheme<Rational>, limits: &Limits<'_>) -> Result<SchemeAnswer> {
    let p = scheme.degree();
    let bits = budget::bits(scheme.mask()).saturating_add(8).saturating_mul(p as u64);
    budget::check_size(limits, budget::product(&[4, p + 2, p + 2]), bits)?;
    let rounds = if scheme.is_spline() { 1 } else { p };
    budget::check(limits, budget::product(&[2, p, p, p, p, rounds]), bits / 2)?;
    let spectrum = match scheme.eigen() {
        Ok(subdivide::Form::Exact(eigen)) => Spectrum::Exact(Decomposition {
            eigenvalues: eigen.eigenvalues,
            blocks: eigen.blocks,
            q: from_rows(eigen.q),
            q_inverse: from_rows(eigen.q_inverse),
            jordan: from_rows(eigen.jordan),
        }),
        Ok(subdivide::Form::Numeric(estimates)) => Spectrum::Numeric(estimates),
        Err(_) => Spectrum::Unknown,
    };
    Ok(SchemeAnswer {
        scheme: scheme.clone(),
        matrix: from_rows(scheme.local_matrix()),
        group_matrix: from_rows(scheme.group_matrix()),
        spectrum,
        limit: scheme.limit_mask(0).ok(),
        tangent: scheme.limit_mask(1).ok(),
        second: scheme.limit_mask(2).ok(),
    })
}

/// The weights of the p + 1 points of one group in a point of a level, or of the limit.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// The scheme.
    pub scheme: Scheme<Rational>,
    /// The level k.
    pub level: usize,
    /// The index i in the level.
    pub index: Index,
    /// Whether it is a point of the level or of the limit.
    pub target: Target,
    /// i/2ᵏ: of a limit point its parameter; of a point of a level, the parameter to which it and the p − 1 points after
    /// it tend.
    pub parameter: Rational,
    /// The weights of P₀ … P_p.
    pub weights: Vec<Rational>,
}

/// The weights of the original group of p + 1 points in point `index` of a level, 0 ≤ index < 2ᵏ + p. No level between is built.
///
/// ```
/// use lath_exact::{answer::{point, scheme_named}, parse};
///
/// let answer = point(&scheme_named("cubic")?, 1, &"1".parse().unwrap(), &Default::default())?;
/// assert_eq!(answer.weights, parse::fractions("1/8,3/4,1/8,0")?);
/// # Ok::<(), lath_exact::error::Error>(())
/// ```
///
/// # Errors
/// S005 for a level above 1000; S006 for an index beyond the level; B001 where the budget is exceeded.
pub fn point(scheme: &Scheme<Rational>, level: usize, index: &Index, limits: &Limits<'_>) -> Result<Point> {
    weights(scheme, level, index, Target::Level, limits)
}

/// The weights of the original group of p + 1 points in the limit at t = index/2ᵏ, 0 ≤ index ≤ 2ᵏ.
///
/// ```
/// use lath_exact::{answer::{limit, scheme_named}, parse};
///
/// let answer = limit(&scheme_named("cubic")?, 3, &"6".parse().unwrap(), &Default::default())?;
/// assert_eq!(answer.weights, parse::fractions("1/384,121/384,235/384,27/384")?);
/// assert_eq!(answer.parameter, parse::fraction("3/4")?);
/// # Ok::<(), lath_exact::error::Error>(())
/// ```
///
/// # Errors
/// As [`point`]; S003 for a scheme whose convergence is not proven.
pub fn limit(scheme: &Scheme<Rational>, level: usize, index: &Index, limits: &Limits<'_>) -> Result<Point> {
    weights(scheme, level, index, Target::Limit, limits)
}

fn weights(
    scheme: &Scheme<Rational>,
    level: usize,
    index: &Index,
    target: Target,
    limits: &Limits<'_>,
) -> Result<Point> {
    let p = scheme.degree();
    let depth = level.min(MAX_LEVEL);
    // A blossom at p arguments, or one product of matrices for each bit; for each of the p + 1 points.
    let (each, bits) = if scheme.is_spline() {
        (budget::product(&[3, p + 1, p + 1]), budget::product(&[p, depth + 8]))
    } else {
        let digits = budget::bits(scheme.mask());
        (budget::product(&[depth + p * p, p + 1, p + 1]), digits.saturating_mul((depth + p) as u64))
    };
    budget::check(limits, each.saturating_mul(p as u64 + 1), bits)?;
    let weights = scheme.group_weights(level, target, index)?;
    let parameter = index.parameter(level);
    Ok(Point { scheme: scheme.clone(), level, index: index.clone(), target, parameter, weights })
}

/// A leap of p neighbours over levels.
#[derive(Clone, Debug, PartialEq)]
pub struct Jump {
    /// The scheme.
    pub scheme: Scheme<Rational>,
    /// Level and index of the first of the p neighbours that leap.
    pub from: (usize, Index),
    /// Level and index of the first of those that they make.
    pub to: (usize, Index),
    /// The power m of A: the number of levels.
    pub power: usize,
    /// Aᵐ.
    pub matrix: Matrix,
}

/// The power of A that takes the p neighbours at (level, index) to a higher level, and where they land.
///
/// ```
/// use lath_exact::answer::{jump, scheme_named};
///
/// let leap = jump(&scheme_named("cubic")?, (1, "1".parse().unwrap()), 5, &Default::default())?;
/// assert_eq!((leap.power, leap.to), (4, (5, "16".parse().unwrap())));
/// # Ok::<(), lath_exact::error::Error>(())
/// ```
///
/// # Errors
/// S005 for a level above 1000, or below the first; B001 where the budget is exceeded.
pub fn jump(scheme: &Scheme<Rational>, from: (usize, Index), to: usize, limits: &Limits<'_>) -> Result<Jump> {
    let (p, levels) = (scheme.degree(), to.min(MAX_LEVEL).saturating_sub(from.0));
    let bits = budget::bits(scheme.mask()).saturating_add(1).saturating_mul(levels as u64 + 1);
    budget::check_size(limits, budget::product(&[p, p]), bits)?;
    let rounds = 2 * (1 + levels.checked_ilog2().unwrap_or(0) as usize);
    budget::check(limits, budget::product(&[p, p, p, rounds]), bits)?;
    let leap = scheme.leap(from.0, &from.1, to)?;
    Ok(Jump { scheme: scheme.clone(), from, to: (to, leap.index), power: leap.power, matrix: from_rows(leap.matrix) })
}

/// Which triplet of the level before makes each triplet of a level.
#[derive(Clone, Debug, PartialEq)]
pub struct Triplets {
    /// The level k.
    pub level: usize,
    /// All 2ᵏ⁻¹ + 1 of them; none for level 0.
    pub triplets: Vec<Descent>,
}

/// The table of triplets of a level: P⁴ᵢ, Pᵢ₊₁, Pᵢ₊₂ at every even i, and the triplet of the level before that makes it.
///
/// ```
/// let table = lath_exact::answer::triplets(4, &Default::default())?.triplets;
/// assert_eq!((table.len(), table[8].index, table[8].from), (9, 16, 8));
/// # Ok::<(), lath_exact::error::Error>(())
/// ```
///
/// # Errors
/// S005 for a level above 1000; B001 where the budget is exceeded.
pub fn triplets(level: usize, limits: &Limits<'_>) -> Result<Triplets> {
    // The table is printed: a row is then two formulas, some four hundred bytes.
    if level <= MAX_LEVEL {
        let count = 1u64.checked_shl(level.saturating_sub(1).min(64) as u32).unwrap_or(u64::MAX);
        limits.check_bytes(count.saturating_mul(420))?;
    }
    Ok(Triplets { level, triplets: descents(level, limits)? })
}
