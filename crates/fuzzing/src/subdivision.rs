//! Subdivision schemes, their levels in every way there is, and spheres.

use crate::questions::ask;
use crate::small;
use crate::tape::Tape;
use lath::error::Code;
use lath::subdivide::{Ends, Index, Scheme, Sphere, Subdivision, Target};
use std::ops::ControlFlow;

/// Makes a polygon under a scheme, and asks it.
pub fn subdivide<const D: usize>(tape: &mut Tape<'_>) {
    let ends = [Ends::Open, Ends::Kept, Ends::Closed][tape.below(3)];
    let (kind, degree, n) = (tape.below(8), tape.below(12), tape.below(10));
    let made = match kind {
        0 => Ok(Scheme::chaikin()),
        1 => Ok(Scheme::cubic()),
        2 => Scheme::lane_riesenfeld(degree),
        3 => Scheme::four_point(&tape.float()),
        4 => return sphere::<D>(tape, ends, degree, n),
        _ => Scheme::from_mask(mask(tape, degree)),
    };
    let Ok(scheme) = made else { return };
    assert!(scheme.mask().iter().all(|x: &f64| x.is_finite()));
    let _ = scheme.convergence();
    let _ = scheme.smoothness();
    if scheme.degree() < 8 {
        let _ = scheme.eigen();
        let _ = scheme.limit_mask(tape.below(3));
    }
    let Ok(polygon) = Subdivision::new(scheme, tape.rows::<D>(n), ends) else { return };
    let target = if tape.flip() { Target::Limit } else { Target::Level };
    levels(&polygon, tape.below(9), target);
    jumps(&polygon, target, tape);
    if let Ok(curve) = polygon.curve() {
        ask(&curve, tape);
    }
}

/// A mask whose halves sum to 1 if the first numbers allow it, or any.
fn mask(tape: &mut Tape<'_>, length: usize) -> Vec<f64> {
    let mut mask: Vec<f64> = (0..length).map(|_| tape.float()).collect();
    if tape.below(8) > 0 {
        for parity in 0..2 {
            let sum: f64 = mask.iter().skip(parity + 2).step_by(2).sum();
            if let Some(first) = mask.get_mut(parity) {
                *first = 1.0 - sum;
            }
        }
    }
    mask
}

/// A slice, a stream, ranges and passes of one level.
fn levels<const D: usize>(polygon: &Subdivision<D>, level: usize, target: Target) {
    let limits = small();
    let whole = match polygon.level(level, target, &limits) {
        Ok(whole) => whole,
        Err(error) => {
            let known = [Code::S003, Code::P003, Code::B001].contains(&error.code());
            return assert!(known, "{error}");
        }
    };
    assert_eq!(polygon.count(level, target).ok().and_then(|count| count.to_u64()), Some(whole.len() as u64));
    assert!(whole.as_flattened().iter().all(|x| x.is_finite()), "level {level}");
    let same = |a: &[f64; D], b: &[f64; D]| (0..D).all(|c| a[c].to_bits() == b[c].to_bits());
    let mut at = 0;
    let streamed = polygon.stream(level, target, &limits, &mut |block| {
        assert!(block.iter().zip(&whole[at..]).all(|(a, b)| same(a, b)), "a stream of level {level}");
        at += block.len();
        ControlFlow::Continue(())
    });
    assert!(streamed.is_ok() && at == whole.len(), "{streamed:?} after {at} points of {}", whole.len());
    for i in [0, 1, whole.len() / 2, whole.len().saturating_sub(1)] {
        let point = polygon.point(level, target, &Index::from(i as u64));
        match whole.get(i) {
            Some(wanted) => assert!(point.is_ok_and(|point| same(&point, wanted)), "point {i} of level {level}"),
            None => assert!(point.is_err(), "point {i} of {} points", whole.len()),
        }
    }
    if let Ok(next) = polygon.refined() {
        assert!(next.control_points().as_flattened().iter().all(|x| x.is_finite()));
    }
}

/// Points of high levels, and the distance to the limit.
fn jumps<const D: usize>(polygon: &Subdivision<D>, target: Target, tape: &mut Tape<'_>) {
    let level = match tape.below(4) {
        0 => 1000,
        1 => 1001,
        _ => tape.below(64),
    };
    let index = Index::from_bits((0..level.min(70)).map(|_| tape.flip()));
    if let Ok(point) = polygon.point(level, target, &index) {
        assert!(point.iter().all(|x| x.is_finite()), "{point:?} of level {level}");
    }
    if let Ok(joint) = polygon.joint(level, &index) {
        let all = [Some(joint.point), joint.tangent, joint.second];
        assert!(all.iter().flatten().flatten().all(|x| x.is_finite()), "{joint:?}");
    }
    if let Ok(distance) = polygon.distance(level.min(30)) {
        assert!(distance.bound().value() >= 0.0, "{distance:?}");
    }
    if let Ok(levels) = polygon.levels_for(tape.float()) {
        assert!(levels <= 1000, "{levels} levels");
    }
    if let Ok(derived) = polygon.derivative() {
        assert!(derived.control_points().as_flattened().iter().all(|x| x.is_finite()));
    }
}

fn sphere<const D: usize>(tape: &mut Tape<'_>, ends: Ends, degree: usize, n: usize) {
    let centre: [f64; D] = std::array::from_fn(|_| tape.float());
    let radius = tape.float();
    // On the sphere where that can be said so simply: along the axes.
    let point = |tape: &mut Tape<'_>| {
        let (axis, sign) = (tape.below(D), if tape.flip() { 1.0 } else { -1.0 });
        std::array::from_fn(|c| centre[c] + if c == axis { sign * radius } else { 0.0 })
    };
    let points: Vec<[f64; D]> = (0..n).map(|_| point(tape)).collect();
    let Ok(sphere) = Sphere::new(centre, radius, degree, points, ends) else { return };
    let level = tape.below(6);
    if let Ok(whole) = sphere.level(level, &small()) {
        assert!(whole.as_flattened().iter().all(|x| x.is_finite()), "level {level} of {sphere:?}");
        for i in [0, whole.len() / 2, whole.len().saturating_sub(1)] {
            let point = sphere.point(level, &Index::from(i as u64));
            assert_eq!(point.ok().as_ref(), whole.get(i), "point {i} of level {level}");
        }
    }
    let index = Index::from_bits((0..20).map(|_| tape.flip()));
    let _ = sphere.point(tape.below(256), &index);
}
