//! Every producer of this crate as [`Cells`].

use crate::cell_mesh::CellMesh;
use crate::cubical::CubicalVolume;
use crate::gluing::{FaceClasses, GluingTable};
use crate::grids::{CuboidGrid, ProductCells};
use crate::lar::LarModel;
use crate::shapes::PlacedCells;
use crate::simplicial::{DeltaComplex, Extrusion, FrozenComplex, Prism, SimplicialComplex, SimplicialGrid};
use crate::surface::{GeneralizedMap, HalfedgeMesh, PolygonMesh};
use coface_algebra::chains::{ChainComplex, TwoSkeleton};
use coface_algebra::{Error, FaceId, RaggedArray};

pub use coface_algebra::chains::Cells;

/// The vertices `0..count`, each as a list of its own.
fn single_vertices(count: usize) -> Result<RaggedArray, Error> {
    RaggedArray::uniform(1, (0..count as u32).collect())
}

/// Vertices keep their names: the cell i of degree 0 is the vertex with the i-th name.
impl Cells for FrozenComplex {
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.chain_complex()
    }

    fn two_skeleton(&self) -> Result<TwoSkeleton, Error> {
        self.two_skeleton()
    }

    /// The vertices of each simplex, rising.
    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        RaggedArray::uniform(degree + 1, self.flat(degree).to_vec())
    }

    fn f_vector(&self) -> Result<Vec<usize>, Error> {
        Ok(self.f_vector())
    }
}

/// Simplices in lexicographic order; vertices keep their names.
impl Cells for SimplicialComplex {
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.chain_complex()
    }

    fn two_skeleton(&self) -> Result<TwoSkeleton, Error> {
        self.freeze().two_skeleton()
    }

    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        self.freeze().cell_vertices(degree)
    }

    fn f_vector(&self) -> Result<Vec<usize>, Error> {
        Ok(self.f_vector())
    }
}

impl Cells for DeltaComplex {
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.chain_complex()
    }

    fn two_skeleton(&self) -> Result<TwoSkeleton, Error> {
        self.two_skeleton()
    }

    /// The vertices of each simplex in its order; one may stand several times.
    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        let cells = 0..self.simplex_count(degree);
        RaggedArray::uniform(degree + 1, cells.flat_map(|cell| self.vertices(degree, cell)).collect())
    }

    fn f_vector(&self) -> Result<Vec<usize>, Error> {
        Ok(self.f_vector())
    }
}

/// The classes of faces, or the simplices of the barycentric subdivision if a class is folded.
impl Cells for FaceClasses {
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.chain_complex()
    }

    fn two_skeleton(&self) -> Result<TwoSkeleton, Error> {
        self.two_skeleton()
    }

    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        if self.has_folds() {
            return self.barycentric_subdivision()?.complex().cell_vertices(degree);
        }
        let classes = 0..self.class_counts().get(degree).copied().unwrap_or(0);
        RaggedArray::uniform(degree + 1, classes.flat_map(|class| self.vertices(degree, class)).collect())
    }

    fn f_vector(&self) -> Result<Vec<usize>, Error> {
        if self.has_folds() {
            return Ok(self.barycentric_subdivision()?.complex().f_vector());
        }
        Ok(self.class_counts())
    }
}

/// The cells are the [`FaceClasses`] of the table.
impl Cells for GluingTable {
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.faces()?.chain_complex()
    }

    fn two_skeleton(&self) -> Result<TwoSkeleton, Error> {
        self.faces()?.two_skeleton()
    }

    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        self.faces()?.cell_vertices(degree)
    }

    fn f_vector(&self) -> Result<Vec<usize>, Error> {
        self.faces()?.f_vector()
    }
}

impl Cells for PolygonMesh {
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.chain_complex()
    }

    fn two_skeleton(&self) -> Result<TwoSkeleton, Error> {
        self.two_skeleton()
    }

    /// Polygons with their corners in order.
    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        match degree {
            0 => single_vertices(self.vertex_count()),
            1 => RaggedArray::uniform(2, self.edge_ends().to_vec()),
            2 => Ok(self.polygons().clone()),
            _ => Ok(RaggedArray::new()),
        }
    }

    fn f_vector(&self) -> Result<Vec<usize>, Error> {
        Ok(self.f_vector())
    }
}

