//! Models taken together and merged.

use super::{BlockRule, CongruenceRequest};
use crate::Producer;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{Error, ErrorKind, VertexId};
use coface_arrange::congruence::{
    BlockMerge, BlockPolicy, CellClasses, ChainCongruence, VertexCongruence, blocks_of, chain_congruence,
    check_blocks, stable_vertex_congruence, vertex_congruence,
};
use coface_geometry::Positions;
use coface_io::{Model, segments};

/// One or more models merged within a tolerance: the quotient of the sum of their chain complexes.
///
/// The vertices, and the cells of each degree, are numbered one model after the other.
///
/// # Examples
/// Two triangles that share an edge in space, each in a model of its own:
/// ```
/// use coface_io as io;
/// use coface_io::Format;
/// use coface_answers::{CongruenceRequest, ModelCongruence};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let a = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
/// let b = io::read(&b"v 1 0 0\nv 1 1 0\nv 0 1 0.001\nf 1 2 3\n"[..], Format::Obj)?;
/// let models = vec![("a".to_owned(), a), ("b".to_owned(), b)];
/// let merged = ModelCongruence::of(models, &CongruenceRequest::within(0.01))?;
/// assert_eq!(merged.f_vector_before(), [6, 6, 2]);
/// assert_eq!(merged.complex().f_vector(), [4, 5, 2]);
/// assert_eq!(merged.to_mesh()?.polygons().list(1), [1, 3, 2]);
/// # Ok(()) }
/// ```
#[derive(Debug)]
pub struct ModelCongruence {
    pub(super) names: Vec<String>,
    pub(super) producers: Vec<Producer>,
    pub(super) listed: Vec<Listed>,
    /// For each degree the number of the first cell of each model, and the number of all.
    pub(super) starts: Vec<Vec<usize>>,
    pub(super) request: CongruenceRequest,
    pub(super) vertices: VertexCongruence,
    pub(super) chains: ChainCongruence,
    pub(super) merges: Option<Vec<BlockMerge>>,
}

impl ModelCongruence {
    /// Merges models, each with its name for people.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for a model without positions or with points of another dimension than the first, for a
    /// tolerance that is none, and for what the request forbids, naming the model; those of [`Producer::of`] and of
    /// [`chain_congruence`].
    ///
    /// # Complexity
    /// Near-linear in the incidences where not many vertices are within the tolerance of one.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CongruenceRequest, ModelCongruence};
    /// // Two triangles with a side in common, whose corners there are 0.001 apart.
    /// let a = coface_io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], coface_io::Format::Obj)?;
    /// let b = coface_io::read(&b"v 1 0 0\nv 1 1 0\nv 0 1 0.001\nf 1 2 3\n"[..], coface_io::Format::Obj)?;
    /// let models = vec![("a".to_owned(), a), ("b".to_owned(), b)];
    /// let merged = ModelCongruence::of(models, &CongruenceRequest::within(0.01))?;
    /// assert_eq!(merged.complex().f_vector(), [4, 5, 2]);
    /// # Ok(()) }
    /// ```
    pub fn of(models: Vec<(String, Model)>, request: &CongruenceRequest) -> Result<Self, Error> {
        let (mut names, mut producers, mut listed) = (Vec::new(), Vec::new(), Vec::new());
        for (name, model) in models {
            listed.push(Listed::of(&model));
            producers.push(Producer::of(model).map_err(|error| error.in_file(name.clone()))?);
            names.push(name);
        }
        let mut complexes = Vec::new();
        for (producer, name) in producers.iter().zip(&names) {
            complexes.push(producer.chain_complex().map_err(|error| error.in_file(name.clone()))?);
        }
        let positions = all_positions(&producers, &complexes, &names)?;
        let degree_count = complexes.iter().map(ChainComplex::degree_count).max().unwrap_or(0);
        let starts: Vec<Vec<usize>> = (0..degree_count).map(|degree| starts(&complexes, degree)).collect();
        let complex = sum(complexes)?;
        let classes = if request.stable { stable_vertex_congruence } else { vertex_congruence };
        let vertices = classes(&positions, request.tolerance, request.rule, request.representative)?;
        let merges = merges(&complex, &positions, &vertices, &starts, request, &names)?;
        let classes = CellClasses::unsigned(vertices.class_of().to_vec())?;
        let chains = chain_congruence(&complex, classes, Some(vertices.positions()), request.options)?;
        Ok(Self { names, producers, listed, starts, request: *request, vertices, chains, merges })
    }

