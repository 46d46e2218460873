//! Rows 38 to 43: points that coincide, data out of order, curves that halt and turn back.

use crate::{near, refused};
use lath::curve::{Bezier, Curve, Polyline};
use lath::error::Limits;
use lath::interpolate::{
    End, Ends, Parameters, akima, bspline_over, cubic, cubic_closed, makima, parameters, pchip, steffen,
};
use lath::knot::{Knots, Side};
use lath::num::Bound;
use lath::query::{bounds, curvature, length, signed_curvature};
use lath::tessellate::flatten;

const FREE: Ends<2> = Ends::Open(End::NotAKnot, End::NotAKnot);

fn length_of<const D: usize>(curve: &dyn Curve<D>) -> f64 {
    length(curve, 1e-9, &Limits::default()).unwrap().0
}

#[test]
fn row_38_neighbours_that_coincide() {
    let points = [[0.0, 0.0], [1.0, 1.0], [1.0, 1.0], [2.0, 0.0]];
    for rule in [Parameters::Chord, Parameters::Centripetal] {
        let error = refused(parameters(&points, false, rule), "P004", 2);
        assert!(error.message().contains("points 1 and 2 are the same"), "{error}");
        refused(parameters(&[[0.0], [1.0], [0.0]], true, rule), "P004", 0);
    }
    // So close that the sum does not grow.
    refused(parameters(&[[0.0, 0.0], [1e10, 0.0], [1e10, 1e-7]], false, Parameters::Chord), "P004", 2);
    // Where the parameters do not depend on them they are no fault.
    let t = parameters(&points, false, Parameters::Uniform).unwrap();
    let curve = cubic(points, t, &FREE).unwrap();
    assert_eq!([1.0, 2.0].map(|t| curve.eval(t).unwrap()), [[1.0, 1.0]; 2]);
}

#[test]
fn row_39_all_points_identical() {
    let point = [3.0, 4.0];
    refused(parameters(&[point; 4], false, Parameters::Chord), "P004", 1);
    let t = || vec![0.0, 1.0, 2.0, 3.0];
    let curves: [Box<dyn Curve<2>>; 7] = [
        Box::new(Bezier::new([point; 4]).unwrap()),
        Box::new(Polyline::new([point; 4]).unwrap()),
        Box::new(cubic([point; 4], t(), &FREE).unwrap()),
        Box::new(pchip([point; 4], t(), false).unwrap()),
        Box::new(steffen([point; 4], t(), false).unwrap()),
        Box::new(akima([point; 4], t(), false).unwrap()),
        Box::new(makima([point; 4], t(), false).unwrap()),
    ];
    for curve in &curves {
        let jet = curve.jet(0.75, 1).unwrap();
        assert_eq!(jet[1], [0.0, 0.0], "{}", curve.kind());
        near(jet[0][0], 3.0, 12.0, 3.0);
        assert!(length_of(&**curve) <= 1e-14);
        assert_eq!(curvature(&**curve, 0.75, Side::Right), None);
        assert_eq!(signed_curvature(&**curve, 0.75, Side::Right), None);
        let (found, bound) = bounds(&**curve);
        assert!(found.hi[0] - found.lo[0] <= 1e-12 && bound.value() <= 1e-12);
    }
}

#[test]
fn row_40_two_values_at_one_parameter() {
    let points = [[0.0], [1.0], [2.0], [3.0]];
    let t = || vec![0.0, 1.0, 1.0, 2.0];
    let error = refused(cubic(points, t(), &Ends::Open(End::Natural, End::Natural)), "T003", 2);
    assert!(error.message().contains("parameter 2 is 1, not above 1"), "{error}");
    refused(pchip(points, t(), false), "T003", 2);
    refused(akima(points, t(), false), "T003", 2);
    refused(steffen(points, t(), false), "T003", 2);
    refused(parameters(&points, false, Parameters::Given(&t())), "T003", 2);
    refused(Knots::from_data(&t(), 3), "T003", 2);
    refused(cubic_closed(points, vec![0.0, 1.0, 2.0, 3.0, 3.0]), "T003", 4);
}

