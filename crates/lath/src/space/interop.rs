//! Points of other crates, each behind a feature named after the crate's major version, so that a new one can join
//! without breaking the old.

#[allow(unused_imports)] // used by whichever feature is on
use crate::space::point::IntoPoint;

/// Implements the conversion for types with the fields x, y, … of a float type.
#[allow(unused_macros)]
macro_rules! by_fields {
    ($($type:ty, $d:literal: $($field:ident)*;)*) => {$(
        impl IntoPoint<$d> for $type {
            fn into_point(self) -> [f64; $d] {
                [$(f64::from(self.$field)),*]
            }
        }
    )*};
}

#[cfg(feature = "mint05")]
by_fields! {
    mint::Point2<f64>, 2: x y;
    mint::Point2<f32>, 2: x y;
    mint::Point3<f64>, 3: x y z;
    mint::Point3<f32>, 3: x y z;
    mint::Vector2<f64>, 2: x y;
    mint::Vector2<f32>, 2: x y;
    mint::Vector3<f64>, 3: x y z;
    mint::Vector3<f32>, 3: x y z;
    mint::Vector4<f64>, 4: x y z w;
    mint::Vector4<f32>, 4: x y z w;
}

#[cfg(feature = "glam034")]
by_fields! {
    glam::DVec2, 2: x y;
    glam::Vec2, 2: x y;
    glam::DVec3, 3: x y z;
    glam::Vec3, 3: x y z;
    glam::Vec3A, 3: x y z;
    glam::DVec4, 4: x y z w;
    glam::Vec4, 4: x y z w;
}

#[cfg(feature = "nalgebra035")]
mod nalgebra035 {
    use crate::space::point::IntoPoint;

    impl<T: Into<f64> + nalgebra::Scalar, const D: usize> IntoPoint<D> for nalgebra::SVector<T, D> {
        fn into_point(self) -> [f64; D] {
            core::array::from_fn(|c| self[c].clone().into())
        }
    }

    impl<T: Into<f64> + nalgebra::Scalar, const D: usize> IntoPoint<D> for nalgebra::Point<T, D> {
        fn into_point(self) -> [f64; D] {
            self.coords.into_point()
        }
    }
}

#[cfg(all(test, feature = "mint05", feature = "glam034", feature = "nalgebra035"))]
mod tests {
    use super::*;

    #[test]
    fn points_of_other_crates_become_arrays() {
        assert_eq!(mint::Point3 { x: 1.0_f32, y: 2.0, z: 3.0 }.into_point(), [1.0, 2.0, 3.0]);
        assert_eq!(glam::DVec2::new(4.0, 5.0).into_point(), [4.0, 5.0]);
        assert_eq!(glam::Vec3A::new(4.0, 5.0, 6.0).into_point(), [4.0, 5.0, 6.0]);
        assert_eq!(nalgebra::Point2::new(0.5_f32, 1.5).into_point(), [0.5, 1.5]);
        assert_eq!(nalgebra::SVector::<f64, 5>::repeat(2.0).into_point(), [2.0; 5]);
        assert_eq!(
            crate::space::point::collect::<2>([glam::Vec2::X, glam::Vec2::Y]).unwrap(),
            [[1.0, 0.0], [0.0, 1.0]]
        );
    }
}
