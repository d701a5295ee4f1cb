//! Walks on a surface compared: contractible, homotopic, homologous.

use super::surface::{Surface, SurfaceComponent};
use crate::failure::Failure;
use coface::VertexId;
use coface::algebra::Word;
use coface::answers::answer::{WalkAnswer, WalkPair};
use coface::topology::{ClosedWalk, ConjugacyForm, NormalForm, Presentation};
use serde_json::Value;
use std::collections::BTreeSet;
use std::path::Path;

/// The largest number of walks of which all pairs are compared.
const MOST: usize = 2_000;

/// What is known of one walk.
struct Known {
    start: VertexId,
    steps: usize,
    component: Option<usize>,
    word: Word,
    class: Vec<i64>,
    element: Option<NormalForm>,
    conjugacy: Option<ConjugacyForm>,
}

/// Walks compared: the object, and facts for people.
pub(super) struct Compared {
    pub(super) walks: Vec<WalkAnswer>,
    pub(super) pairs: Vec<WalkPair>,
    pub(super) facts: Vec<(String, String)>,
}

pub(super) fn compare(
    path: &Path,
    surface: &Surface<'_>,
    components: &[SurfaceComponent],
    numbers: &[u32],
) -> Result<Compared, Failure> {
    let walks = read(path, surface, numbers)?;
    let known = walks
        .iter()
        .map(|walk| know(walk, surface, components))
        .collect::<Result<Vec<_>, coface::Error>>()?;
    let mut facts = Vec::new();
    let mut objects = Vec::new();
    for (i, walk) in known.iter().enumerate() {
        let is_contractible = walk.element.as_ref().is_none_or(NormalForm::is_identity);
        let bounds = walk.class.iter().all(|&x| x == 0);
        let verdict = match (is_contractible, bounds) {
            (true, _) => "can be contracted".to_owned(),
            (false, true) => format!("bounds, but cannot be contracted: {}", walk.word),
            (false, false) => format!("does not bound: {}", walk.word),
        };
        facts.push((format!("walk {i}"), verdict));
        objects.push(WalkAnswer {
            steps: walk.steps,
            component: walk.component,
            contractible: is_contractible,
            bounds,
            word: walk.word.letters().to_vec(),
            homology: walk.class.clone(),
        });
    }
    let mut pairs = Vec::new();
    for (i, a) in known.iter().enumerate() {
        for (j, b) in known.iter().enumerate().skip(i + 1) {
            let together = a.component == b.component && (a.component.is_some() || a.start == b.start);
            let homologous = together && a.class == b.class;
            let free = together && a.conjugacy == b.conjugacy;
            let based = (a.start == b.start).then(|| a.element == b.element);
            if known.len() <= 8 {
                let verdict = match (based, free, homologous) {
                    (Some(true), ..) => "homotopic with the base fixed",
                    (_, true, _) => "freely homotopic",
                    (_, _, true) => "homologous, but not homotopic",
                    _ => "not homologous",
                };
                facts.push((format!("walks {i}, {j}"), verdict.to_owned()));
            }
            pairs.push(WalkPair { walks: [i, j], homotopic: based, freely_homotopic: free, homologous });
        }
    }
    Ok(Compared { walks: objects, pairs, facts })
}

fn know(
    walk: &ClosedWalk,
    surface: &Surface<'_>,
    components: &[SurfaceComponent],
) -> Result<Known, coface::Error> {
    let component = surface.homotopy.component(walk)?;
    let (start, steps) = (walk.start(), walk.len());
    let Some(i) = component else {
        let (word, class) = (Word::new(), Vec::new());
        return Ok(Known { start, steps, component, word, class, element: None, conjugacy: None });
    };
    let group = &surface.homotopy.groups()[i];
    let element = surface.homotopy.element(walk)?.unwrap_or_else(|| group.identity());
    let conjugacy = group.class_of(element.clone());
    let mut word = group.word(&element);
    if let Some(images) = &components[i].images {
        word = word.image(images);
    }
    let class = class(&word, &components[i].presentation);
    Ok(Known { start, steps, component, word, class, element: Some(element), conjugacy: Some(conjugacy) })
}

/// The exponent sums of a word, less a multiple of those of the relator: the first one in that becomes 0 or 1.
fn class(word: &Word, presentation: &Presentation) -> Vec<i64> {
    let count = presentation.generator_count();
    let mut sums = word.exponent_sums(count);
    for relator in presentation.relators() {
        let relation = relator.exponent_sums(count);
        if let Some(pivot) = relation.iter().position(|&x| x != 0) {
            let times = sums[pivot].div_euclid(2) * relation[pivot].signum();
            sums.iter_mut().zip(&relation).for_each(|(sum, x)| *sum -= times * x);
        }
    }
    sums
}

/// Reads {"walks":[[v0,v1,..,v0],..]} or the bare list.
fn read(path: &Path, surface: &Surface<'_>, numbers: &[u32]) -> Result<Vec<ClosedWalk>, Failure> {
    let place = path.display();
    let text = std::fs::read_to_string(path)
        .map_err(|error| Failure::new(format!("{place}: cannot be read: {error}")))?;
    let how = "write closed paths of vertices as {\"walks\":[[v0,v1,..,v0],..]}";
    let value: Value = serde_json::from_str(&text)
        .map_err(|error| Failure::new(format!("{place}:{}: {error}; {how}", error.line())))?;
    let lists: Vec<Vec<u32>> = serde_json::from_value(value.get("walks").unwrap_or(&value).clone())
        .map_err(|error| Failure::new(format!("{place}: {error}; {how}")))?;
    if lists.len() > MOST {
        return Err(Failure::new(format!(
            "{place}: {} walks, and all pairs of them are compared; give at most {MOST}",
            lists.len()
        )));
    }
    let mut known: Vec<(u32, usize)> = numbers.iter().copied().zip(0..).collect();
    known.sort_unstable();
    let vertex = |walk: usize, number: u32| {
        let at = known.binary_search_by_key(&number, |&(number, _)| number);
        at.map(|at| VertexId::new(known[at].1)).map_err(|_| {
            Failure::new(format!(
                "{place}: walk {walk} goes through vertex {number}, which the model does not have"
            ))
        })
    };
    let vertices = lists
        .iter()
        .enumerate()
        .map(|(walk, list)| list.iter().map(|&number| vertex(walk, number)).collect())
        .collect::<Result<Vec<Vec<VertexId>>, Failure>>()?;
    let skeleton = surface.map.skeleton();
    ClosedWalk::from_vertices(skeleton, &vertices).map_err(|error| {
        // In the numbers of the file.
        let edges: BTreeSet<[u32; 2]> = skeleton
            .edge_ends()
            .chunks(2)
            .flat_map(|ends| [[ends[0], ends[1]], [ends[1], ends[0]]])
            .collect();
        for (walk, (list, ids)) in lists.iter().zip(&vertices).enumerate() {
            let missing = ids.windows(2).position(|pair| !edges.contains(&[pair[0].to_u32(), pair[1].to_u32()]));
            if let (Some(first), Some(last)) = (list.first(), list.last())
                && first != last
            {
                return Failure::new(format!(
                    "{place}: walk {walk} starts at vertex {first} but ends at {last}; end with the vertex it starts with"
                ));
            }
            if let Some(step) = missing {
                return Failure::new(format!(
                    "{place}: step {step} of walk {walk} goes from vertex {} to {}, but no edge joins them; go along edges only",
                    list[step],
                    list[step + 1]
                ));
            }
        }
        Failure::from(error.in_file(place.to_string()))
    })
}
