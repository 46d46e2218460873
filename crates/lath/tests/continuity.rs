//! Continuity of computed splines: what the theory says is found in spite of the rounding.

use lath::curve::{Curve, Interval};
use lath::interpolate::{End, Ends, cubic};
use lath::query::{Continuity, continuity};

#[test]
fn a_cubic_spline_far_from_the_origin_is_c2_and_smooth_where_there_is_no_knot() {
    let t = vec![0.0, 1.0, 2.0, 3.5, 4.0];
    let points = [[1e7], [1e7 + 1e-3], [1e7], [1e7 + 2e-3], [1e7 + 1e-3]];
    let curve = cubic(points, t, &Ends::Open(End::NotAKnot, End::Natural)).unwrap();
    let found: Vec<Continuity> = continuity(&curve).into_iter().map(|(_, order)| order).collect();
    assert!(found[0] >= Continuity::Order(2) && found[1] >= Continuity::Order(2), "{found:?}");
    assert_eq!(curve.domain(), Interval { start: 0.0, end: 4.0 });
}

#[test]
fn a_sine_sampled_coarsely_is_c2_at_every_knot_and_no_more() {
    let t: Vec<f64> = (0..20).map(f64::from).collect();
    let points: Vec<[f64; 1]> = t.iter().map(|t| [libm::sin(*t)]).collect();
    let curve = cubic(points, t, &Ends::Open(End::NotAKnot, End::NotAKnot)).unwrap();
    let found: Vec<Continuity> = continuity(&curve).into_iter().map(|(_, order)| order).collect();
    assert_eq!((found[0], found[17]), (Continuity::Smooth, Continuity::Smooth));
    assert!(found[1..17].iter().all(|order| *order == Continuity::Order(2)), "{found:?}");
}
