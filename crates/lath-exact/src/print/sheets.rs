//! The sheet of each answer.

use crate::answer::{
    At, Basis, BasisMatrix, Blending, Change, Collocation, Greville, Interpolation, Jump, Point, Refined, Refinement,
    SchemeAnswer, Spectrum, Triplets,
};
use crate::error::Result;
use crate::explain;
use crate::matrix::Matrix;
use crate::print::number::{latex, subscript, superscript, text};
use crate::print::sheet::{Name, Sheet};
use crate::print::{Answer, shapes};
use crate::rational::Rational;
use lath::error::Limits;
use lath::subdivide::{Scheme, Target};

/// `1, 2, 3`.
pub(crate) fn comma(values: &[Rational]) -> String {
    values.iter().map(text).collect::<Vec<_>>().join(", ")
}

fn rows(rows: &[Vec<Rational>]) -> Matrix {
    let columns = rows.first().map_or(0, Vec::len);
    Matrix::from_fn(rows.len(), columns, |i, j| rows[i][j].clone())
}

/// P, P′, P″, P‴, P⁽⁴⁾ …, and in LaTeX.
pub(crate) fn derived(letter: char, order: usize) -> (String, String) {
    let text = match order {
        0..=3 => format!("{letter}{}", ["", "′", "″", "‴"][order]),
        _ => format!("{letter}⁽{}⁾", superscript(order)),
    };
    let latex = if order < 4 { format!("{letter}{}", "'".repeat(order)) } else { format!("{letter}^{{({order})}}") };
    (text, latex)
}

impl Answer for BasisMatrix {
    fn sheet(&self) -> Sheet {
        let n = self.degree;
        let title = match &self.basis {
            Basis::BSpline => format!("Uniform B-splines of degree {n}"),
            Basis::Bezier => format!("Bézier curves of degree {n}"),
            Basis::Hermite => "Cubic Hermite curves".to_owned(),
            Basis::CatmullRom => "Catmull–Rom splines".to_owned(),
            Basis::Cardinal(tension) => format!("Cardinal splines of tension {}", text(tension)),
        };
        let powers: Vec<String> = (1..=n).rev().map(|k| format!("t{}", superscript(k))).chain(["1".into()]).collect();
        let powers_latex: Vec<String> = (2..=n)
            .rev()
            .map(|k| format!("t^{{{k}}}"))
            .chain((n > 0).then(|| "t".into()))
            .chain(["1".into()])
            .collect();
        let (points, points_latex): (Vec<String>, Vec<String>) = match self.basis {
            Basis::Hermite => (
                ["P₀", "P₁", "P′₀", "P′₁"].map(String::from).to_vec(),
                ["P_0", "P_1", "P'_0", "P'_1"].map(String::from).to_vec(),
            ),
            _ => (0..=n).map(|j| (format!("P{}", subscript(j)), format!("P_{{{j}}}"))).unzip(),
        };
        let (powers, points) = (powers.join(", "), points.join(", "));
        let (powers_latex, points_latex) = (powers_latex.join(", "), points_latex.join(", "));
        Sheet::new(title)
            .line(
                format!("P(t) = ({powers}) · M · ({points})ᵀ, 0 ≤ t ≤ 1"),
                format!("P(t) = ({powers_latex})\\, M\\, ({points_latex})^T, \\quad 0 \\le t \\le 1"),
            )
            .matrix(Name::new("M", "M", "M"), &self.matrix)
    }

    fn json(&self) -> String {
        shapes::basis_matrix(self).print()
    }

    fn explain(&self, limits: &Limits<'_>) -> Result<String> {
        explain::matrix(self, limits)
    }
}

impl Answer for Blending {
    fn sheet(&self) -> Sheet {
        let domain = match self.domain() {
            Some((from, to)) => format!("domain [{}, {}]", text(&from), text(&to)),
            None => "no domain".to_owned(),
        };
        Sheet::new(format!("B-splines of degree {} on the knots {}; {domain}", self.degree, comma(&self.knots)))
            .functions(&self.functions, self.degree)
    }

    fn json(&self) -> String {
        shapes::blending(self).print()
    }

    fn explain(&self, limits: &Limits<'_>) -> Result<String> {
        explain::blending(self, limits)
    }
}

impl Answer for At {
    fn sheet(&self) -> Sheet {
        let ((letter, latex_letter), t) = (derived('P', self.derivative), text(&self.t));
        let name = format!("{letter}({t})");
        let name_latex = format!("{latex_letter}\\left({}\\right)", latex(&self.t));
        let knots = self.knots.values();
        let (from, to) = (text(&knots[self.span]), text(&knots[self.span + 1]));
        let sheet = Sheet::new(format!("B-splines of degree {} at t = {t}", self.knots.degree()))
            .remark(format!("span {}, from {from} to {to}", self.span))
            .sum(Name::new(&name, &name_latex, "WEIGHTS"), 'P', self.first, &self.weights);
        match self.value() {
            Some(value) => sheet.plain_row(Name::new(name, name_latex, "VALUE"), &value),
            None => sheet,
        }
    }

