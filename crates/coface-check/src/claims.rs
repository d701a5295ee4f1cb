//! What has been proved so far, and what has not been looked at.

use crate::{Fault, Verdict};
use serde_json::{Map, Value};

/// Claims of an answer.
#[derive(Debug)]
pub struct Claims<'a> {
    answer: &'a Value,
    proved: Vec<String>,
    known: Vec<String>,
    /// Places inside of the answer about which nothing is said.
    left: Vec<String>,
}

impl<'a> Claims<'a> {
    /// Nothing is proved yet.
    pub fn of(answer: &'a Value) -> Self {
        Self { answer, proved: Vec::new(), known: Vec::new(), left: Vec::new() }
    }

    /// A claim has been proved.
    pub fn prove(&mut self, claim: String) {
        self.proved.push(claim);
    }

    /// A value of the answer is what was found.
    pub fn equal(&mut self, key: &str, found: &Value) -> Result<(), Fault> {
        let said = &self.answer[key];
        if said != found {
            return Err(Fault::new("answer", format!("\"{key}\" is {found}, and the answer says {said}")));
        }
        self.know(&[key]);
        self.prove(format!("{key} = {found}"));
        Ok(())
    }

    /// These keys of the answer have been looked at.
    pub fn know(&mut self, keys: &[&str]) {
        self.known.extend(keys.iter().map(|key| (*key).to_owned()));
    }

    /// If something stands at a place inside of the answer, nothing is said about it.
    pub fn leave(&mut self, is_there: bool, place: &str) {
        if is_there && !self.left.iter().any(|left| left == place) {
            self.left.push(place.to_owned());
        }
    }

    /// What was proved, and what nothing is said about.
    pub fn verdict(self) -> Verdict {
        let mut rest = self.answer.as_object().cloned().unwrap_or_default();
        rest.extend(self.left.into_iter().map(|place| (place, Value::Bool(true))).collect::<Map<_, _>>());
        let known: Vec<&str> = self.known.iter().map(String::as_str).collect();
        Verdict::of(self.proved, &Value::Object(rest), &known)
    }
}

/// An object has no other keys than these.
pub fn keys(object: &Value, known: &[&str], what: &str) -> Result<(), Fault> {
    let fault = |message: String| Fault::new("answer", message);
    let object = object.as_object().ok_or_else(|| fault(format!("{what} is no object")))?;
    match object.keys().find(|key| !known.contains(&key.as_str())) {
        Some(key) => Err(fault(format!("{what} has the key {key:?}, of which nothing is known"))),
        None => Ok(()),
    }
}

/// A value of an object in the answer is what was found.
pub fn equal(object: &Value, key: &str, found: &Value, what: &str) -> Result<(), Fault> {
    let said = &object[key];
    match said == found {
        true => Ok(()),
        false => {
            Err(Fault::new("answer", format!("\"{key}\" of {what} is {found}, and the answer says {said}")))
        }
    }
}

/// A number of things, in words.
pub fn count(number: usize, one: &str, many: &str) -> String {
    format!("{number} {}", if number == 1 { one } else { many })
}

/// Vertices, edges and faces, in words.
pub fn cells([vertices, edges, faces]: [usize; 3]) -> String {
    let vertices = count(vertices, "vertex", "vertices");
    format!("{vertices}, {} and {}", count(edges, "edge", "edges"), count(faces, "face", "faces"))
}
