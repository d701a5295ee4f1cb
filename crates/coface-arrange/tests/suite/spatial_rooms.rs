//! Buildings of boxes whose rooms are known: within a tolerance, rounded, and through exact polygons.

use coface_algebra::{FaceId, RaggedArray, Sign};
use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
use coface_geometry::Positions;
use std::sync::Arc;

const SQUARES: [[u32; 4]; 6] =
    [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];

/// Numbers from 0 to 1 by a seed.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// A building of rooms in a grid: walls that go through along x, walls between them, and slabs.
struct Building {
    rooms: [usize; 3],
    thickness: f64,
    angle: f64,
    shift: [f64; 3],
    noise: f64,
    is_triangulated: bool,
}

const LENGTH: f64 = 4.0;
const HEIGHT: f64 = 2.5;

impl Building {
    fn random(random: &mut Random) -> Self {
        let mut count = |most: f64| 1 + (random.next() * most) as usize;
        let rooms = [count(2.0), count(2.0), count(1.5)];
        let thickness = 0.1 + 0.2 * random.next();
        let angle = if random.next() < 0.2 { 0.0 } else { 6.0 * random.next() };
        let shift = if random.next() < 0.3 { [500_000.123, 5_400_000.77, 312.5] } else { [32.7, -11.1, 3.0] };
        Self { rooms, thickness, angle, shift, noise: 0.0, is_triangulated: random.next() < 0.5 }
    }

    fn boxes(&self) -> Vec<[[f64; 3]; 2]> {
        let ([nx, ny, floors], t) = (self.rooms, self.thickness);
        let (width, depth) = (nx as f64 * (LENGTH + t) + t, ny as f64 * (LENGTH + t) + t);
        let mut boxes = Vec::new();
        for floor in 0..=floors {
            let z = floor as f64 * (HEIGHT + t);
            boxes.push([[0.0, 0.0, z - t], [width, depth, z]]);
            if floor == floors {
                break;
            }
            for j in 0..=ny {
                let y = j as f64 * (LENGTH + t);
                boxes.push([[0.0, y, z], [width, y + t, z + HEIGHT]]);
            }
            for i in 0..=nx {
                let x = i as f64 * (LENGTH + t);
                for j in 0..ny {
                    let y = j as f64 * (LENGTH + t);
                    boxes.push([[x, y + t, z], [x + t, y + t + LENGTH, z + HEIGHT]]);
                }
            }
        }
        boxes
    }

    fn polygons(&self, random: &mut Random) -> SpatialPolygons {
        let (mut flat, mut lists, mut inputs) = (Vec::new(), Vec::new(), Vec::new());
        let (sin, cos) = self.angle.sin_cos();
        for (input, corners) in (0..).zip(self.boxes()) {
            let first = (flat.len() / 3) as u32;
            for corner in 0..8usize {
                let [x, y, z] = [0, 1, 2].map(|axis| corners[corner >> axis & 1][axis]);
                let point = [cos * x - sin * y, sin * x + cos * y, z];
                let mut noise = || self.noise * (2.0 * random.next() - 1.0);
                flat.extend([0, 1, 2].map(|axis| point[axis] + self.shift[axis] + noise()));
            }
            for square in SQUARES {
                let [a, b, c, d] = square.map(|corner| first + corner);
                match self.is_triangulated {
                    true => lists.extend([vec![a, b, c], vec![a, c, d]]),
                    false => lists.push(vec![a, b, c, d]),
                }
            }
            inputs.resize(lists.len(), input);
        }
        let positions = Positions::from_flat(3, flat).expect("three coordinates a corner");
        let polygons = SpatialPolygons::from_polygons(positions, RaggedArray::from_lists(lists));
        polygons.and_then(|polygons| polygons.with_inputs(inputs)).expect("boxes are polygons")
    }

    /// The volumes of boxes and rooms, rising.
    fn volumes(&self) -> Vec<f64> {
        let boxes = self.boxes().into_iter();
        let of_box = |[low, high]: [[f64; 3]; 2]| (0..3).map(|axis| high[axis] - low[axis]).product::<f64>();
        let mut volumes: Vec<f64> = boxes.map(of_box).collect();
        let rooms = self.rooms.iter().product();
        volumes.extend(std::iter::repeat_n(LENGTH * LENGTH * HEIGHT, rooms));
        volumes.sort_by(f64::total_cmp);
        volumes
    }
}

