//! Curvature combs: teeth across the curve, away from the centre of curvature, joined at their tips by a line.
//!
//! *What a tooth shows.* In two and more dimensions the curvature κ of what is seen; over a graph, where curvature would
//! depend on the units of the axes, the second derivative f″, its teeth parallel to the axis.
//!
//! *How long.* See [`Scale`]; all combs of a figure share one.
//!
//! *Where teeth stand.* At equal steps along the curve, closer where the tips run faster than the curve, and at
//! both sides of each break, so that a jump of κ is a jump of the envelope.

use crate::lens::{Lens, Spot};
use crate::path::{Path, Point};
use crate::scale::Scale;
use crate::trace::jet;
use lath::curve::AnyCurve;
use lath::knot::Side;
use lath::space::norm;

/// Every interval between breaks is sampled at so many steps at least.
const START: usize = 4;

/// A place on the curve and its bending.
#[derive(Clone, Copy, Debug)]
struct Sample {
    base: Point,
    /// Where a tooth of length 1 ends, relative to the base: the unit vector away from the centre, as seen.
    away: Point,
    /// κ ≥ 0, or |f″|, in the lens's units.
    bend: f64,
    /// The direction of the tangent, to see how far it turns.
    tangent: Spot,
}

/// The bending along a curve: stretches without gaps, each a list of samples.
pub(crate) struct Comb {
    stretches: Vec<Vec<Sample>>,
}

impl Comb {
    /// Samples the curve so densely that neighbours are about `step` (in the plane) or 4° apart.
    pub(crate) fn new(curve: &AnyCurve, lens: &Lens, step: f64) -> Comb {
        /// More breaks than this are visited in strides: nobody sees their teeth one by one.
        const MOST: usize = 2000;
        /// And about so many samples are taken in all, whatever the curve does.
        const SAMPLES: usize = 100_000;
        let breaks = curve.breaks();
        let stride = breaks.len() / MOST + 1;
        let mut ends: Vec<f64> = breaks.iter().copied().step_by(stride).collect();
        if let (Some(&end), true) = (breaks.last(), !breaks.len().wrapping_sub(1).is_multiple_of(stride)) {
            ends.push(end);
        }
        let mut comb = Comb { stretches: Vec::new() };
        let depth = (SAMPLES / (START * ends.len())).max(1).ilog2().min(13) as usize;
        let mut joined = false;
        for pair in ends.windows(2) {
            comb.stretch((curve, lens), step, depth, (pair[0], pair[1]), &mut joined);
        }
        comb.stretches.retain(|stretch| stretch.len() > 1);
        comb
    }

    /// Samples one interval between breaks, halving it at most `depth` times; `joined` tells whether the list continues.
    fn stretch(
        &mut self,
        (curve, lens): (&AnyCurve, &Lens),
        step: f64,
        depth: usize,
        (a, b): (f64, f64),
        joined: &mut bool,
    ) {
        let at = |k: usize| if k == START { b } else { a + (b - a) * (k as f64 / START as f64) };
        let sample = |t: f64| sample(curve, lens, t, if t == b { Side::Left } else { Side::Right });
        let mut from = (a, sample(a));
        self.push(from.1, step, joined);
        for k in 1..=START {
            // Right ends still to be reached with their depth, the nearest on top.
            let mut ends = vec![(at(k), sample(at(k)), 0)];
            while let Some(&(t, reached, level)) = ends.last() {
                let to = (t, reached);
                let middle = from.0 / 2.0 + to.0 / 2.0;
                let coarse = match (&from.1, &to.1) {
                    (Some(p), Some(q)) => {
                        let turn = (0..3).fold(0.0, |sum, c| sum + p.tangent[c] * q.tangent[c]);
                        distance(p.base, q.base) > step || turn < 0.9976
                    }
                    (None, None) => false,
                    _ => true,
                };
                if coarse && level < depth && from.0 < middle && middle < to.0 {
                    if let Some(end) = ends.last_mut() {
                        end.2 = level + 1;
                    }
                    ends.push((middle, sample(middle), level + 1));
                    continue;
                }
                self.push(to.1, step, joined);
                from = to;
                ends.pop();
            }
        }
    }

