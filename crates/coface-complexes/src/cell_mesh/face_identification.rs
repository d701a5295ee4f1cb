//! Face identification: which sides of cells, and which loose polygons, are one face.
//!
//! Two sides are one face when they are the same cycle of vertices, whatever vertex it starts at and whichever way it
//! runs. The cycles are sorted by their least vertex and its two neighbors in two passes of counting, as the edges of a
//! surface are (`surface::range_sort`); among polygons of four and more vertices the rest decides.

use crate::cell_mesh::shape::CellShape;
use crate::surface::edge_identification::is_sound;
use crate::surface::edge_identification::polygon_fault;
use crate::surface::range_sort::RangedRecords;
use crate::surface::range_sort::RecordSource;
use crate::surface::range_sort::equal_ranges;
use crate::surface::range_sort::split_by;
use coface_algebra::RaggedArray;
use coface_algebra::progress::stage;
use coface_algebra::{Error, ErrorKind};
use rayon::prelude::*;
use std::ops::Range;
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

/// Vertices of a range; a vertex is the least one of about twelve faces.
const RANGE_BITS: u32 = 11;
const RANGE: usize = 1 << RANGE_BITS;
/// Cells a chunk of the first pass has.
const CHUNK: usize = 1 << 15;
/// The most sides and polygons: two bits of a 32-bit word tell how a side lies in its face.
const LIMIT: usize = 1 << 30;
/// The bit of a side that runs against the reference cycle of its face.
const REVERSED: u32 = 1;
/// The bit of a side with more than three vertices.
const LARGE: u32 = 2;

/// The faces of cells and where they come from.
///
/// The reference cycle of a face starts at its least vertex and goes to the smaller neighbor of that vertex.
#[derive(Clone, Debug, Default)]
pub(crate) struct FaceTable {
    /// The reference cycles, rising by least vertex and its two neighbors.
    pub(crate) polygons: RaggedArray,
    /// The face of each side of each cell in the order of [`CellShape::faces`], then of each loose polygon, each as
    /// `2 * face + reversed`.
    pub(crate) side_faces: Vec<u32>,
    /// The cells at face f are `cells[cell_starts[f]..cell_starts[f + 1]]`, each as `2 * cell + reversed`.
    pub(crate) cell_starts: Vec<u32>,
    pub(crate) cells: Vec<u32>,
}

/// Where the sides of each cell start, and which cell a side belongs to.
#[derive(Clone, Debug)]
pub(crate) enum CellSides {
    /// All cells have this many sides.
    Uniform(usize),
    /// The starts, one more than cells, and the cell of each side.
    Listed { starts: Vec<u32>, cells: Vec<u32> },
}

impl CellSides {
    pub(crate) fn new(shapes: &[CellShape]) -> Self {
        let first = shapes.first().copied().unwrap_or(CellShape::Tetrahedron);
        if shapes.iter().all(|&shape| shape == first) {
            return Self::Uniform(first.faces().len());
        }
        let mut starts = Vec::with_capacity(shapes.len() + 1);
        let mut cells = Vec::new();
        for (cell, shape) in shapes.iter().enumerate() {
            starts.push(cells.len() as u32);
            cells.resize(cells.len() + shape.faces().len(), cell as u32);
        }
        starts.push(cells.len() as u32);
        Self::Listed { starts, cells }
    }

    pub(crate) fn start(&self, cell: usize) -> usize {
        match self {
            Self::Uniform(count) => cell * count,
            Self::Listed { starts, .. } => starts[cell] as usize,
        }
    }

    pub(crate) fn range(&self, cell: usize) -> Range<usize> {
        self.start(cell)..self.start(cell + 1)
    }

    fn cell(&self, side: usize) -> usize {
        match self {
            Self::Uniform(4) => side / 4,
            Self::Uniform(count) => side / count,
            Self::Listed { cells, .. } => cells[side] as usize,
        }
    }
}

/// Cells and loose polygons as a source of records: least vertex, its smaller and its larger neighbor in the cycle, and
/// the position with its two bits.
struct Input<'a> {
    vertex_count: usize,
    shapes: &'a [CellShape],
    cells: &'a RaggedArray,
    sides: &'a CellSides,
    side_count: usize,
    polygons: &'a RaggedArray,
    /// The cells of each chunk but the last, which is that of the polygons.
    cell_ranges: Vec<Range<usize>>,
}

