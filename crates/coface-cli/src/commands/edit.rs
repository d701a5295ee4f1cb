//! `coface edit`: local changes of a surface, with a log that undoes them.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::input;
use crate::output::{print_json, print_text, write_json};
use crate::progress::Progress;
use crate::remarks::{accept, say_remarks};
use crate::target::write_model;
use clap::parser::ValueSource;
use clap::{Arg, ArgAction, ArgMatches, Args, Command, FromArgMatches};
use coface::Error;
use coface::answers::answer::{EditAnswer, Remark, RemarkCode};
use coface::answers::{CellName, Edit, EditLog, SurfaceEditor, text};
use std::path::{Path, PathBuf};

/// Edit a surface step by step: flip, split and collapse edges, poke faces; each edit can be undone.
///
/// Edits are done in the order in which they stand. Edges and halfedges are named by their numbers, or by the vertices that they go from
/// and to: --flip 7, --flip "3 5". Edge e has the halfedges 2e and 2e + 1. What is added gets the last number of its kind; where a
/// cell is removed, the last of its kind gets its number. Polygons stay polygons; halfedges are written as halfedges.
///
/// --log keeps what was done, each edit with its inverse, and what the surface was before; --undo takes such a log back.
#[derive(Args)]
pub(crate) struct EditSurface {
    /// The surface: polygons whose faces agree, or halfedges; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    #[command(flatten)]
    edits: Edits,
    /// Write what was done to this file, as JSON; edits of a log that is there already stay in it
    #[arg(long, value_name = "FILE")]
    log: Option<PathBuf>,
    /// Undo the edits of this log first; INPUT must be the surface that it leads to
    #[arg(long, value_name = "LOG")]
    undo: Option<PathBuf>,
    /// With --undo: how many of the last edits are undone [default: all]
    #[arg(long, value_name = "N", requires = "undo")]
    steps: Option<usize>,
}

/// The edits in the order of the command line.
struct Edits(Vec<Edit>);

/// The options, their values and what they do.
const OPTIONS: [(&str, &str, &str); 11] = [
    (
        "flip",
        "EDGE",
        "Turn an edge by one corner counterclockwise: between two triangles, the other diagonal",
    ),
    ("flip-back", "EDGE", "Turn an edge by one corner clockwise"),
    ("split", "EDGE", "Put a vertex in the middle of an edge"),
    ("remove-vertex", "VERTEX", "Remove a vertex with exactly two edges, which become one"),
    (
        "split-face",
        "FROM:TO",
        "Split a face by an edge between the sources of two of its halfedges: --split-face \"0 1:2 3\"",
    ),
    ("remove-edge", "EDGE", "Remove an edge between two faces, which become one"),
    (
        "split-vertex",
        "FROM:TO",
        "Draw a vertex out to an edge, between the corners of two halfedges that leave it",
    ),
    ("contract", "EDGE", "Contract an edge to a vertex: its faces lose a side each"),
    ("remove-pendant", "EDGE", "Remove an edge with an end where no other edge is"),
    (
        "collapse",
        "EDGE",
        "Collapse an edge and the triangles beside it, where the mesh stays a simplicial complex",
    ),
    ("poke", "FACE", "Put a vertex inside a face and join it to each corner"),
];

impl Edits {
    fn edit(option: &str, value: &str) -> Result<Edit, Error> {
        let number = |what: &str| {
            value.trim_start_matches(['v', 'f']).parse::<usize>().map_err(|_| {
                Error::invalid(format!("{value:?} is no number of a {what}")).with_cure("write 7")
            })
        };
        let edge = || value.parse::<CellName>();
        let pair = || match value.split_once(':') {
            Some((from, to)) => Ok((from.parse::<CellName>()?, to.parse::<CellName>()?)),
            None => Err(Error::invalid(format!("{value:?} has no colon between two halfedges"))
                .with_cure("write 4:9, or \"0 1:2 3\"")),
        };
        Ok(match option {
            "flip" => Edit::FlipEdge { edge: edge()? },
            "flip-back" => Edit::FlipEdgeBack { edge: edge()? },
            "split" => Edit::SplitEdge { edge: edge()? },
            "remove-vertex" => Edit::RemoveVertex { vertex: number("vertex")? },
            "split-face" => pair().map(|(from, to)| Edit::SplitFace { from, to })?,
            "remove-edge" => Edit::RemoveEdge { edge: edge()? },
            "split-vertex" => pair().map(|(from, to)| Edit::SplitVertex { from, to })?,
            "contract" => Edit::ContractEdge { edge: edge()? },
            "remove-pendant" => Edit::RemovePendantEdge { edge: edge()? },
            "collapse" => Edit::CollapseEdge { edge: edge()? },
            _ => Edit::PokeFace { face: number("face")? },
        })
    }
}

