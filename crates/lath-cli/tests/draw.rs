//! `lath draw`: pictures of points and curves.
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

mod tool;

use tool::{Folder, lath, lath_from, real};

const ARCH: &str = "0,0\n1,2\n3,2\n4,0\n";
const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";

/// The SVG drawn from standard input.
#[track_caller]
fn svg(input: &str, args: &str) -> String {
    let svg = lath_from(input, ["draw", "-", "-o", "-"].into_iter().chain(args.split_whitespace())).done();
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>") && !svg.contains("NaN"), "{svg}");
    svg
}

/// Width and height of a PNG.
fn pixels(png: &[u8]) -> (u32, u32) {
    assert_eq!(&png[..8], PNG);
    let number = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().unwrap());
    (number(16), number(20))
}

#[test]
fn an_airfoil_in_one_go() {
    let folder = Folder::new();
    let path = folder.path("airfoil.svg");
    assert_eq!(lath(["draw", &real("rae2822.dat"), "--through", "--comb", "--axes", "-o", &path]).done(), "");
    let svg = std::fs::read_to_string(&path).unwrap();
    assert!(svg.contains("<title>RAE 2822 AIRFOIL</title>"));
    // A true Bézier path: one cubic for each of the 128 spans, or more commands in it than spans.
    assert!(svg.lines().any(|line| line.contains(" d=\"") && line.matches(['C', 'c']).count() >= 128));
    let again = folder.path("again.svg");
    lath(["draw", &real("rae2822.dat"), "--through", "--comb", "--axes", "-o", &again]).done();
    assert_eq!(std::fs::read_to_string(again).unwrap(), svg);
}

#[test]
fn formats_follow_extension_or_option() {
    let folder = Folder::new();
    let path = folder.path("arch.png");
    lath_from(ARCH, ["draw", "-", "--through", "-o", &path, "--size", "320x200"]).done();
    assert_eq!(pixels(&std::fs::read(&path).unwrap()), (320, 200));
    lath_from(ARCH, ["draw", "-", "-o", &path, "--size", "320x200", "--density", "3/2"]).done();
    assert_eq!(pixels(&std::fs::read(&path).unwrap()), (480, 300));
    let run = lath_from(ARCH, ["draw", "-", "-o", "-", "--format", "png", "--dark"]);
    assert_eq!((run.code, &run.out[..8]), (Some(0), PNG));
    lath_from(ARCH, ["draw", "-", "-o", &folder.path("arch.jpg")]).fails(2, &[".svg", ".png", "--format"]);
    lath_from(ARCH, ["draw", "-", "-o", &folder.path("arch")]).fails(2, &["--format"]);
    lath_from(ARCH, ["draw", "-"]).fails(2, &["--output"]);
    assert_eq!(folder.names(), ["arch.png"]);
    assert_eq!(lath_from(ARCH, ["draw", "-", "-o", &folder.path("arch"), "--format", "svg"]).done(), "");
}

#[test]
fn every_dimension_has_its_picture() {
    let graph = svg("t,x\n1871,5\n1872,9\n1875,7\n", "--through --params column:t --axes --knots");
    assert!(graph.contains("<svg"));
    svg("5\n9\n7\n", "--axes");
    svg("5\n9\n7\n", "--through --closed --points");
    let seen = |view: &str| svg("0,0,0\n1,2,0\n3,2,5\n4,0,1\n", &format!("--through --axes {view}"));
    assert_ne!(seen("--view -90,0"), seen("--view -90,90"));
    svg("0,0,0,1,2\n1,2,0,2,2\n3,2,5,3,2\n", "--through");
}

#[test]
fn options_change_the_picture() {
    let curve = lath_from(ARCH, ["curve", "-", "--kind", "bspline", "--degree", "2"]).done();
    let plain = svg(&curve, "");
    for option in ["--polygon", "--points", "--knots", "--comb", "--axes", "--dark", "--title Arch", "--size 300x300"] {
        assert_ne!(svg(&curve, option), plain, "{option}");
    }
    assert!(svg(&curve, "--title <&>").contains("<title>&lt;&amp;&gt;</title>"));
    assert!(svg(&curve, "--size 300x200").contains("width=\"300\" height=\"200\""));
    // Names of control points belong to the polygon.
    assert_ne!(svg(&curve, "--polygon --names"), svg(&curve, "--polygon"));
    assert_eq!(svg(&curve, "--names"), plain);
    assert_ne!(svg(ARCH, "--names"), svg(ARCH, ""));
    assert_ne!(svg(ARCH, "--through --names"), svg(ARCH, "--through"));
    assert_ne!(svg(ARCH, "--dots"), svg(ARCH, ""));
    // Points are joined by lines, or by a curve.
    assert_ne!(svg(ARCH, ""), svg(ARCH, "--through"));
    assert_ne!(svg(ARCH, "--through"), svg(ARCH, "--through --closed"));
    assert_ne!(svg(ARCH, "--through"), svg(ARCH, "--through --ends clamped:-1,-1"));
}

