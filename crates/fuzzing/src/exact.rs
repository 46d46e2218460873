//! Questions in fractions, as lines of text.

use lath::error::Limits;
use lath::knot::Side;
use lath::subdivide::Index;
use lath_exact::answer::{
    self, Basis, Condition, Ends, Form, SplineEnds, at, blending, change, collocation, elevation, elevation_bezier,
    greville, insertion, interpolation, scheme_named,
};
use lath_exact::error::{Code, Result};
use lath_exact::print::{Answer, Format, Language, render};
use lath_exact::{Rational, parse};

/// The target: the question in the first line, its arguments in the following.
pub fn run(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    let mut lines = text.split('\n');
    let question = lines.next().unwrap_or_default();
    match answered(question, &mut |_| lines.next().unwrap_or_default().to_owned()) {
        Ok(Some(answer)) => printed(&*answer),
        Ok(None) => {}
        Err(error) => {
            assert!(!error.message().is_empty() && error.remedy().ends_with('.'), "{error}");
        }
    }
}

/// A number that a question takes: whole, and as large as the text says.
fn whole(text: &str) -> usize {
    text.parse().unwrap_or(2)
}

type Made = Option<Box<dyn Answer>>;

fn answered(question: &str, line: &mut dyn FnMut(&str) -> String) -> Result<Made> {
    // About a tenth of a second.
    let limits = &Limits { max_points: 1 << 21, max_bytes: 1 << 20, cancel: None };
    Ok(Some(match question {
        "matrix" => Box::new(answer::matrix(&line("basis").parse::<Basis>()?, whole(&line("degree")), limits)?),
        "blending" => {
            let degree = whole(&line("degree"));
            Box::new(blending(&parse::fractions(&line("knots"))?, degree, limits)?)
        }
        "scheme" => Box::new(answer::scheme(&scheme_named(&line("scheme"))?, limits)?),
        "point" | "limit" => {
            let (scheme, level) = (scheme_named(&line("scheme"))?, whole(&line("level")));
            let Ok(index) = line("index").parse::<Index>() else { return Ok(None) };
            let ask = if question == "point" { answer::point } else { answer::limit };
            Box::new(ask(&scheme, level, &index, limits)?)
        }
        "jump" => {
            let (scheme, level) = (scheme_named(&line("scheme"))?, whole(&line("level")));
            let Ok(index) = line("index").parse::<Index>() else { return Ok(None) };
            Box::new(answer::jump(&scheme, (level, index), whole(&line("to")), limits)?)
        }
        "triplets" => Box::new(answer::triplets(whole(&line("level")), limits)?),
        "at" => {
            let (degree, derivative) = (whole(&line("degree")), whole(&line("derivative")));
            let (knots, t) = (parse::fractions(&line("knots"))?, parse::fraction(&line("t"))?);
            let side = if derivative % 2 == 0 { Side::Right } else { Side::Left };
            let weights = at(&knots, degree, &t, derivative, side, limits)?;
            match line("points") {
                points if points.is_empty() => Box::new(weights),
                points => Box::new(weights.with_points(parse::rows(&points)?)?),
            }
        }
        "greville" => {
            let degree = whole(&line("degree"));
            Box::new(greville(&parse::fractions(&line("knots"))?, degree)?)
        }
        "insertion" => {
            let degree = whole(&line("degree"));
            let (knots, inserted) = (parse::fractions(&line("knots"))?, parse::fractions(&line("insert"))?);
            Box::new(insertion(&knots, degree, &inserted, limits)?)
        }
        "elevation" => {
            let (degree, by) = (whole(&line("degree")), whole(&line("by")));
            match line("knots") {
                knots if knots.is_empty() => Box::new(elevation_bezier(degree, by, limits)?),
                knots => Box::new(elevation(&parse::fractions(&knots)?, degree, by, limits)?),
            }
        }
        "change" => {
            let degree = whole(&line("degree"));
            let (from, to): (Form, Form) = (line("from").parse()?, line("to").parse()?);
            let interval = (parse::fraction(&line("a"))?, parse::fraction(&line("b"))?);
            Box::new(change(&from, &to, degree, interval, limits)?)
        }
        "interpolation" => {
            let points = parse::rows(&line("points"))?;
            let t = parameters(&line("parameters"))?;
            let ends = match line("start").as_str() {
                "closed" => Ends::Closed,
                "cyclic" => Ends::Cyclic,
                "anticyclic" => Ends::Anticyclic,
                start => Ends::Open(start.parse::<Condition>()?, line("end").parse()?),
            };
            Box::new(interpolation(&points, t.as_deref(), ends, limits)?)
        }
        "collocation" => {
            let (degree, points) = (whole(&line("degree")), parse::rows(&line("points"))?);
            let t = parameters(&line("parameters"))?;
            Box::new(collocation(&points, t.as_deref(), degree, line("ends").parse::<SplineEnds>()?, limits)?)
        }
        number => {
            let x = parse::fraction(number)?;
            assert_eq!(parse::fraction(&x.to_string())?, x);
            let near = x.to_f64();
            assert!(!near.is_nan(), "{x} is near {near}");
            if let Some(back) = Rational::from_f64(near) {
                assert_eq!(back.to_f64(), near);
            }
            return Ok(None);
        }
    }))
}

fn parameters(text: &str) -> Result<Option<Vec<Rational>>> {
    if text.is_empty() { Ok(None) } else { parse::fractions(text).map(Some) }
}

/// Every format prints, or says why it cannot; JSON is JSON.
fn printed(answer: &dyn Answer) {
    for format in [Format::Text, Format::Json, Format::Latex] {
        match render(answer, format) {
            Ok(text) => {
                assert!(text.ends_with('\n'), "{text}");
                let json: Option<serde_json::Value> = serde_json::from_str(&text).ok();
                assert!(format != Format::Json || json.is_some(), "{text}");
            }
            Err(error) => panic!("{error}"),
        }
    }
    for language in [Language::Rust, Language::Python, Language::C] {
        match render(answer, Format::Source(language)) {
            Ok(text) => assert!(text.ends_with('\n') && !text.contains("NaN") && !text.contains("inf,"), "{text}"),
            Err(error) => assert_eq!(error.code(), Code::X005, "{error}"),
        }
    }
}