impl FromArgMatches for Edits {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let mut found: Vec<(usize, Edit)> = Vec::new();
        for (option, ..) in OPTIONS {
            if matches.value_source(option) != Some(ValueSource::CommandLine) {
                continue;
            }
            let places = matches.indices_of(option).into_iter().flatten();
            let values = matches.get_many::<String>(option).into_iter().flatten();
            for (place, value) in places.zip(values) {
                let edit = Self::edit(option, value).map_err(|error| {
                    clap::Error::raw(clap::error::ErrorKind::InvalidValue, format!("--{option}: {error}\n"))
                })?;
                found.push((place, edit));
            }
        }
        found.sort_by_key(|&(place, _)| place);
        Ok(Self(found.into_iter().map(|(_, edit)| edit).collect()))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

impl Args for Edits {
    fn augment_args(command: Command) -> Command {
        OPTIONS.into_iter().fold(command, |command, (option, value, help)| {
            command.arg(Arg::new(option).long(option).value_name(value).help(help).action(ArgAction::Append))
        })
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl EditSurface {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let progress = Progress::start(common.quiet);
        let loaded = input::read(&self.input, common.reading(), &progress)?;
        let name = loaded.name.clone();
        let in_file = |error: Error| error.in_file(name.clone());
        progress.stage("identifying cells");
        let lost = loaded.model.groups().len() + loaded.model.data().len();
        let mut remarks = Vec::new();
        if lost > 0 {
            let message = format!("{name}: groups and data on cells do not follow edits: {lost} left out");
            remarks.push(Remark::new(RemarkCode::FormatKeepsLess, message).at(lost, []));
        }
        accept(&remarks, common)?;
        say_remarks(&remarks, common);
        let mut editor = SurfaceEditor::new(loaded.model).map_err(in_file)?;
        let mut undone = 0;
        let earlier = match (&self.undo, &self.log) {
            (Some(path), _) => Some(path),
            (None, Some(path)) if path.exists() => Some(path),
            _ => None,
        };
        if let Some(path) = earlier {
            let whole = SurfaceEditor::of_log(read_log(path)?)
                .map_err(|error| error.in_file(path.display().to_string()))?;
            if whole.model().map_err(in_file)? != editor.model().map_err(in_file)? {
                return Err(Failure::new(format!(
                    "{name}: this is not the surface that the edits of {} lead to; give the one that was written with that log",
                    path.display()
                )));
            }
            editor = whole;
        }
        if self.undo.is_some() {
            undone = self.steps.unwrap_or(editor.records().len());
            editor.undo(undone).map_err(in_file)?;
        }
        let kept = editor.records().len();
        progress.stage("editing");
        for edit in &self.edits.0 {
            editor.apply(edit).map_err(in_file)?;
        }
        let mesh = editor.mesh();
        let [vertices, edges, faces] = mesh.f_vector()[..] else {
            return Err(Failure::new(format!("{name}: the surface has no cells")));
        };
        let answer = EditAnswer {
            file: name.clone(),
            undone,
            edits: editor.records()[kept..].to_vec(),
            f_vector: [vertices, edges, faces],
            remarks,
        };
        if let Some(path) = &common.output {
            progress.stage(format!("writing {}", path.display()));
            let model = editor.model().map_err(in_file)?;
            write_model(path, &model)?;
        }
        if let Some(path) = &self.log {
            write_json(path, &editor.log())?;
        }
        drop(progress);
        match (common.json, &common.output) {
            (true, _) => print_json(&answer),
            (false, Some(_)) if common.quiet => Ok(()),
            (false, _) => print_text(&page(&answer)),
        }
    }
}

fn read_log(path: &Path) -> Result<EditLog, Failure> {
    let place = path.display();
    let text = std::fs::read_to_string(path)
        .map_err(|error| Failure::new(format!("{place}: cannot be read: {error}")))?;
    serde_json::from_str(&text).map_err(|error| {
        Failure::new(format!("{place}:{}: {error}; give a log that coface edit --log wrote", error.line()))
    })
}

fn page(answer: &EditAnswer) -> String {
    let mut facts = Vec::new();
    if answer.undone > 0 {
        facts.push(("undone".to_owned(), text::count(answer.undone, "edit"), String::new()));
    }
    for (i, record) in answer.edits.iter().enumerate() {
        let added = record.added_vertex.map(|vertex| format!("adds vertex {vertex}"));
        let kept = record.kept_vertex.map(|vertex| format!("leaves vertex {vertex}"));
        let label = if i == 0 { "edits" } else { "" };
        facts.push((label.to_owned(), words(&record.edit), added.or(kept).unwrap_or_default()));
    }
    let [v, e, f] = answer.f_vector;
    let cells =
        format!("{}, {}, {}", text::count(v, "vertex"), text::count(e, "edge"), text::count(f, "face"));
    facts.push(("cells".to_owned(), cells, String::new()));
    text::facts(&format!("{} edited", answer.file), &facts)
}

fn words(edit: &Edit) -> String {
    match edit {
        Edit::FlipEdge { edge } => format!("flip {edge}"),
        Edit::FlipEdgeBack { edge } => format!("flip back {edge}"),
        Edit::SplitEdge { edge } => format!("split {edge}"),
        Edit::RemoveVertex { vertex } => format!("remove vertex {vertex}"),
        Edit::SplitFace { from, to } => format!("split the face from {from} to {to}"),
        Edit::RemoveEdge { edge } => format!("remove edge {edge}"),
        Edit::SplitVertex { from, to } => format!("split the vertex from {from} to {to}"),
        Edit::ContractEdge { edge } => format!("contract {edge}"),
        Edit::RemovePendantEdge { edge } => format!("remove pendant edge {edge}"),
        Edit::CollapseEdge { edge } => format!("collapse {edge}"),
        Edit::PokeFace { face } => format!("poke face {face}"),
    }
}
