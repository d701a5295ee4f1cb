//! Bistellar moves: changing a triangulation of a manifold into a smaller one, as a certificate that it is a sphere or a ball.

use super::{Simplex, SimplicialComplex};
use coface_algebra::{Error, RaggedArray, SpreadMap};
use std::hash::{Hash, Hasher};

/// A bistellar move: a simplex A whose link is the boundary of a simplex B that is not in the complex gives way to B.
///
/// The join of A with the boundary of B, a ball, is replaced by the join of the boundary of A with B, a ball with the same
/// boundary. What is left is homeomorphic, in the piecewise linear sense, to what was there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BistellarMove {
    removed: Simplex,
    added: Simplex,
}

impl BistellarMove {
    /// The simplex A that is removed with its cofaces.
    pub fn removed(&self) -> &Simplex {
        &self.removed
    }

    /// The simplex B that is added with its cofaces.
    pub fn added(&self) -> &Simplex {
        &self.added
    }
}

/// Bistellar moves that lead from a complex, or from the complex with a cone over its boundary, to the boundary of a simplex.
///
/// [`Self::check`] follows them, so that nobody has to trust the search that found them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SphereCertificate {
    apex: Option<u32>,
    moves: Vec<BistellarMove>,
}

impl SphereCertificate {
    /// The apex of the cone over the boundary, when the complex is a ball; `None` for a sphere.
    pub fn apex(&self) -> Option<u32> {
        self.apex
    }

    /// The moves, in order.
    pub fn moves(&self) -> &[BistellarMove] {
        &self.moves
    }

    /// Follows the moves from the complex to the boundary of a simplex.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] with the number of the first move that is none, or if the last complex is not the
    /// boundary of a simplex.
    ///
    /// # Examples
    /// The boundary of the octahedron is a sphere.
    /// ```
    /// use coface_complexes::known_spaces::cross_polytope_boundary;
    /// use coface_complexes::simplicial::recognize_sphere;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sphere = cross_polytope_boundary(2)?;
    /// let certificate = recognize_sphere(&sphere, 1000)?.expect("six vertices are few");
    /// certificate.check(&sphere)?;
    /// # Ok(()) }
    /// ```
    pub fn check(&self, complex: &SimplicialComplex) -> Result<(), Error> {
        if complex.dimension().is_none_or(|dimension| dimension > MOST_DIMENSIONS) {
            return Err(Error::invalid(format!("certificates are for dimensions 1 to {MOST_DIMENSIONS}")));
        }
        let (apex, mut triangulation) = match self.apex {
            None => (None, Triangulation::of_closed(complex)?),
            Some(_) => {
                let (apex, triangulation) = Triangulation::of_cone(complex)?;
                (Some(apex), triangulation)
            }
        };
        if apex != self.apex {
            return Err(Error::invalid("the apex of the certificate is a vertex of the complex"));
        }
        for (number, one) in self.moves.iter().enumerate() {
            let fault =
                || Error::invalid(format!("move {number} is no bistellar move of the complex at that point"));
            let (removed, added) = (Face::of(one.removed.numbers()), Face::of(one.added.numbers()));
            let (removed, added) = (removed.ok_or_else(fault)?, added.ok_or_else(fault)?);
            if !triangulation.may_move(&removed, &added) {
                return Err(fault());
            }
            triangulation.apply(&removed, &added);
        }
        match triangulation.is_simplex_boundary() {
            true => Ok(()),
            false => Err(Error::invalid("the moves end before the boundary of a simplex")),
        }
    }
}

