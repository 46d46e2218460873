//! Colours and weights: everything that is a matter of taste, in one place.
//!
//! The series colours keep their order under the common colour vision deficiencies: they differ in lightness as well as
//! in hue (after Okabe and Ito, *Color universal design*, 2008, darkened for thin lines on white and lightened for
//! black). Lines of data are the heaviest, helpers are thin and grey, the grid is barely there.

/// An opaque sRGB colour.
///
/// ```
/// use lath_draw::theme::Color;
///
/// assert_eq!(Color::new(0, 103, 176).hex(), "#0067b0");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Color {
    /// Red, 0 to 255.
    pub red: u8,
    /// Green, 0 to 255.
    pub green: u8,
    /// Blue, 0 to 255.
    pub blue: u8,
}

impl Color {
    /// The colour of these three parts, 0 to 255 each.
    pub const fn new(red: u8, green: u8, blue: u8) -> Color {
        Color { red, green, blue }
    }

    /// `#rrggbb`.
    pub fn hex(self) -> String {
        format!("#{:02x}{:02x}{:02x}", self.red, self.green, self.blue)
    }
}

/// The colours of a figure.
///
/// ```
/// use lath_draw::theme::Theme;
///
/// let theme = Theme { grid: Theme::LIGHT.paper, ..Theme::LIGHT }; // no grid
/// assert_eq!(theme.series(0), theme.series(8)); // eight colours, then again
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Theme {
    /// The background.
    pub paper: Color,
    /// Titles, data points.
    pub ink: Color,
    /// Labels, control polygons: present, not loud.
    pub muted: Color,
    /// Axis lines.
    pub axis: Color,
    /// Grid lines.
    pub grid: Color,
    /// Curves, in the order in which they are added.
    pub palette: [Color; 8],
    /// The curvature comb of a figure's only curve; with several, each comb has its curve's colour.
    pub comb: Color,
}

impl Theme {
    /// Dark on white, for paper.
    pub const LIGHT: Theme = Theme {
        paper: Color::new(255, 255, 255),
        ink: Color::new(27, 33, 44),
        muted: Color::new(96, 106, 122),
        axis: Color::new(164, 172, 184),
        grid: Color::new(235, 238, 242),
        palette: [
            Color::new(0, 95, 174),
            Color::new(208, 78, 8),
            Color::new(0, 138, 108),
            Color::new(168, 72, 142),
            Color::new(196, 138, 0),
            Color::new(58, 160, 216),
            Color::new(122, 82, 48),
            Color::new(104, 122, 30),
        ],
        comb: Color::new(208, 78, 8),
    };

    /// Light on near black, for screens.
    pub const DARK: Theme = Theme {
        paper: Color::new(19, 22, 28),
        ink: Color::new(233, 236, 241),
        muted: Color::new(150, 160, 176),
        axis: Color::new(92, 101, 117),
        grid: Color::new(36, 41, 50),
        palette: [
            Color::new(94, 178, 245),
            Color::new(245, 140, 72),
            Color::new(62, 196, 158),
            Color::new(220, 138, 192),
            Color::new(238, 190, 80),
            Color::new(150, 216, 250),
            Color::new(198, 160, 124),
            Color::new(178, 198, 96),
        ],
        comb: Color::new(245, 140, 72),
    };

    /// The colour of the series with this index; they repeat.
    pub fn series(&self, index: usize) -> Color {
        self.palette[index % self.palette.len()]
    }
}

/// Widths of lines in px.
pub(crate) mod weight {
    pub(crate) const CURVE: f64 = 2.0;
    pub(crate) const POLYLINE: f64 = 1.4;
    pub(crate) const POLYGON: f64 = 1.0;
    pub(crate) const ENVELOPE: f64 = 1.1;
    pub(crate) const TOOTH: f64 = 0.7;
    pub(crate) const KNOT: f64 = 1.1;
    pub(crate) const AXIS: f64 = 1.0;
    pub(crate) const GRID: f64 = 1.0;
}

/// Sizes of letters in px.
pub(crate) mod letter {
    pub(crate) const TITLE: f64 = 19.0;
    pub(crate) const LEGEND: f64 = 13.5;
    pub(crate) const TICK: f64 = 12.5;
}

#[cfg(test)]
mod tests {
    use super::*;

    /// WCAG relative luminance, with the gamma approximated by a square.
    fn luminance(c: Color) -> f64 {
        let part = |x: u8| f64::from(x) / 255.0 * (f64::from(x) / 255.0);
        0.2126 * part(c.red) + 0.7152 * part(c.green) + 0.0722 * part(c.blue)
    }

    #[test]
    fn lines_and_labels_stand_out_from_the_paper() {
        for theme in [Theme::LIGHT, Theme::DARK] {
            let contrast = |c: Color| {
                let (a, b) = (luminance(c) + 0.05, luminance(theme.paper) + 0.05);
                if a > b { a / b } else { b / a }
            };
            for c in theme.palette {
                assert!(contrast(c) > 2.2, "{}", c.hex());
            }
            assert!(contrast(theme.ink) > 10.0);
            assert!(contrast(theme.muted) > 4.0);
            assert!(contrast(theme.grid) < contrast(theme.axis));
        }
    }
}
