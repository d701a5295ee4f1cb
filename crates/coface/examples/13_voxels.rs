//! Guide 13: volumes of voxels: cubes, their homology, their surface, periodic axes, and blocks that are reduced alone.
//!
//! Run with `cargo run -p coface --example 13_voxels`.

use coface::complexes::cubical::CubicalVolume;
use coface::complexes::surface::PolygonMesh;
use coface::geometry::MassProperties;
use coface::topology::homology;

fn main() -> Result<(), coface::Error> {
    // A cube of 3 by 3 by 3 voxels without the one in the middle: a cavity, so the second Betti number is 1.
    let hollow = CubicalVolume::new(&[3, 3, 3], &[false; 3], |voxel| voxel != [1, 1, 1])?;
    assert_eq!(hollow.set_count(), 26);
    let complex = hollow.chain_complex()?;
    // The cavity takes one cube away and none of its sides: 4^3 vertices, 3 * 4^2 * 3 edges, 3 * 4 * 3^2 squares, 26 cubes.
    assert_eq!(complex.f_vector(), [64, 144, 108, 26]);
    assert_eq!(homology(&complex).betti_numbers(), [1, 0, 1, 0]);

    // A channel along the first axis instead: a solid ring, with one loop.
    let ring = CubicalVolume::new(&[3, 3, 3], &[false; 3], |voxel| voxel[1] != 1 || voxel[2] != 1)?;
    assert_eq!(homology(&ring.chain_complex()?).betti_numbers(), [1, 1, 0, 0]);

    // Its surface is a torus of squares: 9 - 1 at each end, 3 * 12 outside and 3 * 4 along the channel. They look outward, so the volume is that
    // of the voxels, 24.
    let (positions, squares) = ring.boundary_squares()?;
    assert_eq!(squares.len(), 2 * 8 + 3 * 12 + 3 * 4);
    let surface = PolygonMesh::new(positions.len(), squares.clone(), &[])?;
    assert_eq!(homology(&surface.chain_complex()?).betti_numbers(), [1, 2, 1]);
    let mass = MassProperties::enclosed(&positions, &squares).expect("the surface is closed");
    assert!((mass.volume() - 24.0).abs() < 1e-9);

    // Voxels that share only an edge are connected, since their closed cubes are: two of them on a diagonal are one component.
    let diagonal = CubicalVolume::new(&[2, 2], &[false; 2], |voxel| voxel[0] == voxel[1])?;
    let complex = diagonal.chain_complex()?;
    assert_eq!((complex.f_vector(), homology(&complex).betti_numbers()), (&[7, 8, 2][..], vec![1, 0, 0]));

    // The same cut into simplices: a diagonal more and two triangles for each square, and nothing else changes.
    let simplices = diagonal.simplicial_chain_complex()?;
    assert_eq!(simplices.f_vector(), [7, 10, 4]);
    assert_eq!(homology(&simplices).betti_numbers(), [1, 0, 0]);

    // Axes that repeat: a full volume with both axes periodic is a torus; a bar along one periodic axis is a circle.
    let torus = CubicalVolume::full(&[4, 3], &[true, true])?.chain_complex()?;
    assert_eq!((torus.f_vector(), homology(&torus).betti_numbers()), (&[12, 24, 12][..], vec![1, 2, 1]));
    let bar = CubicalVolume::new(&[4, 3], &[true, false], |voxel| voxel[1] == 1)?.chain_complex()?;
    assert_eq!(homology(&bar).betti_numbers(), [1, 1, 0]);

    // Words of 64 voxels are what a volume holds: one bit each, the last axis fastest.
    let row = CubicalVolume::from_words(&[1, 5], &[false; 2], vec![0b10110])?;
    assert_eq!((0..5).map(|x| row.is_set(&[0, x])).collect::<Vec<_>>(), [false, true, true, false, true]);
    assert_eq!(homology(&row.chain_complex()?).betti_numbers()[0], 2);
    Ok(())
}
