//! One workload, everybody who can do it: first whether they agree, then how long they take.

use crate::contender::Contender;
use crate::{Result, memory};
use std::time::Duration;

/// The greatest difference from lath, relative to lath's largest coordinate, at which two answers count as the same.
pub(crate) const TOLERANCE: f64 = 1e-12;

/// A row of the table for each contender; the first is lath.
pub(crate) struct Comparison {
    pub(crate) workload: String,
    /// Points put in or points got out, by which times and bytes are divided.
    pub(crate) points: usize,
    pub(crate) rows: Vec<Row>,
}

pub(crate) struct Row {
    pub(crate) name: &'static str,
    pub(crate) outcome: Outcome,
}

pub(crate) enum Outcome {
    Timed {
        times: Times,
        /// Bytes; unknown for another process.
        peak: Option<usize>,
        /// None of a yardstick, which computes nothing.
        difference: Option<f64>,
    },
    /// Computes something else, so it is not timed.
    Differs(f64),
    Failed(String),
}

pub(crate) struct Times {
    pub(crate) least: Duration,
    pub(crate) median: Duration,
}

impl Comparison {
    /// Asks everybody for a sample, drops whoever differs from the first contender, and runs the others in `rounds`
    /// rounds: each once a round, and in each round another one begins, so that a slow moment of the machine meets all.
    pub(crate) fn run(
        workload: String,
        points: usize,
        rounds: usize,
        contenders: Vec<Contender>,
    ) -> Result<Comparison> {
        Comparison::within(TOLERANCE, workload, points, rounds, contenders)
    }

    /// The same where answers may differ by more, because only so much was asked for.
    pub(crate) fn within(
        tolerance: f64,
        workload: String,
        points: usize,
        rounds: usize,
        contenders: Vec<Contender>,
    ) -> Result<Comparison> {
        eprintln!("{workload} …");
        let mut reference = Vec::new();
        let mut rows = Vec::new();
        let mut racing = Vec::new(); // contender, its row, its times
        for (row, mut contender) in contenders.into_iter().enumerate() {
            let name = contender.name;
            let outcome = match agree(&mut contender, &mut reference) {
                Ok((difference, peak)) if difference.is_none_or(|difference| difference <= tolerance) => {
                    racing.push((contender, row, Vec::with_capacity(rounds)));
                    let times = Times { least: Duration::ZERO, median: Duration::ZERO };
                    Outcome::Timed { times, peak, difference }
                }
                Ok((difference, _)) => Outcome::Differs(difference.unwrap_or(f64::NAN)),
                Err(error) if row == 0 => return Err(error),
                Err(error) => Outcome::Failed(error.to_string()),
            };
            rows.push(Row { name, outcome });
        }
        let count = racing.len();
        for round in 0..rounds {
            for turn in 0..count {
                let (contender, _, times) = &mut racing[(round + turn) % count];
                times.push((contender.run)()?);
            }
        }
        for (_, row, taken) in racing {
            if let Outcome::Timed { times, .. } = &mut rows[row].outcome {
                *times = summary(taken);
            }
        }
        Ok(Comparison { workload, points, rows })
    }

    pub(crate) fn agreed(&self) -> bool {
        self.rows.iter().all(|row| matches!(row.outcome, Outcome::Timed { .. }))
    }
}

/// The difference from the reference, which the first contender becomes, and the bytes of a run that also warms up.
fn agree(contender: &mut Contender, reference: &mut Vec<[f64; 3]>) -> Result<(Option<f64>, Option<usize>)> {
    let sample = contender.sample.as_mut().map(|sample| sample()).transpose()?;
    let (warm, bytes) = memory::peak(|| (contender.run)());
    warm?;
    let peak = contender.here.then_some(bytes);
    let Some(sample) = sample else { return Ok((None, peak)) };
    if reference.is_empty() {
        *reference = sample;
        return Ok((None, peak));
    }
    if sample.len() != reference.len() {
        return Err(format!("{} points instead of {}", sample.len(), reference.len()).into());
    }
    let (mut largest, mut difference) = (0.0_f64, 0.0_f64);
    for (ours, theirs) in reference.as_flattened().iter().zip(sample.as_flattened()) {
        let apart = (ours - theirs).abs();
        largest = largest.max(ours.abs());
        difference = if apart > difference || apart.is_nan() { apart } else { difference };
    }
    Ok((Some(difference / largest), peak))
}

fn summary(mut taken: Vec<Duration>) -> Times {
    taken.sort();
    Times { least: taken[0], median: taken[taken.len() / 2] }
}
