//! Points as NumPy's `.npy`: one row a point.
//!
//! Versions 1.0 to 3.0; C and Fortran order; either byte order. `float64` is taken as it is; `float32` and integers are
//! widened where a double holds them exactly, which is always but for 64-bit integers beyond 2⁵³ (F014). Every other
//! dtype is refused by name. Shapes are `(n,)`, points in one dimension, and `(n, m)`.
//!
//! The header is believed only as far as the bytes behind it: they must be exactly as many as it says, and nothing is
//! allocated before that is known. An `.npy` file has no names of columns.

use lath::error::Limits;

use crate::error::{Error, Result};
pub(crate) use crate::points::npy_header::MAGIC;
use crate::points::npy_scan::Scan;
pub(crate) use crate::points::npy_scan::not_finite;
use crate::points::table::{PointTable, RowsAt};
use crate::source::Source;
use crate::stream::Stream;

/// Reads an `.npy` file.
///
/// ```
/// use lath::error::Limits;
/// use lath_io::{format, points::npy, source::Source};
///
/// let mut bytes = Vec::new();
/// let mut rows = format::by_name("npy")?.rows(&mut bytes, None)?;
/// rows.row(&[0.5, 1.0])?;
/// rows.row(&[1.5, 2.0])?;
/// rows.finish()?;
/// drop(rows);
/// let table = npy::read(&Source::from_bytes("a.npy", bytes), &Limits::default())?;
/// assert_eq!((table.width(), table.values()), (2, &[0.5, 1.0, 1.5, 2.0][..]));
/// # Ok::<(), lath_io::Error>(())
/// ```
///
/// # Errors
/// F025 what is no `.npy`, is cut off or too long, or has another dtype or shape; F014 an integer that no double holds;
/// P001 no rows, P002 NaN or infinity with the row's index, P006 no columns; B001 above the budget.
pub fn read(source: &Source, limits: &Limits<'_>) -> Result<PointTable> {
    table(source, limits, true).map(|(table, _)| table)
}

