//! Chains as the user writes and sees them: cells named by vertices of the file.

use super::{Cells, Producer};
use coface_algebra::chains::{Chain, ChainComplex};
use coface_algebra::{CellId, Error, VertexId};
use coface_algebra::{Integer, Sign};
use coface_complexes::cell_mesh::CellShape;
use coface_geometry::Positions;
use coface_io::{Group, GroupKind, Model, ModelParts};
use std::collections::BTreeMap;

/// A term of a chain: a coefficient and the vertices of a cell, in an order that gives it an orientation.
pub type Term = (Integer, Vec<u32>);

impl Producer {
    /// The chain of these terms, in the degree where the cells are. A cell named against its orientation counts
    /// negatively: an edge from its end to its start, a simplex by an odd permutation, a polygon backwards.
    ///
    /// Cells of halfedge permutations, gluing tables and chain complexes are named by their own number, and then
    /// the degree must be given.
    ///
    /// # Errors
    /// [`NotInComplex`](coface_algebra::ErrorKind::NotInComplex) naming a cell that is not there, [`InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for cells of different
    /// degrees and for a 3-cell that is no tetrahedron and not named in its own order.
    ///
    /// # Complexity
    /// Linear in the cells of the degrees that are searched.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_io::{Model, Structure};
    /// use coface_answers::Producer;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let rim = RaggedArray::from_lists([[5, 7], [7, 9], [5, 9]]);
    /// let producer = Producer::of(Model::from_structure(Structure::Facets(rim)))?;
    /// let complex = producer.chain_complex()?;
    /// let around = [[5, 7], [7, 9], [9, 5]].map(|edge| (1.into(), edge.to_vec()));
    /// assert!(complex.is_cycle(&producer.chain(&complex, &around, None)?)?);
    /// # Ok(()) }
    /// ```
    pub fn chain(
        &self,
        complex: &ChainComplex,
        terms: &[Term],
        degree: Option<usize>,
    ) -> Result<Chain<Integer>, Error> {
        let (degree, cells) =
            self.oriented_cells(complex, terms.iter().map(|(_, cell)| &cell[..]), degree)?;
        let signed = terms.iter().zip(cells).map(|((x, _), (cell, sign))| match sign {
            Sign::Plus => (cell, x.clone()),
            Sign::Minus => (cell, -x),
        });
        Chain::new(complex, degree, signed)
    }

