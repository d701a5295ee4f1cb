//! Assemblies: lists of cells, affine maps and further lists.

use crate::shapes::faces::turn_cell;
use crate::shapes::placed_cells::{CellKind, PlacedCells};
use coface_algebra::{Error, ErrorKind};
use coface_algebra::{RaggedArray, Sign};
use coface_geometry::{AffineMap, Positions};
use std::sync::Arc;

/// A list of cells, affine maps and further assemblies; each map moves everything that comes after it in the same list.
///
/// Of several maps in a list the last acts first, as if each set up the frame for what follows: a translation and then a
/// rotation turn a thing about itself and put it somewhere. A list inside a list begins in the frame of its place, and its maps
/// end with it. Cells are shared, not copied, until the assembly is flattened.
///
/// # References
/// The `Struct` of A. Paoluzzi and others, *LinearAlgebraicRepresentation.jl*.
///
/// # Examples
/// Three circles in a row, the third by two maps:
/// ```
/// use coface_complexes::shapes;
/// use coface_complexes::shapes::Assembly;
/// use coface_geometry::AffineMap;
/// use std::sync::Arc;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let circle = Arc::new(shapes::circle(1.0, 8)?);
/// let step = AffineMap::translation(&[3.0, 0.0])?;
/// let mut row = Assembly::new();
/// row.push_cells(circle.clone());
/// row.push_map(step.clone());
/// row.push_cells(circle.clone());
/// row.push_map(step);
/// row.push_cells(circle);
/// let flat = row.flatten()?;
/// assert_eq!(flat.leaf_count(), 3);
/// assert_eq!(flat.positions().as_flat()[2 * 16], 7.0);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, Default)]
pub struct Assembly {
    items: Vec<Item>,
}

#[derive(Clone, Debug)]
enum Item {
    Map(AffineMap),
    /// Lists of cells on the same positions.
    Cells(Vec<Arc<PlacedCells>>),
    List(Arc<Assembly>),
}

/// Cells of one kind and dimension in a [`FlatAssembly`].
#[derive(Clone, Debug, PartialEq)]
pub struct AssemblyPart {
    kind: CellKind,
    dimension: usize,
    cells: RaggedArray,
    leaves: Vec<u32>,
}

impl AssemblyPart {
    /// What the cells are.
    pub fn kind(&self) -> CellKind {
        self.kind
    }

    /// The dimension of the cells.
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// The cells by their vertices in the whole assembly.
    pub fn cells(&self) -> &RaggedArray {
        &self.cells
    }

    /// For each cell the number of the leaf that it comes from.
    pub fn leaves(&self) -> &[u32] {
        &self.leaves
    }
}

/// An assembly with all its cells in place.
///
/// **Leaves** are the cells that the lists name, numbered in the order in which they are met, each once for every time it is met.
/// Vertices come leaf by leaf; vertices of different leaves are different, wherever they lie.
#[derive(Clone, Debug, PartialEq)]
pub struct FlatAssembly {
    positions: Positions,
    vertex_leaves: Vec<u32>,
    parts: Vec<AssemblyPart>,
    paths: Vec<Vec<usize>>,
}

impl FlatAssembly {
    /// The positions of all vertices.
    pub fn positions(&self) -> &Positions {
        &self.positions
    }

    /// For each vertex the number of the leaf that it comes from.
    pub fn vertex_leaves(&self) -> &[u32] {
        &self.vertex_leaves
    }

    /// The cells, those of each dimension and kind together, by rising dimension, simplices first.
    pub fn parts(&self) -> &[AssemblyPart] {
        &self.parts
    }

    /// The number of leaves.
    pub fn leaf_count(&self) -> usize {
        self.paths.len()
    }

    /// Where a leaf stands: its position in each list on the way to it, the outermost first, from 0.
    ///
    /// # Panics
    /// If there is no such leaf.
    pub fn path(&self, leaf: usize) -> &[usize] {
        &self.paths[leaf]
    }
}

impl Assembly {
    /// An empty list.
    pub fn new() -> Self {
        Self::default()
    }

    /// Appends a map of everything that is appended later.
    pub fn push_map(&mut self, map: AffineMap) {
        self.items.push(Item::Map(map));
    }

