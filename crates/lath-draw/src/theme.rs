//! Colours and weights: everything that is a matter of taste, in one place.
//!
//! Any two of the eight series colours can be told apart with each of the three colour vision deficiencies: seen through
//! the model of Machado, Oliveira and Fernandes (*A physiologically-based model for simulation of color vision deficiency*,
//! 2009) they stay at least 16 apart in CIELAB, the first four 20. Lines of data are the heaviest, helpers are thin and grey,
//! the grid is barely there.

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
            Color::new(206, 54, 4),
            Color::new(16, 162, 132),
            Color::new(112, 31, 88),
            Color::new(240, 142, 16),
            Color::new(122, 160, 206),
            Color::new(116, 20, 28),
            Color::new(148, 158, 90),
        ],
        comb: Color::new(206, 54, 4),
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
            Color::new(216, 120, 20),
            Color::new(52, 236, 172),
            Color::new(232, 60, 152),
            Color::new(252, 216, 62),
            Color::new(182, 238, 230),
            Color::new(188, 214, 98),
            Color::new(80, 142, 82),
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

    /// Linear sRGB.
    fn linear(c: Color) -> [f64; 3] {
        [c.red, c.green, c.blue].map(|x| {
            let x = f64::from(x) / 255.0;
            if x <= 0.04045 { x / 12.92 } else { libm::pow((x + 0.055) / 1.055, 2.4) }
        })
    }

    fn times(matrix: &[[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
        matrix.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
    }

    /// CIELAB for the white of sRGB.
    fn lab(rgb: [f64; 3]) -> [f64; 3] {
        const XYZ: [[f64; 3]; 3] = [[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]];
        let [x, y, z] = times(&XYZ, rgb.map(|x| x.clamp(0.0, 1.0)));
        let f = |t: f64| if t > 0.008856 { libm::cbrt(t) } else { 7.787 * t + 16.0 / 116.0 };
        let [x, y, z] = [f(x / 0.9505), f(y), f(z / 1.089)];
        [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
    }

    /// WCAG relative luminance.
    fn luminance(c: Color) -> f64 {
        let [r, g, b] = linear(c);
        0.2126 * r + 0.7152 * g + 0.0722 * b
    }

    #[test]
    fn series_stay_apart_for_every_eye() {
        const ORDINARY: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        const PROTANOPIA: [[f64; 3]; 3] =
            [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]];
        const DEUTERANOPIA: [[f64; 3]; 3] =
            [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]];
        const TRITANOPIA: [[f64; 3]; 3] =
            [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]];
        for theme in [Theme::LIGHT, Theme::DARK] {
            for (eye, least, first) in
                [(ORDINARY, 30.0, 40.0), (PROTANOPIA, 16.0, 22.0), (DEUTERANOPIA, 16.0, 22.0), (TRITANOPIA, 16.0, 20.0)]
            {
                let seen = theme.palette.map(|c| lab(times(&eye, linear(c))));
                for (j, b) in seen.iter().enumerate() {
                    for a in &seen[..j] {
                        let apart = lath::space::distance(a, b);
                        assert!(apart > if j < 4 { first } else { least }, "{apart}");
                    }
                }
            }
        }
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