    /// The cells with these vertices, all of one degree, each with its orientation against the one that the order of
    /// the vertices gives; the rules are those of [`Self::chain`].
    ///
    /// # Errors
    /// Those of [`Self::chain`].
    ///
    /// # Examples
    /// See [`Self::chain`].
    pub fn oriented_cells<'t>(
        &self,
        complex: &ChainComplex,
        lists: impl Iterator<Item = &'t [u32]> + Clone,
        degree: Option<usize>,
    ) -> Result<(usize, Vec<(CellId, Sign)>), Error> {
        let found = self.cells_with_vertices(complex, lists.clone(), degree)?;
        let mut found_degree: Option<(usize, &[u32])> = degree.map(|degree| (degree, &[][..]));
        let mut cells = Vec::with_capacity(found.len());
        for (vertices, candidates) in lists.zip(found) {
            let (degree, _) = candidates[0];
            match found_degree {
                Some((other, first)) if other != degree => {
                    return Err(Error::invalid(format!(
                        "the chain has the cell {first:?} of degree {other} and the cell {vertices:?} of degree {degree}"
                    ))
                    .with_cure("give a chain of cells of one degree"));
                }
                _ => found_degree = Some((degree, vertices)),
            }
            // Of polygons around the same vertices, the one with this order.
            let mut signs = candidates.iter().map(|&(degree, cell)| {
                Ok::<_, Error>((cell, self.relative_sign(degree, cell.index(), vertices)?))
            });
            let first = signs.next().expect("a list that no cell has is an error");
            cells.push(first.or_else(|fault| signs.find_map(Result::ok).ok_or(fault))?);
        }
        Ok((found_degree.map_or(0, |(degree, _)| degree), cells))
    }

    /// The orientation of a cell against the order of these vertices.
    fn relative_sign(&self, degree: usize, cell: usize, vertices: &[u32]) -> Result<Sign, Error> {
        let own = self.cell_vertices(degree, CellId::new(cell));
        if own == vertices || degree == 0 {
            return Ok(Sign::Plus);
        }
        let places: Vec<usize> = vertices
            .iter()
            .map(|vertex| own.iter().position(|other| other == vertex).expect("the vertices are the same"))
            .collect();
        let is_polygon = degree == 2 && !matches!(self.cells, Cells::Simplices(_));
        if is_polygon {
            let count = places.len();
            let step = |by: usize| (0..count).all(|i| places[(i + 1) % count] == (places[i] + by) % count);
            return match (step(1), step(count - 1)) {
                (true, _) => Ok(Sign::Plus),
                (_, true) => Ok(Sign::Minus),
                _ => Err(Error::invalid(format!("{vertices:?} does not run around the polygon {own:?}"))
                    .with_cure("list its vertices in their order")),
            };
        }
        if own.len() != degree + 1 {
            return Err(Error::invalid(format!("{vertices:?} is not in the order of the cell {own:?}"))
                .with_cure("name cells that are no simplices in their own order"));
        }
        let inversions = (0..places.len())
            .flat_map(|i| (i + 1..places.len()).map(move |j| (i, j)))
            .filter(|&(i, j)| places[i] > places[j])
            .count();
        Ok(Sign::power_of_minus_one(inversions))
    }

    /// A picture of chains: their cells as points, polylines, polygons and 3-cells, one [`Group`] a chain, on the positions
    /// of the producer. Edges are joined to polylines that run as the coefficients say and as often, closed ones where
    /// the chain is a cycle; polygons are turned by the sign, and other multiplicities are not shown. Vertices have the numbers of the producer, but for voxels,
    /// whose corners are in no file: those that no cell has are left out.
    ///
    /// # Errors
    /// [`InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if the cells have no vertices or the vertices no positions, or a cell has no picture:
    /// simplices of dimension 4 and up.
    pub fn picture(&self, chains: &[(String, Chain<Integer>)]) -> Result<Model, Error> {
        self.require_finite()?;
        if self.positions.dimension() == 0 || !self.names_cells_by_vertices() {
            return Err(no_positions());
        }
        let mut model = ModelParts {
            vertex_count: self.positions.len(),
            positions: self.positions.clone(),
            ..ModelParts::default()
        };
        for (name, chain) in chains {
            let kind = kind_of(chain.degree());
            let first = drawn_count(&model, kind);
            let mut members = Vec::new();
            if kind == GroupKind::Lines {
                for line in self.polylines(chain) {
                    members.push(model.lines.len() as u32);
                    model.lines.push(&line);
                }
                model.groups.push(Group::new(name, kind, members));
                continue;
            }
            for (at, (cell, coefficient)) in chain.terms().iter().enumerate() {
                let mut vertices = self.cell_vertices(chain.degree(), *cell);
                if coefficient.signum() < 0 && chain.degree() < 3 {
                    vertices.reverse();
                }
                self.draw(&mut model, chain.degree(), *cell, &vertices)?;
                members.push(if kind == GroupKind::Vertices { vertices[0] } else { (first + at) as u32 });
            }
            model.groups.push(Group::new(name, kind, members));
        }
        if matches!(self.cells, Cells::Voxels(_)) {
            drop_unused(&mut model)?;
        }
        let model = model.into_model();
        model.check()?;
        Ok(model)
    }

    /// The edges of a chain of degree 1 as [`walks`].
    fn polylines(&self, chain: &Chain<Integer>) -> Vec<Vec<u32>> {
        walks(chain.terms().iter().map(|(cell, x)| (x, self.cell_vertices(1, *cell))))
    }

    fn draw(
        &self,
        model: &mut ModelParts,
        degree: usize,
        cell: CellId,
        vertices: &[u32],
    ) -> Result<(), Error> {
        match (degree, &self.cells) {
            (3, Cells::Solids(mesh)) => {
                model.shapes.push(mesh.shapes()[cell.index()]);
                model.cells.push(vertices);
            }
            (3, cells) if !matches!(cells, Cells::Voxels(_)) => {
                model.shapes.push(CellShape::Tetrahedron);
                model.cells.push(vertices);
            }
            _ => return draw_cube(model, degree, vertices),
        }
        Ok(())
    }
}

/// Edges with their coefficients as walks along them: from vertices where more begins than ends, then around.
fn walks<'x>(edges: impl Iterator<Item = (&'x Integer, Vec<u32>)>) -> Vec<Vec<u32>> {
    /// Edges that are run through more often than this are drawn this often.
    const MOST_TIMES: u64 = 64;
    let mut next: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    let mut surplus: BTreeMap<u32, i64> = BTreeMap::new();
    for (x, ends) in edges {
        let (from, to) = if x.signum() > 0 { (ends[0], ends[1]) } else { (ends[1], ends[0]) };
        let times = x.to_i64().map_or(MOST_TIMES, |x| x.unsigned_abs().min(MOST_TIMES));
        for _ in 0..times {
            next.entry(from).or_default().push(to);
            *surplus.entry(from).or_default() += 1;
            *surplus.entry(to).or_default() -= 1;
        }
    }
    let starts = surplus.iter().filter(|&(_, &count)| count > 0);
    let mut starts: Vec<u32> =
        starts.flat_map(|(&vertex, &count)| std::iter::repeat_n(vertex, count as usize)).collect();
    starts.extend(next.keys().copied().collect::<Vec<_>>());
    let mut walks = Vec::new();
    for start in starts {
        let mut walk = vec![start];
        let mut at = start;
        while let Some(to) = next.get_mut(&at).and_then(Vec::pop) {
            walk.push(to);
            at = to;
        }
        if walk.len() > 1 {
            walks.push(walk);
        }
    }
    walks
}

