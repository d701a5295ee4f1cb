//! Conforming faces to make cells of.
#![allow(dead_code, reason = "each test takes what it needs")]
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_algebra::RaggedArray;
use coface_arrange::spatial::{PolygonalComplex, SpatialCells};
use coface_geometry::Positions;
use std::collections::{BTreeMap, BTreeSet};

/// Faces with vertices that are shared by their coordinates; a face that is there already is not added again.
#[derive(Clone, Default)]
pub(crate) struct Faces {
    vertices: BTreeMap<[u64; 3], u32>,
    flat: Vec<f64>,
    walks: Vec<Vec<u32>>,
    face_of_walk: Vec<u32>,
    known: BTreeSet<Vec<Vec<u32>>>,
}

impl Faces {
    pub(crate) fn vertex(&mut self, point: [f64; 3]) -> u32 {
        // Both zeros are one.
        let point = point.map(|x| x + 0.0);
        let next = self.vertices.len() as u32;
        *self.vertices.entry(point.map(f64::to_bits)).or_insert_with(|| {
            self.flat.extend(point);
            next
        })
    }

    pub(crate) fn face_count(&self) -> usize {
        self.known.len()
    }

    /// Adds a face with these walks around it.
    pub(crate) fn add(&mut self, walks: &[&[[f64; 3]]]) {
        let walks: Vec<Vec<u32>> =
            walks.iter().map(|walk| walk.iter().map(|&point| self.vertex(point)).collect()).collect();
        let mut key = walks.clone();
        key.iter_mut().for_each(|walk| walk.sort_unstable());
        key.sort_unstable();
        let face = self.known.len() as u32;
        if self.known.insert(key) {
            self.face_of_walk.extend(walks.iter().map(|_| face));
            self.walks.extend(walks);
        }
    }

    /// Adds the six sides of a box, fronts outward.
    pub(crate) fn add_box(&mut self, low: [f64; 3], high: [f64; 3]) {
        for axis in 0..3 {
            let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
            for (x, turned) in [(low[axis], true), (high[axis], false)] {
                let mut square = [[low[i], low[j]], [high[i], low[j]], [high[i], high[j]], [low[i], high[j]]]
                    .map(|[u, v]| {
                        let mut point = [x; 3];
                        (point[i], point[j]) = (u, v);
                        point
                    });
                if turned {
                    square.reverse();
                }
                self.add(&[&square]);
            }
        }
    }

    pub(crate) fn add_cube(&mut self, low: [f64; 3], side: f64) {
        self.add_box(low, low.map(|x| x + side));
    }

    pub(crate) fn add_tetrahedron(&mut self, [a, b, c, d]: [[f64; 3]; 4]) {
        for triangle in [[a, b, c], [a, b, d], [b, c, d], [c, a, d]] {
            self.add(&[&triangle]);
        }
    }

    /// Adds the unit squares around a union of unit cubes at integer places.
    pub(crate) fn add_cubes(&mut self, cubes: &[[i32; 3]]) {
        let cubes: BTreeSet<[i32; 3]> = cubes.iter().copied().collect();
        for &cube in &cubes {
            for axis in 0..3 {
                for step in [0, 1] {
                    let mut beyond = cube;
                    beyond[axis] += 2 * step - 1;
                    if cubes.contains(&beyond) {
                        continue;
                    }
                    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
                    let square = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[u, v]| {
                        let mut point = cube;
                        (point[axis], point[i], point[j]) = (cube[axis] + step, cube[i] + u, cube[j] + v);
                        point.map(f64::from)
                    });
                    self.add(&[&square]);
                }
            }
        }
    }

    /// The same faces with vertices moved.
    pub(crate) fn moved(&self, motion: impl Fn([f64; 3]) -> [f64; 3]) -> Self {
        let mut moved = Self::default();
        let point = |v: u32| motion([0, 1, 2].map(|axis| self.flat[3 * v as usize + axis]));
        for face in 0..self.face_count() as u32 {
            let walks: Vec<Vec<[f64; 3]>> = (0..self.walks.len())
                .filter(|&walk| self.face_of_walk[walk] == face)
                .map(|walk| self.walks[walk].iter().map(|&v| point(v)).collect())
                .collect();
            let walks: Vec<&[[f64; 3]]> = walks.iter().map(Vec::as_slice).collect();
            moved.add(&walks);
        }
        moved
    }

    pub(crate) fn positions(&self) -> Positions {
        Positions::from_flat(3, self.flat.clone()).unwrap()
    }

    pub(crate) fn complex(&self) -> PolygonalComplex {
        let walks = RaggedArray::from_lists(&self.walks);
        PolygonalComplex::from_walks(self.flat.len() / 3, &walks, &self.face_of_walk, &[]).unwrap()
    }

    pub(crate) fn cells(&self) -> SpatialCells {
        SpatialCells::new(self.complex(), &self.positions()).unwrap()
    }
}

/// Two cubes of side 1, the second shifted by one half along all axes, cut against each other.
pub(crate) fn shifted_cubes() -> Faces {
    let mut faces = Faces::default();
    for axis in 0..3 {
        let place = |x: f64, u: f64, v: f64| {
            let mut point = [x; 3];
            (point[(axis + 1) % 3], point[(axis + 2) % 3]) = (u, v);
            point
        };
        let square = |x: f64, low: f64, high: f64| {
            [place(x, low, low), place(x, high, low), place(x, high, high), place(x, low, high)]
        };
        // Of the first cube: far from the second, an angle outside of it, a square inside.
        faces.add(&[&square(0.0, 0.0, 1.0)]);
        let angle =
            [[0., 0.], [1., 0.], [1., 0.5], [0.5, 0.5], [0.5, 1.], [0., 1.]].map(|[u, v]| place(1.0, u, v));
        faces.add(&[&angle]);
        faces.add(&[&square(1.0, 0.5, 1.0)]);
        // Of the second.
        faces.add(&[&square(0.5, 0.5, 1.0)]);
        let angle = [[1., 0.5], [1.5, 0.5], [1.5, 1.5], [0.5, 1.5], [0.5, 1.], [1., 1.]]
            .map(|[u, v]| place(0.5, u, v));
        faces.add(&[&angle]);
        faces.add(&[&square(1.5, 0.5, 1.5)]);
    }
    faces
}

/// A cube of side 1 with a square rod of side one half and length 2 through it along the third axis.
pub(crate) fn rod_through_cube() -> Faces {
    let mut faces = Faces::default();
    let square =
        |low: f64, high: f64, z: f64| [[low, low, z], [high, low, z], [high, high, z], [low, high, z]];
    for z in [0.0, 1.0] {
        let mut hole = square(0.25, 0.75, z);
        hole.reverse();
        faces.add(&[&square(0.0, 1.0, z), &hole]);
    }
    let heights = [-0.5, 0.0, 1.0, 1.5];
    for z in heights {
        faces.add(&[&square(0.25, 0.75, z)]);
    }
    let mut walls = |low: f64, high: f64, from: f64, to: f64| {
        let (bottom, top) = (square(low, high, from), square(low, high, to));
        for i in 0..4 {
            let j = (i + 1) % 4;
            faces.add(&[&[bottom[i], bottom[j], top[j], top[i]]]);
        }
    };
    walls(0.0, 1.0, 0.0, 1.0);
    heights.windows(2).for_each(|pair| walls(0.25, 0.75, pair[0], pair[1]));
    faces
}
