//! `lath subdivide`: a polygon refined again and again, the jump to one point, and the limit.
//!
//! Points go out as they are made, so that any level is written in constant memory.

use crate::dimension::{InDimension, in_dimension};
use crate::failure::Result;
use crate::input::{Coordinates, Reading};
use crate::level_index::{LevelIndex, level};
use crate::numbers::{self, finite, list};
use crate::output::Output;
use crate::scheme::{SCHEMES, SchemeWord};
use crate::table::{TableFormat, axis_names};
use crate::voice::Voice;
use clap::ArgGroup;
use lath::curve::pad;
use lath::error::{Code, Error, Limits};
use lath::subdivide::{Ends, Index, Scheme, Sphere, Subdivision, Target};
use lath_io::format::Format;
use lath_io::number::{counted, shortest};
use lath_io::points::PointTable;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::str::FromStr;

/// Refine a polygon by subdivision: any level, one point of it, or the limit
///
/// Reads the polygon (CSV, TSV, text, JSON) and writes the points of a level as a table. n points of an open polygon have
/// 2ᵏ(n − p) + p points at level k, p the degree of the scheme: the polygon retreats from its ends.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
#[command(group = ArgGroup::new("question").required(true).args(["levels", "only", "to_tolerance"]))]
pub(crate) struct Args {
    /// The file of points; `-` is standard input.
    points: PathBuf,
    /// The rule by which the polygon is refined.
    #[arg(long, value_name = "SCHEME", value_parser = SCHEMES)]
    scheme: SchemeWord,
    /// Refine K times, and write the points of that level.
    #[arg(long, value_name = "K", value_parser = level, allow_hyphen_values = true)]
    levels: Option<usize>,
    /// One point alone, such as 60:123456789, without the levels between; levels to 1000, indices of any length.
    #[arg(long, value_name = "LEVEL:INDEX", allow_hyphen_values = true)]
    only: Option<LevelIndex>,
    /// The least level whose polygon is proven to lie within T of the curve; the level is told on standard error.
    #[arg(long, value_name = "T", value_parser = numbers::positive, allow_hyphen_values = true, conflicts_with = "sphere")]
    to_tolerance: Option<f64>,
    /// The polygon returns from its last point to its first.
    #[arg(long)]
    closed: bool,
    /// Start and end in the end points, by counting each as many times as the degree says.
    #[arg(long, conflicts_with = "closed")]
    keep_ends: bool,
    /// Instead of the level's points those of the curve it tends to: row i is the curve at t = i/2ᴷ.
    #[arg(long, conflicts_with = "sphere")]
    limit: bool,
    /// The points lie on this sphere (in the plane on the circle X,Y,R), and stay there: midpoints are those of arcs.
    #[arg(long, value_name = "X,Y,Z,R", allow_hyphen_values = true)]
    sphere: Option<Ball>,
    #[command(flatten)]
    table: TableFormat,
    #[command(flatten)]
    reading: Reading,
    #[command(flatten)]
    coordinates: Coordinates,
    #[command(flatten)]
    output: Output,
}

const EXAMPLES: &str = "\
Examples:
  lath subdivide polygon.csv --scheme chaikin --levels 4 --closed
  lath subdivide polygon.csv --scheme cubic --only 60:123456789
      one point of level 60, at once
  lath subdivide polygon.csv --scheme cubic --only 3:6 --limit
      the curve at t = 6/8, in segments from the first joint
  lath subdivide part.csv --scheme degree:5 --keep-ends --to-tolerance 0.01
      as many levels as 0.01 mm need
  lath subdivide points.csv --scheme four-point --levels 6 -o dense.npy
  lath subdivide net.csv --scheme cubic --sphere 0,0,0,1 --levels 5";

/// `X,Y,Z,R`
#[derive(Clone, Debug, PartialEq)]
struct Ball {
    centre: Vec<f64>,
    radius: f64,
}

impl FromStr for Ball {
    type Err = String;

    fn from_str(text: &str) -> Result<Ball, String> {
        match list(text, finite)?[..] {
            [ref centre @ .., radius] if !centre.is_empty() && radius > 0.0 => {
                Ok(Ball { centre: centre.to_vec(), radius })
            }
            _ => Err("a sphere is its centre and a radius above 0: X,Y,Z,R".into()),
        }
    }
}

/// Writes the points.
pub(crate) fn run(args: &Args, limits: &Limits<'_>, voice: Voice) -> Result<()> {
    let format = args.table.choose(&args.output)?;
    let scheme = args.scheme.scheme()?;
    if args.sphere.is_some() && !scheme.is_spline() {
        let error = Error::new(Code::S002, "on a sphere midpoints are taken, but this scheme is not made of midpoints");
        let error = lath_io::Error::from(error).in_source("--scheme");
        return Err(error.remedied("Take chaikin, cubic or degree:P.").into());
    }
    let table = args.reading.points_named(&args.points, &args.coordinates.names(), limits)?;
    let table = args.coordinates.of(table)?;
    let voice = voice.unless(args.table.is_json());
    let work = Work { args, limits, voice, format, scheme, table: &table };
    in_dimension(table.width(), work).map_err(|error| table.locate(error))?
}

