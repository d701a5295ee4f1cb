//! Complexes in shards, as bytes and as files: homology, torsion and generators are those of the whole, whatever the parts; damage and
//! mixtures are named; work that was cut off goes on to the same bytes.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_algebra::chains::{Chain, ChainComplex, Partition, Parts};
use coface_algebra::{CellId, ErrorKind};
use coface_algebra::{Integer, SparseMatrix, WideMatrix, invariant_factors};
use coface_complexes::known_spaces as spaces;
use coface_complexes::simplicial::SimplicialComplex;
use coface_geometry::Positions;
use coface_io as io;
use coface_io::{Format, Model, Structure};
use coface_scale::shards;
use coface_scale::shards::{
    Owners, ShardChains, ShardFolder, ShardPlace, ShardRequest, chains_below_merge, chains_on_cells, merge,
    reduce, root_chains, root_homology, shard_model, shard_of_part, sum_chains, summary,
};
use coface_topology::{HomologyBasis, homology};
use proptest::prelude::*;
use std::fs;
use std::path::Path;
use xxhash_rust::xxh3::{Xxh3, xxh3_64};

/// All shards and reduced shards of a tree, as bytes.
struct Tree {
    place: ShardPlace,
    shards: Vec<Vec<u8>>,
    /// From the leaves to the root.
    levels: Vec<Vec<Vec<u8>>>,
}

impl Tree {
    fn new(parts: &impl Parts, fan_in: u32) -> Self {
        let place = ShardPlace::new(0xc0face, parts.part_count(), fan_in, 0).unwrap();
        let shard = |number| shard_of_part(place.at(0, number), &parts.part(number).unwrap(), None).unwrap();
        let shards: Vec<Vec<u8>> = (0..parts.part_count()).map(shard).collect();
        let mut levels = vec![shards.iter().map(|shard| reduce(shard).unwrap()).collect::<Vec<_>>()];
        while !(levels.last().unwrap().len() == 1 && summary(&levels.last().unwrap()[0]).unwrap().is_root()) {
            let level = levels.len() as u32;
            let merged = (0..place.width(level)).map(|number| {
                let place = place.at(level, number);
                let children = place.children();
                let below = &levels[level as usize - 1];
                merge(place, &below[children.start as usize..children.end as usize]).unwrap()
            });
            levels.push(merged.collect());
        }
        Self { place, shards, levels }
    }

    fn root(&self) -> &[u8] {
        &self.levels.last().unwrap()[0]
    }

    fn generators(&self) -> ShardChains {
        let mut chains = root_chains(self.root()).unwrap();
        for level in (1..self.levels.len()).rev() {
            let below = &self.levels[level - 1];
            let pieces = (0..self.place.width(level as u32)).map(|number| {
                let place = self.place.at(level as u32, number);
                let children = place.children();
                chains_below_merge(place, &below[children.start as usize..children.end as usize], &chains)
                    .unwrap()
            });
            chains = sum_chains(&pieces.collect::<Vec<_>>()).unwrap();
        }
        let pieces: Vec<Vec<u8>> =
            self.shards.iter().map(|shard| chains_on_cells(shard, &chains).unwrap()).collect();
        ShardChains::from_bytes(&sum_chains(&pieces).unwrap()).unwrap()
    }
}

/// Cycles of the orders that there must be, whose free classes are a basis: the determinant of their coefficients on one is 1 or -1.
fn check_generators(complex: &ChainComplex, chains: &ShardChains) {
    let basis = HomologyBasis::unshortened(complex);
    for (degree, chains) in chains.degrees.iter().enumerate() {
        let orders: Vec<Option<Integer>> = chains.iter().map(|chain| chain.order.clone()).collect();
        assert_eq!(orders, basis.orders(degree));
        let rows: Vec<Vec<Integer>> = chains
            .iter()
            .map(|chain| {
                let terms =
                    chain.terms.iter().map(|term| (CellId::new(term.id as usize), term.coefficient.clone()));
                let cycle = Chain::new(complex, degree, terms).unwrap();
                assert!(complex.is_cycle(&cycle).unwrap());
                basis.class_of(&cycle).unwrap().coefficients().to_vec()
            })
            .collect();
        let free: Vec<usize> = (0..orders.len()).filter(|&i| orders[i].is_none()).collect();
        let columns = free.iter().map(|&i| (0..).zip(free.iter().map(|&j| rows[i][j].clone())).collect());
        let minor = WideMatrix::from_integer_columns(free.len(), columns).unwrap();
        assert_eq!(invariant_factors(&minor), vec![Integer::ONE; free.len()]);
    }
}

