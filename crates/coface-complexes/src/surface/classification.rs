//! Classification of compact surfaces: which one is each component.

use super::dual_graph::contradictions;
use super::{BoundaryLoop, PolygonMesh, SurfaceOrientation, SurfaceVerdict};
use crate::components::Components;
use coface_algebra::progress::{Steps, stage};
use coface_algebra::{EdgeId, VertexId};
use std::fmt;

/// A compact connected surface up to homeomorphism.
///
/// The Euler characteristic is $2 - 2g - b$ for genus g and $2 - k - b$ for k crosscaps, with b boundary loops.
///
/// # References
/// W. S. Massey, *A Basic Course in Algebraic Topology* (1991), chapter I.
///
/// # Examples
/// ```
/// use coface_complexes::surface::SurfaceType;
/// let torus = SurfaceType::orientable(1, 0);
/// assert_eq!((torus.to_string().as_str(), torus.euler_characteristic()), ("torus", 0));
/// assert_eq!(SurfaceType::non_orientable(1, 1).to_string(), "Moebius band");
/// assert_eq!(SurfaceType::orientable(3, 106).to_string(), "genus-3 surface with 106 boundary components");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SurfaceType {
    is_orientable: bool,
    genus: usize,
    boundary_count: usize,
}

impl SurfaceType {
    /// The sphere with `genus` handles and `boundary_count` holes.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::SurfaceType;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = SurfaceType::orientable(1, 0);
    /// assert_eq!(torus.euler_characteristic(), 0);
    /// # Ok(()) }
    /// ```
    pub const fn orientable(genus: usize, boundary_count: usize) -> Self {
        Self { is_orientable: true, genus, boundary_count }
    }

    /// The sphere with `crosscaps` crosscaps, at least one, and `boundary_count` holes.
    ///
    /// # Panics
    /// If there is no crosscap.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::SurfaceType;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = SurfaceType::orientable(1, 0);
    /// assert_eq!(SurfaceType::non_orientable(1, 0).euler_characteristic(), 1);
    /// # Ok(()) }
    /// ```
    pub const fn non_orientable(crosscaps: usize, boundary_count: usize) -> Self {
        assert!(crosscaps > 0, "a surface without crosscaps is orientable");
        Self { is_orientable: false, genus: crosscaps, boundary_count }
    }

    /// Whether it is orientable.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::SurfaceType;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = SurfaceType::orientable(1, 0);
    /// assert!(torus.is_orientable());
    /// # Ok(()) }
    /// ```
    pub const fn is_orientable(self) -> bool {
        self.is_orientable
    }

    /// The number of handles of an orientable surface, of crosscaps of a non-orientable one.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::SurfaceType;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = SurfaceType::orientable(1, 0);
    /// assert_eq!(torus.genus(), 1);
    /// # Ok(()) }
    /// ```
    pub const fn genus(self) -> usize {
        self.genus
    }

    /// The number of boundary loops.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::SurfaceType;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = SurfaceType::orientable(1, 0);
    /// assert_eq!(torus.boundary_count(), 0);
    /// # Ok(()) }
    /// ```
    pub const fn boundary_count(self) -> usize {
        self.boundary_count
    }

    /// The Euler characteristic.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::SurfaceType;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = SurfaceType::orientable(1, 0);
    /// assert_eq!(torus.euler_characteristic(), 0);
    /// # Ok(()) }
    /// ```
    pub const fn euler_characteristic(self) -> i64 {
        let handles = if self.is_orientable { 2 * self.genus } else { self.genus };
        2 - handles as i64 - self.boundary_count as i64
    }
}

impl fmt::Display for SurfaceType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let closed = match (self.is_orientable, self.genus, self.boundary_count) {
            (true, 0, 1) => return f.write_str("disk"),
            (true, 0, 2) => return f.write_str("annulus"),
            (true, 0, 3) => return f.write_str("pair of pants"),
            (false, 1, 1) => return f.write_str("Moebius band"),
            (true, 0, _) => "sphere".to_owned(),
            (true, 1, _) => "torus".to_owned(),
            (true, 2, _) => "double torus".to_owned(),
            (true, genus, _) => format!("genus-{genus} surface"),
            (false, 1, _) => "projective plane".to_owned(),
            (false, 2, _) => "Klein bottle".to_owned(),
            (false, genus, _) => format!("non-orientable surface with {genus} crosscaps"),
        };
        f.write_str(&closed)?;
        match (self.boundary_count, self.is_orientable || self.genus < 3) {
            (0, _) => Ok(()),
            (1, true) => f.write_str(" with 1 boundary component"),
            (b, true) => write!(f, " with {b} boundary components"),
            (1, false) => f.write_str(" and 1 boundary component"),
            (b, false) => write!(f, " and {b} boundary components"),
        }
    }
}

