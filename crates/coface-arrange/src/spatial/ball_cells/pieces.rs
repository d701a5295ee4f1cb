//! Pieces of space between the faces that are kept, and whether they are balls.

use super::touching::facing_halves;
use super::{Cuts, NONE};
use crate::spatial::SpatialArrangement;
use crate::spatial::face_walks::face_walks;
use coface_algebra::{EdgeId, FaceId, RaggedArray, Sign, UnionFind};

/// The faces that stay.
pub(super) struct Kept {
    /// Whether a face stays.
    pub(super) is_kept: Vec<bool>,
    /// Whether a face is there because of cuts alone, on a face that would be left out without them perhaps.
    pub(super) is_from_cut: Vec<bool>,
    /// Twice the face that each fine face is part of, plus one if that has the other front.
    pub(super) faces_of_fine: Vec<u32>,
    /// Kept faces with the vertices inside of them that no edge of them ends at, rising.
    pub(super) points: Vec<(u32, u32)>,
    /// The piece of each cell; of the exterior and of cells that are left out, the last one.
    pub(super) piece_of_cell: Vec<u32>,
    pub(super) piece_count: usize,
    /// The region of each cell, and last of the exterior: its piece, or a number from [`Self::piece_count`] on for what is
    /// connected outside of all pieces.
    region_of_cell: Vec<u32>,
}

impl Kept {
    /// `parts` are those of the cells. Polygons from a number on are cuts.
    pub(super) fn new(
        arrangement: &SpatialArrangement,
        first_cut: usize,
        parts: &[u32],
        cuts: &Cuts,
        keeps_faces: bool,
    ) -> Self {
        let face_count = arrangement.complex().face_count();
        let part = |cell: u32| parts.get(cell as usize).copied().unwrap_or(NONE);
        let mut is_from_cut = vec![false; face_count];
        let mut is_kept = vec![false; face_count];
        let mut pieces = UnionFind::new(parts.len() + 1);
        let node = |cell: u32| if part(cell) == NONE { parts.len() as u32 } else { cell };
        for cell in 0..parts.len() as u32 {
            pieces.unite(cell, node(cell));
        }
        let mut regions = UnionFind::new(parts.len() + 1);
        for face in 0..face_count {
            let from = if cuts.rounds.is_empty() {
                Vec::new()
            } else {
                arrangement.polygons_of_face(FaceId::new(face))
            };
            let is_on = |&(polygon, _): &(u32, Sign)| polygon as usize >= first_cut;
            let is_of_cuts = !from.is_empty() && from.iter().all(is_on);
            let sides = [0, 1].map(|side| arrangement.packed_cell(face as u32, side));
            let [behind, before] = sides.map(part);
            let is_of_result = !is_of_cuts && (keeps_faces || behind != before);
            let mut on = from.iter().filter(|own| is_on(own)).map(|own| own.0 as usize - first_cut);
            let is_on_cut = on.any(|cut| cuts.is_between(cut, sides));
            is_from_cut[face] = !is_of_result;
            is_kept[face] = is_of_result || is_on_cut;
            if !is_kept[face] {
                pieces.unite(node(sides[0]), node(sides[1]));
                let [behind, before] = sides.map(|cell| cell.min(parts.len() as u32));
                regions.unite(behind, before);
            }
        }
        let numbers = pieces.class_numbers();
        // The outside gets the last number.
        let outside = numbers[parts.len()];
        let piece_count = pieces.class_count() - 1;
        let number = |&class: &u32| match class {
            class if class == outside => piece_count as u32,
            class if class > outside => class - 1,
            class => class,
        };
        let piece_of_cell: Vec<u32> = numbers[..parts.len()].iter().map(number).collect();
        let region = |(cell, class): (usize, u32)| match piece_of_cell.get(cell) {
            Some(&piece) if (piece as usize) < piece_count => piece,
            _ => piece_count as u32 + class,
        };
        let region_of_cell = regions.class_numbers().into_iter().enumerate().map(region).collect();
        let mut points = arrangement.points_in_faces();
        points.retain(|&(face, _)| is_kept[face as usize]);
        let faces_of_fine = faces_of_fine(arrangement);
        Self { is_kept, is_from_cut, faces_of_fine, points, piece_of_cell, piece_count, region_of_cell }
    }

    /// The piece on a side of a face, [`Self::piece_count`] for the outside.
    pub(super) fn piece_at(&self, arrangement: &SpatialArrangement, face: u32, side: u32) -> u32 {
        let cell = arrangement.packed_cell(face, side);
        self.piece_of_cell.get(cell as usize).copied().unwrap_or(self.piece_count as u32)
    }

