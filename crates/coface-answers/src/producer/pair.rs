//! A model relative to a part of it.

use super::{Cells, Producer};
use coface_algebra::RaggedArray;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, Error};
use coface_io::{Model, Structure};

/// A complex relative to a subcomplex that a user named: the boundary, or the cells of another model.
///
/// The homology of [`Self::chains`] is the relative homology of the pair.
///
/// # References
/// J. R. Munkres, *Elements of Algebraic Topology* (1984), section 9.
///
/// # Examples
/// A disk modulo its rim is a sphere but for one point: only degree 2 is left.
/// ```
/// use coface_algebra::{CellId, RaggedArray};
/// use coface_io::{Model, Structure};
/// use coface_answers::{Pair, Producer};
/// use coface_topology::homology;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let disk = RaggedArray::from_lists([[0, 1, 2], [0, 2, 3]]);
/// let producer = Producer::of(Model::from_structure(Structure::Facets(disk)))?;
/// let pair = Pair::with_boundary(&producer, &producer.chain_complex()?)?;
/// assert_eq!(homology(pair.chains()).betti_numbers(), [0, 0, 1]);
/// assert_eq!(pair.cell(1, CellId::new(0)), CellId::new(1), "the diagonal is the only edge left");
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct Pair {
    chains: ChainComplex,
    /// The numbers of the cells that are left, for each degree.
    kept: Vec<Vec<CellId>>,
}

impl Pair {
    /// A complex modulo nothing.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{Pair, Producer};
    /// let disk = coface_io::read(&b"[[0,1,2],[0,2,3]]"[..], coface_io::Format::Json)?;
    /// let disk = Producer::of(disk)?;
    /// let whole = disk.chain_complex()?;
    /// let pair = Pair::with_boundary(&disk, &whole)?;
    /// assert_eq!(Pair::absolute(whole).chains().f_vector(), [4, 5, 2]);
    /// # Ok(()) }
    /// ```
    pub fn absolute(complex: ChainComplex) -> Self {
        let kept = complex.f_vector().iter().map(|&count| (0..count).map(CellId::new).collect()).collect();
        Self { chains: complex, kept }
    }

    /// The complex of a producer modulo its boundary: the ridges that lie in just one top cell, and their faces; of a
    /// gluing table, the facets without gluing and their faces.
    ///
    /// # Errors
    /// [`Shape`](coface_algebra::ErrorKind::Shape) if the complex is not that of the producer.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{Pair, Producer};
    /// let disk = coface_io::read(&b"[[0,1,2],[0,2,3]]"[..], coface_io::Format::Json)?;
    /// let disk = Producer::of(disk)?;
    /// let whole = disk.chain_complex()?;
    /// let pair = Pair::with_boundary(&disk, &whole)?;
    /// assert_eq!(pair.chains().f_vector(), [0, 1, 2], "the diagonal and the triangles are left");
    /// # Ok(()) }
    /// ```
    pub fn with_boundary(producer: &Producer, complex: &ChainComplex) -> Result<Self, Error> {
        if let Cells::Gluings(gluings) = &producer.cells {
            // A facet glued to another of its simplex may cancel in the matrix, and so do the ends of a loop.
            let part = gluings.1.boundary_cells()?;
            return Ok(Self { chains: complex.relative(&part)?, kept: complex.complement(&part)? });
        }
        let mut part = nothing(complex);
        if let Some(top) = complex.dimension().filter(|&dimension| dimension > 0)
            && let Some(matrix) = complex.boundary_matrix(top)
        {
            let mut degrees = vec![0_u32; matrix.row_count()];
            for &row in matrix.rows() {
                degrees[row as usize] += 1;
            }
            part[top - 1] = degrees.iter().map(|&degree| degree == 1).collect();
        }
        Self::modulo(complex, part)
    }

