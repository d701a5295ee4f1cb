//! `coface render`: still pictures.

use super::view::read_result;
use crate::arguments::Common;
use crate::failure::Failure;
use crate::input;
use crate::output::{print_bytes, print_json, write_file};
use crate::progress::Progress;
use clap::Args;
use coface::report::{Camera, Picture, PictureStyle, Producer, Report, Scene, matrix_picture};
use serde_json::json;
use std::path::{Path, PathBuf};

/// Draw a model as PNG or SVG, without a browser.
///
/// The picture is shaded, with edges where there is room for them, and with what --with gives drawn over it: generators, seams, loops, cocycles,
/// sets of simplices. In SVG what is hidden is left out, and hidden parts of lines given by --with are dotted. --matrix draws the
/// boundary matrices instead.
#[derive(Args)]
pub(crate) struct Render {
    /// The model; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// Draw an answer of coface over the model: the JSON of another verb; may be given several times
    #[arg(long, value_name = "RESULT.json")]
    with: Vec<PathBuf>,
    /// Width and height in pixels
    #[arg(long, value_name = "WxH", default_value = "1200x900", value_parser = size)]
    size: [usize; 2],
    /// The direction from the model to the eye
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = direction)]
    from: Option<[f64; 3]>,
    /// What is up in the picture
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = direction)]
    up: Option<[f64; 3]>,
    /// See in perspective, with this angle in degrees from bottom to top
    #[arg(long, value_name = "ANGLE", num_args = 0..=1, default_missing_value = "35")]
    perspective: Option<f64>,
    /// Draw edges
    #[arg(long, conflicts_with = "no_edges")]
    edges: bool,
    /// Draw no edges
    #[arg(long)]
    no_edges: bool,
    /// A dark background
    #[arg(long)]
    dark: bool,
    /// Mark what is wrong: the witness of the report
    #[arg(long)]
    witness: bool,
    /// Draw the sparsity of the boundary matrices, as SVG
    #[arg(long, conflicts_with_all = ["with", "from", "up", "perspective", "edges", "no_edges", "dark", "witness"])]
    matrix: bool,
}

fn size(text: &str) -> Result<[usize; 2], String> {
    let sides = text.split_once('x').map(|(width, height)| (width.parse(), height.parse()));
    match sides {
        Some((Ok(width), Ok(height))) if width > 0 && height > 0 => Ok([width, height]),
        _ => Err("give a width and a height in pixels, like 1200x900".to_owned()),
    }
}

fn direction(text: &str) -> Result<[f64; 3], String> {
    let numbers: Option<Vec<f64>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
    numbers
        .and_then(|numbers| <[f64; 3]>::try_from(numbers).ok())
        .filter(|numbers| numbers.iter().all(|x| x.is_finite()) && numbers.iter().any(|&x| x != 0.0))
        .ok_or_else(|| "give three numbers with commas between them, not all 0, like 1,0.5,2".to_owned())
}

/// What a picture is written as.
#[derive(Clone, Copy, PartialEq)]
enum PictureFormat {
    Png,
    Svg,
}

impl Render {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let format = self.format(common.output.as_deref())?;
        let progress = Progress::start(common.quiet);
        let loaded = input::read(&self.input, common.reading(), &progress)?;
        progress.stage("drawing");
        let in_file = |error: coface::Error| error.in_file(loaded.name.clone());
        let bytes = if self.matrix {
            let complex =
                Producer::of(loaded.model).and_then(Producer::into_chain_complex).map_err(in_file)?;
            matrix_picture(&loaded.name, &complex).into_bytes()
        } else {
            let mut scene = Scene::of(&loaded.name, &loaded.model).map_err(in_file)?;
            for path in &self.with {
                scene.add_result(&input::name(path), &read_result(path)?)?;
            }
            if self.witness {
                scene = scene.with_report(Report::of(loaded.model).map_err(in_file)?.to_json(100));
            }
            let picture = Picture::new(&scene, &self.style(&scene)?)?;
            match format {
                PictureFormat::Png => picture.png()?,
                PictureFormat::Svg => picture.svg().into_bytes(),
            }
        };
        drop(progress);
        match &common.output {
            Some(path) => write_file(path, &bytes)?,
            None if common.json => {}
            None => return print_bytes(|out| out.write_all(&bytes)),
        }
        if common.json {
            print_json(&json!({
                "file": loaded.name,
                "picture": common.output.as_ref().map(|path| path.display().to_string()),
                "bytes": bytes.len(),
            }))?;
        }
        Ok(())
    }

    fn format(&self, output: Option<&Path>) -> Result<PictureFormat, Failure> {
        let extension = output.and_then(Path::extension).map(|extension| extension.to_ascii_lowercase());
        match extension.as_deref().and_then(|extension| extension.to_str()) {
            Some("png") if self.matrix => {
                Err(Failure::new("boundary matrices are drawn as SVG; name the output *.svg".to_owned()))
            }
            Some("png") => Ok(PictureFormat::Png),
            Some("svg") | None => Ok(PictureFormat::Svg),
            Some(other) => Err(Failure::new(format!(
                "no picture has the extension {other}; name the output *.png or *.svg"
            ))),
        }
    }

    fn style(&self, scene: &Scene) -> Result<PictureStyle, Failure> {
        let mut style = PictureStyle::default();
        style.size = self.size;
        style.is_dark = self.dark;
        style.edges = match (self.edges, self.no_edges) {
            (true, _) => Some(true),
            (_, true) => Some(false),
            _ => None,
        };
        if self.perspective.is_some_and(|angle| !(1.0..=170.0).contains(&angle)) {
            return Err(Failure::new("an angle of view is between 1 and 170 degrees".to_owned()));
        }
        if self.from.is_some() || self.up.is_some() || self.perspective.is_some() {
            let mut camera = if scene.dimension() == 2 { Camera::above() } else { Camera::default() };
            camera.from = self.from.unwrap_or(camera.from);
            camera.up = self.up.unwrap_or(camera.up);
            camera.field_of_view = self.perspective;
            style.camera = Some(camera);
        }
        Ok(style)
    }
}
