//! The complex of pieces that are balls, with bridges.

use super::matching::vertices_of_cut;
use super::pieces::{Kept, Pieces};
use super::{BallComplex, NONE};
use crate::face_cells::{FaceCells, bridges, connected, has_simple_rim, low_matrices};
use crate::spatial::{PolygonalComplex, SpatialArrangement};
use coface_algebra::chains::{ChainComplex, ChainRefinement};
use coface_algebra::{Error, FaceId, ParityUnionFind, RaggedArray, Sign, SparseMatrix, UnionFind, VertexId};
use coface_geometry::Positions;

/// Kept vertices, edges and faces of an arrangement, bridges, and pieces. `original` is the same without cuts.
pub(super) fn build(
    original: &SpatialArrangement,
    arrangement: &SpatialArrangement,
    kept: &Kept,
    pieces: &Pieces,
    triangles: bool,
) -> Result<BallComplex, Error> {
    let complex = arrangement.complex();
    let first_cut = original.polygon_count();
    let faces: Vec<u32> =
        (0..complex.face_count() as u32).filter(|&face| kept.is_kept[face as usize]).collect();
    // Edges of kept faces; those on cuts alone, or between pieces of one face, are no pieces of edges.
    let mut is_edge = vec![false; complex.edge_count()];
    let mut is_from_input = vec![false; complex.edge_count()];
    for &face in &faces {
        for &side in complex.packed_sides().list(face as usize) {
            is_edge[(side >> 1) as usize] = true;
            is_from_input[(side >> 1) as usize] |= !kept.is_from_cut[face as usize];
        }
    }
    let (face_pieces, between) = face_pieces(arrangement, first_cut, kept, &faces);
    between.iter().for_each(|&edge| is_from_input[edge as usize] = false);
    let edges: Vec<u32> = (0..complex.edge_count() as u32).filter(|&edge| is_edge[edge as usize]).collect();
    let mut number_of_vertex = vec![NONE; complex.vertex_count()];
    edges
        .iter()
        .flat_map(|&edge| complex.edges()[edge as usize])
        .for_each(|v| number_of_vertex[v as usize] = 0);
    let mut vertices = Vec::new();
    for (vertex, number) in number_of_vertex.iter_mut().enumerate().filter(|(_, number)| **number != NONE) {
        *number = vertices.len() as u32;
        vertices.push(vertex as u32);
    }
    let positions = arrangement.positions();
    let coordinates = vertices.iter().flat_map(|&vertex| positions.point(VertexId::from_u32(vertex)));
    let positions = Positions::from_flat(3, coordinates.copied().collect())?;
    let is_original = original_vertices(original, arrangement);
    let EdgePieces { numbers: mut edge_pieces, is_turned } =
        EdgePieces::new(complex, &edges, &is_from_input, &is_original);
    let mut ends: Vec<[u32; 2]> = edges
        .iter()
        .zip(&is_turned)
        .map(|(&edge, &turned)| {
            let [a, b] = complex.edges()[edge as usize].map(|v| number_of_vertex[v as usize]);
            if turned { [b, a] } else { [a, b] }
        })
        .collect();
    let points = &kept.points;
    let own_sides = |face: u32| {
        let list = complex.packed_sides().list(face as usize).iter();
        list.map(|&side| (side, complex.side_ends(side).map(|v| number_of_vertex[v as usize])))
    };
    let mut number_of_edge = vec![NONE; complex.edge_count()];
    (0..).zip(&edges).for_each(|(number, &edge)| number_of_edge[edge as usize] = number);
    let mut cells = FaceCells { ends: &mut ends, of_face: Vec::new(), sides: RaggedArray::new() };
    let mut bridged = Vec::new();
    for (place, &face) in (0u32..).zip(&faces) {
        let sides: Vec<([u32; 2], u32)> = own_sides(face)
            .map(|(side, own)| {
                let number = number_of_edge[(side >> 1) as usize];
                (own, 2 * number + ((side & 1) ^ u32::from(is_turned[number as usize])))
            })
            .collect();
        let start = points.partition_point(|&(other, _)| other < face);
        let inside = points[start..].iter().take_while(|&&(other, _)| other == face);
        let inside: Vec<u32> =
            inside.map(|&(_, v)| number_of_vertex[v as usize]).filter(|&number| number != NONE).collect();
        if inside.is_empty() && sides.len() < 4 {
            cells.add_whole(place, &sides);
            continue;
        }
        let is_cut = (triangles && sides.len() > 3 || !has_simple_rim(&sides)) && {
            // Triangles on vertices before merging; where one is no vertex now, bridges do.
            let number = |fine: u32| arrangement.vertex_of_fine(fine).map(|v| number_of_vertex[v as usize]);
            let own = arrangement.triangulated(FaceId::from_u32(face))?;
            let own: Option<Vec<[u32; 3]>> =
                own.into_iter().map(|[a, b, c]| Some([number(a)?, number(b)?, number(c)?])).collect();
            own.is_some_and(|own| cells.add_triangles(place, &sides, &own))
        };
        if !is_cut {
            cells.add_whole(place, &sides);
        }
        let lists: Vec<[u32; 2]> = sides.iter().map(|side| side.0).collect();
        let mut groups = connected(&lists, &inside);
        if is_cut {
            // Triangles connect what sides do not.
            let is_lone = |own: &Vec<u32>| own.len() == 1 && inside.contains(&own[0]);
            let (lone, rest): (Vec<_>, Vec<_>) = groups.into_iter().partition(is_lone);
            groups = std::iter::once(rest.concat()).chain(lone).collect();
        }
        bridged.push(groups);
    }
    let FaceCells { of_face, sides: cell_sides, .. } = cells;
    bridged.iter().for_each(|groups| ends.extend(bridges(&positions, groups)));
    // Shells of one piece that have no vertex in common; those that have were joined there.
    let mut vertices_of_shell: Vec<Vec<u32>> = Vec::new();
    let mut shell_of_root: Vec<(u32, usize)> = Vec::new();
    for own in pieces.shells.iter().filter(|own| own.len() > 1) {
        for &shell in own {
            shell_of_root.push((shell, vertices_of_shell.len()));
            vertices_of_shell.push(Vec::new());
        }
    }
    if !shell_of_root.is_empty() {
        shell_of_root.sort_unstable();
        for &face in &faces {
            for half in [2 * face, 2 * face + 1] {
                let root = pieces.shell_of_half[half as usize];
                if let Ok(at) = shell_of_root.binary_search_by_key(&root, |known| known.0) {
                    vertices_of_shell[shell_of_root[at].1].extend(own_sides(face).map(|(_, ends)| ends[0]));
                }
            }
        }
        let mut first = 0;
        for own in pieces.shells.iter().filter(|own| own.len() > 1) {
            let groups = &mut vertices_of_shell[first..first + own.len()];
            groups.iter_mut().for_each(|group| {
                group.sort_unstable();
                group.dedup();
            });
            ends.extend(bridges(&positions, groups));
            first += own.len();
        }
    }
    edge_pieces.resize(ends.len(), None);
    let face_pieces = of_face.iter().map(|&place| face_pieces[place as usize]).collect();
    let of_cell: Vec<u32> = of_face.iter().map(|&place| faces[place as usize]).collect();
    let boundaries = matrices(arrangement, kept, vertices.len(), &ends, &of_cell, &cell_sides)?;
    let parts = (0..kept.piece_count as u32).map(|piece| Some(pieces.part(piece))).collect();
    let mut count = 0;
    let vertex_pieces = vertices.iter().map(|&vertex| {
        is_original[vertex as usize].then(|| {
            count += 1;
            count - 1
        })
    });
    let refinement = ChainRefinement::new(vec![vertex_pieces.collect(), edge_pieces, face_pieces, parts]);
    let mut others: Vec<u32> = pieces.doubtful().into_iter().map(|piece| pieces.part(piece)).collect();
    others.sort_unstable();
    others.dedup();
    Ok(BallComplex { complex: ChainComplex::new(boundaries)?, positions, refinement, others })
}

