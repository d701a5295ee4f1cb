//! `coface cut`: surfaces cut open.

use crate::arguments::Common;
use crate::certified;
use crate::failure::Failure;
use crate::output::{print_json, print_text};
use crate::progress::Progress;
use crate::remarks::{accept, say_remarks};
use crate::surface;
use clap::{Args, ValueEnum};
use coface::algebra::Word;
use coface::answers::answer::{CutAnswer, Remark, RemarkCode};
use coface::answers::text;
use coface::answers::{CutRequest, LayoutRequest, LayoutWeights, SurfaceCut, SurfaceModel};
use coface::topology::PolygonPlane;
use std::path::PathBuf;

/// Cut a surface open: each component to a disk, or along one path of edges.
///
/// Without options a component is cut along all edges that a spanning tree of its faces does not cross. --simplify leaves
/// out what is not needed: a torus is cut along two loops that meet, a sphere along one edge, a disk not at all. Surfaces may
/// have a boundary, and need not be orientable. (The function coface.cut of Python does as --simplify unless it is told simplify=False.)
///
/// --canonical cuts along disjoint simple loops through one vertex, so that the way around the disk is a1 b1 a1^-1 b1^-1 a2 .. of an
/// orientable surface, and c1 c1 c2 c2 .. of one that is not; paths e1, e2, .. lead to boundary loops d1, d2, .. The loops go across edges and
/// faces, which are split: new vertices have the numbers after those of the file, and --json says of which vertices they are means.
///
/// --layout draws the disk of a canonical cut as a regular polygon, each vertex inside in the middle of its neighbors, so that no triangle is turned
/// over: in the unit circle (polygon), or in the disk of Klein (klein), where hyperbolic lines are straight, so that the corners make one turn. With
/// --uv the mesh stays where it is, and the layout is its texture coordinates: "vt" in .obj, data "s" and "t" in .ply and .vtk, and in
/// .glb by coface convert.
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
    /// Refine the mesh and cut along canonical loops
    #[arg(long, conflicts_with_all = ["simplify", "along", "roles"])]
    canonical: bool,
    /// Draw the disk of a canonical cut in the plane
    #[arg(long, value_enum, value_name = "PLANE", conflicts_with_all = ["simplify", "along", "roles"])]
    layout: Option<Layout>,
    /// Of a layout: each vertex is the mean of its neighbors, all alike, or by cotangents, which keep angles better [default: uniform]
    #[arg(long, value_enum, value_name = "WEIGHTS")]
    weights: Option<Weights>,
    /// Keep the mesh in space, and write the layout as texture coordinates [default layout: polygon]
    #[arg(long, conflicts_with_all = ["simplify", "along", "roles"])]
    uv: bool,
    /// With --simplify: how often to go through all seams to make them shorter [default: 4, none on large models]
    #[arg(long, value_name = "N", requires = "simplify")]
    rounds: Option<usize>,
    /// The vertex where loops start and end, in its component
    #[arg(long, value_name = "VERTEX", conflicts_with = "along")]
    base: Option<u32>,
    /// Cut along the path through these vertices instead, closed if the first is there again at the end: "0 1 2 0"
    #[arg(long, value_name = "PATH")]
    along: Option<String>,
    /// With --json, or in the file of -o: "roles", which edges are in the spanning tree of vertices, which are crossed by that of faces, and
    /// which are in neither and close the generators; coface view --with draws them
    #[arg(long, conflicts_with = "along")]
    roles: bool,
    /// Cut the boundary surface of a volume mesh
    #[arg(long)]
    boundary: bool,
    /// A certificate of the cut, which coface check verifies: what components are, that each is cut to a disk, the word of seams around it, or what
    /// a path leaves; of a facet list, or a surface as plain OFF or OBJ; in
    /// the binary form if OUT ends in .bin
    #[arg(long, value_name = "OUT", conflicts_with_all = ["canonical", "layout", "uv", "boundary"])]
    certificate: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Layout {
    Polygon,
    Klein,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Weights {
    Uniform,
    Cotangent,
}

impl Cut {
    /// How the disks are to be drawn, if they are.
    fn layout(&self) -> Result<Option<LayoutRequest>, Failure> {
        let plane = match (self.layout, self.uv) {
            (None, false) if self.weights.is_some() => {
                return Err(Failure::new(
                    "--weights is about a layout; add --layout polygon, or leave --weights out",
                ));
            }
            (None, false) => return Ok(None),
            (Some(Layout::Klein), _) => PolygonPlane::Klein,
            _ => PolygonPlane::Euclidean,
        };
        let weights = match self.weights {
            Some(Weights::Cotangent) => LayoutWeights::Cotangent,
            _ => LayoutWeights::Uniform,
        };
        Ok(Some(LayoutRequest { plane, weights, as_texture: self.uv }))
    }

    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        if let Some(place) = &self.certificate {
            certified::check_place(place, std::slice::from_ref(&self.input), "cut", common)?;
        }
        let progress = Progress::start(common.quiet);
        let (name, surface) = surface::read(&self.input, self.boundary, common, &progress)?;
        if let Some(path) = &self.along {
            return self.cut_along(path, &name, &surface, common, progress);
        }
        let request = CutRequest {
            simplify: self.simplify,
            rounds: self.rounds,
            roles: self.roles,
            canonical: self.canonical,
            layout: self.layout()?,
            base: self
                .base
                .map(|base| surface.vertex_numbered(base))
                .transpose()
                .map_err(|error| error.in_file(name.clone()))?,
        };
        let cut = surface.cut_open(&request).map_err(|error| error.in_file(name.clone()))?;
        let mut remarks = cut.answer().remarks;
        if cut.is_long() {
            let message = format!(
                "{} seams on {} sides of faces are not made shorter; --rounds 1 does it",
                cut.seams().len(),
                surface.map().side_count()
            );
            remarks.push(Remark::new(RemarkCode::StepLeftOut, message).at(cut.seams().len(), []));
        }
        accept(&remarks, common)?;
        say_remarks(&remarks, common);
        let object = self.save(&cut, &name, remarks, common, &progress)?;
        drop(progress);
        answer(common, &object, &page(&name, &cut))
    }

    /// Writes the mesh if that is wanted; the answer for programs.
    fn save(
        &self,
        cut: &SurfaceCut<'_>,
        name: &str,
        remarks: Vec<Remark>,
        common: &Common,
        progress: &Progress,
    ) -> Result<CutAnswer, Failure> {
        if let Some(place) = &self.certificate {
            progress.stage(format!("proving {}", place.display()));
            certified::save(place, std::slice::from_ref(&self.input), |inputs| cut.certificate(inputs))?;
        }
        let mut object = cut.answer();
        object.file = Some(name.to_owned());
        object.remarks = remarks;
        if let Some(path) = &common.output {
            progress.stage(format!("writing {}", path.display()));
            surface::save(path, &cut.model()?, &object, common)?;
        }
        Ok(object)
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
        let in_path = |error: coface::Error| Failure::new(format!("{name}: --along \"{path}\": {error}"));
        let cut = surface.cut_along(&vertices_of(path)?).map_err(in_path)?;
        let remarks = cut.answer().remarks;
        accept(&remarks, common)?;
        say_remarks(&remarks, common);
        let object = self.save(&cut, name, remarks, common, &progress)?;
        drop(progress);
        let kind = cut.seams()[0].kind();
        let mut facts = vec![(
            "path".to_owned(),
            format!("{}, {kind}", text::count(cut.edges().len(), "edge")),
            "each edge of it is two edges of the boundary now".to_owned(),
        )];
        for (i, component) in cut.components().iter().enumerate() {
            let label = if i == 0 { "surface" } else { "" };
            facts.push((label.to_owned(), component.surface.clone(), counts(component.f_vector)));
        }
        answer(common, &object, &text::facts(&format!("{name} cut along a path"), &facts))
    }
}

