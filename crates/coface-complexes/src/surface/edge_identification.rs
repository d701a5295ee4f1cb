//! Edge identification: which sides of polygons, and which loose edges, are one edge.
//!
//! Two passes of a counting sort. The first cuts the sides into ranges of their smaller vertex, in streams; the second
//! sorts each range by that vertex in the cache, and then the few sides at each vertex by the other end. Sides that
//! come to lie beside each other are one edge. Both passes run in parallel over chunks of faces and ranges of
//! vertices; the result does not depend on how they were cut.

use super::range_sort::{RangedRecords, RecordSource, equal_ranges, split_by};
use coface_algebra::RaggedArray;
use coface_algebra::progress::stage;
use coface_algebra::{Error, ErrorKind};
use rayon::prelude::*;
use std::cmp::Ordering;
use std::ops::Range;
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

/// Vertices `range << RANGE_BITS ..` make up a range; the sides of one range fit in the second-level cache.
const RANGE_BITS: u32 = 13;
const RANGE: usize = 1 << RANGE_BITS;
/// Sides a chunk of the first pass has, about.
const CHUNK: usize = 1 << 17;
/// The most sides and loose edges: two bits of a 32-bit word tell how a side lies in its face.
const LIMIT: usize = 1 << 30;
/// The bit of a side that runs from its larger to its smaller vertex.
const REVERSED: u32 = 1;
/// The bit of the side that is the least edge of its face.
const LEAST: u32 = 2;

/// The edges of polygons and where they come from.
#[derive(Clone, Debug, Default)]
pub(crate) struct EdgeTable {
    /// Edge e joins `ends[2 * e] < ends[2 * e + 1]`; the pairs rise lexicographically.
    pub(crate) ends: Vec<u32>,
    /// The edge of each corner (from that corner to the next), then of each loose edge.
    pub(crate) corner_edges: Vec<u32>,
    /// The faces at edge e are `faces[face_starts[e]..face_starts[e + 1]]`, each as `2 * face + reversed`.
    pub(crate) face_starts: Vec<u32>,
    pub(crate) faces: Vec<u32>,
    /// Pairs (first, later) of faces with the same cycle of edges, by the later face.
    pub(crate) duplicates: Vec<(u32, u32)>,
}

/// A side of a face or a loose edge on its way through the passes: smaller vertex, larger vertex, and the position
/// of the side with its two bits.
type Side = [u32; 3];