    /// The region on a side of a face.
    fn region_at(&self, arrangement: &SpatialArrangement, half: u32) -> u32 {
        let cell = arrangement.packed_cell(half >> 1, half & 1) as usize;
        self.region_of_cell[cell.min(self.region_of_cell.len() - 1)]
    }

    /// The half-faces around each piece, rising; twice a kept face, plus one in front of it. The last list has all others.
    pub(super) fn halves_of_pieces(&self, arrangement: &SpatialArrangement) -> RaggedArray {
        let halves = 0..2 * self.is_kept.len() as u32;
        let piece = |half: u32| match self.is_kept[(half >> 1) as usize] {
            true => self.piece_at(arrangement, half >> 1, half & 1),
            false => self.piece_count as u32,
        };
        RaggedArray::grouped(self.piece_count + 1, halves.map(piece))
    }
}

/// The boundaries of pieces.
///
/// The sides of kept faces, **half-faces**, are glued along edges where nothing that is kept is between them. So they
/// close up to surfaces, the shells, pulled apart where they touch. Seen from within a piece two shells that touch in
/// a vertex are joined there by a tube, if the piece lies between them at the vertex. A piece is a ball if its shells,
/// joined in this way and by bridges, are one sphere: by Alexander's theorem a sphere of polygons in space bounds a
/// ball.
pub(super) struct Pieces {
    part_of_piece: Vec<u32>,
    /// The shells of each piece, joined by tubes, by a half-face of each.
    pub(super) shells: Vec<Vec<u32>>,
    /// The half-face that stands for the shell of each half-face of a kept face.
    pub(super) shell_of_half: Vec<u32>,
    is_ball: Vec<bool>,
    /// The pieces that lie between two parts of the faces at a vertex, with the vertex.
    between: Vec<(u32, u32)>,
    /// The pieces of which it is not known whether they lie between parts of the faces at a vertex, rising, with the vertex.
    unknown: Vec<(u32, u32)>,
}

/// A corner of a shell at a vertex.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Touch {
    vertex: u32,
    /// The part of the kept faces at the vertex that are connected without it.
    part: u32,
    /// The piece, or the region outside of all pieces.
    region: u32,
    /// A half-face of the shell there.
    half: u32,
}

/// The corner of a half-face: a vertex of one of its shells.
struct Corners<'a> {
    sides: &'a RaggedArray,
    /// Corners that are one vertex of a shell.
    classes: UnionFind,
    /// The same, with both sides of a face put together: one class for each part of the kept faces at a vertex.
    around_vertex: UnionFind,
}

impl Corners<'_> {
    /// The corner of a half-face at an end of the side in this place: end 0 is where the edge begins.
    fn number(&self, half: u32, place: usize, end: usize) -> u32 {
        let side = self.sides.start((half >> 1) as usize) + place;
        (4 * side + 2 * end) as u32 + (half & 1)
    }

    fn unite(&mut self, a: u32, b: u32) {
        self.classes.unite(a, b);
        self.around_vertex.unite(a >> 1, b >> 1);
    }
}

