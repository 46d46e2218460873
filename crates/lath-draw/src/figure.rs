//! Figures: layers in, SVG or PNG out.

use crate::axes::Axes;
use crate::cage::Cage;
use crate::comb::{Comb, Scale};
use crate::extent::Extent;
use crate::frame::{Gutter, Layout, Wish, arrange};
use crate::header::{Header, Sample};
use crate::layer::{CurveLayer, Join, PointLayer, Polygon};
use crate::lens::{Lens, Reach, View};
use crate::paint;
use crate::scene::{Scene, Stroke};
use crate::theme::{Color, Theme, weight};
use crate::trace::{corners, trace};
use crate::{png, svg};
use lath::error::{Code, Error, Result};

/// A picture of curves and points, built layer by layer.
///
/// One dimension gives a graph over t, two a plane figure of equal aspect, three and more a parallel projection of the
/// first three coordinates. All layers of a figure have the same kind. Later layers lie on top, points above all curves.
///
/// ```
/// use lath::curve::Bezier;
/// use lath_draw::{figure::Figure, layer::{CurveLayer, PointLayer}};
///
/// let control = [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]];
/// let svg = Figure::new()
///     .title("A cubic arch")
///     .curve(CurveLayer::of(Bezier::new(control)?)?.label("Bézier curve").polygon(true).comb(true))
///     .points(PointLayer::new(2, &[0.0, 0.0, 4.0, 0.0])?.label("ends"))
///     .axes(true)
///     .to_svg()?;
/// assert!(svg.starts_with("<svg") && svg.contains("<title>A cubic arch</title>"));
/// # Ok::<(), lath::error::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Figure {
    title: String,
    names: Vec<String>,
    layers: Vec<Layer>,
    size: Option<[f64; 2]>,
    density: Option<f64>,
    theme: Theme,
    axes: bool,
    legend: bool,
    camera: [f64; 2],
}

#[derive(Clone, Debug)]
enum Layer {
    Curve(CurveLayer),
    Points(PointLayer),
}

impl Default for Figure {
    fn default() -> Figure {
        Figure::new()
    }
}

/// The least and greatest sides of a picture in px.
const SIDES: [f64; 2] = [16.0, 16_384.0];
/// The greatest distance of what is drawn from the curve, in px.
const TOLERANCE: f64 = 0.02;
/// The distance of the teeth of a comb in px, and of its samples.
const TEETH: f64 = 5.0;
const STEP: f64 = 1.5;

impl Figure {
    /// An empty light figure whose size follows its content.
    pub fn new() -> Figure {
        Figure {
            title: String::new(),
            names: Vec::new(),
            layers: Vec::new(),
            size: None,
            density: None,
            theme: Theme::LIGHT,
            axes: false,
            legend: true,
            camera: [-60.0, 25.0],
        }
    }

    /// The line above the picture, also its `<title>`.
    pub fn title(mut self, title: impl Into<String>) -> Figure {
        self.title = title.into();
        self
    }

    /// Adds a curve.
    pub fn curve(mut self, layer: CurveLayer) -> Figure {
        self.layers.push(Layer::Curve(layer));
        self
    }

    /// Adds points.
    pub fn points(mut self, layer: PointLayer) -> Figure {
        self.layers.push(Layer::Points(layer));
        self
    }

    /// Width and height in px, from 16 to 16384 (other sizes are moved into that range). Without a size the width is at
    /// most 960 and the height follows the content.
    pub fn size(mut self, width: f64, height: f64) -> Figure {
        let side = |x: f64| if x > SIDES[0] { if x < SIDES[1] { x } else { SIDES[1] } } else { SIDES[0] };
        self.size = Some([side(width), side(height)]);
        self
    }

    /// Pixels of a PNG to the px; without it 1 where a size was asked for, else 2.
    pub fn density(mut self, density: f64) -> Figure {
        self.density = Some(density);
        self
    }

    /// Light on dark instead of dark on light.
    pub fn dark(mut self, dark: bool) -> Figure {
        self.theme = if dark { Theme::DARK } else { Theme::LIGHT };
        self
    }

    /// Colours of one's own.
    pub fn theme(mut self, theme: Theme) -> Figure {
        self.theme = theme;
        self
    }

    /// Whether axes are drawn: a grid with labels, in space a box with labels.
    pub fn axes(mut self, axes: bool) -> Figure {
        self.axes = axes;
        self
    }

    /// The names of the axes: of t and the value for a graph, else of the coordinates. Shown with the axes.
    pub fn axis_names(mut self, names: impl IntoIterator<Item = impl Into<String>>) -> Figure {
        self.names = names.into_iter().map(Into::into).collect();
        self
    }

    /// Whether there is a legend (there is, if anything has a name or needs an explanation).
    pub fn legend(mut self, legend: bool) -> Figure {
        self.legend = legend;
        self
    }

