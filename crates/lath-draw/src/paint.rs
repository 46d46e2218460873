//! Layers into the scene.

use crate::layer::{Join, PointLayer, Polygon};
use crate::lens::{Lens, Placement};
use crate::names::Names;
use crate::path::{Path, Point};
use crate::pen::Pen;
use crate::scene::{Scene, Shape, Stroke};
use crate::theme::{Color, Theme, weight};
use crate::thin::Thin;
use crate::trace::{jet, trace};
use lath::curve::AnyCurve;
use lath::knot::Side;
use lath::space::{distance, norm};

/// A curve as one path.
pub(crate) fn curve(
    scene: &mut Scene,
    curve: &AnyCurve,
    (lens, place): (&Lens, &Placement),
    tolerance: f64,
    color: Color,
) {
    let mut pen = Pen::new();
    let mut px: Vec<Point> = Vec::with_capacity(4);
    trace(curve, lens, tolerance, &mut |piece| {
        px.clear();
        px.extend(piece.iter().map(|p| place.px(*p)));
        pen.piece(&px);
    });
    scene.line(pen.finish(curve.is_closed()), Stroke::new(color, weight::CURVE));
}

/// A control polygon: thin lines, hollow squares.
pub(crate) fn polygon(scene: &mut Scene, polygon: &Polygon, lens: &Lens, place: &Placement, theme: &Theme) {
    let centers: Vec<Point> = polygon.spots.iter().map(|spot| place.px(lens.plane(spot))).collect();
    let stroke = Stroke::new(theme.muted, weight::POLYGON);
    let join = if polygon.closed { Join::Closed } else { Join::Open };
    scene.line(joined(&centers, join), stroke.opacity(0.55));
    scene.marks(Shape::Square, 2.6, centers, theme.paper, stroke);
}

/// The breaks of a curve: short strokes across it.
pub(crate) fn knots(scene: &mut Scene, curve: &AnyCurve, lens: &Lens, place: &Placement, theme: &Theme) {
    const HALF: f64 = 5.0;
    let breaks = curve.breaks();
    let mut strokes = Path::new();
    let mut thin = Thin::new(breaks.len(), HALF);
    for (i, t) in breaks.iter().enumerate() {
        let side = if i + 1 == breaks.len() { Side::Left } else { Side::Right };
        let [spot, velocity, _] = jet(curve, *t, side);
        let center = place.px(lens.plane(&spot));
        if !thin.lets(center) {
            continue;
        }
        let v = lens.vector(&velocity);
        let along = [place.scale[0] * v[0], -place.scale[1] * v[1]];
        let speed = norm(&along);
        let across = if speed > 0.0 && speed.is_finite() { [-along[1] / speed, along[0] / speed] } else { [0.0, 1.0] };
        let end = |s: f64| [center[0] + s * HALF * across[0], center[1] + s * HALF * across[1]];
        strokes.line(end(-1.0), end(1.0));
    }
    scene.line(strokes, Stroke::new(theme.ink, weight::KNOT).butt());
}

/// Points, joined by lines.
pub(crate) fn polyline(scene: &mut Scene, layer: &PointLayer, lens: &Lens, place: &Placement, color: Color) {
    if layer.join != Join::None {
        let path = joined(&centers(layer, lens, place), layer.join);
        scene.line(path, Stroke::new(color, weight::POLYLINE));
    }
}

/// Points as dots with a rim of paper, smaller where they are crowded.
pub(crate) fn dots(scene: &mut Scene, layer: &PointLayer, lens: &Lens, place: &Placement, color: Color, paper: Color) {
    if layer.dots {
        let centers = centers(layer, lens, place);
        let mut gaps: Vec<f64> = centers.windows(2).map(|pair| distance(&pair[0], &pair[1])).collect();
        gaps.sort_by(f64::total_cmp);
        let gap = gaps.get(gaps.len() / 2).copied().unwrap_or(20.0);
        let share = libm::sqrt(scene.width * scene.height / centers.len() as f64);
        let radius = (0.15 * gap).clamp(1.2, 2.7).min((0.2 * share).clamp(1.2, 2.7));
        scene.marks(Shape::Circle, radius, centers, color, Stroke::new(paper, 0.25 * radius));
    }
}

/// Keeps names off a layer's points and lines.
pub(crate) fn avoid(layer: &PointLayer, lens: &Lens, place: &Placement, names: &mut Names) {
    if layer.dots {
        let joined = matches!(layer.join, Join::Open | Join::Closed);
        names.avoid(&centers(layer, lens, place), joined, layer.join == Join::Closed);
    }
}

/// The names of points beside them.
pub(crate) fn names(
    scene: &mut Scene,
    layer: &PointLayer,
    lens: &Lens,
    place: &Placement,
    color: Color,
    names: &mut Names,
) {
    let centers = centers(layer, lens, place);
    let (n, closed) = (centers.len(), layer.join == Join::Closed);
    for (i, (name, at)) in layer.names.iter().zip(&centers).enumerate() {
        let before = if i > 0 {
            centers[i - 1]
        } else if closed {
            centers[n - 1]
        } else {
            *at
        };
        let behind = if i + 1 < n {
            centers[i + 1]
        } else if closed {
            centers[0]
        } else {
            *at
        };
        names.write(scene, name, (before, *at, behind), color);
    }
}

fn centers(layer: &PointLayer, lens: &Lens, place: &Placement) -> Vec<Point> {
    layer.spots.iter().map(|spot| place.px(lens.plane(spot))).collect()
}

fn joined(centers: &[Point], join: Join) -> Path {
    let mut pen = Pen::new();
    let closed = join == Join::Closed;
    let stride = if join == Join::Pairs { 2 } else { 1 };
    for pair in centers.windows(2).step_by(stride) {
        pen.piece(pair);
    }
    if let (true, [first, .., last]) = (closed, centers) {
        pen.piece(&[*last, *first]);
    }
    pen.finish(closed)
}
