//! Axes of a graph or a plane figure: a faint grid, labels, no box.

use crate::font;
use crate::frame::{Frame, Gutter, Layout};
use crate::lens::Lens;
use crate::path::Path;
use crate::scene::{Align, Scene, Stroke};
use crate::theme::{Theme, letter, weight};
use crate::ticks::{Ticks, ticks};

/// From the frame to the labels, from the frame to the baseline of the labels below, and from line to line.
const GAP: f64 = 9.0;
const BELOW: f64 = 20.0;
const LINE: f64 = 18.0;
/// A grid line so close to the base line is left out.
const CLOSE: f64 = 6.0;

/// The distance of ticks along an axis of this length, in px: a quarter of it within limits that look well along x
/// and along y.
fn least(axis: usize, length: f64) -> f64 {
    let [low, high] = [[40.0, 84.0], [24.0, 52.0]][axis];
    (length / 4.0).clamp(low, high)
}

/// The ticks of both axes, with their names.
pub(crate) struct Axes {
    ticks: [Ticks; 2],
    words: [Option<String>; 2],
}

impl Axes {
    /// The ticks for a layout.
    pub(crate) fn new(lens: &Lens, layout: &Layout, names: &[String]) -> Axes {
        let Frame { left, top, right, bottom } = layout.frame;
        let (lo, hi) = (layout.placement.plane([left, bottom]), layout.placement.plane([right, top]));
        let along = |label: &str| font::width(label, letter::TICK) + 1.6 * letter::TICK;
        let across = |_: &str| 1.8 * letter::TICK;
        let value = |axis: usize, plane: f64| lens.value(axis, plane);
        let ticks = [
            ticks(value(0, lo[0]), value(0, hi[0]), right - left, least(0, right - left), along),
            ticks(value(1, lo[1]), value(1, hi[1]), bottom - top, least(1, bottom - top), across),
        ];
        let words = core::array::from_fn(|axis| {
            let name = names.get(axis).map(String::as_str).unwrap_or_default();
            match (name, ticks[axis].note.as_deref()) {
                ("", note) => note.map(str::to_owned),
                (name, None) => Some(name.to_owned()),
                (name, Some(note)) => Some(format!("{name} ({note})")),
            }
        });
        Axes { ticks, words }
    }

    /// The room that the labels take.
    pub(crate) fn gutter(&self) -> Gutter {
        let width = |text: &str| font::width(text, letter::TICK);
        let widest = self.ticks[1].ticks.iter().map(|t| width(&t.label)).fold(0.0, |m, w| if w > m { w } else { m });
        let last = self.ticks[0].ticks.last().map_or(0.0, |t| width(&t.label) / 2.0 - crate::frame::MARGIN);
        Gutter {
            left: (widest + GAP).ceil(),
            top: if self.words[1].is_some() { LINE } else { 0.0 },
            right: if last > 0.0 { last.ceil() } else { 0.0 },
            bottom: BELOW + if self.words[0].is_some() { LINE } else { 0.0 },
        }
    }

    /// Draws grid and labels; a graph has horizontal grid lines and a base line with ticks.
    pub(crate) fn draw(&self, scene: &mut Scene, lens: &Lens, layout: &Layout, theme: &Theme, graph: bool) {
        let Frame { left, top, right, bottom } = layout.frame;
        let (mut grid, mut zero, mut base) = (Path::new(), Path::new(), Path::new());
        for tick in &self.ticks[0].ticks {
            let x = layout.placement.px([lens.coordinate(0, tick.value), 0.0])[0];
            let line = sharp(x);
            if graph {
                base.line([line, sharp(bottom)], [line, sharp(bottom) + 5.0]);
            } else {
                let path = if tick.value == 0.0 { &mut zero } else { &mut grid };
                path.line([line, top], [line, bottom]);
            }
            let half = font::width(&tick.label, letter::TICK) / 2.0;
            if x - half > 1.0 && x + half < layout.width - 1.0 {
                scene.text(&tick.label, letter::TICK, [x, bottom + BELOW], Align::Center, theme.muted);
            }
        }
        for tick in &self.ticks[1].ticks {
            let y = layout.placement.px([0.0, lens.coordinate(1, tick.value)])[1];
            let path = if tick.value == 0.0 { &mut zero } else { &mut grid };
            if !(graph && bottom - y < CLOSE) {
                path.line([left, sharp(y)], [right, sharp(y)]);
            }
            if left - GAP - font::width(&tick.label, letter::TICK) > 0.0 {
                let baseline = y + 0.34 * letter::TICK;
                scene.text(&tick.label, letter::TICK, [left - GAP, baseline], Align::Right, theme.muted);
            }
        }
        if graph {
            base.line([left, sharp(bottom)], [right, sharp(bottom)]);
        }
        scene.line(grid, Stroke::new(theme.grid, weight::GRID).butt());
        scene.line(zero, Stroke::new(theme.axis, weight::GRID).opacity(0.6).butt());
        scene.line(base, Stroke::new(theme.axis, weight::AXIS).butt());
        if let Some(words) = &self.words[0] {
            let words = font::fit(words, letter::TICK, right - left);
            scene.text(&words, letter::TICK, [right, bottom + BELOW + LINE], Align::Right, theme.muted);
        }
        if let Some(words) = &self.words[1] {
            let from = left - self.gutter().left;
            let words = font::fit(words, letter::TICK, right - from);
            scene.text(
                &words,
                letter::TICK,
                [if from > 0.0 { from } else { 0.0 }, top - 10.0],
                Align::Left,
                theme.muted,
            );
        }
    }
}

/// The middle of a pixel, so that a line one px wide is one pixel wide.
fn sharp(x: f64) -> f64 {
    x.floor() + 0.5
}