impl Pieces {
    pub(super) fn new(arrangement: &SpatialArrangement, kept: &Kept, parts: &[u32]) -> Self {
        let complex = arrangement.complex();
        let sides = complex.packed_sides();
        let mut corners = Corners {
            sides,
            classes: UnionFind::new(4 * sides.item_count()),
            around_vertex: UnionFind::new(2 * sides.item_count()),
        };
        let mut shells = UnionFind::new(2 * complex.face_count());
        let mut walk_counts = vec![0i64; complex.face_count()];
        for face in (0..complex.face_count()).filter(|&face| kept.is_kept[face]) {
            walk_counts[face] = join_within_face(arrangement, face as u32, &mut corners);
        }
        // Along each edge the half-faces on the two sides of a sector between kept faces are glued.
        let places = places_at_edges(arrangement, &kept.is_kept);
        let mut around: Vec<(u32, usize)> = Vec::new();
        for edge in 0..complex.edge_count() {
            around.clear();
            let (fine, along) =
                arrangement.fine_edges(EdgeId::new(edge)).next().expect("an edge has a first piece");
            for &fine_side in arrangement.fine().radial_order().list(fine.index()) {
                let packed = kept.faces_of_fine[(fine_side >> 1) as usize];
                let face = (packed >> 1) as usize;
                if !kept.is_kept[face] {
                    continue;
                }
                // The half-face before the side in the order around the edge, and the side as the face has it.
                let before = packed ^ (fine_side & 1);
                let side = (2 * edge) as u32 | ((before & 1) ^ u32::from(along == Sign::Minus));
                let own = sides.start(face)..sides.start(face) + sides.list(face).len();
                let known = places.list(edge).iter().map(|&item| item as usize);
                let place = known.into_iter().find(|item| own.contains(item) && sides.items()[*item] == side);
                around.push((before, place.expect("a face around an edge has the edge") - own.start));
            }
            for (i, &(before, place)) in around.iter().enumerate() {
                let (next, next_place) = around[(i + 1) % around.len()];
                let after = before ^ 1;
                shells.unite(after, next);
                for end in 0..2 {
                    let (a, b) = (corners.number(after, place, end), corners.number(next, next_place, end));
                    corners.unite(a, b);
                }
            }
        }
        let halves = || {
            let faces = (0..complex.face_count() as u32).filter(|&face| kept.is_kept[face as usize]);
            faces.flat_map(|face| [2 * face, 2 * face + 1])
        };
        let piece_at = |half: u32| kept.piece_at(arrangement, half >> 1, half & 1);
        // Twice the Euler characteristic of each shell, at its root.
        let mut characteristic = vec![0i64; 2 * complex.face_count()];
        let mut is_counted = vec![false; 4 * sides.item_count()];
        let mut unknown = Vec::new();
        let mut touching: Vec<Touch> = Vec::new();
        for half in halves() {
            let face = (half >> 1) as usize;
            let shell = shells.find(half) as usize;
            let list = sides.list(face);
            characteristic[shell] += 2 * (2 - walk_counts[face]) - list.len() as i64;
            for (place, &side) in list.iter().enumerate() {
                for end in 0..2 {
                    let corner = corners.number(half, place, end);
                    let root = corners.classes.find(corner);
                    if !std::mem::replace(&mut is_counted[root as usize], true) {
                        characteristic[shell] += 2;
                        let vertex = complex.edges()[(side >> 1) as usize][end];
                        let part = corners.around_vertex.find(corner >> 1);
                        touching.push(Touch {
                            vertex,
                            part,
                            region: kept.region_at(arrangement, half),
                            half,
                        });
                    }
                }
            }
        }
        for &(face, vertex) in &kept.points {
            let part = 2 * sides.item_count() as u32 + face;
            for half in [2 * face, 2 * face + 1] {
                touching.push(Touch { vertex, part, region: kept.region_at(arrangement, half), half });
            }
        }
        touching.sort_unstable();
        let mut between = Vec::new();
        for at in touching.chunk_by(|x, y| x.vertex == y.vertex) {
            let joined =
                join_at_vertex(arrangement, kept, at, &mut shells, &mut characteristic, &mut unknown);
            between.extend(joined.into_iter().map(|piece| (piece, at[0].vertex)));
        }
        unknown.sort_unstable();
        unknown.dedup();
        let shell_of_half: Vec<u32> =
            (0..2 * complex.face_count() as u32).map(|half| shells.find(half)).collect();
        let mut own_shells = vec![Vec::new(); kept.piece_count];
        let mut is_ball = vec![true; kept.piece_count];
        for half in halves() {
            let piece = piece_at(half) as usize;
            if piece < kept.piece_count && shells.find(half) == half {
                own_shells[piece].push(half);
            }
        }
        for (piece, own) in own_shells.iter().enumerate() {
            is_ball[piece] = own.iter().all(|&shell| characteristic[shell as usize] == 4);
        }
        let mut part_of_piece = vec![NONE; kept.piece_count + 1];
        for (cell, &piece) in kept.piece_of_cell.iter().enumerate() {
            part_of_piece[piece as usize] = parts[cell];
        }
        Self { part_of_piece, shells: own_shells, shell_of_half, is_ball, between, unknown }
    }

    /// Whether a piece is a ball, as far as is known.
    pub(super) fn is_ball(&self, piece: u32) -> bool {
        self.is_ball[piece as usize]
    }

    /// The pieces that are no balls, or not known to be.
    pub(super) fn doubtful(&self) -> Vec<u32> {
        let is_doubtful = |&piece: &u32| !self.is_ball(piece) || self.unknown_at(piece).next().is_some();
        (0..self.is_ball.len() as u32).filter(is_doubtful).collect()
    }

