//! How copies of a fundamental domain are glued.

use crate::curves::CutSurface;
use crate::groups::SurfaceGroup;
use coface_algebra::{EdgeId, Error, FaceId, VertexId};
use coface_algebra::{Sign, UnionFind, Word};
use coface_complexes::surface::GeneralizedMap;

/// A side of the polygon.
#[derive(Clone, Copy, Debug)]
pub(super) struct DomainSide {
    /// The edge of the surface.
    pub(super) edge: EdgeId,
    /// Whether the walk around the polygon runs along or against the edge.
    pub(super) direction: Sign,
    /// The position of the other side on the edge; none on the boundary.
    pub(super) mate: Option<u32>,
    /// The number of its crossing among the distinct ones; 0 on the boundary.
    pub(super) crossing: u32,
    letter: i32,
}

/// The fundamental domain of a component, with the group and the crossings of its sides.
#[derive(Clone, Debug)]
pub(super) struct Domain {
    pub(super) group: SurfaceGroup,
    pub(super) sides: Vec<DomainSide>,
    /// The vertex of the surface at each position; at least one.
    pub(super) vertices: Vec<VertexId>,
    /// How many letters there are on the boundary before each position.
    pub(super) prefixes: Vec<u32>,
    /// The letters around the boundary.
    word: Vec<i32>,
    /// The distinct crossings.
    pub(super) crossings: Vec<Word>,
    /// The positions whose crossings are the letters.
    pub(super) letters: Vec<u32>,
    /// The edges inside of the domain.
    pub(super) inner_edges: Vec<EdgeId>,
    /// The number of each edge of the surface among the inner ones, if it is one.
    pub(super) inner_numbers: Vec<u32>,
    /// The positions of the ends of each inner edge.
    pub(super) inner_ends: Vec<[u32; 2]>,
    pub(super) faces: Vec<FaceId>,
}

impl Domain {
    /// The domain of a component of a surface.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::NotInComplex`] if there is no such component.
    pub(super) fn new(map: &GeneralizedMap, cut: &CutSurface, component: usize) -> Result<Self, Error> {
        let Some(found) = cut.domains().get(component) else {
            return Err(Error::new(
                coface_algebra::ErrorKind::NotInComplex,
                format!("there is no component {component}; the surface has {}", cut.domains().len()),
            ));
        };
        let word: Vec<i32> = found.letters().iter().copied().filter(|&letter| letter != 0).collect();
        let is_closed = found.relator().is_some();
        let group = match found.relator() {
            Some(relator) => SurfaceGroup::closed(&relator)?,
            None => {
                SurfaceGroup::free(word.iter().map(|letter| letter.unsigned_abs()).max().unwrap_or(0) as usize)
            }
        };
        let mut sides: Vec<DomainSide> = found
            .sides()
            .zip(found.letters())
            .map(|((side, sign), &letter)| DomainSide {
                edge: map.edge(side),
                direction: sign.times(Sign::power_of_minus_one((map.step(side) & 1) as usize)),
                mate: map.mate(side).map(|mate| {
                    cut.side_position(mate).expect("both sides of a cut edge are on the boundary") as u32
                }),
                crossing: 0,
                letter,
            })
            .collect();
        let vertices = match sides.as_slice() {
            [] => vec![found_vertex(map, cut, component)],
            sides => sides.iter().map(|side| source(map, side)).collect(),
        };
        // The whole walk around a closed component is the relator, which is the unit.
        let before = |position: usize| {
            let count = found.letters_before(position);
            if is_closed && count == word.len() { 0 } else { count as u32 }
        };
        let prefixes: Vec<u32> = (0..sides.len()).map(before).collect();
        // Copy x at position i is copy x g at the same corner there: P(i) = g P(corner).
        let crossings_of_sides = (0..sides.len()).map(|position| {
            let there = sides[position].mate? as usize;
            let is_twisted = sides[position].direction == sides[there].direction;
            Some([prefixes[position], before(if is_twisted { there } else { there + 1 })])
        });
        let crossings_of_sides: Vec<Option<[u32; 2]>> = crossings_of_sides.collect();
        let mut distinct: Vec<[u32; 2]> = crossings_of_sides.iter().flatten().copied().collect();
        distinct.sort_unstable();
        distinct.dedup();
        for (side, crossing) in sides.iter_mut().zip(&crossings_of_sides) {
            if let Some(crossing) = crossing {
                side.crossing = distinct.binary_search(crossing).expect("all crossings are listed") as u32;
            }
        }
        let prefix = |count: u32| Word::from_letters(word[..count as usize].iter().copied());
        let crossings = distinct.into_iter().map(|[a, b]| prefix(a).times(&prefix(b).inverse())).collect();
        let letters = letters(map, &sides);
        assert_eq!(letters.len(), group.generator_count(), "as many letters as generators");
        let (mut faces, mut inner_edges, mut inner_ends) = (Vec::new(), Vec::new(), Vec::new());
        let mut inner_numbers = vec![0; map.f_vector()[1]];
        for face in (0..map.f_vector()[2]).map(FaceId::new) {
            let mut rim = map.sides_of(face);
            let first = rim.clone().next().expect("every face has sides");
            if cut.component(map, first) != component {
                continue;
            }
            faces.push(face);
            for side in rim.by_ref() {
                if cut.side_position(side).is_some() || map.first_side(map.edge(side)) != side {
                    continue;
                }
                let [a, b] = [side, map.next(side)].map(|side| cut.corner_position(side) as u32);
                inner_numbers[map.edge(side).index()] = inner_edges.len() as u32;
                inner_edges.push(map.edge(side));
                inner_ends.push(if map.step(side) & 1 == 0 { [a, b] } else { [b, a] });
            }
        }
        Ok(Self {
            group,
            sides,
            vertices,
            prefixes,
            word,
            crossings,
            letters,
            inner_edges,
            inner_numbers,
            inner_ends,
            faces,
        })
    }

