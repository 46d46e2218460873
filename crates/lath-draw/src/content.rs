//! From the layers of a figure to its picture: what is seen, how large, and in which order it is drawn.

use crate::axes::Axes;
use crate::cage::Cage;
use crate::comb::Comb;
use crate::extent::Extent;
use crate::frame::{Gutter, Layout, Wish, arrange};
use crate::header::{Header, Sample};
use crate::layer::{Join, PointLayer, Polygon};
use crate::lens::{Lens, Reach, View};
use crate::names::Names;
use crate::paint;
use crate::scale::Scale;
use crate::scene::{Scene, Stroke};
use crate::subject::Subject;
use crate::theme::{Color, weight};
use crate::trace::{corners, trace};
use lath::error::Result;

/// The greatest distance of what is drawn from the curve, in px; and in the plane, for measuring its extent.
const TOLERANCE: f64 = 0.02;
const ROUGH: f64 = 1e-5;
/// The distance of the teeth of a comb in px, and of its samples.
const TEETH: f64 = 5.0;
const STEP: f64 = 1.5;

/// Everything that is known before the layout.
pub(crate) struct Content<'a> {
    subject: &'a Subject,
    lens: Lens,
    tolerance: f64,
    extent: Extent,
    colors: Vec<Color>,
    polygons: Vec<Polygon>,
    combs: Vec<(Comb, Color)>,
    scale: Option<Scale>,
    cage: Option<Cage>,
    header: Header,
}

