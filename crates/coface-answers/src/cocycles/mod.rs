//! First cohomology: a basis of integral cocycles dual to loops, harmonic forms, and the test of one cochain.
//!
//! * [`CocyclesRequest`] asks for a basis; [`FoundCocycles`] has it, makes the [`CocyclesAnswer`] and the model of the
//!   edges with the values as data.
//! * [`SurfaceCocycles`] is the part of it that needs a surface and nothing of its file, [`surface_harmonic_forms`] too.
//! * [`tested_cochain`] says whether a [`GivenCochain`] is closed and exact.

mod certificate;
mod surface;
mod testing;

pub use surface::{SurfaceCocycles, surface_harmonic_forms};
pub use testing::{GivenCochain, tested_cochain};

use crate::answer::{
    CocycleBasisMethod, CocyclesAnswer, EdgeWeights, HarmonicFormAnswer, LoopAnswer, LoopIntersections,
    Remark, WholeNumber,
};
use crate::{CellNames, Domain, Pair, Producer, edge_lengths};
use coface_algebra::chains::{Chain, ChainComplex, Cochain};
use coface_algebra::progress::stage;
use coface_algebra::{CellId, EdgeId, Error, ErrorKind, Integer, RaggedArray};
use coface_complexes::surface::GeneralizedMap;
use coface_io::{CellData, GroupKind, Model};
use coface_topology::{HarmonicForm, HomologyBasis};

/// What to do where lengths cannot be measured.
const FINITE: &str = "take uniform weights, or give the point finite coordinates";

/// Asks for a basis of the first cohomology.
///
/// # Examples
/// A triangle without its inside has one cocycle.
/// ```
/// use coface_answers::{CocyclesRequest, Producer};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let rim = Producer::of(coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?)?;
/// let found = CocyclesRequest::new().found(&rim)?;
/// assert_eq!(found.answer("rim.json").rank, 1);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, Default)]
pub struct CocyclesRequest {
    method: Option<CocycleBasisMethod>,
    is_harmonic: bool,
    weights: Option<EdgeWeights>,
    domain: Domain,
    mesh: Option<Model>,
}

