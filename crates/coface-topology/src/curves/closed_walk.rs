//! Closed walks along edges.

use coface_algebra::chains::{Chain, TwoSkeleton};
use coface_algebra::{CellId, EdgeId, Error, ErrorKind, VertexId};
use coface_algebra::{Integer, RaggedArray};

/// A closed path along edges: each step starts where the one before ends, the first one where the last one ends.
///
/// It may meet vertices and edges several times. Without steps it stays at its start.
///
/// # Conventions
/// A step 2e runs along edge e, 2e + 1 against it.
///
/// # Examples
/// Around the rim of a triangle with the edges 01, 02, 12.
/// ```
/// use coface_algebra::VertexId;
/// use coface_complexes::known_spaces;
/// use coface_topology::ClosedWalk;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let skeleton = known_spaces::simplex(2)?.freeze().two_skeleton()?;
/// let around = ClosedWalk::from_vertices(&skeleton, &[[0, 1, 2, 0].map(VertexId::from_u32)])?.remove(0);
/// assert_eq!(around.steps(), [0, 4, 3]);
/// assert_eq!(around, ClosedWalk::new(&skeleton, vec![0, 4, 3])?);
/// assert!(ClosedWalk::new(&skeleton, vec![0, 4]).is_err());
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ClosedWalk {
    start: VertexId,
    steps: Vec<u32>,
}

impl ClosedWalk {
    /// The walk with these steps, of which there must be one at least.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] naming an edge that is not there; [`ErrorKind::InvalidInput`] for no steps and
    /// naming the first step that does not start where the one before ends, or the last one if it does not close the
    /// walk.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_topology::ClosedWalk;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A triangle with the edges 01, 02, 12.
    /// let skeleton = known_spaces::simplex(2)?.freeze().two_skeleton()?;
    /// // Along 01, along 12, back along 02.
    /// assert_eq!(ClosedWalk::new(&skeleton, vec![0, 4, 3])?.len(), 3);
    /// assert!(ClosedWalk::new(&skeleton, vec![0, 4]).is_err());
    /// # Ok(()) }
    /// ```
    pub fn new(skeleton: &TwoSkeleton, steps: Vec<u32>) -> Result<Self, Error> {
        let ends = skeleton.edge_ends();
        if let Some(step) = steps.iter().find(|&&step| step as usize >= ends.len()) {
            return Err(Error::new(
                ErrorKind::NotInComplex,
                format!("there is no edge {}; there are {}", EdgeId::from_u32(step >> 1), ends.len() / 2),
            ));
        }
        let (Some(&first), Some(&last)) = (steps.first(), steps.last()) else {
            return Err(Error::invalid("a walk without steps has no start")
                .with_cure("say at which vertex it stays: ClosedWalk::constant"));
        };
        let [source, target] =
            [0, 1].map(|end| move |step: u32| VertexId::from_u32(ends[(step ^ end) as usize]));
        for (i, pair) in steps.windows(2).enumerate() {
            if target(pair[0]) != source(pair[1]) {
                return Err(Error::invalid(format!(
                    "step {} of the walk starts at {}, but the step before ends at {}",
                    i + 2,
                    source(pair[1]),
                    target(pair[0])
                ))
                .with_cure("give the steps of a closed path in order"));
            }
        }
        if target(last) != source(first) {
            return Err(Error::invalid(format!(
                "the walk starts at {} but its last step ends at {}",
                source(first),
                target(last)
            ))
            .with_cure("give the steps of a closed path in order"));
        }
        Ok(Self { start: source(first), steps })
    }

    /// The walk without steps that stays at a vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_topology::ClosedWalk;
    /// let stay = ClosedWalk::constant(VertexId::new(2));
    /// assert_eq!((stay.start(), stay.len()), (VertexId::new(2), 0));
    /// ```
    pub fn constant(vertex: VertexId) -> Self {
        Self { start: vertex, steps: Vec::new() }
    }

