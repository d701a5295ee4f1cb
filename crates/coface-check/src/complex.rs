//! Chain complexes of the input, made by the checker itself.

use crate::json::{field, index, list};
use crate::{Fault, polygons, simplices};
use serde_json::{Map, Value};
use std::collections::BTreeMap;

/// A column: rows with their entries, rising.
pub(crate) type Column = Vec<(u32, i64)>;

/// A chain complex over the integers: for each degree the number of cells and their boundaries.
///
/// # Examples
/// See [`Complex::read`].
#[derive(Clone, Debug)]
pub struct Complex {
    counts: Vec<usize>,
    /// For each degree from 1 on, where the column of each cell starts, and all entries.
    starts: Vec<Vec<usize>>,
    entries: Vec<Column>,
    is_augmented: bool,
}

impl Complex {
    /// Reads a facet list or a chain complex in JSON, or a surface in OFF or OBJ.
    ///
    /// A **facet list** is `[[0, 1, 2], ..]` or `{"facets": [..]}`. Its cells of degree k are the faces with k + 1 vertices, in the order
    /// of their rising lists of vertices; face i, without vertex i, has incidence $(-1)^i$. A **chain complex** is
    /// `{"boundaries": [{"rows": m, "cols": n, "entries": [[row, column, value], ..]}, ..]}`; that its boundaries compose to zero is checked.
    /// A surface of triangles alone is the simplicial complex of its triangles, edges and vertices, used or not. With polygons of more
    /// sides, cells of degree 2 are the polygons in the order of the file, and edges run from the smaller to the larger vertex.
    ///
    /// # Errors
    /// A [`Fault`] where the file is of another form, or where it is not plain which complex it means.
    ///
    /// # Complexity
    /// O(n log n) time for n entries; at most 64 faces for each byte of the file are made.
    ///
    /// # Examples
    /// ```
    /// let triangle = coface_check::Complex::read(b"[[0, 1, 2]]").expect("a facet list");
    /// assert_eq!(triangle.counts(), [3, 3, 1]);
    /// // The faces {0, 1}, {0, 2} and {1, 2}.
    /// assert_eq!(triangle.boundary(2, 0), [(0, 1), (1, -1), (2, 1)]);
    /// ```
    pub fn read(bytes: &[u8]) -> Result<Self, Fault> {
        let step = "input";
        match bytes.iter().find(|byte| !byte.is_ascii_whitespace()) {
            Some(b'{' | b'[') => {
                let value: Value = serde_json::from_slice(bytes)
                    .map_err(|error| Fault::new(step, format!("this is not one value of JSON: {error}")))?;
                Self::of_json(&value, bytes.len())
            }
            Some(_) => polygons::read(bytes),
            None => Err(Fault::new(step, "the file is empty")),
        }
    }

    fn of_json(value: &Value, size: usize) -> Result<Self, Fault> {
        let Some(object) = value.as_object() else {
            return simplices::of_facets(&facets_of(value)?, Vec::new(), size);
        };
        let of_other = object.keys().find(|key| !["name", "facets", "boundaries"].contains(&key.as_str()));
        if let Some(key) = of_other {
            return Err(Fault::new("input", format!("the checker does not know the key {key:?}")));
        }
        match (object.get("facets"), object.get("boundaries")) {
            (Some(facets), None) => simplices::of_facets(&facets_of(facets)?, Vec::new(), size),
            (None, Some(matrices)) => Self::of_matrices(list(matrices, "\"boundaries\"", "input")?),
            _ => Err(Fault::new("input", "the object needs one of \"facets\" and \"boundaries\"")),
        }
    }

    fn of_matrices(matrices: &[Value]) -> Result<Self, Fault> {
        let step = "input";
        let (mut counts, mut columns, mut budget) = (Vec::new(), Vec::new(), 1usize << 20);
        for (k, matrix) in matrices.iter().enumerate() {
            let object: &Map<String, Value> =
                matrix.as_object().ok_or_else(|| Fault::new(step, "a boundary matrix is no object"))?;
            if object.len() != 3 {
                return Err(Fault::new(step, format!("boundary matrix {} has keys of other things", k + 1)));
            }
            let rows = index(field(matrix, "rows", step)?, "\"rows\"", step)? as usize;
            let width = index(field(matrix, "cols", step)?, "\"cols\"", step)? as usize;
            let entries = list(field(matrix, "entries", step)?, "\"entries\"", step)?;
            // A count that the file merely names takes no memory.
            budget = (budget + 16 * entries.len())
                .checked_sub(rows.max(width))
                .ok_or_else(|| Fault::new(step, "the matrices have many more cells than entries"))?;
            if counts.last().is_some_and(|&above| above != rows) {
                return Err(Fault::new(step, format!("boundary matrix {} has {rows} rows", k + 1)));
            }
            if counts.is_empty() {
                counts.push(rows);
            }
            counts.push(width);
            columns.push(columns_of(entries, rows, width)?);
        }
        if counts.is_empty() {
            return Err(Fault::new(step, "there is no boundary matrix"));
        }
        let complex = Self::new(counts, columns, false);
        complex.check_squares()?;
        Ok(complex)
    }

