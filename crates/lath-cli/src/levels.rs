//! A polygon, its levels under a scheme, and the curve they tend to, as layers of a figure.

use crate::dimension::{InDimension, in_dimension};
use crate::failure::{Failure, Result};
use crate::level_index::level;
use crate::marks;
use crate::scheme::{SCHEMES, SchemeWord};
use lath::curve::{AnyCurve, Curve, CurveBuilder, pad};
use lath::error::{Error, Limits};
use lath::subdivide::{Ends, Scheme, Subdivision, Target};
use lath_draw::layer::{CurveLayer, Join, PointLayer};
use lath_io::number::counted;
use lath_io::points::PointTable;

/// The options of `draw` that ask for levels.
#[derive(Debug, clap::Args)]
pub(crate) struct Levels {
    /// Draw points as a polygon with its levels 1 to K under subdivision, and the curve they tend to.
    #[arg(long, value_name = "K", value_parser = level, allow_hyphen_values = true, conflicts_with = "through")]
    levels: Option<usize>,
    /// The rule by which the polygon is refined (default cubic).
    #[arg(long, value_name = "SCHEME", value_parser = SCHEMES, requires = "levels")]
    scheme: Option<SchemeWord>,
    /// The levels start and end in the end points of the polygon.
    #[arg(long, requires = "levels", conflicts_with = "closed")]
    keep_ends: bool,
}

/// What is drawn.
pub(crate) enum Layer {
    Curve(CurveLayer),
    Points(PointLayer),
}

impl Levels {
    /// Whether levels are asked for.
    pub(crate) fn are_given(&self) -> bool {
        self.levels.is_some()
    }

    /// The limit, then the polygon and its levels.
    pub(crate) fn layers(&self, points: &PointTable, closed: bool, limits: &Limits<'_>) -> Result<Vec<Layer>> {
        let scheme = self.scheme.as_ref().unwrap_or(&SchemeWord::Cubic).scheme()?;
        let ends = match (closed, self.keep_ends) {
            (true, _) => Ends::Closed,
            (_, true) => Ends::Kept,
            _ => Ends::Open,
        };
        let levels = self.levels.unwrap_or(0);
        let work = Work { points, scheme, ends, levels, limits };
        let layers = in_dimension(points.width(), work).and_then(|layers| layers);
        layers.map_err(|error| Failure::from(points.locate(error)))
    }
}

struct Work<'a> {
    points: &'a PointTable,
    scheme: Scheme,
    ends: Ends,
    levels: usize,
    limits: &'a Limits<'a>,
}

/// Points closer than this many to a polygon are drawn as dots.
const DOTS: usize = 64;

impl InDimension for Work<'_> {
    type Output = Result<Vec<Layer>, Error>;

    fn run<const D: usize>(self) -> Result<Vec<Layer>, Error> {
        let points = pad::<D>(self.points.values(), self.points.width());
        let polygon = Subdivision::new(self.scheme.clone(), points, self.ends)?;
        let last = polygon.count(self.levels, Target::Level)?.to_u64().unwrap_or(u64::MAX);
        // The levels before the last have as many points together, and a point takes about a hundred bytes of a picture.
        let all = last.saturating_mul(2);
        self.limits.check_points(all)?;
        self.limits.check_bytes(all.saturating_mul(128))?;
        let mut layers: Vec<Layer> = self.limit(&polygon)?.into_iter().collect();
        for level in 0..=self.levels {
            let rows = polygon.level(level, Target::Level, self.limits)?;
            let (label, count) = match level {
                0 => ("polygon".to_owned(), self.points.len()), // kept ends appear once to the user
                _ => (format!("level {level}"), rows.len()),
            };
            let layer = self.layer(level, &rows, -0.5 * (self.scheme.degree() as f64 - 1.0))?;
            let layer = layer.dots(count <= DOTS).names(names(level, last, rows.len()));
            layers.push(Layer::Points(layer.label(format!("{label}: {}", counted(count, "point")))));
        }
        Ok(layers)
    }
}

/// The names P₀, P₁, … of a polygon's points and P¹₀, P¹₁, … of a level's, while there are few enough to be read.
fn names(level: usize, last: u64, count: usize) -> Vec<String> {
    const READABLE: u64 = 7;
    if last > READABLE {
        return Vec::new();
    }
    (0..count).map(|i| marks::name(level, i)).collect()
}

impl Work<'_> {
    /// Points of a level, joined. Over a graph, point i of a level stands at t = (i + shift)/2ᵏ.
    fn layer<const D: usize>(&self, level: usize, rows: &[[f64; D]], shift: f64) -> Result<PointLayer, Error> {
        let dimension = self.points.width();
        let values: Vec<f64> = rows.iter().flat_map(|row| row.iter().take(dimension).copied()).collect();
        if dimension > 1 {
            let join = if self.ends == Ends::Closed { Join::Closed } else { Join::Open };
            return Ok(PointLayer::new(dimension, &values)?.join(join));
        }
        let step = (0..level).fold(1.0, |step, _| step * 0.5);
        let t: Vec<f64> = (0..values.len()).map(|i| (i as f64 + shift) * step).collect();
        Ok(PointLayer::graph(&t, &values)?.join(Join::Open))
    }

    /// The limit: as the B-spline it is, else as many of its points; none where it is one point or not proven to exist.
    fn limit<const D: usize>(&self, polygon: &Subdivision<D>) -> Result<Option<Layer>, Error> {
        if polygon.spans() == 0 {
            return Ok(None);
        }
        if self.scheme.is_spline() {
            let curve = AnyCurve::build(self.points.width(), Limit(Box::new(polygon.curve()?)))?;
            let label = format!("limit: B-spline of degree {}", self.scheme.degree());
            return Ok(Some(Layer::Curve(CurveLayer::new(&curve).label(label))));
        }
        if !self.scheme.convergence().is_proven() {
            return Ok(None);
        }
        /// More cannot be told apart.
        const SEEN: u64 = 2048;
        let count = |level: usize| polygon.count(level, Target::Limit).ok().and_then(|count| count.to_u64());
        let level = (0..12).find(|&level| count(level).is_none_or(|count| count >= SEEN)).unwrap_or(12);
        let rows = polygon.level(level, Target::Limit, self.limits)?;
        Ok(Some(Layer::Points(self.layer(level, &rows, 0.0)?.dots(false).label("limit"))))
    }
}

/// A curve of known dimension on its way into [`AnyCurve`].
struct Limit(Box<dyn std::any::Any>);

impl CurveBuilder for Limit {
    fn build<const D: usize>(self) -> Result<Box<dyn Curve<D>>, Error> {
        match self.0.downcast::<lath::curve::BSpline<D>>() {
            Ok(curve) => Ok(curve),
            Err(_) => Err(Error::new(lath::error::Code::P006, "the limit has another dimension than its polygon")),
        }
    }
}
