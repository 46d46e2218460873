//! Scenes as PNG, drawn by tiny-skia: the same list, the same look, the same bytes on every machine.
//!
//! Pixels are stored as RGB without alpha (the paper covers everything) and without row filters, which line drawings are better off
//! without: files are a third smaller than with the usual ones.

use crate::path::{Path, Segment};
use crate::scene::{Item, Scene, Shape, Stroke};
use crate::theme::Color;
use lath::error::{Code, Error, Result};
use tiny_skia::{FillRule, LineCap, LineJoin, Paint, PathBuilder, Pixmap, Rect, StrokeDash, Transform};

/// The greatest number of pixels: 256 MiB of memory.
const MOST_PIXELS: f64 = 67_108_864.0;

/// The picture as a PNG file with `density` pixels to the px, so that 2 suits print and dense screens.
///
/// *Errors.* B001 when the picture would have more than 2²⁶ pixels, or none.
///
/// ```
/// use lath_draw::{scene::Scene, theme::Theme};
///
/// let scene = Scene::new(80.0, 60.0, Theme::LIGHT.paper);
/// assert!(lath_draw::png::write(&scene, 1.0)?.starts_with(b"\x89PNG"));
/// assert!(lath_draw::png::write(&scene, 1e9).unwrap_err().is_budget());
/// # Ok::<(), lath::error::Error>(())
/// ```
pub fn write(scene: &Scene, density: f64) -> Result<Vec<u8>> {
    encode(&draw(scene, density)?)
        .map_err(|error| Error::new(Code::B001, format!("the PNG could not be encoded: {error}")))
}

fn encode(pixmap: &Pixmap) -> core::result::Result<Vec<u8>, png::EncodingError> {
    let opaque: Vec<u8> = pixmap.data().chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, pixmap.width(), pixmap.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_deflate_compression(png::DeflateCompression::Level(7));
    encoder.set_filter(png::Filter::NoFilter);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&opaque)?;
    writer.finish()?;
    Ok(bytes)
}

fn draw(scene: &Scene, density: f64) -> Result<Pixmap> {
    let (width, height) = ((scene.width * density).round(), (scene.height * density).round());
    let fits = width >= 1.0 && height >= 1.0 && width * height <= MOST_PIXELS;
    let pixmap = if fits { Pixmap::new(width as u32, height as u32) } else { None };
    let mut pixmap = pixmap.ok_or_else(|| {
        Error::new(Code::B001, format!("a picture of {width} × {height} pixels: the budget is 1 to {MOST_PIXELS}"))
    })?;
    pixmap.fill(paint(scene.paper, 1.0).1);
    let transform = Transform::from_scale(density as f32, density as f32);
    for item in &scene.items {
        draw_item(&mut pixmap, item, transform);
    }
    Ok(pixmap)
}

fn draw_item(pixmap: &mut Pixmap, item: &Item, transform: Transform) {
    match item {
        Item::Fill { path, color, opacity } => {
            if let Some(path) = build(path) {
                pixmap.fill_path(&path, &paint(*color, *opacity).0, FillRule::Winding, transform, None);
            }
        }
        Item::Line { path, stroke } => {
            if let Some(path) = build(path) {
                line(pixmap, &path, stroke, transform);
            }
        }
        Item::Marks { shape, size, centers, fill, stroke } => {
            let size = *size as f32;
            let form = match shape {
                Shape::Circle => PathBuilder::from_circle(0.0, 0.0, size),
                Shape::Square => Rect::from_ltrb(-size, -size, size, size).map(PathBuilder::from_rect),
            };
            let Some(form) = form else { return };
            for center in centers {
                let there = transform.pre_translate(center[0] as f32, center[1] as f32);
                pixmap.fill_path(&form, &paint(*fill, 1.0).0, FillRule::Winding, there, None);
                line(pixmap, &form, stroke, there);
            }
        }
    }
}