/// Identifies the sides of the polygons and the loose edges.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] naming the first polygon or loose edge with a vertex that does not exist, with a repeated vertex,
/// or a polygon of fewer than three vertices; [`ErrorKind::TooLarge`] from 2^30 sides on.
pub(crate) fn identify_edges(
    vertex_count: usize,
    polygons: &RaggedArray,
    loose_edges: &[[u32; 2]],
) -> Result<EdgeTable, Error> {
    let corner_count = polygons.item_count();
    let side_count = corner_count + loose_edges.len();
    if side_count >= LIMIT || u32::try_from(vertex_count).is_err() {
        return Err(Error::new(
            ErrorKind::TooLarge,
            format!(
                "{vertex_count} vertices and {side_count} sides of faces; the limits are 2^32 - 1 and 2^30 - 1"
            ),
        ));
    }
    let sides =
        RangedRecords::new(vertex_count, RANGE_BITS, &Sides::new(vertex_count, polygons, loose_edges))?;
    let range_count = sides.range_count();

    // Second pass, first half: sort each range, count its edges.
    let range_sizes = sides.range_sizes();
    let mut keys = vec![0u64; side_count];
    let mut bucket_ends = vec![0u32; vertex_count];
    let steps = stage("identifying edges", 2 * range_count);
    let counted: Vec<RangeCount> = split_by(&mut keys, range_sizes.iter().copied())
        .into_par_iter()
        .zip(bucket_ends.par_chunks_mut(RANGE))
        .enumerate()
        .map(|(r, (keys, ends))| {
            steps.advance(1);
            sort_range(sides.base(r), sides.segments(r), keys, ends, polygons, corner_count)
        })
        .collect();
    drop(sides);

    // Second half: number the edges.
    let edge_count: usize = counted.iter().map(|count| count.edges).sum();
    let face_of_corner = CornerFaces::new(polygons);
    let mut ends = vec![0u32; 2 * edge_count];
    let mut face_starts = vec![0u32; edge_count + 1];
    let mut faces = vec![0u32; corner_count];
    let corner_edges: Vec<AtomicU32> = {
        let mut zeros = Vec::new();
        zeros.resize_with(side_count, AtomicU32::default);
        zeros
    };
    let mut firsts = Vec::with_capacity(range_count);
    let mut total = (0usize, 0usize, 0usize);
    for (count, &size) in counted.iter().zip(&range_sizes) {
        firsts.push(total);
        total = (total.0 + size, total.1 + count.edges, total.2 + size - count.loose);
    }
    split_by(&mut ends, counted.iter().map(|count| 2 * count.edges))
        .into_par_iter()
        .zip(split_by(&mut face_starts[1..], counted.iter().map(|count| count.edges)))
        .zip(split_by(&mut faces, counted.iter().zip(&range_sizes).map(|(count, size)| size - count.loose)))
        .zip(bucket_ends.par_chunks(RANGE))
        .enumerate()
        .for_each(|(r, (((ends, starts), faces), bucket_ends))| {
            steps.advance(1);
            let (first_key, first_edge, first_face) = firsts[r];
            let keys = &keys[first_key..first_key + range_sizes[r]];
            let (mut edge, mut face, mut at) = (0, 0, 0);
            for (local, &bucket_end) in bucket_ends.iter().enumerate() {
                let bucket_end = bucket_end as usize;
                while at < bucket_end {
                    let larger = (keys[at] >> 32) as u32;
                    ends[2 * edge] = ((r << RANGE_BITS) + local) as u32;
                    ends[2 * edge + 1] = larger;
                    while at < bucket_end && (keys[at] >> 32) as u32 == larger {
                        let word = keys[at] as u32;
                        let corner = (word >> 2) as usize;
                        corner_edges[corner].store((first_edge + edge) as u32, Relaxed);
                        if corner < corner_count {
                            faces[face] = face_of_corner.face(corner) << 1 | (word & REVERSED);
                            face += 1;
                        }
                        at += 1;
                    }
                    starts[edge] = (first_face + face) as u32;
                    edge += 1;
                }
            }
        });
    let mut duplicates: Vec<(u32, u32)> = counted.into_iter().flat_map(|count| count.duplicates).collect();
    duplicates.sort_unstable_by_key(|&(first, later)| (later, first));
    let corner_edges = corner_edges.into_iter().map(AtomicU32::into_inner).collect();
    Ok(EdgeTable { ends, corner_edges, face_starts, faces, duplicates })
}

/// What the sides of one range of smaller vertices amount to.
struct RangeCount {
    edges: usize,
    loose: usize,
    duplicates: Vec<(u32, u32)>,
}

/// The sides of all faces and the loose edges as records.
struct Sides<'a> {
    vertex_count: usize,
    polygons: &'a RaggedArray,
    loose_edges: &'a [[u32; 2]],
    /// The faces of each chunk but the last, which is that of the loose edges.
    face_ranges: Vec<Range<usize>>,
}

impl<'a> Sides<'a> {
    fn new(vertex_count: usize, polygons: &'a RaggedArray, loose_edges: &'a [[u32; 2]]) -> Self {
        let chunk_count = polygons.item_count().div_ceil(CHUNK);
        let face_ranges = equal_ranges(polygons.len(), chunk_count);
        Self { vertex_count, polygons, loose_edges, face_ranges }
    }
}