impl Cells for HalfedgeMesh {
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.chain_complex()
    }

    fn two_skeleton(&self) -> Result<TwoSkeleton, Error> {
        self.two_skeleton()
    }

    /// A face lists the sources of its halfedges.
    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        match degree {
            0 => single_vertices(self.vertex_count()),
            1 => RaggedArray::uniform(2, self.edge_ends().to_vec()),
            2 => {
                let corners =
                    |face| self.face_halfedges(face).map(|h| self.source(h).to_u32()).collect::<Vec<_>>();
                Ok(RaggedArray::from_lists((0..self.face_count()).map(FaceId::new).map(corners)))
            }
            _ => Ok(RaggedArray::new()),
        }
    }

    fn f_vector(&self) -> Result<Vec<usize>, Error> {
        Ok(self.f_vector())
    }
}

/// The cells are those of [`GeneralizedMap::skeleton`].
impl Cells for GeneralizedMap {
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.skeleton().chain_complex()
    }

    fn two_skeleton(&self) -> Result<TwoSkeleton, Error> {
        Ok(self.skeleton().clone())
    }

    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        self.skeleton().cell_vertices(degree)
    }

    fn f_vector(&self) -> Result<Vec<usize>, Error> {
        Ok(self.f_vector())
    }
}

impl Cells for CellMesh {
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.chain_complex()
    }

    fn two_skeleton(&self) -> Result<TwoSkeleton, Error> {
        self.two_skeleton()
    }

    /// Cells with their corners as they were given.
    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        match degree {
            3 => Ok(self.cells().clone()),
            _ => self.skeleton().cell_vertices(degree),
        }
    }

    fn f_vector(&self) -> Result<Vec<usize>, Error> {
        Ok(self.f_vector())
    }
}

impl Cells for LarModel {
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.chain_complex()
    }

    /// Each list in the order that it was given in.
    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        Ok(self.cells(degree).into_owned())
    }

    fn f_vector(&self) -> Result<Vec<usize>, Error> {
        Ok(self.f_vector())
    }
}

impl Cells for CuboidGrid {
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.chain_complex()
    }

    /// The corners of each cell, rising.
    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        self.cells(degree)
    }

    fn f_vector(&self) -> Result<Vec<usize>, Error> {
        Ok(self.f_vector())
    }
}

/// The simplices of full dimension and all their faces, in lexicographic order.
impl Cells for SimplicialGrid {
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.to_frozen()?.chain_complex()
    }

    fn two_skeleton(&self) -> Result<TwoSkeleton, Error> {
        self.to_frozen()?.two_skeleton()
    }

    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        self.to_frozen()?.cell_vertices(degree)
    }

    fn f_vector(&self) -> Result<Vec<usize>, Error> {
        Ok(self.to_frozen()?.f_vector())
    }
}

/// The simplices, all their faces and all vertices, in lexicographic order.
impl Cells for Extrusion {
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.to_frozen()?.chain_complex()
    }

    fn two_skeleton(&self) -> Result<TwoSkeleton, Error> {
        self.to_frozen()?.two_skeleton()
    }

    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        self.to_frozen()?.cell_vertices(degree)
    }

    fn f_vector(&self) -> Result<Vec<usize>, Error> {
        Ok(self.to_frozen()?.f_vector())
    }
}

/// The cells are those of [`Prism::complex`].
impl Cells for Prism {
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.chain_complex()
    }

    fn two_skeleton(&self) -> Result<TwoSkeleton, Error> {
        self.complex().two_skeleton()
    }

    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        self.complex().cell_vertices(degree)
    }

    fn f_vector(&self) -> Result<Vec<usize>, Error> {
        Ok(self.complex().f_vector())
    }
}

/// The cells and all their faces, with all vertices.
impl Cells for PlacedCells {
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.chain_complex()
    }

    /// The lists of [`PlacedCells::skeleton`].
    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        match degree {
            0 => single_vertices(self.vertex_count()),
            _ if degree > self.dimension() => Ok(RaggedArray::new()),
            _ => Ok(self.skeleton(degree)?.cells().clone()),
        }
    }
}

/// The cells are those of [`ProductCells::into_placed_cells`], which refuses prisms over simplices.
impl Cells for ProductCells {
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.clone().into_placed_cells()?.chain_complex()
    }

    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        self.clone().into_placed_cells()?.cell_vertices(degree)
    }
}

