//! Developer tasks: `cargo xtask test` checks everything, `cargo xtask bench` measures.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a developer tool talks to a terminal")]

mod advisories;
mod answers;
mod api;
mod book;
mod clipping;
mod fuzz;
#[cfg(test)]
mod house;
mod ogc;
mod packages;
mod plane_soak;
mod python;
mod release;
mod soak;
mod space_soak;
mod studio;
mod tally;
mod targets;
mod test;
mod tokens;
mod typescript;
mod viewer;
mod wheels;
mod wild;

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

const USAGE: &str = "usage:
  cargo xtask test            format, lints, docs, packages, all tests, the viewer, Python, the commands of the README
  cargo xtask test -p CRATE   format, lints, docs and tests of one crate
  cargo xtask viewer          the viewer alone: types, tests, the page in the repository, the page in a browser
  cargo xtask studio          builds dist/studio.html: the program as WebAssembly in one page, with a target of WASI or Debian's rustc-web (minutes)
  cargo xtask studio --test   runs the page in a browser too, and compares its answers with the program's
  cargo xtask python          the Python package alone: build, types, stubs, tests, examples
  cargo xtask python --sdist  makes its source distribution and looks at it; --wheel makes the wheel for this machine too (minutes)
  cargo xtask release X.Y.Z [--date YYYY-MM-DD] [--allow-dirty]
                              gives every crate, the changelog and the citation the version; says what to commit and tag
  cargo xtask package [--verify] [--allow-dirty]
                              packs every crate that is published and looks at it: licences, readme, size; --verify builds them too (minutes)
  cargo xtask archive [--no-build]
                              builds the program for release and puts it into dist/ with manual pages, completions, licences, a bill of
                              materials and checksums, as .tar.gz (.zip on Windows), and as .deb where dpkg-deb is there
  cargo xtask answers --write DIR | --against DIR [--program PATH] [--only WORD] [--seconds N] [--jobs N]
                              runs every verb on every file; keeps the answers in DIR, or compares with those there
  cargo xtask wild DIR..      runs `coface info` on every file below the folders; counts what is read, and why the rest is refused
  cargo xtask ogc DIR..       runs the XML test cases of JTS or GEOS below the folders: isValid and overlays of polygons
  cargo xtask clipping DIR..  runs the cases of Clipper2 and of i_overlay: results are valid and have the areas of the cases
  cargo xtask soak [--minutes N]
                              asks the program and the Python package the same again and again; answers, files and memory must stay
  cargo xtask soak --space [--count N] [--chains N] [--steps N] [--stl N] [--scenes N] [--angles N] [--offsets N] [--tubes N]
                              chains of Booleans of solids, random scenes against voxels, rooms at many angles, boxes that coincide,
                              tubes that overlap themselves
  cargo xtask soak --plane [--chains N]
                              the laws of the Boolean algebra over chains of operations of sets with spline boundaries
  cargo xtask targets [--run] [TARGET]
                              checks the program for Windows, macOS, Linux on ARM and WASI; --run runs tests of the first under Wine and
                              of the third under an emulator, where linkers for them are installed (minutes)
  cargo xtask advisories [DIR]
                              says which packages have known faults, by the snapshot in xtask/advisories.txt; DIR makes it anew
  cargo xtask book [--check | --write] [--program PATH] [--only CHAPTER]
                              follows the links of docs/book and writes docs/book.html; --check runs its commands and compares
                              what they print and draw, --write keeps that and generates the reference
  cargo xtask api [--write]   says what has changed of what each crate offers, as listed in docs/api; writes the lists
  cargo xtask types [--write] says whether the viewer has the types of docs/answers.schema.json; writes them
  cargo xtask fuzz --minutes N [--target NAME] [--jobs N]
                              runs the fuzz targets for so long together and prints what each has executed, reached and found
  cargo xtask bench [ARGS]    builds for release and runs coface-bench (`cargo xtask bench list` says what there is)";

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    match words.first().map(String::as_str) {
        Some("test") if words.len() == 1 => test::run(),
        Some("test") if words.len() == 3 && matches!(words[1].as_str(), "-p" | "--package") => {
            test::run_crate(&words[2])
        }
        Some("viewer") if words.len() == 1 => viewer::run(),
        Some("studio") if words.len() == 1 => studio::run(false),
        Some("studio") if words[1..] == ["--test"] => studio::run(true),
        Some("python") if words.len() == 1 => python::run(),
        Some("python") if words[1..] == ["--sdist"] => wheels::wheels(false),
        Some("python") if words[1..] == ["--wheel"] => wheels::wheels(true),
        Some("release") => release::release(&words[1..]),
        Some("package") => release::package(&words[1..]),
        Some("archive") => release::archive(&words[1..]),
        Some("answers") => answers::answers(&words[1..]),
        Some("targets") => targets::targets(&words[1..]),
        Some("advisories") => advisories::advisories(&words[1..]),
        Some("soak") if words.get(1).is_some_and(|word| word == "--space") => space_soak::soak(&words[2..]),
        Some("soak") if words.get(1).is_some_and(|word| word == "--plane") => plane_soak::soak(&words[2..]),
        Some("soak") => soak::soak(&words[1..]),
        Some("wild") => wild::wild(&words[1..]),
        Some("ogc") => ogc::ogc(&words[1..]),
        Some("clipping") => clipping::clipping(&words[1..]),
        Some("book") => book::book(&words[1..]),
        Some("api") => api::api(&words[1..]),
        Some("types") => typescript::types(&words[1..]),
        Some("fuzz") => fuzz::fuzz(&words[1..]),
        Some("bench") => bench(&words[1..]),
        Some("help" | "-h" | "--help") => {
            println!("{USAGE}");
            ExitCode::SUCCESS
        }
        _ => {
            eprintln!("{USAGE}");
            ExitCode::from(2)
        }
    }
}

/// Builds the programs for release and runs `coface-bench` with these words.
fn bench(words: &[String]) -> ExitCode {
    let is_built =
        cargo(&["build", "--release", "--workspace"]).status().is_ok_and(|status| status.success());
    let is_done = is_built
        && cargo(&["run", "--release", "--quiet", "--package", "coface-bench", "--"])
            .args(words)
            .status()
            .is_ok_and(|status| status.success());
    if is_done { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// The command `cargo WORDS` in the root of the repository.
fn cargo(words: &[&str]) -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(words).current_dir(root());
    command
}

/// The root of the repository.
fn root() -> PathBuf {
    let own = Path::new(env!("CARGO_MANIFEST_DIR"));
    own.parent().map_or_else(|| own.to_owned(), Path::to_owned)
}
