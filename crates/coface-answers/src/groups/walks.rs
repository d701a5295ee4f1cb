//! Walks on a surface compared: contractible, homotopic, homologous.

use super::GivenWalks;
use super::surface::{Surface, SurfaceComponent};
use crate::answer::{WalkAnswer, WalkPair};
use coface_algebra::{Error, VertexId, Word};
use coface_topology::{ClosedWalk, ConjugacyForm, NormalForm, Presentation};
use std::collections::BTreeSet;

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

pub(super) fn compare(
    given: &GivenWalks,
    surface: &Surface<'_>,
    components: &[SurfaceComponent],
    numbers: &[u32],
) -> Result<(Vec<WalkAnswer>, Vec<WalkPair>), Error> {
    let walks = closed_walks(given, surface, numbers)?;
    let known =
        walks.iter().map(|walk| know(walk, surface, components)).collect::<Result<Vec<_>, Error>>()?;
    let answer = |walk: &Known| WalkAnswer {
        steps: walk.steps,
        component: walk.component,
        contractible: walk.element.as_ref().is_none_or(NormalForm::is_identity),
        bounds: walk.class.iter().all(|&x| x == 0),
        word: walk.word.letters().to_vec(),
        homology: walk.class.clone(),
    };
    let mut pairs = Vec::new();
    for (i, a) in known.iter().enumerate() {
        for (j, b) in known.iter().enumerate().skip(i + 1) {
            let together = a.component == b.component && (a.component.is_some() || a.start == b.start);
            // What bounds is homologous wherever it is.
            let bound = [a, b].iter().all(|walk| walk.class.iter().all(|&x| x == 0));
            let homologous = bound || together && a.class == b.class;
            let free = together && a.conjugacy == b.conjugacy;
            let based = (a.start == b.start).then(|| a.element == b.element);
            pairs.push(WalkPair { walks: [i, j], homotopic: based, freely_homotopic: free, homologous });
        }
    }
    Ok((known.iter().map(answer).collect(), pairs))
}

fn know(walk: &ClosedWalk, surface: &Surface<'_>, components: &[SurfaceComponent]) -> Result<Known, Error> {
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

/// The walks on the edges of the surface.
fn closed_walks(
    given: &GivenWalks,
    surface: &Surface<'_>,
    numbers: &[u32],
) -> Result<Vec<ClosedWalk>, Error> {
    let GivenWalks { place, walks: lists } = given;
    if lists.len() > MOST {
        let message = format!("{} walks, and all pairs of them are compared", lists.len());
        return Err(Error::invalid(message).with_cure(format!("give at most {MOST}")).in_file(place));
    }
    let mut known: Vec<(u32, usize)> = numbers.iter().copied().zip(0..).collect();
    known.sort_unstable();
    let vertex = |index: usize, number: u32| {
        let walk = index + 1;
        let at = known.binary_search_by_key(&number, |&(number, _)| number);
        at.map(|at| VertexId::new(known[at].1)).map_err(|_| {
            let message = format!("walk {walk} goes through vertex {number}, which the model does not have");
            Error::invalid(message).in_file(place)
        })
    };
    let vertices = lists
        .iter()
        .enumerate()
        .map(|(walk, list)| list.iter().map(|&number| vertex(walk, number)).collect())
        .collect::<Result<Vec<Vec<VertexId>>, Error>>()?;
    let skeleton = surface.map.skeleton();
    ClosedWalk::from_vertices(skeleton, &vertices).map_err(|error| {
        // In the numbers of the file.
        let edges: BTreeSet<[u32; 2]> = skeleton
            .edge_ends()
            .chunks(2)
            .flat_map(|ends| [[ends[0], ends[1]], [ends[1], ends[0]]])
            .collect();
        for ((list, ids), walk) in lists.iter().zip(&vertices).zip(1..) {
            let missing =
                ids.windows(2).position(|pair| !edges.contains(&[pair[0].to_u32(), pair[1].to_u32()]));
            if let (Some(first), Some(last)) = (list.first(), list.last())
                && first != last
            {
                return Error::invalid(format!("walk {walk} starts at vertex {first} but ends at {last}"))
                    .with_cure("end with the vertex it starts with")
                    .in_file(place);
            }
            if let Some(step) = missing {
                let [from, to] = [list[step], list[step + 1]];
                return Error::invalid(format!(
                    "step {} of walk {walk} goes from vertex {from} to {to}, but no edge joins them",
                    step + 1
                ))
                .with_cure("go along edges only")
                .in_file(place);
            }
        }
        error.in_file(place)
    })
}
