//! Everything that can be asked of a curve, and what must hold of the answers.

use crate::counted::Counted;
use crate::small;
use crate::tape::Tape;
use lath::curve::{AnyCurve, Curve, CurveVisitor, Interval, Outside};
use lath::error::Code;
use lath::knot::Side;
use lath::query::{bounds, continuity, curvature, length};
use lath::tessellate::flatten;

/// Asks a curve whose dimension is known at run time.
pub fn ask_any(curve: &AnyCurve, tape: &mut Tape<'_>) {
    struct Ask<'a, 'b>(&'a mut Tape<'b>);
    impl CurveVisitor for Ask<'_, '_> {
        type Output = ();
        fn visit<const D: usize>(self, curve: &dyn Curve<D>, _dimension: usize) {
            ask(curve, self.0);
        }
    }
    curve.visit(Ask(tape));
}

/// Asks everything; parameters, orders and tolerances come from the tape.
pub fn ask<const D: usize>(curve: &dyn Curve<D>, tape: &mut Tape<'_>) {
    let domain = curve.domain();
    assert!(domain.start < domain.end && domain.start.is_finite() && domain.end.is_finite(), "{domain:?}");
    let breaks = curve.breaks();
    assert!(breaks.windows(2).all(|pair| pair[0] < pair[1]), "{breaks:?}");
    assert_eq!((breaks.first(), breaks.last()), (Some(&domain.start), Some(&domain.end)), "{breaks:?}");
    let (exact, scale) = extent(curve, &breaks);
    let order = tape.below(curve.degree() + 3).min(12);
    let mut inside: Vec<f64> = breaks.iter().copied().take(9).collect();
    inside.push(domain.end);
    for _ in 0..4 {
        let u = f64::from(tape.byte()) / 255.0;
        let t = domain.start * (1.0 - u) + domain.end * u;
        inside.push(if t < domain.start { domain.start } else { t });
    }
    let size = curve.degree() as f64 + 2.0;
    // The last term is for numbers so small that a rounding is no fraction of them.
    let slack = 1e3 * size * size * (f64::EPSILON * scale + f64::from_bits(1));
    let (around, excess) = bounds(curve);
    for axis in 0..D {
        let (lo, hi) = (around.lo[axis], around.hi[axis]);
        assert!(lo <= hi, "a box from {lo} to {hi}");
        assert!((lo.is_finite() && hi.is_finite()) || !excess.value().is_finite(), "{around:?} {excess:?}");
    }
    for t in inside {
        match curve.eval(t) {
            Ok(point) => {
                assert!(point.iter().all(|x| x.is_finite()), "{point:?} at {t:?}");
                let stands_out = |c: usize| point[c] < around.lo[c] - slack || point[c] > around.hi[c] + slack;
                let out = exact && slack.is_finite() && (0..D).any(stands_out);
                assert!(!out, "{point:?} at {t:?} is not in {around:?}, slack {slack}");
            }
            Err(error) => assert_eq!(error.code(), Code::P003, "{error} at {t:?} of {domain:?}"),
        }
        if let Ok(jet) = curve.jet(t, order) {
            assert!(jet.len() == order + 1 && jet.as_flattened().iter().all(|x| x.is_finite()), "{jet:?} at {t:?}");
        }
        let mut jet = vec![[0.0; D]; order + 1];
        curve.jet_into(t, Side::Left, &mut jet);
        for side in [Side::Left, Side::Right] {
            let bend = curvature(curve, t, side);
            assert!(bend.is_none_or(|k| k.is_finite() && k >= 0.0), "curvature {bend:?} at {t:?}");
        }
    }
    outside(curve, domain, tape);
    let _ = continuity(curve);
    measures(curve, scale, tape);
}