/// Everything that must hold of a complex in shards.
fn check(complex: &ChainComplex, partition: &Partition<'_>, fan_in: u32) {
    let tree = Tree::new(partition, fan_in);
    assert_eq!(root_homology(tree.root()).unwrap(), homology(complex));
    let root = summary(tree.root()).unwrap();
    let cells = root.cells();
    assert_eq!(cells.iter().map(|&count| count as usize).collect::<Vec<_>>(), complex.f_vector());
    let mut strata = 0;
    for (number, level) in tree.levels.iter().enumerate() {
        let mut signed = 0;
        for bytes in level {
            let summary = summary(bytes).unwrap();
            strata += if number == 0 { summary.strata() as usize } else { 0 };
            let signs = [1, -1].into_iter().cycle();
            signed +=
                summary.critical().iter().zip(signs).map(|(&count, sign)| sign * count as i64).sum::<i64>();
        }
        assert_eq!(signed, complex.euler_characteristic(), "level {number}");
    }
    assert_eq!(strata, partition.stratum_count());
    check_generators(complex, &tree.generators());
}

fn facets() -> impl Strategy<Value = ChainComplex> {
    let simplex =
        prop::collection::btree_set(0u32..9, 1..5).prop_map(|set| set.into_iter().collect::<Vec<u32>>());
    prop::collection::vec(simplex, 0..14)
        .prop_map(|facets| SimplicialComplex::from_facets(&facets).unwrap().chain_complex().unwrap())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn shards_have_the_homology_of_the_whole(
        complex in facets(),
        owners in prop::collection::vec(0u32..5, 30),
        part_count in 1u32..8,
        fan_in in 2u32..5,
    ) {
        check(&complex, &Partition::by_walk(&complex, part_count).unwrap(), fan_in);
        let owner = |degree: usize, cell: u32| owners[(7 * degree + cell as usize) % owners.len()];
        check(&complex, &Partition::new(&complex, 5, owner).unwrap(), fan_in);
    }

    /// Folder, bytes and memory agree.
    #[test]
    fn a_folder_has_the_homology_of_the_whole(complex in facets(), part_count in 1u32..6, seed in any::<bool>()) {
        let folder = tempfile::tempdir().unwrap();
        let mut request = ShardRequest::new("random", part_count);
        request.fan_in = 2;
        request.owners = if seed { Owners::Random } else { Owners::Walk };
        let model = Model::from_structure(Structure::Chains(complex.clone()));
        let shards = shard_model(model, folder.path(), &request).unwrap();
        (0..part_count).for_each(|number| drop(shards.reduce(number, false).unwrap()));
        let found = shards.merge_all(false).unwrap();
        prop_assert_eq!(found.homology(), &homology(&complex));
        check_generators(&complex, &shards.generators().unwrap());
        let partition = request.owners.partition(&complex, &Positions::default(), part_count).unwrap();
        let tree = Tree::new(&partition, 2);
        let strip = |bytes: &[u8]| summary(bytes).unwrap().critical().to_vec();
        for (level, parts) in tree.levels.iter().enumerate() {
            for (number, bytes) in parts.iter().enumerate() {
                let file = fs::read(shards.reduced_path(level as u32, number as u32)).unwrap();
                prop_assert_eq!(strip(&file), strip(bytes));
            }
        }
    }
}

