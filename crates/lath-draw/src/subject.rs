//! What a figure is asked to show.

use crate::layer::{CurveLayer, Join, PointLayer};
use crate::lens::View;
use crate::theme::{Color, Theme};
use lath::error::{Code, Error, Result};

/// The layers of a figure and how they are to be seen.
#[derive(Clone, Debug)]
pub(crate) struct Subject {
    pub(crate) title: String,
    pub(crate) names: Vec<String>,
    pub(crate) layers: Vec<Layer>,
    pub(crate) size: Option<[f64; 2]>,
    pub(crate) theme: Theme,
    pub(crate) axes: bool,
    pub(crate) legend: bool,
    pub(crate) camera: [f64; 2],
}

/// One thing to show.
#[derive(Clone, Debug)]
pub(crate) enum Layer {
    Curve(CurveLayer),
    Points(PointLayer),
}

impl Subject {
    pub(crate) fn curves(&self) -> impl Iterator<Item = (usize, &CurveLayer)> + Clone {
        self.layers.iter().enumerate().filter_map(|(i, layer)| match layer {
            Layer::Curve(curve) => Some((i, curve)),
            Layer::Points(_) => None,
        })
    }

    pub(crate) fn rows(&self) -> impl Iterator<Item = (usize, &PointLayer)> + Clone {
        self.layers.iter().enumerate().filter_map(|(i, layer)| match layer {
            Layer::Points(points) => Some((i, points)),
            Layer::Curve(_) => None,
        })
    }

    /// Graph, plane or space, the same for all layers.
    pub(crate) fn kind(&self) -> Result<View> {
        let kind = |layer: &Layer| match layer {
            Layer::Curve(layer) => layer.curve.dimension().min(3),
            Layer::Points(layer) => layer.dimension.min(3),
        };
        let first = self.layers.first().map_or(2, kind);
        if let Some(index) = self.layers.iter().position(|layer| kind(layer) != first) {
            let message = format!("layer {index} has {} dimensions, the first has {first}", kind(&self.layers[index]));
            return Err(Error::new(Code::P005, message).at(index));
        }
        let [azimuth, elevation] = self.camera;
        match first {
            1 => Ok(View::Graph),
            2 => Ok(View::Plane),
            _ if azimuth.is_finite() && elevation.is_finite() => Ok(View::space(azimuth, elevation)),
            _ => Err(Error::new(Code::T001, format!("the view is {azimuth}, {elevation} degrees"))),
        }
    }

    /// The colour of each layer: its own, or the next of the theme; dots alone are ink, pairs muted.
    pub(crate) fn colors(&self) -> Vec<Color> {
        let mut series = 0;
        let mut next = || {
            series += 1;
            self.theme.series(series - 1)
        };
        self.layers
            .iter()
            .map(|layer| match layer {
                Layer::Curve(layer) => layer.color.unwrap_or_else(&mut next),
                Layer::Points(layer) if layer.join == Join::None => layer.color.unwrap_or(self.theme.ink),
                Layer::Points(layer) if layer.join == Join::Pairs => layer.color.unwrap_or(self.theme.muted),
                Layer::Points(layer) => layer.color.unwrap_or_else(&mut next),
            })
            .collect()
    }
}
