//! Homology and cohomology of a model, and everything that can be asked beside the groups.
//!
//! * [`HomologyRequest`] says what is asked; [`HomologyRequest::found`] answers it about a model.
//! * [`FoundHomology`] has the [`HomologyAnswer`], the groups, and the generators as a model to look at.
//! * A chain, a cochain or a map of vertices that the user writes is a [`GivenChain`], a [`GivenRealCochain`] or a
//!   [`GivenVertexMap`].

pub(crate) mod certificate;
mod classes;
mod domain;
mod generators;
mod harmonic;
mod maps;
mod products;
mod sequence;

pub use domain::{Domain, RelativeTo};

use crate::answer::{ChainTerm, HomologyAnswer, PhysicalGroup, Remark, RemarkCode};
use crate::{CellNames, Pair, Producer, Term, homology_of_volume};
use coface_algebra::chains::Chain;
use coface_algebra::progress::stage;
use coface_algebra::{Error, Integer};
use coface_io::{Model, Structure};
use coface_topology::{AbelianGroup, Coefficients, Homology, HomologyBasis, homology};

/// Asks for homology groups, and for more about them.
///
/// # Examples
/// The rim of a triangle has one loop.
/// ```
/// use coface_answers::HomologyRequest;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let rim = coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?;
/// let answer = HomologyRequest::new().generators(true).found("rim.json", rim)?.into_answer();
/// assert_eq!(answer.homology[1].betti, 1);
/// assert_eq!(answer.generators.map(|degrees| degrees[1][0].chain.len()), Some(3));
/// # Ok(()) }
/// ```
#[derive(Debug)]
pub struct HomologyRequest {
    coefficients: Coefficients,
    is_cohomology: bool,
    is_reduced: bool,
    domain: Domain,
    has_sequence: bool,
    has_generators: bool,
    is_for_mesh: bool,
    cycles: Vec<GivenChain>,
    cup: Option<[usize; 2]>,
    has_intersection_form: bool,
    has_harmonic: bool,
    decomposed: Option<GivenRealCochain>,
    map: Option<GivenVertexMap>,
    is_certified: bool,
}

/// A chain as the user writes it.
#[derive(Clone, Debug)]
pub struct GivenChain {
    /// Where it comes from, in messages.
    pub place: String,
    /// The degree, where it does not follow from the cells.
    pub degree: Option<usize>,
    /// Coefficients, and cells by their vertices.
    pub terms: Vec<Term>,
}

/// A real cochain as the user writes it.
#[derive(Clone, Debug)]
pub struct GivenRealCochain {
    /// Where it comes from, in messages.
    pub place: String,
    /// The degree, where it does not follow from the cells.
    pub degree: Option<usize>,
    /// Values, and cells by their vertices.
    pub terms: Vec<(f64, Vec<u32>)>,
}

/// A simplicial map as the user writes it.
#[derive(Debug)]
pub struct GivenVertexMap {
    /// Where it comes from, in messages.
    pub place: String,
    /// Pairs of a vertex and its image.
    pub images: Vec<(u32, u32)>,
    /// What the target is called.
    pub target_name: String,
    /// The target.
    pub target: Model,
}

impl Default for HomologyRequest {
    fn default() -> Self {
        Self {
            coefficients: Coefficients::Integers,
            is_cohomology: false,
            is_reduced: false,
            domain: Domain::default(),
            has_sequence: false,
            has_generators: false,
            is_for_mesh: false,
            cycles: Vec::new(),
            cup: None,
            has_intersection_form: false,
            has_harmonic: false,
            decomposed: None,
            map: None,
            is_certified: false,
        }
    }
}

impl HomologyRequest {
    /// Asks for integral homology groups.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::HomologyRequest;
    /// let rim = coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?;
    /// let found = HomologyRequest::new().found("rim.json", rim)?;
    /// assert_eq!(found.groups()[1].to_string(), "Z");
    /// # Ok(()) }
    /// ```
    pub fn new() -> Self {
        Self::default()
    }

    /// The coefficients of groups, generators and products.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::HomologyRequest;
    /// let rim = coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?;
    /// let request = HomologyRequest::new().coefficients(coface_topology::Coefficients::Modulo(2));
    /// assert_eq!(request.found("rim.json", rim)?.answer().coefficients, "Z/2");
    /// # Ok(()) }
    /// ```
    pub fn coefficients(mut self, coefficients: Coefficients) -> Self {
        self.coefficients = coefficients;
        self
    }

