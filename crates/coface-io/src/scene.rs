//! Meshes that are placed in space by transformations: what glTF, 3MF and COLLADA hold.

use crate::assembly::Assembly;
use crate::element_kind::Kind;
use crate::{GroupKind, Model, Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind};
use std::collections::{BTreeMap, HashMap};

/// More meshes than this are not placed: few bytes can place a mesh very often.
const MOST_PLACED: usize = 1 << 16;
/// Beyond so many, what is placed has at most `RATIO` coordinates and corners for each byte of the file.
const FREE: usize = 1 << 22;
const RATIO: usize = 64;
/// Nodes that contain nodes are followed so deep.
const DEEPEST: usize = 64;

/// An affine map: three rows of four numbers, the last of which is the translation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Placement(pub(crate) [[f64; 4]; 3]);

impl Placement {
    pub(crate) const IDENTITY: Self =
        Self([[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]]);

    /// The map of a matrix of four columns, one after the other, as it acts on columns.
    pub(crate) fn from_columns(columns: [[f64; 4]; 4]) -> Self {
        Self(std::array::from_fn(|row| std::array::from_fn(|column| columns[column][row])))
    }

    /// First the inner map, then this one.
    pub(crate) fn after(self, inner: Self) -> Self {
        Self(std::array::from_fn(|row| {
            std::array::from_fn(|column| {
                let sum: f64 = (0..3).map(|k| self.0[row][k] * inner.0[k][column]).sum();
                if column == 3 { sum + self.0[row][3] } else { sum }
            })
        }))
    }

    fn apply(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        if *self == Self::IDENTITY {
            return [x, y, z];
        }
        self.0.map(|[a, b, c, d]| a * x + b * y + c * z + d)
    }

    /// Whether the map turns space inside out.
    fn is_mirror(&self) -> bool {
        let [a, b, c] = self.0;
        a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
            + a[2] * (b[0] * c[1] - b[1] * c[0])
            < 0.0
    }
}

/// A mesh before it is placed.
#[derive(Clone, Debug, Default)]
pub(crate) struct LooseMesh {
    pub(crate) points: Vec<[f64; 3]>,
    pub(crate) polygons: Vec<Vec<u32>>,
    pub(crate) lines: Vec<Vec<u32>>,
    pub(crate) singles: Vec<u32>,
    /// How many points were one with others at the same place.
    pub(crate) welded: usize,
}

impl LooseMesh {
    /// How many coordinates, corners and lists there are: what a copy costs.
    fn number_count(&self) -> usize {
        let lists = self.polygons.iter().chain(&self.lines);
        3 * self.points.len() + self.singles.len() + lists.map(|list| list.len() + 1).sum::<usize>()
    }

    /// The mesh whose points at one place are one: formats that have normals and texture coordinates split them.
    pub(crate) fn welded(mut self) -> Self {
        let mut known: HashMap<[u64; 3], u32> = HashMap::with_capacity(self.points.len());
        let mut points = Vec::with_capacity(self.points.len());
        let new: Vec<u32> = self
            .points
            .iter()
            .map(|point| {
                *known.entry(point.map(|x| (x + 0.0).to_bits())).or_insert_with(|| {
                    points.push(*point);
                    points.len() as u32 - 1
                })
            })
            .collect();
        self.welded += self.points.len() - points.len();
        self.points = points;
        for list in self.polygons.iter_mut().chain(&mut self.lines) {
            list.iter_mut().for_each(|vertex| *vertex = new[*vertex as usize]);
        }
        self.singles.iter_mut().for_each(|vertex| *vertex = new[*vertex as usize]);
        self
    }
}

/// Placed meshes, put together to one.
pub(crate) struct Scene {
    assembly: Assembly,
    placed: usize,
    /// How many coordinates and corners may still be placed.
    left: usize,
    steps: usize,
    welded: usize,
    /// The numbers of the groups by their names.
    groups: BTreeMap<String, i64>,
}

impl Scene {
    /// An empty scene of a file of so many bytes, those of its buffers and those that are unpacked included.
    pub(crate) fn of_size(bytes: usize) -> Self {
        Self {
            assembly: Assembly::new(3),
            placed: 0,
            left: FREE.max(bytes.saturating_mul(RATIO)),
            steps: 0,
            welded: 0,
            groups: BTreeMap::new(),
        }
    }

    /// Takes one step on the way through the nodes of the file: few bytes can make a way without end.
    pub(crate) fn step(&mut self, depth: usize) -> Result<(), Error> {
        self.steps += 1;
        if depth > DEEPEST {
            return Err(Error::invalid("a node contains itself, or nodes are nested too deep")
                .with_cure("export the file again"));
        }
        if self.steps > 16 * MOST_PLACED {
            return Err(Error::new(ErrorKind::TooLarge, "the file places its nodes too often")
                .with_cure("export fewer copies of them"));
        }
        Ok(())
    }