#[test]
fn points_of_a_curve_are_marked_with_their_tangents() {
    let curve = lath_from(ARCH, ["curve", "-", "--kind", "bspline", "--degree", "2"]).done();
    let dots = |options: &str| svg(&curve, options).matches("<circle").count();
    assert_eq!((dots(""), dots("--at 0,1/2,3/2"), dots("--at breaks")), (0, 3, 3));
    // One line more, for all tangents.
    let lines = |options: &str| svg(&curve, options).matches("<path").count();
    assert_eq!((lines("--at 1"), lines("--at 0,1,2")), (lines("") + 1, lines("") + 1));
    svg("5\n9\n7\n", "--through --at 1/2 --axes");
    svg("0,0,0\n1,2,0\n3,2,5\n4,0,1\n", "--through --closed --at breaks");
    let draw = ["draw", "-", "-o", "-", "--at"];
    lath_from(&curve, draw.into_iter().chain(["2.5"])).fails(3, &["standard input", "2.5"]);
    lath_from(&curve, draw.into_iter().chain(["x"])).fails(2, &["--at", "not a number"]);
    lath_from(ARCH, draw.into_iter().chain(["1", "--levels", "2"])).fails(2, &["--at", "--levels"]);
}

#[test]
fn kinds_are_compared_in_one_figure() {
    let curves = |kinds: &str| svg(ARCH, &format!("--through --kind {kinds}")).matches("<path").count();
    let one = curves("akima");
    let three = curves("akima,cardinal:1/2,steffen");
    assert!(three >= one + 2, "{one} {three}");
    assert_ne!(svg(ARCH, "--through --kind akima"), svg(ARCH, "--through --kind pchip"));
    // Conditions go to the kinds that have ends.
    assert_ne!(svg(ARCH, "--through --kind cubic,pchip --ends natural"), svg(ARCH, "--through --kind cubic,pchip"));
    svg("t,x\n1,5\n2,9\n4,7\n7,7\n", "--through --params column:t --kind cubic,pchip,bspline --degree 2 --axes");
    svg("5\n9\n7\n8\n", "--through --closed --kind bspline --degree 4 --axes");
    let draw = ["draw", "-", "-o", "-", "--through", "--kind"];
    lath_from(ARCH, draw.into_iter().chain(["akima,pchip", "--ends", "natural"])).fails(2, &["akima"]);
    lath_from(ARCH, draw.into_iter().chain(["akima,pcihp"])).fails(2, &["pcihp", "'pchip'"]);
    lath_from("0,0\n1,1\n", draw.into_iter().chain(["akima,bspline"])).fails(3, &["P001", "degree 3"]);
}

#[test]
fn several_files_in_one_figure() {
    let folder = Folder::new();
    let points = folder.file("points.csv", ARCH);
    let curve = folder.path("curve.json");
    lath_from(ARCH, ["curve", "-", "--kind", "bezier", "-o", &curve]).done();
    let both = lath_from(ARCH, ["draw", &points, &curve, "-", "-o", "-"]).done();
    assert!(both.len() > lath(["draw", &curve, "-o", "-"]).done().len());
    let graph = folder.file("graph.csv", "1\n2\n3\n");
    lath(["draw", &points, &graph, "-o", "-"]).fails(3, &["graph.csv", "P005", "--columns"]);
    lath(["draw", &points, &folder.path("none.csv"), "-o", "-"]).fails(4, &["none.csv", "I001"]);
    lath_from(ARCH, ["draw", "-", "-", "-o", "-"]).fails(2, &["only once"]);
    lath_from(r#"{"lath":1,"shapes":[]}"#, ["draw", "-", "-o", "-"]).fails(3, &["A002", "no shapes"]);
}

#[test]
fn wrong_options_are_named() {
    for (args, words) in [
        ("--size 300", ["--size", "WxH"]),
        ("--size 8x8", ["--size", "16"]),
        ("--size -3x4", ["--size", "WxH"]),
        ("--size 99999x300", ["--size", "16384"]),
        ("--density 0", ["--density", "0.1 to 16"]),
        ("--density -1", ["--density", "0.1 to 16"]),
        ("--view 30", ["--view", "azimuth,elevation"]),
        ("--view a,b", ["--view", "not a number"]),
        ("--closed", ["--through", "lath through"]),
        ("--params chord", ["--through", "lath through"]),
        ("--kind cubic", ["--through", "lath through"]),
        ("--through --closed --start natural", ["--closed", "--start"]),
    ] {
        lath_from(ARCH, ["draw", "-", "-o", "-"].into_iter().chain(args.split(' '))).fails(2, &words);
    }
    lath_from(ARCH, ["draw", "-", "-o", "-", "--through", "--start", "clamped:1"]).fails(3, &["P005"]);
    lath_from("0,0\n0,0\n", ["draw", "-", "-o", "-", "--through"]).fails(3, &["P004", "standard input:2"]);
    lath_from(ARCH, ["draw", "-", "-o", "-", "--format", "png", "--size", "16384x16384"]).fails(5, &["B001"]);
}
