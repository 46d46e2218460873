//! What a computer algebra system says, recorded in testdata/exact/sympy.json; and the corpus of the core's floor `basis`.
#![allow(clippy::unwrap_used)] // helpers of tests stop at the first fault, loudly

use lath_exact::answer::{Condition, Ends, Spectrum, blending, interpolation, matrix, scheme, scheme_named};
use lath_exact::{Polynomial, Rational};
use serde_json::Value;
use testkit::corpus;

fn recorded() -> Value {
    let path = corpus::folder().join("exact/sympy.json");
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

fn fractions(value: &Value) -> Vec<Rational> {
    value.as_array().unwrap().iter().map(|x| x.as_str().unwrap().parse().unwrap()).collect()
}

fn size(value: &Value) -> usize {
    value.as_u64().unwrap() as usize
}

#[test]
fn functions_agree_with_sympy() {
    let recorded = recorded();
    let cases = recorded["functions"].as_array().unwrap();
    assert!(cases.len() >= 12);
    for case in cases {
        let answer = blending(&fractions(&case["knots"]), size(&case["degree"]), &Default::default()).unwrap();
        let functions = case["functions"].as_array().unwrap();
        assert_eq!(answer.functions.len(), functions.len());
        for (f, expected) in answer.functions.iter().zip(functions) {
            // A piece that is zero all along is not recorded.
            let pieces: Vec<_> = f.pieces.iter().filter(|piece| !piece.polynomial.is_zero()).collect();
            let expected = expected["pieces"].as_array().unwrap();
            assert_eq!(pieces.len(), expected.len(), "N{} on {:?}", f.index, answer.knots);
            for (piece, expected) in pieces.iter().zip(expected) {
                assert_eq!(piece.from.to_string(), expected["from"].as_str().unwrap());
                assert_eq!(piece.to.to_string(), expected["to"].as_str().unwrap());
                assert_eq!(piece.polynomial, Polynomial::new(fractions(&expected["coefficients"])));
            }
        }
    }
}

#[test]
fn tangents_agree_with_sympy() {
    for case in recorded()["interpolation"].as_array().unwrap() {
        let points: Vec<Vec<Rational>> = fractions(&case["points"]).into_iter().map(|y| vec![y]).collect();
        let tangents: Vec<Vec<Rational>> = fractions(&case["tangents"]).into_iter().map(|m| vec![m]).collect();
        let ends = Ends::Open(Condition::NotAKnot, Condition::NotAKnot);
        let answer = interpolation(&points, Some(&fractions(&case["parameters"])), ends, &Default::default()).unwrap();
        assert_eq!(answer.tangents, tangents);
    }
}

#[test]
fn schemes_agree_with_sympy() {
    let recorded = recorded();
    let cases = recorded["schemes"].as_array().unwrap();
    assert!(cases.len() >= 10);
    for case in cases {
        let name = case["scheme"].as_str().unwrap();
        let answer = scheme(&scheme_named(name).unwrap(), &Default::default()).unwrap();
        let rows: Vec<Vec<Rational>> = case["matrix"].as_array().unwrap().iter().map(fractions).collect();
        assert_eq!(answer.matrix.rows(), rows, "{name}");
        let Spectrum::Exact(a) = &answer.spectrum else {
            assert_eq!(case["rational"], Value::Bool(false), "{name}");
            continue;
        };
        assert_eq!(a.eigenvalues, fractions(&case["eigenvalues"]), "{name}");
        let mut blocks = Vec::new();
        let mut place = 0;
        for size in &a.blocks {
            blocks.push((a.eigenvalues[place].clone(), *size));
            place += size;
        }
        blocks.sort();
        let expected = case["blocks"].as_array().unwrap().iter();
        let mut expected: Vec<(Rational, usize)> =
            expected.map(|pair| (pair[0].as_str().unwrap().parse().unwrap(), size(&pair[1]))).collect();
        expected.sort();
        assert_eq!(blocks, expected, "{name}");
        // For the scheme of the polygon's own limit and the like, whose convergence is proven.
        if let Some(limit) = &answer.limit {
            assert_eq!(*limit, fractions(&case["limit"]), "{name}");
        }
    }
}

#[test]
fn matrices_agree_with_sympy() {
    for case in recorded()["matrices"].as_array().unwrap() {
        let basis = case["basis"].as_str().unwrap().parse().unwrap();
        let answer = matrix(&basis, size(&case["degree"]), &Default::default()).unwrap();
        let rows: Vec<Vec<Rational>> = case["rows"].as_array().unwrap().iter().map(fractions).collect();
        assert_eq!(answer.matrix.rows(), rows);
    }
}

/// The corpus reads fractions in the tests' own type.
fn ours(values: &[testkit::rational::Rational]) -> Vec<Rational> {
    values.iter().map(|x| x.to_string().parse().unwrap()).collect()
}

#[test]
fn the_corpus_of_bases_is_reproduced() {
    let (mut matrices, mut functions) = (0, 0);
    for case in corpus::load("basis").into_iter().filter(|case| !case.has("error")) {
        match case.text("kind") {
            "matrix" => {
                let basis = case.text("basis").parse().unwrap();
                let answer = matrix(&basis, case.count("degree"), &Default::default()).unwrap();
                let rows: Vec<Vec<Rational>> = case.rows("rows").iter().map(|row| ours(row)).collect();
                assert_eq!(answer.matrix.rows(), rows, "{}", case.place);
                matrices += 1;
            }
            "bspline" => {
                let answer =
                    blending(&ours(&case.numbers("knots")), case.count("degree"), &Default::default()).unwrap();
                let order = case.count_if("derivative").unwrap_or(0);
                for expected in case.entries("functions") {
                    let f = &answer.functions[expected.count("index")];
                    for expected in expected.entries("pieces") {
                        let from = ours(&[expected.number("from")]).remove(0);
                        let piece = f.pieces.iter().find(|piece| piece.from == from).unwrap();
                        assert_eq!(piece.to, ours(&[expected.number("to")])[0]);
                        let derived = (0..order).fold(piece.polynomial.clone(), |p, _| p.derivative());
                        let coefficients = ours(&expected.numbers("coefficients"));
                        assert_eq!(derived, Polynomial::new(coefficients), "{}: N{} from {from}", case.place, f.index);
                        functions += 1;
                    }
                }
            }
            _ => {}
        }
    }
    assert!(matrices >= 8 && functions >= 40, "{matrices} matrices, {functions} pieces");
}