fn line(pixmap: &mut Pixmap, path: &tiny_skia::Path, stroke: &Stroke, transform: Transform) {
    let style = tiny_skia::Stroke {
        width: stroke.width as f32,
        line_cap: if stroke.butt { LineCap::Butt } else { LineCap::Round },
        line_join: LineJoin::Round,
        dash: stroke.dash.and_then(|[dash, gap]| StrokeDash::new(vec![dash as f32, gap as f32], 0.0)),
        ..tiny_skia::Stroke::default()
    };
    pixmap.stroke_path(path, &paint(stroke.color, stroke.opacity).0, &style, transform, None);
}

fn paint(color: Color, opacity: f64) -> (Paint<'static>, tiny_skia::Color) {
    let alpha = (opacity.clamp(0.0, 1.0) * 255.0).round() as u8;
    let color = tiny_skia::Color::from_rgba8(color.red, color.green, color.blue, alpha);
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    paint.set_color(color);
    (paint, color)
}

fn build(path: &Path) -> Option<tiny_skia::Path> {
    let mut builder = PathBuilder::with_capacity(path.segments().len(), 3 * path.segments().len());
    for segment in path.segments() {
        match *segment {
            Segment::Move([x, y]) => builder.move_to(x as f32, y as f32),
            Segment::Line([x, y]) => builder.line_to(x as f32, y as f32),
            Segment::Quad([ax, ay], [x, y]) => builder.quad_to(ax as f32, ay as f32, x as f32, y as f32),
            Segment::Cubic([ax, ay], [bx, by], [x, y]) => {
                builder.cubic_to(ax as f32, ay as f32, bx as f32, by as f32, x as f32, y as f32);
            }
            Segment::Close => builder.close(),
        }
    }
    builder.finish()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Align;
    use crate::theme::Theme;

    #[test]
    fn pixels_are_where_the_scene_says() {
        let mut scene = Scene::new(20.0, 10.0, Color::new(255, 255, 255));
        let mut path = Path::new();
        path.polyline([[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]], true);
        scene.fill(path, Color::new(0, 0, 0), 0.5);
        let pixmap = draw(&scene, 2.0).unwrap();
        assert_eq!((pixmap.width(), pixmap.height()), (40, 20));
        assert_eq!(pixmap.pixel(5, 5).unwrap().red(), 127);
        assert_eq!(pixmap.pixel(30, 5).unwrap().red(), 255);
    }

    #[test]
    fn what_is_written_reads_back_as_what_was_drawn() {
        let mut scene = Scene::new(31.0, 17.0, Theme::DARK.paper);
        scene.text("Pq", 12.0, [3.0, 12.0], Align::Left, Theme::DARK.ink);
        let (drawn, bytes) = (draw(&scene, 1.5).unwrap(), write(&scene, 1.5).unwrap());
        let read = Pixmap::decode_png(&bytes).unwrap();
        assert_eq!((read.width(), read.height()), (47, 26));
        assert!(read == drawn && drawn.data().chunks(4).any(|pixel| pixel != &drawn.data()[..4]));
    }

    #[test]
    fn odd_content_draws_nothing_and_does_not_panic() {
        let mut scene = Scene::new(20.0, 10.0, Theme::DARK.paper);
        for x in [f64::NAN, f64::INFINITY, 1e300, -1e12] {
            let mut path = Path::new();
            path.line([0.0, x], [x, 5.0]);
            path.close();
            path.cubic_to([x, x], [0.0, x], [1.0, 1.0]);
            scene.line(path.clone(), Stroke::new(Theme::DARK.ink, x).dash(x, x));
            scene.fill(path, Theme::DARK.ink, x);
            scene.marks(
                Shape::Square,
                x,
                vec![[x, 1.0], [1.0, 1.0]],
                Theme::DARK.ink,
                Stroke::new(Theme::DARK.ink, 1.0),
            );
            scene.text("x", x, [x, x], Align::Center, Theme::DARK.ink);
        }
        assert!(write(&scene, 1.0).is_ok());
        for (w, h) in [(0.0, 10.0), (f64::NAN, 1.0), (-5.0, 5.0), (1e9, 1e9)] {
            assert!(write(&Scene::new(w, h, Theme::DARK.paper), 1.0).unwrap_err().is_budget());
        }
    }
}
