//! Runs the tool on lines of arguments, in a folder made for the purpose that is made anew for every line.
#![no_main]

use fuzzing::arguments::{FILES, judge, line};
use std::{env, fs};

libfuzzer_sys::fuzz_target!(init: {
    let folder = env::temp_dir().join(format!("lath-arguments-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder for temporary files");
    env::set_current_dir(&folder).expect("the folder was just made");
}, |bytes: &[u8]| {
    let Some(arguments) = line(bytes) else { return };
    for entry in fs::read_dir(".").into_iter().flatten().flatten() {
        let _ = fs::remove_file(entry.path()).or_else(|_| fs::remove_dir_all(entry.path()));
    }
    for (name, text) in FILES {
        fs::write(name, text).expect("a file in the folder");
    }
    let code = lath_cli::run(std::iter::once("lath".to_owned()).chain(arguments));
    judge(Some(i32::from(code)), None);
});
