//! Axes in space: a box around the data, its far faces with a grid, labels along its silhouette.

use crate::font;
use crate::frame::{Gutter, Layout};
use crate::lens::{Lens, Reach, Spot};
use crate::path::{Path, Point};
use crate::scene::{Align, Scene, Stroke};
use crate::theme::{Theme, letter, weight};
use crate::ticks::ticks;

/// The box of the data.
pub(crate) struct Cage {
    lo: Spot,
    hi: Spot,
}

impl Cage {
    /// Room for labels around the box.
    pub(crate) const GUTTER: Gutter = Gutter { left: 34.0, top: 14.0, right: 34.0, bottom: 24.0 };

    /// The box of the data; around a single place a cube as large as the lens takes for one.
    pub(crate) fn new(reach: &Reach, lens: &Lens) -> Cage {
        if reach.is_finite() && reach.lo != reach.hi {
            return Cage { lo: reach.lo, hi: reach.hi };
        }
        let side = |s: f64| core::array::from_fn(|c| lens.centre[c] + s * lens.unit[c] / 2.0);
        Cage { lo: side(-1.0), hi: side(1.0) }
    }

    pub(crate) fn corners(&self) -> impl Iterator<Item = Spot> {
        (0..8_usize).map(|k| self.corner([k & 1 > 0, k & 2 > 0, k & 4 > 0]))
    }

    fn corner(&self, high: [bool; 3]) -> Spot {
        core::array::from_fn(|c| if high[c] { self.hi[c] } else { self.lo[c] })
    }

    /// Draws the three far faces, and on one edge for each axis its labels.
    pub(crate) fn draw(&self, scene: &mut Scene, lens: &Lens, layout: &Layout, theme: &Theme, names: &[String]) {
        let px = |spot: &Spot| layout.placement.px(lens.plane(spot));
        let towards = lens.view.towards();
        // The far face of each axis is the one that looks away from the camera.
        let far: [bool; 3] = core::array::from_fn(|c| towards[c] < 0.0);
        let (mut grid, mut edges) = (Path::new(), Path::new());
        let middle = px(&core::array::from_fn(|c| self.lo[c] / 2.0 + self.hi[c] / 2.0));
        for axis in 0..3 {
            let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
            let edge = |at_a: bool, at_b: bool| -> (Spot, Spot) {
                let mut high = [false; 3];
                (high[a], high[b]) = (at_a, at_b);
                let from = self.corner(high);
                high[axis] = true;
                (from, self.corner(high))
            };
            // Edges of the far faces; the one opposite the camera's corner belongs to no near face.
            for (at_a, at_b) in [(far[a], far[b]), (far[a], !far[b]), (!far[a], far[b])] {
                let (from, to) = edge(at_a, at_b);
                edges.line(px(&from), px(&to));
            }
            // Labels along the silhouette: the edge between a near and a far face, the lower one, for the upright
            // axis the one to the left.
            let silhouette = [edge(far[a], !far[b]), edge(!far[a], far[b])];
            let place = |e: &(Spot, Spot)| -> Point {
                let (p, q) = (px(&e.0), px(&e.1));
                [(p[0] + q[0]) / 2.0, (p[1] + q[1]) / 2.0]
            };
            let (p, q) = (px(&silhouette[0].0), px(&silhouette[0].1));
            let upright = (q[1] - p[1]).abs() > 2.0 * (q[0] - p[0]).abs();
            let [first, second] = [place(&silhouette[0]), place(&silhouette[1])];
            let take_first = if upright { first[0] < second[0] } else { first[1] > second[1] };
            let (from, to) = silhouette[usize::from(!take_first)];
            let length = lath::space::distance(&px(&from), &px(&to));
            let least = if upright { 44.0 } else { 64.0 };
            let room = |label: &str| {
                let wide = font::width(label, letter::TICK) + letter::TICK;
                if upright { 1.8 * letter::TICK } else { wide }
            };
            let marks = ticks(self.lo[axis], self.hi[axis], length, least, room);
            let outward = outward(px(&from), px(&to), middle);
            let mut last = None;
            for tick in marks.ticks.iter().filter(|_| self.lo[axis] < self.hi[axis] && length > 30.0) {
                let at = |spot: &Spot| {
                    let mut spot = *spot;
                    spot[axis] = tick.value;
                    spot
                };
                // Grid lines on the two far faces that contain this axis.
                let (corner, along_a, along_b) =
                    (edge(far[a], far[b]).0, edge(!far[a], far[b]).0, edge(far[a], !far[b]).0);
                grid.line(px(&at(&corner)), px(&at(&along_a)));
                grid.line(px(&at(&corner)), px(&at(&along_b)));
                let p = px(&at(&from));
                label(scene, theme, &tick.label, p, outward, 9.0);
                last = Some(p);
            }
            let name = names.get(axis).map_or(["x", "y", "z"][axis], String::as_str);
            let name = marks.note.map_or(name.to_owned(), |note| format!("{name} ({note})"));
            if length > 30.0 && last.is_some() {
                // The upright axis has its name above its upper end, where a long note finds room.
                let (p, q) = (px(&from), px(&to));
                let top = if p[1] < q[1] { p } else { q };
                if upright {
                    let half = font::width(&name, letter::TICK) / 2.0;
                    label(scene, theme, &name, [top[0] - half + 3.0, top[1]], [0.0, -1.0], 8.0);
                } else {
                    label(scene, theme, &name, place(&(from, to)), outward, 30.0);
                }
            }
        }
        scene.line(grid, Stroke::new(theme.grid, weight::GRID));
        scene.line(edges, Stroke::new(theme.axis, weight::AXIS).opacity(0.5));
    }
}

/// The unit normal of an edge that points away from the middle.
fn outward(p: Point, q: Point, middle: Point) -> Point {
    let d = [q[0] - p[0], q[1] - p[1]];
    let length = lath::space::norm(&d);
    if length <= 0.0 {
        return [0.0, 1.0];
    }
    let n = [-d[1] / length, d[0] / length];
    let side = n[0] * (p[0] - middle[0]) + n[1] * (p[1] - middle[1]);
    if side < 0.0 { [-n[0], -n[1]] } else { n }
}

/// A text beside a point, its nearest side `gap` px away in the direction `outward`.
fn label(scene: &mut Scene, theme: &Theme, text: &str, p: Point, outward: Point, gap: f64) {
    let half = [font::width(text, letter::TICK) / 2.0, 0.36 * letter::TICK];
    let centre: Point = core::array::from_fn(|c| p[c] + outward[c] * (gap + half[c]));
    // Not beyond the edge of the picture, if it fits at all.
    let (least, most) = (half[0] + 4.0, scene.width - half[0] - 4.0);
    let at = [if least < most { centre[0].clamp(least, most) } else { centre[0] }, centre[1] + half[1]];
    scene.text(text, letter::TICK, at, Align::Center, theme.muted);
}
