//! `lath curve`: a curve from control points.

use crate::failure::{Failure, Result};
use crate::input::{Coordinates, Reading};
use crate::numbers::{self, Numbers};
use crate::output::{Output, check_extension};
use clap::ValueEnum;
use lath::curve::{AnyCurve, BSpline, Bezier, Curve, CurveBuilder, PolygonEnd, UniformBSpline, pad};
use lath::error::{Code, Error, Limits};
use lath::knot::Knots;
use lath_io::number::counted;
use lath_io::points::PointTable;
use lath_io::shapes::{self, Shape};
use std::path::PathBuf;
use std::str::FromStr;

/// Make a curve from control points
///
/// Reads the control polygon (CSV, TSV, text, JSON) and writes the curve as lath JSON.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Args {
    /// The file of control points; `-` is standard input.
    points: PathBuf,
    /// The kind of curve.
    #[arg(long, value_enum)]
    kind: Kind,
    /// The degree of a B-spline (default 3); a Bézier curve has one less than points.
    #[arg(long, value_name = "P", value_parser = numbers::count, allow_hyphen_values = true)]
    degree: Option<u64>,
    /// The knots: a,b,…, or uniform, or clamped (default clamped, and uniform for closed curves).
    ///
    /// n points of degree P take n + P + 1 knots, the domain running from knot P to knot n; a closed curve takes the n + 1
    /// knots of one period.
    #[arg(long, value_name = "KNOTS", allow_hyphen_values = true)]
    knots: Option<KnotRule>,
    /// The column of weights, column:NAME, which make the curve rational; the other columns are coordinates.
    ///
    /// Points are Cartesian, never multiplied by their weights.
    #[arg(long, value_name = "WEIGHTS", value_parser = weights_column, conflicts_with_all = ["tension", "at_polygon"])]
    weights: Option<String>,
    /// Close the curve: the first P points follow the last.
    #[arg(long)]
    closed: bool,
    /// The tension of a uniform cubic B-spline, from 0 (none) to 1 (the polygon of its joints): one for all segments, or s1,s2,… one for each.
    ///
    /// The joints stay, the tangents there shrink to 1 − S. One tension gives a Hermite curve, several give Bézier segments, the speed
    /// jumping where they differ. Knots are uniform.
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    tension: Option<Numbers>,
    /// Lead a uniform B-spline to the ends of its polygon by points added there.
    ///
    /// Knots are uniform; --knots clamped, the default, reaches the ends too, by knots.
    #[arg(long, value_name = "HOW", value_enum, conflicts_with = "closed")]
    at_polygon: Option<AtPolygon>,
    #[command(flatten)]
    reading: Reading,
    #[command(flatten)]
    coordinates: Coordinates,
    #[command(flatten)]
    output: Output,
}

const EXAMPLES: &str = "\
Examples:
  lath curve polygon.csv --kind bezier
  lath curve polygon.csv --kind bspline --degree 2 --knots uniform
  lath curve square.csv --kind bspline --knots 0,0,0,0,1,1,1,1
  lath curve quarter.csv --kind bezier --weights column:w
  lath curve polygon.csv --kind bspline --at-polygon phantom
      unit spans, from the first point to the last
  lath curve polygon.csv --kind bspline --closed --tension 1/2
      half-way to the polygon of its joints
  lath curve polygon.csv --kind bspline --closed | lath draw - --polygon -o loop.svg";

#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
enum Kind {
    /// One polynomial piece
    Bezier,
    /// Pieces over knots
    Bspline,
}

#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
enum AtPolygon {
    /// Both end points P times in all: the curve starts and ends straight, without speed
    Repeat,
    /// The polygon goes on by its mirror image, 2P₀ − P₁ for cubics: the curve starts and ends with a speed, not bent
    Phantom,
}

#[derive(Clone, Debug, PartialEq)]
enum KnotRule {
    Uniform,
    Clamped,
    Given(Vec<f64>),
}

impl FromStr for KnotRule {
    type Err = String;

    fn from_str(text: &str) -> Result<KnotRule, String> {
        match text {
            "uniform" => Ok(KnotRule::Uniform),
            "clamped" => Ok(KnotRule::Clamped),
            _ if text.contains(|c: char| c.is_ascii_digit()) => numbers::knots(text).map(KnotRule::Given),
            _ => Err("knots are a,b,…, or uniform, or clamped".into()),
        }
    }
}

