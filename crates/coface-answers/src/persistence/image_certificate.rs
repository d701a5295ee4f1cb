//! Certificates of the persistence of images.

use super::FoundImage;
use super::certificate::{chains, entering};
use crate::answer::PersistenceAnswer;
use crate::homology::certificate::{Input, Number, chain_complex, checked};
use coface_algebra::{CellId, Error, ErrorKind};
use coface_check_persistence::Image;
use coface_topology::{Filtration, ImageConstruction};
use serde::Serialize;

/// A certificate of an image, as `docs/certificates.md` describes it.
#[derive(Serialize)]
struct Certificate<'a> {
    coface_certificate: u64,
    coface: &'static str,
    kind: &'static str,
    inputs: Vec<Input>,
    /// Whether the first place of a voxel is the one along the axis that runs fastest.
    first_fastest: bool,
    min_persistence: f64,
    answer: &'a PersistenceAnswer,
    proof: Proof,
}

#[derive(Serialize)]
struct Proof {
    /// For each degree the cells in the order in which they enter.
    order: Vec<Vec<u32>>,
    /// For each degree from 1 on the chains that end classes, and the cycles of those that stay.
    chains: Vec<Vec<Vec<(Number, u32)>>>,
}

impl FoundImage {
    /// A certificate of the diagram, from the name and the bytes of the file that the image was read from: chains over the field that prove the births and deaths.
    /// [`coface_check_walks::check`] makes the cubes and their values from the file, without any code of this library, as `docs/certificates.md` says. It has been checked. That voxels
    /// make and end the classes is not proved, but that they have the values.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] if the checker does not read the file as this library does: it reads arrays of NumPy whose last axis runs fastest, and grey maps with values below
    /// 256, of up to 2^22 cells, without infinite values, periodic axes and masks.
    ///
    /// # Complexity
    /// That of the cycles of all pairs of the cubes, also of those of persistence 0.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{GreyImage, ImageRequest};
    /// use coface_io::{Format, VolumeStream};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let input = &b"P2\n3 1\n9\n0 5 1\n"[..];
    /// let (image, _) = GreyImage::read(VolumeStream::new(input, Format::Pgm)?)?;
    /// let certificate = ImageRequest::new().found("row.pgm", image)?.certificate(&[("row.pgm", input)])?;
    /// let verdict = coface_check_walks::check(certificate.as_bytes(), &[input]).expect("the proof holds");
    /// assert_eq!(verdict.proved()[0], "the image has 1 x 3 voxels, which are cubes, and sublevel sets of their values grow");
    /// # Ok(()) }
    /// ```
    pub fn certificate(&self, inputs: &[(&str, &[u8])]) -> Result<String, Error> {
        let refused = |why: &str| {
            Error::new(
                ErrorKind::UnsupportedFormat,
                format!(
                    "no certificate: {why}; leave --certificate out, or give a small array of NumPy (.npy) or a grey map (.pgm) without a mask and periodic axes"
                ),
            )
        };
        let [(_, bytes)] = inputs else {
            return Err(Error::invalid("a certificate of an image is of one input"));
        };
        if self.is_cut || self.is_periodic {
            return Err(refused("the checker knows no masks and no periodic axes"));
        }
        let image = Image::read(bytes).map_err(|fault| refused(&fault.to_string()))?;
        let are_vertices = self.construction == ImageConstruction::Vertices;
        let (cells, values) = image
            .cells(are_vertices, self.diagram.is_falling())
            .map_err(|fault| refused(&fault.to_string()))?;
        if cells.counts() == [0] {
            return Err(refused("there is no voxel"));
        }
        let complex = chain_complex(&cells)?;
        let filtration = Filtration::new(&complex, values)?;
        let order: Vec<Vec<u32>> =
            (0..cells.counts().len()).map(|degree| entering(&filtration, degree)).collect();
        let number = |_: usize, cell: CellId| cell.to_u32();
        let chains = chains(&complex, &filtration, self.diagram.prime(), &order, number)?;
        let answer = self.answer();
        let certificate = Certificate {
            coface_certificate: coface_check::VERSION,
            coface: env!("CARGO_PKG_VERSION"),
            kind: "image",
            inputs: Input::list(inputs),
            first_fastest: self.axes.is_first_fastest,
            min_persistence: self.min_persistence,
            answer: &answer,
            proof: Proof { order, chains },
        };
        checked(&certificate, inputs).map_err(|fault| refused(&fault.to_string()))
    }
}
