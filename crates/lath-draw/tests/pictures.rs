//! Whole figures: what is drawn is the curve, whatever the size, the scale or the degeneracy.
#![allow(clippy::expect_used, clippy::unwrap_used)] // also outside the test functions

use lath::curve::{BSpline, Bezier, Curve, Hermite, Interval, Polyline};
use lath::error::Code;
use lath::knot::{Knots, Side};
use lath_draw::figure::Figure;
use lath_draw::layer::{CurveLayer, Join, PointLayer};
use lath_draw::path::{Path, Point, Segment};
use lath_draw::scene::{Item, Scene};
use lath_draw::theme::{Color, Theme};

const RED: Color = Color::new(255, 0, 1);

/// The path that was drawn in our red.
fn red(scene: &Scene) -> &Path {
    let mut paths = scene.items.iter().filter_map(|item| match item {
        Item::Line { path, stroke } if stroke.color == RED => Some(path),
        _ => None,
    });
    paths.next_back().expect("a red curve")
}

fn curve<const D: usize>(curve: impl Curve<D>) -> CurveLayer {
    CurveLayer::of(curve).unwrap().color(RED)
}

/// All points of a path's commands.
fn points(path: &Path) -> Vec<Point> {
    let mut all = Vec::new();
    for segment in path.segments() {
        match *segment {
            Segment::Move(p) | Segment::Line(p) => all.push(p),
            Segment::Quad(a, p) => all.extend([a, p]),
            Segment::Cubic(a, b, p) => all.extend([a, b, p]),
            Segment::Close => {}
        }
    }
    all
}

fn close(a: Point, b: Point) -> bool {
    lath::space::distance(&a, &b) < 1e-9
}

#[test]
fn a_plane_cubic_is_one_command_and_a_similarity_of_its_points() {
    let control = [[0.0, 0.0], [0.0, 3.0], [4.0, 3.0], [4.0, -1.0]];
    let scene = Figure::new().curve(curve(Bezier::new(control).unwrap())).scene().unwrap();
    let path = red(&scene);
    assert!(matches!(path.segments(), [Segment::Move(_), Segment::Cubic(..)]));
    let px = points(path);
    let scale = (px[3][0] - px[0][0]) / 4.0;
    for (p, b) in px.iter().zip(control) {
        assert!(close(*p, [px[0][0] + scale * b[0], px[0][1] - scale * b[1]]), "{px:?}");
    }
}

#[test]
fn a_graph_has_its_control_points_at_even_abscissae() {
    let domain = Interval { start: 2.0, end: 5.0 };
    for (n, degree) in [(2, 1), (3, 2), (4, 3)] {
        let values = [[1.0], [4.0], [-2.0], [0.5]];
        let bezier = Bezier::on(values[..n].iter(), domain).unwrap();
        let scene = Figure::new().curve(curve(bezier)).axes(true).scene().unwrap();
        let px = points(red(&scene));
        assert_eq!(px.len(), n);
        let step = (px[degree][0] - px[0][0]) / degree as f64;
        for (i, p) in px.iter().enumerate() {
            assert!((p[0] - px[0][0] - step * i as f64).abs() < 1e-9);
            let rise = (values[i][0] - values[0][0]) * (px[1][1] - px[0][1]) / (values[1][0] - values[0][0]);
            assert!((p[1] - px[0][1] - rise).abs() < 1e-9);
        }
    }
}

#[test]
fn splines_are_drawn_piece_by_piece_and_closed_ones_are_closed() {
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let scene = Figure::new().curve(curve(BSpline::closed_uniform(3, square).unwrap())).scene().unwrap();
    let segments = red(&scene).segments();
    assert!(matches!(segments[0], Segment::Move(_)) && segments[5] == Segment::Close && segments.len() == 6);
    assert!(segments[1..5].iter().all(|segment| matches!(segment, Segment::Cubic(..))));

    let scene = Figure::new().curve(curve(Polyline::new(square).unwrap())).scene().unwrap();
    assert!(red(&scene).segments()[1..].iter().all(|segment| matches!(segment, Segment::Line(_))));

    let scene = Figure::new().curve(curve(BSpline::uniform(2, square).unwrap())).scene().unwrap();
    assert!(red(&scene).segments()[1..].iter().all(|segment| matches!(segment, Segment::Quad(..))));
}

