//! Persistent homology of a model that grows.
//!
//! * [`PersistenceRequest`] says over which field, and how the model grows: by a [`Growth`].
//! * [`FoundDiagram`] has the diagram and makes the [`PersistenceAnswer`].
//! * A [`RipsRequest`] asks for that of points or distances, or of the flag complex of a graph; [`FoundRips`] has the diagram.
//! * A [`PointFiltration`] has the simplices and the values of a complex that points make, such as their alpha complex, for a [`PersistenceRequest`].
//! * An [`ImageRequest`] asks for that of a [`GreyImage`], whose numbers are those of an array or a volume file; [`FoundImage`] has the diagram, and [`ImageCells`]
//!   finds the cycles of its classes.
//! * A [`GivenZigzag`] is a complex that gains and loses simplices, for [`PersistenceRequest::zigzag`].
//! * A [`VineyardRequest`] asks for the paths of points of a diagram while the function moves; [`write_vines`] writes them as a table.
//! * A [`GivenDiagram`] is one that was written before. A [`DiagramDistanceRequest`] asks how far two are from each other, a [`DiagramCurvesRequest`]
//!   and a [`DiagramImageRequest`] for curves and images.
//! * An [`EulerRequest`] asks for Euler characteristics of what has entered, without homology, also along [`Directions`].
//! * [`write_diagram`] writes a diagram as the text that other programs read, [`write_kinds`] one whose pairs have kinds as a table.

mod certificate;
mod curves;
mod diagram;
mod distance;
mod euler;
mod extended;
mod filtered;
mod given;
mod image;
mod image_certificate;
mod image_cycles;
mod points;
mod points_certificate;
mod vineyard;
mod vineyard_certificate;
mod zigzag;

pub use curves::{CurveValues, DiagramCurveKind, DiagramCurvesRequest, DiagramImageRequest};
pub use diagram::{DiagramFormat, write_diagram, write_kinds};
pub use distance::{DiagramDistanceRequest, DiagramMetric};
pub use euler::{Directions, EulerRequest};
pub use filtered::PointFiltration;
pub use given::GivenDiagram;
pub use image::{FoundImage, GreyImage, ImageRequest};
pub use image_cycles::{FoundImageCycles, ImageCells};
pub use points::{FoundRips, RipsRequest};
pub use vineyard::{VineyardRequest, write_vines};
pub use zigzag::GivenZigzag;

use crate::answer::{PersistenceAnswer, PersistencePairAnswer};
use crate::{CellNames, Domain, Pair, Producer, RelativeTo};
use coface_algebra::chains::{Chain, ChainComplex};
use coface_algebra::progress::stage;
use coface_algebra::{CellId, Error, Integer, VertexId};
use coface_geometry::Positions;
use coface_io::Model;
use coface_topology::{
    Coefficients, Filtration, PersistenceDiagram, PersistencePair, PersistentCycle, image_persistence,
    persistence, persistent_cycles, torsion_primes,
};

/// A function on the vertices of a model.
#[derive(Clone, Debug, PartialEq)]
pub enum VertexFunction {
    /// The coordinate with this number.
    Coordinate(usize),
    /// The number of the vertex.
    Number,
    /// One value for each vertex number, from 0 on.
    Values {
        /// Where they come from.
        place: String,
        /// The values.
        values: Vec<f64>,
    },
}

impl VertexFunction {
    /// The last coordinate, the height; the vertex number where there are no positions.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::VertexFunction;
    /// use coface_geometry::Positions;
    /// assert_eq!(VertexFunction::of_positions(&Positions::default()), VertexFunction::Number);
    /// ```
    pub fn of_positions(positions: &Positions) -> Self {
        positions.dimension().checked_sub(1).map_or(Self::Number, Self::Coordinate)
    }

    /// What the function is called: `x`, `vertex number`, or where the values come from.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::VertexFunction::Coordinate(1).name(), "y");
    /// ```
    pub fn name(&self) -> String {
        match self {
            Self::Coordinate(axis) => {
                ["x", "y", "z"].get(*axis).map_or(format!("coordinate {axis}"), |name| (*name).to_owned())
            }
            Self::Number => "vertex number".to_owned(),
            Self::Values { place, .. } => place.clone(),
        }
    }

