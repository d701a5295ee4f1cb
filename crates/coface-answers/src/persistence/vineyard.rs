//! Vineyards of functions on a model.

use super::VertexFunction;
use crate::Producer;
use crate::answer::{VineAnswer, VineyardAnswer};
use coface_algebra::Error;
use coface_topology::{Coefficients, Vine, VinePoint, vineyard};
use std::io::Write;

/// Asks for the paths of the points of a diagram while the function moves.
///
/// # Examples
/// A path whose valley at the end becomes flat.
/// ```
/// use coface_answers::{Producer, VertexFunction, VineyardRequest};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let path = Producer::of(coface_io::read(&b"[[0,1],[1,2]]"[..], coface_io::Format::Json)?)?;
/// let values = |values: &[f64]| VertexFunction::Values { place: "f".to_owned(), values: values.to_vec() };
/// let functions = [values(&[0.0, 4.0, 2.0]), values(&[0.0, 4.0, 6.0])];
/// let answer = VineyardRequest::new().answer("path.json", &path, &functions)?;
/// assert_eq!(answer.vines[1].points, [(0.0, 2.0, Some(4.0)), (0.5, 4.0, Some(4.0))]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct VineyardRequest {
    coefficients: Coefficients,
    pub(super) min_persistence: f64,
}

impl Default for VineyardRequest {
    fn default() -> Self {
        Self { coefficients: Coefficients::Modulo(2), min_persistence: 0.0 }
    }
}

impl VineyardRequest {
    /// Asks for all vines over two elements.
    ///
    /// # Examples
    /// See [`VineyardRequest`].
    pub fn new() -> Self {
        Self::default()
    }

    /// The field of coefficients.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{Producer, VertexFunction, VineyardRequest};
    /// use coface_topology::Coefficients;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = Producer::of(coface_io::read(&b"[[0,1],[1,2]]"[..], coface_io::Format::Json)?)?;
    /// let request = VineyardRequest::new().coefficients(Coefficients::Modulo(3));
    /// assert_eq!(request.answer("path", &path, &[VertexFunction::Number])?.field, 3);
    /// # Ok(()) }
    /// ```
    pub fn coefficients(mut self, coefficients: Coefficients) -> Self {
        self.coefficients = coefficients;
        self
    }

    /// Leaves out the vines whose persistence is nowhere greater.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{Producer, VertexFunction, VineyardRequest};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = Producer::of(coface_io::read(&b"[[0,2],[2,1]]"[..], coface_io::Format::Json)?)?;
    /// let functions = [VertexFunction::Number];
    /// assert_eq!(VineyardRequest::new().answer("path", &path, &functions)?.vines.len(), 2);
    /// assert_eq!(VineyardRequest::new().min_persistence(1.0).answer("path", &path, &functions)?.vines.len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn min_persistence(mut self, least: f64) -> Self {
        self.min_persistence = least;
        self
    }

    /// Finds the vines of these functions on the vertices of a model with this name, one after the other.
    ///
    /// # Errors
    /// Those of [`Producer::chain_complex`], [`VertexFunction::values`] and [`vineyard`].
    ///
    /// # Examples
    /// See [`VineyardRequest`].
    pub fn answer(
        &self,
        name: &str,
        producer: &Producer,
        functions: &[VertexFunction],
    ) -> Result<VineyardAnswer, Error> {
        let Coefficients::Modulo(prime) = self.coefficients else {
            return Err(Error::invalid("persistence has a prime field").with_cure("give f2, f3, f5, ..."));
        };
        let complex = producer.chain_complex()?;
        let count = complex.cell_count(0);
        let values: Vec<Vec<f64>> = functions
            .iter()
            .map(|function| function.values(producer, count))
            .collect::<Result<_, Error>>()?;
        let vines = vineyard(&complex, &values, self.coefficients).map_err(|error| error.in_file(name))?;
        let point = |point: &VinePoint| (point.parameter(), point.birth(), point.death());
        let vine = |vine: &Vine| VineAnswer {
            degree: vine.degree(),
            points: vine.points().iter().map(point).collect(),
        };
        Ok(VineyardAnswer {
            file: name.to_owned(),
            field: prime as u32,
            functions: functions.iter().map(VertexFunction::name).collect(),
            vines: vines.iter().filter(|vine| vine.persistence() > self.min_persistence).map(vine).collect(),
            remarks: Vec::new(),
        })
    }
}

/// Writes the points of vines as lines `vine,degree,parameter,birth,death` under a header; vines are numbered from 0 on, and what stays has the death `inf`.
///
/// # Errors
/// [`coface_algebra::ErrorKind::Io`] if the stream cannot be written.
///
/// # Examples
/// ```
/// use coface_answers::{Producer, VertexFunction, VineyardRequest, write_vines};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let point = Producer::of(coface_io::read(&b"[[5]]"[..], coface_io::Format::Json)?)?;
/// let answer = VineyardRequest::new().answer("point", &point, &[VertexFunction::Number])?;
/// let mut text = Vec::new();
/// write_vines(&answer, &mut text)?;
/// assert_eq!(text, b"vine,degree,parameter,birth,death\n0,0,0,5,inf\n");
/// # Ok(()) }
/// ```
pub fn write_vines(answer: &VineyardAnswer, mut out: impl Write) -> Result<(), Error> {
    writeln!(out, "vine,degree,parameter,birth,death")?;
    for (number, vine) in answer.vines.iter().enumerate() {
        for &(parameter, birth, death) in &vine.points {
            let death = death.unwrap_or(f64::INFINITY);
            writeln!(out, "{number},{},{parameter},{birth},{death}", vine.degree)?;
        }
    }
    Ok(())
}
