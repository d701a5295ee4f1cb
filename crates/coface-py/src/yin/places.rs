//! Places on boundaries and edges: points along them, how they bend, and their images.

use super::{Interface, YinSet};
use crate::arrays;
use crate::errors::{OrRaise, invalid};
use crate::objects::to_python;
use crate::work::run;
use coface::geometry::AffineMap;
use coface::yin::Sampling;
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Eight points on each piece, unless something else is asked for.
const USUAL: Sampling = Sampling::PerPiece(8);

/// At most one of three ways.
fn sampling_of(
    py: Python<'_>,
    per_piece: Option<usize>,
    count: Option<usize>,
    spacing: Option<f64>,
) -> PyResult<Sampling> {
    match (per_piece, count, spacing) {
        (None, None, None) => Ok(USUAL),
        (Some(count), None, None) => Ok(Sampling::PerPiece(count)),
        (None, Some(count), None) => Ok(Sampling::PerCurve(count)),
        (None, None, Some(length)) => Ok(Sampling::Spacing(length)),
        _ => {
            let cure = "give one of per_piece=, count= and spacing=";
            Err(invalid(py, "points along a boundary are asked for in more than one way", cure))
        }
    }
}

/// The affine map of the plane with a matrix by rows and an offset.
fn map_of(matrix: &Bound<'_, PyAny>, offset: [f64; 2]) -> PyResult<AffineMap> {
    let py = matrix.py();
    let rows = arrays::positions(matrix, "the matrix")?;
    if rows.as_flat().len() != 4 || rows.dimension() != 2 {
        return Err(invalid(
            py,
            "the matrix of a map of the plane has two rows of two numbers",
            "give an array of shape (2, 2)",
        ));
    }
    AffineMap::new(rows.as_flat().to_vec(), offset.to_vec()).or_raise(py)
}

/// What points along curves have in common, as columns.
#[derive(Default)]
struct Columns {
    pieces: Vec<i64>,
    parameters: Vec<f64>,
    lengths: Vec<f64>,
    points: Vec<[f64; 2]>,
    tangents: Vec<[f64; 2]>,
    curvatures: Vec<f64>,
}

impl Columns {
    fn push(
        &mut self,
        place: (usize, f64, f64),
        point: [f64; 2],
        tangent: Option<[f64; 2]>,
        curvature: Option<f64>,
    ) {
        let (piece, parameter, length) = place;
        self.pieces.push(piece as i64);
        self.parameters.push(parameter);
        self.lengths.push(length);
        self.points.push(point);
        self.tangents.push(tangent.unwrap_or([f64::NAN; 2]));
        self.curvatures.push(curvature.unwrap_or(f64::NAN));
    }

    fn into_python<'py>(self, py: Python<'py>, first: Vec<(&str, Vec<i64>)>) -> PyResult<Bound<'py, PyDict>> {
        let table = PyDict::new(py);
        for (name, numbers) in first {
            table.set_item(name, PyArray1::from_vec(py, numbers))?;
        }
        table.set_item("piece", PyArray1::from_vec(py, self.pieces))?;
        table.set_item("parameter", PyArray1::from_vec(py, self.parameters))?;
        table.set_item("length", PyArray1::from_vec(py, self.lengths))?;
        for (name, pairs) in [("point", self.points), ("tangent", self.tangents)] {
            table.set_item(name, PyArray1::from_vec(py, pairs.concat()).reshape([pairs.len(), 2])?)?;
        }
        table.set_item("curvature", PyArray1::from_vec(py, self.curvatures))?;
        Ok(table)
    }
}

#[pymethods]
impl YinSet {
    /// Points along the boundary, with lengths, directions and curvatures.
    ///
    /// Parameters
    /// ----------
    /// per_piece : int, optional
    ///     So many points on each piece, at equally spaced parameters; 8 if no number is given.
    /// count : int, optional
    ///     So many points on each curve instead, at equal distances along it.
    /// spacing : float, optional
    ///     The distance of points along each curve instead: the greatest that is not above this and fits a whole number of times.
    ///
    /// Returns
    /// -------
    /// dict of ndarray
    ///     For n points ``curve``, ``piece``, ``parameter`` (in [0, 1) on the piece), ``length`` (from the beginning of the curve), ``point`` and
    ///     ``tangent`` of shape (n, 2), with the set on the left, and ``curvature``, positive where the curve turns left; ``nan`` where the curve
    ///     stands still.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> square = coface.YinSet.from_rings([[[0, 0], [2, 0], [2, 2], [0, 2]]])
    /// >>> found = square.sample(count=8)
    /// >>> found["point"][3].tolist(), found["length"].tolist()[3], found["tangent"][3].tolist()
    /// ([2.0, 1.0], 3.0, [0.0, 1.0])
    #[pyo3(signature = (*, per_piece=None, count=None, spacing=None))]
    fn sample<'py>(
        &self,
        py: Python<'py>,
        per_piece: Option<usize>,
        count: Option<usize>,
        spacing: Option<f64>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let sampling = sampling_of(py, per_piece, count, spacing)?;
        let found = run(py, None, || self.set.sampled("self", sampling))?.samples;
        let mut columns = Columns::default();
        for own in &found {
            columns.push((own.piece, own.parameter, own.length), own.point, own.tangent, own.curvature);
        }
        columns.into_python(py, vec![("curve", found.iter().map(|own| own.curve as i64).collect())])
    }

    /// How the curves bend: the least and the greatest curvature of each, and where it turns most at a knot.
    ///
    /// Returns
    /// -------
    /// list of dict
    ///     For each curve ``curve``, ``least`` and ``greatest`` (curvatures, positive where the curve turns left, with the set on its left),
    ///     ``sharpest`` (the knot at which it turns most, in degrees) and ``roughest`` (the same among knots that are no kinks; ``None`` if all
    ///     are), each with ``piece``, ``parameter``, ``point`` and ``value``.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> square = coface.YinSet.from_rings([[[0, 0], [2, 0], [2, 2], [0, 2]]])
    /// >>> square.curvature()[0]["sharpest"]["value"]
    /// 90.0
    fn curvature<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &run(py, None, || self.set.curvature("self"))?.curves)
    }

    /// The image under an affine map of the plane; curves and kinks keep their names.
    ///
    /// Parameters
    /// ----------
    /// matrix : array_like of shape (2, 2)
    ///     The matrix of the map, by rows. It has an inverse.
    /// offset : (float, float)
    ///     Where the origin goes.
    ///
    /// Returns
    /// -------
    /// YinSet
    ///     The set of all ``matrix @ point + offset``.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> square = coface.YinSet.from_rings([[[0, 0], [2, 0], [2, 2], [0, 2]]])
    /// >>> square.transformed([[0, 3], [1, 0]], (5, 0)).area
    /// 12.0
    #[pyo3(signature = (matrix, offset=[0.0, 0.0]))]
    fn transformed(&self, py: Python<'_>, matrix: &Bound<'_, PyAny>, offset: [f64; 2]) -> PyResult<Self> {
        let map = map_of(matrix, offset)?;
        run(py, None, || Self::of(self.set.transformed(&map)?))
    }
}

