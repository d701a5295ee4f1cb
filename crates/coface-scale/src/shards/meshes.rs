//! Shards of files of simplices that are read without being kept in memory.
//!
//! The file is read once, into flat files. Planes that halve a sample of the elements say which part has each of them; a table of the vertices that
//! several parts have says which other elements touch a part. Then each part is made of its own elements and those that touch it.

use super::folder::ShardFolder;
use super::manifest::ShardManifest;
use super::models::ShardRequest;
use super::owners::{Owners, scattered};
use super::scratch::Scratch;
use super::shard::write_shard;
use coface_algebra::Error;
use coface_algebra::chains::{ChainComplex, Part};
use coface_algebra::progress;
use coface_algebra::{RaggedArray, SparseMatrix};
use coface_io::container::array_of_bytes;
use coface_io::{Format, NO_VERTEX, stream_mesh};
use std::collections::BTreeMap;
use std::fs::{self, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};
use xxhash_rust::xxh3::Xxh3;

/// No vertex, no part.
const NONE: u32 = NO_VERTEX;
/// A vertex that several parts have.
const SHARED: u32 = u32::MAX - 1;
/// So many elements are looked at to find planes, at most.
const SAMPLE: usize = 1 << 18;
/// All records that wait to be written take so many bytes, nearly.
const PENDING: usize = 32 << 20;
/// Numbers of a record: four vertices and the part.
const RECORD: usize = 5;

/// Cuts a file of points, segments, triangles and tetrahedra (MEDIT, Gmsh) into shards, as [`shard_model`](super::shard_model) does, without the whole in
/// memory. `None` where the file is of another format, or has other elements, or owners are to be found by a walk or a list: then the model has to be read.
///
/// # Errors
/// Those of the reader and of [`ShardFolder::create`]; [`ErrorKind::Io`](coface_algebra::ErrorKind::Io).
///
/// # Complexity
/// Linear in the file, but for sorting the cells of each part. Memory: 4 bytes a vertex, what parts have in common, and one part. The folder takes about 50 bytes
/// an element while shards are written.
///
/// # Examples
/// ```
/// use coface_scale::shards::{ShardRequest, shard_mesh_file};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let folder = std::env::temp_dir().join("coface-mesh-shards");
/// std::fs::create_dir_all(&folder)?;
/// let file = folder.join("two.mesh");
/// let text = "MeshVersionFormatted 2\nDimension 3\nVertices 5\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n1 1 1 0\n";
/// std::fs::write(&file, format!("{text}Tetrahedra 2\n1 2 3 4 0\n2 3 4 5 0\nEnd\n"))?;
/// let shards = shard_mesh_file(&file, None, &folder, &ShardRequest::new("two", 2))?.expect("these are simplices");
/// (0..2).try_for_each(|number| shards.reduce(number, false).map(|_| ()))?;
/// assert_eq!(shards.merge_all(false)?.cells(), [5, 9, 7, 2]);
/// # std::fs::remove_dir_all(&folder)?;
/// # Ok(()) }
/// ```
pub fn shard_mesh_file(
    file: &Path,
    format: Option<Format>,
    folder: &Path,
    request: &ShardRequest,
) -> Result<Option<ShardFolder>, Error> {
    if matches!(request.owners, Owners::Walk | Owners::Listed(_)) {
        return Ok(None);
    }
    let scratch = Scratch::new(folder)?;
    let [vertices, elements] = [scratch.stream()?, scratch.stream()?];
    if !stream_mesh(file, format, [Box::new(vertices.clone()), Box::new(elements.clone())])? {
        return Ok(None);
    }
    let (vertices, elements) = (vertices.into_map()?, elements.into_map()?);
    let (vertices, elements) = (array_of_bytes::<f64>(&vertices), array_of_bytes::<u32>(&elements));
    let element_count = elements.len() / 4;
    // A tetrahedron has about as many cells and incidences as this, those that others share counted for each of them in part.
    let part_count = request.part_count_for(17 * element_count as u64);
    let mesh = Mesh {
        vertices: &vertices,
        elements: &elements,
        part_count,
        is_random: request.owners == Owners::Random,
    };
    let planes = mesh.planes();
    let sharing = mesh.sharing(&planes);
    let complex = mesh.number(request.fan_in);
    let manifest = ShardManifest::new(complex, part_count, request.fan_in, request.source.clone());
    let shards = ShardFolder::create(folder, manifest, request.replaces)?;
    let shards = shards.finished(|shards| {
        let mut records = Records::new(scratch.path(), part_count);
        let dimension = mesh.distribute(&planes, &sharing, &mut records)?;
        records.flush()?;
        // Ids: where a stratum begins, then the rank within it.
        let mut strata: BTreeMap<Vec<u32>, Vec<u64>> = BTreeMap::new();
        let steps = progress::stage("finding strata", part_count as usize);
        for number in 0..part_count {
            let cells = LocalCells::new(number, dimension, &records.read(number)?);
            for (key, counts) in cells.strata().filter(|(key, _)| key[0] == number) {
                strata.insert(key.to_vec(), counts);
            }
            steps.advance(1);
        }
        drop(steps);
        let mut next = vec![0u64; dimension + 1];
        for counts in strata.values_mut() {
            counts
                .iter_mut()
                .zip(&mut next)
                .for_each(|(count, next)| *next += std::mem::replace(count, *next));
        }
        let steps = progress::stage("writing shards", part_count as usize);
        for number in 0..part_count {
            let cells = LocalCells::new(number, dimension, &records.read(number)?);
            let (part, names) = cells.into_part(&strata)?;
            let place = shards.place(0, number);
            shards.write_shard(number, |out| write_shard(place, &part, Some(&names), out).map(|_| ()))?;
            steps.advance(1);
        }
        // Before the list of shards, so that whole folders have nothing else in them.
        drop(scratch);
        Ok(())
    })?;
    Ok(Some(shards))
}

