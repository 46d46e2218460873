//! The tool's arguments, as lines of text.
//!
//! The files they may name lie in a folder made for the purpose ([`FILES`]), and a line is made harmless before it is run: it
//! names no other folder, and asks for no great picture and no great budget.

/// The files of the folder where the lines are run.
pub const FILES: [(&str, &str); 5] = [
    ("points.csv", "x,y\n0,0\n1,2\n3,2\n4,0\n"),
    ("space.txt", "0 0 0\n1 2 1\n3 2 5\n4 0 1\n6 1 0\n"),
    ("broken.csv", "x,y\n0,0\n1,nan\n1,2\n1,2\n"),
    (
        "curve.json",
        "{\"lath\":1,\"shapes\":[{\"kind\":\"bspline\",\"degree\":3,\"closed\":true,\"points\":[[0,0],[1,2],[3,2],[4,0]]}]}\n",
    ),
    (
        "two.json",
        "{\"lath\":1,\"shapes\":[{\"kind\":\"bezier\",\"points\":[[0,0],[1,2],[3,2]]},{\"kind\":\"polyline\",\"points\":[[0,0,0],[1,1,5]]}]}\n",
    ),
];

/// Enough for every example, and soon reached.
const BUDGET: &str = "--budget=60000";

/// What the bytes say to the tool, without its own name; none where running it might do harm or take long.
#[must_use]
pub fn line(bytes: &[u8]) -> Option<Vec<String>> {
    let text = std::str::from_utf8(bytes).ok()?;
    let mut arguments: Vec<String> = text.split('\n').map(str::to_owned).collect();
    if arguments.len() > 40 || !arguments.iter().all(|argument| harmless(argument)) {
        return None;
    }
    arguments.insert(0, BUDGET.to_owned());
    Some(arguments)
}

fn harmless(argument: &str) -> bool {
    // A slash is good for fractions only.
    let mut slashes = argument.match_indices('/').map(|(at, _)| argument.as_bytes().get(at + 1));
    let inside = slashes.all(|next| next.is_some_and(u8::is_ascii_digit))
        && !argument.contains("..")
        && !argument.starts_with('/');
    // No side of a picture above 999 pixels, no other budget, no standard input (nobody is there to end it), nothing that
    // the system refuses to hand over.
    let figures = argument.split(|c: char| !c.is_ascii_digit()).map(str::len).max().unwrap_or(0);
    let small = !argument.contains(['x', 'X', '×']) || figures < 4;
    let budget = argument.starts_with("--budget") || argument.contains("%");
    inside && small && !budget && argument != "-" && !argument.contains('\0')
}

/// Whether a run ended as the contract says: the exit code, and what stands on standard output and error where that is known.
pub fn judge(code: Option<i32>, written: Option<(&[u8], &str)>) {
    assert!(matches!(code, Some(0..=5)), "exit {code:?}: {written:?}");
    let Some((out, err)) = written else { return };
    assert!(!err.contains("panicked"), "{err}");
    if matches!(code, Some(2..=5)) {
        assert!(out.is_empty() && !err.is_empty(), "exit {code:?} with {} bytes on standard output: {err}", out.len());
    }
    if matches!(code, Some(3..=5)) {
        assert!(err.starts_with("lath: ") && err.contains("\nRemedy: "), "{err}");
    }
}
