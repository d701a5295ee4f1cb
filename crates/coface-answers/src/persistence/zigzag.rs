//! Zigzag persistence of files of steps, and of simplices with the times at which they are there.

use super::PersistenceRequest;
use super::certificate::{Certificate, Proof, chains, entering};
use crate::answer::{PersistenceAnswer, PersistencePairAnswer};
use crate::homology::certificate::{checked, refused};
use coface_algebra::progress::stage;
use coface_algebra::{Error, VertexId};
use coface_complexes::simplicial::Simplex;
use coface_topology::{Coefficients, ZigzagFiltration, ZigzagPair, ZigzagStep};
use serde_json::Value;
use std::collections::BTreeSet;

/// A zigzag that a user gives.
///
/// # Examples
/// The steps of a file as `fzz` has them: an edge comes and goes.
/// ```
/// use coface_answers::{GivenZigzag, PersistenceRequest};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let zigzag = GivenZigzag::read("edge.txt", b"i 0\ni 1\ni 0 1\nd 0 1\n")?;
/// let answer = PersistenceRequest::new().zigzag(&zigzag)?;
/// let part = &answer.diagram[1];
/// assert_eq!((part.birth, part.death, part.kind.as_deref()), (2.0, Some(3.0), Some("closed-open")));
/// let part = &answer.diagram[2];
/// assert_eq!((part.birth, part.death, part.kind.as_deref()), (4.0, None, Some("open-open")));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct GivenZigzag {
    name: String,
    filtration: ZigzagFiltration,
}

/// How files are to be.
const FORMS: &str = "give lines \"i 0 1\" where a simplex enters and \"d 0 1\" where it leaves, with times as \"i 0 1 @ 2.5\"; or JSON: [[\"i\",[0,1],2.5],..], or \
                     {\"simplices\":[[0,1],..],\"times\":[[enters,leaves,..],..]}";

fn no_zigzag(message: impl Into<String>) -> Error {
    Error::parse(message).with_cure(FORMS)
}

impl GivenZigzag {
    /// The zigzag in a file of this name: lines `i 0 1` (a simplex enters) and `d 0 1` (it leaves), as `fzz` has them, whose times are their numbers from 1 on, or
    /// stand behind them: `i 0 1 @ 2.5`; what follows `#` is left out. Or JSON: the steps `[["i",[0,1],2.5],..]`, or [simplices with their times](Self::of_stays)
    /// as `{"simplices":[..],"times":[..]}`.
    ///
    /// # Errors
    /// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) with the file and the line for what is no zigzag, and those of [`ZigzagFiltration::push`].
    ///
    /// # Examples
    /// See [`GivenZigzag`].
    pub fn read(name: &str, bytes: &[u8]) -> Result<Self, Error> {
        let start = bytes.trim_ascii_start();
        let filtration = match start.first() {
            Some(b'{' | b'[') => of_json(bytes),
            _ => of_text(bytes),
        };
        let filtration = filtration.map_err(|error| error.in_file(name))?;
        Ok(Self { name: name.to_owned(), filtration })
    }

    /// The zigzag of these steps.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::GivenZigzag;
    /// use coface_topology::ZigzagFiltration;
    /// assert!(GivenZigzag::new("nothing", ZigzagFiltration::default()).filtration().steps().is_empty());
    /// ```
    pub fn new(name: &str, filtration: ZigzagFiltration) -> Self {
        Self { name: name.to_owned(), filtration }
    }

    /// The zigzag of steps as a file has them: `"i"` or `"d"`, a simplex, and a time for all or for none.
    ///
    /// # Errors
    /// As of [`Self::read`], naming the step counted from 1.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::GivenZigzag;
    /// let steps = [("i".to_owned(), vec![0], None), ("d".to_owned(), vec![0], None)];
    /// assert_eq!(GivenZigzag::of_steps("point", steps).expect("steps").filtration().steps().len(), 2);
    /// ```
    pub fn of_steps(
        name: &str,
        steps: impl IntoIterator<Item = (String, Vec<u32>, Option<f64>)>,
    ) -> Result<Self, Error> {
        let filtration = of_steps(steps).map_err(|error| error.in_file(name))?;
        Ok(Self { name: name.to_owned(), filtration })
    }