/// Looks for bistellar moves from a closed manifold to the boundary of a simplex: `None` if the search made `budget` moves without
/// success, or the dimension is above 7. Success proves that the complex is a sphere in the piecewise linear sense.
///
/// The search prefers moves that remove facets; when there are none it makes some that add facets, at random with a fixed seed, and goes
/// on. It is the same at every run.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] if a ridge does not lie in exactly two facets, or a facet is below the top dimension.
///
/// # Complexity
/// $O(b (2^d + s))$ for b moves in dimension d, with stars of s facets.
///
/// # References
/// A. Bjorner, F. H. Lutz, *Simplicial manifolds, bistellar flips and a 16-vertex triangulation of the Poincare homology
/// 3-sphere*, Experimental Mathematics 9 (2000); U. Pachner, *P.L. homeomorphic manifolds are equivalent by elementary shellings*,
/// European Journal of Combinatorics 12 (1991).
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces::{cross_polytope_boundary, cyclic_torus};
/// use coface_complexes::simplicial::recognize_sphere;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// assert!(recognize_sphere(&cross_polytope_boundary(3)?, 1000)?.is_some());
/// assert!(recognize_sphere(&cyclic_torus(2)?, 1000)?.is_none(), "a torus is no sphere");
/// # Ok(()) }
/// ```
pub fn recognize_sphere(
    complex: &SimplicialComplex,
    budget: usize,
) -> Result<Option<SphereCertificate>, Error> {
    if complex.dimension().is_none_or(|dimension| dimension > MOST_DIMENSIONS) {
        return Ok(None);
    }
    let moves = Triangulation::of_closed(complex)?.reduce(budget);
    Ok(moves.map(|moves| SphereCertificate { apex: None, moves }))
}

/// Looks for bistellar moves from a manifold with a cone over its boundary to the boundary of a simplex. Success proves that the complex,
/// if it is a manifold with boundary, is a ball: what is left of a sphere without the star of a vertex.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] if a ridge lies in three facets, a facet is below the top dimension, or there is no boundary.
///
/// # Complexity
/// As [`recognize_sphere`].
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces::simplex;
/// use coface_complexes::simplicial::recognize_ball;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let ball = simplex(3)?;
/// let certificate = recognize_ball(&ball, 10)?.expect("a tetrahedron");
/// assert!(certificate.moves().is_empty(), "with the cone over its boundary it is the boundary of a 4-simplex");
/// certificate.check(&ball)?;
/// # Ok(()) }
/// ```
pub fn recognize_ball(
    complex: &SimplicialComplex,
    budget: usize,
) -> Result<Option<SphereCertificate>, Error> {
    if complex.dimension().is_none_or(|dimension| dimension > MOST_DIMENSIONS) {
        return Ok(None);
    }
    let (apex, mut triangulation) = Triangulation::of_cone(complex)?;
    Ok(triangulation.reduce(budget).map(|moves| SphereCertificate { apex: Some(apex), moves }))
}

/// Whether facets of one size, given rising, are a sphere or a ball: a simplex, the boundary of one, or what moves lead there.
pub(super) fn is_sphere_or_ball(facets: &RaggedArray) -> bool {
    if facets.len() == 1 {
        return true;
    }
    let size = facets.iter().next().map_or(0, <[u32]>::len);
    if facets.len() == size + 1 {
        let mut vertices: Vec<u32> = facets.iter().flatten().copied().collect();
        vertices.sort_unstable();
        vertices.dedup();
        if vertices.len() == size + 1 {
            return true;
        }
    }
    if !(2..=MOST_VERTICES).contains(&size) {
        return false;
    }
    let lists = facets.iter().map(|facet| Face::of(facet).expect("the size is checked"));
    let Ok((mut triangulation, rim)) = Triangulation::of_faces(size - 1, lists) else { return false };
    if !rim.is_empty() {
        triangulation.close(&rim);
    }
    triangulation.reduce(LINK_MOVES + 20 * facets.len()).is_some()
}

/// So many moves are tried on a link, and more on a large one.
const LINK_MOVES: usize = 10_000;
/// Above this dimension nothing is tried: a facet has more faces than are worth it.
const MOST_DIMENSIONS: usize = 7;
const MOST_VERTICES: usize = MOST_DIMENSIONS + 1;
/// After so many moves in vain the search heats more.
const PATIENCE: usize = 200;

/// The vertices of a simplex, rising, without memory of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Face {
    vertices: [u32; MOST_VERTICES],
    len: u8,
}

