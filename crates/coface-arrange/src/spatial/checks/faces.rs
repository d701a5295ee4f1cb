//! The faces that are checked.

use super::CheckedPrimitive;
use coface_algebra::{Error, ErrorKind, RaggedArray};

/// Faces with holes, in shells or not, by the vertices of their rings. Nothing is asked of the rings: what is wrong
/// with them is what the check says.
///
/// # Examples
/// A square with a triangular hole:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_arrange::spatial::checks::CheckedFaces;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let rings = RaggedArray::from_lists([&[0, 1, 2, 3][..], &[4, 5, 6]]);
/// let faces = CheckedFaces::from_rings(rings, &[0, 0])?;
/// assert_eq!((faces.face_count(), faces.rings_of_face(0)), (1, 0..2));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CheckedFaces {
    rings: RaggedArray,
    /// The first ring of each face, and the number of rings; `None` where each face has one ring.
    starts: Option<Vec<u32>>,
    shell_of_face: Option<Vec<u32>>,
    solid_of_shell: Vec<u32>,
    /// What each solid is stated to be; solids where that is not said.
    primitives: Vec<CheckedPrimitive>,
}

impl CheckedFaces {
    /// A face for each polygon.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::checks::CheckedFaces;
    /// assert_eq!(CheckedFaces::from_polygons(RaggedArray::from_lists([[0, 1, 2]])).face_count(), 1);
    /// ```
    pub fn from_polygons(polygons: RaggedArray) -> Self {
        Self {
            rings: polygons,
            starts: None,
            shell_of_face: None,
            solid_of_shell: Vec::new(),
            primitives: Vec::new(),
        }
    }

    /// The faces with these rings; `face_of_ring` rises from 0 by at most 1, and the first ring of a face is its outer
    /// ring.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless there is a face for each ring and the numbers rise so.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::checks::CheckedFaces;
    /// let rings = RaggedArray::from_lists([[0, 1, 2], [3, 4, 5]]);
    /// assert!(CheckedFaces::from_rings(rings.clone(), &[0, 1]).is_ok());
    /// assert!(CheckedFaces::from_rings(rings, &[0, 2]).is_err());
    /// ```
    pub fn from_rings(rings: RaggedArray, face_of_ring: &[u32]) -> Result<Self, Error> {
        let steps = face_of_ring.windows(2).all(|pair| pair[1] == pair[0] || pair[1] == pair[0] + 1);
        if face_of_ring.len() != rings.len() || face_of_ring.first().is_some_and(|&face| face != 0) || !steps
        {
            return Err(Error::new(ErrorKind::Shape, "the faces of rings do not rise from 0 by at most 1")
                .with_cure("list the rings of each face together, the outer ring first"));
        }
        let changes = (1..face_of_ring.len()).filter(|&ring| face_of_ring[ring] != face_of_ring[ring - 1]);
        let mut starts: Vec<u32> = vec![0];
        starts.extend(changes.map(|ring| ring as u32));
        if !face_of_ring.is_empty() {
            starts.push(face_of_ring.len() as u32);
        }
        Ok(Self {
            rings,
            starts: Some(starts),
            shell_of_face: None,
            solid_of_shell: Vec::new(),
            primitives: Vec::new(),
        })
    }

    /// The same faces with the shell of each, and the solid of each shell. The first shell of a solid is its outer
    /// shell, the others are the shells of its voids.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless there is a shell for each face and a solid for each shell.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::checks::CheckedFaces;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let faces = CheckedFaces::from_polygons(RaggedArray::from_lists([[0, 1, 2], [3, 4, 5]]));
    /// let faces = faces.with_shells(vec![0, 1], vec![0, 0])?;
    /// assert_eq!(faces.shell_of_face(), Some(&[0, 1][..]));
    /// # Ok(()) }
    /// ```
    pub fn with_shells(mut self, shell_of_face: Vec<u32>, solid_of_shell: Vec<u32>) -> Result<Self, Error> {
        let is_shell = |&shell: &u32| (shell as usize) < solid_of_shell.len();
        if shell_of_face.len() != self.face_count() || !shell_of_face.iter().all(is_shell) {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{} shells are named for {} faces", shell_of_face.len(), self.face_count()),
            )
            .with_cure("name the shell of each face and the solid of each shell"));
        }
        self.shell_of_face = Some(shell_of_face);
        self.solid_of_shell = solid_of_shell;
        Ok(self)
    }

    /// The same faces with what each solid is stated to be, which says which codes are looked for: by their numbers in
    /// [`Self::with_shells`], which comes first.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless there is one for each solid.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::checks::{CheckedFaces, CheckedPrimitive};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let faces = CheckedFaces::from_polygons(RaggedArray::from_lists([[0, 1, 2], [3, 4, 5]]));
    /// let faces = faces.with_shells(vec![0, 1], vec![0, 1])?;
    /// assert!(faces.clone().with_primitives(vec![CheckedPrimitive::Solid]).is_err());
    /// assert!(faces.with_primitives(vec![CheckedPrimitive::MultiSurface, CheckedPrimitive::Solid]).is_ok());
    /// # Ok(()) }
    /// ```
    pub fn with_primitives(mut self, primitives: Vec<CheckedPrimitive>) -> Result<Self, Error> {
        let count = self.solid_of_shell.iter().max().map_or(0, |&last| last as usize + 1);
        if primitives.len() != count {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{} primitives are named for {count} solids", primitives.len()),
            )
            .with_cure("say of each solid what it is"));
        }
        self.primitives = primitives;
        Ok(self)
    }

    /// What a solid that is given is stated to be.
    pub(super) fn primitive(&self, solid: u32) -> CheckedPrimitive {
        self.primitives.get(solid as usize).copied().unwrap_or_default()
    }

    /// What the solid of a shell is stated to be.
    pub(super) fn primitive_of_shell(&self, shell: usize) -> CheckedPrimitive {
        self.solid_of_shell.get(shell).map_or(CheckedPrimitive::Solid, |&solid| self.primitive(solid))
    }

    /// The number of faces.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::checks::CheckedFaces;
    /// assert_eq!(CheckedFaces::from_polygons(RaggedArray::new()).face_count(), 0);
    /// ```
    pub fn face_count(&self) -> usize {
        self.starts.as_ref().map_or(self.rings.len(), |starts| starts.len() - 1)
    }

    /// The rings as lists of vertices.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::checks::CheckedFaces;
    /// let faces = CheckedFaces::from_polygons(RaggedArray::from_lists([[0, 1, 2]]));
    /// assert_eq!(faces.rings().list(0), [0, 1, 2]);
    /// ```
    pub fn rings(&self) -> &RaggedArray {
        &self.rings
    }

    /// The numbers of the rings of a face.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::checks::CheckedFaces;
    /// let faces = CheckedFaces::from_polygons(RaggedArray::from_lists([[0, 1, 2]]));
    /// assert_eq!(faces.rings_of_face(0), 0..1);
    /// ```
    pub fn rings_of_face(&self, face: usize) -> std::ops::Range<usize> {
        match &self.starts {
            None => face..face + 1,
            Some(starts) => starts[face] as usize..starts[face + 1] as usize,
        }
    }

    /// The shell of each face, if shells are given.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::checks::CheckedFaces;
    /// assert_eq!(CheckedFaces::from_polygons(RaggedArray::new()).shell_of_face(), None);
    /// ```
    pub fn shell_of_face(&self) -> Option<&[u32]> {
        self.shell_of_face.as_deref()
    }

    /// The solid of each shell, if shells are given.
    pub(super) fn solid_of_shell(&self) -> &[u32] {
        &self.solid_of_shell
    }
}
