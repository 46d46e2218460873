//! `lath draw`: curves and points as a picture.

use crate::failure::{Failure, Result};
use crate::input::{Coordinates, Reading, check_standard_input};
use crate::interpolation::Interpolation;
use crate::levels::{Layer, Levels};
use crate::look::Look;
use crate::marks;
use crate::numbers::{Numbers, finite, list};
use crate::output;
use crate::sites::At;
use clap::ValueEnum;
use lath::curve::AnyCurve;
use lath::error::{Code, Error, Limits};
use lath_draw::figure::Figure;
use lath_draw::layer::{CurveLayer, Join, PointLayer};
use lath_io::format::Content;
use lath_io::number::counted;
use lath_io::points::PointTable;
use lath_io::shapes::Shape;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// Draw curves and points as SVG or PNG
///
/// Curves (lath JSON) are drawn as they are. Points are drawn as dots joined by lines; with --through, as a curve through
/// them, by the options of `lath through`. One dimension gives a graph over t, two a plane figure of equal aspect, three a
/// projection.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Args {
    /// Files of curves or points, drawn into one figure; `-` is standard input.
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// The picture, .svg or .png; `-` is standard output.
    #[arg(short, long, value_name = "FILE", required = true)]
    output: PathBuf,
    /// The format of the picture (default: by the extension of the output, svg to standard output).
    #[arg(long, value_enum)]
    format: Option<Picture>,
    /// Draw curves through the points of the files.
    #[arg(long)]
    through: bool,
    /// Draw the control polygons.
    #[arg(long)]
    polygon: bool,
    /// Mark the points where the pieces of a curve join: for a curve made by `through`, its data.
    #[arg(long)]
    points: bool,
    /// Mark the points of the curves at these parameters, and the tangents there; `breaks` for those where pieces join.
    #[arg(long, value_name = "T,…", allow_hyphen_values = true, conflicts_with = "levels")]
    at: Option<At>,
    /// Draw points without the lines between them.
    #[arg(long, conflicts_with_all = ["levels", "through"])]
    dots: bool,
    /// Write P₀, P₁, … beside the points of the files, and of control polygons.
    #[arg(long, conflicts_with = "levels")]
    names: bool,
    /// Mark the knots by strokes across the curve.
    #[arg(long)]
    knots: bool,
    /// Draw the curvature as a comb: the longer a tooth, the tighter the bend.
    #[arg(long)]
    comb: bool,
    /// Draw axes.
    #[arg(long)]
    axes: bool,
    /// From where three dimensions are seen, in degrees: azimuth from x towards y, elevation above the xy plane.
    #[arg(long, value_name = "AZ,EL", allow_hyphen_values = true)]
    view: Option<Angles>,
    #[command(flatten)]
    look: Look,
    #[command(flatten)]
    reading: Reading,
    #[command(flatten)]
    coordinates: Coordinates,
    #[command(flatten, next_help_heading = "Options with --levels")]
    levels: Levels,
    #[command(flatten, next_help_heading = "Options with --through")]
    interpolation: Interpolation,
}

const EXAMPLES: &str = "\
Examples:
  lath draw wing.dat --through --comb --axes -o wing.svg
  lath draw coast.csv --through --closed --dark -o coast.png --size 1600x1200
  lath draw nile.csv --through --params column:year --axes -o nile.svg
  lath draw steps.csv --through --kind cubic,akima,pchip --axes -o which.svg
  lath draw polygon.csv --levels 3 --scheme chaikin --closed -o corners.svg
  lath draw a.json b.json points.csv -o together.svg
  lath curve polygon.csv --kind bspline | lath draw - --polygon --knots -o spline.svg
  lath draw arch.json --polygon --names --at 0,1/2,1 -o handles.svg
  lath draw knot.json --view -60,30 -o - > knot.svg";

#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
enum Picture {
    /// Scalable, curves as true Bézier paths
    Svg,
    /// Pixels
    Png,
}

/// `az,el`
#[derive(Clone, Copy, Debug, PartialEq)]
struct Angles(f64, f64);

impl FromStr for Angles {
    type Err = String;

    fn from_str(text: &str) -> Result<Angles, String> {
        match list(text, finite)?[..] {
            [azimuth, elevation] => Ok(Angles(azimuth, elevation)),
            _ => Err("a view is two angles in degrees: azimuth,elevation".into()),
        }
    }
}

