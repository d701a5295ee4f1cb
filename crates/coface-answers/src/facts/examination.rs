//! From a model to its report.

use super::drawn::DrawnPolygons;
use super::geometry::{GeometryCheck, GeometryFacts, GeometryRequest, GeometryUnchecked};
use super::moments::{Moment, check_exponents};
use super::report::{DataSummary, GroupSummary, Kind, Report};
use super::{cells, chains, gluings, halfedges, polygons, simplicial, volume};
use crate::answer::{Place, Remark};
use crate::producer::{Cells, Producer};
use coface_algebra::Error;
use coface_complexes::simplicial::LINK_BUDGET;
use coface_io::{GroupKind, Model, RemarkCode, StatedSurfaces, Structure};

/// What a report says beside the usual, and how hard it tries.
///
/// # Examples
/// ```
/// use coface_answers::ReportRequest;
/// let request = ReportRequest::new().moments(vec![[2, 0, 0]]).full_verdict(true);
/// assert_ne!(request, ReportRequest::new());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ReportRequest {
    moments: Vec<[u32; 3]>,
    link_budget: u64,
    geometry: GeometryRequest,
}

/// How many places of a fault of the geometry are kept.
const PLACES: usize = 1000;

impl Default for ReportRequest {
    fn default() -> Self {
        let geometry = GeometryRequest { places: PLACES, ..GeometryRequest::default() };
        Self { moments: Vec::new(), link_budget: LINK_BUDGET, geometry }
    }
}

impl ReportRequest {
    /// No moments, a verdict within [`LINK_BUDGET`], and a check of the geometry of surfaces that are not large.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::ReportRequest;
    /// assert_eq!(ReportRequest::new(), ReportRequest::default());
    /// ```
    pub fn new() -> Self {
        Self::default()
    }

    /// Integrates monomials $x^a y^b z^c$ with these exponents a, b, c.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::ReportRequest;
    /// assert_ne!(ReportRequest::new().moments(vec![[2, 0, 0]]), ReportRequest::new());
    /// ```
    #[must_use]
    pub fn moments(mut self, exponents: Vec<[u32; 3]>) -> Self {
        self.moments = exponents;
        self
    }

    /// Whether the manifold verdict looks at all links, however many simplices they have.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::ReportRequest;
    /// assert_ne!(ReportRequest::new().full_verdict(true), ReportRequest::new().full_verdict(false));
    /// ```
    #[must_use]
    pub fn full_verdict(mut self, is_full: bool) -> Self {
        self.link_budget = if is_full { u64::MAX } else { LINK_BUDGET };
        self
    }

    /// Which surfaces have their geometry checked.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{GeometryCheck, ReportRequest};
    /// assert_ne!(ReportRequest::new().geometry(GeometryCheck::Always), ReportRequest::new());
    /// ```
    #[must_use]
    pub fn geometry(mut self, check: GeometryCheck) -> Self {
        self.geometry.check = check;
        self
    }

    /// A face is flat when its points are within this distance from a plane, in the unit of the file; `None` for a
    /// hundredth of its diameter.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::ReportRequest;
    /// assert_ne!(ReportRequest::new().flatness(Some(0.01)), ReportRequest::new());
    /// ```
    #[must_use]
    pub fn flatness(mut self, tolerance: Option<f64>) -> Self {
        self.geometry.flatness = tolerance;
        self
    }

    /// Lists up to this many places of each fault of the geometry; all are counted.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::ReportRequest;
    /// assert_ne!(ReportRequest::new().geometry_places(usize::MAX), ReportRequest::new());
    /// ```
    #[must_use]
    pub fn geometry_places(mut self, most: usize) -> Self {
        self.geometry.places = most;
        self
    }
}

impl ReportRequest {
    fn parts(&self) -> (&[[u32; 3]], &GeometryRequest) {
        (&self.moments, &self.geometry)
    }
}

