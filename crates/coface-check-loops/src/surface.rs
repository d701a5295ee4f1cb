//! Surfaces: faces glued along edges, cut or not, and what the pieces are.

use coface_check::{Complex, Fault};
use std::collections::{BTreeSet, HashMap};

/// Faces with their sides. The sides of all faces have numbers one after the other; the corner of a side is its start.
pub(crate) struct Surface {
    /// Where each side starts and ends, by vertices as the file names them.
    ends: Vec<[u32; 2]>,
    /// The face of each side.
    face_of: Vec<u32>,
    /// The side before and the side after each side, around its face.
    around: Vec<[u32; 2]>,
    /// The edge of each side.
    edge_of: Vec<u32>,
    /// One or two sides of each edge.
    sides_of: Vec<Vec<u32>>,
    /// The number of faces.
    face_count: usize,
    /// The number of vertices in no face.
    pub(crate) isolated: usize,
    by_ends: HashMap<[u32; 2], u32>,
    by_vertices: HashMap<Vec<u32>, u32>,
}

/// A connected piece of a surface that may be cut.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Piece {
    /// Vertices, edges and faces.
    pub(crate) counts: [usize; 3],
    /// Whether all faces can be turned so that they agree along edges.
    pub(crate) is_orientable: bool,
    /// The ways around its boundary.
    pub(crate) loops: Vec<Vec<Step>>,
}

/// A side that is passed, from its start to its end if forward.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Step {
    pub(crate) side: u32,
    pub(crate) is_forward: bool,
}

impl Piece {
    /// Vertices minus edges plus faces.
    pub(crate) fn euler_characteristic(&self) -> i64 {
        let [v, e, f] = self.counts.map(|count| count as i64);
        v - e + f
    }

    /// The name of the surface, by the classification of surfaces.
    pub(crate) fn name(&self) -> String {
        name(self.is_orientable, self.euler_characteristic(), self.loops.len())
    }
}

/// The name of a connected surface, by its orientability, Euler characteristic and number of boundary loops.
pub(crate) fn name(is_orientable: bool, euler_characteristic: i64, loops: usize) -> String {
    let defect = (2 - euler_characteristic - loops as i64).max(0);
    let genus = if is_orientable { defect / 2 } else { defect };
    let closed = match (is_orientable, genus, loops) {
        (true, 0, 1) => return "disk".to_owned(),
        (true, 0, 2) => return "annulus".to_owned(),
        (true, 0, 3) => return "pair of pants".to_owned(),
        (false, 1, 1) => return "Moebius band".to_owned(),
        (true, 0, _) => "sphere".to_owned(),
        (true, 1, _) => "torus".to_owned(),
        (true, 2, _) => "double torus".to_owned(),
        (true, ..) => format!("genus-{genus} surface"),
        (false, 1, _) => "projective plane".to_owned(),
        (false, 2, _) => "Klein bottle".to_owned(),
        (false, ..) => format!("non-orientable surface with {genus} crosscaps"),
    };
    let with = if is_orientable || genus < 3 { "with" } else { "and" };
    match loops {
        0 => closed,
        1 => format!("{closed} {with} 1 boundary component"),
        _ => format!("{closed} {with} {loops} boundary components"),
    }
}

/// Classes of numbers that have been joined.
#[derive(Debug)]
pub struct Classes(Vec<u32>);

impl Classes {
    /// Each number is a class of its own.
    pub fn new(count: usize) -> Self {
        Self((0..count as u32).collect())
    }

    /// The number that stands for a class.
    pub fn of(&mut self, mut item: u32) -> u32 {
        while self.0[item as usize] != item {
            let above = self.0[self.0[item as usize] as usize];
            self.0[item as usize] = above;
            item = above;
        }
        item
    }

    /// Joins two classes; whether they were two.
    pub fn join(&mut self, a: u32, b: u32) -> bool {
        let (a, b) = (self.of(a), self.of(b));
        self.0[a.max(b) as usize] = a.min(b);
        a != b
    }
}

