//! Title and legend above the plot.

use crate::font;
use crate::frame::MARGIN;
use crate::path::Path;
use crate::scene::{Align, Scene, Shape, Stroke};
use crate::theme::{Color, Theme, letter, weight};

/// The height of the title, of a row of the legend, and the air below both.
const TITLE: f64 = 30.0;
const ROW: f64 = 23.0;
const AIR: f64 = 13.0;
/// The width of a sample, its distance to the label, and the distance between entries.
const SAMPLE: f64 = 24.0;
const GAP: f64 = 8.0;
const BETWEEN: f64 = 26.0;

/// What stands before a label.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Sample {
    Curve(Color),
    Polyline(Color, bool),
    Dots(Color),
    Polygon,
    Knots(Color),
    Comb(Color),
}

/// Title and legend.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Header {
    pub(crate) title: String,
    pub(crate) entries: Vec<(Sample, String)>,
}

impl Header {
    /// The height taken in a picture of this width.
    pub(crate) fn height(&self, width: f64) -> f64 {
        let rows = self.places(width).last().map_or(0.0, |(_, row, _)| row + 1.0);
        let title = if self.title.is_empty() { 0.0 } else { TITLE };
        if rows == 0.0 && title == 0.0 { 0.0 } else { title + ROW * rows + AIR }
    }

    /// Where each entry stands: x, row, and the label cut to fit.
    fn places(&self, width: f64) -> Vec<(f64, f64, String)> {
        let room = width - 2.0 * MARGIN;
        let (mut x, mut row) = (0.0, 0.0);
        let mut places = Vec::new();
        for (_, label) in &self.entries {
            let label = font::fit(label, letter::LEGEND, room - SAMPLE - GAP);
            let wide = SAMPLE + GAP + font::width(&label, letter::LEGEND);
            if x > 0.0 && x + wide > room {
                (x, row) = (0.0, row + 1.0);
            }
            places.push((MARGIN + x, row, label));
            x += wide + BETWEEN;
        }
        places
    }

    /// Draws both.
    pub(crate) fn draw(&self, scene: &mut Scene, theme: &Theme) {
        let width = scene.width;
        let mut top = MARGIN;
        if !self.title.is_empty() {
            let title = font::fit(&self.title, letter::TITLE, width - 2.0 * MARGIN);
            scene.text(&title, letter::TITLE, [MARGIN, top + 15.0], Align::Left, theme.ink);
            top += TITLE;
        }
        for ((sample, _), (x, row, label)) in self.entries.iter().zip(self.places(width)) {
            let middle = top + ROW * row + ROW / 2.0 - 1.0;
            sample.draw(scene, theme, x, middle);
            let at = [x + SAMPLE + GAP, middle + 0.34 * letter::LEGEND];
            scene.text(&label, letter::LEGEND, at, Align::Left, theme.muted);
        }
    }
}

impl Sample {
    fn draw(&self, scene: &mut Scene, theme: &Theme, x: f64, y: f64) {
        let (end, middle) = (x + SAMPLE, x + SAMPLE / 2.0);
        let mut path = Path::new();
        path.line([x + 1.0, y], [end - 1.0, y]);
        let paper = Stroke::new(theme.paper, 1.0);
        match *self {
            Sample::Curve(color) => scene.line(path, Stroke::new(color, weight::CURVE)),
            Sample::Polyline(color, dots) => {
                scene.line(path, Stroke::new(color, weight::POLYLINE));
                if dots {
                    scene.marks(Shape::Circle, 2.6, vec![[middle, y]], color, paper);
                }
            }
            Sample::Dots(color) => {
                let centers = vec![[middle - 8.0, y], [middle, y], [middle + 8.0, y]];
                scene.marks(Shape::Circle, 2.4, centers, color, paper);
            }
            Sample::Polygon => {
                scene.line(path, Stroke::new(theme.muted, weight::POLYGON).opacity(0.7));
                let rim = Stroke::new(theme.muted, weight::POLYGON);
                scene.marks(Shape::Square, 2.6, vec![[middle, y]], theme.paper, rim);
            }
            Sample::Knots(color) => {
                scene.line(path, Stroke::new(color, weight::CURVE));
                let mut strokes = Path::new();
                for dx in [-5.0, 5.0] {
                    strokes.line([middle + dx, y - 5.0], [middle + dx, y + 5.0]);
                }
                scene.line(strokes, Stroke::new(theme.ink, weight::KNOT).butt());
            }
            Sample::Comb(color) => {
                let mut teeth = Path::new();
                let mut tips = Vec::new();
                for k in 0..=6_u8 {
                    let u = f64::from(k) / 6.0;
                    let tip = [
                        x + 1.0 + (SAMPLE - 2.0) * u,
                        y + 5.0 - 10.0 * (1.0 - (2.0 * u - 1.0) * (2.0 * u - 1.0)) - 1.5,
                    ];
                    teeth.line([tip[0], y + 6.0], tip);
                    tips.push(tip);
                }
                scene.line(teeth, Stroke::new(color, weight::TOOTH).opacity(0.6).butt());
                let mut envelope = Path::new();
                envelope.polyline(tips, false);
                scene.line(envelope, Stroke::new(color, weight::ENVELOPE));
            }
        }
    }
}