impl Hash for Face {
    fn hash<H: Hasher>(&self, state: &mut H) {
        // Two vertices are one number; behind the last there are zeros.
        for pair in self.vertices[..usize::from(self.len).next_multiple_of(2)].as_chunks::<2>().0 {
            state.write_u64(u64::from(pair[0]) << 32 | u64::from(pair[1]));
        }
    }
}

impl Face {
    /// `None` for more vertices than fit. The numbers are rising.
    fn of(numbers: &[u32]) -> Option<Self> {
        let mut vertices = [0; MOST_VERTICES];
        vertices.get_mut(..numbers.len())?.copy_from_slice(numbers);
        Some(Self { vertices, len: numbers.len() as u8 })
    }

    fn numbers(&self) -> &[u32] {
        &self.vertices[..usize::from(self.len)]
    }

    fn contains(&self, vertex: u32) -> bool {
        self.numbers().contains(&vertex)
    }

    fn is_face_of(&self, other: &Self) -> bool {
        self.numbers().iter().all(|&vertex| other.contains(vertex))
    }

    /// The face of the vertices whose bits are set.
    fn choose(&self, bits: u32) -> Self {
        let mut face = Self { vertices: [0; MOST_VERTICES], len: 0 };
        for (i, &vertex) in self.numbers().iter().enumerate() {
            if bits >> i & 1 == 1 {
                face.vertices[usize::from(face.len)] = vertex;
                face.len += 1;
            }
        }
        face
    }

    fn without(&self, position: usize) -> Self {
        self.choose(((1 << self.len) - 1) & !(1 << position))
    }

    /// The face of all vertices of two faces without a common one.
    fn join(&self, other: &Self) -> Self {
        let mut face = *self;
        for &vertex in other.numbers() {
            face.vertices[usize::from(face.len)] = vertex;
            face.len += 1;
        }
        let len = usize::from(face.len);
        face.vertices[..len].sort_unstable();
        face
    }

    fn to_simplex(self) -> Simplex {
        Simplex::from_sorted(self.numbers())
    }
}

/// A closed triangulation that changes by bistellar moves.
struct Triangulation {
    dimension: usize,
    /// In how many facets each face lies.
    degrees: SpreadMap<Face, u32>,
    facets: Facets,
    /// For each number of vertices, faces whose link has the size of the boundary of a simplex, among others that had once.
    candidates: Vec<Vec<Face>>,
    random: u64,
}

/// The facets of a triangulation, and those at each vertex. The order of these depends on the moves that were made.
#[derive(Default)]
struct Facets {
    /// Each with its places in the stars of its vertices.
    faces: Vec<(Face, [u32; MOST_VERTICES])>,
    numbers: SpreadMap<Face, u32>,
    /// The numbers of the facets at each vertex.
    stars: SpreadMap<u32, Vec<u32>>,
}

impl Facets {
    fn insert(&mut self, facet: Face) {
        let number = self.faces.len() as u32;
        let mut places = [0; MOST_VERTICES];
        for (place, &vertex) in places.iter_mut().zip(facet.numbers()) {
            let star = self.stars.entry(vertex).or_default();
            *place = star.len() as u32;
            star.push(number);
        }
        self.faces.push((facet, places));
        self.numbers.insert(facet, number);
    }

    fn remove(&mut self, facet: &Face) {
        let number = self.numbers.remove(facet).expect("only what is there is removed");
        let (_, places) = self.faces[number as usize];
        for (&place, &vertex) in places.iter().zip(facet.numbers()) {
            let star = self.stars.get_mut(&vertex).expect("a facet is in the stars of its vertices");
            star.swap_remove(place as usize);
            if star.is_empty() {
                self.stars.remove(&vertex);
            } else if let Some(&moved) = star.get(place as usize) {
                let (face, places) = &mut self.faces[moved as usize];
                let corner = face.numbers().iter().position(|&corner| corner == vertex);
                places[corner.expect("a facet is in the stars of its vertices only")] = place;
            }
        }
        self.faces.swap_remove(number as usize);
        if let Some((moved, places)) = self.faces.get(number as usize) {
            self.numbers.insert(*moved, number);
            for (&place, vertex) in places.iter().zip(moved.numbers()) {
                self.stars.get_mut(vertex).expect("a facet is in the stars of its vertices")
                    [place as usize] = number;
            }
        }
    }

