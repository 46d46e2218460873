//! `cargo xtask gallery`: draws every picture of the documentation anew, by the commands recorded beside it, and writes the
//! gallery's page.
//!
//! `testdata/figures/pictures.toml` lists them: `[[picture]]`, a file and the arguments that draw it; `[[section.figure]]`, a figure
//! of the gallery with what the page says about it. A figure's last command draws; commands before it make what it needs, in a folder
//! that has `testdata/figures` and `testdata/real` and nothing else. Each figure is drawn as SVG and as PNG, light and dark.
//!
//! Tests of the tool and of this crate compare pictures and page; this only writes. Look at each changed picture at full size,
//! light and dark, before it is committed. `cargo xtask gallery NAME …` draws the figures of these names only.

use crate::{Outcome, read_toml};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

const LIST: &str = "testdata/figures/pictures.toml";
const FOLDER: &str = "docs/gallery";

pub(crate) fn run(root: &Path, names: &[&str]) -> Outcome {
    let list = List::read(root)?;
    let known: Vec<&str> = list.figures().map(|figure| figure.name.as_str()).collect();
    if let Some(unknown) = names.iter().find(|name| !known.contains(name)) {
        return Err(format!("no figure is called {unknown}; {LIST} has {}", known.join(", ")));
    }
    let tool = build(root)?;
    let scratch = Scratch::new(root)?;
    let mut faults = Vec::new();
    for figure in list.figures().filter(|figure| names.is_empty() || names.contains(&figure.name.as_str())) {
        faults.extend(figure.draw(&tool, &scratch, root).err());
    }
    for (file, arguments) in list.pictures.iter().filter(|_| names.is_empty()) {
        faults.extend(scratch.run(&tool, arguments, &["-o", &absolute(root, file)?]).err());
    }
    let page = format!("{FOLDER}/README.md");
    std::fs::write(root.join(&page), list.page()).map_err(|error| format!("{page}: {error}"))?;
    match faults.is_empty() {
        true => Ok(format!("{} figures in {FOLDER}, {} other pictures", known.len(), list.pictures.len())),
        false => Err(faults.join("\n")),
    }
}

/// The list of all pictures.
struct List {
    /// File and arguments of the pictures outside the gallery.
    pictures: Vec<(String, Vec<String>)>,
    sections: Vec<Section>,
}

struct Section {
    title: String,
    about: String,
    figures: Vec<Figure>,
}

struct Figure {
    name: String,
    title: String,
    says: String,
    commands: Vec<Vec<String>>,
}

impl List {
    fn read(root: &Path) -> Result<List, String> {
        List::of(&read_toml(root, LIST)?).map_err(|fault| format!("{LIST}: {fault}"))
    }

    fn of(table: &toml::Table) -> Result<List, String> {
        let mut pictures = Vec::new();
        for picture in array(table, "picture") {
            let file = text(picture, "file")?;
            pictures.push((file, words(picture.get("command"))?));
        }
        let mut sections = Vec::new();
        for section in array(table, "section") {
            let table = section.as_table().ok_or("a section is a table")?;
            let mut figures = Vec::new();
            for figure in array(table, "figure") {
                let commands =
                    figure.get("commands").and_then(toml::Value::as_array).ok_or("a figure without commands")?;
                let commands: Vec<_> = commands.iter().map(|line| words(Some(line))).collect::<Result<_, _>>()?;
                let name = text(figure, "name")?;
                if commands.is_empty() {
                    return Err(format!("{name} has no command"));
                }
                figures.push(Figure { name, title: text(figure, "title")?, says: text(figure, "says")?, commands });
            }
            sections.push(Section { title: text(section, "title")?, about: text(section, "about")?, figures });
        }
        Ok(List { pictures, sections })
    }

    fn figures(&self) -> impl Iterator<Item = &Figure> {
        self.sections.iter().flat_map(|section| &section.figures)
    }

    /// The page of the gallery.
    fn page(&self) -> String {
        let mut page = String::from(
            "# Gallery\n\n\
            Every figure here is drawn by the commands below it, run from the root of the repository; a test draws them again and \
            compares every byte.\nThe pictures come as SVG and PNG, light (`-o …`) and dark (`--dark`).\n\n",
        );
        for section in &self.sections {
            let _ = writeln!(page, "- [{}](#{})", section.title, anchor(&section.title));
        }
        for section in &self.sections {
            let _ = write!(page, "\n## {}\n\n{}\n", section.title, section.about);
            for figure in &section.figures {
                page.push_str(&figure.entry());
            }
        }
        page
    }
}

