//! Certificates of arrangements.

use crate::area::Area;
use crate::drawing::Drawing;
use crate::faces::{Faces, OUTSIDE};
use crate::formula::Rule;
use crate::inside;
use crate::subdivision::Subdivision;
use coface_check::json::{field, index, list, optional};
use coface_check::{Fault, Verdict};
use serde_json::{Value, json};

/// An arrangement that has been proved.
pub(crate) struct Arrangement {
    pub(crate) plane: Subdivision,
    pub(crate) faces: Faces,
    /// For each face the regions that contain it.
    pub(crate) regions: Vec<Vec<u32>>,
    pub(crate) title: String,
}

impl Arrangement {
    /// Reads the inputs and the proof of a certificate.
    pub(crate) fn read(whole: &Value, inputs: &[&[u8]]) -> Result<Self, Fault> {
        let drawing = Drawing::read(inputs)?;
        let plane = Subdivision::read(field(whole, "proof", "certificate")?, &drawing)?;
        let faces = Faces::new(&plane);
        let regions = inside::regions(whole, &drawing, &plane, &faces)?;
        let counted =
            |count: usize, one: &str, many: &str| format!("{count} {}", if count == 1 { one } else { many });
        let title = format!(
            "an arrangement of {} in {}, {} and {}",
            counted(drawing.segments().len(), "segment", "segments"),
            counted(plane.vertices.len(), "vertex", "vertices"),
            counted(plane.edges.len(), "edge", "edges"),
            counted(faces.count - 1, "bounded face", "bounded faces")
        );
        Ok(Self { plane, faces, regions, title })
    }
}

/// Compares a claim of the answer, where there is one, with what was found.
pub(crate) fn claim(proved: &mut Vec<String>, answer: &Value, key: &str, found: &Value) -> Result<(), Fault> {
    match optional(answer, key) {
        Some(said) if said == found => proved.push(format!("{key} = {found}")),
        Some(said) => {
            return Err(Fault::new("answer", format!("\"{key}\" is {found}, and the answer says {said}")));
        }
        None => {}
    }
    Ok(())
}

/// Checks a certificate of an arrangement.
pub(crate) fn check(whole: &Value, inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    let Arrangement { plane, faces, regions, title } = Arrangement::read(whole, inputs)?;
    let answer = field(whole, "answer", "certificate")?;
    let [v, e, f] = [plane.vertices.len(), plane.edges.len(), faces.count - 1];
    let is_bridge = |edge: &usize| faces.of[2 * edge] == faces.of[2 * edge + 1];
    let bridges = (0..e).filter(is_bridge).count();
    let mut proved = vec![title, Rule::of(whole)?.claim()];
    for (key, found) in [
        ("f_vector", json!([v, e, f])),
        ("components", json!(faces.components)),
        ("euler_characteristic", json!((v + f) as i64 - e as i64)),
        ("holes", json!(faces.holes)),
        ("bridges", json!(bridges)),
        ("dangling_edges", json!(dangling(&plane))),
        // The boundary of a face is made of closed walks.
        ("products_zero", json!(true)),
        ("dimension", json!(2)),
    ] {
        claim(&mut proved, answer, key, &found)?;
    }
    // A halfedge on the left of which each face of the answer is.
    let step = "faces";
    let named = list(field(field(whole, "proof", step)?, "faces", step)?, "\"faces\"", step)?;
    let mut order = Vec::with_capacity(f);
    for ends in named {
        let [from, to] = list(ends, "a halfedge", step)? else {
            return Err(Fault::new(step, "a halfedge is no pair of vertices"));
        };
        let [from, to] = [index(from, "a vertex", step)?, index(to, "a vertex", step)?];
        let edge = plane.edges.binary_search(&[from.min(to), from.max(to)]);
        let edge = edge.map_err(|_| Fault::new(step, format!("no edge joins {from} and {to}")))?;
        order.push(faces.of[2 * edge + usize::from(from > to)]);
    }
    let mut once = order.clone();
    once.sort_unstable();
    if !once.iter().copied().eq(OUTSIDE + 1..faces.count as u32) {
        return Err(Fault::new(step, "these are not all bounded faces, each once"));
    }
    let around = order.iter().map(|&face| json!(regions[face as usize]));
    claim(&mut proved, answer, "inside", &Value::Array(around.collect()))?;
    if let Some(measures) = optional(answer, "measures") {
        let measures = list(measures, "\"measures\"", "answer")?;
        if measures.len() != f {
            return Err(Fault::new("answer", format!("{} areas are there for {f} faces", measures.len())));
        }
        let walks = faces.halfedges();
        for (number, (measure, &face)) in measures.iter().zip(&order).enumerate() {
            let what = format!("the area of face {number}");
            Area::of(&plane, &walks[face as usize], &what)?.agrees(measure, &what)?;
        }
        proved.push("measures, the areas of the faces, to one part in 10^13".to_owned());
    }
    let known = [
        "f_vector",
        "components",
        "euler_characteristic",
        "holes",
        "bridges",
        "dangling_edges",
        "inside",
        "measures",
        "products_zero",
        "dimension",
    ];
    Ok(Verdict::of(proved, answer, &known))
}

/// The number of edges that go when ends with one edge are removed one by one.
fn dangling(plane: &Subdivision) -> usize {
    let mut degrees: Vec<usize> = plane.around.iter().map(Vec::len).collect();
    let mut is_gone = vec![false; plane.edges.len()];
    let mut waiting: Vec<usize> = (0..degrees.len()).filter(|&vertex| degrees[vertex] == 1).collect();
    let mut count = 0;
    while let Some(vertex) = waiting.pop() {
        let mut around = plane.around[vertex].iter().map(|halfedge| *halfedge as usize / 2);
        let Some(edge) = around.find(|&edge| !is_gone[edge]) else { continue };
        is_gone[edge] = true;
        count += 1;
        for end in plane.edges[edge].map(|end| end as usize) {
            degrees[end] -= 1;
            if degrees[end] == 1 {
                waiting.push(end);
            }
        }
    }
    count
}
