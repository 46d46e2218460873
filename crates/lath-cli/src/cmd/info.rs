//! `lath info`: what a file holds.

use crate::failure::Result;
use crate::input::Reading;
use crate::output;
use lath::curve::{AnyCurve, Curve, CurveVisitor};
use lath::error::Limits;
use lath::num::Bound;
use lath::query::bounds;
use lath_io::format::Content;
use lath_io::number::shortest;
use lath_io::points::PointTable;
use lath_io::shapes::Shape;
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::path::PathBuf;

/// Say what a file holds: curves or points
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Args {
    /// The file of curves or points; `-` is standard input.
    file: PathBuf,
    /// One JSON object instead of text.
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    reading: Reading,
}

const EXAMPLES: &str = "\
Examples:
  lath info curve.json
  lath info wing.dat --json
  lath through wing.dat | lath info -";

/// Writes the description.
pub(crate) fn run(args: &Args, limits: &Limits<'_>) -> Result<()> {
    let (name, content) = args.reading.read(&args.file, limits)?;
    let text = match (content, args.json) {
        (Content::Shapes(shapes), true) => shapes_json(&shapes).to_string() + "\n",
        (Content::Shapes(shapes), false) => shapes_text(&name, &shapes),
        (Content::Points(table), true) => points_json(&table).to_string() + "\n",
        (Content::Points(table), false) => points_text(&name, &table),
    };
    output::write(None, |out| out.write_all(text.as_bytes()).map_err(|error| lath_io::Error::writing(&error)))
}

/// The box of a curve, without the padding.
struct Extent {
    lo: Vec<f64>,
    hi: Vec<f64>,
    bound: Bound,
}

fn extent(curve: &AnyCurve) -> Extent {
    struct Ask;
    impl CurveVisitor for Ask {
        type Output = Extent;
        fn visit<const D: usize>(self, curve: &dyn Curve<D>, dimension: usize) -> Extent {
            let (found, bound) = bounds(curve);
            let cut = |corner: [f64; D]| corner.into_iter().take(dimension).collect();
            Extent { lo: cut(found.lo), hi: cut(found.hi), bound }
        }
    }
    curve.visit(Ask)
}

fn shapes_json(shapes: &[Shape]) -> Value {
    let one = |(index, shape): (usize, &Shape)| {
        let mut object = json!({ "index": index, "kind": shape.kind() });
        if let Some(name) = shape.name() {
            object["name"] = json!(name);
        }
        if let Some(curve) = shape.curve() {
            let (domain, extent) = (curve.domain(), extent(curve));
            object["degree"] = json!(curve.degree());
            object["dimension"] = json!(curve.dimension());
            object["domain"] = json!([domain.start, domain.end]);
            object["box"] = json!([extent.lo, extent.hi]);
            object["box_bound"] = json!({ "value": extent.bound.value(), "proven": extent.bound.is_proven() });
            object["closed"] = json!(curve.is_closed());
            object["breaks"] = json!(curve.breaks().len());
        }
        object
    };
    json!({ "count": shapes.len(), "shapes": shapes.iter().enumerate().map(one).collect::<Vec<_>>() })
}

fn shapes_text(source: &str, shapes: &[Shape]) -> String {
    let count = shapes.len();
    let mut text = format!("{source}: {count} shape{}\n", if count == 1 { "" } else { "s" });
    for (index, shape) in shapes.iter().enumerate() {
        let name = shape.name().map_or_else(String::new, |name| format!(" \"{name}\""));
        // Writing into a String cannot fail.
        let _ = writeln!(text, "\nshape {index}{name}");
        let mut line = |label: &str, value: &dyn std::fmt::Display| {
            let _ = writeln!(text, "  {label:<10} {value}");
        };
        line("kind", &shape.kind());
        if let Some(curve) = shape.curve() {
            let (domain, breaks) = (curve.domain(), curve.breaks().len());
            line("degree", &curve.degree());
            line("dimension", &curve.dimension());
            line("domain", &interval(domain.start, domain.end));
            line("closed", &if curve.is_closed() { "yes" } else { "no" });
            line("breaks", &breaks);
            let extent = extent(curve);
            let estimate = if extent.bound.is_proven() { "" } else { "  (estimate)" };
            box_lines(&mut text, &extent.lo, &extent.hi, estimate);
        }
    }
    text
}

fn points_box(table: &PointTable) -> (Vec<f64>, Vec<f64>) {
    let mut lo = vec![f64::INFINITY; table.width()];
    let mut hi = vec![f64::NEG_INFINITY; table.width()];
    for row in table.rows() {
        for (c, x) in row.iter().enumerate() {
            if *x < lo[c] {
                lo[c] = *x;
            }
            if *x > hi[c] {
                hi[c] = *x;
            }
        }
    }
    (lo, hi)
}

fn points_json(table: &PointTable) -> Value {
    let (lo, hi) = points_box(table);
    json!({ "points": {
        "rows": table.len(),
        "columns": table.width(),
        "names": table.columns(),
        "title": table.title(),
        "box": [lo, hi],
    } })
}

fn points_text(source: &str, table: &PointTable) -> String {
    let (lo, hi) = points_box(table);
    let mut text = format!("{source}: points\n\n");
    if let Some(title) = table.title() {
        let _ = writeln!(text, "  {:<10} {title}", "title");
    }
    let _ = writeln!(text, "  {:<10} {}\n  {:<10} {}", "rows", table.len(), "columns", table.width());
    if let Some(names) = table.columns() {
        let _ = writeln!(text, "  {:<10} {}", "names", names.join(", "));
    }
    box_lines(&mut text, &lo, &hi, "");
    text
}

/// One line for each axis, under the label `box`.
fn box_lines(text: &mut String, lo: &[f64], hi: &[f64], remark: &str) {
    for (axis, (lo, hi)) in lo.iter().zip(hi).enumerate() {
        let (label, remark) = if axis == 0 { ("box", remark) } else { ("", "") };
        let _ = writeln!(text, "  {label:<10} {}{remark}", interval(*lo, *hi));
    }
}

fn interval(start: f64, end: f64) -> String {
    format!("[{}, {}]", shortest(start), shortest(end))
}
