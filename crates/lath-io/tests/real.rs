//! Real files, as others wrote them.
#![allow(clippy::unwrap_used)]

use std::path::PathBuf;

use lath::error::Limits;
use lath_io::points::PointTable;
use lath_io::{format, source::Source};

fn table(name: &str) -> PointTable {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../testdata/real").join(name);
    let limits = Limits::default();
    format::read_points(&Source::open(path, &limits).unwrap(), None, &limits).unwrap()
}

#[test]
fn airfoils_have_a_title_and_two_columns() {
    for (name, title, rows, second) in [
        ("rae2822.dat", "RAE 2822 AIRFOIL", 129, [0.999398, 0.000128]),
        ("naca2412.dat", "NAca 2412 By Naca.exe D. LEDNICER", 69, [0.9978671, 0.0017153]),
        ("clarky.dat", "CLARK Y AIRFOIL", 121, [0.99, 0.002969]),
    ] {
        let t = table(name);
        assert_eq!((t.title(), t.columns(), t.width(), t.len()), (Some(title), None, 2, rows), "{name}");
        assert_eq!((t.row(1), t.line(0), t.line(1)), (Some(&second[..]), Some(2), Some(3)), "{name}");
    }
}

#[test]
fn outlines_close_where_they_began() {
    for (name, rows) in [("iceland.csv", 20), ("italy.csv", 66)] {
        let t = table(name);
        assert_eq!((t.columns().unwrap(), t.len()), (&["lon".to_owned(), "lat".to_owned()][..], rows), "{name}");
        assert_eq!(t.row(0), t.row(rows - 1), "{name}");
    }
}

#[test]
fn series_give_their_years_as_parameters() {
    let (year, volume) = table("nile_flow.csv").split_parameter("year").unwrap();
    assert_eq!((year.len(), year[0], year[99]), (100, 1871.0, 1970.0));
    assert_eq!((volume.width(), volume.values()[0], volume.values()[99]), (1, 1120.0, 740.0));
    let sunspots = table("sunspots_yearly.csv");
    assert_eq!(sunspots.columns().unwrap(), ["YEAR", "SUNACTIVITY"]);
    assert_eq!((sunspots.len(), sunspots.row(308)), (309, Some(&[2008.0, 2.9][..])));
}
