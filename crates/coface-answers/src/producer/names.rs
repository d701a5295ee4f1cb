//! The names of cells in answers: the vertices of the file.

use super::{Pair, Producer};
use crate::answer::{ChainTerm, RealTerm, WholeNumber};
use coface_algebra::chains::{Chain, ChainComplex, Cochain};
use coface_algebra::{CellId, Error, Integer, VertexId};

/// Names the cells of a chain complex that was made from a model: those that a pair keeps, if there is one, and one
/// degree higher if the complex is augmented by the empty simplex.
///
/// # Examples
/// ```
/// use coface_algebra::CellId;
/// use coface_answers::{CellNames, Producer};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let triangle = coface_io::read(&b"[[4,5,9]]"[..], coface_io::Format::Json)?;
/// let producer = Producer::of(triangle)?;
/// let names = CellNames::of(&producer);
/// assert_eq!(names.vertices(2, CellId::new(0)), [4, 5, 9]);
/// assert_eq!(names.word(2, CellId::new(0)), "{v4 v5 v9}");
/// # Ok(()) }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct CellNames<'a> {
    producer: &'a Producer,
    pair: Option<&'a Pair>,
    /// How many degrees the complex stands above the model: 1 for an augmented one.
    shift: usize,
}

impl<'a> CellNames<'a> {
    /// The names of the cells of the complex of a model.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_algebra::CellId;
    /// use coface_answers::{CellNames, Producer};
    /// let edge = Producer::of(coface_io::read(&b"[[3,8]]"[..], coface_io::Format::Json)?)?;
    /// let names = CellNames::of(&edge);
    /// assert_eq!(names.vertices(1, CellId::new(0)), [3, 8]);
    /// # Ok(()) }
    /// ```
    pub fn of(producer: &'a Producer) -> Self {
        Self { producer, pair: None, shift: 0 }
    }

    /// The names of the cells of a complex relative to a subcomplex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_answers::{CellNames, Pair, Producer};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = Producer::of(coface_io::read(&b"[[3,8]]"[..], coface_io::Format::Json)?)?;
    /// let whole = edge.chain_complex()?;
    /// let pair = Pair::with_boundary(&edge, &whole)?;
    /// assert_eq!(CellNames::of(&edge).within(Some(&pair)).vertices(1, CellId::new(0)), [3, 8]);
    /// # Ok(()) }
    /// ```
    pub fn within(self, pair: Option<&'a Pair>) -> Self {
        Self { pair, ..self }
    }

    /// The names where the complex is augmented: the empty simplex has no vertices and stands in degree 0.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_answers::{CellNames, Producer};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = Producer::of(coface_io::read(&b"[[3,8]]"[..], coface_io::Format::Json)?)?;
    /// let names = CellNames::of(&edge).augmented(true);
    /// assert_eq!(names.word(0, CellId::new(0)), "{}");
    /// assert_eq!(names.vertices(2, CellId::new(0)), [3, 8]);
    /// # Ok(()) }
    /// ```
    pub fn augmented(self, is_augmented: bool) -> Self {
        Self { shift: usize::from(is_augmented), ..self }
    }