    /// The zigzag of simplices with the times at which each enters, leaves, enters again, and so on, as Dionysus takes them; an infinite time says that it stays. At
    /// one time simplices enter first, by rising dimension, then others leave, by falling dimension.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if there are not as many lists of times as simplices, or times of a simplex fall or
    /// are no numbers; and those of [`ZigzagFiltration::push`].
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{GivenZigzag, PersistenceRequest};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let (simplices, times) = ([vec![0], vec![1], vec![0, 1]], [vec![0.0], vec![1.0, 8.0], vec![2.0, 5.0]]);
    /// let zigzag = GivenZigzag::of_stays("edge", &simplices, &times)?;
    /// let answer = PersistenceRequest::new().zigzag(&zigzag)?;
    /// let part = &answer.diagram[2];
    /// // Behind 5 the second point is a component again, up to 8 itself.
    /// assert_eq!((part.birth, part.death, part.kind.as_deref()), (5.0, Some(8.0), Some("open-closed")));
    /// # Ok(()) }
    /// ```
    pub fn of_stays(name: &str, simplices: &[Vec<u32>], times: &[Vec<f64>]) -> Result<Self, Error> {
        let filtration = of_stays(simplices, times).map_err(|error| error.in_file(name))?;
        Ok(Self { name: name.to_owned(), filtration })
    }

    /// The steps.
    ///
    /// # Examples
    /// See [`Self::new`].
    pub fn filtration(&self) -> &ZigzagFiltration {
        &self.filtration
    }
}

fn of_text(bytes: &[u8]) -> Result<ZigzagFiltration, Error> {
    let text = std::str::from_utf8(bytes).map_err(|_| no_zigzag("the file is no text"))?;
    let mut given = Steps::default();
    for (line, content) in text.lines().enumerate() {
        let content = content.split('#').next().unwrap_or_default().trim();
        if content.is_empty() {
            continue;
        }
        let mut push = || {
            let (content, time) = match content.split_once('@') {
                Some((content, time)) => {
                    let time = time.trim();
                    let number = time.parse().map_err(|_| no_zigzag(format!("{time:?} is no time")))?;
                    (content, Some(number))
                }
                None => (content, None),
            };
            let mut words = content.split_whitespace();
            let is_insertion = is_insertion(words.next().unwrap_or_default())?;
            let vertex = |word: &str| {
                word.parse()
                    .map_err(|_| no_zigzag(format!("{word:?} is no vertex: vertices are numbers from 0 on")))
            };
            let simplex = words.map(vertex).collect::<Result<Vec<u32>, Error>>()?;
            given.add(is_insertion, &simplex, time)
        };
        push().map_err(|error| error.at_line(line as u64 + 1))?;
    }
    Ok(given.filtration)
}

fn is_insertion(word: &str) -> Result<bool, Error> {
    match word {
        "i" => Ok(true),
        "d" => Ok(false),
        _ => Err(no_zigzag(format!("a step begins with {word:?}"))),
    }
}

/// Steps that are given one after the other.
#[derive(Default)]
struct Steps {
    filtration: ZigzagFiltration,
    has_times: Option<bool>,
    /// What has left at the time of the last step.
    left: BTreeSet<Simplex>,
}

impl Steps {
    /// Adds a step; those without a time have the numbers 1, 2, ..
    fn add(&mut self, is_insertion: bool, simplex: &[u32], time: Option<f64>) -> Result<(), Error> {
        if *self.has_times.get_or_insert(time.is_some()) != time.is_some() {
            return Err(Error::invalid("some steps have times and some have none")
                .with_cure("give a time for each step, or for none"));
        }
        let last = self.filtration.steps().last().map(ZigzagStep::time);
        let time = time.unwrap_or(self.filtration.steps().len() as f64 + 1.0);
        if last != Some(time) {
            self.left.clear();
        }
        let simplex = Simplex::from_numbers(simplex)?;
        if is_insertion && self.left.contains(&simplex) {
            // It would be there twice at that time.
            let message = format!("the simplex {simplex} enters at {time}, the time at which it leaves");
            return Err(
                Error::invalid(message).with_cure("leave both steps out, or give them different times")
            );
        }
        if !is_insertion {
            self.left.insert(simplex.clone());
        }
        self.filtration.push(match is_insertion {
            true => ZigzagStep::insertion(simplex, time),
            false => ZigzagStep::deletion(simplex, time),
        })
    }
}