/// Writes the picture.
pub(crate) fn run(args: &Args, limits: &Limits<'_>) -> Result<()> {
    let wanted = match args.levels.are_given() {
        true => args.interpolation.is_given_beyond_closed(),
        false => args.interpolation.is_given(),
    };
    if wanted && !args.through {
        return Err(Failure::usage("the options of 'lath through' need '--through' here"));
    }
    args.interpolation.check()?;
    check_standard_input(args.files.iter().map(PathBuf::as_path))?;
    let file = output::file(Some(&args.output));
    let picture = picture(args.format, file)?;
    let mut drawing = Drawing { args, figure: Figure::new(), sources: Vec::new(), title: None };
    let names = args.interpolation.names(&args.coordinates);
    for path in &args.files {
        let (name, content) = args.reading.read_named(path, &names, limits)?;
        match content {
            Content::Points(table) => drawing.points(path, &name, table, limits)?,
            Content::Shapes(shapes) if shapes.is_empty() => return Err(Failure::no_shapes(&name)),
            Content::Shapes(shapes) => drawing.shapes(path, &name, &shapes)?,
        }
    }
    let bytes = drawing.finish(picture)?;
    output::write(file, |out| out.write_all(&bytes).map_err(|error| lath_io::Error::writing(&error)))
}

/// As asked for, else by the extension.
fn picture(asked: Option<Picture>, file: Option<&Path>) -> Result<Picture> {
    match (asked, output::extension(file).as_deref()) {
        (Some(picture), _) => Ok(picture),
        (None, Some("svg")) => Ok(Picture::Svg),
        (None, Some("png")) => Ok(Picture::Png),
        (None, None) if file.is_none() => Ok(Picture::Svg),
        _ => Err(Failure::usage("the output is no .svg and no .png: choose one with '--format'")),
    }
}

/// The figure while files are added to it.
struct Drawing<'a> {
    args: &'a Args,
    figure: Figure,
    /// The source of each layer, for messages.
    sources: Vec<String>,
    /// The title of the first file that has one.
    title: Option<String>,
}

