//! A curve through points: the options of `through`, which `draw --through` takes too, and what they mean for the data.

use crate::condition::{BothEnds, Condition, Conditions};
use crate::construction::Through;
use crate::derivative::Given;
use crate::failure::{Failure, Result};
use crate::input::{Columns, Coordinates};
use crate::kind::{KINDS, Kind, Kinds};
use crate::numbers::{self, finite};
use crate::words::{Word, Words, unknown};
use clap::Args;
use lath::curve::AnyCurve;
use lath::error::{Code as CoreCode, Limits};
use lath::interpolate::Parameters;
use lath_io::number::counted;
use lath_io::points::PointTable;
use lath_io::{Code, Error};

/// The options that say which curve passes through the points.
#[derive(Args, Debug)]
pub(crate) struct Interpolation {
    /// The kind of curve (default cubic); `draw` takes several between commas, and compares them.
    #[arg(long, value_name = "KIND", value_parser = KINDS, conflicts_with = "tangents")]
    kind: Option<Kinds>,
    /// The degree of a B-spline (default 3).
    #[arg(long, value_name = "P", value_parser = numbers::count, allow_hyphen_values = true)]
    degree: Option<u64>,
    /// When the curve passes each point (default centripetal, and uniform for points of one coordinate).
    #[arg(long, value_name = "RULE", value_parser = Words { known: RULES, parse: rule })]
    params: Option<Rule>,
    /// The condition at the start: natural, not-a-knot, clamped:X,Y,… or second:X,Y,… (default not-a-knot).
    #[arg(long, value_name = "COND", conflicts_with_all = ["ends", "closed", "tangents"])]
    start: Option<Condition>,
    /// The condition at the end, in the same words.
    #[arg(long, value_name = "COND", conflicts_with_all = ["ends", "closed", "tangents"])]
    end: Option<Condition>,
    /// One condition for both ends; also cyclic or anticyclic.
    ///
    /// cyclic: slope and second derivative of both ends agree, whatever the values. anticyclic: they agree with opposite
    /// sign, as over half a period of something that returns mirrored; no other tool offers this one.
    #[arg(long, value_name = "COND", conflicts_with_all = ["closed", "tangents"])]
    ends: Option<BothEnds>,
    /// A derivative at a point of a B-spline, at an end or inside, as often as wanted: 2:1:0,1 gives point 2 the slope 0,1.
    ///
    /// Points count from 0, orders go from 1 to one below the degree. Each adds a knot near its point.
    #[arg(long, value_name = "INDEX:ORDER:X,Y,…", allow_hyphen_values = true, conflicts_with_all = ["closed", "tangents"])]
    derivative: Vec<Given>,
    /// Close the curve smoothly.
    ///
    /// A last point equal to the first is the closing point; otherwise the curve returns to the first point by itself.
    #[arg(long)]
    closed: bool,
    /// The period of a closed curve over given parameters: it closes at the first t + P.
    #[arg(long, value_name = "P", value_parser = numbers::positive, allow_hyphen_values = true, requires = "closed")]
    period: Option<f64>,
    /// The columns that hold the slope at each point, such as dx,dy.
    #[arg(long, value_name = "NAMES")]
    tangents: Option<Columns>,
}

/// A curve, and what it was made from.
pub(crate) struct Passing {
    pub(crate) curve: AnyCurve,
    /// What the legend calls it.
    pub(crate) label: String,
    /// When it passes each point; a closed curve passes the first one again.
    pub(crate) parameters: Vec<f64>,
}

/// The rule by which points get their parameters.
#[derive(Clone, Debug, PartialEq)]
enum Rule {
    Uniform,
    Chord,
    Centripetal,
    /// The sides to this power.
    Alpha(f64),
    Column(String),
}

const RULES: &[Word] = &[
    ("uniform", "t = 0, 1, 2, …"),
    ("chord", "The length of the polygon so far"),
    ("centripetal", "The sum of the square roots of the polygon's sides so far"),
    (
        "alpha",
        "The sum of the polygon's sides to a power from 0 on so far, alpha:A (0 uniform, 1/2 centripetal, 1 chord)",
    ),
    ("column", "In a column of the points, column:NAME; the others are coordinates"),
];