    /// From where three dimensions are seen, in degrees: `azimuth` from x towards y, `elevation` above the xy-plane.
    /// (−90, 0) looks along y with x to the right and z up, (−90, 90) is the plan. Without it (−60, 25).
    pub fn view(mut self, azimuth: f64, elevation: f64) -> Figure {
        self.camera = [azimuth, elevation];
        self
    }

    /// The picture as an SVG document: curves are its Bézier commands, letters are outlines.
    ///
    /// *Error of the drawing.* Pieces up to degree 3 are exact up to the three decimals of a coordinate; higher ones are
    /// within 0.02 px, proven up to degree 100, else and for curves that are not polynomial estimated.
    ///
    /// # Errors
    /// P005 if layers differ in kind (graph, plane, space); T001 for a view that is not finite.
    pub fn to_svg(&self) -> Result<String> {
        Ok(svg::write(&self.scene()?))
    }

    /// The picture as a PNG file, the same as the SVG.
    ///
    /// # Errors
    /// As [`Figure::to_svg`]; B001 for more than 2²⁶ pixels.
    pub fn to_png(&self) -> Result<Vec<u8>> {
        let density = self.density.unwrap_or(if self.size.is_some() { 1.0 } else { 2.0 });
        png::write(&self.scene()?, density)
    }

    /// The picture as a display list, to add to it or to print it otherwise.
    ///
    /// # Errors
    /// As [`Figure::to_svg`].
    pub fn scene(&self) -> Result<Scene> {
        let content = Content::new(self)?;
        let gutters = |layout: &Layout| match (self.axes, content.cage.is_some()) {
            (true, false) => Axes::new(&content.lens, layout, &self.names).gutter(),
            (true, true) => Cage::GUTTER,
            (false, _) => Gutter::default(),
        };
        // Labels need room, which changes the scale, which changes the labels: a few rounds of widening settle it.
        let mut gutter = Gutter::default();
        let mut layout = content.layout(self, gutter);
        for _ in 0..3 {
            gutter = gutter.both(&gutters(&layout));
            layout = content.layout(self, gutter);
        }
        let mut scene = Scene::new(layout.width, layout.height, self.theme.paper);
        scene.title = if self.title.is_empty() { "lath".to_owned() } else { self.title.clone() };
        content.header.draw(&mut scene, &self.theme);
        if let Some(cage) = &content.cage {
            cage.draw(&mut scene, &content.lens, &layout, &self.theme, &self.names);
        } else if self.axes {
            let axes = Axes::new(&content.lens, &layout, &self.names);
            axes.draw(&mut scene, &content.lens, &layout, &self.theme, content.lens.view == View::Graph);
        }
        content.draw(self, &mut scene, &layout);
        Ok(scene)
    }

    fn curves(&self) -> impl Iterator<Item = (usize, &CurveLayer)> + Clone {
        self.layers.iter().enumerate().filter_map(|(i, layer)| match layer {
            Layer::Curve(curve) => Some((i, curve)),
            Layer::Points(_) => None,
        })
    }

    fn rows(&self) -> impl Iterator<Item = (usize, &PointLayer)> + Clone {
        self.layers.iter().enumerate().filter_map(|(i, layer)| match layer {
            Layer::Points(points) => Some((i, points)),
            Layer::Curve(_) => None,
        })
    }

    /// Graph, plane or space, the same for all layers.
    fn kind(&self) -> Result<View> {
        let kind = |layer: &Layer| match layer {
            Layer::Curve(layer) => layer.curve.dimension().min(3),
            Layer::Points(layer) => layer.dimension.min(3),
        };
        let first = self.layers.first().map_or(2, kind);
        if let Some(index) = self.layers.iter().position(|layer| kind(layer) != first) {
            let message = format!("layer {index} has {} dimensions, the first has {first}", kind(&self.layers[index]));
            return Err(Error::new(Code::P005, message).at(index));
        }
        let [azimuth, elevation] = self.camera;
        match first {
            1 => Ok(View::Graph),
            2 => Ok(View::Plane),
            _ if azimuth.is_finite() && elevation.is_finite() => Ok(View::space(azimuth, elevation)),
            _ => Err(Error::new(Code::T001, format!("the view is {azimuth}, {elevation} degrees"))),
        }
    }

    /// The colour of each layer: its own, or the next of the theme; dots alone are ink.
    fn colors(&self) -> Vec<Color> {
        let mut series = 0;
        let mut next = || {
            series += 1;
            self.theme.series(series - 1)
        };
        self.layers
            .iter()
            .map(|layer| match layer {
                Layer::Curve(layer) => layer.color.unwrap_or_else(&mut next),
                Layer::Points(layer) if layer.join == Join::None => layer.color.unwrap_or(self.theme.ink),
                Layer::Points(layer) => layer.color.unwrap_or_else(&mut next),
            })
            .collect()
    }
}

