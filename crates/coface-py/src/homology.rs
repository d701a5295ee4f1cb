//! Groups, and the cycles and cocycles that generate them.

pub(crate) use crate::chain::{Chain, Generator};

use crate::arrays;
use crate::errors::{OrRaise, invalid, no_place, wrong_type};
use crate::homology_facts::{GroupFacts, read};
use crate::json::from_python;
use crate::objects::to_python;
use coface::answers::text;
use coface::topology::{AbelianGroup, Coefficients};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

/// Homology or cohomology: a group for each degree.
///
/// Made by :meth:`ChainComplex.homology`. ``homology[k]`` is the group of degree k.
///
/// Examples
/// --------
/// >>> import coface
/// >>> plane = coface.generate("rp2").chain_complex()
/// >>> plane.homology()
/// Homology(Z, Z/2)
/// >>> plane.homology()[1].torsion
/// (2,)
/// >>> plane.homology("f2")
/// Homology(Z/2, Z/2, Z/2)
#[pyclass(frozen, dict, module = "coface", name = "Homology")]
pub(crate) struct Homology {
    groups: Vec<Py<HomologyGroup>>,
    words: Vec<String>,
    bettis: Vec<usize>,
    ring: Coefficients,
    is_cohomology: bool,
}

impl Homology {
    /// Integral groups without generators.
    pub(crate) fn of_groups(groups: &[AbelianGroup], is_cohomology: bool) -> Self {
        let none = vec![Vec::new(); groups.len()];
        Self::with_generators(groups, none, Coefficients::Integers, is_cohomology)
    }

    /// Groups over a ring with generators.
    pub(crate) fn with_generators(
        groups: &[AbelianGroup],
        generators: Vec<Vec<Generator>>,
        ring: Coefficients,
        is_cohomology: bool,
    ) -> Self {
        let made = Python::attach(|py| {
            groups
                .iter()
                .zip(generators)
                .enumerate()
                .map(|(degree, (group, generators))| {
                    let generators =
                        generators.into_iter().map(|one| Py::new(py, one)).collect::<PyResult<_>>()?;
                    let group = group.clone();
                    Py::new(py, HomologyGroup { degree, group, generators, ring, is_cohomology })
                })
                .collect::<PyResult<_>>()
        });
        // Only a lack of memory could be in the way.
        Self::of(made.unwrap_or_default(), ring, is_cohomology)
    }

    fn of(groups: Vec<Py<HomologyGroup>>, ring: Coefficients, is_cohomology: bool) -> Self {
        let words = groups.iter().map(|group| group.get().text()).collect();
        let bettis = groups.iter().map(|group| group.get().group.betti()).collect();
        Self { groups, words, bettis, ring, is_cohomology }
    }
}

#[pymethods]
impl Homology {
    /// The groups of the degrees 0, 1, ...
    #[getter]
    fn groups<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.groups.iter().map(|group| group.clone_ref(py)))
    }

    /// The ranks of the free parts.
    #[getter]
    fn betti_numbers<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, &self.bettis)
    }

    /// The orders of the finite parts, one tuple a degree, each order dividing the next.
    #[getter]
    fn torsion<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        let lists: Vec<Bound<'py, PyTuple>> =
            self.groups.iter().map(|group| group.get().torsion(py)).collect::<PyResult<_>>()?;
        PyTuple::new(py, lists)
    }

    /// Whether it is cohomology.
    #[getter]
    fn is_cohomology(&self) -> bool {
        self.is_cohomology
    }

    /// The alternating sum of the Betti numbers.
    #[getter]
    fn euler_characteristic(&self) -> i64 {
        self.bettis.iter().enumerate().map(|(k, &b)| if k % 2 == 0 { b as i64 } else { -(b as i64) }).sum()
    }

    /// The ring of coefficients: ``"Z"``, ``"Q"``, ``"Z/2"``, ...
    #[getter]
    fn coefficients(&self) -> String {
        self.ring.to_string()
    }

    /// The groups as ``coface homology --json`` prints them.
    ///
    /// A group that is not integral also has ``coefficients``, one of cohomology ``cohomology``, and one with generators ``generators``:
    /// ``order`` (0 is infinite), ``length``, ``chain`` as pairs of a coefficient and vertices, ``cells`` and, of a cycle of finite order,
    /// ``bounding``. :meth:`from_dict` reads all of it back.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyDict>>> {
        self.groups.iter().map(|group| group.get().to_dict(py)).collect()
    }

    /// The groups that :meth:`to_dict` wrote.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> found = coface.homology(coface.generate("rp2"), "f2", generators=True)
    /// >>> coface.Homology.from_dict(found.to_dict()) == found
    /// True
    #[staticmethod]
    fn from_dict(groups: &Bound<'_, PyAny>) -> PyResult<Self> {
        let py = groups.py();
        if groups.cast::<PyDict>().is_ok() {
            return Err(invalid(py, "homology is a list of groups", "give what Homology.to_dict() gave"));
        }
        let mut found = Vec::new();
        for group in groups.try_iter()? {
            found.push(HomologyGroup::from_dict(&group?)?);
        }
        let (ring, is_cohomology) =
            found.first().map_or((Coefficients::Integers, false), |group| (group.ring, group.is_cohomology));
        if found.iter().any(|group| (group.ring, group.is_cohomology) != (ring, is_cohomology)) {
            let cure = "give what Homology.to_dict() gave";
            return Err(invalid(py, "the groups have different coefficients", cure));
        }
        let groups = found.into_iter().map(|group| Py::new(py, group)).collect::<PyResult<_>>()?;
        Ok(Self::of(groups, ring, is_cohomology))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let rebuild = py.get_type::<Self>().getattr("from_dict")?;
        Ok((rebuild, PyTuple::new(py, [self.to_dict(py)?])?))
    }

    fn __getitem__(&self, py: Python<'_>, degree: &Bound<'_, PyAny>) -> PyResult<Py<HomologyGroup>> {
        let degree: isize = degree.extract().map_err(|_| {
            let shown = degree.repr().map_or_else(|_| "this".to_owned(), |shown| shown.to_string());
            wrong_type(py, format!("{shown} is no degree"), "give an integer: homology[1]")
        })?;
        let place = if degree < 0 { degree + self.groups.len() as isize } else { degree };
        let group = usize::try_from(place).ok().and_then(|place| self.groups.get(place));
        group.map(|group| group.clone_ref(py)).ok_or_else(|| {
            let cure = format!("the groups have degrees below {}", self.groups.len());
            no_place(py, format!("there is no degree {degree}"), &cure)
        })
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.groups(py)?.call_method0("__iter__")
    }

    fn __len__(&self) -> usize {
        self.groups.len()
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| {
            let other = other.get();
            (self.ring, self.is_cohomology) == (other.ring, other.is_cohomology) && self.words == other.words
        })
    }

    fn __hash__(&self) -> isize {
        self.bettis.iter().fold(29, |sum, &betti| sum.wrapping_mul(1_000_003).wrapping_add(betti as isize))
    }

    fn __repr__(&self) -> String {
        let name = if self.is_cohomology { "Cohomology" } else { "Homology" };
        let mut words = &self.words[..];
        while let [rest @ .., last] = words
            && last == "0"
        {
            words = rest;
        }
        format!("{name}({})", if words.is_empty() { "0".to_owned() } else { words.join(", ") })
    }
}