/// Spaces with torsion, among them products and lens spaces, in 1, 2, 7, 64 shards, with random owners, and with one cell in each.
#[test]
fn torsion_comes_through_shards() {
    let klein = spaces::klein_grid(4, 4).unwrap().chain_complex().unwrap();
    let circle = SimplicialComplex::from_facets([[0, 1], [1, 2], [0, 2]]).unwrap().chain_complex().unwrap();
    let mut complexes: Vec<ChainComplex> = [
        spaces::klein_grid(7, 6),
        spaces::projective_plane(),
        spaces::real_projective_space(3),
        spaces::lens_space(5, 2),
        spaces::lens_space(3, 1),
        spaces::moore_space(6),
        spaces::torus_grid(&[4, 4, 4]),
    ]
    .into_iter()
    .map(|space| space.unwrap().chain_complex().unwrap())
    .collect();
    complexes.push(coface_algebra::chains::ProductComplex::new(&klein, &circle).unwrap().into_complex());
    for complex in &complexes {
        for part_count in [1, 2, 7, 64] {
            check(complex, &Partition::by_walk(complex, part_count).unwrap(), 2);
            check(complex, &Owners::Random.partition(complex, &Positions::default(), part_count).unwrap(), 8);
        }
    }
    let plane = &complexes[1];
    check(plane, &Partition::new(plane, 10, |_, cell| cell).unwrap(), 3);
}

#[test]
fn complexes_without_cells_or_edges_have_shards() {
    for complex in [ChainComplex::of_points(0), ChainComplex::of_points(5)] {
        for part_count in [1, 3] {
            check(&complex, &Partition::by_walk(&complex, part_count).unwrap(), 2);
        }
    }
}

/// A cell whose incidences are all 2 cancels with nothing, alone or together.
#[test]
fn cells_without_unit_incidence_stay_critical() {
    let matrices = vec![
        SparseMatrix::zero(1, 1).unwrap(),
        SparseMatrix::from_entries(1, 2, [(0, 0, 2), (0, 1, 2)]).unwrap(),
    ];
    let complex = ChainComplex::new(matrices).unwrap();
    let partition = Partition::new(&complex, 2, |_, cell| cell).unwrap();
    let tree = Tree::new(&partition, 2);
    for bytes in tree.levels.iter().flatten() {
        let whole = summary(bytes).unwrap();
        assert_eq!(whole.critical().iter().sum::<u64>(), whole.cells().iter().sum::<u64>());
    }
    check(&complex, &partition, 2);
}

/// Coefficients that double beyond 64 bits in each shard.
#[test]
fn columns_that_overflow_are_promoted() {
    let steps = 130;
    let entries = (0..steps).flat_map(|i| [(i, i, 1), (i + 1, i, -2)]).chain([(0, steps, 1)]);
    let complex = ChainComplex::new(vec![
        SparseMatrix::zero(1, steps + 1).unwrap(),
        SparseMatrix::from_entries(steps + 1, steps + 1, entries).unwrap(),
    ])
    .unwrap();
    let partition = Partition::new(&complex, 2, |_, cell| u32::from(cell >= 66)).unwrap();
    check(&complex, &partition, 2);
    let widest =
        Tree::new(&partition, 2).levels[0].iter().map(|bytes| summary(bytes).unwrap().widest()).max();
    assert!(widest.unwrap() > 64, "{widest:?}");
}

fn bottle() -> ChainComplex {
    spaces::klein_grid(4, 4).unwrap().chain_complex().unwrap()
}

/// A container whose section of a role and index is changed, with right checksums again.
fn forged(bytes: &[u8], role: u32, index: u32, change: impl FnOnce(&mut [u8])) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    let number = |bytes: &[u8], at: usize| u64::from_le_bytes(bytes[at..at + 8].try_into().unwrap()) as usize;
    let count = number(&bytes, 24) & 0xffff_ffff;
    let end = 64 + 40 * count;
    let row = (0..count)
        .map(|i| 64 + 40 * i)
        .find(|&at| bytes[at..at + 4] == role.to_le_bytes() && bytes[at + 4..at + 8] == index.to_le_bytes());
    let row = row.unwrap();
    let (start, length) = (number(&bytes, row + 16), number(&bytes, row + 24));
    change(&mut bytes[start..start + length]);
    let checksum = xxh3_64(&bytes[start..start + length]);
    bytes[row + 32..row + 40].copy_from_slice(&checksum.to_le_bytes());
    let mut hash = Xxh3::new();
    hash.update(&bytes[..32]);
    hash.update(&bytes[40..end]);
    let checksum = hash.digest();
    bytes[32..40].copy_from_slice(&checksum.to_le_bytes());
    bytes
}

