//! `coface cover`: universal covers of surfaces, and orientation double covers.

use crate::arguments::Common;
use crate::certified;
use crate::failure::Failure;
use crate::output::{print_json, print_text};
use crate::progress::Progress;
use crate::remarks::{accept, say_remarks};
use crate::surface;
use clap::{ArgGroup, Args, ValueEnum};
use coface::Error;
use coface::answers::answer::{CoverAnswer, Remark, RemarkCode};
use coface::answers::text;
use coface::answers::{LayoutChoice, SurfaceModel};
use coface::topology::{CoverExtent, UniversalCover};
use serde::Serialize;
use std::path::PathBuf;

/// The universal cover of a surface, as far as is asked for, or its orientation double cover.
///
/// A universal cover is made of copies of the surface cut to a disk, one for each element of the fundamental group; copies
/// are counted by their distance: how many cuts lie between them and the first one. Whether two copies are the same is
/// decided by normal forms of words, not by looks.
///
/// The mesh written with -o has data: "source" on vertices and "face" on polygons, the numbers in the file of what lies
/// below; "copy" on both, and "length" on polygons, the distance of the copy. It lies in the plane or, by --layout, in the
/// hyperbolic plane, so that copies are congruent: the disk of Poincare keeps angles, and in the disk of Klein straight sides are right.
#[derive(Args)]
#[command(group(ArgGroup::new("extent").required(true).args(["radius", "copies", "orientation"])))]
pub(crate) struct Cover {
    /// The model; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// All copies up to this distance
    #[arg(long, value_name = "N")]
    radius: Option<usize>,
    /// So many copies, the nearest first; all of a finite cover that has fewer
    #[arg(long, value_name = "N")]
    copies: Option<usize>,
    /// The orientation double cover instead: every face twice, so that all agree
    #[arg(long)]
    orientation: bool,
    /// Where the mesh lies: flat (torus, Klein bottle, annulus, Moebius band), disk (of Poincare) or klein (closed, negative Euler
    /// characteristic), none (over the surface); by default flat or disk, what there is
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
    /// A certificate of the cover, which coface check verifies: the way down is a local isomorphism, copies, words, degree of a whole cover; of a facet
    /// list, or a surface as plain OFF or OBJ; in
    /// the binary form if OUT ends in .bin
    #[arg(long, value_name = "OUT", conflicts_with = "boundary")]
    certificate: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Layout {
    Auto,
    Flat,
    Disk,
    Klein,
    None,
}

impl Cover {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        if let Some(place) = &self.certificate {
            certified::check_place(place, std::slice::from_ref(&self.input), "cover", common)?;
        }
        let progress = Progress::start(common.quiet);
        let (name, surface) = surface::read(&self.input, self.boundary, common, &progress)?;
        if self.orientation {
            return self.double_cover(&name, &surface, common, progress);
        }
        let in_file = |error: Error| error.in_file(name.clone());
        let extent = match (self.radius, self.copies) {
            (Some(radius), _) => CoverExtent::Radius(radius),
            (None, copies) => CoverExtent::Copies(copies.unwrap_or(1)),
        };
        let cover = surface.cover(self.component, extent, self.most_cells).map_err(in_file)?;
        self.certify(&progress, |inputs| cover.certificate(inputs))?;
        let choice = match self.layout {
            Layout::None => None,
            Layout::Auto => common.output.is_some().then_some(LayoutChoice::Any),
            Layout::Flat => Some(LayoutChoice::Flat),
            Layout::Disk => Some(LayoutChoice::Disk),
            Layout::Klein => Some(LayoutChoice::Klein),
        };
        let mut remarks = Vec::new();
        let placed = match choice.map(|choice| cover.placed(choice)).transpose() {
            Err(error) if self.layout == Layout::Auto => {
                let message = format!("the mesh lies over the surface: {}", error.message());
                remarks.push(Remark::new(RemarkCode::LayoutReplaced, message));
                None
            }
            placed => placed.map_err(in_file)?,
        };
        accept(&remarks, common)?;
        say_remarks(&remarks, common);
        let mut object = cover.answer(placed.as_ref());
        object.file = Some(name.clone());
        object.remarks = remarks;
        if let Some(path) = &common.output {
            progress.stage(format!("writing {}", path.display()));
            surface::save(path, &cover.model(placed.as_ref())?, &object, common)?;
        }
        drop(progress);
        answer(common, &object, || page(&name, &object, cover.cover()))
    }

    /// Writes the certificate, if there is to be one.
    fn certify(
        &self,
        progress: &Progress,
        certificate: impl FnOnce(&[(&str, &[u8])]) -> Result<String, Error>,
    ) -> Result<(), Failure> {
        let Some(place) = &self.certificate else { return Ok(()) };
        progress.stage(format!("proving {}", place.display()));
        certified::save(place, std::slice::from_ref(&self.input), certificate)
    }

    fn double_cover(
        &self,
        name: &str,
        surface: &SurfaceModel,
        common: &Common,
        progress: Progress,
    ) -> Result<(), Failure> {
        let (object, model) = surface.double_cover(name)?;
        self.certify(&progress, |inputs| object.certificate(inputs))?;
        if let Some(path) = &common.output {
            progress.stage(format!("writing {}", path.display()));
            surface::save(path, &model, &object, common)?;
        }
        drop(progress);
        answer(common, &object, || {
            let fact = |label: &str, value: String, gloss: &str| (label.to_owned(), value, gloss.to_owned());
            let facts = [
                fact("surface", names(&object.surfaces_below), ""),
                fact("cover", names(&object.surfaces), "each face twice, once for each side"),
                fact("cells", counts(&object.f_vector), ""),
            ];
            text::facts(&format!("orientation double cover of {name}"), &facts)
        })
    }
}

/// The answer on standard output; -o has the mesh.
fn answer(common: &Common, object: &impl Serialize, page: impl FnOnce() -> String) -> Result<(), Failure> {
    match (common.json, &common.output) {
        (true, _) => print_json(object),
        (false, Some(_)) if common.quiet => Ok(()),
        (false, _) => print_text(&page()),
    }
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

fn counts(f_vector: &[usize]) -> String {
    let counts = f_vector.iter().zip(["vertex", "edge", "face"]);
    counts.map(|(&count, cell)| text::count(count, cell)).collect::<Vec<_>>().join(", ")
}

fn page(name: &str, object: &CoverAnswer, cover: &UniversalCover) -> String {
    let mut facts = Vec::new();
    let mut fact = |label: &str, value: String, gloss: &str| {
        facts.push((label.to_owned(), value, gloss.to_owned()));
    };
    let component = match (object.component, object.components) {
        (i, count) if count > 1 => format!("component {i} of 0 to {}", count - 1),
        _ => String::new(),
    };
    fact("surface", object.surface.clone(), &component);
    fact("group", object.group.clone(), "of deck transformations");
    let whole = if cover.is_complete() { "the whole cover" } else { "part of the cover" };
    fact("copies", cover.copy_count().to_string(), whole);
    let spheres = cover.sphere_sizes();
    let (few, more) = surface::few(spheres.len());
    let mut sizes: Vec<String> = spheres.iter().take(few).map(ToString::to_string).collect();
    if more > 0 {
        sizes.push("..".to_owned());
    }
    fact("spheres", sizes.join(", "), "copies at distance 0, 1, ..");
    fact("cells", counts(&object.f_vector), "");
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