    /// Appends cells.
    pub fn push_cells(&mut self, cells: Arc<PlacedCells>) {
        self.items.push(Item::Cells(vec![cells]));
    }

    /// Appends cells of several dimensions or kinds on the same vertices, as one leaf.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless all have the same positions.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::shapes;
    /// use coface_complexes::shapes::{Assembly, CellKind};
    /// use std::sync::Arc;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = shapes::cuboid(&[1.0, 1.0], &[1, 1], CellKind::Cuboid)?;
    /// let sides = square.boundary()?;
    /// let mut assembly = Assembly::new();
    /// assembly.push_mixed_cells([square, sides].map(Arc::new).into())?;
    /// let flat = assembly.flatten()?;
    /// assert_eq!((flat.leaf_count(), flat.parts().len(), flat.positions().len()), (1, 2, 4));
    /// # Ok(()) }
    /// ```
    pub fn push_mixed_cells(&mut self, parts: Vec<Arc<PlacedCells>>) -> Result<(), Error> {
        if parts.windows(2).any(|pair| pair[0].positions() != pair[1].positions()) {
            return Err(Error::new(ErrorKind::Shape, "the parts of a leaf have different positions")
                .with_cure("append them one after the other, as leaves of their own"));
        }
        self.items.push(Item::Cells(parts));
        Ok(())
    }

    /// Appends a list inside this one.
    pub fn push_assembly(&mut self, assembly: Arc<Self>) {
        self.items.push(Item::List(assembly));
    }

    /// The number of items of the list itself: maps, cells and lists.
    pub fn len(&self) -> usize {
        self.items.len()
    }

    /// Whether the list has no item.
    pub fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// All cells in place.
    ///
    /// A map that mirrors turns cells of the dimension of the space, and of one less, over: solids stay positive, and the
    /// normals of closed surfaces stay outward.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] naming the place of a map or of cells of another dimension than the first;
    /// [`ErrorKind::InvalidInput`] naming the place where coordinates become infinite; [`ErrorKind::TooLarge`] beyond
    /// $2^{32}$ vertices.
    ///
    /// # Complexity
    /// Linear in the result.
    ///
    /// # Examples
    /// A mirrored triangle still runs counterclockwise:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::shapes::{Assembly, CellKind, PlacedCells};
    /// use coface_geometry::{AffineMap, Positions};
    /// use std::sync::Arc;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(2, vec![0., 0., 1., 0., 0., 1.])?;
    /// let triangle = PlacedCells::new(corners, CellKind::Simplex, 2, RaggedArray::from_lists([[0, 1, 2]]))?;
    /// let mut assembly = Assembly::new();
    /// assembly.push_map(AffineMap::scaling(&[-1.0, 1.0])?);
    /// assembly.push_cells(Arc::new(triangle));
    /// assert_eq!(assembly.flatten()?.parts()[0].cells().list(0), [1, 0, 2]);
    /// # Ok(()) }
    /// ```
    pub fn flatten(&self) -> Result<FlatAssembly, Error> {
        let mut gathering = Gathering::default();
        gathering.add_list(self, None)?;
        let Gathering { space, coordinates, vertex_leaves, mut parts, paths, .. } = gathering;
        parts.sort_by_key(|part| (part.dimension, part.kind));
        Ok(FlatAssembly {
            positions: Positions::from_flat(space.unwrap_or(0), coordinates)?,
            vertex_leaves,
            parts,
            paths,
        })
    }
}

/// What has been met so far on a walk through an assembly.
#[derive(Default)]
struct Gathering {
    space: Option<usize>,
    coordinates: Vec<f64>,
    vertex_leaves: Vec<u32>,
    parts: Vec<AssemblyPart>,
    paths: Vec<Vec<usize>>,
    /// The path to the list that is walked through, then the item.
    path: Vec<usize>,
}

impl Gathering {
    fn add_list(&mut self, list: &Assembly, frame: Option<&AffineMap>) -> Result<(), Error> {
        let mut frame = frame.cloned();
        self.path.push(0);
        for (i, item) in list.items.iter().enumerate() {
            if let Some(last) = self.path.last_mut() {
                *last = i;
            }
            match item {
                Item::Map(map) => {
                    self.check_space(map.dimension(), "a map")?;
                    frame = Some(match &frame {
                        Some(outer) => map.then(outer).map_err(|error| self.at_path(&error))?,
                        None => map.clone(),
                    });
                }
                Item::Cells(parts) => self.add_leaf(parts, frame.as_ref())?,
                Item::List(inner) => self.add_list(inner, frame.as_ref())?,
            }
        }
        self.path.pop();
        Ok(())
    }

