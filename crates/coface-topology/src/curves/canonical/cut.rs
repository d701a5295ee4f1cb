//! Surfaces cut to canonical polygons.

use super::component::{CanonicalComponent, CanonicalCurve, CurveKind, curves_of};
use super::refinement::{Carrier, Refinement};
use super::schema::{CanonicalLoops, Schema};
use super::strands::{Crossings, Disks, Root};
use coface_algebra::progress::stage;
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, HalfedgeId, Sign, UnionFind, VertexId};
use coface_complexes::surface::{FaceOrientation, GeneralizedMap, Slice, SurfaceType};

const NONE: u32 = u32::MAX;

/// The steps of the curves of one component.
type Walks = Vec<Vec<u32>>;

/// A surface refined such that each component can be cut along edges to its canonical polygon.
///
/// The curves of a component are simple, start at one base, and have no other point in common. Cut along them it is a disk with one
/// of these words around it, and paths to the boundary loops after it:
///
/// * $a_1 b_1 a_1^{-1} b_1^{-1} a_2 b_2 a_2^{-1} b_2^{-1} \dots$ of an orientable surface;
/// * $c_1 c_1 c_2 c_2 \dots$ of a non-orientable one;
/// * $e_1 d_1 e_1^{-1} e_2 d_2 e_2^{-1} \dots$ for boundary loops $d_1, d_2, \dots$ that paths $e_1, e_2, \dots$ lead to;
/// * $s_1 s_1^{-1}$ of a sphere, $d_1$ of a disk, which is not cut.
///
/// # References
/// G. Vegter, C. K. Yap, *Computational complexity of combinatorial surfaces* (1990); F. Lazarus, M. Pocchiola, G. Vegter,
/// A. Verroust, *Computing a canonical polygonal schema of an orientable triangulated surface* (2001). Ours differs in that curves cross the
/// edges of the surface instead of following them, and takes surfaces that are not orientable or have a boundary.
///
/// # Examples
/// A surface of genus 2 and its octagon.
/// ```
/// use coface_algebra::Sign;
/// use coface_complexes::known_spaces;
/// use coface_complexes::surface::GeneralizedMap;
/// use coface_topology::CanonicalCut;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = known_spaces::cyclic_torus(2)?;
/// let double = known_spaces::oriented_sum(&torus, &torus, Sign::Plus)?;
/// let double = GeneralizedMap::new(double.freeze().two_skeleton()?)?;
/// let cut = CanonicalCut::new(&double, None)?;
/// assert_eq!(cut.components()[0].word(), [1, 2, -1, -2, 3, 4, -3, -4]);
/// assert_eq!(cut.slice().surface().surfaces()[0].to_string(), "disk");
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct CanonicalCut {
    pub(super) refinement: Refinement,
    pub(super) components: Vec<CanonicalComponent>,
}

impl CanonicalCut {
    /// Draws the curves of all components. They start at `base` in its component, unless that is a disk, and at the first vertex inside the surface that can be
    /// a base in others; where there is none, at a new vertex in the first face.
    ///
    /// Curves are crossings of as few edges as the spanning trees allow; edges are split evenly where curves cross them.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for a base that is on the boundary or on no face, or that a face or an edge is at twice.
    ///
    /// # Complexity
    /// $O(g n)$ for genus g, or number of boundary loops g, and n cells: no curve crosses an edge more than a fixed number of times.
    ///
    /// # Examples
    /// The Klein bottle is a quadrangle with two crosscaps.
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_complexes::surface::GeneralizedMap;
    /// use coface_topology::CanonicalCut;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let bottle = known_spaces::klein_grid(5, 5)?;
    /// let bottle = GeneralizedMap::new(bottle.freeze().two_skeleton()?)?;
    /// let cut = CanonicalCut::new(&bottle, None)?;
    /// assert_eq!(cut.components()[0].word(), [1, 1, 2, 2]);
    /// # Ok(()) }
    /// ```
    pub fn new(map: &GeneralizedMap, base: Option<VertexId>) -> Result<Self, Error> {
        let (surfaces, orientation) = (map.surfaces(), map.orientation());
        let (poked, roots) = placed_roots(map, &surfaces, &orientation, base)?;
        let drawing = stage("drawing canonical loops", 0);
        let (loops_drawn, loops) = draw_loops(poked.map(), &surfaces, &roots);
        drop(drawing);
        let joining = stage("joining boundary loops", 0);
        let roots = roots_after(&loops_drawn, poked.map(), &roots);
        let (joined, paths, loops) = draw_paths(loops_drawn.map(), &surfaces, &roots, loops);
        drop(joining);
        let refinement = joined.after(&loops_drawn).after(&poked);
        let mut components: Vec<CanonicalComponent> = (surfaces.iter().zip(&roots))
            .map(|(&surface, root)| CanonicalComponent {
                surface,
                base: root.as_ref().map(|root| root.vertex),
                curves: Vec::new(),
                word: Vec::new(),
            })
            .collect();
        for (i, component) in components.iter_mut().enumerate() {
            component.curves = curves_of(surfaces[i], &loops[i], &paths[i]);
        }
        let mut cut = Self { refinement, components };
        cut.add_slits();
        cut.add_boundaries();
        cut.read_words();
        Ok(cut)
    }

