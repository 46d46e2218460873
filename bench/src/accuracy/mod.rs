//! How wrong everybody is: the largest and the mean E = |computed − exact| / (u Σ|bᵢ|Bᵢ(t)), u = 2⁻⁵³, over degrees 0 to 10,
//! three families of knots, values and two derivatives.
//!
//! ```text
//! accuracy
//! ├── input     the curves and the parameters, the same on every machine
//! ├── oracle    E by exact integers
//! ├── tally     what is counted, and the file that lets a stopped run go on
//! └── report    the tables
//! ```
//!
//! *Sides.* At a knot where the curve breaks, lath has to answer from the right, at the domain's end from the left. A peer
//! that answers a knot from the other side has another convention, which is no error: it is measured from the side that
//! suits it better.

mod input;
mod oracle;
mod report;
mod tally;

pub(crate) use input::Case;
pub(crate) use oracle::ORDERS;

use crate::Result;
use crate::contender::scipy::Scipy;
use crate::contender::{bspline::Bspline, enterpolation::Enterpolation, lath::Lath};
use input::{Family, PARAMETERS};
use oracle::Oracle;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::time::Instant;
use tally::{Chunk, Record, Tallies};

const DEGREES: std::ops::RangeInclusive<usize> = 0..=10;
/// Parameters for each degree and family.
const SAMPLES: usize = 100_000;
/// The degree that everybody uses gets ten times as many.
const FAVOURITE: usize = 3;
/// Cases between two entries of the record.
const CASES: usize = 100;
/// The oracle is held against the definition at so many parameters of so many cases of each degree and family.
const CHECKED: (usize, usize) = (5, 4);

/// A library that evaluates B-splines of one coordinate and any degree.
pub(crate) trait Answers {
    const NAME: &'static str;
    /// 1 for values alone, 3 for two derivatives.
    const ORDERS: usize;
    type Curve;
    /// The curve, or why it is refused.
    fn curve(case: &Case) -> Result<Self::Curve>;
    /// Writes value and derivatives at t, `ORDERS` of them.
    fn answer(curve: &Self::Curve, t: f64, out: &mut [f64]) -> Result<()>;
}

/// For each order a number for each parameter, NaN where there is none; or why the curve is refused.
type Ask<'a> = Box<dyn FnMut(&Case) -> Result<Vec<Vec<f64>>> + 'a>;

/// A contender without its types.
pub(crate) struct Who<'a> {
    pub(crate) name: String,
    pub(crate) orders: usize,
    ask: Ask<'a>,
}

impl Who<'_> {
    fn here<A: Answers>() -> Who<'static> {
        let ask = |case: &Case| {
            let curve = caught(|| A::curve(case))?;
            let mut all = vec![Vec::with_capacity(case.parameters.len()); A::ORDERS];
            for &t in &case.parameters {
                let mut out = [f64::NAN; ORDERS];
                if caught(|| A::answer(&curve, t, &mut out[..A::ORDERS])).is_err() {
                    out = [f64::NAN; ORDERS];
                }
                all.iter_mut().zip(out).for_each(|(all, x)| all.push(x));
            }
            Ok(all)
        };
        Who { name: A::NAME.to_owned(), orders: A::ORDERS, ask: Box::new(ask) }
    }
}

/// A panic as an error.
fn caught<T>(work: impl FnOnce() -> Result<T>) -> Result<T> {
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|_| Err("a panic".into()))
}

/// What is promised: 3(p + 1) for values, 10p for derivatives.
fn bound(degree: usize, order: usize) -> usize {
    if order == 0 { 3 * (degree + 1) } else { 10 * degree }
}