    /// Whether cohomology is asked for.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::HomologyRequest;
    /// let rim = coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?;
    /// let found = HomologyRequest::new().cohomology(true).found("rim.json", rim)?;
    /// assert!(found.answer().cohomology);
    /// # Ok(()) }
    /// ```
    pub fn cohomology(mut self, is_cohomology: bool) -> Self {
        self.is_cohomology = is_cohomology;
        self
    }

    /// Whether the groups are reduced: a point has none.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::HomologyRequest;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let point = coface_io::read(&b"[[7]]"[..], coface_io::Format::Json)?;
    /// let found = HomologyRequest::new().reduced(true).found("point.json", point)?;
    /// assert_eq!(found.groups()[0].betti(), 0);
    /// # Ok(()) }
    /// ```
    pub fn reduced(mut self, is_reduced: bool) -> Self {
        self.is_reduced = is_reduced;
        self
    }

    /// The subcomplex that homology is relative to.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{HomologyRequest, RelativeTo};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let disk = coface_io::read(&b"[[0,1,2]]"[..], coface_io::Format::Json)?;
    /// let found = HomologyRequest::new().relative(Some(RelativeTo::Boundary)).found("disk.json", disk)?;
    /// assert_eq!(found.groups()[2].betti(), 1);
    /// # Ok(()) }
    /// ```
    pub fn relative(mut self, relative: Option<RelativeTo>) -> Self {
        self.domain.relative = relative;
        self
    }

    /// The groups of the model, by names or numbers, whose cells and faces are the domain; without any it is the whole model.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::HomologyRequest;
    /// use coface_io::{Format, Group, GroupKind};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = b"OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n5 5 5\n3 0 1 2\n3 0 2 3\n";
    /// let square = coface_io::read(&text[..], Format::Off)?.with_group(Group::new("lid", GroupKind::Polygons, vec![1]))?;
    /// let found = HomologyRequest::new().domain(vec!["lid".to_owned()]).found("square.off", square)?;
    /// assert_eq!(found.groups()[0].betti(), 1, "the isolated vertex is not in the domain");
    /// # Ok(()) }
    /// ```
    pub fn domain(mut self, groups: Vec<String>) -> Self {
        self.domain.groups = groups;
        self
    }

    /// Whether the long exact sequence of the pair is wanted.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::HomologyRequest;
    /// let rim = coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?;
    /// use coface_answers::RelativeTo;
    /// let disk = coface_io::read(&b"[[0,1,2]]"[..], coface_io::Format::Json)?;
    /// let request = HomologyRequest::new().relative(Some(RelativeTo::Boundary)).sequence(true);
    /// assert!(request.found("disk.json", disk)?.into_answer().sequence.is_some_and(|sequence| sequence.exact));
    /// # Ok(()) }
    /// ```
    pub fn sequence(mut self, has_sequence: bool) -> Self {
        self.has_sequence = has_sequence;
        self
    }

    /// Whether generators of the groups are wanted.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::HomologyRequest;
    /// let rim = coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?;
    /// let answer = HomologyRequest::new().generators(true).found("rim.json", rim)?.into_answer();
    /// assert_eq!(answer.generators.map(|degrees| degrees[1][0].chain.len()), Some(3));
    /// # Ok(()) }
    /// ```
    pub fn generators(mut self, has_generators: bool) -> Self {
        self.has_generators = has_generators;
        self
    }

    /// Whether the generators are wanted as groups of the mesh too, for [`FoundHomology::mesh_with_generators`].
    ///
    /// # Examples
    /// See [`FoundHomology::mesh_with_generators`].
    pub fn for_mesh(mut self, is_for_mesh: bool) -> Self {
        self.is_for_mesh = is_for_mesh;
        self
    }

    /// Cycles whose classes are wanted.
    pub fn cycles(mut self, cycles: Vec<GivenChain>) -> Self {
        self.cycles = cycles;
        self
    }

    /// The degrees of two bases of cohomology whose cup products are wanted.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::HomologyRequest;
    /// let rim = coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?;
    /// let answer = HomologyRequest::new().cup(Some([0, 1])).found("rim.json", rim)?.into_answer();
    /// assert_eq!(answer.cup.map(|products| products.degrees), Some([0, 1]));
    /// # Ok(()) }
    /// ```
    pub fn cup(mut self, degrees: Option<[usize; 2]>) -> Self {
        self.cup = degrees;
        self
    }