    /// The value of each vertex, in the order of the `count` cells of degree 0.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if the model has no such coordinate, or not
    /// as many vertices as there are values.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{Producer, VertexFunction};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = Producer::of(coface_io::read(&b"[[3,8]]"[..], coface_io::Format::Json)?)?;
    /// assert_eq!(VertexFunction::Number.values(&edge, 2)?, [3.0, 8.0]);
    /// assert!(VertexFunction::Coordinate(0).values(&edge, 2).is_err());
    /// # Ok(()) }
    /// ```
    pub fn values(&self, producer: &Producer, count: usize) -> Result<Vec<f64>, Error> {
        let numbers = (0..count).map(|vertex| producer.cell_vertices(0, CellId::new(vertex))[0] as usize);
        let positions = producer.positions();
        if matches!(self, Self::Coordinate(_)) {
            producer.require_finite()?;
        }
        Ok(match self {
            Self::Coordinate(_) if positions.dimension() == 0 => {
                return Err(Error::invalid(format!("there are no positions to take {} from", self.name()))
                    .with_cure("give a file of values: --function FILE"));
            }
            Self::Coordinate(axis) if *axis >= positions.dimension() => {
                let (name, dimension) = (self.name(), positions.dimension());
                return Err(Error::invalid(format!(
                    "there is no coordinate {name}: positions have {dimension} coordinates"
                )));
            }
            Self::Coordinate(axis) => {
                numbers.map(|number| positions.point(VertexId::new(number))[*axis]).collect()
            }
            Self::Number => numbers.map(|number| number as f64).collect(),
            Self::Values { place, values } => {
                let needed = numbers.clone().max().map_or(0, |last| last + 1);
                if values.len() != needed {
                    return Err(Error::invalid(format!("{} values for {needed} vertices", values.len()))
                        .with_cure("write one number a line for each vertex number from 0 on")
                        .in_file(place));
                }
                numbers.map(|number| values[number]).collect()
            }
        })
    }
}

/// How a model grows.
#[derive(Clone, Debug)]
pub enum Growth {
    /// By sublevel sets of a function on vertices: each cell enters with its highest vertex. `None` is
    /// [`VertexFunction::of_positions`].
    Lower(Option<VertexFunction>),
    /// By superlevel sets: each cell enters with its lowest vertex.
    Upper(Option<VertexFunction>),
    /// By values of all cells: a list for each degree.
    Cells {
        /// Where they come from.
        place: String,
        /// The values.
        values: Vec<Vec<f64>>,
    },
    /// By values of some cells, given by their vertices; the others enter with their first coface.
    Listed {
        /// Where they come from.
        place: String,
        /// The cells with their values.
        values: Vec<(Vec<u32>, f64)>,
    },
}

/// Asks for persistent homology.
///
/// # Examples
/// Three points on a line, joined one after the other.
/// ```
/// use coface_answers::{PersistenceRequest, Producer};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let path = Producer::of(coface_io::read(&b"[[0,2],[2,1]]"[..], coface_io::Format::Json)?)?;
/// let found = PersistenceRequest::new().found("path.json", &path)?;
/// let answer = found.answer();
/// // Vertex 1 is joined to vertex 0 when vertex 2 comes.
/// assert_eq!((answer.diagram[1].birth, answer.diagram[1].death), (1.0, Some(2.0)));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct PersistenceRequest {
    coefficients: Coefficients,
    growth: Growth,
    min_persistence: f64,
    cycles: bool,
    most_degree: Option<usize>,
    threshold: Option<f64>,
    /// For each degree the cells as they enter, where values of cells leave that open.
    order: Option<Vec<Vec<u32>>>,
    relative: Option<RelativeTo>,
    image_of: Option<RelativeTo>,
}

