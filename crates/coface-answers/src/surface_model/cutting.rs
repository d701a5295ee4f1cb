//! Surfaces cut open.

use super::SurfaceModel;
use super::canonical::{LayoutRequest, PlacedPolygons};
use crate::answer::{RefinementAnswer, TreesAnswer};
use crate::groups::roles_of_edges;
use coface_algebra::progress::stage;
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, VertexId};
use coface_algebra::{RaggedArray, Sign, Word};
use coface_complexes::surface::{GeneralizedMap, PathKind, Slice};
use coface_io::{CellData, GroupKind, Model};
use coface_topology::{CutGraph, CutSurface, TreeCotree};
use std::borrow::Cow;

/// How a surface is to be cut open.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CutRequest {
    /// Whether loose ends are left out and seams made short.
    pub simplify: bool,
    /// How often to go through all seams to make them shorter; without a number 4 times, and not at all on large models.
    pub rounds: Option<usize>,
    /// The vertex where loops start and end, in its component.
    pub base: Option<VertexId>,
    /// Whether the tree, the cotree and the edges in neither are wanted.
    pub roles: bool,
    /// Whether the surface is refined and cut along canonical curves, to a polygon with a canonical word around it. Then the base is the only
    /// other wish that counts.
    pub canonical: bool,
    /// How the polygons of a canonical cut are drawn, if they are to be; then the cut is canonical.
    pub layout: Option<LayoutRequest>,
}

/// A surface cut open along edges: what came of each component, and the seams.
///
/// Made by [`SurfaceModel::cut_open`] and [`SurfaceModel::cut_along`].
#[derive(Clone, Debug)]
pub struct SurfaceCut<'s> {
    pub(super) surface: Cow<'s, SurfaceModel>,
    pub(super) slice: Slice<GeneralizedMap>,
    pub(super) edges: Vec<EdgeId>,
    pub(super) seams: Vec<CutSeam>,
    pub(super) components: Vec<CutComponent>,
    pub(super) is_simplified: bool,
    pub(super) is_long: bool,
    pub(super) roles: Option<TreesAnswer>,
    pub(super) refinement: Option<RefinementAnswer>,
    pub(super) placed: Option<PlacedPolygons>,
}

/// A path of edges along which a surface is cut.
#[derive(Clone, Debug, PartialEq)]
pub struct CutSeam {
    pub(super) kind: String,
    pub(super) name: Option<String>,
    pub(super) is_reversing: bool,
    pub(super) steps: Vec<u32>,
    pub(super) length: Option<f64>,
    pub(super) component: usize,
}

impl CutSeam {
    /// What it is for: seams of the kind `handle` together open the handles of an orientable component, those of the
    /// kind `crosscap` the cross-caps of one that is not; `join`, `slit`; of a path that was given `two-sided`, `one-sided` or `open`.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CutRequest, SurfaceModel};
    /// // The torus of seven vertices.
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let surface = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let cut = surface.cut_open(&CutRequest { simplify: true, ..CutRequest::default() })?;
    /// assert!(cut.seams().iter().all(|seam| seam.kind() == "handle"));
    /// # Ok(()) }
    /// ```
    pub fn kind(&self) -> &str {
        &self.kind
    }

    /// Its name in the canonical word, of a canonical cut.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CutRequest, SurfaceModel};
    /// // The torus of seven vertices.
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let surface = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let cut = surface.cut_open(&CutRequest { canonical: true, ..CutRequest::default() })?;
    /// assert_eq!(cut.seams()[0].name(), Some("a1"));
    /// # Ok(()) }
    /// ```
    pub fn name(&self) -> Option<&str> {
        self.name.as_deref()
    }

    /// Whether the disk, glued together again at this seam alone, becomes a Moebius band.
    pub(crate) fn is_reversing(&self) -> bool {
        self.is_reversing
    }

