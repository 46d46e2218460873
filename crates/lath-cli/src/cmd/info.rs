//! `lath info`: what a file holds.

use crate::accuracy::Accuracy;
use crate::certainty::{bound_json, rounded, with_margin};
use crate::failure::Result;
use crate::input::Reading;
use crate::output;
use lath::curve::{AnyCurve, Curve, CurveVisitor};
use lath::error::Limits;
use lath::num::Bound;
use lath::query::{Area, Continuity, area, bounds, continuity};
use lath_io::format::Content;
use lath_io::number::{counted, shortest};
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
        (Content::Shapes(shapes), true) => shapes_json(&shapes, limits).to_string() + "\n",
        (Content::Shapes(shapes), false) => shapes_text(&name, &shapes, limits),
        (Content::Points(table), true) => points_json(&table).to_string() + "\n",
        (Content::Points(table), false) => points_text(&name, &table),
    };
    output::write(None, |out| out.write_all(text.as_bytes()).map_err(|error| lath_io::Error::writing(&error)))
}

/// What the library finds out about a curve.
struct Facts {
    lo: Vec<f64>,
    hi: Vec<f64>,
    bound: Bound,
    /// Of curves in two dimensions and more.
    length: Option<(f64, Bound)>,
    /// Of closed plane curves.
    area: Option<Area>,
    /// At every inner break, and at the seam of a closed curve.
    continuity: Vec<(f64, Continuity)>,
}

impl Facts {
    fn of(curve: &AnyCurve, limits: &Limits<'_>) -> Facts {
        struct Ask;
        impl CurveVisitor for Ask {
            type Output = Facts;
            fn visit<const D: usize>(self, curve: &dyn Curve<D>, dimension: usize) -> Facts {
                let (found, bound) = bounds(curve);
                let cut = |corner: [f64; D]| corner.into_iter().take(dimension).collect();
                Facts {
                    lo: cut(found.lo),
                    hi: cut(found.hi),
                    bound,
                    length: None,
                    area: None,
                    continuity: continuity(curve),
                }
            }
        }
        let mut facts = curve.visit(Ask);
        if curve.dimension() > 1 {
            facts.length = Accuracy::default().length(curve, limits).ok();
        }
        // Refused where the ends do not meet: then there is none.
        facts.area = curve.in_plane().and_then(|curve| area(curve).ok());
        facts
    }
}

fn shapes_json(shapes: &[Shape], limits: &Limits<'_>) -> Value {
    let one = |(index, shape): (usize, &Shape)| {
        let mut object = json!({ "index": index, "kind": shape.kind() });
        if let Some(name) = shape.name() {
            object["name"] = json!(name);
        }
        if let Some(curve) = shape.curve() {
            let (domain, facts) = (curve.domain(), Facts::of(curve, limits));
            object["degree"] = json!(curve.degree());
            object["dimension"] = json!(curve.dimension());
            object["domain"] = json!([domain.start, domain.end]);
            object["box"] = json!([facts.lo, facts.hi]);
            object["box_bound"] = bound_json(facts.bound);
            object["closed"] = json!(curve.is_closed());
            object["rational"] = json!(curve.is_rational());
            object["breaks"] = json!(curve.breaks().len());
            let at = |(t, continuity): &(f64, Continuity)| json!({ "t": t, "continuity": continuity.to_string() });
            object["continuity"] = facts.continuity.iter().map(at).collect();
            if let Some((length, bound)) = facts.length {
                object["length"] = json!(length);
                object["length_bound"] = bound_json(bound);
            }
            if let Some(area) = facts.area {
                object["area"] = json!(area.signed);
                object["area_bound"] = bound_json(area.bound);
                if let Some((centroid, bound)) = area.centroid {
                    object["centroid"] = json!(centroid);
                    object["centroid_bound"] = bound_json(bound);
                }
            }
        }
        object
    };
    json!({ "count": shapes.len(), "shapes": shapes.iter().enumerate().map(one).collect::<Vec<_>>() })
}

fn shapes_text(source: &str, shapes: &[Shape], limits: &Limits<'_>) -> String {
    let count = shapes.len();
    let mut text = format!("{source}: {}\n", counted(count, "shape"));
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
            if curve.is_rational() {
                line("rational", &"yes");
            }
            line("breaks", &breaks);
            let facts = Facts::of(curve, limits);
            line("continuity", &joints(&facts.continuity));
            if let Some((length, bound)) = facts.length {
                line("length", &with_margin(length, bound));
            }
            if let Some(area) = facts.area {
                line("area", &with_margin(area.signed, area.bound));
            }
            let axes = facts.lo.iter().zip(&facts.hi);
            let axes: Vec<String> = axes
                .map(|(lo, hi)| format!("[{}, {}]", rounded(*lo, facts.bound), rounded(*hi, facts.bound)))
                .collect();
            box_lines(&mut text, &axes, if facts.bound.is_proven() { "" } else { "  (estimate)" });
        }
    }
    text
}

/// `C2 at 5 breaks, C0 at t = 2, 4`: the most frequent continuity by number, the others by place.
fn joints(found: &[(f64, Continuity)]) -> String {
    /// More places would not be read.
    const MOST: usize = 6;
    let mut kinds: Vec<(Continuity, Vec<f64>)> = Vec::new();
    for (t, continuity) in found {
        match kinds.iter_mut().find(|(kind, _)| kind == continuity) {
            Some((_, places)) => places.push(*t),
            None => kinds.push((*continuity, vec![*t])),
        }
    }
    kinds.sort_by_key(|(_, places)| std::cmp::Reverse(places.len()));
    let one = |(i, (kind, places)): (usize, &(Continuity, Vec<f64>))| match (i, places.len()) {
        (1.., 1..=MOST) => {
            let places: Vec<String> = places.iter().map(|t| shortest(*t).to_string()).collect();
            format!("{kind} at t = {}", places.join(", "))
        }
        (_, count) => format!("{kind} at {}", counted(count, "break")),
    };
    match kinds.is_empty() {
        true => "one piece".into(),
        false => kinds.iter().enumerate().map(one).collect::<Vec<_>>().join(", "),
    }
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
    let axes: Vec<String> = lo.iter().zip(&hi).map(|(lo, hi)| interval(*lo, *hi)).collect();
    box_lines(&mut text, &axes, "");
    text
}

/// One line for each axis, under the label `box`.
fn box_lines(text: &mut String, axes: &[String], remark: &str) {
    for (axis, range) in axes.iter().enumerate() {
        let (label, remark) = if axis == 0 { ("box", remark) } else { ("", "") };
        let _ = writeln!(text, "  {label:<10} {range}{remark}");
    }
}

fn interval(start: f64, end: f64) -> String {
    format!("[{}, {}]", shortest(start), shortest(end))
}