impl Report {
    /// Examines a model. The model is taken along, so that its arrays become those of the structures made from it.
    ///
    /// # Errors
    /// Those of [`Producer::of`].
    ///
    /// # Complexity
    /// That of integral homology, near-linear on meshes; everything else is near-linear.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_io::{Model, Structure};
    /// use coface_answers::Report;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The Moebius band of five triangles.
    /// let band = RaggedArray::from_lists([[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 0], [4, 0, 1]]);
    /// let report = Report::of(Model::from_structure(Structure::Facets(band)))?;
    /// assert_eq!(report.name(), Some("Moebius band"));
    /// assert_eq!(report.is_orientable(), Some(false));
    /// assert_eq!(report.homology()[1].to_string(), "Z");
    /// # Ok(()) }
    /// ```
    pub fn of(model: Model) -> Result<Self, Error> {
        Self::with_moments(model, &[])
    }

    /// Examines a model as [`Self::of`] does, and integrates monomials $x^a y^b z^c$ with these exponents a, b, c over it.
    ///
    /// # Errors
    /// Those of [`Self::of`]; [`coface_algebra::ErrorKind::InvalidInput`] for exponents that add up to more than 100.
    ///
    /// # Complexity
    /// $O(n (a + 1) (b + 1) (c + 1))$ for n corners of polygons, for each monomial.
    ///
    /// # Examples
    /// The integral of x over a tetrahedron: its volume times its middle.
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// use coface_answers::Report;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let tetrahedron = io::read(text.as_bytes(), Format::Obj)?;
    /// let report = Report::with_moments(tetrahedron, &[[1, 0, 0]])?;
    /// assert_eq!(report.mass().map(|mass| mass.volume()), Some(1.0));
    /// assert!((report.moments()[0].volume().unwrap_or(0.0) - 0.25).abs() < 1e-15);
    /// # Ok(()) }
    /// ```
    pub fn with_moments(model: Model, exponents: &[[u32; 3]]) -> Result<Self, Error> {
        Self::answering(model, &ReportRequest::new().moments(exponents.to_vec()))
    }

    /// Examines a model as a request asks.
    ///
    /// # Errors
    /// Those of [`Self::with_moments`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_answers::{Report, ReportRequest};
    /// use coface_io::{Model, Structure};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let facets = RaggedArray::from_lists(vec![vec![0, 1, 2], vec![5]]);
    /// let report = Report::answering(Model::from_structure(Structure::Facets(facets)), &ReportRequest::new())?;
    /// let witness = report.witness().expect("a facet is a point");
    /// assert_eq!((witness.kind(), &witness.cells()[..]), ("not_pure", &[vec![5]][..]));
    /// # Ok(()) }
    /// ```
    pub fn answering(model: Model, request: &ReportRequest) -> Result<Self, Error> {
        let exponents = &request.moments[..];
        check_exponents(exponents)?;
        let kind = kind_of(&model);
        let (permutations, pointers) = halfedges::pointers(&model)?;
        let drawn = DrawnPolygons::of(&model, request.geometry.check)?;
        let reference = model.reference_system().cloned();
        let stated = model.stated_surfaces().cloned();
        let mut model = model.into_parts();
        let mut remarks = std::mem::take(&mut model.remarks);
        let has_seams =
            model.data.iter().any(|data| data.name() == "seam" && data.kind() == GroupKind::Lines);
        let data = std::mem::take(&mut model.data).iter().map(DataSummary::of).collect();
        let groups = model.groups.iter().map(GroupSummary::of).collect();
        // Nothing of a volume is made whole but its voxels.
        let volume = match model.structure.take() {
            Some(Structure::Volume(volume)) => Some(volume),
            structure => {
                model.structure = structure;
                None
            }
        };
        let mut report = match &volume {
            Some(volume) => volume::report(volume)?,
            None => report_of(Producer::of(model.into_model())?, kind, request, stated.as_ref())?,
        };
        if report.moments.is_empty() {
            let nothing = |&exponents: &[u32; 3]| Moment { exponents, volume: None, surface: None };
            report.moments = exponents.iter().map(nothing).collect();
        }
        if kind == Kind::Complex {
            // The vertices of a facet have an order, but it orients nothing.
            report.coherently_oriented = None;
            report.problems.retain(|problem| problem.kind() != super::ProblemKind::OrientationConflict);
        }
        remarks.extend(report.problems.iter().map(|problem| {
            Remark::new(problem.kind().into(), problem.message())
                .at(problem.count(), problem.cells().iter().map(Place::cell))
        }));
        // What was cut on purpose has seams.
        report.remarks.retain(|own| {
            let is_meant = has_seams && own.code == RemarkCode::CoincidentVertices;
            !(is_meant || remarks.contains(own))
        });
        remarks.append(&mut report.remarks);
        if let Some(geometry) = report.geometry.take() {
            remarks.extend(geometry.remarks());
            report.geometry = Some(geometry.with_corrections(&remarks));
        }
        if let Some(drawn) = &drawn {
            remarks.extend(drawn.remarks());
        }
        (report.drawn, report.reference) = (drawn, reference);
        (report.permutations, report.pointers) = (permutations, pointers);
        report.warnings = remarks.iter().map(|remark| remark.message.clone()).collect();
        report.remarks = remarks;
        (report.data, report.groups) = (data, groups);
        Ok(report)
    }
}