impl Surface {
    /// The faces of an input of dimension 2, each edge in one or two of them and each vertex with one fan of them or none.
    pub(crate) fn read(input: &[u8]) -> Result<Self, Fault> {
        let refuse = |message: &str| Fault::new("surface", message);
        let complex = Complex::read(input)?;
        let [_, edge_count, face_count] = *complex.counts() else {
            return Err(refuse("the input is no complex of dimension 2"));
        };
        let faces: Option<Vec<&[u32]>> = (0..face_count).map(|face| complex.vertices(2, face)).collect();
        let mut found = Self::of(&faces.ok_or_else(|| refuse("the faces have no vertices"))?)?;
        let used: BTreeSet<u32> = found.ends.iter().map(|ends| ends[0]).collect();
        found.isolated = complex.counts()[0].saturating_sub(used.len());
        match found.edge_count() == edge_count {
            true => Ok(found),
            false => Err(refuse("an edge lies in no face")),
        }
    }

    /// Faces by their vertices, which are different around a face. The faces that have an edge are one or two, those of a vertex one fan.
    pub(crate) fn of(faces: &[&[u32]]) -> Result<Self, Fault> {
        let refuse = |message: String| Fault::new("surface", message);
        let mut found = Self {
            ends: Vec::new(),
            face_of: Vec::new(),
            around: Vec::new(),
            edge_of: Vec::new(),
            sides_of: Vec::new(),
            face_count: faces.len(),
            isolated: 0,
            by_ends: HashMap::new(),
            by_vertices: HashMap::new(),
        };
        for (face, vertices) in (0u32..).zip(faces) {
            let (first, count) = (found.ends.len(), vertices.len());
            u32::try_from(first + count).map_err(|_| refuse("there are too many faces".to_owned()))?;
            let mut sorted = vertices.to_vec();
            sorted.sort_unstable();
            if count < 3 || sorted.windows(2).any(|pair| pair[0] == pair[1]) {
                return Err(refuse(format!("face {face} has fewer than three vertices, or one twice")));
            }
            found.by_vertices.insert(sorted, face);
            for i in 0..count {
                let ends @ [a, b] = [vertices[i], vertices[(i + 1) % count]];
                let next = found.sides_of.len() as u32;
                let edge = *found.by_ends.entry([a.min(b), a.max(b)]).or_insert(next);
                if edge == next {
                    found.sides_of.push(Vec::new());
                }
                found.sides_of[edge as usize].push((first + i) as u32);
                found.ends.push(ends);
                found.face_of.push(face);
                found.around.push([(i + count - 1) % count, (i + 1) % count].map(|i| (first + i) as u32));
                found.edge_of.push(edge);
            }
        }
        if let Some(sides) = found.sides_of.iter().find(|sides| sides.len() > 2) {
            let [a, b] = found.ends[sides[0] as usize];
            return Err(refuse(format!("edge {{{a}, {b}}} lies in {} faces", sides.len())));
        }
        let corners = found.corners(&vec![false; found.edge_count()]);
        let mut fans: Vec<(u32, u32)> = found.ends.iter().map(|ends| ends[0]).zip(corners).collect();
        fans.sort_unstable();
        fans.dedup();
        match fans.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            Some(pair) => Err(refuse(format!("the faces at vertex {} are more than one fan", pair[0].0))),
            None => Ok(found),
        }
    }

    /// The edge between two vertices.
    pub(crate) fn edge(&self, [a, b]: [u32; 2]) -> Option<u32> {
        self.by_ends.get(&[a.min(b), a.max(b)]).copied()
    }

    /// The face with these vertices in any order.
    pub(crate) fn face(&self, mut vertices: Vec<u32>) -> Option<u32> {
        vertices.sort_unstable();
        self.by_vertices.get(&vertices).copied()
    }

    /// A face that has this vertex.
    pub(crate) fn face_at(&self, vertex: u32) -> Option<u32> {
        let side = self.ends.iter().position(|ends| ends[0] == vertex)?;
        Some(self.face_of[side])
    }

    pub(crate) fn edge_count(&self) -> usize {
        self.sides_of.len()
    }

    /// Whether an edge lies in two faces.
    pub(crate) fn is_inner(&self, edge: u32) -> bool {
        self.sides_of[edge as usize].len() == 2
    }

    pub(crate) fn edge_of(&self, side: u32) -> u32 {
        self.edge_of[side as usize]
    }

    /// The faces of an edge, one or two.
    pub(crate) fn faces_of(&self, edge: u32) -> impl Iterator<Item = u32> + '_ {
        self.sides_of[edge as usize].iter().map(|&side| self.face_of[side as usize])
    }

    /// The faces around a corner's vertex, as pairs of a vertex and a face.
    pub(crate) fn corners_of_faces(&self) -> impl Iterator<Item = (u32, u32)> + '_ {
        self.ends.iter().map(|ends| ends[0]).zip(self.face_of.iter().copied())
    }

    /// Where a step starts and ends.
    pub(crate) fn ends_of(&self, step: Step) -> [u32; 2] {
        let [from, to] = self.ends[step.side as usize];
        if step.is_forward { [from, to] } else { [to, from] }
    }

    /// The two sides of each edge that is glued.
    fn glued<'a>(&'a self, is_cut: &'a [bool]) -> impl Iterator<Item = [u32; 2]> + 'a {
        let edges = self.sides_of.iter().zip(is_cut).filter(|(_, is_cut)| !**is_cut);
        edges.filter_map(|(sides, _)| <[u32; 2]>::try_from(&sides[..]).ok())
    }

    /// Whether two sides of one edge start at one vertex.
    fn is_parallel(&self, [a, b]: [u32; 2]) -> bool {
        self.ends[a as usize][0] == self.ends[b as usize][0]
    }

    /// For each corner its class: the vertex that it is at when edges have been cut.
    fn corners(&self, is_cut: &[bool]) -> Vec<u32> {
        let mut classes = Classes::new(self.ends.len());
        for [a, b] in self.glued(is_cut) {
            let [after_a, after_b] = [a, b].map(|side| self.around[side as usize][1]);
            let pairs = if self.is_parallel([a, b]) {
                [(a, b), (after_a, after_b)]
            } else {
                [(a, after_b), (after_a, b)]
            };
            pairs.into_iter().for_each(|(a, b)| {
                classes.join(a, b);
            });
        }
        (0..self.ends.len() as u32).map(|corner| classes.of(corner)).collect()
    }

    /// For each face a number of its piece, and the pieces that cutting along edges leaves.
    pub(crate) fn pieces(&self, is_cut: &[bool]) -> (Vec<usize>, Vec<Piece>) {
        let mut classes = Classes::new(self.face_count);
        // Faces twice, once for each way around: an orientable piece keeps the two apart.
        let mut turned = Classes::new(2 * self.face_count);
        for [a, b] in self.glued(is_cut) {
            let [f, g] = [a, b].map(|side| self.face_of[side as usize]);
            classes.join(f, g);
            let turn = u32::from(self.is_parallel([a, b]));
            turned.join(2 * f, 2 * g + turn);
            turned.join(2 * f + 1, 2 * g + 1 - turn);
        }
        let (mut numbers, mut pieces) = (HashMap::new(), Vec::<Piece>::new());
        let mut of_face = Vec::with_capacity(self.face_count);
        for face in 0..self.face_count as u32 {
            let number = *numbers.entry(classes.of(face)).or_insert(pieces.len());
            if number == pieces.len() {
                let is_orientable = turned.of(2 * face) != turned.of(2 * face + 1);
                pieces.push(Piece { is_orientable, ..Piece::default() });
            }
            pieces[number].counts[2] += 1;
            of_face.push(number);
        }
        for (corner, class) in self.corners(is_cut).into_iter().enumerate() {
            let counts = &mut pieces[of_face[self.face_of[corner] as usize]].counts;
            counts[0] += usize::from(class as usize == corner);
            let edge = self.edge_of[corner];
            let is_second = self.sides_of[edge as usize][0] as usize != corner;
            counts[1] += usize::from(is_cut[edge as usize] || !is_second);
        }
        let mut is_passed = vec![false; self.ends.len()];
        for side in 0..self.ends.len() as u32 {
            if self.is_free(side, is_cut) && !is_passed[side as usize] {
                let way = self.way(side, is_cut);
                way.iter().for_each(|step| is_passed[step.side as usize] = true);
                pieces[of_face[self.face_of[side as usize] as usize]].loops.push(way);
            }
        }
        (of_face, pieces)
    }

    /// Whether a side is on the boundary when edges have been cut.
    fn is_free(&self, side: u32, is_cut: &[bool]) -> bool {
        let edge = self.edge_of[side as usize];
        is_cut[edge as usize] || !self.is_inner(edge)
    }

    /// The way along the boundary from a free side back to it. At the end of a side it turns around the vertex, across glued edges, up to the
    /// next free side.
    fn way(&self, first: u32, is_cut: &[bool]) -> Vec<Step> {
        let start = Step { side: first, is_forward: true };
        let (mut at, mut way) = (start, Vec::new());
        loop {
            way.push(at);
            let vertex = self.ends_of(at)[1];
            at = self.after(at);
            while !self.is_free(at.side, is_cut) {
                let sides = &self.sides_of[self.edge_of[at.side as usize] as usize];
                let mate = if sides[0] == at.side { sides[1] } else { sides[0] };
                // The mate is passed towards the vertex, so that the next side starts there.
                at = self.after(Step { side: mate, is_forward: self.ends[mate as usize][1] == vertex });
            }
            if at.side == start.side {
                return way;
            }
        }
    }

    /// The next side of the same face.
    fn after(&self, Step { side, is_forward }: Step) -> Step {
        Step { side: self.around[side as usize][usize::from(is_forward)], is_forward }
    }
}

