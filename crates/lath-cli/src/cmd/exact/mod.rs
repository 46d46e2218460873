//! `lath exact`: matrices, blending functions, masks and weights as fractions.
//!
//! Each question is a function of the library and has its options in `questions`; what is said about the answer's paper is
//! in `paper`, and `picture` draws the answers that are functions.

mod paper;
mod picture;
mod questions;

use crate::failure::{Failure, Result};
use crate::level_index::LevelIndex;
use lath::error::Limits;
use lath::subdivide::Scheme;
use lath_exact::answer::{self, Condition, Ends, Form, SplineEnds};
use lath_exact::error::Error;
use lath_exact::{Rational, parse};
use questions::{Chosen, Question};

/// Answer in exact fractions: matrices, blending functions, masks, weights
///
/// Numbers are given as fractions or decimals, such as 5/7 or 0.25, and every answer is exact.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES, subcommand_value_name = "QUESTION", subcommand_help_heading = "Questions")]
pub(crate) struct Args {
    #[command(subcommand)]
    question: Question,
}

const EXAMPLES: &str = "\
Examples:
  lath exact matrix --basis bspline --degree 3
  lath exact blending --degree 2 --knots 0,0,0,1,2,3,3,3 -o functions.svg
  lath exact limit --degree 3 --level 3 --index 6 --explain
  lath exact at --degree 3 --knots 0,0,0,0,1/3,2/3,1,1,1,1 --t 1/2
  lath exact scheme --scheme four-point --format json
Run `lath exact QUESTION --help` for the options of a question.";

/// Answers.
pub(crate) fn run(args: &Args, limits: &Limits<'_>) -> Result<()> {
    match &args.question {
        Question::Matrix(q) => {
            let basis = of("--basis", q.basis.parse())?;
            let answer = answer::matrix(&basis, q.degree, limits)?;
            q.paper.write_or_draw(&answer, &q.look, || picture::basis(&answer), limits)
        }
        Question::Blending(q) => {
            let answer = of("--knots", answer::blending(&q.spline.knots()?, q.spline.degree, limits))?;
            q.paper.write_or_draw(&answer, &q.look, || picture::blending(&answer), limits)
        }
        Question::Scheme(q) => q.paper.write(&answer::scheme(&scheme(&q.scheme)?, limits)?, limits),
        Question::Point(q) => q.paper.write(&answer::point(&scheme(&q.scheme)?, q.level, &q.index, limits)?, limits),
        Question::Limit(q) => q.paper.write(&answer::limit(&scheme(&q.scheme)?, q.level, &q.index, limits)?, limits),
        Question::Jump(q) => {
            let LevelIndex { level, index } = &q.from;
            let from = (*level, index.clone());
            q.paper.write(&answer::jump(&scheme(&q.scheme)?, from, q.to_level, limits)?, limits)
        }
        Question::Triplets(q) => q.paper.write(&answer::triplets(q.level, limits)?, limits),
        Question::At(q) => {
            let (knots, t) = (q.spline.knots()?, of("--t", parse::fraction(&q.t))?);
            let answer = answer::at(&knots, q.spline.degree, &t, q.derivative, q.side.into(), limits)?;
            let answer = match &q.points {
                Some(points) => of("--points", parse::rows(points).and_then(|points| answer.with_points(points)))?,
                None => answer,
            };
            q.paper.write(&answer, limits)
        }
        Question::Greville(q) => {
            let answer = of("--knots", answer::greville(&q.spline.knots()?, q.spline.degree))?;
            q.paper.write(&answer, limits)
        }
        Question::Insertion(q) => {
            let (knots, inserted) = (q.spline.knots()?, fractions("--insert", &q.insert)?);
            q.paper.write(&answer::insertion(&knots, q.spline.degree, &inserted, limits)?, limits)
        }
        Question::Elevation(q) => {
            let answer = match &q.knots {
                Some(knots) => answer::elevation(&fractions("--knots", knots)?, q.degree, q.by, limits)?,
                None => answer::elevation_bezier(q.degree, q.by, limits)?,
            };
            q.paper.write(&answer, limits)
        }
        Question::Change(q) => {
            let from: Form = of("--from", q.from.parse())?;
            let to: Form = of("--to", q.to.parse())?;
            let interval = match &fractions("--interval", &q.interval)?[..] {
                [a, b] => (a.clone(), b.clone()),
                _ => return Err(Failure::usage("'--interval' takes two numbers: a,b")),
            };
            let degree = q.degree.unwrap_or(3);
            q.paper.write(&answer::change(&from, &to, degree, interval, limits)?, limits)
        }
        Question::Interpolation(q) => {
            let points = of("--points", parse::rows(&q.points))?;
            let parameters = q.params.as_deref().map(|t| fractions("--params", t)).transpose()?;
            let parameters = parameters.as_deref();
            match q.degree {
                Some(degree) => {
                    q.paper.write(&answer::collocation(&points, parameters, degree, spline_ends(q)?, limits)?, limits)
                }
                None => q.paper.write(&answer::interpolation(&points, parameters, ends(q)?, limits)?, limits),
            }
        }
    }
}

/// What an option says, or its fault.
fn of<T>(option: &'static str, result: Result<T, Error>) -> Result<T> {
    result.map_err(|error| Failure::exact(option, error))
}

fn fractions(option: &'static str, text: &str) -> Result<Vec<Rational>> {
    of(option, parse::fractions(text))
}

fn scheme(chosen: &Chosen) -> Result<Scheme<Rational>> {
    match (&chosen.scheme, chosen.degree) {
        (Some(name), _) => of("--scheme", answer::scheme_named(name)),
        (None, degree) => of("--degree", answer::scheme_named(&format!("degree:{}", degree.unwrap_or(3)))),
    }
}

fn ends(q: &questions::Interpolation) -> Result<Ends> {
    let condition = |option, text: &Option<String>| -> Result<Condition> {
        text.as_deref().map_or(Ok(Condition::NotAKnot), |text| of(option, text.parse()))
    };
    match q.ends.as_deref() {
        _ if q.closed => Ok(Ends::Closed),
        Some("cyclic") => Ok(Ends::Cyclic),
        Some("anticyclic") => Ok(Ends::Anticyclic),
        Some(both) => {
            let both: Condition = of("--ends", both.parse())?;
            Ok(Ends::Open(both.clone(), both))
        }
        None => Ok(Ends::Open(condition("--start", &q.start)?, condition("--end", &q.end)?)),
    }
}

/// The ends of a B-spline of any degree: the same at both.
fn spline_ends(q: &questions::Interpolation) -> Result<SplineEnds> {
    if q.start.is_some() || q.end.is_some() {
        return Err(Failure::usage(
            "with '--degree' both ends are alike: '--ends natural', 'not-a-knot', or '--closed'",
        ));
    }
    match q.ends.as_deref() {
        _ if q.closed => Ok(SplineEnds::Closed),
        Some(text) => of("--ends", text.parse()),
        None => Ok(SplineEnds::NotAKnot),
    }
}
