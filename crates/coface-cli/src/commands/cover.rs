//! `coface cover`: universal covers of surfaces, and orientation double covers.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::output::{print_json, print_text, remark};
use crate::progress::Progress;
use crate::{surface, text};
use clap::{ArgGroup, Args, ValueEnum};
use coface::algebra::RaggedArray;
use coface::geometry::Positions;
use coface::io::{CellData, GroupKind, Model};
use coface::report::SurfaceModel;
use coface::topology::{CoverExtent, CoverPlane, CutSurface, TreeCotree, UniversalCover};
use coface::{Error, FaceId, VertexId};
use serde_json::{Value, json};
use std::path::PathBuf;

/// The universal cover of a surface, as far as is asked for, or its orientation double cover.
///
/// A universal cover is made of copies of the surface cut to a disk, one for each element of the fundamental group; copies
/// are counted by their distance: how many cuts lie between them and the first one. Whether two copies are the same is
/// decided by normal forms of words, not by looks.
///
/// The mesh written with -o has data: "source" on vertices and "face" on polygons, the numbers in the file of what lies
/// below; "copy" on both, and "length" on polygons, the distance of the copy. It lies in the plane or, by --layout, in the
/// hyperbolic disk, so that copies are congruent.
#[derive(Args)]
#[command(group(ArgGroup::new("extent").required(true).args(["radius", "copies", "orientation"])))]
pub(crate) struct Cover {
    /// The model; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// All copies up to this distance
    #[arg(long, value_name = "N")]
    radius: Option<usize>,
    /// So many copies, the nearest first
    #[arg(long, value_name = "N")]
    copies: Option<usize>,
    /// The orientation double cover instead: every face twice, so that all agree
    #[arg(long)]
    orientation: bool,
    /// Where the mesh lies: flat (torus, Klein bottle, annulus, Moebius band), disk (closed, negative Euler characteristic),
    /// none (over the surface); by default what there is
    #[arg(long, value_enum, default_value_t = Layout::Auto, hide_default_value = true)]
    layout: Layout,
    /// Cover this component, counted from 0
    #[arg(long, value_name = "I", default_value_t = 0, conflicts_with = "orientation")]
    component: usize,
    /// Refuse covers of more cells than this
    #[arg(long, value_name = "N", default_value_t = 100_000_000)]
    most_cells: usize,
    /// Cover the boundary surface of a volume mesh
    #[arg(long)]
    boundary: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Layout {
    Auto,
    Flat,
    Disk,
    None,
}

impl Cover {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let progress = Progress::start(common.quiet);
        let (name, surface) = surface::read(&self.input, self.boundary, common, &progress)?;
        if self.orientation {
            return self.double_cover(&name, &surface, common, progress);
        }
        let map = surface.map();
        progress.stage("cutting");
        let trees = TreeCotree::new(map);
        let cut = CutSurface::new(map, &trees);
        let extent = match (self.radius, self.copies) {
            (Some(radius), _) => CoverExtent::Radius(radius),
            (None, copies) => CoverExtent::Copies(copies.unwrap_or(1)),
        };
        progress.stage("gluing copies");
        let cover = UniversalCover::new(map, &cut, self.component, extent, self.most_cells)
            .map_err(|error| error.in_file(name.clone()))?;
        let layout = if common.output.is_some() || matches!(self.layout, Layout::Flat | Layout::Disk) {
            progress.stage("laying out");
            self.layout(&cover, &surface, &name, common)?
        } else {
            None
        };
        let orientation = map.orientation();
        let root = trees.components()[self.component].root();
        let below = map.surfaces()[orientation.component(root)].to_string();
        let letters: Vec<[u32; 2]> =
            cover.letters().into_iter().map(|edge| surface.edge_numbers(edge)).collect();
        let words: Vec<Vec<i32>> =
            (0..cover.copy_count()).map(|copy| cover.copy_word(copy).letters().to_vec()).collect();
        let plane = layout.as_ref().map(|(plane, _)| match plane {
            CoverPlane::Flat => "flat",
            CoverPlane::Hyperbolic => "disk",
            _ => "other",
        });
        let object = json!({
            "file": name,
            "component": self.component,
            "components": trees.components().len(),
            "surface": below,
            "group": cover.group().name().to_string(),
            "copies": cover.copy_count(),
            "complete": cover.is_complete(),
            "spheres": cover.sphere_sizes(),
            "f_vector": cover.f_vector(),
            "euler_characteristic": cover.euler_characteristic(),
            "letters": letters,
            "words": words,
            "layout": plane,
        });
        if let Some(path) = &common.output {
            progress.stage(format!("writing {}", path.display()));
            let model = model(&surface, &cover, layout.map(|(_, points)| points))?;
            surface::save(path, &model, &object, common)?;
        }
        drop(progress);
        answer(common, &object, || page(&name, &object, &cover))
    }

