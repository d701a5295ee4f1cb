//! Differences between two records, key by key.

use super::run::Record;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fmt::Write;

/// A key that answers may have now though they had none before, and why.
const ADDED: &[(&str, &str)] = &[
    ("remarks", "every answer says what was assumed"),
    ("groups", "info lists the named parts of a file"),
    ("trees", "loops lists the trees of small complexes"),
];

/// One difference.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Difference {
    /// A fault: the answer is another one.
    Changed { run: String, key: String, old: String, new: String },
    /// Known and meant.
    Expected(&'static str),
    /// Worth a look, but no fault: wording, time limits.
    Note { run: String, text: String },
}

/// A run whose record is not in the folder.
pub(super) fn missing(run: &str) -> Vec<Difference> {
    vec![Difference::Note { run: run.to_owned(), text: "no record in the folder; not compared".to_owned() }]
}

/// What differs between the records of a run.
pub(super) fn compare(run: &str, old: &Record, new: &Record) -> Vec<Difference> {
    let note = |text: String| Difference::Note { run: run.to_owned(), text };
    if old.has_timed_out || new.has_timed_out {
        let which = match (old.has_timed_out, new.has_timed_out) {
            (true, true) => return Vec::new(),
            (true, false) => "before",
            _ => "now",
        };
        return vec![note(format!("took too long {which}; not compared"))];
    }
    let mut found = Vec::new();
    if old.status != new.status {
        let status = |record: &Record| format!("{:?} {}", record.status, first_line(&record.errors));
        found.push(Difference::Changed {
            run: run.to_owned(),
            key: "exit status".to_owned(),
            old: status(old),
            new: status(new),
        });
        return found;
    }
    values(run, "", &old.answer, &new.answer, &mut found);
    if old.errors != new.errors {
        let (before, now) = (old.errors.trim(), new.errors.trim());
        found.push(note(format!("standard error\n      - {}\n      + {}", shorten(before), shorten(now))));
    }
    found
}

fn values(run: &str, key: &str, old: &Value, new: &Value, found: &mut Vec<Difference>) {
    let text =
        |value: Option<&Value>| value.map_or_else(|| "(no such key)".to_owned(), |v| shorten(&v.to_string()));
    let change = |key: String, old: Option<&Value>, new: Option<&Value>| Difference::Changed {
        run: run.to_owned(),
        key,
        old: text(old),
        new: text(new),
    };
    match (old, new) {
        (Value::Object(before), Value::Object(now)) => {
            let mut keys: Vec<&String> = before.keys().chain(now.keys()).collect();
            keys.sort();
            keys.dedup();
            for name in keys {
                let path = if key.is_empty() { name.clone() } else { format!("{key}.{name}") };
                match (before.get(name), now.get(name)) {
                    (Some(a), Some(b)) => values(run, &path, a, b, found),
                    (None, Some(_)) if is_added(name).is_some() => {
                        found.extend(is_added(name).map(Difference::Expected));
                    }
                    (a, b) => found.push(change(path, a, b)),
                }
            }
        }
        (Value::Array(before), Value::Array(now)) if before.len() == now.len() => {
            for (i, (a, b)) in before.iter().zip(now).enumerate() {
                values(run, &format!("{key}[{i}]"), a, b, found);
            }
        }
        _ if old == new => {}
        _ => found.push(change(key.to_owned(), Some(old), Some(new))),
    }
}

fn is_added(name: &str) -> Option<&'static str> {
    ADDED.iter().find(|(key, _)| *key == name).map(|&(key, _)| key)
}

fn first_line(text: &str) -> String {
    shorten(text.lines().next().unwrap_or_default())
}

/// The beginning of a text, as much as stands in a line or two.
fn shorten(text: &str) -> String {
    const MOST: usize = 200;
    match text.char_indices().nth(MOST) {
        Some((end, _)) => format!("{} ..", &text[..end]),
        None => text.to_owned(),
    }
}

/// All differences of a comparison.
#[derive(Debug, Default)]
pub(super) struct Report {
    runs: usize,
    changed: Vec<(String, Vec<String>)>,
    notes: Vec<(String, String)>,
    expected: BTreeMap<&'static str, usize>,
}