/// Role 14: the hashes of shared faces.
#[test]
fn neighbors_that_disagree_are_named_with_their_shared_faces() {
    let complex = bottle();
    let tree = Tree::new(&Partition::by_walk(&complex, 4).unwrap(), 2);
    let mut leaves = tree.levels[0].clone();
    assert!(merge(tree.place.at(1, 0), &leaves[..2]).is_ok());
    leaves[1] = forged(&leaves[1], 14, 0, |hashes| hashes.iter_mut().for_each(|byte| *byte ^= 1));
    let error = merge(tree.place.at(1, 0), &leaves[..2]).unwrap_err();
    assert!(
        error.to_string().contains("part 0 and part 1 disagree")
            && error.to_string().contains("the faces shared by the parts"),
        "{error}"
    );
    // Neighbors that meet two levels later.
    let mut leaves = tree.levels[0].clone();
    leaves[3] = forged(&leaves[3], 14, 0, |hashes| hashes.iter_mut().for_each(|byte| *byte ^= 1));
    let right = merge(tree.place.at(1, 1), &leaves[2..]);
    let error =
        right.and_then(|right| merge(tree.place.at(2, 0), &[tree.levels[1][0].clone(), right])).unwrap_err();
    assert!(error.to_string().contains("disagree"), "{error}");
}

#[test]
fn every_flipped_bit_of_a_shard_and_what_is_made_of_it_is_seen() {
    let complex = SimplicialComplex::from_facets([[0, 1], [1, 2], [0, 2]]).unwrap().chain_complex().unwrap();
    let tree = Tree::new(&Partition::by_walk(&complex, 2).unwrap(), 2);
    let chains = root_chains(tree.root()).unwrap();
    let flips = |bytes: &[u8], fails: &dyn Fn(&[u8]) -> coface_algebra::Error| {
        for at in 0..bytes.len() {
            let mut damaged = bytes.to_vec();
            damaged[at] ^= 1 << (at % 8);
            let error = fails(&damaged);
            assert!(error.byte().is_some() && error.cure().is_some(), "byte {at}: {error}");
        }
        for length in 0..bytes.len() {
            fails(&bytes[..length]);
        }
    };
    flips(&tree.shards[0], &|bytes| reduce(bytes).unwrap_err());
    flips(&tree.levels[0][0], &|bytes| summary(bytes).unwrap_err());
    flips(tree.root(), &|bytes| root_homology(bytes).unwrap_err());
    flips(&chains, &|bytes| ShardChains::from_bytes(bytes).unwrap_err());
}

#[test]
fn lies_in_sections_are_errors() {
    let complex = bottle();
    let tree = Tree::new(&Partition::by_walk(&complex, 2).unwrap(), 2);
    let (shard, left) = (&tree.shards[0], &tree.levels[0][0]);
    // 1 place, 2 counts, 3 starts, 4 rows, 5 entries, 8 ids, 9 keys, 10 and 11 key sets, 12 to 14 walls.
    for (role, index) in [(1, 0), (2, 0), (3, 1), (4, 1), (5, 2), (8, 0), (9, 0), (10, 0), (11, 0)] {
        let lie = forged(shard, role, index, |bytes| bytes.fill(0xff));
        assert!(reduce(&lie).is_err(), "section {role} {index}");
        let lie = forged(left, role, index, |bytes| bytes.fill(0xff));
        // Sections without a number cannot lie, and one id or entry may be any.
        assert!(summary(&lie).is_err() || lie == *left || matches!(role, 5 | 8), "section {role} {index}");
    }
    for role in [12, 14] {
        let lie = forged(left, role, u32::from(role == 14), |bytes| bytes.fill(0xff));
        assert!(summary(&lie).is_err(), "section {role}");
    }
    for role in [1, 8, 16, 18, 19] {
        let chains = forged(&root_chains(tree.root()).unwrap(), role, 0, |bytes| bytes.fill(0xff));
        let read = ShardChains::from_bytes(&chains);
        assert!(read.is_err() || matches!(role, 8 | 19), "section {role}: {read:?}");
    }
}

