//! The commands of a chapter: run in order in a folder of their own, and compared with what the page says that they print.
//!
//! - A block of the language `console` has lines `$ coface ..`, `$ cat FILE` or `$ head FILE`, each followed by its output: what goes to
//!   standard output, then what goes to standard error. `> FILE` at the end of a command keeps its output in a file.
//! - `console,lines=1-4+9` shows these lines of each output, and `...` for each gap; `lines=0` shows none. `console,fails` is for commands that
//!   end with an exit status other than 0.
//! - A block with `file=NAME` in its first line is written to that file.
//! - The folder has `data/` of the repository, and an empty folder `pictures/`: what commands draw there is kept in `docs/book/src/pictures`.

use super::{Chapter, keep, source};
use crate::root;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

/// Runs the commands of a chapter. The faults are differences, or with `is_written` what cannot be run.
pub(super) fn run(chapter: &Chapter, program: &Path, is_written: bool) -> Vec<String> {
    let folder = env::temp_dir().join(format!("coface-book-{}-{}", std::process::id(), chapter.name));
    let mut faults = Vec::new();
    match prepare(&folder) {
        Err(error) => faults.push(format!("{}: {error}", folder.display())),
        Ok(()) => {
            let text = replayed(chapter, program, &folder, &mut faults);
            if text != chapter.text {
                let path = source().join(format!("{}.md", chapter.name));
                if is_written {
                    faults.extend(keep(&path, &text, true));
                } else {
                    faults.push(difference(chapter, &text));
                }
            }
            faults.extend(pictures(&folder.join("pictures"), is_written));
        }
    }
    // A folder that cannot be removed is left to the system.
    let _ = fs::remove_dir_all(&folder);
    faults
}

fn prepare(folder: &Path) -> std::io::Result<()> {
    fs::create_dir_all(folder.join("pictures"))?;
    fs::create_dir_all(folder.join("data"))?;
    for entry in fs::read_dir(root().join("data"))? {
        let path = entry?.path();
        if path.is_file() {
            fs::copy(&path, folder.join("data").join(path.file_name().unwrap_or_default()))?;
        }
    }
    Ok(())
}

/// The first line in which the page differs from what its commands print.
fn difference(chapter: &Chapter, text: &str) -> String {
    let mut lines = chapter.text.lines().zip(text.lines()).enumerate();
    let place = lines.find(|(_, (said, done))| said != done);
    match place {
        Some((i, (said, done))) => format!(
            "{}.md:{}: the page and the program differ: cargo xtask book --write\n  page     {said}\n  program  {done}",
            chapter.name,
            i + 1
        ),
        None => format!("{}.md: the output of the last command differs in length", chapter.name),
    }
}

/// The text of the chapter with the outputs that its commands have now.
fn replayed(chapter: &Chapter, program: &Path, folder: &Path, faults: &mut Vec<String>) -> String {
    let mut text = String::new();
    let mut lines = chapter.text.lines().enumerate().peekable();
    while let Some((i, line)) = lines.next() {
        text.push_str(line);
        text.push('\n');
        let Some(info) = line.strip_prefix("```").filter(|info| !info.is_empty()) else { continue };
        let words: Vec<&str> = info.split([',', ' ']).collect();
        let mut body = Vec::new();
        for (_, line) in lines.by_ref() {
            if line == "```" {
                break;
            }
            body.push(line);
        }
        if let Some(name) = words.iter().find_map(|word| word.strip_prefix("file="))
            && let Err(error) = fs::write(folder.join(name), body.join("\n") + "\n")
        {
            faults.push(format!("{}.md:{}: {name}: {error}", chapter.name, i + 1));
        }
        if words[0] == "console" {
            let shown = words.iter().find_map(|word| word.strip_prefix("lines="));
            let fails = words.contains(&"fails");
            for command in body.iter().filter_map(|line| line.strip_prefix("$ ")) {
                text.push_str(&format!("$ {command}\n"));
                match output(command, program, folder) {
                    Err(why) => faults.push(format!("{}.md:{}: {command}: {why}", chapter.name, i + 1)),
                    Ok((is_done, said)) => {
                        if is_done == fails {
                            faults.push(format!(
                                "{}.md:{}: {command} ended otherwise than the page says:\n{said}",
                                chapter.name,
                                i + 1
                            ));
                        }
                        text.push_str(&excerpt(&said, shown));
                    }
                }
            }
        } else {
            for line in body {
                text.push_str(line);
                text.push('\n');
            }
        }
        text.push_str("```\n");
    }
    text
}

/// What a command prints, and whether it succeeds.
fn output(command: &str, program: &Path, folder: &Path) -> Result<(bool, String), String> {
    let mut words = split(command);
    let target = match words.iter().position(|word| word == ">") {
        Some(at) if at + 2 == words.len() => {
            let target = words.pop();
            words.pop();
            target
        }
        Some(_) => return Err("a file has to follow the last >".to_owned()),
        None => None,
    };
    let (is_done, out, errors) = match words.first().map(String::as_str) {
        Some("coface") => {
            let run = Command::new(program)
                .args(&words[1..])
                .current_dir(folder)
                .env("NO_COLOR", "1")
                .stdin(Stdio::null())
                .output()
                .map_err(|error| error.to_string())?;
            let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
            (run.status.success(), text(&run.stdout), text(&run.stderr))
        }
        Some("cat") if words.len() == 2 => {
            let text = fs::read_to_string(folder.join(&words[1])).map_err(|error| error.to_string())?;
            (true, text, String::new())
        }
        _ => return Err("only coface and cat are run".to_owned()),
    };
    match target {
        None => Ok((is_done, out + &errors)),
        Some(file) => {
            fs::write(folder.join(&file), out).map_err(|error| format!("{file}: {error}"))?;
            Ok((is_done, errors))
        }
    }
}

