//! `coface cut`: surfaces cut open.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::output::{print_json, print_text, remark};
use crate::progress::Progress;
use crate::{surface, text};
use clap::Args;
use coface::algebra::{RaggedArray, Sign, Word};
use coface::io::{CellData, GroupKind, Model};
use coface::report::SurfaceModel;
use coface::surface::{GeneralizedMap, PathKind, Slice};
use coface::topology::{CutGraph, CutSurface, TreeCotree};
use coface::{EdgeId, FaceId, VertexId};
use serde_json::{Value, json};
use std::path::PathBuf;

/// Cut a surface open: each component to a disk, or along one path of edges.
///
/// Without options a component is cut along all edges that a spanning tree of its faces does not cross. --simplify leaves
/// out what is not needed: a torus is cut along two loops that meet, a sphere along one edge, a disk not at all. Surfaces may
/// have a boundary, and need not be orientable.
///
/// The mesh written with -o has the numbers of the file as data: "source" on vertices, "face" on polygons; the edges along
/// which it was cut are lines, with "seam", counted from 1 (0 for loose ends), and "source", the ends in the file. Formats
/// that keep data are .ply and .vtk; .json has the faces and "source".
#[derive(Args)]
pub(crate) struct Cut {
    /// The model; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// Leave loose ends out and take short seams
    #[arg(long, conflicts_with = "along")]
    simplify: bool,
    /// With --simplify: how often to go through all seams to make them shorter [default: 4, none on large models]
    #[arg(long, value_name = "N", requires = "simplify")]
    rounds: Option<usize>,
    /// The vertex where loops start and end, in its component
    #[arg(long, value_name = "VERTEX", conflicts_with = "along")]
    base: Option<u32>,
    /// Cut along the path through these vertices instead, closed if the first is there again at the end: "0 1 2 0"
    #[arg(long, value_name = "PATH")]
    along: Option<String>,
    /// Cut the boundary surface of a volume mesh
    #[arg(long)]
    boundary: bool,
}

/// Seams are made shorter without being told to if that takes at most about so many steps.
const PATIENCE: usize = 40_000_000;

/// What one component became.
struct Component {
    name: String,
    cut_edges: usize,
    boundary_edges: usize,
    f_vector: [usize; 3],
    base: Option<u32>,
    generators: usize,
    relator: Option<Word>,
    word: Vec<i32>,
    seams: Vec<usize>,
}

impl Component {
    fn euler_characteristic(&self) -> i64 {
        let [v, e, f] = self.f_vector;
        v as i64 - e as i64 + f as i64
    }
}

/// A seam as it is shown.
struct ShownSeam {
    kind: String,
    steps: Vec<u32>,
    length: Option<f64>,
    component: usize,
}

