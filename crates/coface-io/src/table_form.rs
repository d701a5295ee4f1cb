//! What the numbers of a table are: points, or distances.

use crate::{NumberTable, Remark, RemarkCode};
use coface_algebra::progress::stage;
use coface_algebra::{Error, memory};
use coface_complexes::filtered::Distances;
use coface_geometry::distance;

/// What the numbers of a table are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum TableForm {
    /// A row for each point, its coordinates in any number of columns.
    Points,
    /// The distances of each point to the points before it, one point after the other.
    Lower,
    /// The distances of each point to the points after it, one point after the other.
    Upper,
    /// A row for each point, with its distances to all points.
    Square,
    /// Rows `i j distance` with points from 0 on; other pairs of points are infinitely far apart.
    Sparse,
}

impl TableForm {
    /// The form of this name: `points`, `lower`, `upper`, `square` or `sparse`.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for another name.
    ///
    /// # Examples
    /// ```
    /// use coface_io::TableForm;
    /// assert_eq!(TableForm::from_name("lower").expect("a form"), TableForm::Lower);
    /// ```
    pub fn from_name(name: &str) -> Result<Self, Error> {
        Ok(match name {
            "points" => Self::Points,
            "lower" => Self::Lower,
            "upper" => Self::Upper,
            "square" | "full" => Self::Square,
            "sparse" => Self::Sparse,
            _ => {
                return Err(Error::invalid(format!("\"{}\" is no form of distances", name.escape_debug()))
                    .with_cure("give points, lower, upper, square or sparse"));
            }
        })
    }

    /// The form that a table has by its looks: a square one with zeros on its diagonal that is symmetric and has no negative number holds
    /// distances, and a remark says so; all others hold points. What rounding leaves is no matter: the diagonal may be a millionth of the largest distance, and
    /// two entries for one distance may differ by a billionth of it. The table of a Matrix Market file has sparse distances. Distances are the means of both then, and the remark says how much they differed.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{NumberTable, TableForm};
    /// let form = |rows: [[f64; 3]; 3]| TableForm::of(&NumberTable::from_rows(rows)).0;
    /// assert_eq!(form([[0.0, 3.0, 5.0], [3.0, 0.0, 4.0], [5.0, 4.0, 0.0]]), TableForm::Square);
    /// assert_eq!(form([[0.0, 3.0, 5.0], [3.0, 0.0, 4.0], [5.0, 1.0, 0.0]]), TableForm::Points);
    /// ```
    pub fn of(table: &NumberTable) -> (Self, Option<Remark>) {
        if table.is_list_of_pairs() {
            return (Self::Sparse, None);
        }
        if !is_square_of_distances(table) {
            return (Self::Points, None);
        }
        let mut message = "the table is symmetric with zeros on its diagonal: its numbers were taken for distances; --distances points takes \
                           its rows as points"
            .to_owned();
        if let Some(evened) = Self::Square.evened(table) {
            message = format!("{message}; {}", evened.message);
        }
        (Self::Square, Some(Remark::new(RemarkCode::InputReading, message)))
    }

    /// What rounding left in a square table of distances and was evened out.
    pub(crate) fn evened(self, table: &NumberTable) -> Option<Remark> {
        let count = table.row_count();
        if self != Self::Square || (0..count).any(|i| table.row(i).len() != count) {
            return None;
        }
        let diagonal = (0..count).filter(|&i| table.row(i)[i] != 0.0).count();
        let pairs = (0..count).flat_map(|i| (0..i).map(move |j| (i, j)));
        let differences: Vec<f64> = pairs
            .map(|(i, j)| (table.row(i)[j] - table.row(j)[i]).abs())
            .filter(|difference| *difference > 0.0)
            .collect();
        let mut parts = Vec::new();
        if diagonal > 0 {
            parts.push(format!("{} on the diagonal became 0", counted(diagonal, "number")));
        }
        if !differences.is_empty() {
            let most = differences.iter().copied().fold(0.0, f64::max);
            let pairs = counted(differences.len(), "pair");
            parts.push(format!(
                "{pairs} of numbers for one distance, up to {most:e} apart, became their means"
            ));
        }
        let message = parts.join(", and ");
        (!parts.is_empty())
            .then(|| Remark::new(RemarkCode::InputReading, message).at(diagonal + differences.len(), []))
    }