    fn json(&self) -> String {
        shapes::at(self).print()
    }

    fn explain(&self, limits: &Limits<'_>) -> Result<String> {
        explain::at(self, limits)
    }
}

impl Answer for Greville {
    fn sheet(&self) -> Sheet {
        Sheet::new(format!("Greville abscissae of degree {} on the knots {}", self.degree, comma(&self.knots)))
            .plain_row(Name::new("ξ", "\\xi", "GREVILLE"), &self.abscissae)
    }

    fn json(&self) -> String {
        shapes::greville(self).print()
    }

    fn explain(&self, limits: &Limits<'_>) -> Result<String> {
        explain::greville(self, limits)
    }
}

impl Answer for Refinement {
    fn sheet(&self) -> Sheet {
        let title = match &self.kind {
            Refined::Inserted(knots) => format!("Inserting {} at degree {}", comma(knots), self.degree),
            Refined::Elevated(_) => format!("Raising the degree from {} to {}", self.degree, self.new_degree),
        };
        Sheet::new(title)
            .remark(format!("knots before: {}", comma(&self.knots)))
            .remark(format!("knots after: {}", comma(&self.new_knots)))
            .line("Q = A · P", "Q = A P")
            .matrix(Name::new("A", "A", "A"), &self.matrix)
    }

    fn json(&self) -> String {
        shapes::refinement(self).print()
    }

    fn explain(&self, limits: &Limits<'_>) -> Result<String> {
        explain::refinement(self, limits)
    }
}

impl Answer for Change {
    fn sheet(&self) -> Sheet {
        let (a, b) = (text(&self.interval.0), text(&self.interval.1));
        Sheet::new(format!("From {} to {}, degree {}, on [{a}, {b}]", self.from, self.to, self.degree))
            .line("coefficients after = C · coefficients before", "c_{\\text{after}} = C\\, c_{\\text{before}}")
            .matrix(Name::new("C", "C", "C"), &self.matrix)
    }

    fn json(&self) -> String {
        shapes::change(self).print()
    }

    fn explain(&self, limits: &Limits<'_>) -> Result<String> {
        explain::change(self, limits)
    }
}

impl Answer for Interpolation {
    fn sheet(&self) -> Sheet {
        Sheet::new(format!("Cubic spline through {} points, ends: {}", self.points.len(), self.ends))
            .remark("one row a point, one column a coordinate")
            .plain_row(Name::new("t", "t", "PARAMETERS"), &self.parameters)
            .plain_matrix(Name::new("tangents", "P'", "TANGENTS"), &rows(&self.tangents))
            .plain_row(Name::new("knots", "\\text{knots}", "KNOTS"), &self.knots)
            .plain_matrix(Name::new("control points", "P", "CONTROL_POINTS"), &rows(&self.control_points))
    }

    fn json(&self) -> String {
        shapes::interpolation(self).print()
    }

    fn explain(&self, limits: &Limits<'_>) -> Result<String> {
        explain::interpolation(self, limits)
    }
}

impl Answer for Collocation {
    fn sheet(&self) -> Sheet {
        let (p, n) = (self.degree, self.points.len());
        Sheet::new(format!("B-spline of degree {p} through {n} points, ends: {}", self.ends))
            .remark("one row a point, one column a coordinate")
            .plain_row(Name::new("t", "t", "PARAMETERS"), &self.parameters)
            .plain_row(Name::new("knots", "\\text{knots}", "KNOTS"), &self.knots)
            .plain_matrix(Name::new("control points", "P", "CONTROL_POINTS"), &rows(&self.control_points))
    }

    fn json(&self) -> String {
        shapes::collocation(self).print()
    }

    fn explain(&self, limits: &Limits<'_>) -> Result<String> {
        explain::collocation(self, limits)
    }
}