impl Cut {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let progress = Progress::start(common.quiet);
        let (name, surface) = surface::read(&self.input, self.boundary, common, &progress)?;
        if let Some(path) = &self.along {
            return self.cut_along(path, &name, &surface, common, progress);
        }
        let map = surface.map();
        progress.stage("finding spanning trees");
        let lengths = surface::edge_lengths(map.skeleton(), surface.positions());
        let base = self.base.map(|base| surface::vertex(&surface, base, &name)).transpose()?;
        let trees = if self.simplify || base.is_some() {
            TreeCotree::greedy(map, base, lengths.as_deref()).map_err(|error| error.in_file(name.clone()))?
        } else {
            TreeCotree::new(map)
        };
        progress.stage("walking around domains");
        let cut = CutSurface::new(map, &trees);
        let mut graph = CutGraph::new(map, &trees, lengths.as_deref())?;
        let mut is_shortened = false;
        if self.simplify {
            let work = graph.seams().len().saturating_mul(map.side_count());
            let rounds = self.rounds.unwrap_or(if work <= PATIENCE { 4 } else { 0 });
            if rounds > 0 {
                progress.stage("shortening seams");
                graph = graph.shortened(map, lengths.as_deref(), rounds)?;
                is_shortened = true;
            } else if self.rounds.is_none() && !common.quiet {
                remark(&format!(
                    "{} seams on {} sides of faces are not made shorter; --rounds 1 does it",
                    graph.seams().len(),
                    map.side_count()
                ));
            }
        }
        let is_inner = |edge: &EdgeId| map.mate(map.first_side(*edge)).is_some();
        let edges: Vec<EdgeId> = if self.simplify {
            graph.edges()
        } else {
            cut.cut_graph(map).into_iter().filter(is_inner).collect()
        };
        let seams: Vec<ShownSeam> = graph
            .seams()
            .iter()
            .map(|seam| ShownSeam {
                kind: seam.kind().to_string(),
                steps: seam.steps().to_vec(),
                length: lengths.as_ref().map(|_| seam.length()),
                component: trees.component_of_vertex(seam.ends()[0]).unwrap_or_default(),
            })
            .collect();
        progress.stage("cutting");
        let slice = map.slice_edges(&edges)?;
        let mut components =
            components(map, &slice, &edges, trees.components().len(), |face| trees.component_of_face(face));
        let (surfaces, orientation) = (map.surfaces(), map.orientation());
        for (i, component) in components.iter_mut().enumerate() {
            let found = &trees.components()[i];
            component.name = surfaces[orientation.component(found.root())].to_string();
            component.base = Some(surface.number(found.base()));
            component.generators = found.generators().len();
            component.relator = cut.domains()[i].relator().filter(|_| !is_shortened);
            component.seams = (0..seams.len()).filter(|&seam| seams[seam].component == i).collect();
        }
        words(map, &slice, &seams, &mut components);
        let object = json!({
            "file": name,
            "simplified": self.simplify,
            "components": components.iter().map(|c| component_to_json(c, &seams, &surface)).collect::<Vec<_>>(),
            "f_vector": slice.surface().f_vector(),
        });
        if let Some(path) = &common.output {
            progress.stage(format!("writing {}", path.display()));
            let model = model(&surface, &slice, &edges, &seams)?;
            surface::save(path, &model, &object, common)?;
        }
        drop(progress);
        answer(common, &object, &page(&name, &components, &seams, &surface))
    }

    /// Cuts along one path.
    fn cut_along(
        &self,
        path: &str,
        name: &str,
        surface: &SurfaceModel,
        common: &Common,
        progress: Progress,
    ) -> Result<(), Failure> {
        let map = surface.map();
        let in_path = |error: coface::Error| Failure::new(format!("{name}: --along \"{path}\": {error}"));
        let steps = steps_of(path, surface, name)?;
        progress.stage("cutting");
        let ends = map.skeleton().edge_ends();
        let is_closed = ends[steps[0] as usize] == ends[(steps[steps.len() - 1] ^ 1) as usize];
        let slice =
            if is_closed { map.slice_cycle(&steps) } else { map.slice_path(&steps) }.map_err(in_path)?;
        let edges: Vec<EdgeId> = steps.iter().map(|&step| EdgeId::from_u32(step >> 1)).collect();
        let orientation = slice.surface().orientation();
        let surfaces = slice.surface().surfaces();
        let mut components =
            components(map, &slice, &edges, surfaces.len(), |face| orientation.component(face));
        for (component, surface) in components.iter_mut().zip(&surfaces) {
            component.name = surface.to_string();
        }
        let kind = match slice.path_kind() {
            Some(PathKind::TwoSided) => "two-sided",
            Some(PathKind::OneSided) => "one-sided",
            _ => "open",
        };
        let shown: Vec<Value> = components
            .iter()
            .map(|component| {
                json!({
                    "surface": component.name,
                    "cut_edges": component.cut_edges,
                    "boundary_edges": component.boundary_edges,
                    "euler_characteristic": component.euler_characteristic(),
                    "f_vector": component.f_vector,
                })
            })
            .collect();
        let object = json!({
            "file": name,
            "path": {"kind": kind, "edges": steps.len()},
            "components": shown,
            "f_vector": slice.surface().f_vector(),
        });
        if let Some(out) = &common.output {
            progress.stage(format!("writing {}", out.display()));
            let seam = ShownSeam { kind: kind.to_owned(), steps, length: None, component: 0 };
            surface::save(out, &model(surface, &slice, &edges, &[seam])?, &object, common)?;
        }
        drop(progress);
        let mut facts = vec![(
            "path".to_owned(),
            format!("{}, {kind}", text::count(edges.len(), "edge")),
            "each edge of it is two edges of the boundary now".to_owned(),
        )];
        for (i, component) in components.iter().enumerate() {
            let label = if i == 0 { "surface" } else { "" };
            facts.push((label.to_owned(), component.name.clone(), counts(component.f_vector)));
        }
        answer(common, &object, &text::facts(&format!("{name} cut along a path"), &facts))
    }
}

