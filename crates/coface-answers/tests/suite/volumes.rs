//! Volumes of voxels: files that other programs wrote, and the homology of known ones.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_answers::{Report, homology_of_volume};
use coface_complexes::cubical::CubicalVolume;
use coface_io as io;
use coface_io::{ReadOptions, Structure, VolumeReading, VoxelRule};
use proptest::prelude::*;
use std::collections::BTreeSet;
use std::path::Path;

fn volume_of(name: &str, rule: VoxelRule) -> CubicalVolume {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../coface-io/tests/volumes").join(name);
    let options = ReadOptions::new().volume(VolumeReading { rule, ..VolumeReading::default() });
    match io::read_path_with(path, &options).unwrap().structure() {
        Some(Structure::Volume(volume)) => volume.clone(),
        _ => panic!("{name} holds no volume"),
    }
}

/// Written by numpy 2.4, nibabel 5 and pynrrd 1: the same twelve numbers in each, the first axis running fastest.
#[test]
fn files_of_other_programs_are_read() {
    const VALUES: [f64; 12] = [0.0, 1.0, 2.0, 3.0, 100.0, 0.0, 7.0, 7.0, 1.0, 0.0, 0.0, 5.0];
    let names = [
        "numpy_f4_c.npy",
        "numpy_i8_big_f.npy",
        "numpy_f2_c.npy",
        "numpy_version_2.npy",
        "numpy_bool_f.npy",
        "nibabel_1.nii.gz",
        "nibabel_2.nii",
        "nibabel_big.nii",
        "nibabel_scaled.nii",
        "nibabel_pair.hdr",
        "nibabel_pair.img",
        "pynrrd_gzip.nrrd",
        "pynrrd_raw_big.nrrd",
        "pynrrd_ascii.nrrd",
        "pynrrd_detached.nhdr",
    ];
    for name in names {
        for rule in
            [VoxelRule::Nonzero, VoxelRule::AtLeast(2.5), VoxelRule::Equal(7.0), VoxelRule::Between(1.0, 5.0)]
        {
            let volume = volume_of(name, rule);
            let expected = CubicalVolume::new(&[3, 2, 2], &[false; 3], |v| {
                let value = VALUES[(v[0] + 3 * (v[1] + 2 * v[2])) as usize];
                rule.holds(if name.contains("bool") { f64::from(value != 0.0) } else { value })
            });
            assert_eq!(volume, expected.unwrap(), "{name} {rule}");
        }
    }
}

fn betti(volume: &CubicalVolume) -> Vec<usize> {
    let (counts, homology) = homology_of_volume(volume).unwrap();
    let complex = volume.chain_complex().unwrap();
    assert_eq!(counts, complex.f_vector());
    assert_eq!(homology, coface_topology::homology(&complex));
    homology.betti_numbers()
}

fn distance(voxel: &[u32], center: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|axis| f64::from(voxel[axis]) + 0.5 - center[axis])
}

#[test]
fn known_solids_have_their_homology() {
    // Linked rings: one around the z axis, the other through it.
    let ring = |voxel: &[u32], center: [f64; 3], normal: usize, radius: f64| {
        let d = distance(voxel, center);
        let flat: f64 = (0..3).filter(|&axis| axis != normal).map(|axis| d[axis] * d[axis]).sum();
        (flat.sqrt() - radius).hypot(d[normal]) < 2.5
    };
    let first = |v: &[u32]| ring(v, [13.0, 12.0, 12.0], 2, 7.0);
    let second = |v: &[u32]| ring(v, [20.0, 12.0, 12.0], 1, 7.0);
    let shape = [33, 24, 24];
    let linked = CubicalVolume::new(&shape, &[false; 3], |v| first(v) || second(v)).unwrap();
    assert_eq!(betti(&linked), [2, 2, 0, 0]);
    let around = CubicalVolume::new(&shape, &[false; 3], |v| !(first(v) || second(v))).unwrap();
    // Alexander duality, the outside being a box: its loops go through the rings.
    assert_eq!(betti(&around), [1, 2, 2, 0]);
    let ball = CubicalVolume::new(&[20; 3], &[false; 3], |v| {
        let r = distance(v, [10.0; 3]).iter().map(|x| x * x).sum::<f64>().sqrt();
        (4.0..8.0).contains(&r)
    });
    assert_eq!(betti(&ball.unwrap()), [1, 0, 1, 0]);
    // A slab across two periodic axes is a thick torus.
    let slab = CubicalVolume::new(&[8, 8, 8], &[true, true, false], |v| v[2] == 3).unwrap();
    assert_eq!(betti(&slab), [1, 2, 1, 0]);
    assert_eq!(betti(&CubicalVolume::new(&[4, 4], &[true; 2], |_| false).unwrap()), [0; 3]);
}

