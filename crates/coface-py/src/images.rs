//! Arrays of numpy as images.

use crate::errors::{OrRaise, invalid};
use coface::answers::GreyImage;
use coface::complexes::cubical::CubicalVolume;
use coface::io::VolumeReading;
use numpy::{PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::prelude::*;

/// An array as an image, with the voxels that are inside.
pub(crate) fn grey_image(
    py: Python<'_>,
    values: &Bound<'_, PyAny>,
    mask: Option<PyReadonlyArrayDyn<'_, bool>>,
) -> PyResult<GreyImage> {
    let image = match values.extract::<PyReadonlyArrayDyn<'_, f32>>() {
        Ok(single) => {
            let numbers = single.as_slice().map_err(|_| not_contiguous(py))?;
            GreyImage::new(single.shape(), numbers.iter().map(|&number| number.into()))
        }
        Err(_) => {
            let double: PyReadonlyArrayDyn<'_, f64> = values.extract()?;
            let numbers = double.as_slice().map_err(|_| not_contiguous(py))?;
            GreyImage::new(double.shape(), numbers.iter().copied())
        }
    };
    let mut image = image.or_raise(py)?;
    if let Some(mask) = mask {
        let shape: Vec<u32> = mask.shape().iter().map(|&length| length as u32).collect();
        let mut inside = mask.as_slice().map_err(|_| not_contiguous(py))?.iter();
        let volume = CubicalVolume::new(&shape, &vec![false; shape.len()], |_| inside.next() == Some(&true));
        image = volume.and_then(|volume| image.mask(&volume)).or_raise(py)?;
    }
    Ok(image)
}

/// The axes of an image that are periodic.
pub(crate) fn periodic_reading(
    py: Python<'_>,
    image: &GreyImage,
    periodic: Vec<usize>,
) -> PyResult<VolumeReading> {
    let mut reading = VolumeReading::default();
    for axis in periodic {
        let Some(is_periodic) = reading.periodic.get_mut(axis) else {
            let message = format!("axis {axis} of an image with {} axes", image.shape().len());
            return Err(invalid(py, message, "number axes from 0"));
        };
        *is_periodic = true;
    }
    Ok(reading)
}

fn not_contiguous(py: Python<'_>) -> PyErr {
    invalid(py, "the image is not contiguous".to_owned(), "give numpy.ascontiguousarray(x)")
}