    fn len(&self) -> usize {
        self.faces.len()
    }

    fn vertex_count(&self) -> usize {
        self.stars.len()
    }

    /// The facets around a face, in no order.
    fn around(&self, face: &Face) -> impl Iterator<Item = &Face> {
        let stars = face.numbers().iter().filter_map(|vertex| self.stars.get(vertex));
        let star = stars.min_by_key(|star| star.len()).map_or(&[][..], Vec::as_slice);
        star.iter().map(|&number| &self.faces[number as usize].0).filter(|facet| face.is_face_of(facet))
    }

    /// The least number that no vertex has.
    fn unused_vertex(&self) -> u32 {
        (0..).find(|vertex| !self.stars.contains_key(vertex)).expect("there are fewer vertices than numbers")
    }
}

impl Triangulation {
    fn of_closed(complex: &SimplicialComplex) -> Result<Self, Error> {
        let (triangulation, rim) = Self::of_facets(complex)?;
        match rim.is_empty() {
            true => Ok(triangulation),
            false => Err(Error::invalid(format!(
                "{} lies in one facet only; a sphere is closed",
                rim[0].to_simplex()
            ))),
        }
    }

    /// With a cone over the ridges that lie in one facet; gives its apex.
    fn of_cone(complex: &SimplicialComplex) -> Result<(u32, Self), Error> {
        let (mut triangulation, rim) = Self::of_facets(complex)?;
        if rim.is_empty() {
            return Err(Error::invalid("the complex has no boundary; a ball has one"));
        }
        Ok((triangulation.close(&rim), triangulation))
    }

    /// Adds a cone over these ridges; gives its apex.
    fn close(&mut self, rim: &[Face]) -> u32 {
        let apex = self.facets.unused_vertex();
        let point = Face::of(&[apex]).expect("one vertex fits");
        rim.iter().for_each(|ridge| self.insert(ridge.join(&point)));
        apex
    }

    /// The facets, and the ridges in one facet only.
    fn of_facets(complex: &SimplicialComplex) -> Result<(Self, Vec<Face>), Error> {
        let dimension = complex.dimension().unwrap_or(0);
        let facets = complex.facets();
        if let Some(facet) = facets.iter().find(|facet| facet.dimension() != dimension || dimension == 0) {
            return Err(Error::invalid(format!(
                "{facet} is a facet of dimension {}; moves are for complexes whose facets have one dimension, at least 1",
                facet.dimension()
            )));
        }
        let faces = facets.iter().map(|facet| Face::of(facet.numbers()).expect("the dimension is checked"));
        Self::of_faces(dimension, faces)
    }

    /// The same for facets of this dimension.
    fn of_faces(dimension: usize, facets: impl Iterator<Item = Face>) -> Result<(Self, Vec<Face>), Error> {
        let mut triangulation = Self {
            dimension,
            degrees: SpreadMap::default(),
            facets: Facets::default(),
            candidates: vec![Vec::new(); dimension + 2],
            random: 0x9e37_79b9_7f4a_7c15,
        };
        facets.for_each(|facet| triangulation.insert(facet));
        // Sorted, so that of several crowded faces the least is named whatever the order of the hash map.
        let mut unpaired: Vec<(Face, u32)> = triangulation
            .degrees
            .iter()
            .filter(|&(face, &degree)| usize::from(face.len) == dimension && degree != 2)
            .map(|(face, &degree)| (*face, degree))
            .collect();
        unpaired.sort_unstable();
        if let Some((face, degree)) = unpaired.iter().find(|&&(_, degree)| degree > 2) {
            return Err(Error::invalid(format!("{} lies in {degree} facets", face.to_simplex())));
        }
        let rim = unpaired.into_iter().map(|(face, _)| face).collect();
        Ok((triangulation, rim))
    }

    fn insert(&mut self, facet: Face) {
        self.facets.insert(facet);
        for bits in 1..1u32 << facet.len {
            let face = facet.choose(bits);
            let degree = self.degrees.entry(face).or_insert(0);
            *degree += 1;
            // The link of a face of codimension k has k + 1 facets at least.
            if *degree as usize == self.dimension + 2 - usize::from(face.len) {
                self.candidates[usize::from(face.len)].push(face);
            }
        }
    }