impl Report {
    /// Adds what one run gave.
    pub(super) fn add(&mut self, differences: Vec<Difference>) {
        self.runs += 1;
        let mut lines = Vec::new();
        let mut name = String::new();
        for difference in differences {
            match difference {
                Difference::Changed { run, key, old, new } => {
                    name = run;
                    lines.push(format!("    {key}\n      - {old}\n      + {new}"));
                }
                Difference::Expected(key) => *self.expected.entry(key).or_default() += 1,
                Difference::Note { run, text } => self.notes.push((run, text)),
            }
        }
        if !lines.is_empty() {
            self.changed.push((name, lines));
        }
    }

    /// Whether no answer is another one.
    pub(super) fn is_clean(&self) -> bool {
        self.changed.is_empty()
    }

    /// The report: changed answers last, where they are seen.
    pub(super) fn to_text(&self) -> String {
        /// How many keys of one run are listed.
        const MOST_KEYS: usize = 12;
        let mut text = String::new();
        let mut notes = self.notes.clone();
        notes.sort();
        for (run, note) in &notes {
            let _ = writeln!(text, "note: {run}: {note}");
        }
        let mut changed = self.changed.clone();
        changed.sort();
        for (run, lines) in &changed {
            let _ = writeln!(text, "CHANGED {run}");
            for line in lines.iter().take(MOST_KEYS) {
                let _ = writeln!(text, "{line}");
            }
            if lines.len() > MOST_KEYS {
                let _ = writeln!(text, "    .. and {} keys more", lines.len() - MOST_KEYS);
            }
        }
        for (key, count) in &self.expected {
            let why = ADDED.iter().find(|(name, _)| name == key).map_or("", |(_, why)| why);
            let _ = writeln!(text, "expected: the key {key:?} was added {count} times ({why})");
        }
        let _ = writeln!(
            text,
            "{} runs, {} with changed answers, {} notes",
            self.runs,
            self.changed.len(),
            self.notes.len()
        );
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn record(status: i32, answer: Value, errors: &str) -> Record {
        Record { status: Some(status), has_timed_out: false, answer, errors: errors.to_owned() }
    }

    #[test]
    fn a_changed_key_is_named_by_its_path() {
        let old = record(0, json!({"homology": [{"betti": 1}, {"betti": 2}], "area": 1.0}), "");
        let new =
            record(0, json!({"homology": [{"betti": 1}, {"betti": 3}], "area": 1.0, "remarks": []}), "");
        assert_eq!(
            compare("info", &old, &new),
            [
                Difference::Changed {
                    run: "info".to_owned(),
                    key: "homology[1].betti".to_owned(),
                    old: "2".to_owned(),
                    new: "3".to_owned()
                },
                Difference::Expected("remarks"),
            ]
        );
    }

    #[test]
    fn a_key_that_goes_or_comes_is_a_change() {
        let old = record(0, json!({"genus": null, "remarks": []}), "");
        let new = record(0, json!({"gender": null}), "");
        let mut report = Report::default();
        report.add(compare("info", &old, &new));
        assert!(!report.is_clean());
        let text = report.to_text();
        for part in ["genus", "gender", "remarks", "(no such key)", "1 with changed answers"] {
            assert!(text.contains(part), "{part} in {text}");
        }
    }

    #[test]
    fn wording_is_a_note_and_status_a_change() {
        let old = record(1, Value::Null, "error: no such file");
        let mut report = Report::default();
        report.add(compare("info", &old, &record(1, Value::Null, "error: there is no such file")));
        assert!(report.is_clean());
        assert!(report.to_text().contains("note: info: standard error"));
        report.add(compare("info", &old, &record(0, json!({}), "")));
        assert!(!report.is_clean());
    }

    #[test]
    fn what_took_too_long_is_not_compared() {
        let old = Record { status: None, has_timed_out: true, answer: Value::Null, errors: String::new() };
        assert_eq!(compare("pi1", &old, &old), []);
        let found = compare("pi1", &old, &record(0, json!({}), ""));
        assert!(matches!(&found[..], [Difference::Note { text, .. }] if text.contains("before")));
    }
}