/// Everything that is known before the layout.
struct Content {
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

impl Content {
    fn new(figure: &Figure) -> Result<Content> {
        let view = figure.kind()?;
        let polygons: Vec<Polygon> =
            figure.curves().filter(|(_, layer)| layer.polygon).flat_map(|(_, layer)| layer.polygons()).collect();
        let mut reach = Reach::EMPTY;
        for spot in figure.curves().flat_map(|(_, layer)| corners(&layer.curve)) {
            reach.include(&spot);
        }
        let points = figure.rows().flat_map(|(_, layer)| &layer.spots);
        for spot in points.clone().chain(polygons.iter().flat_map(|polygon| &polygon.spots)) {
            reach.include(spot);
        }
        let lens = Lens::new(view, &reach);
        let longest = figure.size.map_or(960.0, |[w, h]| if w > h { w } else { h });
        let tolerance = TOLERANCE / longest;
        let mut extent = Extent::EMPTY;
        for spot in points.chain(polygons.iter().flat_map(|polygon| &polygon.spots)) {
            extent.include(lens.plane(spot));
        }
        for (_, layer) in figure.curves() {
            trace(&layer.curve, &lens, tolerance, &mut |piece| extent.include_piece(piece));
        }
        let cage = (figure.axes && matches!(view, View::Space { .. })).then(|| Cage::new(&reach, &lens));
        if let Some(cage) = &cage {
            for corner in cage.corners() {
                extent.include(lens.plane(&corner));
            }
        }
        let graph = view == View::Graph;
        extent = extent.or_unit([graph || extent.height() == 0.0 || !extent.is_finite(), graph]);

        let colors = figure.colors();
        let series = figure.rows().filter(|(_, layer)| layer.join != Join::None).count() + figure.curves().count();
        let rough = Content::rough(figure, &extent, graph);
        let combs: Vec<(Comb, Color)> = figure
            .curves()
            .filter(|(_, layer)| layer.comb)
            .map(|(i, layer)| {
                let color = if series == 1 && layer.color.is_none() { figure.theme.comb } else { colors[i] };
                (Comb::new(&layer.curve, &lens, STEP / rough.placement.scale[0]), color)
            })
            .collect();
        let height = if graph { 0.22 * extent.height() } else { 0.12 * extent.longest() };
        let scale = Scale::new(combs.iter().map(|(comb, _)| comb), height);
        if let Some(scale) = &scale {
            for tip in combs.iter().flat_map(|(comb, _)| comb.tips(scale)) {
                extent.include(tip);
            }
        }
        let mut content =
            Content { lens, tolerance, extent, colors, polygons, combs, scale, cage, header: Header::default() };
        content.header = content.header(figure);
        Ok(content)
    }

    /// About how many px a unit of the plane will have.
    fn rough(figure: &Figure, extent: &Extent, graph: bool) -> Layout {
        let gutter = Gutter::default();
        arrange(&Wish { extent: *extent, equal: !graph, size: figure.size, gutter, header: &|_| 0.0 })
    }

    fn layout(&self, figure: &Figure, gutter: Gutter) -> Layout {
        let header = |width: f64| self.header.height(width);
        let equal = self.lens.view != View::Graph;
        arrange(&Wish { extent: self.extent, equal, size: figure.size, gutter, header: &header })
    }

    fn header(&self, figure: &Figure) -> Header {
        let mut entries = Vec::new();
        for (i, layer) in figure.curves() {
            entries.extend(layer.label.clone().map(|label| (Sample::Curve(self.colors[i]), label)));
        }
        for (i, layer) in figure.rows() {
            let sample = match layer.join {
                Join::None => Sample::Dots(self.colors[i]),
                _ => Sample::Polyline(self.colors[i], layer.dots),
            };
            entries.extend(layer.label.clone().map(|label| (sample, label)));
        }
        if !self.polygons.is_empty() {
            entries.push((Sample::Polygon, "control polygon".to_owned()));
        }
        if let Some((i, _)) = figure.curves().find(|(_, layer)| layer.knots) {
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
        if !figure.legend {
            entries.clear();
        }
        Header { title: figure.title.clone(), entries }
    }

    fn draw(&self, figure: &Figure, scene: &mut Scene, layout: &Layout) {
        let (theme, place) = (&figure.theme, &layout.placement);
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
        for (i, layer) in figure.rows() {
            paint::polyline(scene, layer, &self.lens, place, self.colors[i]);
        }
        for (i, layer) in figure.curves() {
            paint::curve(scene, &layer.curve, (&self.lens, place), self.tolerance, self.colors[i]);
        }
        for (_, layer) in figure.curves().filter(|(_, layer)| layer.knots) {
            paint::knots(scene, &layer.curve, &self.lens, place, theme);
        }
        for (i, layer) in figure.rows() {
            paint::dots(scene, layer, &self.lens, place, self.colors[i], theme.paper);
        }
    }
}