    /// The distances that a table holds, or those of its points. Points have the Euclidean distance.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) or
    /// [`ErrorKind::Shape`](coface_algebra::ErrorKind::Shape) for rows that do not fit the form, with their line.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{NumberTable, TableForm};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = NumberTable::read(&b"0 0\n3 0\n3 4\n"[..])?;
    /// let lower = NumberTable::read(&b"3\n5 4\n"[..])?;
    /// let square = NumberTable::read(&b"0 3 5\n3 0 4\n5 4 0\n"[..])?;
    /// let distances = TableForm::Points.distances(&points)?;
    /// assert_eq!(TableForm::Lower.distances(&lower)?, distances);
    /// assert_eq!(TableForm::Square.distances(&square)?, distances);
    /// # Ok(()) }
    /// ```
    pub fn distances(self, table: &NumberTable) -> Result<Distances, Error> {
        match self {
            Self::Points => of_points(table),
            Self::Lower => of_lower(table),
            Self::Upper => {
                let count = point_count(table.numbers().len())?;
                let row = |i: usize| i * (2 * count - i - 1) / 2;
                let at = |i: usize, j: usize| table.numbers()[row(j) + i - j - 1];
                let lower = (0..count).flat_map(|i| (0..i).map(move |j| at(i, j)));
                Distances::from_lower_triangle(count, lower.collect())
            }
            Self::Square => of_square(table),
            Self::Sparse => of_list(table),
        }
    }
}

/// An error in a row of a table.
fn in_row(error: Error, table: &NumberTable, row: usize) -> Error {
    match table.line(row) {
        Some(line) => error.at_line(line),
        None => error,
    }
}

fn of_points(table: &NumberTable) -> Result<Distances, Error> {
    let count = table.row_count();
    table.point_dimension("give each point as many numbers, or say what they are by --distances lower")?;
    memory::require((count as u64).saturating_mul(count as u64).saturating_mul(4), || {
        format!("the distances of {count} points")
    })?;
    let steps = stage("measuring distances", count);
    let mut lower = Vec::with_capacity(count * count.saturating_sub(1) / 2);
    for i in steps.each(0..count) {
        for j in 0..i {
            lower.push(distance(table.row(i), table.row(j)));
        }
    }
    if let Some(at) = lower.iter().position(|distance| !distance.is_finite()) {
        let i = ((((8 * at + 1) as f64).sqrt() + 1.0) / 2.0) as usize;
        return Err(Error::invalid(format!(
            "the distance of point {i} to an earlier one is too large for a number"
        ))
        .with_cure("scale the points"));
    }
    Distances::from_lower_triangle(count, lower)
}

/// The number of points whose pairs are so many.
fn point_count(pairs: usize) -> Result<usize, Error> {
    let count = ((((8.0 * pairs as f64 + 1.0).sqrt() + 1.0) / 2.0).round()) as usize;
    if pairs == 0 {
        return Ok(1);
    }
    if count * (count - 1) / 2 != pairs {
        return Err(Error::invalid(format!(
            "{} are not one for each pair of any number of points: {count} points have {} pairs",
            counted(pairs, "distance"),
            count * (count - 1) / 2
        ))
        .with_cure("give a number for each pair, or say how the table is laid out by --distances square or --distances sparse"));
    }
    Ok(count)
}

fn of_lower(table: &NumberTable) -> Result<Distances, Error> {
    // Rows of lengths 1, 2, 3, .. that end in 0 have the diagonal too.
    let rows = table.row_count();
    let with_diagonal = rows > 1
        && (0..rows).all(|row| table.row(row).len() == row + 1 && table.row(row).last() == Some(&0.0));
    if with_diagonal {
        let lower = (0..rows).flat_map(|row| table.row(row)[..row].iter().copied());
        return Distances::from_lower_triangle(rows, lower.collect());
    }
    let numbers = table.numbers();
    Distances::from_lower_triangle(point_count(numbers.len())?, numbers.to_vec())
}

fn of_square(table: &NumberTable) -> Result<Distances, Error> {
    let count = table.row_count();
    let largest = largest_of(table);
    let mut lower = Vec::new();
    for i in 0..count {
        let row = table.row(i);
        let wrong = |error: Error| in_row(error, table, i);
        if row.len() != count {
            return Err(wrong(
                Error::invalid(format!(
                    "row {i} has {}, and there are {count} rows",
                    counted(row.len(), "number")
                ))
                .with_cure("give as many numbers in each row as there are rows"),
            ));
        }
        if !is_nearly_zero(row[i], largest) {
            return Err(wrong(
                Error::invalid(format!("the distance of point {i} to itself is {}, not 0", row[i]))
                    .with_cure("write zeros on the diagonal"),
            ));
        }
        for (j, &one) in row.iter().enumerate().take(i) {
            let other = table.row(j)[i];
            if !is_nearly(one, other, largest) {
                return Err(wrong(
                    Error::invalid(format!("row {i} says that point {j} is at {one}, row {j} says {other}"))
                        .with_cure("write the same number in both places"),
                ));
            }
            lower.push(if one == other { one } else { f64::midpoint(one, other) });
        }
    }
    Distances::from_lower_triangle(count, lower)
}

