//! Scenes: nested lists of shapes, files and affine maps, as JSON.

use super::member::{Member, command_of};
use crate::arguments::Common;
use crate::failure::Failure;
use crate::input;
use crate::progress::Progress;
use clap::{Command, FromArgMatches};
use coface::complexes::families::{Family, FamilyModel};
use coface::complexes::shapes::{Assembly, PlacedCells};
use coface::geometry::{AffineMap, Angle};
use coface::io::Model;
use coface::{Error, ErrorKind};
use serde_json::{Map, Value};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The keys that an item of a scene may have first.
const KEYS: &str = "translate, rotate, scale, matrix, shape, file, or a list inside the list";

/// Reads a scene and puts everything in its place.
pub(super) fn assemble(path: &Path, common: &Common, progress: &Progress) -> Result<Model, Failure> {
    let name = input::name(path);
    let in_scene = |error: Error| Failure::from(error.in_file(name.clone()));
    let value = parse(path).map_err(in_scene)?;
    let folder = path.parent().map(Path::to_path_buf).unwrap_or_default();
    let (dimension, items) = items(&value).map_err(in_scene)?;
    let mut reading = Reading {
        dimension,
        scene: path,
        folder,
        common,
        progress,
        files: BTreeMap::new(),
        path: Vec::new(),
    };
    let assembly = reading.list(items).map_err(in_scene)?;
    let flat = assembly.flatten().map_err(in_scene)?;
    Model::from_assembly(&flat).map_err(in_scene)
}

fn parse(path: &Path) -> Result<Value, Error> {
    let text = if path.as_os_str() == "-" {
        std::io::read_to_string(std::io::stdin().lock())?
    } else {
        std::fs::read_to_string(path).map_err(|error| {
            Error::new(ErrorKind::Io, format!("the scene cannot be read: {error}"))
                .with_cure("check the path; a scene is text")
        })?
    };
    serde_json::from_str(&text)
        .map_err(|error| Error::parse(format!("this is no JSON: {error}")).at_line(error.line() as u64))
}

