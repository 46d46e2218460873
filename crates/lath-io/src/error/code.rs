//! The codes: short names that never change their meaning, for scripts, tests and manuals.
//!
//! `F…` is a fault in what a file says, `I…` a refusal of the operating system, `W…` something that only
//! [`check`](crate::check) finds: what is valid and yet seldom meant. What the core refuses keeps the core's code.

use core::fmt;

macro_rules! codes {
    ($($code:ident $summary:literal $remedy:literal)*) => {
        /// The stable name of one kind of failure.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Code {
            /// The core refused the data; its own code says why.
            Core(lath::error::Code),
            $(#[doc = $summary] $code,)*
        }

        impl Code {
            /// The codes of this crate, in order; those of the core are in [`lath::error::Code::ALL`].
            pub const ALL: &'static [Code] = &[$(Code::$code),*];

            /// The code as it is printed, `"F005"`.
            #[must_use]
            pub fn as_str(self) -> &'static str {
                match self { Code::Core(code) => code.as_str(), $(Code::$code => stringify!($code)),* }
            }

            /// What went wrong, in a few words and without the culprit.
            #[must_use]
            pub fn summary(self) -> &'static str {
                match self { Code::Core(code) => code.summary(), $(Code::$code => $summary),* }
            }

            /// What to do about it when nothing more is known.
            #[must_use]
            pub fn remedy(self) -> &'static str {
                match self { Code::Core(code) => code.remedy(), $(Code::$code => $remedy),* }
            }
        }
    };
}

codes! {
    F001 "nothing to read" "Give at least one row of numbers."
    F002 "a NUL byte in text" "Give a text file encoded as UTF-8."
    F003 "not UTF-8" "Save the file as UTF-8."
    F004 "unknown format" "Name one of the formats."
    F005 "not a number" "Correct the field, or begin the line with # to make it a comment."
    F006 "a number in a notation that is not read" "Write it as 1234.5 or 1.2345e3."
    F007 "an empty field" "Fill in the number, or leave the row out."
    F008 "a misplaced quotation mark" "Close the quotation before the next separator."
    F009 "no such column" "Name a column of the table, or its index from 0."
    F010 "not JSON" "Correct the syntax at the place named."
    F011 "text after the JSON value" "Give one JSON value a file."
    F012 "JSON nested too deep" "Give points as [[x,y],…] and shapes as {\"lath\": 1, \"shapes\": […]}."
    F013 "a key given twice" "Keep one of the two members."
    F014 "an integer that no double holds exactly" "Write it with an exponent, as in 9.1e15, if rounding is meant."
    F015 "a missing member" "Add the member."
    F016 "an unknown member" "Remove the member, or correct its name."
    F017 "a JSON value of the wrong type" "Give a value of the type named."
    F018 "an unknown version of lath JSON" "Write \"lath\": 1."
    F019 "an unknown kind of shape" "Use one of the kinds named."
    F020 "not supported yet" "Use a kind or a member that is supported."
    F021 "points where shapes are needed, or shapes where points are" "Give a file of the other sort."
    F022 "a column name that is not unique" "Choose the column by its index from 0."
    F023 "what the format cannot hold" "Choose another format."
    F024 "another number of rows than announced" "Write as many rows as were announced."
    F025 "not an .npy file that is read here" "Save the array with numpy.save as float64."
    I001 "no such file or folder" "Check the path."
    I002 "permission denied" "Check the permissions of the file and of its folder."
    I003 "a folder, not a file" "Name a file."
    I004 "reading failed" "Check the file and the device it is on."
    I005 "writing failed" "Check the space on the device and the permissions of the folder."
    W001 "nearly equal knots" "Make them equal, if one knot is meant."
    W002 "spans of very different length" "Check the knots; evaluation stays accurate, but tools that step evenly will not."
    W003 "a knot that breaks the curve in two" "Remove one of the knots, if the curve is to hold together."
    W004 "an end that is not clamped" "Repeat the end knot degree + 1 times, if the curve is to end in its control point."
    W005 "neighbouring points coincide" "Remove one of the two, unless the halt is meant."
    W006 "all points coincide" "Give points that differ: this curve is a point."
    W007 "ends that do not meet" "Make the two points equal, if they are one."
    W008 "a closed shape that repeats its first point" "Remove the last point: a closed shape returns by itself."
    W009 "the first point is repeated at the end" "Nothing to do, if the points are closed; with --closed it is taken as the closing point."
    W010 "a derivative that vanishes at the end of a piece" "Move one of the two control points, if direction or speed matter there."
    W011 "a cusp or a halt inside a piece" "Move the control points, if the curve is to be smooth there."
    W012 "a piece without length" "Remove the piece, or the points it repeats."
    W013 "a parameter below the one before it" "Sort the rows by parameter, if they belong to it."
    W014 "a parameter given twice" "Keep one of the two rows."
    W015 "numbers far from zero for their differences" "Subtract an offset: few digits are left for the shape."
    W016 "numbers whose squares overflow" "Scale the input below 1e150."
    W017 "a list without shapes" "Give at least one shape."
    W018 "a weight that is not positive" "Make it positive, if the curve is to stay within the hull of its points."
    W019 "weights of very different size" "Check the weights; the curve stays accurate, but its parameter runs unevenly."
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_are_distinct_and_remedies_are_sentences() {
        for (i, code) in Code::ALL.iter().enumerate() {
            assert!(!code.summary().is_empty() && code.remedy().ends_with('.'), "{code}");
            assert!(Code::ALL[..i].iter().all(|other| other.as_str() != code.as_str()));
        }
        assert_eq!(Code::Core(lath::error::Code::P005).as_str(), "P005");
    }
}
