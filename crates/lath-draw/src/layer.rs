//! What a figure is made of: curves with what is drawn along them, and rows of points.

use crate::lens::Spot;
use crate::theme::Color;
use core::any::Any;
use lath::curve::{AnyCurve, BSpline, Bezier, Curve, CurveVisitor, Nurbs, RationalBezier, UniformBSpline};
use lath::error::{Code, Error, Result};

/// A curve, with its control polygon, knots and curvature comb if wanted.
///
/// ```
/// use lath::curve::Bezier;
/// use lath_draw::layer::CurveLayer;
///
/// let arch = Bezier::new([[0.0, 0.0], [1.0, 2.0], [3.0, 0.0]])?;
/// let layer = CurveLayer::of(arch)?.label("arch").polygon(true).comb(true);
/// # Ok::<(), lath::error::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct CurveLayer {
    pub(crate) curve: AnyCurve,
    pub(crate) label: Option<String>,
    pub(crate) color: Option<Color>,
    pub(crate) polygon: bool,
    pub(crate) knots: bool,
    pub(crate) comb: bool,
    pub(crate) letter: Option<char>,
}

impl CurveLayer {
    /// A curve alone. It is shared, not copied.
    pub fn new(curve: &AnyCurve) -> CurveLayer {
        let (curve, label, color, letter) = (curve.clone(), None, None, None);
        CurveLayer { curve, label, color, polygon: false, knots: false, comb: false, letter }
    }

    /// A curve whose dimension is known when compiling: 1, 2, 3, 4, 8 or 16.
    ///
    /// *Errors.* P006 for another dimension.
    pub fn of<const D: usize>(curve: impl Curve<D>) -> Result<CurveLayer> {
        Ok(CurveLayer::new(&AnyCurve::of(curve)?))
    }

    /// Its name in the legend.
    pub fn label(mut self, label: impl Into<String>) -> CurveLayer {
        self.label = Some(label.into());
        self
    }

    /// Its colour, if not the next one of the theme.
    pub fn color(mut self, color: Color) -> CurveLayer {
        self.color = Some(color);
        self
    }

    /// Whether the control polygon is drawn: the control points of a Bézier curve or B-spline (over the graph of one
    /// dimension at their Greville abscissae), of other polynomial curves those of their Bézier pieces.
    pub fn polygon(mut self, polygon: bool) -> CurveLayer {
        self.polygon = polygon;
        self
    }

    /// A letter for the points of its control polygon, where it is drawn and is one: P₀, P₁, … None are written beside more than
    /// 200 points.
    pub fn letter(mut self, letter: char) -> CurveLayer {
        self.letter = Some(letter);
        self
    }

    /// Whether the curve's breaks are marked by short strokes across it.
    pub fn knots(mut self, knots: bool) -> CurveLayer {
        self.knots = knots;
        self
    }

    /// Whether the curvature comb is drawn: teeth away from the centre of curvature, as long as κ says; over a graph the
    /// second derivative. Where κ varies a lot, long teeth are shortened logarithmically, and the legend says from where.
    pub fn comb(mut self, comb: bool) -> CurveLayer {
        self.comb = comb;
        self
    }

    /// The control polygons as the picture sees them.
    pub(crate) fn polygons(&self) -> Vec<Polygon> {
        self.curve.visit(Polygons)
    }

    /// The points of the control polygon with their names.
    pub(crate) fn named_polygon(&self) -> Option<PointLayer> {
        const READABLE: usize = 200;
        let letter = self.letter.filter(|_| self.polygon)?;
        let polygon = match <[Polygon; 1]>::try_from(self.polygons()) {
            Ok([polygon]) if polygon.spots.len() <= READABLE => polygon,
            _ => return None,
        };
        let names = (0..polygon.spots.len()).map(|i| indexed(letter, i)).collect();
        let layer = PointLayer::checked(self.curve.dimension(), polygon.spots).ok()?;
        Some(layer.names(names).join(if polygon.closed { Join::Closed } else { Join::Open }))
    }
}

/// A letter with an index below, such as P₁₂.
pub fn indexed(letter: char, index: usize) -> String {
    let below = |digit: char| char::from_u32('₀' as u32 + digit.to_digit(10).unwrap_or(0)).unwrap_or(digit);
    core::iter::once(letter).chain(index.to_string().chars().map(below)).collect()
}

/// Points, as dots, as a polyline, or both.
///
/// ```
/// use lath_draw::layer::{Join, PointLayer};
///
/// let triangle = PointLayer::new(2, &[0.0, 0.0, 4.0, 0.0, 0.0, 3.0])?.join(Join::Closed).label("3 points");
/// assert!(PointLayer::new(2, &[1.0, 2.0, 3.0]).is_err());
/// # Ok::<(), lath::error::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct PointLayer {
    pub(crate) dimension: usize,
    pub(crate) spots: Vec<Spot>,
    pub(crate) label: Option<String>,
    pub(crate) color: Option<Color>,
    pub(crate) names: Vec<String>,
    pub(crate) dots: bool,
    pub(crate) join: Join,
}

