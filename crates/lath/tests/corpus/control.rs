//! Curves from control points over uniform knots: tension, and the ends of the polygon.

use crate::refused;
use lath::curve::{Curve, PolygonEnd, UniformBSpline};
use lath::error::Result;
use lath::knot::Side;
use testkit::corpus::{Entry, load};
use testkit::error_measure::units;
use testkit::rational::Rational;

fn build<const D: usize>(case: &Entry) -> Result<Box<dyn Curve<D>>> {
    let points: Vec<[f64; D]> = case.float_rows("points").iter().map(|row| row[..].try_into().unwrap()).collect();
    let degree = case.count("degree");
    let curve = match case.text_if("at-polygon") {
        Some("repeat") => UniformBSpline::at_polygon(degree, points, PolygonEnd::Repeat)?,
        Some("phantom") => UniformBSpline::at_polygon(degree, points, PolygonEnd::Phantom)?,
        Some(other) => panic!("{}: no end {other}", case.place),
        None if case.flag("closed") => UniformBSpline::closed(degree, points)?,
        None => UniformBSpline::new(degree, points)?,
    };
    if !case.has("tension") {
        return Ok(Box::new(curve));
    }
    Ok(match case.floats("tension")[..] {
        [tension] => Box::new(curve.with_tension(tension)?),
        ref tensions => Box::new(curve.with_tensions(tensions)?),
    })
}

fn replay<const D: usize>(case: &Entry) -> usize {
    let Some(curve) = refused(case, build::<D>(case)) else {
        return 0;
    };
    let domain = curve.domain();
    assert_eq!(case.floats("domain"), [domain.start, domain.end], "{}", case.place);
    assert_eq!(curve.is_closed(), case.flag("closed"), "{}", case.place);
    let size = case.float_rows("points").iter().flatten().fold(1.0, |most: f64, x| most.max(x.abs()));
    let degree = curve.degree() as f64;
    let mut compared = 0;
    for at in case.entries("at") {
        let side = if at.text_if("side") == Some("left") { Side::Left } else { Side::Right };
        let keys: Vec<String> = (1..).map(|k| format!("d{k}")).take_while(|key| at.has(key)).collect();
        let mut out = vec![[0.0; D]; keys.len() + 1];
        curve.jet_into(at.float("t"), side, &mut out);
        // The unit spans amplify a derivative by 2p at most; mirrored points are twice as far away.
        let mut condition = Rational::from_f64(3.0 * size);
        for (found, key) in out.iter().zip(std::iter::once("value").chain(keys.iter().map(String::as_str))) {
            for (found, exact) in found.iter().zip(at.numbers(key)) {
                let off = units(*found, &exact, &condition);
                assert!(off <= 10.0 * degree, "{}: {key} at {} is {found}, not {exact}", case.place, at.float("t"));
                compared += 1;
            }
            condition = condition * Rational::from_f64(2.0 * degree);
        }
    }
    compared
}

#[test]
fn curves_from_control_points_answer_their_cases() {
    let mut compared = 0;
    for case in load("control") {
        compared += match case.rows("points")[0].len() {
            1 => replay::<1>(&case),
            2 => replay::<2>(&case),
            3 => replay::<3>(&case),
            other => panic!("{}: {other} dimensions", case.place),
        };
    }
    assert!(compared > 600, "{compared}");
}