fn rule(text: &str) -> Result<Rule, String> {
    match text.split_once(':') {
        None if text == "uniform" => Ok(Rule::Uniform),
        None if text == "chord" => Ok(Rule::Chord),
        None if text == "centripetal" => Ok(Rule::Centripetal),
        Some(("alpha", power)) => match finite(power)? {
            power if power >= 0.0 => Ok(Rule::Alpha(power)),
            power => Err(format!("the power of the sides is {power}; it is a number from 0 on")),
        },
        None if text == "alpha" => Err("the power is missing: alpha:A, such as alpha:1/2".into()),
        Some(("column", name)) if !name.trim().is_empty() => Ok(Rule::Column(name.trim().to_owned())),
        Some(_) | None if text.starts_with("column") => {
            Err("the name is missing: column:NAME; or take uniform, chord or centripetal".into())
        }
        _ => Err(unknown("rule", text, RULES)),
    }
}

impl Interpolation {
    /// Whether any of the options was given.
    pub(crate) fn is_given(&self) -> bool {
        self.closed || self.is_given_beyond_closed()
    }

    /// Whether any but `--closed` was given.
    pub(crate) fn is_given_beyond_closed(&self) -> bool {
        let kind = self.kind.is_some() || self.degree.is_some() || self.tangents.is_some();
        kind || self.has_conditions() || !self.derivative.is_empty() || self.period.is_some() || self.params.is_some()
    }

    /// Whether the curve is to be closed.
    pub(crate) fn is_closed(&self) -> bool {
        self.closed
    }

    fn has_conditions(&self) -> bool {
        self.start.is_some() || self.end.is_some() || self.ends.is_some()
    }

    fn conditions(&self) -> Conditions {
        Conditions::new(self.start.as_ref(), self.end.as_ref(), self.ends.as_ref())
    }

    fn kinds(&self) -> &[Kind] {
        self.kind.as_ref().map_or(&[Kind::Cubic], |Kinds(kinds)| kinds)
    }

    /// Refuses options that mean nothing together, before any data are read.
    pub(crate) fn check(&self) -> Result<()> {
        let refuse = |message: String| Err(Failure::usage(message));
        let kinds = self.kinds();
        if self.period.is_some() && self.parameter_name().is_none() {
            return refuse("'--period' needs given parameters: '--params column:NAME'".into());
        }
        if self.degree.is_some() && !kinds.contains(&Kind::BSpline) {
            return refuse("'--degree' belongs to '--kind bspline'".into());
        }
        if self.has_conditions() && !kinds.iter().any(|kind| kind.has_ends()) {
            let kind = kinds.first().map_or_else(String::new, Kind::to_string);
            return refuse(format!("a curve of kind '{kind}' has no conditions at its ends; cubic and bspline have"));
        }
        if !self.derivative.is_empty() && !kinds.contains(&Kind::BSpline) {
            return refuse("'--derivative' belongs to '--kind bspline'".into());
        }
        match self.conditions().misfit(self.bspline_degree()) {
            Some(message) if kinds.contains(&Kind::BSpline) => refuse(message),
            _ => Ok(()),
        }
    }

    /// Refuses several kinds where one curve is made.
    pub(crate) fn check_single(&self) -> Result<()> {
        match self.kinds() {
            [_] => Ok(()),
            _ => Err(Failure::usage("several kinds are compared by 'lath draw --through'; one curve takes one kind")),
        }
    }

    fn bspline_degree(&self) -> u64 {
        self.degree.unwrap_or(3)
    }

    /// All columns that are asked for by name, where coordinates are.
    pub(crate) fn names<'a>(&'a self, chosen: &'a Coordinates) -> Vec<&'a str> {
        let mut names = chosen.names();
        if !names.is_empty() {
            names.extend(self.parameter_name());
            names.extend(self.tangents.iter().flat_map(|Columns(names)| names.iter().map(String::as_str)));
        }
        names
    }