/// Writes the curve.
pub(crate) fn run(args: &Args, limits: &Limits<'_>) -> Result<()> {
    check_extension(args.output.file(), &["json"], "curves are written as .json; `lath eval` makes points of them")?;
    check_options(args)?;
    let (table, weights) = read(args, limits)?;
    let dimension = table.width();
    let family = match args.kind {
        Kind::Bezier if args.closed => {
            let error = Error::new(Code::C002, "a Bézier curve cannot be closed");
            return Err(table.locate(error).remedied("Leave out --closed, or take --kind bspline.").into());
        }
        Kind::Bezier => Family::Bezier,
        Kind::Bspline => {
            let degree = usize::try_from(args.degree.unwrap_or(3)).unwrap_or(usize::MAX);
            let n = table.len();
            match (&args.knots, args.closed) {
                _ if args.tension.is_some() || args.at_polygon.is_some() => Family::Uniform {
                    degree,
                    closed: args.closed,
                    end: args.at_polygon,
                    tension: args.tension.as_ref().map(|Numbers(tensions)| &tensions[..]),
                },
                (Some(KnotRule::Given(knots)), false) => {
                    check_points(n, degree).map_err(|error| table.locate(error))?;
                    Family::Open(given(knots, n, degree)?)
                }
                (Some(KnotRule::Uniform), false) => {
                    Family::Open(Knots::uniform(n, degree).map_err(|e| table.locate(e))?)
                }
                (_, false) => Family::Open(Knots::clamped(n, degree).map_err(|e| table.locate(e))?),
                (Some(KnotRule::Given(period)), true) => {
                    check_period(period, n, degree)?;
                    Family::Closed { period, degree }
                }
                (_, true) => Family::ClosedUniform { degree },
            }
        }
    };
    let builder = ControlPoints { family, rows: table.values(), dimension, weights };
    let curve = AnyCurve::build(dimension, builder).map_err(|error| table.locate(error))?;
    args.output.write(|out| shapes::write(out, &[Shape::from(curve)]))
}

/// `column:NAME`, the name.
fn weights_column(text: &str) -> Result<String, String> {
    match text.split_once(':') {
        Some(("column", name)) if !name.trim().is_empty() => Ok(name.trim().to_owned()),
        _ => Err("weights stand in a column of the points: column:NAME, or column:2 by its index from 0".into()),
    }
}

/// The coordinates, and the weights where there are some.
fn read(args: &Args, limits: &Limits<'_>) -> Result<(PointTable, Option<Vec<f64>>)> {
    let mut names = args.coordinates.names();
    let Some(weights) = args.weights.as_deref() else {
        let table = args.reading.points_named(&args.points, &names, limits)?;
        return Ok((args.coordinates.of(table)?, None));
    };
    if names.is_empty() {
        let (weights, table) = args.reading.points_named(&args.points, &[], limits)?.split_parameter(weights)?;
        return Ok((table, Some(weights)));
    }
    names.push(weights);
    let table = args.reading.points_named(&args.points, &names, limits)?;
    let weights = table.take_columns(&[weights])?.values().to_vec();
    Ok((args.coordinates.of(table)?, Some(weights)))
}

/// Options that belong to B-splines only, and knots that cannot close.
fn check_options(args: &Args) -> Result<()> {
    let usage = |message: &str| Err(Failure::usage(message));
    match (args.kind, args.degree, &args.knots) {
        (Kind::Bezier, Some(_), _) => {
            usage("'--degree' belongs to '--kind bspline': a Bézier curve has one less than points")
        }
        (Kind::Bezier, _, Some(_)) => usage("'--knots' belongs to '--kind bspline'"),
        (Kind::Bezier, ..) if args.tension.is_some() => usage("'--tension' belongs to '--kind bspline'"),
        (Kind::Bezier, ..) if args.at_polygon.is_some() => usage("'--at-polygon' belongs to '--kind bspline'"),
        (_, _, Some(KnotRule::Clamped | KnotRule::Given(_))) if args.tension.is_some() => {
            usage("'--tension' is for uniform knots: '--knots uniform', or none")
        }
        (_, _, Some(KnotRule::Clamped | KnotRule::Given(_))) if args.at_polygon.is_some() => {
            usage("'--at-polygon' is for uniform knots: '--knots uniform', or none")
        }
        (_, Some(degree), _) if degree != 3 && args.tension.is_some() => usage("'--tension' is for degree 3"),
        (_, _, Some(KnotRule::Clamped)) if args.closed => usage("'--knots clamped' cannot be used with '--closed'"),
        _ => Ok(()),
    }
}