    /// The vertices at which it is not known whether a piece lies between parts of the faces.
    pub(super) fn unknown_at(&self, piece: u32) -> impl Iterator<Item = u32> {
        let begin = self.unknown.partition_point(|known| known.0 < piece);
        self.unknown[begin..].iter().take_while(move |known| known.0 == piece).map(|known| known.1)
    }

    /// A vertex at which a piece lies between two parts of the faces.
    pub(super) fn vertex_between(&self, piece: u32) -> Option<u32> {
        self.between.iter().find(|known| known.0 == piece).map(|known| known.1)
    }

    /// The part that a piece belongs to.
    pub(super) fn part(&self, piece: u32) -> u32 {
        self.part_of_piece[piece as usize]
    }
}

/// Joins the corners at the vertices along the walks of a face, on both sides of it; the number of walks.
fn join_within_face(arrangement: &SpatialArrangement, face: u32, corners: &mut Corners<'_>) -> i64 {
    let complex = arrangement.complex();
    let list = complex.packed_sides().list(face as usize);
    let start = |place: usize| complex.side_ends(list[place])[0];
    let mut by_start: Vec<(u32, usize)> = (0..list.len()).map(|place| (start(place), place)).collect();
    by_start.sort_unstable();
    let is_simple = by_start.windows(2).all(|pair| pair[0].0 != pair[1].0);
    // The end of a side where it ends, and that where it begins.
    let head = |place: usize| usize::from(list[place] & 1 == 0);
    let mut join = |from: usize, to: usize| {
        for side in 0..2 {
            let half = 2 * face + side;
            let (a, b) = (corners.number(half, from, head(from)), corners.number(half, to, 1 - head(to)));
            corners.unite(a, b);
        }
    };
    if is_simple {
        let next: Vec<usize> = (0..list.len())
            .map(|place| {
                let end = complex.side_ends(list[place])[1];
                let at = by_start.partition_point(|&(vertex, _)| vertex < end);
                by_start[at].1
            })
            .collect();
        let mut walks = UnionFind::new(list.len());
        for (place, &to) in next.iter().enumerate() {
            join(place, to);
            walks.unite(place as u32, to as u32);
        }
        return walks.class_count() as i64;
    }
    let face = FaceId::from_u32(face);
    let walks = face_walks(
        &arrangement.paths(face),
        arrangement.view(face),
        &arrangement.fine_triangles().predicates(),
    );
    for walk in &walks {
        for (i, &place) in walk.iter().enumerate() {
            join(place as usize, walk[(i + 1) % walk.len()] as usize);
        }
    }
    walks.len() as i64
}

/// Twice the face that each fine face is part of, plus one if that has the other front.
fn faces_of_fine(arrangement: &SpatialArrangement) -> Vec<u32> {
    let mut faces = vec![NONE; arrangement.fine().complex().face_count()];
    for face in 0..arrangement.complex().face_count() {
        for (fine, sign) in arrangement.fine_faces(FaceId::new(face)) {
            faces[fine.index()] = 2 * face as u32 + u32::from(sign == Sign::Minus);
        }
    }
    faces
}

/// The places in the lists of sides at which kept faces have each edge.
fn places_at_edges(arrangement: &SpatialArrangement, is_kept: &[bool]) -> RaggedArray {
    let complex = arrangement.complex();
    let sides = complex.packed_sides();
    let mut edges = Vec::with_capacity(sides.item_count());
    let mut places = Vec::with_capacity(sides.item_count());
    for face in (0..complex.face_count()).filter(|&face| is_kept[face]) {
        for (place, &side) in sides.list(face).iter().enumerate() {
            edges.push(side >> 1);
            places.push((sides.start(face) + place) as u32);
        }
    }
    let mut lists = RaggedArray::grouped(complex.edge_count(), edges.iter().copied());
    lists.items_mut().iter_mut().for_each(|item| *item = places[*item as usize]);
    lists
}

