//! `lath exact`: the textbooks' numbers from the command line, every format, and what is refused.
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

mod tool;

use serde_json::{Value, json};
use tool::{Folder, Run, lath};

fn run(words: &str) -> Run {
    lath(["exact"].into_iter().chain(words.split_whitespace()))
}

/// The answer as JSON.
#[track_caller]
fn answer(words: &str) -> Value {
    serde_json::from_str(&run(&format!("{words} --json")).done()).unwrap()
}

/// A matrix of integers over a common denominator, as JSON writes it.
fn over(denominator: i64, rows: &[&[i64]]) -> Value {
    let gcd = |mut a: i64, mut b: i64| {
        while b != 0 {
            (a, b) = (b, a % b);
        }
        a.abs()
    };
    let fraction = |x: &i64| match gcd(*x, denominator) {
        common if common == denominator => (x / denominator).to_string(),
        common => format!("{}/{}", x / common, denominator / common),
    };
    rows.iter().map(|row| row.iter().map(fraction).collect::<Vec<_>>()).collect()
}

fn rows(words: &str) -> Value {
    answer(words)["rows"].clone()
}

#[test]
fn matrices_of_the_bases() {
    let bspline = |degree: usize| rows(&format!("matrix --basis bspline --degree {degree}"));
    assert_eq!(bspline(1), over(1, &[&[-1, 1], &[1, 0]]));
    assert_eq!(bspline(2), over(2, &[&[1, -2, 1], &[-2, 2, 0], &[1, 1, 0]]));
    let cubic = over(6, &[&[-1, 3, -3, 1], &[3, -6, 3, 0], &[-3, 0, 3, 0], &[1, 4, 1, 0]]);
    assert_eq!((bspline(3), rows("matrix --basis bspline")), (cubic.clone(), cubic));
    let quartic: [&[i64]; 5] =
        [&[1, -4, 6, -4, 1], &[-4, 12, -12, 4, 0], &[6, -6, -6, 6, 0], &[-4, -12, 12, 4, 0], &[1, 11, 11, 1, 0]];
    assert_eq!(bspline(4), over(24, &quartic));
    let quintic: [&[i64]; 6] = [
        &[-1, 5, -10, 10, -5, 1],
        &[5, -20, 30, -20, 5, 0],
        &[-10, 20, 0, -20, 10, 0],
        &[10, 20, -60, 20, 10, 0],
        &[-5, -50, 0, 50, 5, 0],
        &[1, 26, 66, 26, 1, 0],
    ];
    assert_eq!(bspline(5), over(120, &quintic));
    let hermite = over(1, &[&[2, -2, 1, 1], &[-3, 3, -2, -1], &[0, 0, 1, 0], &[1, 0, 0, 0]]);
    assert_eq!(rows("matrix --basis hermite"), hermite);
    let bezier = over(1, &[&[-1, 3, -3, 1], &[3, -6, 3, 0], &[-3, 3, 0, 0], &[1, 0, 0, 0]]);
    assert_eq!(rows("matrix --basis bezier --degree 3"), bezier);
    let catmull_rom = over(2, &[&[-1, 3, -3, 1], &[2, -5, 4, -1], &[-1, 0, 1, 0], &[0, 2, 0, 0]]);
    assert_eq!(rows("matrix --basis catmull-rom"), catmull_rom);
    assert_eq!(rows("matrix --basis cardinal:0"), catmull_rom);
    let object = answer("matrix --basis bspline --degree 1");
    let members: Vec<&String> = object.as_object().unwrap().keys().collect();
    assert_eq!(members, ["basis", "degree", "powers", "rows"]);
    assert_eq!((&object["powers"], &object["basis"]), (&json!("descending"), &json!("bspline")));
}