/// Voxels and all their faces, in the order of [`CubicalVolume::cell_ids`].
impl Cells for CubicalVolume {
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.chain_complex()
    }

    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        self.cell_vertices(degree)
    }

    fn f_vector(&self) -> Result<Vec<usize>, Error> {
        Ok(self.cell_ids()?.iter().map(Vec::len).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell_mesh::CellShape;
    use crate::grids::product;
    use crate::known_spaces;
    use crate::shapes::CellKind;
    use crate::simplicial::extrude;
    use coface_geometry::Positions;
    use std::collections::BTreeSet;

    fn trimmed(counts: &[usize]) -> &[usize] {
        let end = counts.iter().rposition(|&count| count > 0).map_or(0, |last| last + 1);
        &counts[..end]
    }

    /// What holds for every producer. `has_paths`: the faces have paths around them.
    fn keeps_the_contract(name: &str, cells: &dyn Cells, has_paths: bool) {
        // Boundary of boundary is zero.
        let chains = cells.chain_complex().unwrap();
        ChainComplex::new(chains.boundary_matrices().to_vec())
            .map(|again| assert_eq!(again, chains, "{name}"))
            .unwrap_or_else(|_| assert!(chains.degree_count() <= 1, "{name}"));
        let counts = cells.f_vector().unwrap();
        assert_eq!(trimmed(&counts), trimmed(chains.f_vector()), "{name}");
        let names = cells.cell_vertices(0).unwrap();
        let lists: Vec<RaggedArray> =
            (0..=counts.len()).map(|degree| cells.cell_vertices(degree).unwrap()).collect();
        for (degree, lists) in lists.iter().enumerate() {
            assert_eq!(lists.len(), chains.cell_count(degree), "{name} in degree {degree}");
        }
        for list in names.iter() {
            assert_eq!(list.len(), 1, "{name}");
        }
        let set =
            |degree: usize, cell: usize| lists[degree].list(cell).iter().copied().collect::<BTreeSet<u32>>();
        for degree in 1..counts.len() {
            for cell in 0..chains.cell_count(degree) {
                let column = chains.boundary_matrix(degree).unwrap().column(cell);
                // Facets that cancel, as of a loop, leave fewer in the boundary than there are.
                for &facet in column.rows() {
                    assert!(
                        set(degree, cell).is_superset(&set(degree - 1, facet as usize)),
                        "{name}: cell {cell}"
                    );
                }
                if degree == 1 && column.rows().len() == 2 {
                    let ends = lists[1]
                        .list(cell)
                        .iter()
                        .map(|&end| names.items().iter().position(|&name| name == end).unwrap());
                    let signs: Vec<i32> =
                        ends.map(|end| chains.boundary_matrix(1).unwrap().entry(end, cell)).collect();
                    assert_eq!(signs, [-1, 1], "{name}: edge {cell} runs from its source to its target");
                }
            }
        }
        let skeleton = cells.two_skeleton();
        assert_eq!(skeleton.is_ok(), has_paths, "{name}");
        let Ok(skeleton) = skeleton else { return };
        let low = skeleton.chain_complex().unwrap();
        for degree in 0..=2 {
            assert_eq!(low.cell_count(degree), chains.cell_count(degree), "{name}");
            if chains.cell_count(degree) > 0 {
                assert_eq!(low.boundary_matrix(degree), chains.boundary_matrix(degree), "{name}");
            }
        }
        for (face, list) in lists.get(2).into_iter().flat_map(|lists| lists.iter()).enumerate() {
            let around = skeleton.cell_vertices(2).unwrap();
            let around: BTreeSet<u32> =
                around.list(face).iter().map(|&v| names.items()[v as usize]).collect();
            assert_eq!(around, list.iter().copied().collect(), "{name}: face {face}");
        }
    }

    #[test]
    fn every_producer_keeps_the_contract() -> Result<(), Error> {
        let sphere = known_spaces::simplex_boundary(3)?;
        keeps_the_contract("complex", &sphere, true);
        keeps_the_contract(
            "complex with gaps",
            &SimplicialComplex::from_facets([vec![3, 9, 4], vec![7, 9]])?,
            true,
        );
        keeps_the_contract("empty complex", &SimplicialComplex::new(), true);
        keeps_the_contract("frozen complex", &known_spaces::cyclic_torus(3)?.freeze(), true);
        keeps_the_contract("delta complex", &DeltaComplex::new(1, vec![vec![0, 0], vec![0, 0, 0]])?, true);
        let mut band = GluingTable::unglued(2, 1)?;
        band.glue(0, 2, 0, &[1, 2, 0])?;
        keeps_the_contract("gluing table", &band, true);
        keeps_the_contract("face classes", &GluingTable::unglued(3, 2)?.faces()?, true);
        let mut folded = GluingTable::unglued(3, 1)?;
        folded.glue(0, 3, 0, &[1, 0, 3, 2])?;
        assert!(folded.faces()?.has_folds());
        keeps_the_contract("folded gluing table", &folded, true);
        let square = RaggedArray::from_lists([[0, 1, 2, 3]]);
        let polygons = PolygonMesh::new(6, square, &[[4, 5]])?;
        keeps_the_contract("polygon mesh", &polygons, true);
        keeps_the_contract("points", &PolygonMesh::new(3, RaggedArray::new(), &[])?, true);
        let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
        keeps_the_contract("halfedge mesh", &torus, true);
        keeps_the_contract("generalized map", &GeneralizedMap::new(torus.two_skeleton()?)?, true);
        let pyramid = RaggedArray::from_lists([[0, 1, 2, 3, 4]]);
        let pyramid = CellMesh::new(6, vec![CellShape::Pyramid], pyramid, &RaggedArray::new(), &[[4, 5]])?;
        keeps_the_contract("cell mesh", &pyramid, true);
        let grid = CuboidGrid::new(&[2, 1, 1])?;
        keeps_the_contract("cuboid grid", &grid, true);
        keeps_the_contract("grid of one point", &CuboidGrid::new(&[])?, true);
        keeps_the_contract("model", &grid.lar_model()?, true);
        let triangles = SimplicialGrid::new(&[2, 1])?;
        keeps_the_contract("simplicial grid", &triangles, true);
        keeps_the_contract("simplicial grid of vertices", &SimplicialGrid::new(&[2, 0])?, true);
        let tower = extrude(5, &RaggedArray::from_lists([[0, 1, 2], [1, 2, 3]]), &[1.0])?;
        keeps_the_contract("extrusion", &tower, true);
        keeps_the_contract("prism", &Prism::new(&sphere.freeze())?, true);
        keeps_the_contract("placed cuboids", &grid.placed_cells(3)?, true);
        keeps_the_contract("placed simplices", &triangles.placed_cells()?, true);
        let points = Positions::from_flat(1, vec![0.0, 1.0])?;
        let points = PlacedCells::new(points, CellKind::Simplex, 0, RaggedArray::from_lists([[1]]))?;
        // The cells of degree 0 are all points, also those that no list names.
        keeps_the_contract("placed points", &points, true);
        let segments = CuboidGrid::new(&[2])?.placed_cells(1)?;
        keeps_the_contract("product of cells", &product(&segments, &segments)?, true);
        let mut voxels = [true; 12];
        voxels[5] = false;
        let bits = [voxels.iter().enumerate().fold(0, |bits, (i, &is_set)| bits | u64::from(is_set) << i)];
        keeps_the_contract(
            "volume",
            &CubicalVolume::from_words(&[2, 2, 3], &[false; 3], bits.to_vec())?,
            true,
        );
        // A voxel that meets itself around the torus: its squares have no paths that their boundaries tell.
        keeps_the_contract("periodic volume", &CubicalVolume::full(&[1, 1], &[true, true])?, false);
        keeps_the_contract("chain complex", &sphere.chain_complex()?, true);
        keeps_the_contract("2-skeleton", &sphere.freeze().two_skeleton()?, true);
        Ok(())
    }

    #[test]
    fn short_periodic_axes_keep_the_corners_of_cells() -> Result<(), Error> {
        // One voxel on a torus of length 1 by 2: its edges along the first axis are loops.
        let volume = CubicalVolume::full(&[1, 2], &[true, true])?;
        assert_eq!(volume.cell_vertices(1)?.iter().filter(|ends| ends[0] == ends[1]).count(), 2);
        assert_eq!(volume.cell_vertices(2)?.len(), 2);
        Ok(())
    }
}