impl Figure {
    /// Draws light and dark, as SVG and PNG.
    fn draw(&self, tool: &Path, scratch: &Scratch, root: &Path) -> Result<(), String> {
        let (last, before) = self.commands.split_last().ok_or("no command")?;
        for command in before {
            scratch.run(tool, command, &[])?;
        }
        for (suffix, look) in [("", &[][..]), ("-dark", &["--dark"][..])] {
            for (extension, density) in [("svg", &[][..]), ("png", &["--density", "0.85"][..])] {
                let file = absolute(root, &format!("{FOLDER}/{}{suffix}.{extension}", self.name))?;
                scratch.run(tool, last, &[look, density, &["-o", &file]].concat())?;
            }
        }
        Ok(())
    }

    /// What the page shows and says.
    fn entry(&self) -> String {
        let Figure { name, title, says, commands } = self;
        let mut lines = String::new();
        for (i, command) in commands.iter().enumerate() {
            let _ = write!(lines, "lath {}", command.iter().map(|word| quoted(word)).collect::<Vec<_>>().join(" "));
            lines.push_str(&if i + 1 == commands.len() { format!(" -o {name}.svg\n") } else { "\n".to_owned() });
        }
        let alt = title.replace('"', "&quot;");
        format!(
            "\n### {title}\n\n\
            <picture><source media=\"(prefers-color-scheme: dark)\" srcset=\"{name}-dark.svg\">\
            <img alt=\"{alt}\" src=\"{name}.svg\"></picture>\n\n\
            {says} ([PNG]({name}.png), [dark]({name}-dark.png))\n\n```sh\n{lines}```\n"
        )
    }
}

/// A folder with the data of the figures.
struct Scratch(PathBuf);

impl Scratch {
    fn new(root: &Path) -> Result<Scratch, String> {
        let folder = root.join("target/gallery");
        let fill = || -> std::io::Result<()> {
            if folder.exists() {
                std::fs::remove_dir_all(&folder)?;
            }
            for data in ["testdata/figures", "testdata/real"] {
                std::fs::create_dir_all(folder.join(data))?;
                for entry in std::fs::read_dir(root.join(data))? {
                    let entry = entry?;
                    std::fs::copy(entry.path(), folder.join(data).join(entry.file_name()))?;
                }
            }
            Ok(())
        };
        fill().map_err(|error| format!("{}: {error}", folder.display()))?;
        Ok(Scratch(folder))
    }

    fn run(&self, tool: &Path, command: &[String], more: &[&str]) -> Result<(), String> {
        let output = Command::new(tool).args(command).args(more).current_dir(&self.0).output();
        let output = output.map_err(|error| format!("{}: {error}", tool.display()))?;
        let words = command.join(" ");
        if output.status.success() {
            Ok(())
        } else {
            Err(format!("lath {words}: {}", String::from_utf8_lossy(&output.stderr)))
        }
    }
}

/// The tool, built without optimisation: it draws the same bytes, and compiles sooner.
fn build(root: &Path) -> Result<PathBuf, String> {
    let status = Command::new("cargo")
        .args(["build", "--quiet", "--package", "lath-cli"])
        .current_dir(root)
        .status()
        .map_err(|error| format!("cargo: {error}"))?;
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), PathBuf::from);
    let tool = target.join("debug").join(format!("lath{}", std::env::consts::EXE_SUFFIX));
    if status.success() { Ok(tool) } else { Err("lath does not build".to_owned()) }
}

fn absolute(root: &Path, file: &str) -> Result<String, String> {
    let path = std::path::absolute(root.join(file)).map_err(|error| format!("{file}: {error}"))?;
    path.into_os_string().into_string().map_err(|path| format!("{}: not in UTF-8", path.display()))
}

fn array<'a>(table: &'a toml::Table, key: &str) -> &'a [toml::Value] {
    table.get(key).and_then(toml::Value::as_array).map(Vec::as_slice).unwrap_or_default()
}