impl RecordSource<3> for Sides<'_> {
    fn chunk_sizes(&self) -> Vec<usize> {
        let corners =
            |faces: &Range<usize>| self.polygons.start(faces.end) - self.polygons.start(faces.start);
        self.face_ranges.iter().map(corners).chain([self.loose_edges.len()]).collect()
    }

    fn check(&self, chunk: usize) -> Result<(), Error> {
        if let Some(faces) = self.face_ranges.get(chunk) {
            let mut bad = None;
            for_each_polygon(self.polygons, faces.clone(), |face, _, polygon| {
                if bad.is_none() && !is_sound(self.vertex_count, polygon) {
                    bad = Some(face);
                }
            });
            return bad.map_or(Ok(()), |face| {
                Err(polygon_fault(self.vertex_count, face, self.polygons.list(face)))
            });
        }
        for (i, &ends) in self.loose_edges.iter().enumerate() {
            check_loose_edge(self.vertex_count, i, ends)?;
        }
        Ok(())
    }

    fn for_each(&self, chunk: usize, mut put: impl FnMut(Side)) {
        let mut put = |a: u32, b: u32, position: usize, least: u32| {
            let (smaller, larger, reversed) = if a < b { (a, b, 0) } else { (b, a, REVERSED) };
            put([smaller, larger, (position as u32) << 2 | least | reversed]);
        };
        if let Some(faces) = self.face_ranges.get(chunk) {
            for_each_polygon(self.polygons, faces.clone(), |_, start, polygon| {
                let least = least_side(polygon);
                for_each_side(polygon, |a, b, i| put(a, b, start + i, if i == least { LEAST } else { 0 }));
            });
        } else {
            for (i, &[a, b]) in self.loose_edges.iter().enumerate() {
                put(a, b, self.polygons.item_count() + i, 0);
            }
        }
    }
}

/// Sorts the sides of one range by smaller vertex, larger vertex and position into `keys` (larger vertex above, word
/// below), writes where the sides of each vertex end, counts edges and finds equal faces.
fn sort_range<'a>(
    base: usize,
    segments: impl Iterator<Item = &'a [Side]> + Clone,
    keys: &mut [u64],
    bucket_ends: &mut [u32],
    polygons: &RaggedArray,
    corner_count: usize,
) -> RangeCount {
    let mut count = RangeCount { edges: 0, loose: 0, duplicates: Vec::new() };
    if keys.is_empty() {
        return count;
    }
    for segment in segments.clone() {
        for &[smaller, ..] in segment {
            bucket_ends[smaller as usize - base] += 1;
        }
    }
    let mut total = 0;
    for end in bucket_ends.iter_mut() {
        let size = *end;
        *end = total;
        total += size;
    }
    for segment in segments {
        for &[smaller, larger, word] in segment {
            let at = &mut bucket_ends[smaller as usize - base];
            keys[*at as usize] = u64::from(larger) << 32 | u64::from(word);
            *at += 1;
        }
    }
    let mut start = 0;
    for (local, &end) in bucket_ends.iter().enumerate() {
        let bucket = &mut keys[start..end as usize];
        start = end as usize;
        sort_bucket(bucket);
        let mut at = 0;
        while at < bucket.len() {
            let larger = bucket[at] >> 32;
            let first = at;
            let mut least_count = 0;
            while at < bucket.len() && bucket[at] >> 32 == larger {
                let word = bucket[at] as u32;
                least_count += (word & LEAST) >> 1;
                count.loose += usize::from((word >> 2) as usize >= corner_count);
                at += 1;
            }
            count.edges += 1;
            if least_count > 1 {
                let smaller = (base + local) as u32;
                collect_duplicates(
                    &bucket[first..at],
                    [smaller, larger as u32],
                    polygons,
                    &mut count.duplicates,
                );
            }
        }
    }
    count
}

/// Sorts the few sides at one vertex; they come in rising order of position, so most buckets are nearly in order.
fn sort_bucket(bucket: &mut [u64]) {
    if bucket.len() > 24 {
        bucket.sort_unstable();
        return;
    }
    for i in 1..bucket.len() {
        let key = bucket[i];
        let mut j = i;
        while j > 0 && bucket[j - 1] > key {
            bucket[j] = bucket[j - 1];
            j -= 1;
        }
        bucket[j] = key;
    }
}

