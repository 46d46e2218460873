//! Work is refused before it begins if it would not end soon.
//!
//! Exact arithmetic has no fixed price: an operation costs the more, the more digits its fractions have. So the work of an
//! answer is estimated as a number of operations times the 64-bit words of their operands, and [`POINTS`] points of the
//! budget ([`Limits::max_points`]) pay for one of them. The default budget of 2³¹ points ends within about a minute.

use crate::error::{Code, Error, Result};
use crate::rational::Rational;
use lath::error::Limits;

/// What one operation on fractions of one word costs: about as much as sixteen operations on floats.
const POINTS: u64 = 16;

/// Refuses `operations` operations on fractions of up to `bits` bits (B001); reports a cancellation (B002).
pub(crate) fn check(limits: &Limits<'_>, operations: u64, bits: u64) -> Result<()> {
    limits.check_cancel()?;
    let words = 1 + bits / 64;
    let points = operations.saturating_mul(words).saturating_mul(POINTS);
    if points <= limits.max_points {
        return Ok(());
    }
    // Where a product stopped at the greatest number, it is a bound and no count.
    let (work, budget) = (points / POINTS, limits.max_points / POINTS);
    let work = if points == u64::MAX { "more than 10¹⁸".to_owned() } else { work.to_string() };
    let message = format!(
        "{work} operations on fractions of one word; the budget of {} points pays for {budget}",
        limits.max_points
    );
    Err(Error::new(Code::Core(lath::error::Code::B001), message))
}

/// Refuses an answer of `numbers` fractions of up to `bits` bits (B001).
pub(crate) fn check_size(limits: &Limits<'_>, numbers: u64, bits: u64) -> Result<()> {
    // The fraction itself, and its digits printed.
    limits.check_bytes(numbers.saturating_mul(64 + bits / 2))?;
    Ok(())
}

/// The bits of the longest of some numbers, once they stand over one denominator, which is how differences of them grow.
pub(crate) fn bits<'a>(values: impl IntoIterator<Item = &'a Rational>) -> u64 {
    values.into_iter().map(Rational::bits).max().unwrap_or(1)
}

/// a · b · …, or the greatest number if that is beyond it.
pub(crate) fn product(factors: &[usize]) -> u64 {
    factors.iter().fold(1u64, |product, factor| product.saturating_mul(*factor as u64))
}