    /// Its length in the unit of the file; `None` without positions.
    pub(crate) fn length(&self) -> Option<f64> {
        self.length
    }

    /// Its steps: 2e along edge e, 2e + 1 against it.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CutRequest, SurfaceModel};
    /// // The torus of seven vertices.
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let surface = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let cut = surface.cut_open(&CutRequest { simplify: true, ..CutRequest::default() })?;
    /// assert!(cut.seams().iter().all(|seam| !seam.steps().is_empty()));
    /// # Ok(()) }
    /// ```
    pub fn steps(&self) -> &[u32] {
        &self.steps
    }
}

/// What one component of a surface became.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CutComponent {
    /// What it is: before it was cut to a disk, or after it was cut along a path.
    pub surface: String,
    /// The number of edges along which it was cut.
    pub cut_edges: usize,
    /// The number of edges around it now.
    pub boundary_edges: usize,
    /// Its numbers of vertices, edges and faces now.
    pub f_vector: [usize; 3],
    /// The number in the file of the vertex where loops start; none of a path.
    pub base: Option<u32>,
    /// Its number of handles, or of cross-caps if it is not orientable; 0 of a surface cut along a path.
    pub genus: usize,
    /// The number of generators of its fundamental group.
    pub generators: usize,
    /// The word of generators around the disk, where there is one and seams are those of the generators.
    pub relator: Option<Word>,
    /// The seams around the disk: i for seam i, counted from 1 among `seams`, -i backwards.
    pub word: Vec<i32>,
    /// Which of all seams are its own.
    pub seams: Vec<usize>,
    /// The canonical word around the disk, of a canonical cut.
    pub canonical: Option<String>,
}

impl CutComponent {
    /// Vertices - edges + faces: 1 of a disk.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CutRequest, SurfaceModel};
    /// // The torus of seven vertices.
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let surface = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let cut = surface.cut_open(&CutRequest { simplify: true, ..CutRequest::default() })?;
    /// assert_eq!(cut.components()[0].euler_characteristic(), 1);
    /// # Ok(()) }
    /// ```
    pub fn euler_characteristic(&self) -> i64 {
        let [v, e, f] = self.f_vector;
        v as i64 - e as i64 + f as i64
    }
}

/// Seams are made shorter without being told to if that takes at most about so many steps.
const PATIENCE: usize = 40_000_000;