    /// Whether the intersection form is wanted.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::HomologyRequest;
    /// let rim = coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?;
    /// let sphere = coface_io::read(&b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"[..], coface_io::Format::Json)?;
    /// let answer = HomologyRequest::new().intersection_form(true).found("sphere.json", sphere)?.into_answer();
    /// assert_eq!(answer.intersection_form.map(|form| form.rank), Some(0));
    /// # Ok(()) }
    /// ```
    pub fn intersection_form(mut self, has_intersection_form: bool) -> Self {
        self.has_intersection_form = has_intersection_form;
        self
    }

    /// Whether harmonic cochains are wanted, dual to the free generators.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::HomologyRequest;
    /// let rim = coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?;
    /// let answer = HomologyRequest::new().harmonic(true).found("rim.json", rim)?.into_answer();
    /// assert_eq!(answer.harmonic.map(|degrees| degrees[1].len()), Some(1));
    /// # Ok(()) }
    /// ```
    pub fn harmonic(mut self, has_harmonic: bool) -> Self {
        self.has_harmonic = has_harmonic;
        self
    }

    /// A cochain whose Hodge decomposition is wanted.
    pub fn decomposed(mut self, cochain: Option<GivenRealCochain>) -> Self {
        self.decomposed = cochain;
        self
    }

    /// A simplicial map whose maps on homology are wanted.
    pub fn map(mut self, map: Option<GivenVertexMap>) -> Self {
        self.map = map;
        self
    }

    /// Whether a certificate is wanted, so that what proves the generators is found too.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::HomologyRequest;
    /// let bytes = &b"[[0,1],[1,2],[0,2]]"[..];
    /// let rim = coface_io::read(bytes, coface_io::Format::Json)?;
    /// let found = HomologyRequest::new().generators(true).certified(true).found("rim.json", rim)?;
    /// assert!(found.certificate(&[("rim.json", bytes)])?.contains("duals"));
    /// # Ok(()) }
    /// ```
    pub fn certified(mut self, is_certified: bool) -> Self {
        self.is_certified = is_certified;
        self
    }

    /// Whether nothing but groups is asked for, of the whole.
    fn is_groups_alone(&self) -> bool {
        self.domain.is_whole()
            && !self.is_reduced
            && !self.has_generators
            && !self.is_for_mesh
            && self.cycles.is_empty()
            && self.cup.is_none()
            && !self.has_intersection_form
            && !self.has_harmonic
            && self.decomposed.is_none()
            && self.map.is_none()
    }

    /// The groups asked for, from degree 0 of the model on.
    fn groups(&self, integral: &Homology) -> Vec<AbelianGroup> {
        let groups = match self.is_cohomology {
            true => integral.dual(self.coefficients),
            false => integral.with_coefficients(self.coefficients),
        };
        groups.groups()[usize::from(self.is_reduced).min(groups.groups().len())..].to_vec()
    }