impl RecordSource<4> for Input<'_> {
    fn chunk_sizes(&self) -> Vec<usize> {
        let sides = |cells: &Range<usize>| self.sides.start(cells.end) - self.sides.start(cells.start);
        self.cell_ranges.iter().map(sides).chain([self.polygons.len()]).collect()
    }

    fn check(&self, chunk: usize) -> Result<(), Error> {
        if let Some(cells) = self.cell_ranges.get(chunk) {
            for cell in cells.clone() {
                check_cell(self.vertex_count, cell, self.shapes[cell], self.cells.list(cell))?;
            }
            return Ok(());
        }
        match (0..self.polygons.len()).find(|&i| !is_sound(self.vertex_count, self.polygons.list(i))) {
            Some(i) => Err(polygon_fault(self.vertex_count, i, self.polygons.list(i))),
            None => Ok(()),
        }
    }

    fn for_each(&self, chunk: usize, mut put: impl FnMut([u32; 4])) {
        let Some(cells) = self.cell_ranges.get(chunk) else {
            for (i, polygon) in self.polygons.iter().enumerate() {
                put(polygon_record(polygon, self.side_count + i));
            }
            return;
        };
        let mut position = self.sides.start(cells.start);
        for cell in cells.clone() {
            let vertices = self.cells.list(cell);
            if let &[a, b, c, d] = vertices {
                // The sides of a tetrahedron, as in `CellShape::faces`.
                for (i, [x, y, z]) in [[a, c, b], [a, b, d], [b, c, d], [c, a, d]].into_iter().enumerate() {
                    put(triangle_record(x, y, z, position + i));
                }
                position += 4;
                continue;
            }
            for face in self.shapes[cell].faces() {
                match **face {
                    [x, y, z] => put(triangle_record(vertices[x], vertices[y], vertices[z], position)),
                    [x, y, z, w] => {
                        put(polygon_record(&[vertices[x], vertices[y], vertices[z], vertices[w]], position));
                    }
                    _ => unreachable!("sides of cells are triangles and quadrangles"),
                }
                position += 1;
            }
        }
    }
}

impl Input<'_> {
    /// The reference cycle of the side or polygon at this position.
    fn cycle(&self, position: usize) -> Vec<u32> {
        if position >= self.side_count {
            return reference_cycle(self.polygons.list(position - self.side_count).to_vec());
        }
        let cell = self.sides.cell(position);
        let vertices = self.cells.list(cell);
        let side = self.shapes[cell].faces()[position - self.sides.start(cell)];
        reference_cycle(side.iter().map(|&i| vertices[i]).collect())
    }

    /// The vertex opposite to the least one in the quadrangle at this position; `None` for other polygons.
    fn opposite(&self, position: usize) -> Option<u32> {
        let cell = (position < self.side_count).then(|| self.sides.cell(position))?;
        let vertices = self.cells.list(cell);
        let &[x, y, z, w] = self.shapes[cell].faces()[position - self.sides.start(cell)] else { return None };
        let quadrangle = [x, y, z, w].map(|i| vertices[i]);
        let least = (0..4).min_by_key(|&i| quadrangle[i])?;
        Some(quadrangle[(least + 2) % 4])
    }

    /// Whether two large sides with the same least vertex and neighbors are one face.
    fn same_face(&self, p: usize, q: usize) -> bool {
        match (self.opposite(p), self.opposite(q)) {
            (Some(x), Some(y)) => x == y,
            _ => self.cycle(p) == self.cycle(q),
        }
    }
}

fn triangle_record(x: u32, y: u32, z: u32, position: usize) -> [u32; 4] {
    let (least, next, previous) = if x < y && x < z {
        (x, y, z)
    } else if y < z {
        (y, z, x)
    } else {
        (z, x, y)
    };
    record(least, next, previous, position, 0)
}

fn polygon_record(polygon: &[u32], position: usize) -> [u32; 4] {
    let n = polygon.len();
    let at = (0..n).min_by_key(|&i| polygon[i]).expect("a polygon has vertices");
    let large = if n > 3 { LARGE } else { 0 };
    record(polygon[at], polygon[(at + 1) % n], polygon[(at + n - 1) % n], position, large)
}

fn record(least: u32, next: u32, previous: u32, position: usize, large: u32) -> [u32; 4] {
    let reversed = if previous < next { REVERSED } else { 0 };
    [least, next.min(previous), next.max(previous), (position as u32) << 2 | large | reversed]
}

/// The cycle read from its least vertex towards the smaller neighbor.
fn reference_cycle(mut polygon: Vec<u32>) -> Vec<u32> {
    let at = (0..polygon.len()).min_by_key(|&i| polygon[i]).unwrap_or(0);
    polygon.rotate_left(at);
    if polygon.len() > 2 && polygon[polygon.len() - 1] < polygon[1] {
        polygon[1..].reverse();
    }
    polygon
}