impl Drawing<'_> {
    /// A file of points: with `--through` a curve and its points, else points and the lines between them.
    fn points(&mut self, path: &Path, source: &str, table: PointTable, limits: &Limits<'_>) -> Result<()> {
        if self.title.is_none() {
            self.title = table.title().map(str::to_owned);
        }
        let several = self.args.files.len() > 1;
        if self.args.levels.are_given() {
            let points = self.args.coordinates.of(table)?;
            self.name_axes(&points, "t");
            for layer in self.args.levels.layers(&points, self.args.interpolation.is_closed(), limits)? {
                match layer {
                    Layer::Curve(layer) => self.add_layer(source, |figure| figure.curve(layer)),
                    Layer::Points(layer) => self.add_points(source, layer),
                }
            }
            return Ok(());
        }
        if !self.args.through {
            let points = self.args.coordinates.of(table)?;
            let layer = PointLayer::new(points.width(), points.values()).map_err(|error| points.locate(error))?;
            let layer = layer.join(if self.args.dots { Join::None } else { Join::Open });
            self.name_axes(&points, "t");
            let layer = match (several, self.args.dots) {
                (false, _) => layer,
                (true, false) => layer.label(stem(path)),
                (true, true) => layer.label(format!("{} points", points.len())), // all in ink: names would not tell them apart
            };
            self.add_given(source, &points, layer);
            return Ok(());
        }
        let (made, points) = self.args.interpolation.curves(&table, &self.args.coordinates, limits)?;
        for passing in &made {
            let label = match (several, made.len()) {
                (false, _) => passing.label.clone(),
                (true, 1) => stem(path),
                (true, _) => format!("{}: {}", stem(path), passing.label),
            };
            self.add_curve(source, &passing.curve, Some(label))?;
        }
        let layer = match made.first() {
            Some(passing) if points.width() == 1 => {
                // A closed curve has one more parameter, at which it passes the first point again.
                let t = &passing.parameters;
                let values: Vec<f64> = points.values().iter().cycle().take(t.len()).copied().collect();
                PointLayer::graph(t, &values)
            }
            _ => PointLayer::new(points.width(), points.values()),
        };
        let layer = layer.map_err(|error| points.locate(error))?;
        let layer = if several { layer } else { layer.label(counted(points.len(), "point")) };
        self.name_axes(&points, self.args.interpolation.parameter_name().unwrap_or("t"));
        self.add_given(source, &points, layer);
        Ok(())
    }

    /// A file of shapes.
    fn shapes(&mut self, path: &Path, source: &str, shapes: &[Shape]) -> Result<()> {
        let several = self.args.files.len() > 1 || shapes.len() > 1;
        for (index, shape) in shapes.iter().enumerate() {
            let Some(curve) = shape.curve() else {
                continue;
            };
            let label = match shape.name() {
                Some(name) => Some(name.to_owned()),
                None if several && shapes.len() > 1 => Some(format!("{} {index}", stem(path))),
                None if several => Some(stem(path)),
                None => None,
            };
            self.add_curve(source, curve, label)?;
            if self.args.points {
                let layer = marks::dots(curve, &curve.breaks());
                self.add_points(source, layer.map_err(|error| lath_io::Error::from(error).in_source(source))?);
            }
        }
        Ok(())
    }

    /// A curve, and its points and tangents where they are asked for.
    fn add_curve(&mut self, source: &str, curve: &AnyCurve, label: Option<String>) -> Result<()> {
        let args = self.args;
        let layer = CurveLayer::new(curve).polygon(args.polygon).knots(args.knots).comb(args.comb);
        let layer = if args.names { layer.letter('P') } else { layer };
        let layer = match label {
            Some(label) => layer.label(label),
            None => layer,
        };
        self.add_layer(source, |figure| figure.curve(layer));
        if let Some(at) = &args.at {
            let at = match at {
                At::Breaks => curve.breaks(),
                At::These(Numbers(numbers)) => numbers.clone(),
            };
            let both = marks::dots(curve, &at).and_then(|dots| Ok([marks::tangents(curve, &at)?, dots]));
            for layer in both.map_err(|error| lath_io::Error::from(error).in_source(source))? {
                self.add_points(source, layer);
            }
        }
        Ok(())
    }

    /// The points of a file, with names where they are asked for.
    fn add_given(&mut self, source: &str, points: &PointTable, layer: PointLayer) {
        let count = if self.args.names { points.len() } else { 0 };
        self.add_points(source, layer.names(marks::names(count)));
    }

    fn add_points(&mut self, source: &str, layer: PointLayer) {
        self.add_layer(source, |figure| figure.points(layer));
    }

    fn add_layer(&mut self, source: &str, add: impl FnOnce(Figure) -> Figure) {
        self.figure = add(std::mem::take(&mut self.figure));
        self.sources.push(source.to_owned());
    }

    /// The axes get the names of the columns, where there is one file and it has them.
    fn name_axes(&mut self, points: &PointTable, parameter: &str) {
        if let (1, Some(names)) = (self.args.files.len(), points.columns()) {
            let parameter = (points.width() == 1).then_some(parameter);
            let names = parameter.into_iter().chain(names.iter().map(String::as_str));
            self.figure = std::mem::take(&mut self.figure).axis_names(names);
        }
    }

    fn finish(self, picture: Picture) -> Result<Vec<u8>> {
        let Drawing { args, mut figure, sources, title } = self;
        // One title for several files would be wrong for all but one.
        if let (Some(title), 1) = (title, args.files.len()) {
            figure = figure.title(title);
        }
        figure = args.look.apply(figure.axes(args.axes));
        if let Some(Angles(azimuth, elevation)) = args.view {
            figure = figure.view(azimuth, elevation);
        }
        let drawn = match picture {
            Picture::Svg => figure.to_svg().map(String::into_bytes),
            Picture::Png => figure.to_png(),
        };
        let placed = |error: Error| {
            let source = error.index().and_then(|layer| sources.get(layer));
            let mixed = error.code() == Code::P005;
            let error = source.iter().fold(lath_io::Error::from(error), |error, source| error.in_source(source));
            let remedy =
                "Draw files of different dimensions in pictures of their own, or choose columns with --columns.";
            if mixed { error.remedied(remedy) } else { error }
        };
        Ok(drawn.map_err(placed)?)
    }
}

/// What a file is called in the legend.
fn stem(path: &Path) -> String {
    match path.file_stem() {
        Some(stem) if path.as_os_str() != "-" => stem.to_string_lossy().into_owned(),
        _ => "standard input".to_owned(),
    }
}