#[pymethods]
impl Interface {
    /// Points along the edges, with lengths, directions and curvatures.
    ///
    /// Parameters
    /// ----------
    /// per_piece : int, optional
    ///     So many points on each piece, at equally spaced parameters; 8 if no number is given.
    /// count : int, optional
    ///     So many points on each edge instead, at equal distances along it.
    /// spacing : float, optional
    ///     The distance of points along each edge instead: the greatest that is not above this and fits a whole number of times.
    ///
    /// Returns
    /// -------
    /// dict of ndarray
    ///     For n points ``edge``, the phases on its ``left`` and ``right`` (-1 outside of all), ``piece``, ``parameter`` (in [0, 1] on the piece),
    ///     ``length`` (from the beginning of the edge), ``point`` and ``tangent`` of shape (n, 2), and ``curvature``, positive where the edge
    ///     turns left; ``nan`` where the edge stands still. Edges that are not closed give the point at their end too.
    ///
    /// Examples
    /// --------
    /// >>> import coface, numpy as np
    /// >>> rooms = coface.interface(np.array([[1, 2]]))
    /// >>> found = rooms.sample(count=2)
    /// >>> len(found["edge"]), sorted(set(found["left"].tolist() + found["right"].tolist()))
    /// (9, [-1, 0, 1])
    #[pyo3(signature = (*, per_piece=None, count=None, spacing=None))]
    fn sample<'py>(
        &self,
        py: Python<'py>,
        per_piece: Option<usize>,
        count: Option<usize>,
        spacing: Option<f64>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let sampling = sampling_of(py, per_piece, count, spacing)?;
        let found = run(py, None, || self.interface.sampled("self", sampling))?.samples;
        let mut columns = Columns::default();
        for own in &found {
            columns.push((own.piece, own.parameter, own.length), own.point, own.tangent, own.curvature);
        }
        let phase = |phase: Option<u32>| phase.map_or(-1, i64::from);
        let first = vec![
            ("edge", found.iter().map(|own| i64::from(own.edge)).collect()),
            ("left", found.iter().map(|own| phase(own.left)).collect()),
            ("right", found.iter().map(|own| phase(own.right)).collect()),
        ];
        columns.into_python(py, first)
    }

    /// How the edges bend: the least and the greatest curvature of each, and where it turns most at a knot between its ends.
    ///
    /// Returns
    /// -------
    /// list of dict
    ///     For each edge ``edge``, the phases on its ``left`` and ``right``, ``least`` and ``greatest`` (curvatures, positive where the edge turns
    ///     left) and ``sharpest`` (in degrees; ``None`` without a knot between its ends), each with ``piece``, ``parameter``, ``point`` and ``value``.
    ///
    /// Examples
    /// --------
    /// >>> import coface, numpy as np
    /// >>> rooms = coface.interface(np.array([[1, 2]]))
    /// >>> sorted(abs(edge["sharpest"]["value"]) for edge in rooms.curvature() if edge["sharpest"])
    /// [90.0, 90.0]
    fn curvature<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &run(py, None, || self.interface.curvature("self"))?.edges)
    }

    /// The image under an affine map of the plane: each edge once, so that phases keep their common arcs.
    ///
    /// Parameters
    /// ----------
    /// matrix : array_like of shape (2, 2)
    ///     The matrix of the map, by rows. It has an inverse.
    /// offset : (float, float)
    ///     Where the origin goes.
    ///
    /// Returns
    /// -------
    /// Interface
    ///     The phases of all ``matrix @ point + offset``, with their names.
    ///
    /// Examples
    /// --------
    /// >>> import coface, numpy as np
    /// >>> rooms = coface.interface(np.array([[1, 2]]))
    /// >>> rooms.transformed([[3, 0], [0, -1]]).areas
    /// [3.0, 3.0]
    #[pyo3(signature = (matrix, offset=[0.0, 0.0]))]
    fn transformed(&self, py: Python<'_>, matrix: &Bound<'_, PyAny>, offset: [f64; 2]) -> PyResult<Self> {
        let map = map_of(matrix, offset)?;
        run(py, None, || Self::of(self.interface.transformed(&map)?))
    }
}