/// Everything that is known before the dimension is a constant.
struct Work<'a> {
    args: &'a Args,
    limits: &'a Limits<'a>,
    voice: Voice,
    format: &'static Format,
    scheme: Scheme,
    table: &'a PointTable,
}

impl InDimension for Work<'_> {
    type Output = Result<()>;

    fn run<const D: usize>(self) -> Result<()> {
        let points = pad::<D>(self.table.values(), self.table.width());
        let ends = match (self.args.closed, self.args.keep_ends) {
            (true, _) => Ends::Closed,
            (_, true) => Ends::Kept,
            _ => Ends::Open,
        };
        match &self.args.sphere {
            Some(ball) => self.on_sphere(ball, points, ends),
            None => {
                let polygon = Subdivision::new(self.scheme.clone(), points, ends);
                self.in_space(&polygon.map_err(|error| self.fault(error))?)
            }
        }
    }
}

impl Work<'_> {
    fn in_space<const D: usize>(&self, polygon: &Subdivision<D>) -> Result<()> {
        let target = if self.args.limit { Target::Limit } else { Target::Level };
        let fault = |error| self.fault(error);
        if let Some(LevelIndex { level, index }) = &self.args.only {
            let point = polygon.point(*level, target, index).map_err(fault)?;
            return self.write(1, |row| row(&point));
        }
        let level = match self.args.to_tolerance {
            Some(tolerance) => polygon.levels_for(tolerance).map_err(fault)?,
            None => self.args.levels.unwrap_or(0),
        };
        let count = polygon.count(level, target).map_err(fault)?.to_u64().unwrap_or(u64::MAX);
        self.limits.check_points(count).map_err(fault)?;
        // Whatever the library refuses, it refuses at the first point: nothing has been written then.
        polygon.point(level, target, &Index::default()).map_err(fault)?;
        if self.args.to_tolerance.is_some() {
            let distance = polygon.distance(level).map_err(fault)?.bound().value();
            self.voice.note(&format!("level {level} is proven to lie within {} of the curve", shortest(distance)));
        }
        self.write(count, |row| {
            let mut outcome = Ok(());
            let sent = polygon.stream(level, target, self.limits, &mut |block| {
                outcome = block.iter().try_for_each(&mut *row);
                if outcome.is_ok() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
            });
            outcome.and(sent.map_err(fault))
        })
    }

    fn on_sphere<const D: usize>(&self, ball: &Ball, points: Vec<[f64; D]>, ends: Ends) -> Result<()> {
        let (given, wanted) = (ball.centre.len(), self.table.width());
        if given != wanted {
            let message = format!("the centre has {}, the points have {wanted}", counted(given, "coordinate"));
            let error = self.fault(Error::new(Code::P005, message));
            return Err(error.remedied("Give the centre of the sphere with as many coordinates as the points.").into());
        }
        let centre = core::array::from_fn(|c| ball.centre.get(c).copied().unwrap_or(0.0));
        let fault = |error| self.fault(error);
        let sphere = Sphere::new(centre, ball.radius, self.scheme.degree(), points, ends).map_err(fault)?;
        let points = match &self.args.only {
            Some(LevelIndex { level, index }) => vec![sphere.point(*level, index).map_err(fault)?],
            None => sphere.level(self.args.levels.unwrap_or(0), self.limits).map_err(fault)?,
        };
        self.write(points.len() as u64, |row| points.iter().try_for_each(row))
    }

    /// Writes the table: `fill` hands over one point after the other.
    fn write<const D: usize>(
        &self,
        count: u64,
        fill: impl FnOnce(&mut dyn FnMut(&[f64; D]) -> lath_io::Result<()>) -> lath_io::Result<()>,
    ) -> Result<()> {
        let dimension = self.table.width();
        self.args.output.write(|out| {
            let mut sink = self.format.rows_counted(out, Some(&axis_names(dimension)), count)?;
            let mut progress = self.voice.progress(Some(count), self.args.output.file().is_some());
            fill(&mut |point| {
                progress.step();
                sink.row(point.get(..dimension).unwrap_or(point))
            })?;
            sink.finish()
        })
    }

    /// What the library refused, with its place: an option, or a row of the file.
    fn fault(&self, error: Error) -> lath_io::Error {
        let option = match (&self.args.only, self.args.levels) {
            (Some(_), _) => "--only",
            (_, Some(_)) => "--levels",
            _ => "--to-tolerance",
        };
        match error.code() {
            Code::S005 | Code::S006 => lath_io::Error::from(error).in_source(option),
            Code::S003 | Code::K006 => lath_io::Error::from(error).in_source("--scheme"),
            Code::S007 | Code::S008 => {
                let line = error.index().and_then(|index| self.table.line(index));
                line.into_iter().fold(self.table.locate(error), |error, line| error.at_line(line.into(), None))
            }
            _ => self.table.locate(error),
        }
    }
}