    /// The numbers of cells of all models, by degree.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CongruenceRequest, ModelCongruence};
    /// // Two triangles with a side in common, whose corners there are 0.001 apart.
    /// let a = coface_io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], coface_io::Format::Obj)?;
    /// let b = coface_io::read(&b"v 1 0 0\nv 1 1 0\nv 0 1 0.001\nf 1 2 3\n"[..], coface_io::Format::Obj)?;
    /// let models = vec![("a".to_owned(), a), ("b".to_owned(), b)];
    /// let merged = ModelCongruence::of(models, &CongruenceRequest::within(0.01))?;
    /// assert_eq!(merged.f_vector_before(), [3 + 3, 3 + 3, 1 + 1]);
    /// # Ok(()) }
    /// ```
    pub fn f_vector_before(&self) -> Vec<usize> {
        self.starts.iter().map(|starts| starts.last().copied().unwrap_or(0)).collect()
    }

    /// The quotient.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CongruenceRequest, ModelCongruence};
    /// // Two triangles with a side in common, whose corners there are 0.001 apart.
    /// let a = coface_io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], coface_io::Format::Obj)?;
    /// let b = coface_io::read(&b"v 1 0 0\nv 1 1 0\nv 0 1 0.001\nf 1 2 3\n"[..], coface_io::Format::Obj)?;
    /// let models = vec![("a".to_owned(), a), ("b".to_owned(), b)];
    /// let merged = ModelCongruence::of(models, &CongruenceRequest::within(0.01))?;
    /// assert_eq!(merged.complex().f_vector(), [4, 5, 2]);
    /// # Ok(()) }
    /// ```
    pub fn complex(&self) -> &ChainComplex {
        self.chains.complex()
    }

    /// The classes of the vertices and their positions.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CongruenceRequest, ModelCongruence};
    /// // Two triangles with a side in common, whose corners there are 0.001 apart.
    /// let a = coface_io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], coface_io::Format::Obj)?;
    /// let b = coface_io::read(&b"v 1 0 0\nv 1 1 0\nv 0 1 0.001\nf 1 2 3\n"[..], coface_io::Format::Obj)?;
    /// let models = vec![("a".to_owned(), a), ("b".to_owned(), b)];
    /// let merged = ModelCongruence::of(models, &CongruenceRequest::within(0.01))?;
    /// assert_eq!(merged.vertices().class_count(), 4);
    /// # Ok(()) }
    /// ```
    pub fn vertices(&self) -> &VertexCongruence {
        &self.vertices
    }

    /// The classes of the cells of each degree, and which cells collapsed or changed.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CongruenceRequest, ModelCongruence};
    /// // Two triangles with a side in common, whose corners there are 0.001 apart.
    /// let a = coface_io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], coface_io::Format::Obj)?;
    /// let b = coface_io::read(&b"v 1 0 0\nv 1 1 0\nv 0 1 0.001\nf 1 2 3\n"[..], coface_io::Format::Obj)?;
    /// let models = vec![("a".to_owned(), a), ("b".to_owned(), b)];
    /// let merged = ModelCongruence::of(models, &CongruenceRequest::within(0.01))?;
    /// assert_eq!(merged.chains().complex().f_vector(), [4, 5, 2]);
    /// # Ok(()) }
    /// ```
    pub fn chains(&self) -> &ChainCongruence {
        &self.chains
    }

