//! What `draw` marks on curves and points: joints, tangents, names.

use lath::curve::{AnyCurve, Outside};
use lath::error::Result;
use lath::knot::Side;
use lath_draw::layer::{Join, PointLayer, indexed};

/// `P₃`, and of a level of a subdivision `P²₃`.
pub(crate) fn name(level: usize, index: usize) -> String {
    const ABOVE: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let above = level.to_string().bytes().map(|digit| ABOVE[usize::from(digit - b'0')]).collect::<String>();
    let point = indexed('P', index);
    if level == 0 { point } else { point.replacen('P', &format!("P{above}"), 1) }
}

/// Names for so many points, none where they could not be read.
pub(crate) fn names(count: usize) -> Vec<String> {
    const READABLE: usize = 200;
    if count > READABLE { Vec::new() } else { (0..count).map(|i| name(0, i)).collect() }
}

/// The points of a curve at these parameters.
pub(crate) fn dots(curve: &AnyCurve, at: &[f64]) -> Result<PointLayer> {
    let dimension = curve.dimension();
    let mut rows = vec![0.0; at.len() * dimension];
    for (t, row) in at.iter().zip(rows.chunks_exact_mut(dimension.max(1))) {
        curve.eval_into(*t, Outside::Error, row)?;
    }
    if dimension == 1 { PointLayer::graph(at, &rows) } else { PointLayer::new(dimension, &rows) }
}

/// The tangents at these parameters: the handles that the Bézier pieces beside them have, or would have if one were split there.
pub(crate) fn tangents(curve: &AnyCurve, at: &[f64]) -> Result<PointLayer> {
    let (dimension, domain, breaks) = (curve.dimension(), curve.domain(), curve.breaks());
    let mut jet = vec![0.0; 2 * dimension];
    let (mut abscissae, mut rows) = (Vec::new(), Vec::new());
    for &t in at {
        curve.jet_into(t, if t == domain.end { Side::Left } else { Side::Right }, 1, &mut jet);
        let (point, derivative) = jet.split_at(dimension);
        for h in [-behind(&breaks, t, curve.is_closed()) / 3.0, before(&breaks, t, curve.is_closed()) / 3.0] {
            abscissae.push(t + h);
            rows.extend(point.iter().zip(derivative).map(|(x, slope)| x + h * slope));
        }
    }
    let ends = match dimension {
        1 => PointLayer::graph(&abscissae, &rows)?,
        _ => PointLayer::new(dimension, &rows)?,
    };
    Ok(ends.join(Join::Pairs).dots(false))
}

/// How far t is behind the break before it; at the start of a closed curve the last piece is before it.
fn behind(breaks: &[f64], t: f64, closed: bool) -> f64 {
    match (breaks.partition_point(|b| *b < t), breaks) {
        (0, [.., a, b]) if closed => b - a,
        (0, _) => 0.0,
        (i, _) => t - breaks[i - 1],
    }
}

/// How far t is before the next break; at the end of a closed curve the first piece follows.
fn before(breaks: &[f64], t: f64, closed: bool) -> f64 {
    match (breaks.get(breaks.partition_point(|b| *b <= t)), breaks) {
        (Some(next), _) => next - t,
        (None, [a, b, ..]) if closed => b - a,
        (None, _) => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn handles_reach_from_break_to_break() {
        let breaks = [0.0, 1.0, 3.0];
        let both = |t: f64, closed: bool| (behind(&breaks, t, closed), before(&breaks, t, closed));
        assert_eq!((both(0.0, false), both(3.0, false)), ((0.0, 1.0), (2.0, 0.0)));
        assert_eq!((both(0.0, true), both(3.0, true)), ((2.0, 1.0), (2.0, 1.0)));
        assert_eq!((both(1.0, false), both(1.5, false)), ((1.0, 2.0), (0.5, 1.5)));
    }

    #[test]
    fn names_have_level_and_index() {
        assert_eq!((name(0, 10).as_str(), name(12, 3).as_str()), ("P₁₀", "P¹²₃"));
        assert_eq!((names(2), names(201).len()), (vec!["P₀".to_owned(), "P₁".to_owned()], 0));
    }
}
