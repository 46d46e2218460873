//! A clamped non-uniform cubic B-spline with 1,000 control points in space, at 1,000,000 parameters.
//!
//! *Timed:* from a curve built before to a new list of points. Allocating the list is inside, because not everybody can
//! write into the caller's memory; freeing it is outside.
//!
//! *Compared:* every point.

use crate::Result;
use crate::comparison::Comparison;
use crate::contender::scipy::{Scipy, Task};
use crate::contender::{Contender, bspline::Bspline, enterpolation::Enterpolation, lath::Lath};
use crate::random::Random;
use std::cell::RefCell;
use std::hint::black_box;
use std::time::Instant;

const CONTROL_POINTS: usize = 1_000;
const PARAMETERS: usize = 1_000_000;
const ROUNDS: usize = 11;

pub(crate) const DEGREE: usize = 3;

pub(crate) struct Spline {
    /// All control points + degree + 1 knots.
    pub(crate) knots: Vec<f64>,
    pub(crate) points: Vec<[f64; 3]>,
}

/// A library that evaluates B-splines.
pub(crate) trait Evaluates {
    const NAME: &'static str;
    type Curve;
    fn build(spline: &Spline) -> Result<Self::Curve>;
    /// Appends a point for each parameter; there is room for all.
    fn evaluate(curve: &Self::Curve, parameters: &[f64], out: &mut Vec<[f64; 3]>) -> Result<()>;
}

pub(crate) fn compare(scipy: Option<&RefCell<Scipy>>, all: &mut Vec<Comparison>) -> Result<()> {
    let mut random = Random::new(1);
    let spline = spline(&mut random);
    let end = spline.knots[spline.knots.len() - 1];
    let shuffled: Vec<f64> = (0..PARAMETERS).map(|_| random.unit() * end).collect();
    let mut sorted = shuffled.clone();
    sorted.sort_by(f64::total_cmp);
    for (parameters, name) in [(&sorted, "sorted"), (&shuffled, "random")] {
        let mut contenders = vec![contender::<Lath>(&spline, parameters)?];
        #[cfg(feature = "heavy")]
        contenders.push(contender::<crate::contender::curvo::Curvo>(&spline, parameters)?);
        contenders.push(contender::<Enterpolation>(&spline, parameters)?);
        contenders.push(contender::<Bspline>(&spline, parameters)?);
        if let Some(scipy) = scipy {
            scipy.borrow_mut().load(&[&spline.knots, spline.points.as_flattened(), parameters])?;
            contenders.push(Scipy::contender(scipy, Task::Evaluate));
        }
        let workload = format!("evaluate at {PARAMETERS} parameters, {name}");
        all.push(Comparison::run(workload, PARAMETERS, ROUNDS, contenders)?);
    }
    Ok(())
}

/// Spans between 0.1 and 1.9.
fn spline(random: &mut Random) -> Spline {
    let mut knots = vec![0.0; DEGREE + 1];
    let mut t = 0.0;
    for _ in DEGREE..CONTROL_POINTS {
        t += 0.1 + 1.8 * random.unit();
        knots.push(t);
    }
    knots.extend([t; DEGREE]);
    Spline { knots, points: random.walk(CONTROL_POINTS) }
}

fn contender<'a, P: Evaluates>(spline: &Spline, parameters: &'a [f64]) -> Result<Contender<'a>>
where
    P::Curve: Clone + 'a,
{
    let curve = P::build(spline)?;
    let again = curve.clone();
    let sample = move || {
        let mut out = Vec::with_capacity(parameters.len());
        P::evaluate(&again, parameters, &mut out)?;
        Ok(out)
    };
    let run = move || {
        let start = Instant::now();
        let mut out = Vec::with_capacity(parameters.len());
        P::evaluate(black_box(&curve), black_box(parameters), &mut out)?;
        let out = black_box(out);
        let taken = start.elapsed();
        drop(out);
        Ok(taken)
    };
    Ok(Contender { name: P::NAME, here: true, sample: Some(Box::new(sample)), run: Box::new(run) })
}
