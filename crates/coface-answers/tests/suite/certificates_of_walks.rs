//! Walks on surfaces are compared by normal forms, and by the algorithm of Dehn in the checker, which shares no code with them.

use coface_answers::{GivenWalks, GroupsRequest, Producer, SurfaceLoops};
use proptest::prelude::*;
use std::collections::BTreeSet;

type Facets = Vec<[u32; 3]>;

fn torus() -> Facets {
    (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 2) % 7, (i + 3) % 7]]).collect()
}

fn plane() -> Facets {
    vec![
        [0, 1, 2],
        [0, 2, 3],
        [0, 3, 4],
        [0, 4, 5],
        [0, 1, 5],
        [1, 2, 4],
        [2, 4, 5],
        [2, 3, 5],
        [1, 3, 5],
        [1, 3, 4],
    ]
}

/// The connected sum: the last triangle of the one and the first of the other are removed, and their rims are one.
fn sum(one: &Facets, other: &Facets) -> Facets {
    let free = one.iter().flatten().max().map_or(0, |most| most + 1);
    let (rim, own) = (one[one.len() - 1], other[0]);
    let name = |vertex: u32| own.iter().position(|&o| o == vertex).map_or(vertex + free, |i| rim[i]);
    let others = other[1..].iter().map(|facet| facet.map(name));
    one[..one.len() - 1].iter().copied().chain(others).collect()
}

/// Closed surfaces of all kinds, and with a hole.
fn surfaces() -> Vec<Facets> {
    let (torus, plane) = (torus(), plane());
    let klein = sum(&plane, &plane);
    let mut all = vec![
        vec![[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]],
        plane.clone(),
        torus.clone(),
        klein.clone(),
        sum(&klein, &plane),
        sum(&torus, &torus),
        sum(&torus, &klein),
        sum(&sum(&torus, &torus), &torus),
    ];
    all.push(all[2][1..].to_vec());
    all.push(all[5][1..].to_vec());
    // Two of them, and a vertex.
    all.push(
        torus.iter().copied().chain(plane.iter().map(|facet| facet.map(|vertex| vertex + 10))).collect(),
    );
    all
}

struct Graph(Vec<Vec<u32>>);

impl Graph {
    fn of(facets: &Facets) -> Self {
        let most = facets.iter().flatten().max().map_or(0, |most| *most as usize);
        let mut neighbors = vec![BTreeSet::new(); most + 1];
        for facet in facets {
            for (a, b) in [(0, 1), (1, 2), (2, 0)] {
                neighbors[facet[a] as usize].insert(facet[b]);
                neighbors[facet[b] as usize].insert(facet[a]);
            }
        }
        Self(neighbors.into_iter().map(|own| own.into_iter().collect()).collect())
    }

    /// A path that takes the choices in turn.
    fn path(&self, from: u32, choices: &[usize]) -> Vec<u32> {
        let mut path = vec![from];
        for &choice in choices {
            let own = &self.0[path[path.len() - 1] as usize];
            path.push(own[choice % own.len()]);
        }
        path
    }

    /// A shortest path.
    fn back(&self, from: u32, to: u32) -> Vec<u32> {
        let mut before = vec![None; self.0.len()];
        let mut ready = std::collections::VecDeque::from([to]);
        before[to as usize] = Some(to);
        while let Some(at) = ready.pop_front() {
            for &next in &self.0[at as usize] {
                if before[next as usize].is_none() {
                    before[next as usize] = Some(at);
                    ready.push_back(next);
                }
            }
        }
        let mut path = vec![from];
        while path[path.len() - 1] != to {
            path.push(before[path[path.len() - 1] as usize].expect("the component is connected"));
        }
        path
    }

    /// A closed walk.
    fn closed(&self, from: u32, choices: &[usize]) -> Vec<u32> {
        let mut path = self.path(from, choices);
        let rest = self.back(path[path.len() - 1], from);
        path.extend(&rest[1..]);
        path
    }
}

