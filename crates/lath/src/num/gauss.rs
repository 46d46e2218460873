//! Gauss–Legendre quadrature, with a bound for functions that are analytic around the interval.

/// A rule on [−1, 1] with an even number of nodes: the positive ones, each with its weight, the weights of ±x being equal.
///
/// *Source.* C. F. Gauss 1814; nodes and weights are the nearest floats of the roots of Legendre's polynomials.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gauss {
    pairs: &'static [(f64, f64)],
}

/// The rules of 4, 8, 16 and 32 nodes.
pub(crate) const RULES: [Gauss; 4] =
    [Gauss { pairs: &G4 }, Gauss { pairs: &G8 }, Gauss { pairs: &G16 }, Gauss { pairs: &G32 }];

impl Gauss {
    /// The sum that stands for ∫ f over [a, b]; exact, up to rounding, for polynomials of degree 2n − 1.
    pub(crate) fn integrate(self, a: f64, b: f64, f: impl Fn(f64) -> f64) -> f64 {
        let (middle, half) = (0.5 * a + 0.5 * b, 0.5 * b - 0.5 * a);
        let mut sum = 0.0;
        // The outer nodes have the smallest weights.
        for (x, weight) in self.pairs.iter().rev() {
            sum += weight * (f(middle - half * x) + f(middle + half * x));
        }
        sum * half
    }
}

/// What the rules of 4, 8, 16 and 32 nodes miss at most on [−1, 1], per unit of M, for a function that is analytic inside the
/// ellipse with the foci ±1 and the half-axes (ρ ± 1/ρ)/2, and there at most M in magnitude.
///
/// *Proof.* The function is Σ c_k T_k with |c_k| ≤ 2Mρ⁻ᵏ. A rule of n nodes integrates T_k exactly below k = 2n, and for odd k; the others have the
/// integral 2/(1 − k²), at most 2/15 in magnitude, and the rule's value is at most 2: (4 + 4/15) M Σ ρ⁻ᵏ over k = 2n, 2n + 2, …
///
/// *Source.* L. N. Trefethen, Is Gauss quadrature better than Clenshaw–Curtis? (2008), theorem 4.5.
pub(crate) fn shares_missed(rho: f64) -> [f64; 4] {
    let inverse = 1.0 / rho;
    let square = inverse * inverse;
    let front = 64.0 / 15.0 / (1.0 - square);
    // ρ⁻⁸, and each power is the square of the one before.
    let mut power = (square * square) * (square * square);
    core::array::from_fn(|_| {
        let missed = front * power;
        power *= power;
        missed
    })
}

const G4: [(f64, f64); 2] = [(0.33998104358485626, 0.6521451548625461), (0.8611363115940526, 0.34785484513745385)];

const G8: [(f64, f64); 4] = [
    (0.1834346424956498, 0.362683783378362),
    (0.525532409916329, 0.31370664587788727),
    (0.7966664774136267, 0.22238103445337448),
    (0.9602898564975363, 0.10122853629037626),
];

const G16: [(f64, f64); 8] = [
    (0.09501250983763744, 0.1894506104550685),
    (0.2816035507792589, 0.18260341504492358),
    (0.45801677765722737, 0.16915651939500254),
    (0.6178762444026438, 0.14959598881657674),
    (0.755404408355003, 0.12462897125553388),
    (0.8656312023878318, 0.09515851168249279),
    (0.9445750230732326, 0.062253523938647894),
    (0.9894009349916499, 0.027152459411754096),
];

const G32: [(f64, f64); 16] = [
    (0.04830766568773832, 0.0965400885147278),
    (0.1444719615827965, 0.09563872007927486),
    (0.23928736225213706, 0.09384439908080457),
    (0.33186860228212767, 0.09117387869576389),
    (0.42135127613063533, 0.08765209300440381),
    (0.5068999089322294, 0.08331192422694675),
    (0.5877157572407623, 0.07819389578707031),
    (0.6630442669302152, 0.0723457941088485),
    (0.7321821187402897, 0.06582222277636185),
    (0.7944837959679424, 0.058684093478535544),
    (0.84936761373257, 0.050998059262376175),
    (0.8963211557660521, 0.04283589802222668),
    (0.9349060759377397, 0.03427386291302143),
    (0.9647622555875064, 0.02539206530926206),
    (0.9856115115452684, 0.01627439473090567),
    (0.9972638618494816, 0.007018610009470096),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_are_exact_up_to_twice_the_nodes() {
        for rule in RULES {
            let nodes = 2 * rule.pairs.len();
            for degree in 0..2 * nodes {
                let power = |x: f64| (0..degree).fold(1.0, |product, _| product * x);
                let exact = if degree % 2 == 0 { 2.0 / (degree as f64 + 1.0) } else { 0.0 };
                let found = rule.integrate(-1.0, 1.0, power);
                assert!((found - exact).abs() < 1e-15, "{nodes} nodes, x^{degree}: {found}");
                // ∫ from 1 to 3 of (x − 2)^k is the same.
                let found = rule.integrate(1.0, 3.0, |x| power(x - 2.0));
                assert!((found - exact).abs() < 1e-14, "{nodes} nodes, shifted x^{degree}: {found}");
            }
            // The first power that is missed is missed: fewer nodes than claimed would show earlier, more not at all.
            let power = |x: f64| (0..2 * nodes).fold(1.0, |product, _| product * x);
            let missed = (rule.integrate(-1.0, 1.0, power) - 2.0 / (2.0 * nodes as f64 + 1.0)).abs();
            assert!(missed > 0.0, "{nodes}");
        }
    }

    #[test]
    fn the_bound_holds_beside_a_pole() {
        // 1/(a − x): the integral is ln((a + 1)/(a − 1)), the pole at a = (ρ₀ + 1/ρ₀)/2.
        for pole in [1.25, 2.0, 5.0] {
            let exact = libm::log((pole + 1.0) / (pole - 1.0));
            for rho in [1.5, 1.9, 3.0, 9.0] {
                let reach = (rho + 1.0 / rho) / 2.0;
                if reach >= pole {
                    continue;
                }
                for (rule, missed) in RULES.iter().zip(shares_missed(rho)) {
                    let error = (rule.integrate(-1.0, 1.0, |x| 1.0 / (pole - x)) - exact).abs();
                    assert!(error <= missed / (pole - reach) + 1e-15, "{pole} {rho}: {error}");
                }
            }
        }
    }
}
