//! Whether the space of a gluing table is a manifold, with a certificate or a witness.

use crate::gluing::faces::FaceClasses;
use crate::gluing::table::GluingTable;
use crate::simplicial::collapse::{is_seen_as_ball, is_seen_as_sphere};
use crate::simplicial::links::homology_sizes;
use crate::simplicial::{SimplicialComplex, recognize_ball, recognize_sphere};
use crate::verdict::{Decision, LinkFindings, Verdict};
use coface_algebra::{CellId, Error};
use std::fmt;

/// Whether the space of a gluing table is a manifold, with or without boundary: yes if every vertex link is a sphere or a ball
/// and no class is folded.
pub type GluingVerdict = Verdict<GluingWitness, LinkFindings>;

/// What is wrong with a face class or its link.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum GluingFault {
    /// The class is identified with itself by another order of its vertices; points inside have no neighborhood that
    /// is a ball.
    FoldedFace,
    /// The link of the vertex class is a surface other than the sphere and the disk.
    LinkNotASphere,
    /// The link of the vertex class is no manifold.
    LinkNotAManifold,
    /// The link of the vertex class has not the homology of a sphere or ball.
    LinkHomology,
    /// The link of the vertex class has the homology of a sphere or ball, and a fundamental group that is not trivial.
    LinkNotSimplyConnected,
    /// The link of the vertex class was not seen to be a sphere or ball.
    LinkNotRecognized,
}

impl GluingFault {
    /// The word of the report.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::FoldedFace => "folded_face",
            Self::LinkNotASphere => "link_not_a_sphere",
            Self::LinkNotAManifold => "link_not_a_manifold",
            Self::LinkHomology => "link_homology",
            Self::LinkNotSimplyConnected => "link_not_simply_connected",
            Self::LinkNotRecognized => "link_not_recognized",
        }
    }
}

/// Where the space of a table is no manifold, or is not seen to be one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GluingWitness {
    fault: GluingFault,
    degree: usize,
    classes: Vec<CellId>,
    message: String,
}

impl GluingWitness {
    /// What a crate above found at a vertex class.
    #[doc(hidden)]
    pub fn at_vertex(fault: GluingFault, vertex: usize, message: String) -> Self {
        Self { fault, degree: 0, classes: vec![CellId::new(vertex)], message }
    }

    /// What is wrong.
    pub fn fault(&self) -> GluingFault {
        self.fault
    }

    /// The degree of the face classes: 0 for vertices.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// All face classes of this degree with this fault, rising. For [`GluingFault::LinkNotRecognized`] and the faults of
    /// links of dimension 3 and more, the first alone.
    pub fn classes(&self) -> &[CellId] {
        &self.classes
    }

    /// One sentence for people, about the first of the classes.
    pub fn message(&self) -> &str {
        &self.message
    }
}

impl fmt::Display for GluingWitness {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

/// A connected surface, as a link.
struct LinkSurface {
    euler_characteristic: i64,
    is_orientable: bool,
    boundary_count: usize,
}

impl LinkSurface {
    fn of(table: &GluingTable) -> Result<Self, Error> {
        let boundary_count =
            if table.is_closed() { 0 } else { table.boundary_table()?.0.components().count() };
        Ok(Self {
            euler_characteristic: table.faces()?.alternating_count(),
            is_orientable: table.orientation().odd_cycle().is_none(),
            boundary_count,
        })
    }
}

impl fmt::Display for LinkSurface {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let crosscaps = 2 - self.euler_characteristic - self.boundary_count as i64;
        match (self.is_orientable, crosscaps) {
            (true, 0) => f.write_str("a sphere")?,
            (true, 2) => f.write_str("a torus")?,
            (true, _) => write!(f, "an orientable surface of genus {}", crosscaps / 2)?,
            (false, 1) => f.write_str("a projective plane")?,
            (false, 2) => f.write_str("a Klein bottle")?,
            (false, _) => write!(f, "a surface of {crosscaps} cross-caps")?,
        }
        match self.boundary_count {
            0 => Ok(()),
            1 => f.write_str(" with a hole"),
            count => write!(f, " with {count} holes"),
        }
    }
}