    fn add_leaf(&mut self, parts: &[Arc<PlacedCells>], frame: Option<&AffineMap>) -> Result<(), Error> {
        let leaf = self.paths.len() as u32;
        self.paths.push(self.path.clone());
        let Some(positions) = parts.first().map(|cells| cells.positions()).filter(|p| !p.is_empty()) else {
            return Ok(());
        };
        let space = positions.dimension();
        self.check_space(space, "cells")?;
        let first = self.vertex_leaves.len();
        let count = first + positions.len();
        if u32::try_from(count).is_err() {
            let error = Error::new(ErrorKind::TooLarge, "the assembly has over 2^32 - 1 vertices");
            return Err(self.at_path(&error));
        }
        self.vertex_leaves.resize(count, leaf);
        match frame {
            Some(map) => {
                let moved = map.apply(positions).map_err(|error| self.at_path(&error))?;
                self.coordinates.extend_from_slice(moved.as_flat());
            }
            None => self.coordinates.extend_from_slice(positions.as_flat()),
        }
        let is_mirrored = frame.is_some_and(|map| map.determinant_sign() == Some(Sign::Minus));
        for cells in parts {
            let is_turned = is_mirrored && cells.dimension() + 1 >= space;
            self.add_cells(cells, first as u32, leaf, is_turned)?;
        }
        Ok(())
    }

    fn add_cells(
        &mut self,
        cells: &PlacedCells,
        first: u32,
        leaf: u32,
        is_turned: bool,
    ) -> Result<(), Error> {
        let (kind, dimension) = (cells.kind(), cells.dimension());
        let known = self.parts.iter().position(|part| (part.kind, part.dimension) == (kind, dimension));
        let at = known.unwrap_or_else(|| {
            self.parts.push(AssemblyPart { kind, dimension, cells: RaggedArray::new(), leaves: Vec::new() });
            self.parts.len() - 1
        });
        let part = &mut self.parts[at];
        if u32::try_from(part.cells.item_count() + cells.cells().item_count()).is_err() {
            let error =
                Error::new(ErrorKind::TooLarge, "the cells of the assembly have over 2^32 - 1 corners");
            return Err(self.at_path(&error));
        }
        let mut moved = vec![0; kind.vertex_count(dimension).unwrap_or(0)];
        for cell in cells.cells().iter() {
            moved.iter_mut().zip(cell).for_each(|(new, vertex)| *new = vertex + first);
            if is_turned {
                turn_cell(kind, &mut moved);
            }
            part.cells.push(&moved);
            part.leaves.push(leaf);
        }
        Ok(())
    }

    /// That a thing has the dimension of those before it.
    fn check_space(&mut self, space: usize, what: &str) -> Result<(), Error> {
        let expected = *self.space.get_or_insert(space);
        if space == expected {
            return Ok(());
        }
        let message = format!("{what} of dimension {space} in an assembly of dimension {expected}");
        let error = Error::new(ErrorKind::Shape, message)
            .with_cure("embed all cells in a space of one dimension, and give maps of that dimension");
        Err(self.at_path(&error))
    }

