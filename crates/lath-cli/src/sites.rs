//! Where a curve is evaluated: `--at`, `--count`, `--at-file`.

use crate::failure::Result;
use crate::input::Reading;
use crate::numbers::{Numbers, finite, list};
use lath::curve::{AnyCurve, Interval};
use lath::error::{Code, Error, Limits};
use lath_io::points::PointTable;
use std::path::Path;
use std::str::FromStr;

/// What `--at` takes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum At {
    Breaks,
    These(Numbers),
}

impl FromStr for At {
    type Err = String;

    fn from_str(text: &str) -> Result<At, String> {
        match text {
            "breaks" => Ok(At::Breaks),
            _ => list(text, finite).map(|numbers| At::These(Numbers(numbers))),
        }
    }
}

/// The parameters at which a curve is evaluated, in order.
pub(crate) enum Sites {
    /// From the command line, or the breaks.
    Listed(Vec<f64>),
    /// From a file.
    Filed(PointTable),
    /// Equal steps over the domain, both ends included.
    Even { domain: Interval, count: u64 },
}

impl Sites {
    /// As `--at` says.
    pub(crate) fn at(at: &At, curve: &AnyCurve) -> Sites {
        Sites::Listed(match at {
            At::Breaks => curve.breaks(),
            At::These(Numbers(numbers)) => numbers.clone(),
        })
    }

    /// Those in a file, one a row.
    pub(crate) fn in_file(path: &Path, limits: &Limits<'_>) -> Result<Sites> {
        let table = Reading::sniffed().points(path, limits)?;
        if table.width() != 1 {
            let message = format!("rows of {} numbers, but a curve is evaluated at one t a row", table.width());
            let error = table.locate(Error::new(Code::P005, message));
            return Err(error.remedied("Give a file with one column.").into());
        }
        Ok(Sites::Filed(table))
    }

    /// How many there are.
    pub(crate) fn count(&self) -> u64 {
        match self {
            Sites::Listed(t) => t.len() as u64,
            Sites::Filed(table) => table.len() as u64,
            Sites::Even { count, .. } => *count,
        }
    }

    /// The parameters themselves.
    pub(crate) fn iter(&self) -> Box<dyn Iterator<Item = f64> + '_> {
        match self {
            Sites::Listed(t) => Box::new(t.iter().copied()),
            Sites::Filed(table) => Box::new(table.values().iter().copied()),
            Sites::Even { domain, count } => Box::new((0..*count).map(|i| even(*domain, i, *count))),
        }
    }

    /// What the library refused about site `index`, with its place.
    pub(crate) fn locate(&self, index: usize, error: Error) -> lath_io::Error {
        let error = error.at(index);
        match self {
            Sites::Filed(table) => table.locate(error),
            Sites::Listed(_) => lath_io::Error::from(error).in_source("--at"),
            Sites::Even { .. } => lath_io::Error::from(error).in_source("--count"),
        }
    }
}

/// a + (b − a)·i/(N − 1), the last exactly b.
fn even(domain: Interval, i: u64, count: u64) -> f64 {
    let Interval { start, end } = domain;
    if i == 0 {
        return start;
    }
    if i + 1 == count {
        return end;
    }
    let (steps, i) = ((count - 1) as f64, i as f64);
    let product = domain.length() * i;
    let t = start + if product.is_finite() { product / steps } else { domain.length() * (i / steps) };
    // Rounding must not lead outside.
    if t < end { t } else { end }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_steps_end_exactly() {
        let sites =
            |start, end, count| Sites::Even { domain: Interval { start, end }, count }.iter().collect::<Vec<_>>();
        assert_eq!(sites(0.0, 3.0, 7), [0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0]);
        assert_eq!(sites(0.1, 0.7, 1), [0.1]);
        assert_eq!(sites(0.1, 0.7, 2), [0.1, 0.7]);
        let wide = sites(-1e300, 1e300, 1001);
        assert!(wide.windows(2).all(|pair| pair[0] < pair[1]) && wide[1000] == 1e300);
        let narrow = sites(1e16, 1e16 + 4.0, 1000);
        assert!(narrow.iter().all(|t| (1e16..=1e16 + 4.0).contains(t)));
    }
}