fn no_positions() -> Error {
    Error::invalid("the cells of the model have no positions to draw them at")
        .with_cure("write the generators as .json")
}

/// Draws a cube, or another cell of degree 0 or 2.
fn draw_cube(model: &mut ModelParts, degree: usize, vertices: &[u32]) -> Result<(), Error> {
    match degree {
        0 => model.points.push(VertexId::new(vertices[0] as usize)),
        2 => model.polygons.push(vertices),
        3 => {
            // The corners of a voxel come by rising places, those of a hexahedron around its bottom and its top.
            model.shapes.push(CellShape::Hexahedron);
            model.cells.push(&[0, 4, 6, 2, 1, 5, 7, 3].map(|corner| vertices[corner]));
        }
        _ => {
            return Err(Error::invalid(format!("a cell of degree {degree} cannot be drawn"))
                .with_cure("write the generators as .json"));
        }
    }
    Ok(())
}

/// The number of cells that a model has of a kind.
fn drawn_count(model: &ModelParts, kind: GroupKind) -> usize {
    match kind {
        GroupKind::Vertices => model.points.len(),
        GroupKind::Lines => model.lines.len(),
        GroupKind::Polygons => model.polygons.len(),
        _ => model.cells.len(),
    }
}

/// Cubes with coefficients, each with the places of its corners in the order of [`Producer::cell_vertices`].
pub(crate) struct CubeChain {
    pub(crate) name: String,
    pub(crate) degree: usize,
    pub(crate) terms: Vec<(Integer, Vec<u64>)>,
}

/// A picture as of [`Producer::picture`] of chains of cubes, of which nothing but these is known; `positions` gives those of corners at rising places.
pub(crate) fn picture_of_cubes(
    chains: &[CubeChain],
    positions: impl FnOnce(&[u64]) -> Result<Positions, Error>,
) -> Result<Model, Error> {
    let corners = chains.iter().flat_map(|chain| &chain.terms).flat_map(|(_, corners)| corners);
    let mut used: Vec<u64> = corners.copied().collect();
    used.sort_unstable();
    used.dedup();
    let positions = positions(&used)?;
    if positions.dimension() == 0 {
        return Err(no_positions());
    }
    let place = |corner: &u64| used.binary_search(corner).expect("all corners are there") as u32;
    let mut model = ModelParts { vertex_count: used.len(), positions, ..ModelParts::default() };
    for CubeChain { name, degree, terms } in chains {
        let kind = kind_of(*degree);
        let first = drawn_count(&model, kind);
        let vertices = |corners: &[u64]| corners.iter().map(place).collect::<Vec<u32>>();
        let mut members = Vec::new();
        if kind == GroupKind::Lines {
            for line in walks(terms.iter().map(|(x, corners)| (x, vertices(corners)))) {
                members.push(model.lines.len() as u32);
                model.lines.push(&line);
            }
        } else {
            for (at, (x, corners)) in terms.iter().enumerate() {
                let mut vertices = vertices(corners);
                if x.signum() < 0 && *degree < 3 {
                    vertices.reverse();
                }
                draw_cube(&mut model, *degree, &vertices)?;
                members.push(if kind == GroupKind::Vertices { vertices[0] } else { (first + at) as u32 });
            }
        }
        model.groups.push(Group::new(name, kind, members));
    }
    let model = model.into_model();
    model.check()?;
    Ok(model)
}

/// The kind of the groups of cells of a degree.
fn kind_of(degree: usize) -> GroupKind {
    match degree {
        0 => GroupKind::Vertices,
        1 => GroupKind::Lines,
        2 => GroupKind::Polygons,
        _ => GroupKind::Cells,
    }
}

