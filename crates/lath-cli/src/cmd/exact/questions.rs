//! The questions and their options.

use super::fractions;
use super::paper::Paper;
use crate::failure::Result;
use crate::level_index::{LevelIndex, index, level};
use crate::look::Look;
use crate::side::Side;
use clap::{Args, Subcommand};
use lath::subdivide::Index;
use lath_exact::Rational;

#[derive(Debug, Subcommand)]
pub(crate) enum Question {
    /// The matrix of a basis, and its blending functions as a picture
    Matrix(Matrix),
    /// B-splines on any knots as polynomials, or as a picture
    Blending(Blending),
    /// A subdivision scheme: matrices, eigenvalues, eigenvectors, masks of the limit and its derivatives
    Scheme(Scheme),
    /// The weights of one point of a level
    Point(Place),
    /// The weights of the curve at t = INDEX/2^LEVEL
    Limit(Place),
    /// The power of A that leaps over levels, and where the tuple lands
    Jump(Jump),
    /// Which triplet of the level before makes each triplet
    Triplets(Triplets),
    /// The weights of the control points at a parameter
    At(At),
    /// Where the control points stand
    Greville(Greville),
    /// The matrix that inserts knots
    Insertion(Insertion),
    /// The matrix that raises the degree
    Elevation(Elevation),
    /// The matrix from one basis to another
    Change(Change),
    /// A spline through points: tangents and control points
    Interpolation(Interpolation),
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  lath exact matrix --basis bspline --degree 5\n  \
    lath exact matrix --basis hermite -o hermite.svg\n  lath exact matrix --basis cardinal:1/2 --format latex")]
pub(crate) struct Matrix {
    /// bspline, bezier, hermite, catmull-rom, or cardinal:T with a tension.
    #[arg(long)]
    pub(crate) basis: String,
    /// The degree; hermite, catmull-rom and cardinal have degree 3.
    #[arg(long, value_name = "P", value_parser = level, allow_hyphen_values = true, default_value = "3")]
    pub(crate) degree: usize,
    #[command(flatten)]
    pub(crate) paper: Paper,
    #[command(flatten, next_help_heading = "Options of a picture")]
    pub(crate) look: Look,
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  lath exact blending --degree 2 --knots 0,0,0,1,2,3,3,3\n  \
    lath exact blending --degree 3 --knots -3,-2,-1,0,1,1,1,2,3,4,5,6 -o functions.svg")]
pub(crate) struct Blending {
    #[command(flatten)]
    pub(crate) spline: Spline,
    #[command(flatten)]
    pub(crate) paper: Paper,
    #[command(flatten, next_help_heading = "Options of a picture")]
    pub(crate) look: Look,
}

/// A degree and its knots.
#[derive(Debug, Args)]
pub(crate) struct Spline {
    /// The degree.
    #[arg(long, value_name = "P", value_parser = level, allow_hyphen_values = true)]
    pub(crate) degree: usize,
    /// The knots, not decreasing.
    #[arg(long, value_name = "A,B,…", allow_hyphen_values = true)]
    knots: String,
}

impl Spline {
    /// The knots as fractions.
    pub(crate) fn knots(&self) -> Result<Vec<Rational>> {
        fractions("--knots", &self.knots)
    }
}

/// A scheme by its degree or its name.
#[derive(Debug, Args)]
#[group(required = true, multiple = false)]
pub(crate) struct Chosen {
    /// The scheme of uniform B-splines of this degree.
    #[arg(long, value_name = "P", value_parser = level, allow_hyphen_values = true)]
    pub(crate) degree: Option<usize>,
    /// chaikin, cubic, degree:P, four-point[:W], or mask:a,b,…
    #[arg(long)]
    pub(crate) scheme: Option<String>,
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  lath exact scheme --degree 3\n  lath exact scheme --scheme four-point --explain")]
pub(crate) struct Scheme {
    #[command(flatten)]
    pub(crate) scheme: Chosen,
    #[command(flatten)]
    pub(crate) paper: Paper,
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  lath exact limit --degree 3 --level 3 --index 6\n  \
    lath exact point --scheme chaikin --level 60 --index 123456789 --format json")]
pub(crate) struct Place {
    #[command(flatten)]
    pub(crate) scheme: Chosen,
    /// The level, to 1000.
    #[arg(long, value_name = "K", value_parser = level, allow_hyphen_values = true)]
    pub(crate) level: usize,
    /// The index, of any length.
    #[arg(long, value_name = "I", value_parser = index, allow_hyphen_values = true)]
    pub(crate) index: Index,
    #[command(flatten)]
    pub(crate) paper: Paper,
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  lath exact jump --degree 3 --from 1:1 --to-level 5")]
pub(crate) struct Jump {
    #[command(flatten)]
    pub(crate) scheme: Chosen,
    /// Level and index of the first of the neighbours that leap.
    #[arg(long, value_name = "LEVEL:INDEX", allow_hyphen_values = true)]
    pub(crate) from: LevelIndex,
    /// The level where they land.
    #[arg(long, value_name = "K", value_parser = level, allow_hyphen_values = true)]
    pub(crate) to_level: usize,
    #[command(flatten)]
    pub(crate) paper: Paper,
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  lath exact triplets --level 4")]
pub(crate) struct Triplets {
    /// The level.
    #[arg(long, value_name = "K", value_parser = level, allow_hyphen_values = true)]
    pub(crate) level: usize,
    #[command(flatten)]
    pub(crate) paper: Paper,
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  lath exact at --degree 2 --knots 0,0,0,1,2,3,3,3 --t 5/7\n  \
    lath exact at --degree 1 --knots 0,0,1,2,2 --t 1/2 --points \"0,0; 4,2; 8,0\"")]
pub(crate) struct At {
    #[command(flatten)]
    pub(crate) spline: Spline,
    /// The parameter.
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    pub(crate) t: String,
    /// Weights of this derivative.
    #[arg(long, value_name = "K", value_parser = level, allow_hyphen_values = true, default_value = "0")]
    pub(crate) derivative: usize,
    /// From which side of a knot.
    #[arg(long, value_enum, default_value = "right")]
    pub(crate) side: Side,
    /// Control points, such as "0,0; 4,2; 8,0": the answer then has the point too.
    #[arg(long, value_name = "X,Y; …", allow_hyphen_values = true)]
    pub(crate) points: Option<String>,
    #[command(flatten)]
    pub(crate) paper: Paper,
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  lath exact greville --degree 3 --knots 0,0,0,0,1,2,2,2,2")]
pub(crate) struct Greville {
    #[command(flatten)]
    pub(crate) spline: Spline,
    #[command(flatten)]
    pub(crate) paper: Paper,
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  lath exact insertion --degree 2 --knots 0,0,0,1,2,2,2 --insert 1/2")]
pub(crate) struct Insertion {
    #[command(flatten)]
    pub(crate) spline: Spline,
    /// The knots to insert.
    #[arg(long, value_name = "A,B,…", allow_hyphen_values = true)]
    pub(crate) insert: String,
    #[command(flatten)]
    pub(crate) paper: Paper,
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  lath exact elevation --degree 2\n  \
    lath exact elevation --degree 2 --knots 0,0,0,1,2,2,2 --by 2")]
pub(crate) struct Elevation {
    /// The degree before.
    #[arg(long, value_name = "P", value_parser = level, allow_hyphen_values = true)]
    pub(crate) degree: usize,
    /// The knots, not decreasing (default: a Bézier curve).
    #[arg(long, value_name = "A,B,…", allow_hyphen_values = true)]
    pub(crate) knots: Option<String>,
    /// By how much the degree is raised.
    #[arg(long, value_name = "N", value_parser = level, allow_hyphen_values = true, default_value = "1")]
    pub(crate) by: usize,
    #[command(flatten)]
    pub(crate) paper: Paper,
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  lath exact change --from bspline --to bernstein --degree 3\n  \
    lath exact change --from hermite --to power --interval 1,3")]
pub(crate) struct Change {
    /// bernstein, power (of t − a), hermite, bspline (over uniform knots), or bspline:KNOTS.
    #[arg(long, value_name = "BASIS")]
    pub(crate) from: String,
    /// The other basis, in the same words.
    #[arg(long, value_name = "BASIS")]
    pub(crate) to: String,
    /// The degree (default 3).
    #[arg(long, value_name = "P", value_parser = level, allow_hyphen_values = true)]
    pub(crate) degree: Option<usize>,
    /// The interval.
    #[arg(long, value_name = "A,B", allow_hyphen_values = true, default_value = "0,1")]
    pub(crate) interval: String,
    #[command(flatten)]
    pub(crate) paper: Paper,
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  lath exact interpolation --points \"0,0; 1,2; 3,1\" --ends natural\n  \
    lath exact interpolation --points \"0; 1; 0; 2\" --start clamped:1/2 --explain\n  \
    lath exact interpolation --points \"1,0; 0,1; -1,0; 0,-1\" --closed\n  \
    lath exact interpolation --points \"0; 1; 0; 2; 1\" --degree 4")]
pub(crate) struct Interpolation {
    /// The points, such as "0,0; 1,2; 3,1".
    #[arg(long, value_name = "X,Y; …", allow_hyphen_values = true)]
    pub(crate) points: String,
    /// A B-spline of this degree, whose ends are natural, not-a-knot or closed (default: a cubic spline with any ends).
    #[arg(long, value_name = "P", value_parser = level, allow_hyphen_values = true)]
    pub(crate) degree: Option<usize>,
    /// The parameters (default 0, 1, 2, …); one more than points if closed.
    #[arg(long, value_name = "A,B,…", allow_hyphen_values = true)]
    pub(crate) params: Option<String>,
    /// natural, not-a-knot, clamped:X,Y,… or second:X,Y,… (default not-a-knot).
    #[arg(long, value_name = "COND", conflicts_with_all = ["ends", "closed"])]
    pub(crate) start: Option<String>,
    /// The condition at the end, in the same words.
    #[arg(long, value_name = "COND", conflicts_with_all = ["ends", "closed"])]
    pub(crate) end: Option<String>,
    /// One condition for both ends; also cyclic or anticyclic.
    #[arg(long, value_name = "COND", conflicts_with = "closed")]
    pub(crate) ends: Option<String>,
    /// The curve returns to its first point.
    #[arg(long)]
    pub(crate) closed: bool,
    #[command(flatten)]
    pub(crate) paper: Paper,
}
