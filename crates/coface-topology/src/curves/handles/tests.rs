//! Handle loops and tunnel loops against the homology of what is inside and outside, and against searches from all vertices.

use super::linking_matrix::LinkingMatrix;
use super::*;
use crate::curves::intersection_number;
use crate::curves::root_search::{RootSearch, without_tail};
use coface_complexes::surface::linking_terms;
use coface_complexes::surface::samples::{Places, cubes, drilled_cube, genus, map_of, trefoil, tube};
use proptest::prelude::*;
use std::collections::BTreeMap;

type Place = [i32; 3];

/// Which cycles of lattice edges bound in a set of unit cubes, modulo a prime: by elimination of the boundaries of squares.
struct Inside {
    numbers: BTreeMap<(Place, usize), usize>,
    rows: BTreeMap<usize, Vec<(usize, i64)>>,
}

const PRIME: i64 = 1_000_003;

impl Inside {
    fn new(cells: &[Place]) -> Self {
        let mut inside = Self { numbers: BTreeMap::new(), rows: BTreeMap::new() };
        for &cell in cells {
            for axis in 0..3 {
                for side in [0, 1] {
                    let mut corner = cell;
                    corner[axis] += side;
                    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
                    let [mut far_j, mut far_k] = [corner; 2];
                    far_j[j] += 1;
                    far_k[k] += 1;
                    let square = [(corner, j, 1), (far_j, k, 1), (far_k, j, -1), (corner, k, -1)];
                    let chain = inside.chain(&square);
                    inside.add(chain);
                }
            }
        }
        inside
    }

    fn chain(&mut self, edges: &[(Place, usize, i64)]) -> BTreeMap<usize, i64> {
        let mut chain = BTreeMap::new();
        for &(at, axis, sign) in edges {
            let next = self.numbers.len();
            let number = *self.numbers.entry((at, axis)).or_insert(next);
            *chain.entry(number).or_insert(0) += sign;
        }
        chain
    }

    fn reduced(&self, mut chain: BTreeMap<usize, i64>) -> BTreeMap<usize, i64> {
        let mut done = BTreeMap::new();
        while let Some((edge, value)) = chain.pop_last() {
            let value = value.rem_euclid(PRIME);
            if value == 0 {
                continue;
            }
            match self.rows.get(&edge) {
                None => {
                    done.insert(edge, value);
                }
                Some(row) => row.iter().filter(|(other, _)| *other != edge).for_each(|&(other, x)| {
                    let entry = chain.entry(other).or_insert(0);
                    *entry = (*entry - value * x).rem_euclid(PRIME);
                }),
            }
        }
        done
    }

    fn add(&mut self, chain: BTreeMap<usize, i64>) {
        let rest = self.reduced(chain);
        let Some((&edge, &value)) = rest.last_key_value() else { return };
        let inverse = (0..20).fold((1i64, value, PRIME - 2), |(result, square, power), _| {
            let result = if power & 1 == 1 { result * square % PRIME } else { result };
            (result, square * square % PRIME, power >> 1)
        });
        self.rows.insert(edge, rest.into_iter().map(|(other, x)| (other, x * inverse.0 % PRIME)).collect());
    }

    /// Whether a closed walk through lattice points, along edges and diagonals of squares, bounds.
    fn bounds(&mut self, walk: &[Place]) -> bool {
        let mut edges = Vec::new();
        for pair in walk.windows(2) {
            let mut at = pair[0];
            for axis in 0..3 {
                match pair[1][axis] - at[axis] {
                    0 => {}
                    1 => {
                        edges.push((at, axis, 1));
                        at[axis] += 1;
                    }
                    _ => {
                        at[axis] -= 1;
                        edges.push((at, axis, -1));
                    }
                }
            }
        }
        let chain = self.chain(&edges);
        self.reduced(chain).is_empty()
    }
}

fn lengths_of(map: &GeneralizedMap, positions: &Places) -> Vec<f64> {
    positions.distances(map.skeleton().edge_ends()).unwrap()
}