    fn at_path(&self, error: &Error) -> Error {
        let place: Vec<String> = self.path.iter().map(ToString::to_string).collect();
        let named = Error::new(error.kind(), format!("item {}: {}", place.join("."), error.message()));
        match error.cure() {
            Some(cure) => named.with_cure(cure),
            None => named,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes;
    use coface_geometry::Angle;
    use proptest::prelude::*;

    fn point(x: f64, y: f64) -> Arc<PlacedCells> {
        let position = Positions::from_flat(2, vec![x, y]).unwrap();
        Arc::new(PlacedCells::new(position, CellKind::Simplex, 0, RaggedArray::from_lists([[0]])).unwrap())
    }

    #[test]
    fn maps_set_up_frames_and_end_with_their_list() {
        let move_right = AffineMap::translation(&[10.0, 0.0]).unwrap();
        let quarter = AffineMap::rotation(2, [0, 1], Angle::turns(1, 4)).unwrap();
        let mut inner = Assembly::new();
        inner.push_map(quarter);
        inner.push_cells(point(1.0, 0.0));
        let mut outer = Assembly::new();
        outer.push_map(move_right.clone());
        outer.push_assembly(Arc::new(inner));
        outer.push_cells(point(1.0, 0.0));
        outer.push_map(move_right);
        outer.push_cells(point(0.0, 0.0));
        let flat = outer.flatten().unwrap();
        assert_eq!(flat.positions().as_flat(), [10.0, 1.0, 11.0, 0.0, 20.0, 0.0]);
        assert_eq!((0..3).map(|leaf| flat.path(leaf)).collect::<Vec<_>>(), [&[1, 1][..], &[2], &[4]]);
        assert_eq!(flat.vertex_leaves(), [0, 1, 2]);
    }

    #[test]
    fn dimensions_are_kept_apart_and_faults_have_a_path() {
        let mut inner = Assembly::new();
        inner.push_cells(Arc::new(shapes::circle(1.0, 3).unwrap()));
        inner.push_cells(point(0.0, 0.0));
        let mut outer = Assembly::new();
        outer.push_assembly(Arc::new(inner.clone()));
        outer.push_cells(Arc::new(shapes::circle(1.0, 4).unwrap()));
        let flat = outer.flatten().unwrap();
        let parts: Vec<_> =
            flat.parts().iter().map(|part| (part.dimension(), part.leaves().to_vec())).collect();
        assert_eq!(parts, [(0, vec![1]), (1, vec![0, 0, 0, 2, 2, 2, 2])]);
        inner.push_map(AffineMap::identity(3));
        outer.push_assembly(Arc::new(inner));
        let error = outer.flatten().unwrap_err();
        assert_eq!(error.kind(), ErrorKind::Shape);
        assert!(
            error.to_string().starts_with("item 2.2: a map of dimension 3 in an assembly of dimension 2"),
            "{error}"
        );
        let nothing = Assembly::new().flatten().unwrap();
        assert_eq!((nothing.leaf_count(), nothing.parts().len()), (0, 0));
    }

    proptest! {
        /// Whatever maps come before it, a solid box stays positive and its boundary stays outward.
        #[test]
        fn mirrored_solids_stay_positive(
            factors in prop::collection::vec((-3i32..4).prop_filter("not flat", |x| *x != 0), 3),
            turns in 0i64..12,
            kind in prop::sample::select(vec![CellKind::Simplex, CellKind::Cuboid]),
        ) {
            let solid = shapes::cuboid(&[1.0, 2.0, 3.0], &[1, 2, 1], kind).unwrap();
            let factors: Vec<f64> = factors.into_iter().map(f64::from).collect();
            let mut assembly = Assembly::new();
            assembly.push_map(AffineMap::scaling(&factors).unwrap());
            assembly.push_map(AffineMap::rotation_about([1.0, 2.0, -1.0], Angle::turns(turns, 12)).unwrap());
            assembly.push_cells(Arc::new(solid));
            let flat = assembly.flatten().unwrap();
            let part = &flat.parts()[0];
            let placed = PlacedCells::new(flat.positions().clone(), kind, 3, part.cells().clone()).unwrap();
            // Six times the volume of the cones over the boundary, each polygon as triangles.
            let boundary = placed.boundary().unwrap();
            let p = |v: u32| boundary.positions().point(coface_algebra::VertexId::from_u32(v));
            let cone = |a: u32, b: u32, c: u32| {
                let (a, b, c) = (p(a), p(b), p(c));
                a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
                    + a[2] * (b[0] * c[1] - b[1] * c[0])
            };
            let volume: f64 = boundary.cells().iter().map(|cell| match *cell {
                [a, b, c] => cone(a, b, c),
                [a, b, c, d] => cone(a, c, d) + cone(a, d, b),
                _ => f64::NAN,
            }).sum();
            let expected = 36.0 * factors.iter().product::<f64>().abs();
            prop_assert!((volume - expected).abs() < 1e-9 * expected, "{volume} {expected}");
        }
    }
}
