//! The command line.

use coface::Error;
use std::path::PathBuf;

pub(crate) const USAGE: &str = "usage:
  coface-bench list
  coface-bench write INPUT FILE                write an input; FILE ends in .raw, .obj, .off, .ply or .npy
  coface-bench run [TASK[@INPUT]]...           measure tasks, all of them when none is named
  coface-bench compare TASK INPUT --peer LABEL=COMMAND...
                                               measure a task beside other programs, in turns; {} in COMMAND is the
                                               input file (else it is added at the end); a program that prints a JSON
                                               line with seconds, peak_mb and result is taken at its word
options:
  --runs N       runs of each row, the median counts (default 5)
  --threads N    threads that coface may use (default: all)
  --json FILE    also append one JSON line a row to FILE";

/// What to do.
#[derive(Debug, PartialEq)]
pub(crate) enum Verb {
    List,
    Write { input: String, path: PathBuf },
    Sample { task: String, path: PathBuf },
    Run { names: Vec<String> },
    Compare { task: String, input: String, peers: Vec<Peer> },
}

/// Another program for the same task.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Peer {
    pub(crate) label: String,
    pub(crate) command: Vec<String>,
}

/// The verb and its options.
#[derive(Debug, PartialEq)]
pub(crate) struct Arguments {
    pub(crate) verb: Verb,
    pub(crate) runs: usize,
    pub(crate) threads: Option<usize>,
    pub(crate) json: Option<PathBuf>,
}

impl Arguments {
    /// # Errors
    /// If the words make no command.
    pub(crate) fn parse(words: impl IntoIterator<Item = String>) -> Result<Self, Error> {
        let (mut plain, mut peers) = (Vec::new(), Vec::new());
        let (mut runs, mut threads, mut json) = (5, None, None);
        let mut words = words.into_iter();
        while let Some(word) = words.next() {
            let mut value = || words.next().ok_or_else(|| wrong(&format!("{word} needs a value")));
            match word.as_str() {
                "--runs" => runs = positive(&value()?)?,
                "--threads" => threads = Some(positive(&value()?)?),
                "--json" => json = Some(PathBuf::from(value()?)),
                "--peer" => peers.push(Peer::parse(&value()?)?),
                "-h" | "--help" => plain.push("list".to_owned()),
                _ if word.starts_with("--") => return Err(wrong(&format!("{word} is no option"))),
                _ => plain.push(word),
            }
        }
        let words: Vec<&str> = plain.iter().map(String::as_str).collect();
        let verb = match words[..] {
            ["list"] => Verb::List,
            ["write", input, path] => Verb::Write { input: input.to_owned(), path: path.into() },
            ["sample", task, path] => Verb::Sample { task: task.to_owned(), path: path.into() },
            ["compare", task, input] => {
                Verb::Compare { task: task.to_owned(), input: input.to_owned(), peers: peers.clone() }
            }
            ["list" | "write" | "sample" | "compare", ..] => {
                return Err(wrong("the words do not fit the verb"));
            }
            ["run", ref names @ ..] | ref names => {
                Verb::Run { names: names.iter().map(|&name| name.to_owned()).collect() }
            }
        };
        if !peers.is_empty() && !matches!(verb, Verb::Compare { .. }) {
            return Err(wrong("--peer belongs to compare"));
        }
        Ok(Self { verb, runs, threads, json })
    }
}

impl Peer {
    fn parse(text: &str) -> Result<Self, Error> {
        let (label, command) = text.split_once('=').ok_or_else(|| wrong("--peer is LABEL=COMMAND"))?;
        let command: Vec<String> = command.split_whitespace().map(str::to_owned).collect();
        if command.is_empty() {
            return Err(wrong("the peer's command is empty"));
        }
        Ok(Self { label: label.trim().to_owned(), command })
    }
}

fn positive(text: &str) -> Result<usize, Error> {
    text.parse().ok().filter(|&n| n > 0).ok_or_else(|| wrong(&format!("{text:?} is no positive number")))
}

fn wrong(message: &str) -> Error {
    Error::invalid(message).with_cure("see `coface-bench list`")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &[&str]) -> Result<Arguments, Error> {
        Arguments::parse(text.iter().map(|&word| word.to_owned()))
    }

    #[test]
    fn tasks_may_stand_without_a_verb() {
        let arguments = parse(&["homology@t3_8", "--runs", "3"]).unwrap();
        assert_eq!(arguments.verb, Verb::Run { names: vec!["homology@t3_8".to_owned()] });
        assert_eq!(arguments.runs, 3);
        assert_eq!(parse(&[]).unwrap().verb, Verb::Run { names: vec![] });
    }

    #[test]
    fn a_peer_has_a_label_and_a_command() {
        let arguments = parse(&["compare", "homology", "t3_8", "--peer", "other 1.2=prog -x {}"]).unwrap();
        let Verb::Compare { peers, .. } = arguments.verb else { panic!("a comparison") };
        assert_eq!(peers[0].label, "other 1.2");
        assert_eq!(peers[0].command, ["prog", "-x", "{}"]);
    }

    #[test]
    fn wrong_words_are_refused() {
        for words in [
            &["write", "ico3"][..],
            &["--runs"],
            &["--runs", "0"],
            &["run", "--peer", "a=b"],
            &["compare", "a", "b", "--peer", "ab"],
            &["--nothing"],
        ] {
            assert!(parse(words).is_err(), "{words:?}");
        }
    }
}