fn of_list(table: &NumberTable) -> Result<Distances, Error> {
    let mut list = Vec::with_capacity(table.row_count());
    let mut count = 0;
    for row in 0..table.row_count() {
        let wrong = |message: String| {
            in_row(
                Error::invalid(message).with_cure("write rows of two points, from 0 on, and their distance"),
                table,
                row,
            )
        };
        let &[i, j, distance] = table.row(row) else {
            return Err(wrong(format!("the row has {}, not 3", counted(table.row(row).len(), "number"))));
        };
        let point = |number: f64| {
            let is_point = number >= 0.0 && number.fract() == 0.0 && number < f64::from(u32::MAX);
            is_point.then_some(number as usize).ok_or_else(|| wrong(format!("{number} is no point")))
        };
        let (i, j) = (point(i)?, point(j)?);
        count = count.max(i + 1).max(j + 1);
        list.push((i, j, distance));
    }
    Distances::from_list(count, list)
}

fn is_square_of_distances(table: &NumberTable) -> bool {
    let count = table.row_count();
    let largest = largest_of(table);
    count > 2
        && (0..count).all(|i| table.row(i).len() == count && is_nearly_zero(table.row(i)[i], largest))
        && (0..count).all(|i| {
            (0..i).all(|j| {
                let (one, other) = (table.row(i)[j], table.row(j)[i]);
                one >= 0.0 && other >= 0.0 && is_nearly(one, other, largest)
            })
        })
}

/// The largest finite number.
fn largest_of(table: &NumberTable) -> f64 {
    table.numbers().iter().copied().filter(|number| number.is_finite()).fold(0.0, f64::max)
}

/// Whether the distance of a point to itself is 0 but for rounding, as the root of a difference of squares leaves it.
fn is_nearly_zero(number: f64, largest: f64) -> bool {
    number == 0.0 || number.abs() <= 1e-6 * largest
}

/// Whether two numbers are one distance but for rounding.
fn is_nearly(one: f64, other: f64, largest: f64) -> bool {
    one == other || (one - other).abs() <= 1e-9 * largest
}

/// A number of things.
fn counted(number: usize, singular: &str) -> String {
    if number == 1 { format!("1 {singular}") } else { format!("{number} {singular}s") }
}

#[cfg(test)]
mod tests {
    use super::TableForm;
    use crate::{NumberTable, RipsReading};

    #[test]
    fn rounding_does_not_make_points_of_distances() {
        let exact = NumberTable::from_rows([[0.0, 3.0, 5.0], [3.0, 0.0, 4.0], [5.0, 4.0, 0.0]]);
        let rounded = NumberTable::from_rows([[1e-8, 3.0, 5.0], [3.0, 0.0, 4.0], [5.0 + 1e-12, 4.0, -1e-9]]);
        let (form, said) = TableForm::of(&rounded);
        assert_eq!(form, TableForm::Square);
        let message = said.unwrap().message;
        assert!(message.contains("2 numbers on the diagonal") && message.contains("1 pair"), "{message}");
        for reading in
            [RipsReading::default(), RipsReading { form: Some(TableForm::Square), ..Default::default() }]
        {
            let found = reading.distances(&rounded).unwrap();
            assert_eq!(found.remarks().len(), 1);
            let exact = reading.distances(&exact).unwrap();
            assert_eq!(found.distances().enclosing_radius(), exact.distances().enclosing_radius());
        }
        for far in [
            [[1e-3, 3.0, 5.0], [3.0, 0.0, 4.0], [5.0, 4.0, 0.0]],
            [[0.0, 3.0, 5.0], [3.1, 0.0, 4.0], [5.0, 4.0, 0.0]],
        ] {
            let far = NumberTable::from_rows(far);
            assert_eq!(TableForm::of(&far).0, TableForm::Points);
            assert!(TableForm::Square.distances(&far).is_err());
        }
    }

    #[test]
    fn nothing_has_no_points() {
        for text in ["", "x,y\n", "# none\n"] {
            let table = NumberTable::read(text.as_bytes()).unwrap();
            let error = RipsReading::default().distances(&table).unwrap_err();
            assert!(error.to_string().contains("no point"), "{error}");
            assert!(crate::AlphaReading::default().points(&table).is_err());
        }
    }
}