/// How points are joined by lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Join {
    /// Not at all.
    #[default]
    None,
    /// In their order.
    Open,
    /// In their order and back to the first.
    Closed,
    /// The first with the second, the third with the fourth, and so on: tangents, for one.
    Pairs,
}

impl PointLayer {
    /// Points of `dimension` coordinates, row by row. Of one coordinate: a graph over t = 0, 1, 2, …
    ///
    /// *Errors.* P006 for dimension 0 or above 16; P005 if the rows do not come out even; P002, P003 for coordinates
    /// that are not finite or beyond 1e300.
    pub fn new(dimension: usize, rows: &[f64]) -> Result<PointLayer> {
        if dimension == 0 || dimension > lath::curve::MAX_DIMENSION {
            return Err(Error::new(Code::P006, format!("points of {dimension} coordinates")));
        }
        if !rows.len().is_multiple_of(dimension) {
            let message = format!("{} numbers are not rows of {dimension}", rows.len());
            return Err(Error::new(Code::P005, message).at(rows.len() / dimension));
        }
        let spots = rows.chunks_exact(dimension).enumerate().map(|(i, row)| match row {
            [value] => [i as f64, *value, 0.0],
            _ => core::array::from_fn(|c| row.get(c).copied().unwrap_or(0.0)),
        });
        PointLayer::checked(dimension, spots.collect())
    }

    /// Points (t, value) of a graph.
    ///
    /// *Errors.* T004 if there are not as many parameters as values; P002, P003 as [`PointLayer::new`].
    pub fn graph(parameters: &[f64], values: &[f64]) -> Result<PointLayer> {
        if parameters.len() != values.len() {
            let message = format!("{} parameters for {} values", parameters.len(), values.len());
            return Err(Error::new(Code::T004, message));
        }
        PointLayer::checked(1, parameters.iter().zip(values).map(|(t, value)| [*t, *value, 0.0]).collect())
    }

    fn checked(dimension: usize, spots: Vec<Spot>) -> Result<PointLayer> {
        for (index, x) in spots.iter().enumerate().flat_map(|(i, spot)| spot.iter().map(move |x| (i, *x))) {
            if !x.is_finite() {
                return Err(Error::new(Code::P002, format!("a coordinate of point {index} is {x}")).at(index));
            }
            if x.abs() > 1e300 {
                return Err(Error::new(Code::P003, format!("a coordinate of point {index} is {x:e}")).at(index));
            }
        }
        let (label, color, names) = (None, None, Vec::new());
        Ok(PointLayer { dimension, spots, label, color, names, dots: true, join: Join::None })
    }

    /// Their name in the legend.
    pub fn label(mut self, label: impl Into<String>) -> PointLayer {
        self.label = Some(label.into());
        self
    }

    /// Their colour. Else dots are drawn in ink, pairs are muted, and other joined points have the theme's next colour.
    pub fn color(mut self, color: Color) -> PointLayer {
        self.color = Some(color);
        self
    }

    /// Names written beside the first points, in the points' colour; one that would cover another is left out.
    pub fn names(mut self, names: Vec<String>) -> PointLayer {
        self.names = names;
        self
    }

    /// Whether the points themselves are drawn (they are, unless told otherwise).
    pub fn dots(mut self, dots: bool) -> PointLayer {
        self.dots = dots;
        self
    }

    /// How the points are joined.
    pub fn join(mut self, join: Join) -> PointLayer {
        self.join = join;
        self
    }
}

/// Control points as the picture sees them.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Polygon {
    pub(crate) spots: Vec<Spot>,
    pub(crate) closed: bool,
}

struct Polygons;

impl CurveVisitor for Polygons {
    type Output = Vec<Polygon>;