/// The closed cubes of a set of voxels as a set of places, without anything of the library.
fn places(voxels: &[Vec<i64>]) -> BTreeSet<Vec<i64>> {
    let mut all = BTreeSet::new();
    for voxel in voxels {
        let mut cells = vec![Vec::new()];
        for &x in voxel {
            cells = cells
                .into_iter()
                .flat_map(|cell: Vec<i64>| (0..3).map(move |i| [&cell[..], &[2 * x + i]].concat()))
                .collect();
        }
        all.extend(cells);
    }
    all
}

/// The rank of a matrix over the field of 2 elements, given by its columns.
fn rank(columns: Vec<BTreeSet<usize>>) -> usize {
    let mut pivots: std::collections::BTreeMap<usize, BTreeSet<usize>> = std::collections::BTreeMap::new();
    for mut column in columns {
        while let Some(&low) = column.last() {
            match pivots.get(&low) {
                Some(pivot) => column = column.symmetric_difference(pivot).copied().collect(),
                None => {
                    pivots.insert(low, column);
                    break;
                }
            }
        }
    }
    pivots.len()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Cubes of up to three dimensions have no torsion: ranks over two elements tell all.
    #[test]
    fn random_voxels_have_the_homology_of_their_cubes(
        shape in prop::collection::vec(1u32..5, 1..4),
        bits in any::<u64>(),
        density in 1u64..4,
    ) {
        let mut voxels = Vec::new();
        let mut at = 0;
        let volume = CubicalVolume::new(&shape, &vec![false; shape.len()], |voxel| {
            at += 1;
            let is_set = bits.rotate_left(at * 11) & 3 < density;
            if is_set {
                voxels.push(voxel.iter().map(|&x| i64::from(x)).collect::<Vec<_>>());
            }
            is_set
        }).unwrap();
        let all = places(&voxels);
        let dimension = |cell: &[i64]| cell.iter().filter(|x| *x % 2 == 1).count();
        let mut cells: Vec<Vec<&Vec<i64>>> = vec![Vec::new(); shape.len() + 1];
        all.iter().for_each(|cell| cells[dimension(cell)].push(cell));
        let ranks: Vec<usize> = (0..=shape.len() + 1).map(|degree| {
            if degree == 0 || degree > shape.len() {
                return 0;
            }
            rank(cells[degree].iter().map(|cell| {
                (0..cell.len()).filter(|&axis| cell[axis] % 2 == 1).flat_map(|axis| [-1, 1].map(|step| {
                    let mut face = (*cell).clone();
                    face[axis] += step;
                    cells[degree - 1].binary_search(&&face).unwrap()
                })).collect()
            }).collect())
        }).collect();
        let expected: Vec<usize> = (0..=shape.len()).map(|k| cells[k].len() - ranks[k] - ranks[k + 1]).collect();
        let mut found = betti(&volume);
        found.resize(shape.len() + 1, 0);
        prop_assert_eq!(&found, &expected);
        let model = io::Model::from_structure(Structure::Volume(volume));
        let report = Report::of(model).unwrap();
        let signed: i64 = expected.iter().enumerate().map(|(k, &b)| if k % 2 == 0 { b as i64 } else { -(b as i64) }).sum();
        prop_assert_eq!(report.euler_characteristic(), signed);
        prop_assert_eq!(report.components(), expected[0]);
    }
}