fn of_json(bytes: &[u8]) -> Result<ZigzagFiltration, Error> {
    let value: Value = serde_json::from_slice(bytes).map_err(|error| no_zigzag(error.to_string()))?;
    if let Value::Object(object) = &value {
        let list = |key: &str| {
            let list = object.get(key).and_then(Value::as_array);
            list.ok_or_else(|| no_zigzag(format!("the object has no list {key:?}")))
        };
        let simplices = list("simplices")?.iter().map(numbers).collect::<Result<Vec<_>, Error>>()?;
        let times = list("times")?.iter().map(|times| {
            let times = times.as_array().ok_or_else(|| no_zigzag(format!("{times} is no list of times")))?;
            times.iter().map(time_of).collect::<Result<Vec<f64>, Error>>()
        });
        return of_stays(&simplices, &times.collect::<Result<Vec<_>, Error>>()?);
    }
    let step = |(place, step): (usize, &Value)| {
        let wrong = || no_zigzag(format!("step {}: {step} is no step", place + 1));
        let (word, simplex, time) = match step.as_array().map_or(&[][..], Vec::as_slice) {
            [word, simplex] => (word, simplex, None),
            [word, simplex, time] => (word, simplex, Some(time_of(time)?)),
            _ => return Err(wrong()),
        };
        Ok((word.as_str().ok_or_else(wrong)?.to_owned(), numbers(simplex)?, time))
    };
    let steps =
        value.as_array().into_iter().flatten().enumerate().map(step).collect::<Result<Vec<_>, Error>>()?;
    of_steps(steps)
}

/// Steps with `"i"` or `"d"`.
fn of_steps(
    steps: impl IntoIterator<Item = (String, Vec<u32>, Option<f64>)>,
) -> Result<ZigzagFiltration, Error> {
    let mut given = Steps::default();
    for (place, (word, simplex, time)) in steps.into_iter().enumerate() {
        is_insertion(&word)
            .and_then(|is_insertion| given.add(is_insertion, &simplex, time))
            .map_err(|error| behind(&format!("step {}", place + 1), &error))?;
    }
    Ok(given.filtration)
}

fn numbers(simplex: &Value) -> Result<Vec<u32>, Error> {
    let wrong = || no_zigzag(format!("{simplex} is no simplex: vertices are numbers from 0 on"));
    let number =
        |vertex: &Value| vertex.as_u64().and_then(|vertex| u32::try_from(vertex).ok()).ok_or_else(wrong);
    simplex.as_array().ok_or_else(wrong)?.iter().map(number).collect()
}

/// A time; `null` stands for one that never comes, as numbers of JSON are finite.
fn time_of(value: &Value) -> Result<f64, Error> {
    match value {
        Value::Null => Ok(f64::INFINITY),
        _ => value.as_f64().ok_or_else(|| no_zigzag(format!("{value} is no time"))),
    }
}

/// The fault with the place before it.
fn behind(place: &str, error: &Error) -> Error {
    let message = format!("{place}: {}", error.message());
    Error::new(error.kind(), message).with_cure(error.cure().unwrap_or_default())
}

fn of_stays(simplices: &[Vec<u32>], times: &[Vec<f64>]) -> Result<ZigzagFiltration, Error> {
    if simplices.len() != times.len() {
        let message = format!("there are {} simplices and {} lists of times", simplices.len(), times.len());
        return Err(Error::invalid(message).with_cure("give a list of times for each simplex"));
    }
    let mut steps = Vec::new();
    for (numbers, times) in simplices.iter().zip(times) {
        let simplex = Simplex::from_numbers(numbers)?;
        if times.iter().any(|time| time.is_nan()) || times.windows(2).any(|two| two[0] > two[1]) {
            let message = format!("the times {times:?} of the simplex {simplex} do not rise");
            return Err(
                Error::invalid(message).with_cure("give the times at which it enters and leaves in turns")
            );
        }
        for (place, &time) in times.iter().enumerate().filter(|(_, time)| **time != f64::INFINITY) {
            steps.push(match place % 2 {
                0 => ZigzagStep::insertion(simplex.clone(), time),
                _ => ZigzagStep::deletion(simplex.clone(), time),
            });
        }
    }
    let rank = |step: &ZigzagStep| {
        let dimension = step.simplex().dimension() as i64;
        (!step.is_insertion(), if step.is_insertion() { dimension } else { -dimension })
    };
    steps.sort_by(|a, b| a.time().total_cmp(&b.time()).then_with(|| rank(a).cmp(&rank(b))));
    let mut filtration = ZigzagFiltration::default();
    for step in steps {
        let time = step.time();
        filtration.push(step).map_err(|error| behind(&format!("at the time {time}"), &error))?;
    }
    Ok(filtration)
}

