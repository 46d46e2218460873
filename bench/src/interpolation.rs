//! The natural C² cubic spline through n points in space, parameters given.
//!
//! *Timed:* from the points and parameters in memory, which the contender may borrow, to a curve that can be evaluated.
//! Allocating the curve, and whatever copies its constructor asks for, is inside; freeing it is outside.
//!
//! *Compared:* the curves at random parameters.

use crate::Result;
use crate::comparison::Comparison;
use crate::contender::scipy::{Scipy, Task};
use crate::contender::{Contender, lath::Lath, ndarray_interp::NdarrayInterp};
use crate::random::Random;
use lath::interpolate::{Parameters, parameters};
use std::cell::RefCell;
use std::hint::black_box;
use std::time::Instant;

const SAMPLES: usize = 500;

pub(crate) struct Data {
    pub(crate) parameters: Vec<f64>,
    pub(crate) points: Vec<[f64; 3]>,
    /// Where the curves are compared.
    samples: Vec<f64>,
}

/// A library that interpolates.
pub(crate) trait Interpolates {
    const NAME: &'static str;
    /// What is left to be evaluated; may borrow the data.
    type Curve<'a>;
    fn through(data: &Data) -> Result<Self::Curve<'_>>;
    fn point(curve: &Self::Curve<'_>, t: f64) -> Result<[f64; 3]>;
}

pub(crate) fn compare(scipy: Option<&RefCell<Scipy>>, all: &mut Vec<Comparison>) -> Result<()> {
    let cases = [
        (2_000, Parameters::Uniform, "uniform", 300),
        (2_000, Parameters::Chord, "chord", 300),
        (10_000, Parameters::Chord, "chord", 99),
        (100_000, Parameters::Chord, "chord", 25),
        (1_000_000, Parameters::Uniform, "uniform", 11),
        (1_000_000, Parameters::Chord, "chord", 11),
    ];
    for (n, rule, name, rounds) in cases {
        let data = data(n, rule)?;
        let mut contenders = vec![contender::<Lath>(&data)];
        #[cfg(feature = "heavy")]
        contenders.push(contender::<crate::contender::scirs2::Scirs2>(&data));
        contenders.push(contender::<NdarrayInterp>(&data));
        if let Some(scipy) = scipy {
            scipy.borrow_mut().load(&[&data.parameters, data.points.as_flattened(), &data.samples])?;
            contenders.push(Scipy::contender(scipy, Task::Cubic));
            contenders.push(Scipy::contender(scipy, Task::Interpolate));
        }
        all.push(Comparison::run(format!("interpolate {n} points, {name}"), n, rounds, contenders)?);
    }
    Ok(())
}

fn data(n: usize, rule: Parameters<'_>) -> Result<Data> {
    let mut random = Random::new(n as u64);
    let points = random.walk(n);
    let parameters = parameters(&points, false, rule)?;
    let end = parameters[n - 1];
    let samples = (0..SAMPLES).map(|_| random.unit() * end).collect();
    Ok(Data { parameters, points, samples })
}

fn contender<P: Interpolates>(data: &Data) -> Contender<'_> {
    let sample = move || {
        let curve = P::through(data)?;
        data.samples.iter().map(|t| P::point(&curve, *t)).collect()
    };
    let run = move || {
        let start = Instant::now();
        let curve = black_box(P::through(black_box(data))?);
        let taken = start.elapsed();
        drop(curve);
        Ok(taken)
    };
    Contender { name: P::NAME, here: true, sample: Some(Box::new(sample)), run: Box::new(run) }
}
