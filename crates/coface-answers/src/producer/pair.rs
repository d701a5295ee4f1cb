//! A model relative to a part of it.

use super::{Cells, Producer};
use coface_algebra::RaggedArray;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, Error, ErrorKind};
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
        Self::divided(complex, rim(complex))
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
        let cells = Self::cells_of_model(producer, complex, model)?;
        Self::divided(complex, marked(complex, cells)?)
    }

    /// The cells of a producer that another model names.
    pub(crate) fn cells_of_model(
        producer: &Producer,
        complex: &ChainComplex,
        model: &Model,
    ) -> Result<Vec<(usize, CellId)>, Error> {
        if !producer.names_cells_by_vertices() {
            return Err(Error::invalid("the cells of the model are not told by their vertices")
                .with_cure("take it relative to its boundary, or give it as facets, polygons or cells"));
        }
        let lists = cells_of(model)?;
        let found = producer.cells_with_vertices(complex, lists.iter(), None)?;
        Ok(found.into_iter().flatten().collect())
    }

    /// The part of a complex that some cells and their faces are, modulo nothing.
    ///
    /// # Errors
    /// [`NotInComplex`](coface_algebra::ErrorKind::NotInComplex) for a cell that is not there.
    ///
    /// # Complexity
    /// Linear in the complex.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_algebra::CellId;
    /// use coface_answers::{Pair, Producer};
    /// let disk = Producer::of(coface_io::read(&b"[[0,1,2],[0,2,3]]"[..], coface_io::Format::Json)?)?;
    /// let half = Pair::of_cells(&disk.chain_complex()?, &[(2, CellId::new(1))])?;
    /// assert_eq!(half.chains().f_vector(), [3, 3, 1]);
    /// assert_eq!(half.modulo_boundary()?.chains().f_vector(), [0, 0, 1]);
    /// # Ok(()) }
    /// ```
    pub fn of_cells(complex: &ChainComplex, cells: &[(usize, CellId)]) -> Result<Self, Error> {
        let kept = listed(&closed(complex, marked(complex, cells.iter().copied())?));
        Ok(Self { chains: complex.subcomplex(&kept)?, kept })
    }

    /// What is left modulo the ridges that lie in just one top cell of what was there, and their faces.
    ///
    /// # Errors
    /// None for a pair that was made here.
    ///
    /// # Examples
    /// See [`Self::of_cells`].
    pub fn modulo_boundary(self) -> Result<Self, Error> {
        let part = rim(&self.chains);
        self.modulo(part)
    }

    /// What is left modulo more cells of the whole complex and their faces; those that are not in the pair do not count.
    ///
    /// # Errors
    /// [`NotInComplex`](coface_algebra::ErrorKind::NotInComplex) for a cell that is not in the whole complex.
    ///
    /// # Complexity
    /// Linear in the complex.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_algebra::CellId;
    /// use coface_answers::{Pair, Producer};
    /// let disk = Producer::of(coface_io::read(&b"[[0,1,2],[0,2,3]]"[..], coface_io::Format::Json)?)?;
    /// let whole = disk.chain_complex()?;
    /// let diagonal = (1, CellId::new(1));
    /// assert_eq!(Pair::absolute(whole.clone()).modulo_cells(&whole, &[diagonal])?.chains().f_vector(), [2, 4, 2]);
    /// # Ok(()) }
    /// ```
    pub fn modulo_cells(self, whole: &ChainComplex, cells: &[(usize, CellId)]) -> Result<Self, Error> {
        let marks = closed(whole, marked(whole, cells.iter().copied())?);
        let kept = self.kept.iter().zip(&marks);
        let part = kept.map(|(kept, marks)| kept.iter().map(|cell| marks[cell.index()]).collect()).collect();
        self.modulo(part)
    }

    /// What is left modulo marked cells of the pair and their faces.
    fn modulo(self, part: Vec<Vec<bool>>) -> Result<Self, Error> {
        let left = Self::divided(&self.chains, part)?;
        let in_whole = |(left, kept): (Vec<CellId>, &Vec<CellId>)| {
            left.into_iter().map(|cell| kept[cell.index()]).collect()
        };
        Ok(Self { chains: left.chains, kept: left.kept.into_iter().zip(&self.kept).map(in_whole).collect() })
    }

    /// A complex modulo the marked cells and their faces.
    fn divided(complex: &ChainComplex, part: Vec<Vec<bool>>) -> Result<Self, Error> {
        let part = listed(&closed(complex, part));
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

    /// The cells of the pair by degree, as rising numbers in the whole complex.
    pub(crate) fn cells(&self) -> &[Vec<CellId>] {
        &self.kept
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

/// Marks on cells, for each degree.
fn marked(
    complex: &ChainComplex,
    cells: impl IntoIterator<Item = (usize, CellId)>,
) -> Result<Vec<Vec<bool>>, Error> {
    let mut marks: Vec<Vec<bool>> = complex.f_vector().iter().map(|&count| vec![false; count]).collect();
    for (degree, cell) in cells {
        let mark = marks.get_mut(degree).and_then(|marks| marks.get_mut(cell.index()));
        *mark.ok_or_else(|| {
            Error::new(
                ErrorKind::NotInComplex,
                format!("there is no cell {} of degree {degree}", cell.index()),
            )
        })? = true;
    }
    Ok(marks)
}

/// Marks on the faces of marked cells too.
fn closed(complex: &ChainComplex, mut marks: Vec<Vec<bool>>) -> Vec<Vec<bool>> {
    for degree in (1..marks.len()).rev() {
        let Some(matrix) = complex.boundary_matrix(degree) else { continue };
        let (below, above) = marks.split_at_mut(degree);
        for (cell, _) in above[0].iter().enumerate().filter(|&(_, &marked)| marked) {
            for &row in matrix.column(cell).rows() {
                below[degree - 1][row as usize] = true;
            }
        }
    }
    marks
}

/// The marked cells, for each degree in rising order.
fn listed(marks: &[Vec<bool>]) -> Vec<Vec<CellId>> {
    let of_degree =
        |marks: &Vec<bool>| (0..marks.len()).filter(|&cell| marks[cell]).map(CellId::new).collect();
    marks.iter().map(of_degree).collect()
}

/// Marks on the ridges that lie in just one top cell.
fn rim(complex: &ChainComplex) -> Vec<Vec<bool>> {
    let mut marks: Vec<Vec<bool>> = complex.f_vector().iter().map(|&count| vec![false; count]).collect();
    if let Some(top) = complex.dimension().filter(|&dimension| dimension > 0)
        && let Some(matrix) = complex.boundary_matrix(top)
    {
        let mut degrees = vec![0_u32; matrix.row_count()];
        for &row in matrix.rows() {
            degrees[row as usize] += 1;
        }
        marks[top - 1] = degrees.iter().map(|&degree| degree == 1).collect();
    }
    marks
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
