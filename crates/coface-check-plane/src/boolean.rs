//! Certificates of Booleans.

use crate::area::Area;
use crate::claims::{Arrangement, claim};
use crate::formula::{Formula, Rule};
use crate::subdivision::Subdivision;
use coface_check::json::{field, list, optional, text};
use coface_check::{Fault, Verdict};
use serde_json::{Value, json};

/// Checks a certificate of a Boolean.
pub(crate) fn check(whole: &Value, inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    let step = "certificate";
    let formula = text(field(whole, "formula", step)?, "\"formula\"", step)?;
    let formula = Formula::read(formula, inputs.len())?;
    let Arrangement { plane, faces, regions, title } = Arrangement::read(whole, inputs)?;
    let answer = field(whole, "answer", step)?;
    let is_in: Vec<bool> =
        regions.iter().map(|regions| formula.holds(|input| regions.contains(&input))).collect();
    if is_in[0] {
        return Err(Fault::new("formula", "it holds outside of all inputs"));
    }
    // The boundary has the result on one side: on the left of these halfedges.
    let face = |halfedge: u32| faces.of[halfedge as usize] as usize;
    let halfedges = 0..faces.of.len() as u32;
    let boundary: Vec<u32> = halfedges.filter(|&h| is_in[face(h)] && !is_in[face(h ^ 1)]).collect();
    // Faces of the result that share an edge are of one component.
    let mut component = vec![usize::MAX; faces.count];
    let around = faces.halfedges();
    let mut components = 0;
    for start in (0..faces.count).filter(|&start| is_in[start]) {
        let mut waiting = vec![start];
        let before = component[start];
        while let Some(at) = waiting.pop() {
            if component[at] == usize::MAX {
                component[at] = components;
                waiting.extend(around[at].iter().map(|&h| face(h ^ 1)).filter(|&other| is_in[other]));
            }
        }
        components += usize::from(before == usize::MAX);
    }
    let mut degrees = vec![0usize; plane.vertices.len()];
    for &halfedge in &boundary {
        plane.edges[halfedge as usize / 2].iter().for_each(|&end| degrees[end as usize] += 1);
    }
    let pinches = degrees.iter().filter(|degree| **degree > 2).count();
    let of_inputs = format!("the result is {} of the inputs, numbered from 0", formula.shown());
    let mut proved = vec![title, of_inputs, Rule::of(whole)?.claim()];
    claim(&mut proved, answer, "components", &json!(components))?;
    claim(&mut proved, answer, "pinches", &json!(pinches))?;
    // A face has a closed boundary, and so has a union of faces.
    claim(&mut proved, answer, "closed", &json!(true))?;
    claim(&mut proved, answer, "dimension", &json!(2))?;
    if pinches == 0 {
        // The boundary is circles; each component has one outer one.
        claim(&mut proved, answer, "holes", &json!(circles(&plane.edges, &boundary) - components))?;
    }
    if let Some(measure) = optional(answer, "measure") {
        let what = "the area of the result";
        let area = match boundary[..] {
            [] if measure.as_f64() == Some(0.0) => 0.0,
            _ => Area::of(&plane, &boundary, what)?.agrees(measure, what)?,
        };
        proved.push(format!("measure = {area}, to one part in 10^13"));
    }
    if let Some(measures) = optional(answer, "measures").filter(|_| answer["polygons"] == json!(components)) {
        let said = list(measures, "\"measures\"", "answer")?;
        let mut walks = vec![Vec::new(); components];
        boundary.iter().for_each(|&h| walks[component[face(h)]].push(h));
        areas_in_some_order(said, &plane, &walks)?;
        proved.push("measures, the areas of the components in some order, to one part in 10^13".to_owned());
    }
    let mut known = vec!["components", "pinches", "measure", "closed", "dimension"];
    known.extend((pinches == 0).then_some("holes"));
    known.extend((answer["polygons"] == json!(components)).then_some("measures"));
    Ok(Verdict::of(proved, answer, &known))
}

/// The number of circles that halfedges make, of which each vertex has none or two.
fn circles(edges: &[[u32; 2]], boundary: &[u32]) -> usize {
    let mut after = std::collections::BTreeMap::new();
    for &halfedge in boundary {
        let [low, high] = edges[halfedge as usize / 2];
        let (from, to) = if halfedge.is_multiple_of(2) { (low, high) } else { (high, low) };
        after.insert(from, to);
    }
    let mut count = 0;
    while let Some((_, mut at)) = after.pop_first() {
        count += 1;
        while let Some(next) = after.remove(&at) {
            at = next;
        }
    }
    count
}

/// Tests that these are the areas of the components: both sorted, each agrees with one.
fn areas_in_some_order(said: &[Value], plane: &Subdivision, walks: &[Vec<u32>]) -> Result<(), Fault> {
    let fault = |message: String| Fault::new("answer", message);
    if said.len() != walks.len() {
        return Err(fault(format!("{} areas are there for {} components", said.len(), walks.len())));
    }
    let mut said: Vec<&Value> = said.iter().collect();
    said.sort_by(|a, b| a.as_f64().unwrap_or(0.0).total_cmp(&b.as_f64().unwrap_or(0.0)));
    let what = |number: usize| format!("the area at place {number} of all, rising,");
    let found = walks.iter().map(|walk| Area::of(plane, walk, "the area of a component"));
    let mut found = found.collect::<Result<Vec<_>, _>>()?;
    found.sort_by(Area::compare);
    for (number, (said, found)) in said.into_iter().zip(found).enumerate() {
        found.agrees(said, &what(number))?;
    }
    Ok(())
}