#[test]
fn shards_that_do_not_belong_together_are_refused() {
    let complex = bottle();
    let partition = Partition::by_walk(&complex, 3).unwrap();
    let tree = Tree::new(&partition, 3);
    let [a, b, c] = &tree.levels[0][..] else { panic!("three parts") };
    let place = tree.place.at(1, 0);
    let fails = |children: &[&Vec<u8>], words: &str| {
        let children: Vec<&[u8]> = children.iter().map(|bytes| &bytes[..]).collect();
        let error = merge(place, &children).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::InvalidInput);
        assert!(error.to_string().contains(words) && error.cure().is_some(), "{error}");
    };
    fails(&[a, b], "2 reduced shards");
    fails(&[a, c, b], "in the place of part 1");
    let other = ShardPlace::new(1, 3, 3, 1).unwrap();
    let other = reduce(&shard_of_part(other, &partition.part(1).unwrap(), None).unwrap()).unwrap();
    fails(&[a, &other, c], "another complex");
    // Cut in another way, under the number of the complex.
    let walk = Owners::Random.partition(&complex, &Positions::default(), 3).unwrap();
    let liar = reduce(&shard_of_part(tree.place.at(0, 1), &walk.part(1).unwrap(), None).unwrap()).unwrap();
    fails(&[a, &liar, c], "disagree");
    assert!(root_homology(a).unwrap_err().to_string().contains("merge"));
    assert!(reduce(a).unwrap_err().to_string().contains("holds a reduced shard"));
    assert!(merge(tree.place.at(2, 0), &[tree.root()]).unwrap_err().to_string().contains("nothing is left"));
    let chains = root_chains(tree.root()).unwrap();
    assert!(chains_on_cells(&tree.shards[0], &chains).unwrap_err().to_string().contains("level 1"));
    assert!(sum_chains(&[chains, root_chains(Tree::new(&partition, 2).root()).unwrap()]).is_err());
    assert!(sum_chains::<Vec<u8>>(&[]).is_err());
    assert!(ShardPlace::new(0, 0, 2, 0).is_err() && ShardPlace::new(0, 1, 1, 0).is_err());
    assert!(shard_of_part(tree.place.at(0, 2), &partition.part(1).unwrap(), None).is_err());
}

/// The same bytes, whatever the number of threads and however often.
#[test]
fn bytes_do_not_depend_on_threads() {
    let complex = spaces::torus_grid(&[6, 6]).unwrap().chain_complex().unwrap();
    let partition = Partition::by_walk(&complex, 5).unwrap();
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| Tree::new(&partition, 2).levels)
    };
    assert!(with(1) == with(3));
}

fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut files: Vec<(String, Vec<u8>)> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap())
        .map(|entry| (entry.file_name().into_string().unwrap(), fs::read(entry.path()).unwrap()))
        .collect();
    files.sort();
    files
}

fn torus_in(folder: &Path, part_count: u32) -> ShardFolder {
    let torus = spaces::torus_grid(&[9, 9]).unwrap().chain_complex().unwrap();
    let mut request = ShardRequest::new("torus", part_count);
    request.fan_in = 3;
    shard_model(Model::from_structure(Structure::Chains(torus)), folder, &request).unwrap()
}

