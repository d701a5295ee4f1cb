//! What a check finds.

use super::{FaultCode, FaultScope};

/// Where a fault is.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct FaultPlace {
    /// The faces that have the fault, or meet there.
    pub faces: Vec<u32>,
    /// The vertices that show it: the ends of an edge, the vertex with several fans, the point that is off the plane.
    pub vertices: Vec<u32>,
    /// The shells that have the fault; only for codes from 301 on that are about whole shells.
    pub shells: Vec<u32>,
    /// A point of the place, rounded.
    pub point: Option<[f64; 3]>,
    /// How far the farthest point is from the plane of the face, rounded, for faces that are not flat.
    pub distance: Option<f64>,
}

/// One code with its count and its first places.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Fault {
    pub(super) code: FaultCode,
    pub(super) scope: FaultScope,
    pub(super) count: usize,
    pub(super) is_complete: bool,
    pub(super) places: Vec<FaultPlace>,
}

impl Fault {
    /// What is wrong.
    ///
    /// # Examples
    /// ```
    /// # use coface_algebra::RaggedArray;
    /// # use coface_arrange::spatial::checks::{CheckedFaces, FaultCode, GeometryChecks};
    /// # use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// # let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0.])?;
    /// # let faces = CheckedFaces::from_polygons(RaggedArray::from_lists([[0, 1, 2]]));
    /// let found = GeometryChecks::new().check(&corners, &faces)?;
    /// assert_eq!(found.faults()[0].code(), FaultCode::TooFewFaces);
    /// # Ok(()) }
    /// ```
    pub fn code(&self) -> FaultCode {
        self.code
    }

    /// What the fault refutes.
    ///
    /// # Examples
    /// ```
    /// # use coface_algebra::RaggedArray;
    /// # use coface_arrange::spatial::checks::{CheckedFaces, FaultScope, GeometryChecks};
    /// # use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// # let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0.])?;
    /// # let faces = CheckedFaces::from_polygons(RaggedArray::from_lists([[0, 1, 2]]));
    /// // A triangle is a sound surface that bounds no solid.
    /// let found = GeometryChecks::new().check(&corners, &faces)?;
    /// assert_eq!(found.faults()[0].scope(), FaultScope::Solid);
    /// # Ok(()) }
    /// ```
    pub fn scope(&self) -> FaultScope {
        self.scope
    }

    /// In how many places it is.
    ///
    /// # Examples
    /// ```
    /// # use coface_algebra::RaggedArray;
    /// # use coface_arrange::spatial::checks::{CheckedFaces, GeometryChecks};
    /// # use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// # let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0.])?;
    /// # let faces = CheckedFaces::from_polygons(RaggedArray::from_lists([[0, 1, 2]]));
    /// let found = GeometryChecks::new().check(&corners, &faces)?;
    /// assert_eq!(found.faults()[0].count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn count(&self) -> usize {
        self.count
    }

    /// Whether all places are counted; a check ends early when there are millions.
    ///
    /// # Examples
    /// ```
    /// # use coface_algebra::RaggedArray;
    /// # use coface_arrange::spatial::checks::{CheckedFaces, GeometryChecks};
    /// # use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// # let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0.])?;
    /// # let faces = CheckedFaces::from_polygons(RaggedArray::from_lists([[0, 1, 2]]));
    /// let found = GeometryChecks::new().check(&corners, &faces)?;
    /// assert!(found.faults()[0].is_complete());
    /// # Ok(()) }
    /// ```
    pub fn is_complete(&self) -> bool {
        self.is_complete
    }

    /// The first places.
    ///
    /// # Examples
    /// ```
    /// # use coface_algebra::RaggedArray;
    /// # use coface_arrange::spatial::checks::{CheckedFaces, GeometryChecks};
    /// # use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// # let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0.])?;
    /// # let faces = CheckedFaces::from_polygons(RaggedArray::from_lists([[0, 1, 2]]));
    /// let found = GeometryChecks::new().check(&corners, &faces)?;
    /// assert_eq!(found.faults()[0].places()[0].faces, [0]);
    /// # Ok(()) }
    /// ```
    pub fn places(&self) -> &[FaultPlace] {
        &self.places
    }

    /// One sentence: how many places have it and what it means.
    ///
    /// # Examples
    /// ```
    /// # use coface_algebra::RaggedArray;
    /// # use coface_arrange::spatial::checks::{CheckedFaces, GeometryChecks};
    /// # use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// # let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0.])?;
    /// # let faces = CheckedFaces::from_polygons(RaggedArray::from_lists([[0, 1, 2]]));
    /// let found = GeometryChecks::new().check(&corners, &faces)?;
    /// assert_eq!(found.faults()[0].sentence(), "1 shell has too few faces to bound a solid");
    /// # Ok(()) }
    /// ```
    pub fn sentence(&self) -> String {
        let mut sentence = self.code.sentence(self.count);
        if !self.is_complete {
            sentence.insert_str(0, "more than ");
        }
        let farthest = self.places.iter().filter_map(|place| place.distance).fold(0.0, f64::max);
        if self.code == FaultCode::NotFlat {
            sentence += &format!(": points are up to {farthest:.3e} off the plane");
        }
        sentence
    }
}

