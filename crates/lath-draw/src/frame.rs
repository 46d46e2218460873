//! Where the plot stands in the picture: margins, the size that suits the content, and the scale.

use crate::extent::Extent;
use crate::lens::Placement;

/// The air around everything, in px.
pub(crate) const MARGIN: f64 = 28.0;
/// The air between the content and its frame.
const PAD: f64 = 20.0;
/// The width of a picture for which no size is asked, and the greatest height of its plot.
const WIDTH: f64 = 960.0;
const TALLEST: f64 = 640.0;
const GRAPH: f64 = 380.0;

/// A rectangle in px.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Frame {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) right: f64,
    pub(crate) bottom: f64,
}

impl Frame {
    pub(crate) fn width(&self) -> f64 {
        self.right - self.left
    }

    pub(crate) fn height(&self) -> f64 {
        self.bottom - self.top
    }
}

/// Room outside the frame, for labels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Gutter {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) right: f64,
    pub(crate) bottom: f64,
}

impl Gutter {
    /// Room enough for both.
    pub(crate) fn both(&self, other: &Gutter) -> Gutter {
        Gutter {
            left: most(self.left, other.left),
            top: most(self.top, other.top),
            right: most(self.right, other.right),
            bottom: most(self.bottom, other.bottom),
        }
    }
}

/// What is to be arranged.
pub(crate) struct Wish<'a> {
    pub(crate) extent: Extent,
    /// One scale for both axes.
    pub(crate) equal: bool,
    /// The size asked for, if any.
    pub(crate) size: Option<[f64; 2]>,
    pub(crate) gutter: Gutter,
    /// The height of title and legend in a picture of some width.
    pub(crate) header: &'a dyn Fn(f64) -> f64,
}

/// The arrangement.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Layout {
    pub(crate) width: f64,
    pub(crate) height: f64,
    pub(crate) frame: Frame,
    pub(crate) placement: Placement,
}

/// Without a size, the picture takes the shape of its content: wide and low for an airfoil, about square for an island.
pub(crate) fn arrange(wish: &Wish<'_>) -> Layout {
    let (w, h) = (wish.extent.width(), wish.extent.height());
    let gutter = &wish.gutter;
    let beside = 2.0 * MARGIN + gutter.left + gutter.right;
    let (width, height, header) = match wish.size {
        Some([width, height]) => (width, height, (wish.header)(width)),
        None => {
            let (mut plot, mut tall) = (WIDTH - beside, GRAPH);
            if wish.equal {
                let scale = least((plot - 2.0 * PAD) / w, (TALLEST - 2.0 * PAD) / h);
                tall = most(scale * h + 2.0 * PAD, 96.0);
                plot = most(scale * w + 2.0 * PAD, WIDTH / 2.0 - beside);
            }
            let width = (plot + beside).ceil();
            let header = (wish.header)(width);
            (width, (tall + 2.0 * MARGIN + header + gutter.top + gutter.bottom).ceil(), header)
        }
    };
    // In a picture too small for its margins they shrink, then the labels go.
    let margin = least(MARGIN, least(width, height) / 12.0);
    let mut frame = Frame {
        left: margin + gutter.left,
        top: margin + header + gutter.top,
        right: width - margin - gutter.right,
        bottom: height - margin - gutter.bottom,
    };
    if frame.width() < width / 4.0 {
        (frame.left, frame.right) = (margin, width - margin);
    }
    if frame.height() < height / 4.0 {
        (frame.top, frame.bottom) = (margin, height - margin);
    }
    let pad = least(PAD, least(frame.width(), frame.height()) / 8.0);
    let mut scale = [(frame.width() - 2.0 * pad) / w, (frame.height() - 2.0 * pad) / h];
    if wish.equal {
        scale = [least(scale[0], scale[1]); 2];
    }
    let origin = [
        (frame.left + frame.right) / 2.0 - scale[0] * (wish.extent.lo[0] + wish.extent.hi[0]) / 2.0,
        (frame.top + frame.bottom) / 2.0 + scale[1] * (wish.extent.lo[1] + wish.extent.hi[1]) / 2.0,
    ];
    Layout { width, height, frame, placement: Placement { scale, origin } }
}

fn least(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

fn most(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wish(extent: Extent, equal: bool, size: Option<[f64; 2]>) -> Layout {
        arrange(&Wish { extent, equal, size, gutter: Gutter::default(), header: &|_| 0.0 })
    }

    #[test]
    fn a_flat_subject_gets_a_flat_picture() {
        let airfoil = wish(Extent { lo: [-0.5, -0.06], hi: [0.5, 0.06] }, true, None);
        assert_eq!(airfoil.width, 960.0);
        assert!(airfoil.height < 220.0, "{}", airfoil.height);
        let pole = wish(Extent { lo: [0.0, 0.0], hi: [0.1, 1.0] }, true, None);
        assert!(pole.width == 480.0 && pole.height > 600.0);
    }

    #[test]
    fn the_content_lies_in_the_frame_at_any_size() {
        for size in [[16.0, 16.0], [16.0, 4000.0], [3000.0, 20.0], [640.0, 480.0]] {
            for (w, h) in [(1.0, 1.0), (0.0, 1.0), (1.0, 0.0), (1e-9, 1.0)] {
                let extent = Extent { lo: [3.0, -2.0], hi: [3.0 + w, -2.0 + h] };
                let layout = wish(extent, true, Some(size));
                for corner in [extent.lo, extent.hi] {
                    let [x, y] = layout.placement.px(corner);
                    assert!(x > 0.0 && x < size[0] && y > 0.0 && y < size[1], "{size:?} {x} {y}");
                }
            }
        }
    }
}
