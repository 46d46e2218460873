//! How a picture looks, whatever it shows.

use crate::numbers::finite;
use clap::Args;
use lath_draw::figure::Figure;
use std::str::FromStr;

/// The options of every picture.
#[derive(Args, Debug)]
pub(crate) struct Look {
    /// Light on dark.
    #[arg(long)]
    dark: bool,
    /// The line above the picture (default: the title of the file, where it has one).
    #[arg(long, value_name = "TEXT")]
    title: Option<String>,
    /// Width and height in pixels, such as 1200x800 (default: 960 wide, as high as the content).
    #[arg(long, value_name = "WxH", allow_hyphen_values = true)]
    size: Option<Size>,
    /// Pixels of a PNG for each pixel of the size, from 0.1 to 16 (default 1 with --size, else 2).
    #[arg(long, value_name = "D", value_parser = density, allow_hyphen_values = true)]
    density: Option<f64>,
}

impl Look {
    /// Whether anything is asked for: where there is no picture, that is refused.
    pub(crate) fn is_given(&self) -> bool {
        self.dark || self.title.is_some() || self.size.is_some() || self.density.is_some()
    }

    /// The figure with this look; what was not asked for stays.
    pub(crate) fn apply(&self, mut figure: Figure) -> Figure {
        if self.dark {
            figure = figure.dark(true);
        }
        if let Some(title) = &self.title {
            figure = figure.title(title);
        }
        if let Some(Size(width, height)) = self.size {
            figure = figure.size(width.into(), height.into());
        }
        match self.density {
            Some(density) => figure.density(density),
            None => figure,
        }
    }
}

/// `WxH`
#[derive(Clone, Copy, Debug, PartialEq)]
struct Size(u16, u16);

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Size, String> {
        let side = |text: &str| text.trim().parse().ok().filter(|side| (16..=16_384).contains(side));
        let sides = text.split_once(['x', 'X', '×']).and_then(|(w, h)| Some(Size(side(w)?, side(h)?)));
        sides.ok_or_else(|| "a size is WxH with whole numbers from 16 to 16384, such as 1200x800".into())
    }
}

fn density(text: &str) -> Result<f64, String> {
    match finite(text)? {
        density if (0.1..=16.0).contains(&density) => Ok(density),
        _ => Err("a density is a number from 0.1 to 16".into()),
    }
}
