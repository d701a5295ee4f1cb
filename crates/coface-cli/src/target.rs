//! What a result is written as: a model, or what is seen of it.

use crate::failure::Failure;
use crate::output::write_file;
use crate::remarks;
use coface::io::{Format, Model, RemarkCode, losses, never_written, write_path};
use coface::pictures::{GltfForm, Picture, PictureStyle, Scene, gltf, gltf_rounding};
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
            _ => Self::Model(written_format(path, SEEN)?),
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

/// The format in which a model is written to this file; `more` are the extensions beyond those of models.
pub(crate) fn written_format(path: &Path, more: &str) -> Result<Format, Failure> {
    let format = Format::from_path(path).ok_or_else(|| unknown_extension(path, more))?;
    match never_written(format) {
        None => Ok(format),
        Some(error) => Err(error.in_file(path.display().to_string()).into()),
    }
}

/// Refuses a file whose extension is no format in which models are written, before the work whose result it is to hold; a name without an
/// extension is JSON.
pub(crate) fn check_extension(path: &Path) -> Result<(), Failure> {
    match path.extension() {
        Some(_) => written_format(path, "").map(drop),
        None => Ok(()),
    }
}

/// Writes a model in the format of the name, and says how far that rounds positions.
pub(crate) fn write_model(path: &Path, model: &Model) -> Result<(), Failure> {
    write_path(model, path, None)?;
    take_rounding(path, model);
    Ok(())
}

/// Notes how far a file of this name rounds the positions of a model.
pub(crate) fn take_rounding(path: &Path, model: &Model) {
    let mut lost = Format::from_path(path).map_or_else(Vec::new, |format| losses(model, format));
    lost.retain(|lost| matches!(lost.code, RemarkCode::NumbersRounded | RemarkCode::RoundedInvalid));
    remarks::take(&path.display().to_string(), &lost);
}

/// Writes what is seen of a model, and says how far that rounds positions.
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
    write_file(path, &bytes)?;
    if matches!(seen, Seen::Glb | Seen::Gltf) {
        remarks::take(&path.display().to_string(), gltf_rounding(&scene).as_slice());
    }
    Ok(())
}