    fn remove(&mut self, facet: Face) {
        self.facets.remove(&facet);
        for bits in 1..1u32 << facet.len {
            let face = facet.choose(bits);
            let degree = self.degrees.get_mut(&face).expect("a facet is there with all its faces");
            *degree -= 1;
            if *degree == 0 {
                self.degrees.remove(&face);
            } else if *degree as usize == self.dimension + 2 - usize::from(face.len) {
                self.candidates[usize::from(face.len)].push(face);
            }
        }
    }

    /// The simplex whose boundary is the link of a face, if it is one.
    fn link_simplex(&self, face: &Face) -> Option<Face> {
        let size = self.dimension + 2 - usize::from(face.len);
        if self.degrees.get(face).copied().unwrap_or(0) as usize != size {
            return None;
        }
        let mut others: Vec<u32> = Vec::with_capacity(size * size);
        for facet in self.facets.around(face) {
            others.extend(facet.numbers().iter().filter(|&&vertex| !face.contains(vertex)));
        }
        others.sort_unstable();
        others.dedup();
        (others.len() == size).then(|| Face::of(&others)).flatten()
    }

    fn may_move(&self, removed: &Face, added: &Face) -> bool {
        let is_there = match usize::from(removed.len) == self.dimension + 1 {
            // A facet gives way to a cone over its boundary.
            true => {
                return self.degrees.contains_key(removed)
                    && added.len == 1
                    && !self.degrees.contains_key(added);
            }
            false => self.link_simplex(removed).as_ref() == Some(added),
        };
        is_there && !self.degrees.contains_key(added)
    }

    fn apply(&mut self, removed: &Face, added: &Face) {
        if usize::from(removed.len) == self.dimension + 1 {
            self.remove(*removed);
        } else {
            (0..usize::from(added.len)).for_each(|i| self.remove(removed.join(&added.without(i))));
        }
        if removed.len == 1 {
            self.insert(*added);
        } else {
            (0..usize::from(removed.len)).for_each(|i| self.insert(removed.without(i).join(added)));
        }
    }

    fn is_simplex_boundary(&self) -> bool {
        [self.facets.len(), self.facets.vertex_count()] == [self.dimension + 2; 2]
    }

