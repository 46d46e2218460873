//! The verbs of the library on curves whose family and dimension are known at run time.

use crate::steps::Step;
use clap::ValueEnum;
use lath::curve::{AnyCurve, BSpline, Bezier, Curve, CurveBuilder, CurveVisitor, Interval, Nurbs, RationalBezier};
use lath::error::{Code, Error, Limits, Result};
use lath::num::Bound;
use lath::refine::{to_beziers, to_bspline, to_hermite, to_power};
use lath_io::number::shortest;
use std::any::Any;

/// What a step makes of a curve.
pub(crate) struct Outcome {
    /// The curves: one, or two of a split.
    pub(crate) curves: Vec<AnyCurve>,
    /// What there is to say.
    pub(crate) note: Option<String>,
}

/// A curve as the verbs take it; `piece`: it came as a Bézier curve, and goes as one if it still is.
#[derive(Clone, Debug)]
enum Work<const D: usize> {
    Polynomial { curve: BSpline<D>, piece: bool },
    Rational { curve: Nurbs<D>, piece: bool },
}

/// The same method of either kind.
macro_rules! each {
    ($work:expr, $curve:ident => $verb:expr) => {
        match $work {
            Work::Polynomial { curve: $curve, piece } => Work::Polynomial { curve: $verb, piece: *piece },
            Work::Rational { curve: $curve, piece } => Work::Rational { curve: $verb, piece: *piece },
        }
    };
}

/// The same method of either kind, with the bound that it returns.
macro_rules! each_within {
    ($work:expr, $curve:ident => $verb:expr) => {
        match $work {
            Work::Polynomial { curve: $curve, piece } => {
                let (curve, bound) = $verb;
                (Work::Polynomial { curve, piece: *piece }, bound)
            }
            Work::Rational { curve: $curve, piece } => {
                let (curve, bound) = $verb;
                (Work::Rational { curve, piece: *piece }, bound)
            }
        }
    };
}

impl<const D: usize> Work<D> {
    fn of(curve: &dyn Curve<D>) -> Result<Work<D>> {
        let any = curve as &dyn Any;
        if let Some(curve) = any.downcast_ref::<Nurbs<D>>() {
            return Ok(Work::Rational { curve: curve.clone(), piece: false });
        }
        if let Some(curve) = any.downcast_ref::<RationalBezier<D>>() {
            return Ok(Work::Rational { curve: curve.to_nurbs()?, piece: true });
        }
        Ok(Work::Polynomial { curve: to_bspline(curve)?, piece: any.is::<Bezier<D>>() })
    }

    fn curve(self) -> Result<Box<dyn Curve<D>>> {
        // A Bézier curve again, if there are no knots inside.
        let single = |knots: &lath::knot::Knots| knots.functions() == knots.degree() + 1;
        Ok(match self {
            Work::Polynomial { curve, piece: true } if !curve.is_closed() && single(curve.knots()) => {
                Box::new(Bezier::on(curve.clamp()?.control_points(), curve.domain())?)
            }
            Work::Rational { curve, piece: true } if !curve.is_closed() && single(curve.knots()) => {
                let curve = curve.clamp()?;
                let weights: Vec<f64> = curve.weights().to_vec();
                Box::new(RationalBezier::on(curve.control_points(), weights, curve.domain())?)
            }
            Work::Polynomial { curve, .. } => Box::new(curve),
            Work::Rational { curve, .. } => Box::new(curve),
        })
    }

    fn points(&self) -> usize {
        match self {
            Work::Polynomial { curve, .. } => curve.control_points().len(),
            Work::Rational { curve, .. } => curve.control_points().len(),
        }
    }

