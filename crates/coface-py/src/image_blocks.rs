//! Persistence of images by blocks: parts as bytes.

use crate::chain_complex::ring;
use crate::errors::{OrRaise, invalid};
use crate::persistence::{Diagram, Persistence};
use crate::work::run;
use coface::answers::FoundImage;
use coface::scale::shards;
use coface::topology::{ImageBlocks, ImageConstruction};
use numpy::PyReadonlyArrayDyn;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};

/// How an image is cut and what is asked: shape, block, construction, superlevel, periodic, coefficients.
type Cut<'py> = (Vec<usize>, Vec<usize>, String, bool, Vec<bool>, Bound<'py, PyAny>);

fn blocks_of(py: Python<'_>, cut: &Cut<'_>) -> PyResult<ImageBlocks> {
    let (shape, block, construction, superlevel, periodic, coefficients) = cut;
    let construction: ImageConstruction = construction.parse().or_raise(py)?;
    let blocks = ImageBlocks::new(shape, block).or_raise(py)?;
    let blocks = blocks.construction(construction).superlevel(*superlevel).periodic(periodic).or_raise(py)?;
    blocks.coefficients(ring(coefficients)?).or_raise(py)
}

fn block_of(py: Python<'_>, cut: &Cut<'_>, number: u32) -> PyResult<ImageBlocks> {
    let blocks = blocks_of(py, cut)?;
    if number >= blocks.count() {
        let message = format!("there is no block {number} of {}", blocks.count());
        return Err(invalid(py, message, "number the blocks from 0"));
    }
    Ok(blocks)
}

/// The number of blocks.
#[pyfunction]
pub(crate) fn _image_block_count(py: Python<'_>, cut: Cut<'_>) -> PyResult<u32> {
    Ok(blocks_of(py, &cut)?.count())
}

/// Where the voxels of the window of a block are along each axis.
#[pyfunction]
pub(crate) fn _image_window(py: Python<'_>, cut: Cut<'_>, number: u32) -> PyResult<Vec<Vec<usize>>> {
    Ok(block_of(py, &cut, number)?.window(number))
}

fn numbers<'a>(py: Python<'_>, values: &'a PyReadonlyArrayDyn<'_, f64>) -> PyResult<&'a [f64]> {
    values.as_slice().map_err(|_| {
        invalid(py, "the window is not contiguous".to_owned(), "give numpy.ascontiguousarray(x)")
    })
}

/// The checksum of the numbers of a window and of what is asked.
#[pyfunction]
pub(crate) fn _image_window_checksum(
    py: Python<'_>,
    cut: Cut<'_>,
    number: u32,
    values: PyReadonlyArrayDyn<'_, f64>,
) -> PyResult<u64> {
    Ok(shards::window_checksum(&block_of(py, &cut, number)?, number, numbers(py, &values)?))
}

/// What is left of a block.
#[pyfunction]
pub(crate) fn _image_part<'py>(
    py: Python<'py>,
    cut: Cut<'py>,
    number: u32,
    values: PyReadonlyArrayDyn<'py, f64>,
) -> PyResult<Bound<'py, PyBytes>> {
    let blocks = block_of(py, &cut, number)?;
    let numbers = numbers(py, &values)?;
    Ok(PyBytes::new(py, &run(py, None, || shards::image_part(&blocks, number, numbers))?))
}

/// The part of the blocks of some parts.
#[pyfunction]
pub(crate) fn _merge_image_parts<'py>(
    py: Python<'py>,
    parts: Vec<Bound<'py, PyBytes>>,
) -> PyResult<Bound<'py, PyBytes>> {
    let parts: Vec<&[u8]> = parts.iter().map(|part| part.as_bytes()).collect();
    Ok(PyBytes::new(py, &run(py, None, || shards::merge_image_parts(&parts))?))
}

/// The counts of a part.
#[pyfunction]
pub(crate) fn _image_part_summary<'py>(py: Python<'py>, part: &[u8]) -> PyResult<Bound<'py, PyDict>> {
    let found = shards::image_part_summary(part).or_raise(py)?;
    let dict = PyDict::new(py);
    dict.set_item("blocks", (found.blocks().start, found.blocks().end))?;
    dict.set_item("critical", found.critical())?;
    dict.set_item("pairs", found.pairs())?;
    dict.set_item("rules", found.rules())?;
    dict.set_item("bytes", found.bytes())?;
    dict.set_item("checksum", found.checksum())?;
    dict.set_item("sources", found.sources())?;
    Ok(dict)
}

/// The diagram of the part of all blocks.
#[pyfunction]
#[pyo3(signature = (part, construction, periodic, least, progress=None))]
pub(crate) fn _image_part_diagram(
    py: Python<'_>,
    part: &Bound<'_, PyBytes>,
    construction: &str,
    periodic: bool,
    least: f64,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Persistence> {
    let construction = construction.parse().or_raise(py)?;
    // Bytes of Python do not change, and are kept by the caller.
    let part = part.as_bytes();
    let diagram = run(py, progress, || shards::image_diagram(part))?;
    let found = FoundImage::of_diagram("image", construction, &diagram, periodic, least);
    Ok(Persistence { diagram: Diagram::Image { found, cells: None } })
}
