//! What a result is written as: a model, or what is seen of it.

use crate::failure::Failure;
use crate::output::write_file;
use coface::io::{Format, Model};
use coface::pictures::{GltfForm, Picture, PictureStyle, Scene, gltf};
use std::path::Path;

/// What a file is, by its extension.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Target {
    Model(Format),
    Seen(Seen),
}

/// Files that show a model.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Seen {
    Glb,
    Gltf,
    Png,
    Svg,
}

impl Target {
    /// The target of a file of this name.
    pub(crate) fn of_path(path: &Path) -> Result<Self, Failure> {
        let extension = path.extension().map(|extension| extension.to_ascii_lowercase());
        Ok(match extension.as_deref().and_then(|extension| extension.to_str()) {
            Some("glb") => Self::Seen(Seen::Glb),
            Some("gltf") => Self::Seen(Seen::Gltf),
            Some("png") => Self::Seen(Seen::Png),
            _ => Self::Model(Format::from_path(path).ok_or_else(|| unknown_extension(path, SEEN))?),
        })
    }

    /// The format, or none where a mesh is asked for that is only looked at.
    pub(crate) fn format(self) -> Option<Format> {
        match self {
            Self::Model(format) => Some(format),
            Self::Seen(_) => None,
        }
    }
}

const SEEN: &str = ", glb, gltf, png";

/// The file has an extension that nothing is written by; `more` are those beyond the formats of models.
pub(crate) fn unknown_extension(path: &Path, more: &str) -> Failure {
    let names: Vec<&str> =
        Format::ALL.into_iter().filter(|format| !format.is_read_only()).map(Format::name).collect();
    let names = names.join(", ");
    let fault = match path.extension() {
        Some(extension) => format!("the extension \"{}\" is no format known here", extension.display()),
        None => "the name has no extension, which tells the format".to_owned(),
    };
    Failure::new(format!("{}: {fault}; end it in one of {names}{more}", path.display()))
}

/// Refuses a file whose extension is no format, before the work whose result it is to hold; a name without an extension is JSON.
pub(crate) fn check_extension(path: &Path) -> Result<(), Failure> {
    match path.extension() {
        Some(_) if Format::from_path(path).is_none() => Err(unknown_extension(path, "")),
        _ => Ok(()),
    }
}

/// Writes what is seen of a model.
pub(crate) fn write_seen(path: &Path, model: &Model, seen: Seen) -> Result<(), Failure> {
    let title = path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    let scene = Scene::of(&title, model)?;
    let picture = || Picture::new(&scene, &PictureStyle::default());
    let bytes = match seen {
        Seen::Glb => gltf(&scene, None, GltfForm::Binary)?,
        Seen::Gltf => gltf(&scene, None, GltfForm::Json)?,
        Seen::Png => picture()?.png()?,
        Seen::Svg => picture()?.svg().into_bytes(),
    };
    write_file(path, &bytes)
}
