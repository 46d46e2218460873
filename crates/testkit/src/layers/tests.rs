//! A check that cannot fail checks nothing: small made-up houses, each with one fault.

use super::*;

const THREE: &str = r#"
    [[floor]]
    room = "error"
    [[floor]]
    room = "num"
    [[floor]]
    room = "mesh"
    planned = true
    [[floor]]
    room = "curve"
    [crates.lath]
    imports = []
    outside = ["libm"]
    tests = ["testkit"]
    [crates.lath-io]
    imports = ["lath"]
    [crates.testkit]
    imports = ["lath"]
"#;

const CONTENTS: &str = "pub mod error; // F0: faults\npub mod num; // F1: numbers\npub mod curve; // F3: curves\n\npub use curve::Curve;\n";

fn faults(sources: &[(&str, &str)]) -> Vec<String> {
    let owned: Vec<(String, String)> = sources.iter().map(|(path, text)| ((*path).into(), (*text).into())).collect();
    check(&Layers::parse(THREE), &owned)
}

#[test]
fn a_sound_house_has_no_faults() {
    let sound = [
        ("lib.rs", CONTENTS),
        ("error/mod.rs", "//! F0 — faults.\nmod code;\npub use self::code::Code;"),
        ("error/code.rs", "use super::Error; // not crate::curve\n/* nor /* nested */ crate::curve */"),
        (
            "num/mod.rs",
            "//! F1 — numbers.\nuse crate::error::{Code, Error};\npub(crate) mod sum;\npub(crate) fn f() {}",
        ),
        ("num/sum.rs", "use super::super::error::Code;\nconst S: &str = \"crate::curve\";\nconst C: char = '\"';"),
        (
            "curve/mod.rs",
            "//! F3 — curves.\nuse crate::{error::Error, num::{self, Sum as S}};\nfn f<'a>(x: &'a str) { crate::num::g::<u8>(); }",
        ),
    ];
    assert_eq!(faults(&sound), [""; 0]);
}

#[test]
fn an_import_that_points_up_is_named_with_both_floors() {
    let text = "//! F1 — numbers.\n\nuse crate::error::Error;\nuse crate::curve::Curve;\n";
    assert_eq!(
        faults(&[("num/mod.rs", text)]),
        ["num/mod.rs:4: floor 1 (num) imports floor 3 (curve): move the method up"]
    );
}

#[test]
fn every_way_to_point_up_is_seen() {
    let ways = [
        "use crate::{error::Error, curve::Curve};",
        "use crate::{\n    error::{Code, Error},\n    curve::{self},\n};",
        "use crate::curve::*;",
        "use super::super::curve::Curve;",
        "use super::{super::curve::Curve, Sum};",
        "pub use self::super::super::curve::Curve;",
        "fn f(x: crate::curve::Curve) {}",
        "fn f() { let r = \"a\\\"\"; crate::curve::g(r#\"\"#); }",
        "mod tests { use super::super::super::curve::Curve; }",
        "#[cfg(test)]\nmod tests {\n    use crate::curve::Curve;\n}",
        "macro_rules! m { () => { $crate::curve::Curve } }",
        "const C: char = '\\''; use crate::curve::Curve;",
    ];
    for way in ways {
        let found = faults(&[("num/sum.rs", way)]);
        assert_eq!(found.len(), 1, "{way}: {found:?}");
        assert!(found[0].ends_with("floor 1 (num) imports floor 3 (curve): move the method up"), "{way}: {found:?}");
    }
}

#[test]
fn the_crate_root_is_no_module() {
    for way in ["use crate::Curve;", "use crate::{error::Error, Curve};", "use crate::*;", "use super::super::Curve;"] {
        let found = faults(&[("num/sum.rs", way)]);
        assert_eq!(found.len(), 1, "{way}: {found:?}");
        assert!(found[0].contains("from the crate root"), "{way}: {found:?}");
    }
}

#[test]
fn inline_modules_end_where_their_brace_does() {
    let text = "mod inner { fn f() { if true {} } }\nuse super::super::error::Code;\nuse super::super::curve::Curve;";
    let found = faults(&[("num/sum.rs", text)]);
    assert_eq!(found, ["num/sum.rs:3: floor 1 (num) imports floor 3 (curve): move the method up"]);
}

#[test]
fn rooms_without_a_floor_and_floors_without_an_essay_are_refused() {
    assert!(faults(&[("extras.rs", "//! F1 — extras.")])[0].contains("no floor of layers.toml is called `extras`"));
    assert!(faults(&[("num/mod.rs", "//! Numbers.")])[0].contains("opens with its essay"));
}

#[test]
fn the_table_of_contents_is_bottom_up_and_complete() {
    let late = "pub mod num; // F1: numbers\npub mod error; // F0: faults\npub mod curve; // F3: curves\n";
    assert!(faults(&[("lib.rs", late)])[0].contains("floor 0 (error) is declared too late"));
    let missing = "pub mod error; // F0: faults\npub mod curve; // F3: curves\n";
    assert!(faults(&[("lib.rs", missing)])[0].contains("floor 1 (num) is not declared"));
    let unknown = format!("{CONTENTS}mod extras;");
    assert!(faults(&[("lib.rs", &unknown)])[0].contains("no floor of layers.toml is called `extras`"));
    let built = "pub mod error; // F0: e\npub mod num; // F1: n\npub mod mesh; // F2: m\npub mod curve; // F3: c\n";
    assert!(faults(&[("lib.rs", built)])[0].contains("remove `planned`"));
    let bare = CONTENTS.replace("// F1: numbers", "// F2: numbers");
    assert!(faults(&[("lib.rs", &bare)])[0].contains("`// F1: …`"));
}

#[test]
fn empty_names_and_overgrown_files_are_refused() {
    let file = |name: &str, text: String| check_files(&[(name.to_owned(), text)]);
    assert!(file("num/utils.rs", String::new())[0].contains("says nothing"));
    assert!(file("common/mod.rs", String::new())[0].contains("says nothing"));
    assert!(file("num/sum.rs", "let x;\n".repeat(LONGEST + 1))[0].contains("701 lines of code"));
    let long_but_not_code = "// words\n\n".repeat(LONGEST) + "let x;\n#[cfg(test)]\n" + &"let y;\n".repeat(LONGEST);
    assert_eq!(file("num/sum.rs", long_but_not_code), [""; 0]);
}

#[test]
fn edges_between_crates_are_closed() {
    let layers = Layers::parse(THREE);
    let manifest = |name: &str, body: &str| check_manifest(&layers, &format!("[package]\nname = \"{name}\"\n{body}"));
    assert_eq!(
        manifest("lath", "[dependencies]\nlibm = \"0\"\n[dev-dependencies]\ntestkit = \"0\"\nproptest = \"0\""),
        [""; 0]
    );
    assert!(manifest("lath", "[dependencies]\nrand = \"0\"")[0].contains("not on its list"));
    assert!(manifest("lath", "[dependencies]\ntestkit = \"0\"")[0].contains("an edge that layers.toml does not have"));
    assert!(manifest("testkit", "[dependencies]\nlath-io = \"0\"")[0].contains("an edge"));
    assert!(manifest("stranger", "")[0].contains("missing from [crates]"));
}
