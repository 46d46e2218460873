//! The JSON shape of each answer: a promise.

use crate::answer::{
    At, BasisMatrix, Blending, Change, Collocation, Ends, Function, Greville, Interpolation, Jump, Piece, Point,
    Refined, Refinement, SchemeAnswer, Spectrum, Triplets,
};
use crate::print::json::{Json, object};
use lath::knot::Side;
use lath::subdivide::Index;

/// An index is a number as long as every reader of JSON reads it exactly, then a string of digits.
fn index(i: &Index) -> Json {
    match i.to_u64() {
        Some(n) if n <= 1 << 53 => Json::Number(n),
        _ => Json::Text(i.to_string()),
    }
}

pub(super) fn basis_matrix(answer: &BasisMatrix) -> Json {
    object([
        ("basis", Json::Text(answer.basis.to_string())),
        ("degree", Json::count(answer.degree)),
        ("powers", Json::Text("descending".into())),
        ("rows", Json::matrix(&answer.matrix)),
    ])
}

pub(super) fn blending(answer: &Blending) -> Json {
    let piece = |piece: &Piece| {
        object([
            ("from", Json::fraction(&piece.from)),
            ("to", Json::fraction(&piece.to)),
            ("coefficients", Json::fractions(&piece.polynomial.padded(answer.degree))),
        ])
    };
    let function = |function: &Function| {
        let pieces = function.pieces.iter().map(piece).collect();
        object([("index", Json::count(function.index)), ("pieces", Json::List(pieces))])
    };
    object([
        ("degree", Json::count(answer.degree)),
        ("knots", Json::fractions(&answer.knots)),
        ("functions", Json::List(answer.functions.iter().map(function).collect())),
    ])
}

pub(super) fn at(answer: &At) -> Json {
    let weights = answer.weights.iter().enumerate().filter(|(_, w)| **w != 0);
    let weights = weights.map(|(j, w)| ((answer.first + j).to_string(), Json::fraction(w))).collect();
    let mut members = vec![
        ("t".to_owned(), Json::fraction(&answer.t)),
        ("span".to_owned(), Json::count(answer.span)),
        ("derivative".to_owned(), Json::count(answer.derivative)),
        ("weights".to_owned(), Json::Object(weights)),
    ];
    if answer.side == Side::Left {
        members.insert(2, ("side".to_owned(), Json::Text("left".into())));
    }
    if let Some(value) = answer.value() {
        members.push(("value".to_owned(), Json::fractions(&value)));
    }
    Json::Object(members)
}

pub(super) fn greville(answer: &Greville) -> Json {
    object([
        ("degree", Json::count(answer.degree)),
        ("knots", Json::fractions(&answer.knots)),
        ("abscissae", Json::fractions(&answer.abscissae)),
    ])
}

pub(super) fn refinement(answer: &Refinement) -> Json {
    let done = match &answer.kind {
        Refined::Inserted(knots) => ("inserted", Json::fractions(knots)),
        Refined::Elevated(by) => ("elevated", Json::count(*by)),
    };
    object([
        ("degree", Json::count(answer.degree)),
        ("knots", Json::fractions(&answer.knots)),
        done,
        ("new_degree", Json::count(answer.new_degree)),
        ("new_knots", Json::fractions(&answer.new_knots)),
        ("rows", Json::matrix(&answer.matrix)),
    ])
}

pub(super) fn change(answer: &Change) -> Json {
    let (a, b) = &answer.interval;
    object([
        ("from", Json::Text(answer.from.to_string())),
        ("to", Json::Text(answer.to.to_string())),
        ("degree", Json::count(answer.degree)),
        ("interval", Json::fractions(&[a.clone(), b.clone()])),
        ("rows", Json::matrix(&answer.matrix)),
    ])
}

pub(super) fn interpolation(answer: &Interpolation) -> Json {
    let ends = match &answer.ends {
        Ends::Open(start, end) => Json::List(vec![Json::Text(start.to_string()), Json::Text(end.to_string())]),
        other => Json::Text(other.to_string()),
    };
    object([
        ("parameters", Json::fractions(&answer.parameters)),
        ("points", Json::rows(&answer.points)),
        ("ends", ends),
        ("tangents", Json::rows(&answer.tangents)),
        ("knots", Json::fractions(&answer.knots)),
        ("control_points", Json::rows(&answer.control_points)),
    ])
}

pub(super) fn collocation(answer: &Collocation) -> Json {
    object([
        ("degree", Json::count(answer.degree)),
        ("parameters", Json::fractions(&answer.parameters)),
        ("points", Json::rows(&answer.points)),
        ("ends", Json::Text(answer.ends.to_string())),
        ("knots", Json::fractions(&answer.knots)),
        ("control_points", Json::rows(&answer.control_points)),
    ])
}

pub(super) fn scheme(answer: &SchemeAnswer) -> Json {
    let mut members = vec![
        ("degree".to_owned(), Json::count(answer.scheme.degree())),
        ("matrix".to_owned(), Json::matrix(&answer.matrix)),
        ("group_matrix".to_owned(), Json::matrix(&answer.group_matrix)),
    ];
    let mut add = |key: &str, value: Json| members.push((key.to_owned(), value));
    match &answer.spectrum {
        Spectrum::Exact(a) => {
            add("eigenvalues", Json::fractions(&a.eigenvalues));
            add("q", Json::matrix(&a.q));
            add("q_inverse", Json::matrix(&a.q_inverse));
            if a.is_defective() {
                add("jordan", Json::matrix(&a.jordan));
            }
        }
        Spectrum::Numeric(_) | Spectrum::Unknown => {
            for key in ["eigenvalues", "q", "q_inverse"] {
                add(key, Json::Null);
            }
        }
    }
    add("limit", Json::optional(answer.limit.as_deref()));
    add("tangent", Json::optional(answer.tangent.as_deref()));
    add("second", Json::optional(answer.second.as_deref()));
    if let Spectrum::Numeric(estimates) = &answer.spectrum {
        // Strings, as all numbers here: nearest doubles of what no fraction holds.
        let pair = |[re, im]: &[f64; 2]| Json::List(vec![Json::Text(re.to_string()), Json::Text(im.to_string())]);
        add("estimates", Json::List(estimates.iter().map(pair).collect()));
    }
    Json::Object(members)
}

pub(super) fn point(answer: &Point) -> Json {
    object([
        ("degree", Json::count(answer.scheme.degree())),
        ("level", Json::count(answer.level)),
        ("index", index(&answer.index)),
        ("parameter", Json::fraction(&answer.parameter)),
        ("weights", Json::fractions(&answer.weights)),
    ])
}

pub(super) fn jump(answer: &Jump) -> Json {
    let place = |(level, i): &(usize, Index)| object([("level", Json::count(*level)), ("index", index(i))]);
    object([
        ("degree", Json::count(answer.scheme.degree())),
        ("from", place(&answer.from)),
        ("to", place(&answer.to)),
        ("power", Json::count(answer.power)),
        ("matrix", Json::matrix(&answer.matrix)),
    ])
}

pub(super) fn triplets(answer: &Triplets) -> Json {
    let row = |d: &lath::subdivide::Descent| object([("index", Json::Number(d.index)), ("from", Json::Number(d.from))]);
    object([("level", Json::count(answer.level)), ("triplets", Json::List(answer.triplets.iter().map(row).collect()))])
}