impl GluingTable {
    /// Whether the space of this table is a manifold, with or without boundary. `faces` are the face classes of the
    /// table.
    ///
    /// Exact up to dimension 3: there the vertex links are points, circles, paths and connected surfaces, and the Euler
    /// characteristic tells spheres and disks. A vertex whose link is another surface is **ideal**: without it the space
    /// may be a manifold, and the witness names the link. From dimension 4 on a link must be a manifold with the homology
    /// of a sphere or ball, and is one if its triangulation collapses, after a facet is taken out of a sphere, or bistellar
    /// moves lead from it to the boundary of a simplex; otherwise the verdict is unknown.
    ///
    /// A folded class makes it no manifold: some element of prime order p acts freely on a sphere of dimension 2 or more
    /// around a point inside, so the first homology of the link of that point has p-torsion.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::Shape`] for the face classes of another table; [`coface_algebra::ErrorKind::TooLarge`] as
    /// [`FaceClasses::barycentric_subdivision`] for links from dimension 4 on.
    ///
    /// # Complexity
    /// Linear up to dimension 3; above, also in the size of the second barycentric subdivisions of the links.
    ///
    /// # References
    /// W. P. Thurston, *Three-dimensional geometry and topology* (1997), section 3.2; J. H. C. Whitehead, *Simplicial
    /// spaces, nuclei and m-groups* (1939).
    ///
    /// # Examples
    /// A tetrahedron with two facets glued so that an edge is folded:
    /// ```
    /// use coface_complexes::gluing::{GluingFault, GluingTable};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut table = GluingTable::unglued(3, 1)?;
    /// assert_eq!(table.manifold_verdict(&table.faces()?)?.as_str(), "yes");
    /// table.glue(0, 3, 0, &[1, 0, 3, 2])?;
    /// let verdict = table.manifold_verdict(&table.faces()?)?;
    /// let witness = verdict.witness().expect("no has a witness");
    /// assert_eq!((verdict.as_str(), witness.fault()), ("no", GluingFault::FoldedFace));
    /// # Ok(()) }
    /// ```
    pub fn manifold_verdict(&self, faces: &FaceClasses) -> Result<GluingVerdict, Error> {
        self.check_faces(faces)?;
        let boundary_facet_count = self.boundary_facets().count();
        let mut findings = LinkFindings { boundary_facet_count, collapsed_link_count: 0 };
        let decision = self.decide(faces, &mut findings)?;
        Ok(Verdict { decision, is_closed: boundary_facet_count == 0, findings })
    }

    fn decide(
        &self,
        faces: &FaceClasses,
        findings: &mut LinkFindings,
    ) -> Result<Decision<GluingWitness>, Error> {
        if self.dimension() <= 2 {
            // Vertex links are connected curves.
            return Ok(Decision::Yes);
        }
        if let Some(degree) = (1..self.dimension()).find(|&degree| faces.folded(degree).next().is_some()) {
            return Ok(Decision::No(folded(faces, degree)));
        }
        if self.dimension() == 3 {
            // A connected surface is a sphere or a disk when its Euler characteristic is that of one.
            let right = |vertex: usize| if faces.is_boundary(0, CellId::new(vertex)) { 1 } else { 2 };
            let found = link_euler_characteristics(faces);
            let ideal: Vec<usize> =
                (0..found.len()).filter(|&vertex| found[vertex] != right(vertex)).collect();
            let Some(&first) = ideal.first() else { return Ok(Decision::Yes) };
            let link = LinkSurface::of(self.vertex_links(faces)?[first].table())?;
            return Ok(Decision::No(GluingWitness {
                fault: GluingFault::LinkNotASphere,
                degree: 0,
                message: format!(
                    "the link of vertex {first} is {link}, neither a sphere nor a disk: the vertex is ideal"
                ),
                classes: ideal.into_iter().map(CellId::new).collect(),
            }));
        }
        let links = self.vertex_links(faces)?;
        let mut unknown = None;
        for (vertex, link) in links.iter().enumerate() {
            match recognize(link.table())? {
                None => findings.collapsed_link_count += 1,
                Some((fault, message)) => {
                    let witness = GluingWitness {
                        fault,
                        degree: 0,
                        classes: vec![CellId::new(vertex)],
                        message: format!("the link of vertex {vertex} {message}"),
                    };
                    if fault != GluingFault::LinkNotRecognized {
                        return Ok(Decision::No(witness));
                    }
                    unknown.get_or_insert(witness);
                }
            }
        }
        Ok(unknown.map_or(Decision::Yes, Decision::Unknown))
    }
}

