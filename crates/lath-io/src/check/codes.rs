//! Every code that a finding may have.

use crate::check::finding::Severity;
use crate::error::Code;

/// One code with what it means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct CodeEntry {
    /// `"K004"`.
    pub code: &'static str,
    /// How bad it is.
    pub severity: Severity,
    /// What is wrong, in a few words.
    pub summary: &'static str,
    /// What to do when nothing more is known.
    pub remedy: &'static str,
}

/// All codes that [`check`](crate::check::check()) may find, in order: its own first, then those of the readers, then
/// those of the core. `docs/CHECK.md` is this table.
pub fn codes() -> impl Iterator<Item = CodeEntry> {
    let own = Code::ALL.iter().copied().filter(|code| code.as_str().starts_with('W'));
    let readers = Code::ALL.iter().copied().filter(|code| code.as_str().starts_with('F') && !is_output(*code));
    let concerns = |code: &lath::error::Code| code.as_str().starts_with(['K', 'P', 'T', 'R', 'C']);
    let core = lath::error::Code::ALL.iter().filter(move |code| concerns(code)).map(|&code| Code::Core(code));
    own.chain(readers).chain(core).map(|code| CodeEntry {
        code: code.as_str(),
        severity: severity(code),
        summary: code.summary(),
        remedy: code.remedy(),
    })
}

/// Codes of choosing columns and of writing: no fault of a file.
fn is_output(code: Code) -> bool {
    matches!(code, Code::F009 | Code::F021 | Code::F022 | Code::F023 | Code::F024)
}

/// How bad a finding of this code is.
pub(crate) fn severity(code: Code) -> Severity {
    match code {
        Code::W002 | Code::W004 | Code::W009 | Code::W016 | Code::W017 | Code::W019 => Severity::Note,
        code if code.as_str().starts_with('W') => Severity::Warning,
        _ => Severity::Error,
    }
}