/// For each vertex of an arrangement with cuts whether it is one without them.
fn original_vertices(original: &SpatialArrangement, arrangement: &SpatialArrangement) -> Vec<bool> {
    if original.polygon_count() == arrangement.polygon_count() {
        return vec![true; arrangement.complex().vertex_count()];
    }
    let of_fine = vertices_of_cut(original, arrangement);
    let mut is_original = vec![false; arrangement.complex().vertex_count()];
    for vertex in 0..original.complex().vertex_count() {
        let fine = of_fine[original.fine_vertex(VertexId::new(vertex)).index()];
        if let Some(vertex) = arrangement.vertex_of_fine(fine) {
            is_original[vertex as usize] = true;
        }
    }
    is_original
}

/// What the kept edges are pieces of.
struct EdgePieces {
    /// The edge that each is a piece of; none for those that are on cuts alone.
    numbers: Vec<Option<u32>>,
    /// Whether it is turned, so that the pieces of an edge run in one direction.
    is_turned: Vec<bool>,
}

impl EdgePieces {
    /// Two edges are pieces of one if they alone meet at a vertex that is there because of cuts.
    fn new(complex: &PolygonalComplex, edges: &[u32], is_from_input: &[bool], is_original: &[bool]) -> Self {
        let mut at_vertex: Vec<(u32, u32, bool)> = Vec::new();
        for (number, &edge) in (0..).zip(edges).filter(|&(_, &edge)| is_from_input[edge as usize]) {
            let ends = complex.edges()[edge as usize].into_iter().zip([true, false]);
            let new = ends.filter(|&(vertex, _)| !is_original[vertex as usize]);
            at_vertex.extend(new.map(|(vertex, begins)| (vertex, number, begins)));
        }
        at_vertex.sort_unstable();
        let mut joined = ParityUnionFind::new(edges.len());
        for at in at_vertex.chunk_by(|x, y| x.0 == y.0) {
            if let &[(_, a, a_begins), (_, b, b_begins)] = at {
                let sign = if a_begins == b_begins { Sign::Minus } else { Sign::Plus };
                joined.unite(a, b, sign);
            }
        }
        let mut number_of_root = vec![NONE; edges.len()];
        let mut count = 0;
        let mut found = Self { numbers: Vec::with_capacity(edges.len()), is_turned: Vec::new() };
        for (number, &edge) in (0..).zip(edges) {
            let (root, sign) = joined.find(number);
            found.is_turned.push(sign == Sign::Minus);
            found.numbers.push(is_from_input[edge as usize].then(|| {
                let known = &mut number_of_root[root as usize];
                if *known == NONE {
                    *known = count;
                    count += 1;
                }
                *known
            }));
        }
        found
    }
}