impl CocyclesRequest {
    /// Asks for cocycles, by crossing on surfaces and in general elsewhere.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CocyclesRequest, Producer};
    /// let rim = Producer::of(coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?)?;
    /// let found = CocyclesRequest::new().found(&rim)?;
    /// assert_eq!(found.cocycles().len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn new() -> Self {
        Self::default()
    }

    /// How they are found; `None` is by crossing on surfaces, and in general elsewhere.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::answer::CocycleBasisMethod;
    /// use coface_answers::{CocyclesRequest, Producer};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let disk = Producer::of(coface_io::read(&b"[[0,1,2]]"[..], coface_io::Format::Json)?)?;
    /// let request = CocyclesRequest::new().method(Some(CocycleBasisMethod::General));
    /// assert_eq!(request.found(&disk)?.method(), CocycleBasisMethod::General);
    /// # Ok(()) }
    /// ```
    pub fn method(mut self, method: Option<CocycleBasisMethod>) -> Self {
        self.method = method;
        self
    }

    /// Whether the harmonic form of each class is wanted.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{CocyclesRequest, Producer};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let disk = Producer::of(coface_io::read(&b"[[0,1,2]]"[..], coface_io::Format::Json)?)?;
    /// let found = CocyclesRequest::new().harmonic(true).found(&disk)?;
    /// assert_eq!(found.answer("disk.json").edges.map(|edges| edges.len()), Some(3));
    /// # Ok(()) }
    /// ```
    pub fn harmonic(mut self, is_harmonic: bool) -> Self {
        self.is_harmonic = is_harmonic;
        self
    }

    /// The weights of edges for harmonic forms; `None` is cotangents where they exist, with a remark where they do not.
    pub fn weights(mut self, weights: Option<EdgeWeights>) -> Self {
        self.weights = weights;
        self
    }

    /// The domain and what it is relative to. The mesh is what the producer is made of: it must be given if the domain has groups, or if
    /// [`FoundCocycles::mesh_with_cocycles`] is wanted.
    ///
    /// # Examples
    /// A disk modulo its rim has no cocycles; an annulus modulo its rim has one, which crosses it.
    /// ```
    /// use coface_answers::{CocyclesRequest, Domain, Producer, RelativeTo};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let ring = b"[[0,1,3],[1,3,4],[1,2,4],[2,4,5],[0,2,5],[0,3,5]]";
    /// let ring = Producer::of(coface_io::read(&ring[..], coface_io::Format::Json)?)?;
    /// let domain = Domain { groups: vec![], relative: Some(RelativeTo::Boundary) };
    /// let found = CocyclesRequest::new().domain(domain, None).found(&ring)?;
    /// assert_eq!(found.cocycles().len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn domain(mut self, domain: Domain, mesh: Option<Model>) -> Self {
        (self.domain, self.mesh) = (domain, mesh);
        self
    }

    /// Finds the cocycles. Those of a domain, or relative to a part, are found in general.
    ///
    /// # Errors
    /// Those of [`Domain::pair`] and [`Producer::two_skeleton`]; [`ErrorKind::NonManifold`] if a method of surfaces is asked for and the
    /// model is none; [`ErrorKind::UnsupportedFormat`] if harmonic forms are asked for and the model is no surface.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CocyclesRequest, Producer};
    /// let rim = Producer::of(coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?)?;
    /// let found = CocyclesRequest::new().found(&rim)?;
    /// assert_eq!(found.answer("rim.json").rank, 1);
    /// # Ok(()) }
    /// ```
    pub fn found<'a>(&self, producer: &'a Producer) -> Result<FoundCocycles<'a>, Error> {
        let map = self.surface(producer)?;
        let lengths = map.as_ref().and_then(|map| edge_lengths(map.skeleton(), producer.positions()));
        let steps = stage("finding cocycles", 0);
        let mut found = match &map {
            Some(map) => {
                let is_slicing = self.method == Some(CocycleBasisMethod::Slicing);
                let on_surface = SurfaceCocycles::new(map, lengths.as_deref(), is_slicing)
                    .map_err(|error| named_walk(error, producer))?;
                FoundCocycles::of_surface(producer, map, &on_surface)
            }
            None => FoundCocycles::in_general(producer, &self.domain, self.mesh.as_ref())?,
        };
        if let Some(mesh) = &self.mesh {
            found.mesh = Some((mesh.clone(), self.domain.words(mesh)?));
        }
        drop(steps);
        if self.is_harmonic {
            let _steps = stage("spreading harmonic forms", 0);
            let Some(map) = &map else {
                return Err(Error::new(
                    ErrorKind::UnsupportedFormat,
                    "harmonic one-forms with weights are for surfaces",
                )
                .with_cure(
                    "ask for harmonic cochains of the complex: coface homology --cohomology --harmonic",
                ));
            };
            if self.weights != Some(EdgeWeights::Uniform) {
                producer.require_finite().map_err(|error| error.with_cure(FINITE))?;
            }
            let (weights, forms, remark) =
                surface_harmonic_forms(map, &found.cocycles, lengths.as_deref(), self.weights)?;
            let names = CellNames::of(producer);
            let edges = (0..map.skeleton().edge_count()).map(CellId::new);
            found.remarks.extend(remark);
            found.harmonic =
                Some(Harmonic { weights, edges: edges.map(|edge| names.vertices(1, edge)).collect(), forms });
        }
        Ok(found)
    }

    /// The surface whose cocycles are asked for, if they are not those of a complex in general.
    fn surface(&self, producer: &Producer) -> Result<Option<GeneralizedMap>, Error> {
        const GENERAL: &str = "take the method general, which serves for every model";
        if !self.domain.is_whole() {
            return match self.method {
                None | Some(CocycleBasisMethod::General) => Ok(None),
                Some(_) => {
                    Err(Error::invalid("cocycles relative to a part, or of groups, are found in general")
                        .with_cure(GENERAL))
                }
            };
        }
        match (self.method, GeneralizedMap::new(producer.two_skeleton()?)) {
            (Some(CocycleBasisMethod::General), _) | (None, Err(_)) => Ok(None),
            (_, Ok(map)) => Ok(Some(map)),
            (Some(_), Err(error)) => Err(error.with_cure(GENERAL)),
        }
    }
}