    /// The walks through these lists of vertices, each of which ends with the vertex it starts with. Of several edges
    /// between two vertices the first one is taken.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] naming a vertex that is not there; [`ErrorKind::InvalidInput`] naming the walk and
    /// the first step between two vertices that no edge joins, and a list that is empty or does not close.
    ///
    /// # Complexity
    /// Linear in the edges and, times the degrees met, in the walks.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::known_spaces;
    /// use coface_topology::ClosedWalk;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A triangle with the edges 01, 02, 12.
    /// let skeleton = known_spaces::simplex(2)?.freeze().two_skeleton()?;
    /// let walks = ClosedWalk::from_vertices(&skeleton, &[[0, 1, 2, 0].map(VertexId::new)])?;
    /// assert_eq!(walks[0].steps(), [0, 4, 3]);
    /// # Ok(()) }
    /// ```
    pub fn from_vertices<L: AsRef<[VertexId]>>(
        skeleton: &TwoSkeleton,
        lists: &[L],
    ) -> Result<Vec<Self>, Error> {
        let ends = skeleton.edge_ends();
        let steps_at = RaggedArray::grouped(skeleton.vertex_count(), ends.iter().copied());
        let walk = |(index, list): (usize, &L)| {
            let (number, list) = (index + 1, list.as_ref());
            if let Some(vertex) = list.iter().find(|vertex| vertex.index() >= skeleton.vertex_count()) {
                return Err(Error::new(
                    ErrorKind::NotInComplex,
                    format!(
                        "walk {number} goes through {vertex}; there are {} vertices",
                        skeleton.vertex_count()
                    ),
                ));
            }
            let (Some(&first), Some(&last)) = (list.first(), list.last()) else {
                return Err(Error::invalid(format!("walk {number} has no vertices"))
                    .with_cure("name the vertex it stays at"));
            };
            if first != last {
                return Err(Error::invalid(format!("walk {number} starts at {first} but ends at {last}"))
                    .with_cure("close it: end with the vertex it starts with"));
            }
            let step = |(i, pair): (usize, &[VertexId])| {
                let mut steps = steps_at.list(pair[0].index()).iter().copied();
                steps.find(|&step| ends[(step ^ 1) as usize] == pair[1].to_u32()).ok_or_else(|| {
                    Error::invalid(format!(
                        "step {} of walk {number} goes from {} to {}, but no edge joins them",
                        i + 1,
                        pair[0],
                        pair[1]
                    ))
                    .with_cure("go along edges only")
                })
            };
            let steps = list.windows(2).enumerate().map(step).collect::<Result<_, Error>>()?;
            Ok(Self { start: first, steps })
        };
        lists.iter().enumerate().map(walk).collect()
    }

    /// The vertex where the walk starts and ends.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::known_spaces;
    /// use coface_topology::ClosedWalk;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A triangle with the edges 01, 02, 12.
    /// let skeleton = known_spaces::simplex(2)?.freeze().two_skeleton()?;
    /// let around = ClosedWalk::new(&skeleton, vec![0, 4, 3])?;
    /// assert_eq!(around.start(), VertexId::new(0));
    /// # Ok(()) }
    /// ```
    pub fn start(&self) -> VertexId {
        self.start
    }

    /// The steps: 2e along edge e, 2e + 1 against it.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_topology::ClosedWalk;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A triangle with the edges 01, 02, 12.
    /// let skeleton = known_spaces::simplex(2)?.freeze().two_skeleton()?;
    /// let around = ClosedWalk::new(&skeleton, vec![0, 4, 3])?;
    /// assert_eq!(around.steps(), [0, 4, 3]);
    /// # Ok(()) }
    /// ```
    pub fn steps(&self) -> &[u32] {
        &self.steps
    }

    /// The number of steps.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_topology::ClosedWalk;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A triangle with the edges 01, 02, 12.
    /// let skeleton = known_spaces::simplex(2)?.freeze().two_skeleton()?;
    /// let around = ClosedWalk::new(&skeleton, vec![0, 4, 3])?;
    /// assert_eq!(around.len(), 3);
    /// # Ok(()) }
    /// ```
    pub fn len(&self) -> usize {
        self.steps.len()
    }

    /// Whether the walk stays where it is.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_topology::ClosedWalk;
    /// assert!(ClosedWalk::constant(VertexId::new(0)).is_empty());
    /// ```
    pub fn is_empty(&self) -> bool {
        self.steps.is_empty()
    }