fn found(map: &GeneralizedMap, positions: &Places) -> Vec<HandlePair> {
    let lengths = lengths_of(map, positions);
    let linking = |edges: &[EdgeId]| linking_terms(map, positions, edges);
    handle_pairs(map, Some(&lengths), &linking, 100_000_000).unwrap()
}

/// The lengths of the shortest independent loops of a kind among the edges closed up along shortest paths from any vertex, by elimination.
fn from_all_vertices(map: &GeneralizedMap, positions: &Places, kind: HandleKind) -> Vec<f64> {
    let lengths = lengths_of(map, positions);
    let trees = TreeCotree::new(map);
    let homology = SurfaceHomology::new(map, &trees);
    let linking = |edges: &[EdgeId]| linking_terms(map, positions, edges);
    let linking = LinkingMatrix::new(map, &trees, &homology, &linking).unwrap();
    let mut loops = Vec::new();
    let mut search = RootSearch::new(map, &lengths);
    for root in 0..map.vertex_count() as u32 {
        search.run(root, f64::INFINITY);
        for closing in search.closings(f64::INFINITY).collect::<Vec<_>>() {
            let steps = without_tail(search.loop_through(closing.edge));
            let length: f64 = steps.iter().map(|step| lengths[(step >> 1) as usize]).sum();
            let class = homology.class_of_walk(&ClosedWalk::new(map.skeleton(), steps).unwrap()).unwrap();
            if linking.kind(&class) == Some(kind) {
                loops.push((length, class));
            }
        }
    }
    loops.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut rows: Vec<(usize, Vec<i64>)> = Vec::new();
    let mut kept = Vec::new();
    for (length, mut class) in loops {
        for (pivot, row) in &rows {
            if class[*pivot] % 2 != 0 {
                class.iter_mut().zip(row).for_each(|(a, b)| *a += b);
            }
        }
        if let Some(pivot) = class.iter().position(|x| x % 2 != 0) {
            rows.push((pivot, class));
            kept.push(length);
        }
    }
    kept
}

fn check_lengths(map: &GeneralizedMap, positions: &Places, pairs: &[HandlePair]) {
    for (kind, of_kind) in [
        (HandleKind::Handle, HandlePair::handle as fn(&HandlePair) -> &ShortestCycle),
        (HandleKind::Tunnel, HandlePair::tunnel),
    ] {
        let mut own: Vec<f64> = pairs.iter().map(|pair| of_kind(pair).length()).collect();
        own.sort_by(f64::total_cmp);
        let expected = from_all_vertices(map, positions, kind);
        if expected.len() == pairs.len() {
            let sums: [f64; 2] = [own.iter().sum(), expected.iter().sum()];
            // From some vertices the shortest loop of a kind is no edge closed up along shortest paths.
            assert!(sums[0] > sums[1] - 1e-9 && sums[0] < 1.25 * sums[1], "{kind:?}: {own:?} {expected:?}");
        }
    }
}

fn check_crossings(map: &GeneralizedMap, pairs: &[HandlePair]) {
    for pair in pairs {
        let crossings = intersection_number(map, pair.handle().walk(), pair.tunnel().walk()).unwrap();
        assert!(crossings % 2 != 0, "{crossings}");
    }
}

fn check_cubes(tunnels: u32, turned: u64) {
    let cells = drilled_cube(tunnels);
    let (map, positions) = cubes(&cells, turned);
    let genera: usize = map.surfaces().iter().map(|surface| surface.genus()).sum();
    let pairs = found(&map, &positions);
    assert_eq!(pairs.len(), genera);
    assert!(pairs.windows(2).all(|pair| pair[0].length() <= pair[1].length()));
    let mut inside = Inside::new(&cells);
    let around = (-1..6).flat_map(|x| (-1..6).flat_map(move |y| (-1..6).map(move |z| [x, y, z])));
    let mut outside = Inside::new(&around.filter(|cell| !cells.contains(cell)).collect::<Vec<_>>());
    for pair in &pairs {
        for (cycle, is_handle) in [(pair.handle(), true), (pair.tunnel(), false)] {
            let places: Vec<Place> = cycle
                .walk()
                .vertices(map.skeleton())
                .into_iter()
                .map(|vertex| [0, 1, 2].map(|axis| positions.point(vertex)[axis] as i32))
                .collect();
            assert_eq!(
                [inside.bounds(&places), outside.bounds(&places)],
                [is_handle, !is_handle],
                "{places:?}"
            );
        }
    }
    check_crossings(&map, &pairs);
    check_lengths(&map, &positions, &pairs);
}