/// The faces that begin in one range of vertices.
#[derive(Default)]
struct RangeFaces {
    items: Vec<u32>,
    /// The numbers of vertices; empty when all are triangles.
    sizes: Vec<u32>,
    face_count: usize,
    /// The number of loose polygons among the records.
    loose: usize,
}

/// Identifies the sides of cells and the loose polygons.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] naming the first cell or polygon with a vertex that does not exist or repeats, or of a wrong
/// size; [`ErrorKind::TooLarge`] from 2^30 sides on.
pub(crate) fn identify_faces(
    vertex_count: usize,
    shapes: &[CellShape],
    cells: &RaggedArray,
    sides: &CellSides,
    polygons: &RaggedArray,
) -> Result<FaceTable, Error> {
    let side_count = sides.start(cells.len());
    let record_count = side_count + polygons.len();
    if record_count >= LIMIT || u32::try_from(vertex_count).is_err() {
        return Err(Error::new(
            ErrorKind::TooLarge,
            format!(
                "{vertex_count} vertices and {record_count} sides of cells; the limits are 2^32 - 1 and 2^30 - 1"
            ),
        ));
    }
    let cell_ranges = equal_ranges(cells.len(), cells.len().div_ceil(CHUNK));
    let input = Input { vertex_count, shapes, cells, sides, side_count, polygons, cell_ranges };
    let records = RangedRecords::new(vertex_count, RANGE_BITS, &input)?;

    // Second pass, first half: sort each range, list its faces. A placed record is its local face and its word.
    let range_sizes = records.range_sizes();
    let mut placed = vec![0u64; record_count];
    let steps = stage("identifying faces", 2 * range_sizes.len());
    let found: Vec<RangeFaces> = split_by(&mut placed, range_sizes.iter().copied())
        .into_par_iter()
        .enumerate()
        .map_init(Vec::new, |keys, (r, placed)| {
            steps.advance(1);
            sort_range(&input, records.base(r), records.segments(r), keys, placed)
        })
        .collect();
    drop(records);

    // Second half: number the faces.
    let face_count: usize = found.iter().map(|range| range.face_count).sum();
    let side_faces: Vec<AtomicU32> = {
        let mut zeros = Vec::new();
        zeros.resize_with(record_count, AtomicU32::default);
        zeros
    };
    let mut cell_starts = vec![0u32; face_count + 1];
    let mut face_cells = vec![0u32; side_count];
    let mut firsts = Vec::with_capacity(found.len());
    let mut total = (0, 0, 0);
    for (range, &size) in found.iter().zip(&range_sizes) {
        firsts.push(total);
        total = (total.0 + size, total.1 + range.face_count, total.2 + size - range.loose);
    }
    split_by(&mut cell_starts[1..], found.iter().map(|range| range.face_count))
        .into_par_iter()
        .zip(split_by(
            &mut face_cells,
            found.iter().zip(&range_sizes).map(|(range, size)| size - range.loose),
        ))
        .enumerate()
        .for_each(|(r, (ends, face_cells))| {
            steps.advance(1);
            let (first_record, first_face, first_cell) = firsts[r];
            let mut count = 0;
            for &key in &placed[first_record..first_record + range_sizes[r]] {
                let (local, word) = ((key >> 32) as usize, key as u32);
                let position = (word >> 2) as usize;
                side_faces[position].store(((first_face + local) as u32) << 1 | (word & REVERSED), Relaxed);
                if position < side_count {
                    face_cells[count] = (sides.cell(position) as u32) << 1 | (word & REVERSED);
                    count += 1;
                }
                ends[local] = (first_cell + count) as u32;
            }
        });
    let side_faces = side_faces.into_iter().map(AtomicU32::into_inner).collect();
    Ok(FaceTable { polygons: joined(&found), side_faces, cell_starts, cells: face_cells })
}

/// The faces of all ranges in one array.
fn joined(ranges: &[RangeFaces]) -> RaggedArray {
    let mut items = vec![0; ranges.iter().map(|range| range.items.len()).sum()];
    split_by(&mut items, ranges.iter().map(|range| range.items.len()))
        .into_par_iter()
        .zip(ranges)
        .for_each(|(piece, range)| piece.copy_from_slice(&range.items));
    if items.is_empty() {
        return RaggedArray::new();
    }
    if ranges.iter().all(|range| range.sizes.is_empty()) {
        return RaggedArray::uniform(3, items).expect("triangles have three vertices");
    }
    let mut starts = vec![0];
    let mut total = 0;
    for range in ranges {
        for i in 0..range.face_count {
            total += range.sizes.get(i).copied().unwrap_or(3);
            starts.push(total);
        }
    }
    let uniform = starts.windows(2).all(|pair| pair[1] - pair[0] == starts[1]);
    let array = if uniform {
        RaggedArray::uniform(starts[1] as usize, items)
    } else {
        RaggedArray::from_parts(starts, items)
    };
    array.expect("the sizes of the faces add up")
}

