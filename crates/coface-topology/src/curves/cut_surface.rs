//! Surfaces cut open along a cut graph: fundamental domains and the words of edges.

use super::{EdgeRole, TreeCotree};
use coface_algebra::progress::stage;
use coface_algebra::{EdgeId, FaceId, HalfedgeId};
use coface_algebra::{Sign, Word};
use coface_complexes::surface::GeneralizedMap;

/// No position on a boundary.
const NONE: u32 = u32::MAX;

/// A surface cut along the cut graph of a [`TreeCotree`]: every edge that the cotree does not cross.
///
/// Each component becomes a disk, its [`FundamentalDomain`]. Every vertex is on the cut graph, so every corner of a
/// face is at a **position** on the boundary of its domain, and every edge leads from one position to another: that
/// gives each edge a word in the generators.
///
/// # Conventions
/// A path is multiplied from left to right. Letter i of component k is `trees.components()[k].generators()[i - 1]`, run
/// through as the edge runs, -i the same backwards. All corners of a domain at one vertex are that vertex, moved
/// along the tree to the base; so words of closed paths are elements of the fundamental group at the base, up to
/// conjugation when they start elsewhere: by the path in the tree.
///
/// # References
/// H. Seifert, W. Threlfall, *Lehrbuch der Topologie* (1934), chapter 6, for polygons with sides identified in pairs.
///
/// # Examples
/// The torus with 7 vertices: 8 edges are cut, the domain has 16 sides, and the relator is a commutator.
/// ```
/// use coface_complexes::known_spaces;
/// use coface_complexes::surface::GeneralizedMap;
/// use coface_topology::{CutSurface, TreeCotree};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = GeneralizedMap::new(known_spaces::cyclic_torus(2)?.freeze().two_skeleton()?)?;
/// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
/// let domain = &cut.domains()[0];
/// assert_eq!((domain.cut_edge_count(), domain.side_count()), (8, 16));
/// assert_eq!(domain.f_vector(), [16, 29, 14]);
/// assert_eq!(domain.relator().expect("the torus is closed").len(), 4);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CutSurface {
    /// The position of the corner where each side starts.
    corner_positions: Vec<u32>,
    /// The position of each side on the boundary of its domain; none if the cotree crosses it.
    side_positions: Vec<u32>,
    components: Vec<u32>,
    domains: Vec<FundamentalDomain>,
}

/// The polygon that a component of a surface becomes when it is cut along the cut graph.
///
/// Its sides are numbered by **positions** in the order of a walk around it. Position i is also that of the corner
/// where side i starts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FundamentalDomain {
    /// 2s for side s of the surface, 2s + 1 if the walk runs against the rim of its face.
    sides: Vec<u32>,
    /// The letter of each side; 0 for sides on the tree and on the boundary edge that belongs to the cotree.
    letters: Vec<i32>,
    /// How many letters there are before each position.
    letters_before: Vec<u32>,
    word: Vec<i32>,
    is_closed: bool,
    cut_edge_count: usize,
    f_vector: [usize; 3],
}

impl FundamentalDomain {
    /// The number of sides of the polygon: two for each cut edge, one for each edge of the boundary.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutSurface, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
    /// let domain = &cut.domains()[0];
    /// assert_eq!(domain.side_count(), 4);
    /// # Ok(()) }
    /// ```
    pub fn side_count(&self) -> usize {
        self.sides.len()
    }