#[test]
fn loops_of_knotted_tubes_bound_on_their_side() {
    for (map, positions) in [
        tube(trefoil, [60, 6], 0.3),
        tube(|t| [3.0 * t.cos(), 3.0 * t.sin(), 0.0], [24, 8], 1.0),
        // Twice around an axis.
        tube(
            |t| [(2.0 + t.cos()) * (2.0 * t).cos(), (2.0 + t.cos()) * (2.0 * t).sin(), t.sin()],
            [60, 6],
            0.25,
        ),
    ] {
        let pairs = found(&map, &positions);
        assert_eq!(pairs.len(), 1);
        // Around the tube, in a circle.
        assert!(pairs[0].handle().walk().len() <= 8 && pairs[0].shorter() == HandleKind::Handle);
        assert!(pairs[0].tunnel().length() > 5.0);
        check_crossings(&map, &pairs);
        check_lengths(&map, &positions, &pairs);
    }
}

#[test]
fn surfaces_without_an_inside_are_refused() {
    let nothing = |_: &[EdgeId]| Ok(Vec::new());
    let klein = map_of(coface_complexes::known_spaces::klein_grid(4, 4));
    let error = handle_pairs(&klein, None, &nothing, 1_000).unwrap_err();
    assert!(error.message().contains("is not orientable"), "{}", error.message());
    let disk = map_of(coface_complexes::known_spaces::simplex(2));
    let error = handle_pairs(&disk, None, &nothing, 1_000).unwrap_err();
    assert!(error.message().contains("has a boundary"), "{}", error.message());
    // No surface in space has these linking numbers.
    let error = handle_pairs(&genus(2), None, &nothing, 1_000).unwrap_err();
    assert!(error.message().contains("meets itself"), "{}", error.message());
    let sphere = map_of(coface_complexes::known_spaces::simplex_boundary(2));
    assert_eq!(handle_pairs(&sphere, None, &nothing, 1_000).unwrap(), []);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    #[test]
    fn loops_of_drilled_cubes_bound_on_their_side(tunnels in 0u32..4096, turned in any::<u64>()) {
        check_cubes(tunnels, turned);
    }

    #[test]
    fn loops_below_a_length_are_those_of_pairs(tunnels in 0u32..4096, turned in any::<u64>(), below in 1.0f64..24.0) {
        let (map, positions) = cubes(&drilled_cube(tunnels), turned);
        let lengths = lengths_of(&map, &positions);
        let linking = |edges: &[EdgeId]| linking_terms(&map, &positions, edges);
        let short = short_handle_loops(&map, Some(&lengths), &linking, below, usize::MAX).unwrap();
        prop_assert!(short.is_complete());
        prop_assert!(short.loops().iter().all(|(_, cycle)| cycle.length() < below));
        let mut own: Vec<f64> = short.loops().iter().map(|(_, cycle)| cycle.length()).collect();
        let mut expected: Vec<f64> = found(&map, &positions)
            .iter()
            .flat_map(|pair| [pair.handle().length(), pair.tunnel().length()])
            .filter(|length| *length < below)
            .collect();
        own.sort_by(f64::total_cmp);
        expected.sort_by(f64::total_cmp);
        prop_assert_eq!(own.len(), expected.len());
        prop_assert!(own.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-9));
    }
}
