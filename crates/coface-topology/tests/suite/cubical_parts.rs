//! Volumes of voxels: whole and block by block.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_algebra::chains::{ChainComplex, PartTree, Partition, Parts};
use coface_complexes::cubical::{
    CubicalBlocks, CubicalVolume, FullVoxels, SimplicialBlocks, VoxelBox, VoxelWindow, Voxels,
};
use coface_complexes::grids::CuboidGrid;
use coface_complexes::simplicial::FrozenComplex;
use coface_topology::{homology, homology_of_parts};
use proptest::prelude::*;

fn betti(volume: &CubicalVolume) -> Vec<usize> {
    homology(&volume.chain_complex().unwrap()).betti_numbers()
}

/// Blocks have the homology of the whole, and cells that add up to it, with the keys of a partition whose owners are told by `owner` from
/// the id of a maximal cell.
fn check_parts(
    complex: &ChainComplex,
    whole: &impl Parts,
    parts: &impl Parts,
    fan_in: u32,
    owner: impl Fn(u64) -> u32,
) {
    let whole = whole.part(0).unwrap();
    assert_eq!(whole.complex(), complex);
    let partition =
        Partition::new(complex, parts.part_count(), |degree, cell| owner(whole.ids(degree)[cell as usize]));
    let partition = partition.unwrap();
    let mut own = vec![0; complex.degree_count()];
    for number in 0..parts.part_count() {
        let part = parts.part(number).unwrap();
        let other = partition.part(number).unwrap();
        // An empty part has no degrees in a partition.
        for degree in 0..complex.degree_count() {
            let ids: Vec<u64> =
                other.ids(degree).iter().map(|&cell| whole.ids(degree)[cell as usize]).collect();
            assert_eq!(part.ids(degree), ids);
            assert!((0..ids.len()).all(|cell| part.key(degree, cell) == other.key(degree, cell)));
            let empty = ids.is_empty();
            assert!(
                empty || part.complex().boundary_matrix(degree) == other.complex().boundary_matrix(degree)
            );
        }
        part.own_counts().iter().zip(&mut own).for_each(|(count, total)| *total += count);
    }
    assert_eq!(own, complex.f_vector());
    let tree = PartTree::new(parts, fan_in).unwrap();
    assert_eq!(homology(tree.root().complex()), homology(complex));
    assert_eq!(homology_of_parts(parts, fan_in).unwrap(), homology(complex));
}

/// The voxel of the cell at this place of a volume, given as one number, if it is a voxel.
fn voxel_of(volume: &CubicalVolume, mut place: u64) -> Vec<u32> {
    let mut voxel: Vec<u32> = Vec::new();
    for (&length, periodic) in volume.shape().iter().zip(volume.is_periodic()).rev() {
        let length = 2 * u64::from(length) + u64::from(!periodic);
        voxel.push((place % length / 2) as u32);
        place /= length;
    }
    voxel.reverse();
    voxel
}

/// The volume block by block, cubes and simplices.
fn check(volume: &CubicalVolume, counts: &[u32], fan_in: u32) {
    let one = vec![1; volume.shape().len()];
    let blocks = CubicalBlocks::new(volume, counts).unwrap();
    let block_of = |voxel: Vec<u32>| {
        let has = |number: &u32| {
            let VoxelBox { start, end } = blocks.voxels(*number);
            voxel.iter().zip(start.iter().zip(&end)).all(|(x, (start, end))| start <= x && x < end)
        };
        (0..blocks.part_count()).find(has).unwrap()
    };
    let whole = CubicalBlocks::new(volume, &one).unwrap();
    let complex = volume.chain_complex().unwrap();
    check_parts(&complex, &whole, &blocks, fan_in, |id| block_of(voxel_of(volume, id)));
    let simplices = SimplicialBlocks::new(volume, counts).unwrap();
    let whole = SimplicialBlocks::new(volume, &one).unwrap();
    let kinds = SimplicialBlocks::<CubicalVolume>::kind_count(one.len());
    let simplicial = volume.simplicial_chain_complex().unwrap();
    check_parts(&simplicial, &whole, &simplices, fan_in, |id| block_of(voxel_of(volume, id / kinds)));
    assert_eq!(homology(&simplicial), homology(&complex));
    // A block needs its window and no more.
    for number in 0..blocks.part_count() {
        let window = volume.window(&blocks.voxels(number)).unwrap();
        let words = window.words().to_vec();
        assert_eq!(
            words.len(),
            VoxelWindow::word_count(volume.shape(), volume.is_periodic(), window.inner()).unwrap()
        );
        let window =
            VoxelWindow::from_words(volume.shape(), volume.is_periodic(), &blocks.voxels(number), words)
                .unwrap();
        let from_window = CubicalBlocks::new(&window, counts).unwrap();
        assert_eq!(from_window.part(number).unwrap(), blocks.part(number).unwrap());
        let from_window = SimplicialBlocks::new(&window, counts).unwrap();
        assert_eq!(from_window.part(number).unwrap(), simplices.part(number).unwrap());
    }
}