    /// The sides of the polygon in the order of the walk: sides of faces, and the sign minus where the walk runs
    /// against the rim of the face.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Sign;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutSurface, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
    /// let domain = &cut.domains()[0];
    /// assert!(domain.sides().all(|(_, sign)| sign == Sign::Plus));
    /// # Ok(()) }
    /// ```
    pub fn sides(&self) -> impl ExactSizeIterator<Item = (HalfedgeId, Sign)> + '_ {
        self.sides.iter().map(|&packed| {
            (HalfedgeId::from_u32(packed >> 1), Sign::power_of_minus_one((packed & 1) as usize))
        })
    }

    /// The letter that each side reads: i for generator i, -i for it backwards, 0 on the tree. In a component with
    /// boundary the last side is the boundary edge that belongs to the cotree; it reads 0 as well.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutSurface, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
    /// let domain = &cut.domains()[0];
    /// assert_eq!(domain.letters(), [1, 2, -1, -2]);
    /// # Ok(()) }
    /// ```
    pub fn letters(&self) -> &[i32] {
        &self.letters
    }

    /// The number of cut edges in the interior of the surface.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutSurface, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
    /// let domain = &cut.domains()[0];
    /// assert_eq!(domain.cut_edge_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn cut_edge_count(&self) -> usize {
        self.cut_edge_count
    }

    /// The numbers of vertices, edges and faces of the domain.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutSurface, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
    /// let domain = &cut.domains()[0];
    /// assert_eq!(domain.f_vector(), [4, 4, 1]);
    /// # Ok(()) }
    /// ```
    pub fn f_vector(&self) -> [usize; 3] {
        self.f_vector
    }

    /// Vertices minus edges plus faces: 1, since it is a disk. A sphere with a single vertex has a cut graph without
    /// edges; there it is 2.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutSurface, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
    /// let domain = &cut.domains()[0];
    /// assert_eq!(domain.euler_characteristic(), 1);
    /// # Ok(()) }
    /// ```
    pub fn euler_characteristic(&self) -> i64 {
        let [v, e, f] = self.f_vector;
        v as i64 - e as i64 + f as i64
    }

    /// The word around the boundary, in which each generator occurs twice: the relator of the fundamental group.
    /// `None` for components with boundary, whose generators are free.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutSurface, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
    /// let domain = &cut.domains()[0];
    /// assert_eq!(domain.relator().expect("the torus is closed").letters(), [1, 2, -1, -2]);
    /// # Ok(()) }
    /// ```
    pub fn relator(&self) -> Option<Word> {
        self.is_closed.then(|| Word::from_letters(self.word.iter().copied()))
    }

    /// The number of letters before a position.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutSurface, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
    /// let domain = &cut.domains()[0];
    /// assert_eq!(domain.letters_before(3), 3);
    /// # Ok(()) }
    /// ```
    pub fn letters_before(&self, position: usize) -> usize {
        self.letters_before[position] as usize
    }

    /// The word from one position to another along the boundary, without passing the end of the walk.
    ///
    /// # Panics
    /// If a position is above the number of sides.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutSurface, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
    /// let domain = &cut.domains()[0];
    /// assert_eq!(domain.word_between(0, 2).letters(), [1, 2]);
    /// assert_eq!(domain.word_between(2, 0).letters(), [-2, -1]);
    /// # Ok(()) }
    /// ```
    pub fn word_between(&self, from: usize, to: usize) -> Word {
        let [a, b] = [from, to].map(|position| self.letters_before[position] as usize);
        if a <= b {
            Word::from_letters(self.word[a..b].iter().copied())
        } else {
            Word::from_letters(self.word[b..a].iter().copied()).inverse()
        }
    }
}