/// What was read.
struct Mesh<'a> {
    /// Three coordinates each.
    vertices: &'a [f64],
    /// Four vertices each, `NONE` where there are fewer.
    elements: &'a [u32],
    part_count: u32,
    is_random: bool,
}

/// A plane across an axis: what is below it goes to the first child.
#[derive(Clone, Copy)]
enum Plane {
    Split { axis: usize, at: f64, children: [u32; 2] },
    Part(u32),
}

/// The parts that have each vertex.
struct Sharing {
    /// The one part, `SHARED` or `NONE`.
    of_vertex: Vec<u32>,
    /// Pairs of a shared vertex and a part that has it, sorted.
    shared: Vec<(u32, u32)>,
}

impl Sharing {
    fn parts(&self, vertex: u32) -> impl Iterator<Item = u32> + '_ {
        let only = self.of_vertex[vertex as usize];
        let start = if only == SHARED {
            self.shared.partition_point(|pair| pair.0 < vertex)
        } else {
            self.shared.len()
        };
        let several = self.shared[start..].iter().take_while(move |pair| pair.0 == vertex).map(|pair| pair.1);
        Some(only).filter(|&part| part < SHARED).into_iter().chain(several)
    }
}

fn corners(element: &[u32]) -> &[u32] {
    &element[..element.iter().position(|&vertex| vertex == NONE).unwrap_or(element.len())]
}