#[cfg(test)]
mod tests {
    use super::Surface;

    #[test]
    fn surfaces_have_their_names() {
        let plane = "[[0,1,4],[0,1,5],[0,2,3],[0,2,5],[0,3,4],[1,2,3],[1,2,4],[1,3,5],[2,4,5],[3,4,5]]";
        for (input, names) in [
            ("[[0,1,2]]", &["disk"][..]),
            ("[[0,1,2],[0,1,3],[0,2,3],[1,2,3],[5,6,7]]", &["sphere", "disk"]),
            (plane, &["projective plane"]),
            ("[[0,1,2],[1,2,3],[2,3,4],[3,4,0],[4,0,1]]", &["Moebius band"]),
            (
                "OFF\n6 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 1\n0 1 1\n4 0 1 4 3\n4 1 2 5 4\n4 2 0 3 5\n",
                &["annulus"],
            ),
        ] {
            let surface = Surface::read(input.as_bytes()).expect("a surface");
            let (_, pieces) = surface.pieces(&vec![false; surface.edge_count()]);
            assert_eq!(pieces.iter().map(super::Piece::name).collect::<Vec<_>>(), names, "{input}");
            // Cut along all edges it is so many disks.
            let (_, pieces) = surface.pieces(&vec![true; surface.edge_count()]);
            assert!(pieces.iter().all(|piece| piece.name() == "disk" && piece.counts[2] == 1), "{input}");
        }
    }

    #[test]
    fn what_is_no_surface_is_refused() {
        for (input, why) in [
            ("[[0,1,2],[2,3,4]]", "the faces at vertex 2 are more than one fan"),
            ("[[0,1,2],[2,3]]", "an edge lies in no face"),
            ("[[0,1,2],[0,1,3],[0,1,4]]", "lies in 3 faces"),
            ("[[0,1],[1,2]]", "no complex of dimension 2"),
            ("[[0,1,2,3]]", "no complex of dimension 2"),
        ] {
            let fault = Surface::read(input.as_bytes()).err().expect("no surface").to_string();
            assert!(fault.contains(why), "{input}: {fault}");
        }
    }
}
