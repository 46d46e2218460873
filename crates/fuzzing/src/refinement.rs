//! The same curve in another description.

use crate::questions::ask;
use crate::small;
use crate::tape::Tape;
use lath::curve::{BSpline, Curve, Interval, Nurbs};
use lath::refine::{to_beziers, to_bspline, to_hermite, to_power};

/// Steps one after another: more would only be longer.
const STEPS: usize = 4;

/// A B-spline through a few operations, each of which answers with a curve or refuses.
pub fn refine<const D: usize>(tape: &mut Tape<'_>) {
    let Some(mut curve) = spline::<D>(tape) else { return };
    for _ in 0..STEPS {
        let domain = curve.domain();
        let made = match tape.below(20) {
            0 => {
                let n = tape.below(4);
                same(&curve, curve.insert_knots(&(0..n).map(|_| inside(tape, domain)).collect::<Vec<_>>()))
            }
            1 => same(&curve, curve.refine_uniformly(tape.below(4), &small())),
            2 => same(&curve, curve.elevate(tape.below(4))),
            3 => curve.remove_knots(tape.float()).map(|(curve, _)| curve),
            4 => {
                let tolerance = if tape.flip() { Some(tape.float()) } else { None };
                curve.reduce(tape.below(4), tolerance).map(|(curve, _)| curve)
            }
            5 => curve.split(inside(tape, domain)).map(|(_, right)| right),
            6 => curve.trim(Interval { start: inside(tape, domain), end: inside(tape, domain) }),
            7 => curve.clamp(),
            8 => curve.reparametrise(Interval { start: tape.float(), end: tape.float() }),
            9 => curve.reverse(),
            10 => curve.move_seam(inside(tape, domain)),
            11 => curve.derivative(),
            12 => curve.antiderivative(),
            13 => spline::<D>(tape).map_or_else(|| curve.clamp(), |other| curve.sum(&other)),
            14 => spline::<1>(tape).map_or_else(|| curve.clamp(), |other| curve.product(&other)),
            15 => spline::<D>(tape)
                .map_or_else(|| curve.clamp(), |other| curve.join(&other, tape.float()).map(|(joined, _)| joined)),
            16 => curve.close(tape.float()).map(|(curve, _)| curve),
            17 => curve.to_beziers().and_then(|pieces| BSpline::from_beziers(&pieces)),
            18 => {
                if let Ok(area) = curve.integral(inside(tape, domain), inside(tape, domain)) {
                    assert!(area.iter().all(|x| x.is_finite()), "{area:?}");
                }
                curve.reverse()
            }
            _ => spline::<D>(tape).map_or_else(
                || curve.clamp(),
                |other| BSpline::make_compatible(&[curve.clone(), other]).map(|mut both| both.swap_remove(0)),
            ),
        };
        if let Ok(made) = made {
            curve = made;
        }
    }
    finite(curve.control_points());
    let forms: [lath::error::Result<Box<dyn Curve<D>>>; 3] = [
        to_bspline(&curve).map(|curve| Box::new(curve) as Box<dyn Curve<D>>),
        to_power(&curve).map(|curve| Box::new(curve) as Box<dyn Curve<D>>),
        to_hermite(&curve, tape.float()).map(|(curve, _)| Box::new(curve) as Box<dyn Curve<D>>),
    ];
    let _ = to_beziers(&curve);
    forms.iter().flatten().for_each(|form| ask(&**form, tape));
    ask(&curve, tape);
}

/// The same for a rational one.
pub fn refine_rational<const D: usize>(tape: &mut Tape<'_>) {
    let Some(curve) = spline::<D>(tape) else { return };
    let weights = tape.weights(curve.control_points().len());
    let Ok(mut curve) = curve.weighted(weights) else { return };
    for _ in 0..STEPS {
        let domain = curve.domain();
        let made = match tape.below(13) {
            0 => {
                let n = tape.below(4);
                curve.insert_knots(&(0..n).map(|_| inside(tape, domain)).collect::<Vec<_>>())
            }
            1 => curve.refine_uniformly(tape.below(4), &small()),
            2 => curve.elevate(tape.below(4)),
            3 => curve.remove_knots(tape.float()).map(|(curve, _)| curve),
            4 => curve.reduce(tape.below(4), Some(tape.float())).map(|(curve, _)| curve),
            5 => curve.split(inside(tape, domain)).map(|(left, _)| left),
            6 => curve.trim(Interval { start: inside(tape, domain), end: inside(tape, domain) }),
            7 => curve.clamp(),
            8 => curve.reparametrise(Interval { start: tape.float(), end: tape.float() }),
            9 => curve.reverse(),
            10 => curve.move_seam(inside(tape, domain)),
            11 => curve.close(tape.float()).map(|(curve, _)| curve),
            _ => Nurbs::make_compatible(&[curve.clone(), curve.clone()]).map(|mut both| both.swap_remove(1)),
        };
        if let Ok(made) = made {
            curve = made;
        }
    }
    finite(curve.control_points());
    if let Ok(pieces) = curve.to_beziers() {
        pieces.iter().for_each(|piece| finite(piece.control_points()));
    }
    ask(&curve, tape);
}

fn spline<const D: usize>(tape: &mut Tape<'_>) -> Option<BSpline<D>> {
    let (degree, n) = (tape.below(6), tape.below(9));
    match tape.below(5) {
        0 => BSpline::closed(&tape.increasing(n + 1), degree, tape.rows::<D>(n)),
        1 => BSpline::closed_uniform(degree, tape.rows::<D>(n)),
        2 => BSpline::clamped(degree, tape.rows::<D>(n)),
        _ => BSpline::over(tape.increasing(n + degree + 1), degree, tape.rows::<D>(n)),
    }
    .ok()
}

/// A parameter of the domain, or any number.
fn inside(tape: &mut Tape<'_>, domain: Interval) -> f64 {
    match tape.byte() {
        sort @ 0..=240 => {
            let u = f64::from(sort) / 240.0;
            domain.start * (1.0 - u) + domain.end * u
        }
        _ => tape.float(),
    }
}

fn finite<const D: usize>(points: &[[f64; D]]) {
    assert!(points.as_flattened().iter().all(|x| x.is_finite()), "{points:?}");
}

/// What only describes the curve anew keeps its domain, and its ends.
fn same<const D: usize>(old: &BSpline<D>, made: lath::error::Result<BSpline<D>>) -> lath::error::Result<BSpline<D>> {
    if let Ok(new) = &made {
        assert_eq!(new.domain(), old.domain());
    }
    made
}