#[test]
fn work_goes_on_where_it_was_cut_off() {
    let folder = tempfile::tempdir().unwrap();
    let shards = torus_in(folder.path(), 7);
    for number in 0..7 {
        assert!(shards.reduce(number, false).unwrap().is_new());
    }
    let whole = shards.merge_all(false).unwrap();
    assert_eq!((whole.homology().betti_numbers(), whole.levels().len()), (vec![1, 2, 1], 3));
    let before = files(folder.path());
    assert_eq!(before.len(), 1 + 7 + 7 + 3 + 1);
    // Finished: nothing is made again, until it is damaged, gone, or of something else.
    assert!(!shards.reduce(3, false).unwrap().is_new() && shards.reduce(3, true).unwrap().is_new());
    assert!(!shards.merge(1, 1, false).unwrap().is_new());
    let path = shards.reduced_path(0, 3);
    fs::write(&path, &fs::read(&path).unwrap()[..100]).unwrap();
    assert!(shards.reduced_shards().unwrap_err().to_string().contains("coface reduce"));
    fs::remove_file(shards.reduced_path(0, 5)).unwrap();
    fs::remove_file(shards.reduced_path(1, 2)).unwrap();
    let mut bytes = fs::read(shards.reduced_path(2, 0)).unwrap();
    bytes[300] ^= 4;
    fs::write(shards.reduced_path(2, 0), bytes).unwrap();
    assert!(shards.reduce(3, false).unwrap().is_new() && shards.reduce(5, false).unwrap().is_new());
    assert!(shards.merge(1, 2, false).unwrap().is_new() && !shards.merge(1, 0, false).unwrap().is_new());
    assert_eq!(shards.merge_all(false).unwrap().homology(), whole.homology());
    assert!(files(folder.path()) == before, "the same bytes");
    // A second time by the same call, and as another program finds it.
    torus_in(folder.path(), 7);
    assert!(files(folder.path()) == before);
    assert_eq!(ShardFolder::open(folder.path()).unwrap().manifest(), shards.manifest());
}

#[test]
fn what_is_missing_or_of_another_complex_is_named() {
    let folder = tempfile::tempdir().unwrap();
    assert!(ShardFolder::open(folder.path()).unwrap_err().to_string().contains("coface shard"));
    let shards = torus_in(folder.path(), 5);
    shards.reduce(2, false).unwrap();
    let error = shards.merge_all(false).unwrap_err().to_string();
    assert!(
        error.contains("4 of 5 parts") && error.contains("part-000000.shard") && error.contains("..."),
        "{error}"
    );
    // Other shards in the same folder, only on request.
    let request = ShardRequest::new("bottle", 5);
    let bottle = || Model::from_structure(Structure::Chains(bottle()));
    let error = shard_model(bottle(), folder.path(), &request).unwrap_err();
    assert!(error.to_string().contains("--force"), "{error}");
    let mut force = request;
    force.replaces = true;
    let other = shard_model(bottle(), folder.path(), &force).unwrap();
    // The reduced shard of the torus is not of this shard.
    let error = other.merge_all(false).unwrap_err().to_string();
    assert!(error.contains("another complex"), "{error}");
    assert!((0..5).all(|number| other.reduce(number, false).unwrap().is_new()));
    assert_eq!(other.merge_all(false).unwrap().homology(), &homology(&self::bottle()));
    // A shard of somebody else under the name of one of ours.
    let elsewhere = tempfile::tempdir().unwrap();
    let torus = torus_in(elsewhere.path(), 5);
    fs::copy(torus.shard_path(1), other.shard_path(1)).unwrap();
    assert!(other.merge_all(false).unwrap_err().to_string().contains("1 of 5 parts"));
    assert!(other.reduce(1, false).unwrap_err().to_string().contains("another complex"));
    for (name, text) in
        [("a", "{"), ("b", "{}"), ("c", "{\"coface_shards\":9}"), ("d", "{\"coface_shards\":1}")]
    {
        fs::write(folder.path().join("shards.json"), text).unwrap();
        let error = ShardFolder::open(folder.path()).unwrap_err();
        assert!(error.cure().is_some() && error.to_string().contains("shards.json"), "{name}: {error}");
    }
    let error = shards::reduce_file(&folder.path().join("shards.json"), false).unwrap_err().to_string();
    assert!(error.contains(".shard"), "{error}");
    assert!(
        shards::reduce_file(&folder.path().join("none.shard"), false)
            .unwrap_err()
            .to_string()
            .contains("no such file")
    );
}