impl Answer for SchemeAnswer {
    fn sheet(&self) -> Sheet {
        let (p, spline) = (self.scheme.degree(), self.scheme.is_spline());
        let title = match spline {
            true => format!("Lane–Riesenfeld subdivision of degree {p}"),
            false => format!("Subdivision by a mask of {} numbers, which counts as degree {p}", p + 2),
        };
        let mut sheet = Sheet::new(title)
            .row(Name::new("mask", "\\text{mask}", "MASK"), self.scheme.mask())
            .matrix(Name::new("A", "A", "A"), &self.matrix)
            .matrix(Name::new("group", "G", "GROUP"), &self.group_matrix);
        match &self.spectrum {
            Spectrum::Exact(a) => {
                sheet = sheet
                    .plain_row(Name::new("eigenvalues", "\\lambda", "EIGENVALUES"), &a.eigenvalues)
                    .plain_matrix(Name::new("Q", "Q", "Q"), &a.q)
                    .matrix(Name::new("Q⁻¹", "Q^{-1}", "Q_INVERSE"), &a.q_inverse);
                if a.is_defective() {
                    sheet = sheet
                        .remark("A has too few eigenvectors for a diagonal form: A = Q J Q⁻¹ with the Jordan form")
                        .plain_matrix(Name::new("J", "J", "JORDAN"), &a.jordan);
                }
            }
            Spectrum::Numeric(estimates) => {
                let shown: Vec<String> = estimates.iter().map(|[re, im]| complex(*re, *im)).collect();
                sheet = sheet.remark(format!("eigenvalues, not all rational, about: {}", shown.join(", ")));
            }
            Spectrum::Unknown => sheet = sheet.remark("the matrix is too large for its eigenvalues to be looked for"),
        }
        let masks = [
            ("limit", "LIMIT", &self.limit),
            ("tangent", "TANGENT", &self.tangent),
            ("second", "SECOND", &self.second),
        ];
        for (name, constant, mask) in masks {
            sheet = match mask {
                Some(mask) => sheet.row(Name::new(name, format!("\\text{{{name}}}"), constant), mask),
                None if spline => sheet.remark(format!("{name}: there is none")),
                None => sheet.remark(format!("{name}: none is proven to exist")),
            };
        }
        sheet
    }

    fn json(&self) -> String {
        shapes::scheme(self).print()
    }

    fn explain(&self, limits: &Limits<'_>) -> Result<String> {
        explain::scheme(self, limits)
    }
}

fn complex(re: f64, im: f64) -> String {
    if im == 0.0 {
        format!("{re:.6}")
    } else {
        format!("{re:.6} {} {:.6}i", if im < 0.0 { "−" } else { "+" }, im.abs())
    }
}

impl Answer for Point {
    fn sheet(&self) -> Sheet {
        let (p, level, index) = (self.scheme.degree(), self.level, &self.index);
        let t = &self.parameter;
        let (title, name, name_latex) = match self.target {
            Target::Limit => (
                format!("The limit at index {index} of level {level}, degree {p}, t = {}", text(t)),
                format!("P({})", text(t)),
                format!("P\\left({}\\right)", latex(t)),
            ),
            Target::Level => (
                format!("Point {index} of level {level}, degree {p}"),
                format!("P({level}, {index})"),
                format!("P^{{{level}}}_{{{index}}}"),
            ),
        };
        Sheet::new(title).sum(Name::new(name, name_latex, "WEIGHTS"), 'P', 0, &self.weights)
    }

    fn json(&self) -> String {
        shapes::point(self).print()
    }

    fn explain(&self, limits: &Limits<'_>) -> Result<String> {
        explain::point(self, limits)
    }
}

impl Answer for Jump {
    fn sheet(&self) -> Sheet {
        let p = self.scheme.degree();
        let ((from, i), (to, j)) = (&self.from, &self.to);
        let m = self.power;
        Sheet::new(format!("From level {from} to level {to}, degree {p}"))
            .remark(format!(
                "the {p} points from index {i} of level {from} make the {p} points from index {j} of level {to}"
            ))
            .matrix(
                Name::new(
                    format!("A{}", if m == 1 { String::new() } else { superscript(m) }),
                    format!("A^{{{m}}}"),
                    "A",
                ),
                &self.matrix,
            )
    }

    fn json(&self) -> String {
        shapes::jump(self).print()
    }

    fn explain(&self, limits: &Limits<'_>) -> Result<String> {
        explain::jump(self, limits)
    }
}

impl Answer for Triplets {
    fn sheet(&self) -> Sheet {
        let k = self.level;
        let mut sheet = Sheet::new(format!("Triplets of level {k}"));
        if k == 0 {
            return sheet.remark("level 0 is given: no triplet makes it");
        }
        for d in &self.triplets {
            let (i, j) = (d.index, d.from);
            sheet = sheet.line(
                format!("P({k}; {i}, {}, {}) = A · P({}; {j}, {}, {})", i + 1, i + 2, k - 1, j + 1, j + 2),
                format!("P^{{{k}}}_{{{i},{},{}}} = A\\, P^{{{}}}_{{{j},{},{}}}", i + 1, i + 2, k - 1, j + 1, j + 2),
            );
        }
        sheet.matrix(Name::new("A", "A", "A"), &rows(&Scheme::cubic().local_matrix()))
    }

    fn json(&self) -> String {
        shapes::triplets(self).print()
    }

    fn explain(&self, limits: &Limits<'_>) -> Result<String> {
        explain::triplets(self, limits)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_have_their_marks() {
        assert_eq!(derived('P', 2), ("P″".to_owned(), "P''".to_owned()));
        assert_eq!(derived('P', 4), ("P⁽⁴⁾".to_owned(), "P^{(4)}".to_owned()));
    }
}