    fn take(&self, step: &Step, limits: &Limits<'_>) -> Result<(Vec<Work<D>>, Option<String>)> {
        let one = |work: Work<D>| Ok((vec![work], None));
        match step {
            Step::Insert(at) => one(each!(self, curve => curve.insert_knots(at)?)),
            Step::Halve(levels) => one(each!(self, curve => curve.refine_uniformly(*levels, limits)?)),
            Step::Elevate(by) => {
                // A degree more takes one point for each span.
                let spans = match self {
                    Work::Polynomial { curve, .. } => curve.breaks().len(),
                    Work::Rational { curve, .. } => curve.breaks().len(),
                } as u64;
                limits.check_points((*by as u64).saturating_mul(spans).saturating_add(self.points() as u64))?;
                one(each!(self, curve => curve.elevate(*by)?))
            }
            Step::Reduce(by, tolerance) => {
                let (work, bound) = each_within!(self, curve => curve.reduce(*by, *tolerance)?);
                Ok((vec![work], Some(format!("degree lowered by {by}, {}", moved(bound)))))
            }
            Step::Remove(tolerance) => {
                let (work, bound) = each_within!(self, curve => curve.remove_knots(*tolerance)?);
                let gone = self.points() - work.points();
                let knots = if gone == 1 { "knot" } else { "knots" };
                Ok((vec![work], Some(format!("{gone} {knots} removed, {}", moved(bound)))))
            }
            Step::Close(tolerance) => {
                let (work, bound) = each_within!(self, curve => curve.close(*tolerance)?);
                Ok((vec![work], Some(format!("closed, {}", moved(bound)))))
            }
            Step::Split(t) => {
                let parts = match self {
                    Work::Polynomial { curve, piece } => {
                        let (left, right) = curve.split(*t)?;
                        [left, right].map(|curve| Work::Polynomial { curve, piece: *piece }).to_vec()
                    }
                    Work::Rational { curve, piece } => {
                        let (left, right) = curve.split(*t)?;
                        [left, right].map(|curve| Work::Rational { curve, piece: *piece }).to_vec()
                    }
                };
                Ok((parts, None))
            }
            Step::Trim(start, end) => {
                let part = Interval { start: *start, end: *end };
                one(each!(self, curve => curve.trim(part)?))
            }
            Step::Domain(start, end) => {
                let domain = Interval { start: *start, end: *end };
                one(each!(self, curve => curve.reparametrise(domain)?))
            }
            Step::Clamp => one(each!(self, curve => curve.clamp()?)),
            Step::Seam(t) => one(each!(self, curve => curve.move_seam(*t)?)),
            Step::Reverse => one(each!(self, curve => curve.reverse()?)),
            Step::Derivative | Step::Antiderivative => match self {
                Work::Polynomial { curve, piece } => {
                    let curve = if *step == Step::Derivative { curve.derivative()? } else { curve.antiderivative()? };
                    one(Work::Polynomial { curve, piece: *piece })
                }
                Work::Rational { .. } => {
                    let message = "derivatives and antiderivatives of rational curves are no curves of the same kind";
                    Err(Error::new(Code::Q006, message))
                }
            },
            // Takes all curves of the file at once: see `join`.
            Step::Join(_) => one(self.clone()),
        }
    }

    fn join(&self, other: &Work<D>, tolerance: f64) -> Result<(Work<D>, String)> {
        let (work, joint, degree) = match (self, other) {
            (Work::Polynomial { curve: a, .. }, Work::Polynomial { curve: b, .. }) => {
                let (curve, joint) = a.join(b, tolerance)?;
                let degree = curve.degree();
                (Work::Polynomial { curve, piece: false }, joint, degree)
            }
            (a, b) => {
                let (curve, joint) = a.rational()?.join(&b.rational()?, tolerance)?;
                let degree = curve.degree();
                (Work::Rational { curve, piece: false }, joint, degree)
            }
        };
        let smooth = match joint.multiplicity {
            0 => "as one polynomial".to_owned(),
            m if m <= degree => format!("C^{}", degree - m),
            _ => "with a jump".to_owned(),
        };
        Ok((work, format!("joined at t = {}, {smooth}, {}", shortest(joint.t), moved(joint.bound))))
    }

    fn rational(&self) -> Result<Nurbs<D>> {
        match self {
            Work::Polynomial { curve, .. } => curve.to_nurbs(),
            Work::Rational { curve, .. } => Ok(curve.clone()),
        }
    }
}

/// A bound, for people.
fn moved(bound: Bound) -> String {
    match bound {
        Bound::Proven(0.0) => "no point has moved".to_owned(),
        Bound::Proven(distance) => format!("points moved by at most {distance:.1e}"),
        Bound::Estimate(distance) => format!("points moved by about {distance:.1e}"),
    }
}

/// Takes a step with one curve.
pub(crate) fn take(step: &Step, curve: &AnyCurve, limits: &Limits<'_>) -> Result<Outcome> {
    struct Take<'a>(&'a Step, &'a Limits<'a>);
    impl CurveVisitor for Take<'_> {
        type Output = Result<Outcome>;
        fn visit<const D: usize>(self, curve: &dyn Curve<D>, dimension: usize) -> Result<Outcome> {
            let (works, note) = Work::of(curve)?.take(self.0, self.1)?;
            let curves = works.into_iter().map(|work| any(work, dimension)).collect::<Result<_>>()?;
            Ok(Outcome { curves, note })
        }
    }
    curve.visit(Take(step, limits))
}