/// A basis of the first cohomology of a model.
#[derive(Clone, Debug)]
pub struct FoundCocycles<'a> {
    producer: &'a Producer,
    /// The domain relative to a part, if it is not the whole model.
    pair: Option<Pair>,
    /// The mesh to write the cocycles into, and the words of the domain.
    mesh: Option<(Model, String)>,
    method: CocycleBasisMethod,
    cocycles: Vec<Cochain<Integer>>,
    loops: Vec<LoopAnswer>,
    pairing: Vec<Vec<Integer>>,
    determinant: Option<Integer>,
    intersection: Option<(Vec<Vec<i64>>, Option<Integer>)>,
    harmonic: Option<Harmonic>,
    remarks: Vec<Remark>,
}

#[derive(Clone, Debug)]
struct Harmonic {
    weights: EdgeWeights,
    edges: Vec<Vec<u32>>,
    forms: Vec<HarmonicForm>,
}

impl<'a> FoundCocycles<'a> {
    fn of_surface(producer: &'a Producer, map: &GeneralizedMap, found: &SurfaceCocycles) -> Self {
        let names = CellNames::of(producer);
        let basis = found.basis();
        let walk = |walk: &coface_topology::ClosedWalk| {
            let vertices = walk.vertices(map.skeleton());
            LoopAnswer::Walk(vertices.into_iter().map(|vertex| names.vertex(vertex)).collect())
        };
        let row = |row: &Vec<i64>| row.iter().map(|&x| Integer::from(x)).collect();
        Self {
            producer,
            pair: None,
            mesh: None,
            method: if found.is_sliced() {
                CocycleBasisMethod::Slicing
            } else {
                CocycleBasisMethod::Crossing
            },
            loops: basis.loops().iter().map(walk).collect(),
            pairing: basis.pairing().iter().map(row).collect(),
            determinant: basis.determinant().cloned(),
            cocycles: basis.cocycles().to_vec(),
            intersection: found
                .intersection()
                .map(|(matrix, determinant)| (matrix.to_vec(), determinant.cloned())),
            harmonic: None,
            remarks: Vec::new(),
        }
    }

    /// The cocycles of a basis of homology, on the free loops of that basis.
    fn in_general(producer: &'a Producer, domain: &Domain, mesh: Option<&Model>) -> Result<Self, Error> {
        let whole = producer.chain_complex()?;
        let pair = domain.pair(producer, &whole, mesh)?;
        let mut found = Self {
            producer,
            pair,
            mesh: None,
            method: CocycleBasisMethod::General,
            cocycles: Vec::new(),
            loops: Vec::new(),
            pairing: Vec::new(),
            determinant: Some(Integer::ONE),
            intersection: None,
            harmonic: None,
            remarks: Vec::new(),
        };
        let complex = found.pair.as_ref().map_or(&whole, Pair::chains);
        if complex.degree_count() < 2 {
            return Ok(found);
        }
        let basis = HomologyBasis::new(complex);
        let free = basis.generators(1).iter().filter(|generator| generator.order().is_none());
        let loops: Vec<&Chain<Integer>> = free.map(|generator| generator.chain()).collect();
        let cocycles = basis.cocycles(1).into_iter().filter(|cocycle| cocycle.order().is_none());
        found.cocycles = cocycles.map(|cocycle| cocycle.cochain().clone()).collect();
        for cocycle in &found.cocycles {
            let value = |chain: &&Chain<Integer>| Ok(cocycle.pairing(chain)?.unwrap_or_default());
            found.pairing.push(loops.iter().map(value).collect::<Result<Vec<Integer>, Error>>()?);
        }
        let one = |i: usize, j: usize| if i == j { Integer::ONE } else { Integer::ZERO };
        let mut rows = found.pairing.iter().enumerate();
        let is_identity = found.pairing.len() == loops.len()
            && rows.all(|(i, row)| row.iter().enumerate().all(|(j, x)| *x == one(i, j)));
        found.determinant = is_identity.then_some(Integer::ONE);
        let names = CellNames::of(producer).within(found.pair.as_ref());
        found.loops = loops.iter().map(|chain| LoopAnswer::Cycle(names.terms(1, chain.terms()))).collect();
        Ok(found)
    }