    /// The plane and the positions of a layout, if there is one and it is wanted.
    fn layout(
        &self,
        cover: &UniversalCover,
        surface: &SurfaceModel,
        name: &str,
        common: &Common,
    ) -> Result<Option<(CoverPlane, Positions)>, Failure> {
        if self.layout == Layout::None {
            return Ok(None);
        }
        let found = match cover.layout(surface.map(), None) {
            Ok(found) => found,
            Err(error) if self.layout == Layout::Auto => {
                if !common.quiet {
                    remark(&format!("the mesh lies over the surface: {}", error.message()));
                }
                return Ok(None);
            }
            Err(error) => return Err(error.in_file(name.to_owned()).into()),
        };
        let is_wanted = match self.layout {
            Layout::Flat => found.plane() == CoverPlane::Flat,
            Layout::Disk => found.plane() == CoverPlane::Hyperbolic,
            Layout::Auto | Layout::None => true,
        };
        if !is_wanted {
            let other = if self.layout == Layout::Flat { "disk" } else { "flat" };
            return Err(Failure::new(format!(
                "{name}: the cover has no such layout, because of its Euler characteristic; take --layout {other}"
            )));
        }
        let coordinates = found.points().iter().flat_map(|&[x, y]| [x, y, 0.0]).collect();
        Ok(Some((found.plane(), Positions::from_flat(3, coordinates)?)))
    }

    fn double_cover(
        &self,
        name: &str,
        surface: &SurfaceModel,
        common: &Common,
        progress: Progress,
    ) -> Result<(), Failure> {
        progress.stage("covering");
        let cover = surface.map().orientation_double_cover();
        let map = cover.map();
        let [v, e, f] = map.f_vector();
        let surfaces = |map: &coface::surface::GeneralizedMap| -> Vec<String> {
            map.surfaces().iter().map(ToString::to_string).collect()
        };
        let [below, above] = [surfaces(surface.map()), surfaces(map)];
        let object = json!({
            "file": name,
            "copies": 2,
            "surfaces_below": below,
            "surfaces": above,
            "f_vector": [v, e, f],
            "euler_characteristic": v as i64 - e as i64 + f as i64,
        });
        if let Some(path) = &common.output {
            progress.stage(format!("writing {}", path.display()));
            let faces: Vec<FaceId> = (0..f).map(FaceId::new).collect();
            let polygons =
                RaggedArray::from_lists(faces.iter().map(|&face| {
                    map.sides_of(face).map(|side| map.source(side).to_u32()).collect::<Vec<_>>()
                }));
            let vertices: Vec<VertexId> =
                (0..v).map(|vertex| cover.vertex_below(VertexId::new(vertex))).collect();
            let below: Vec<FaceId> = faces.iter().map(|&face| cover.face_below(face).0).collect();
            let sheet = |count: usize| (0..count as i64).map(|cell| cell % 2).collect();
            let model = surface
                .model_over(polygons, &vertices, &below, None)?
                .with_data(CellData::integers("copy", GroupKind::Vertices, 1, sheet(v))?)?
                .with_data(CellData::integers("copy", GroupKind::Polygons, 1, sheet(f))?)?;
            surface::save(path, &model, &object, common)?;
        }
        drop(progress);
        answer(common, &object, || {
            let fact = |label: &str, value: String, gloss: &str| (label.to_owned(), value, gloss.to_owned());
            let facts = [
                fact("surface", names(&below), ""),
                fact("cover", names(&above), "each face twice, once for each side"),
                fact("cells", counts([v, e, f]), ""),
            ];
            text::facts(&format!("orientation double cover of {name}"), &facts)
        })
    }
}