/// Walks one after the other; a negative number is a walk backwards.
fn product(walks: &[Vec<u32>], letters: &[i32]) -> Vec<u32> {
    let mut all: Vec<u32> = Vec::new();
    for letter in letters {
        let mut own = walks[letter.unsigned_abs() as usize - 1].clone();
        if *letter < 0 {
            own.reverse();
        }
        let known = usize::from(!all.is_empty());
        all.extend(&own[known..]);
    }
    all
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn comparisons_of_walks_are_proved(
        which in 0usize..11,
        choices in prop::collection::vec(prop::collection::vec(0usize..12, 2..9), 3),
        (turn, base, is_canonical) in (0usize..9, 0u32..4, prop::bool::ANY),
        detour in prop::collection::vec(0usize..12, 0..5),
    ) {
        let facets = surfaces().swap_remove(which);
        let graph = Graph::of(&facets);
        let input = format!("{facets:?}").into_bytes();
        let producer = Producer::of(coface_io::read(&input[..], coface_io::Format::Json).expect("facets")).expect("a surface");
        let loops: Vec<Vec<u32>> = choices.iter().map(|choices| graph.closed(3, choices)).collect();
        // Homologous or not, these are often not homotopic.
        let mut walks: Vec<Vec<u32>> = [
            &[1][..], &[2], &[1, 2], &[2, 1], &[1, 2, -1, -2], &[2, -1, -2, 1], &[-1, 2, 1, -2], &[1, 3, -1, -3], &[1, 1, 2, 2], &[1, 2, 1, 2],
            &[1, 2, 3], &[1, 3, 2], &[3, 1, 2], &[1, -1],
        ]
        .iter()
        .map(|letters| product(&loops, letters))
        .collect();
        // One that begins elsewhere, with a path there and back.
        let mut turned = walks[10].clone();
        turned.pop();
        let by = turn % turned.len();
        turned.rotate_left(by);
        let start = turned[0];
        let path = graph.path(start, &detour);
        let around = path.iter().rev().chain(&turned[1..]).chain(&path).copied().collect();
        walks.push(around);
        if which == 10 {
            walks.extend([vec![11, 12, 10, 11], vec![11]]);
        }
        let kind = if is_canonical { SurfaceLoops::Canonical } else { SurfaceLoops::Any };
        let given = GivenWalks { place: "walks".to_owned(), walks };
        let request = GroupsRequest::new().surface_loops(kind).base(Some(base)).walks(Some(given));
        let found = request.found(&producer).expect("walks on a surface");
        let certificate = request.certificate(&found, &producer, &[("in.json", &input)]);
        let certificate = certificate.expect("the checker finds the same");
        let verdict = coface_check_walks::check(certificate.as_bytes(), &[&input]).expect("it has been checked");
        prop_assert_eq!(verdict.unchecked(), ["components.base"]);
        let pairs = found.homotopic_answer("in.json").expect("walks were compared").pairs;
        // Rotations and detours are freely homotopic.
        let pair = pairs.iter().find(|pair| pair.walks == [10, 14]).expect("a pair");
        prop_assert!(pair.freely_homotopic);
    }
}

#[test]
fn walks_that_bound_are_homologous_wherever_they_are() {
    let facets = "[[0,1,2],[3,4,5]]";
    let producer = Producer::of(coface_io::read(facets.as_bytes(), coface_io::Format::Json).expect("facets"))
        .expect("a surface");
    let walks = vec![vec![0, 1, 2, 0], vec![3, 4, 5, 3]];
    let request = GroupsRequest::new().walks(Some(GivenWalks { place: "walks".to_owned(), walks }));
    let found = request.found(&producer).expect("walks on a surface");
    let pair = &found.homotopic_answer("in.json").expect("walks were compared").pairs[0];
    assert!(pair.homologous && !pair.freely_homotopic && pair.homotopic.is_none());
}