impl Mesh<'_> {
    fn point(&self, vertex: u32) -> [f64; 3] {
        let at = 3 * vertex as usize;
        [self.vertices[at], self.vertices[at + 1], self.vertices[at + 2]]
    }

    fn centroid(&self, vertices: &[u32]) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for &vertex in vertices {
            sum.iter_mut().zip(self.point(vertex)).for_each(|(sum, x)| *sum += x / vertices.len() as f64);
        }
        sum
    }

    /// A number that this mesh has, cut in this way.
    fn number(&self, fan_in: u32) -> u64 {
        let mut hash = Xxh3::new();
        for number in [self.part_count, fan_in, u32::from(self.is_random)] {
            hash.update(&number.to_le_bytes());
        }
        self.elements.iter().for_each(|vertex| hash.update(&vertex.to_le_bytes()));
        self.vertices.iter().for_each(|x| hash.update(&x.to_bits().to_le_bytes()));
        hash.digest()
    }

    /// Planes that halve a sample over and over. Points at one place are not parted.
    fn planes(&self) -> Vec<Plane> {
        let step = (self.elements.len() / 4).div_ceil(SAMPLE).max(1);
        let mut sample: Vec<[f64; 3]> = self
            .elements
            .chunks_exact(4)
            .step_by(step)
            .map(|element| self.centroid(corners(element)))
            .collect();
        let mut planes = vec![Plane::Part(0)];
        let mut pending = vec![(0usize, &mut sample[..], 0u32, self.part_count)];
        while let Some((plane, group, first, count)) = pending.pop() {
            if count == 1 || group.is_empty() {
                planes[plane] = Plane::Part(first);
                continue;
            }
            let extent = |axis: usize| {
                let values = group.iter().map(|point| point[axis]);
                values.clone().fold(f64::NEG_INFINITY, f64::max) - values.fold(f64::INFINITY, f64::min)
            };
            let extents = [extent(0), extent(1), extent(2)];
            let axis = (0..3).rev().max_by(|&a, &b| extents[a].total_cmp(&extents[b])).unwrap_or(0);
            let lower = count / 2;
            let at = (group.len() as u64 * u64::from(lower) / u64::from(count)) as usize;
            let order = |a: &[f64; 3], b: &[f64; 3]| a[axis].total_cmp(&b[axis]);
            let (_, middle, _) = group.select_nth_unstable_by(at, order);
            let value = middle[axis];
            let children = [planes.len() as u32, planes.len() as u32 + 1];
            planes[plane] = Plane::Split { axis, at: value, children };
            planes.extend([Plane::Part(first), Plane::Part(first + lower)]);
            let (below, above) = group.split_at_mut(at);
            pending.push((children[0] as usize, below, first, lower));
            pending.push((children[1] as usize, above, first + lower, count - lower));
        }
        planes
    }

    fn owner(&self, planes: &[Plane], position: usize, vertices: &[u32]) -> u32 {
        if self.is_random {
            return scattered((position as u64 >> 32) as usize, position as u32, self.part_count);
        }
        let point = self.centroid(vertices);
        let mut at = 0;
        loop {
            match planes[at] {
                Plane::Part(part) => return part,
                Plane::Split { axis, at: value, children } => {
                    at = children[usize::from(point[axis] >= value)] as usize;
                }
            }
        }
    }

    fn each_element(&self, mut visit: impl FnMut(usize, &[u32]) -> Result<(), Error>) -> Result<(), Error> {
        let steps = progress::stage("cutting into parts", self.elements.len() / 4);
        for (position, element) in self.elements.chunks_exact(4).enumerate() {
            visit(position, corners(element))?;
            if position % 4096 == 4095 {
                steps.advance(4096);
            }
        }
        Ok(())
    }

    fn sharing(&self, planes: &[Plane]) -> Sharing {
        let mut of_vertex = vec![NONE; self.vertices.len() / 3];
        let mut shared: Vec<(u32, u32)> = Vec::new();
        let mut sorted = 0;
        let visit = |position: usize, vertices: &[u32]| {
            let owner = self.owner(planes, position, vertices);
            for &vertex in vertices {
                let known = &mut of_vertex[vertex as usize];
                match *known {
                    NONE => *known = owner,
                    SHARED => shared.push((vertex, owner)),
                    part if part == owner => {}
                    part => {
                        shared.extend([(vertex, part), (vertex, owner)]);
                        *known = SHARED;
                    }
                }
            }
            // What stands there several times goes before it takes much room.
            if shared.len() > 2 * sorted + (1 << 20) {
                shared.sort_unstable();
                shared.dedup();
                sorted = shared.len();
            }
            Ok(())
        };
        self.each_element(visit).expect("nothing is read or written");
        shared.sort_unstable();
        shared.dedup();
        for (vertex, part) in (0..).zip(&mut of_vertex).filter(|(_, part)| **part == NONE) {
            // A vertex by itself; elements have other numbers.
            *part = self.owner(planes, self.elements.len() / 4 + vertex as usize, &[vertex]);
        }
        Sharing { of_vertex, shared }
    }

    /// Hands each element to the parts that touch it, and each vertex that no element has to its own. Gives the dimension.
    fn distribute(
        &self,
        planes: &[Plane],
        sharing: &Sharing,
        records: &mut Records<'_>,
    ) -> Result<usize, Error> {
        let mut dimension = 0;
        let mut has_element = vec![0u64; (self.vertices.len() / 3).div_ceil(64)];
        let mut parts = Vec::new();
        self.each_element(|position, vertices| {
            let owner = self.owner(planes, position, vertices);
            dimension = dimension.max(vertices.len() - 1);
            parts.clear();
            for &vertex in vertices {
                has_element[vertex as usize / 64] |= 1 << (vertex % 64);
                parts.extend(sharing.parts(vertex));
            }
            parts.sort_unstable();
            parts.dedup();
            parts.iter().try_for_each(|&part| records.push(part, vertices, owner))
        })?;
        for (vertex, &part) in (0..).zip(&sharing.of_vertex) {
            if has_element[vertex as usize / 64] >> (vertex % 64) & 1 == 0 {
                records.push(part, &[vertex], part)?;
            }
        }
        Ok(dimension)
    }
}