    /// Appends to the last stretch, or begins another behind a gap.
    fn push(&mut self, sample: Option<Sample>, step: f64, joined: &mut bool) {
        let Some(sample) = sample else {
            *joined = false;
            return;
        };
        let last = self.stretches.last().and_then(|stretch| stretch.last());
        // What the sampling could not bring closer together is a jump of the curve itself.
        *joined &= last.is_some_and(|last| distance(last.base, sample.base) <= 16.0 * step);
        match self.stretches.last_mut() {
            Some(stretch) if *joined => stretch.push(sample),
            _ => self.stretches.push(vec![sample]),
        }
        *joined = true;
    }

    /// Each bending with the length of curve that has it.
    pub(crate) fn bends(&self) -> impl Iterator<Item = (f64, f64)> {
        self.stretches.iter().flat_map(|stretch| stretch.windows(2)).flat_map(|pair| {
            let length = distance(pair[0].base, pair[1].base) / 2.0;
            [(pair[0].bend, length), (pair[1].bend, length)]
        })
    }

    /// The tips of all teeth.
    pub(crate) fn tips(&self, scale: &Scale) -> impl Iterator<Item = Point> {
        self.stretches.iter().flatten().map(|sample| sample.tip(scale))
    }

    /// Teeth `spacing` apart (over a graph along its axis), and the envelope, both through `px`.
    pub(crate) fn draw(&self, scale: &Scale, spacing: f64, graph: bool, px: impl Fn(Point) -> Point) -> (Path, Path) {
        let (mut teeth, mut envelope) = (Path::new(), Path::new());
        for stretch in &self.stretches {
            let placed: Vec<(Point, Point)> = stretch.iter().map(|s| (px(s.base), px(s.tip(scale)))).collect();
            let advance = |a: &(Point, Point), b: &(Point, Point)| {
                if graph {
                    return (b.0[0] - a.0[0]).abs();
                }
                let (along, across) = (distance(a.0, b.0), 0.45 * distance(a.1, b.1));
                // A jump at one place is no advance.
                if along < 1e-6 {
                    0.0
                } else if along > across {
                    along
                } else {
                    across
                }
            };
            let total = placed.windows(2).fold(0.0, |sum, pair| sum + advance(&pair[0], &pair[1]));
            let count = (total / spacing).round();
            let gap = if count >= 1.0 { total / count } else { total };
            let (mut walked, mut next) = (0.0, 0.0);
            for pair in placed.windows(2) {
                let length = advance(&pair[0], &pair[1]);
                while length > 0.0 && next <= walked + length + 1e-9 * total {
                    let u = ((next - walked) / length).clamp(0.0, 1.0);
                    teeth.line(mix(pair[0].0, pair[1].0, u), mix(pair[0].1, pair[1].1, u));
                    next += gap;
                }
                walked += length;
            }
            envelope.polyline(sparse(placed.into_iter().map(|(_, tip)| tip)), false);
        }
        (teeth, envelope)
    }
}

impl Sample {
    fn tip(&self, scale: &Scale) -> Point {
        let length = scale.length(self.bend);
        [self.base[0] + length * self.away[0], self.base[1] + length * self.away[1]]
    }
}

/// The bending at t; none where the tangent vanishes.
fn sample(curve: &AnyCurve, lens: &Lens, t: f64, side: Side) -> Option<Sample> {
    let [p, v, a] = jet(curve, t, side);
    let scaled = |d: &Spot| -> Spot { core::array::from_fn(|c| d[c] / lens.unit[c]) };
    let (velocity, acceleration) = (scaled(&v), scaled(&a));
    let speed = norm(&velocity);
    if !(speed > 0.0 && speed.is_finite()) {
        return None;
    }
    let tangent: Spot = velocity.map(|x| x / speed);
    let (bend, away) = if curve.dimension() == 1 {
        // Parameters have the unit of the first axis: f″ per its square.
        let second = acceleration[1] * lens.unit[0] * lens.unit[0];
        (second.abs(), if second > 0.0 { [0.0, -1.0] } else { [0.0, 1.0] })
    } else {
        let along = (0..3).fold(0.0, |sum, c| sum + tangent[c] * acceleration[c]);
        let across: Spot = core::array::from_fn(|c| acceleration[c] - along * tangent[c]);
        let length = norm(&across);
        let normal = if length > 0.0 { across.map(|x| -x / length) } else { [0.0; 3] };
        (length / speed / speed, lens.project(&normal))
    };
    let base = lens.plane(&p);
    let finite = bend.is_finite() && base.iter().chain(&away).all(|x| x.is_finite());
    finite.then_some(Sample { base, away, bend, tangent })
}

