//! Outlines of letters: boxes, areas and lengths agree with what other programs found out.
#![allow(clippy::unwrap_used)] // helpers of tests stop at the first fault, loudly

use lath::curve::{Bezier, Curve, Path};
use lath::error::Limits;
use lath::query::{area, bounds, length};
use lath::refine::to_bspline;

const OUTLINES: &str = include_str!("../../../testdata/glyphs/outlines.tsv");
/// Of the units of both fonts.
const EM: f64 = 1000.0;

struct Glyph {
    name: String,
    /// Lo, then hi.
    extent: [f64; 4],
    area: f64,
    length: f64,
    contours: Vec<Path<2>>,
}

/// Commands of one contour after the other: straight lines and Bézier curves, each from where the last one ended.
fn contours(text: &str) -> Vec<Path<2>> {
    let mut found: Vec<Vec<Bezier<2>>> = Vec::new();
    let mut at = [0.0; 2];
    for command in text.split(' ') {
        let (letter, numbers) = command.split_at(1);
        let numbers: Vec<f64> = numbers.split(',').map(|number| number.parse().unwrap()).collect();
        let points: Vec<[f64; 2]> = numbers.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect();
        match letter {
            "M" => found.push(Vec::new()),
            _ => {
                assert_eq!(points.len(), "LQC".find(letter).unwrap() + 1);
                let curve = Bezier::new([&[at], &points[..]].concat()).unwrap();
                found.last_mut().unwrap().push(curve);
            }
        }
        at = *points.last().unwrap();
    }
    let path = |pieces: Vec<Bezier<2>>| Path::new(pieces.into_iter().map(|p| Box::new(p) as Box<dyn Curve<2>>), true);
    found.into_iter().map(|pieces| path(pieces).unwrap()).collect()
}

fn glyphs() -> Vec<Glyph> {
    let one = |line: &str| {
        let fields: Vec<&str> = line.split('\t').collect();
        let number = |i: usize| fields[i].parse::<f64>().unwrap();
        Glyph {
            name: format!("{} {}", fields[0], fields[1]),
            extent: [number(2), number(3), number(4), number(5)],
            area: number(6),
            length: number(7),
            contours: contours(fields[8]),
        }
    };
    let found: Vec<Glyph> = OUTLINES.lines().skip(1).map(one).collect();
    assert_eq!(found.len(), 120);
    found
}

#[test]
fn boxes_are_tight() {
    for glyph in glyphs() {
        let mut found = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
        for contour in &glyph.contours {
            let (extent, bound) = bounds(contour);
            assert!(bound.is_proven());
            for c in 0..2 {
                found[c] = found[c].min(extent.lo[c]);
                found[c + 2] = found[c + 2].max(extent.hi[c]);
            }
        }
        for (found, exact) in found.iter().zip(glyph.extent) {
            assert!((found - exact).abs() <= 1e-9 * EM, "{}: {found} for {exact}", glyph.name);
        }
    }
}

#[test]
fn areas_have_nine_digits_and_a_proven_bound() {
    for glyph in glyphs() {
        let (mut sum, mut bound) = (0.0, 0.0);
        for contour in &glyph.contours {
            let found = area(contour).unwrap();
            assert!(found.bound.is_proven());
            sum += found.signed;
            bound += found.bound.value();
        }
        assert!((sum - glyph.area).abs() <= 1e-9 * glyph.area.abs(), "{}: {sum} for {}", glyph.name, glyph.area);
        assert!(bound <= 1e-13 * EM * EM, "{}: {bound:e}", glyph.name);
    }
}

#[test]
fn lengths_have_ten_digits_and_a_proven_bound() {
    for glyph in glyphs() {
        let (mut sum, mut bound) = (0.0, 0.0);
        for contour in &glyph.contours {
            let found = length(contour, 1e-11 * EM, &Limits::default()).unwrap();
            assert!(found.1.is_proven());
            sum += found.0;
            bound += found.1.value();
        }
        assert!((sum - glyph.length).abs() <= 1e-10 * glyph.length, "{}: {sum} for {}", glyph.name, glyph.length);
        assert!(bound <= 1e-10 * glyph.length, "{}: {bound:e}", glyph.name);
    }
}

#[test]
fn every_contour_splits_and_joins_again() {
    for glyph in glyphs() {
        for contour in &glyph.contours {
            let whole = to_bspline(contour).unwrap();
            let domain = contour.domain();
            let t = domain.start + 0.37 * (domain.end - domain.start);
            let (left, right) = whole.split(t).unwrap();
            assert_eq!(left.control_points().last(), right.control_points().first(), "{}", glyph.name);
            let (again, joint) = left.join(&right, 1e-9 * EM).unwrap();
            assert!(joint.bound.is_proven() && joint.bound.value() <= 1e-9 * EM, "{}: {joint:?}", glyph.name);
            assert_eq!(again.knots().values(), whole.knots().values(), "{}", glyph.name);
            for (a, b) in again.control_points().iter().zip(whole.control_points()) {
                assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-9 * EM), "{}: {a:?} for {b:?}", glyph.name);
            }
        }
    }
}
