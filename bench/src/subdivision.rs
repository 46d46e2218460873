//! Curves by subdivision: one polygon to a high level, and many small rings to a low one.
//!
//! *Level 20 of a closed cubic polygon of 100 points in the plane*, 104,857,600 points. Timed is the filling of a buffer that
//! was written to before, the same for lath, for a plain fill and for passes by hand; `level` asks for memory of its own,
//! and the stream hands out blocks. Compared: every 997th point.
//!
//! *Chaikin's corner cutting, 4 steps, on 100,000 rings of 100 points in the plane.* Timed: from each ring in memory to a new list of
//! points, which is freed before the next. Rings, because on open lines geo keeps the end points and cuts beside them, which
//! is another polygon. Compared: every point of every 1000th ring.

use crate::comparison::Comparison;
use crate::contender::{Contender, Sample};
use crate::random::Random;
use crate::{Result, memory};
use lath::error::Limits;
use lath::subdivide::{Ends, Scheme, Subdivision, Target};
use std::cell::RefCell;
use std::hint::black_box;
use std::ops::ControlFlow;
use std::rc::Rc;
use std::time::{Duration, Instant};

const ROUNDS: usize = 11;

const CORNERS: usize = 100;
const LEVEL: usize = 20;
/// Every so many points of the level are compared.
const STRIDE: usize = 997;

const RINGS: usize = 100_000;
pub(crate) const STEPS: usize = 4;
/// Every so many rings are compared.
const RING_STRIDE: usize = 1_000;

type Buffer<'a> = &'a RefCell<Vec<[f64; 2]>>;

pub(crate) fn compare(all: &mut Vec<Comparison>) -> Result<()> {
    all.push(level()?);
    all.push(chaikin()?);
    Ok(())
}

fn level() -> Result<Comparison> {
    let corners = polygon(&mut Random::new(20), CORNERS);
    let sub = Subdivision::new(Scheme::cubic(), corners.clone(), Ends::Closed)?;
    for k in [5, 10, 15, LEVEL] {
        let (streamed, bytes) = memory::peak(|| stream(&sub, k, &mut |_| ()));
        streamed?;
        println!("stream of level {k}: {} points, {bytes} bytes at its peak", CORNERS << k);
    }
    let count = CORNERS << LEVEL;
    let buffer = RefCell::new(vec![[1.0; 2]; count]);
    let contenders = vec![
        into_buffer("lath level_into", &buffer, |out| {
            Ok(sub.level_into(LEVEL, Target::Level, &Limits::default(), out)?)
        }),
        filling(&buffer),
        by_passes(&buffer, &corners),
        Contender {
            name: "lath level",
            here: true,
            sample: Some(Box::new(|| Ok(every(STRIDE, &sub.level(LEVEL, Target::Level, &Limits::default())?)))),
            run: Box::new(|| {
                let start = Instant::now();
                let level = black_box(sub.level(LEVEL, Target::Level, &Limits::default())?);
                let taken = start.elapsed();
                drop(level);
                Ok(taken)
            }),
        },
        Contender {
            name: "lath stream",
            here: true,
            sample: Some(Box::new(|| {
                let (mut kept, mut seen) = (Vec::new(), 0);
                stream(&sub, LEVEL, &mut |block| {
                    let first = (STRIDE - seen % STRIDE) % STRIDE;
                    kept.extend(block.iter().skip(first).step_by(STRIDE).map(in_space));
                    seen += block.len();
                })?;
                Ok(kept)
            })),
            run: Box::new(|| {
                let start = Instant::now();
                stream(&sub, LEVEL, &mut |block| {
                    black_box(block);
                })?;
                Ok(start.elapsed())
            }),
        },
    ];
    Comparison::run(format!("level {LEVEL} of {CORNERS} points, closed cubic"), count, ROUNDS, contenders)
}

fn stream(sub: &Subdivision<2>, level: usize, sink: &mut dyn FnMut(&[[f64; 2]])) -> Result<()> {
    sub.stream(level, Target::Level, &Limits::default(), &mut |block| {
        sink(block);
        ControlFlow::Continue(())
    })?;
    Ok(())
}

/// Somebody who writes the level into the common buffer.
fn into_buffer<'a>(
    name: &'static str,
    buffer: Buffer<'a>,
    write: impl Fn(&mut [[f64; 2]]) -> Result<()> + Clone + 'a,
) -> Contender<'a> {
    let again = write.clone();
    let sample: Sample<'a> = Box::new(move || {
        again(&mut buffer.borrow_mut())?;
        Ok(every(STRIDE, &buffer.borrow()))
    });
    let run = move || {
        let mut out = buffer.borrow_mut();
        let start = Instant::now();
        write(&mut out)?;
        black_box(&out[..]);
        Ok(start.elapsed())
    };
    Contender { name, here: true, sample: Some(sample), run: Box::new(run) }
}