/// The answer on standard output; -o has the mesh.
fn answer(common: &Common, object: &Value, page: impl FnOnce() -> String) -> Result<(), Failure> {
    match (common.json, &common.output) {
        (true, _) => print_json(object),
        (false, Some(_)) if common.quiet => Ok(()),
        (false, _) => print_text(&page()),
    }
}

/// The cover as a mesh with its projection and copies as data.
fn model(
    surface: &SurfaceModel,
    cover: &UniversalCover,
    positions: Option<Positions>,
) -> Result<Model, Error> {
    let [vertex_count, _, face_count] = cover.f_vector();
    let vertices = || (0..vertex_count).map(VertexId::new);
    let faces = || (0..face_count).map(FaceId::new);
    let vertex_sources: Vec<VertexId> = vertices().map(|vertex| cover.vertex_below(vertex)).collect();
    let face_sources: Vec<FaceId> = faces().map(|face| cover.face_below(face)).collect();
    let data = |name: &str, kind, values: Vec<i64>| CellData::integers(name, kind, 1, values);
    let copy_lengths: Vec<i64> =
        (0..cover.copy_count()).map(|copy| cover.copies().length(copy) as i64).collect();
    let lengths = faces().map(|face| copy_lengths[cover.face_copy(face)]).collect();
    surface
        .model_over(cover.polygons(), &vertex_sources, &face_sources, positions)?
        .with_data(data(
            "copy",
            GroupKind::Vertices,
            vertices().map(|vertex| cover.vertex_copy(vertex) as i64).collect(),
        )?)?
        .with_data(data(
            "copy",
            GroupKind::Polygons,
            faces().map(|face| cover.face_copy(face) as i64).collect(),
        )?)?
        .with_data(data("length", GroupKind::Polygons, lengths)?)
}

/// The names of components, not too many.
fn names(all: &[String]) -> String {
    let (few, more) = surface::few(all.len());
    match (few, more) {
        (0, _) => "none".to_owned(),
        (_, 0) => all.join(", "),
        _ => format!("{} and {more} more", all[..few].join(", ")),
    }
}

fn counts([v, e, f]: [usize; 3]) -> String {
    format!("{}, {}, {}", text::count(v, "vertex"), text::count(e, "edge"), text::count(f, "face"))
}

fn page(name: &str, object: &Value, cover: &UniversalCover) -> String {
    let mut facts = Vec::new();
    let mut fact = |label: &str, value: String, gloss: &str| {
        facts.push((label.to_owned(), value, gloss.to_owned()));
    };
    let component = match (object["component"].as_u64(), object["components"].as_u64()) {
        (Some(i), Some(count)) if count > 1 => format!("component {i} of 0 to {}", count - 1),
        _ => String::new(),
    };
    fact("surface", object["surface"].as_str().unwrap_or_default().to_owned(), &component);
    fact("group", object["group"].as_str().unwrap_or_default().to_owned(), "of deck transformations");
    let whole = if cover.is_complete() { "the whole cover" } else { "part of the cover" };
    fact("copies", cover.copy_count().to_string(), whole);
    let spheres = cover.sphere_sizes();
    let (few, more) = surface::few(spheres.len());
    let mut sizes: Vec<String> = spheres.iter().take(few).map(ToString::to_string).collect();
    if more > 0 {
        sizes.push("..".to_owned());
    }
    fact("spheres", sizes.join(", "), "copies at distance 0, 1, ..");
    fact("cells", counts(cover.f_vector()), "");
    let disk = match cover.euler_characteristic() {
        1 => "a disk",
        2 => "a sphere",
        _ => "",
    };
    fact("Euler char.", cover.euler_characteristic().to_string(), disk);
    for copy in 1..cover.copy_count().min(5) {
        let word = cover.copy_word(copy).to_string();
        fact(if copy == 1 { "words" } else { "" }, format!("copy {copy}: {word}"), "");
    }
    text::facts(&format!("universal cover of {name}"), &facts)
}