impl Default for PersistenceRequest {
    fn default() -> Self {
        let coefficients = Coefficients::Modulo(2);
        let growth = Growth::Lower(None);
        let (most_degree, threshold, order, relative, image_of) = (None, None, None, None, None);
        let (min_persistence, cycles) = (0.0, false);
        Self {
            coefficients,
            growth,
            min_persistence,
            cycles,
            most_degree,
            threshold,
            order,
            relative,
            image_of,
        }
    }
}

impl PersistenceRequest {
    /// Asks for persistence over two elements as the model grows by height.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PersistenceRequest, Producer};
    /// let path = Producer::of(coface_io::read(&b"[[0,2],[2,1]]"[..], coface_io::Format::Json)?)?;
    /// // Vertex 1 is joined to vertex 0 when vertex 2 comes.
    /// assert_eq!(PersistenceRequest::new().found("path", &path)?.answer().diagram.len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn new() -> Self {
        Self::default()
    }

    /// The field of coefficients.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PersistenceRequest, Producer};
    /// let path = Producer::of(coface_io::read(&b"[[0,2],[2,1]]"[..], coface_io::Format::Json)?)?;
    /// let request = PersistenceRequest::new().coefficients(coface_topology::Coefficients::Modulo(3));
    /// assert_eq!(request.found("path", &path)?.answer().field, 3);
    /// # Ok(()) }
    /// ```
    pub fn coefficients(mut self, coefficients: Coefficients) -> Self {
        self.coefficients = coefficients;
        self
    }

    /// How the model grows.
    pub fn growth(mut self, growth: Growth) -> Self {
        self.growth = growth;
        self
    }

    /// Leaves out the pairs whose persistence is not greater; a negative number keeps all.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PersistenceRequest, Producer};
    /// let path = Producer::of(coface_io::read(&b"[[0,2],[2,1]]"[..], coface_io::Format::Json)?)?;
    /// // The class of vertex 1 lives from 1 to 2.
    /// let found = PersistenceRequest::new().min_persistence(1.5).found("path", &path)?;
    /// assert_eq!(found.answer().diagram.len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn min_persistence(mut self, least: f64) -> Self {
        self.min_persistence = least;
        self
    }

    /// Asks for cycles, bounding chains and cocycles of the pairs.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PersistenceRequest, Producer};
    /// let path = Producer::of(coface_io::read(&b"[[0,2],[2,1]]"[..], coface_io::Format::Json)?)?;
    /// let answer = PersistenceRequest::new().cycles(true).found("path", &path)?.answer();
    /// // Vertex 1 is born, less vertex 0, and a path between them ends it.
    /// assert_eq!(answer.diagram[1].cycle.as_ref().map(Vec::len), Some(2));
    /// assert_eq!(answer.diagram[1].bounding_chain.as_ref().map(Vec::len), Some(2));
    /// # Ok(()) }
    /// ```
    pub fn cycles(mut self, cycles: bool) -> Self {
        self.cycles = cycles;
        self
    }

    /// Asks for homology relative to a part of the model: cells of the part are left out, those that are left enter as they do. Cycles are relative ones.
    ///
    /// # Examples
    /// A disk relative to its rim: one class of degree 2, from when all of the disk is there.
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PersistenceRequest, Producer, RelativeTo};
    /// let disk = Producer::of(coface_io::read(&b"[[0,1,2],[0,2,3]]"[..], coface_io::Format::Json)?)?;
    /// let request = PersistenceRequest::new().relative(Some(RelativeTo::Boundary));
    /// let answer = request.found("disk", &disk)?.answer();
    /// assert_eq!((answer.betti, answer.relative_to.as_deref()), (vec![0, 0, 1], Some("boundary")));
    /// assert_eq!((answer.diagram[0].degree, answer.diagram[0].birth), (2, 3.0));
    /// # Ok(()) }
    /// ```
    pub fn relative(mut self, part: Option<RelativeTo>) -> Self {
        self.relative = part;
        self
    }

    /// Asks for the classes of a part of the model as they are seen in the whole: they are born in the part, and die when they bound in the whole.
    ///
    /// # Examples
    /// The rim of a triangle, whose last vertex has the number 2.
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PersistenceRequest, Producer, RelativeTo};
    /// let disk = Producer::of(coface_io::read(&b"[[0,1,2]]"[..], coface_io::Format::Json)?)?;
    /// let request = PersistenceRequest::new().image_of(Some(RelativeTo::Boundary)).min_persistence(-1.0);
    /// let answer = request.found("disk", &disk)?.answer();
    /// let rim = answer.diagram.last().expect("a loop that bounds at once");
    /// assert_eq!((rim.degree, rim.birth, rim.death), (1, 2.0, Some(2.0)));
    /// # Ok(()) }
    /// ```
    pub fn image_of(mut self, part: Option<RelativeTo>) -> Self {
        self.image_of = part;
        self
    }

    /// Asks for the degrees up to one: of a model that lacks its cells of higher degree, those that it tells.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PersistenceRequest, Producer};
    /// let path = Producer::of(coface_io::read(&b"[[0,2],[2,1]]"[..], coface_io::Format::Json)?)?;
    /// assert_eq!(PersistenceRequest::new().up_to_degree(0).found("path", &path)?.answer().betti, [1]);
    /// # Ok(()) }
    /// ```
    pub fn up_to_degree(mut self, degree: usize) -> Self {
        self.most_degree = Some(degree);
        self
    }

    /// Says the largest value of the simplices that were looked at, which the answer tells: of points and graphs alone.
    pub(super) fn threshold(mut self, threshold: f64) -> Self {
        self.threshold = Some(threshold);
        self
    }

    /// Says in which order the cells of each degree enter, of a growth by values of all cells.
    pub(super) fn in_order(mut self, order: Vec<Vec<u32>>) -> Self {
        self.order = Some(order);
        self
    }

    /// Finds the diagram of a model with this name.
    ///
    /// # Errors
    /// Those of [`Producer::chain_complex`] and [`VertexFunction::values`];
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if a cell enters before one of its faces, or
    /// the coefficients are no prime field.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PersistenceRequest, Producer};
    /// let path = Producer::of(coface_io::read(&b"[[0,2],[2,1]]"[..], coface_io::Format::Json)?)?;
    /// assert_eq!(PersistenceRequest::new().found("path", &path)?.answer().betti, [1, 0]);
    /// # Ok(()) }
    /// ```
    pub fn found<'a>(&self, name: &str, producer: &'a Producer) -> Result<FoundDiagram<'a>, Error> {
        self.found_in(name, producer, None)
    }

    /// The same with the model of the producer, which says what its groups are: a part may be one of them.
    ///
    /// # Errors
    /// As [`Self::found`], and those of [`Domain::pair`] where a part is asked for.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PersistenceRequest, Producer, RelativeTo};
    /// let square = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\ng lid\nf 1 2 3\ng rest\nf 1 3 4\n";
    /// let model = coface_io::read(&square[..], coface_io::Format::Obj)?;
    /// let producer = Producer::of(model.clone())?;
    /// let request = PersistenceRequest::new().relative(Some(RelativeTo::Groups(vec!["lid".to_owned()])));
    /// let found = request.found_in("square.obj", &producer, Some(&model))?;
    /// assert_eq!(found.answer().betti, [0, 0, 0], "what is left is a disk relative to an edge");
    /// # Ok(()) }
    /// ```
    pub fn found_in<'a>(
        &self,
        name: &str,
        producer: &'a Producer,
        model: Option<&Model>,
    ) -> Result<FoundDiagram<'a>, Error> {
        let complex = producer.chain_complex()?;
        let relative = self.pair(name, self.relative.as_ref(), producer, &complex, model)?;
        let image = self.pair(name, self.image_of.as_ref(), producer, &complex, model)?;
        let steps = stage("sorting cells", 0);
        let (function, star, filtration) = self.filtration(name, producer, &complex)?;
        drop(steps);
        let found = |filtration, kept, diagram: &PersistenceDiagram, (cycles, torsion_primes)| FoundDiagram {
            producer,
            name: name.to_owned(),
            function,
            star,
            filtration,
            min_persistence: self.min_persistence,
            diagram: diagram.longer_than(self.min_persistence),
            most_degree: self.most_degree,
            threshold: self.threshold,
            cycles,
            torsion_primes,
            kept,
            relative_to: self.relative.as_ref().map(RelativeTo::name),
            image_of: self.image_of.as_ref().map(RelativeTo::name),
            inside: None,
            part: self.relative.as_ref().or(self.image_of.as_ref()).map(|part| match part {
                RelativeTo::Boundary => "boundary",
                RelativeTo::Part { .. } => "file",
                RelativeTo::Groups(_) => "groups",
            }),
        };
        if let Some(image) = image {
            let steps = stage("pairing cells", 0);
            let part = image.subcomplex(&complex)?;
            let whole = self.up_to(image_persistence(&complex, &filtration, &part, self.coefficients)?);
            drop(steps);
            return Ok(FoundDiagram { inside: Some(part), ..found(filtration, None, &whole, (None, None)) });
        }
        let Some(pair) = relative else {
            let (whole, cycles, primes) = self.classes(&complex, &filtration)?;
            return Ok(found(filtration, None, &whole, (cycles, primes)));
        };
        let kept = pair.cells().to_vec();
        let (whole, cycles, primes) = self.classes(pair.chains(), &filtration.restricted(&kept))?;
        let whole = whole.with_cells(&kept);
        Ok(found(filtration, Some(kept), &whole, (cycles, primes)))
    }

    /// The pair of the model and a part, if there is one.
    fn pair(
        &self,
        name: &str,
        part: Option<&RelativeTo>,
        producer: &Producer,
        complex: &ChainComplex,
        model: Option<&Model>,
    ) -> Result<Option<Pair>, Error> {
        let Some(part) = part else { return Ok(None) };
        let refused =
            |message: &str, cure: &str| Err(Error::invalid(message).with_cure(cure.to_owned()).in_file(name));
        if self.relative.is_some() && self.image_of.is_some() {
            return refused(
                "persistence is relative to a part, or of its image in the whole",
                "give one of both",
            );
        }
        if self.image_of.is_some() && self.cycles {
            return refused(
                "there are no cycles of the image of a part",
                "ask for those of the part or of the whole",
            );
        }
        let domain = Domain { groups: Vec::new(), relative: Some(part.clone()) };
        domain.pair(producer, complex, model).map_err(|error| error.in_file(name))
    }

    /// The whole diagram, with cycles and the primes of torsion if cycles are asked for.
    fn classes(&self, complex: &ChainComplex, filtration: &Filtration) -> Result<Classes, Error> {
        let steps = stage("pairing cells", 0);
        let whole = self.up_to(persistence(complex, filtration, self.coefficients)?);
        drop(steps);
        if !self.cycles {
            return Ok((whole, None, None));
        }
        let cycles = persistent_cycles(complex, filtration, &whole, self.min_persistence)?;
        Ok((whole, Some(cycles), Some(torsion_primes(complex, filtration)?)))
    }

    fn up_to(&self, whole: PersistenceDiagram) -> PersistenceDiagram {
        match self.most_degree {
            Some(degree) => whole.up_to_degree(degree),
            None => whole,
        }
    }

    fn filtration(
        &self,
        name: &str,
        producer: &Producer,
        complex: &ChainComplex,
    ) -> Result<(String, Option<&'static str>, Filtration), Error> {
        let (place, filtration) = match &self.growth {
            Growth::Cells { place, values } => {
                let filtration = match &self.order {
                    Some(order) => Filtration::in_order(complex, values.clone(), order.clone()),
                    None => Filtration::new(complex, values.clone()),
                };
                (place, filtration)
            }
            Growth::Listed { place, values } => (place, of_listed(values, producer, complex)),
            Growth::Lower(function) | Growth::Upper(function) => {
                if function.is_none() {
                    // The height is meant where there are coordinates.
                    producer.require_finite().map_err(|error| error.in_file(name))?;
                }
                let function =
                    function.clone().unwrap_or_else(|| VertexFunction::of_positions(producer.positions()));
                let values = function.values(producer, complex.cell_count(0))?;
                let (star, filtration) = match self.growth {
                    Growth::Upper(_) => ("upper", Filtration::upper_star(complex, &values)),
                    _ => ("lower", Filtration::lower_star(complex, &values)),
                };
                let filtration = filtration.map_err(|error| error.in_file(name))?;
                return Ok((function.name(), Some(star), filtration));
            }
        };
        Ok((place.clone(), None, filtration.map_err(|error| error.in_file(place))?))
    }
}