/// The dimension of the space and the outermost list: `{"dimension": 3, "assembly": [..]}`, or the bare list.
fn items(scene: &Value) -> Result<(usize, &[Value]), Error> {
    if let Value::Array(items) = scene {
        return Ok((3, items));
    }
    let Some(Value::Array(items)) = scene.get("assembly") else {
        return Err(Error::parse("a scene is a list of items")
            .with_cure(r#"write {"assembly": [..]}, with "dimension" beside it for other spaces than that of dimension 3"#));
    };
    let dimension = match scene.get("dimension") {
        None => 3,
        Some(value) => match value.as_u64() {
            Some(dimension @ 1..=16) => dimension as usize,
            _ => {
                return Err(
                    Error::invalid(format!("{value} is no dimension of a space")).with_cure("take 1 to 16")
                );
            }
        },
    };
    let object = scene.as_object().into_iter().flatten();
    if let Some((key, _)) =
        object.into_iter().find(|(key, _)| !matches!(key.as_str(), "assembly" | "dimension"))
    {
        return Err(Error::invalid(format!("a scene has no key {key:?}"))
            .with_cure("use \"assembly\" and \"dimension\" only"));
    }
    Ok((dimension, items))
}

/// What is needed while a scene is read.
struct Reading<'a> {
    dimension: usize,
    scene: &'a Path,
    folder: PathBuf,
    common: &'a Common,
    progress: &'a Progress,
    /// Files are read once however often they are named.
    files: BTreeMap<PathBuf, Vec<Arc<PlacedCells>>>,
    /// Where the item stands that is read.
    path: Vec<usize>,
}

impl Reading<'_> {
    fn list(&mut self, items: &[Value]) -> Result<Assembly, Error> {
        let mut assembly = Assembly::new();
        for (i, item) in items.iter().enumerate() {
            self.path.push(i);
            self.item(item, &mut assembly)?;
            self.path.pop();
        }
        Ok(assembly)
    }

    fn item(&mut self, item: &Value, assembly: &mut Assembly) -> Result<(), Error> {
        let object = match item {
            Value::Array(items) => {
                let list = self.list(items)?;
                assembly.push_assembly(Arc::new(list));
                return Ok(());
            }
            Value::Object(object) => object,
            other => return Err(self.here(&fault(format!("{other} is no item of a scene"), KEYS))),
        };
        if object.contains_key("shape") {
            let cells = self.shape(object).map_err(|error| self.here(&error))?;
            assembly.push_cells(Arc::new(cells));
            return Ok(());
        }
        let mut entries = object.iter();
        let (Some((key, value)), None) = (entries.next(), entries.next()) else {
            let message = format!("an item has one key, this one {}", object.len());
            return Err(self.here(&fault(message, KEYS)));
        };
        if let ("assembly", Value::Array(items)) = (key.as_str(), value) {
            let list = self.list(items)?;
            assembly.push_assembly(Arc::new(list));
            return Ok(());
        }
        if key == "file" {
            let parts = self.file(value).map_err(|error| self.here(&error))?;
            return assembly.push_mixed_cells(parts).map_err(|error| self.here(&error));
        }
        let map = self.map(key, value).map_err(|error| self.here(&error))?;
        if map.determinant_sign().is_none() {
            let error = fault("the map flattens the space".to_owned(), "a map that can be undone");
            return Err(self.here(&error));
        }
        assembly.push_map(map);
        Ok(())
    }

    /// The error with the place of the item.
    fn here(&self, error: &Error) -> Error {
        let place: Vec<String> = self.path.iter().map(ToString::to_string).collect();
        let file = error.file().map_or_else(String::new, |file| format!("{file}: "));
        let named = Error::new(error.kind(), format!("item {}: {file}{}", place.join("."), error.message()));
        match error.cure() {
            Some(cure) => named.with_cure(cure),
            None => named,
        }
    }

    fn map(&self, key: &str, value: &Value) -> Result<AffineMap, Error> {
        let d = self.dimension;
        match key {
            "translate" => AffineMap::translation(&numbers(value, d)?),
            "scale" => AffineMap::scaling(&numbers(value, d)?),
            "rotate" => rotation(d, value),
            "matrix" => matrix(d, value),
            _ => Err(fault(format!("no item of a scene has the key {key:?}"), KEYS)),
        }
    }

    /// A shape with its parameters, which are those of the command line.
    fn shape(&self, object: &Map<String, Value>) -> Result<PlacedCells, Error> {
        let Some(Value::String(name)) = object.get("shape") else {
            return Err(fault("a shape has a name in quotes".to_owned(), "\"sphere\", for instance"));
        };
        let mut words = vec!["scene".to_owned(), name.clone()];
        for (key, value) in object.iter().filter(|(key, _)| *key != "shape") {
            let option = format!("--{}", key.replace('_', "-"));
            match value {
                Value::Bool(true) => words.push(option),
                Value::Bool(false) => {}
                Value::Array(list) => {
                    let list: Vec<String> = list.iter().map(Value::to_string).collect();
                    words.push(format!("{option}={}", list.join(",")));
                }
                Value::String(text) => words.push(format!("{option}={text}")),
                other => words.push(format!("{option}={other}")),
            }
        }
        let shapes = Family::all().filter(|family| family.has_positions()).map(command_of);
        let command = Command::new("scene").subcommands(shapes).subcommand_required(true);
        let shape = command
            .disable_help_flag(true)
            .disable_help_subcommand(true)
            .try_get_matches_from(words)
            .and_then(|matches| Member::from_arg_matches(&matches))
            .map_err(|error| {
                let text = error.render().to_string();
                let first = text.lines().next().unwrap_or_default();
                let message = first.strip_prefix("error: ").unwrap_or(first);
                fault(
                    format!("the shape {name:?}: {message}"),
                    &format!("parameters that `coface generate {name} --help` lists"),
                )
            })?;
        match shape.make()? {
            FamilyModel::Cells(cells) => self.embedded(cells),
            FamilyModel::Complex(_) => {
                Err(fault(format!("{name:?} has no positions"), "a shape with positions"))
            }
        }
    }

    fn file(&mut self, value: &Value) -> Result<Vec<Arc<PlacedCells>>, Error> {
        let Some(name) = value.as_str() else {
            return Err(fault(format!("{value} is no name of a file"), "a name in quotes"));
        };
        let path = self.folder.join(name);
        if let Some(parts) = self.files.get(&path) {
            return Ok(parts.clone());
        }
        self.progress.stage(format!("reading {}", path.display()));
        let model = coface::io::read_companion(self.scene, name, &self.common.reading())?;
        crate::remarks::take(&path.display().to_string(), model.remarks());
        let parts = model.placed_cells().map_err(|error| error.in_file(path.display().to_string()))?;
        let parts: Vec<Arc<PlacedCells>> =
            parts.into_iter().map(|cells| self.embedded(cells).map(Arc::new)).collect::<Result<_, _>>()?;
        self.files.insert(path, parts.clone());
        Ok(parts)
    }

    /// Cells of a lower dimension lie in the first axes.
    fn embedded(&self, cells: PlacedCells) -> Result<PlacedCells, Error> {
        let old = cells.positions().dimension();
        cells.embedded(self.dimension).map_err(|_| {
            let message = format!("positions of dimension {old} in a scene of dimension {}", self.dimension);
            Error::new(ErrorKind::Shape, message).with_cure(format!("give the scene \"dimension\": {old}"))
        })
    }
}

