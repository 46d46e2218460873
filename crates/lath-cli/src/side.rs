//! From which side a break is reached.

use clap::ValueEnum;

/// What `--side` takes.
#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
pub(crate) enum Side {
    /// What the piece before says
    Left,
    /// What the piece behind says
    Right,
}

impl From<Side> for lath::knot::Side {
    fn from(side: Side) -> lath::knot::Side {
        match side {
            Side::Left => lath::knot::Side::Left,
            Side::Right => lath::knot::Side::Right,
        }
    }
}