    /// The surface refined, with the way back.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::CanonicalCut;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CanonicalCut::new(&torus, None)?;
    /// assert_eq!(cut.refinement().map().surfaces(), torus.surfaces());
    /// # Ok(()) }
    /// ```
    pub fn refinement(&self) -> &Refinement {
        &self.refinement
    }

    /// The components, in the order of their first faces.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::CanonicalCut;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CanonicalCut::new(&torus, None)?;
    /// assert_eq!(cut.components().len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn components(&self) -> &[CanonicalComponent] {
        &self.components
    }

    /// The edges of the refined surface along which it is to be cut, component by component and curve by curve.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::CanonicalCut;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CanonicalCut::new(&torus, None)?;
    /// let steps = cut.components()[0].curves().iter().map(|curve| curve.steps().len());
    /// assert_eq!(cut.edges().len(), steps.sum());
    /// # Ok(()) }
    /// ```
    pub fn edges(&self) -> Vec<EdgeId> {
        let curves = self.components.iter().flat_map(|component| &component.curves);
        let cut = curves.filter(|curve| curve.kind != CurveKind::Boundary);
        cut.flat_map(|curve| &curve.steps).map(|step| EdgeId::from_u32(step >> 1)).collect()
    }

    /// The refined surface cut open: a disk for each component.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::CanonicalCut;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CanonicalCut::new(&torus, None)?;
    /// assert_eq!(cut.slice().surface().surfaces()[0].to_string(), "disk");
    /// # Ok(()) }
    /// ```
    pub fn slice(&self) -> Slice<GeneralizedMap> {
        self.refinement.map().slice_edges(&self.edges()).expect("the edges are those of the surface")
    }

    /// Cuts spheres along two edges, or one where there is no second one.
    fn add_slits(&mut self) {
        let map = self.refinement.map();
        let ends = map.skeleton().edge_ends();
        let flags = flags_at_vertices(map);
        let steps_from = |vertex: VertexId| {
            let flags = map.fan(flags[vertex.index()]).into_iter();
            flags.map(|flag| map.step(HalfedgeId::from_u32(flag >> 1)) ^ (flag & 1))
        };
        for component in &mut self.components {
            let Some(base) = component.base.filter(|_| is_sphere(component.surface)) else { continue };
            let end = |step: u32| VertexId::from_u32(ends[(step ^ 1) as usize]);
            let first = steps_from(base).next().expect("the base is on a face");
            let further = steps_from(end(first)).find(|&step| end(step) != base && end(step) != end(first));
            let steps = [first].into_iter().chain(further).collect();
            component.curves = vec![CanonicalCurve { kind: CurveKind::Slit, name: "s1".to_owned(), steps }];
        }
    }

    /// Adds the boundary loops, each from the end of the path to it.
    fn add_boundaries(&mut self) {
        let map = self.refinement.map();
        let ends = map.skeleton().edge_ends();
        let mut loop_at = vec![NONE; map.vertex_count()];
        let holes: Vec<Vec<u32>> = (map.boundary_loops().into_iter())
            .map(|walk| {
                walk.iter().map(|&(side, sign)| map.step(side) ^ u32::from(sign == Sign::Minus)).collect()
            })
            .collect();
        for (hole, number) in holes.iter().zip(0..) {
            hole.iter().for_each(|&step| loop_at[ends[step as usize] as usize] = number);
        }
        let orientation = map.orientation();
        for (i, component) in self.components.iter_mut().enumerate() {
            let reached: Vec<usize> = if component.base.is_none() {
                let face = |hole: &Vec<u32>| map.face(map.first_side(EdgeId::from_u32(hole[0] >> 1)));
                let own = holes.iter().position(|hole| orientation.component(face(hole)) == i);
                own.map(|hole| ends[holes[hole][0] as usize] as usize).into_iter().collect()
            } else {
                let paths = component.curves.iter().filter(|curve| curve.kind == CurveKind::Join);
                paths.map(|path| ends[(path.steps[path.steps.len() - 1] ^ 1) as usize] as usize).collect()
            };
            for (start, number) in reached.into_iter().zip(1..) {
                let mut steps = holes[loop_at[start] as usize].clone();
                let first = steps.iter().position(|&step| ends[step as usize] as usize == start);
                steps.rotate_left(first.expect("a path ends at a boundary loop"));
                let name = format!("d{number}");
                component.curves.push(CanonicalCurve { kind: CurveKind::Boundary, name, steps });
            }
        }
    }

    /// Reads the words around the polygons, and puts curves to boundary loops in the order in which they are met.
    fn read_words(&mut self) {
        let slice = self.slice();
        let map = self.refinement.map();
        // The first step of each curve with its letter.
        let mut letters = vec![0_i32; 2 * map.edge_count()];
        for component in &self.components {
            for (curve, letter) in component.curves.iter().zip(1..) {
                let first = curve.steps[0];
                (letters[first as usize], letters[(first ^ 1) as usize]) = (letter, -letter);
            }
        }
        let orientation = slice.surface().orientation();
        for walk in slice.surface().boundary_loops() {
            let component = orientation.component(slice.surface().face(walk[0].0));
            let steps = walk.iter().map(|&(side, sign)| map.step(side) ^ u32::from(sign == Sign::Minus));
            let word: Vec<i32> =
                steps.map(|step| letters[step as usize]).filter(|&letter| letter != 0).collect();
            self.components[component].set_word(word);
        }
    }
}