/// The yardstick: the buffer's memory written once, with nothing computed.
fn filling(buffer: Buffer<'_>) -> Contender<'_> {
    let fill = |out: &mut [[f64; 2]]| {
        out.fill(black_box([0.5, 0.25]));
        Ok(())
    };
    Contender { sample: None, ..into_buffer("plain fill", buffer, fill) }
}

/// Refinement by passes between the common buffer and one of half its size, which is asked for before the clock starts.
fn by_passes<'a>(buffer: Buffer<'a>, corners: &'a [[f64; 2]]) -> Contender<'a> {
    let work = move |out: &mut [[f64; 2]]| -> Duration {
        let mut other = vec![[1.0; 2]; out.len() / 2];
        let start = Instant::now();
        passes(corners, out, &mut other);
        black_box(&out[..]);
        start.elapsed()
    };
    let sample: Sample<'a> = Box::new(move || {
        work(&mut buffer.borrow_mut());
        Ok(every(STRIDE, &buffer.borrow()))
    });
    let run = move || Ok(work(&mut buffer.borrow_mut()));
    Contender { name: "passes by hand", here: true, sample: Some(sample), run: Box::new(run) }
}

/// `LEVEL` passes; their number is even, so that the last one writes into the buffer that begins with the corners.
fn passes(corners: &[[f64; 2]], whole: &mut [[f64; 2]], half: &mut [[f64; 2]]) {
    let mut n = corners.len();
    whole[..n].copy_from_slice(corners);
    for _ in 0..LEVEL / 2 {
        pass(&whole[..n], &mut half[..2 * n]);
        pass(&half[..2 * n], &mut whole[..4 * n]);
        n *= 4;
    }
}

/// One refinement of a closed polygon: edge and vertex points alternately.
fn pass(from: &[[f64; 2]], to: &mut [[f64; 2]]) {
    let rule = |[a, b, c]: [&[f64; 2]; 3], made: &mut [[f64; 2]; 2]| {
        for axis in 0..2 {
            made[0][axis] = 0.5 * (a[axis] + b[axis]);
            made[1][axis] = 0.125 * (a[axis] + c[axis]) + 0.75 * b[axis];
        }
    };
    let (pairs, _) = to.as_chunks_mut::<2>();
    for (window, made) in from.windows(3).zip(&mut *pairs) {
        rule([&window[0], &window[1], &window[2]], made);
    }
    let n = from.len();
    rule([&from[n - 2], &from[n - 1], &from[0]], &mut pairs[n - 2]);
    rule([&from[n - 1], &from[0], &from[1]], &mut pairs[n - 1]);
}

/// A library that cuts the corners of rings.
pub(crate) trait CutsCorners {
    const NAME: &'static str;
    type Ring;
    type Cut;
    fn ring(points: &[[f64; 2]]) -> Self::Ring;
    /// The ring after `STEPS` steps.
    fn cut(ring: &Self::Ring) -> Result<Self::Cut>;
    /// Its points, each once.
    fn points(cut: &Self::Cut) -> Vec<[f64; 2]>;
}

fn chaikin() -> Result<Comparison> {
    let mut random = Random::new(4);
    let rings: Vec<Vec<[f64; 2]>> = (0..RINGS).map(|_| polygon(&mut random, CORNERS)).collect();
    let contenders = vec![
        cutting::<crate::contender::lath::Lath>(&rings),
        #[cfg(feature = "heavy")]
        cutting::<crate::contender::geo::Geo>(&rings),
    ];
    let workload = format!("Chaikin {STEPS} steps, {RINGS} rings of {CORNERS}");
    Comparison::run(workload, RINGS * (CORNERS << STEPS), ROUNDS, contenders)
}

fn cutting<P: CutsCorners>(rings: &[Vec<[f64; 2]>]) -> Contender<'static>
where
    P::Ring: 'static,
{
    let rings: Rc<[P::Ring]> = rings.iter().map(|ring| P::ring(ring)).collect();
    let again = Rc::clone(&rings);
    let sample: Sample<'static> = Box::new(move || {
        let mut kept = Vec::new();
        for ring in again.iter().step_by(RING_STRIDE) {
            kept.extend(P::points(&P::cut(ring)?).iter().map(in_space));
        }
        Ok(kept)
    });
    let run = move || {
        let start = Instant::now();
        for ring in rings.iter() {
            black_box(P::cut(black_box(ring))?);
        }
        Ok(start.elapsed())
    };
    Contender { name: P::NAME, here: true, sample: Some(sample), run: Box::new(run) }
}

/// n points of a random walk in the plane.
fn polygon(random: &mut Random, n: usize) -> Vec<[f64; 2]> {
    random.walk(n).into_iter().map(|[x, y, _]| [x, y]).collect()
}

fn every(stride: usize, points: &[[f64; 2]]) -> Vec<[f64; 3]> {
    points.iter().step_by(stride).map(in_space).collect()
}

fn in_space(point: &[f64; 2]) -> [f64; 3] {
    [point[0], point[1], 0.0]
}
