//! Persistence diagrams as the text that other programs read.

use crate::answer::PersistenceAnswer;
use coface_algebra::Error;
use coface_topology::{PersistenceDiagram, PersistencePair};
use std::io::Write;
use std::path::Path;

/// A format of persistence diagrams.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum DiagramFormat {
    /// Lines `p degree birth death` with p the number of elements of the field, as GUDHI writes and reads `.pers` files.
    Gudhi,
    /// For each degree a line `persistence intervals in dim 0:` and under it the intervals, as Ripser prints them.
    Ripser,
    /// A header, then lines `degree,birth,death,birth_cell,death_cell`.
    Csv,
}

impl DiagramFormat {
    /// The format with the extension of this path: `.pers`, `.txt` (as Ripser prints) or `.csv`.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::DiagramFormat;
    /// assert_eq!(DiagramFormat::from_path("a.pers".as_ref()), Some(DiagramFormat::Gudhi));
    /// ```
    pub fn from_path(path: &Path) -> Option<Self> {
        match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "pers" => Some(Self::Gudhi),
            "txt" => Some(Self::Ripser),
            "csv" => Some(Self::Csv),
            _ => None,
        }
    }
}

/// Writes a persistence diagram as text: numbers in the fewest digits that give the same number back, `inf` for the
/// death of an essential class (`-inf` where values fall; Ripser leaves the place empty where they rise).
///
/// # Errors
/// [`coface_algebra::ErrorKind::Io`] if the stream cannot be written.
///
/// # Examples
/// Two points that meet by an edge at 2.5:
/// ```
/// use coface_algebra::SparseMatrix;
/// use coface_algebra::chains::ChainComplex;
/// use coface_answers::{DiagramFormat, write_diagram};
/// use coface_topology::{Coefficients, Filtration, persistence};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let edge = ChainComplex::new(vec![SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?])?;
/// let filtration = Filtration::new(&edge, vec![vec![0.0, 1.0], vec![2.5]])?;
/// let diagram = persistence(&edge, &filtration, Coefficients::Modulo(3))?;
/// let mut text = Vec::new();
/// write_diagram(&diagram, &mut text, DiagramFormat::Gudhi)?;
/// assert_eq!(text, b"3 0 0 inf\n3 0 1 2.5\n");
/// # Ok(()) }
/// ```
pub fn write_diagram(
    diagram: &PersistenceDiagram,
    out: impl Write,
    format: DiagramFormat,
) -> Result<(), Error> {
    let never = if diagram.is_falling() { f64::NEG_INFINITY } else { f64::INFINITY };
    let lines = diagram.pairs().iter().map(|pair: &PersistencePair| Line {
        degree: pair.degree(),
        birth: pair.birth(),
        death: pair.death(),
        birth_cell: pair.birth_cell().index().to_string(),
        death_cell: pair.death_cell().map(|cell| cell.index().to_string()),
    });
    write_lines(diagram.prime(), never, diagram.degree_count(), lines, out, format)
}

/// Writes classes that have kinds, those of extended persistence and of zigzags, as lines `degree,birth,death,kind,birth_cell,death_cell` under a header; what stays
/// has the death `inf`, and cells are given by their vertices, with blanks between them.
///
/// # Errors
/// [`coface_algebra::ErrorKind::Io`] if the stream cannot be written.
///
/// # Examples
/// ```
/// use coface_answers::{GivenZigzag, PersistenceRequest, write_kinds};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let zigzag = GivenZigzag::read("point.txt", b"i 7\nd 7\n")?;
/// let mut text = Vec::new();
/// write_kinds(&PersistenceRequest::new().zigzag(&zigzag)?, &mut text)?;
/// assert_eq!(text, b"degree,birth,death,kind,birth_cell,death_cell\n0,1,2,closed-closed,7,7\n");
/// # Ok(()) }
/// ```
pub fn write_kinds(answer: &PersistenceAnswer, mut out: impl Write) -> Result<(), Error> {
    writeln!(out, "degree,birth,death,kind,birth_cell,death_cell")?;
    let name = |cell: &[u32]| cell.iter().map(u32::to_string).collect::<Vec<_>>().join(" ");
    for pair in &answer.diagram {
        let (kind, death) = (pair.kind.as_deref().unwrap_or_default(), pair.death.unwrap_or(f64::INFINITY));
        let cells = [name(&pair.birth_cell), pair.death_cell.as_deref().map(name).unwrap_or_default()];
        writeln!(out, "{},{},{death},{kind},{}", pair.degree, pair.birth, cells.join(","))?;
    }
    Ok(())
}