/// Leaves out points within a quarter px of the last one kept, except the last of all.
fn sparse(points: impl Iterator<Item = Point>) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::new();
    let mut skipped = None;
    for p in points {
        skipped = match kept.last() {
            Some(&last) if distance(last, p) < 0.25 => Some(p),
            _ => {
                kept.push(p);
                None
            }
        };
    }
    kept.extend(skipped);
    kept
}

fn distance(a: Point, b: Point) -> f64 {
    lath::space::distance(&a, &b)
}

fn mix(a: Point, b: Point, u: f64) -> Point {
    [a[0] + u * (b[0] - a[0]), a[1] + u * (b[1] - a[1])]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layer::CurveLayer;
    use crate::lens::{Reach, View};
    use lath::curve::{Bezier, Hermite};

    fn comb(points: &[Point]) -> (Comb, Lens) {
        let mut reach = Reach::EMPTY;
        points.iter().for_each(|p| reach.include(&[p[0], p[1], 0.0]));
        let lens = Lens::new(View::Plane, &reach);
        let layer = CurveLayer::of(Bezier::new(points).unwrap()).unwrap();
        (Comb::new(&layer.curve, &lens, 1e-3), lens)
    }

    #[test]
    fn teeth_are_as_long_as_the_curvature_and_point_away_from_the_centre() {
        // y = x² on [−1, 1]: κ = 2 / (1 + 4x²)^(3/2), greatest 2 at 0, where the tooth points down.
        let (comb, lens) = comb(&[[-1.0, 1.0], [0.0, -1.0], [1.0, 1.0]]);
        let scale = Scale::new(comb.bends(), 0.5).unwrap();
        assert_eq!(scale.words("κ", 1.0 / lens.unit[0]), "κ, longest tooth 2");
        for sample in comb.stretches.iter().flatten() {
            let x = lens.value(0, sample.base[0]);
            let kappa = 2.0 / libm::pow(1.0 + 4.0 * x * x, 1.5);
            assert!((scale.length(sample.bend) - 0.25 * kappa).abs() < 1e-9);
            assert!(sample.away[1] < 0.0);
        }
    }

    #[test]
    fn a_nose_does_not_hide_the_flanks() {
        // The tip of the flat parabola x = 100 y²: κ is 200 at the nose and below one on most of the length.
        let (comb, lens) = comb(&[[1.0, 0.1], [-1.0, 0.0], [1.0, -0.1]]);
        let scale = Scale::new(comb.bends(), 1.0).unwrap();
        let words = scale.words("κ", 1.0 / lens.unit[0]);
        assert!(words.contains("linear to 0.0") && words.ends_with("then logarithmic to 200"), "{words}");
        let mut lengths: Vec<f64> = comb.stretches.iter().flatten().map(|sample| scale.length(sample.bend)).collect();
        lengths.sort_by(f64::total_cmp);
        assert!(lengths[lengths.len() / 2] > 0.05, "the median tooth can be seen");
    }

    #[test]
    fn straight_lines_have_no_comb() {
        let (straight, _) = comb(&[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0], [3.0, 3.0]]);
        assert_eq!(Scale::new(straight.bends(), 1.0), None);
        let still = Hermite::new(vec![0.0, 1.0], [[5.0, 5.0]; 2], [[0.0, 0.0]; 2]).unwrap();
        let layer = CurveLayer::of(still).unwrap();
        let lens = Lens::new(View::Plane, &Reach { lo: [5.0; 3], hi: [5.0; 3] });
        assert!(Comb::new(&layer.curve, &lens, 1e-3).stretches.is_empty());
    }

    #[test]
    fn teeth_stand_at_even_distances() {
        // A quarter turn of a spiral-like cubic, compared in px.
        let (comb, _) = comb(&[[0.0, 0.0], [0.5, 0.0], [1.0, 0.5], [1.0, 1.0]]);
        let scale = Scale::new(comb.bends(), 0.01).unwrap();
        let (teeth, envelope) = comb.draw(&scale, 5.0, false, |p| [1000.0 * p[0], 1000.0 * p[1]]);
        let bases: Vec<Point> = teeth
            .segments()
            .chunks(2)
            .filter_map(|pair| match pair[0] {
                crate::path::Segment::Move(p) => Some(p),
                _ => None,
            })
            .collect();
        for pair in bases.windows(2) {
            assert!((distance(pair[0], pair[1]) - 5.0).abs() < 0.1, "{pair:?}");
        }
        assert!(bases.len() > 250 && envelope.segments().len() > 250);
    }
}