/// Leaves out the vertices that no cell has.
fn drop_unused(model: &mut ModelParts) -> Result<(), Error> {
    let mut used: Vec<u32> = model.points.iter().map(|vertex| vertex.to_u32()).collect();
    for lists in [&model.lines, &model.polygons, &model.cells] {
        used.extend(lists.items());
    }
    used.sort_unstable();
    used.dedup();
    let place = |vertex: u32| used.binary_search(&vertex).map_or(vertex, |place| place as u32);
    for lists in [&mut model.lines, &mut model.polygons, &mut model.cells] {
        lists.items_mut().iter_mut().for_each(|vertex| *vertex = place(*vertex));
    }
    for vertex in &mut model.points {
        *vertex = VertexId::new(place(vertex.to_u32()) as usize);
    }
    let of_group = |group: &Group| match group.kind() {
        GroupKind::Vertices => {
            let members = group.members().iter().map(|&vertex| place(vertex)).collect();
            Group::new(group.name(), GroupKind::Vertices, members)
        }
        _ => group.clone(),
    };
    model.groups = model.groups.iter().map(of_group).collect();
    let points = used.iter().flat_map(|&vertex| model.positions.point(VertexId::new(vertex as usize)));
    model.positions = Positions::from_flat(model.positions.dimension(), points.copied().collect())?;
    model.vertex_count = used.len();
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::RaggedArray;
    use coface_io::Structure;

    fn producer(facets: &[Vec<u32>]) -> Producer {
        Producer::of(Model::from_structure(Structure::Facets(RaggedArray::from_lists(facets)))).unwrap()
    }

    #[test]
    fn cells_are_found_with_their_orientation() {
        let producer = producer(&[vec![3, 5, 8, 9], vec![5, 8, 9, 11]]);
        let complex = producer.chain_complex().unwrap();
        let term = |x: i64, vertices: &[u32]| (Integer::from(x), vertices.to_vec());
        let chain =
            producer.chain(&complex, &[term(2, &[5, 3, 8, 9]), term(1, &[8, 9, 5, 11])], None).unwrap();
        assert_eq!((chain.degree(), chain.to_string()), (3, "-2 c0 + c1".to_owned()));
        let faces = producer.chain(&complex, &[term(1, &[9, 8, 5])], None).unwrap();
        assert_eq!(faces.degree(), 2);
        let fault = |terms: &[Term]| producer.chain(&complex, terms, None).unwrap_err().to_string();
        assert!(fault(&[term(1, &[3, 11])]).contains("no cell [3, 11]"));
        assert!(
            fault(&[term(1, &[3, 5]), term(1, &[3])]).contains("of degree 1 and the cell [3] of degree 0")
        );
    }

    #[test]
    fn edges_are_joined_to_loops() {
        let rim = producer(&[vec![3, 5], vec![5, 8], vec![3, 8], vec![8, 9]]);
        let complex = rim.chain_complex().unwrap();
        let term = |x: i64, vertices: &[u32]| (Integer::from(x), vertices.to_vec());
        let around = [term(1, &[3, 5]), term(1, &[5, 8]), term(1, &[8, 3])];
        assert_eq!(rim.polylines(&rim.chain(&complex, &around, None).unwrap()), [[3, 5, 8, 3]]);
        let path = [term(1, &[5, 8]), term(2, &[8, 9])];
        let lines = rim.polylines(&rim.chain(&complex, &path, None).unwrap());
        assert_eq!(lines, [vec![5, 8, 9], vec![8, 9]]);
    }

    #[test]
    fn polygons_are_found_forwards_and_backwards() {
        let positions =
            coface_geometry::Positions::from_flat(2, vec![0., 0., 1., 0., 1., 1., 0., 1.]).unwrap();
        let square = Model::from_polygons(positions, RaggedArray::from_lists([[0, 1, 2, 3]])).unwrap();
        let producer = Producer::of(square).unwrap();
        let complex = producer.chain_complex().unwrap();
        let chain = |vertices: [u32; 4]| producer.chain(&complex, &[(Integer::ONE, vertices.to_vec())], None);
        assert_eq!(chain([2, 3, 0, 1]).unwrap().to_string(), "c0");
        assert_eq!(chain([1, 0, 3, 2]).unwrap().to_string(), "-c0");
        assert!(chain([0, 2, 1, 3]).unwrap_err().to_string().contains("does not run around"));
        // Another polygon around the same four vertices is told by its order.
        let positions =
            coface_geometry::Positions::from_flat(2, vec![0., 0., 1., 0., 1., 1., 0., 1.]).unwrap();
        let both = RaggedArray::from_lists([[0, 1, 2, 3], [0, 2, 1, 3]]);
        let two = Producer::of(Model::from_polygons(positions, both).unwrap()).unwrap();
        let bow =
            two.chain(&two.chain_complex().unwrap(), &[(Integer::ONE, vec![1, 3, 0, 2])], None).unwrap();
        assert_eq!(bow.to_string(), "c1");
        let picture = producer.picture(&[("face".into(), chain([1, 0, 3, 2]).unwrap())]).unwrap();
        assert_eq!(picture.polygons().list(0), [3, 2, 1, 0]);
        assert_eq!(picture.groups()[0].members(), [0]);
    }
}
