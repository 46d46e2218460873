//! Where a curve is evaluated: `--at`, `--count`, `--at-file`.

use crate::failure::Result;
use crate::input::{Reading, not_points};
use crate::numbers::{Numbers, finite, list};
use lath::curve::{AnyCurve, Interval};
use lath::error::{Code, Error, Limits};
use lath_io::format::Opened;
use lath_io::number::counted;
use lath_io::points::Rows;
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

/// The parameters at which a curve is evaluated, one after the other and as often as needed. None of them is kept.
pub(crate) struct Sites<'a> {
    origin: Origin<'a>,
    /// How many have been handed out.
    done: u64,
}

enum Origin<'a> {
    /// The command line, or the breaks.
    List(Vec<f64>),
    /// A file.
    File(Rows<'a>),
    /// Equal steps over the domain, both ends included.
    Steps { domain: Interval, count: u64 },
}

impl<'a> Sites<'a> {
    fn new(origin: Origin<'a>) -> Sites<'a> {
        Sites { origin, done: 0 }
    }

    /// As `--at` says.
    pub(crate) fn at(at: &At, curve: &AnyCurve) -> Sites<'a> {
        Sites::new(Origin::List(match at {
            At::Breaks => curve.breaks(),
            At::These(Numbers(numbers)) => numbers.clone(),
        }))
    }

    /// In equal steps over the domain, both ends included.
    pub(crate) fn even(domain: Interval, count: u64) -> Sites<'a> {
        Sites::new(Origin::Steps { domain, count })
    }

    /// Those in a file, one a row.
    pub(crate) fn in_file(path: &Path, limits: &'a Limits<'a>) -> Result<Sites<'a>> {
        match Reading::sniffed().open(path, &[], limits)? {
            Opened::Rows(rows) => Ok(Sites::new(Origin::File(rows))),
            Opened::Shapes(_) => Err(not_points(path)),
        }
    }

    /// How many there are, where that is known before all are read.
    pub(crate) fn count(&self) -> Option<u64> {
        match &self.origin {
            Origin::List(t) => Some(t.len() as u64),
            Origin::File(_) => None,
            Origin::Steps { count, .. } => Some(*count),
        }
    }

    /// The next parameter.
    pub(crate) fn next(&mut self) -> lath_io::Result<Option<f64>> {
        let t = match &mut self.origin {
            Origin::List(t) => usize::try_from(self.done).ok().and_then(|i| t.get(i).copied()),
            Origin::Steps { domain, count } => (self.done < *count).then(|| even(*domain, self.done, *count)),
            Origin::File(rows) => match rows.next_row()? {
                None => None,
                Some(&[t]) => Some(t),
                Some(row) => {
                    let message =
                        format!("rows of {}, but a curve is evaluated at one t a row", counted(row.len(), "number"));
                    let error = lath_io::Error::from(Error::new(Code::P005, message));
                    let error = rows.source().into_iter().fold(error, lath_io::Error::in_source);
                    return Err(error.remedied("Give a file with one column."));
                }
            },
        };
        self.done += u64::from(t.is_some());
        Ok(t)
    }

    /// Goes back before the first.
    pub(crate) fn rewind(&mut self) -> lath_io::Result<()> {
        self.done = 0;
        match &mut self.origin {
            Origin::File(rows) => rows.rewind(),
            _ => Ok(()),
        }
    }

    /// What the library refused about the last parameter, with its place.
    pub(crate) fn locate(&self, error: Error) -> lath_io::Error {
        let option = match &self.origin {
            Origin::File(rows) => return rows.locate(error),
            Origin::List(_) => "--at",
            Origin::Steps { .. } => "--count",
        };
        let index = usize::try_from(self.done.saturating_sub(1)).unwrap_or(usize::MAX);
        lath_io::Error::from(error.at(index)).in_source(option)
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
#[allow(clippy::unwrap_used)] // a failing unwrap is a failing test
mod tests {
    use super::*;

    #[test]
    fn equal_steps_end_exactly() {
        let sites = |start, end, count| {
            let mut sites = Sites::even(Interval { start, end }, count);
            std::iter::from_fn(move || sites.next().unwrap()).collect::<Vec<_>>()
        };
        assert_eq!(sites(0.0, 3.0, 7), [0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0]);
        assert_eq!(sites(0.1, 0.7, 1), [0.1]);
        assert_eq!(sites(0.1, 0.7, 2), [0.1, 0.7]);
        let wide = sites(-1e300, 1e300, 1001);
        assert!(wide.windows(2).all(|pair| pair[0] < pair[1]) && wide[1000] == 1e300);
        let narrow = sites(1e16, 1e16 + 4.0, 1000);
        assert!(narrow.iter().all(|t| (1e16..=1e16 + 4.0).contains(t)));
    }
}