/// One connected component of a mesh.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SurfaceComponent {
    f_vector: [usize; 3],
    boundary_count: usize,
    surface: Option<SurfaceType>,
}

impl SurfaceComponent {
    /// A component that is a surface with these counts.
    pub(super) fn of_surface(f_vector: [usize; 3], boundary_count: usize, is_orientable: bool) -> Self {
        let mut component = Self { f_vector, boundary_count, surface: None };
        let handles = 2 - component.euler_characteristic() - boundary_count as i64;
        let handles =
            usize::try_from(handles).expect("a connected surface has Euler characteristic at most 2 - b");
        component.surface = Some(if is_orientable {
            SurfaceType::orientable(handles / 2, boundary_count)
        } else {
            SurfaceType::non_orientable(handles, boundary_count)
        });
        component
    }

    /// Components in words: "torus", "5 spheres", "2 disks and 1 torus"; `None` without components, and if one of them is
    /// neither a surface nor a point.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh, SurfaceComponent};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Three loops, each between two monogons.
    /// let mesh = HalfedgeMesh::from_next((0..6).collect())?;
    /// let components = GeneralizedMap::new(mesh.two_skeleton()?)?.surface_components();
    /// assert_eq!(SurfaceComponent::names(&components).as_deref(), Some("3 spheres"));
    /// # Ok(()) }
    /// ```
    pub fn names(components: &[Self]) -> Option<String> {
        if let [only] = components {
            return Some(only.surface?.to_string());
        }
        let points = components.iter().filter(|part| part.f_vector == [1, 0, 0]).count();
        let mut types: Vec<SurfaceType> = components.iter().filter_map(|part| part.surface).collect();
        if types.is_empty() || types.len() + points < components.len() {
            return None;
        }
        types.sort_unstable_by_key(|surface| (!surface.is_orientable, surface.genus, surface.boundary_count));
        let mut words: Vec<String> =
            types.chunk_by(|a, b| a == b).map(|equal| counted(equal.len(), &equal[0].to_string())).collect();
        if points > 0 {
            words.push(counted(points, "isolated vertex"));
        }
        let last = words.pop()?;
        Some(if words.is_empty() { last } else { format!("{} and {last}", words.join(", ")) })
    }

    /// The numbers of its vertices, edges and faces.
    pub fn f_vector(&self) -> [usize; 3] {
        self.f_vector
    }

    /// Vertices minus edges plus faces.
    pub fn euler_characteristic(&self) -> i64 {
        let [v, e, f] = self.f_vector;
        v as i64 - e as i64 + f as i64
    }

    /// The number of components of its boundary graph.
    pub fn boundary_count(&self) -> usize {
        self.boundary_count
    }

    /// Which surface it is; `None` for an isolated vertex and where the component is no surface.
    pub fn surface(&self) -> Option<SurfaceType> {
        self.surface
    }
}

/// Everything that the surface tests say about a mesh.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SurfaceSurvey {
    components: Components,
    verdict: SurfaceVerdict,
    orientation: SurfaceOrientation,
    boundary_loops: Vec<BoundaryLoop>,
    parts: Vec<SurfaceComponent>,
}

impl SurfaceSurvey {
    /// The connected components.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let survey = PolygonMesh::new(3, RaggedArray::from_lists([[0, 1, 2]]), &[])?.survey();
    /// assert_eq!(survey.components().count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn components(&self) -> &Components {
        &self.components
    }

    /// The manifold test.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let survey = PolygonMesh::new(3, RaggedArray::from_lists([[0, 1, 2]]), &[])?.survey();
    /// assert!(survey.verdict().is_manifold());
    /// # Ok(()) }
    /// ```
    pub fn verdict(&self) -> &SurfaceVerdict {
        &self.verdict
    }

    /// The orientation.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let survey = PolygonMesh::new(3, RaggedArray::from_lists([[0, 1, 2]]), &[])?.survey();
    /// assert_eq!(survey.orientation().is_orientable(), Some(true));
    /// # Ok(()) }
    /// ```
    pub fn orientation(&self) -> &SurfaceOrientation {
        &self.orientation
    }

    /// The boundary.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let survey = PolygonMesh::new(3, RaggedArray::from_lists([[0, 1, 2]]), &[])?.survey();
    /// assert_eq!(survey.boundary_loops().len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn boundary_loops(&self) -> &[BoundaryLoop] {
        &self.boundary_loops
    }

    /// Each component: its counts and which surface it is.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let survey = PolygonMesh::new(3, RaggedArray::from_lists([[0, 1, 2]]), &[])?.survey();
    /// assert_eq!(survey.parts()[0].euler_characteristic(), 1);
    /// # Ok(()) }
    /// ```
    pub fn parts(&self) -> &[SurfaceComponent] {
        &self.parts
    }

    /// Which surface the mesh is, if it is connected and a surface.
    pub fn surface(&self) -> Option<SurfaceType> {
        match &self.parts[..] {
            [only] => only.surface,
            _ => None,
        }
    }

    /// The mesh in words: "torus", "5 spheres", "2 disks and 1 torus"; `None` if some component is neither a surface nor
    /// a point.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let survey = PolygonMesh::new(3, RaggedArray::from_lists([[0, 1, 2]]), &[])?.survey();
    /// assert_eq!(survey.name().as_deref(), Some("disk"));
    /// # Ok(()) }
    /// ```
    pub fn name(&self) -> Option<String> {
        SurfaceComponent::names(&self.parts)
    }
}

