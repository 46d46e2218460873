//! Choosing columns, by name or by index from 0.

use crate::error::{Code, Error, Result};
use crate::points::PointTable;

impl PointTable {
    /// The table of these columns, in the order given; a column may be taken twice.
    ///
    /// A name of the header goes before an index: where a column is called `0`, `0` means that one.
    ///
    /// ```
    /// use lath_io::points::PointTable;
    ///
    /// let names = ["x", "y", "z"].map(String::from).to_vec();
    /// let table = PointTable::new(Some(names), 3, vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0])?;
    /// assert_eq!(table.take_columns(&["z", "0"])?.values(), [3.0, 1.0, 6.0, 4.0]);
    /// let error = table.take_columns(&["w"]).unwrap_err();
    /// assert_eq!(error.message(), "there is no column \"w\" among \"x\", \"y\", \"z\"");
    /// # Ok::<(), lath_io::Error>(())
    /// ```
    ///
    /// # Errors
    /// F009 a column that is not there, the message listing those that are, or no column at all; F022 a name that two
    /// columns have.
    pub fn take_columns<S: AsRef<str>>(&self, wanted: &[S]) -> Result<PointTable> {
        let columns = self.columns.as_deref();
        let indices = choose(columns, self.width, wanted).map_err(|error| self.named(error))?;
        Ok(self.with_columns(&indices))
    }

    /// One column as parameters (or weights), and the table of all others.
    ///
    /// # Errors
    /// F009 where the column is not there or is the only one, F022 a name that two columns have.
    pub fn split_parameter(&self, name: &str) -> Result<(Vec<f64>, PointTable)> {
        let index = self.column(name)?;
        if self.width == 1 {
            return Err(self.no_column(format!("beside the column \"{name}\" there is none left for coordinates")));
        }
        let others: Vec<usize> = (0..self.width).filter(|&i| i != index).collect();
        let parameters = self.rows().filter_map(|row| row.get(index).copied()).collect();
        Ok((parameters, self.with_columns(&others)))
    }

    fn column(&self, name: &str) -> Result<usize> {
        find(self.columns.as_deref(), self.width, name).map_err(|error| self.named(error))
    }

    fn no_column(&self, message: String) -> Error {
        self.named(Error::new(Code::F009, message))
    }

    fn named(&self, error: Error) -> Error {
        match &self.source {
            Some(source) => error.in_source(source),
            None => error,
        }
    }

    fn with_columns(&self, indices: &[usize]) -> PointTable {
        let pick = |row: &[f64]| indices.iter().filter_map(|&i| row.get(i).copied()).collect::<Vec<_>>();
        let names = |all: &Vec<String>| indices.iter().filter_map(|&i| all.get(i).cloned()).collect();
        PointTable {
            source: self.source.clone(),
            title: self.title.clone(),
            columns: self.columns.as_ref().map(names),
            width: indices.len(),
            values: self.rows().flat_map(pick).collect(),
            rows_at: self.rows_at.clone(),
        }
    }
}

/// The indices of these columns, at least one.
pub(crate) fn choose<S: AsRef<str>>(names: Option<&[String]>, width: usize, wanted: &[S]) -> Result<Vec<usize>> {
    if wanted.is_empty() {
        return Err(Error::new(Code::F009, "no column is chosen"));
    }
    wanted.iter().map(|name| find(names, width, name.as_ref())).collect()
}

/// The index of the column called `name`, or of the one with that index, among `width` columns.
pub(crate) fn find(names: Option<&[String]>, width: usize, name: &str) -> Result<usize> {
    let name = name.trim();
    let mut matching = names.unwrap_or_default().iter().enumerate().filter(|(_, n)| n.as_str() == name).map(|(i, _)| i);
    match (matching.next(), matching.next()) {
        (Some(index), None) => Ok(index),
        (Some(first), Some(second)) => {
            Err(Error::new(Code::F022, format!("the columns {first} and {second} are both called \"{name}\"")))
        }
        (None, _) => match name.parse::<usize>() {
            Ok(index) if index < width => Ok(index),
            _ => {
                Err(Error::new(Code::F009, format!("there is no column \"{name}\" among {}", available(names, width))))
            }
        },
    }
}

/// How many names a message lists.
const LISTED: usize = 20;

fn available(names: Option<&[String]>, width: usize) -> String {
    match names {
        Some(names) => {
            let more = if names.len() > LISTED { ", …" } else { "" };
            let listed: Vec<String> = names.iter().take(LISTED).map(|name| format!("\"{name}\"")).collect();
            listed.join(", ") + more
        }
        None if width == 1 => "the one without a name, 0".to_owned(),
        None => format!("the {width} without names, 0 to {}", width.saturating_sub(1)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(names: Option<&[&str]>, width: usize) -> PointTable {
        let names = names.map(|names| names.iter().map(|&n| n.to_owned()).collect());
        let values = (0..2 * width).map(|i| i as f64).collect();
        PointTable { source: Some("t.csv".into()), ..PointTable::new(names, width, values).unwrap() }
    }

    #[test]
    fn columns_by_name_and_index() {
        let t = table(Some(&["a", "1", "b"]), 3);
        assert_eq!(t.take_columns(&["b", " a "]).unwrap().values(), [2.0, 0.0, 5.0, 3.0]);
        assert_eq!(t.take_columns(&["1", "2"]).unwrap().columns().unwrap(), ["1", "b"]);
        assert_eq!(table(None, 2).take_columns(&["1", "1"]).unwrap().values(), [1.0, 1.0, 3.0, 3.0]);
    }

    #[test]
    fn one_column_splits_off() {
        let (t, rest) = table(Some(&["x", "t", "y"]), 3).split_parameter("t").unwrap();
        assert_eq!((t, rest.values()), (vec![1.0, 4.0], &[0.0, 2.0, 3.0, 5.0][..]));
        assert_eq!(rest.columns().unwrap(), ["x", "y"]);
    }

    #[test]
    fn refusals_list_the_columns() {
        let message = |t: &PointTable, name: &str| {
            let error = t.take_columns(&[name]).unwrap_err();
            assert_eq!(error.place().source.as_deref(), Some("t.csv"));
            (error.code().as_str(), error.message().to_owned())
        };
        assert_eq!(
            message(&table(None, 2), "x"),
            ("F009", "there is no column \"x\" among the 2 without names, 0 to 1".into())
        );
        assert_eq!(
            message(&table(None, 1), "1"),
            ("F009", "there is no column \"1\" among the one without a name, 0".into())
        );
        assert_eq!(
            message(&table(Some(&["x", "x"]), 2), "x"),
            ("F022", "the columns 0 and 1 are both called \"x\"".into())
        );
        let error = table(None, 1).split_parameter("0").unwrap_err();
        assert_eq!(error.code().as_str(), "F009");
        assert_eq!(table(None, 1).take_columns::<&str>(&[]).unwrap_err().code().as_str(), "F009");
    }
}
