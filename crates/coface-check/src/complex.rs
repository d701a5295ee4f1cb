//! Chain complexes of the input, made by the checker itself.

use crate::json::{field, index, list, parsed};
use crate::lists::Lists;
use crate::{Fault, polygons, simplices};
use serde_json::{Map, Value};
use std::collections::{BTreeMap, HashMap};

/// A column: rows with their entries, rising.
pub(crate) type Column = Vec<(u32, i64)>;

/// For each degree the cells by their vertices: rising those of a simplex, around those of a polygon.
pub(crate) type Names = Vec<Lists<u32>>;

/// A chain complex over the integers: for each degree the number of cells and their boundaries.
///
/// # Examples
/// See [`Complex::read`].
#[derive(Clone, Debug)]
pub struct Complex {
    counts: Vec<usize>,
    /// For each degree from 1 on the boundary of each cell.
    columns: Vec<Lists<(u32, i64)>>,
    /// None where cells have numbers alone.
    names: Option<Names>,
}

impl Complex {
    /// Reads a facet list or a chain complex in JSON, or a surface in OFF or OBJ.
    ///
    /// A **facet list** is `[[0, 1, 2], ..]` or `{"facets": [..]}`. Its cells of degree k are the faces with k + 1 vertices, in the order
    /// of their rising lists of vertices; face i, without vertex i, has incidence $(-1)^i$. A **chain complex** is
    /// `{"boundaries": [{"rows": m, "cols": n, "entries": [[row, column, value], ..]}, ..]}`; that its boundaries compose to zero is checked.
    /// Both may have `"vertices"`, a list of places, which are all vertices then.
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
            Some(b'{' | b'[') => Self::of_json(parsed(bytes, step)?, bytes.len()),
            Some(_) => polygons::read(bytes),
            None => Err(Fault::new(step, "the file is empty")),
        }
    }

    fn of_json(value: Value, size: usize) -> Result<Self, Fault> {
        let step = "input";
        let of_facets = |list: Value, vertices: Option<u32>| {
            let facets = facets_of(&list)?;
            // What the list was read from is not needed while the faces are made.
            drop(list);
            let last = facets.iter().flatten().max();
            match vertices.zip(last).filter(|(count, last)| *last >= count) {
                Some((_, last)) => Err(Fault::new(step, format!("vertex {last} is not there"))),
                None => simplices::of_facets(&facets, &(0..vertices.unwrap_or(0)).collect::<Vec<_>>(), size),
            }
        };
        let mut object = match value {
            Value::Object(object) => object,
            list => return of_facets(list, None),
        };
        // Where vertices lie has no part in what is proved; without a facet they are vertices too.
        let vertices = match object.remove("vertices") {
            Some(points) => u32::try_from(list(&points, "\"vertices\"", step)?.len()).ok(),
            None => None,
        };
        let of_other = object.keys().find(|key| !["name", "facets", "boundaries"].contains(&key.as_str()));
        if let Some(key) = of_other {
            return Err(Fault::new("input", format!("the checker does not know the key {key:?}")));
        }
        match (object.remove("facets"), object.get("boundaries")) {
            (Some(facets), None) => of_facets(facets, vertices),
            (None, Some(matrices)) => {
                let complex = Self::of_matrices(list(matrices, "\"boundaries\"", step)?)?;
                match vertices.filter(|count| *count as usize != complex.counts[0]) {
                    Some(count) => Err(Fault::new(step, format!("{count} vertices have places"))),
                    None => Ok(complex),
                }
            }
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
            columns.push(columns_of(entries, rows, width)?.into_iter().collect());
        }
        if counts.is_empty() {
            return Err(Fault::new(step, "there is no boundary matrix"));
        }
        let complex = Self::new(counts, columns, None);
        complex.check_squares()?;
        Ok(complex)
    }

    /// From the numbers of cells of each degree, and the boundaries of those of degrees 1, 2, .., which compose to zero.
    ///
    /// # Examples
    /// ```
    /// let edge = coface_check::Complex::of_columns(vec![2, 1], vec![vec![vec![(0, -1), (1, 1)]]]);
    /// assert_eq!(edge.boundary(1, 0), [(0, -1), (1, 1)]);
    /// ```
    pub fn of_columns(counts: Vec<usize>, columns: Vec<Vec<Vec<(u32, i64)>>>) -> Self {
        Self::new(counts, columns.into_iter().map(|own| own.into_iter().collect()).collect(), None)
    }

    /// From the boundaries of the cells of degrees 1, 2, ...
    pub(crate) fn new(counts: Vec<usize>, columns: Vec<Lists<(u32, i64)>>, names: Option<Names>) -> Self {
        Self { counts, columns, names }
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
        self.columns[degree - 1].get(cell)
    }

    /// The vertices of a cell: rising those of a simplex, around those of a polygon; `None` where cells have numbers alone.
    ///
    /// # Panics
    /// If there is no such cell.
    ///
    /// # Examples
    /// ```
    /// let triangle = coface_check::Complex::read(b"[[0, 1, 2]]").expect("a facet list");
    /// assert_eq!(triangle.vertices(1, 2), Some(&[1, 2][..]));
    /// ```
    pub fn vertices(&self, degree: usize, cell: usize) -> Option<&[u32]> {
        Some(self.names.as_ref()?[degree].get(cell))
    }

    /// The cells by their vertices, where they have such names.
    pub(crate) fn names(&self) -> Option<&Names> {
        self.names.as_ref()
    }

    /// For each cell of a degree the cells above it, with their incidences.
    pub(crate) fn cofaces(&self, degree: usize) -> Vec<Column> {
        let mut above = vec![Column::new(); self.counts[degree]];
        for cell in 0..self.counts.get(degree + 1).copied().unwrap_or(0) {
            for (face, incidence) in self.boundary(degree + 1, cell) {
                above[*face as usize].push((cell as u32, *incidence));
            }
        }
        above
    }

    /// The complex modulo a subcomplex: the faces that lie in one cell of the highest degree alone, or the cells of another file, with
    /// all their faces. What is left keeps its order.
    ///
    /// # Errors
    /// A [`Fault`] if the other file is no facet list or surface, or has a cell that is not here.
    ///
    /// # Examples
    /// ```
    /// let triangle = coface_check::Complex::read(b"[[0, 1, 2]]").expect("a facet list");
    /// assert_eq!(triangle.relative(None).expect("its boundary").counts(), [0, 0, 1]);
    /// assert_eq!(triangle.relative(Some(b"[[1]]")).expect("a vertex").counts(), [2, 3, 1]);
    /// ```
    pub fn relative(&self, part: Option<&[u8]>) -> Result<Self, Fault> {
        let kept = self.part(part)?.into_iter();
        let kept = kept.map(|is_in| (0..is_in.len()).filter(|cell| !is_in[*cell]).collect());
        Ok(self.restricted(&kept.collect::<Vec<_>>()))
    }

    /// For each degree which cells lie in a subcomplex: as for [`Complex::relative`].
    ///
    /// # Errors
    /// Those of [`Complex::relative`].
    ///
    /// # Examples
    /// ```
    /// let edge = coface_check::Complex::read(b"[[0, 1]]").expect("a facet list");
    /// assert_eq!(edge.part(None).expect("its boundary"), [vec![true, true], vec![false]]);
    /// ```
    pub fn part(&self, part: Option<&[u8]>) -> Result<Vec<Vec<bool>>, Fault> {
        let mut is_in: Vec<Vec<bool>> = self.counts.iter().map(|count| vec![false; *count]).collect();
        let top = self.counts.len() - 1;
        match part {
            None if top > 0 => {
                let cofaces = self.cofaces(top - 1);
                is_in[top - 1].iter_mut().zip(&cofaces).for_each(|(is_in, cells)| *is_in = cells.len() == 1);
            }
            None => (),
            Some(bytes) => {
                let finder = Finder::of(self, None);
                for cell in cells_of(bytes)? {
                    let (degree, cell) = finder.cell(&cell, "relative")?;
                    is_in[degree][cell as usize] = true;
                }
            }
        }
        for degree in (1..=top).rev() {
            for cell in (0..self.counts[degree]).filter(|cell| is_in[degree][*cell]).collect::<Vec<_>>() {
                self.boundary(degree, cell)
                    .iter()
                    .for_each(|(face, _)| is_in[degree - 1][*face as usize] = true);
            }
        }
        Ok(is_in)
    }

    /// The cells that are kept, which rise in each degree, with what is kept of their boundaries.
    ///
    /// # Panics
    /// If a cell is not there.
    ///
    /// # Examples
    /// ```
    /// let edge = coface_check::Complex::read(b"[[0, 1]]").expect("a facet list");
    /// assert_eq!(edge.restricted(&[vec![1], vec![0]]).boundary(1, 0), [(0, 1)]);
    /// ```
    pub fn restricted(&self, kept: &[Vec<usize>]) -> Self {
        let column = |degree: usize, cell: usize| -> Column {
            let place = |(face, incidence): &(u32, i64)| {
                let place = kept[degree - 1].binary_search(&(*face as usize)).ok()?;
                Some((place as u32, *incidence))
            };
            self.boundary(degree, cell).iter().filter_map(place).collect()
        };
        let columns =
            (1..kept.len()).map(|k| kept[k].iter().map(|&cell| column(k, cell)).collect()).collect();
        let names = self.names.as_ref().map(|names| {
            let of = |(names, kept): (&Lists<u32>, &Vec<usize>)| {
                kept.iter().map(|&cell| names.get(cell).to_vec()).collect()
            };
            names.iter().zip(kept).map(of).collect()
        });
        Self::new(kept.iter().map(Vec::len).collect(), columns, names)
    }
}

