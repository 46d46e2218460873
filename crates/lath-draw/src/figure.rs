//! Figures: layers in, SVG or PNG out.

use crate::content::Content;
use crate::layer::{CurveLayer, PointLayer};
use crate::scene::Scene;
use crate::subject::{Layer, Subject};
use crate::theme::Theme;
use crate::{png, svg};
use lath::error::Result;

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
    subject: Subject,
    density: Option<f64>,
}

impl Default for Figure {
    fn default() -> Figure {
        Figure::new()
    }
}

/// The least and greatest sides of a picture in px.
const SIDES: [f64; 2] = [16.0, 16_384.0];
impl Figure {
    /// An empty light figure whose size follows its content.
    pub fn new() -> Figure {
        let subject = Subject {
            title: String::new(),
            names: Vec::new(),
            layers: Vec::new(),
            size: None,
            theme: Theme::LIGHT,
            axes: false,
            legend: true,
            camera: [-60.0, 25.0],
        };
        Figure { subject, density: None }
    }

    /// The line above the picture, also its `<title>`.
    pub fn title(mut self, title: impl Into<String>) -> Figure {
        self.subject.title = title.into();
        self
    }

    /// Adds a curve.
    pub fn curve(mut self, layer: CurveLayer) -> Figure {
        self.subject.layers.push(Layer::Curve(layer));
        self
    }

    /// Adds points.
    pub fn points(mut self, layer: PointLayer) -> Figure {
        self.subject.layers.push(Layer::Points(layer));
        self
    }

    /// Width and height in px, from 16 to 16384 (other sizes are moved into that range). Without a size the width is at
    /// most 960 and the height follows the content.
    pub fn size(mut self, width: f64, height: f64) -> Figure {
        let side = |x: f64| if x > SIDES[0] { if x < SIDES[1] { x } else { SIDES[1] } } else { SIDES[0] };
        self.subject.size = Some([side(width), side(height)]);
        self
    }

    /// Pixels of a PNG to the px; without it 1 where a size was asked for, else 2.
    pub fn density(mut self, density: f64) -> Figure {
        self.density = Some(density);
        self
    }

    /// Light on dark instead of dark on light.
    pub fn dark(mut self, dark: bool) -> Figure {
        self.subject.theme = if dark { Theme::DARK } else { Theme::LIGHT };
        self
    }

    /// Colours of one's own.
    pub fn theme(mut self, theme: Theme) -> Figure {
        self.subject.theme = theme;
        self
    }

    /// Whether axes are drawn: a grid with labels, in space a box with labels.
    pub fn axes(mut self, axes: bool) -> Figure {
        self.subject.axes = axes;
        self
    }

    /// The names of the axes: of t and the value for a graph, else of the coordinates. Shown with the axes.
    pub fn axis_names(mut self, names: impl IntoIterator<Item = impl Into<String>>) -> Figure {
        self.subject.names = names.into_iter().map(Into::into).collect();
        self
    }

    /// Whether there is a legend (there is, if anything has a name or needs an explanation).
    pub fn legend(mut self, legend: bool) -> Figure {
        self.subject.legend = legend;
        self
    }

    /// From where three dimensions are seen, in degrees: `azimuth` from x towards y, `elevation` above the xy-plane.
    /// (−90, 0) looks along y with x to the right and z up, (−90, 90) is the plan. Without it (−60, 25).
    pub fn view(mut self, azimuth: f64, elevation: f64) -> Figure {
        self.subject.camera = [azimuth, elevation];
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
        let density = self.density.unwrap_or(if self.subject.size.is_some() { 1.0 } else { 2.0 });
        png::write(&self.scene()?, density)
    }

    /// The picture as a display list, to add to it or to print it otherwise.
    ///
    /// # Errors
    /// As [`Figure::to_svg`].
    pub fn scene(&self) -> Result<Scene> {
        Ok(Content::new(&self.subject)?.scene())
    }
}
