//! Constructors, from bytes: every family of curves, every interpolant, schemes and solvers.

use crate::questions::{ask, ask_counted};
use crate::tape::Tape;
use crate::{interpolants, refinement, solvers, subdivision};
use lath::basis::bspline::values;
use lath::curve::{
    BSpline, Bezier, Curve, Hermite, Interval, Nurbs, Path, PolygonEnd, Polyline, Power, QuinticHermite,
    RationalBezier, UniformBSpline,
};
use lath::error::Result;
use lath::knot::{Knots, Side};

/// The target.
pub fn run(bytes: &[u8]) {
    let tape = &mut Tape::new(bytes);
    match tape.below(4) {
        0 => in_dimension::<1>(tape),
        1 => in_dimension::<2>(tape),
        2 => in_dimension::<3>(tape),
        _ => solvers::solve(tape),
    }
}

fn in_dimension<const D: usize>(tape: &mut Tape<'_>) {
    match tape.below(6) {
        0 => {
            if let Ok(curve) = family::<D>(tape, 2) {
                ask(&*curve, tape);
            }
        }
        1 => interpolants::interpolate::<D>(tape),
        2 => subdivision::subdivide::<D>(tape),
        3 => refinement::refine::<D>(tape),
        4 => refinement::refine_rational::<D>(tape),
        _ => knots::<D>(tape),
    }
}

/// A curve of some family; paths hold others, `depth` deep.
fn family<const D: usize>(tape: &mut Tape<'_>, depth: usize) -> Result<Box<dyn Curve<D>>> {
    let (kind, degree, n) = (tape.below(19), tape.below(8), tape.below(12));
    Ok(match kind {
        0 => Box::new(BSpline::over(tape.increasing(n), degree, tape.rows::<D>(n.saturating_sub(degree + 1)))?),
        1 => Box::new(BSpline::closed(&tape.increasing(n + 1), degree, tape.rows::<D>(n))?),
        2 => Box::new(BSpline::uniform(degree, tape.rows::<D>(n))?),
        3 => Box::new(BSpline::clamped(degree, tape.rows::<D>(n))?),
        4 => Box::new(BSpline::closed_uniform(degree, tape.rows::<D>(n))?),
        5 => Box::new(Bezier::on(tape.rows::<D>(n), Interval { start: tape.float(), end: tape.float() })?),
        6 => Box::new(Hermite::new(tape.increasing(n), tape.rows::<D>(n), tape.rows::<D>(n))?),
        7 => Box::new(Hermite::closed(tape.increasing(n + 1), tape.rows::<D>(n), tape.rows::<D>(n))?),
        8 => {
            let (t, points) = (tape.increasing(n), tape.rows::<D>(n));
            Box::new(QuinticHermite::new(t, points, tape.rows::<D>(n), tape.rows::<D>(n))?)
        }
        9 if depth > 0 => {
            let closed = tape.flip();
            let pieces = (0..n % 4).map(|_| family::<D>(tape, depth - 1)).collect::<Result<Vec<_>>>()?;
            Box::new(Path::new(pieces, closed)?)
        }
        10 => {
            let breaks = tape.increasing(n % 5 + 1);
            let pieces: Vec<_> = (0..n % 5).map(|_| tape.rows::<D>(degree)).collect();
            Box::new(Power::new(breaks, pieces)?)
        }
        11 => {
            let (t, points) = (tape.increasing(n), tape.rows::<D>(n.saturating_sub(degree + 1)));
            let weights = tape.weights(points.len());
            Box::new(Nurbs::over(t, degree, points, weights)?)
        }
        12 => {
            let (t, points) = (tape.increasing(n + 1), tape.rows::<D>(n));
            Box::new(Nurbs::closed(&t, degree, points, tape.weights(n))?)
        }
        13 => {
            let (points, weights) = (tape.rows::<D>(n), tape.weights(n));
            let domain = Interval { start: tape.float(), end: tape.float() };
            Box::new(RationalBezier::on(points, weights, domain)?)
        }
        14 => Box::new(UniformBSpline::new(degree, tape.rows::<D>(n))?),
        15 => Box::new(UniformBSpline::closed(degree, tape.rows::<D>(n))?),
        16 => {
            let end = if tape.flip() { PolygonEnd::Repeat } else { PolygonEnd::Phantom };
            Box::new(UniformBSpline::at_polygon(degree, tape.rows::<D>(n), end)?)
        }
        17 => {
            let mut vector = || std::array::from_fn(|_| tape.float());
            let (center, a, b) = (vector(), vector(), vector());
            let (from, to) = (tape.float(), tape.float());
            Box::new(match degree % 4 {
                0 => Nurbs::ellipse(center, a, b)?,
                1 => Nurbs::elliptic_arc(center, a, b, from, to)?,
                2 => Nurbs::parabola(center, a, b, from, to)?,
                _ => Nurbs::hyperbola(center, a, b, from, to)?,
            })
        }
        _ => Box::new(Polyline::new(tape.rows::<D>(n))?),
    })
}

/// Knots of any making: what is promised of them, and a curve over them.
fn knots<const D: usize>(tape: &mut Tape<'_>) {
    let (degree, n) = (tape.below(8), tape.below(20));
    let made = match tape.below(5) {
        0 => Knots::uniform(n, degree),
        1 => Knots::clamped(n, degree),
        2 => Knots::from_data(&tape.increasing(n), degree),
        3 => Knots::periodic(&tape.increasing(n), degree),
        _ => Knots::new(tape.increasing(n), degree),
    };
    let Ok(knots) = made else { return };
    let (start, end) = knots.domain();
    assert!(start < end && knots.values().iter().all(|t| t.is_finite()), "{knots:?}");
    assert!(knots.values().windows(2).all(|pair| pair[0] <= pair[1]), "{knots:?}");
    let u = f64::from(tape.byte()) / 255.0;
    for t in knots.breaks().into_iter().chain([start, end, start * (1.0 - u) + end * u]) {
        for side in [Side::Left, Side::Right] {
            let span = knots.span(&t, side);
            assert!(knots.degree() <= span && span < knots.functions(), "span {span} of {knots:?}");
            let values = values(&knots, span, &t);
            let sum: f64 = values.iter().sum();
            assert!(values.iter().all(|x| *x >= 0.0 && *x <= 1.0 + 1e-9), "{values:?} at {t:?} of {knots:?}");
            assert!((sum - 1.0).abs() < 1e-9, "{values:?} at {t:?} of {knots:?}");
        }
    }
    let points = tape.rows::<D>(knots.functions());
    if let Ok(curve) = BSpline::new(knots, points) {
        ask_counted(curve, tape);
    }
}
