//! The browser viewer: its sources, the page that is made of them, and that page in a real browser.

use crate::root;
use crate::tally::Tally;
use crate::test::{build, built, check, install_package};
use std::path::PathBuf;
use std::process::{Command, ExitCode, Stdio};

/// The page that the program holds.
const PAGE: &str = "crates/coface-pictures/page/viewer.html";

/// Runs the checks of the viewer alone, and closes with the counts.
pub(crate) fn run() -> ExitCode {
    let mut tally = Tally::default();
    viewer(&mut tally);
    if build(&mut tally) {
        browser(&mut tally);
    }
    println!("{}", tally.to_line());
    if tally.failed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// Types and tests of the viewer; that the page in the repository is what its sources make. What is not installed, and
/// cannot be, is skipped.
pub(crate) fn viewer(tally: &mut Tally) {
    if let Err(why) = prepare() {
        tally.skip("the viewer", &why);
        return;
    }
    check(tally, "types of the viewer", &mut npm(&["run", "--silent", "check"]));
    check(tally, "tests of the viewer", &mut npm(&["test", "--silent"]));
    bundle(tally);
}

/// The command `npm WORDS` in the folder of the viewer.
pub(crate) fn npm(words: &[&str]) -> Command {
    let mut command = Command::new(if cfg!(windows) { "npm.cmd" } else { "npm" });
    command.args(words).current_dir(root().join("viewer")).env("NO_COLOR", "1");
    command
}

/// Sees to it that Node is there, and what the lock file names.
pub(crate) fn prepare() -> Result<(), String> {
    let version = output(Command::new("node").arg("--version")).ok_or("node is not installed")?;
    let major = version.trim().trim_start_matches('v').split('.').next().and_then(|major| major.parse().ok());
    if major.is_none_or(|major: u32| major < 20) {
        return Err(format!("node is {}, and 20 is needed", version.trim()));
    }
    output(npm(&["--version"]).stderr(Stdio::null())).ok_or("npm is not installed")?;
    let viewer = root().join("viewer");
    let modified = |path: PathBuf| path.metadata().and_then(|data| data.modified()).ok();
    let installed = modified(viewer.join("node_modules/.package-lock.json"));
    if installed.is_some() && installed >= modified(viewer.join("package-lock.json")) {
        return Ok(());
    }
    println!("== viewer: npm ci");
    let is_done = npm(&["ci", "--no-audit", "--no-fund", "--fetch-retries=1", "--fetch-timeout=60000"])
        .stdin(Stdio::null())
        .status();
    match is_done.is_ok_and(|status| status.success()) {
        true => Ok(()),
        false => Err("npm ci cannot install what viewer/package-lock.json names".to_owned()),
    }
}

/// Whether the page in the repository is what its sources make, byte for byte.
fn bundle(tally: &mut Tally) {
    let folder = root().join("target/viewer");
    let place = folder.display().to_string();
    check(tally, "page of the viewer", &mut npm(&["run", "--silent", "build", "--", "--outDir", &place]));
    let [made, held] = [folder.join("viewer.html"), root().join(PAGE)].map(|path| std::fs::read(path).ok());
    let is_same = made.is_some() && made == held;
    println!(
        "== page of the viewer: {}",
        if is_same {
            "the same as in the repository"
        } else {
            "differs from the repository; run `npm run build` in viewer/ and commit what changes"
        }
    );
    tally.count(is_same);
}

/// The page in a browser.
pub(crate) fn browser(tally: &mut Tally) {
    if let Err(why) = prepare() {
        tally.skip("the page in a browser", &why);
        return;
    }
    let Some(chromium) = chromium() else {
        tally.skip("the page in a browser", "chromium is not installed, and cannot be");
        return;
    };
    let program = built("coface").get_program().to_owned();
    let mut tests = npm(&["run", "--silent", "test:browser"]);
    tests.env("COFACE_PROGRAM", program).env("CHROMIUM", chromium);
    check(tally, "the page in a browser", &mut tests);
}

/// A browser of the Chromium family; installed where that is possible.
pub(crate) fn chromium() -> Option<PathBuf> {
    let find = || {
        let names = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];
        let named = std::env::var_os("CHROMIUM").map(PathBuf::from).filter(|path| path.is_file());
        named.or_else(|| names.iter().find_map(|name| on_path(name)))
    };
    find().or_else(|| {
        install_package("chromium");
        find()
    })
}

pub(crate) fn on_path(name: &str) -> Option<PathBuf> {
    let folders = std::env::var_os("PATH")?;
    std::env::split_paths(&folders).map(|folder| folder.join(name)).find(|path| path.is_file())
}

/// What a command prints, if it runs well.
pub(crate) fn output(command: &mut Command) -> Option<String> {
    let output = command.stdin(Stdio::null()).output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).into_owned())
}