/// Adds the pairs of equal faces among those that have this edge as their least one.
fn collect_duplicates(
    run: &[u64],
    least: [u32; 2],
    polygons: &RaggedArray,
    duplicates: &mut Vec<(u32, u32)>,
) {
    let mut cycles: Vec<(u32, Cycle<'_>)> = Vec::new();
    for &key in run {
        if key as u32 & LEAST != 0 {
            let face = face_of_position(polygons, (key as u32 >> 2) as usize);
            cycles.push((face as u32, Cycle::new(polygons.list(face), least)));
        }
    }
    if let [(first, a), (later, b)] = cycles[..] {
        // By far the most frequent case: two different faces at an edge.
        if a.compare(&b) == Ordering::Equal {
            duplicates.push((first, later));
        }
        return;
    }
    cycles.sort_by(|(_, a), (_, b)| a.compare(b));
    for equal in cycles.chunk_by(|(_, a), (_, b)| a.compare(b) == Ordering::Equal) {
        duplicates.extend(equal[1..].iter().map(|&(later, _)| (equal[0].0, later)));
    }
}

/// A polygon read from its least vertex towards the smaller neighbor of that vertex; equal for polygons with the same
/// edges, whatever vertex they start at and whichever way they run.
#[derive(Clone, Copy)]
struct Cycle<'a> {
    polygon: &'a [u32],
    start: usize,
    forward: bool,
}

impl<'a> Cycle<'a> {
    fn new(polygon: &'a [u32], [first, second]: [u32; 2]) -> Self {
        let start =
            polygon.iter().position(|&v| v == first).expect("the face has the edge it was filed under");
        let next = polygon[if start + 1 == polygon.len() { 0 } else { start + 1 }];
        Self { polygon, start, forward: next == second }
    }

    fn compare(&self, other: &Self) -> Ordering {
        self.polygon.len().cmp(&other.polygon.len()).then_with(|| self.vertices().cmp(other.vertices()))
    }

    fn vertices(&self) -> impl Iterator<Item = u32> {
        let n = self.polygon.len();
        let step = if self.forward { 1 } else { n - 1 };
        (0..n).scan(self.start, move |at, _| {
            let vertex = self.polygon[*at];
            *at += step;
            *at -= if *at >= n { n } else { 0 };
            Some(vertex)
        })
    }
}

/// The face of each corner: computed where all faces have one size, looked up otherwise.
pub(crate) enum CornerFaces {
    Triangles,
    Uniform(usize),
    Listed(Vec<u32>),
}

impl CornerFaces {
    pub(crate) fn new(polygons: &RaggedArray) -> Self {
        match polygons.uniform_width() {
            Some(3) => Self::Triangles,
            Some(width) => Self::Uniform(width),
            None => {
                let mut faces = Vec::with_capacity(polygons.item_count());
                for (face, polygon) in polygons.iter().enumerate() {
                    faces.resize(faces.len() + polygon.len(), face as u32);
                }
                Self::Listed(faces)
            }
        }
    }

    pub(crate) fn face(&self, corner: usize) -> u32 {
        match self {
            Self::Triangles => corner as u32 / 3,
            Self::Uniform(width) => (corner / width) as u32,
            Self::Listed(faces) => faces[corner],
        }
    }
}