#[test]
fn a_jump_is_a_gap() {
    // Two cubics that do not meet: a knot of multiplicity 4.
    let knots = Knots::new(vec![0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 2.0], 3).unwrap();
    let values = [[0.0], [1.0], [0.0], [1.0], [5.0], [4.0], [5.0], [4.0]];
    let scene = Figure::new().curve(curve(BSpline::new(knots, values).unwrap()).comb(true)).scene().unwrap();
    assert_eq!(red(&scene).segments().iter().filter(|segment| matches!(segment, Segment::Move(_))).count(), 2);
    // Degree 0 over a graph: steps; in the plane: dots.
    let knots = |n: i32| Knots::new((0..=n).map(f64::from).collect(), 0).unwrap();
    let steps = BSpline::new(knots(3), [[1.0], [3.0], [2.0]]).unwrap();
    let scene = Figure::new().curve(curve(steps)).scene().unwrap();
    let px = points(red(&scene));
    assert_eq!(px.len(), 6);
    assert!(px.chunks(2).all(|step| step[0][1] == step[1][1] && step[0][0] < step[1][0]));
    let dots = BSpline::new(knots(2), [[1.0, 1.0], [3.0, 2.0]]).unwrap();
    assert!(Figure::new().curve(curve(dots)).to_png().is_ok());
}

/// A circle of radius 2 around (1e7, −3), which offers no Bézier pieces.
#[derive(Debug)]
struct Circle;

impl Curve<2> for Circle {
    fn kind(&self) -> &'static str {
        "circle"
    }
    fn degree(&self) -> usize {
        2
    }
    fn domain(&self) -> Interval {
        Interval { start: 0.0, end: std::f64::consts::TAU }
    }
    fn jet_into(&self, t: f64, _side: Side, out: &mut [[f64; 2]]) {
        let (s, c) = (2.0 * libm::sin(t), 2.0 * libm::cos(t));
        for (k, row) in out.iter_mut().enumerate() {
            *row = [[1e7 + c, -3.0 + s], [-s, c], [-c, -s], [s, -c]][if k == 0 { 0 } else { (k - 1) % 3 + 1 }];
        }
    }
}

#[test]
fn what_is_not_polynomial_is_followed_within_a_fiftieth_of_a_px() {
    let scene = Figure::new().size(800.0, 800.0).curve(curve(Circle).comb(true)).scene().unwrap();
    let px = points(red(&scene));
    let (mut lo, mut hi) = ([f64::MAX; 2], [f64::MIN; 2]);
    for p in px.iter().step_by(3) {
        for c in 0..2 {
            lo[c] = if p[c] < lo[c] { p[c] } else { lo[c] };
            hi[c] = if p[c] > hi[c] { p[c] } else { hi[c] };
        }
    }
    let (centre, radius) = ([(lo[0] + hi[0]) / 2.0, (lo[1] + hi[1]) / 2.0], (hi[0] - lo[0]) / 2.0);
    assert!(radius > 200.0);
    for b in px.windows(4).step_by(3) {
        for k in 0..=8 {
            let (u, v) = (f64::from(k) / 8.0, 1.0 - f64::from(k) / 8.0);
            let p: Point = std::array::from_fn(|c| {
                v * v * v * b[0][c] + 3.0 * u * v * v * b[1][c] + 3.0 * u * u * v * b[2][c] + u * u * u * b[3][c]
            });
            assert!((lath::space::distance(&p, &centre) - radius).abs() < 0.02);
        }
    }
}

#[test]
fn curves_over_one_polygon_have_it_drawn_once() {
    let square = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]];
    let quadratic = BSpline::new(Knots::clamped(4, 2).unwrap(), square).unwrap();
    let first = curve(Bezier::new(square).unwrap()).polygon(true).letter('P');
    let second = curve(quadratic).polygon(true).letter('P');
    let items = |figure: Figure| figure.scene().unwrap().items.len();
    let (one, two) = (items(Figure::new().curve(first.clone())), items(Figure::new().curve(first).curve(second)));
    assert_eq!(two, one + 1, "one curve more, and nothing else");
}

#[test]
fn degenerate_content_gives_pictures() {
    let rows = [3.0, 4.0, 1e7, 3.0, 4.0, 1e7, 3.0, 4.0, 1e7 + 1e-3];
    for dimension in 1..=3 {
        for count in 0..=3 {
            let rows: Vec<f64> = rows.chunks(3).take(count).flat_map(|row| row[..dimension].to_vec()).collect();
            for join in [Join::None, Join::Open, Join::Closed, Join::Pairs] {
                for size in [None, Some([16.0, 16.0]), Some([2000.0, 20.0]), Some([300.0, 200.0])] {
                    let layer = PointLayer::new(dimension, &rows).unwrap().join(join).label("points");
                    let mut figure =
                        Figure::new().points(layer).axes(true).title("A title").axis_names(["a", "b", "c"]);
                    if let Some([w, h]) = size {
                        figure = figure.size(w, h).density(0.5);
                    }
                    assert!(figure.to_svg().unwrap().starts_with("<svg"));
                    assert!(figure.to_png().unwrap().starts_with(b"\x89PNG"));
                }
            }
        }
    }
    assert!(Figure::new().to_png().is_ok());
    let still = Hermite::new(vec![0.0, 1.0], [[5.0, 5.0]; 2], [[0.0, 0.0]; 2]).unwrap();
    let layer = curve(still).comb(true).knots(true).polygon(true);
    assert!(Figure::new().curve(layer).axes(true).to_png().is_ok());
}