    /// Whether the component has no boundary.
    pub(super) fn is_closed(&self) -> bool {
        self.sides.iter().all(|side| side.mate.is_some())
    }

    /// Whether the component is orientable: no two sides run along their edge in the same direction.
    pub(super) fn is_orientable(&self) -> bool {
        let mut glued = self.sides.iter().filter_map(|side| Some((side, &self.sides[side.mate? as usize])));
        glued.all(|(side, mate)| side.direction != mate.direction)
    }

    /// The Euler characteristic of the component.
    pub(super) fn euler_characteristic(&self) -> i64 {
        1 - self.group.generator_count() as i64 + i64::from(self.is_closed())
    }

    /// The letters around the boundary.
    pub(super) fn word(&self) -> &[i32] {
        &self.word
    }

    /// The words of the boundary before each letter, and that after all.
    pub(super) fn prefix_words(&self) -> impl Iterator<Item = Word> + '_ {
        (0..=self.word.len()).map(|count| Word::from_letters(self.word[..count].iter().copied()))
    }

    /// The number of vertices, edges and faces of the domain.
    pub(super) fn cell_count(&self) -> usize {
        self.vertices.len() + self.sides.len() + self.inner_edges.len() + self.faces.len()
    }

    /// The word around the boundary before a position.
    pub(super) fn prefix(&self, position: usize) -> Word {
        Word::from_letters(self.word[..self.prefixes[position] as usize].iter().copied())
    }

    /// The position after this one.
    pub(super) fn after(&self, position: usize) -> usize {
        if position + 1 == self.sides.len() { 0 } else { position + 1 }
    }

    /// The corners of the mate at the start and at the end of a side.
    pub(super) fn mate_corners(&self, position: usize, mate: usize) -> [usize; 2] {
        if self.sides[position].direction == self.sides[mate].direction {
            [mate, self.after(mate)]
        } else {
            [self.after(mate), mate]
        }
    }
}

/// The vertex where the walk along a side starts.
fn source(map: &GeneralizedMap, side: &DomainSide) -> VertexId {
    map.skeleton().edge(side.edge)[usize::from(side.direction == Sign::Minus)]
}

/// The one vertex of a sphere that is not cut.
fn found_vertex(map: &GeneralizedMap, cut: &CutSurface, component: usize) -> VertexId {
    let mut sides = map.sides().filter(|&side| cut.component(map, side) == component);
    map.source(sides.next().expect("a component has a face with sides"))
}

/// Cut edges whose crossings generate the group freely but for the relator: those that are not on a spanning tree of
/// the cut graph in which the whole boundary counts as one vertex. Around each inner vertex of the tree the crossings
/// make a relation, which eliminates one tree edge. Edges of the tree-cotree's tree are preferred for it.
fn letters(map: &GeneralizedMap, sides: &[DomainSide]) -> Vec<u32> {
    let mut classes = UnionFind::new(map.f_vector()[0]);
    let ends = |side: &DomainSide| map.skeleton().edge(side.edge).map(VertexId::to_u32);
    let mut border = None;
    for side in sides.iter().filter(|side| side.mate.is_none()) {
        for end in ends(side) {
            classes.unite(*border.get_or_insert(end), end);
        }
    }
    // One side of each edge, where its letter is read forwards if there is such a side.
    let mut order: Vec<u32> = (0..sides.len() as u32)
        .filter(|&position| {
            let side = &sides[position as usize];
            side.mate.is_some_and(|mate| {
                let other = &sides[mate as usize];
                let rank = |side: &DomainSide, at: u32| (side.letter < 0, at);
                rank(side, position) < rank(other, mate)
            })
        })
        .collect();
    order.sort_by_key(|&position| (sides[position as usize].letter.unsigned_abs(), position));
    order.retain(|&position| {
        let [a, b] = ends(&sides[position as usize]);
        !classes.unite(a, b)
    });
    order
}