    /// The next of a fixed sequence of numbers that look random (SplitMix64).
    fn next_random(&mut self, below: usize) -> usize {
        self.random = self.random.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.random;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ z >> 31) % below as u64) as usize
    }

    /// A move that removes a face of so many vertices, chosen at random; at most `tries` candidates are looked at.
    fn choose(&mut self, len: usize, tries: usize) -> Option<(Face, Face)> {
        let mut looked = 0;
        let mut left = self.candidates[len].len();
        while left > 0 && looked < tries {
            let at = self.next_random(left);
            let face = self.candidates[len][at];
            let size = self.dimension + 2 - len;
            if self.degrees.get(&face).copied().unwrap_or(0) as usize != size {
                // Not a candidate any more: forget it, and keep those not looked at in front.
                left -= 1;
                self.candidates[len].swap(at, left);
                self.candidates[len].swap_remove(left);
                continue;
            }
            if len == self.dimension + 1 {
                return Some((face, Face::of(&[self.facets.unused_vertex()])?));
            }
            looked += 1;
            if let Some(added) = self.link_simplex(&face).filter(|added| !self.degrees.contains_key(added)) {
                return Some((face, added));
            }
            left -= 1;
            self.candidates[len].swap(at, left);
        }
        None
    }

    /// Moves to the boundary of a simplex; `None` if they are not found.
    fn reduce(&mut self, budget: usize) -> Option<Vec<BistellarMove>> {
        let mut moves = Vec::new();
        // A face of n vertices gives way to one of dimension + 2 - n: facets become fewer if n is the smaller.
        let most = self.dimension.div_ceil(2);
        let heating = (self.dimension + 2).div_ceil(2);
        let mut fewest = self.facets.len();
        let mut since = 0;
        loop {
            if self.is_simplex_boundary() {
                return Some(moves);
            }
            let found = (1..=most).find_map(|len| self.choose(len, usize::MAX));
            if let Some((removed, added)) = found {
                self.make(&removed, &added, &mut moves);
            } else {
                let strength = 1 + since / PATIENCE;
                let count = 1 + self.next_random(2 + strength * (1 + self.dimension));
                for _ in 0..count {
                    // Moves that keep the number of facets, or add as few as can be.
                    let (removed, added) =
                        (heating..=self.dimension + 1).find_map(|len| self.choose(len, 64))?;
                    self.make(&removed, &added, &mut moves);
                }
            }
            if self.facets.len() < fewest {
                fewest = self.facets.len();
                since = 0;
            } else {
                since += 1;
            }
            if moves.len() > budget {
                return None;
            }
        }
    }

    fn make(&mut self, removed: &Face, added: &Face, moves: &mut Vec<BistellarMove>) {
        self.apply(removed, added);
        moves.push(BistellarMove { removed: removed.to_simplex(), added: added.to_simplex() });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::known_spaces;

    #[test]
    fn of_several_crowded_faces_the_least_is_named() {
        let page = |i: u32| [10 * (i / 3), 10 * (i / 3) + 1, 10 * (i / 3) + 2 + i % 3];
        let books = SimplicialComplex::from_facets((0..24).map(page)).unwrap();
        // Hash maps are seeded anew each time.
        for _ in 0..10 {
            let error = Triangulation::of_facets(&books).map(|_| ()).unwrap_err();
            assert_eq!(error.message(), "{0, 1} lies in 3 facets");
        }
    }

    #[test]
    fn spheres_are_recognized_and_their_certificates_hold() {
        let spheres = [
            known_spaces::circle(9).unwrap(),
            known_spaces::cross_polytope_boundary(2).unwrap(),
            known_spaces::cross_polytope_boundary(3).unwrap(),
            known_spaces::cross_polytope_boundary(3).unwrap().barycentric_subdivision().unwrap().0,
            known_spaces::cross_polytope_boundary(4).unwrap(),
            known_spaces::simplex_boundary(5).unwrap(),
        ];
        for sphere in spheres {
            let certificate = recognize_sphere(&sphere, 100_000).unwrap().expect("a sphere");
            certificate.check(&sphere).unwrap();
        }
    }

    #[test]
    fn other_manifolds_are_not() {
        let poincare = known_spaces::glued_solid(known_spaces::Solid::Dodecahedron, 2).unwrap();
        assert_eq!(recognize_sphere(&poincare, 20_000).unwrap(), None);
        let space = known_spaces::real_projective_space(3).unwrap();
        assert_eq!(recognize_sphere(&space, 5_000).unwrap(), None);
    }

    #[test]
    fn balls_need_a_boundary_and_spheres_none() {
        let ball = known_spaces::simplex(3).unwrap().barycentric_subdivision().unwrap().0;
        recognize_ball(&ball, 10_000).unwrap().expect("a ball").check(&ball).unwrap();
        assert!(recognize_sphere(&ball, 10).unwrap_err().to_string().contains("a sphere is closed"));
        let sphere = known_spaces::simplex_boundary(3).unwrap();
        assert!(recognize_ball(&sphere, 10).unwrap_err().to_string().contains("has no boundary"));
    }

    #[test]
    fn a_changed_certificate_is_refused() {
        let sphere = known_spaces::cross_polytope_boundary(3).unwrap();
        let good = recognize_sphere(&sphere, 1000).unwrap().expect("a sphere");
        let mut cut = good.clone();
        cut.moves.pop();
        assert!(cut.check(&sphere).unwrap_err().to_string().contains("end before"));
        let mut swapped = good.clone();
        swapped.moves[0].added = Simplex::from([0, 1]);
        assert!(swapped.check(&sphere).unwrap_err().to_string().contains("move 0"));
        let torus = known_spaces::cyclic_torus(3).unwrap();
        assert!(good.check(&torus).is_err());
    }
}