#[test]
fn a_full_volume_is_a_grid_of_cuboids() {
    let volume = CubicalVolume::full(&[2, 3, 4], &[false; 3]).unwrap();
    let complex = volume.chain_complex().unwrap();
    assert_eq!(complex.f_vector(), CuboidGrid::new(&[2, 3, 4]).unwrap().f_vector());
    assert_eq!(betti(&volume), [1, 0, 0, 0]);
}

#[test]
fn periodic_axes_close() {
    for (shape, periodic, expected) in [
        (vec![1], vec![true], vec![1, 1]),
        (vec![2, 1], vec![true, true], vec![1, 2, 1]),
        (vec![3, 4, 5], vec![true, false, true], vec![1, 2, 1, 0]),
        (vec![2, 2, 2, 2], vec![true; 4], vec![1, 4, 6, 4, 1]),
    ] {
        let volume = CubicalVolume::full(&shape, &periodic).unwrap();
        assert_eq!(betti(&volume), expected, "{shape:?}");
        check(&volume, &vec![1; shape.len()], 2);
        check(&volume, &shape, 3);
    }
}

/// One critical cell a stratum: eight for each block of a torus.
#[test]
fn strata_of_blocks_are_balls() {
    let torus = CubicalVolume::full(&[12, 12, 12], &[true; 3]).unwrap();
    let blocks = CubicalBlocks::at_least(&torus, 27).unwrap();
    assert_eq!(blocks.counts(), [2, 4, 4]);
    let blocks = CubicalBlocks::new(&torus, &[3, 3, 3]).unwrap();
    let tree = PartTree::new(&blocks, 8).unwrap();
    assert_eq!(tree.critical_counts()[0].iter().sum::<usize>(), 8 * 27);
    assert_eq!(tree.root().complex().f_vector(), [1, 3, 3, 1]);
}

#[test]
fn impossible_volumes_are_refused() {
    assert!(CubicalVolume::full(&[], &[]).unwrap_err().to_string().contains("1 to 8 axes"));
    assert!(CubicalVolume::full(&[3, 0], &[false; 2]).unwrap_err().to_string().contains("axis 1"));
    assert!(CubicalVolume::full(&[u32::MAX; 3], &[false; 3]).is_err());
    let volume = CubicalVolume::full(&[3, 3], &[false; 2]).unwrap();
    assert!(CubicalBlocks::new(&volume, &[4, 1]).unwrap_err().to_string().contains("[4, 1]"));
    assert!(CubicalBlocks::new(&volume, &[1]).is_err());
    let outside = VoxelBox { start: vec![1, 0], end: vec![4, 1] };
    assert!(volume.window(&outside).unwrap_err().to_string().contains("[1, 0] to [4, 1]"));
    let window = volume.window(&VoxelBox { start: vec![0, 0], end: vec![1, 1] }).unwrap();
    assert!(window.window(&VoxelBox { start: vec![1, 1], end: vec![2, 2] }).is_err());
    assert!(
        CubicalBlocks::new(&window, &[3, 3]).unwrap().part(8).unwrap_err().to_string().contains("not known")
    );
    let inner = window.inner().clone();
    let words = |words| VoxelWindow::from_words(&[3, 3], &[false; 2], &inner, words);
    assert_eq!(words(vec![0b1111]).unwrap(), window);
    assert!(words(vec![0b11111]).is_err());
    assert!(words(vec![0, 0]).is_err());
    // Ids of 8 axes need the numbers of 545835 simplices a carrier.
    let long = FullVoxels::new(&[100; 8], &[false; 8]).unwrap();
    assert_eq!(SimplicialBlocks::<FullVoxels>::kind_count(8), 545_835);
    assert!(SimplicialBlocks::at_least(&long, 2).unwrap_err().to_string().contains("64-bit"));
}