#[test]
fn subdivision_schemes() {
    let cubic = answer("scheme --degree 3");
    assert_eq!(cubic["matrix"], over(8, &[&[4, 4, 0], &[1, 6, 1], &[0, 4, 4]]));
    let group: [&[i64]; 5] = [&[4, 4, 0, 0], &[1, 6, 1, 0], &[0, 4, 4, 0], &[0, 1, 6, 1], &[0, 0, 4, 4]];
    assert_eq!(cubic["group_matrix"], over(8, &group));
    assert_eq!(cubic["eigenvalues"], json!(["1/4", "1/2", "1"]));
    assert_eq!(cubic["q"], over(2, &[&[2, -2, 2], &[-1, 0, 2], &[2, 2, 2]]));
    assert_eq!(cubic["q_inverse"], over(6, &[&[2, -4, 2], &[-3, 0, 3], &[1, 4, 1]]));
    assert_eq!(cubic["limit"], json!(["1/6", "2/3", "1/6"]));
    assert_eq!((&cubic["tangent"], &cubic["second"]), (&json!(["-1/2", "0", "1/2"]), &json!(["1", "-2", "1"])));
    assert_eq!(answer("scheme --scheme cubic"), cubic);
    let chaikin = answer("scheme --scheme chaikin");
    assert_eq!(chaikin["matrix"], over(4, &[&[3, 1], &[1, 3]]));
    assert_eq!((&chaikin["eigenvalues"], &chaikin["second"]), (&json!(["1/2", "1"]), &Value::Null));
    let quintic: [&[i64]; 5] =
        [&[6, 20, 6, 0, 0], &[1, 15, 15, 1, 0], &[0, 6, 20, 6, 0], &[0, 1, 15, 15, 1], &[0, 0, 6, 20, 6]];
    let five = answer("scheme --degree 5");
    assert_eq!(five["matrix"], over(32, &quintic));
    assert_eq!(five["eigenvalues"], json!(["1/16", "1/8", "1/4", "1/2", "1"]));
    let four_point = answer("scheme --scheme four-point");
    assert!(four_point["second"].is_null() && !four_point["jordan"].is_null(), "{four_point}");
    assert_eq!(answer("scheme --scheme mask:1/4,3/4,3/4,1/4")["matrix"], chaikin["matrix"]);
}

#[test]
fn points_limits_jumps_and_triplets() {
    let weights = |words: &str| answer(words)["weights"].clone();
    assert_eq!(weights("limit --degree 3 --level 0 --index 0"), json!(["1/6", "2/3", "1/6", "0"]));
    assert_eq!(weights("limit --degree 3 --level 0 --index 1"), json!(["0", "1/6", "2/3", "1/6"]));
    assert_eq!(weights("limit --degree 3 --level 1 --index 1"), json!(["1/48", "23/48", "23/48", "1/48"]));
    let object = answer("limit --degree 3 --level 3 --index 6");
    assert_eq!(
        object,
        json!({"degree": 3, "level": 3, "index": 6, "parameter": "3/4", "weights": ["1/384", "121/384", "235/384", "9/128"]})
    );
    assert_eq!(weights("point --degree 3 --level 1 --index 1"), json!(["1/8", "3/4", "1/8", "0"]));
    assert_eq!(weights("point --scheme chaikin --level 1 --index 0"), json!(["3/4", "1/4", "0"]));
    // An index of 300 digits is a string, and the weights sum to 1 all the same.
    let index = "7".repeat(300);
    let far = answer(&format!("point --degree 2 --level 1000 --index {index}"));
    assert_eq!(far["index"], json!(index));
    let jump = answer("jump --degree 3 --from 1:1 --to-level 3");
    assert_eq!((&jump["power"], &jump["to"]), (&json!(2), &json!({"level": 3, "index": 4})));
    assert_eq!(jump["matrix"], over(32, &[&[10, 20, 2], &[5, 22, 5], &[2, 20, 10]]));
    let landed = |level: u32| answer(&format!("jump --degree 3 --from 1:1 --to-level {level}"))["to"]["index"].clone();
    assert_eq!([2, 3, 4, 5].map(landed), [2, 4, 8, 16].map(|i| json!(i)));
    let triplets = answer("triplets --level 4");
    let expected: Vec<Value> = (0..=8).map(|i| json!({"index": 2 * i, "from": i})).collect();
    assert_eq!(triplets, json!({"level": 4, "triplets": expected}));
}

