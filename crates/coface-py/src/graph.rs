//! Graphs of cells in the form of others.

use crate::errors::invalid;
use coface::answers::answer::CellGraph;
use pyo3::prelude::*;

/// A graph of cells, the text of its JSON, as GraphML.
///
/// Parameters
/// ----------
/// graph : str
///     What ``json.dumps(graph.to_dict())`` gives.
///
/// Returns
/// -------
/// str
///     The text of the file.
///
/// Examples
/// --------
/// >>> import coface
/// >>> coface._coface.graphml('{"inputs": [], "nodes": [], "edges": []}').count("<key ")
/// 18
#[pyfunction]
pub(crate) fn graphml(py: Python<'_>, graph: &str) -> PyResult<String> {
    let graph: Result<CellGraph, _> = serde_json::from_str(graph);
    let graph = graph
        .map_err(|error| invalid(py, format!("this is no graph of cells: {error}"), "give one of arrange"));
    Ok(graph?.to_graphml())
}
