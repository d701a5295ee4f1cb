//! What comes of cutting and covering surfaces, and of their first cohomology.

use crate::answer::answer;
use crate::homology::Chain;
use crate::model::Model;
use crate::objects::text_of;
use coface::answers::answer::{CoverAnswer, CutAnswer, EdgeWeights, WholeNumber};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use serde::Serialize;

/// A surface cut open: a disk for each component, and seams.
///
/// Made by :meth:`Surface.cut`.
#[pyclass(frozen, dict, module = "coface", name = "Domain")]
pub(crate) struct Domain {
    pub(super) answer: CutAnswer,
    pub(super) model: Py<Model>,
}

answer! { Domain {
    /// For each component ``surface``, ``f_vector``, ``cut_edges``, ``boundary_edges``, ``seams``, ``word``, ``relator`` and more.
    components,
    /// The numbers of vertices, edges and faces of the opened surface.
    f_vector,
    /// Whether the graph was made short.
    simplified,
    /// The edges by ``tree``, ``cotree`` and ``generators``; ``None`` unless they were asked for.
    roles,
    /// Of a canonical cut the ``f_vector`` of the refined surface and its new ``vertices``, each with the vertices ``of`` the file whose mean it is by ``weights``.
    refinement,
    /// Of a layout its ``plane`` and ``weights``, whether it is ``texture``, and how many of its ``triangles`` are ``turned`` over; else ``None``.
    layout,
    /// Of a cut along a path its ``kind`` and number of ``edges``.
    path,
}
    /// The opened surface: its lines are the seams, with the data ``seam`` and ``source``; vertices have ``source``.
    #[getter]
    fn model(&self, py: Python<'_>) -> Py<Model> {
        self.model.clone_ref(py)
    }

    fn __repr__(&self) -> String {
        let f_vector = text_of(&self.answer.f_vector);
        format!("Domain(f-vector {f_vector}, components {})", self.answer.components.len())
    }
}

/// A part of a universal cover: copies of a domain, glued.
///
/// Made by :meth:`Surface.cover`.
#[pyclass(frozen, dict, module = "coface", name = "Cover")]
pub(crate) struct Cover {
    pub(super) answer: CoverAnswer,
    pub(super) model: Py<Model>,
}

answer! { Cover {
    /// The component that is covered.
    component,
    /// What it is.
    surface,
    /// The name of its fundamental group.
    group,
    /// The number of copies.
    copies,
    /// Whether it is the whole cover.
    complete,
    /// The number of copies at each word length.
    spheres,
    /// The numbers of vertices, edges and faces.
    f_vector,
    /// Vertices - edges + faces: 1 of a disk.
    euler_characteristic,
    /// The edges of the surface, by their vertices, that letters cross.
    letters,
    /// The word of each copy: letters are 1, 2, .. and their inverses -1, -2, ..
    words,
    /// Where copies were put: ``flat``, ``disk``, ``klein`` or ``None`` for over the surface.
    layout,
}
    /// The cover as a model; its data ``source``, ``copy`` and ``length`` say what lies below.
    #[getter]
    fn model(&self, py: Python<'_>) -> Py<Model> {
        self.model.clone_ref(py)
    }

    fn __repr__(&self) -> String {
        format!("Cover(copies {}, f-vector {})", self.answer.copies, text_of(&self.answer.f_vector))
    }
}

/// A basis of the first cohomology of a surface, dual to loops.
///
/// Made by :meth:`Surface.cocycles`.
#[pyclass(frozen, dict, module = "coface", name = "Cocycles")]
pub(crate) struct Cocycles {
    pub(super) answer: BasisAnswer,
    pub(super) cocycles: Vec<Py<Chain>>,
    pub(super) forms: Option<Vec<Vec<f64>>>,
    pub(super) edge_count: usize,
}

/// What is known of a basis beside its cochains.
#[derive(Serialize)]
pub(super) struct BasisAnswer {
    pub(super) rank: usize,
    pub(super) method: String,
    pub(super) pairing: Vec<Vec<i64>>,
    pub(super) determinant: Option<WholeNumber>,
    pub(super) loops: Vec<Vec<u32>>,
    pub(super) intersection: Option<Vec<Vec<i64>>>,
    pub(super) weights: Option<EdgeWeights>,
    pub(super) closed_residuals: Option<Vec<f64>>,
    pub(super) coclosed_residuals: Option<Vec<f64>>,
}

answer! { Cocycles {
    /// The rank of the first cohomology over the integers.
    rank,
    /// How cocycles were found.
    method,
    /// The value of cocycle i on loop j.
    pairing,
    /// Its determinant.
    determinant,
    /// The loops, each a list of vertices, the first one again at the end.
    loops,
    /// How often loops cross each other, with signs, on closed oriented surfaces.
    intersection,
    /// The weights of harmonic forms: ``cotangent`` or ``uniform``.
    weights,
    /// The largest sum of each harmonic form around a face.
    closed_residuals,
    /// The largest weighted sum of each harmonic form at a vertex.
    coclosed_residuals,
}
    /// The cocycles, integral cochains of degree 1.
    #[getter]
    fn cocycles(&self, py: Python<'_>) -> Vec<Py<Chain>> {
        self.cocycles.iter().map(|chain| chain.clone_ref(py)).collect()
    }

    /// The harmonic forms, if they were asked for: ``float64``, shape (rank, edges).
    #[getter]
    fn harmonic<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        let Some(forms) = &self.forms else { return Ok(None) };
        let flat: Vec<f64> = forms.iter().flatten().copied().collect();
        Ok(Some(PyArray1::from_vec(py, flat).reshape([forms.len(), self.edge_count])?.into_any()))
    }

    fn __len__(&self) -> usize {
        self.cocycles.len()
    }

    fn __repr__(&self) -> String {
        format!("Cocycles(rank {})", self.cocycles.len())
    }
}