/// A diagram with cycles and the primes of torsion, if they were asked for.
type Classes = (PersistenceDiagram, Option<Vec<PersistentCycle>>, Option<Vec<u32>>);

fn of_listed(
    listed: &[(Vec<u32>, f64)],
    producer: &Producer,
    complex: &ChainComplex,
) -> Result<Filtration, Error> {
    let mut given: Vec<Vec<Option<f64>>> =
        complex.f_vector().iter().map(|&count| vec![None; count]).collect();
    let lists = listed.iter().map(|(vertices, _)| &vertices[..]);
    for (cells, (_, value)) in producer.cells_with_vertices(complex, lists, None)?.iter().zip(listed) {
        for (degree, cell) in cells {
            given[*degree][cell.index()] = Some(*value);
        }
    }
    Filtration::from_cofaces(complex, &given)
}

/// A persistence diagram of a model.
#[derive(Clone, Debug)]
pub struct FoundDiagram<'a> {
    producer: &'a Producer,
    name: String,
    function: String,
    star: Option<&'static str>,
    filtration: Filtration,
    min_persistence: f64,
    diagram: PersistenceDiagram,
    most_degree: Option<usize>,
    threshold: Option<f64>,
    /// In the order of the diagram.
    cycles: Option<Vec<PersistentCycle>>,
    torsion_primes: Option<Vec<u32>>,
    /// The cells that are not in the part, by degree: cycles have their numbers.
    kept: Option<Vec<Vec<CellId>>>,
    relative_to: Option<String>,
    image_of: Option<String>,
    /// The cells of the part whose image it is, by degree.
    inside: Option<Vec<Vec<CellId>>>,
    /// How the part is given: as `boundary`, `file` or `groups`.
    part: Option<&'static str>,
}