/// All that a check finds, by rising code.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct GeometryFaults {
    pub(super) faults: Vec<Fault>,
    pub(super) faces_left_out: usize,
    pub(super) shells_left_out: usize,
    pub(super) shell_count: usize,
}

impl GeometryFaults {
    /// The faults, by rising code; one code of each scope is there once.
    ///
    /// # Examples
    /// ```
    /// # use coface_algebra::RaggedArray;
    /// # use coface_arrange::spatial::checks::{CheckedFaces, GeometryChecks};
    /// # use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A tetrahedron has no fault.
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let found = GeometryChecks::new().check(&corners, &CheckedFaces::from_polygons(sides))?;
    /// assert!(found.faults().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn faults(&self) -> &[Fault] {
        &self.faults
    }

    /// Whether the faces are a sound surface: no fault has the scope [`FaultScope::Surface`], and all was examined.
    ///
    /// # Examples
    /// ```
    /// # use coface_algebra::RaggedArray;
    /// # use coface_arrange::spatial::checks::{CheckedFaces, GeometryChecks};
    /// # use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0.])?;
    /// let triangle = CheckedFaces::from_polygons(RaggedArray::from_lists([[0, 1, 2]]));
    /// let found = GeometryChecks::new().check(&corners, &triangle)?;
    /// assert!(found.is_sound_surface() && !found.is_valid_solid());
    /// # Ok(()) }
    /// ```
    pub fn is_sound_surface(&self) -> bool {
        self.has_all() && !self.faults.iter().any(|fault| fault.scope == FaultScope::Surface)
    }

    /// Whether the faces bound one valid solid, or each solid that is given is valid: no fault at all, and all was
    /// examined.
    ///
    /// # Examples
    /// ```
    /// # use coface_algebra::RaggedArray;
    /// # use coface_arrange::spatial::checks::{CheckedFaces, GeometryChecks};
    /// # use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let found = GeometryChecks::new().check(&corners, &CheckedFaces::from_polygons(sides))?;
    /// assert!(found.is_valid_solid());
    /// # Ok(()) }
    /// ```
    pub fn is_valid_solid(&self) -> bool {
        self.has_all() && self.shell_count > 0 && self.faults.is_empty()
    }

    fn has_all(&self) -> bool {
        self.shells_left_out == 0
    }

    /// The faces that have no area or whose rings cross: where they meet other faces was not examined.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::checks::GeometryFaults;
    /// assert_eq!(GeometryFaults::default().faces_left_out(), 0);
    /// ```
    pub fn faces_left_out(&self) -> usize {
        self.faces_left_out
    }

    /// The shells of which it was not examined how they lie to others that they touch, because too many touch.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::checks::GeometryFaults;
    /// assert_eq!(GeometryFaults::default().shells_left_out(), 0);
    /// ```
    pub fn shells_left_out(&self) -> usize {
        self.shells_left_out
    }
}