impl<'a> Content<'a> {
    /// Sees, measures and scales.
    pub(crate) fn new(subject: &'a Subject) -> Result<Content<'a>> {
        let view = subject.kind()?;
        let mut polygons: Vec<Polygon> =
            subject.curves().filter(|(_, layer)| layer.polygon).flat_map(|(_, layer)| layer.polygons()).collect();
        polygons.dedup(); // curves of several kinds over one polygon
        let mut reach = Reach::EMPTY;
        for spot in subject.curves().flat_map(|(_, layer)| corners(&layer.curve)) {
            reach.include(&spot);
        }
        let points = subject.rows().flat_map(|(_, layer)| &layer.spots);
        for spot in points.clone().chain(polygons.iter().flat_map(|polygon| &polygon.spots)) {
            reach.include(spot);
        }
        let lens = Lens::new(view, &reach);
        let mut extent = Extent::EMPTY;
        for spot in points.chain(polygons.iter().flat_map(|polygon| &polygon.spots)) {
            extent.include(lens.plane(spot));
        }
        for (_, layer) in subject.curves() {
            trace(&layer.curve, &lens, ROUGH, &mut |piece| extent.include_piece(piece));
        }
        let cage = (subject.axes && matches!(view, View::Space { .. })).then(|| Cage::new(&reach, &lens));
        if let Some(cage) = &cage {
            for corner in cage.corners() {
                extent.include(lens.plane(&corner));
            }
        }
        let graph = view == View::Graph;
        extent = extent.or_unit([graph || extent.height() == 0.0 || !extent.is_finite(), graph]);

        // Combs and labels only take room away: no scale will be greater than this.
        let [sx, sy] = Content::rough(subject, &extent, graph).placement.scale;
        let scale = if sx > sy { sx } else { sy };
        let tolerance = TOLERANCE / scale;
        let colors = subject.colors();
        let series = subject.rows().filter(|(_, layer)| matches!(layer.join, Join::Open | Join::Closed)).count()
            + subject.curves().count();
        let combs: Vec<(Comb, Color)> = subject
            .curves()
            .filter(|(_, layer)| layer.comb)
            .map(|(i, layer)| {
                let color = if series == 1 && layer.color.is_none() { subject.theme.comb } else { colors[i] };
                (Comb::new(&layer.curve, &lens, STEP / scale), color)
            })
            .collect();
        let height = if graph { 0.22 * extent.height() } else { 0.12 * extent.longest() };
        let scale = Scale::new(combs.iter().flat_map(|(comb, _)| comb.bends()), height);
        if let Some(scale) = &scale {
            for tip in combs.iter().flat_map(|(comb, _)| comb.tips(scale)) {
                extent.include(tip);
            }
        }
        let mut content = Content {
            subject,
            lens,
            tolerance,
            extent,
            colors,
            polygons,
            combs,
            scale,
            cage,
            header: Header::default(),
        };
        content.header = content.header();
        Ok(content)
    }

    /// The finished picture.
    pub(crate) fn scene(&self) -> Scene {
        let Subject { title, names, theme, .. } = self.subject;
        // Labels need room, which changes the scale, which changes the labels: a few rounds of widening settle it.
        let mut gutter = Gutter::default();
        let mut layout = self.layout(gutter);
        for _ in 0..3 {
            gutter = gutter.both(&self.gutter(&layout));
            layout = self.layout(gutter);
        }
        let mut scene = Scene::new(layout.width, layout.height, theme.paper);
        scene.title = if title.is_empty() { "lath".to_owned() } else { title.clone() };
        self.header.draw(&mut scene, theme);
        if let Some(cage) = &self.cage {
            cage.draw(&mut scene, &self.lens, &layout, theme, names);
        } else if self.subject.axes {
            let axes = Axes::new(&self.lens, &layout, names);
            axes.draw(&mut scene, &self.lens, &layout, theme, self.lens.view == View::Graph);
        }
        self.draw(&mut scene, &layout);
        scene
    }

    /// The room that the labels of the axes would take in a layout.
    fn gutter(&self, layout: &Layout) -> Gutter {
        match (self.subject.axes, self.cage.is_some()) {
            (true, false) => Axes::new(&self.lens, layout, &self.subject.names).gutter(),
            (true, true) => Cage::GUTTER,
            (false, _) => Gutter::default(),
        }
    }

    /// The layout without labels, combs and legend.
    fn rough(subject: &Subject, extent: &Extent, graph: bool) -> Layout {
        let gutter = Gutter::default();
        arrange(&Wish { extent: *extent, equal: !graph, size: subject.size, gutter, header: &|_| 0.0 })
    }

    fn layout(&self, gutter: Gutter) -> Layout {
        let header = |width: f64| self.header.height(width);
        let equal = self.lens.view != View::Graph;
        arrange(&Wish { extent: self.extent, equal, size: self.subject.size, gutter, header: &header })
    }

    fn header(&self) -> Header {
        let subject = self.subject;
        let mut entries = Vec::new();
        for (i, layer) in subject.curves() {
            entries.extend(layer.label.clone().map(|label| (Sample::Curve(self.colors[i]), label)));
        }
        for (i, layer) in subject.rows() {
            let sample = match layer.join {
                Join::None => Sample::Dots(self.colors[i]),
                _ => Sample::Polyline(self.colors[i], layer.dots),
            };
            entries.extend(layer.label.clone().map(|label| (sample, label)));
        }
        if !self.polygons.is_empty() {
            entries.push((Sample::Polygon, "control polygon".to_owned()));
        }
        if let Some((i, _)) = subject.curves().find(|(_, layer)| layer.knots) {
            entries.push((Sample::Knots(self.colors[i]), "knots".to_owned()));
        }
        if let (Some(scale), Some((_, color))) = (&self.scale, self.combs.first()) {
            let unit = &self.lens.unit;
            let words = match self.lens.view {
                View::Graph => scale.words("second derivative", unit[1] / unit[0] / unit[0]),
                _ => scale.words("curvature κ", 1.0 / unit[0]),
            };
            entries.push((Sample::Comb(*color), words));
        }
        if !subject.legend {
            entries.clear();
        }
        Header { title: subject.title.clone(), entries }
    }

    /// The layers, from the back: polygons, combs, polylines, curves, knots, dots.
    fn draw(&self, scene: &mut Scene, layout: &Layout) {
        let subject = self.subject;
        let (theme, place) = (&subject.theme, &layout.placement);
        for polygon in &self.polygons {
            paint::polygon(scene, polygon, &self.lens, place, theme);
        }
        if let Some(scale) = &self.scale {
            for (comb, color) in &self.combs {
                let (teeth, envelope) = comb.draw(scale, TEETH, self.lens.view == View::Graph, |p| place.px(p));
                scene.line(teeth, Stroke::new(*color, weight::TOOTH).opacity(0.5).butt());
                scene.line(envelope, Stroke::new(*color, weight::ENVELOPE).opacity(0.9));
            }
        }
        for (i, layer) in subject.rows() {
            paint::polyline(scene, layer, &self.lens, place, self.colors[i]);
        }
        for (i, layer) in subject.curves() {
            paint::curve(scene, &layer.curve, (&self.lens, place), self.tolerance, self.colors[i]);
        }
        for (_, layer) in subject.curves().filter(|(_, layer)| layer.knots) {
            paint::knots(scene, &layer.curve, &self.lens, place, theme);
        }
        for (i, layer) in subject.rows() {
            paint::dots(scene, layer, &self.lens, place, self.colors[i], theme.paper);
        }
        let mut polygons: Vec<PointLayer> = subject.curves().filter_map(|(_, layer)| layer.named_polygon()).collect();
        polygons.dedup_by(|a, b| a.spots == b.spots);
        if polygons.is_empty() && subject.rows().all(|(_, layer)| layer.names.is_empty()) {
            return;
        }
        let mut names = Names::default();
        for layer in &polygons {
            paint::avoid(layer, &self.lens, place, &mut names);
        }
        for (_, layer) in subject.rows() {
            paint::avoid(layer, &self.lens, place, &mut names);
        }
        for (_, layer) in subject.curves() {
            trace(&layer.curve, &self.lens, self.tolerance, &mut |piece| {
                for pair in piece.windows(2) {
                    names.avoid_line(place.px(pair[0]), place.px(pair[1]));
                }
            });
        }
        for (i, layer) in subject.rows() {
            paint::names(scene, layer, &self.lens, place, self.colors[i], &mut names);
        }
        for layer in &polygons {
            paint::names(scene, layer, &self.lens, place, theme.muted, &mut names);
        }
    }
}