#[test]
fn blending_functions_and_weights() {
    let open = answer("blending --degree 2 --knots 0,0,0,1,2,3,3,3");
    assert_eq!(open["functions"].as_array().unwrap().len(), 5);
    let first = json!({"index": 0, "pieces": [{"from": "0", "to": "1", "coefficients": ["1", "-2", "1"]}]});
    assert_eq!(open["functions"][0], first);
    // The triple knot at 1: eight functions; N₁ = (11t³ − 15t² − 3t + 7)/12 on [0, 1), N₆ = (−3t³ + 21t² − 45t + 31)/6 on [2, 3).
    let triple = answer("blending --degree 3 --knots -3,-2,-1,0,1,1,1,2,3,4,5,6");
    let piece = |index: usize, from: &str| {
        let pieces = triple["functions"][index]["pieces"].as_array().unwrap();
        pieces.iter().find(|piece| piece["from"] == from).unwrap()["coefficients"].clone()
    };
    assert_eq!(triple["functions"].as_array().unwrap().len(), 8);
    assert_eq!(piece(1, "0"), over(12, &[&[7, -3, -15, 11]])[0]);
    assert_eq!(piece(2, "0"), over(4, &[&[1, 3, 3, -7]])[0]);
    assert_eq!(piece(4, "1"), over(4, &[&[-37, 69, -39, 7]])[0]);
    assert_eq!(piece(6, "2"), over(6, &[&[31, -45, 21, -3]])[0]);
    let at = answer("at --degree 2 --knots 0,0,0,1,2,3,3,3 --t 5/7");
    assert_eq!(at["weights"], json!({"0": "4/49", "1": "65/98", "2": "25/98"}));
    let slope = answer("at --degree 2 --knots 0,0,0,1,2,3,3,3 --t 1/2 --derivative 1");
    assert_eq!(slope["weights"], json!({"0": "-1", "1": "1/2", "2": "1/2"})); // 2(t−1), 2−3t, t
    let left = answer("at --degree 1 --knots 0,0,1,1,2,2 --t 1 --side left");
    assert_eq!(left["side"], "left");
}

#[test]
fn a_point_that_another_library_gets_wrong() {
    let at = |knots: &str| {
        let knots = format!("0,0,0,0,{knots},1,1,1,1");
        let points = "5,5; 10,10; 20,15; 35,15; 45,10; 50,5";
        let args = ["exact", "at", "--degree", "3", "--knots", &knots, "--t", "1/2", "--points", points, "--json"];
        serde_json::from_str::<Value>(&lath(args).done()).unwrap()["value"].clone()
    };
    assert_eq!(at("1/3,2/3"), json!(["55/2", "235/16"]));
    assert_eq!(at("0.33,0.66"), json!(["4459803800/161321193", "2370082930/161321193"]));
}

#[test]
fn matrices_that_refine_and_change() {
    let insertion = answer("insertion --degree 2 --knots 0,0,0,1,1,1 --insert 1/2");
    assert_eq!(insertion["rows"], over(2, &[&[2, 0, 0], &[1, 1, 0], &[0, 1, 1], &[0, 0, 2]]));
    let elevation = over(3, &[&[3, 0, 0], &[1, 2, 0], &[0, 2, 1], &[0, 0, 3]]);
    assert_eq!(rows("elevation --degree 2"), elevation);
    assert_eq!(rows("elevation --degree 2 --knots 0,0,0,1,1,1 --by 1"), elevation);
    let change = over(6, &[&[1, 4, 1, 0], &[0, 4, 2, 0], &[0, 2, 4, 0], &[0, 1, 4, 1]]);
    assert_eq!(rows("change --from bspline --to bernstein"), change);
    assert_eq!(rows("change --from power --to power --degree 1"), over(1, &[&[1, 0], &[0, 1]]));
    let greville = answer("greville --degree 3 --knots 0,0,0,0,1,2,2,2,2");
    assert_eq!(greville["abscissae"], json!(["0", "1/3", "1", "5/3", "2"]));
}

#[test]
fn interpolation_with_every_end() {
    let ask = |points: &str, options: &[&str]| {
        let args = [&["exact", "interpolation", "--points", points][..], options, &["--json"]].concat();
        serde_json::from_str::<Value>(&lath(args).done()).unwrap()
    };
    let natural = ask("0; 1; 0", &["--ends", "natural"]);
    assert_eq!(natural["tangents"], json!([["3/2"], ["0"], ["-3/2"]]));
    assert_eq!(ask("0; 1; 0", &["--start", "natural", "--end", "natural"]), natural);
    let clamped = ask("0; 1; 0", &["--ends", "clamped:1/2"]);
    assert_eq!(clamped["tangents"], json!([["1/2"], ["-1/4"], ["1/2"]]));
    for options in [&["--ends", "cyclic"][..], &["--ends", "anticyclic"], &["--closed"], &[]] {
        assert!(ask("0,0; 1,2; 3,1; 4,4", options)["tangents"].as_array().unwrap().len() >= 4);
    }
    // The circle's control points are half as far again as its joints.
    let circle = ask("1,0; 0,1; -1,0; 0,-1", &["--closed"]);
    let text = circle["control_points"].to_string();
    assert!(text.contains("3/2") && text.contains("-3/2"), "{circle}");
    let given = ask("0; 1; 0", &["--params", "0,1,3", "--ends", "natural"]);
    assert_eq!(given["parameters"], json!(["0", "1", "3"]));
}