/// "1 torus", "2 spheres", "3 genus-3 surfaces with 4 boundary components".
fn counted(count: usize, name: &str) -> String {
    if count == 1 {
        return format!("1 {name}");
    }
    let (head, tail) = match name.find(" with ") {
        Some(at) => name.split_at(at),
        None => (name, ""),
    };
    let plural = match head {
        "pair of pants" => "pairs of pants".to_owned(),
        "annulus" => "annuli".to_owned(),
        "torus" => "tori".to_owned(),
        "double torus" => "double tori".to_owned(),
        "isolated vertex" => "isolated vertices".to_owned(),
        head => format!("{head}s"),
    };
    format!("{count} {plural}{tail}")
}

impl PolygonMesh {
    /// All surface tests at once: components, manifold test, orientation, boundary and classification.
    ///
    /// # Complexity
    /// Nearly linear; the tests run side by side.
    ///
    /// # Examples
    /// The boundary of a tetrahedron:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let faces = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let survey = PolygonMesh::new(4, faces, &[])?.survey();
    /// assert_eq!(survey.name().as_deref(), Some("sphere"));
    /// assert_eq!(survey.orientation().is_coherent(), Some(true));
    /// # Ok(()) }
    /// ```
    pub fn survey(&self) -> SurfaceSurvey {
        let steps = stage("examining the surface", 5);
        fn done<T>(steps: &Steps, found: T) -> T {
            steps.advance(1);
            found
        }
        let (components, (verdict, (orientation, boundary_loops))) = rayon::join(
            || done(&steps, self.components()),
            || {
                rayon::join(
                    || done(&steps, self.manifold_verdict()),
                    || {
                        rayon::join(
                            || done(&steps, self.orientation()),
                            || done(&steps, self.boundary_loops()),
                        )
                    },
                )
            },
        );
        let parts = self.classify(&components, &verdict, &orientation, &boundary_loops);
        SurfaceSurvey { components, verdict, orientation, boundary_loops, parts }
    }

    fn classify(
        &self,
        components: &Components,
        verdict: &SurfaceVerdict,
        orientation: &SurfaceOrientation,
        boundary_loops: &[BoundaryLoop],
    ) -> Vec<SurfaceComponent> {
        let part_of = |vertex: u32| components.of(VertexId::from_u32(vertex));
        let empty = SurfaceComponent { f_vector: [0; 3], boundary_count: 0, surface: None };
        let mut parts = vec![empty; components.count()];
        if let [only] = &mut parts[..] {
            only.f_vector = [self.vertex_count(), self.edge_count(), self.face_count()];
        } else {
            for vertex in 0..self.vertex_count() as u32 {
                parts[part_of(vertex)].f_vector[0] += 1;
            }
            for &[a, _] in self.edge_ends().as_chunks::<2>().0 {
                parts[part_of(a)].f_vector[1] += 1;
            }
            for polygon in self.polygons().iter() {
                parts[part_of(polygon[0])].f_vector[2] += 1;
            }
        }
        for boundary in boundary_loops {
            parts[part_of(boundary.vertices()[0].to_u32())].boundary_count += 1;
        }
        let mut is_surface: Vec<bool> = parts.iter().map(|part| part.f_vector[2] > 0).collect();
        for vertex in verdict.non_manifold_vertices() {
            is_surface[components.of(*vertex)] = false;
        }
        let non_orientable = self.non_orientable_parts(components, orientation);
        for (i, part) in parts.iter_mut().enumerate() {
            if is_surface[i] {
                *part = SurfaceComponent::of_surface(part.f_vector, part.boundary_count, !non_orientable[i]);
            }
        }
        parts
    }

