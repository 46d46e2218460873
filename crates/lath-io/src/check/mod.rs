//! What is wrong with a file: all of it at once, and what can be mended.
//!
//! Readers stop at the first fault. [`check`] goes on: it looks at every row of a table, every knot, point and parameter
//! of every shape, also in files that the readers refuse; and where a shape can be built it looks at the curve. Each
//! [`Finding`] has a stable code, a place, a message and a remedy, and one of three severities:
//!
//! - *error*: some reader or constructor refuses it;
//! - *warning*: it is valid, and seldom meant: doubled points, nearly equal knots, cusps;
//! - *note*: worth knowing.
//!
//! What is said of a curve is proven where it follows from its Bézier points (two that coincide make a derivative
//! vanish), and called an estimate where it was searched for (a cusp inside a piece).
//!
//! [`fix`] mends what is safe: it never moves a point, and says in words what it did.
//!
//! ```
//! use lath::error::Limits;
//! use lath_io::{check, source::Source};
//!
//! let source = Source::from_bytes("walk.csv", "x,y\n0,0\n1,nan\n1,2\n1,2\n");
//! let report = check::check(&source, None, &Limits::default())?;
//! let found: Vec<(&str, Option<u64>)> = report.findings().iter().map(|f| (f.code(), f.place().line)).collect();
//! assert_eq!(found, [("P002", Some(3)), ("W005", Some(5))]);
//! let fixed = check::fix(&source, None, &Limits::default())?;
//! assert_eq!(fixed.bytes(), b"x,y\n0,0\n1,2\n");
//! assert!(fixed.report().findings().is_empty());
//! # Ok::<(), lath_io::Error>(())
//! ```

mod codes;
mod document;
mod finding;
mod geometry;
mod knots;
mod mend;
mod members;
mod table;

pub use codes::{CodeEntry, codes};
pub use finding::{Finding, Severity};
pub use mend::{Fixed, fix};

use lath::error::Limits;

use crate::error::Result;
use crate::format::{self, Format};
use crate::number::shortest;
use crate::source::Source;
use finding::Findings;

/// What was found in one file.
#[derive(Clone, Debug)]
pub struct Report {
    findings: Vec<Finding>,
    shapes: Option<usize>,
    points: Option<usize>,
}

impl Report {
    /// The findings, in the order of the file as far as there is one. At most 20 of one code; a last one then says how
    /// many more there are.
    #[must_use]
    pub fn findings(&self) -> &[Finding] {
        &self.findings
    }

    /// How many findings are errors.
    #[must_use]
    pub fn errors(&self) -> usize {
        self.count(Severity::Error)
    }

    /// How many findings are warnings.
    #[must_use]
    pub fn warnings(&self) -> usize {
        self.count(Severity::Warning)
    }

    /// How many findings are notes.
    #[must_use]
    pub fn notes(&self) -> usize {
        self.count(Severity::Note)
    }

    fn count(&self, severity: Severity) -> usize {
        self.findings.iter().filter(|finding| finding.severity() == severity).count()
    }

    /// The number of shapes, where the file holds shapes.
    #[must_use]
    pub fn shapes(&self) -> Option<usize> {
        self.shapes
    }

    /// The number of points that could be read: rows of a table, or points of the shapes.
    #[must_use]
    pub fn points(&self) -> Option<usize> {
        self.points
    }
}

/// Looks for everything that is wrong with a source, in the format it has or in the one named.
///
/// # Errors
/// Only what says nothing about the content: the budget (B001), cancellation (B002), the system.
pub fn check(source: &Source, from: Option<&'static Format>, limits: &Limits<'_>) -> Result<Report> {
    let mut findings = Findings::new(source);
    let mut report = Report { findings: Vec::new(), shapes: None, points: None };
    match format::of_source(source, from) {
        Err(error) => findings.push(error)?,
        Ok(format) => match format.name {
            "json" | "scipy" => document::check(source, limits, &mut findings, &mut report)?,
            "npy" => table::npy(source, limits, &mut findings, &mut report)?,
            _ => table::text(source, limits, &mut findings, &mut report)?,
        },
    }
    report.findings = findings.finish();
    Ok(report)
}

/// The findings of several reports as one JSON object,
/// `{"findings":[{"code","severity","where","message","remedy"}]}`: `schema/check.schema.json`.
///
/// ```
/// use lath::error::Limits;
/// use lath_io::{check, source::Source};
///
/// let report = check::check(&Source::from_bytes("a.csv", "1,2\n"), None, &Limits::default())?;
/// assert_eq!(check::to_json(&[&report]), "{\"findings\":[]}\n");
/// # Ok::<(), lath_io::Error>(())
/// ```
#[must_use]
pub fn to_json(reports: &[&Report]) -> String {
    let text = |text: &str| serde_json::Value::from(text).to_string();
    let one = |finding: &Finding| {
        let severity = text(&finding.severity().to_string());
        format!(
            "\n{{\"code\":{},\"severity\":{severity},\"where\":{},\"message\":{},\"remedy\":{}}}",
            text(finding.code()),
            text(&finding.location()),
            text(finding.message()),
            text(finding.remedy()),
        )
    };
    let findings: Vec<String> = reports.iter().flat_map(|report| report.findings()).map(one).collect();
    let end = if findings.is_empty() { "" } else { "\n" };
    format!("{{\"findings\":[{}{end}]}}\n", findings.join(","))
}

/// A number in a message.
fn show(x: f64) -> String {
    shortest(x).to_string()
}