    /// The model whose cells are named.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CellNames, Producer};
    /// let edge = Producer::of(coface_io::read(&b"[[3,8]]"[..], coface_io::Format::Json)?)?;
    /// let names = CellNames::of(&edge);
    /// assert!(std::ptr::eq(names.producer(), &edge));
    /// # Ok(()) }
    /// ```
    pub fn producer(&self) -> &'a Producer {
        self.producer
    }

    /// How many degrees the complex stands above the model: 1 for an augmented one.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CellNames, Producer};
    /// let edge = Producer::of(coface_io::read(&b"[[3,8]]"[..], coface_io::Format::Json)?)?;
    /// let names = CellNames::of(&edge);
    /// assert_eq!((names.shift(), names.augmented(true).shift()), (0, 1));
    /// # Ok(()) }
    /// ```
    pub fn shift(&self) -> usize {
        self.shift
    }

    /// The terms of a chain or cochain with integers as coefficients.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, Integer};
    /// use coface_answers::answer::WholeNumber;
    /// use coface_answers::{CellNames, Producer};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = Producer::of(coface_io::read(&b"[[3,8]]"[..], coface_io::Format::Json)?)?;
    /// let terms = CellNames::of(&edge).terms(1, &[(CellId::new(0), Integer::from(-2))]);
    /// assert_eq!(terms, [(WholeNumber::Number(-2), vec![3, 8])]);
    /// # Ok(()) }
    /// ```
    pub fn terms(&self, degree: usize, terms: &[(CellId, Integer)]) -> Vec<ChainTerm> {
        let term = |(cell, coefficient): &(CellId, Integer)| {
            let vertices = self.vertices(degree, *cell).into_iter().map(u64::from).collect();
            (WholeNumber::from(coefficient), vertices)
        };
        terms.iter().map(term).collect()
    }

    /// The terms of a real cochain.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_algebra::CellId;
    /// use coface_answers::{CellNames, Producer};
    /// let edge = Producer::of(coface_io::read(&b"[[3,8]]"[..], coface_io::Format::Json)?)?;
    /// let names = CellNames::of(&edge);
    /// let cochain = coface_algebra::chains::Cochain::new(&edge.chain_complex()?, 1, [(CellId::new(0), 0.5)])?;
    /// assert_eq!(names.real_terms(&cochain), [(0.5, vec![3, 8])]);
    /// # Ok(()) }
    /// ```
    pub fn real_terms(&self, cochain: &Cochain<f64>) -> Vec<RealTerm> {
        let term = |&(cell, value): &(CellId, f64)| (value, self.vertices(cochain.degree(), cell));
        cochain.terms().iter().map(term).collect()
    }

    /// The number in the model of a cell of the complex.
    fn cell(&self, degree: usize, cell: CellId) -> CellId {
        self.pair.map_or(cell, |pair| pair.cell(degree, cell))
    }

    /// The name of a cell of the complex: its vertices in the file, or its number where cells have no vertices.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_algebra::CellId;
    /// use coface_answers::{CellNames, Producer};
    /// let edge = Producer::of(coface_io::read(&b"[[3,8]]"[..], coface_io::Format::Json)?)?;
    /// let names = CellNames::of(&edge);
    /// assert_eq!(names.vertices(0, CellId::new(1)), [8]);
    /// # Ok(()) }
    /// ```
    pub fn vertices(&self, degree: usize, cell: CellId) -> Vec<u32> {
        match degree.checked_sub(self.shift) {
            Some(degree) => self.producer.cell_vertices(degree, self.cell(degree, cell)),
            // The empty simplex, below all vertices.
            None => Vec::new(),
        }
    }

    /// The number of a vertex in the file.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CellNames, Producer};
    /// let edge = Producer::of(coface_io::read(&b"[[3,8]]"[..], coface_io::Format::Json)?)?;
    /// let names = CellNames::of(&edge);
    /// assert_eq!(names.vertex(coface_algebra::VertexId::new(1)), 8);
    /// # Ok(()) }
    /// ```
    pub fn vertex(&self, vertex: VertexId) -> u32 {
        self.vertices(self.shift, CellId::new(vertex.index()))[0]
    }

    /// The name of a cell of the complex, as people read it.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_algebra::CellId;
    /// use coface_answers::{CellNames, Producer};
    /// let edge = Producer::of(coface_io::read(&b"[[3,8]]"[..], coface_io::Format::Json)?)?;
    /// let names = CellNames::of(&edge);
    /// assert_eq!(names.word(1, CellId::new(0)), "{v3 v8}");
    /// # Ok(()) }
    /// ```
    pub fn word(&self, degree: usize, cell: CellId) -> String {
        self.word_of(&self.vertices(degree, cell))
    }

    /// A name as people read it: `{v0 v3}`, or `{cell 7}` where cells have no vertices.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{CellNames, Producer};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = Producer::of(coface_io::read(&b"[[3,8]]"[..], coface_io::Format::Json)?)?;
    /// assert_eq!(CellNames::of(&edge).word_of(&[3, 8]), "{v3 v8}");
    /// # Ok(()) }
    /// ```
    pub fn word_of<T: std::fmt::Display>(&self, name: &[T]) -> String {
        match name {
            [cell] if !self.producer.names_cells_by_vertices() => format!("{{cell {cell}}}"),
            vertices => {
                let vertices: Vec<String> = vertices.iter().map(|vertex| format!("v{vertex}")).collect();
                format!("{{{}}}", vertices.join(" "))
            }
        }
    }

    /// A chain of the complex as one of the model, whose complex is `whole`.
    ///
    /// # Errors
    /// Those of [`Chain::new`], if the cells are none of the complex.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_algebra::CellId;
    /// use coface_answers::{CellNames, Producer};
    /// let edge = Producer::of(coface_io::read(&b"[[3,8]]"[..], coface_io::Format::Json)?)?;
    /// let names = CellNames::of(&edge);
    /// let whole = edge.chain_complex()?;
    /// let chain = names.to_model(&whole, 1, &[(CellId::new(0), 2.into())])?;
    /// assert_eq!(chain.terms(), [(CellId::new(0), 2.into())]);
    /// # Ok(()) }
    /// ```
    pub fn to_model(
        &self,
        whole: &ChainComplex,
        degree: usize,
        terms: &[(CellId, Integer)],
    ) -> Result<Chain<Integer>, Error> {
        let degree = degree - self.shift;
        let in_model = |(cell, x): &(CellId, Integer)| (self.cell(degree, *cell), x.clone());
        Chain::new(whole, degree, terms.iter().map(in_model))
    }

    /// A chain of the model as one of the complex; cells that the pair leaves out vanish.
    ///
    /// # Errors
    /// Those of [`Chain::new`], if the cells are none of the complex.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_algebra::CellId;
    /// use coface_answers::{CellNames, Producer};
    /// let edge = Producer::of(coface_io::read(&b"[[3,8]]"[..], coface_io::Format::Json)?)?;
    /// let names = CellNames::of(&edge);
    /// let whole = edge.chain_complex()?;
    /// let chain = names.to_model(&whole, 1, &[(CellId::new(0), 2.into())])?;
    /// assert_eq!(names.of_model(&whole, &chain)?, chain);
    /// # Ok(()) }
    /// ```
    pub fn of_model(&self, complex: &ChainComplex, chain: &Chain<Integer>) -> Result<Chain<Integer>, Error> {
        let kept = |(cell, x): &(CellId, Integer)| {
            let position = match self.pair {
                Some(pair) => pair.position(chain.degree(), *cell)?,
                None => *cell,
            };
            Some((position, x.clone()))
        };
        Chain::new(complex, chain.degree() + self.shift, chain.terms().iter().filter_map(kept))
    }
}