/// The answer on standard output; -o has the mesh.
fn answer(common: &Common, object: &CutAnswer, page: &str) -> Result<(), Failure> {
    match (common.json, &common.output) {
        (true, _) => print_json(object),
        (false, Some(_)) if common.quiet => Ok(()),
        (false, _) => print_text(page),
    }
}

/// The vertices of a path, by their numbers in the file.
fn vertices_of(path: &str) -> Result<Vec<u32>, Failure> {
    let words = path.split([' ', ',', '\t']).filter(|word| !word.is_empty());
    let number = |word: &str| {
        word.trim_start_matches('v').parse().map_err(|_| {
            Failure::new(format!("--along \"{path}\": {word:?} is no vertex; write a path as \"0 1 2\""))
        })
    };
    let vertices: Vec<u32> = words.map(number).collect::<Result<_, _>>()?;
    if vertices.len() < 2 {
        return Err(Failure::new(format!(
            "--along \"{path}\": a path has two vertices at least; write it as \"0 1 2\""
        )));
    }
    Ok(vertices)
}

fn counts([v, e, f]: [usize; 3]) -> String {
    format!("{}, {}, {}", text::count(v, "vertex"), text::count(e, "edge"), text::count(f, "face"))
}

/// What a seam is for, in words: how many of its kind the component has, and what they open together.
fn gloss(kind: &str, seams: usize, genus: usize) -> String {
    let together = |what: &str| {
        let opened = if genus == 1 { format!("the {what}") } else { text::count(genus, what) };
        if seams == 1 {
            format!("it opens {opened}")
        } else {
            format!("one of {seams} seams that open {opened}")
        }
    };
    match kind {
        "handle" => together("handle"),
        "crosscap" => together("cross-cap"),
        "join" => "it joins boundary loops, handles and cross-caps".to_owned(),
        "slit" => "it opens the sphere".to_owned(),
        _ => String::new(),
    }
}