/// The elements of each part and those that touch it, in a file for each.
struct Records<'a> {
    folder: &'a Path,
    pending: Vec<Vec<u8>>,
    most: usize,
}

impl<'a> Records<'a> {
    fn new(folder: &'a Path, part_count: u32) -> Self {
        let most = (PENDING / part_count as usize).clamp(1 << 10, 1 << 18);
        Self { folder, pending: vec![Vec::new(); part_count as usize], most }
    }

    fn path(&self, part: usize) -> PathBuf {
        self.folder.join(format!("part-{part}"))
    }

    fn push(&mut self, part: u32, vertices: &[u32], owner: u32) -> Result<(), Error> {
        let pending = &mut self.pending[part as usize];
        for place in 0..4 {
            pending.extend(vertices.get(place).copied().unwrap_or(NONE).to_le_bytes());
        }
        pending.extend(owner.to_le_bytes());
        if pending.len() >= self.most { self.write(part as usize) } else { Ok(()) }
    }

    fn write(&mut self, part: usize) -> Result<(), Error> {
        let mut file = OpenOptions::new().append(true).create(true).open(self.path(part))?;
        file.write_all(&self.pending[part])?;
        self.pending[part].clear();
        Ok(())
    }

    fn flush(&mut self) -> Result<(), Error> {
        (0..self.pending.len()).try_for_each(|part| self.write(part))?;
        self.pending = Vec::new();
        Ok(())
    }

    fn read(&self, part: u32) -> Result<Vec<u32>, Error> {
        Ok(array_of_bytes::<u32>(&fs::read(self.path(part as usize))?).into_owned())
    }
}

/// The cells of one part: simplices by their vertices, rising.
struct LocalCells {
    number: u32,
    /// For each dimension the simplices, in lexicographic order; behind their vertices `NONE`.
    cells: Vec<Vec<[u32; 4]>>,
    /// For each dimension the number of the key of each.
    keys: Vec<Vec<u32>>,
    sets: Vec<Vec<u32>>,
}

/// The faces of a simplex with rising vertices, itself among them.
fn for_each_face(vertices: &[u32], mut visit: impl FnMut(usize, [u32; 4])) {
    for subset in 1u32..1 << vertices.len() {
        let (mut face, mut count) = ([NONE; 4], 0);
        for (i, &vertex) in vertices.iter().enumerate() {
            if subset >> i & 1 == 1 {
                face[count] = vertex;
                count += 1;
            }
        }
        visit(count - 1, face);
    }
}

impl LocalCells {
    fn new(number: u32, dimension: usize, records: &[u32]) -> Self {
        let sorted = |record: &[u32]| {
            let mut vertices = [record[0], record[1], record[2], record[3]];
            vertices.sort_unstable();
            vertices
        };
        let mut cells: Vec<Vec<[u32; 4]>> = vec![Vec::new(); dimension + 1];
        for record in records.chunks_exact(RECORD).filter(|record| record[4] == number) {
            for_each_face(corners(&sorted(record)), |degree, face| cells[degree].push(face));
        }
        for cells in &mut cells {
            cells.sort_unstable();
            cells.dedup();
        }
        // All cells are of this part; those that elements of others have are of those too.
        let mut others: Vec<Vec<(u32, u32)>> = vec![Vec::new(); dimension + 1];
        for record in records.chunks_exact(RECORD).filter(|record| record[4] != number) {
            for_each_face(corners(&sorted(record)), |degree, face| {
                if let Ok(cell) = cells[degree].binary_search(&face) {
                    others[degree].push((cell as u32, record[4]));
                }
            });
        }
        let mut sets = vec![vec![number]];
        let mut number_of = BTreeMap::from([(vec![number], 0u32)]);
        let keys = cells.iter().zip(&mut others).map(|(cells, others)| {
            others.sort_unstable();
            others.dedup();
            let mut keys = vec![0; cells.len()];
            for group in others.chunk_by(|a, b| a.0 == b.0) {
                let mut set: Vec<u32> = group.iter().map(|&(_, part)| part).collect();
                let at = set.partition_point(|&part| part < number);
                set.insert(at, number);
                keys[group[0].0 as usize] = *number_of.entry(set).or_insert_with_key(|set| {
                    sets.push(set.clone());
                    sets.len() as u32 - 1
                });
            }
            keys
        });
        let keys = keys.collect();
        Self { number, cells, keys, sets }
    }