/// Joins two curves of the same dimension.
pub(crate) fn join(first: &AnyCurve, second: &AnyCurve, tolerance: f64) -> Result<Outcome> {
    struct Join<'a>(&'a AnyCurve, f64);
    impl CurveVisitor for Join<'_> {
        type Output = Result<Outcome>;
        fn visit<const D: usize>(self, curve: &dyn Curve<D>, dimension: usize) -> Result<Outcome> {
            let other = self.0.visit(Taken)?.downcast::<Work<D>>().ok().filter(|_| self.0.dimension() == dimension);
            let Some(other) = other else {
                let message = format!("a curve in {} dimensions after one in {dimension}", self.0.dimension());
                return Err(Error::new(Code::P005, message));
            };
            let (work, note) = Work::of(curve)?.join(&other, self.1)?;
            Ok(Outcome { curves: vec![any(work, dimension)?], note: Some(note) })
        }
    }
    first.visit(Join(second, tolerance))
}

/// A family to convert to.
#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
pub(crate) enum Form {
    /// Bézier curves, one for each piece
    Bezier,
    /// A B-spline
    Bspline,
    /// Points and tangents: cubic at most, with one tangent at each joint
    Hermite,
    /// Powers of t on each piece
    Power,
}

/// How far tangents of both sides may disagree, of the size of the curve: rounding.
const AGREED: f64 = 1e-12;

/// The same curve in another form.
pub(crate) fn convert(curve: &AnyCurve, form: Form) -> Result<Outcome> {
    struct Convert(Form);
    impl CurveVisitor for Convert {
        type Output = Result<Outcome>;
        fn visit<const D: usize>(self, curve: &dyn Curve<D>, dimension: usize) -> Result<Outcome> {
            let (curves, note) = converted(curve, self.0)?;
            let curves = curves.into_iter().map(|curve| held(curve, dimension)).collect::<Result<_>>()?;
            Ok(Outcome { curves, note })
        }
    }
    curve.visit(Convert(form))
}

/// Curves in their dimension, and what there is to say.
type Converted<const D: usize> = (Vec<Box<dyn Curve<D>>>, Option<String>);

fn converted<const D: usize>(curve: &dyn Curve<D>, form: Form) -> Result<Converted<D>> {
    fn boxed<const D: usize, C: Curve<D>>(curve: C) -> Box<dyn Curve<D>> {
        Box::new(curve)
    }
    let one = |curve: Box<dyn Curve<D>>| Ok((vec![curve], None));
    match (form, Work::of(curve)) {
        (Form::Bezier, Ok(Work::Rational { curve, .. })) => {
            Ok((curve.to_beziers()?.into_iter().map(boxed).collect(), None))
        }
        (Form::Bezier, _) => Ok((to_beziers(curve)?.into_iter().map(boxed).collect(), None)),
        (Form::Bspline, Ok(Work::Rational { curve, .. })) => one(boxed(curve)),
        (Form::Bspline, _) => one(boxed(to_bspline(curve)?)),
        (Form::Power, _) => one(boxed(to_power(curve)?)),
        (Form::Hermite, _) => {
            let mut size = f64::MIN_POSITIVE;
            curve.bezier_pieces(&mut |piece| {
                size = piece
                    .points
                    .as_flattened()
                    .iter()
                    .fold(size, |most, x| if x.abs() > most { x.abs() } else { most });
            });
            let (curve, bound) = to_hermite(curve, size * AGREED)?;
            let note = format!("tangents on both sides agree within {:.1e}", bound.value());
            Ok((vec![boxed(curve)], Some(note)))
        }
    }
}

/// The curve as the verbs take it, in whatever dimension it is.
struct Taken;

impl CurveVisitor for Taken {
    type Output = Result<Box<dyn Any>>;
    fn visit<const D: usize>(self, curve: &dyn Curve<D>, _dimension: usize) -> Result<Box<dyn Any>> {
        Ok(Box::new(Work::of(curve)?))
    }
}

/// What came of a step, as a curve of `dimension` ≤ D dimensions.
fn any<const D: usize>(work: Work<D>, dimension: usize) -> Result<AnyCurve> {
    held(work.curve()?, dimension)
}

/// A curve of D dimensions as one of `dimension` ≤ D.
fn held<const D: usize>(curve: Box<dyn Curve<D>>, dimension: usize) -> Result<AnyCurve> {
    struct Made(Box<dyn Any>);
    impl CurveBuilder for Made {
        fn build<const E: usize>(self) -> Result<Box<dyn Curve<E>>> {
            match self.0.downcast::<Box<dyn Curve<E>>>() {
                Ok(curve) => Ok(*curve),
                // The curve came from the instance that its dimension leads back to.
                Err(_) => Err(Error::new(Code::P006, format!("a curve in {E} dimensions"))),
            }
        }
    }
    AnyCurve::build(dimension, Made(Box::new(curve)))
}