    /// The complex of a producer modulo the cells of a model with the same vertex numbers, and their faces.
    ///
    /// # Errors
    /// [`NotInComplex`](coface_algebra::ErrorKind::NotInComplex) naming a cell of the model that the producer does not have;
    /// [`InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if the model has no cells that are told by their vertices.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{Pair, Producer};
    /// let disk = coface_io::read(&b"[[0,1,2],[0,2,3]]"[..], coface_io::Format::Json)?;
    /// let disk = Producer::of(disk)?;
    /// let whole = disk.chain_complex()?;
    /// let pair = Pair::with_boundary(&disk, &whole)?;
    /// let edge = coface_io::read(&b"[[0,1]]"[..], coface_io::Format::Json)?;
    /// assert_eq!(Pair::with_model(&disk, &whole, &edge)?.chains().f_vector(), [2, 4, 2]);
    /// # Ok(()) }
    /// ```
    pub fn with_model(producer: &Producer, complex: &ChainComplex, model: &Model) -> Result<Self, Error> {
        if !producer.names_cells_by_vertices() {
            return Err(Error::invalid("the cells of the model are not told by their vertices")
                .with_cure("take it relative to its boundary, or give it as facets, polygons or cells"));
        }
        let mut part = nothing(complex);
        for (degree, cell) in
            producer.cells_with_vertices(complex, cells_of(model)?.iter(), None)?.into_iter().flatten()
        {
            part[degree][cell.index()] = true;
        }
        Self::modulo(complex, part)
    }

    /// The complex modulo the marked cells and their faces.
    fn modulo(complex: &ChainComplex, mut part: Vec<Vec<bool>>) -> Result<Self, Error> {
        for degree in (1..part.len()).rev() {
            let Some(matrix) = complex.boundary_matrix(degree) else { continue };
            let (below, above) = part.split_at_mut(degree);
            for (cell, _) in above[0].iter().enumerate().filter(|&(_, &marked)| marked) {
                for &row in matrix.column(cell).rows() {
                    below[degree - 1][row as usize] = true;
                }
            }
        }
        let listed =
            |marks: &Vec<bool>| (0..marks.len()).filter(|&cell| marks[cell]).map(CellId::new).collect();
        let part: Vec<Vec<CellId>> = part.iter().map(listed).collect();
        Ok(Self { chains: complex.relative(&part)?, kept: complex.complement(&part)? })
    }

    /// The chain complex of the pair.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{Pair, Producer};
    /// let disk = coface_io::read(&b"[[0,1,2],[0,2,3]]"[..], coface_io::Format::Json)?;
    /// let disk = Producer::of(disk)?;
    /// let whole = disk.chain_complex()?;
    /// let pair = Pair::with_boundary(&disk, &whole)?;
    /// assert_eq!(pair.chains().f_vector(), [0, 1, 2]);
    /// # Ok(()) }
    /// ```
    pub fn chains(&self) -> &ChainComplex {
        &self.chains
    }

    /// The number, in the whole complex, of a cell of the pair.
    ///
    /// # Panics
    /// If there is no such cell.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_algebra::CellId;
    /// use coface_answers::{Pair, Producer};
    /// let disk = coface_io::read(&b"[[0,1,2],[0,2,3]]"[..], coface_io::Format::Json)?;
    /// let disk = Producer::of(disk)?;
    /// let whole = disk.chain_complex()?;
    /// let pair = Pair::with_boundary(&disk, &whole)?;
    /// assert_eq!(pair.cell(2, CellId::new(1)), CellId::new(1));
    /// # Ok(()) }
    /// ```
    pub fn cell(&self, degree: usize, cell: CellId) -> CellId {
        self.kept[degree][cell.index()]
    }

    /// The cells of the subcomplex by degree, as numbers in the whole complex.
    ///
    /// # Errors
    /// [`NotInComplex`](coface_algebra::ErrorKind::NotInComplex) if `whole` is not the complex that the pair was made of.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{Pair, Producer};
    /// let disk = coface_io::read(&b"[[0,1,2],[0,2,3]]"[..], coface_io::Format::Json)?;
    /// let disk = Producer::of(disk)?;
    /// let whole = disk.chain_complex()?;
    /// let pair = Pair::with_boundary(&disk, &whole)?;
    /// assert_eq!(pair.subcomplex(&whole)?[1].len(), 4, "the edges of the boundary");
    /// # Ok(()) }
    /// ```
    pub fn subcomplex(&self, whole: &ChainComplex) -> Result<Vec<Vec<CellId>>, Error> {
        whole.complement(&self.kept)
    }