/// The boundary matrices of edges, of pieces of faces with these sides, and of pieces of cells.
fn matrices(
    arrangement: &SpatialArrangement,
    kept: &Kept,
    vertex_count: usize,
    ends: &[[u32; 2]],
    face_of_cell: &[u32],
    sides: &RaggedArray,
) -> Result<Vec<SparseMatrix>, Error> {
    let of_pieces = face_of_cell.iter().enumerate().flat_map(|(row, &face)| {
        let sides = [0, 1].map(|side| kept.piece_at(arrangement, face, side) as usize);
        let is_seen = move |piece: usize| piece < kept.piece_count && sides[0] != sides[1];
        [(sides[0], 1), (sides[1], -1)]
            .into_iter()
            .filter(move |&(piece, _)| is_seen(piece))
            .map(move |(piece, sign)| (row, piece, sign))
    });
    let pieces = SparseMatrix::from_entries(face_of_cell.len(), kept.piece_count, of_pieces)?;
    let [edges, faces] = low_matrices(vertex_count, ends, sides)?;
    Ok(vec![edges, faces, pieces])
}

/// The face that each kept face is a piece of, and the edges between pieces of one: just cuts part them there.
fn face_pieces(
    arrangement: &SpatialArrangement,
    first_cut: usize,
    kept: &Kept,
    faces: &[u32],
) -> (Vec<Option<u32>>, Vec<u32>) {
    let complex = arrangement.complex();
    let mut between = Vec::new();
    let mut joined = UnionFind::new(complex.face_count());
    if arrangement.polygon_count() > first_cut {
        let mut sides: Vec<(u32, u32)> = Vec::new();
        for face in 0..complex.face_count() as u32 {
            sides.extend(complex.packed_sides().list(face as usize).iter().map(|&side| (side >> 1, face)));
        }
        sides.sort_unstable();
        for at in sides.chunk_by(|x, y| x.0 == y.0) {
            let own: Vec<u32> =
                at.iter().map(|side| side.1).filter(|&face| !kept.is_from_cut[face as usize]).collect();
            if let &[f, g] = own.as_slice()
                && (at.len() > 2 || lies_on_other_cuts(arrangement, first_cut, [f, g]))
                && arrangement.are_one_without([f, g], first_cut)
            {
                joined.unite(f, g);
                between.push(at[0].0);
            }
        }
    }
    let mut numbers = vec![NONE; complex.face_count()];
    let mut count = 0;
    let mut pieces = Vec::with_capacity(faces.len());
    for &face in faces {
        if kept.is_from_cut[face as usize] {
            pieces.push(None);
            continue;
        }
        let number = &mut numbers[joined.find(face) as usize];
        if *number == NONE {
            *number = count;
            count += 1;
        }
        pieces.push(Some(*number));
    }
    (pieces, between)
}

/// Whether a cut lies on one of two faces and not on the other.
fn lies_on_other_cuts(arrangement: &SpatialArrangement, first_cut: usize, faces: [u32; 2]) -> bool {
    let [f, g] = faces.map(|face| {
        let polygons = arrangement.polygons_of_face(FaceId::from_u32(face));
        polygons.into_iter().filter(|&(polygon, _)| polygon as usize >= first_cut).count()
    });
    f != g
}