impl SurfaceModel {
    /// Cuts each component to a disk.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for a base that is no vertex of a component with faces; those of [`coface_topology::CanonicalCut::new`] of a
    /// canonical cut, and [`coface_topology::CanonicalCut::layout`] of one with a layout.
    ///
    /// # Complexity
    /// $O(n \log n)$; each round of shortening takes as many steps for each seam.
    ///
    /// # Examples
    /// The way around the disk that a torus is cut to passes each seam twice.
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_io::{Model, Structure};
    /// use coface_answers::{CutRequest, SurfaceModel};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let torus = Model::from_structure(Structure::Facets(RaggedArray::from_lists(triangles)));
    /// let surface = SurfaceModel::of(torus)?;
    /// let cut = surface.cut_open(&CutRequest { simplify: true, ..CutRequest::default() })?;
    /// assert_eq!(cut.components()[0].euler_characteristic(), 1);
    /// assert_eq!(cut.components()[0].word.len(), 2 * cut.seams().len());
    /// # Ok(()) }
    /// ```
    pub fn cut_open(&self, request: &CutRequest) -> Result<SurfaceCut<'_>, Error> {
        if request.canonical || request.layout.is_some() {
            return self.cut_canonically(request.base, request.layout);
        }
        let map = self.map();
        let trees_stage = stage("finding spanning trees", 0);
        let lengths = self.edge_lengths();
        let trees = if request.simplify || request.base.is_some() {
            TreeCotree::greedy(map, request.base, lengths.as_deref())?
        } else {
            TreeCotree::new(map)
        };
        drop(trees_stage);
        let walking = stage("walking around domains", 0);
        let cut = CutSurface::new(map, &trees);
        let mut graph = CutGraph::new(map, &trees, lengths.as_deref())?;
        drop(walking);
        let (mut is_shortened, mut is_long) = (false, false);
        if request.simplify {
            let work = graph.seams().len().saturating_mul(map.side_count());
            let rounds = request.rounds.unwrap_or(if work <= PATIENCE { 4 } else { 0 });
            if rounds > 0 {
                let _shortening = stage("shortening seams", 0);
                graph = graph.shortened(map, lengths.as_deref(), rounds)?;
                is_shortened = true;
            }
            is_long = rounds == 0 && request.rounds.is_none();
        }
        let _cutting = stage("cutting", 0);
        let is_inner = |edge: &EdgeId| map.mate(map.first_side(*edge)).is_some();
        let edges: Vec<EdgeId> = if request.simplify {
            graph.edges()
        } else {
            cut.cut_graph(map).into_iter().filter(is_inner).collect()
        };
        let seam = |seam: &coface_topology::Seam| CutSeam {
            kind: seam.kind().to_string(),
            name: None,
            is_reversing: seam.is_reversing(),
            steps: seam.steps().to_vec(),
            length: lengths.as_ref().map(|_| seam.length()),
            component: trees.component_of_vertex(seam.ends()[0]).unwrap_or_default(),
        };
        let seams: Vec<CutSeam> = graph.seams().iter().map(seam).collect();
        let slice = map.slice_edges(&edges)?;
        let mut components =
            counted(map, &slice, &edges, trees.components().len(), |face| trees.component_of_face(face));
        let (surfaces, orientation) = (map.surfaces(), map.orientation());
        for (i, component) in components.iter_mut().enumerate() {
            let found = &trees.components()[i];
            let surface = &surfaces[orientation.component(found.root())];
            (component.surface, component.genus) = (surface.to_string(), surface.genus());
            component.base = Some(self.number(found.base()));
            component.generators = found.generators().len();
            component.relator = cut.domains()[i].relator().filter(|_| !is_shortened);
            component.seams = (0..seams.len()).filter(|&seam| seams[seam].component == i).collect();
        }
        find_words(map, &slice, &seams, &mut components);
        let is_simplified = request.simplify;
        let roles = request.roles.then(|| {
            let numbers: Vec<u32> = (0..map.vertex_count()).map(|v| self.number(VertexId::new(v))).collect();
            roles_of_edges(map, &trees, &numbers)
        });
        Ok(SurfaceCut {
            surface: Cow::Borrowed(self),
            slice,
            edges,
            seams,
            components,
            is_simplified,
            is_long,
            roles,
            refinement: None,
            placed: None,
        })
    }

    /// Cuts along the path through these vertices, given by their numbers in the file; it is closed if the first is there again at the end.
    ///
    /// # Errors
    /// Those of [`Self::steps_along`], [`GeneralizedMap::slice_path`] and [`GeneralizedMap::slice_cycle`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::SurfaceModel;
    /// // The torus of seven vertices.
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let surface = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let cut = surface.cut_along(&[0, 1, 2, 0])?;
    /// assert_eq!(cut.seams()[0].kind(), "two-sided");
    /// # Ok(()) }
    /// ```
    pub fn cut_along(&self, path: &[u32]) -> Result<SurfaceCut<'_>, Error> {
        let map = self.map();
        let steps = self.steps_along(path)?;
        let _cutting = stage("cutting", 0);
        let is_closed = path.first() == path.last();
        self.check_path(path, &steps)?;
        let slice = if is_closed { map.slice_cycle(&steps) } else { map.slice_path(&steps) }?;
        let edges: Vec<EdgeId> = steps.iter().map(|&step| EdgeId::from_u32(step >> 1)).collect();
        let orientation = slice.surface().orientation();
        let surfaces = slice.surface().surfaces();
        let mut components = counted(map, &slice, &edges, surfaces.len(), |face| orientation.component(face));
        for (component, surface) in components.iter_mut().zip(&surfaces) {
            component.surface = surface.to_string();
        }
        let kind = match slice.path_kind() {
            Some(PathKind::TwoSided) => "two-sided",
            Some(PathKind::OneSided) => "one-sided",
            _ => "open",
        };
        let is_reversing = slice.path_kind() == Some(PathKind::OneSided);
        let seams = vec![CutSeam {
            kind: kind.to_owned(),
            name: None,
            is_reversing,
            steps,
            length: None,
            component: 0,
        }];
        Ok(SurfaceCut {
            surface: Cow::Borrowed(self),
            slice,
            edges,
            seams,
            components,
            is_simplified: false,
            is_long: false,
            roles: None,
            refinement: None,
            placed: None,
        })
    }

    /// That a path can be cut along, with faults in the numbers of the file.
    fn check_path(&self, path: &[u32], steps: &[u32]) -> Result<(), Error> {
        let is_closed = path.first() == path.last();
        let mut met: Vec<(u32, usize)> =
            path.iter().copied().zip(0..).take(path.len() - usize::from(is_closed)).collect();
        met.sort_unstable();
        let mut edges: Vec<(u32, usize)> = steps.iter().map(|step| step >> 1).zip(0..).collect();
        edges.sort_unstable();
        if let Some(pair) = edges.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            let (i, j) = (pair[0].1, pair[1].1);
            let [a, b] = [path[i], path[i + 1]];
            return Err(Error::invalid(format!(
                "steps {} and {} both run along the edge of vertices {a} and {b}",
                i + 1,
                j + 1
            ))
            .with_cells([[a, b]])
            .with_cure("give each edge once"));
        }
        if let Some(pair) = met.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            let vertex = pair[0].0;
            return Err(Error::invalid(format!("the path comes through vertex {vertex} twice"))
                .with_cells([[vertex]])
                .with_cure("give a path that does not meet itself"));
        }
        let map = self.map();
        let is_boundary = |step: &u32| map.mate(map.first_side(EdgeId::from_u32(step >> 1))).is_none();
        if let Some(i) = steps.iter().position(is_boundary) {
            let [a, b] = [path[i], path[i + 1]];
            return Err(Error::invalid(format!(
                "step {} from vertex {a} to {b} runs along the boundary: there is nothing to cut",
                i + 1
            ))
            .with_cells([[a, b]])
            .with_cure("leave the step out"));
        }
        Ok(())
    }

    /// The vertices that lie in no face, by their numbers in the file: no component has them.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::SurfaceModel;
    /// let text = &b"v 0 0 0\nv 9 9 9\nv 3 4 0\nv 0 4 0\nf 1 3 4\n"[..];
    /// let surface = SurfaceModel::of(coface_io::read(text, coface_io::Format::Obj)?)?;
    /// assert_eq!(surface.isolated_vertices(), [1]);
    /// # Ok(()) }
    /// ```
    pub fn isolated_vertices(&self) -> Vec<u32> {
        let map = self.map();
        let mut is_isolated = vec![true; map.vertex_count()];
        map.sides().for_each(|side| is_isolated[map.source(side).index()] = false);
        let isolated = (0..map.vertex_count()).filter(|&vertex| is_isolated[vertex]);
        isolated.map(|vertex| self.number(VertexId::new(vertex))).collect()
    }

    /// The steps along a path of vertices, given by their numbers in the file: 2e along edge e, 2e + 1 against it.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for fewer than two vertices; [`ErrorKind::NotInComplex`] naming the first vertex that is not there, or the
    /// first two that no edge joins.
    ///
    /// # Complexity
    /// Linear in the edges.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::SurfaceModel;
    /// // The torus of seven vertices.
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let surface = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// assert_eq!(surface.steps_along(&[0, 1, 2, 0])?.len(), 3);
    /// assert!(surface.steps_along(&[0]).is_err());
    /// # Ok(()) }
    /// ```
    pub fn steps_along(&self, path: &[u32]) -> Result<Vec<u32>, Error> {
        if path.len() < 2 {
            return Err(
                Error::invalid("a path has two vertices at least").with_cure("give its vertices in order")
            );
        }
        let vertices: Vec<VertexId> =
            path.iter().map(|&number| self.vertex_numbered(number)).collect::<Result<_, _>>()?;
        let skeleton = self.map().skeleton();
        let ends = skeleton.edge_ends();
        let steps_at = RaggedArray::grouped(skeleton.vertex_count(), ends.iter().copied());
        let step = |(i, pair): (usize, &[VertexId])| {
            let mut steps = steps_at.list(pair[0].index()).iter().copied();
            steps.find(|&step| ends[(step ^ 1) as usize] == pair[1].to_u32()).ok_or_else(|| {
                let [a, b] = [path[i], path[i + 1]];
                Error::new(
                    ErrorKind::NotInComplex,
                    format!("step {} goes from vertex {a} to vertex {b}, but no edge joins them", i + 1),
                )
                .with_cells([[a, b]])
                .with_cure("go along edges only")
            })
        };
        vertices.windows(2).enumerate().map(step).collect()
    }
}

