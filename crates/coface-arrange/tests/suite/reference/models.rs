//! Polygons as the library takes them, and cubes that are turned.

use super::Random;
use super::space::Polygon;
use coface_algebra::RaggedArray;
use coface_geometry::Positions;
use std::f64::consts::PI;

/// Points, walks and the polygon of each walk.
#[derive(Clone, Debug, Default)]
pub(crate) struct Walks {
    pub(crate) flat: Vec<f64>,
    pub(crate) walks: Vec<Vec<u32>>,
    pub(crate) polygon_of_walk: Vec<u32>,
    pub(crate) polygon_count: u32,
}

impl Walks {
    /// Each polygon with its own points.
    pub(crate) fn of(polygons: &[Polygon]) -> Self {
        let mut found = Self::default();
        polygons.iter().for_each(|polygon| found.add_polygon(polygon));
        found
    }

    pub(crate) fn add_polygon(&mut self, polygon: &Polygon) {
        let walks = polygon.walks.iter();
        self.add(walks.map(|walk| walk.iter().map(|corner| corner.map(|x| x as f64)).collect()).collect());
    }

    pub(crate) fn add(&mut self, walks: Vec<Vec<[f64; 3]>>) {
        for walk in walks {
            let first = self.flat.len() as u32 / 3;
            self.flat.extend(walk.iter().flatten());
            self.walks.push((first..first + walk.len() as u32).collect());
            self.polygon_of_walk.push(self.polygon_count);
        }
        self.polygon_count += 1;
    }

    pub(crate) fn positions(&self) -> Positions {
        Positions::from_flat(3, self.flat.clone()).unwrap()
    }

    pub(crate) fn lists(&self) -> RaggedArray {
        RaggedArray::from_lists(&self.walks)
    }

    /// Adds the image of the cube of side 1 at the origin, fronts outward.
    pub(crate) fn add_cube(&mut self, motion: impl Fn([f64; 3]) -> [f64; 3]) {
        for side in super::soups::cuboid([0; 3], [1; 3], 0) {
            self.add(vec![side.walks[0].iter().map(|corner| motion(corner.map(|x| x as f64))).collect()]);
        }
    }
}

/// Turned around an axis by an angle in radians.
pub(crate) fn turned(p: [f64; 3], axis: usize, angle: f64) -> [f64; 3] {
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let (sine, cosine) = angle.sin_cos();
    let mut image = p;
    (image[i], image[j]) = (cosine * p[i] - sine * p[j], sine * p[i] + cosine * p[j]);
    image
}

pub(crate) fn shifted(p: [f64; 3], by: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| p[i] + by[i])
}

/// Where the second of several moved copies is.
pub(crate) fn second_place(p: [f64; 3]) -> [f64; 3] {
    shifted(turned(turned(p, 2, PI / 12.0), 0, PI / 5.0), [0.3, 0.4, 0.25])
}

/// The 36 squares of a grid of two cubes each way, and a moved copy of them.
pub(crate) fn crossing_grids() -> Walks {
    let mut walks = Walks::default();
    for motion in [|p| p, second_place] as [fn([f64; 3]) -> [f64; 3]; 2] {
        for axis in 0..3 {
            for (x, u, v) in (0..12).map(|i| (i / 4, i % 2, i / 2 % 2)) {
                let corner = |[du, dv]: [i32; 2]| {
                    let mut p = [0.0; 3];
                    (p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]) =
                        (f64::from(x), f64::from(u + du), f64::from(v + dv));
                    motion(p)
                };
                walks.add(vec![[[0, 0], [1, 0], [1, 1], [0, 1]].map(corner).to_vec()]);
            }
        }
    }
    walks
}

/// A cube, a moved copy of it, and a copy moved on from there: `count` of them.
pub(crate) fn moved_cubes(count: usize) -> Walks {
    let third = |p| second_place(shifted(turned(turned(p, 1, PI / 12.0), 1, PI / 5.0), [-0.2, 0.4, -0.2]));
    let mut walks = Walks::default();
    walks.add_cube(|p| p);
    if count > 1 {
        walks.add_cube(second_place);
    }
    if count > 2 {
        walks.add_cube(third);
    }
    walks
}

/// Cubes with sides from 0.3 to 1 anywhere in a box, turned in any way.
pub(crate) fn random_cubes(count: usize, seed: u64) -> Walks {
    let mut random = Random::bare(seed);
    let mut walks = Walks::default();
    for _ in 0..count {
        let side = 0.3 + 0.7 * random.unit();
        let by = [0; 3].map(|_| 2.0 * random.unit());
        let angles = [0; 3].map(|_| PI * random.unit());
        walks.add_cube(|p| {
            let p = turned(p.map(|x| side * x), 2, angles[2]);
            shifted(turned(turned(p, 1, angles[1]), 0, angles[0]), by)
        });
    }
    walks
}
