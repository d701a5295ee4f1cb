//! Smaller triangulations of a 3-manifold.

use crate::answer::{HomologyGroup, SimplifyAnswer};
use crate::census::Census;
use crate::facts::{orientations_open, space_of};
use crate::isomorphism::table_of;
use coface_algebra::{Error, ErrorKind};
use coface_complexes::gluing::{FaceClasses, GluingTable};
use coface_io::{Model, Structure};
use coface_topology::{GluingMove, Homology, homology, simplified, simplified_until};

/// A triangulated 3-manifold as a gluing table with fewer tetrahedra, and what is said of it.
#[derive(Clone, Debug)]
pub struct SimplifiedManifold {
    model: Model,
    answer: SimplifyAnswer,
}

impl SimplifiedManifold {
    /// The gluing table as a model.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sphere = coface_io::isosig::read(&b"bkaagj"[..])?;
    /// assert!(coface_answers::SimplifiedManifold::of("sphere.sig", &sphere, 0)?.model().structure().is_some());
    /// # Ok(()) }
    /// ```
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// What is said of it.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sphere = coface_io::isosig::read(&b"bkaagj"[..])?;
    /// let found = coface_answers::SimplifiedManifold::of("sphere.sig", &sphere, 0)?;
    /// assert_eq!(found.answer().name.as_deref(), Some("S3"));
    /// # Ok(()) }
    /// ```
    pub fn answer(&self) -> &SimplifyAnswer {
        &self.answer
    }

    /// Simplifies a gluing table, list of facets or mesh of tetrahedra by moves, with so many attempts: see [`simplified`]. The
    /// homology before and after is compared.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] for models that are no triangulations of dimension 3; [`ErrorKind::InvalidInput`] where an edge is
    /// identified with its own reverse; those of [`GluingTable::from_simplices`].
    ///
    /// # Examples
    /// The boundary of the 4-simplex.
    /// ```
    /// use coface_answers::SimplifiedManifold;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "[[0,1,2,3],[0,1,2,4],[0,1,3,4],[0,2,3,4],[1,2,3,4]]";
    /// let sphere = coface_io::read(text.as_bytes(), coface_io::Format::Json)?;
    /// let found = SimplifiedManifold::of("sphere.json", &sphere, 20)?;
    /// assert!(found.answer().f_vector[3] < 5 && found.answer().moves.len() >= 2);
    /// # Ok(()) }
    /// ```
    pub fn of(name: &str, model: &Model, attempts: usize) -> Result<Self, Error> {
        Self::found(name, model, attempts, None).map_err(|error| error.in_file(name))
    }

    /// As [`Self::of`], until a triangulation is in a census: the answer says on which line, and the model is that triangulation.
    ///
    /// # Errors
    /// As [`Self::of`].
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{Census, SimplifiedManifold};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let census = Census::from_reader("closed.sig", &b"bkaagb S3\nbkaagj S3\ncMcabbgqw RP3\n"[..])?;
    /// let text = "[[0,1,2,3],[0,1,2,4],[0,1,3,4],[0,2,3,4],[1,2,3,4]]";
    /// let sphere = coface_io::read(text.as_bytes(), coface_io::Format::Json)?;
    /// let found = SimplifiedManifold::in_census("sphere.json", &sphere, 200, &census)?;
    /// let line = found.answer().census.as_ref().and_then(|census| census.found.as_ref());
    /// assert_eq!(line.and_then(|line| line.name.as_deref()), Some("S3"));
    /// # Ok(()) }
    /// ```
    pub fn in_census(name: &str, model: &Model, attempts: usize, census: &Census) -> Result<Self, Error> {
        Self::found(name, model, attempts, Some(census)).map_err(|error| error.in_file(name))
    }

    fn found(name: &str, model: &Model, attempts: usize, census: Option<&Census>) -> Result<Self, Error> {
        let table = table_of(model)?;
        if table.dimension() != 3 {
            let message = format!(
                "moves are for triangulations of dimension 3, and this one has {}",
                table.dimension()
            );
            return Err(Error::new(ErrorKind::UnsupportedFormat, message).with_cure("give tetrahedra"));
        }
        let faces = table.faces()?;
        if let Some(edge) = faces.folded(1).next() {
            return Err(Error::invalid(format!("edge {} is identified with its own reverse", edge.index()))
                .with_cure("subdivide such simplices"));
        }
        // Ideal vertices are no points of the space: their homology is that of what is left when they are cut off.
        let groups = |table: &GluingTable, faces: &FaceClasses| -> Result<Homology, Error> {
            Ok(match table.ideal_vertices(faces)?.is_empty() {
                true => homology(&faces.chain_complex()?),
                false => homology(&table.truncated(faces)?.faces()?.chain_complex()?),
            })
        };
        let before = groups(&table, &faces)?;
        let found = match census {
            None => simplified(&table, attempts)?,
            Some(census) => simplified_until(&table, attempts, |table| {
                census.find(table).is_ok_and(|line| line.is_some())
            })?,
        };
        let moves = found.moves().iter().map(GluingMove::to_string).collect();
        let table: GluingTable = found.into_table();
        let faces_after = table.faces()?;
        let after = groups(&table, &faces_after)?;
        if after != before {
            return Err(Error::invalid("moves have changed the homology")
                .with_cure("please report this model as a fault of coface"));
        }
        let space = space_of(&table, &faces_after)?;
        let answer = SimplifyAnswer {
            file: name.to_owned(),
            f_vector_before: faces.class_counts(),
            f_vector: faces_after.class_counts(),
            moves,
            homology: HomologyGroup::list(after.groups()),
            signature: table.isomorphism_signature()?,
            name: space.as_ref().map(|space| space.name().to_string()),
            name_proof: space.as_ref().map(|space| space.proof().word().to_owned()),
            census: match census {
                Some(census) => Some(census.answer(census.find(&table)?)),
                None => None,
            },
            remarks: orientations_open(space.as_ref()).into_iter().collect(),
        };
        Ok(Self { model: Model::from_structure(Structure::Gluings(table)), answer })
    }
}

/// A triangulation as a model by its gluing table.
///
/// # Errors
/// Those of [`GluingTable::from_simplices`]; [`ErrorKind::UnsupportedFormat`] for other models, and for simplices that touch in faces below
/// their facets only, which gluings do not tell.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let ball = coface_io::read(&b"[[0,1,2,3],[1,2,3,4]]"[..], coface_io::Format::Json)?;
/// assert!(coface_answers::gluing_model(&ball)?.structure().is_some());
/// # Ok(()) }
/// ```
pub fn gluing_model(model: &Model) -> Result<Model, Error> {
    Ok(Model::from_structure(Structure::Gluings(table_of(model)?)))
}
