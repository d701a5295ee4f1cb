//! Persistence of a pair: relative to a part of the complex, and of the image of a part in the whole.

use crate::groups;
use crate::pairs::{Order, Pair, pairs, read};
use coface_check::json::{field, list, optional, text};
use coface_check::{Complex, Fault};
use serde_json::Value;
use std::collections::{HashMap, HashSet};

/// A subcomplex of the complex of the input.
pub(crate) struct Part {
    /// For each degree which cells are in it.
    is_in: Vec<Vec<bool>>,
    /// Whether the diagram is of its image in the whole; otherwise it is relative to the part.
    pub(crate) is_image: bool,
    /// Whether the part is the one that the answer names.
    pub(crate) is_named: bool,
    /// What the part is.
    pub(crate) claim: String,
}

/// The part that a certificate is about: the boundary, the cells of a second input, or those that it lists as the ones of groups.
pub(crate) fn part(
    whole: &Value,
    complex: &Complex,
    is_listed: bool,
    inputs: &[&[u8]],
) -> Result<Option<Part>, Fault> {
    let step = "part";
    let answer = field(whole, "answer", "answer")?;
    let (relative, image) = (optional(answer, "relative_to"), optional(answer, "image_of"));
    let kind = optional(whole, "part").map(|kind| text(kind, "\"part\"", step)).transpose()?;
    let (name, is_image) = match (relative, image, kind) {
        (None, None, None) if inputs.len() == 1 => return Ok(None),
        (Some(name), None, Some(_)) => (name, false),
        (None, Some(name), Some(_)) => (name, true),
        _ => return Err(Fault::new(step, "the answer and the inputs are not those of one part")),
    };
    if is_listed {
        return Err(Fault::new(step, "simplices that the certificate lists have no parts"));
    }
    let named = text(name, "the name of the part", step)?;
    let listed = optional(whole, "part_cells").map(Value::to_string);
    let (file, expected) = match (kind, inputs) {
        (Some("boundary"), [_]) if listed.is_none() => (None, "boundary"),
        (Some("groups"), [_]) if listed.is_some() => (listed.as_ref().map(|cells| cells.as_bytes()), named),
        (Some("file"), [_, part]) if listed.is_none() => {
            let name = whole["inputs"][1]["name"].as_str();
            (Some(*part), name.ok_or_else(|| Fault::new(step, "the file of the part has no name"))?)
        }
        _ => return Err(Fault::new(step, "the inputs are not those of such a part")),
    };
    if named != expected {
        return Err(Fault::new(step, format!("the part is {expected}, and not {named}")));
    }
    let is_in = complex.part(file)?;
    let of_groups = listed.as_ref().and_then(|_| groups::of_name(inputs[0], named));
    if let Some(polygons) = &of_groups {
        let cells = Value::from(polygons.iter().map(|cell| Value::from(cell.clone())).collect::<Vec<_>>());
        if complex.part(Some(cells.to_string().as_bytes()))? != is_in {
            return Err(Fault::new(
                step,
                format!("the cells that are listed are not those of {named:.200?}"),
            ));
        }
    }
    let counts: Vec<usize> = is_in.iter().map(|own| own.iter().filter(|is_in| **is_in).count()).collect();
    let what = match (file, &listed, &of_groups) {
        (None, ..) => "the boundary of the whole".to_owned(),
        (_, None, _) => "the cells of the second input".to_owned(),
        (_, _, Some(_)) => format!("the polygons of the group {named}"),
        (_, _, None) => "the cells that the certificate lists".to_owned(),
    };
    let is_named = listed.is_none() || of_groups.is_some();
    let how = if is_image { "the image of a part in the whole" } else { "the whole relative to a part" };
    let claim = format!("the diagram is of {how}, which is {what}: {counts:?} cells of degrees 0, 1, ..");
    Ok(Some(Part { is_in, is_image, is_named, claim }))
}

impl Part {
    /// The key of the answer that names the part.
    pub(crate) fn key(&self) -> &'static str {
        if self.is_image { "image_of" } else { "relative_to" }
    }

    pub(crate) fn has(&self, degree: usize, cell: usize) -> bool {
        self.is_in[degree][cell]
    }

    /// The cells of each degree that are in the part, or those that are not.
    fn cells(&self, is_wanted: bool) -> Vec<Vec<usize>> {
        let of = |own: &Vec<bool>| (0..own.len()).filter(|cell| own[*cell] == is_wanted).collect();
        self.is_in.iter().map(of).collect()
    }

    /// The complex without the part, and the values of what is left.
    pub(crate) fn left(&self, complex: &Complex, values: &[Vec<f64>]) -> (Complex, Vec<Vec<f64>>) {
        let kept = self.cells(false);
        let of = |(kept, values): (&Vec<usize>, &Vec<f64>)| kept.iter().map(|&cell| values[cell]).collect();
        let values = kept.iter().zip(values).map(of).collect();
        (complex.restricted(&kept), values)
    }

    /// The pairs of the image: births are those of the part by itself, and a cell of the whole ends the last of them that the boundary of its chain has, where
    /// cells of the part come before all others.
    pub(crate) fn image_pairs(
        &self,
        complex: &Complex,
        orders: &[Order],
        of_whole: &[Pair],
        proof: &Value,
        prime: i128,
    ) -> Result<Vec<Pair>, Fault> {
        let step = "image_chains";
        let inside = self.cells(true);
        let own_orders: Vec<Order> =
            orders.iter().zip(&inside).map(|(order, kept)| order.restricted(kept)).collect();
        let own = field(proof, "part_chains", "part_chains")?;
        let of_part = pairs(&complex.restricted(&inside), &own_orders, own, prime)?;
        // The cells of the whole that end a class, whose chains these are.
        let mut to_come: HashSet<(usize, u32)> =
            of_whole.iter().filter_map(|&(degree, _, death)| Some((degree + 1, death?))).collect();
        let mut ends: HashMap<(usize, u32), u32> = HashMap::new();
        let chains = list(field(proof, step, step)?, "\"image_chains\"", step)?;
        if chains.len() + 1 != complex.counts().len() {
            return Err(Fault::new(step, "there are not chains of each degree from 1 on"));
        }
        for (k, of_degree) in (1..).zip(chains) {
            for chain in list(of_degree, "the chains of a degree", step)? {
                let (owner, boundary) = read(complex, orders, k, chain, prime)?;
                if !to_come.remove(&(k, owner)) {
                    return Err(Fault::new(
                        step,
                        "a chain belongs to a cell that ends no class, or that has one",
                    ));
                }
                let faces = boundary.iter().filter(|(_, entry)| **entry != 0);
                let faces = faces.map(|(place, _)| orders[k - 1].cells[*place as usize]);
                let last =
                    faces.max_by_key(|&face| (!self.has(k - 1, face as usize), orders[k - 1].place(face)));
                let last = last.ok_or_else(|| Fault::new(step, "a chain has no boundary"))?;
                if ends.insert((k - 1, last), owner).is_some() {
                    return Err(Fault::new(step, "the boundaries of two chains have one last cell"));
                }
            }
        }
        if !to_come.is_empty() {
            return Err(Fault::new(step, "a cell that ends a class has no chain"));
        }
        let pair = |(degree, birth, _): Pair| {
            let birth = inside[degree][birth as usize] as u32;
            (degree, birth, ends.get(&(degree, birth)).copied())
        };
        Ok(of_part.into_iter().map(pair).collect())
    }
}