impl CutSurface {
    /// Walks around the domains.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Panics
    /// If the trees are not of this surface.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutSurface, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
    /// assert_eq!(cut.domains().len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn new(map: &GeneralizedMap, trees: &TreeCotree) -> Self {
        let signs = trees.face_signs(map);
        let mut cut = Self {
            corner_positions: vec![0; map.side_count()],
            side_positions: vec![NONE; map.side_count()],
            components: (0..map.skeleton().face_count())
                .map(|face| trees.component_of_face(FaceId::new(face)) as u32)
                .collect(),
            domains: Vec::new(),
        };
        let walker = Walker { map, trees, signs };
        let mut starts = vec![None; trees.components().len()];
        for side in map.sides().rev().filter(|&side| !walker.is_crossed(side)) {
            starts[trees.component_of_face(map.face(side))] = Some(side);
        }
        for (component, found) in trees.components().iter().enumerate() {
            let exit = trees.exit(found.root()).filter(|_| found.has_boundary());
            let sides = match (exit, starts[component]) {
                (Some(exit), _) => walker.around(exit, true, &mut cut.corner_positions),
                (None, Some(start)) => walker.around(start, false, &mut cut.corner_positions),
                (None, None) => Vec::new(),
            };
            for (position, &packed) in sides.iter().enumerate() {
                cut.side_positions[(packed >> 1) as usize] = position as u32;
            }
            cut.domains.push(FundamentalDomain::new(map, trees, component, sides));
        }
        let mut counts = vec![[0; 2]; cut.domains.len()];
        let steps = stage("counting edges of domains", map.skeleton().edge_count());
        for edge in steps.each((0..map.skeleton().edge_count()).map(EdgeId::new)) {
            counts[cut.component(map, map.first_side(edge))][0] += 1;
        }
        for &component in &cut.components {
            counts[component as usize][1] += 1;
        }
        for (domain, [edges, faces]) in cut.domains.iter_mut().zip(counts) {
            let vertices = domain.sides.len().max(1);
            domain.f_vector = [vertices, edges + domain.cut_edge_count, faces];
        }
        cut
    }

    /// The domains, one for each component of the trees.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutSurface, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
    /// assert_eq!(cut.domains()[0].f_vector(), [4, 4, 1]);
    /// # Ok(()) }
    /// ```
    pub fn domains(&self) -> &[FundamentalDomain] {
        &self.domains
    }

    /// The component, and so the domain, that a side is in.
    ///
    /// # Panics
    /// If there is no such side. Likewise the functions that follow panic where there is no such cell.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::HalfedgeId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutSurface, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
    /// assert_eq!(cut.component(&torus, HalfedgeId::new(3)), 0);
    /// # Ok(()) }
    /// ```
    pub fn component(&self, map: &GeneralizedMap, side: HalfedgeId) -> usize {
        self.components[map.face(side).index()] as usize
    }

    /// The position on the boundary of its domain of the corner where a side starts.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::HalfedgeId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutSurface, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
    /// assert_eq!(cut.corner_position(HalfedgeId::new(0)), 0);
    /// # Ok(()) }
    /// ```
    pub fn corner_position(&self, side: HalfedgeId) -> usize {
        self.corner_positions[side.index()] as usize
    }

    /// The position of a side on the boundary of its domain; `None` if the cotree crosses it.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::HalfedgeId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutSurface, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
    /// assert_eq!(cut.side_position(HalfedgeId::new(0)), Some(0));
    /// # Ok(()) }
    /// ```
    pub fn side_position(&self, side: HalfedgeId) -> Option<usize> {
        let position = self.side_positions[side.index()];
        (position != NONE).then_some(position as usize)
    }

    /// The word of a side, run through in the direction of the rim of its face.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::HalfedgeId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutSurface, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
    /// assert_eq!(cut.side_word(&torus, HalfedgeId::new(0)).letters(), [1]);
    /// # Ok(()) }
    /// ```
    pub fn side_word(&self, map: &GeneralizedMap, side: HalfedgeId) -> Word {
        let domain = &self.domains[self.component(map, side)];
        let walked = self.side_position(side).map(|position| (position, domain.letters[position]));
        match walked {
            // The last side of a walk leads back to position 0; its own letter is the shortest word.
            Some((position, letter)) if letter != 0 => {
                let letter = if domain.sides[position] & 1 == 0 { letter } else { -letter };
                Word::from_letters([letter])
            }
            Some((position, _)) if domain.is_closed || position + 1 < domain.side_count() => {
                Word::from_letters([])
            }
            _ => domain.word_between(self.corner_position(side), self.corner_position(map.next(side))),
        }
    }

    /// The word of a path of steps (2e along edge e, 2e + 1 against it): an element of the fundamental group if it is
    /// closed.
    ///
    /// # Complexity
    /// Linear in the number of steps times the number of letters around the domain.
    ///
    /// # Examples
    /// The loop of a generator has the word of that generator.
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_complexes::surface::GeneralizedMap;
    /// use coface_topology::{CutSurface, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = GeneralizedMap::new(known_spaces::cyclic_torus(2)?.freeze().two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let cut = CutSurface::new(&torus, &trees);
    /// let second = trees.components()[0].generators()[1];
    /// assert_eq!(cut.path_word(&torus, &trees.based_loop(&torus, second)).letters(), [2]);
    /// # Ok(()) }
    /// ```
    pub fn path_word(&self, map: &GeneralizedMap, steps: &[u32]) -> Word {
        let mut word = Word::from_letters([]);
        for &step in steps {
            let side = map.first_side(EdgeId::from_u32(step >> 1));
            let along = self.side_word(map, side);
            word.append(&if map.step(side) == step { along } else { along.inverse() });
        }
        word
    }

    /// The copy of the domain across a cut side: in the universal cover copy x meets copy x g at this side, and the
    /// result is the word of g. `None` on the boundary and for sides that the cotree crosses.
    ///
    /// The corner of copy x at position i is the base moved by x P(i), P(i) being the word of the first i sides. Side
    /// i of copy x is side j of copy x g: their corners agree, x P(i) = x g P(j + 1), or x P(i) = x g P(j) if both
    /// run along their edge in the same direction.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::HalfedgeId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutSurface, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
    /// // Across a side of the first loop lies the copy that the second loop leads to.
    /// let word = cut.crossing(&torus, HalfedgeId::new(0)).expect("a cut side");
    /// assert_eq!(word.exponent_sums(2).iter().map(|x| x.abs()).collect::<Vec<_>>(), [0, 1]);
    /// # Ok(()) }
    /// ```
    pub fn crossing(&self, map: &GeneralizedMap, side: HalfedgeId) -> Option<Word> {
        let mate = map.mate(side)?;
        let [here, there] = [self.side_position(side)?, self.side_position(mate)?];
        let domain = &self.domains[self.component(map, side)];
        let direction = |position: usize, side| (domain.sides[position] ^ map.step(side)) & 1;
        let corner = if direction(here, side) == direction(there, mate) { there } else { there + 1 };
        Some(domain.word_between(0, here).times(&domain.word_between(0, corner).inverse()))
    }

    /// The edges of the cut graph: all that the cotree does not cross from face to face, those of the boundary among
    /// them.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutSurface, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
    /// assert_eq!(cut.cut_graph(&torus).len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn cut_graph(&self, map: &GeneralizedMap) -> Vec<EdgeId> {
        let edges = (0..map.skeleton().edge_count()).map(EdgeId::new);
        edges.filter(|&edge| self.side_position(map.first_side(edge)).is_some()).collect()
    }
}

