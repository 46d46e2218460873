//! End conditions as words.

use crate::numbers::{finite, list};
use crate::words::{Word, unknown};
use lath::error::{Code, Error};
use lath::interpolate::{BSplineEnd, End, Ends};
use lath_io::number::counted;
use std::str::FromStr;

/// `natural | not-a-knot | clamped:X,Y,… | second:X,Y,…`
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Condition {
    Natural,
    NotAKnot,
    Clamped(Vec<f64>),
    Second(Vec<f64>),
}

/// What `--ends` takes: one condition for both ends, or one that joins them.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum BothEnds {
    Each(Condition),
    Cyclic,
    Anticyclic,
}

impl FromStr for Condition {
    type Err = String;

    fn from_str(text: &str) -> Result<Condition, String> {
        match text.split_once(':') {
            None if text == "natural" => Ok(Condition::Natural),
            None if text == "not-a-knot" => Ok(Condition::NotAKnot),
            Some(("clamped", vector)) => list(vector, finite).map(Condition::Clamped),
            Some(("second", vector)) => list(vector, finite).map(Condition::Second),
            _ => Err(mistyped(text, &["natural", "not-a-knot", "clamped:X,Y,…", "second:X,Y,…"])),
        }
    }
}

impl FromStr for BothEnds {
    type Err = String;

    fn from_str(text: &str) -> Result<BothEnds, String> {
        match text {
            "cyclic" => Ok(BothEnds::Cyclic),
            "anticyclic" => Ok(BothEnds::Anticyclic),
            "natural" | "not-a-knot" => text.parse().map(BothEnds::Each),
            _ if text.starts_with("clamped:") || text.starts_with("second:") => text.parse().map(BothEnds::Each),
            _ => {
                const ALL: &[&str] =
                    &["natural", "not-a-knot", "clamped:X,Y,…", "second:X,Y,…", "cyclic", "anticyclic"];
                Err(mistyped(text, ALL))
            }
        }
    }
}

/// What to say about a condition that is none.
fn mistyped(text: &str, known: &'static [&'static str]) -> String {
    let known: Vec<Word> = known.iter().map(|word| (*word, "")).collect();
    unknown("condition", text, &known)
}

impl Condition {
    /// Refuses a vector that has another number of coordinates than the points.
    pub(crate) fn check(&self, dimension: usize) -> Result<(), Error> {
        let (word, vector) = match self {
            Condition::Natural | Condition::NotAKnot => return Ok(()),
            Condition::Clamped(vector) => ("clamped", vector),
            Condition::Second(vector) => ("second", vector),
        };
        if vector.len() == dimension {
            return Ok(());
        }
        let (given, wanted) = (counted(vector.len(), "number"), counted(dimension, "coordinate"));
        Err(Error::new(Code::P005, format!("the {word} end has {given}, but the points have {wanted}")))
    }

    /// Why an end of a B-spline of this degree cannot have the condition.
    fn misfit(&self, degree: u64) -> Option<String> {
        let (word, least) = match self {
            Condition::Natural | Condition::NotAKnot => return None,
            Condition::Clamped(_) => ("clamped", 2),
            Condition::Second(_) => ("second", 3),
        };
        let (given, wanted) = ("one derivative is given", degree / 2);
        match degree {
            2 | 3 if degree >= least => None,
            2 => Some(format!("an end of degree 2 has no second derivative to give, as '{word}' does")),
            _ => Some(format!("by '{word}' {given}, but an end of degree {degree} takes {wanted}")),
        }
    }

    /// The condition for the library, padded with zeros.
    fn end<const D: usize>(&self) -> End<D> {
        match self {
            Condition::Natural => End::Natural,
            Condition::NotAKnot => End::NotAKnot,
            Condition::Clamped(vector) => End::Clamped(padded(vector)),
            Condition::Second(vector) => End::Second(padded(vector)),
        }
    }

    /// The condition for a B-spline.
    fn bspline_end<const D: usize>(&self) -> BSplineEnd<D> {
        match self {
            Condition::Natural => BSplineEnd::Natural,
            Condition::NotAKnot => BSplineEnd::NotAKnot,
            Condition::Clamped(vector) => BSplineEnd::Derivatives(vec![(1, padded(vector))]),
            Condition::Second(vector) => BSplineEnd::Derivatives(vec![(2, padded(vector))]),
        }
    }
}

fn padded<const D: usize>(vector: &[f64]) -> [f64; D] {
    core::array::from_fn(|c| vector.get(c).copied().unwrap_or(0.0))
}

/// The conditions at both ends.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Conditions {
    Open(Condition, Condition),
    Cyclic,
    Anticyclic,
}

impl Conditions {
    /// From the options `--start`, `--end` and `--ends`; not-a-knot where nothing is said.
    pub(crate) fn new(start: Option<&Condition>, end: Option<&Condition>, both: Option<&BothEnds>) -> Conditions {
        let or_default = |end: Option<&Condition>| end.cloned().unwrap_or(Condition::NotAKnot);
        match both {
            Some(BothEnds::Cyclic) => Conditions::Cyclic,
            Some(BothEnds::Anticyclic) => Conditions::Anticyclic,
            Some(BothEnds::Each(each)) => Conditions::Open(each.clone(), each.clone()),
            None => Conditions::Open(or_default(start), or_default(end)),
        }
    }

    /// See [`Condition::check`].
    pub(crate) fn check(&self, dimension: usize) -> Result<(), Error> {
        match self {
            Conditions::Open(start, end) => start.check(dimension).and_then(|()| end.check(dimension)),
            Conditions::Cyclic | Conditions::Anticyclic => Ok(()),
        }
    }

    /// The conditions for the library, padded with zeros.
    pub(crate) fn ends<const D: usize>(&self) -> Ends<D> {
        match self {
            Conditions::Open(start, end) => Ends::Open(start.end(), end.end()),
            Conditions::Cyclic => Ends::Cyclic,
            Conditions::Anticyclic => Ends::Anticyclic,
        }
    }

    /// Why a B-spline of this degree cannot have these ends.
    pub(crate) fn misfit(&self, degree: u64) -> Option<String> {
        match self {
            Conditions::Open(start, end) => start.misfit(degree).or_else(|| end.misfit(degree)),
            Conditions::Cyclic | Conditions::Anticyclic => {
                Some("cyclic and anticyclic ends belong to '--kind cubic'; '--closed' closes a B-spline".into())
            }
        }
    }

    /// The conditions for a B-spline: those that join the ends are refused before.
    pub(crate) fn bspline_ends<const D: usize>(&self) -> (BSplineEnd<D>, BSplineEnd<D>) {
        match self {
            Conditions::Open(start, end) => (start.bspline_end(), end.bspline_end()),
            Conditions::Cyclic | Conditions::Anticyclic => (BSplineEnd::NotAKnot, BSplineEnd::NotAKnot),
        }
    }
}