fn is_sphere(surface: SurfaceType) -> bool {
    surface.euler_characteristic() == 2
}

fn is_disk(surface: SurfaceType) -> bool {
    surface.euler_characteristic() == 1 && surface.is_orientable()
}

/// A flag at each vertex on a face.
fn flags_at_vertices(map: &GeneralizedMap) -> Vec<u32> {
    let mut flags = vec![NONE; map.vertex_count()];
    for side in map.sides().rev() {
        flags[map.source(side).index()] = side.to_u32() << 1;
    }
    flags
}

/// A root for each component but disks, in the surface with faces poked where no vertex can be one.
fn placed_roots(
    map: &GeneralizedMap,
    surfaces: &[SurfaceType],
    orientation: &FaceOrientation,
    base: Option<VertexId>,
) -> Result<(Refinement, Vec<Option<Root>>), Error> {
    let flags = flags_at_vertices(map);
    let root_at = |vertex: VertexId| {
        let flag = flags[vertex.index()];
        if flag == NONE {
            return None;
        }
        Root::new(map, flag).filter(|root| root.is_inside(map))
    };
    let component_at =
        |vertex: VertexId| orientation.component(map.face(HalfedgeId::from_u32(flags[vertex.index()] >> 1)));
    let mut found: Vec<Option<Root>> = vec![None; surfaces.len()];
    if let Some(base) = base {
        let refused = |fault: &str| {
            Error::invalid(format!("canonical loops cannot start at the base: {fault}"))
                .with_cells([[base.to_u32()]])
                .with_cure("give a vertex inside the surface")
        };
        match flags.get(base.index()) {
            None => {
                return Err(Error::new(ErrorKind::NotInComplex, format!("there is no vertex {base}")));
            }
            Some(&NONE) => return Err(refused("it is on no face")),
            Some(_) => {}
        }
        let root =
            root_at(base).ok_or_else(|| refused("it is on the boundary, or twice on a face or an edge"))?;
        if !is_disk(surfaces[component_at(base)]) {
            found[component_at(base)] = Some(root);
        }
    }
    let mut missing =
        found.iter().zip(surfaces).filter(|(root, surface)| root.is_none() && !is_disk(**surface)).count();
    for vertex in (0..map.vertex_count()).map(VertexId::new).filter(|vertex| flags[vertex.index()] != NONE) {
        if missing == 0 {
            break;
        }
        let component = component_at(vertex);
        if found[component].is_some() || is_disk(surfaces[component]) {
            continue;
        }
        found[component] = root_at(vertex);
        missing -= usize::from(found[component].is_some());
    }
    let mut poked = Vec::new();
    for (i, root) in found.iter().enumerate() {
        if root.is_none() && !is_disk(surfaces[i]) {
            let mut faces = (0..map.face_count()).map(FaceId::new);
            poked.push(faces.find(|&face| orientation.component(face) == i).expect("a component has a face"));
        }
    }
    poked.sort_unstable();
    let refined = Refinement::poked(map, &poked);
    // Sides have other numbers in the refined surface.
    let roots = rooted_again(&refined, map, &found, orientation);
    Ok((refined, roots))
}