fn text(table: &toml::Value, key: &str) -> Result<String, String> {
    let text = table.get(key).and_then(toml::Value::as_str).filter(|text| !text.trim().is_empty());
    text.map(str::to_owned).ok_or_else(|| format!("a {key} is missing in: {table}"))
}

fn words(list: Option<&toml::Value>) -> Result<Vec<String>, String> {
    let list = list.and_then(toml::Value::as_array).ok_or("a command is a list of words")?;
    list.iter().map(|word| word.as_str().map(str::to_owned).ok_or_else(|| format!("{word} is no word"))).collect()
}

/// A word as a shell takes it.
fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_./,:=+".contains(c);
    if !word.is_empty() && word.chars().all(plain) { word.to_owned() } else { format!("\"{word}\"") }
}

/// How a heading is linked to.
fn anchor(heading: &str) -> String {
    let kept = heading.chars().filter(|c| c.is_alphanumeric() || *c == ' ' || *c == '-');
    kept.map(|c| if c == ' ' { '-' } else { c.to_ascii_lowercase() }).collect()
}

#[cfg(test)]
mod tests {
    use super::{FOLDER, Figure, List, anchor, quoted};
    use std::collections::BTreeSet;

    #[test]
    fn the_page_says_what_the_list_says() {
        let root = crate::root();
        let list = List::read(&root).unwrap();
        let page = std::fs::read_to_string(root.join(FOLDER).join("README.md")).unwrap();
        assert!(page == list.page(), "`cargo xtask gallery` writes the page anew");
    }

    #[test]
    fn the_folder_holds_what_the_list_names_and_nothing_else() {
        let root = crate::root();
        let list = List::read(&root).unwrap();
        let mut named: Vec<String> = vec!["README.md".to_owned()];
        for Figure { name, .. } in list.figures() {
            named.extend(["svg", "png"].into_iter().flat_map(|e| [format!("{name}.{e}"), format!("{name}-dark.{e}")]));
        }
        let names: BTreeSet<String> = named.iter().cloned().collect();
        assert_eq!(names.len(), named.len(), "a name occurs twice");
        let entries = std::fs::read_dir(root.join(FOLDER)).unwrap();
        let files: BTreeSet<String> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        assert_eq!(files, names);
    }

    #[test]
    fn every_picture_that_a_page_shows_is_there() {
        let root = crate::root();
        let mut pages = vec![root.join("README.md"), root.join(FOLDER).join("README.md")];
        pages.extend(std::fs::read_dir(root.join("docs")).unwrap().map(|entry| entry.unwrap().path()));
        let mut shown = 0;
        for page in pages.iter().filter(|page| page.extension().is_some_and(|extension| extension == "md")) {
            let text = std::fs::read_to_string(page).unwrap();
            // Links, and the two places of a picture that comes light and dark.
            for start in ["](", "src=\"", "srcset=\""] {
                for target in text.split(start).skip(1).filter_map(|rest| rest.split([')', '"', '#']).next()) {
                    if target.ends_with(".svg") || target.ends_with(".png") {
                        assert!(page.with_file_name(target).exists(), "{}: {target}", page.display());
                        shown += 1;
                    }
                }
            }
        }
        assert!(shown > 200, "{shown}");
    }

    #[test]
    fn commands_stand_on_the_page_as_a_shell_takes_them() {
        assert_eq!((quoted("a/b-1.csv"), quoted("degree 1.json")), ("a/b-1.csv".into(), "\"degree 1.json\"".into()));
        assert_eq!(anchor("Curves through points"), "curves-through-points");
        let list = "[[section]]\ntitle = 'S'\nabout = 'a'\n[[section.figure]]\nname = 'n'\ntitle = 'T'\nsays = 'It is.'\n\
            commands = [['curve', 'a b', '-o', 'c.json'], ['draw', 'c.json']]";
        let page = List::of(&list.parse().unwrap()).unwrap().page();
        assert!(page.contains("```sh\nlath curve \"a b\" -o c.json\nlath draw c.json -o n.svg\n```\n"), "{page}");
        assert!(page.contains("- [S](#s)\n") && page.contains("srcset=\"n-dark.svg\""), "{page}");
        for wrong in ["[[picture]]\nfile = 'x'", &list.replace("says", "said"), &list.replace("commands", "command")] {
            assert!(List::of(&wrong.parse().unwrap()).is_err(), "{wrong}");
        }
    }
}
