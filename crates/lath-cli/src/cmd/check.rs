//! `lath check`: everything that is wrong with files, and what can be mended.

use crate::failure::{Failure, Result};
use crate::input::{Reading, check_standard_input};
use crate::output;
use crate::report::excerpt;
use crate::voice::Voice;
use lath::error::Limits;
use lath_io::Error;
use lath_io::check::{self, Finding, Report};
use lath_io::number::counted;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// Say everything that is wrong with files, and mend what is safe to mend
///
/// Other verbs stop at the first fault; this one goes on, and looks at the curves as well. An error is what another verb
/// would refuse, a warning what is valid and seldom meant. The exit code is 1 where an error is found.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Args {
    /// The files of points or curves; `-` is standard input.
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Mend what is safe, say what was changed, and report what is left. No point is moved.
    #[arg(long)]
    fix: bool,
    /// One JSON object instead of text: {"findings":[…]}; with --fix, changes are told on standard error.
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    reading: Reading,
}

const EXAMPLES: &str = "\
Examples:
  lath check wing.csv curve.json
  lath check wing.csv --fix
  lath check *.json --json > findings.json";

/// What was found in one file, and how the file was mended.
struct Checked<'a> {
    path: &'a Path,
    name: String,
    report: Report,
    changes: Vec<String>,
    mended: Option<Vec<u8>>,
}

/// Checks, mends, and reports.
pub(crate) fn run(args: &Args, limits: &Limits<'_>, voice: Voice) -> Result<()> {
    check_standard_input(args.files.iter().map(PathBuf::as_path))?;
    if args.fix && args.files.iter().any(|path| path.as_os_str() == "-") {
        return Err(Failure::usage("'--fix' changes files, and standard input ('-') is none"));
    }
    // All files are read before the first is changed, and all are changed before anything is said.
    let checked = args.files.iter().map(|path| look(args, path, limits)).collect::<Result<Vec<Checked<'_>>>>()?;
    for file in &checked {
        if let Some(bytes) = &file.mended {
            output::write(Some(file.path), |out| out.write_all(bytes).map_err(|error| Error::writing(&error)))?;
        }
    }
    let text = if args.json {
        for file in &checked {
            file.changes.iter().for_each(|change| voice.note(&format!("{}: mended: {change}", file.name)));
        }
        check::to_json(&checked.iter().map(|file| &file.report).collect::<Vec<_>>())
    } else {
        checked.iter().map(described).collect()
    };
    output::write(None, |out| out.write_all(text.as_bytes()).map_err(|error| Error::writing(&error)))?;
    match checked.iter().any(|file| file.report.errors() > 0) {
        true => Err(Failure::Found),
        false => Ok(()),
    }
}

fn look<'a>(args: &Args, path: &'a Path, limits: &Limits<'_>) -> Result<Checked<'a>> {
    let (source, format) = args.reading.source(path, limits)?;
    let name = source.name().to_owned();
    if !args.fix {
        let report = check::check(&source, format, limits)?;
        return Ok(Checked { path, name, report, changes: Vec::new(), mended: None });
    }
    let fixed = check::fix(&source, format, limits)?;
    let mended = (!fixed.changes().is_empty()).then(|| fixed.bytes().to_vec());
    Ok(Checked { path, name, report: fixed.report().clone(), changes: fixed.changes().to_vec(), mended })
}

/// Changes, findings, and a line that sums up.
fn described(file: &Checked<'_>) -> String {
    let mut text = String::new();
    // Writing into a String cannot fail.
    for change in &file.changes {
        let _ = writeln!(text, "{}: mended: {change}", file.name);
    }
    for finding in file.report.findings() {
        text.push_str(&shown(finding));
    }
    let report = &file.report;
    let count = |n: usize, word: &str| (n > 0).then(|| counted(n, word));
    let held = [report.shapes().and_then(|n| count(n, "shape")), report.points().and_then(|n| count(n, "point"))];
    let held: Vec<String> = held.into_iter().flatten().collect();
    let found = [(report.errors(), "error"), (report.warnings(), "warning"), (report.notes(), "note")];
    let found: Vec<String> = found.into_iter().filter_map(|(n, word)| count(n, word)).collect();
    let found = if found.is_empty() { "nothing found".to_owned() } else { found.join(", ") };
    let held = if held.is_empty() { String::new() } else { format!(" in {}", held.join(", ")) };
    let _ = writeln!(text, "{}: {found}{held}", file.name);
    text
}

fn shown(finding: &Finding) -> String {
    let (place, severity, code) = (finding.location(), finding.severity(), finding.code());
    let mut text = format!("{place}: {severity} {code}: {}\n", finding.message());
    text.push_str(&excerpt(finding.place().line, finding.excerpt(), finding.caret()));
    text + "  " + finding.remedy() + "\n"
}
