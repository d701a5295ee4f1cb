//! Fundamental groups.

use crate::arrays;
use crate::errors::{bound, invalid, required, whole, wrong_type};
use crate::given::source_of;
use crate::homology::Homology;
use crate::model::Model;
use crate::source::Source;
use crate::surface::numbers_of;
use crate::work::run;
use coface::algebra::Word;
use coface::answers::group_of_space;
use coface::topology::{
    AbelianGroup, CosetTable, EdgePathGroups, Effort, GroupName, PermutationGroup, Presentation,
    Simplification, SubgroupClass,
};
use coface::{Error, ErrorKind, VertexId};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyInt, PyTuple};
use std::sync::Arc;
use std::time::Duration;

/// The fundamental group of a component: generators, which are loops at a base, and relators.
///
/// Words are lists of letters: 1, 2, .. for generators and -1, -2, .. for their inverses.
///
/// Examples
/// --------
/// >>> import coface
/// >>> group, = coface.pi1(coface.generate("rp2"))
/// >>> group
/// FundamentalGroup(Z/2, 1 generator, 1 relator)
/// >>> group.abelianization.torsion
/// (2,)
#[pyclass(frozen, dict, module = "coface", name = "FundamentalGroup")]
pub(crate) struct FundamentalGroup {
    presentation: Presentation,
    name: Option<GroupName>,
    base: Option<u32>,
    loops: Vec<Vec<u32>>,
    /// What the loops run in.
    source: Option<Arc<Source>>,
}

impl FundamentalGroup {
    pub(crate) fn new(
        presentation: Presentation,
        name: Option<GroupName>,
        base: u32,
        loops: Vec<Vec<u32>>,
        source: Arc<Source>,
    ) -> Self {
        Self { presentation, name, base: Some(base), loops, source: Some(source) }
    }

    fn word(&self, py: Python<'_>, letters: &[i32]) -> PyResult<Word> {
        let count = self.presentation.generator_count();
        match letters.iter().find(|&&letter| letter == 0 || letter.unsigned_abs() as usize > count) {
            Some(letter) => {
                let message = format!("the letter {letter} is no generator of {count}");
                Err(invalid(py, message, "letters are 1, 2, .. and -1, -2, .."))
            }
            None => Ok(Word::from_letters(letters.iter().copied())),
        }
    }
}

fn effort(py: Python<'_>, time_limit: Option<f64>) -> PyResult<Effort> {
    let time = time_limit.map(Duration::try_from_secs_f64).transpose();
    let time =
        time.map_err(|error| invalid(py, format!("time_limit: {error}"), "give a number of seconds"))?;
    Ok(Effort::new().time_limit(time))
}

