//! Files that a build without one of the features `xml` and `compression` refuses, and how compressed streams are read with it.

use coface_algebra::Error;
use std::io::Read;

/// The first two bytes of a gzip stream.
pub(crate) const GZIP: &[u8] = b"\x1f\x8b";

/// The error about a file of an XML format.
#[cfg(not(feature = "xml"))]
pub(crate) fn without_xml(format: &str) -> Error {
    use coface_algebra::ErrorKind;
    Error::new(ErrorKind::UnsupportedFormat, format!("this build of coface does not read {format}"))
        .with_cure("build coface-io with the feature \"xml\", which is on by default, or convert the file")
}

/// The error about a file of a format that needs a feature.
#[cfg(not(all(feature = "gltf", feature = "archives", feature = "images")))]
pub(crate) fn without_feature(format: &str, feature: &str) -> Error {
    use coface_algebra::ErrorKind;
    Error::new(ErrorKind::UnsupportedFormat, format!("this build of coface does not read {format}"))
        .with_cure(format!(
            "build coface-io with the feature \"{feature}\", which is on by default, or convert the file"
        ))
}

/// The error about a compressed file.
#[cfg(not(feature = "compression"))]
pub(crate) fn without_compression() -> Error {
    use coface_algebra::ErrorKind;
    Error::new(ErrorKind::UnsupportedFormat, "this build of coface does not read compressed data").with_cure(
        "build coface-io with the feature \"compression\", which is on by default, or write the file uncompressed",
    )
}

/// The bytes of a gzip stream.
#[cfg(feature = "compression")]
pub(crate) fn gunzipped<'r>(packed: impl Read + 'r) -> Result<Box<dyn Read + 'r>, Error> {
    Ok(Box::new(flate2::read::MultiGzDecoder::new(packed)))
}

/// The bytes of a gzip stream.
#[cfg(not(feature = "compression"))]
pub(crate) fn gunzipped<'r>(_packed: impl Read + 'r) -> Result<Box<dyn Read + 'r>, Error> {
    Err(without_compression())
}

/// The bytes of a zlib stream.
#[cfg(feature = "compression")]
pub(crate) fn inflated<'r>(packed: impl Read + 'r) -> Result<Box<dyn Read + 'r>, Error> {
    Ok(Box::new(flate2::read::ZlibDecoder::new(packed)))
}

/// The bytes of a zlib stream.
#[cfg(not(feature = "compression"))]
pub(crate) fn inflated<'r>(_packed: impl Read + 'r) -> Result<Box<dyn Read + 'r>, Error> {
    Err(without_compression())
}

#[cfg(test)]
mod tests {
    use crate::{Format, VolumeStream, read};

    /// The start of a NIfTI file that is compressed, and empty XML files.
    #[test]
    fn files_of_a_missing_feature_are_refused_by_its_name() {
        let svg = read(&b"<svg xmlns=\"http://www.w3.org/2000/svg\"/>"[..], Format::Svg);
        let vtk = read(&b"<VTKFile type=\"PolyData\"><PolyData/></VTKFile>"[..], Format::VtkPolygons);
        for model in [svg, vtk] {
            match model {
                Ok(_) if cfg!(feature = "xml") => {}
                Ok(_) => panic!("read without the feature"),
                Err(error) => {
                    assert_eq!(error.to_string().contains("\"xml\""), !cfg!(feature = "xml"), "{error}");
                }
            }
        }
        let stream = VolumeStream::new(&b"\x1f\x8b\x08\0\0\0\0\0"[..], Format::Nifti);
        let Err(error) = stream.map(|_| ()) else { panic!("a cut file") };
        assert_eq!(error.to_string().contains("\"compression\""), !cfg!(feature = "compression"), "{error}");
    }
}
