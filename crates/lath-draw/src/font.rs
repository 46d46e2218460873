//! Letters as outlines of one bundled font, so that a label has the same shape in every viewer and every format.
//!
//! The font is Cantarell Regular (SIL Open Font License 1.1, beside the font in `assets/`). A character that it lacks is
//! drawn by a near relative (a superscript minus by a small raised minus, unusual spaces by a space) and otherwise by the
//! font's box for missing glyphs: nothing disappears silently. No kerning, no ligatures, no right-to-left text: these
//! are labels.

use crate::path::{Path, Point};
use skrifa::instance::{LocationRef, Size};
use skrifa::outline::{DrawSettings, OutlinePen};
use skrifa::{FontRef, GlyphId, MetadataProvider};

static CANTARELL: &[u8] = include_bytes!("../assets/Cantarell-Regular.otf");

/// The outline of a text and its width, both in px: letters `size` px high (from the lowest descender to the highest
/// ascender), the baseline along y = 0 from x = 0.
///
/// ```
/// let (path, width) = lath_draw::font::outline("κ = 1.5", 13.0);
/// assert!(!path.is_empty());
/// assert_eq!(width, lath_draw::font::width("κ = 1.5", 13.0));
/// ```
pub fn outline(text: &str, size: f64) -> (Path, f64) {
    let mut path = Path::new();
    let width = set(text, size, Some(&mut path));
    (path, width)
}

/// The width of a text in px.
pub fn width(text: &str, size: f64) -> f64 {
    set(text, size, None)
}

/// The text itself if it is not wider than `room` px, else its longest beginning that fits with "…" behind it.
///
/// ```
/// assert_eq!(lath_draw::font::fit("abc", 13.0, 100.0), "abc");
/// assert!(lath_draw::font::fit("a long label", 13.0, 40.0).ends_with('…'));
/// ```
pub fn fit(text: &str, size: f64, room: f64) -> String {
    // No letter is narrower than a fiftieth of its size on average: what lies far beyond cannot fit.
    let most = (room / size * 50.0).clamp(0.0, 1e6) as usize;
    if text.chars().nth(most).is_none() && width(text, size) <= room {
        return text.to_owned();
    }
    let mut kept = String::new();
    let mut used = width("…", size);
    for c in text.chars() {
        used += width(c.encode_utf8(&mut [0; 4]), size);
        if used > room {
            break;
        }
        kept.push(c);
    }
    kept.truncate(kept.trim_end().len());
    kept.push('…');
    kept
}

/// How a character is drawn: by which character, at what share of the size, raised by what share.
fn relative(c: char) -> (char, f64, f64) {
    match c {
        '⁻' => ('−', 0.62, 0.3),
        '⁺' => ('+', 0.62, 0.3),
        '\u{202f}' | '\u{2009}' => (' ', 0.7, 0.0),
        c if c.is_whitespace() || c.is_control() => (' ', 1.0, 0.0),
        c => (c, 1.0, 0.0),
    }
}

fn set(text: &str, size: f64, mut path: Option<&mut Path>) -> f64 {
    let Ok(font) = FontRef::new(CANTARELL) else { return 0.0 };
    let (charmap, glyphs) = (font.charmap(), font.outline_glyphs());
    let metrics = font.glyph_metrics(Size::new(1.0), LocationRef::default());
    let mut x = 0.0;
    for c in text.chars() {
        let (c, share, raise) = relative(c);
        let id = charmap.map(c).unwrap_or(GlyphId::NOTDEF);
        let scale = size * share;
        if let (Some(path), Some(glyph)) = (path.as_deref_mut(), glyphs.get(id)) {
            let mut pen = Pen { path, scale, origin: [x, -raise * size] };
            // A glyph that cannot be read leaves its width blank; the bundled font has none.
            let _ = glyph.draw(DrawSettings::unhinted(Size::new(1000.0), LocationRef::default()), &mut pen);
        }
        x += scale * f64::from(metrics.advance_width(id).unwrap_or(0.5));
    }
    x
}

/// Receives outlines of 1000 units per em, y up.
struct Pen<'a> {
    path: &'a mut Path,
    scale: f64,
    origin: Point,
}

impl Pen<'_> {
    fn at(&self, x: f32, y: f32) -> Point {
        let unit = self.scale / 1000.0;
        [self.origin[0] + unit * f64::from(x), self.origin[1] - unit * f64::from(y)]
    }
}

impl OutlinePen for Pen<'_> {
    fn move_to(&mut self, x: f32, y: f32) {
        self.path.move_to(self.at(x, y));
    }
    fn line_to(&mut self, x: f32, y: f32) {
        self.path.line_to(self.at(x, y));
    }
    fn quad_to(&mut self, ax: f32, ay: f32, x: f32, y: f32) {
        self.path.quad_to(self.at(ax, ay), self.at(x, y));
    }
    fn curve_to(&mut self, ax: f32, ay: f32, bx: f32, by: f32, x: f32, y: f32) {
        self.path.cubic_to(self.at(ax, ay), self.at(bx, by), self.at(x, y));
    }
    fn close(&mut self) {
        self.path.close();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn widths_add_up_and_scale() {
        let sum = width("1", 10.0) + width("8", 10.0) + width("7", 10.0);
        assert!((width("187", 10.0) - sum).abs() < 1e-12);
        assert!((width("187", 20.0) - 2.0 * sum).abs() < 1e-12);
        assert_eq!(width("", 10.0), 0.0);
        assert!(width("m", 10.0) > width("i", 10.0));
    }

    #[test]
    fn every_character_we_write_ourselves_is_in_the_font() {
        let font = FontRef::new(CANTARELL).unwrap();
        for c in
            "abcdefghijklmnopqrstuvwxyz ABCDEFGHIJKLMNOPQRSTUVWXYZ 0123456789 .,:;()[]/+−×=…κ″′≈⁰¹²³⁴⁵⁶⁷⁸⁹⁻\u{2009}"
                .chars()
        {
            assert!(font.charmap().map(relative(c).0).is_some(), "{c}");
        }
    }

    #[test]
    fn a_missing_glyph_is_a_box_not_a_gap() {
        for text in ["漢", "\u{10ffff}", "🙂"] {
            let (path, width) = outline(text, 12.0);
            assert!(!path.is_empty() && width > 0.0, "{text}");
        }
        assert!(outline("\n\t\u{0}", 12.0).0.is_empty());
    }

    #[test]
    fn fitting_keeps_what_fits() {
        let room = 60.0;
        let short = fit("the quick brown fox jumps over the lazy dog", 12.0, room);
        assert!(short.ends_with('…') && width(&short, 12.0) <= room);
        assert_eq!(fit("anything", 12.0, 0.0), "…");
        assert!(fit(&"x".repeat(10_000_000), 12.0, room).len() < 40);
    }
}