    /// The column that holds the parameters, where one does.
    pub(crate) fn parameter_name(&self) -> Option<&str> {
        match &self.params {
            Some(Rule::Column(name)) => Some(name),
            _ => None,
        }
    }

    /// The curves through the rows of the table, one for each kind; also the columns that are coordinates.
    pub(crate) fn curves(
        &self,
        table: &PointTable,
        chosen: &Coordinates,
        limits: &Limits<'_>,
    ) -> Result<(Vec<Passing>, PointTable)> {
        let given = self.parameter_name().map(|name| table.take_columns(&[name])).transpose()?;
        let tangents = self.tangents.as_ref().map(|Columns(names)| table.take_columns(names)).transpose()?;
        let points = self.coordinates(table, chosen)?;
        let dimension = points.width();
        if let Some(tangents) = &tangents
            && tangents.width() != dimension
        {
            let message =
                format!("the slopes have {}, the points {dimension}", counted(tangents.width(), "coordinate"));
            return Err(points
                .locate(lath::error::Error::new(CoreCode::P005, message))
                .remedied("Name one column of slopes for each coordinate.")
                .into());
        }
        let conditions = self.conditions();
        let derivatives = &self.derivative;
        let checked = conditions
            .check(dimension)
            .and_then(|()| derivatives.iter().try_for_each(|given| given.check(dimension)))
            .and_then(|()| self.check_memory(&points, limits));
        checked.map_err(|error| points.locate(error))?;
        let count = if self.closed { self.without_closing_point(&points, tangents.as_ref())? } else { points.len() };
        let given = given.map(|t| self.closing_parameter(t.values(), count, &points)).transpose()?;
        let rule = match (&self.params, &given) {
            (_, Some(given)) => Parameters::Given(given),
            (Some(Rule::Uniform), _) => Parameters::Uniform,
            (Some(Rule::Chord), _) => Parameters::Chord,
            (Some(Rule::Alpha(power)), _) => Parameters::Power(*power),
            (None, _) if dimension == 1 => Parameters::Uniform,
            _ => Parameters::Centripetal,
        };
        let size = count.saturating_mul(dimension);
        let rows = points.values().get(..size).unwrap_or_default();
        let tangents = tangents.as_ref().map(|table| table.values().get(..size).unwrap_or_default());
        let mut made = Vec::new();
        for &kind in self.kinds() {
            let degree = usize::try_from(self.bspline_degree()).unwrap_or(usize::MAX);
            let (conditions, closed) = (&conditions, self.closed);
            let mut found = Vec::new();
            let parameters = &mut found;
            let builder =
                Through { rows, dimension, rule, closed, tangents, kind, degree, conditions, derivatives, parameters };
            let curve = AnyCurve::build(dimension, builder).map_err(|error| match error.code() {
                CoreCode::C003 => Error::from(error).in_source("--derivative"),
                _ => points.locate(error),
            })?;
            let label = match tangents {
                Some(_) => "curve with given slopes".to_owned(),
                None => kind.label(self.bspline_degree()),
            };
            made.push(Passing { curve, label, parameters: found });
        }
        Ok((made, points))
    }

    /// Refuses what would not fit into the budget of memory: about ten numbers for each coordinate in all, and the rows of
    /// the system that a B-spline solves.
    fn check_memory(&self, points: &PointTable, limits: &Limits<'_>) -> lath::error::Result<()> {
        let held = 80 * points.width().next_power_of_two() as u64;
        let row = self.kinds().contains(&Kind::BSpline).then(|| self.bspline_degree().min(30).saturating_mul(40));
        limits.check_bytes((points.len() as u64).saturating_mul(held + row.unwrap_or(0)))
    }