    /// The vertices that are met, from the start back to it: one more than there are steps.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::known_spaces;
    /// use coface_topology::ClosedWalk;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A triangle with the edges 01, 02, 12.
    /// let skeleton = known_spaces::simplex(2)?.freeze().two_skeleton()?;
    /// let around = ClosedWalk::new(&skeleton, vec![0, 4, 3])?;
    /// assert_eq!(around.vertices(&skeleton)[1], VertexId::new(1));
    /// # Ok(()) }
    /// ```
    pub fn vertices(&self, skeleton: &TwoSkeleton) -> Vec<VertexId> {
        let target = |&step: &u32| VertexId::from_u32(skeleton.edge_ends()[(step ^ 1) as usize]);
        std::iter::once(self.start).chain(self.steps.iter().map(target)).collect()
    }

    /// The walk backwards.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_topology::ClosedWalk;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A triangle with the edges 01, 02, 12.
    /// let skeleton = known_spaces::simplex(2)?.freeze().two_skeleton()?;
    /// let around = ClosedWalk::new(&skeleton, vec![0, 4, 3])?;
    /// assert_eq!(around.reversed().steps(), [2, 5, 1]);
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self { start: self.start, steps: self.steps.iter().rev().map(|step| step ^ 1).collect() }
    }

    /// The sum of the steps as a chain: a cycle of degree 1.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_topology::ClosedWalk;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A triangle with the edges 01, 02, 12.
    /// let skeleton = known_spaces::simplex(2)?.freeze().two_skeleton()?;
    /// let around = ClosedWalk::new(&skeleton, vec![0, 4, 3])?;
    /// assert_eq!(around.chain().to_string(), "c0 - c1 + c2");
    /// # Ok(()) }
    /// ```
    pub fn chain(&self) -> Chain<Integer> {
        let term =
            |&step: &u32| (CellId::from_u32(step >> 1), Integer::from(if step & 1 == 0 { 1 } else { -1 }));
        Chain::of_cells(1, self.steps.iter().map(term)).expect("integers can be added")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_complexes::known_spaces;

    #[test]
    fn walks_that_are_no_paths_are_refused() {
        let skeleton = known_spaces::simplex(2).unwrap().freeze().two_skeleton().unwrap();
        let fault =
            |steps: &[u32]| ClosedWalk::new(&skeleton, steps.to_vec()).unwrap_err().message().to_owned();
        assert_eq!(fault(&[0, 2, 5]), "step 2 of the walk starts at v0, but the step before ends at v1");
        assert_eq!(fault(&[0, 4]), "the walk starts at v0 but its last step ends at v2");
        assert_eq!(fault(&[0, 6]), "there is no edge e3; there are 3");
        let square = known_spaces::circle(4).unwrap().freeze().two_skeleton().unwrap();
        let fault = |vertices: &[u32]| {
            let list: Vec<VertexId> = vertices.iter().map(|&v| VertexId::from_u32(v)).collect();
            ClosedWalk::from_vertices(&square, &[list]).unwrap_err().message().to_owned()
        };
        assert_eq!(fault(&[0, 1, 3, 0]), "step 2 of walk 1 goes from v1 to v3, but no edge joins them");
        assert_eq!(fault(&[0, 1]), "walk 1 starts at v0 but ends at v1");
        assert_eq!(fault(&[0, 9, 0]), "walk 1 goes through v9; there are 4 vertices");
        assert_eq!(fault(&[]), "walk 1 has no vertices");
    }

    #[test]
    fn walks_have_vertices_and_chains() {
        let skeleton = known_spaces::simplex(2).unwrap().freeze().two_skeleton().unwrap();
        let around = ClosedWalk::new(&skeleton, vec![0, 4, 3]).unwrap();
        assert_eq!(around.vertices(&skeleton), [0, 1, 2, 0].map(VertexId::from_u32));
        assert_eq!(around.chain().to_string(), "c0 - c1 + c2");
        assert_eq!(around.reversed().chain(), around.chain().negated());
        let point = ClosedWalk::constant(VertexId::new(2));
        assert!(point.is_empty() && point.chain().is_zero());
        assert_eq!(point.vertices(&skeleton), [VertexId::new(2)]);
    }
}
