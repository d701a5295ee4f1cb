//! Certificates of reports: the checker finds components, links, orientations and boundaries by itself.

use crate::claims::keys;
use crate::groups::Ring;
use crate::homology::{compare, integral_groups};
use crate::json::{field, optional};
use crate::{Complex, Fault, Verdict, moves};
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};

pub(crate) fn check(certificate: &Value, inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    let step = "answer";
    let (answer, complex) = (field(certificate, "answer", "certificate")?, Complex::read(inputs[0])?);
    let proof = field(certificate, "proof", "certificate")?;
    let groups = integral_groups(&complex, proof)?;
    let mut proved = compare(field(answer, "homology", step)?, &groups, &Ring::Integers, "H_")?;
    let mut known = vec!["file", "homology"];
    for (key, found) in facts(&complex, proof)? {
        let claim = field(answer, key, step)?;
        let is_manifold = key == "manifold";
        if is_manifold {
            keys(claim, &["verdict", "closed", "witness"], "\"manifold\"")?;
        }
        let said =
            if is_manifold { json!([claim.get("verdict"), claim.get("closed")]) } else { claim.clone() };
        if said != found {
            return Err(Fault::new(step, format!("{key:?} is {found}, but the answer says {said}")));
        }
        // The cells that the answer shows are not looked at.
        if !is_manifold || optional(claim, "witness").is_none() {
            known.push(key);
        }
        proved.push(format!("{key} = {found}"));
    }
    Ok(Verdict::of(proved, answer, &known))
}

/// What can be said of a complex of simplices or polygons, by the keys of the answer.
fn facts(complex: &Complex, proof: &Value) -> Result<Vec<(&'static str, Value)>, Fault> {
    let (counts, step) = (complex.counts(), "input");
    let names = complex.names().ok_or_else(|| Fault::new(step, "a report needs cells with vertices"))?;
    let top = counts.len() - 1;
    let euler = (0..)
        .zip(counts)
        .map(|(k, count)| if k % 2 == 0 { *count as i64 } else { -(*count as i64) })
        .sum::<i64>();
    let mut pieces = Classes::new(counts[0]);
    for edge in (0..counts.get(1).copied().unwrap_or(0)).map(|edge| complex.boundary(1, edge)) {
        pieces.unite(edge[0].0, edge[1].0, false);
    }
    let loose: Vec<bool> = (0..top).map(|k| complex.cofaces(k).iter().any(Vec::is_empty)).collect();
    let is_pure = !loose.contains(&true);
    let mut facts = vec![
        ("dimension", json!(top)),
        ("f_vector", json!(counts)),
        ("euler_characteristic", json!(euler)),
        ("components", json!(pieces.count)),
        ("pure", json!(is_pure)),
    ];
    // Whether vertices without cells count, the file does not say.
    if top == 0 || loose[0] {
        return Ok(facts);
    }
    let ridges = complex.cofaces(top - 1);
    let mut sides = Classes::new(counts[top]);
    let mut is_orientable = Some(true);
    for pair in ridges.iter().filter(|cells| cells.len() > 1) {
        match pair[..] {
            // Neighbors agree if the ridge has opposite incidences in them.
            [(a, x), (b, y)] => {
                is_orientable = is_orientable.map(|so_far| sides.unite(a, b, x == y) && so_far);
            }
            _ => is_orientable = None,
        }
    }
    let rim: Vec<usize> = (0..ridges.len()).filter(|ridge| ridges[*ridge].len() == 1).collect();
    let mut loops = Classes::new(counts[0]);
    let mut on_rim: BTreeSet<u32> = BTreeSet::new();
    for ridge in &rim {
        on_rim.extend(names[top - 1].get(*ridge));
        names[top - 1]
            .get(*ridge)
            .windows(2)
            .for_each(|ends| loops.unite_named(names[0].items(), ends[0], ends[1]));
    }
    // The vertices off the boundary are classes of their own.
    let loop_count = on_rim.len() + loops.count - counts[0];
    if is_pure {
        facts.push(("orientable", json!(is_orientable)));
    }
    if top == 2 {
        facts.push(("boundary_loops", json!(loop_count)));
    }
    let links = links(names[top].iter(), top);
    let is_manifold = match (top, optional(proof, "links")) {
        (..=3, _) => Some(is_pure && links.values().all(|link| is_ball_or_sphere(link, top - 1))),
        _ if !is_pure || ridges.iter().any(|cells| cells.len() > 2) => Some(false),
        (_, Some(logs)) => moves::follow(logs, &links).map(|()| Some(true))?,
        (_, None) => {
            (!small_links(names[top].iter()).values().all(|link| is_ball_or_sphere(link, 2))).then_some(false)
        }
    };
    if let Some(is_manifold) = is_manifold {
        facts.push(("manifold", json!([if is_manifold { "yes" } else { "no" }, rim.is_empty()])));
        if let (true, 2, 1, Some(orientable)) = (is_manifold, top, pieces.count, is_orientable) {
            let twice = 2 - euler - loop_count as i64;
            facts.push(("genus", json!(if orientable { twice / 2 } else { twice })));
        }
    }
    Ok(facts)
}