    /// The columns chosen, or all, without those that hold parameters and slopes.
    fn coordinates(&self, table: &PointTable, chosen: &Coordinates) -> Result<PointTable> {
        let index = |name: &str| -> Result<usize> {
            table.take_columns(&[name])?;
            let named = table.columns().and_then(|names| names.iter().position(|n| n == name));
            Ok(named.or_else(|| name.parse().ok()).unwrap_or(usize::MAX))
        };
        let slopes = self.tangents.iter().flat_map(|Columns(names)| names.iter().map(String::as_str));
        let taken: Vec<usize> = self.parameter_name().into_iter().chain(slopes).map(index).collect::<Result<_>>()?;
        let candidates: Vec<usize> = match &chosen.columns {
            Some(Columns(names)) => names.iter().map(|name| index(name)).collect::<Result<_>>()?,
            None => (0..table.width()).collect(),
        };
        let left: Vec<usize> = candidates.into_iter().filter(|i| !taken.contains(i)).collect();
        if left.is_empty() {
            let error =
                Error::new(Code::F009, "no column is left for coordinates beside those of parameters and slopes");
            return Err(error.in_source(table.source().unwrap_or_default()).into());
        }
        select(table, &left)
    }

    /// The number of points of a closed curve: a last point equal to the first is not counted.
    fn without_closing_point(&self, points: &PointTable, tangents: Option<&PointTable>) -> Result<usize> {
        let last = points.len().saturating_sub(1);
        if last == 0 || points.row(0) != points.row(last) {
            return Ok(points.len());
        }
        match tangents {
            Some(tangents) if tangents.row(0) != tangents.row(last) => {
                let error =
                    lath::error::Error::new(CoreCode::C001, "the closing point has another slope than the first point");
                let error = points.locate(error.at(last));
                let error = points.line(last).into_iter().fold(error, |e, line| e.at_line(line.into(), None));
                Err(error.remedied("Give both the same slope, or leave the closing point out.").into())
            }
            _ => Ok(last),
        }
    }

    /// The given parameters; for a closed curve with the one where it closes.
    fn closing_parameter(&self, t: &[f64], count: usize, points: &PointTable) -> Result<Vec<f64>> {
        let mut out = t.to_vec();
        let fault = |code, message: String, remedy: &str| {
            Err(points.locate(lath::error::Error::new(code, message)).remedied(remedy).into())
        };
        let end = self.period.zip(t.first()).map(|(period, first)| first + period);
        match (self.closed, end, t.get(count)) {
            (false, ..) | (true, None, Some(_)) => {}
            (true, Some(end), Some(&closing)) if end == closing => {}
            (true, Some(end), Some(&closing)) => {
                let message = format!("the closing point stands at t = {closing}, but the period ends at {end}");
                return fault(CoreCode::T004, message, "Leave out --period, or the closing point.");
            }
            (true, None, None) => {
                let message = format!(
                    "{} for {} of a closed curve, and no closing point",
                    counted(t.len(), "parameter"),
                    counted(count, "point")
                );
                let remedy =
                    "Give --period, or repeat the first point at the end with the parameter where the curve closes.";
                return fault(CoreCode::T004, message, remedy);
            }
            (true, Some(end), None) => match t.last() {
                Some(last) if end <= *last => {
                    let message = format!("the period ends at t = {end}, but the last point stands at {last}");
                    return fault(CoreCode::T003, message, "Give a longer period.");
                }
                _ => out.push(end),
            },
        }
        Ok(out)
    }
}

/// The columns with these indices. A column may be called by the index of another one, so names are asked first.
fn select(table: &PointTable, indices: &[usize]) -> Result<PointTable> {
    if indices.iter().copied().eq(0..table.width()) {
        return Ok(table.clone());
    }
    let name = |i: usize| table.columns().and_then(|names| names.get(i).cloned()).unwrap_or_else(|| i.to_string());
    let unique = |i: &usize| {
        let name = name(*i);
        table.columns().map_or(0, |names| names.iter().filter(|n| **n == name).count()) < 2
    };
    let wanted = indices.iter().map(|i| if unique(i) { name(*i) } else { i.to_string() });
    Ok(table.take_columns(&wanted.collect::<Vec<_>>())?)
}