/// Whether the pieces are exact, polynomial or rational, and their greatest coordinate. They fill the domain one after another,
/// polynomial ones from break to break.
fn extent<const D: usize>(curve: &dyn Curve<D>, breaks: &[f64]) -> (bool, f64) {
    let start = Pieces { most: curve.degree() + 1, end: breaks[0], count: 0, scale: 0.0 };
    let (mut polynomial, mut rational) = (start, start);
    if curve.bezier_pieces(&mut |piece| polynomial.add(piece.start, piece.end, piece.points.iter().copied())) {
        assert_eq!((polynomial.count, Some(&polynomial.end)), (breaks.len() - 1, breaks.last()));
        return (true, polynomial.scale);
    }
    let exact = curve.rational_pieces(&mut |piece| {
        rational.add(piece.start, piece.end, piece.points.iter().map(|weighted| weighted.point));
    });
    assert!(!exact || Some(&rational.end) == breaks.last(), "pieces to {} of {breaks:?}", rational.end);
    (exact, rational.scale)
}

/// What was seen of the pieces.
#[derive(Clone, Copy)]
struct Pieces {
    /// The most control points that a piece may have.
    most: usize,
    /// Where the last ended.
    end: f64,
    count: usize,
    scale: f64,
}

impl Pieces {
    fn add<const D: usize>(&mut self, start: f64, end: f64, points: impl ExactSizeIterator<Item = [f64; D]>) {
        assert!(start == self.end && start < end, "a piece from {start:?} to {end:?} after {:?}", self.end);
        assert!((1..=self.most).contains(&points.len()), "piece {} of {} points", self.count, points.len());
        (self.count, self.end) = (self.count + 1, end);
        for x in points.flatten() {
            if x.is_nan() || x.abs() > self.scale {
                self.scale = x.abs();
            }
        }
    }
}

fn outside<const D: usize>(curve: &dyn Curve<D>, domain: Interval, tape: &mut Tape<'_>) {
    let t = tape.float();
    for policy in [Outside::Error, Outside::Clamp, Outside::Extrapolate, Outside::Periodic] {
        match curve.eval_outside(t, policy) {
            Ok(point) => assert!(t.is_finite() && point.iter().all(|x| x.is_finite()), "{point:?} at {t:?}"),
            Err(error) => {
                let codes = match (t.is_finite(), policy) {
                    (false, _) => [Code::T001; 2],
                    (true, Outside::Error) if !domain.contains(t) => [Code::T002; 2],
                    _ => [Code::P003; 2],
                };
                assert!(codes.contains(&error.code()), "{error} at {t:?} of {domain:?}");
            }
        }
    }
}

fn measures<const D: usize>(curve: &dyn Curve<D>, scale: f64, tape: &mut Tape<'_>) {
    // Some fraction of the curve's size, or any number.
    let tolerance = if tape.flip() { scale / (1.0 + f64::from(tape.byte())) } else { tape.float() };
    let limits = small();
    if let Ok((length, bound)) = length(curve, tolerance, &limits) {
        assert!(length >= 0.0 && bound.value() >= 0.0, "length {length} {bound:?}");
        assert!(length.is_finite() || scale > 1e290, "length {length} {bound:?} of coordinates to {scale}");
    }
    let (mut sent, mut last) = (0u64, f64::NEG_INFINITY);
    let mut bad = None;
    // Curves without pieces are asked again and again: counted.
    let flattened = flatten(curve, tolerance, &limits, &mut |t, point| {
        assert!(t >= last, "{t:?} after {last:?}");
        (sent, last) = (sent + 1, t);
        if point.iter().any(|x| !x.is_finite()) {
            bad = Some((t, point));
        }
    });
    match flattened {
        Ok(bound) => {
            assert!(bad.is_none(), "{bad:?} from coordinates to {scale}");
            assert!(bound.value() >= 0.0 && sent >= 2 && sent <= limits.max_points * 2, "{sent} points, {bound:?}");
        }
        Err(error) => assert!([Code::Q001, Code::B001, Code::P003].contains(&error.code()), "{error}"),
    }
}

/// The same for a curve that nobody else holds, counting how often it is asked.
pub fn ask_counted<const D: usize>(curve: impl Curve<D>, tape: &mut Tape<'_>) {
    ask::<D>(&Counted::new(curve), tape);
}
