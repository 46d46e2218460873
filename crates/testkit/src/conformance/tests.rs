//! Laws that cannot be broken prove nothing: a sound curve with one fault at a time.

use super::*;
use lath::curve::{Bezier, BezierPiece, Curve, Interval};
use lath::knot::Side;
use proptest::strategy::ValueTree;

#[derive(Clone, Copy, Debug, PartialEq)]
enum Fault {
    None,
    Slope,
    Value,
    Break,
    Domain,
    Pieces,
    Gap,
    Invariance,
}

/// A parabola in the plane, with a fault.
#[derive(Debug)]
struct Faulty {
    sound: Bezier<2>,
    fault: Fault,
}

impl Curve<2> for Faulty {
    fn kind(&self) -> &'static str {
        "faulty"
    }
    fn degree(&self) -> usize {
        self.sound.degree()
    }
    fn domain(&self) -> Interval {
        self.sound.domain()
    }
    fn breaks(&self) -> Vec<f64> {
        let Interval { start, end } = self.domain();
        if self.fault == Fault::Domain { vec![start, 0.5 * (start + end)] } else { vec![start, end] }
    }
    fn jet_into(&self, t: f64, side: Side, out: &mut [[f64; 2]]) {
        self.sound.jet_into(t, side, out);
        match self.fault {
            Fault::Slope if out.len() > 1 => out[1][0] *= 1.01,
            Fault::Value => out[0][1] += 1e-9,
            Fault::Break if t == self.domain().end => out[0][1] += 1e-9,
            Fault::Invariance => out[0][0] += 0.01 * out[0][0] * out[0][0],
            _ => {}
        }
    }
    fn bezier_pieces(&self, visit: &mut dyn FnMut(BezierPiece<'_, 2>)) -> bool {
        if self.fault == Fault::Invariance {
            return false; // then nothing but the map itself can show it
        }
        self.sound.bezier_pieces(&mut |piece| {
            let mut points = piece.points.to_vec();
            if self.fault == Fault::Pieces {
                points[1][0] += 1e-6;
            }
            let end = if self.fault == Fault::Gap { 0.5 * (piece.start + piece.end) } else { piece.end };
            visit(BezierPiece { start: piece.start, end, points: &points });
        })
    }
}

fn definition() -> Definition<2> {
    let points = vec![[0.0, 1.0], [2.0, 5.0], [4.0, -1.0]];
    Definition { degree: 2, numbers: vec![1.0, 3.0], points, ..Definition::default() }
}

fn build(definition: &Definition<2>, fault: Fault) -> Faulty {
    let domain = Interval { start: definition.numbers[0], end: definition.numbers[1] };
    Faulty { sound: Bezier::on(&definition.points, domain).unwrap(), fault }
}

/// The laws that a fault breaks.
fn broken(fault: Fault) -> Vec<&'static str> {
    type Check = fn(&Definition<2>, &dyn Curve<2>) -> Law;
    let all: [(&str, Check); 9] = [
        ("domain", laws::any_domain_is_kept),
        ("answered", laws::any_parameter_is_answered_or_refused),
        ("sides", laws::any_side_of_a_break_is_its_piece),
        ("pieces", laws::any_piece_is_the_curve),
        ("box", laws::any_box_holds_the_curve),
        ("hull", laws::any_hull_holds_the_curve),
        ("derivatives", laws::derivatives_are_derivatives),
        ("outside", laws::outside_follows_the_policy),
        ("flattening", laws::flattening_stays_within_tolerance),
    ];
    let curve = build(&definition(), fault);
    all.into_iter().filter(|(_, law)| law(&definition(), &curve).is_err()).map(|(name, _)| name).collect()
}

#[test]
fn a_sound_curve_keeps_every_law() {
    assert_eq!(broken(Fault::None), [""; 0]);
}

#[test]
fn every_fault_breaks_a_law() {
    for (fault, law) in [
        (Fault::Slope, "derivatives"),
        (Fault::Slope, "outside"),
        (Fault::Value, "pieces"),
        (Fault::Break, "sides"),
        (Fault::Domain, "domain"),
        (Fault::Pieces, "pieces"),
        (Fault::Gap, "pieces"),
    ] {
        assert!(broken(fault).contains(&law), "{fault:?} breaks {:?}", broken(fault));
    }
}

#[test]
fn pieces_of_another_size_are_noticed() {
    /// A curve so many times as large as its pieces say.
    #[derive(Debug)]
    struct Scaled(Bezier<2>, f64);
    impl Curve<2> for Scaled {
        fn kind(&self) -> &'static str {
            "scaled"
        }
        fn degree(&self) -> usize {
            2
        }
        fn domain(&self) -> Interval {
            self.0.domain()
        }
        fn jet_into(&self, t: f64, side: Side, out: &mut [[f64; 2]]) {
            self.0.jet_into(t, side, out);
            out[0] = out[0].map(|x| self.1 * x);
        }
        fn bezier_pieces(&self, visit: &mut dyn FnMut(BezierPiece<'_, 2>)) -> bool {
            self.0.bezier_pieces(visit)
        }
    }
    let scaled = |factor| Scaled(Bezier::new(&definition().points).unwrap(), factor);
    assert!(laws::any_box_holds_the_curve(&definition(), &scaled(3.0)).is_err());
    assert!(laws::any_hull_holds_the_curve(&definition(), &scaled(3.0)).is_err());
    assert!(laws::flattening_stays_within_tolerance(&definition(), &scaled(3.0)).is_err());
    assert!(laws::box_is_tight(&definition(), &scaled(0.25)).is_err());
}

#[test]
fn a_group_declared_too_large_is_noticed() {
    let strategy = (strategies::control_points::<2>(3..6), laws::maps::<2>(Invariance::Affine));
    let mut faults = 0;
    let mut runner = runner();
    for _ in 0..32 {
        let (mut drawn, map) = strategy.new_tree(&mut runner).unwrap().current();
        drawn.numbers = vec![0.0, 1.0];
        faults += usize::from(laws::invariance(&drawn, &map, |d| build(d, Fault::Invariance)).is_err());
    }
    assert!(faults > 24, "{faults}");
}

#[test]
#[should_panic(expected = "declare the larger group")]
fn a_group_declared_too_small_is_noticed() {
    let strategy = strategies::control_points::<2>(3..6);
    laws::invariance_ends(strategy, Invariance::PerAxis, |d| Bezier::new(&d.points).unwrap());
}

#[test]
fn a_reversal_that_is_none_is_noticed() {
    let sound = build(&definition(), Fault::None);
    assert!(laws::reversal(&definition(), &sound, &sound).is_err());
}
