//! Complexes larger than memory: shards as bytes and in folders.

use crate::errors::OrRaise;
use crate::given::source_of;
use crate::homology::Homology;
use crate::work::run;
use coface::io::container::checksum_of_header;
use coface::scale::shards;
use coface::scale::shards::{FolderLevel, ReducedStep, ShardFolder, ShardPlace, ShardRequest};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

/// Cuts a model into shards in a folder: the number of shards.
#[pyfunction]
#[pyo3(signature = (model, folder, parts, memory, fan_in, name, replace, progress=None))]
#[expect(clippy::too_many_arguments, reason = "all of them are given by the function of Python")]
pub(crate) fn _shard(
    py: Python<'_>,
    model: &Bound<'_, PyAny>,
    folder: PathBuf,
    parts: u32,
    memory: Option<u64>,
    fan_in: u32,
    name: &str,
    replace: bool,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<u32> {
    let source = source_of(model)?;
    let mut request = ShardRequest::new(name, parts);
    (request.fan_in, request.part_memory, request.replaces) = (fan_in, memory, replace);
    run(py, progress, || {
        let model = Arc::clone(&source).model.clone();
        Ok(shards::shard_model(model, &folder, &request)?.manifest().part_count)
    })
}

/// Reduces a shard.
#[pyfunction]
#[pyo3(signature = (shard, progress=None))]
pub(crate) fn _reduce<'py>(
    py: Python<'py>,
    shard: &Bound<'py, PyBytes>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyBytes>> {
    // Bytes of Python do not change, and are kept by the caller.
    let shard = shard.as_bytes();
    Ok(PyBytes::new(py, &run(py, progress, || shards::reduce(shard))?))
}

/// Merges the reduced shards of a level that belong to a place.
#[pyfunction]
#[pyo3(signature = (children, complex, parts, fan_in, level, number, progress=None))]
#[expect(clippy::too_many_arguments, reason = "a place is five numbers")]
pub(crate) fn _merge<'py>(
    py: Python<'py>,
    children: Vec<Bound<'py, PyBytes>>,
    complex: u64,
    parts: u32,
    fan_in: u32,
    level: u32,
    number: u32,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyBytes>> {
    let place = ShardPlace::new(complex, parts, fan_in, 0).or_raise(py)?.at(level, number);
    let children: Vec<&[u8]> = children.iter().map(|child| child.as_bytes()).collect();
    Ok(PyBytes::new(py, &run(py, progress, || shards::merge(place, &children))?))
}

/// The counts of a reduced shard.
#[pyfunction]
pub(crate) fn _summary<'py>(py: Python<'py>, reduced: &[u8]) -> PyResult<Bound<'py, PyDict>> {
    let found = shards::summary(reduced).or_raise(py)?;
    let dict = PyDict::new(py);
    dict.set_item("level", found.place().level)?;
    dict.set_item("number", found.place().number)?;
    dict.set_item("cells", found.cells())?;
    dict.set_item("strata", found.strata())?;
    dict.set_item("critical", found.critical())?;
    dict.set_item("bytes", found.bytes())?;
    dict.set_item("is_root", found.is_root())?;
    dict.set_item("checksum", found.checksum())?;
    dict.set_item("sources", found.sources())?;
    Ok(dict)
}

/// The checksum that a shard says it has, from its first bytes and its length.
#[pyfunction]
pub(crate) fn _shard_checksum(py: Python<'_>, start: &[u8], length: u64) -> PyResult<u64> {
    checksum_of_header(start, length).or_raise(py).map(|(_, checksum)| checksum)
}

/// The homology that a root has.
#[pyfunction]
pub(crate) fn _root_homology(py: Python<'_>, root: &[u8]) -> PyResult<Homology> {
    let homology = shards::root_homology(root).or_raise(py)?;
    Ok(Homology::of_groups(homology.groups(), false))
}

/// Reduces the shards of a folder and merges them, unless that is done: homology, cells, levels, and how many reduced shards were made now.
#[pyfunction]
#[pyo3(signature = (folder, replace, progress=None))]
pub(crate) fn _folder_homology<'py>(
    py: Python<'py>,
    folder: PathBuf,
    replace: bool,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<(Homology, Vec<u64>, Vec<Bound<'py, PyDict>>, u32)> {
    let made = AtomicU32::new(0);
    let counted = |step: ReducedStep| {
        made.fetch_add(u32::from(step.is_new()), Ordering::Relaxed);
        step
    };
    let summary = run(py, progress, || {
        let folder = ShardFolder::open(&folder)?;
        for number in 0..folder.manifest().part_count {
            counted(folder.reduce(number, replace)?);
        }
        folder.merge_all_by(|level, number| folder.merge(level, number, replace).map(&counted))
    })?;
    let levels = summary.levels().iter().map(|level| level_to_python(py, level)).collect::<PyResult<_>>()?;
    let groups = Homology::of_groups(summary.homology().groups(), false);
    Ok((groups, summary.cells().to_vec(), levels, made.into_inner()))
}

fn level_to_python<'py>(py: Python<'py>, level: &FolderLevel) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("parts", level.parts())?;
    dict.set_item("strata", level.strata())?;
    dict.set_item("critical", level.critical())?;
    dict.set_item("bytes", level.bytes())?;
    Ok(dict)
}