/// The command line after `accuracy`: `[--samples N] [--resume FILE]`. Whether lath keeps its bound.
pub(crate) fn run(arguments: &[String]) -> Result<bool> {
    let (mut samples, mut file) = (SAMPLES, None);
    let mut arguments = arguments.iter();
    while let Some(option) = arguments.next() {
        let value = arguments.next().ok_or_else(|| format!("{option} takes a value"))?;
        match option.as_str() {
            "--samples" => samples = value.parse().map_err(|error| format!("--samples {value}: {error}"))?,
            "--resume" => file = Some(PathBuf::from(value)),
            _ => return Err(format!("accuracy takes --samples and --resume, not {option}").into()),
        }
    }
    let mut scipy = match Scipy::start() {
        Ok(scipy) => Some(scipy),
        Err(reason) => {
            println!("scipy: skipped, because {reason}");
            None
        }
    };
    let mut who = vec![Who::here::<Lath>()];
    if let Some(scipy) = &mut scipy {
        let name = scipy.versions().split(',').next().unwrap_or("scipy").to_owned();
        who.push(Who { name, orders: ORDERS, ask: Box::new(|case| scipy.answers(case)) });
    }
    #[cfg(feature = "heavy")]
    who.push(Who::here::<crate::contender::curvo::Curvo>());
    who.extend([Who::here::<Bspline>(), Who::here::<Enterpolation>()]);
    std::panic::set_hook(Box::new(|_| ())); // a peer's panic is counted, not printed
    check_oracle()?;
    let names: Vec<&str> = who.iter().map(|who| who.name.as_str()).collect();
    let run = format!("accuracy of {}, {samples} samples", names.join(", "));
    let mut record = Record::open(file, &run, who.len())?;
    let kept = measure(&mut who, samples, &mut record)?;
    let degrees: Vec<usize> = DEGREES.collect();
    println!("{run}\n{}", report::markdown(&record, &who, &degrees));
    Ok(kept)
}

fn check_oracle() -> Result<()> {
    let (mut compared, start) = (0, Instant::now());
    for degree in DEGREES {
        for family in Family::ALL {
            for number in 0..CHECKED.0 {
                compared += oracle::agrees(&Case::draw(degree, family, number), CHECKED.1)?;
            }
        }
    }
    println!("oracle: agrees with the definition in {compared} answers ({:.0} s)", start.elapsed().as_secs_f64());
    Ok(())
}

/// Asks for what the record does not hold yet. Whether lath kept its bound everywhere.
fn measure(who: &mut [Who], samples: usize, record: &mut Record) -> Result<bool> {
    let mut kept = true;
    for degree in DEGREES {
        for family in Family::ALL {
            let samples = if degree == FAVOURITE { 10 * samples } else { samples };
            let (cases, start) = (samples.div_ceil(PARAMETERS), Instant::now());
            let mut done = 0;
            for number in 0..cases.div_ceil(CASES) {
                if record.holds(degree, family, number) {
                    continue;
                }
                let numbers = number * CASES..cases.min((number + 1) * CASES);
                done += numbers.len() * PARAMETERS;
                let mut tallies = vec![Tallies::default(); who.len()];
                for case in numbers {
                    ask(&Case::draw(degree, family, case), who, &mut tallies)?;
                }
                record.add(Chunk { degree, family, number, tallies })?;
            }
            let rate = done as f64 / start.elapsed().as_secs_f64();
            let lath = record.joined(degree, family, who.len())[0];
            eprintln!(
                "degree {degree}, {}: {done} parameters, {rate:.0} a second; lath {:?}",
                family.name(),
                lath.map(|tally| tally.largest)
            );
            for (order, tally) in lath.iter().enumerate() {
                kept &= tally.none + tally.refused == 0 && tally.largest <= bound(degree, order) as f64;
            }
        }
    }
    Ok(kept)
}

/// Asks everybody about one curve. The first of them is lath, and where it breaks its bound the input is printed.
fn ask(case: &Case, who: &mut [Who], tallies: &mut [Tallies]) -> Result<()> {
    let mut oracle = Oracle::new(case);
    let spans = case.spans();
    for (place, (who, tallies)) in who.iter_mut().zip(tallies).enumerate() {
        let answers = match (who.ask)(case) {
            Ok(answers) => answers,
            Err(reason) => {
                if place == 0 {
                    eprintln!("lath refuses {:?} of degree {}: {reason}", case.knots, case.degree);
                }
                tallies[..who.orders].iter_mut().for_each(|tally| tally.refused += case.parameters.len() as u64);
                continue;
            }
        };
        for (k, (answers, tally)) in answers.iter().zip(tallies).enumerate() {
            for (&t, &found) in case.parameters.iter().zip(answers) {
                let span = case.span(t).ok_or("a parameter outside the domain")?;
                let allowed = bound(case.degree, k) as f64;
                let mut off = oracle.units(span, t, k, found)?;
                if off > allowed && place > 0 && t == case.knots[span] {
                    let before = spans.iter().rev().find(|&&other| other < span);
                    if let Some(&before) = before {
                        let left = oracle.units(before, t, k, found)?;
                        off = if left < off { left } else { off };
                    }
                }
                if off > allowed && place == 0 {
                    let Case { degree, knots, points, .. } = case;
                    eprintln!(
                        "lath breaks its bound: E = {off} at {t:?}, derivative {k}, degree {degree}\n  knots {knots:?}\n  points {points:?}"
                    );
                }
                tally.add(off);
            }
        }
    }
    Ok(())
}
