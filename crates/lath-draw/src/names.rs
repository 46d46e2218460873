//! Names beside points: each outside the bend of its polygon, none over another.

use crate::font;
use crate::path::Point;
use crate::scene::{Align, Scene};
use crate::theme::{Color, letter};

/// How far the middle of a name stands from its point, beyond half of the name itself: near, or further where lines are near.
const GAPS: [f64; 2] = [9.0, 17.0];
/// The height of letters relative to their size.
const HEIGHT: f64 = 0.72;

/// The half extent of a dot that a name must leave visible.
const DOT: f64 = 4.0;
/// Names may stand in so many directions from their points.
const DIRECTIONS: usize = 24;

/// Where names must not stand, and where they had better not: centre and half extent of dots and names, and lines.
#[derive(Default)]
pub(crate) struct Names {
    boxes: Vec<(Point, Point)>,
    lines: Vec<(Point, Point)>,
}

impl Names {
    /// Keeps the points of a layer visible, and its lines if it has any.
    pub(crate) fn avoid(&mut self, centers: &[Point], joined: bool, closed: bool) {
        self.boxes.extend(centers.iter().map(|at| (*at, [DOT, DOT])));
        if joined {
            self.lines.extend(centers.windows(2).map(|pair| (pair[0], pair[1])));
        }
        if let (true, [first, .., last]) = (joined && closed, centers) {
            self.lines.push((*last, *first));
        }
    }

    /// Keeps names off a line, unless there are too many to be kept off.
    pub(crate) fn avoid_line(&mut self, from: Point, to: Point) {
        const MOST: usize = 20_000;
        if self.lines.len() < MOST {
            self.lines.push((from, to));
        }
    }

    /// Writes `name` beside the middle one of three neighbouring points (the point itself twice at an end): as far away from the
    /// others as it can without covering a point or a name, crossing few lines; not at all where there is no such place.
    pub(crate) fn write(
        &mut self,
        scene: &mut Scene,
        name: &str,
        (before, at, behind): (Point, Point, Point),
        color: Color,
    ) {
        let half = [font::width(name, letter::TICK) / 2.0, letter::TICK * HEIGHT / 2.0];
        let [x, y] = outwards(before, at, behind);
        let mut best: Option<(usize, Point)> = None;
        for (gap, k) in GAPS.into_iter().flat_map(|gap| (0..DIRECTIONS).map(move |k| (gap, k))) {
            // Outwards first, then ever further round, to both sides in turn.
            let turns = k.div_ceil(2) as f64 * if k % 2 == 0 { 1.0 } else { -1.0 };
            let angle = core::f64::consts::TAU * turns / DIRECTIONS as f64;
            let (sin, cos) = (libm::sin(angle), libm::cos(angle));
            let away = [x * cos - y * sin, x * sin + y * cos];
            let reach = gap + away[0].abs() * half[0] + away[1].abs() * half[1];
            let middle = [at[0] + away[0] * reach, at[1] + away[1] * reach];
            let inside = middle[0] > half[0]
                && middle[1] > half[1]
                && middle[0] + half[0] < scene.width
                && middle[1] + half[1] < scene.height;
            let free = |(other, extent): &(Point, Point)| {
                (0..2).any(|c| (middle[c] - other[c]).abs() >= half[c] + extent[c] + 1.5)
            };
            if inside && self.boxes.iter().all(free) {
                let crossed =
                    self.lines.iter().filter(|line| crosses(line, middle, [half[0] + 1.5, half[1] + 1.5])).count();
                if best.is_none_or(|(least, _)| crossed < least) {
                    best = Some((crossed, middle));
                }
            }
        }
        if let Some((_, middle)) = best {
            scene.text(name, letter::TICK, [middle[0], middle[1] + half[1]], Align::Center, color);
            self.boxes.push((middle, half));
        }
    }
}

/// Whether a line passes through a box: clipped to it (Liang and Barsky 1984), something is left.
fn crosses((from, to): &(Point, Point), middle: Point, half: Point) -> bool {
    let (mut start, mut end) = (0.0, 1.0);
    for c in 0..2 {
        let (step, low, high) = (to[c] - from[c], middle[c] - half[c] - from[c], middle[c] + half[c] - from[c]);
        if step == 0.0 {
            if low > 0.0 || high < 0.0 {
                return false;
            }
            continue;
        }
        let (enter, leave) = if step > 0.0 { (low / step, high / step) } else { (high / step, low / step) };
        start = if enter > start { enter } else { start };
        end = if leave < end { leave } else { end };
    }
    start <= end
}

/// The direction away from the neighbours; across the line where they pull in opposite directions, upwards alone.
fn outwards(before: Point, at: Point, behind: Point) -> Point {
    let unit = |to: Point| {
        let (x, y) = (to[0] - at[0], to[1] - at[1]);
        let length = libm::sqrt(x * x + y * y);
        if length > 0.0 { [x / length, y / length] } else { [0.0, 0.0] }
    };
    let (a, b) = (unit(before), unit(behind));
    let (x, y) = (-(a[0] + b[0]), -(a[1] + b[1]));
    let length = libm::sqrt(x * x + y * y);
    if length > 0.2 {
        return [x / length, y / length];
    }
    // Nearly straight: across, and upwards rather than downwards.
    let across = [b[1] - a[1], a[0] - b[0]];
    let length = libm::sqrt(across[0] * across[0] + across[1] * across[1]);
    if length == 0.0 {
        return [0.0, -1.0];
    }
    let sign = if across[1] > 0.0 { -1.0 } else { 1.0 };
    [sign * across[0] / length, sign * across[1] / length]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_through_a_box_are_seen() {
        let crossed = |from, to| crosses(&(from, to), [10.0, 10.0], [2.0, 1.0]);
        assert!(
            crossed([0.0, 10.0], [20.0, 10.0])
                && crossed([9.0, 0.0], [11.0, 20.0])
                && crossed([9.0, 10.0], [9.0, 10.0])
        );
        assert!(
            !crossed([0.0, 0.0], [20.0, 0.0])
                && !crossed([0.0, 0.0], [7.0, 20.0])
                && !crossed([0.0, 10.0], [7.0, 10.0])
        );
    }

    #[test]
    fn names_stand_outside_the_bend() {
        // y down: a corner whose neighbours are below it; a straight line; a lone point.
        assert_eq!(outwards([-1.0, 1.0], [0.0, 0.0], [1.0, 1.0]), [0.0, -1.0]);
        assert_eq!(outwards([-1.0, 0.0], [0.0, 0.0], [1.0, 0.0]), [0.0, -1.0]);
        assert_eq!(outwards([0.0, 0.0], [0.0, 0.0], [0.0, 0.0]), [0.0, -1.0]);
        assert_eq!(outwards([0.0, 0.0], [0.0, 0.0], [0.0, 5.0]), [0.0, -1.0]);
    }
}