fn fault(message: String, cure: &str) -> Error {
    Error::invalid(message).with_cure(format!("give {cure}"))
}

/// So many numbers in a list.
fn numbers(value: &Value, count: usize) -> Result<Vec<f64>, Error> {
    let list: Option<Vec<f64>> = value.as_array().and_then(|list| list.iter().map(Value::as_f64).collect());
    list.filter(|list| list.len() == count).ok_or_else(|| {
        fault(format!("{value} is no list of {count} numbers"), "one number for each axis of the scene")
    })
}

fn rotation(dimension: usize, value: &Value) -> Result<AffineMap, Error> {
    const CURE: &str = "{\"axis\": [x, y, z], \"degrees\": a} or {\"plane\": [i, j], \"degrees\": a}";
    let wrong = || fault(format!("{value} is no rotation"), CURE);
    let object = value.as_object().filter(|object| object.len() == 2).ok_or_else(wrong)?;
    let degrees = object.get("degrees").and_then(Value::as_f64).ok_or_else(wrong)?;
    let angle = Angle::degrees(degrees)?;
    if let Some(plane) = object.get("plane") {
        let axes: Option<Vec<u64>> =
            plane.as_array().and_then(|list| list.iter().map(Value::as_u64).collect());
        let &[i, j] = axes.as_deref().ok_or_else(wrong)? else { return Err(wrong()) };
        return AffineMap::rotation(
            dimension,
            [i, j].map(|axis| usize::try_from(axis).unwrap_or(usize::MAX)),
            angle,
        );
    }
    let axis = numbers(object.get("axis").ok_or_else(wrong)?, 3)?;
    if dimension != 3 {
        return Err(fault(
            format!("a rotation about an axis in a scene of dimension {dimension}"),
            "a plane of rotation",
        ));
    }
    AffineMap::rotation_about([axis[0], axis[1], axis[2]], angle)
}

/// d rows of d numbers, d rows with the offset as last column, or these with a last row 0 .. 0 1.
fn matrix(dimension: usize, value: &Value) -> Result<AffineMap, Error> {
    let d = dimension;
    let wrong = || {
        let message = format!("this is no matrix of an affine map of dimension {d}");
        fault(message, &format!("{d} rows of {d} numbers, or of {} with the offset last", d + 1))
    };
    let rows = value.as_array().ok_or_else(wrong)?;
    let width = rows.first().and_then(Value::as_array).map(Vec::len).ok_or_else(wrong)?;
    if width != d && width != d + 1 {
        return Err(wrong());
    }
    let rows: Vec<Vec<f64>> =
        rows.iter().map(|row| numbers(row, width)).collect::<Result<_, _>>().map_err(|_| wrong())?;
    let is_last = |row: &[f64]| row.iter().enumerate().all(|(k, &x)| x == f64::from(u8::from(k == d)));
    let rows = match rows.split_last() {
        Some((last, rows)) if rows.len() == d && width == d + 1 && is_last(last) => rows,
        _ => &rows,
    };
    if rows.len() != d {
        return Err(wrong());
    }
    let offset = rows.iter().map(|row| row.get(d).copied().unwrap_or(0.0)).collect();
    AffineMap::new(rows.iter().flat_map(|row| row[..d].to_vec()).collect(), offset)
}
