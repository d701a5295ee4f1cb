//! Faces with holes made into disks, and bridges between parts of a boundary.

use coface_algebra::{Error, RaggedArray, SparseMatrix, UnionFind, VertexId};
use coface_geometry::Positions;

/// The disks that faces are made into, one face after the other.
pub(crate) struct FaceCells<'a> {
    /// The ends of all edges; edges across faces come after those that were there.
    pub(crate) ends: &'a mut Vec<[u32; 2]>,
    /// The face that each disk is a piece of.
    pub(crate) of_face: Vec<u32>,
    /// The sides of each disk as twice the edge, plus one for those against it.
    pub(crate) sides: RaggedArray,
}

impl FaceCells<'_> {
    /// Adds a face as it is. Sides have their ends.
    pub(crate) fn add_whole(&mut self, face: u32, sides: &[([u32; 2], u32)]) {
        let packed: Vec<u32> = sides.iter().map(|side| side.1).collect();
        self.of_face.push(face);
        self.sides.push(&packed);
    }

    /// Adds the triangles that make up a face, with edges across it; nothing, and `false`, if their sides are not those of the
    /// face.
    pub(crate) fn add_triangles(
        &mut self,
        face: u32,
        sides: &[([u32; 2], u32)],
        triangles: &[[u32; 3]],
    ) -> bool {
        let mut known: Vec<([u32; 2], u32)> = sides.to_vec();
        known.sort_unstable();
        let mut across: Vec<[u32; 2]> = Vec::new();
        let mut used = 0;
        for &[a, b, c] in triangles {
            for side in [[a, b], [b, c], [c, a]] {
                match known.binary_search_by_key(&side, |own| own.0) {
                    Ok(_) => used += 1,
                    Err(_) => across.push([side[0].min(side[1]), side[0].max(side[1])]),
                }
            }
        }
        across.sort_unstable();
        // Two triangles lie at each edge across the face.
        if used != sides.len() || across.chunk_by(|x, y| x == y).any(|own| own.len() != 2) {
            return false;
        }
        across.dedup();
        let first = self.ends.len() as u32;
        self.ends.extend(&across);
        for &[a, b, c] in triangles {
            let packed =
                [[a, b], [b, c], [c, a]].map(|side| match known.binary_search_by_key(&side, |own| own.0) {
                    Ok(at) => known[at].1,
                    Err(_) => {
                        let ends = [side[0].min(side[1]), side[0].max(side[1])];
                        let at = across.partition_point(|other| *other < ends) as u32;
                        2 * (first + at) + u32::from(side != ends)
                    }
                });
            self.of_face.push(face);
            self.sides.push(&packed);
        }
        true
    }
}

/// Whether the sides of a face, but for slits, are one closed walk that comes to no vertex twice: boundary matrices tell how
/// it runs.
pub(crate) fn has_simple_rim(sides: &[([u32; 2], u32)]) -> bool {
    let mut edges: Vec<(u32, [u32; 2])> = sides.iter().map(|side| (side.1 >> 1, side.0)).collect();
    edges.sort_unstable();
    let rims = edges.chunk_by(|x, y| x.0 == y.0).filter(|own| own.len() == 1);
    let rims: Vec<[u32; 2]> = rims.map(|own| own[0].1).collect();
    let groups = connected(&rims, &[]);
    groups.len() == 1 && groups[0].len() == rims.len()
}

/// The boundary matrices of edges with these ends, and of disks with these sides.
pub(crate) fn low_matrices(
    vertex_count: usize,
    ends: &[[u32; 2]],
    sides: &RaggedArray,
) -> Result<[SparseMatrix; 2], Error> {
    let of_edges = ends.iter().enumerate();
    let of_edges = of_edges.flat_map(|(edge, &[a, b])| [(a as usize, edge, -1), (b as usize, edge, 1)]);
    let of_faces = sides.iter().enumerate().flat_map(|(column, own)| {
        own.iter().map(move |&side| ((side >> 1) as usize, column, 1 - 2 * i64::from(side & 1)))
    });
    Ok([
        SparseMatrix::from_entries(vertex_count, ends.len(), of_edges)?,
        SparseMatrix::from_entries(ends.len(), sides.len(), of_faces)?,
    ])
}

/// The vertices of these sides and points, those connected by sides together.
pub(crate) fn connected(sides: &[[u32; 2]], points: &[u32]) -> Vec<Vec<u32>> {
    let mut vertices: Vec<u32> = sides.iter().flatten().chain(points).copied().collect();
    vertices.sort_unstable();
    vertices.dedup();
    let place = |vertex: u32| vertices.partition_point(|&other| other < vertex) as u32;
    let mut joined = UnionFind::new(vertices.len());
    sides.iter().for_each(|&[a, b]| {
        joined.unite(place(a), place(b));
    });
    let numbers = joined.class_numbers();
    let mut groups = vec![Vec::new(); joined.class_count()];
    vertices.iter().zip(numbers).for_each(|(&vertex, number)| groups[number as usize].push(vertex));
    groups
}

/// An edge from each group of vertices but the first to the groups before it: from its first vertex to the nearest.
pub(crate) fn bridges(positions: &Positions, groups: &[Vec<u32>]) -> Vec<[u32; 2]> {
    let distance = |a: u32, b: u32| -> f64 {
        let [a, b] = [a, b].map(|vertex| positions.point(VertexId::from_u32(vertex)));
        a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum()
    };
    let Some((first, others)) = groups.split_first() else { return Vec::new() };
    let mut edges = Vec::new();
    for own in others {
        let Some(&from) = own.first() else { continue };
        let nearest = first.iter().copied().min_by(|&a, &b| distance(from, a).total_cmp(&distance(from, b)));
        edges.extend(nearest.map(|to| [from.min(to), from.max(to)]));
    }
    edges
}