/// The answer on standard output; -o has the mesh.
fn answer(common: &Common, object: &Value, page: &str) -> Result<(), Failure> {
    match (common.json, &common.output) {
        (true, _) => print_json(object),
        (false, Some(_)) if common.quiet => Ok(()),
        (false, _) => print_text(page),
    }
}

/// The steps of a path given by the numbers of its vertices.
fn steps_of(path: &str, surface: &SurfaceModel, name: &str) -> Result<Vec<u32>, Failure> {
    let map = surface.map();
    let words = path.split([' ', ',', '\t']).filter(|word| !word.is_empty());
    let mut vertices = Vec::new();
    for word in words {
        let number: u32 = word.trim_start_matches('v').parse().map_err(|_| {
            Failure::new(format!("--along \"{path}\": {word:?} is no vertex; write a path as \"0 1 2\""))
        })?;
        vertices.push(surface::vertex(surface, number, name)?);
    }
    if vertices.len() < 2 {
        return Err(Failure::new(format!(
            "--along \"{path}\": a path has two vertices at least; write it as \"0 1 2\""
        )));
    }
    let ends = map.skeleton().edge_ends();
    let steps_at = RaggedArray::grouped(map.skeleton().vertex_count(), ends.iter().copied());
    let step = |(i, pair): (usize, &[VertexId])| {
        let mut steps = steps_at.list(pair[0].index()).iter().copied();
        steps.find(|&step| ends[(step ^ 1) as usize] == pair[1].to_u32()).ok_or_else(|| {
            let [a, b] = [pair[0], pair[1]].map(|vertex| surface.number(vertex));
            Failure::new(format!(
                "{name}: --along \"{path}\": step {i} goes from vertex {a} to vertex {b}, but no edge joins them; go along edges only"
            ))
        })
    };
    vertices.windows(2).enumerate().map(step).collect()
}

/// The counts of each component of the surface that was cut open.
fn components(
    map: &GeneralizedMap,
    slice: &Slice<GeneralizedMap>,
    edges: &[EdgeId],
    count: usize,
    component_of: impl Fn(FaceId) -> usize,
) -> Vec<Component> {
    let open = slice.surface();
    let mut components: Vec<Component> = (0..count)
        .map(|_| Component {
            name: String::new(),
            cut_edges: 0,
            boundary_edges: 0,
            f_vector: [0; 3],
            base: None,
            generators: 0,
            relator: None,
            word: Vec::new(),
            seams: Vec::new(),
        })
        .collect();
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
        components[component_of(map.face(map.first_side(edge)))].cut_edges += 1;
    }
    components
}