/// The face that the corner at this position belongs to, by bisection where faces differ in size.
fn face_of_position(polygons: &RaggedArray, corner: usize) -> usize {
    if let Some(width) = polygons.uniform_width() {
        return corner / width;
    }
    let (mut low, mut high) = (0, polygons.len());
    while high - low > 1 {
        let middle = (low + high) / 2;
        if polygons.start(middle) <= corner {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// Calls `visit` with each polygon in the range, its number and the position of its first corner.
fn for_each_polygon(
    polygons: &RaggedArray,
    faces: Range<usize>,
    mut visit: impl FnMut(usize, usize, &[u32]),
) {
    let corners = polygons.start(faces.start)..polygons.start(faces.end);
    let mut start = corners.start;
    // Triangles as a loop of their own: their size is then known when the loop is compiled.
    if polygons.uniform_width() == Some(3) {
        for (face, triangle) in faces.zip(polygons.items()[corners].as_chunks::<3>().0) {
            visit(face, start, triangle);
            start += 3;
        }
        return;
    }
    for face in faces {
        let polygon = polygons.list(face);
        visit(face, start, polygon);
        start += polygon.len();
    }
}

/// Calls `visit` with the ends and the number of each side of a polygon.
#[inline(always)]
fn for_each_side(polygon: &[u32], mut visit: impl FnMut(u32, u32, usize)) {
    if let &[a, b, c] = polygon {
        visit(a, b, 0);
        visit(b, c, 1);
        visit(c, a, 2);
        return;
    }
    for (i, pair) in polygon.windows(2).enumerate() {
        visit(pair[0], pair[1], i);
    }
    visit(polygon[polygon.len() - 1], polygon[0], polygon.len() - 1);
}

/// The number of the side whose pair of vertices is the least: at the least vertex, towards its smaller neighbor.
#[inline(always)]
fn least_side(polygon: &[u32]) -> usize {
    if let &[a, b, c] = polygon {
        // The side opposite to the greatest vertex.
        return if c > a && c > b {
            0
        } else if a > b {
            1
        } else {
            2
        };
    }
    let n = polygon.len();
    let least = (0..n).min_by_key(|&i| polygon[i]).expect("a polygon has vertices");
    let (before, after) = ((least + n - 1) % n, (least + 1) % n);
    if polygon[after] < polygon[before] { least } else { before }
}

pub(crate) fn is_sound(vertex_count: usize, polygon: &[u32]) -> bool {
    if let &[a, b, c] = polygon {
        (a.max(b).max(c) as usize) < vertex_count && a != b && b != c && c != a
    } else {
        polygon.len() > 3
            && polygon.iter().all(|&v| (v as usize) < vertex_count)
            && repeated_vertex(polygon).is_none()
    }
}

#[cold]
pub(crate) fn polygon_fault(vertex_count: usize, face: usize, polygon: &[u32]) -> Error {
    if let Some(&vertex) = polygon.iter().find(|&&v| v as usize >= vertex_count) {
        return Error::invalid(format!(
            "face f{face} names vertex v{vertex}, but there are {vertex_count} vertices"
        ))
        .with_cure("number the vertices from 0");
    }
    if let Some(vertex) = repeated_vertex(polygon) {
        return Error::invalid(format!("face f{face} repeats vertex v{vertex}"))
            .with_cure("remove the face, or leave the repeated vertex out");
    }
    Error::invalid(format!("face f{face} has {} vertices; a face needs three", polygon.len()))
        .with_cure("remove the face, or give it as a loose edge")
}

fn check_loose_edge(vertex_count: usize, i: usize, [a, b]: [u32; 2]) -> Result<(), Error> {
    if a.max(b) as usize >= vertex_count {
        return Err(Error::invalid(format!(
            "loose edge {i} names vertex v{}, but there are {vertex_count} vertices",
            a.max(b)
        ))
        .with_cure("number the vertices from 0"));
    }
    if a == b {
        return Err(Error::invalid(format!("loose edge {i} joins v{a} to itself")).with_cure("remove it"));
    }
    Ok(())
}

/// The first vertex that stands twice; short lists are compared pairwise, long ones sorted.
fn repeated_vertex(vertices: &[u32]) -> Option<u32> {
    if vertices.len() <= 16 {
        return vertices.iter().enumerate().find(|(i, v)| vertices[..*i].contains(v)).map(|(_, &v)| v);
    }
    let mut sorted = vertices.to_vec();
    sorted.sort_unstable();
    sorted.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| pair[0])
}