#[test]
fn every_format_and_the_derivation() {
    let ask = |format: &str| run(&format!("matrix --basis bspline --degree 2 --format {format}")).done();
    assert!(ask("text").contains("M = 1/2 × ⎢ −2   2  0 ⎥"), "{}", ask("text"));
    assert!(ask("latex").contains("\\frac") && ask("latex").contains("\\begin"));
    for (format, word) in [("rust", "const"), ("python", "= "), ("c", "double")] {
        assert!(ask(format).contains(word), "{}", ask(format));
    }
    assert_eq!(ask("json"), run("matrix --basis bspline --degree 2 --json").done());
    let folder = Folder::new();
    for (extension, format) in
        [("json", "json"), ("tex", "latex"), ("rs", "rust"), ("py", "python"), ("c", "c"), ("h", "c"), ("txt", "text")]
    {
        let path = folder.path(&format!("m.{extension}"));
        assert_eq!(lath(["exact", "matrix", "--basis", "bspline", "--degree", "2", "-o", &path]).done(), "");
        assert_eq!(std::fs::read_to_string(path).unwrap(), ask(format));
    }
    for question in ["matrix --basis bspline", "limit --degree 3 --level 3 --index 6", "scheme --scheme four-point"] {
        let steps = run(&format!("{question} --explain")).done();
        assert!(steps.lines().count() > 4 && steps.contains("1."), "{steps}");
    }
    run("matrix --basis bspline --explain --json").fails(2, &["--explain", "--json"]);
    run(&format!("matrix --basis bspline -o {}", folder.path("m.doc"))).fails(2, &[".doc", "--format"]);
}

#[test]
fn functions_are_drawn() {
    let folder = Folder::new();
    let svg = |words: &str| {
        let path = folder.path("picture.svg");
        assert_eq!(run(&format!("{words} -o {path}")).done(), "");
        let svg = std::fs::read_to_string(path).unwrap();
        assert!(svg.starts_with("<svg") && !svg.contains("NaN"));
        svg
    };
    let cubic = svg("blending --degree 3 --knots -3,-2,-1,0,1,1,1,2,3,4,5,6");
    assert!(cubic.len() > svg("blending --degree 1 --knots 0,1,2").len());
    for basis in ["bspline", "bezier", "hermite", "catmull-rom", "cardinal:1/2", "bezier --degree 9"] {
        svg(&format!("matrix --basis {basis}"));
    }
    svg("blending --degree 1 --knots 0,0,1,1,2,2"); // functions that jump
    svg("blending --degree 0 --knots 0,1,2");
    svg("blending --degree 3 --knots 0,1,2,3,4"); // one function, and no domain
    let png = folder.path("picture.png");
    run(&format!("matrix --basis hermite -o {png}")).done();
    assert_eq!(std::fs::read(png).unwrap()[..4], *b"\x89PNG");
    let path = folder.path("none.svg");
    run(&format!("greville --degree 1 --knots 0,1,2,3 -o {path}")).fails(2, &["nothing to draw"]);
    run(&format!("matrix --basis hermite --json -o {path}")).fails(2, &["picture"]);
    run(&format!("matrix --basis hermite --explain -o {path}")).fails(2, &["picture"]);
    run("greville --degree 1 --knots 0,1,2,3 --format png").fails(2, &["nothing to draw"]);
    assert!(!folder.names().contains(&"none.svg".to_owned()));
}

#[test]
fn pictures_have_the_look_that_is_asked_for() {
    let ask = |look: &str| run(&format!("matrix --basis hermite --format svg{look}")).done();
    let (plain, dark) = (ask(""), ask(" --dark"));
    assert!(plain.starts_with("<svg") && dark != plain);
    let small = ask(" --size 640x400");
    assert!(small.contains("640") && !plain.contains("width=\"640"), "{}", &small[..200]);
    let folder = Folder::new();
    let path = folder.path("f.svg");
    run(&format!("blending --degree 1 --knots 0,1,2 --dark --size 300x200 -o {path}")).done();
    assert!(std::fs::read_to_string(&path).unwrap().contains("300"));
    // An option that would do nothing is refused.
    for look in ["--dark", "--size 640x400", "--title T", "--density 2"] {
        run(&format!("matrix --basis hermite {look}")).fails(2, &["picture", "--format"]);
        run(&format!("blending --degree 1 --knots 0,1,2 --json {look}")).fails(2, &["picture"]);
    }
    run("matrix --basis hermite --format svg --size 3x3").fails(2, &["--size", "16384"]);
    run("scheme --degree 3 --dark").fails(2, &["--dark"]);
}