    /// Adds a mesh at its place; its polygons are a group of this name, if it has one.
    pub(crate) fn place(&mut self, mesh: &LooseMesh, placement: Placement, name: &str) -> Result<(), Error> {
        self.placed += 1;
        let first = self.assembly.vertex_count();
        let left = self.left.checked_sub(mesh.number_count());
        let Some(left) = left.filter(|_| self.placed <= MOST_PLACED) else {
            return Err(Error::new(ErrorKind::TooLarge, "the file places its meshes too often")
                .with_cure("export fewer copies of them"));
        };
        self.left = left;
        for &given in &mesh.points {
            let point = placement.apply(given);
            // A point that has no place of its own is kept without one.
            if given.iter().all(|x| x.is_finite()) && point.iter().any(|x| !x.is_finite()) {
                return Err(Error::invalid("a transformation moves a point to where no number is")
                    .with_cure("export the mesh again"));
            }
            self.assembly.add_vertex(&point)?;
        }
        let group = (!name.is_empty()).then(|| {
            let next = self.groups.len() as i64 + 1;
            let group = *self.groups.entry(name.to_owned()).or_insert(next);
            self.assembly.name_group(GroupKind::Polygons, group, name.to_owned());
            group
        });
        let mut moved = Vec::new();
        let number = |vertex: u32| u64::from(vertex.saturating_sub(first as u32));
        let count = mesh.points.len() as u32;
        let in_range = |vertices: &[u32]| match vertices.iter().find(|&&vertex| vertex >= count) {
            Some(vertex) => Err(Error::invalid(format!(
                "a face names vertex {vertex}, but its mesh has {count} vertices, numbered from 0"
            ))
            .with_cure("export the mesh again")),
            None => Ok(()),
        };
        for polygon in &mesh.polygons {
            in_range(polygon)?;
            moved.clear();
            moved.extend(polygon.iter().map(|vertex| first as u32 + vertex));
            if placement.is_mirror() {
                moved.reverse();
            }
            let member = self.assembly.add(Kind::Polygon, moved.len(), &moved, number)?;
            if let (Some(group), Some(member)) = (group, member) {
                self.assembly.add_to_group(GroupKind::Polygons, group, member);
            }
        }
        for line in &mesh.lines {
            in_range(line)?;
            moved.clear();
            moved.extend(line.iter().map(|vertex| first as u32 + vertex));
            self.assembly.add(Kind::Line, moved.len(), &moved, number)?;
        }
        for single in &mesh.singles {
            in_range(&[*single])?;
            self.assembly.add(Kind::Point, 1, &[first as u32 + single], number)?;
        }
        self.welded += mesh.welded;
        Ok(())
    }

    pub(crate) fn finish(mut self) -> Result<Model, Error> {
        self.assembly.has_objects = true;
        if self.welded > 0 {
            let message = format!(
                "{} points at the place of another one of their mesh are one with it, as they are where normals, colors \
                 or textures differ",
                self.welded
            );
            let remark = Remark::new(RemarkCode::InputReading, message);
            self.assembly.remarks.push(remark.at(self.welded, []));
        }
        self.assembly.finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_bytes_cannot_place_much() {
        // Three points, of which many triangles are made: copies are counted by their triangles too.
        let points = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let mesh = LooseMesh { points, polygons: vec![vec![0, 1, 2]; 1000], ..LooseMesh::default() };
        let copies = |bytes: usize| {
            let mut scene = Scene::of_size(bytes);
            (0..).take_while(|_| scene.place(&mesh, Placement::IDENTITY, "").is_ok()).count()
        };
        assert_eq!(copies(50_000), FREE / 4009);
        assert_eq!(copies(300_000), RATIO * 300_000 / 4009);
    }

    #[test]
    fn placements_follow_each_other_and_mirrors_turn_faces() {
        let shift = Placement([[1.0, 0.0, 0.0, 5.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]]);
        let mirror = Placement([[-2.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]]);
        assert_eq!(shift.after(mirror).apply([1.0, 2.0, 3.0]), [3.0, 2.0, 3.0]);
        assert_eq!(mirror.after(shift).apply([1.0, 2.0, 3.0]), [-12.0, 2.0, 3.0]);
        let mesh = LooseMesh {
            points: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-0.0, 0.0, 0.0]],
            polygons: vec![vec![3, 1, 2], vec![0, 3, 1]],
            ..LooseMesh::default()
        };
        let mut scene = Scene::of_size(0);
        scene.place(&mesh.clone().welded(), Placement::IDENTITY, "a").unwrap();
        scene.place(&mesh, mirror, "a").unwrap();
        let model = scene.finish().unwrap();
        assert_eq!(model.vertex_count(), 7);
        assert_eq!(model.polygons().iter().collect::<Vec<_>>(), [&[0, 1, 2][..], &[5, 4, 6], &[4, 6, 3]]);
        assert_eq!(model.groups()[0].members(), [0, 1, 2]);
        assert_eq!(model.remarks().len(), 2);
    }
}
