//! Values of another system, recorded: `testdata/reference/interpolation.json`, computed with scipy.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests stop at the first fault

use lath::curve::{BSpline, Curve};
use lath::interpolate::{BSplineEnd, End, Ends, akima, bspline, bspline_closed, cubic, cubic_closed, makima, pchip};
use lath::knot::{Knots, Side};
use lath::space::distance;
use serde_json::Value;
use std::collections::BTreeSet;
use std::path::Path;

fn read(name: &str) -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../testdata/reference").join(name);
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

fn rows<const D: usize>(value: &Value) -> Vec<[f64; D]> {
    value.as_array().unwrap().iter().map(|row| numbers(row).try_into().unwrap()).collect()
}

/// Compares values and derivatives at the queries with the recorded ones, relative to each column's largest magnitude.
fn compare<const D: usize>(name: &str, curve: &dyn Curve<D>, query: &[f64], result: &Value, tolerances: [f64; 3]) {
    for (order, key) in ["value", "d1", "d2"].into_iter().enumerate() {
        let Some(recorded) = result.get(key) else { continue };
        let recorded: Vec<[f64; D]> = rows(recorded);
        let found: Vec<[f64; D]> = query
            .iter()
            .map(|t| {
                let mut jet = vec![[0.0; D]; order + 1];
                curve.jet_into(*t, Side::Right, &mut jet);
                jet[order]
            })
            .collect();
        for axis in 0..D {
            let largest = recorded.iter().map(|row| row[axis].abs()).fold(0.0, f64::max);
            for (i, (found, recorded)) in found.iter().zip(&recorded).enumerate() {
                let error = (found[axis] - recorded[axis]).abs();
                assert!(
                    error <= tolerances[order] * largest,
                    "{name}, {key}, axis {axis}, t = {}: {} against {}",
                    query[i],
                    found[axis],
                    recorded[axis]
                );
            }
        }
    }
}

const CUBIC: [f64; 3] = [1e-12, 1e-10, 1e-10];
const OTHER: [f64; 3] = [1e-10, 1e-10, 1e-10];

fn open_set<const D: usize>(set: &Value, seen: &mut BTreeSet<String>) {
    let (t, query, points) = (numbers(&set["t"]), numbers(&set["query"]), rows::<D>(&set["y"]));
    let results = set["results"].as_object().unwrap();
    let vector = |key: &str| -> [f64; D] { numbers(&results["end_vectors"][key]).try_into().unwrap() };
    let (start, end) = (vector("start"), vector("end"));
    let zero = || End::Clamped([0.0; D]);
    for (name, result) in results.iter().filter(|(name, _)| *name != "end_vectors") {
        let ends = match name.as_str() {
            "cubic_natural" => Some((End::Natural, End::Natural)),
            "cubic_not-a-knot" => Some((End::NotAKnot, End::NotAKnot)),
            "cubic_clamped" => Some((zero(), zero())),
            "cubic_slopes" => Some((End::Clamped(start), End::Clamped(end))),
            "cubic_second" => Some((End::Second(start), End::Second(end))),
            "cubic_slope_start_natural_end" => Some((End::Clamped(start), End::Natural)),
            "cubic_not_a_knot_start_second_end" => Some((End::NotAKnot, End::Second(end))),
            _ => None,
        };
        if let Some((start, end)) = ends {
            compare(name, &cubic(&points, t.clone(), &Ends::Open(start, end)).unwrap(), &query, result, CUBIC);
        } else if let Some(degree) = name.strip_prefix("bspline_k") {
            let degree: usize = degree.parse().unwrap();
            let ends = BSplineEnd::NotAKnot;
            let curve = bspline(&points, t.clone(), degree, &ends, &ends).unwrap();
            let knots = numbers(&result["knots"]);
            assert_eq!(curve.knots().values(), knots, "{name}");
            let recorded: Vec<[f64; D]> = rows(&result["coefficients"]);
            for axis in 0..D {
                let largest = recorded.iter().map(|row| row[axis].abs()).fold(0.0, f64::max);
                for (found, recorded) in curve.control_points().iter().zip(&recorded) {
                    assert!((found[axis] - recorded[axis]).abs() <= 1e-10 * largest, "{name}: {found:?} {recorded:?}");
                }
            }
            let recorded = BSpline::new(Knots::new(knots, degree).unwrap(), recorded).unwrap();
            compare(name, &recorded, &query, result, OTHER);
            compare(name, &curve, &query, result, OTHER);
        } else {
            let make = match name.as_str() {
                "pchip" => pchip,
                "akima" => akima,
                "makima" => makima,
                other => panic!("nobody compares {other}"),
            };
            compare(name, &make(&points, t.clone(), false).unwrap(), &query, result, OTHER);
        }
        seen.insert(name.clone());
    }
}

