//! Curves through points, with every rule, every end and every choice of parameters.

use crate::questions::ask;
use crate::tape::Tape;
use lath::curve::{Curve, Hermite};
use lath::interpolate::{
    BSplineEnd, End, Ends, Parameters, Tcb, akima, bspline, bspline_closed, bspline_over, cardinal, cubic,
    cubic_closed, kochanek_bartels, makima, parameters, pchip, steffen,
};
use lath::knot::Knots;

/// Makes one, and asks it.
pub fn interpolate<const D: usize>(tape: &mut Tape<'_>) {
    let (rule, closed, n) = (tape.below(12), tape.flip(), tape.below(10));
    let points = tape.rows::<D>(n);
    let given;
    let choice = match tape.below(6) {
        0 => Parameters::Uniform,
        1 => Parameters::Chord,
        2 => Parameters::Centripetal,
        _ => {
            given = tape.increasing(n + usize::from(closed));
            Parameters::Given(&given)
        }
    };
    let Ok(t) = parameters(&points, closed, choice) else { return };
    assert!(t.windows(2).all(|pair| pair[0] < pair[1]) && t.iter().all(|t| t.is_finite()), "{t:?}");
    let made = match rule {
        0 | 1 if closed => cubic_closed(points.clone(), t),
        0 | 1 => cubic(points.clone(), t, &ends(tape)),
        2 => cardinal(points.clone(), t, closed, tape.float()),
        3 => pchip(points.clone(), t, closed),
        4 => steffen(points.clone(), t, closed),
        5 => akima(points.clone(), t, closed),
        6 => makima(points.clone(), t, closed),
        7 => {
            let tcb = Tcb { tension: tape.float(), continuity: tape.float(), bias: tape.float() };
            return kochanek_bartels(points, t, closed, tcb).iter().for_each(|curve| ask(curve, tape));
        }
        8 if !closed => {
            let degree = tape.below(6);
            let Ok(knots) = Knots::from_data(&t, degree) else { return };
            return bspline_over(points, &t, knots).iter().for_each(|curve| ask(curve, tape));
        }
        9 if !closed => {
            let knots = Knots::new(tape.increasing(n + 4), 3);
            let Ok(knots) = knots else { return };
            return bspline_over(points, &t, knots).iter().for_each(|curve| ask(curve, tape));
        }
        _ if closed => {
            let degree = tape.below(9);
            return bspline_closed(points, t, degree).iter().for_each(|curve| ask(curve, tape));
        }
        _ => {
            let degree = tape.below(10);
            let (start, end) = (bspline_end(tape, degree), bspline_end(tape, degree));
            return bspline(points, t, degree, &start, &end).iter().for_each(|curve| ask(curve, tape));
        }
    };
    if let Ok(curve) = made {
        passes(&curve, &points);
        ask(&curve, tape);
    }
}

/// An Hermite curve takes its data for values, to the bit; −0.0 and 0.0 are the same.
fn passes<const D: usize>(curve: &Hermite<D>, points: &[[f64; D]]) {
    assert_eq!(curve.points(), points);
    for (t, point) in curve.parameters().iter().zip(points) {
        if let Ok(found) = curve.eval(*t) {
            assert_eq!(found, *point, "at {t:?}");
        }
    }
}

fn ends<const D: usize>(tape: &mut Tape<'_>) -> Ends<D> {
    let mut end = || match tape.below(6) {
        0 => None,
        1 | 2 => Some(End::Natural),
        3 => Some(End::Clamped(std::array::from_fn(|_| tape.float()))),
        4 => Some(End::Second(std::array::from_fn(|_| tape.float()))),
        _ => Some(End::NotAKnot),
    };
    match (end(), end()) {
        (Some(start), Some(end)) => Ends::Open(start, end),
        (None, _) => Ends::Cyclic,
        (Some(_), None) => Ends::Anticyclic,
    }
}

fn bspline_end<const D: usize>(tape: &mut Tape<'_>, degree: usize) -> BSplineEnd<D> {
    match tape.below(3) {
        0 => BSplineEnd::NotAKnot,
        1 => BSplineEnd::Natural,
        _ => {
            let count = if tape.below(8) == 0 { tape.below(5) } else { degree / 2 };
            let mut order = 0;
            let row = |tape: &mut Tape<'_>| {
                order += 1 + tape.below(4) / 3;
                (order, std::array::from_fn(|_| tape.float()))
            };
            let mut row = row;
            BSplineEnd::Derivatives((0..count).map(|_| row(tape)).collect())
        }
    }
}
