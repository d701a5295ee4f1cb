//! The remarks of a run: what the readers of its inputs assumed is said once, on standard error, and stands in front of
//! the remarks of the answer.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::output::remark;
use coface::algebra::escaped;
use coface::answers::answer::{Place, Remark, RemarkCode};
use serde::Serialize;
use serde_json::Value;
use std::borrow::Cow;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// A remark with the name of the input that it is about.
struct Read {
    name: String,
    remark: Remark,
    /// Whether the user has seen it.
    is_said: bool,
}

/// What the readers of this run assumed. A run of the program is one verb, whose inputs are read in several places.
static READ: Mutex<Vec<Read>> = Mutex::new(Vec::new());

fn read() -> MutexGuard<'static, Vec<Read>> {
    READ.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Takes the remarks of an input that was read; those that are known already are left out.
pub(crate) fn take(name: &str, remarks: &[Remark]) {
    let mut read = read();
    for one in remarks {
        if !read.iter().any(|known| known.name == name && known.remark == *one) {
            read.push(Read { name: name.to_owned(), remark: one.clone(), is_said: false });
        }
    }
}

/// Says what the readers assumed and nobody has said yet, unless `--quiet` is given.
pub(crate) fn say_read(common: &Common) {
    for known in read().iter_mut().filter(|known| !known.is_said) {
        known.is_said = true;
        if !common.quiet {
            remark(&format!("{}: {}", known.name, known.remark.message));
        }
    }
}

/// The page of the verb has these remarks: they are not said again.
pub(crate) fn are_on_the_page() {
    read().iter_mut().for_each(|known| known.is_said = true);
}

impl Read {
    /// Whether a remark of an answer with this code says the same; an answer about several inputs begins it with the name.
    fn is_said_by(&self, code: RemarkCode, message: &str) -> bool {
        let unnamed =
            message.strip_prefix(&self.name).and_then(|rest| rest.strip_prefix(": ")).unwrap_or(message);
        self.remark.code == code && self.remark.message == unnamed
    }
}

/// Prints the remarks of an answer on standard error, unless `--quiet` is given; those that a reader left are said once.
pub(crate) fn say_remarks(remarks: &[Remark], common: &Common) {
    let is_read = |said: &Remark| read().iter().any(|known| known.is_said_by(said.code, &said.message));
    if !common.quiet {
        remarks.iter().filter(|said| !is_read(said)).for_each(|said| remark(&said.message));
    }
}

/// Refuses the first assumption among the remarks of an answer with `--strict`; to be asked before anything is written.
///
/// Rings that cross themselves and polygons that are not flat are left to the request: it knows whether the file or an option
/// said what becomes of them, and then nothing is assumed.
pub(crate) fn accept(remarks: &[Remark], common: &Common) -> Result<(), Failure> {
    let is_decided = |code| matches!(code, RemarkCode::SelfCrossingRing | RemarkCode::FacesSplit);
    let is_assumed = |remark: &&Remark| remark.code.is_assumption() && !is_decided(remark.code);
    match remarks.iter().find(|remark| common.strict && is_assumed(remark)) {
        Some(remark) => Err(Failure::new(format!(
            "{}; --strict refuses what is assumed: leave it out, or correct the input",
            remark.message
        ))),
        None => Ok(()),
    }
}

/// An answer as a JSON object: what the readers assumed is in front of its own remarks.
pub(crate) fn object(answer: &(impl Serialize + ?Sized)) -> String {
    let mut object = serde_json::to_value(answer).expect("answers have texts as keys");
    if let Some(Value::Array(own)) = object.get_mut("remarks") {
        let own_remarks: Vec<Remark> =
            own.iter().filter_map(|one| serde_json::from_value(one.clone()).ok()).collect();
        let mut all = read_remarks(&own_remarks);
        all.append(own);
        *own = all;
    }
    of_harmless_characters(object.to_string())
}

/// The same JSON with escapes for the characters that a terminal takes for orders, and that JSON lets stand as they
/// are.
fn of_harmless_characters(json: String) -> String {
    if let Cow::Borrowed(_) = escaped(&json) {
        return json;
    }
    let mut whole = String::with_capacity(json.len() + 16);
    for character in json.chars() {
        match escaped(character.encode_utf8(&mut [0; 4])) {
            Cow::Owned(_) => whole += &format!("\\u{:04x}", u32::from(character)),
            Cow::Borrowed(same) => whole.push_str(same),
        }
    }
    whole
}

/// The remarks of readers that the answer does not have itself; of several inputs each names its own.
fn read_remarks(own: &[Remark]) -> Vec<Value> {
    let read = read();
    let is_one = read.iter().all(|known| known.name == read[0].name);
    let named = |known: &Read| {
        let mut remark = known.remark.clone();
        if !is_one {
            if remark.places.is_empty() {
                remark.places.push(Place::default());
            }
            for place in &mut remark.places {
                place.file.get_or_insert_with(|| known.name.clone());
            }
        }
        serde_json::to_value(&remark).expect("remarks have texts as keys")
    };
    let is_own = |known: &&Read| own.iter().any(|own| known.is_said_by(own.code, &own.message));
    read.iter().filter(|known| !is_own(known)).map(named).collect()
}