#[test]
fn every_recorded_interpolant_agrees() {
    let document = read("interpolation.json");
    let mut seen = BTreeSet::new();
    for set in document["sets"].as_array().unwrap() {
        if set["closed"] == true {
            let (t, query) = (numbers(&set["t"]), numbers(&set["query"]));
            let mut points: Vec<[f64; 2]> = rows(&set["y"]);
            assert_eq!(points.pop(), points.first().copied());
            for (name, result) in set["results"].as_object().unwrap() {
                match name.as_str() {
                    "cubic_periodic" => {
                        compare(name, &cubic_closed(&points, t.clone()).unwrap(), &query, result, CUBIC);
                    }
                    "bspline_periodic_k3" | "bspline_periodic_k5" => {
                        let degree = if name.ends_with('3') { 3 } else { 5 };
                        compare(name, &bspline_closed(&points, t.clone(), degree).unwrap(), &query, result, OTHER);
                    }
                    other => panic!("nobody compares {other}"),
                }
                seen.insert(name.clone());
            }
        } else if set["y"][0].as_array().unwrap().len() == 1 {
            open_set::<1>(set, &mut seen);
        } else {
            open_set::<2>(set, &mut seen);
        }
    }
    assert_eq!(seen.len(), 7 + 3 + 6 + 3, "{seen:?}");
}

#[test]
fn every_recorded_bspline_agrees() {
    let document = read("bspline_eval.json");
    let cases = document["cases"].as_array().unwrap();
    assert_eq!(cases.len(), 6);
    for case in cases {
        let degree = case["degree"].as_u64().unwrap() as usize;
        let knots = Knots::new(numbers(&case["knots"]), degree).unwrap();
        let points = numbers(&case["coefficients"]).into_iter().map(|c| [c]);
        let curve = BSpline::new(knots, points).unwrap();
        let query = numbers(&case["query"]);
        let mut orders = vec![(0, numbers(&case["value"]))];
        for (order, values) in case["derivs"].as_object().unwrap() {
            orders.push((order.parse().unwrap(), numbers(values)));
        }
        assert_eq!(orders.len(), 1 + degree.min(3));
        for (order, recorded) in orders {
            let largest = recorded.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            for (t, recorded) in query.iter().zip(recorded) {
                let found = curve.jet(*t, order).unwrap()[order][0];
                assert!((found - recorded).abs() <= 1e-12 * largest, "degree {degree}, order {order}, t = {t}");
            }
        }
    }
}

/// The curves of geomdl's examples, in as many dimensions as they have.
fn example<const D: usize>(item: &Value) {
    let (degree, points) = (item["degree"].as_u64().unwrap() as usize, rows::<D>(&item["control_points"]));
    let size = points.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
    let spline = BSpline::over(numbers(&item["knots"]), degree, points).unwrap();
    let weights = match item["weights"].is_null() {
        true => vec![1.0; spline.control_points().len()],
        false => numbers(&item["weights"]),
    };
    let curve = spline.clone().weighted(weights).unwrap();
    let recorded = numbers(&item["u"]).into_iter().zip(rows::<D>(&item["point"]));
    for (t, point) in recorded {
        let (found, plain) = (curve.eval(t).unwrap(), spline.eval(t).unwrap());
        assert!(distance(&found, &point) <= 1e-12 * size, "{} at {t}: {found:?}, not {point:?}", item["name"]);
        assert_eq!(distance(&plain, &point) <= 1e-12 * size, item["weights"].is_null(), "{}", item["name"]);
    }
}

#[test]
fn every_example_curve_of_geomdl_agrees() {
    let document = read("../geomdl/examples.json");
    let items = document["items"].as_array().unwrap();
    assert_eq!(items.len(), 6);
    for item in items {
        match item["control_points"][0].as_array().unwrap().len() {
            2 => example::<2>(item),
            _ => example::<3>(item),
        }
    }
}