impl SurfaceCut<'_> {
    /// What became of each component.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CutRequest, SurfaceModel};
    /// // The torus of seven vertices.
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let surface = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let cut = surface.cut_open(&CutRequest { simplify: true, ..CutRequest::default() })?;
    /// assert_eq!(cut.components().len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn components(&self) -> &[CutComponent] {
        &self.components
    }

    /// The seams. Their numbers in pictures and files are counted from 1.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CutRequest, SurfaceModel};
    /// // The torus of seven vertices.
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let surface = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let cut = surface.cut_open(&CutRequest { simplify: true, ..CutRequest::default() })?;
    /// assert_eq!(cut.components()[0].word.len(), 2 * cut.seams().len());
    /// # Ok(()) }
    /// ```
    pub fn seams(&self) -> &[CutSeam] {
        &self.seams
    }

    /// The edges along which the surface was cut.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CutRequest, SurfaceModel};
    /// // The torus of seven vertices.
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let surface = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let cut = surface.cut_open(&CutRequest { simplify: true, ..CutRequest::default() })?;
    /// assert_eq!(cut.edges().len(), cut.components()[0].cut_edges);
    /// # Ok(()) }
    /// ```
    pub fn edges(&self) -> &[EdgeId] {
        &self.edges
    }

    /// The surface as it is now, and what it was.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CutRequest, SurfaceModel};
    /// // The torus of seven vertices.
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let surface = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let cut = surface.cut_open(&CutRequest { simplify: true, ..CutRequest::default() })?;
    /// assert_eq!(cut.slice().surface().surfaces()[0].to_string(), "disk");
    /// # Ok(()) }
    /// ```
    pub fn slice(&self) -> &Slice<GeneralizedMap> {
        &self.slice
    }

    /// The edges by what they are in the tree-cotree decomposition, if that was asked for.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CutRequest, SurfaceModel};
    /// // The torus of seven vertices.
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let surface = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let cut = surface.cut_open(&CutRequest { roles: true, ..CutRequest::default() })?;
    /// let roles = cut.roles().expect("they were asked for");
    /// assert_eq!((roles.tree.len(), roles.cotree.len(), roles.generators.len()), (6, 13, 2));
    /// # Ok(()) }
    /// ```
    pub fn roles(&self) -> Option<&TreesAnswer> {
        self.roles.as_ref()
    }

    /// The surface whose edges were cut: the one given, or its refinement of a canonical cut.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CutRequest, SurfaceModel};
    /// // The torus of seven vertices.
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let surface = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let cut = surface.cut_open(&CutRequest::default())?;
    /// assert_eq!(cut.surface().map().vertex_count(), 7);
    /// # Ok(()) }
    /// ```
    pub fn surface(&self) -> &SurfaceModel {
        &self.surface
    }

    /// What was added to refine the surface, of a canonical cut.
    pub(crate) fn refinement(&self) -> Option<&RefinementAnswer> {
        self.refinement.as_ref()
    }

    /// Where the polygons of a canonical cut lie, if a layout was asked for.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CutRequest, LayoutRequest, SurfaceModel};
    /// // The torus of seven vertices.
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let surface = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let request = CutRequest { layout: Some(LayoutRequest::default()), ..CutRequest::default() };
    /// let cut = surface.cut_open(&request)?;
    /// let placed = cut.placed().ok_or(coface_algebra::Error::invalid("it was asked for"))?;
    /// assert_eq!(placed.turned(), 0);
    /// # Ok(()) }
    /// ```
    pub fn placed(&self) -> Option<&PlacedPolygons> {
        self.placed.as_ref()
    }

    /// Whether seams were left longer than they could be because the surface is large.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CutRequest, SurfaceModel};
    /// // The torus of seven vertices.
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let surface = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let cut = surface.cut_open(&CutRequest { simplify: true, ..CutRequest::default() })?;
    /// assert!(!cut.is_long());
    /// # Ok(()) }
    /// ```
    pub fn is_long(&self) -> bool {
        self.is_long
    }

    /// The vertices along a seam by their numbers in the file.
    ///
    /// # Panics
    /// If there is no such seam.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CutRequest, SurfaceModel};
    /// // The torus of seven vertices.
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let surface = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let cut = surface.cut_open(&CutRequest { simplify: true, ..CutRequest::default() })?;
    /// assert!(cut.seam_vertices(0).len() > 1);
    /// # Ok(()) }
    /// ```
    pub fn seam_vertices(&self, seam: usize) -> Vec<u32> {
        self.surface.numbers_along(&self.seams[seam].steps)
    }

    /// The surface as it is now as a model, with edges of the cut as lines. Their data are `seam`, counted from 1 (0 for loose ends), and
    /// `source`, the numbers in the file of the ends; vertices have `source`, polygons `face`. With a layout it lies in the plane, or has
    /// texture coordinates.
    ///
    /// # Errors
    /// Those of [`SurfaceModel::model_over`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CutRequest, SurfaceModel};
    /// // The torus of seven vertices.
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let surface = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let cut = surface.cut_open(&CutRequest { simplify: true, ..CutRequest::default() })?;
    /// assert_eq!(cut.model()?.polygons().len(), 14);
    /// # Ok(()) }
    /// ```
    pub fn model(&self) -> Result<Model, Error> {
        let open = self.slice.surface();
        let faces: Vec<FaceId> = (0..open.skeleton().face_count()).map(FaceId::new).collect();
        let mut seam_of = vec![-1_i64; self.surface.map().skeleton().edge_count()];
        self.edges.iter().for_each(|edge| seam_of[edge.index()] = 0);
        for (seam, number) in self.seams.iter().zip(1..) {
            seam.steps.iter().for_each(|&step| seam_of[(step >> 1) as usize] = number);
        }
        let (mut lines, mut numbers, mut sources) = (RaggedArray::new(), Vec::new(), Vec::new());
        for edge in (0..open.skeleton().edge_count()).map(EdgeId::new) {
            let source = self.slice.edge_sources()[edge];
            let number = seam_of[source.index()];
            let ends = open.skeleton().edge(edge);
            // A loop is no line.
            if number >= 0 && ends[0] != ends[1] {
                lines.push(&ends.map(VertexId::to_u32));
                numbers.push(number);
                sources.extend(self.surface.edge_numbers(source).map(i64::from));
            }
        }
        let mut model = self.surface.model_over(
            polygons_of_map(open),
            self.slice.vertex_sources().as_slice(),
            &faces,
            self.placed.as_ref().map(PlacedPolygons::positions).transpose()?.flatten(),
        )?;
        for coordinates in self.placed.iter().flat_map(PlacedPolygons::texture_coordinates) {
            model = model.with_data(coordinates?)?;
        }
        model
            .with_lines(lines)?
            .with_data(CellData::integers("seam", GroupKind::Lines, 1, numbers)?)?
            .with_data(CellData::integers("source", GroupKind::Lines, 2, sources)?)
    }

    /// The vertices that lie in no face, by their numbers in the file.
    pub(crate) fn isolated_vertices(&self) -> Vec<u32> {
        self.surface.isolated_vertices()
    }

    /// Whether it was cut along a path, and not to disks.
    pub(crate) fn is_along_path(&self) -> bool {
        self.slice.path_kind().is_some()
    }

    /// Whether loose ends were left out and seams made short.
    pub(crate) fn is_simplified(&self) -> bool {
        self.is_simplified
    }

    /// The numbers of vertices, edges and faces of all pieces together.
    pub(crate) fn f_vector(&self) -> Vec<usize> {
        self.slice.surface().f_vector()
    }
}