/// A group of one degree: a free part over the ring of coefficients, of rank :attr:`betti`, and cyclic groups of finite orders.
#[pyclass(frozen, module = "coface", name = "HomologyGroup")]
pub(crate) struct HomologyGroup {
    degree: usize,
    group: AbelianGroup,
    generators: Vec<Py<Generator>>,
    ring: Coefficients,
    is_cohomology: bool,
}

impl HomologyGroup {
    fn text(&self) -> String {
        text::group(&self.group, self.ring)
    }
}

#[pymethods]
impl HomologyGroup {
    /// The degree.
    #[getter]
    fn degree(&self) -> usize {
        self.degree
    }

    /// The rank of the free part.
    #[getter]
    fn betti(&self) -> usize {
        self.group.betti()
    }

    /// The orders of the finite part, each dividing the next.
    #[getter]
    fn torsion<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        let orders: Vec<Bound<'py, PyAny>> =
            self.group.torsion().iter().map(|order| arrays::integer(py, order)).collect::<PyResult<_>>()?;
        PyTuple::new(py, orders)
    }

    /// The generators, if they were asked for: those of finite order in the order of :attr:`torsion`, and the free ones.
    #[getter]
    fn generators<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.generators.iter().map(|one| one.clone_ref(py)))
    }

    /// The ring of coefficients: ``"Z"``, ``"Q"``, ``"Z/2"``, ...
    #[getter]
    fn coefficients(&self) -> String {
        self.ring.to_string()
    }

    /// Whether it is a group of cohomology.
    #[getter]
    fn is_cohomology(&self) -> bool {
        self.is_cohomology
    }

    /// The group as a dictionary: one entry of :meth:`Homology.to_dict`.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let generators = self.generators.iter().map(|one| one.get().facts()).collect();
        let facts = GroupFacts::of(self.degree, &self.group, self.ring, self.is_cohomology, generators);
        let dict = to_python(py, &facts)?.cast_into::<PyDict>()?;
        // Orders stay integers of Python, however large.
        dict.set_item("torsion", self.torsion(py)?.to_list())?;
        Ok(dict)
    }

    /// The group that :meth:`to_dict` wrote.
    #[staticmethod]
    fn from_dict(group: &Bound<'_, PyAny>) -> PyResult<Self> {
        let py = group.py();
        let facts: GroupFacts = read(py, from_python(group)?, "a group of homology")?;
        let generators = facts.generators.iter().flatten().map(|one| Generator::of_facts(py, one));
        let generators = generators.map(|one| Py::new(py, one?)).collect::<PyResult<_>>()?;
        Ok(Self {
            degree: facts.degree,
            group: facts.group().or_raise(py)?,
            generators,
            ring: facts.ring().or_raise(py)?,
            is_cohomology: facts.cohomology,
        })
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let rebuild = py.get_type::<Self>().getattr("from_dict")?;
        Ok((rebuild, PyTuple::new(py, [self.to_dict(py)?])?))
    }

    /// Whether it is the group of one element.
    #[getter]
    fn is_trivial(&self) -> bool {
        self.group.is_trivial()
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| {
            let other = other.get();
            self.group == other.group && self.ring == other.ring
        })
    }

    fn __hash__(&self) -> isize {
        self.group.betti() as isize
    }

    fn __str__(&self) -> String {
        self.text()
    }

    fn __repr__(&self) -> String {
        let symbol = if self.is_cohomology { "H^" } else { "H_" };
        format!("{symbol}{} = {}", self.degree, self.text())
    }
}