fn page(name: &str, cut: &SurfaceCut<'_>) -> String {
    let components = cut.components();
    let mut facts = Vec::new();
    let mut fact = |label: &str, value: String, gloss: &str| {
        facts.push((label.to_owned(), value, gloss.to_owned()));
    };
    let (shown, more) = surface::few(components.len());
    for (i, component) in components.iter().take(shown).enumerate() {
        if components.len() > 1 {
            fact("component", format!("{} of {}", i + 1, components.len()), "");
        }
        fact("surface", component.surface.clone(), "");
        fact("cut edges", component.cut_edges.to_string(), "");
        let what = if component.euler_characteristic() == 1 { "it is a disk" } else { "" };
        fact("domain", counts(component.f_vector), what);
        fact("boundary", text::count(component.boundary_edges, "edge"), "around the domain");
        let (few, rest) = surface::few(component.seams.len());
        for (i, &seam) in component.seams.iter().take(few).enumerate() {
            let shown = &cut.seams()[seam];
            let vertices = cut.seam_vertices(seam);
            let way: Vec<String> = vertices.iter().take(6).map(ToString::to_string).collect();
            let dots = if vertices.len() > way.len() { " .." } else { "" };
            let name = shown.name().map_or_else(|| (seam + 1).to_string(), str::to_owned);
            let value = format!(
                "{name}: {}, {} through {}{dots}",
                shown.kind(),
                text::count(shown.steps().len(), "edge"),
                way.join(" ")
            );
            let seams = component.seams.iter().filter(|&&other| cut.seams()[other].kind() == shown.kind());
            let gloss = gloss(shown.kind(), seams.count(), component.genus);
            fact(if i == 0 { "seams" } else { "" }, value, &gloss);
        }
        if rest > 0 {
            fact("", format!("and {rest} more (--json lists all)"), "");
        }
        if let Some(word) = &component.canonical {
            if word.len() <= 400 {
                fact("around it", word.clone(), "seams and boundary loops in the order of a walk");
            }
        } else if !component.word.is_empty() && component.word.len() <= 60 {
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
    if let Some(refined) = cut.answer().refinement {
        let new = text::count(refined.vertices.len(), "vertex");
        facts.push(("added".to_owned(), new, "where seams cross edges and faces".to_owned()));
    }
    if let Some(placed) = cut.answer().layout {
        let plane = if placed.plane == "klein" {
            "regular in the disk of Klein"
        } else {
            "regular in the unit circle"
        };
        let turned = match placed.turned {
            0 => "none is turned over".to_owned(),
            count => format!("{count} of them turned over or flat"),
        };
        facts.push((
            "polygon".to_owned(),
            plane.to_owned(),
            format!("{}, {turned}", text::count(placed.triangles, "triangle")),
        ));
    }
    text::facts(&format!("{name} cut open"), &facts)
}
