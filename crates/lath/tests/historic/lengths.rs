//! Lengths and polylines that missed their tolerance.

use crate::near;
use lath::curve::{Bezier, Curve};
use lath::error::Limits;
use lath::query::{bounds, length};
use lath::tessellate::flatten;

fn length_of<const D: usize>(curve: &dyn Curve<D>, accuracy: f64) -> f64 {
    let (found, bound) = length(curve, accuracy, &Limits::default()).unwrap();
    assert!(bound.is_proven() && bound.value() <= accuracy, "{bound:?}");
    found
}

/// The length of y = s x² on [−1, 1]: √(1 + 4s²) + asinh(2s)/(2s).
fn parabola(s: f64) -> f64 {
    (1.0 + 4.0 * s * s).sqrt() + libm::asinh(2.0 * s) / (2.0 * s)
}

/// A curve's polyline.
fn polyline(curve: &dyn Curve<2>, tolerance: f64) -> Vec<[f64; 2]> {
    let mut points = Vec::new();
    flatten(curve, tolerance, &Limits::default(), &mut |_, point| points.push(point)).unwrap();
    points
}

/// bezier-rs 0.5.0: the length of a strongly bent curve was given up after eight halvings, its tolerance missed without a word. The
/// accuracy is kept, or the bound says otherwise: y = 1000x² has a closed form.
#[test]
fn bezier_rs_length_missed_its_tolerance() {
    let steep = Bezier::new([[-1.0, 1000.0], [0.0, -1000.0], [1.0, 1000.0]]).unwrap();
    for accuracy in [1.0, 1e-3, 1e-6] {
        assert!((length_of(&steep, accuracy) - parabola(1000.0)).abs() <= accuracy + 1e-9);
    }
    // Too little work allowed: the bound still holds.
    let few = Limits { max_points: 20, ..Limits::default() };
    let (found, bound) = length(&steep, 1e-9, &few).unwrap();
    assert!(bound.value() > 1e-9 && (found - parabola(1000.0)).abs() <= bound.value(), "{found} {bound:?}");
}

/// Splipy 188: strongly bent cubics were off by more than a tenth. A parabola raised to degree 3 is still as long as it was.
#[test]
fn splipy_188_length_of_bent_cubics() {
    for s in [1.0, 3.0, 30.0] {
        let cubic = Bezier::new([[-1.0, s], [-1.0 / 3.0, -s / 3.0], [1.0 / 3.0, -s / 3.0], [1.0, s]]).unwrap();
        assert!((length_of(&cubic, 1e-7) - parabola(s)).abs() <= 2e-7, "{s}");
    }
}

/// Godot 62301: a straight line of length 5000 measured 5415. Straight is straight, wherever the inner control points lie on it.
#[test]
fn godot_62301_a_straight_line_of_5000() {
    for handles in [[0.0, 5000.0], [1000.0, 1200.0], [4000.0, 4999.0]] {
        let line = Bezier::new([0.0, handles[0], handles[1], 5000.0].map(|x| [x, 0.0, 0.0])).unwrap();
        near(length_of(&line, 1e-9), 5000.0, 5000.0);
    }
}

/// flo_curves 0.8.1: a squared difference of lengths was compared with a length, so that the result hung on the unit. Here a scale of 2ᵏ
/// changes no bit but the exponent.
#[test]
fn flo_curves_length_depended_on_the_scale() {
    let points = [[0.0, 0.0], [1.0, 3.0], [4.0, -2.0], [5.0, 1.0]];
    let plain = length_of(&Bezier::new(points).unwrap(), 1e-6);
    for exponent in [-40, -10, 10, 40] {
        let scale = libm::ldexp(1.0, exponent);
        let scaled = Bezier::new(points.map(|p| p.map(|x| x * scale))).unwrap();
        assert_eq!(length_of(&scaled, 1e-6 * scale), plain * scale);
    }
}

