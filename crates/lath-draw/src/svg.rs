//! Scenes as SVG: paths with true Bézier commands, numbers of three decimals with nothing superfluous, stable bytes.
//!
//! A subpath begins at an absolute place and goes on by steps, which are short numbers. Places are rounded first and subtracted
//! as whole thousandths, so that steps add up to the places and rounding never accumulates.

use crate::path::{Path, Point, Segment};
use crate::scene::{Item, Scene, Shape, Stroke};

/// The picture as a complete SVG document. Coordinates are rounded to a thousandth of a px.
///
/// ```
/// use lath_draw::{scene::Scene, theme::Theme};
///
/// let mut scene = Scene::new(80.0, 60.0, Theme::LIGHT.paper);
/// scene.title = "a < b".into();
/// let svg = lath_draw::svg::write(&scene);
/// assert!(svg.starts_with(r#"<svg xmlns="http://www.w3.org/2000/svg" width="80" height="60" viewBox="0 0 80 60" role="img">"#));
/// assert!(svg.contains("<title>a &lt; b</title>"));
/// ```
pub fn write(scene: &Scene) -> String {
    let mut out = String::from(r#"<svg xmlns="http://www.w3.org/2000/svg" width=""#);
    number(&mut out, scene.width);
    out.push_str(r#"" height=""#);
    number(&mut out, scene.height);
    out.push_str(r#"" viewBox="0 0 "#);
    number(&mut out, scene.width);
    out.push(' ');
    number(&mut out, scene.height);
    out.push_str("\" role=\"img\">\n<title>");
    escape(&mut out, &scene.title);
    out.push_str("</title>\n<rect width=\"100%\" height=\"100%\" fill=\"");
    out.push_str(&scene.paper.hex());
    out.push_str("\"/>\n");
    for item in &scene.items {
        write_item(&mut out, item);
    }
    out.push_str("</svg>\n");
    out
}

fn write_item(out: &mut String, item: &Item) {
    match item {
        Item::Fill { path, color, opacity } => {
            path_data(out, path);
            attribute(out, "fill", &color.hex());
            opaque(out, "fill-opacity", *opacity);
            out.push_str("/>\n");
        }
        Item::Line { path, stroke } => {
            path_data(out, path);
            attribute(out, "fill", "none");
            line_style(out, stroke);
            out.push_str("/>\n");
        }
        Item::Marks { shape, size, centers, fill, stroke } => {
            out.push_str("<g");
            attribute(out, "fill", &fill.hex());
            line_style(out, stroke);
            out.push_str(">\n");
            for center in centers {
                mark(out, *shape, *size, *center);
            }
            out.push_str("</g>\n");
        }
    }
}

fn mark(out: &mut String, shape: Shape, size: f64, center: Point) {
    let numbers = match shape {
        Shape::Circle => {
            out.push_str("<circle");
            vec![("cx", center[0]), ("cy", center[1]), ("r", size)]
        }
        Shape::Square => {
            out.push_str("<rect");
            vec![("x", center[0] - size), ("y", center[1] - size), ("width", 2.0 * size), ("height", 2.0 * size)]
        }
    };
    for (name, value) in numbers {
        numeric(out, name, value);
    }
    out.push_str("/>\n");
}

fn path_data(out: &mut String, path: &Path) {
    out.push_str("<path d=\"");
    let (mut pen, mut start) = ([0; 2], [0; 2]);
    for segment in path.segments() {
        match *segment {
            Segment::Move(p) => {
                (pen, start) = (thousandths(p), thousandths(p));
                command(out, 'M', &pen);
            }
            Segment::Line(p) => {
                let [dx, dy] = step(pen, thousandths(p));
                match (dx, dy) {
                    (_, 0) => command(out, 'h', &[dx]),
                    (0, _) => command(out, 'v', &[dy]),
                    _ => command(out, 'l', &[dx, dy]),
                }
                pen = thousandths(p);
            }
            Segment::Quad(a, p) => curve(out, 'q', &mut pen, &[a, p]),
            Segment::Cubic(a, b, p) => curve(out, 'c', &mut pen, &[a, b, p]),
            Segment::Close => {
                out.push('z');
                pen = start;
            }
        }
    }
    out.push('"');
}

/// A Bézier command, its points relative to the pen, which goes to the last.
fn curve(out: &mut String, letter: char, pen: &mut [i64; 2], points: &[Point]) {
    let mut steps = Vec::with_capacity(6);
    for p in points {
        steps.extend(step(*pen, thousandths(*p)));
    }
    command(out, letter, &steps);
    if let Some(last) = points.last() {
        *pen = thousandths(*last);
    }
}

fn thousandths(p: Point) -> [i64; 2] {
    p.map(rounded)
}

fn step(from: [i64; 2], to: [i64; 2]) -> [i64; 2] {
    [to[0] - from[0], to[1] - from[1]]
}

fn command(out: &mut String, letter: char, numbers: &[i64]) {
    out.push(letter);
    for (i, x) in numbers.iter().enumerate() {
        if i > 0 && *x >= 0 {
            out.push(' ');
        }
        decimal(out, *x);
    }
}

fn line_style(out: &mut String, stroke: &Stroke) {
    attribute(out, "stroke", &stroke.color.hex());
    numeric(out, "stroke-width", stroke.width);
    opaque(out, "stroke-opacity", stroke.opacity);
    if !stroke.butt {
        attribute(out, "stroke-linecap", "round");
    }
    attribute(out, "stroke-linejoin", "round");
    if let Some([dash, gap]) = stroke.dash {
        let mut list = String::new();
        number(&mut list, dash);
        list.push(' ');
        number(&mut list, gap);
        attribute(out, "stroke-dasharray", &list);
    }
}

fn attribute(out: &mut String, name: &str, value: &str) {
    out.push(' ');
    out.push_str(name);
    out.push_str("=\"");
    out.push_str(value);
    out.push('"');
}

fn numeric(out: &mut String, name: &str, value: f64) {
    let mut text = String::new();
    number(&mut text, value);
    attribute(out, name, &text);
}

fn opaque(out: &mut String, name: &str, value: f64) {
    if value < 1.0 {
        numeric(out, name, value);
    }
}

/// Rounded to nearest thousandths; what is not a number becomes 0, what is huge is clamped.
fn rounded(x: f64) -> i64 {
    (x.clamp(-1e9, 1e9) * 1000.0).round() as i64 // NaN casts to 0
}

fn number(out: &mut String, x: f64) {
    decimal(out, rounded(x));
}

/// Thousandths as a number of at most three decimals, without superfluous zeros.
fn decimal(out: &mut String, thousandths: i64) {
    let (whole, rest) = (thousandths.unsigned_abs() / 1000, thousandths.unsigned_abs() % 1000);
    if thousandths < 0 {
        out.push('-');
    }
    if whole > 0 || rest == 0 {
        out.push_str(&whole.to_string());
    }
    if rest > 0 {
        out.push('.');
        out.push_str(format!("{rest:03}").trim_end_matches('0'));
    }
}

/// Text content: markup characters escaped, characters that XML 1.0 forbids replaced.
fn escape(out: &mut String, text: &str) {
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '\t' | '\n' | '\r' => out.push(' '),
            '\u{0}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::theme::Theme;

    fn text(x: f64) -> String {
        let mut out = String::new();
        number(&mut out, x);
        out
    }

    #[test]
    fn numbers_are_short_and_stable() {
        for (x, expected) in [
            (0.0, "0"),
            (-0.0, "0"),
            (-0.0004, "0"),
            (1.0, "1"),
            (0.5, ".5"),
            (-0.5, "-.5"),
            (0.01, ".01"),
            (12.3456, "12.346"),
            (-1.25, "-1.25"),
            (100.001, "100.001"),
            (99.9999, "100"),
            (f64::NAN, "0"),
            (f64::INFINITY, "1000000000"),
        ] {
            assert_eq!(text(x), expected);
        }
    }

    #[test]
    fn commands_are_bezier_commands() {
        let mut path = Path::new();
        path.move_to([1.0, -2.0]);
        path.quad_to([3.0, 4.0], [-5.0, 6.5]);
        path.cubic_to([0.0, 0.0], [1.0, 1.0], [2.0, 0.0]);
        path.close();
        let mut scene = Scene::new(10.0, 10.0, Theme::DARK.paper);
        scene.line(path, Stroke::new(Theme::DARK.ink, 1.5).opacity(0.5).dash(4.0, 2.0));
        let svg = write(&scene);
        assert!(svg.contains(r##"<path d="M1-2q2 6-6 8.5c5-6.5 6-5.5 7-6.5z" fill="none" stroke="#e9ecf1" stroke-width="1.5" stroke-opacity=".5" stroke-linecap="round" stroke-linejoin="round" stroke-dasharray="4 2"/>"##), "{svg}");
    }

    #[test]
    fn steps_add_up_to_the_places() {
        // Steps of a third of a thousandth: rounded one by one, all of them would be 0.
        let mut path = Path::new();
        path.move_to([1.0, 1.0]);
        for i in 1..=30 {
            path.line_to([1.0 + f64::from(i) / 3000.0, 1.0]);
        }
        path.close();
        path.line_to([1.0, 5.0]);
        let mut out = String::new();
        path_data(&mut out, &path);
        assert_eq!(out.matches("h.001").count(), 10, "{out}");
        assert!(out.ends_with("zv4\""), "{out}");
    }

    #[test]
    fn titles_cannot_break_the_document() {
        let mut scene = Scene::new(1.0, 1.0, Theme::LIGHT.paper);
        scene.title = "</title><script>&\u{0}\u{ffff}".into();
        let svg = write(&scene);
        assert!(svg.contains("<title>&lt;/title&gt;&lt;script&gt;&amp;\u{fffd}\u{fffd}</title>"), "{svg}");
    }
}
