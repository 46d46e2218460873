//! Writes files for `testdata/interop.py`, which holds them against NumPy and SciPy.

use std::path::PathBuf;

use lath::error::Limits;
use lath_io::source::Source;
use lath_io::{Result, atomic, format};

fn main() -> Result<()> {
    let folder = PathBuf::from(std::env::args().nth(1).unwrap_or_else(|| ".".to_owned()));
    let rows = [[0.1, -0.0, 1e300], [5e-324, 1.0 / 3.0, -2.5]];
    let npy = format::by_name("npy")?;
    atomic::write(folder.join("kept.npy"), |out| {
        let mut sink = npy.rows(out, None)?;
        rows.iter().try_for_each(|row| sink.row(row))?;
        sink.finish()
    })?;
    atomic::write(folder.join("streamed.npy"), |out| {
        let mut sink = npy.rows_counted(out, None, 2)?;
        rows.iter().try_for_each(|row| sink.row(row))?;
        sink.finish()
    })?;
    let names = ["x", "y", "z"].map(String::from);
    atomic::write(folder.join("none.npy"), |out| npy.rows_counted(out, Some(&names), 0)?.finish())?;
    let limits = Limits::default();
    for name in ["splrep.json", "space.json"] {
        let source = Source::open(PathBuf::from("testdata/scipy").join(name), &limits)?;
        let shapes = format::read_shapes(&source, None, &limits)?;
        let scipy = format::by_name("scipy")?;
        atomic::write(folder.join(name), |out| scipy.write_shapes(out, &shapes))?;
    }
    Ok(())
}
