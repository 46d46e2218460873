//! Numbers with what is known of their error, for people and for programs.

use lath::num::Bound;
use lath_io::number::shortest;
use serde_json::{Value, json};

/// `{"value": …, "proven": …}`
pub(crate) fn bound_json(bound: Bound) -> Value {
    json!({ "value": bound.value(), "proven": bound.is_proven() })
}

/// The number as far as it is known, and how far it may be off: `2.9578857 ± 3e-10`.
pub(crate) fn with_margin(x: f64, bound: Bound) -> String {
    format!("{}{}", rounded(x, bound), margin(bound))
}

/// How far an answer may be off.
fn margin(bound: Bound) -> String {
    match (bound.value(), bound.is_proven()) {
        (0.0, true) => String::new(),
        // Half as much again, so that one digit is not less than the bound.
        (value, proven) => format!(" ± {:.0e}{}", 1.5 * value, if proven { "" } else { "  (estimate)" }),
    }
}

/// The number with as many decimals as its bound lets stand.
pub(crate) fn rounded(x: f64, bound: Bound) -> String {
    let (mut step, mut decimals) = (1.0, 0);
    while step > bound.value() && decimals < 16 {
        step /= 10.0;
        decimals += 1;
    }
    if bound.value() <= 0.0 || decimals == 16 || !(1e-4..1e15).contains(&x.abs()) {
        return shortest(x).to_string();
    }
    let text = format!("{x:.decimals$}");
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}