/// The faces of a surface by their vertices.
pub(super) fn polygons_of_map(map: &GeneralizedMap) -> RaggedArray {
    let faces = (0..map.skeleton().face_count()).map(FaceId::new);
    RaggedArray::from_lists(
        faces.map(|face| map.sides_of(face).map(|side| map.source(side).to_u32()).collect::<Vec<_>>()),
    )
}

/// The counts of each component of the surface that was cut open.
pub(super) fn counted(
    map: &GeneralizedMap,
    slice: &Slice<GeneralizedMap>,
    edges: &[EdgeId],
    count: usize,
    component_of: impl Fn(FaceId) -> usize,
) -> Vec<CutComponent> {
    let open = slice.surface();
    let mut components = vec![CutComponent::default(); count];
    let mut seen = vec![false; open.skeleton().vertex_count()];
    for side in open.sides() {
        let component = &mut components[component_of(open.face(side))];
        component.boundary_edges += usize::from(open.mate(side).is_none());
        component.f_vector[1] += usize::from(open.first_side(open.edge(side)) == side);
        component.f_vector[0] += usize::from(!std::mem::replace(&mut seen[open.source(side).index()], true));
    }
    for face in (0..open.skeleton().face_count()).map(FaceId::new) {
        components[component_of(face)].f_vector[2] += 1;
    }
    for &edge in edges {
        // The faces of the slice are those of the surface.
        components[component_of(map.face(map.first_side(edge)))].cut_edges += 1;
    }
    components
}

/// The seams around the boundary of each disk.
fn find_words(
    map: &GeneralizedMap,
    slice: &Slice<GeneralizedMap>,
    seams: &[CutSeam],
    components: &mut [CutComponent],
) {
    // The first step of each seam with its letter.
    let mut letters: Vec<(u32, i32, usize)> = Vec::with_capacity(seams.len());
    for (i, component) in components.iter().enumerate() {
        for (&seam, letter) in component.seams.iter().zip(1..) {
            letters.push((seams[seam].steps[0], letter, i));
        }
    }
    letters.sort_unstable();
    for walk in slice.surface().boundary_loops() {
        for (side, sign) in walk {
            let step = map.step(side) ^ u32::from(sign == Sign::Minus);
            let found = |step: u32| letters.binary_search_by_key(&step, |&(first, ..)| first);
            if let Ok(at) = found(step) {
                components[letters[at].2].word.push(letters[at].1);
            } else if let Ok(at) = found(step ^ 1) {
                components[letters[at].2].word.push(-letters[at].1);
            }
        }
    }
}