    /// How the cocycles were found.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CocyclesRequest, Producer};
    /// let rim = Producer::of(coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?)?;
    /// let found = CocyclesRequest::new().found(&rim)?;
    /// assert_eq!(found.method(), coface_answers::answer::CocycleBasisMethod::General);
    /// # Ok(()) }
    /// ```
    pub fn method(&self) -> CocycleBasisMethod {
        self.method
    }

    /// The cocycles.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CocyclesRequest, Producer};
    /// let rim = Producer::of(coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?)?;
    /// let found = CocyclesRequest::new().found(&rim)?;
    /// assert_eq!(found.cocycles()[0].degree(), 1);
    /// # Ok(()) }
    /// ```
    pub fn cocycles(&self) -> &[Cochain<Integer>] {
        &self.cocycles
    }

    /// What was assumed on the way.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CocyclesRequest, Producer};
    /// let rim = Producer::of(coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?)?;
    /// let found = CocyclesRequest::new().found(&rim)?;
    /// assert!(found.remarks().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn remarks(&self) -> &[Remark] {
        &self.remarks
    }

    /// The answer as plain data, with this name of the input.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CocyclesRequest, Producer};
    /// let rim = Producer::of(coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?)?;
    /// let found = CocyclesRequest::new().found(&rim)?;
    /// assert_eq!(found.answer("rim.json").pairing.len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn answer(&self, file: &str) -> CocyclesAnswer {
        let names = CellNames::of(self.producer).within(self.pair.as_ref());
        let row = |row: &Vec<Integer>| row.iter().map(WholeNumber::from).collect();
        let form = |form: &HarmonicForm| HarmonicFormAnswer {
            values: form.values().as_slice().to_vec(),
            closed_residual: form.closed_residual(),
            coclosed_residual: form.coclosed_residual(),
        };
        let harmonic = self.harmonic.as_ref();
        CocyclesAnswer {
            file: file.to_owned(),
            method: self.method,
            rank: self.cocycles.len(),
            pairing: self.pairing.iter().map(row).collect(),
            determinant: self.determinant.as_ref().map(WholeNumber::from),
            loops: self.loops.clone(),
            cocycles: self.cocycles.iter().map(|cocycle| names.terms(1, cocycle.terms())).collect(),
            intersection: self.intersection.as_ref().map(|(matrix, determinant)| LoopIntersections {
                matrix: matrix.clone(),
                determinant: determinant.as_ref().map(WholeNumber::from),
            }),
            weights: harmonic.map(|harmonic| harmonic.weights),
            edges: harmonic.map(|harmonic| harmonic.edges.clone()),
            harmonic: harmonic.map(|harmonic| harmonic.forms.iter().map(form).collect()),
            remarks: self.remarks.clone(),
        }
    }

    /// The model with all edges as lines and the values on them as data: `cocycle_1`, .. and `harmonic_1`, ..; a value
    /// belongs to the direction of its line.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if the model has no positions, or a value is beyond 64 bits.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{CocyclesRequest, Producer};
    /// use coface_io::Format;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let rim = coface_io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\nl 2 3\nl 3 1\n"[..], Format::Obj)?;
    /// let rim = Producer::of(rim)?;
    /// let model = CocyclesRequest::new().found(&rim)?.model()?;
    /// assert_eq!(model.lines().len(), 3);
    /// assert_eq!(model.data()[0].name(), "cocycle_1");
    /// # Ok(()) }
    /// ```
    pub fn model(&self) -> Result<Model, Error> {
        let producer = self.producer;
        producer.require_finite()?;
        if producer.positions().is_empty() || !producer.names_cells_by_vertices() {
            return Err(Error::invalid("the edges of the model have no positions to draw them at")
                .with_cure("write the cocycles as .json"));
        }
        let complex = producer.chain_complex()?;
        let mut model = Model::from_polygons(producer.positions().clone(), cells(producer, &complex, 2))?
            .with_lines(cells(producer, &complex, 1))?;
        let edge_count = model.lines().len();
        for (cocycle, number) in self.cocycles.iter().zip(1..) {
            let mut values = vec![0i64; edge_count];
            for &(edge, ref value) in cocycle.terms() {
                let edge = self.pair.as_ref().map_or(edge, |pair| pair.cell(1, edge));
                values[edge.index()] = value.to_i64().ok_or_else(|| {
                    Error::invalid(format!(
                        "cocycle {number} has the value {value} on an edge, beyond 64 bits"
                    ))
                    .with_cure("write the cocycles as .json")
                })?;
            }
            let name = format!("cocycle_{number}");
            model = model.with_data(CellData::integers(name, GroupKind::Lines, 1, values)?)?;
        }
        let forms = self.harmonic.as_ref().map_or(&[][..], |harmonic| &harmonic.forms);
        for (form, number) in forms.iter().zip(1..) {
            let values = (0..edge_count).map(|edge| form.values()[EdgeId::new(edge)]).collect();
            let name = format!("harmonic_{number}");
            model = model.with_data(CellData::reals(name, GroupKind::Lines, 1, values)?)?;
        }
        Ok(model)
    }
}