impl PersistenceRequest {
    /// Finds the persistence of a zigzag: pairs have a kind, which says whether the class is there at the time of its birth and at that of its death.
    ///
    /// # Errors
    /// Those of [`ZigzagFiltration::persistence`].
    ///
    /// # Examples
    /// See [`GivenZigzag`].
    pub fn zigzag(&self, zigzag: &GivenZigzag) -> Result<PersistenceAnswer, Error> {
        let Coefficients::Modulo(prime) = self.coefficients else {
            return Err(Error::invalid("persistence has a prime field").with_cure("give f2, f3, f5, ..."));
        };
        let steps = stage("pairing steps", 0);
        let pairs = zigzag.filtration.persistence(self.coefficients)?;
        drop(steps);
        let steps = zigzag.filtration.steps();
        let top = steps.iter().map(|step| step.simplex().dimension() + 1).max().unwrap_or(0);
        let mut betti = vec![0; top];
        for pair in pairs.iter().filter(|pair| pair.death_step().is_none()) {
            betti[pair.degree()] += 1;
        }
        let cell = |step: usize| steps[step].simplex().vertices().map(VertexId::to_u32).collect();
        let answer = |pair: &ZigzagPair| PersistencePairAnswer {
            degree: pair.degree(),
            kind: Some(kind_name(pair).to_owned()),
            birth: pair.birth(),
            death: pair.death(),
            birth_cell: cell(pair.birth_step()),
            death_cell: pair.death_step().map(cell),
            cycle: None,
            bounding_chain: None,
            cocycle: None,
        };
        // A class that is there at one time alone has the length 0, and is there.
        let is_met = |pair: &ZigzagPair| pair.is_birth_closed() && pair.is_death_closed();
        let least = self.min_persistence;
        let is_long = |pair: &&ZigzagPair| pair.persistence() > least || least == 0.0 && is_met(pair);
        let long = pairs.iter().filter(is_long);
        Ok(PersistenceAnswer {
            file: zigzag.name.clone(),
            field: prime as u32,
            function: "zigzag".to_owned(),
            star: None,
            threshold: None,
            diagram: long.map(answer).collect(),
            betti,
            torsion_primes: None,
            collapsed: None,
            relative_to: None,
            image_of: None,
            vertex_names: None,
            remarks: Vec::new(),
        })
    }
}

impl PersistenceRequest {
    /// A certificate of [`Self::zigzag`], from the name and the bytes of the file that the zigzag was read from: chains of the cone that prove it, which
    /// [`coface_check_persistence::check`] follows without any code of this library, as `docs/certificates.md` says. It has been checked.
    ///
    /// # Errors
    /// Those of [`Self::zigzag`]; [`coface_algebra::ErrorKind::UnsupportedFormat`] if the checker does not read the file as this library does.
    ///
    /// # Complexity
    /// That of the cycles of all pairs of the cone.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{GivenZigzag, PersistenceRequest};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let input = &b"i 0\ni 1\ni 0 1\nd 0 1\n"[..];
    /// let zigzag = GivenZigzag::read("edge.txt", input)?;
    /// let certificate = PersistenceRequest::new().zigzag_certificate(&zigzag, &[("edge.txt", input)])?;
    /// let verdict = coface_check_persistence::check(certificate.as_bytes(), &[input]).expect("the proof holds");
    /// assert_eq!(verdict.proved()[1], "Betti numbers over F_2 at the end = [2, 0]");
    /// # Ok(()) }
    /// ```
    pub fn zigzag_certificate(
        &self,
        zigzag: &GivenZigzag,
        inputs: &[(&str, &[u8])],
    ) -> Result<String, Error> {
        let answer = self.zigzag(zigzag)?;
        let (cone, filtration) = zigzag.filtration.cone_filtration()?;
        let order: Vec<Vec<u32>> =
            (0..cone.degree_count()).map(|degree| entering(&filtration, degree)).collect();
        let chains = chains(&cone, &filtration, answer.field, &order, |_, cell| cell.to_u32())?;
        let proof = Proof { values: Vec::new(), order, chains, of_image: None };
        let certificate = Certificate::new("zigzag", inputs, self.min_persistence, &answer, proof);
        checked(&certificate, inputs).map_err(|fault| refused(&fault.to_string()))
    }
}

fn kind_name(pair: &ZigzagPair) -> &'static str {
    match (pair.is_birth_closed(), pair.is_death_closed()) {
        (true, true) => "closed-closed",
        (true, false) => "closed-open",
        (false, true) => "open-closed",
        (false, false) => "open-open",
    }
}