#[test]
fn row_41_parameters_out_of_order() {
    let points = [[0.0], [1.0], [2.0], [3.0]];
    let t = || vec![0.0, 2.0, 1.0, 3.0];
    let error = refused(cubic(points, t(), &Ends::Open(End::Natural, End::Natural)), "T003", 2);
    assert!(error.remedy().contains("Sort"), "{error}");
    refused(makima(points, t(), false), "T003", 2);
    refused(parameters(&points, false, Parameters::Given(&t())), "T003", 2);
    refused(Knots::from_data(&t(), 2), "T003", 2);
    let knots = Knots::clamped(4, 3).unwrap();
    assert!(bspline_over(points, &[0.0, 0.7, 0.3, 1.0], knots).unwrap_err().is_parameter());
}

#[test]
fn row_42_control_points_that_coincide_at_an_end() {
    let diagonal = |equal: usize| {
        let point = |i: usize| if i < equal { [0.0, 0.0] } else { [1.0, 1.0] };
        Bezier::new((0..4).map(point)).unwrap()
    };
    for (equal, half) in [(1, 0.875), (2, 0.5), (3, 0.125)] {
        let curve = diagonal(equal);
        assert_eq!(curve.eval(0.5).unwrap(), [half; 2]);
        near(length_of(&curve), 2_f64.sqrt(), 1e8, 1.0);
        // The first derivative that does not vanish says where it starts: C(3, k) k! (1, 1).
        let jet = curve.jet(0.0, 3).unwrap();
        assert!(jet[1..equal].iter().all(|d| *d == [0.0; 2]), "{jet:?}");
        assert_eq!(jet[equal], [[3.0; 2], [6.0; 2], [6.0; 2]][equal - 1]);
        let bend = curvature(&curve, 0.0, Side::Right);
        assert!(if equal == 1 { bend.is_some_and(|k| k < 1e-15) } else { bend.is_none() }, "{bend:?}");
        let mut points = Vec::new();
        let bound = flatten(&curve, 1e-3, &Limits::default(), &mut |_, p| points.push(p)).unwrap();
        assert!(matches!(bound, Bound::Proven(d) if d <= 1e-3));
        assert!(points.iter().flatten().all(|x| (0.0..=1.0).contains(x)));
    }
}

#[test]
fn row_43_cusps_and_curves_that_double_back() {
    // A cusp at t = ½: the tangent vanishes there and nowhere else.
    let cusp = Bezier::new([[0.0, 0.0], [1.0, 1.0], [0.0, 1.0], [1.0, 0.0]]).unwrap();
    assert_eq!(cusp.jet(0.5, 1).unwrap(), [[0.5, 0.75], [0.0, 0.0]]);
    assert_eq!(curvature(&cusp, 0.5, Side::Right), None);
    assert!(curvature(&cusp, 0.25, Side::Right).is_some_and(f64::is_finite));
    // 2t(1−t): out to ½ and back.
    let back = Bezier::new([[0.0, 0.0], [1.0, 0.0], [0.0, 0.0]]).unwrap();
    near(length_of(&back), 1.0, 1e8, 1.0);
    let (found, bound) = bounds(&back);
    assert!(found.hi[0] >= 0.5 && found.hi[0] - 0.5 <= bound.value() && bound.value() < 1e-11);
    // A straight stretch bends nowhere.
    let line = Bezier::new([[0.0, 0.0], [1.0, 2.0], [2.0, 4.0], [3.0, 6.0]]).unwrap();
    for t in [0.0, 0.3, 1.0] {
        assert!(signed_curvature(&line, t, Side::Right).is_some_and(|k| k.abs() < 1e-15));
        assert!(curvature(&line, t, Side::Right).is_some_and(|k| k < 1e-15));
    }
    for curve in [&cusp as &dyn Curve<2>, &back, &line] {
        let mut count = 0;
        let bound = flatten(curve, 1e-6, &Limits::default(), &mut |_, _| count += 1).unwrap();
        assert!(bound.is_proven() && bound.value() <= 1e-6 && (2..5000).contains(&count));
    }
}