    /// Which components hold an odd cycle of faces. Where faces conflict as listed, each component is tried by itself.
    fn non_orientable_parts(&self, components: &Components, orientation: &SurfaceOrientation) -> Vec<bool> {
        let mut found = vec![false; components.count()];
        if orientation.odd_cycle().is_some() {
            for edge in contradictions(self) {
                found[components.of(self.edge(EdgeId::new(edge))[0])] = true;
            }
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::RaggedArray;
    use proptest::prelude::*;

    fn survey_of(vertex_count: usize, triangles: &[[u32; 3]]) -> SurfaceSurvey {
        PolygonMesh::new(vertex_count, RaggedArray::from_lists(triangles), &[]).unwrap().survey()
    }

    /// The torus or, glued with a reflection, the Klein bottle of m by n squares, each cut in two.
    fn grid(m: u32, n: u32, reflected: bool) -> Vec<[u32; 3]> {
        let id = |i: u32, j: u32| {
            let j = if reflected && i == m { (n - j % n) % n } else { j % n };
            (i % m) * n + j
        };
        (0..m * n)
            .flat_map(|k| {
                let (i, j) = (k / n, k % n);
                let [a, b, c, d] = [id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)];
                [[a, b, c], [a, c, d]]
            })
            .collect()
    }

    #[test]
    fn known_surfaces_have_their_names() {
        // Moebius' torus of seven vertices: the orbits of 013 and 023 modulo 7; and the projective plane of six.
        let torus: Vec<[u32; 3]> =
            (0..7).flat_map(|i| [[0, 1, 3], [0, 2, 3]].map(|t| t.map(|v: u32| (v + i) % 7))).collect();
        let plane = [
            [0, 1, 2],
            [0, 2, 3],
            [0, 3, 4],
            [0, 4, 5],
            [0, 5, 1],
            [1, 2, 4],
            [2, 3, 5],
            [3, 4, 1],
            [4, 5, 2],
            [5, 1, 3],
        ];
        let table: [(&str, usize, Vec<[u32; 3]>, i64); 8] = [
            ("torus", 7, torus.clone(), 0),
            ("torus with 1 boundary component", 7, torus[1..].to_vec(), -1),
            ("projective plane", 6, plane.to_vec(), 1),
            ("Moebius band", 6, plane[1..].to_vec(), 0),
            ("Klein bottle", 25, grid(5, 5, true), 0),
            ("Klein bottle with 1 boundary component", 25, grid(5, 5, true)[1..].to_vec(), -1),
            ("torus", 20, grid(4, 5, false), 0),
            ("disk", 3, vec![[0, 1, 2]], 1),
        ];
        for (name, vertex_count, triangles, euler) in table {
            let survey = survey_of(vertex_count, &triangles);
            assert_eq!(survey.name().as_deref(), Some(name));
            let surface = survey.surface().unwrap();
            assert_eq!(surface.euler_characteristic(), euler, "{name}");
            assert_eq!(survey.orientation().is_orientable(), Some(surface.is_orientable()), "{name}");
            assert_eq!(survey.boundary_loops().len(), surface.boundary_count(), "{name}");
        }
    }

    #[test]
    fn several_components_are_counted_in_words() {
        let mut triangles = grid(3, 3, false);
        for base in [9, 13] {
            triangles.extend([[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]].map(|t| t.map(|v| v + base)));
        }
        triangles.extend(grid(3, 3, true).iter().map(|t| t.map(|v| v + 17)));
        let survey = survey_of(27, &triangles);
        assert_eq!(
            survey.name().as_deref(),
            Some("2 spheres, 1 torus, 1 Klein bottle and 1 isolated vertex")
        );
        assert_eq!((survey.surface(), survey.components().count()), (None, 5));
        assert_eq!(survey_of(0, &[]).name(), None);
        assert_eq!(survey_of(4, &[[0, 1, 2], [0, 1, 3], [0, 2, 3]]).name().as_deref(), Some("disk"));
    }

    #[test]
    fn a_pinched_component_has_no_name_but_the_others_do() {
        let survey = survey_of(8, &[[0, 1, 2], [0, 3, 4], [5, 6, 7]]);
        assert_eq!(survey.name(), None);
        assert_eq!(survey.parts()[0].surface(), None);
        assert_eq!(survey.parts()[1].surface(), Some(SurfaceType::orientable(0, 1)));
    }

    proptest! {
        /// Cutting faces out of a closed surface and relabeling it keeps handles or crosscaps.
        #[test]
        fn holes_do_not_change_the_genus(
            m in 3u32..7, n in 3u32..7, reflected: bool, hole in 0usize..18, turned in prop::collection::vec(any::<bool>(), 72),
        ) {
            let mut triangles = grid(m, n, reflected);
            for (triangle, turn) in triangles.iter_mut().zip(turned) {
                if turn {
                    triangle.swap(0, 1);
                }
            }
            triangles.swap_remove(hole);
            let surface = survey_of((m * n) as usize, &triangles).surface().unwrap();
            let expected =
                if reflected { SurfaceType::non_orientable(2, 1) } else { SurfaceType::orientable(1, 1) };
            prop_assert_eq!(surface, expected);
        }
    }
}