#[test]
fn cells_of_generators_are_named_by_vertices() {
    let folder = tempfile::tempdir().unwrap();
    // Vertex numbers with gaps.
    let model = io::read(&b"[[10,20],[20,30],[10,30],[30,40]]"[..], Format::Json).unwrap();
    let shards = shard_model(model, folder.path(), &ShardRequest::new("circle", 3)).unwrap();
    (0..3).for_each(|number| drop(shards.reduce(number, false).unwrap()));
    shards.merge_all(false).unwrap();
    let chains = shards.generators().unwrap();
    let mut names: Vec<Vec<u64>> = chains.degrees[1][0].terms.iter().map(|term| term.name.clone()).collect();
    names.iter_mut().for_each(|name| name.sort_unstable());
    names.sort();
    assert_eq!(names, [[10, 20], [10, 30], [20, 30]]);
}

#[test]
fn owners_are_those_asked_for() {
    let path = SimplicialComplex::from_facets((0..8).map(|i| [i, i + 1]).collect::<Vec<_>>())
        .unwrap()
        .chain_complex()
        .unwrap();
    let positions =
        Positions::from_flat(2, (0..9).flat_map(|i| [f64::from(i % 3), f64::from(i)]).collect()).unwrap();
    let edges = |owners: &Owners, part: u32| {
        owners.partition(&path, &positions, 3).unwrap().part(part).unwrap().ids(1).to_vec()
    };
    assert_eq!(edges(&Owners::Automatic, 0), [0, 1]);
    assert_eq!((edges(&Owners::Positions, 1), edges(&Owners::Positions, 2)), (vec![2, 3, 4], vec![5, 6, 7]));
    assert_eq!(edges(&Owners::Listed(vec![2, 0, 0, 0, 1, 1, 1, 2]), 2), [0, 7]);
    assert!(
        Owners::Listed(vec![0]).partition(&path, &positions, 3).unwrap_err().to_string().contains("8 cells")
    );
    assert!(
        Owners::Listed(vec![3; 8])
            .partition(&path, &positions, 3)
            .unwrap_err()
            .to_string()
            .contains("part 3")
    );
    assert!(Owners::Positions.partition(&path, &Positions::default(), 3).is_err());
    let random: usize = (0..3).map(|part| edges(&Owners::Random, part).len()).sum();
    assert_eq!(random, 8);
}

/// Found by fuzzing: a list that says 4,294,967,295 parts took memory and time for each of them.
#[test]
fn a_list_of_more_parts_than_files_is_answered_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let model = io::read(&b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"[..], Format::Json).unwrap();
    let shards = shard_model(model, &folder.path().join("s"), &ShardRequest::new("sphere", 3)).unwrap();
    shards.reduce(1, false).unwrap();
    let list = shards.path().join("shards.json");
    let text = fs::read_to_string(&list).unwrap();
    fs::write(&list, text.replace("\"parts\": 3", "\"parts\": 4294967295")).unwrap();
    fs::write(shards.path().join("part-1.reduced"), "is no name of a part").unwrap();
    let shards = ShardFolder::open(shards.path()).unwrap();
    assert_eq!(shards.manifest().part_count, u32::MAX);
    // The reduced part is of a complex of three.
    assert!(shards.reduced_shards().is_err());
    fs::remove_file(shards.reduced_path(0, 1)).unwrap();
    let error = shards.merge_all(false).unwrap_err();
    assert!(error.to_string().contains("4294967295 of 4294967295 parts are not reduced"), "{error}");
    assert!(error.cure().is_some_and(|cure| cure.ends_with("part-000002.shard ...")), "{error}");
}