/// The words of a command, as a shell has them: quotes keep spaces.
fn split(command: &str) -> Vec<String> {
    let mut words = Vec::new();
    let mut word = String::new();
    let mut quote = None;
    let mut has_word = false;
    for c in command.chars() {
        match (quote, c) {
            (Some(open), c) if c == open => quote = None,
            (Some(_), c) => word.push(c),
            (None, '"' | '\'') => (quote, has_word) = (Some(c), true),
            (None, ' ') => {
                if has_word {
                    words.push(std::mem::take(&mut word));
                }
                has_word = false;
            }
            (None, c) => {
                word.push(c);
                has_word = true;
            }
        }
    }
    if has_word {
        words.push(word);
    }
    words
}

/// The lines of an output that are shown, as in `1-4+9`.
fn excerpt(said: &str, shown: Option<&str>) -> String {
    let lines: Vec<&str> = said.lines().map(str::trim_end).collect();
    let Some(shown) = shown else { return lines.iter().map(|line| format!("{line}\n")).collect() };
    if shown == "0" || lines.is_empty() {
        return String::new();
    }
    let mut text = String::new();
    let mut next = 0;
    for range in shown.split('+') {
        let (first, last) = range.split_once('-').unwrap_or((range, range));
        let first = first.parse::<usize>().unwrap_or(1).max(1) - 1;
        let last = last.parse::<usize>().unwrap_or(lines.len()).min(lines.len());
        if first > next {
            text.push_str("...\n");
        }
        for line in lines.get(first..last).unwrap_or_default() {
            // Long lines of answers in JSON are cut.
            let short: String = line.chars().take(150).collect();
            text.push_str(&short);
            text.push_str(if short.len() < line.len() { " ...\n" } else { "\n" });
        }
        next = last;
    }
    if next < lines.len() {
        text.push_str("...\n");
    }
    text
}

/// Compares what was drawn with the pictures of the book, or keeps it.
fn pictures(made: &Path, is_written: bool) -> Vec<String> {
    let mut faults = Vec::new();
    let Ok(entries) = fs::read_dir(made) else { return faults };
    let mut paths: Vec<PathBuf> = entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
    paths.sort();
    for path in paths {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let kept = source().join("pictures").join(&name);
        let (new, old) = (fs::read(&path).unwrap_or_default(), fs::read(&kept).unwrap_or_default());
        if new.len() > 400_000 {
            faults.push(format!("pictures/{name} has {} bytes; draw it smaller", new.len()));
        }
        if is_alike(&new, &old) {
            continue;
        }
        if !is_written {
            faults.push(format!("pictures/{name} is not what its command draws: cargo xtask book --write"));
        } else if let Err(error) =
            fs::create_dir_all(source().join("pictures")).and_then(|()| fs::write(&kept, new))
        {
            faults.push(format!("pictures/{name}: {error}"));
        }
    }
    faults
}

/// Whether two pictures show the same: SVG with numbers that are near, PNG of the same size that is compressed to about the same length, since
/// the last bits of sines differ between systems.
fn is_alike(new: &[u8], old: &[u8]) -> bool {
    if new == old {
        return true;
    }
    if new.starts_with(b"\x89PNG") {
        let is_near = new.len().abs_diff(old.len()) * 50 < new.len();
        return old.len() > 24 && new.len() > 24 && new[16..24] == old[16..24] && is_near;
    }
    let is_digit = |c: char| c.is_ascii_digit() || c == '.' || c == '-';
    let parts = |bytes: &[u8]| {
        let text = String::from_utf8_lossy(bytes).into_owned();
        let numbers: Vec<f64> = text.split(|c| !is_digit(c)).filter_map(|word| word.parse().ok()).collect();
        let rest: String = text.split(is_digit).collect();
        (numbers, rest)
    };
    let ((new, new_rest), (old, old_rest)) = (parts(new), parts(old));
    new_rest == old_rest && new.len() == old.len() && new.iter().zip(&old).all(|(a, b)| (a - b).abs() < 0.2)
}

#[cfg(test)]
mod tests {
    use super::{excerpt, split};

    #[test]
    fn quotes_keep_spaces() {
        assert_eq!(
            split("coface link a.json --simplices \"0 1; 3\""),
            ["coface", "link", "a.json", "--simplices", "0 1; 3"]
        );
        assert_eq!(split("coface info ''"), ["coface", "info", ""]);
    }

    #[test]
    fn gaps_are_marked() {
        assert_eq!(excerpt("a\nb\nc\nd\n", Some("1+3")), "a\n...\nc\n...\n");
        assert_eq!(excerpt("a\nb\n", Some("1-2")), "a\nb\n");
        assert_eq!(excerpt("a\nb\n", None), "a\nb\n");
        assert_eq!(excerpt("a\n", Some("0")), "");
    }
}
