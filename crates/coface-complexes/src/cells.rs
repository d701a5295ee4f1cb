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
use coface_algebra::{CellId, Error, FaceId, RaggedArray};

pub use coface_algebra::chains::Cells;

/// The vertices `0..count`, each as a list of its own.
fn single_vertices(count: usize) -> Result<RaggedArray, Error> {
    RaggedArray::uniform(1, (0..count as u32).collect())
}

/// Methods of [`Cells`] that are the methods of the producer of the same name.
macro_rules! own {
    (@ chain_complex) => {
        fn chain_complex(&self) -> Result<ChainComplex, Error> {
            self.chain_complex()
        }
    };
    (@ two_skeleton) => {
        fn two_skeleton(&self) -> Result<TwoSkeleton, Error> {
            self.two_skeleton()
        }
    };
    (@ f_vector) => {
        fn f_vector(&self) -> Result<Vec<usize>, Error> {
            Ok(self.f_vector())
        }
    };
    ($($method:ident),+) => {
        $(own!(@ $method);)+
    };
}

/// Methods of [`Cells`] that ask another producer, of which this one has the cells.
macro_rules! through {
    (@ chain_complex $producer:ident $cells:expr) => {
        fn chain_complex(&self) -> Result<ChainComplex, Error> {
            let $producer = self;
            Cells::chain_complex($cells)
        }
    };
    (@ two_skeleton $producer:ident $cells:expr) => {
        fn two_skeleton(&self) -> Result<TwoSkeleton, Error> {
            let $producer = self;
            Cells::two_skeleton($cells)
        }
    };
    (@ cell_vertices $producer:ident $cells:expr) => {
        fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
            let $producer = self;
            Cells::cell_vertices($cells, degree)
        }
    };
    (@ f_vector $producer:ident $cells:expr) => {
        fn f_vector(&self) -> Result<Vec<usize>, Error> {
            let $producer = self;
            Cells::f_vector($cells)
        }
    };
    ($($method:ident),+ : |$producer:ident| $cells:expr) => {
        through!(@@ ($producer $cells) $($method)+);
    };
    (@@ $given:tt $($method:ident)+) => {
        $(through!(@@@ $method $given);)+
    };
    (@@@ $method:ident ($producer:ident $cells:expr)) => {
        through!(@ $method $producer $cells);
    };
}

/// Vertices keep their names: the cell i of degree 0 is the vertex with the i-th name.
impl Cells for FrozenComplex {
    own!(chain_complex, two_skeleton, f_vector);

    /// The vertices of each simplex, rising.
    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        RaggedArray::uniform(degree + 1, self.flat(degree).to_vec())
    }
}

/// Simplices in lexicographic order; vertices keep their names.
impl Cells for SimplicialComplex {
    own!(chain_complex, f_vector);
    through!(two_skeleton, cell_vertices: |producer| &producer.freeze());
}

impl Cells for DeltaComplex {
    own!(chain_complex, two_skeleton, f_vector);

    /// The vertices of each simplex in its order; one may stand several times.
    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        let cells = 0..self.simplex_count(degree);
        RaggedArray::uniform(
            degree + 1,
            cells.flat_map(|cell| self.vertices(degree, CellId::new(cell))).collect(),
        )
    }
}

/// The classes of faces, or the simplices of the barycentric subdivision if a class is folded.
impl Cells for FaceClasses {
    own!(chain_complex, two_skeleton);

    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        if self.has_folds() {
            return self.barycentric_subdivision()?.complex().cell_vertices(degree);
        }
        let classes = 0..self.class_counts().get(degree).copied().unwrap_or(0);
        RaggedArray::uniform(
            degree + 1,
            classes.flat_map(|class| self.vertices(degree, CellId::new(class))).collect(),
        )
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
    through!(chain_complex, two_skeleton, cell_vertices, f_vector: |producer| &producer.faces()?);
}

impl Cells for PolygonMesh {
    own!(chain_complex, two_skeleton, f_vector);

    /// Polygons with their corners in order.
    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        match degree {
            0 => single_vertices(self.vertex_count()),
            1 => RaggedArray::uniform(2, self.edge_ends().to_vec()),
            2 => Ok(self.polygons().clone()),
            _ => Ok(RaggedArray::new()),
        }
    }
}

impl Cells for HalfedgeMesh {
    own!(chain_complex, two_skeleton, f_vector);

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
}

/// The cells are those of [`GeneralizedMap::skeleton`].
impl Cells for GeneralizedMap {
    own!(f_vector);
    through!(chain_complex, two_skeleton, cell_vertices: |producer| producer.skeleton());
}

impl Cells for CellMesh {
    own!(chain_complex, two_skeleton, f_vector);

    /// Cells with their corners as they were given.
    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        match degree {
            3 => Ok(self.cells().clone()),
            _ => self.skeleton().cell_vertices(degree),
        }
    }
}

impl Cells for LarModel {
    own!(chain_complex, f_vector);

    /// Each list in the order that it was given in.
    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        Ok(self.cells(degree).into_owned())
    }
}

impl Cells for CuboidGrid {
    own!(chain_complex, f_vector);

    /// The corners of each cell, rising.
    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        self.cells(degree)
    }
}

/// The simplices of full dimension and all their faces, in lexicographic order.
impl Cells for SimplicialGrid {
    through!(chain_complex, two_skeleton, cell_vertices, f_vector: |producer| &producer.to_frozen()?);
}

/// The simplices, all their faces and all vertices, in lexicographic order.
impl Cells for Extrusion {
    through!(chain_complex, two_skeleton, cell_vertices, f_vector: |producer| &producer.to_frozen()?);
}

/// The cells are those of [`Prism::complex`].
impl Cells for Prism {
    own!(chain_complex);
    through!(two_skeleton, cell_vertices, f_vector: |producer| producer.complex());
}

/// The cells and all their faces, with all vertices.
impl Cells for PlacedCells {
    own!(chain_complex);

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
    through!(chain_complex, cell_vertices: |producer| &producer.clone().into_placed_cells()?);
}

/// Voxels and all their faces, in the order of [`CubicalVolume::cell_ids`].
impl Cells for CubicalVolume {
    own!(chain_complex);

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
    use coface_algebra::samples::keeps_the_contract;
    use coface_geometry::Positions;

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