    /// The vertices of one block that became one; `None` if there are no blocks.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CongruenceRequest, ModelCongruence};
    /// // Two triangles with a side in common, whose corners there are 0.001 apart.
    /// let a = coface_io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], coface_io::Format::Obj)?;
    /// let b = coface_io::read(&b"v 1 0 0\nv 1 1 0\nv 0 1 0.001\nf 1 2 3\n"[..], coface_io::Format::Obj)?;
    /// let models = vec![("a".to_owned(), a), ("b".to_owned(), b)];
    /// let merged = ModelCongruence::of(models, &CongruenceRequest::within(0.01))?;
    /// assert!(merged.merges().is_some_and(|merges| merges.is_empty()), "a and b are the blocks");
    /// # Ok(()) }
    /// ```
    pub fn merges(&self) -> Option<&[BlockMerge]> {
        self.merges.as_deref()
    }

    /// Whether the product of any two successive boundary matrices of the quotient is zero, found by multiplying them.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] for products beyond 32 bits.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CongruenceRequest, ModelCongruence};
    /// // Two triangles with a side in common, whose corners there are 0.001 apart.
    /// let a = coface_io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], coface_io::Format::Obj)?;
    /// let b = coface_io::read(&b"v 1 0 0\nv 1 1 0\nv 0 1 0.001\nf 1 2 3\n"[..], coface_io::Format::Obj)?;
    /// let models = vec![("a".to_owned(), a), ("b".to_owned(), b)];
    /// let merged = ModelCongruence::of(models, &CongruenceRequest::within(0.01))?;
    /// assert!(merged.products_are_zero()?);
    /// # Ok(()) }
    /// ```
    pub fn products_are_zero(&self) -> Result<bool, Error> {
        for pair in self.complex().boundary_matrices().windows(2) {
            if !pair[0].product(&pair[1])?.is_zero() {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// The name of the model of a vertex, and its number there.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_algebra::VertexId;
    /// use coface_answers::{CongruenceRequest, ModelCongruence};
    /// // Two triangles with a side in common, whose corners there are 0.001 apart.
    /// let a = coface_io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], coface_io::Format::Obj)?;
    /// let b = coface_io::read(&b"v 1 0 0\nv 1 1 0\nv 0 1 0.001\nf 1 2 3\n"[..], coface_io::Format::Obj)?;
    /// let models = vec![("a".to_owned(), a), ("b".to_owned(), b)];
    /// let merged = ModelCongruence::of(models, &CongruenceRequest::within(0.01))?;
    /// assert_eq!(merged.vertex_source(VertexId::new(4)), ("b", 1));
    /// # Ok(()) }
    /// ```
    pub fn vertex_source(&self, vertex: VertexId) -> (&str, usize) {
        let (model, number) = source(&self.starts[0], vertex.index());
        (&self.names[model], number)
    }

    /// The quotient with the positions of its vertices.
    ///
    /// # Errors
    /// None for a congruence that was made here.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CongruenceRequest, ModelCongruence};
    /// // Two triangles with a side in common, whose corners there are 0.001 apart.
    /// let a = coface_io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], coface_io::Format::Obj)?;
    /// let b = coface_io::read(&b"v 1 0 0\nv 1 1 0\nv 0 1 0.001\nf 1 2 3\n"[..], coface_io::Format::Obj)?;
    /// let models = vec![("a".to_owned(), a), ("b".to_owned(), b)];
    /// let merged = ModelCongruence::of(models, &CongruenceRequest::within(0.01))?;
    /// assert!(merged.to_chains()?.structure().is_some());
    /// # Ok(()) }
    /// ```
    pub fn to_chains(&self) -> Result<Model, Error> {
        Model::from_chains(self.complex().clone(), self.vertices.positions().clone())
    }
}

/// What a model lists by itself, though it may be a face of something else.
#[derive(Debug, Default)]
pub(super) struct Listed {
    pub(super) points: Vec<VertexId>,
    pub(super) segments: Vec<[u32; 2]>,
    pub(super) polygon_count: usize,
}

impl Listed {
    fn of(model: &Model) -> Self {
        Self {
            points: model.points().to_vec(),
            segments: segments(model.lines()),
            polygon_count: model.polygons().len(),
        }
    }
}

/// The model and the number in it of a cell.
pub(super) fn source(starts: &[usize], cell: usize) -> (usize, usize) {
    // Models without cells start where the next one does: the last that starts at the cell or before it has the cell.
    let model = starts.partition_point(|&start| start <= cell) - 1;
    (model, cell - starts[model])
}

fn starts(complexes: &[ChainComplex], degree: usize) -> Vec<usize> {
    let mut total = 0;
    let mut starts = vec![0];
    for complex in complexes {
        total += complex.cell_count(degree);
        starts.push(total);
    }
    starts
}

/// The sum of complexes, by halves, so that no matrix is copied more often than the logarithm of their number.
fn sum(mut complexes: Vec<ChainComplex>) -> Result<ChainComplex, Error> {
    while complexes.len() > 1 {
        let mut halves = Vec::with_capacity(complexes.len().div_ceil(2));
        let mut rest = complexes.into_iter();
        while let Some(complex) = rest.next() {
            halves.push(match rest.next() {
                Some(other) => complex.direct_sum(&other)?,
                None => complex,
            });
        }
        complexes = halves;
    }
    Ok(complexes.pop().unwrap_or_else(|| ChainComplex::of_points(0)))
}

/// The positions of all vertices; of the dimension that all models have.
fn all_positions(
    producers: &[Producer],
    complexes: &[ChainComplex],
    names: &[String],
) -> Result<Positions, Error> {
    let mut coordinates = Vec::new();
    let mut first: Option<(usize, &String)> = None;
    for ((producer, complex), name) in producers.iter().zip(complexes).zip(names) {
        producer.require_finite().map_err(|error| error.in_file(name.clone()))?;
        let (positions, count) = (producer.positions(), complex.cell_count(0));
        if positions.len() != count {
            return Err(Error::invalid(format!("the model has {count} vertices, but no positions"))
                .with_cure("give a format with coordinates, or \"vertices\" beside the matrices in JSON")
                .in_file(name.clone()));
        }
        if count == 0 {
            continue;
        }
        let dimension = positions.dimension();
        let &mut (expected, of) = first.get_or_insert((dimension, name));
        if dimension != expected {
            return Err(Error::invalid(format!(
                "its points have {dimension} coordinates, but those of {of} have {expected}"
            ))
            .with_cure("give all models as many coordinates, with zeros where a model is flat")
            .in_file(name.clone()));
        }
        coordinates.extend_from_slice(positions.as_flat());
    }
    Positions::from_flat(first.map_or(0, |(dimension, _)| dimension), coordinates)
}

/// The merges within blocks, or the error that they are if the request forbids them.
fn merges(
    complex: &ChainComplex,
    positions: &Positions,
    vertices: &VertexCongruence,
    starts: &[Vec<usize>],
    request: &CongruenceRequest,
    names: &[String],
) -> Result<Option<Vec<BlockMerge>>, Error> {
    let blocks: Vec<u32> = match request.blocks {
        BlockRule::None => return Ok(None),
        BlockRule::Components => blocks_of(complex),
        BlockRule::Models => {
            let counts = starts.first().into_iter().flat_map(|starts| starts.windows(2));
            let counts = counts.map(|pair| pair[1] - pair[0]);
            (0..).zip(counts).flat_map(|(block, count)| std::iter::repeat_n(block, count)).collect()
        }
    };
    let found = check_blocks(vertices, positions, &blocks, BlockPolicy::Warn)?;
    if let (BlockPolicy::Forbid, Some(merge)) = (request.within_blocks, found.first()) {
        let [a, b] = [merge.vertices[0], merge.vertices[1]].map(|vertex| source(&starts[0], vertex as usize));
        let part = if request.blocks == BlockRule::Models { "" } else { ", which cells connect," };
        return Err(Error::new(
            ErrorKind::InvalidInput,
            format!(
                "vertices v{} and v{}{part} become one; the nearest two in their class are {} apart",
                a.1, b.1, merge.distance
            ),
        )
        .with_cure(format!("choose a tolerance below {}, or allow merging within blocks", merge.distance))
        .in_file(names[a.0].clone()));
    }
    Ok(Some(found))
}