/// The table, and whether it was float64; `finite` refuses NaN and infinities.
pub(crate) fn table(source: &Source, limits: &Limits<'_>, finite: bool) -> Result<(PointTable, bool)> {
    let mut scan = Scan::new(Stream::of(source), limits)?;
    // The bytes of all numbers are there: neither product overflows.
    let count = scan.rows * scan.width as u64;
    let bytes = (source.bytes().len() as u64).saturating_add(count.saturating_mul(8));
    limits.check_bytes(bytes).map_err(|error| Error::from(error).in_source(source.name()))?;
    let mut values = Vec::with_capacity(usize::try_from(count).unwrap_or(0));
    for index in 0..scan.rows {
        let start = values.len();
        scan.row(&mut values)?;
        let row = values.get(start..).unwrap_or_default();
        if let Some((column, x)) = row.iter().enumerate().find(|(_, x)| finite && !x.is_finite()) {
            return Err(not_finite(index, column, *x).in_source(source.name()));
        }
    }
    let (width, float64) = (scan.width, scan.number.is_float64());
    let source = Some(source.name().to_owned());
    Ok((PointTable { source, title: None, columns: None, width, values, rows_at: RowsAt::Nowhere }, float64))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn npy(version: u8, text: &str, data: &[u8]) -> Vec<u8> {
        let mut bytes = [MAGIC, &[version, 0]].concat();
        match version {
            1 => bytes.extend((text.len() as u16).to_le_bytes()),
            _ => bytes.extend((text.len() as u32).to_le_bytes()),
        }
        bytes.extend(text.as_bytes());
        bytes.extend(data);
        bytes
    }

    fn header(descr: &str, fortran: &str, shape: &str) -> String {
        format!("{{'descr': {descr}, 'fortran_order': {fortran}, 'shape': {shape}, }}\n")
    }

    fn table(bytes: &[u8]) -> PointTable {
        read(&Source::from_bytes("a.npy", bytes), &Limits::default()).unwrap()
    }

    fn fault(bytes: &[u8]) -> (&'static str, String) {
        let error = read(&Source::from_bytes("a.npy", bytes), &Limits::default()).unwrap_err();
        assert_eq!(error.place().source.as_deref(), Some("a.npy"));
        (error.code().as_str(), error.message().to_owned())
    }

    fn message(descr: &str, shape: &str, data: &[u8]) -> String {
        let (code, message) = fault(&npy(1, &header(descr, "False", shape), data));
        assert_eq!(code, "F025", "{message}");
        message
    }

    #[test]
    fn versions_orders_and_types_are_read() {
        let data: Vec<u8> = [1.0_f64, -0.0, 5e-324, 1e300].iter().flat_map(|x| x.to_le_bytes()).collect();
        for version in [1, 2, 3] {
            let t = table(&npy(version, &header("'<f8'", "False", "(2, 2)"), &data));
            assert_eq!((t.width(), t.len(), t.values()[2], t.values()[1].is_sign_negative()), (2, 2, 5e-324, true));
        }
        let t = table(&npy(1, &header("\"<f8\"", "True", "(2,2)"), &data));
        assert_eq!(t.values(), [1.0, 5e-324, 0.0, 1e300]);
        assert_eq!(table(&npy(1, &header("'<f8'", "False", "(4,)"), &data)).width(), 1);
        let big: Vec<u8> = [1.5_f64, -2.0].iter().flat_map(|x| x.to_be_bytes()).collect();
        assert_eq!(table(&npy(1, &header("'>f8'", "False", "(2,)"), &big)).values(), [1.5, -2.0]);
        let cases: [(&str, Vec<u8>, f64); 8] = [
            ("'<f4'", 0.1_f32.to_le_bytes().to_vec(), f64::from(0.1_f32)),
            ("'>f4'", (-2.5_f32).to_be_bytes().to_vec(), -2.5),
            ("'<i4'", (-7_i32).to_le_bytes().to_vec(), -7.0),
            ("'>i2'", (-7_i16).to_be_bytes().to_vec(), -7.0),
            ("'|i1'", vec![0xFF], -1.0),
            ("'|u1'", vec![0xFF], 255.0),
            ("'<u4'", u32::MAX.to_le_bytes().to_vec(), 4294967295.0),
            ("'<i8'", (-9007199254740992_i64).to_le_bytes().to_vec(), -9007199254740992.0),
        ];
        for (descr, data, value) in cases {
            assert_eq!(table(&npy(1, &header(descr, "False", "(1,)"), &data)).values(), [value], "{descr}");
        }
    }

    #[test]
    fn integers_beyond_a_double_are_refused() {
        for (descr, data) in [
            ("'<i8'", 9007199254740993_i64.to_le_bytes()),
            ("'<i8'", i64::MAX.to_le_bytes()),
            ("'<u8'", u64::MAX.to_le_bytes()),
        ] {
            assert_eq!(fault(&npy(1, &header(descr, "False", "(1,)"), &data)).0, "F014");
        }
    }

    #[test]
    fn headers_that_lie_are_refused() {
        let eight = [0; 8];
        assert_eq!(message("'<f8'", "(2,)", &eight), "the shape (2, 1) of <f8 takes 16 bytes, but 8 follow");
        assert_eq!(message("'<f8'", "(1,)", &[0; 9]), "the shape (1, 1) of <f8 takes 8 bytes, but 9 follow");
        assert_eq!(
            message("'<f8'", "(4611686018427387904, 4)", &eight),
            "the shape (4611686018427387904, 4) of <f8 takes more bytes than can be counted, but 8 follow"
        );
        assert!(message("'<f8'", "(2305843009213693953,)", &eight).contains("more bytes than can be counted"));
        assert_eq!(
            message("'<f8'", "(99999999999999999999,)", &eight),
            "the shape has the huge number 99999999999999999999"
        );
        assert_eq!(
            message("'<f8'", "(-1,)", &eight),
            "the header has \"-1,), }\" where a whole number from 0 is needed"
        );
        assert_eq!(message("'<f8'", "()", &eight), "the array has 0 dimensions, not 1 or 2");
        assert_eq!(message("'<f8'", "(1,1,1)", &eight), "the array has 3 dimensions, not 1 or 2");
        assert_eq!(fault(&npy(1, &header("'<f8'", "False", "(0, 3)"), &[])).0, "P001");
        assert_eq!(fault(&npy(1, &header("'<f8'", "False", "(3, 0)"), &[])).0, "P006");
    }

    #[test]
    fn other_types_are_refused_by_name() {
        for descr in ["<c16", "|O", "<U10", "|b1", "<f2", "<f16", "<M8[D]", "|V8", "f8", "=f8", "|f8", "", "é8"] {
            let message = message(&format!("'{descr}'"), "(1,)", &[0; 8]);
            assert_eq!(message, format!("the numbers are of dtype {descr:?}, which is not read"));
        }
        assert!(message("[('x', '<f8')]", "(1,)", &[0; 8]).contains("records"));
    }

    #[test]
    fn headers_that_are_none_are_refused() {
        let whole = npy(1, &header("'<f8'", "False", "(1,)"), &[0; 8]);
        for length in 0..whole.len() {
            assert_eq!(fault(&whole[..length]).0, "F025", "{length}");
        }
        for text in
            ["", "{", "{}", "{'descr'", "{'descr': 1}", "{'a': 1}", "{'shape': (1,), 'shape': (1,)}", "{'shape': (1"]
        {
            assert_eq!(fault(&npy(1, text, &[])).0, "F025", "{text}");
        }
        assert_eq!(
            fault(&npy(4, &header("'<f8'", "False", "(1,)"), &[0; 8])).1,
            "version 4.0 of .npy is not known; there are 1.0, 2.0 and 3.0"
        );
        assert_eq!(fault(&npy(1, &(header("'<f8'", "False", "(1,)") + "x"), &[0; 8])).0, "F025");
        assert_eq!(fault(&npy(1, &header("'<f8'", "0", "(1,)"), &[0; 8])).0, "F025");
        assert_eq!(fault(&npy(1, &header("'<f8'", "False", &"(1,".repeat(70)), &[0; 8])).0, "F025");
    }

    #[test]
    fn what_is_not_finite_names_its_row() {
        let data: Vec<u8> = [1.0, 2.0, 3.0, f64::NAN].iter().flat_map(|x: &f64| x.to_le_bytes()).collect();
        let error =
            read(&Source::from_bytes("a.npy", npy(1, &header("'<f8'", "False", "(2, 2)"), &data)), &Limits::default());
        let error = error.unwrap_err();
        assert_eq!(
            (error.code().as_str(), error.place().index, error.message()),
            ("P002", Some(1), "column 1 of row 1 is NaN")
        );
    }

    #[test]
    fn the_budget_counts_rows() {
        let source = Source::from_bytes("a.npy", npy(1, &header("'|u1'", "False", "(100,)"), &[1; 100]));
        let code = |limits| read(&source, &limits).map(|t| t.len()).map_err(|e| e.code().as_str());
        assert_eq!(code(Limits { max_points: 99, ..Limits::default() }), Err("B001"));
        assert_eq!(code(Limits { max_bytes: 800, ..Limits::default() }), Err("B001"));
        assert_eq!(code(Limits { max_points: 100, ..Limits::default() }), Ok(100));
    }
}