#[test]
fn every_scale_looks_the_same() {
    let picture = |scale: f64| {
        let spiral = [[0.0, 0.0], [3.0, 0.5], [2.0, 3.0], [-1.0, 2.0], [0.5, -1.0]];
        let bezier = Bezier::new(spiral.map(|[x, y]| [x * scale, y * scale])).unwrap();
        let figure = Figure::new().curve(curve(bezier).comb(true).knots(true).polygon(true));
        let bytes = figure.clone().axes(true).to_png().unwrap();
        assert!(!bytes.is_empty());
        points(red(&figure.scene().unwrap()))
    };
    let one = picture(1.0);
    for scale in [1e-300, 1e-150, 1e-9, 1e9, 1e150, 1e299] {
        let other = picture(scale);
        assert_eq!(one.len(), other.len(), "{scale:e}");
        assert!(one.iter().zip(&other).all(|(a, b)| lath::space::distance(a, b) < 1e-6), "{scale:e}");
    }
}

#[test]
fn nothing_is_drawn_outside_the_picture() {
    let wild = [[0.0, 0.0], [10.0, 9.0], [-8.0, 9.0], [3.0, -7.0], [1.0, 1.0]];
    let layer = curve(BSpline::clamped(3, wild).unwrap()).comb(true).knots(true).polygon(true).label("wild");
    for dark in [false, true] {
        let scene = Figure::new().dark(dark).curve(layer.clone()).axes(true).title("Wild").scene().unwrap();
        for item in &scene.items {
            let all = match item {
                Item::Fill { path, .. } | Item::Line { path, .. } => points(path),
                Item::Marks { centers, .. } => centers.clone(),
            };
            let inside = |p: &Point| p[0] > 4.0 && p[0] < scene.width - 4.0 && p[1] > 4.0 && p[1] < scene.height - 4.0;
            // Control points of letters and curves may stick out of their outline a little, but not out of the picture.
            assert!(all.iter().all(inside), "{item:?}");
        }
    }
}

#[test]
fn layers_of_different_kind_are_refused() {
    let figure = Figure::new()
        .points(PointLayer::new(2, &[0.0, 0.0]).unwrap())
        .points(PointLayer::new(3, &[0.0, 0.0, 0.0]).unwrap());
    let error = figure.to_svg().unwrap_err();
    assert_eq!((error.code(), error.index()), (Code::P005, Some(1)));
    let figure = Figure::new().points(PointLayer::new(3, &[0.0, 0.0, 0.0]).unwrap()).view(f64::NAN, 0.0);
    assert_eq!(figure.to_svg().unwrap_err().code(), Code::T001);
    let huge = Figure::new().size(16_000.0, 16_000.0);
    assert!(huge.to_svg().is_ok() && huge.to_png().unwrap_err().is_budget());
}

#[test]
fn the_same_figure_is_the_same_bytes() {
    let figure = || {
        let arch = Bezier::new([[0.0, 0.0, 0.0], [1.0, 2.0, 1.0], [2.0, 0.0, 3.0]]).unwrap();
        Figure::new().curve(CurveLayer::of(arch).unwrap().label("arch").comb(true)).axes(true).view(30.0, 20.0)
    };
    assert_eq!(figure().to_svg().unwrap(), figure().to_svg().unwrap());
    assert_eq!(figure().to_png().unwrap(), figure().to_png().unwrap());
}

#[test]
fn colours_go_round_by_series() {
    let line = |y: f64| PointLayer::new(2, &[0.0, y, 1.0, y]).unwrap().join(Join::Open);
    let scene = Figure::new().points(line(0.0)).points(line(1.0)).scene().unwrap();
    let lines: Vec<Color> = scene
        .items
        .iter()
        .filter_map(|item| match item {
            Item::Line { stroke, .. } => Some(stroke.color),
            _ => None,
        })
        .collect();
    assert_eq!(lines, [Theme::LIGHT.series(0), Theme::LIGHT.series(1)]);
}

#[test]
fn numbers_that_overflow_on_the_way_do_no_harm() {
    // The interval times the tangent is beyond the range of numbers.
    let wild = Hermite::new(vec![-9e299, 0.0, 9e299], [[1.0], [2.0], [3.0]], [[1e200], [-1e250], [1.0]]).unwrap();
    let layer = curve(wild).comb(true).knots(true).polygon(true);
    let svg = Figure::new().curve(layer).axes(true).to_svg().unwrap();
    assert!(!svg.contains("NaN") && !svg.contains("inf") && !svg.contains("1000000000"));
}