/// For each vertex of cells of one dimension the cells that make its link: of a polygon the two neighbors of the vertex.
fn links<'a>(cells: impl Iterator<Item = &'a [u32]>, dimension: usize) -> BTreeMap<u32, Vec<Vec<u32>>> {
    let mut links: BTreeMap<u32, Vec<Vec<u32>>> = BTreeMap::new();
    for cell in cells {
        for (i, vertex) in cell.iter().enumerate() {
            let mut others = [&cell[i + 1..], &cell[..i]].concat();
            if cell.len() > dimension + 1 {
                others = vec![others[0], others[others.len() - 1]];
            }
            links.entry(*vertex).or_default().push(others);
        }
    }
    links
}

/// The links of dimension 2: for each simplex of three vertices less than a facet the triangles around it.
fn small_links<'a>(facets: impl Iterator<Item = &'a [u32]>) -> BTreeMap<Vec<u32>, Vec<Vec<u32>>> {
    let mut links: BTreeMap<Vec<u32>, Vec<Vec<u32>>> = BTreeMap::new();
    for facet in facets {
        for a in 0..facet.len() {
            for b in 0..a {
                for c in 0..b {
                    let is_corner = |place: &usize| [a, b, c].contains(place);
                    let part = |wanted: bool| {
                        (0..facet.len())
                            .filter(|place| is_corner(place) == wanted)
                            .map(|place| facet[place])
                            .collect()
                    };
                    links.entry(part(false)).or_default().push(part(true));
                }
            }
        }
    }
    links
}

/// Whether cells, of a dimension up to 2, are a sphere or a ball.
fn is_ball_or_sphere(cells: &[Vec<u32>], dimension: usize) -> bool {
    if dimension == 0 {
        return cells.len() <= 2;
    }
    let links = links(cells.iter().map(Vec::as_slice), dimension);
    let mut classes = Classes::new(links.len());
    let names: Vec<u32> = links.keys().copied().collect();
    cells
        .iter()
        .for_each(|cell| cell.windows(2).for_each(|ends| classes.unite_named(&names, ends[0], ends[1])));
    // A connected surface with V - E + F = 2 is a sphere, and one with a boundary and V - E + F = 1 a disk. Each edge is in two links.
    let corners: usize =
        links.values().map(|link| link.iter().flatten().collect::<BTreeSet<_>>().len()).sum();
    let euler = links.len() as i64 - corners as i64 / 2 + cells.len() as i64;
    let has_form = dimension == 1 || euler == 2 || euler == 1 && 3 * cells.len() < corners;
    classes.count == 1 && has_form && links.values().all(|link| is_ball_or_sphere(link, dimension - 1))
}

/// Classes of things that are equal, or each the reverse of the other.
struct Classes {
    /// A thing of the same class, nearer to the root, and whether it is the reverse.
    above: Vec<(u32, bool)>,
    count: usize,
}

impl Classes {
    fn new(count: usize) -> Self {
        Self { above: (0..count as u32).map(|i| (i, false)).collect(), count }
    }

    fn root(&mut self, mut thing: u32) -> (u32, bool) {
        let mut is_reverse = false;
        while self.above[thing as usize].0 != thing {
            let (next, turn) = self.above[thing as usize];
            let (after, other) = self.above[next as usize];
            // Halves the way; the root is not the reverse of itself.
            self.above[thing as usize] = (after, turn ^ other);
            is_reverse ^= turn ^ other;
            thing = after;
        }
        (thing, is_reverse)
    }

    /// Makes two things equal, or reverse; whether that does not contradict what was said before.
    fn unite(&mut self, a: u32, b: u32, is_reverse: bool) -> bool {
        let ((a, of_a), (b, of_b)) = (self.root(a), self.root(b));
        if a == b {
            return of_a ^ of_b == is_reverse;
        }
        self.count -= 1;
        self.above[a as usize] = (b, of_a ^ of_b ^ is_reverse);
        true
    }

    /// Makes two vertices equal, by rising names.
    fn unite_named(&mut self, names: &[u32], a: u32, b: u32) {
        let place = |vertex| names.binary_search(&vertex).unwrap_or(0) as u32;
        self.unite(place(a), place(b), false);
    }
}