impl FundamentalDomain {
    fn new(map: &GeneralizedMap, trees: &TreeCotree, component: usize, sides: Vec<u32>) -> Self {
        let found = &trees.components()[component];
        let mut letters = Vec::with_capacity(sides.len());
        let mut letters_before = vec![0];
        let mut word = Vec::new();
        let mut inner = 0;
        for &packed in &sides {
            let side = HalfedgeId::from_u32(packed >> 1);
            inner += usize::from(map.mate(side).is_some());
            let letter = match found.generators().binary_search(&map.edge(side)) {
                Err(_) => 0,
                Ok(index) => {
                    let letter = i32::try_from(index + 1).expect("there are fewer than 2^31 generators");
                    if (packed ^ map.step(side)) & 1 == 0 { letter } else { -letter }
                }
            };
            letters.push(letter);
            if letter != 0 {
                word.push(letter);
            }
            letters_before.push(word.len() as u32);
        }
        Self {
            sides,
            letters,
            letters_before,
            word,
            is_closed: !found.has_boundary(),
            cut_edge_count: inner / 2,
            f_vector: [0; 3],
        }
    }
}

/// Walks around domains.
struct Walker<'a> {
    map: &'a GeneralizedMap,
    trees: &'a TreeCotree,
    signs: Vec<Sign>,
}

impl Walker<'_> {
    /// Whether the cotree crosses a side from face to face.
    fn is_crossed(&self, side: HalfedgeId) -> bool {
        self.map.mate(side).is_some() && self.trees.roles()[self.map.edge(side).index()] == EdgeRole::Cotree
    }

    /// The sides of the domain that side `start` is on, from it on, or from the next one on up to it if it comes
    /// last. Notes the position of each corner that is passed.
    fn around(&self, start: HalfedgeId, is_last: bool, corner_positions: &mut [u32]) -> Vec<u32> {
        let packed = |side: HalfedgeId| {
            2 * side.to_u32() + u32::from(self.signs[self.map.face(side).index()] == Sign::Minus)
        };
        let mut sides = Vec::new();
        let mut corners = Vec::new();
        let mut at = start;
        let steps = stage("walking around a domain", 0);
        let mut walked = 0;
        loop {
            walked += 1;
            steps.pass(walked);
            if !is_last {
                sides.push(packed(at));
            }
            // The corners between this side and the next.
            let from = at;
            at = self.turn(from, &mut corners);
            while self.is_crossed(at) {
                let mate = self.map.mate(at).expect("a crossed side has a mate");
                at = self.turn(mate, &mut corners);
            }
            let position = if at == start && !is_last { 0 } else { sides.len() as u32 };
            for corner in corners.drain(..) {
                corner_positions[corner as usize] = position;
            }
            if is_last {
                sides.push(packed(at));
            }
            if at == start {
                return sides;
            }
        }
    }

    /// The side after this one on the rim of its face, in the direction of the walk; notes the corner between them.
    fn turn(&self, side: HalfedgeId, corners: &mut Vec<u32>) -> HalfedgeId {
        if self.signs[self.map.face(side).index()] == Sign::Plus {
            let next = self.map.next(side);
            corners.push(next.to_u32());
            next
        } else {
            corners.push(side.to_u32());
            self.map.previous(side)
        }
    }
}

#[cfg(test)]
mod tests;
