//! A display list: what is drawn, in order, in px, y down. [`svg`](crate::svg) and [`png`](crate::png) both print it.

use crate::font;
use crate::path::{Path, Point};
use crate::theme::Color;
use crate::thin::Thin;

/// How a line is drawn. Ends and corners are round unless `butt` is set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Its colour.
    pub color: Color,
    /// Its width in px.
    pub width: f64,
    /// 0 (not to be seen) to 1 (covers).
    pub opacity: f64,
    /// Lengths of dash and gap in px.
    pub dash: Option<[f64; 2]>,
    /// Square ends exactly at the end points, for grids and teeth.
    pub butt: bool,
}

impl Stroke {
    /// A solid line.
    pub fn new(color: Color, width: f64) -> Stroke {
        Stroke { color, width, opacity: 1.0, dash: None, butt: false }
    }

    /// The same line, less opaque.
    pub fn opacity(self, opacity: f64) -> Stroke {
        Stroke { opacity, ..self }
    }

    /// The same line, dashed.
    pub fn dash(self, dash: f64, gap: f64) -> Stroke {
        Stroke { dash: Some([dash, gap]), ..self }
    }

    /// The same line with square ends.
    pub fn butt(self) -> Stroke {
        Stroke { butt: true, ..self }
    }
}

/// The form of a marker around its centre.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A disc; its size is the radius.
    Circle,
    /// An upright square; its size is half a side.
    Square,
}

/// One thing to draw.
#[derive(Clone, Debug, PartialEq)]
pub enum Item {
    /// The inside of a path (non-zero winding).
    Fill {
        /// The path.
        path: Path,
        /// Its colour.
        color: Color,
        /// 0 to 1.
        opacity: f64,
    },
    /// A line along a path.
    Line {
        /// The path.
        path: Path,
        /// How.
        stroke: Stroke,
    },
    /// The same marker at many places.
    Marks {
        /// The form.
        shape: Shape,
        /// Radius or half side in px.
        size: f64,
        /// Where.
        centers: Vec<Point>,
        /// The inside.
        fill: Color,
        /// The rim.
        stroke: Stroke,
    },
}

/// A picture as a display list.
///
/// ```
/// use lath_draw::{path::Path, scene::{Scene, Stroke}, theme::Theme};
///
/// let mut scene = Scene::new(200.0, 100.0, Theme::LIGHT.paper);
/// let mut path = Path::new();
/// path.line([10.0, 90.0], [190.0, 10.0]);
/// scene.line(path, Stroke::new(Theme::LIGHT.series(0), 2.0));
/// let svg = lath_draw::svg::write(&scene);
/// assert!(svg.contains(r#"<path d="M10 90l180-80""#));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Width in px.
    pub width: f64,
    /// Height in px.
    pub height: f64,
    /// The background.
    pub paper: Color,
    /// The title, for readers that do not see the picture.
    pub title: String,
    /// What is drawn, the first at the back.
    pub items: Vec<Item>,
}

/// Where a text stands relative to its point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Align {
    /// It begins there.
    Left,
    /// Its middle is there.
    Center,
    /// It ends there.
    Right,
}

impl Scene {
    /// An empty picture.
    pub fn new(width: f64, height: f64, paper: Color) -> Scene {
        Scene { width, height, paper, title: String::new(), items: Vec::new() }
    }

    /// Fills a path.
    pub fn fill(&mut self, path: Path, color: Color, opacity: f64) {
        if !path.is_empty() {
            self.items.push(Item::Fill { path, color, opacity });
        }
    }

    /// Draws a line along a path.
    pub fn line(&mut self, path: Path, stroke: Stroke) {
        if !path.is_empty() {
            self.items.push(Item::Line { path, stroke });
        }
    }

    /// Draws markers. Those on the same spot are drawn once, and in a crowd of tens of thousands those that are hidden.
    pub fn marks(&mut self, shape: Shape, size: f64, centers: Vec<Point>, fill: Color, stroke: Stroke) {
        let mut thin = Thin::new(centers.len(), 2.0 * size);
        let centers: Vec<Point> = centers.into_iter().filter(|center| thin.lets(*center)).collect();
        if !centers.is_empty() {
            self.items.push(Item::Marks { shape, size, centers, fill, stroke });
        }
    }

    /// Writes a text whose baseline runs through `at`, as filled outlines.
    pub fn text(&mut self, text: &str, size: f64, at: Point, align: Align, color: Color) {
        let (path, width) = font::outline(text, size);
        let x = match align {
            Align::Left => at[0],
            Align::Center => at[0] - width / 2.0,
            Align::Right => at[0] - width,
        };
        let mut placed = Path::new();
        placed.extend_mapped(&path, |p| [p[0] + x, p[1] + at[1]]);
        self.fill(placed, color, 1.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::theme::Theme;

    #[test]
    fn a_million_markers_on_one_spot_are_one() {
        let mut scene = Scene::new(10.0, 10.0, Theme::LIGHT.paper);
        let centers = (0..1_000_000).map(|i| [5.0 + 1e-8 * f64::from(i), f64::NAN.max(5.0)]).collect();
        scene.marks(Shape::Circle, 2.0, centers, Theme::LIGHT.ink, Stroke::new(Theme::LIGHT.ink, 1.0));
        let Item::Marks { centers, .. } = &scene.items[0] else { panic!() };
        assert_eq!(centers.len(), 1);
    }
}