    /// Answers the request about a model with this name.
    ///
    /// # Errors
    /// Those of [`Producer::of`], with the name of the model; [`ErrorKind::NotACycle`](coface_algebra::ErrorKind::NotACycle)
    /// if a given cycle has a boundary; an invalid argument where the model does not have what is asked about.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::HomologyRequest;
    /// let rim = coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?;
    /// let found = HomologyRequest::new().found("rim.json", rim)?;
    /// assert_eq!(found.groups().iter().map(|group| group.betti()).collect::<Vec<_>>(), [1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn found(&self, name: &str, model: Model) -> Result<FoundHomology, Error> {
        let in_file = |error: Error| error.in_file(name);
        let answer =
            |groups: &[AbelianGroup]| HomologyAnswer::of(name, self.coefficients, self.is_cohomology, groups);
        if let Some(Structure::Volume(volume)) = model.structure()
            && self.is_groups_alone()
        {
            let _steps = stage("computing homology", 0);
            let groups = self.groups(&homology_of_volume(volume).map_err(in_file)?.1);
            return Ok(FoundHomology {
                answer: answer(&groups),
                groups,
                producer: None,
                chains: Vec::new(),
                duals: None,
                mesh: None,
                is_reduced: self.is_reduced,
                relative: None,
            });
        }
        if self.is_certified && self.domain.has_groups() {
            return Err(in_file(
                Error::invalid("a certificate does not know the groups of a mesh")
                    .with_cure("leave --certificate out, or write the domain as a model of its own"),
            ));
        }
        let mesh = (self.domain.has_groups() || self.is_for_mesh).then(|| model.clone());
        let steps = stage("identifying cells", 0);
        let producer = Producer::of(model).map_err(in_file)?;
        drop(steps);
        let whole = producer.chain_complex()?;
        let pair = self.domain.pair(&producer, &whole, mesh.as_ref()).map_err(in_file)?;
        let complex = pair.as_ref().map_or(&whole, Pair::chains);
        let augmented = if self.is_reduced { Some(complex.augmented()?) } else { None };
        let complex = augmented.as_ref().unwrap_or(complex);
        let names = CellNames::of(&producer).within(pair.as_ref()).augmented(self.is_reduced);
        let steps = stage("computing homology", 0);
        let has_generators = self.has_generators || self.is_for_mesh;
        let needs_basis = has_generators || self.has_harmonic || !self.cycles.is_empty();
        let basis = needs_basis.then(|| HomologyBasis::new(complex));
        let integral = basis.as_ref().map_or_else(|| homology(complex), HomologyBasis::homology);
        drop(steps);
        let groups = self.groups(&integral);
        let mut object = answer(&groups);
        let cut = |said: &&Remark| said.code == RemarkCode::IdealVerticesCut;
        object.remarks.extend(producer.remarks().iter().filter(cut).cloned());
        let (mut chains, mut duals) = (Vec::new(), None);
        let mut written = None;
        if let Some(basis) = basis.as_ref().filter(|_| has_generators) {
            let _steps = stage("finding generators", 0);
            let found = generators::find(basis, &names, self.coefficients, self.is_cohomology);
            object.generators = self.has_generators.then(|| generators::answer(&found, &names));
            chains = generators::named(&found, &names, &whole)?;
            if let Some(mesh) = mesh.filter(|_| self.is_for_mesh) {
                let symbol = if self.is_cohomology { "H^" } else { "H_" };
                let chains =
                    generators::physical(&found, &names, &whole, symbol, &self.domain.words(&mesh)?)?;
                let mesh = producer.mesh_with_chains(mesh, &chains, self.is_cohomology).map_err(in_file)?;
                let before = mesh.groups().len() - chains.len();
                let groups = mesh.groups()[before..].iter().zip(&chains);
                object.physical_groups = Some(
                    groups.map(|(group, (_, chain))| PhysicalGroup::of(group, chain.degree())).collect(),
                );
                written = Some(mesh);
            }
            let proved = || generators::duals(basis, &names, self.coefficients, self.is_cohomology);
            duals = self.is_certified.then(proved);
        }
        if let Some(basis) = basis.as_ref().filter(|_| !self.cycles.is_empty()) {
            let _steps = stage("finding classes", 0);
            let class = |given: &GivenChain| {
                classes::class(given, basis, &names, &whole).map_err(|error| error.in_file(&given.place))
            };
            object.cycles = Some(self.cycles.iter().map(class).collect::<Result<_, _>>()?);
        }
        if let Some(pair) = pair.as_ref().filter(|_| self.has_sequence) {
            let _steps = stage("computing the long exact sequence", 0);
            object.sequence = Some(sequence::answer(&whole, pair)?);
        }
        if let Some([p, q]) = self.cup {
            let _steps = stage("multiplying cocycles", 0);
            object.cup = Some(products::cup(&producer, p, q, self.coefficients).map_err(in_file)?);
        }
        if self.has_intersection_form {
            let _steps = stage("computing the intersection form", 0);
            object.intersection_form = Some(products::form(&producer).map_err(in_file)?);
        }
        if let Some(basis) = basis.as_ref().filter(|_| self.has_harmonic) {
            let _steps = stage("solving for harmonic cochains", 0);
            object.harmonic = Some(harmonic::cochains(basis, &names)?);
        }
        if let Some(given) = &self.decomposed {
            let _steps = stage("decomposing the cochain", 0);
            object.decomposition = Some(harmonic::decomposition(complex, &names, given)?);
        }
        if let Some(map) = &self.map {
            let _steps = stage("computing the induced map", 0);
            object.map = Some(maps::answer(&producer, map)?);
        }
        Ok(FoundHomology {
            answer: object,
            groups,
            producer: Some(producer),
            chains,
            duals,
            mesh: written,
            is_reduced: self.is_reduced,
            relative: self.domain.word(),
        })
    }
}