/// lyon_geom 1.0.20 and truck-geometry 0.5.0: absolute thresholds, so that the same shape in metres and in micrometres gave different
/// answers. Tolerances scale with the curve, and so do polyline and box, to the bit.
#[test]
fn lyon_geom_and_truck_depended_on_the_unit() {
    let points = [[0.0, 0.0], [1.0, 3.0], [4.0, -2.0], [5.0, 1.0]];
    let plain = polyline(&Bezier::new(points).unwrap(), 1e-3);
    for exponent in [-30, 30] {
        let scale = libm::ldexp(1.0, exponent);
        let scaled = Bezier::new(points.map(|p| p.map(|x| x * scale))).unwrap();
        let expected: Vec<[f64; 2]> = plain.iter().map(|p| p.map(|x| x * scale)).collect();
        assert_eq!(polyline(&scaled, 1e-3 * scale), expected);
        assert_eq!(bounds(&scaled).0.hi[1], bounds(&Bezier::new(points).unwrap()).0.hi[1] * scale);
    }
}

/// kurbo 426: a flat cubic with cusps was flattened wrongly. 0, 3, −2, 1 on a line goes to 1 at t = ¼, back to 0 at ¾ and to 1: its length
/// is 3, and the polyline sees both turns.
#[test]
fn kurbo_426_a_flat_cubic_with_cusps() {
    let flat = Bezier::new([[0.0, 0.0], [3.0, 0.0], [-2.0, 0.0], [1.0, 0.0]]).unwrap();
    assert_eq!([0.25, 0.75].map(|t| flat.eval(t).unwrap()[0]), [1.0, 0.0]);
    assert!((length_of(&flat, 1e-9) - 3.0).abs() <= 1e-9);
    for tolerance in [0.1, 1e-3, 1e-6] {
        let points = polyline(&flat, tolerance);
        let turns: f64 = points.windows(2).map(|side| (side[1][0] - side[0][0]).abs()).sum();
        assert!(turns <= 3.0 + 1e-12 && turns >= 3.0 - 4.0 * tolerance, "{turns}");
    }
    let (found, bound) = bounds(&flat);
    assert!(found.lo[0] <= 0.0 && found.lo[0] >= -bound.value() && found.hi[0] - 1.0 <= bound.value());
}

/// lyon 19, 110, 194 and 547: polylines left their tolerance near inflections, cusps and on flat curves. At every parameter the curve is
/// within the tolerance of some side, measured apart from how the polyline was made.
#[test]
fn lyon_194_flattening_near_inflections() {
    let shapes = [
        [[0.0, 0.0], [1.0, 1.0], [2.0, -1.0], [3.0, 0.0]],
        [[0.0, 0.0], [1.0, 1.0], [0.0, 1.0], [1.0, 0.0]],
        [[0.0, 0.0], [10.0, 0.01], [-9.0, 0.01], [1.0, 0.0]],
        [[0.0, 0.0], [0.0, 0.0], [5.0, 1.0], [0.0, 0.1]],
    ];
    for curve in shapes.map(|points| Bezier::new(points).unwrap()) {
        for tolerance in [0.1, 1e-3] {
            let points = polyline(&curve, tolerance);
            for k in 0..=200 {
                let p = curve.eval(f64::from(k) / 200.0).unwrap();
                let away = points.windows(2).map(|side| distance_to_side(p, side)).fold(f64::INFINITY, f64::min);
                assert!(away <= tolerance * (1.0 + 1e-12), "{away} at {k}: {curve:?}");
            }
        }
    }
}

fn distance_to_side(p: [f64; 2], side: &[[f64; 2]]) -> f64 {
    let (a, b) = (side[0], side[1]);
    let d = [b[0] - a[0], b[1] - a[1]];
    let square = d[0] * d[0] + d[1] * d[1];
    let along = if square > 0.0 { ((p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1]) / square } else { 0.0 };
    let u = along.clamp(0.0, 1.0);
    lath::space::distance(&p, &[a[0] + u * d[0], a[1] + u * d[1]])
}
