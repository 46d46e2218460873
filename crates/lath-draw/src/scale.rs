//! How long the teeth of a curvature comb are.
//!
//! The longest tooth has a fixed share of the picture. While κ varies little, length is proportional to κ. The nose of an
//! airfoil bends some hundred times as much as its flanks, which would then have no visible teeth at all. So where the
//! greatest κ is more than [`LINEAR`] times the median (by arc length, straight parts left aside), length is proportional to
//! asinh(κ/κ₀) with the median κ₀: nearly proportional to κ below κ₀, where the fairness of the flanks is judged, nearly to
//! its logarithm above, and strictly increasing throughout, so that zeros, kinks and jumps remain. The legend says so.

use crate::ticks::rounded;

/// The greatest ratio of the longest tooth to the median that is drawn in proportion.
const LINEAR: f64 = 12.0;
/// The curvature, in turns of a radian per size of the picture, below which a curve is straight to the eye.
const STRAIGHT: f64 = 1e-3;
/// The range of κ/κ₀ that is told apart: beyond are cusps, all equally long.
const RANGE: f64 = 1e4;

/// How long a tooth is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Scale {
    /// κ₀ if compressed.
    knee: Option<f64>,
    greatest: f64,
    /// Whether there is more than `greatest`.
    cut: bool,
    height: f64,
}

impl Scale {
    /// The scale for bendings, each with the length of curve that has it; the longest tooth is `height` long. None where
    /// everything is straight.
    pub(crate) fn new(bends: impl Iterator<Item = (f64, f64)>, height: f64) -> Option<Scale> {
        let mut bent: Vec<(f64, f64)> = bends.filter(|(bend, _)| *bend > STRAIGHT).collect();
        bent.sort_by(|a, b| a.0.total_cmp(&b.0));
        let half = bent.iter().fold(0.0, |sum, (_, length)| sum + length) / 2.0;
        let mut sum = 0.0;
        let median = bent.iter().find(|(_, length)| {
            sum += length;
            sum >= half
        });
        let (median, greatest) = (median?.0, bent.last()?.0);
        let cut = greatest > RANGE * median;
        let greatest = if cut { RANGE * median } else { greatest };
        Some(Scale { knee: (greatest > LINEAR * median).then_some(median), greatest, cut, height })
    }

    /// The length of a tooth.
    pub(crate) fn length(&self, bend: f64) -> f64 {
        let bend = if bend > self.greatest { self.greatest } else { bend };
        let share = match self.knee {
            None => bend / self.greatest,
            Some(knee) => libm::asinh(bend / knee) / libm::asinh(self.greatest / knee),
        };
        self.height * share
    }

    /// What the legend says; `unit` is one unit of bending in the data's own units.
    pub(crate) fn words(&self, name: &str, unit: f64) -> String {
        let greatest = rounded(self.greatest * unit, 3);
        let Some(knee) = self.knee else {
            return format!("{name}, longest tooth {greatest}");
        };
        let end = if self.cut { ", cut at" } else { " to" };
        format!("{name}, linear to {}, then logarithmic{end} {greatest}", rounded(knee * unit, 2))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moderate_bends_are_drawn_in_proportion() {
        let scale = Scale::new([(2.0, 1.0), (3.0, 2.0), (8.0, 0.1)].into_iter(), 4.0).unwrap();
        assert_eq!([0.0, 2.0, 4.0, 8.0].map(|bend| scale.length(bend)), [0.0, 1.0, 2.0, 4.0]);
        assert_eq!(scale.words("κ", 0.5), "κ, longest tooth 4");
    }

    #[test]
    fn the_median_is_taken_by_length_and_without_straight_parts() {
        let bends = [(1e-9, 50.0), (1.0, 3.0), (2.0, 1.0), (100.0, 0.5)];
        let scale = Scale::new(bends.into_iter(), 1.0).unwrap();
        assert_eq!(scale.knee, Some(1.0));
        assert_eq!(scale.length(100.0), 1.0);
        assert!((scale.length(1.0) - libm::asinh(1.0) / libm::asinh(100.0)).abs() < 1e-15);
        assert_eq!(scale.words("κ", 1.0), "κ, linear to 1, then logarithmic to 100");
    }

    #[test]
    fn lengths_increase_and_cusps_are_cut() {
        let scale = Scale::new([(1.0, 1.0), (1e9, 1e-9)].into_iter(), 1.0).unwrap();
        let mut last = -1.0;
        for k in -60..=50 {
            let length = scale.length(libm::pow(1.2, f64::from(k)));
            assert!(length > last && length <= 1.0);
            last = length;
        }
        assert_eq!([0.0, 1e4, 1e9, f64::INFINITY].map(|bend| scale.length(bend)), [0.0, 1.0, 1.0, 1.0]);
        assert_eq!(scale.words("κ", 1.0), "κ, linear to 1, then logarithmic, cut at 10\u{2009}000");
    }

    #[test]
    fn nothing_bent_has_no_scale() {
        assert_eq!(Scale::new([(0.0, 1.0), (1e-4, 1.0)].into_iter(), 1.0), None);
        assert_eq!(Scale::new([].into_iter(), 1.0), None);
    }
}