/// Finds cells by their vertices in any order, or by their numbers where they have no vertices.
pub(crate) struct Finder<'a> {
    complex: &'a Complex,
    by_vertices: HashMap<Vec<u32>, (usize, u32)>,
}

impl<'a> Finder<'a> {
    /// Finds cells of one degree, or of all.
    pub(crate) fn of(complex: &'a Complex, degree: Option<usize>) -> Self {
        let mut by_vertices = HashMap::new();
        for (k, names) in
            complex.names.iter().flatten().enumerate().filter(|(k, _)| degree.is_none_or(|d| d == *k))
        {
            by_vertices.extend(names.iter().zip(0..).map(|(name, cell)| (sorted(name), (k, cell))));
        }
        Self { complex, by_vertices }
    }

    fn cell(&self, vertices: &[u32], step: &str) -> Result<(usize, u32), Fault> {
        let found = self.by_vertices.get(&sorted(vertices)).copied();
        found.ok_or_else(|| Fault::new(step, format!("there is no cell {vertices:?}")))
    }

    /// A cell of a degree, and 1 or -1: whether the order of its vertices is that of the complex.
    pub(crate) fn oriented(&self, degree: usize, listed: &[u32], step: &str) -> Result<(u32, i64), Fault> {
        let Some(names) = &self.complex.names else {
            return match *listed {
                [cell] if self.complex.counts.get(degree).is_some_and(|count| (cell as usize) < *count) => {
                    Ok((cell, 1))
                }
                _ => Err(Fault::new(step, format!("there is no cell {listed:?} of degree {degree}"))),
            };
        };
        let cell = self.cell(listed, step)?.1;
        let name = names[degree].get(cell as usize);
        if name.len() == degree + 1 {
            let pairs = (0..listed.len()).flat_map(|j| (0..j).map(move |i| (listed[i], listed[j])));
            let place = |vertex| name.iter().position(|other| *other == vertex);
            let swaps = pairs.filter(|(a, b)| place(*a) > place(*b)).count();
            return Ok((cell, if swaps % 2 == 0 { 1 } else { -1 }));
        }
        let mut around = listed.to_vec();
        around.rotate_left(listed.iter().position(|vertex| *vertex == name[0]).unwrap_or(0));
        if around == name {
            return Ok((cell, 1));
        }
        around[1..].reverse();
        match around == name {
            true => Ok((cell, -1)),
            false => Err(Fault::new(step, format!("{listed:?} does not go around cell {cell}"))),
        }
    }
}

fn sorted(vertices: &[u32]) -> Vec<u32> {
    let mut sorted = vertices.to_vec();
    sorted.sort_unstable();
    sorted
}

/// The cells that a facet list or a surface names.
fn cells_of(bytes: &[u8]) -> Result<Vec<Vec<u32>>, Fault> {
    match parsed(bytes, "input") {
        Ok(value) => facets_of(value.get("facets").unwrap_or(&value)),
        Err(_) => polygons::cells(bytes),
    }
}

fn facets_of(value: &Value) -> Result<Vec<Vec<u32>>, Fault> {
    let step = "input";
    let facets = list(value, "the facet list", step)?.iter().enumerate().map(|(i, facet)| {
        let vertices = list(facet, &format!("facet {i}"), step)?;
        let vertices = vertices.iter().map(|vertex| index(vertex, "a vertex", step));
        let vertices = sorted(&vertices.collect::<Result<Vec<u32>, _>>()?);
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