/// Joins shells that touch in a vertex where a piece lies between them. `at` are the corners of shells at the vertex.
///
/// On a small sphere around the vertex the faces are curves, in as many connected parts as there are parts here, and the
/// corners are closed walks around regions. A region whose rim is in k parts joins k corners; over all regions the
/// numbers k - 1 sum up to the number of parts less one. Where the pieces at the corners leave just one choice, it is
/// that. Returns the pieces that lie between.
fn join_at_vertex(
    arrangement: &SpatialArrangement,
    kept: &Kept,
    at: &[Touch],
    shells: &mut UnionFind,
    characteristic: &mut [i64],
    unknown: &mut Vec<(u32, u32)>,
) -> Vec<u32> {
    let mut faces: Vec<u32> = at.iter().map(|corner| corner.part).collect();
    faces.dedup();
    if faces.len() < 2 {
        return Vec::new();
    }
    let mut by_region: Vec<(u32, u32, u32, u32)> =
        at.iter().map(|own| (own.region, own.part, shells.find(own.half), own.half)).collect();
    by_region.sort_unstable();
    if by_region[0].0 as usize >= kept.piece_count {
        // Nothing but the outside.
        return Vec::new();
    }
    // Of corners of one shell in one part any will do.
    by_region.dedup_by_key(|corner| (corner.0, corner.1, corner.2));
    let mut joined = 0;
    let mut is_plain = true;
    for own in by_region.chunk_by(|x, y| x.0 == y.0) {
        let parts = own.chunk_by(|x, y| x.1 == y.1).count();
        joined += parts - 1;
        is_plain &= parts == 1 || parts == own.len();
    }
    if !is_plain || joined + 1 != faces.len() {
        // Two parts, with more than one choice: the corners between them are looked for.
        let between = (faces.len() == 2).then(|| {
            let own = |part: u32| {
                let mut list: Vec<u32> =
                    at.iter().filter(|corner| corner.part == part).map(|corner| corner.half >> 1).collect();
                list.sort_unstable();
                list.dedup();
                faces_of_part(arrangement, kept, at[0].vertex, &list)
            };
            let lists = [own(faces[0]), own(faces[1])];
            facing_halves(arrangement, kept, at[0].vertex, [&lists[0], &lists[1]])
        });
        match between.flatten() {
            Some(halves) => {
                let piece = kept.piece_at(arrangement, halves[0] >> 1, halves[0] & 1);
                join(&halves, piece, kept, shells, characteristic);
                return vec![piece];
            }
            None => {
                let own = at.iter().filter(|corner| (corner.region as usize) < kept.piece_count);
                unknown.extend(own.map(|corner| (corner.region, corner.vertex)));
            }
        }
        return Vec::new();
    }
    let mut between = Vec::new();
    for own in by_region.chunk_by(|x, y| x.0 == y.0) {
        if own.chunk_by(|x, y| x.1 == y.1).count() > 1 {
            let halves: Vec<u32> = own.iter().map(|corner| corner.3).collect();
            join(&halves, own[0].0, kept, shells, characteristic);
            between.push(own[0].0);
        }
    }
    between
}

/// Joins the shells of these half-faces by a tube each where they meet at a vertex: k disks around it give way to a
/// sphere with k holes.
fn join(halves: &[u32], piece: u32, kept: &Kept, shells: &mut UnionFind, characteristic: &mut [i64]) {
    if piece as usize >= kept.piece_count {
        return;
    }
    let mut roots: Vec<u32> = halves.iter().map(|&half| shells.find(half)).collect();
    roots.sort_unstable();
    roots.dedup();
    let sum: i64 = roots.iter().map(|&root| characteristic[root as usize]).sum();
    roots.windows(2).for_each(|pair| {
        shells.unite(pair[0], pair[1]);
    });
    let root = shells.find(roots[0]);
    characteristic[root as usize] = sum + 2 * (2 - 2 * halves.len() as i64);
}

/// All kept faces at a vertex that are connected with some there, through edges at it.
fn faces_of_part(arrangement: &SpatialArrangement, kept: &Kept, vertex: u32, some: &[u32]) -> Vec<u32> {
    let complex = arrangement.complex();
    let edges_at = |face: u32| {
        let list = complex.packed_sides().list(face as usize).iter();
        list.filter(|&&side| complex.side_ends(side).contains(&vertex))
            .map(|side| side >> 1)
            .collect::<Vec<u32>>()
    };
    let all: Vec<(u32, Vec<u32>)> = (0..complex.face_count() as u32)
        .filter(|&face| kept.is_kept[face as usize])
        .map(|face| (face, edges_at(face)))
        .filter(|own| !own.1.is_empty())
        .collect();
    let mut found: Vec<u32> = some.to_vec();
    let mut edges: Vec<u32> = some.iter().flat_map(|&face| edges_at(face)).collect();
    loop {
        let count = found.len();
        for (face, own) in &all {
            if !found.contains(face) && own.iter().any(|edge| edges.contains(edge)) {
                found.push(*face);
                edges.extend(own);
            }
        }
        if found.len() == count {
            return found;
        }
    }
}
