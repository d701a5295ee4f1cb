//! Volumes of voxels, from arrays.

use crate::errors::{OrRaise, invalid};
use crate::model::Model;
use crate::work::run;
use coface::complexes::cubical::CubicalVolume;
use coface::io;
use coface::io::{ReadOptions, Structure, VolumeReading, VoxelRule};
use numpy::{PyArray1, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::prelude::*;
use std::path::PathBuf;

/// The volume of an array of truth values; `periodic` has the numbers of axes that close up.
#[pyfunction]
pub(crate) fn _volume(
    py: Python<'_>,
    voxels: PyReadonlyArrayDyn<'_, bool>,
    periodic: Vec<usize>,
) -> PyResult<Model> {
    let lengths = voxels.shape();
    let shape: Option<Vec<u32>> = lengths.iter().map(|&length| u32::try_from(length).ok()).collect();
    let Some(shape) = shape else {
        return Err(invalid(
            py,
            format!("an array of shape {lengths:?}"),
            "give axes of less than 2^32 voxels",
        ));
    };
    let mut is_periodic = vec![false; shape.len()];
    for axis in periodic {
        let Some(is_periodic) = is_periodic.get_mut(axis) else {
            let message = format!("axis {axis} of an array with {} axes", shape.len());
            return Err(invalid(py, message, "number axes from 0"));
        };
        *is_periodic = true;
    }
    let values = voxels
        .as_slice()
        .map_err(|_| invalid(py, "the voxels are not contiguous", "give numpy.ascontiguousarray(voxels)"))?;
    let mut values = values.iter();
    let volume = CubicalVolume::new(&shape, &is_periodic, |_| values.next() == Some(&true)).or_raise(py)?;
    Ok(Model::of(io::Model::from_structure(Structure::Volume(volume))))
}

/// Which voxels of a file are set: one of `nonzero`, `threshold`, `below`, `between`, `value`, with its bounds, and the axes that close up.
pub(crate) type Voxels = (String, [f64; 2], Vec<usize>);

/// The same for the library.
pub(crate) fn reading_of(py: Python<'_>, (rule, bounds, periodic): &Voxels) -> PyResult<VolumeReading> {
    let rule = match rule.as_str() {
        "threshold" => VoxelRule::AtLeast(bounds[0]),
        "below" => VoxelRule::Below(bounds[0]),
        "between" => VoxelRule::Between(bounds[0], bounds[1]),
        "value" => VoxelRule::Equal(bounds[0]),
        _ => VoxelRule::Nonzero,
    };
    let mut reading = VolumeReading { rule, ..VolumeReading::default() };
    for &axis in periodic {
        let Some(is_periodic) = reading.periodic.get_mut(axis) else {
            let cure = "number the axes of the volume from 0";
            return Err(invalid(py, format!("axis {axis} cannot be periodic: no volume has it"), cure));
        };
        *is_periodic = true;
    }
    Ok(reading)
}

/// The volume in a file.
#[pyfunction]
#[pyo3(signature = (path, voxels, allow_outside=false, progress=None))]
pub(crate) fn _read_volume(
    py: Python<'_>,
    path: PathBuf,
    voxels: Voxels,
    allow_outside: bool,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Model> {
    let options = ReadOptions::new().volume(reading_of(py, &voxels)?).allow_outside(allow_outside);
    let model = run(py, progress, || io::read_path_with(&path, &options))?;
    match model.structure() {
        Some(Structure::Volume(_)) => Ok(Model::of(model)),
        _ => {
            let message = format!("{} holds no voxels", path.display());
            Err(invalid(py, message, "give a .npy, .nrrd, .nhdr, .nii or .nii.gz file, or use coface.read"))
        }
    }
}

/// The voxels of a volume as an array, and the numbers of its axes that close up.
pub(crate) fn voxels_of<'py>(
    py: Python<'py>,
    volume: &CubicalVolume,
) -> PyResult<(Bound<'py, PyArrayDyn<bool>>, Vec<usize>)> {
    let shape: Vec<usize> = volume.shape().iter().map(|&length| length as usize).collect();
    let words = volume.words();
    let flat: Vec<bool> = (0..volume.voxel_count()).map(|at| words[at / 64] >> (at % 64) & 1 == 1).collect();
    let array = PyArray1::from_vec(py, flat).reshape(shape)?;
    let axes = volume.is_periodic().iter().enumerate().filter(|(_, is_periodic)| **is_periodic);
    Ok((array, axes.map(|(axis, _)| axis).collect()))
}
