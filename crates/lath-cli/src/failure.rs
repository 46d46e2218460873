//! What can go wrong, and the exit code of each.

use lath_exact::error::Class;
use lath_io::Error;

/// The result of a verb.
pub(crate) type Result<T, E = Failure> = core::result::Result<T, E>;

/// Why a verb did not do what was asked.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The command line is wrong, whatever the data: exit 2. The verb is known once the failure has left it.
    Usage { verb: &'static str, message: String },
    /// The data, the files or the budget: the exit code follows the class of the error.
    Data(Box<Error>),
    /// The file holds another number of shapes than the question needs: exit 3.
    Choice(Choice),
    /// A question in fractions has no answer; `place` is the option at fault, where one is.
    Exact { place: &'static str, error: Box<lath_exact::error::Error> },
    /// `check` found an error in a file, and has reported it: exit 1.
    Found,
}

/// A question that needs one shape, asked of a file where it is not clear which.
#[derive(Debug)]
pub(crate) struct Choice {
    /// A001: several shapes, and none chosen; A002: no such shape.
    pub(crate) code: &'static str,
    /// The file.
    pub(crate) source: String,
    /// What is wrong, the shapes listed.
    pub(crate) message: String,
    /// What to do.
    pub(crate) remedy: String,
}

impl Failure {
    /// The command line is wrong.
    pub(crate) fn usage(message: impl Into<String>) -> Failure {
        Failure::Usage { verb: "", message: message.into() }
    }

    /// What lath-exact refused, in what an option said.
    pub(crate) fn exact(place: &'static str, error: lath_exact::error::Error) -> Failure {
        match error.class() {
            Class::Usage => Failure::usage(format!("{}. {}", error.message(), error.remedy())),
            _ => Failure::Exact { place, error: Box::new(error) },
        }
    }

    /// A file of shapes that holds none.
    pub(crate) fn no_shapes(source: &str) -> Failure {
        let (message, remedy) = ("there are no shapes".into(), "Give a file with a curve.".into());
        Failure::Choice(Choice { code: "A002", source: source.into(), message, remedy })
    }

    /// The same failure, with the verb it happened in.
    pub(crate) fn in_verb(mut self, name: &'static str) -> Failure {
        if let Failure::Usage { verb, .. } = &mut self {
            *verb = name;
        }
        self
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Failure {
        Failure::Data(Box::new(error))
    }
}

impl From<lath_exact::error::Error> for Failure {
    fn from(error: lath_exact::error::Error) -> Failure {
        Failure::exact("", error)
    }
}

impl From<lath::error::Error> for Failure {
    fn from(error: lath::error::Error) -> Failure {
        Error::from(error).into()
    }
}