#[test]
fn windows_of_windows_are_windows() {
    let volume =
        CubicalVolume::new(&[7, 9, 70], &[true, false, true], |v| (v[0] * 5 + v[1] * 3 + v[2]) % 7 < 3)
            .unwrap();
    let window = volume.window(&VoxelBox { start: vec![0, 2, 0], end: vec![4, 9, 66] }).unwrap();
    assert_eq!((window.starts(), window.lengths()), (&[6, 1, 69][..], &[6, 8, 68][..]));
    for (start, end) in [([0, 2, 0], [4, 9, 66]), ([1, 4, 3], [3, 6, 66]), ([0, 8, 0], [1, 9, 1])] {
        let inner = VoxelBox { start: start.to_vec(), end: end.to_vec() };
        assert_eq!(window.window(&inner).unwrap(), volume.window(&inner).unwrap());
    }
    for (x, y, z) in (0..7).flat_map(|x| (0..9).flat_map(move |y| (0..70).map(move |z| (x, y, z)))) {
        let known = x != 5 && y > 0 && z != 67 && z != 68;
        assert_eq!(window.contains(&[x, y, z]), known);
        assert_eq!(window.is_set(&[x, y, z]), known && volume.is_set(&[x, y, z]));
    }
}

#[test]
fn grids_of_simplices_are_those_of_the_cuboids() {
    for shape in [vec![5], vec![2, 3], vec![2, 3, 2], vec![1, 2, 2, 1]] {
        let volume = FullVoxels::new(&shape, &vec![false; shape.len()]).unwrap();
        let grid = CuboidGrid::new(&shape).unwrap();
        let frozen = FrozenComplex::from_facets(grid.simplices().unwrap().lists()).unwrap();
        let blocks = SimplicialBlocks::at_least(&volume, 4).unwrap();
        let whole = SimplicialBlocks::new(&volume, &vec![1; shape.len()]).unwrap().part(0).unwrap();
        assert_eq!(whole.complex().f_vector(), frozen.chain_complex().unwrap().f_vector());
        assert_eq!(PartTree::new(&blocks, 2).unwrap().root().complex().f_vector()[0], 1);
    }
    // Tori are periodic, however short an axis is.
    for shape in [[1, 1, 1], [2, 1, 3], [3, 3, 3]] {
        let torus = FullVoxels::new(&shape, &[true; 3]).unwrap();
        let whole = SimplicialBlocks::new(&torus, &[1; 3]).unwrap().part(0).unwrap();
        assert_eq!(homology(whole.complex()).betti_numbers(), [1, 3, 3, 1]);
        let count = shape.iter().product::<u32>() as usize;
        assert_eq!(whole.complex().f_vector(), [count, 7 * count, 12 * count, 6 * count]);
    }
}

#[test]
fn full_voxels_are_a_full_volume() {
    for periodic in [[false; 3], [true; 3], [true, false, true]] {
        let volume = CubicalVolume::full(&[5, 4, 3], &periodic).unwrap();
        let implicit = FullVoxels::new(&[5, 4, 3], &periodic).unwrap();
        for number in 0..4 {
            let [a, b] = [
                CubicalBlocks::at_least(&volume, 4).unwrap().part(number).unwrap(),
                CubicalBlocks::at_least(&implicit, 4).unwrap().part(number).unwrap(),
            ];
            assert_eq!(a, b);
        }
    }
}

proptest! {
    #[test]
    fn blocks_have_the_homology_of_the_volume(
        shape in prop::collection::vec(1u32..5, 1..4),
        periodic in any::<u8>(),
        bits in any::<u64>(),
        cuts in prop::collection::vec(1u32..5, 3),
        fan_in in 2u32..4,
    ) {
        let periodic: Vec<bool> = (0..shape.len()).map(|axis| periodic >> axis & 1 == 1).collect();
        let mut at = 0;
        let volume = CubicalVolume::new(&shape, &periodic, |_| {
            at += 1;
            bits.rotate_left(at * 5) & 3 != 0
        }).unwrap();
        let counts: Vec<u32> = shape.iter().zip(&cuts).map(|(&length, &cut)| cut.min(length)).collect();
        check(&volume, &counts, fan_in);
    }
}