/// The seams around the boundary of each disk: i for seam i, counted from 1 among those of the component, -i backwards.
fn words(
    map: &GeneralizedMap,
    slice: &Slice<GeneralizedMap>,
    seams: &[ShownSeam],
    components: &mut [Component],
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

/// The surface cut open, with seams as lines.
fn model(
    surface: &SurfaceModel,
    slice: &Slice<GeneralizedMap>,
    edges: &[EdgeId],
    seams: &[ShownSeam],
) -> Result<Model, Failure> {
    let open = slice.surface();
    let faces: Vec<FaceId> = (0..open.skeleton().face_count()).map(FaceId::new).collect();
    let polygons = RaggedArray::from_lists(
        faces
            .iter()
            .map(|&face| open.sides_of(face).map(|side| open.source(side).to_u32()).collect::<Vec<_>>()),
    );
    let mut seam_of = vec![-1i64; surface.map().skeleton().edge_count()];
    edges.iter().for_each(|edge| seam_of[edge.index()] = 0);
    for (seam, number) in seams.iter().zip(1..) {
        seam.steps.iter().for_each(|&step| seam_of[(step >> 1) as usize] = number);
    }
    let (mut lines, mut numbers, mut sources) = (RaggedArray::new(), Vec::new(), Vec::new());
    for edge in (0..open.skeleton().edge_count()).map(EdgeId::new) {
        let source = slice.edge_sources()[edge];
        let number = seam_of[source.index()];
        let ends = open.skeleton().edge(edge);
        // A loop is no line.
        if number >= 0 && ends[0] != ends[1] {
            lines.push(&ends.map(VertexId::to_u32));
            numbers.push(number);
            sources.extend(surface.edge_numbers(source).map(i64::from));
        }
    }
    let model = surface.model_over(polygons, slice.vertex_sources().as_slice(), &faces, None)?;
    Ok(model
        .with_lines(lines)?
        .with_data(CellData::integers("seam", GroupKind::Lines, 1, numbers)?)?
        .with_data(CellData::integers("source", GroupKind::Lines, 2, sources)?)?)
}

fn seam_vertices(seam: &ShownSeam, surface: &SurfaceModel) -> Vec<u32> {
    let ends = surface.map().skeleton().edge_ends();
    let number = |step: u32| surface.number(VertexId::from_u32(ends[step as usize]));
    let first = seam.steps.first().map(|&step| number(step));
    first.into_iter().chain(seam.steps.iter().map(|&step| number(step ^ 1))).collect()
}

fn component_to_json(component: &Component, seams: &[ShownSeam], surface: &SurfaceModel) -> Value {
    let seams: Vec<Value> = component
        .seams
        .iter()
        .map(|&number| {
            let seam = &seams[number];
            json!({
                "number": number + 1,
                "kind": seam.kind,
                "edges": seam.steps.len(),
                "length": seam.length,
                "vertices": seam_vertices(seam, surface),
            })
        })
        .collect();
    json!({
        "surface": component.name,
        "base": component.base,
        "cut_edges": component.cut_edges,
        "boundary_edges": component.boundary_edges,
        "euler_characteristic": component.euler_characteristic(),
        "f_vector": component.f_vector,
        "generators": component.generators,
        "relator": component.relator.as_ref().map(|relator| relator.letters().to_vec()),
        "seams": seams,
        "word": component.word,
    })
}

fn counts([v, e, f]: [usize; 3]) -> String {
    format!("{}, {}, {}", text::count(v, "vertex"), text::count(e, "edge"), text::count(f, "face"))
}

/// What a seam is for, in words.
fn gloss(kind: &str) -> &'static str {
    match kind {
        "handle" => "it opens a handle",
        "crosscap" => "it opens a cross-cap",
        "join" => "it joins boundary loops, handles and cross-caps",
        "slit" => "it opens the sphere",
        _ => "",
    }
}

fn page(name: &str, components: &[Component], seams: &[ShownSeam], surface: &SurfaceModel) -> String {
    let mut facts = Vec::new();
    let mut fact = |label: &str, value: String, gloss: &str| {
        facts.push((label.to_owned(), value, gloss.to_owned()));
    };
    let (shown, more) = surface::few(components.len());
    for (i, component) in components.iter().take(shown).enumerate() {
        if components.len() > 1 {
            fact("component", format!("{} of {}", i + 1, components.len()), "");
        }
        fact("surface", component.name.clone(), "");
        fact("cut edges", component.cut_edges.to_string(), "");
        let what = if component.euler_characteristic() == 1 { "it is a disk" } else { "" };
        fact("domain", counts(component.f_vector), what);
        fact("boundary", text::count(component.boundary_edges, "edge"), "around the domain");
        let (few, rest) = surface::few(component.seams.len());
        for (i, &seam) in component.seams.iter().take(few).enumerate() {
            let shown = &seams[seam];
            let vertices = seam_vertices(shown, surface);
            let way: Vec<String> = vertices.iter().take(6).map(ToString::to_string).collect();
            let dots = if vertices.len() > way.len() { " .." } else { "" };
            let value = format!(
                "{}: {}, {} through {}{dots}",
                seam + 1,
                shown.kind,
                text::count(shown.steps.len(), "edge"),
                way.join(" ")
            );
            fact(if i == 0 { "seams" } else { "" }, value, gloss(&shown.kind));
        }
        if rest > 0 {
            fact("", format!("and {rest} more (--json lists all)"), "");
        }
        if !component.word.is_empty() && component.word.len() <= 60 {
            let word = Word::from_letters(component.word.iter().copied());
            if word.len() == component.word.len() {
                fact("around it", word.to_string(), "the seams of the component in the order of a walk");
            }
        }
    }
    if more > 0 {
        fact("", format!("and {} (--json lists all)", text::count(more, "more component")), "");
    }
    if components.is_empty() {
        fact("surface", "none".to_owned(), "the model has no faces");
    }
    text::facts(&format!("{name} cut open"), &facts)
}