/// The report on cells whose faces are identified.
fn report_of(
    producer: Producer,
    kind: Kind,
    request: &ReportRequest,
    stated: Option<&StatedSurfaces>,
) -> Result<Report, Error> {
    let exponents = &request.moments[..];
    let Producer { cells, labels, positions, partial_positions, remarks } = producer;
    let has_partial_positions = partial_positions.is_some();
    let mut report = match cells {
        Cells::Polygons(mesh) => polygons::report(mesh, positions, &labels, kind, request.parts(), stated)?,
        Cells::Solids(mesh) => {
            let mut report = cells::report(*mesh, &positions, exponents);
            if !positions.is_empty() {
                report.geometry = Some(GeometryFacts::Unchecked(GeometryUnchecked::Volume));
            }
            report
        }
        Cells::Simplices(complex) => simplicial::report(&complex, request.link_budget)?,
        Cells::Halfedges(mesh) => halfedges::report(&mesh),
        Cells::Gluings(gluings) => gluings::report(&gluings.0, &gluings.1)?,
        Cells::Ordered(complex) => chains::report(&complex.complex().chain_complex()?),
        Cells::Chains(complex) => chains::report(&complex),
        Cells::Voxels(cells) => volume::report(cells.volume())?,
    };
    report.remarks.splice(0..0, remarks);
    if has_partial_positions && report.geometry.is_none() {
        report.geometry = Some(GeometryFacts::Unchecked(GeometryUnchecked::NotFinite));
    }
    Ok(report)
}

/// What sort of thing a model is.
fn kind_of(model: &Model) -> Kind {
    match model.structure() {
        Some(Structure::Halfedges { .. }) => Kind::Surface,
        Some(Structure::Volume(_)) => Kind::Volume,
        Some(_) => Kind::Complex,
        None if !model.cells().is_empty() => Kind::Volume,
        None if !model.polygons().is_empty() => Kind::Surface,
        None if !model.lines().is_empty() && is_planar(model) => Kind::Planar,
        None => Kind::Complex,
    }
}

