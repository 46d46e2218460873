//! The registry of kinds: one line for each family that travels.

use lath::curve::{AnyCurve, Curve, CurveBuilder, CurveVisitor};

use crate::error::{Code, Error, Result};
use crate::json::{Json, Members};
use crate::shapes::object::Object;
use crate::shapes::{bezier, bspline, hermite, path, polyline, power, quintic};

/// How one family of curves travels: what a file says of it, checked as far as JSON goes.
pub(crate) trait Travels: Sized {
    /// The value of `"kind"`, which is also what the curve calls its kind.
    const NAME: &'static str;

    /// Takes the members that define the curve.
    fn read(members: &mut Members) -> Result<Self>;

    /// The number of coordinates.
    fn dimension(&self) -> usize;

    /// Builds the curve.
    fn build<const D: usize>(&self) -> lath::error::Result<Box<dyn Curve<D>>>;

    /// What the core refused, at the member at fault.
    fn refused(&self, members: &Members, core: lath::error::Error) -> Error;

    /// The members that define the curve; none for a curve of another family.
    fn write<const D: usize>(curve: &dyn Curve<D>, dimension: usize) -> Option<Object>;
}

macro_rules! kinds {
    ($($variant:ident $data:ty;)*) => {
        /// The data of a curve of any kind.
        pub(crate) enum Data {
            $($variant($data),)*
        }

        /// What `"kind"` may be.
        pub(crate) const NAMES: &[&str] = &[$(<$data as Travels>::NAME),*];

        impl Data {
            /// Takes the members that define a curve of this kind; none where there is no such kind.
            pub(crate) fn read(kind: &str, members: &mut Members) -> Option<Result<Data>> {
                $(if kind == <$data as Travels>::NAME {
                    return Some(<$data>::read(members).map(Data::$variant));
                })*
                None
            }

            /// The number of coordinates.
            pub(crate) fn dimension(&self) -> usize {
                match self { $(Data::$variant(data) => data.dimension(),)* }
            }

            /// What the core refused, at the member at fault.
            pub(crate) fn refused(&self, members: &Members, core: lath::error::Error) -> Error {
                match self { $(Data::$variant(data) => data.refused(members, core),)* }
            }
        }

        impl CurveBuilder for &Data {
            fn build<const D: usize>(self) -> lath::error::Result<Box<dyn Curve<D>>> {
                match self { $(Data::$variant(data) => data.build::<D>(),)* }
            }
        }

        /// Kind and defining members of a curve; none for a family that does not travel.
        pub(crate) fn write_in<const D: usize>(curve: &dyn Curve<D>, dimension: usize) -> Option<(&'static str, Object)> {
            $(if let Some(object) = <$data>::write(curve, dimension) {
                return Some((<$data as Travels>::NAME, object));
            })*
            None
        }
    };
}

// A new family: one line here.
kinds! {
    Bezier bezier::Data;
    BSpline bspline::Data;
    Hermite hermite::Data;
    Path path::Data;
    Polyline polyline::Data;
    Power power::Data;
    QuinticHermite quintic::Data;
}

/// Kinds that the format defines and this version does not hold yet.
pub(crate) const PENDING: &[&str] = &["bezier-surface", "bspline-surface"];

/// Kind and defining members of a curve, as [`write_in`].
pub(crate) fn write(curve: &AnyCurve) -> Option<(&'static str, Object)> {
    struct Write;
    impl CurveVisitor for Write {
        type Output = Option<(&'static str, Object)>;
        fn visit<const D: usize>(self, curve: &dyn Curve<D>, dimension: usize) -> Self::Output {
            write_in(curve, dimension)
        }
    }
    curve.visit(Write)
}

/// Takes kind and data of one shape.
///
/// # Errors
/// F015 without a kind, F017 where it is no string, F019 no such kind, F020 one that is not held yet.
pub(crate) fn read(members: &mut Members) -> Result<Data> {
    let names = || NAMES.iter().map(|name| format!("\"{name}\"")).collect::<Vec<_>>().join(", ");
    let kind = match members.require("kind", &format!("one of {}", names()))? {
        Json::Text(kind) => kind,
        other => {
            let message = format!("\"kind\" is {}, not a string", other.type_name());
            return Err(Error::new(Code::F017, message).at_pointer(members.pointer("kind")));
        }
    };
    Data::read(&kind, members).unwrap_or_else(|| {
        let error = if PENDING.contains(&&*kind) {
            Error::new(Code::F020, format!("shapes of kind \"{kind}\" are not supported yet"))
        } else {
            Error::new(Code::F019, format!("there is no kind \"{kind}\""))
        };
        Err(error.remedied(format!("The kinds are {}.", names())).at_pointer(members.pointer("kind")))
    })
}