/// The same roots in the surface with poked faces, and the new vertices as roots of the components that had none.
fn rooted_again(
    refined: &Refinement,
    map: &GeneralizedMap,
    found: &[Option<Root>],
    orientation: &FaceOrientation,
) -> Vec<Option<Root>> {
    let mut wanted = vec![false; refined.map().vertex_count()];
    found.iter().flatten().for_each(|root| wanted[root.vertex.index()] = true);
    wanted[map.vertex_count()..].fill(true);
    let mut roots = vec![None; found.len()];
    for side in refined.map().sides() {
        let vertex = refined.map().source(side);
        if std::mem::replace(&mut wanted[vertex.index()], false) {
            let component = orientation.component(refined.face_sources()[refined.map().face(side)]);
            roots[component] = Root::new(refined.map(), side.to_u32() << 1);
        }
    }
    roots
}

/// The same roots in a refined surface, with the parts of their first edges as first edges: no strand crosses these.
fn roots_after(refined: &Refinement, before: &GeneralizedMap, roots: &[Option<Root>]) -> Vec<Option<Root>> {
    let map = refined.map();
    let mut first_edges = vec![None; map.vertex_count()];
    for (i, root) in roots.iter().enumerate() {
        if let Some(root) = root {
            first_edges[root.vertex.index()] = Some((i, before.edge(root.corners[0][0])));
        }
    }
    let mut found = vec![None; roots.len()];
    for side in map.sides() {
        let Some((i, first)) = first_edges[map.source(side).index()] else { continue };
        if found[i].is_none() && refined.edge_carriers()[map.edge(side)] == Carrier::Edge(first) {
            found[i] = Root::new(map, side.to_u32() << 1);
        }
    }
    found
}

/// The surface refined along the loops of handles and crosscaps, and the steps of the loops of each component.
fn draw_loops(
    map: &GeneralizedMap,
    surfaces: &[SurfaceType],
    roots: &[Option<Root>],
) -> (Refinement, Vec<Walks>) {
    let with_loops: Vec<usize> =
        (0..roots.len()).filter(|&i| surfaces[i].genus() > 0 && roots[i].is_some()).collect();
    let chosen: Vec<Root> = with_loops.iter().filter_map(|&i| roots[i].clone()).collect();
    if chosen.is_empty() {
        return (Refinement::identity(map.clone()), vec![Vec::new(); roots.len()]);
    }
    let disks = Disks::new(map, chosen, &[]);
    let crossed = generators(map, &disks);
    let mut crossings = Crossings::default();
    let mut spokes: Vec<Vec<usize>> = vec![Vec::new(); roots.len()];
    for (root, &component) in with_loops.iter().enumerate() {
        let around: Vec<HalfedgeId> =
            disks.around(root).into_iter().filter(|&side| crossed[map.edge(side).index()]).collect();
        let mut numbers = vec![NONE; map.edge_count()];
        let mut edges = Vec::new();
        for &side in &around {
            let number = &mut numbers[map.edge(side).index()];
            if *number == NONE {
                *number = edges.len() as u32;
                edges.push(map.edge(side));
            }
        }
        let mut schema = Schema::new(map, &disks, &around, &numbers);
        schema.normalize();
        spokes[component] = crossings.add(map, schema.finish(), &edges);
    }
    let drawn = disks.draw(&crossings);
    let loops = spokes.iter().map(|own| own.iter().map(|&spoke| drawn.curve(spoke)).collect()).collect();
    (drawn.refinement, loops)
}

impl Crossings {
    /// Adds canonical loops whose points are on these edges; their first spokes.
    fn add(&mut self, map: &GeneralizedMap, found: CanonicalLoops, edges: &[EdgeId]) -> Vec<usize> {
        let offset = self.strands.len() as u32;
        for (&edge, points) in edges.iter().zip(found.points) {
            self.points.push((edge, points.into_iter().map(|point| offset + point).collect()));
        }
        self.strands.resize(self.strands.len() + found.point_count, [NONE; 2]);
        let mut spokes = Vec::with_capacity(found.loops.len());
        for crossed in &found.loops {
            spokes.push(self.strand_count);
            for crossing in crossed {
                let is_first = map.first_side(map.edge(crossing.side)) == crossing.side;
                let (before, after) = (self.strand_count as u32, self.strand_count as u32 + 1);
                self.strands[(offset + crossing.point) as usize] =
                    if is_first { [before, after] } else { [after, before] };
                self.strand_count += 1;
            }
            self.strand_count += 1;
        }
        spokes
    }
}

