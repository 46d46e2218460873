//! The kinds of curve that pass through points, as words.

use crate::numbers::{finite, list};
use crate::words::{Word, Words, unknown};
use lath::interpolate::Tcb;
use std::fmt;

/// A kind of curve through points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Kind {
    Cubic,
    BSpline,
    CatmullRom,
    Cardinal(f64),
    KochanekBartels(Tcb),
    Pchip,
    Akima,
    Makima,
    Steffen,
}

/// What `--kind` takes: one kind, or several between commas where they are compared.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Kinds(pub(crate) Vec<Kind>);

const KNOWN: &[Word] = &[
    ("cubic", "Piecewise cubic, with continuous second derivative"),
    ("bspline", "B-spline of any --degree: one derivative less than the degree is continuous"),
    ("catmull-rom", "Slopes from the two neighbours: a point moves four pieces only"),
    ("cardinal", "The same with a tension, cardinal:TENSION, from 0 (catmull-rom) to 1 (the polygon)"),
    (
        "kochanek-bartels",
        "With tension, continuity and bias, kochanek-bartels:T,C,B (all 0: catmull-rom at even steps)",
    ),
    ("pchip", "Rises where the data rise, turns where they turn (Fritsch and Butland)"),
    ("akima", "An outlier disturbs its neighbours only"),
    ("makima", "As akima, calmer where data are flat"),
    ("steffen", "As pchip, rounder"),
];

/// The parser of `--kind`.
pub(crate) const KINDS: Words<Kinds> = Words { known: KNOWN, parse: kinds };

fn kinds(text: &str) -> Result<Kinds, String> {
    // A number between commas belongs to the kind before it.
    let mut parts: Vec<String> = Vec::new();
    for part in text.split(',').map(str::trim) {
        match parts.last_mut() {
            Some(last) if last.contains(':') && finite(part).is_ok() => *last = format!("{last},{part}"),
            _ => parts.push(part.to_owned()),
        }
    }
    parts.iter().map(|part| kind(part)).collect::<Result<_, _>>().map(Kinds)
}

fn kind(text: &str) -> Result<Kind, String> {
    let (name, value) = match text.split_once(':') {
        Some((name, value)) => (name, Some(value)),
        None => (text, None),
    };
    let found = match name {
        "cubic" => Kind::Cubic,
        "bspline" => Kind::BSpline,
        "catmull-rom" => Kind::CatmullRom,
        "cardinal" => Kind::Cardinal(value.map_or(Ok(0.0), finite)?),
        "pchip" => Kind::Pchip,
        "akima" => Kind::Akima,
        "makima" => Kind::Makima,
        "steffen" => Kind::Steffen,
        "kochanek-bartels" => match value.map_or(Ok(vec![0.0; 3]), |three| list(three, finite))?[..] {
            [tension, continuity, bias] => Kind::KochanekBartels(Tcb { tension, continuity, bias }),
            _ => return Err("kochanek-bartels takes three numbers: tension, continuity, bias".into()),
        },
        "" => return Err("a kind is missing".into()),
        _ => return Err(unknown("kind", name, KNOWN)),
    };
    match (found, value) {
        (Kind::Cardinal(_) | Kind::KochanekBartels(_), _) | (_, None) => Ok(found),
        (_, Some(value)) => Err(format!("{name} takes no number, but \"{value}\" follows it")),
    }
}

impl Kind {
    /// Whether the ends have conditions.
    pub(crate) fn has_ends(self) -> bool {
        matches!(self, Kind::Cubic | Kind::BSpline)
    }

    /// What a curve of this kind is called in a legend.
    pub(crate) fn label(self, degree: u64) -> String {
        let signed = |x: f64| x.to_string().replace('-', "−");
        match self {
            Kind::Cubic => "cubic spline".into(),
            Kind::BSpline => format!("B-spline of degree {degree}"),
            Kind::CatmullRom => "Catmull–Rom spline".into(),
            Kind::Cardinal(tension) => format!("cardinal spline, tension {}", signed(tension)),
            Kind::KochanekBartels(Tcb { tension, continuity, bias }) => {
                format!("Kochanek–Bartels {}, {}, {}", signed(tension), signed(continuity), signed(bias))
            }
            Kind::Pchip => "PCHIP".into(),
            Kind::Akima => "Akima".into(),
            Kind::Makima => "modified Akima".into(),
            Kind::Steffen => "Steffen".into(),
        }
    }
}

/// The word of the option.
impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Kind::Cubic => "cubic",
            Kind::BSpline => "bspline",
            Kind::CatmullRom => "catmull-rom",
            Kind::Cardinal(_) => "cardinal",
            Kind::KochanekBartels(_) => "kochanek-bartels",
            Kind::Pchip => "pchip",
            Kind::Akima => "akima",
            Kind::Makima => "makima",
            Kind::Steffen => "steffen",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_or_several() {
        assert_eq!(kinds("pchip"), Ok(Kinds(vec![Kind::Pchip])));
        let several = kinds("cubic, cardinal:1/2,akima");
        assert_eq!(several, Ok(Kinds(vec![Kind::Cubic, Kind::Cardinal(0.5), Kind::Akima])));
        assert_eq!(kinds("cardinal:-1"), Ok(Kinds(vec![Kind::Cardinal(-1.0)])));
        for wrong in ["", "cubic,", "cardinal:", "cardinal:1,2", "cardinal:inf", "pchip:1", "0", "cubic,1"] {
            assert!(kinds(wrong).is_err(), "{wrong}");
        }
        let tcb = Tcb { tension: 0.5, continuity: -1.0, bias: 0.0 };
        let several = kinds("pchip,kochanek-bartels:1/2,-1,0,kochanek-bartels");
        let all = vec![Kind::Pchip, Kind::KochanekBartels(tcb), Kind::KochanekBartels(Tcb::default())];
        assert_eq!(several, Ok(Kinds(all)));
        assert!(kinds("kochanek-bartels:1,2").is_err() && kinds("kochanek-bartels:1,2,3,4").is_err());
    }
}