    fn visit<const D: usize>(self, curve: &dyn Curve<D>, dimension: usize) -> Vec<Polygon> {
        let domain = curve.domain();
        let even = |n: usize, start: f64, end: f64| {
            (0..n).map(move |i| if n < 2 { start } else { start + (end - start) * (i as f64 / (n - 1) as f64) })
        };
        let seen = |points: &[[f64; D]], abscissae: &mut dyn Iterator<Item = f64>| -> Vec<Spot> {
            let spot = |(b, t): (&[f64; D], f64)| match dimension {
                1 => [t, b[0], 0.0],
                _ => core::array::from_fn(|c| if c < dimension { b.get(c).copied().unwrap_or(0.0) } else { 0.0 }),
            };
            points.iter().zip(abscissae).map(spot).collect()
        };
        // Weights pull at the curve, not at its control points.
        let any = curve as &dyn Any;
        let bezier = any.downcast_ref::<RationalBezier<D>>().map(RationalBezier::unweighted);
        if let Some(bezier) = bezier.or_else(|| any.downcast_ref::<Bezier<D>>()) {
            let points = bezier.control_points();
            let spots = seen(points, &mut even(points.len(), domain.start, domain.end));
            return vec![Polygon { spots, closed: false }];
        }
        if let Some(uniform) = (curve as &dyn Any).downcast_ref::<UniformBSpline<D>>()
            && let Ok(spline) = uniform.to_bspline()
        {
            return self.visit(&spline, dimension);
        }
        let spline = any.downcast_ref::<Nurbs<D>>().map(Nurbs::unweighted);
        if let Some(spline) = spline.or_else(|| any.downcast_ref::<BSpline<D>>()) {
            let (knots, degree) = (spline.knots().values(), spline.knots().degree());
            // The mean of the inner knots of a function's support.
            let greville = |i: usize| {
                let inner = knots.get(i + 1..=i + degree).unwrap_or(&[]);
                match (inner.len(), knots.get(i), knots.get(i + 1)) {
                    (0, Some(a), Some(b)) => a / 2.0 + b / 2.0,
                    (n, ..) => inner.iter().fold(0.0, |sum, t| sum + t / n as f64),
                }
            };
            let spots = seen(spline.control_points(), &mut (0..).map(greville));
            // Over a graph a closed spline's polygon goes on into the next period instead of back.
            return vec![Polygon { spots, closed: curve.is_closed() && dimension > 1 }];
        }
        let mut polygons = Vec::new();
        curve.bezier_pieces(&mut |piece| {
            let spots = seen(piece.points, &mut even(piece.points.len(), piece.start, piece.end));
            polygons.push(Polygon { spots, closed: false });
        });
        if polygons.is_empty() {
            curve.rational_pieces(&mut |piece| {
                let points: Vec<[f64; D]> = piece.points.iter().map(|point| point.point).collect();
                let spots = seen(&points, &mut even(points.len(), piece.start, piece.end));
                polygons.push(Polygon { spots, closed: false });
            });
        }
        polygons
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lath::knot::Knots;

    #[test]
    fn bad_points_name_the_culprit() {
        let code = |r: Result<PointLayer>| r.map(|_| ()).unwrap_err().code();
        assert_eq!(code(PointLayer::new(0, &[])), Code::P006);
        assert_eq!(code(PointLayer::new(17, &[0.0; 17])), Code::P006);
        assert_eq!(code(PointLayer::new(2, &[1.0])), Code::P005);
        assert_eq!(code(PointLayer::new(1, &[1.0, f64::NAN])), Code::P002);
        assert_eq!(code(PointLayer::new(1, &[1e301])), Code::P003);
        assert_eq!(code(PointLayer::graph(&[1.0], &[])), Code::T004);
        assert_eq!(PointLayer::new(2, &[0.0, 0.0, 1.0, f64::INFINITY]).unwrap_err().index(), Some(1));
        assert_eq!(PointLayer::new(2, &[]).unwrap().spots.len(), 0);
    }

    #[test]
    fn graphs_have_their_control_points_at_the_greville_abscissae() {
        let knots = Knots::new(vec![0.0, 0.0, 0.0, 1.0, 3.0, 3.0, 3.0], 2).unwrap();
        let spline = BSpline::new(knots, [[1.0], [2.0], [3.0], [4.0]]).unwrap();
        let polygons = CurveLayer::of(spline).unwrap().polygons();
        let abscissae: Vec<f64> = polygons[0].spots.iter().map(|s| s[0]).collect();
        assert_eq!(abscissae, [0.0, 0.5, 2.0, 3.0]);
    }

    #[test]
    fn the_points_of_one_polygon_have_names() {
        let layer = CurveLayer::of(Bezier::new([[0.0; 2], [1.0; 2]]).unwrap()).unwrap();
        let names = |layer: CurveLayer| layer.named_polygon().map(|named| named.names);
        assert_eq!(names(layer.clone().letter('b')), None, "the polygon is not drawn");
        assert_eq!(names(layer.polygon(true).letter('b')), Some(vec!["b₀".to_owned(), "b₁".to_owned()]));
        let long = CurveLayer::of(Bezier::new(vec![[0.0, 1.0]; 201]).unwrap()).unwrap();
        assert_eq!(names(long.polygon(true).letter('b')), None, "too many to be read");
        assert_eq!(indexed('P', 120), "P₁₂₀");
    }

    #[test]
    fn weights_leave_the_polygon() {
        let points = [[0.0, 0.0], [1.0, 2.0], [3.0, 0.0]];
        let polygon = |layer: Result<CurveLayer>| layer.unwrap().polygons();
        let plain = polygon(CurveLayer::of(Bezier::new(points).unwrap()));
        assert_eq!(polygon(CurveLayer::of(RationalBezier::new(points, [1.0, 5.0, 1.0]).unwrap())), plain);
        let knots = Knots::clamped(3, 2).unwrap();
        let rational = Nurbs::new(knots, points, [1.0, 5.0, 1.0]).unwrap();
        assert_eq!(polygon(CurveLayer::of(rational))[0].spots, plain[0].spots);
    }

    #[test]
    fn a_concrete_curve_keeps_its_dimension() {
        let line = Bezier::new([[0.0; 3], [1.0; 3]]).unwrap();
        assert_eq!(CurveLayer::of(line).unwrap().curve.dimension(), 3);
        let line = Bezier::new([[0.0; 5], [1.0; 5]]).unwrap();
        assert_eq!(CurveLayer::of(line).unwrap_err().code(), Code::P006);
    }
}
