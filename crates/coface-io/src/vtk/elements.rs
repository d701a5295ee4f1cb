//! The points and cells of a mesh as they are read, whatever the encoding.

use super::cell_runs::Cells;
use super::cell_types::{CellType, is_of_higher_order};
use crate::assembly::Assembly;
use crate::element_kind::Kind;
use crate::numbers::Numbers;
use crate::oddities::Oddity;
use crate::{Place, Remark, RemarkCode};
use coface_algebra::Error;

/// The most points that a cell of a fixed number has.
const MOST_POINTS: usize = 27;

/// A mesh in the making, and what each cell of the file became.
#[derive(Debug)]
pub(super) struct Elements {
    pub(super) assembly: Assembly,
    /// What the cells became, for the data on them.
    pub(super) cells: Cells,
    /// The cells that became points, which have no data of their own, while nobody has been told of it.
    points_without_data: usize,
}

impl Elements {
    pub(super) fn new() -> Self {
        Self { assembly: Assembly::new(3), cells: Cells::default(), points_without_data: 0 }
    }

    /// Adds what a cell of this type in a section becomes; the file numbers points from `first_point` on.
    pub(super) fn add_cell(
        &mut self,
        section: usize,
        cell_type: CellType,
        vertices: &[u32],
        first_point: u32,
    ) -> Result<(), Error> {
        let count = vertices.len();
        let has_too_few = |least: usize, what: &str| {
            Error::invalid(format!("a {what} has {count} points; it needs {least}")).with_cure("remove it")
        };
        let number = |vertex: u32| u64::from(vertex.saturating_sub(first_point));
        let mut elements = 1;
        let (kind, first) = match cell_type {
            CellType::Empty => (Kind::Point, None),
            CellType::Points => {
                for vertex in vertices {
                    self.assembly.add(Kind::Point, 1, &[*vertex], number)?;
                }
                (Kind::Point, None)
            }
            CellType::Polyline if count < 2 => (Kind::Line, self.leave_out(vertices)),
            CellType::Polyline => (Kind::Line, self.assembly.add(Kind::Line, count, vertices, number)?),
            CellType::Strip if count < 3 => (Kind::Polygon, self.leave_out(vertices)),
            CellType::Strip => {
                let mut first = None;
                elements = 0;
                for (i, triangle) in vertices.windows(3).enumerate() {
                    let [a, b, c] = [triangle[i % 2], triangle[1 - i % 2], triangle[2]];
                    // Triangles that repeat a point only join strips.
                    if a != b && b != c && c != a {
                        let added = self.assembly.add(Kind::Polygon, 3, &[a, b, c], number)?;
                        first = first.or(added);
                        elements += 1;
                    }
                }
                (Kind::Polygon, first)
            }
            CellType::Polygon if count < 3 => (Kind::Polygon, self.leave_out(vertices)),
            CellType::Polygon => (Kind::Polygon, self.assembly.add(Kind::Polygon, count, vertices, number)?),
            CellType::QuadraticPolygon if count < 6 || !count.is_multiple_of(2) => {
                return Err(has_too_few(6, "quadratic polygon (an even number of points)"));
            }
            CellType::QuadraticPolygon => {
                (Kind::Polygon, self.assembly.add(Kind::Polygon, count / 2, vertices, number)?)
            }
            // More points than a linear type has may be those of a type of higher order.
            CellType::Fixed { kind, corners, vertex_count }
                if count != vertex_count && !is_of_higher_order(kind, corners.len(), count) =>
            {
                return Err(Error::invalid(format!(
                    "a cell has {count} points, but its type needs {vertex_count}"
                ))
                .with_cure("give it another type, or the points that are missing"));
            }
            CellType::Fixed { kind, corners, .. } => {
                let mut ordered = [0; MOST_POINTS];
                ordered[..count].copy_from_slice(vertices);
                for (place, &corner) in ordered.iter_mut().zip(corners) {
                    *place = vertices[corner];
                }
                (kind, self.assembly.add(kind, corners.len(), &ordered[..count], number)?)
            }
        };
        self.points_without_data += usize::from(kind == Kind::Point && !vertices.is_empty());
        match (kind, first) {
            (Kind::Point, _) | (_, None) => self.cells.add(section, None, 0, 0),
            (kind, Some(first)) => self.cells.add(section, Some(kind.group_kind()), first, elements),
        }
        Ok(())
    }

    /// Says that data on cells are left out where these are points and the data, of which so many on other cells are not zero, are not.
    pub(super) fn remark_on_points(&mut self, numbers: &Numbers, taken: usize) {
        if self.points_without_data == 0 || count_nonzero(numbers) <= taken {
            return;
        }
        let message = match std::mem::take(&mut self.points_without_data) {
            1 => "1 cell is a point: the data on it are left out".to_owned(),
            count => format!("{count} cells are points: the data on them are left out"),
        };
        self.assembly.remarks.push(Remark::new(RemarkCode::DataLeftOut, message));
    }

    /// Leaves a cell of too few points out.
    fn leave_out(&mut self, vertices: &[u32]) -> Option<u32> {
        self.assembly.oddities.note(Oddity::Collapsed, || Place::cell(vertices));
        None
    }
}

/// How many numbers are not zero.
pub(super) fn count_nonzero(numbers: &Numbers) -> usize {
    (0..numbers.len()).filter(|&i| numbers.real(i) != 0.0).count()
}