/// The fundamental groups of the components of a complex.
///
/// Parameters
/// ----------
/// model : Model, Complex or ChainComplex
///     What is asked about; cells have to say how they are attached.
/// simplify : bool
///     Whether presentations are made short by Tietze moves.
/// base : int, optional
///     The vertex that loops of its component start from.
/// time_limit : float, optional
///     Seconds for simplifying and recognizing a group.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// list of FundamentalGroup
///     One for each component.
///
/// Examples
/// --------
/// >>> import coface
/// >>> [str(group) for group in coface.pi1(coface.generate("poincare"))]
/// ['SL(2,5)']
#[pyfunction]
#[pyo3(signature = (model, *, simplify=true, base=None, time_limit=None, progress=None))]
pub(crate) fn fundamental_groups(
    py: Python<'_>,
    model: &Bound<'_, PyAny>,
    simplify: bool,
    base: Option<u32>,
    time_limit: Option<f64>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Vec<FundamentalGroup>> {
    let source = source_of(model)?;
    let effort = effort(py, time_limit)?;
    run(py, progress, || {
        let producer = source.producer()?;
        let skeleton = producer.two_skeleton()?;
        let numbers = numbers_of(producer, skeleton.vertex_count());
        let groups = match base {
            None => EdgePathGroups::new(&skeleton),
            Some(base) => {
                let place = numbers.iter().position(|&number| number == base).ok_or_else(|| {
                    Error::new(ErrorKind::NotInComplex, format!("there is no vertex {base} to be the base"))
                        .with_cells([[base]])
                        .with_cure("give a vertex of the model")
                })?;
                EdgePathGroups::with_base(&skeleton, VertexId::new(place))?
            }
        };
        let mut found = Vec::new();
        for i in 0..groups.component_count() {
            let presentation = groups.presentation(i);
            let simpler = Simplification::new(presentation, effort);
            let mut name = simpler.presentation().recognized(effort);
            if !name.as_ref().is_some_and(GroupName::is_complete) {
                name = group_of_space(producer)?.map(|(group, _)| group).or(name);
            }
            let letters = |count: usize| (1..=count as i32).map(|letter| Word::from_letters([letter]));
            let (shown, words): (&Presentation, Vec<Word>) = if simplify {
                let shown = simpler.presentation();
                (shown, letters(shown.generator_count()).map(|word| simpler.to_original(&word)).collect())
            } else {
                (presentation, letters(presentation.generator_count()).collect())
            };
            let loops = words.iter().map(|word| {
                groups.loop_vertices(i, word).into_iter().map(|vertex| numbers[vertex.index()]).collect()
            });
            let base = numbers[groups.base(i).index()];
            let source = Arc::clone(&source);
            found.push(FundamentalGroup::new(shown.clone(), name, base, loops.collect(), source));
        }
        Ok(found)
    })
}

impl FundamentalGroup {
    /// The group of generators and relators.
    fn made(
        py: Python<'_>,
        generators: usize,
        relators: Vec<Vec<i32>>,
        time_limit: Option<f64>,
    ) -> PyResult<Self> {
        let effort = effort(py, time_limit)?;
        let words = relators.into_iter().map(Word::from_letters).collect();
        let (presentation, name) = run(py, None, || {
            let presentation = Presentation::new(generators, words)?;
            let name = Simplification::new(&presentation, effort).presentation().recognized(effort);
            Ok((presentation, name))
        })?;
        Ok(Self { presentation, name, base: None, loops: Vec::new(), source: None })
    }
}

#[pymethods]
impl FundamentalGroup {
    /// A group by generators and relators.
    ///
    /// Parameters
    /// ----------
    /// generators : int
    ///     The number of generators.
    /// relators : sequence of sequence of int, optional
    ///     Words that are the unit.
    /// time_limit : float, optional
    ///     Seconds for recognizing the group.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> str(coface.FundamentalGroup(2, [[1, 2, -1, -2]]))
    /// 'Z^2'
    #[new]
    #[pyo3(signature = (*arguments, **options), text_signature = "(generators, relators=[], *, time_limit=None)")]
    fn py_new(
        py: Python<'_>,
        arguments: &Bound<'_, PyTuple>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let names = ["generators", "relators", "time_limit"];
        let [generators, relators, time_limit] = bound("FundamentalGroup", names, 2, arguments, options)?;
        let generators = whole(&required(py, "FundamentalGroup", "generators", generators)?)?;
        let wrong = |what: &Bound<'_, PyAny>, cure: &str| {
            wrong_type(py, format!("FundamentalGroup: {what} is given"), cure)
        };
        let relators: Vec<Vec<i32>> = match relators {
            Some(words) => words
                .extract()
                .map_err(|_| wrong(&words, "give relators as lists of letters: [[1, 2, -1, -2]]"))?,
            None => Vec::new(),
        };
        let time_limit: Option<f64> = match time_limit {
            Some(limit) => Some(limit.extract().map_err(|_| wrong(&limit, "give time_limit in seconds"))?),
            None => None,
        };
        Self::made(py, generators, relators, time_limit)
    }

    /// The vertex that loops start from.
    #[getter]
    fn base(&self) -> Option<u32> {
        self.base
    }

    /// The number of generators.
    #[getter]
    fn generators(&self) -> usize {
        self.presentation.generator_count()
    }

    /// The relators as lists of letters.
    #[getter]
    fn relators(&self) -> Vec<Vec<i32>> {
        self.presentation.relators().iter().map(|word| word.letters().to_vec()).collect()
    }

    /// What the group is called, where it was recognized.
    #[getter]
    fn name(&self) -> Option<String> {
        self.name.as_ref().map(ToString::to_string)
    }

    /// The number of elements, where the group was recognized as a finite one; ``None`` where it is infinite or not recognized.
    #[getter]
    fn order<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        let order = self.name.as_ref().and_then(GroupName::order);
        order.map(|digits| py.get_type::<PyInt>().call1((digits,))).transpose()
    }

    /// The loops of the generators, each an array of vertices, the first one again at the end.
    #[getter]
    fn loops<'py>(&self, py: Python<'py>) -> Vec<Bound<'py, PyArray1<i64>>> {
        self.loops.iter().map(|walk| arrays::id_array(py, walk.iter().copied())).collect()
    }

    /// The group made commutative: the first homology.
    #[getter]
    fn abelianization(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        let groups = [AbelianGroup::default(), self.presentation.abelianization()];
        let homology = Bound::new(py, Homology::of_groups(&groups, false))?;
        Ok(homology.get_item(1)?.unbind())
    }

    /// How many subgroups there are of each index, and how many classes of conjugate ones.
    ///
    /// Parameters
    /// ----------
    /// highest : int
    ///     The highest index.
    /// time_limit : float, optional
    ///     Seconds.
    ///
    /// Returns
    /// -------
    /// list of (int, int) or None
    ///     Subgroups and classes of index 1, 2, ..; ``None`` if the time was too short.
    #[pyo3(signature = (highest, *, time_limit=None, progress=None))]
    fn subgroups(
        &self,
        py: Python<'_>,
        #[pyo3(from_py_with = whole)] highest: usize,
        time_limit: Option<f64>,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Option<Vec<(usize, usize)>>> {
        let effort = effort(py, time_limit)?;
        run(py, progress, || {
            Ok(self.presentation.subgroups_up_to(highest, effort).map(|classes| {
                let of_index = |index| classes.iter().filter(move |class| class.index() == index);
                let count = |index| of_index(index).map(SubgroupClass::conjugate_count).sum();
                (1..=highest).map(|index| (count(index), of_index(index).count())).collect()
            }))
        })
    }

    /// How many homomorphisms there are to a group of permutations, and how many of them are onto.
    ///
    /// Parameters
    /// ----------
    /// group : {"S", "A"}
    ///     Symmetric or alternating.
    /// points : int
    ///     The number of points that are permuted.
    /// time_limit : float, optional
    ///     Seconds.
    ///
    /// Returns
    /// -------
    /// (int, int) or None
    ///     All, and those onto.
    #[pyo3(signature = (group, points, *, time_limit=None, progress=None))]
    fn homomorphisms(
        &self,
        py: Python<'_>,
        group: &str,
        #[pyo3(from_py_with = whole)] points: usize,
        time_limit: Option<f64>,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Option<(u64, u64)>> {
        let target = match group {
            "S" => PermutationGroup::Symmetric(points),
            "A" => PermutationGroup::Alternating(points),
            _ => return Err(invalid(py, format!("the group is {group:?}"), "give \"S\" or \"A\"")),
        };
        if !(1..=8).contains(&points) {
            return Err(invalid(py, format!("{points} points"), "give 1 to 8 points"));
        }
        let effort = effort(py, time_limit)?;
        run(py, progress, || {
            Ok(self.presentation.homomorphisms_to(target, effort).map(|count| (count.all, count.onto)))
        })
    }

    /// The index of the subgroup that words generate, by enumeration of cosets.
    ///
    /// Parameters
    /// ----------
    /// words : sequence of sequence of int
    ///     Generators of the subgroup; none for the trivial one, whose index is the order of the group.
    /// limit : int
    ///     The number of cosets that are followed.
    ///
    /// Returns
    /// -------
    /// int or None
    ///     The index; ``None`` if the limit was reached.
    #[pyo3(signature = (words=Vec::new(), limit=100_000, *, progress=None))]
    fn index(
        &self,
        py: Python<'_>,
        words: Vec<Vec<i32>>,
        #[pyo3(from_py_with = whole)] limit: usize,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Option<usize>> {
        let words: Vec<Word> = words.iter().map(|word| self.word(py, word)).collect::<PyResult<_>>()?;
        run(
            py,
            progress,
            || Ok(CosetTable::new(&self.presentation, &words, limit).map(|table| table.index())),
        )
    }

    /// The same group with a shorter presentation.
    #[pyo3(signature = (*, time_limit=None, progress=None))]
    fn simplified(
        &self,
        py: Python<'_>,
        time_limit: Option<f64>,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let effort = effort(py, time_limit)?;
        let (presentation, name) = run(py, progress, || {
            let simpler = Simplification::new(&self.presentation, effort);
            Ok((simpler.presentation().clone(), simpler.presentation().recognized(effort)))
        })?;
        Ok(Self { presentation, name, base: self.base, loops: Vec::new(), source: self.source.clone() })
    }

    fn __len__(&self) -> usize {
        self.presentation.generator_count()
    }

    fn __str__(&self) -> String {
        self.name.as_ref().map_or_else(|| "not recognized".to_owned(), ToString::to_string)
    }

    fn __repr__(&self) -> String {
        let count =
            |number: usize, one: &str| format!("{number} {one}{}", if number == 1 { "" } else { "s" });
        format!(
            "FundamentalGroup({}, {}, {})",
            self.__str__(),
            count(self.presentation.generator_count(), "generator"),
            count(self.presentation.relators().len(), "relator")
        )
    }

    /// The model that the loops run in; ``None`` of a group that was made of words.
    #[getter]
    fn model(&self) -> Option<Model> {
        self.source.as_ref().map(|source| Model { source: Arc::clone(source) })
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| {
            let other = other.get();
            let model = |group: &Self| group.source.as_ref().map(|source| source.model.clone());
            (self.generators(), self.relators()) == (other.generators(), other.relators())
                && (self.base, &self.loops) == (other.base, &other.loops)
                && model(self) == model(other)
        })
    }

    fn __hash__(&self) -> isize {
        (self.generators() * 1_000_003 + self.presentation.relators().len()) as isize
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, GroupParts)> {
        let rebuild = py.import("coface._coface")?.getattr("_group")?;
        Ok((rebuild, (self.generators(), self.relators(), self.base, self.loops.clone(), self.model())))
    }
}

/// What a group is made of: generators, relators, base, loops, and the model that they run in.
type GroupParts = (usize, Vec<Vec<i32>>, Option<u32>, Vec<Vec<u32>>, Option<Model>);

/// Makes a group again, for pickling.
#[pyfunction]
#[pyo3(signature = (generators, relators, base, loops, model))]
pub(crate) fn _group(
    py: Python<'_>,
    generators: usize,
    relators: Vec<Vec<i32>>,
    base: Option<u32>,
    loops: Vec<Vec<u32>>,
    model: Option<&Bound<'_, Model>>,
) -> PyResult<FundamentalGroup> {
    let source = model.map(|model| Arc::clone(&model.get().source));
    let made = FundamentalGroup::made(py, generators, relators, None)?;
    Ok(FundamentalGroup { base, loops, source, ..made })
}