/// The rooms, walls and slabs of buildings at any angle, with tolerances up to a tenth of the thickness of walls: as many cells
/// as there are, with their volumes, and no point further than twice the tolerance.
#[test]
fn rooms_are_rooms_within_any_tolerance() {
    let mut random = Random(24);
    for number in 0..40 {
        let mut building = Building::random(&mut random);
        let tolerance = building.thickness / 10.0 * 10f64.powf(-5.0 * random.next());
        building.noise = tolerance * [0.0, 0.01, 0.1, 0.2][number & 3];
        let polygons = building.polygons(&mut random);
        let options = SpatialOptions::new().tolerance(tolerance).merge_coplanar(random.next() < 0.3);
        let found = SpatialArrangement::new(&polygons, &options).unwrap();
        let name = format!("building {number}, {tolerance:e}, noise {:e}", building.noise);
        let mut volumes = found.volumes().unwrap();
        volumes.sort_by(f64::total_cmp);
        let truth = building.volumes();
        assert_eq!(volumes.len(), truth.len(), "{name}");
        for (own, truth) in volumes.iter().zip(truth) {
            // The faces of a cell have an area of at most about 200.
            assert!((own - truth).abs() <= 400.0 * tolerance + 1e-6, "{name}: {own} {truth}");
        }
        let joined = found.joined().unwrap();
        assert_eq!(joined.unsettled, 0, "{name}");
        assert!(joined.tolerance <= tolerance.max(1e-8), "{name}: {}", joined.tolerance);
        assert!(joined.largest_movement <= 2.0 * joined.tolerance, "{name}: {}", joined.largest_movement);
        assert!(found.is_exactly_rounded(), "{name}");
    }
}

/// Rounding closes rooms that are open by the last digit, but opens none.
#[test]
fn rounding_opens_no_room() {
    let mut random = Random(5);
    let large = |arrangement: &SpatialArrangement| -> Vec<f64> {
        arrangement.volumes().unwrap().into_iter().filter(|&volume| volume > 1e-3).collect()
    };
    for number in 0..12 {
        let building = Building::random(&mut random);
        let polygons = building.polygons(&mut random);
        let options = SpatialOptions::new();
        let exact = SpatialArrangement::new(&polygons, &options).unwrap();
        let Ok(snapped) = exact.snapped(&options) else { continue };
        let mut before = large(&exact);
        for volume in large(&snapped) {
            if let Some(at) = before.iter().position(|&own| (own - volume).abs() < 1e-4) {
                before.remove(at);
            }
        }
        assert!(before.is_empty(), "building {number}: {before:?} are gone");
        assert_eq!(snapped.crossings_of_rounded(1).unwrap().count, 0);
    }
}

/// The outer surface of a building, cut out of the polygons that all cells have as exact polygons.
#[test]
fn exact_polygons_do_without_what_is_not_wanted() {
    let mut random = Random(7);
    for number in 0..16 {
        let mut building = Building::random(&mut random);
        building.shift = [0.0; 3];
        if number & 1 == 0 {
            building.angle = 0.0;
        }
        let polygons = building.polygons(&mut random);
        let arrangement = SpatialArrangement::new(&polygons, &SpatialOptions::new()).unwrap();
        let (mut surface, mut others) = (Vec::new(), Vec::new());
        for face in (0..arrangement.complex().face_count()).map(FaceId::new) {
            let [back, front] = [Sign::Plus, Sign::Minus].map(|side| arrangement.cell_at(face, side));
            match (back, front) {
                (Some(_), None) => surface.push((face, Sign::Plus)),
                (None, Some(_)) => surface.push((face, Sign::Minus)),
                (Some(_), Some(_)) => others.push(face),
                (None, None) => {}
            }
        }
        let all = arrangement.exact_polygons(&surface, &others);
        let total: f64 = arrangement.volumes().unwrap().iter().sum();
        for keeps_shared in [true, false] {
            let wanted: Vec<bool> =
                all.shared().iter().map(|&is_shared| keeps_shared || !is_shared).collect();
            let own = all.with(&wanted);
            // Points and polygons are there to be numbered.
            let count = own.shared().len();
            let none = SpatialPolygons::new(
                Positions::from_flat(3, vec![0.0; 3]).unwrap(),
                RaggedArray::from_lists(std::iter::repeat_n([0, 0, 0], count)),
                (0..count as u32).collect(),
            );
            let again = none.unwrap().with_exact(0, Arc::new(own)).unwrap();
            let found = SpatialArrangement::new(&again, &SpatialOptions::new())
                .unwrap_or_else(|error| panic!("building {number}, {keeps_shared}: {error}"));
            let sum: f64 = found.volumes().unwrap().iter().sum();
            assert!((sum - total).abs() < 1e-9 * total, "building {number}, {keeps_shared}: {sum} {total}");
            if keeps_shared {
                assert_eq!(found.f_vector()[3], arrangement.f_vector()[3], "building {number}");
            }
        }
    }
}

