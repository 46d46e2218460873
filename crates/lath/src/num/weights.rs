//! The barycentric weights of a float, each off by hardly more than its own last rounding.
//!
//! (t − a)/(b − a) rounds three times. When t and the knots are near each other all differences are exact, and one
//! rounding is left. Where they are not, what the differences lost and what the division left over are found without
//! error, and the quotient is corrected once.
//!
//! *Source.* T. J. Dekker, A floating-point technique for extending the available precision (1971), for the exact product
//! of halves; D. Knuth, The Art of Computer Programming 2 (1969), 4.2.2, for the exact error of a sum.

/// (b − t)/(b − a) and (t − a)/(b − a).
#[inline]
pub(super) fn weights(a: f64, b: f64, t: f64) -> (f64, f64) {
    let (length, left, right) = (b - a, t - a, b - t);
    // Numbers within a factor of two of each other have exact differences (P. Sterbenz 1974).
    let near = a > 0.0 && b <= a + a || b < 0.0 && a >= b + b;
    if near || exact((a, b, t), (length, left, right)) {
        (right / length, left / length)
    } else {
        corrected((a, b, t), (length, left, right))
    }
}

/// Whether nothing was rounded: a rounded difference fails to give back one of its two numbers.
fn exact((a, b, t): (f64, f64, f64), (length, left, right): (f64, f64, f64)) -> bool {
    left + a == t && t - left == a && right + t == b && b - right == t && length + a == b && b - length == a
}

/// The same where a difference was rounded.
#[cold]
fn corrected((a, b, t): (f64, f64, f64), (length, left, right): (f64, f64, f64)) -> (f64, f64) {
    let lost = lost(b, a, length);
    (quotient(right, self::lost(b, t, right), length, lost), quotient(left, self::lost(t, a, left), length, lost))
}

/// x − y − d exactly, for d = x − y rounded.
fn lost(x: f64, y: f64, d: f64) -> f64 {
    let taken = x - d;
    let kept = d + taken;
    (taken - y) + (x - kept)
}

/// (x + dx)/(y + dy), where dx and dy are below the last digits of x and y.
fn quotient(x: f64, dx: f64, y: f64, dy: f64) -> f64 {
    let q = x / y;
    // x − qy: products of halves are exact, and the largest comes off first.
    let ((q1, q2), (y1, y2)) = (halves(q), halves(y));
    let rest = x - q1 * y1 - q1 * y2 - q2 * y1 - q2 * y2;
    let corrected = q + (rest + dx - q * dy) / y;
    // Infinities and their differences have no digits to correct.
    if corrected.is_finite() { corrected } else { q }
}

/// The upper 26 digits and the lower 27.
fn halves(x: f64) -> (f64, f64) {
    let upper = f64::from_bits(x.to_bits() & !((1 << 27) - 1));
    (upper, x - upper)
}
