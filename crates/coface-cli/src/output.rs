//! Where results go: standard output, or a file that appears whole or not at all.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::remarks::object;
use coface::algebra::escaped;
use coface::io::{Format, replace_file};
use serde::Serialize;
use std::borrow::Cow;
use std::io::{self, BufWriter, Write};
use std::path::Path;

/// Whether a file is a page for browsers by its name.
pub(crate) fn is_html(path: &Path) -> bool {
    path.extension().is_some_and(|extension| {
        extension.eq_ignore_ascii_case("html") || extension.eq_ignore_ascii_case("htm")
    })
}

/// Refuses to write a page into a file whose extension is that of something else.
pub(crate) fn check_page(path: &Path) -> Result<(), Failure> {
    match path.extension() {
        Some(extension) if !is_html(path) => Err(Failure::new(format!(
            "{}: a page for browsers is written here, and the extension \"{}\" is of something else; end the name in .html",
            path.display(),
            extension.display()
        ))),
        _ => Ok(()),
    }
}

/// Prints one answer as a JSON object on standard output, with a line end.
pub(crate) fn print_json(answer: &(impl Serialize + ?Sized)) -> Result<(), Failure> {
    let text = object(answer);
    print_bytes(|out| {
        out.write_all(text.as_bytes())?;
        out.write_all(b"\n")
    })
}

/// Prints text on standard output; its colors are taken away when that is no terminal.
pub(crate) fn print_text(text: &str) -> Result<(), Failure> {
    let mut out = BufWriter::new(anstream::stdout().lock());
    out.write_all(text.as_bytes()).and_then(|()| out.flush()).map_err(|error| failed(&error))
}

/// Lets `write` write raw bytes to standard output.
pub(crate) fn print_bytes(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Failure> {
    let mut out = BufWriter::with_capacity(1 << 16, io::stdout().lock());
    write(&mut out).and_then(|()| out.flush()).map_err(|error| failed(&error))
}

/// Says something worth knowing on standard error; the caller sees to `--quiet`.
pub(crate) fn remark(text: &str) {
    let style = anstyle::AnsiColor::Yellow.on_default().bold();
    // A closed standard error leaves nobody to tell.
    let _ = writeln!(anstream::stderr(), "{style}remark:{style:#} {}", escaped(text));
}

fn failed(error: &io::Error) -> Failure {
    Failure::writing("standard output", error)
}

/// Ends the program with what the parser of the command line says: help and the version on standard output, wrong
/// usage on standard error. Words of the command line may be names of files, which stay in their line.
pub(crate) fn end_with(said: &clap::Error) -> ! {
    let mut text = said.render().ansi().to_string();
    for word in std::env::args().skip(1) {
        // An option and its value are one word or two.
        for part in [&word[..], word.split_once('=').map_or("", |(_, value)| value)] {
            if let Cow::Owned(shown) = escaped(part) {
                text = text.replace(part, &shown);
            }
        }
    }
    if said.use_stderr() {
        // A closed standard error leaves nobody to tell.
        let _ = anstream::stderr().write_all(text.as_bytes());
        std::process::exit(said.exit_code());
    }
    std::process::exit(match print_text(&text) {
        Ok(()) | Err(Failure::ClosedPipe) => said.exit_code(),
        Err(failure) => {
            failure.say();
            1
        }
    })
}

/// Writes these bytes to a file.
pub(crate) fn write_file(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    Ok(replace_file(path, |out| Ok(out.write_all(bytes)?))?)
}

/// Writes one JSON object to a file, with a line end.
pub(crate) fn write_json(path: &Path, answer: &(impl Serialize + ?Sized)) -> Result<(), Failure> {
    write_file(path, &json_bytes(answer))
}

/// One JSON object as a file has it, with a line end.
pub(crate) fn json_bytes(answer: &(impl Serialize + ?Sized)) -> Vec<u8> {
    (object(answer) + "\n").into_bytes()
}

/// Whether a file is one of JSON by its name.
pub(crate) fn is_json(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("json"))
}

/// Refuses the name of a file for text or JSON whose extension is that of models, tables or pictures.
pub(crate) fn check_text(path: &Path) -> Result<(), Failure> {
    const NO_MODELS: [&str; 7] = ["pdf", "gif", "webp", "html", "htm", "parquet", "arrow"];
    let Some(extension) = path.extension().and_then(|extension| extension.to_str()) else { return Ok(()) };
    let is_other = NO_MODELS.iter().any(|other| extension.eq_ignore_ascii_case(other))
        || Format::from_path(path).is_some_and(|format| format != Format::Json);
    match is_other {
        true => Err(Failure::new(format!(
            "{}: this answer is written as text or JSON; end the name in .txt or .json",
            path.display()
        ))),
        false => Ok(()),
    }
}

/// Gives an answer as the command line asks: to the file of -o, as the object or as the page without colors by its
/// extension; and on standard output as the object with --json, as the page if no file was named.
pub(crate) fn give(common: &Common, object: &(impl Serialize + ?Sized), page: &str) -> Result<(), Failure> {
    if let Some(path) = &common.output {
        match is_json(path) {
            true => write_json(path, object)?,
            false => {
                check_text(path)?;
                write_file(path, anstream::adapter::strip_str(page).to_string().as_bytes())?;
            }
        }
    }
    match (common.json, &common.output) {
        (true, _) => print_json(object),
        (false, Some(_)) => Ok(()),
        (false, None) => print_text(page),
    }
}

/// A long word without blanks as pages show it: its beginning, and how long it is.
pub(crate) fn beginning(word: &str) -> String {
    const SHOWN: usize = 72;
    if word.len() <= SHOWN {
        return word.to_owned();
    }
    let start: String = word.chars().take(SHOWN - 12).collect();
    format!("{start}.. ({} letters; --json has all)", word.chars().count())
}