/// Sorts the records of one range and lists its faces; each record is placed with the number of its face in the range.
fn sort_range<'a>(
    input: &Input<'_>,
    base: usize,
    segments: impl Iterator<Item = &'a [[u32; 4]]> + Clone,
    keys: &mut Vec<(u64, u32)>,
    placed: &mut [u64],
) -> RangeFaces {
    let mut faces = RangeFaces::default();
    if placed.is_empty() {
        return faces;
    }
    let mut bucket_ends = [0u32; RANGE];
    for segment in segments.clone() {
        for &[least, ..] in segment {
            bucket_ends[least as usize - base] += 1;
        }
    }
    let mut total = 0;
    for end in &mut bucket_ends {
        let size = *end;
        *end = total;
        total += size;
    }
    keys.clear();
    keys.resize(placed.len(), (0, 0));
    for segment in segments {
        for &[least, second, last, word] in segment {
            let at = &mut bucket_ends[least as usize - base];
            keys[*at as usize] = (u64::from(second) << 32 | u64::from(last), word);
            *at += 1;
        }
    }
    let mut at = 0;
    for (local, &end) in bucket_ends.iter().enumerate() {
        keys[at..end as usize].sort_unstable();
        while at < end as usize {
            let key = keys[at].0;
            let first = at;
            let mut large = 0;
            while at < end as usize && keys[at].0 == key {
                large |= keys[at].1 & LARGE;
                at += 1;
            }
            if large == 0 {
                faces.place(
                    &[(base + local) as u32, (key >> 32) as u32, key as u32],
                    &keys[first..at],
                    &mut placed[first..at],
                    input,
                );
            } else {
                place_large(input, &mut keys[first..at], &mut placed[first..at], &mut faces);
            }
        }
    }
    faces
}

impl RangeFaces {
    /// Adds a face and places its records.
    fn place(&mut self, cycle: &[u32], records: &[(u64, u32)], placed: &mut [u64], input: &Input<'_>) {
        if cycle.len() > 3 || !self.sizes.is_empty() {
            self.sizes.resize(self.face_count, 3);
            self.sizes.push(cycle.len() as u32);
        }
        self.items.extend_from_slice(cycle);
        for (place, &(_, word)) in placed.iter_mut().zip(records) {
            *place = (self.face_count as u64) << 32 | u64::from(word);
            self.loose += usize::from((word >> 2) as usize >= input.side_count);
        }
        self.face_count += 1;
    }
}

/// Places records with one least vertex and the same neighbors of it, some of them of more than three vertices.
fn place_large(input: &Input<'_>, records: &mut [(u64, u32)], placed: &mut [u64], faces: &mut RangeFaces) {
    let position = |record: &(u64, u32)| (record.1 >> 2) as usize;
    let is_one_face = match records {
        [_] => true,
        [a, b] => a.1 & b.1 & LARGE != 0 && input.same_face(position(a), position(b)),
        _ => false,
    };
    if is_one_face {
        return faces.place(&input.cycle(position(&records[0])), records, placed, input);
    }
    records.sort_by_cached_key(|record| (input.cycle(position(record)), record.1));
    let mut rest = placed;
    for equal in records.chunk_by(|a, b| input.cycle(position(a)) == input.cycle(position(b))) {
        let (piece, after) = rest.split_at_mut(equal.len());
        faces.place(&input.cycle(position(&equal[0])), equal, piece, input);
        rest = after;
    }
}

fn check_cell(vertex_count: usize, cell: usize, shape: CellShape, vertices: &[u32]) -> Result<(), Error> {
    if vertices.len() != shape.vertex_count() {
        return Err(Error::invalid(format!(
            "cell c{cell} has {} vertices; a {} has {}",
            vertices.len(),
            shape.name(),
            shape.vertex_count()
        )));
    }
    for (i, &vertex) in vertices.iter().enumerate() {
        if vertex as usize >= vertex_count {
            return Err(Error::invalid(format!(
                "cell c{cell}, a {}, names vertex v{vertex}, but there are {vertex_count} vertices",
                shape.name()
            ))
            .with_cure("number the vertices from 0"));
        }
        if vertices[..i].contains(&vertex) {
            return Err(Error::invalid(format!(
                "cell c{cell}, a {}, repeats vertex v{vertex}",
                shape.name()
            ))
            .with_cure("remove the cell, or give it as the smaller shape it is"));
        }
    }
    Ok(())
}
