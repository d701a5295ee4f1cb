//! Zigzag persistence: the classes of complexes that gain and lose simplices.

use crate::cone::{below, made};
use crate::{PAIR_KEYS, pairs, shown, sorted};
use coface_check::json::{field, index, list, optional, text};
use coface_check::{Complex, Fault, Verdict};
use serde_json::Value;
use std::collections::BTreeMap;

/// A step: a simplex enters or leaves at a time.
struct Step {
    is_insertion: bool,
    simplex: Vec<u32>,
    time: f64,
}

/// A stay of a simplex: the steps at which it enters and leaves.
#[derive(Clone, Copy)]
struct Stay {
    entrance: usize,
    exit: Option<usize>,
}

/// Most vertices of a simplex.
const MOST_VERTICES: usize = 64;

fn fault(message: impl Into<String>) -> Fault {
    Fault::new("input", message)
}

/// The steps of a file: lines `i 0 1` and `d 0 1`, with times behind `@` for all or for none, or JSON.
fn steps(input: &[u8]) -> Result<Vec<Step>, Fault> {
    let content = std::str::from_utf8(input).map_err(|_| fault("the file is no text"))?;
    let mut found = Vec::new();
    let mut has_times = None;
    let mut add = |word: &str, simplex: Vec<u32>, time: Option<f64>| {
        let is_insertion = match word {
            "i" => true,
            "d" => false,
            _ => return Err(fault("a step begins with neither i nor d")),
        };
        if *has_times.get_or_insert(time.is_some()) != time.is_some() {
            return Err(fault("some steps have times and some have none"));
        }
        let time = time.unwrap_or(found.len() as f64 + 1.0);
        found.push(Step { is_insertion, simplex: sorted(simplex), time });
        Ok(())
    };
    if content.trim_start().starts_with(['[', '{']) {
        let value: Value = serde_json::from_str(content).map_err(|error| fault(error.to_string()))?;
        if value.is_object() {
            return stays(&value);
        }
        for step in list(&value, "the steps", "input")? {
            match list(step, "a step", "input")? {
                [word, simplex] => add(text(word, "a step", "input")?, vertices(simplex)?, None)?,
                [word, simplex, time] => {
                    let time = time.as_f64().ok_or_else(|| fault("a time is no number"))?;
                    add(text(word, "a step", "input")?, vertices(simplex)?, Some(time))?;
                }
                _ => return Err(fault("a step is no list of two or three")),
            }
        }
        return Ok(found);
    }
    for line in content.lines() {
        let line = line.split('#').next().unwrap_or_default().trim();
        if line.is_empty() {
            continue;
        }
        let (line, time) = match line.split_once('@') {
            Some((line, time)) => {
                (line, Some(time.trim().parse().map_err(|_| fault("a time is no number"))?))
            }
            None => (line, None),
        };
        let mut words = line.split_whitespace();
        let word = words.next().unwrap_or_default();
        let simplex = words.map(|vertex| vertex.parse().map_err(|_| fault("a vertex is no number")));
        add(word, simplex.collect::<Result<_, Fault>>()?, time)?;
    }
    Ok(found)
}

fn vertices(simplex: &Value) -> Result<Vec<u32>, Fault> {
    list(simplex, "a simplex", "input")?.iter().map(|vertex| index(vertex, "a vertex", "input")).collect()
}

/// The steps of simplices with the times at which they enter and leave in turns. At one time simplices enter first, faces before cofaces, and then others leave.
fn stays(value: &Value) -> Result<Vec<Step>, Fault> {
    let simplices = list(field(value, "simplices", "input")?, "\"simplices\"", "input")?;
    let times = list(field(value, "times", "input")?, "\"times\"", "input")?;
    if simplices.len() != times.len() {
        return Err(fault("there is not a list of times for each simplex"));
    }
    let mut found = Vec::new();
    for (simplex, times) in simplices.iter().zip(times) {
        let simplex = sorted(vertices(simplex)?);
        let mut last = f64::NEG_INFINITY;
        for (place, time) in list(times, "times", "input")?.iter().enumerate() {
            // What never comes is null.
            let time = if time.is_null() { Some(f64::INFINITY) } else { time.as_f64() };
            let time = time.filter(|time| *time >= last).ok_or_else(|| fault("times do not rise"))?;
            last = time;
            if time.is_finite() {
                found.push(Step { is_insertion: place % 2 == 0, simplex: simplex.clone(), time });
            }
        }
    }
    let rank = |step: &Step| {
        let dimension = step.simplex.len() as i64;
        (!step.is_insertion, if step.is_insertion { dimension } else { -dimension })
    };
    found.sort_by(|a, b| (a.time + 0.0).total_cmp(&(b.time + 0.0)).then_with(|| rank(a).cmp(&rank(b))));
    Ok(found)
}

