//! The stable codes, each with a summary and a remedy, in one table.

use core::fmt;

macro_rules! codes {
    ($($code:ident $summary:literal $remedy:literal)*) => {
        /// A stable error code. The letter is the subject: K knots, P points, T parameters, R rational weights, C conditions,
        /// Q questions, N numerics, S subdivision, B budgets.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[non_exhaustive]
        pub enum Code {
            $(#[doc = $summary] $code,)*
        }

        impl Code {
            /// Every code, in order.
            pub const ALL: &'static [Code] = &[$(Code::$code),*];

            /// The code as text, `"K003"`.
            pub fn as_str(self) -> &'static str {
                match self { $(Code::$code => stringify!($code)),* }
            }

            /// What the code means, in a few words.
            pub fn summary(self) -> &'static str {
                match self { $(Code::$code => $summary),* }
            }

            /// What to do about it.
            pub fn remedy(self) -> &'static str {
                match self { $(Code::$code => $remedy),* }
            }
        }
    };
}

codes! {
    K001 "wrong number of knots" "A curve of n control points and degree p has n + p + 1 knots; a closed one has n + 1, one period."
    K002 "a knot is not a finite number" "Replace it by a finite number."
    K003 "a knot is repeated more than degree + 1 times" "Remove the repetitions beyond degree + 1, or raise the degree."
    K004 "the knots decrease" "Sort the knots, and check that the control points belong to the sorted order."
    K005 "the domain is empty" "The knots at positions p and n (n functions of degree p) must differ: spread the knots or lower the degree."
    K006 "the degree is out of range" "Choose a degree that the points and knots can carry."
    K007 "a knot is out of scale" "Scale the knots: their magnitude must stay below 1e300."
    P001 "too few points" "Give more points, or choose a lower degree or another end condition."
    P002 "a coordinate is not a finite number" "Remove the point or replace the coordinate by a finite number."
    P003 "a coordinate is out of scale" "Scale the input: coordinates and slopes must stay below 1e300."
    P004 "neighbouring points coincide" "Remove one of the two, or use uniform or given parameters."
    P005 "rows of different length" "Give every point the same number of coordinates."
    P006 "the dimension is not supported" "Points have 1 to 16 coordinates: choose columns, or split them."
    T001 "the parameter is not a finite number" "Replace it by a finite number inside the domain."
    T002 "the parameter lies outside the domain" "Choose a parameter inside the domain, or a policy for outside: clamp, extrapolate or periodic."
    T003 "the parameters do not increase" "Sort the rows by parameter and remove doubled ones."
    T004 "wrong number of parameters" "Give one parameter a point; a closed curve takes one more, where it closes."
    T005 "a parameter is out of scale" "Scale the parameters: their magnitude must stay below 1e300."
    R001 "a weight is not a finite number" "Replace it by a finite number."
    R002 "a weight is out of scale" "Scale the weights, which changes no curve: their magnitude must stay below 1e300."
    R003 "wrong number of weights" "Give one weight a control point."
    R004 "the weights have a pole" "The denominator, the weights' own polynomial, must stay away from zero in the whole domain: use positive weights."
    R005 "a control point is infinitely far away" "A weight of zero must come with the point zero in homogeneous form: raise the weight, or cut the curve elsewhere."
    R006 "a distance needs positive weights" "Make all weights positive; insertion, elevation and cutting take weights of any sign."
    C001 "the end condition cannot be met" "Choose another end condition, or give more points."
    C002 "this kind of curve cannot be closed" "Leave it open, or choose a kind that can be closed."
    C003 "a given derivative cannot be met" "Give each order once at a point, from 1 to one below the degree, at the index of a point that exists."
    C004 "the ends do not meet" "Move the ends together, or allow a larger tolerance."
    C005 "open and closed curves do not mix" "Open the closed ones, or close the open ones, first."
    Q001 "the tolerance is not a positive finite number" "Give a distance above 0 in the units of the points."
    Q002 "a shape parameter is not a finite number" "Give a finite number."
    Q003 "a shape parameter is out of range" "Give a number from the range that the message names."
    Q004 "wrong number of shape parameters" "Give one number for the whole curve, or one for each segment."
    Q005 "the tolerance cannot be met" "Allow a larger tolerance, or ask for a smaller change."
    Q006 "this form cannot hold the curve" "Choose a form that can: B-splines and Bézier pieces hold every polynomial curve."
    Q007 "the distance is not on the curve" "Give a distance from 0 to the length of the curve."
    N001 "the linear system is singular" "The data do not determine the curve: change the parameters or the conditions."
    S001 "the mask does not sum to 1" "The numbers of even index must sum to 1, and those of odd index too."
    S002 "the mask is not usable" "Give finite numbers, 3 to 258 for a mask; the eigen-analysis takes at most 34."
    S003 "the limit is not known" "Convergence or smoothness of this scheme is not proven: ask for the levels, or choose another scheme."
    S004 "the limit is no B-spline" "Only Lane-Riesenfeld schemes (Chaikin, cubic, any degree) tend to B-splines: sample the limit instead."
    S005 "the level is out of range" "Levels go from 0 to 1000; where none is close enough, give a greater tolerance: the points are rounded."
    S006 "the index is not one of the level" "Give decimal digits, from 0 to one less than the number of points."
    S007 "neighbours on the sphere are antipodal" "Put a point between the two: their midpoint could lie anywhere."
    S008 "not on the sphere" "Give a positive radius, and points within 1e-5 radii of the sphere."
    N002 "a condition misses its function" "Every parameter must lie inside its B-spline's support: move the knots or the parameters."
    N003 "rounding would lose the conditions" "Choose a lower degree, other end conditions, or parameters that are more even."
    B001 "the budget would be exceeded" "Ask for less, or raise the budget."
    B002 "the work was cancelled" "Start it again when wanted."
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}