/// A floor and a wall of a real building, 3e-15 apart: diagonals of their sides cross a tolerance apart.
#[test]
fn diagonals_that_cross_near_a_corner_stay_within_the_tolerance() {
    let points = [
        [6.294, -6.79, 3.100000000000378],
        [6.294, -6.79, 3.113000000000378],
        [6.294, -10.95000000000001, 3.113000000000378],
        [6.294, -10.95000000000001, 3.100000000000378],
        [4.769999999999986, -10.95000000000001, 3.113000000000378],
        [4.769999999999986, -10.95000000000001, 3.100000000000378],
        [4.769999999999986, -6.79, 3.113000000000378],
        [4.769999999999986, -6.79, 3.100000000000378],
        [4.769999999999989, -10.95000000000001, 5.69500000000039],
        [4.769999999999989, -10.95000000000001, 3.100000000000378],
        [4.769999999999989, -6.790000000000003, 3.100000000000378],
        [4.769999999999989, -6.790000000000003, 5.69500000000039],
        [4.61799999999999, -6.790000000000003, 3.100000000000378],
        [4.61799999999999, -6.790000000000003, 5.69500000000039],
        [4.61799999999999, -10.95000000000001, 3.100000000000378],
        [4.61799999999999, -10.95000000000001, 5.69500000000039],
    ];
    let triangles = [
        [0, 1, 2],
        [3, 0, 2],
        [3, 2, 4],
        [5, 3, 4],
        [5, 4, 6],
        [7, 5, 6],
        [7, 6, 1],
        [0, 7, 1],
        [2, 1, 6],
        [4, 2, 6],
        [7, 0, 3],
        [7, 3, 5],
        [8, 9, 10],
        [11, 8, 10],
        [11, 10, 12],
        [13, 11, 12],
        [13, 12, 14],
        [15, 13, 14],
        [15, 14, 9],
        [8, 15, 9],
        [12, 10, 9],
        [14, 12, 9],
        [8, 11, 13],
        [8, 13, 15],
    ];
    let positions = Positions::from_flat(3, points.as_flattened().to_vec()).unwrap();
    let inputs = (0..24).map(|triangle| triangle / 12).collect();
    let polygons = SpatialPolygons::from_polygons(positions, RaggedArray::from_lists(triangles))
        .unwrap()
        .with_inputs(inputs)
        .unwrap();
    for merge in [false, true] {
        let options = SpatialOptions::new().tolerance(1e-4).merge_coplanar(merge);
        let found = SpatialArrangement::new(&polygons, &options).unwrap();
        assert_eq!(found.f_vector()[3], 2);
        let joined = found.joined().unwrap();
        assert_eq!((joined.tolerance, joined.unsettled), (1e-4, 0));
        assert!(joined.largest_movement < 1e-14);
    }
}

/// Diagonals of walls are no features: triangles of single precision give the rooms that polygons give, as tolerances grow.
#[test]
fn triangles_of_walls_are_walls() {
    let mut random = Random(42);
    for number in 0..12 {
        let mut building = Building::random(&mut random);
        building.shift = [32.7, -11.1, 3.0];
        building.is_triangulated = true;
        let polygons = building.polygons(&mut random);
        let points = polygons.positions().as_flat().as_chunks::<3>().0.iter();
        let points: Vec<[f64; 3]> = points.map(|point| point.map(|x| f64::from(x as f32))).collect();
        let flat = Positions::from_flat(3, points.into_flattened()).unwrap();
        let walks = polygons.walks().clone();
        let inputs = polygons.input_of_polygon().to_vec();
        let polygons = SpatialPolygons::from_polygons(flat, walks).unwrap().with_inputs(inputs).unwrap();
        for tolerance in [1e-4, 1e-3, 1e-2] {
            let options = SpatialOptions::new().tolerance(tolerance);
            let found = SpatialArrangement::new(&polygons, &options).unwrap();
            let mut volumes = found.volumes().unwrap();
            volumes.sort_by(f64::total_cmp);
            let truth = building.volumes();
            assert_eq!(volumes.len(), truth.len(), "building {number}");
            for (own, truth) in volumes.iter().zip(truth) {
                assert!((own - truth).abs() < 2e-3, "building {number}, {tolerance}: {own} {truth}");
            }
        }
    }
}