/// The complex whose cells are the stays of simplices, by degree in the order of their entrance.
fn complex(steps: &[Step]) -> Result<(Complex, Vec<Vec<Stay>>), Fault> {
    let mut stays: Vec<Vec<Stay>> = Vec::new();
    let mut columns: Vec<Vec<Vec<(u32, i64)>>> = Vec::new();
    // What is there: its number, and how many of its cofacets are there.
    let mut there: BTreeMap<&[u32], (u32, usize)> = BTreeMap::new();
    let facets = |simplex: &[u32]| -> Vec<Vec<u32>> {
        let facet = |left: usize| [&simplex[..left], &simplex[left + 1..]].concat();
        (0..simplex.len()).filter(|_| simplex.len() > 1).map(facet).collect()
    };
    let mut last = f64::NEG_INFINITY;
    for (number, step) in steps.iter().enumerate() {
        let simplex = &step.simplex[..];
        if simplex.is_empty()
            || simplex.len() > MOST_VERTICES
            || simplex.windows(2).any(|two| two[0] == two[1])
        {
            return Err(fault(format!("step {number} has no simplex")));
        }
        if !(step.time.is_finite() && step.time >= last) {
            return Err(fault(format!("the times do not rise at step {number}")));
        }
        last = step.time;
        let degree = simplex.len() - 1;
        if !step.is_insertion {
            let Some((cell, 0)) = there.remove(simplex) else {
                return Err(fault(format!("the simplex of step {number} cannot leave")));
            };
            for facet in facets(simplex) {
                let known = there.get_mut(&facet[..]).ok_or_else(|| fault("a face has left"))?;
                known.1 -= 1;
            }
            stays[degree][cell as usize].exit = Some(number);
            continue;
        }
        let mut column = Vec::new();
        for (place, facet) in facets(simplex).iter().enumerate() {
            let known = there.get_mut(&facet[..]);
            let known = known.ok_or_else(|| fault(format!("step {number} enters before a face")))?;
            known.1 += 1;
            column.push((known.0, if place % 2 == 0 { 1 } else { -1 }));
        }
        column.sort_unstable();
        if stays.len() <= degree {
            stays.resize(degree + 1, Vec::new());
            columns.resize(degree + 1, Vec::new());
        }
        let cell = stays[degree].len() as u32;
        if there.insert(simplex, (cell, 0)).is_some() {
            return Err(fault(format!("the simplex of step {number} is there")));
        }
        stays[degree].push(Stay { entrance: number, exit: None });
        columns[degree].push(column);
    }
    if stays.is_empty() {
        return Err(fault("there is no step"));
    }
    let counts = stays.iter().map(Vec::len).collect();
    Ok((Complex::of_columns(counts, columns.split_off(1)), stays))
}

/// A class: its degree, and the steps at which it is born and dies.
type Class = (usize, usize, Option<usize>);

