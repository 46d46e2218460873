//! Budgets and cancellation, handed to whatever can run long.

use crate::error::{Code, Error, Result};
use alloc::format;
use alloc::string::ToString;
use core::sync::atomic::{AtomicBool, Ordering};

/// A budget for one piece of work, and a flag by which another thread can end it.
///
/// The default is the command line's: 2³¹ points, 4 GiB.
///
/// ```
/// use lath::error::Limits;
///
/// let limits = Limits { max_points: 1_000, ..Limits::default() };
/// assert!(limits.check_points(1_000).is_ok());
/// assert!(limits.check_points(1_001).unwrap_err().is_budget());
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Limits<'a> {
    /// The greatest number of points that may be produced.
    pub max_points: u64,
    /// The greatest number of bytes that may be allocated.
    pub max_bytes: u64,
    /// Work stops soon after this turns true.
    pub cancel: Option<&'a AtomicBool>,
}

impl Default for Limits<'_> {
    fn default() -> Self {
        Limits { max_points: 1 << 31, max_bytes: 4 << 30, cancel: None }
    }
}

impl Limits<'_> {
    /// Refuses more than `max_points` points (B001).
    pub fn check_points(&self, points: u64) -> Result<()> {
        check("points", points, self.max_points)
    }

    /// Refuses more than `max_bytes` bytes (B001).
    pub fn check_bytes(&self, bytes: u64) -> Result<()> {
        check("bytes", bytes, self.max_bytes)
    }

    /// Fails when the work was cancelled (B002).
    pub fn check_cancel(&self) -> Result<()> {
        match self.cancel {
            Some(flag) if flag.load(Ordering::Relaxed) => Err(Error::new(Code::B002, "cancelled on request")),
            _ => Ok(()),
        }
    }
}

fn check(unit: &str, wanted: u64, budget: u64) -> Result<()> {
    if wanted <= budget {
        return Ok(());
    }
    // Callers multiply sizes and stop at the greatest number: then it is a bound, not a count.
    let wanted = if wanted == u64::MAX { "more than 10¹⁹".to_string() } else { wanted.to_string() };
    Err(Error::new(Code::B001, format!("{wanted} {unit} are above the budget of {budget}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_product_that_stopped_at_the_greatest_number_is_no_count() {
        let limits = Limits::default();
        let message = |points| limits.check_points(points).unwrap_err().message().to_string();
        assert_eq!(message(1 << 40), "1099511627776 points are above the budget of 2147483648");
        assert_eq!(message(u64::MAX), "more than 10¹⁹ points are above the budget of 2147483648");
        assert!(limits.check_bytes(u64::MAX).unwrap_err().message().starts_with("more than 10¹⁹ bytes"));
    }
}