#[test]
fn derivations_have_a_budget_of_their_own() {
    let refused = |words: &str| {
        run(words).done();
        run(&format!("{words} --explain")).fails(5, &["B001", "operations", "budget"]);
    };
    refused("limit --degree 100 --level 16 --index 5");
    refused("matrix --basis bspline --degree 20 --budget 2000000");
    // No product that stopped at the greatest number is printed as if it were one.
    for words in ["triplets --level 500", "matrix --basis bspline --degree 9999999999", "scheme --degree 1000"] {
        let run = run(words);
        assert!(!run.err.contains("18446744073709551615"), "{}", run.err);
        run.fails(5, &["B001", "budget"]);
    }
}

#[test]
fn wrong_questions_are_refused_with_the_culprit() {
    for (words, parts) in [
        ("", ["QUESTION", "matrix"]),
        ("matirx --basis bspline", ["matirx", "'matrix'"]),
        ("matrix", ["--basis", "required"]),
        ("matrix --basis bezeir", ["bezeir", "bezier"]),
        ("matrix --basis hermite --degree 4", ["hermite", "degree 3"]),
        ("matrix --basis bspline --degree x", ["--degree", "whole number"]),
        ("matrix --basis bspline --format xml", ["xml", "latex"]),
        ("scheme", ["--degree", "--scheme"]),
        ("scheme --degree 3 --scheme cubic", ["--degree", "--scheme"]),
        ("scheme --scheme chaiken", ["chaiken", "chaikin"]),
        ("limit --degree 3 --level 1", ["--index", "required"]),
        ("limit --degree 3 --level 1 --index -1", ["--index", "digits"]),
        ("jump --degree 3 --from 3 --to-level 4", ["--from", "60:123456789"]),
        ("change --from bspline --to bernstien", ["bernstien", "bernstein"]),
        ("change --from bspline --to power --interval 0,1,2", ["--interval", "two numbers"]),
        ("interpolation --points 0;1 --closed --ends natural", ["--closed", "--ends"]),
    ] {
        run(words).fails(2, &parts);
    }
    for (words, parts) in [
        ("blending --degree 2 --knots 0,1/0,2", ["--knots", "X002", "number 1"]),
        ("blending --degree 2 --knots 0,one,2", ["--knots", "X001", "one"]),
        ("blending --degree 2 --knots 0,2,1,3", ["--knots", "K004", "knot 2"]),
        ("blending --degree 2 --knots nan,1,2,3", ["--knots", "X001", "nan"]),
        ("at --degree 1 --knots 0,0,1,1 --t 2", ["T002", "2", "outside"]),
        ("at --degree 1 --knots 0,0,1,1 --t 1/0", ["--t", "X002", "zero"]),
        ("at --degree 1 --knots 0,0,1,1 --t 1/2 --points 0;1;2", ["--points", "3", "2"]),
        ("limit --degree 3 --level 1 --index 3", ["S006", "index 3", "level 1"]),
        ("limit --degree 3 --level 1001 --index 3", ["S005", "1001", "1000"]),
        ("scheme --degree 0", ["K006", "--degree", "0"]),
        ("scheme --scheme mask:1/4,3/4,1/2,1/4", ["S001", "--scheme", "sum"]),
        ("interpolation --points 0", ["P001", "1", "point"]),
        ("interpolation --points 0,0;1", ["P005", "row 1", "--points"]),
        ("interpolation --points 0;1 --params 1,0", ["T003", "", ""]),
        ("insertion --degree 1 --knots 0,0,1,1 --insert 2", ["T002", "2", ""]),
    ] {
        run(words).fails(3, &parts);
    }
    for words in
        ["triplets --level 60", "matrix --basis bspline --degree 100000", "jump --degree 900 --from 0:0 --to-level 900"]
    {
        run(words).fails(5, &["B001", "budget"]);
    }
    lath(["exact", "triplets", "--level", "2", "-o", "/no/such/folder/t.txt"]).fails(4, &["I001"]);
}