impl FoundDiagram<'_> {
    /// The diagram.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PersistenceRequest, Producer};
    /// let path = Producer::of(coface_io::read(&b"[[0,2],[2,1]]"[..], coface_io::Format::Json)?)?;
    /// let found = PersistenceRequest::new().found("path", &path)?;
    /// assert_eq!(found.diagram().pairs().len(), found.answer().diagram.len());
    /// # Ok(()) }
    /// ```
    pub fn diagram(&self) -> &PersistenceDiagram {
        &self.diagram
    }

    /// The cycles of the pairs, in the order of the diagram; `None` unless they were asked for.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PersistenceRequest, Producer};
    /// let path = Producer::of(coface_io::read(&b"[[0,2],[2,1]]"[..], coface_io::Format::Json)?)?;
    /// let found = PersistenceRequest::new().cycles(true).found("path", &path)?;
    /// assert_eq!(found.cycles().map(<[_]>::len), Some(2));
    /// # Ok(()) }
    /// ```
    pub fn cycles(&self) -> Option<&[PersistentCycle]> {
        self.cycles.as_deref()
    }

    /// The cycles and bounding chains as a model on the vertices of the input, a group for each: `H1_0_from_1_to_5` with the place of the class in its
    /// degree, its birth and its death, and `filling_H1_0` for the chain that it bounds.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if cycles were not asked for, and those of [`Producer::picture`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PersistenceRequest, Producer};
    /// let mesh = &b"OFF\n3 1 0\n0 0 0\n1 1 0\n2 0 0\n3 0 1 2\n"[..];
    /// let mesh = Producer::of(coface_io::read(mesh, coface_io::Format::Off)?)?;
    /// let model = PersistenceRequest::new().cycles(true).found("mesh", &mesh)?.cycles_model()?;
    /// assert_eq!(model.groups()[0].name(), "H0_0_from_0_to_inf");
    /// # Ok(()) }
    /// ```
    pub fn cycles_model(&self) -> Result<Model, Error> {
        let cycles = self.cycles.as_deref();
        let cycles =
            cycles.ok_or_else(|| Error::invalid("cycles were not asked for").with_cure("ask for cycles"))?;
        let of_whole = |chain: &Chain<Integer>| {
            Chain::of_cells(chain.degree(), self.placed(chain.degree(), chain.terms()))
        };
        let mut chains = Vec::new();
        let mut places = vec![0; self.diagram.degree_count()];
        for one in cycles {
            let pair = one.pair();
            let (degree, place) = (pair.degree(), places[pair.degree()]);
            places[degree] += 1;
            let death = pair.death().map_or("inf".to_owned(), |death| death.to_string());
            chains.push((
                format!("H{degree}_{place}_from_{}_to_{death}", pair.birth()),
                of_whole(one.cycle())?,
            ));
            if let Some(bounding) = one.bounding_chain() {
                chains.push((format!("filling_H{degree}_{place}"), of_whole(bounding)?));
            }
        }
        self.producer.picture(&chains)
    }

    /// The terms of a chain or cochain with the numbers of cells in the whole model.
    fn placed(&self, degree: usize, terms: &[(CellId, Integer)]) -> Vec<(CellId, Integer)> {
        let cell = |cell: CellId| match &self.kept {
            Some(kept) => kept[degree][cell.index()],
            None => cell,
        };
        terms.iter().map(|(one, coefficient)| (cell(*one), coefficient.clone())).collect()
    }

    /// The answer as plain data, with the vertices of the cells.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PersistenceRequest, Producer};
    /// let path = Producer::of(coface_io::read(&b"[[0,2],[2,1]]"[..], coface_io::Format::Json)?)?;
    /// let answer = PersistenceRequest::new().found("path", &path)?.answer();
    /// assert_eq!((answer.diagram[1].birth, answer.diagram[1].death), (1.0, Some(2.0)));
    /// # Ok(()) }
    /// ```
    pub fn answer(&self) -> PersistenceAnswer {
        let vertices = |degree, cell: CellId| self.producer.cell_vertices(degree, cell);
        let names = CellNames::of(self.producer);
        let pair = |(place, pair): (usize, &PersistencePair)| {
            let cycle = self.cycles.as_ref().map(|cycles| &cycles[place]);
            let terms = |chain: &Chain<Integer>| {
                names.terms(chain.degree(), &self.placed(chain.degree(), chain.terms()))
            };
            PersistencePairAnswer {
                degree: pair.degree(),
                kind: None,
                birth: pair.birth(),
                death: pair.death(),
                birth_cell: vertices(pair.degree(), pair.birth_cell()),
                death_cell: pair.death_cell().map(|cell| vertices(pair.degree() + 1, cell)),
                cycle: cycle.map(|one| terms(one.cycle())),
                bounding_chain: cycle.and_then(|one| one.bounding_chain()).map(terms),
                cocycle: cycle.map(|one| {
                    names.terms(pair.degree(), &self.placed(pair.degree(), one.cocycle().terms()))
                }),
            }
        };
        let mut betti = self.diagram.betti_numbers();
        if let Some(degree) = self.most_degree {
            // Degrees that were asked for, and that no cell has.
            betti.resize(degree + 1, 0);
        }
        PersistenceAnswer {
            file: self.name.clone(),
            field: self.diagram.prime(),
            function: self.function.clone(),
            star: self.star.map(str::to_owned),
            threshold: self.threshold,
            diagram: self.diagram.pairs().iter().enumerate().map(pair).collect(),
            betti,
            torsion_primes: self.torsion_primes.clone(),
            collapsed: None,
            relative_to: self.relative_to.clone(),
            image_of: self.image_of.clone(),
            vertex_names: self.producer.vertex_names().map(<[String]>::to_vec),
            remarks: Vec::new(),
        }
    }
}