/// Checks the persistence of a zigzag.
pub(crate) fn check(whole: &Value, input: &[u8]) -> Result<Verdict, Fault> {
    let (answer, proof) = (field(whole, "answer", "answer")?, field(whole, "proof", "proof")?);
    let prime = index(field(answer, "field", "answer")?, "\"field\"", "answer")?;
    if !coface_check::is_prime(prime) {
        return Err(Fault::new("answer", format!("{prime} is not prime")));
    }
    if answer["function"] != "zigzag" || optional(answer, "star").is_some() {
        return Err(Fault::new("answer", "it is not about a zigzag"));
    }
    let steps = steps(input)?;
    let (complex, stays) = complex(&steps)?;
    let cone = made(&complex)?;
    let count = steps.len() as f64;
    let over = |stay: &Stay| stay.exit.map_or(count, |exit| 2.0 * count - exit as f64);
    let entrances = |degree: usize| -> Vec<f64> {
        let own = stays.get(degree).into_iter().flatten().map(|stay| stay.entrance as f64);
        match degree.checked_sub(1) {
            Some(below) => own.chain(stays[below].iter().map(over)).collect(),
            None => own.chain([-1.0]).collect(),
        }
    };
    let entrances: Vec<Vec<f64>> = (0..=stays.len()).map(entrances).collect();
    let orders = pairs::orders(&cone, &entrances, field(proof, "order", "order")?, false)?;
    let found = pairs::pairs(&cone, &orders, field(proof, "chains", "chains")?, prime.into())?;
    let mut classes: Vec<Class> = Vec::new();
    for (degree, birth, death) in found {
        let born = below(&complex, degree, birth);
        let dead = death.map(|death| below(&complex, degree + 1, death));
        let (Some((is_born_over, k, birth)), Some(Some((is_dead_over, l, death)))) = (born, dead) else {
            if born.is_none() && dead.is_none() {
                // The component of the apex stays.
                continue;
            }
            return Err(Fault::new("chains", "a class of the cone stays, or that of the apex ends"));
        };
        let (born, dead) = (stays[k][birth as usize], stays[l][death as usize]);
        let below = || degree.checked_sub(1).ok_or_else(|| Fault::new("chains", "a class has no degree"));
        match (is_born_over, is_dead_over, dead.exit) {
            (false, false, _) => classes.push((degree, born.entrance, Some(dead.entrance))),
            // Both stay.
            (true, _, None) => {}
            (true, _, Some(exit)) => classes.push((below()?, exit, born.exit)),
            (false, true, Some(exit)) if exit < born.entrance => {
                classes.push((below()?, exit, Some(born.entrance)));
            }
            (false, true, exit) => classes.push((degree, born.entrance, exit)),
        }
    }
    let mut betti = vec![0_u64; stays.len()];
    classes.iter().filter(|class| class.2.is_none()).for_each(|class| betti[class.0] += 1);
    let claimed = list(field(answer, "betti", "answer")?, "\"betti\"", "answer")?;
    if !claimed.iter().map(Value::as_u64).eq(betti.iter().map(|count| Some(*count))) {
        return Err(Fault::new("answer", format!("the classes that stay are {betti:?} by degree")));
    }
    let least = field(whole, "min_persistence", "answer")?.as_f64();
    let least = least.ok_or_else(|| Fault::new("answer", "\"min_persistence\" is not a number"))?;
    let is_long = |class: &&Class| {
        let length = class.2.map_or(f64::INFINITY, |death| steps[death].time - steps[class.1].time);
        // What is there at one time alone has the length 0.
        let is_met = steps[class.1].is_insertion && class.2.is_some_and(|death| !steps[death].is_insertion);
        length > least || least == 0.0 && is_met
    };
    let mut expected: Vec<Told> = classes.iter().filter(is_long).map(|class| told(&steps, class)).collect();
    let claimed = list(field(answer, "diagram", "answer")?, "\"diagram\"", "answer")?;
    let mut claimed = claimed.iter().map(claimed_class).collect::<Result<Vec<Told>, Fault>>()?;
    expected.sort_unstable();
    claimed.sort_unstable();
    if expected != claimed {
        return Err(Fault::new("answer", "the classes of the chains are others than those of the answer"));
    }
    let mut proved =
        vec![format!("the zigzag has {} steps, at which simplices enter and leave", steps.len())];
    proved.push(format!("Betti numbers over F_{prime} at the end = {betti:?}"));
    for degree in 0..betti.len() {
        let count = expected.iter().filter(|class| class.0 == degree).count();
        let bound = if least == 0.0 {
            "above 0, or that are met at one time".to_owned()
        } else {
            format!("above {}", shown(least))
        };
        proved.push(format!("degree {degree}: the {count} classes that last {bound}, and no others"));
    }
    Ok(Verdict::of(proved, answer, &["file", "field", "function", "star", "diagram", "betti"]))
}

/// A class as an answer tells it: degree, kind, the bits of birth and death, and the simplices of their steps.
type Told = (usize, String, u64, Option<u64>, Vec<u32>, Option<Vec<u32>>);

fn told(steps: &[Step], &(degree, birth, death): &Class) -> Told {
    let bits = |step: usize| (steps[step].time + 0.0).to_bits();
    let first = if steps[birth].is_insertion { "closed" } else { "open" };
    let last = if death.is_some_and(|death| !steps[death].is_insertion) { "closed" } else { "open" };
    let simplex = |step: usize| steps[step].simplex.clone();
    (degree, format!("{first}-{last}"), bits(birth), death.map(bits), simplex(birth), death.map(simplex))
}

fn claimed_class(class: &Value) -> Result<Told, Fault> {
    let step = "answer";
    let keys = class.as_object().into_iter().flat_map(|object| object.keys());
    if let Some(key) = keys.into_iter().find(|key| *key != "kind" && !PAIR_KEYS.contains(&key.as_str())) {
        return Err(Fault::new(step, format!("a pair has the key {key:?}, of which nothing is proved")));
    }
    let bits = |value: &Value| {
        let time = value.as_f64().ok_or_else(|| Fault::new(step, "a time is no number"))?;
        Ok::<u64, Fault>((time + 0.0).to_bits())
    };
    let simplex = |value: &Value| vertices(value).map(sorted);
    Ok((
        index(field(class, "degree", step)?, "\"degree\"", step)? as usize,
        text(field(class, "kind", step)?, "\"kind\"", step)?.to_owned(),
        bits(field(class, "birth", step)?)?,
        optional(class, "death").map(bits).transpose()?,
        simplex(field(class, "birth_cell", step)?)?,
        optional(class, "death_cell").map(simplex).transpose()?,
    ))
}