/// Whether all positions have two coordinates, or a third that is zero or the height of a map.
fn is_planar(model: &Model) -> bool {
    match model.positions().dimension() {
        2 => true,
        3 if model.is_map_with_heights() => true,
        3 => model.positions().as_flat().iter().skip(2).step_by(3).all(|&z| z == 0.0),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Answer, Problem, ProblemKind};
    use coface_algebra::RaggedArray;
    use coface_complexes::cell_mesh::CellShape;
    use coface_complexes::simplicial::FrozenComplex;
    use coface_geometry::Positions;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    /// Up to 14 facets of one to five of nine vertices, with gaps in their numbers.
    fn facet_lists() -> impl Strategy<Value = Vec<Vec<u32>>> {
        let facet = prop::collection::btree_set(0_u32..9, 1..6);
        prop::collection::vec(facet.prop_map(|facet| facet.into_iter().map(|v| v * v + 1).collect()), 0..14)
    }

    fn report_of(facets: &[Vec<u32>]) -> Report {
        Report::of(Model::from_structure(Structure::Facets(RaggedArray::from_lists(facets)))).unwrap()
    }

    proptest! {
        #[test]
        fn reports_agree_with_sets_and_with_homology(facets in facet_lists()) {
            let mut simplices: BTreeSet<Vec<u32>> = BTreeSet::new();
            for facet in &facets {
                for chosen in 1..1_usize << facet.len() {
                    simplices.insert((0..facet.len()).filter(|i| chosen >> i & 1 == 1).map(|i| facet[i]).collect());
                }
            }
            let report = report_of(&facets);
            let count = |k: usize| simplices.iter().filter(|simplex| simplex.len() == k + 1).count();
            let counts: Vec<usize> = (0..5).map(count).take_while(|&count| count > 0).collect();
            prop_assert_eq!(report.f_vector(), &counts[..]);
            let betti: Vec<i64> = report.homology().iter().map(|group| group.betti() as i64).collect();
            prop_assert_eq!(betti.len(), counts.len());
            let alternating = betti.iter().enumerate().map(|(k, b)| if k % 2 == 0 { *b } else { -b }).sum::<i64>();
            prop_assert_eq!(report.euler_characteristic(), alternating);
            prop_assert_eq!(report.components() as i64, betti.first().copied().unwrap_or(0));
            let is_face = |a: &Vec<u32>, b: &Vec<u32>| a.len() < b.len() && a.iter().all(|v| b.contains(v));
            let maximal = simplices.iter().filter(|a| !simplices.iter().any(|b| is_face(a, b)));
            let sizes: BTreeSet<usize> = maximal.map(Vec::len).collect();
            prop_assert_eq!(report.is_pure(), Some(sizes.len() <= 1));
            if report.manifold() != Answer::Unknown {
                prop_assert_eq!(report.manifold() == Answer::No, report.witness().is_some());
            }
        }

        /// A triangle list goes one way through polygon meshes and another through simplices.
        #[test]
        fn two_ways_through_the_house_agree(
            facets in prop::collection::vec(prop::collection::btree_set(0_u32..7, 3..4), 1..16)
        ) {
            let facets: Vec<Vec<u32>> = facets.into_iter().map(|facet| facet.into_iter().collect()).collect();
            let polygons = report_of(&facets);
            let complex = FrozenComplex::from_facets(&RaggedArray::from_lists(&facets)).unwrap();
            let simplices = simplicial::report(&complex, LINK_BUDGET).unwrap();
            prop_assert_eq!(polygons.f_vector(), simplices.f_vector());
            prop_assert_eq!(polygons.components(), simplices.components());
            prop_assert_eq!(polygons.manifold(), simplices.manifold());
            prop_assert_eq!(polygons.is_closed(), simplices.is_closed());
            prop_assert_eq!(polygons.is_orientable(), simplices.is_orientable());
            prop_assert_eq!(polygons.homology(), simplices.homology());
        }
    }

    #[test]
    fn every_component_of_a_surface_is_named() {
        let disk_and_sphere =
            report_of(&[vec![0, 1, 2], vec![3, 4, 5], vec![3, 4, 6], vec![3, 5, 6], vec![4, 5, 6]]);
        let of = |report: &Report| -> Vec<(String, [usize; 3])> {
            let surfaces = report.surfaces().iter();
            surfaces.map(|part| (part.surface().unwrap().to_string(), part.f_vector())).collect()
        };
        assert_eq!(of(&disk_and_sphere), [("disk".into(), [3, 3, 1]), ("sphere".into(), [4, 6, 4])]);
        // A torus of one vertex beside a segment in a digon.
        let next = vec![2, 3, 1, 0, 5, 4];
        let twin = vec![1, 0, 3, 2, 5, 4];
        let halfedges =
            Report::of(Model::from_structure(Structure::Halfedges { next, twin, outer: Vec::new() }))
                .unwrap();
        assert_eq!(of(&halfedges), [("torus".into(), [1, 2, 1]), ("sphere".into(), [2, 1, 1])]);
        assert_eq!(halfedges.name(), Some("1 sphere and 1 torus"));
        let answer = halfedges.answer(1);
        assert_eq!((answer.surfaces[0].genus, answer.genus), (Some(1), None));
    }

    #[test]
    fn curves_points_and_nothing_are_ordinary() {
        let empty = report_of(&[]);
        assert_eq!((empty.dimension(), empty.components(), empty.homology().len()), (None, 0, 0));
        let points = report_of(&[vec![3], vec![8]]);
        assert_eq!(
            (points.f_vector(), points.manifold(), points.homology()[0].betti()),
            (&[2][..], Answer::Yes, 2)
        );
        let rim = report_of(&[vec![0, 1], vec![1, 2], vec![0, 2], vec![7]]);
        assert_eq!((rim.manifold(), rim.is_closed(), rim.is_pure()), (Answer::No, Some(true), Some(false)));
        assert!(rim.witness().unwrap().message().ends_with("without that facet it is a manifold"));
        let star = report_of(&[vec![0, 1], vec![0, 2], vec![0, 30]]);
        assert_eq!((star.manifold(), star.is_closed()), (Answer::No, Some(false)));
        assert_eq!(star.witness().unwrap().cells(), [[0]]);
    }

    #[test]
    fn faults_are_named_by_the_numbers_of_the_file() {
        let report =
            report_of(&[vec![10, 20, 30], vec![10, 20, 40], vec![10, 20, 50], vec![10, 20, 30], vec![60]]);
        let kinds: Vec<ProblemKind> = report.problems().iter().map(Problem::kind).collect();
        let expected = [
            ProblemKind::NonManifoldRidge,
            ProblemKind::NonManifoldVertex,
            ProblemKind::DuplicateCell,
            ProblemKind::IsolatedVertex,
        ];
        assert_eq!(kinds, expected);
        assert_eq!(report.problems()[0].cells().list(0), [10, 20]);
        assert_eq!(report.problems()[2].tops().list(0), [0, 3]);
        assert_eq!(report.problems()[3].cells().list(0), [60]);
        assert_eq!(report.warnings().len(), 4);
    }

    #[test]
    fn drawings_are_planar_and_cells_know_their_inside() {
        let lines = RaggedArray::from_lists([[0, 1], [1, 2]]);
        let positions = Positions::from_flat(2, vec![0., 0., 1., 0., 1., 1.]).unwrap();
        let drawing = Model::from_lines(positions, lines).unwrap();
        assert_eq!(Report::of(drawing).unwrap().kind(), Kind::Planar);
        let roof = &b"SRID=25832;POLYGON Z ((0 0 1, 4 0 1, 4 4 3, 0 0 1))"[..];
        let report = Report::of(coface_io::read(roof, coface_io::Format::Wkt).unwrap()).unwrap();
        assert_eq!(report.kind(), Kind::Planar);
        assert_eq!(report.reference_system().and_then(|system| system.srid()), Some(25832));
        let answer = report.answer(1).reference_system.unwrap();
        assert_eq!(answer.srid, Some(25832));
        assert!(answer.crs.contains("urn:ogc:def:crs:EPSG::25832"), "{}", answer.crs);
        let positions =
            Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 6.]).unwrap();
        let cells = RaggedArray::from_lists([[1, 0, 2, 3]]);
        let inverted = Model::from_cells(positions, vec![CellShape::Tetrahedron], cells).unwrap();
        let report = Report::of(inverted).unwrap();
        assert_eq!((report.kind(), report.signed_volume()), (Kind::Volume, Some(-1.0)));
        assert!(report.warnings()[0].contains("negative volume"), "{:?}", report.warnings());
        assert_eq!(report.skin().unwrap().name(), Some("sphere"));
    }
}