/// The Euler characteristic of the link of each vertex class, if no class is folded: a k-class with a corner at the vertex
/// is a (k-1)-simplex of the link.
pub(super) fn link_euler_characteristics(faces: &FaceClasses) -> Vec<i64> {
    let counts = faces.class_counts();
    let mut found = vec![0; counts.first().copied().unwrap_or(0)];
    for (degree, &count) in counts.iter().enumerate().skip(1) {
        let sign = if degree % 2 == 1 { 1 } else { -1 };
        for class in (0..count).map(CellId::new) {
            for vertex in faces.vertices(degree, class) {
                found[vertex as usize] += sign;
            }
        }
    }
    found
}

fn folded(faces: &FaceClasses, degree: usize) -> GluingWitness {
    let classes: Vec<CellId> = faces.folded(degree).collect();
    let (simplex, vertices) = faces.representative(degree, classes[0]);
    let message = if degree == 1 {
        format!(
            "edge {}, from vertex {} to vertex {} of simplex {simplex}, is identified with its own reverse",
            classes[0].index(),
            vertices[0],
            vertices[1]
        )
    } else {
        format!(
            "face {} of degree {degree}, with the vertices {vertices:?} of simplex {simplex}, is identified with itself \
             by another order of its vertices",
            classes[0].index()
        )
    };
    GluingWitness { fault: GluingFault::FoldedFace, degree, classes, message }
}

/// `None` if a link of dimension 3 or more is seen to be a sphere or ball, else what is known against it.
fn recognize(link: &GluingTable) -> Result<Option<(GluingFault, String)>, Error> {
    let faces = link.faces()?;
    let dimension = link.dimension();
    let verdict = link.manifold_verdict(&faces)?;
    if let Decision::No(witness) = &verdict.decision {
        return Ok(Some((GluingFault::LinkNotAManifold, format!("is no manifold: in it, {witness}"))));
    }
    let chains = faces.chain_complex()?;
    let is_right = |(k, (betti, torsion)): (usize, (usize, usize))| {
        torsion == 0 && betti == usize::from(k == 0) + usize::from(link.is_closed() && k == dimension)
    };
    let homology = homology_sizes(&chains);
    if !homology.iter().copied().enumerate().all(is_right) {
        let betti: Vec<String> = homology.iter().map(|(betti, _)| betti.to_string()).collect();
        let torsion = if homology.iter().any(|&(_, torsion)| torsion > 0) { ", with torsion" } else { "" };
        return Ok(Some((
            GluingFault::LinkHomology,
            format!(
                "has the Betti numbers {}{torsion}, not those of a sphere or ball of dimension {dimension}",
                betti.join(" ")
            ),
        )));
    }
    let open =
        format!("has the homology of a sphere or ball of dimension {dimension}, but was not seen to be one");
    if verdict.to_bool() != Some(true) {
        return Ok(Some((GluingFault::LinkNotRecognized, open)));
    }
    let triangulation = faces.barycentric_subdivision()?.triangulation()?.0;
    let chains = triangulation.chain_complex()?;
    let collapses = if link.is_closed() { is_seen_as_sphere(&chains) } else { is_seen_as_ball(&chains) };
    // Moves want few facets.
    let coarse = || faces.to_delta().and_then(|delta| delta.to_simplicial_complex().ok());
    let is_seen = collapses || is_moved_to_simplex(&coarse().unwrap_or(triangulation), link.is_closed())?;
    Ok((!is_seen).then_some((GluingFault::LinkNotRecognized, open)))
}

/// So many moves are tried on a link for each of its simplices, and more.
const MOVES_EACH: usize = 20;
const MOVES: usize = 10_000;

/// Whether bistellar moves lead from a manifold, or from one with a cone over its boundary, to the boundary of a simplex.
fn is_moved_to_simplex(complex: &SimplicialComplex, is_closed: bool) -> Result<bool, Error> {
    let budget = MOVES + MOVES_EACH * complex.f_vector().last().copied().unwrap_or(0);
    let certificate =
        if is_closed { recognize_sphere(complex, budget)? } else { recognize_ball(complex, budget)? };
    Ok(certificate.is_some())
}