/// A class, with the names of its cells.
pub(super) struct Line {
    pub(super) degree: usize,
    pub(super) birth: f64,
    pub(super) death: Option<f64>,
    pub(super) birth_cell: String,
    pub(super) death_cell: Option<String>,
}

/// Writes classes, which are sorted by degree.
pub(super) fn write_lines(
    prime: u32,
    never: f64,
    degree_count: usize,
    lines: impl Iterator<Item = Line>,
    mut out: impl Write,
    format: DiagramFormat,
) -> Result<(), Error> {
    let mut lines = lines.peekable();
    match format {
        DiagramFormat::Gudhi => {
            for line in lines {
                writeln!(out, "{prime} {} {} {}", line.degree, line.birth, line.death.unwrap_or(never))?;
            }
        }
        DiagramFormat::Ripser => {
            for degree in 0..degree_count {
                writeln!(out, "persistence intervals in dim {degree}:")?;
                while let Some(line) = lines.next_if(|line| line.degree == degree) {
                    match line.death {
                        Some(death) => writeln!(out, " [{},{death})", line.birth)?,
                        // Without a death nothing would say that values fall.
                        None if never < 0.0 => writeln!(out, " [{},-inf)", line.birth)?,
                        None => writeln!(out, " [{}, )", line.birth)?,
                    }
                }
            }
        }
        DiagramFormat::Csv => {
            writeln!(out, "degree,birth,death,birth_cell,death_cell")?;
            for line in lines {
                let cell = line.death_cell.unwrap_or_default();
                let death = line.death.unwrap_or(never);
                writeln!(out, "{},{},{death},{},{cell}", line.degree, line.birth, line.birth_cell)?;
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::SparseMatrix;
    use coface_algebra::chains::ChainComplex;
    use coface_topology::{Coefficients, Filtration, persistence};

    /// A circle of two edges on vertices of heights 0.1 and -2.
    fn text(is_falling: bool, format: DiagramFormat) -> String {
        let ends = [(0, 0, -1), (1, 0, 1), (0, 1, -1), (1, 1, 1)];
        let circle = ChainComplex::new(vec![SparseMatrix::from_entries(2, 2, ends).unwrap()]).unwrap();
        let star = if is_falling { Filtration::upper_star } else { Filtration::lower_star };
        let diagram =
            persistence(&circle, &star(&circle, &[0.1, -2.0]).unwrap(), Coefficients::Modulo(2)).unwrap();
        let mut bytes = Vec::new();
        write_diagram(&diagram, &mut bytes, format).unwrap();
        String::from_utf8(bytes).unwrap()
    }

    #[test]
    fn every_format_has_its_lines() {
        assert_eq!(text(false, DiagramFormat::Gudhi), "2 0 -2 inf\n2 0 0.1 0.1\n2 1 0.1 inf\n");
        assert_eq!(text(true, DiagramFormat::Gudhi), "2 0 0.1 -inf\n2 0 -2 -2\n2 1 -2 -inf\n");
        assert_eq!(
            text(false, DiagramFormat::Ripser),
            "persistence intervals in dim 0:\n [-2, )\n [0.1,0.1)\npersistence intervals in dim 1:\n [0.1, )\n"
        );
        assert_eq!(
            text(false, DiagramFormat::Csv),
            "degree,birth,death,birth_cell,death_cell\n0,-2,inf,1,\n0,0.1,0.1,0,0\n1,0.1,inf,1,\n"
        );
    }

    #[test]
    fn extensions_tell_the_format() {
        for (name, format) in [
            ("a.pers", Some(DiagramFormat::Gudhi)),
            ("a.b.TXT", Some(DiagramFormat::Ripser)),
            ("a.csv", Some(DiagramFormat::Csv)),
            ("pers", None),
            ("a.off", None),
        ] {
            assert_eq!(DiagramFormat::from_path(Path::new(name)), format, "{name}");
        }
    }
}