    /// The number, in the pair, of a cell of the whole complex; `None` if it is in the subcomplex or not there.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_algebra::CellId;
    /// use coface_answers::{Pair, Producer};
    /// let disk = coface_io::read(&b"[[0,1,2],[0,2,3]]"[..], coface_io::Format::Json)?;
    /// let disk = Producer::of(disk)?;
    /// let whole = disk.chain_complex()?;
    /// let pair = Pair::with_boundary(&disk, &whole)?;
    /// let cell = CellId::new(1);
    /// assert_eq!((pair.position(0, cell), pair.position(2, cell)), (None, Some(cell)));
    /// # Ok(()) }
    /// ```
    pub fn position(&self, degree: usize, cell: CellId) -> Option<CellId> {
        self.kept.get(degree)?.binary_search(&cell).ok().map(CellId::new)
    }
}

fn nothing(complex: &ChainComplex) -> Vec<Vec<bool>> {
    complex.f_vector().iter().map(|&count| vec![false; count]).collect()
}

/// The cells of a model that are given by vertices.
fn cells_of(model: &Model) -> Result<RaggedArray, Error> {
    match model.structure() {
        Some(Structure::Facets(facets)) => Ok(facets.clone()),
        Some(_) => Err(Error::invalid("the subcomplex has no cells that are told by their vertices")
            .with_cure("give it as a facet list")),
        None => {
            let mut lists = RaggedArray::new();
            model.cells().iter().chain(model.polygons().iter()).for_each(|list| lists.push(list));
            model.lines().iter().for_each(|line| line.windows(2).for_each(|pair| lists.push(pair)));
            model.points().iter().for_each(|vertex| lists.push(&[vertex.to_u32()]));
            Ok(lists)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::ErrorKind;
    use coface_topology::homology;

    fn producer(facets: &[Vec<u32>]) -> Producer {
        Producer::of(Model::from_structure(Structure::Facets(RaggedArray::from_lists(facets)))).unwrap()
    }

    fn modulo(facets: &[Vec<u32>], part: &[Vec<u32>]) -> Result<Pair, Error> {
        let part = Model::from_structure(Structure::Facets(RaggedArray::from_lists(part)));
        let producer = producer(facets);
        Pair::with_model(&producer, &producer.chain_complex().unwrap(), &part)
    }

    #[test]
    fn modulo_one_vertex_homology_is_reduced() {
        let rim = [vec![4, 5], vec![5, 9], vec![4, 9], vec![20, 21]];
        let pair = modulo(&rim, &[vec![5]]).unwrap();
        assert_eq!(homology(pair.chains()).betti_numbers(), [1, 1]);
    }

    #[test]
    fn a_moebius_band_modulo_its_rim_is_a_projective_plane() {
        let band = [[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 0], [4, 0, 1]].map(|t| t.to_vec());
        let band = producer(&band);
        let pair = Pair::with_boundary(&band, &band.chain_complex().unwrap()).unwrap();
        let groups = homology(pair.chains());
        let groups: Vec<String> = groups.groups().iter().map(ToString::to_string).collect();
        assert_eq!(groups, ["0", "Z/2", "0"]);
    }

    #[test]
    fn everything_modulo_everything_is_nothing() {
        let triangle = [vec![0, 1, 2]];
        let pair = modulo(&triangle, &triangle).unwrap();
        assert_eq!(pair.chains().f_vector(), [0, 0, 0]);
        let error = modulo(&triangle, &[vec![0, 3]]).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::NotInComplex);
        assert!(error.to_string().contains("[0, 3]"));
    }
}
