//! The filtration that a command line asks for.

use crate::failure::Failure;
use coface::algebra::chains::ChainComplex;
use coface::answers::Producer;
use coface::geometry::Positions;
use coface::topology::Filtration;
use coface::{Error, VertexId};
use serde_json::Value;
use std::path::Path;

/// A function on vertices.
#[derive(Clone, Debug)]
pub(crate) enum Function {
    /// The coordinate with this number.
    Coordinate(usize),
    /// The number of the vertex.
    Number,
    /// One value for each vertex, from this file.
    File(std::path::PathBuf),
}

impl Function {
    /// The function of this name; without one the last coordinate, or the vertex number when there are no positions.
    pub(crate) fn choose(name: Option<&str>, positions: &Positions) -> Result<Self, Failure> {
        let Some(name) = name else {
            return Ok(positions.dimension().checked_sub(1).map_or(Self::Number, Self::Coordinate));
        };
        let Some(axis) = ["x", "y", "z"].iter().position(|axis| *axis == name) else {
            return Ok(Self::File(name.into()));
        };
        match positions.dimension() {
            0 => Err(Failure::new(format!(
                "there are no positions to take {name} from; give a file of values: --function FILE"
            ))),
            dimension if axis < dimension => Ok(Self::Coordinate(axis)),
            dimension => Err(Failure::new(format!(
                "there is no coordinate {name}: positions have {dimension} coordinates"
            ))),
        }
    }

    /// What it is called.
    pub(crate) fn name(&self) -> String {
        match self {
            Self::Coordinate(axis) => {
                ["x", "y", "z"].get(*axis).map_or(format!("coordinate {axis}"), |name| (*name).to_owned())
            }
            Self::Number => "vertex number".to_owned(),
            Self::File(path) => path.display().to_string(),
        }
    }

    /// The value of each vertex, in the order of the 0-cells.
    pub(crate) fn values(&self, producer: &Producer, count: usize) -> Result<Vec<f64>, Failure> {
        let numbers = (0..count).map(|vertex| producer.cell_vertices(0, vertex)[0] as usize);
        Ok(match self {
            Self::Coordinate(axis) => {
                numbers.map(|number| producer.positions().point(VertexId::new(number))[*axis]).collect()
            }
            Self::Number => numbers.map(|number| number as f64).collect(),
            Self::File(path) => {
                let values = read_numbers(path)?;
                let needed = numbers.clone().max().map_or(0, |last| last + 1);
                if values.len() != needed {
                    return Err(Error::invalid(format!("{} values for {needed} vertices", values.len()))
                        .with_cure("write one number a line for each vertex number from 0 on")
                        .in_file(path.display().to_string())
                        .into());
                }
                numbers.map(|number| values[number]).collect()
            }
        })
    }
}

/// One number a line; empty lines at the end do not count.
fn read_numbers(path: &Path) -> Result<Vec<f64>, Failure> {
    let number = |(i, line): (usize, &str)| {
        line.trim().parse::<f64>().ok().filter(|value| value.is_finite()).ok_or_else(|| {
            Error::parse(format!("{:?} is not a finite number", line.trim()))
                .at_line(i as u64 + 1)
                .in_file(path.display().to_string())
                .with_cure("write one number a line, for each vertex")
        })
    };
    Ok(read_text(path)?.trim_end().lines().enumerate().map(number).collect::<Result<_, Error>>()?)
}

fn read_text(path: &Path) -> Result<String, Failure> {
    std::fs::read_to_string(path)
        .map_err(|error| Error::from(error).in_file(path.display().to_string()).into())
}

/// The values of a JSON file: `{"values":[[..],..]}`, or the bare list, with a list for each degree; or
/// `{"cells":[[[vertices..],value],..]}`, where cells that are not listed enter with their first coface.
pub(crate) fn read_values(
    path: &Path,
    producer: &Producer,
    complex: &ChainComplex,
) -> Result<Filtration, Failure> {
    let text = read_text(path)?;
    let fault = |error: Error| Failure::from(error.in_file(path.display().to_string()));
    let document: Value = serde_json::from_str(&text)
        .map_err(|error| fault(Error::parse(error.to_string()).with_cure("write valid JSON")))?;
    let shape = || {
        fault(
            Error::invalid("there are no values of cells here")
                .with_cure("write {\"values\":[[..],..]} with a list of numbers for each degree, or {\"cells\":[[[vertices..],value],..]}"),
        )
    };
    if let Some(cells) = document.get("cells") {
        let cells = cells.as_array().ok_or_else(shape)?;
        let listed: Option<Vec<(Vec<u32>, f64)>> = cells.iter().map(listed_cell).collect();
        return values_of_cells(&listed.ok_or_else(shape)?, producer, complex).map_err(fault);
    }
    let lists = document.get("values").unwrap_or(&document).as_array().ok_or_else(shape)?;
    let list = |list: &Value| list.as_array()?.iter().map(Value::as_f64).collect::<Option<Vec<f64>>>();
    let values = lists.iter().map(list).collect::<Option<_>>().ok_or_else(shape)?;
    Filtration::new(complex, values).map_err(fault)
}

/// A cell as `[[vertices..],value]`.
fn listed_cell(cell: &Value) -> Option<(Vec<u32>, f64)> {
    let [vertices, value] = &cell.as_array()?[..] else { return None };
    let number = |vertex: &Value| u32::try_from(vertex.as_u64()?).ok();
    let vertices = vertices.as_array()?.iter().map(number).collect::<Option<Vec<u32>>>()?;
    Some((vertices, value.as_f64()?))
}

fn values_of_cells(
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