    /// The strata with the numbers of their cells in each dimension.
    fn strata(&self) -> impl Iterator<Item = (&[u32], Vec<u64>)> {
        let mut counts = vec![vec![0u64; self.cells.len()]; self.sets.len()];
        for (degree, keys) in self.keys.iter().enumerate() {
            keys.iter().for_each(|&key| counts[key as usize][degree] += 1);
        }
        let occurs = |(_, counts): &(&[u32], Vec<u64>)| counts.iter().any(|&count| count > 0);
        self.sets.iter().map(Vec::as_slice).zip(counts).filter(occurs)
    }

    /// The part, its cells in the order of their ids, and their names.
    fn into_part(self, strata: &BTreeMap<Vec<u32>, Vec<u64>>) -> Result<(Part, Vec<RaggedArray>), Error> {
        let starts: Vec<Option<&Vec<u64>>> = self.sets.iter().map(|set| strata.get(set)).collect();
        let mut ids = Vec::with_capacity(self.cells.len());
        let mut keys = Vec::with_capacity(self.cells.len());
        let mut names = Vec::with_capacity(self.cells.len());
        let mut matrices = Vec::new();
        // Where each simplex of the degree below is in the order of ids.
        let mut place_below: Vec<u32> = Vec::new();
        for (degree, (cells, own_keys)) in self.cells.iter().zip(&self.keys).enumerate() {
            let mut ranks = vec![0u64; self.sets.len()];
            let id_of = own_keys.iter().map(|&key| {
                let rank = &mut ranks[key as usize];
                let start =
                    starts[key as usize].expect("the first part of a key has named its stratum")[degree];
                *rank += 1;
                start + *rank - 1
            });
            let mut order: Vec<(u64, u32)> = id_of.zip(0..).collect();
            order.sort_unstable();
            let mut place = vec![0; cells.len()];
            (0..).zip(&order).for_each(|(at, &(_, cell))| place[cell as usize] = at);
            if degree > 0 {
                let below = &self.cells[degree - 1];
                let mut rows = Vec::with_capacity(cells.len() * (degree + 1));
                let mut entries = Vec::with_capacity(rows.capacity());
                let mut faces = [(0u32, 0i32); 4];
                for &(_, cell) in &order {
                    for (i, slot) in faces[..=degree].iter_mut().enumerate() {
                        let mut face = cells[cell as usize];
                        face.copy_within(i + 1.., i);
                        face[3] = NONE;
                        let row = below.binary_search(&face).expect("the cells of a part are closed");
                        *slot = (place_below[row], if i % 2 == 0 { 1 } else { -1 });
                    }
                    faces[..=degree].sort_unstable();
                    rows.extend(faces[..=degree].iter().map(|face| face.0));
                    entries.extend(faces[..=degree].iter().map(|face| face.1));
                }
                let starts = (0..=cells.len()).map(|i| (i * (degree + 1)) as u32).collect();
                matrices.push(SparseMatrix::from_parts(below.len(), starts, rows, entries)?);
            }
            let items = order.iter().flat_map(|&(_, cell)| cells[cell as usize][..=degree].iter().copied());
            names.push(RaggedArray::uniform(degree + 1, items.collect())?);
            ids.push(order.iter().map(|&(id, _)| id).collect());
            keys.push(order.iter().map(|&(_, cell)| own_keys[cell as usize]).collect());
            place_below = place;
        }
        let complex = match matrices.is_empty() {
            true => ChainComplex::of_points(self.cells[0].len()),
            false => ChainComplex::new(matrices)?,
        };
        if complex.degree_count() == 0 {
            (ids, keys, names) = (Vec::new(), Vec::new(), Vec::new());
        }
        let sets = RaggedArray::from_lists(&self.sets);
        Ok((Part::new(self.number, complex, ids, &sets, keys)?, names))
    }
}
