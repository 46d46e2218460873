//! The JSON of every answer, as promised; and LaTeX whose brackets close.
#![allow(clippy::unwrap_used)] // helpers of tests stop at the first fault, loudly

use lath::knot::Side;
use lath_exact::answer::{
    Condition, Ends, at, blending, change, elevation, greville, insertion, interpolation, jump, limit, matrix, point,
    scheme, scheme_named, triplets,
};
use lath_exact::parse::{fractions, rows};
use lath_exact::print::{Answer, Format, render};

fn json(answer: &dyn Answer) -> String {
    let text = render(answer, Format::Json).unwrap();
    let _: serde_json::Value = serde_json::from_str(&text).unwrap();
    text.trim_end().to_owned()
}

#[test]
fn the_contract() {
    let limits = Default::default();
    assert_eq!(
        json(&matrix(&"bspline".parse().unwrap(), 2, &limits).unwrap()),
        r#"{"basis":"bspline","degree":2,"powers":"descending","rows":[["1/2","-1","1/2"],["-1","1","0"],["1/2","1/2","0"]]}"#
    );
    assert_eq!(
        json(&blending(&fractions("0,1,1,2").unwrap(), 2, &limits).unwrap()),
        r#"{"degree":2,"knots":["0","1","1","2"],"functions":[{"index":0,"pieces":[{"from":"0","to":"1","coefficients":["0","0","1"]},{"from":"1","to":"2","coefficients":["4","-4","1"]}]}]}"#
    );
    let uniform = fractions("0,1,2,3,4,5,6,7").unwrap();
    let weights = at(&uniform, 3, &3.into(), 0, Side::Right, &limits).unwrap();
    assert_eq!(json(&weights), r#"{"t":"3","span":3,"derivative":0,"weights":{"0":"1/6","1":"2/3","2":"1/6"}}"#);
    let end = at(&uniform, 3, &4.into(), 2, Side::Right, &limits).unwrap();
    assert_eq!(
        json(&end.with_points(rows("0;0;1;0").unwrap()).unwrap()),
        r#"{"t":"4","span":3,"side":"left","derivative":2,"weights":{"1":"1","2":"-2","3":"1"},"value":["-2"]}"#
    );
    let cubic = scheme_named("cubic").unwrap();
    assert_eq!(
        json(&limit(&cubic, 3, &6.into(), &limits).unwrap()),
        r#"{"degree":3,"level":3,"index":6,"parameter":"3/4","weights":["1/384","121/384","235/384","9/128"]}"#
    );
    assert_eq!(
        json(&point(&cubic, 1, &1.into(), &limits).unwrap()),
        r#"{"degree":3,"level":1,"index":1,"parameter":"1/2","weights":["1/8","3/4","1/8","0"]}"#
    );
    let far = point(&cubic, 54, &"9007199254740993".parse().unwrap(), &limits).unwrap();
    assert!(json(&far).contains(r#""index":"9007199254740993""#));
    assert_eq!(
        json(&scheme(&scheme_named("chaikin").unwrap(), &limits).unwrap()),
        r#"{"degree":2,"matrix":[["3/4","1/4"],["1/4","3/4"]],"group_matrix":[["3/4","1/4","0"],["1/4","3/4","0"],["0","3/4","1/4"],["0","1/4","3/4"]],"eigenvalues":["1/2","1"],"q":[["-1","1"],["1","1"]],"q_inverse":[["-1/2","1/2"],["1/2","1/2"]],"limit":["1/2","1/2"],"tangent":["-1","1"],"second":null}"#
    );
    let four = json(&scheme(&scheme_named("four-point").unwrap(), &limits).unwrap());
    assert!(
        four.contains(r#""jordan":[["1/8","0","0","0","0"],["0","1/4","1","0","0"]"#)
            && four.ends_with(r#""second":null}"#)
    );
    let numeric = json(&scheme(&scheme_named("four-point:1/32").unwrap(), &limits).unwrap());
    assert!(numeric.contains(r#""eigenvalues":null,"q":null,"q_inverse":null"#) && numeric.contains("estimates"));
    assert_eq!(
        json(&triplets(1, &limits).unwrap()),
        r#"{"level":1,"triplets":[{"index":0,"from":0},{"index":2,"from":1}]}"#
    );
    assert_eq!(
        json(&jump(&cubic, (1, 1.into()), 1, &limits).unwrap()),
        r#"{"degree":3,"from":{"level":1,"index":1},"to":{"level":1,"index":1},"power":0,"matrix":[["1","0","0"],["0","1","0"],["0","0","1"]]}"#
    );
}

#[test]
fn shapes_beside_the_contract() {
    let limits = Default::default();
    let knots = fractions("0,0,1,1").unwrap();
    assert_eq!(json(&greville(&knots, 1).unwrap()), r#"{"degree":1,"knots":["0","0","1","1"],"abscissae":["0","1"]}"#);
    assert_eq!(
        json(&insertion(&knots, 1, &fractions("1/2").unwrap(), &limits).unwrap()),
        r#"{"degree":1,"knots":["0","0","1","1"],"inserted":["1/2"],"new_degree":1,"new_knots":["0","0","1/2","1","1"],"rows":[["1","0"],["1/2","1/2"],["0","1"]]}"#
    );
    assert_eq!(
        json(&elevation(&knots, 1, 1, &limits).unwrap()),
        r#"{"degree":1,"knots":["0","0","1","1"],"elevated":1,"new_degree":2,"new_knots":["0","0","0","1","1","1"],"rows":[["1","0"],["1/2","1/2"],["0","1"]]}"#
    );
    let unit = (0.into(), 1.into());
    assert_eq!(
        json(&change(&"power".parse().unwrap(), &"bernstein".parse().unwrap(), 1, unit, &limits).unwrap()),
        r#"{"from":"power","to":"bernstein","degree":1,"interval":["0","1"],"rows":[["1","0"],["1","1"]]}"#
    );
    let ends = Ends::Open(Condition::Natural, "clamped:1/2".parse().unwrap());
    assert_eq!(
        json(&interpolation(&rows("0;1").unwrap(), None, ends, &limits).unwrap()),
        r#"{"parameters":["0","1"],"points":[["0"],["1"]],"ends":["natural","clamped:1/2"],"tangents":[["5/4"],["1/2"]],"knots":["-3","-2","-1","0","1","2","3","4"],"control_points":[["-5/4"],["0"],["5/4"],["1"]]}"#
    );
}

#[test]
fn latex_is_balanced() {
    let limits = Default::default();
    let knots = fractions("-1,0,0,1/3,2,3,3,3").unwrap();
    let answers: Vec<Box<dyn Answer>> = vec![
        Box::new(matrix(&"bspline".parse().unwrap(), 12, &limits).unwrap()),
        Box::new(matrix(&"cardinal:1/3".parse().unwrap(), 3, &limits).unwrap()),
        Box::new(blending(&knots, 2, &limits).unwrap()),
        Box::new(at(&knots, 2, &"1/2".parse().unwrap(), 1, Side::Right, &limits).unwrap()),
        Box::new(scheme(&scheme_named("four-point").unwrap(), &limits).unwrap()),
        Box::new(triplets(2, &limits).unwrap()),
    ];
    for answer in answers {
        let text = render(&*answer, Format::Latex).unwrap();
        for (open, close) in [("{", "}"), ("\\left(", "\\right)"), ("\\begin{", "\\end{")] {
            assert_eq!(text.matches(open).count(), text.matches(close).count(), "{open} in\n{text}");
        }
        let shown: Vec<&str> = text.lines().filter(|line| !line.starts_with('%')).collect();
        assert!(shown.iter().all(|line| line.starts_with("\\[ ") && line.ends_with(" \\]")), "{text}");
        let formulas: String = text.lines().filter(|line| !line.starts_with('%')).collect();
        assert!(formulas.is_ascii(), "{formulas}");
    }
    let cubic = render(&matrix(&"bspline".parse().unwrap(), 3, &limits).unwrap(), Format::Latex).unwrap();
    assert!(cubic.contains(r"M = \frac{1}{6} \left(\begin{array}{rrrr} -1 & 3 & -3 & 1 \\ 3 & -6 & 3 & 0 \\ -3 & 0 & 3 & 0 \\ 1 & 4 & 1 & 0 \end{array}\right)"));
}