impl FoundCocycles<'_> {
    /// The mesh that was given with the domain, with one more group of lines for each cocycle, named as Gmsh names them: `H^1{1},{70}1`.
    /// [`Producer::mesh_with_chains`] says what is in them.
    ///
    /// # Errors
    /// Those of [`Producer::mesh_with_chains`]; [`ErrorKind::InvalidInput`] if no mesh was given.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{CocyclesRequest, Domain, Producer};
    /// use coface_io::Format;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let rim = coface_io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\nl 2 3\nl 3 1\n"[..], Format::Obj)?;
    /// let producer = Producer::of(rim.clone())?;
    /// let request = CocyclesRequest::new().domain(Domain::default(), Some(rim));
    /// let mesh = request.found(&producer)?.mesh_with_cocycles()?;
    /// assert_eq!((mesh.groups()[0].name(), mesh.lines().len()), ("H^1{0}1", 4));
    /// # Ok(()) }
    /// ```
    pub fn mesh_with_cocycles(&self) -> Result<Model, Error> {
        let Some((mesh, words)) = &self.mesh else {
            return Err(Error::invalid("the mesh was not given").with_cure("give the mesh with the domain"));
        };
        let whole = self.producer.chain_complex()?;
        let names = CellNames::of(self.producer).within(self.pair.as_ref());
        let chain = |(cocycle, number): (&Cochain<Integer>, usize)| {
            Ok((format!("H^1{words}{number}"), names.to_model(&whole, 1, cocycle.terms())?))
        };
        let chains = self.cocycles.iter().zip(1..).map(chain).collect::<Result<Vec<_>, Error>>()?;
        self.producer.mesh_with_chains(mesh.clone(), &chains, true)
    }
}

/// The fault of a closed walk with its vertices by their numbers in the file.
fn named_walk(error: Error, producer: &Producer) -> Error {
    const FEW: usize = 32;
    let [walk] = error.cells() else { return error };
    let walk: Vec<u32> =
        walk.iter().flat_map(|&vertex| producer.cell_vertices(0, CellId::from_u32(vertex))).collect();
    let few: Vec<String> = walk.iter().take(FEW).map(u32::to_string).collect();
    let more = if walk.len() > FEW { " .." } else { "" };
    Error::invalid(format!(
        "the loop through vertices {}{more} is one-sided: slicing there leaves a single side and no jump",
        few.join(" ")
    ))
    .with_cells([walk])
    .with_cure("take the cocycles by crossing")
}

/// The cells of one degree, by their vertices.
fn cells(producer: &Producer, complex: &ChainComplex, degree: usize) -> RaggedArray {
    let count = if degree < complex.degree_count() { complex.cell_count(degree) } else { 0 };
    RaggedArray::from_lists((0..count).map(|cell| producer.cell_vertices(degree, CellId::new(cell))))
}
