//! The steps of `refine`, in the order in which they stand on the command line.

use crate::failure::{Failure, Result};
use crate::numbers::{self, Numbers};
use clap::{Arg, ArgAction, ArgMatches, Command};

/// One change of a curve's description.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Step {
    Insert(Vec<f64>),
    Halve(usize),
    Remove(f64),
    Elevate(usize),
    Reduce(usize, Option<f64>),
    Split(f64),
    Trim(f64, f64),
    Join(f64),
    Clamp,
    Close(f64),
    Seam(f64),
    Reverse,
    Domain(f64, f64),
    Derivative,
    Antiderivative,
}

/// The options that are steps, and the tolerance of `--reduce`.
#[derive(Clone, Debug, Default)]
pub(crate) struct Steps {
    steps: Vec<Step>,
    tolerance: Option<f64>,
}

/// An option's name, the name of its value where it has one, and its help.
const OPTIONS: [(&str, &str, &str); 15] = [
    ("insert", "T,…", "Insert knots; one that is there gets a higher multiplicity, up to degree + 1"),
    ("halve", "K", "Insert the middle of every span, K times"),
    ("remove", "TOLERANCE", "Remove as many knots as the curve stays this near without"),
    ("elevate", "N", "Raise the degree by N"),
    ("reduce", "N", "Lower the degree by N; see --tolerance"),
    ("split", "T", "Split at T: two curves"),
    ("trim", "A,B", "Keep the part from A to B"),
    (
        "join",
        "TOLERANCE",
        "Join all curves of the file, each end to the next start, as smoothly as the tolerance allows",
    ),
    ("clamp", "", "Open a closed curve at its seam; start and end in the first and last control point"),
    ("close", "TOLERANCE", "Close a curve whose ends meet, as smoothly as the tolerance allows"),
    ("seam", "T", "Let a closed curve start at T"),
    ("reverse", "", "Run from the end to the start, over the same domain"),
    ("domain", "A,B", "Change the parameter linearly, so that the domain is from A to B"),
    ("derivative", "", "The derivative, as a curve"),
    ("antiderivative", "", "The antiderivative that starts at zero, as a curve"),
];

impl Steps {
    /// The steps.
    ///
    /// # Errors
    /// Usage: no step at all, or a tolerance that nothing asks for.
    pub(crate) fn checked(&self) -> Result<Vec<Step>> {
        if self.steps.is_empty() {
            return Err(Failure::usage("no step is given, such as '--insert 1/2' or '--elevate 1'"));
        }
        if self.tolerance.is_some() && !self.steps.iter().any(|step| matches!(step, Step::Reduce(..))) {
            return Err(Failure::usage("'--tolerance' belongs to '--reduce'"));
        }
        let with_tolerance = |step: &Step| match step {
            Step::Reduce(by, _) => Step::Reduce(*by, self.tolerance),
            step => step.clone(),
        };
        Ok(self.steps.iter().map(with_tolerance).collect())
    }
}

/// Two numbers with a comma between them.
fn pair(text: &str) -> Result<Numbers, String> {
    let numbers: Numbers = text.parse()?;
    if numbers.0.len() == 2 { Ok(numbers) } else { Err("two numbers are needed, such as 0,1".into()) }
}

/// A small whole number.
fn small(text: &str) -> Result<u64, String> {
    numbers::positive_count(text)
}

impl clap::Args for Steps {
    fn augment_args(command: Command) -> Command {
        let mut command = command.next_help_heading("Steps, in the order given");
        for (name, value, help) in OPTIONS {
            let arg = Arg::new(name).long(name).help(help);
            command = command.arg(match (name, value) {
                (_, "") => arg.action(ArgAction::Append).num_args(0).default_missing_value("").value_parser([""]),
                _ => {
                    let arg = arg.action(ArgAction::Append).value_name(value).allow_hyphen_values(true);
                    match name {
                        "insert" => arg.value_parser(|text: &str| text.parse::<Numbers>()),
                        "trim" | "domain" => arg.value_parser(pair),
                        "halve" | "elevate" | "reduce" => arg.value_parser(small),
                        "split" | "seam" => arg.value_parser(numbers::finite),
                        _ => arg.value_parser(numbers::positive),
                    }
                }
            });
        }
        let tolerance = Arg::new("tolerance").long("tolerance").value_name("T").value_parser(numbers::positive);
        let tolerance = tolerance.allow_hyphen_values(true);
        command.arg(tolerance.help("Refuse to lower a degree if that moves points farther")).next_help_heading(None)
    }

    fn augment_args_for_update(command: Command) -> Command {
        Steps::augment_args(command)
    }
}

impl clap::FromArgMatches for Steps {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Steps, clap::Error> {
        let mut found: Vec<(usize, Step)> = Vec::new();
        for (name, value, _) in OPTIONS {
            let places: Vec<usize> = matches.indices_of(name).into_iter().flatten().collect();
            let steps: Vec<Step> = match (name, value) {
                ("insert" | "trim" | "domain", _) => {
                    let make = |Numbers(list): &Numbers| match (name, list.as_slice()) {
                        ("trim", [a, b]) => Step::Trim(*a, *b),
                        ("domain", [a, b]) => Step::Domain(*a, *b),
                        _ => Step::Insert(list.clone()),
                    };
                    matches.get_many(name).into_iter().flatten().map(make).collect()
                }
                ("halve" | "elevate" | "reduce", _) => {
                    let make = |count: &u64| {
                        let count = usize::try_from(*count).unwrap_or(usize::MAX);
                        match name {
                            "halve" => Step::Halve(count),
                            "elevate" => Step::Elevate(count),
                            _ => Step::Reduce(count, None),
                        }
                    };
                    matches.get_many(name).into_iter().flatten().map(make).collect()
                }
                (_, "") => {
                    let step = match name {
                        "clamp" => Step::Clamp,
                        "reverse" => Step::Reverse,
                        "derivative" => Step::Derivative,
                        _ => Step::Antiderivative,
                    };
                    vec![step; places.len()]
                }
                _ => {
                    let make = |number: &f64| match name {
                        "remove" => Step::Remove(*number),
                        "split" => Step::Split(*number),
                        "join" => Step::Join(*number),
                        "close" => Step::Close(*number),
                        _ => Step::Seam(*number),
                    };
                    matches.get_many(name).into_iter().flatten().map(make).collect()
                }
            };
            found.extend(places.into_iter().zip(steps));
        }
        found.sort_by_key(|(place, _)| *place);
        let tolerance = matches.get_one("tolerance").copied();
        Ok(Steps { steps: found.into_iter().map(|(_, step)| step).collect(), tolerance })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Steps::from_arg_matches(matches)?;
        Ok(())
    }
}
