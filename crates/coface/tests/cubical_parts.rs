//! Volumes of voxels: whole and block by block.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface::cellular::{CubicalBlocks, CubicalVolume, CuboidGrid};
use coface::chains::{PartTree, Parts};
use coface::topology::homology;
use proptest::prelude::*;

fn betti(volume: &CubicalVolume) -> Vec<usize> {
    homology(&volume.chain_complex().unwrap()).betti_numbers()
}

/// The volume block by block: the same homology, and cells that add up to the whole.
fn check(volume: &CubicalVolume, counts: &[u32], fan_in: u32) {
    let complex = volume.chain_complex().unwrap();
    let blocks = CubicalBlocks::new(volume, counts).unwrap();
    let mut ids = vec![Vec::new(); complex.degree_count()];
    for number in 0..blocks.part_count() {
        let part = blocks.part(number).unwrap();
        for (degree, ids) in ids.iter_mut().enumerate() {
            let own =
                part.ids(degree).iter().enumerate().filter(|&(cell, _)| part.key(degree, cell)[0] == number);
            ids.extend(own.map(|(_, &id)| id));
        }
    }
    assert_eq!(ids.iter().map(Vec::len).collect::<Vec<_>>(), complex.f_vector());
    for ids in &mut ids {
        ids.sort_unstable();
        assert!(ids.is_sorted_by(|a, b| a < b), "no cell is own to two blocks");
    }
    let tree = PartTree::new(&blocks, fan_in).unwrap();
    assert_eq!(homology(tree.root().complex()), homology(&complex));
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