impl GeometryFaults {
    /// The same with other numbers for faces and vertices, such as those of a file.
    ///
    /// # Examples
    /// ```
    /// # use coface_algebra::RaggedArray;
    /// # use coface_arrange::spatial::checks::{CheckedFaces, GeometryChecks};
    /// # use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// # let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0.])?;
    /// let triangle = CheckedFaces::from_polygons(RaggedArray::from_lists([[0, 1, 2]]));
    /// let found = GeometryChecks::new().check(&corners, &triangle)?.renumbered(|face| face + 7, |vertex| vertex);
    /// assert_eq!(found.faults()[0].places()[0].faces, [7]);
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn renumbered(mut self, face: impl Fn(u32) -> u32, vertex: impl Fn(u32) -> u32) -> Self {
        for place in self.faults.iter_mut().flat_map(|fault| &mut fault.places) {
            place.faces.iter_mut().for_each(|own| *own = face(*own));
            place.vertices.iter_mut().for_each(|own| *own = vertex(*own));
        }
        self
    }

    /// The same with a fault that was found elsewhere, as by the reader of a file, in so many places, of which some are
    /// listed.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::checks::{FaultCode, FaultScope, GeometryFaults};
    /// let found = GeometryFaults::default();
    /// let found = found.with_fault(FaultCode::RepeatedPoints, FaultScope::Surface, 3, Vec::new());
    /// assert_eq!(found.faults()[0].count(), 3);
    /// ```
    #[must_use]
    pub fn with_fault(
        mut self,
        code: FaultCode,
        scope: FaultScope,
        count: usize,
        mut places: Vec<FaultPlace>,
    ) -> Self {
        match self.faults.iter_mut().find(|fault| (fault.code, fault.scope) == (code, scope)) {
            Some(fault) => {
                fault.count += count;
                fault.places.append(&mut places);
            }
            None => self.faults.push(Fault { code, scope, count, is_complete: true, places }),
        }
        self.faults.sort_by_key(|fault| (fault.code, fault.scope));
        self
    }
}

/// Faults as they are found.
#[derive(Debug)]
pub(super) struct Collector {
    found: Vec<Fault>,
    most: usize,
}

impl Collector {
    pub(super) fn new(most: usize) -> Self {
        Self { found: Vec::new(), most }
    }

    /// Adds a place.
    pub(super) fn add(&mut self, code: FaultCode, scope: FaultScope, place: FaultPlace) {
        self.add_with(code, scope, || place);
    }

    /// Adds a place, which is made only where it is listed.
    pub(super) fn add_with(
        &mut self,
        code: FaultCode,
        scope: FaultScope,
        place: impl FnOnce() -> FaultPlace,
    ) {
        let at = self.found.iter().position(|fault| (fault.code, fault.scope) == (code, scope));
        let at = at.unwrap_or_else(|| {
            self.found.push(Fault { code, scope, count: 0, is_complete: true, places: Vec::new() });
            self.found.len() - 1
        });
        let fault = &mut self.found[at];
        fault.count += 1;
        if fault.places.len() < self.most {
            fault.places.push(place());
        }
    }

    /// Says that not all places of a code were counted.
    pub(super) fn mark_incomplete(&mut self, codes: &[FaultCode]) {
        self.found
            .iter_mut()
            .filter(|fault| codes.contains(&fault.code))
            .for_each(|fault| fault.is_complete = false);
    }

    /// The faults by rising code.
    pub(super) fn into_faults(mut self) -> Vec<Fault> {
        self.found.sort_by_key(|fault| (fault.code, fault.scope));
        self.found
    }
}
