//! The Python package: built, then types, stubs, tests, examples.

use crate::root;
use crate::tally::Tally;
use crate::test::{build, check, install_package, run_counted, target};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::{env, fs, io};

/// The package in the repository.
const PACKAGE: &str = "crates/coface-py";
/// What the checks need beside the package: names for pip.
const REQUIREMENTS: &str = "tests/requirements.txt";

/// What tests use where it can be installed, and are skipped without.
const RAY: &str = "tests/requirements-ray.txt";

/// The same for notebooks and widgets.
const NOTEBOOKS: &str = "tests/requirements-notebooks.txt";

/// Runs the checks of the Python package alone, and closes with the counts.
pub(crate) fn run() -> ExitCode {
    let mut tally = Tally::default();
    if build(&mut tally) {
        python(&mut tally);
    }
    println!("{}", tally.to_line());
    if tally.failed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// Asks the package that was built everything. What is not installed, and cannot be, is skipped.
pub(crate) fn python(tally: &mut Tally) {
    if let Err(why) = prepare() {
        tally.skip("the Python package", &why);
        return;
    }
    if let Err(error) = assemble() {
        println!("== the Python package: failed, its parts cannot be put together: {error}");
        tally.count(false);
        return;
    }
    let cache = target().join("python/mypy").display().to_string();
    let types = ["-m", "mypy", "--cache-dir", &cache, "--package", "coface"];
    check(tally, "types in Python", &mut interpreter(&types));
    let options = [
        "--mypy-config-file",
        "pyproject.toml",
        "--allowlist",
        "tests/stubtest.txt",
        "--ignore-unused-allowlist",
    ];
    let stubs = [&["-m", "mypy.stubtest"], &options[..], &["coface._coface"]].concat();
    check(tally, "stubs in Python", &mut interpreter(&stubs));
    let tests = ["-m", "pytest", "--quiet", "-p", "no:cacheprovider", "--durations=8", "tests"];
    run_counted(tally, "tests in Python", interpreter(&tests), || ());
    examples(tally);
}

/// Puts the compiled part beside the rest in a folder that Python looks into, as a wheel has them.
fn assemble() -> io::Result<()> {
    let site = site();
    if site.exists() {
        fs::remove_dir_all(&site)?;
    }
    copy_folder(&root().join(PACKAGE).join("python"), &site)?;
    let name = format!("{}_coface{}", env::consts::DLL_PREFIX, env::consts::DLL_SUFFIX);
    let compiled = if cfg!(windows) { "_coface.pyd" } else { "_coface.abi3.so" };
    fs::copy(target().join("debug").join(name), site.join("coface").join(compiled)).map(drop)
}

/// Copies what is in a folder, but what a build by hand left there.
fn copy_folder(from: &Path, to: &Path) -> io::Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        let (path, copy) = (entry.path(), to.join(entry.file_name()));
        if entry.file_type()?.is_dir() {
            copy_folder(&path, &copy)?;
        } else if path.extension().is_none_or(|extension| extension != "so" && extension != "pyd") {
            fs::copy(path, copy)?;
        }
    }
    Ok(())
}

/// The gallery: each script asserts what it shows.
fn examples(tally: &mut Tally) {
    let folder = root().join(PACKAGE).join("examples");
    let mut scripts: Vec<PathBuf> = fs::read_dir(&folder)
        .into_iter()
        .flatten()
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| path.extension().is_some_and(|extension| extension == "py"))
        .collect();
    scripts.sort();
    let pictures = target().join("python/pictures").display().to_string();
    for script in scripts {
        let name = script.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        check(tally, &name, &mut interpreter(&[&script.display().to_string(), &pictures]));
    }
}

/// Sees to the environment while something else is built; what goes wrong is told when it is needed.
pub(crate) fn prepare_early() {
    drop(prepare());
}

/// Sees to it that there is an environment with what the checks need.
fn prepare() -> Result<(), String> {
    let version = "import sys; sys.exit(sys.version_info < (3, 10))";
    if !is_done(Command::new("python3").args(["-c", version])) {
        return Err("python3 is not installed, or older than 3.10".to_owned());
    }
    let environment = environment();
    let make = || is_done(Command::new("python3").args(["-m", "venv"]).arg(&environment));
    if !program().is_file() && !make() {
        install_package("python3-venv");
        if !make() {
            return Err("python3 -m venv makes no environment".to_owned());
        }
    }
    install(REQUIREMENTS, "requirements.txt")
        .map_err(|_| "pip cannot install what its tests need".to_owned())?;
    if install(RAY, "requirements-ray.txt").is_err() {
        println!("== python: pip cannot install Ray; its tests are skipped");
    }
    if install(NOTEBOOKS, "requirements-notebooks.txt").is_err() {
        println!("== python: pip cannot install nbclient and anywidget; the notebooks are not executed");
    }
    Ok(())
}

/// Installs what a file of requirements names, unless that was done before.
fn install(requirements: &str, record: &str) -> io::Result<()> {
    let installed = environment().join(record);
    let wanted = fs::read(root().join(PACKAGE).join(requirements))?;
    if fs::read(&installed).is_ok_and(|found| found == wanted) {
        return Ok(());
    }
    println!("== python: pip install -r {requirements}");
    // Most of what is installed is never imported; Python compiles the rest when it is.
    let quietly = ["--quiet", "--disable-pip-version-check", "--retries=1", "--no-compile"];
    let install = [&["-m", "pip", "install"], &quietly[..], &["-r", requirements]].concat();
    if !is_done(&mut interpreter(&install)) {
        return Err(io::Error::other("pip failed"));
    }
    // Says what is installed; without it the next run asks pip again.
    fs::write(&installed, wanted)
}

/// The interpreter that has the package, where [`python`] has made it.
pub(crate) fn with_package() -> Option<Command> {
    program().is_file().then(|| interpreter(&[]))
}

/// Python of the environment, in the folder of the package. What it compiles is kept in the build folder, and not beside the sources.
fn interpreter(words: &[&str]) -> Command {
    let mut command = Command::new(program());
    command.args(words).current_dir(root().join(PACKAGE)).env("PYTHONPATH", site());
    command
        .env_remove("PYTHONDONTWRITEBYTECODE")
        .env("PYTHONPYCACHEPREFIX", target().join("python/bytecode"));
    command.env("MPLBACKEND", "Agg").env("NO_COLOR", "1");
    command
}

fn program() -> PathBuf {
    environment().join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" })
}

fn environment() -> PathBuf {
    target().join("python/environment")
}

/// Where Python finds the package.
fn site() -> PathBuf {
    target().join("python/site")
}

fn is_done(command: &mut Command) -> bool {
    command.stdin(Stdio::null()).status().is_ok_and(|status| status.success())
}