    /// From the boundaries of the cells of degrees 1, 2, ... It is augmented if each edge has two ends, so that a reduced group makes sense.
    pub(crate) fn new(counts: Vec<usize>, columns: Vec<Vec<Column>>, is_augmented: bool) -> Self {
        let mut starts = Vec::new();
        let mut entries = Vec::new();
        for degree in columns {
            let mut start = vec![0];
            let mut all = Vec::with_capacity(degree.iter().map(Vec::len).sum());
            for column in degree {
                all.extend(column);
                start.push(all.len());
            }
            starts.push(start);
            entries.push(all);
        }
        Self { counts, starts, entries, is_augmented }
    }

    fn check_squares(&self) -> Result<(), Fault> {
        for degree in 2..self.counts.len() {
            for cell in 0..self.counts[degree] {
                let mut sum = BTreeMap::new();
                for &(face, incidence) in self.boundary(degree, cell) {
                    for &(ridge, other) in self.boundary(degree - 1, face as usize) {
                        // 2^32 products of 127 bits would be needed to overflow, but a stranger's file may try.
                        let term = i128::from(incidence) * i128::from(other);
                        let entry: &mut i128 = sum.entry(ridge).or_default();
                        *entry = entry
                            .checked_add(term)
                            .ok_or_else(|| Fault::new("input", "entries too large"))?;
                    }
                }
                if sum.values().any(|entry| *entry != 0) {
                    let message =
                        format!("the boundary of the boundary of cell {cell} of degree {degree} is not zero");
                    return Err(Fault::new("input", message));
                }
            }
        }
        Ok(())
    }

    /// The numbers of cells of degrees 0, 1, ...
    ///
    /// # Examples
    /// See [`Complex::read`].
    pub fn counts(&self) -> &[usize] {
        &self.counts
    }

    /// The boundary of a cell: cells of one degree less with their incidences.
    ///
    /// # Panics
    /// If there is no such cell, or the degree is 0.
    ///
    /// # Examples
    /// See [`Complex::read`].
    pub fn boundary(&self, degree: usize, cell: usize) -> &[(u32, i64)] {
        let starts = &self.starts[degree - 1];
        &self.entries[degree - 1][starts[cell]..starts[cell + 1]]
    }

    pub(crate) fn is_augmented(&self) -> bool {
        self.is_augmented
    }
}

fn facets_of(value: &Value) -> Result<Vec<Vec<u32>>, Fault> {
    let step = "input";
    let facets = list(value, "the facet list", step)?.iter().enumerate().map(|(i, facet)| {
        let vertices = list(facet, &format!("facet {i}"), step)?;
        let mut vertices =
            vertices.iter().map(|vertex| index(vertex, "a vertex", step)).collect::<Result<Vec<u32>, _>>()?;
        vertices.sort_unstable();
        match vertices.is_empty() || vertices.windows(2).any(|pair| pair[0] == pair[1]) {
            true => Err(Fault::new(step, format!("facet {i} is empty or repeats a vertex"))),
            false => Ok(vertices),
        }
    });
    facets.collect()
}

/// Columns of triples; values at one place are added.
fn columns_of(entries: &[Value], rows: usize, width: usize) -> Result<Vec<Column>, Fault> {
    let step = "input";
    let mut sorted = Vec::with_capacity(entries.len());
    for entry in entries {
        let [row, column, value] = list(entry, "an entry", step)? else {
            return Err(Fault::new(step, "an entry is not a row, a column and a value"));
        };
        let place = (index(column, "a column", step)?, index(row, "a row", step)?);
        if place.0 as usize >= width || place.1 as usize >= rows {
            return Err(Fault::new(step, format!("there is no row {} and column {}", place.1, place.0)));
        }
        let value = value.as_i64().ok_or_else(|| Fault::new(step, "a value has more than 64 bits"))?;
        sorted.push((place, value));
    }
    sorted.sort_unstable();
    let mut columns = vec![Column::new(); width];
    for ((column, row), value) in sorted {
        let column = &mut columns[column as usize];
        match column.last_mut() {
            Some((last, sum)) if *last == row => {
                *sum = sum.checked_add(value).ok_or_else(|| Fault::new(step, "a sum of values overflows"))?;
            }
            _ => column.push((row, value)),
        }
    }
    columns.iter_mut().for_each(|column| column.retain(|(_, value)| *value != 0));
    Ok(columns)
}