/// Which edges the loops of generators cross: those that neither a spanning tree of the vertices, without roots and with each boundary
/// loop as one vertex, has, nor the trees of faces cross. Edges far from the roots are preferred for the tree.
fn generators(map: &GeneralizedMap, disks: &Disks<'_>) -> Vec<bool> {
    let mut classes = UnionFind::new(map.vertex_count());
    let mut is_at_root = vec![false; map.edge_count()];
    let corners = disks.roots().iter().flat_map(|root| &root.corners);
    corners.flatten().for_each(|&side| is_at_root[map.edge(side).index()] = true);
    let mut edges: Vec<(u32, EdgeId)> = Vec::new();
    for edge in (0..map.edge_count()).map(EdgeId::new) {
        let side = map.first_side(edge);
        let [from, to] = map.skeleton().edge(edge).map(VertexId::to_u32);
        match map.mate(side) {
            None => _ = classes.unite(from, to),
            Some(mate) => {
                let [near, far] = [side, mate].map(|side| disks.depths[map.face(side).index()]);
                if near != NONE && far != NONE && !is_at_root[edge.index()] && !disks.is_crossed(edge) {
                    edges.push((near + far, edge));
                }
            }
        }
    }
    edges.sort_unstable_by_key(|&(length, edge)| (std::cmp::Reverse(length), edge));
    let mut is_generator = vec![false; map.edge_count()];
    for (_, edge) in edges {
        let [from, to] = map.skeleton().edge(edge).map(VertexId::to_u32);
        is_generator[edge.index()] = !classes.unite(from, to);
    }
    is_generator
}

/// The surface refined along paths from the roots to all boundary loops; their steps for each component, and those of the loops again.
fn draw_paths(
    map: &GeneralizedMap,
    surfaces: &[SurfaceType],
    roots: &[Option<Root>],
    mut loops: Vec<Walks>,
) -> (Refinement, Vec<Walks>, Vec<Walks>) {
    let with_paths: Vec<usize> =
        (0..roots.len()).filter(|&i| surfaces[i].boundary_count() > 0 && roots[i].is_some()).collect();
    let mut paths = vec![Vec::new(); roots.len()];
    if with_paths.is_empty() {
        return (Refinement::identity(map.clone()), paths, loops);
    }
    let mut walls = vec![false; map.edge_count()];
    loops.iter().flatten().flatten().for_each(|step| walls[(step >> 1) as usize] = true);
    let wedges =
        with_paths.iter().filter_map(|&i| roots[i].clone()).map(|root| root.wedge(map, &walls)).collect();
    let disks = Disks::new(map, wedges, &walls);
    // One side of each boundary loop, the nearest one.
    let mut crossings = Crossings::default();
    let orientation = map.orientation();
    let mut spokes: Vec<Vec<usize>> = vec![Vec::new(); roots.len()];
    for hole in map.boundary_loops() {
        let component = orientation.component(map.face(hole[0].0));
        if roots[component].is_none() {
            continue;
        }
        let sides = hole.iter().map(|&(side, _)| side);
        let side =
            sides.min_by_key(|&side| (disks.depths[map.face(side).index()], side)).expect("a loop has sides");
        spokes[component].push(crossings.strand_count);
        crossings.points.push((map.edge(side), vec![crossings.strands.len() as u32]));
        crossings.strands.push([crossings.strand_count as u32, NONE]);
        crossings.strand_count += 1;
    }
    let drawn = disks.draw(&crossings);
    for (own, spokes) in paths.iter_mut().zip(&spokes) {
        *own = spokes.iter().map(|&spoke| drawn.curve(spoke)).collect();
    }
    // No path crosses a loop, so that its edges are whole, with other numbers.
    let becomes = drawn.refinement.first_parts(map.edge_count());
    for step in loops.iter_mut().flatten().flatten() {
        *step = 2 * becomes[(*step >> 1) as usize] + (*step & 1);
    }
    (drawn.refinement, paths, loops)
}
