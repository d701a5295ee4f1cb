//! `coface persistence` of volume files.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::input::{self, Source};
use crate::progress::Progress;
use crate::remarks;
use clap::Args;
use coface::answers::{GreyImage, ImageRequest};
use coface::io::{self, Structure, VolumeStream};
use coface::topology::{Coefficients, ImageConstruction};
use std::path::{Path, PathBuf};

/// What is asked of images.
#[derive(Args)]
pub(crate) struct ImageArguments {
    /// Of an image, what voxels are: vertices (v, the V-construction) or top cells (t, the T-construction) [default: t]
    #[arg(long, value_name = "V|T", help_heading = "Images", value_parser = construction)]
    construction: Option<ImageConstruction>,
    /// Of an image, grow by superlevel sets, from high values to low ones
    #[arg(long, help_heading = "Images")]
    superlevel: bool,
    /// Of an image, only the voxels that are not 0 in this volume of the same shape; without it those that are not NaN
    #[arg(long, value_name = "FILE", help_heading = "Images")]
    mask: Option<PathBuf>,
}

fn construction(name: &str) -> Result<ImageConstruction, String> {
    name.parse().map_err(|error: coface::Error| error.to_string())
}

impl ImageArguments {
    /// The option that is given, if one is.
    pub(crate) fn given(&self) -> Option<&'static str> {
        let given = [
            ("--construction", self.construction.is_some()),
            ("--superlevel", self.superlevel),
            ("--mask", self.mask.is_some()),
        ];
        given.into_iter().find(|&(_, is_given)| is_given).map(|(name, _)| name)
    }

    /// What voxels are.
    pub(super) fn construction(&self) -> ImageConstruction {
        self.construction.unwrap_or_default()
    }

    pub(super) fn is_superlevel(&self) -> bool {
        self.superlevel
    }

    pub(super) fn mask(&self) -> Option<&Path> {
        self.mask.as_deref()
    }

    /// A mask that is no volume.
    pub(super) fn no_mask(mask_name: &str) -> Failure {
        Failure::new(format!(
            "{mask_name}: is no volume of voxels; give a mask as .npy, NRRD, NIfTI, MetaImage, PGM or PNG"
        ))
    }

    /// Refuses these options for an input that is no image.
    pub(crate) fn refuse(&self, input: &Path) -> Result<(), Failure> {
        match self.given() {
            None => Ok(()),
            Some(option) => Err(Failure::new(format!(
                "{}: {option} is for the values of a volume; give a volume (.npy, NRRD, NIfTI, MetaImage, PGM, PNG) without a function and without a choice of voxels",
                input::name(input)
            ))),
        }
    }

    /// The image with its name and the question, if the input is a volume.
    pub(crate) fn question(
        &self,
        source: &Source<'_>,
        common: &Common,
        coefficients: Coefficients,
        min_persistence: f64,
        progress: &Progress,
    ) -> Result<Option<(String, GreyImage, ImageRequest)>, Failure> {
        let Some((name, stream)) = stream(source, common)? else { return Ok(None) };
        progress.stage(format!("reading {name}"));
        let (mut image, said) = GreyImage::read(stream).map_err(|error| error.in_file(name.clone()))?;
        remarks::take(&name, &said);
        if let Some(path) = &self.mask {
            let mask_name = input::name(path);
            let mask = input::read(path, common.reading(), progress)?;
            let Some(Structure::Volume(volume)) = mask.model.structure() else {
                return Err(Self::no_mask(&mask_name));
            };
            image = image.mask(volume).map_err(|error| error.in_file(mask_name))?;
        }
        let request = ImageRequest::new()
            .coefficients(coefficients)
            .construction(self.construction.unwrap_or_default())
            .superlevel(self.superlevel)
            .periodic(common.voxels.reading())
            .min_persistence(min_persistence);
        Ok(Some((name, image, request)))
    }
}

/// Refuses superlevel sets of a function for a volume whose values nothing chooses from: its values are not those of vertices.
pub(crate) fn refuse_upper_star(source: &Source<'_>, common: &Common) -> Result<(), Failure> {
    let Some((name, _)) = stream(source, common)? else { return Ok(()) };
    Err(Failure::new(format!(
        "{name}: --upper-star is for functions on vertices, and the values of a volume are those of voxels; grow by superlevel sets of the values with --superlevel, or say the function on the voxels that are set: --function x"
    )))
}

/// The voxels of a volume file; `None` for any other input.
pub(crate) fn stream<'s>(
    source: &'s Source<'_>,
    common: &Common,
) -> Result<Option<(String, VolumeStream<'s>)>, Failure> {
    let options = common.reading();
    let (name, found) = match source {
        Source::File(path) => (input::name(path), io::volume_of_path(path, &options)?),
        Source::Bytes(bytes) => {
            let name = input::name(Path::new("-"));
            let found = io::volume_of(*bytes, &options).map_err(|error| error.in_file(name.clone()))?;
            (name, found)
        }
    };
    Ok(found.map(|(stream, said)| {
        remarks::take(&name, &said);
        (name, stream)
    }))
}
