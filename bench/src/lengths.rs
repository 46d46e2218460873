//! Lengths of plane cubics and of a long B-spline, and parameters at equal lengths.
//!
//! *Timed:* the lengths from control points in memory; for parameters, preparing is inside. Accuracies are absolute, of curves some units long;
//! kurbo's is what it aims at, lath's is proven.
//!
//! *Compared:* the lengths, or the points at the parameters, within ten times the accuracy asked for.

use crate::Result;
use crate::comparison::Comparison;
use crate::contender::Contender;
use crate::random::Random;
use kurbo::{CubicBez, ParamCurve, ParamCurveArclen, Point};
use lath::curve::{BSpline, Bezier, Curve};
use lath::error::Limits;
use lath::query::{ArcLength, length};
use std::hint::black_box;
use std::time::Instant;

const CURVES: usize = 1000;
const STEPS: usize = 1000;
const POINTS: usize = 1000;

pub(crate) fn compare(all: &mut Vec<Comparison>) -> Result<()> {
    let mut random = Random::new(7);
    let cubics: Vec<[[f64; 2]; 4]> =
        (0..CURVES).map(|_| core::array::from_fn(|_| [random.unit(), random.unit()])).collect();
    for accuracy in [1e-3, 1e-6, 1e-9, 1e-12] {
        let contenders = vec![
            contender("lath", || cubics.iter().map(|points| ours(&Bezier::new(points)?, accuracy)).collect()),
            contender("kurbo 0.13", || Ok(cubics.iter().map(|points| cubic(points).arclen(accuracy)).collect())),
        ];
        all.push(Comparison::within(
            10.0 * accuracy,
            format!("length of {CURVES} cubics to {accuracy:e}"),
            CURVES,
            31,
            contenders,
        )?);
    }
    let (points, accuracy) = ([[0.0, 0.0], [1.0, 2.0], [-1.0, 2.0], [3.0, 0.0]], 1e-9);
    let contenders = vec![
        contender("lath", || {
            let curve = Bezier::new(points)?;
            let along = ArcLength::new(&curve, accuracy, &Limits::default())?;
            let steps = along.equal_steps(STEPS, &Limits::default())?;
            steps.iter().map(|t| Ok(curve.eval(*t)?[0])).collect()
        }),
        contender("kurbo 0.13", || {
            let curve = cubic(&points);
            let total = curve.arclen(accuracy);
            let at = |k: usize| curve.eval(curve.inv_arclen(total * (k as f64 / (STEPS - 1) as f64), accuracy)).x;
            Ok((0..STEPS).map(at).collect())
        }),
    ];
    all.push(Comparison::within(1e-8, format!("{STEPS} equal steps along a cubic"), STEPS, 31, contenders)?);
    let polygon: Vec<[f64; 2]> = random.walk(POINTS).into_iter().map(|[x, y, _]| [x, y]).collect();
    for accuracy in [1e-3, 1e-6] {
        let contenders = vec![
            contender("lath", || Ok(vec![ours(&BSpline::clamped(3, &polygon)?, accuracy)?])),
            contender("kurbo 0.13, piece by piece", || {
                let mut sum = 0.0;
                let share = accuracy / (POINTS - 3) as f64;
                BSpline::clamped(3, &polygon)?.bezier_pieces(&mut |piece| {
                    sum += cubic(&core::array::from_fn(|i| piece.points[i])).arclen(share);
                });
                Ok(vec![sum])
            }),
            #[cfg(feature = "heavy")]
            contender("curvo 0.3", || {
                use curvo::prelude::NurbsCurve2D;
                let points = polygon.iter().map(|p| nalgebra::Point3::new(p[0], p[1], 1.0)).collect();
                let knots = BSpline::clamped(3, &polygon)?.knots().values().to_vec();
                Ok(vec![NurbsCurve2D::<f64>::try_new(3, points, knots)?.try_length()?])
            }),
        ];
        all.push(Comparison::within(
            10.0 * accuracy,
            format!("length of a B-spline of {POINTS} points to {accuracy:e}"),
            POINTS,
            31,
            contenders,
        )?);
    }
    Ok(())
}

fn ours(curve: &dyn Curve<2>, accuracy: f64) -> Result<f64> {
    Ok(length(curve, accuracy, &Limits::default())?.0)
}

fn cubic(points: &[[f64; 2]; 4]) -> CubicBez {
    let [a, b, c, d] = points.map(|[x, y]| Point::new(x, y));
    CubicBez::new(a, b, c, d)
}

fn contender<'a>(name: &'static str, work: impl Fn() -> Result<Vec<f64>> + Copy + 'a) -> Contender<'a> {
    let sample = move || Ok(work()?.into_iter().map(|x| [x, 0.0, 0.0]).collect());
    let run = move || {
        let start = Instant::now();
        let answers = black_box(work()?);
        let taken = start.elapsed();
        drop(answers);
        Ok(taken)
    };
    Contender { name, here: true, sample: Some(Box::new(sample)), run: Box::new(run) }
}