/// Homology groups of a model, with what else was asked.
#[derive(Debug)]
pub struct FoundHomology {
    answer: HomologyAnswer,
    groups: Vec<AbelianGroup>,
    /// None for a volume whose groups alone were asked for.
    producer: Option<Producer>,
    /// The generators on the cells of the model, each with a name.
    chains: Vec<(String, Chain<Integer>)>,
    /// What tells the generators apart, if a certificate is wanted.
    duals: Option<Vec<Vec<Vec<ChainTerm>>>>,
    /// The mesh with the generators as groups, if it was asked for.
    mesh: Option<Model>,
    is_reduced: bool,
    /// Relative to the boundary or to a file.
    relative: Option<&'static str>,
}

impl FoundHomology {
    /// The answer as plain data.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::HomologyRequest;
    /// let rim = coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?;
    /// let found = HomologyRequest::new().found("rim.json", rim)?;
    /// assert_eq!(found.answer().homology[1].betti, 1);
    /// # Ok(()) }
    /// ```
    pub fn answer(&self) -> &HomologyAnswer {
        &self.answer
    }

    /// The answer as plain data.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::HomologyRequest;
    /// let rim = coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?;
    /// let answer = HomologyRequest::new().found("rim.json", rim)?.into_answer();
    /// assert_eq!(answer.file, "rim.json");
    /// # Ok(()) }
    /// ```
    pub fn into_answer(self) -> HomologyAnswer {
        self.answer
    }

    /// The groups of degrees 0, 1, ...
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::HomologyRequest;
    /// let rim = coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?;
    /// let found = HomologyRequest::new().found("rim.json", rim)?;
    /// assert_eq!(found.groups()[1].to_string(), "Z");
    /// # Ok(()) }
    /// ```
    pub fn groups(&self) -> &[AbelianGroup] {
        &self.groups
    }

    /// The model with the names of its cells; `None` for a volume whose groups alone were asked for.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::HomologyRequest;
    /// let rim = coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?;
    /// let found = HomologyRequest::new().found("rim.json", rim)?;
    /// let word = found.cell_names().map(|names| names.word(1, coface_algebra::CellId::new(0)));
    /// assert_eq!(word.as_deref(), Some("{v0 v1}"));
    /// # Ok(()) }
    /// ```
    pub fn cell_names(&self) -> Option<CellNames<'_>> {
        self.producer.as_ref().map(CellNames::of)
    }

    /// The generators as a model of groups of cells: `H1_0_free`, `H1_1_order_2`, ...
    ///
    /// # Errors
    /// Those of [`Producer::picture`]: the model has no positions, or the cells are not given by vertices.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::HomologyRequest;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let rim = &b"v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\nl 2 3\nl 3 1\n"[..];
    /// let rim = coface_io::read(rim, coface_io::Format::Obj)?;
    /// let model = HomologyRequest::new().generators(true).found("rim.obj", rim)?.generators_model()?;
    /// assert_eq!(model.groups()[1].name(), "H1_0_free");
    /// # Ok(()) }
    /// ```
    pub fn generators_model(&self) -> Result<Model, Error> {
        match &self.producer {
            Some(producer) => producer.picture(&self.chains),
            None => Err(Error::invalid("generators were not asked for").with_cure("ask for generators")),
        }
    }
    /// The mesh that the answer is about with its groups, and one more for each generator, named as Gmsh names them:
    /// `H_1{1},{70,71}1` is the first generator of degree 1 of the group 1 relative to the groups 70 and 71, and 0 stands for the whole
    /// mesh. [`Producer::mesh_with_chains`] says what is in them.
    ///
    /// # Errors
    /// [`InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if it was not asked for with [`HomologyRequest::for_mesh`].
    ///
    /// # Examples
    /// ```
    /// use coface_answers::HomologyRequest;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let rim = &b"v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\nl 2 3\nl 3 1\n"[..];
    /// let rim = coface_io::read(rim, coface_io::Format::Obj)?;
    /// let mesh = HomologyRequest::new().for_mesh(true).found("rim.obj", rim)?.mesh_with_generators()?;
    /// assert_eq!(mesh.groups()[1].name(), "H_1{0}1");
    /// assert_eq!(mesh.groups()[1].members().len(), 3);
    /// # Ok(()) }
    /// ```
    pub fn mesh_with_generators(&self) -> Result<Model, Error> {
        let asked =
            || Error::invalid("the mesh was not asked for").with_cure("ask for the mesh with its generators");
        self.mesh.clone().ok_or_else(asked)
    }
}