/// Refuses fewer points than the degree needs, naming both numbers.
fn check_points(points: usize, degree: usize) -> lath::error::Result<()> {
    // Builds nothing but the check: the degree is refused first if it is out of range.
    if points > degree || degree > 1000 {
        return Ok(());
    }
    let message = format!("{} for degree {degree}, which takes at least {}", counted(points, "point"), degree + 1);
    Err(Error::new(Code::P001, message))
}

/// The knots of an open curve from the command line.
fn given(values: &[f64], points: usize, degree: usize) -> Result<Knots> {
    let fault = |error: Error| lath_io::Error::from(error).in_source("--knots");
    let wanted = points.saturating_add(degree).saturating_add(1);
    if values.len() + 2 == wanted && degree <= 1000 {
        let message = format!(
            "{} knots for {points} points of degree {degree}, which take {wanted}; two fewer looks like the openNURBS \
             convention, which leaves out the first and the last knot",
            values.len()
        );
        return Err(fault(Error::new(Code::K001, message))
            .remedied("Repeat the first and the last knot once more.")
            .into());
    }
    if values.len() != wanted && degree <= 1000 {
        let message = format!(
            "{} for {} of degree {degree}, which take {wanted}",
            counted(values.len(), "knot"),
            counted(points, "point")
        );
        return Err(fault(Error::new(Code::K001, message)).into());
    }
    Ok(Knots::new(values.to_vec(), degree).map_err(fault)?)
}

/// The period of a closed curve from the command line.
fn check_period(period: &[f64], points: usize, degree: usize) -> Result<()> {
    let fault = |error: Error| lath_io::Error::from(error).in_source("--knots");
    let count = period.len();
    if count != points + 1 {
        let message = format!(
            "{} for a closed curve of {}, which takes {}: one period",
            counted(count, "knot"),
            counted(points, "point"),
            points + 1
        );
        return Err(fault(Error::new(Code::K001, message)).into());
    }
    Knots::periodic(period, degree).map(|_| ()).map_err(|error| fault(error).into())
}

/// What is made of the control points.
enum Family<'a> {
    Bezier,
    Open(Knots),
    Closed { period: &'a [f64], degree: usize },
    ClosedUniform { degree: usize },
    Uniform { degree: usize, closed: bool, end: Option<AtPolygon>, tension: Option<&'a [f64]> },
}

/// Makes the curve in whatever dimension it is asked for.
struct ControlPoints<'a> {
    family: Family<'a>,
    rows: &'a [f64],
    dimension: usize,
    weights: Option<Vec<f64>>,
}

impl CurveBuilder for ControlPoints<'_> {
    fn build<const D: usize>(self) -> lath::error::Result<Box<dyn Curve<D>>> {
        let points = pad::<D>(self.rows, self.dimension);
        let weights = self.weights;
        let spline = |curve: BSpline<D>| -> lath::error::Result<Box<dyn Curve<D>>> {
            Ok(match weights.clone() {
                Some(weights) => Box::new(curve.weighted(weights)?),
                None => Box::new(curve),
            })
        };
        Ok(match self.family {
            Family::Bezier => match weights {
                Some(weights) => Box::new(Bezier::new(points)?.weighted(weights)?),
                None => Box::new(Bezier::new(points)?),
            },
            Family::Open(knots) => spline(BSpline::new(knots, points)?)?,
            Family::Closed { period, degree } => spline(BSpline::closed(period, degree, points)?)?,
            Family::ClosedUniform { degree } => spline(BSpline::closed_uniform(degree, points)?)?,
            Family::Uniform { degree, closed, end, tension } => {
                let curve = match end {
                    Some(AtPolygon::Repeat) => UniformBSpline::at_polygon(degree, points, PolygonEnd::Repeat)?,
                    Some(AtPolygon::Phantom) => UniformBSpline::at_polygon(degree, points, PolygonEnd::Phantom)?,
                    None if closed => UniformBSpline::closed(degree, points)?,
                    None => UniformBSpline::new(degree, points)?,
                };
                match tension {
                    None => Box::new(curve),
                    Some([tension]) => Box::new(curve.with_tension(*tension)?),
                    Some(tensions) => Box::new(curve.with_tensions(tensions)?),
                }
            }
        })
    }
}
