//! Booleans of unions of lattice rectangles against a raster: area, both pairs of Betti numbers, and the unique form.

#![allow(clippy::unwrap_used)]

use coface_arrange::boolean::InsideRule;
use coface_yin::YinSet;

const SIDE: usize = 8;
/// A frame of cells outside goes around.
const WIDTH: usize = SIDE + 2;

/// Cells of the frame and of the square in it; the frame tells what the rest of the plane is.
type Raster = [[bool; WIDTH]; WIDTH];

/// A generator of numbers that is the same everywhere (splitmix64).
struct Random(u64);

impl Random {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % bound as u64) as usize
    }
}

/// A union of rectangles, as a set and as cells.
fn rectangles(count: usize, random: &mut Random) -> (YinSet, Raster) {
    let mut raster = [[false; WIDTH]; WIDTH];
    let mut rings = Vec::new();
    for _ in 0..count {
        let (left, low) = (random.below(SIDE), random.below(SIDE));
        let (right, high) = (left + 1 + random.below(SIDE - left), low + 1 + random.below(SIDE - low));
        let [x0, y0, x1, y1] = [left, low, right, high].map(|at| at as f64);
        rings.push([[x0, y0], [x1, y0], [x1, y1], [x0, y1]]);
        raster[low + 1..=high].iter_mut().for_each(|row| row[left + 1..=right].fill(true));
    }
    (YinSet::from_rings(&rings, InsideRule::Nonzero).unwrap(), raster)
}

fn combined(a: &Raster, b: &Raster, operation: impl Fn(bool, bool) -> bool) -> Raster {
    std::array::from_fn(|y| std::array::from_fn(|x| operation(a[y][x], b[y][x])))
}

/// The number of components of the cells with a value, and whether that of the frame is among them; corners connect or not.
fn components(raster: &Raster, value: bool, with_corners: bool) -> (usize, bool) {
    let mut seen = [[false; WIDTH]; WIDTH];
    let mut count = 0;
    for start in 0..WIDTH * WIDTH {
        let (y, x) = (start / WIDTH, start % WIDTH);
        if seen[y][x] || raster[y][x] != value {
            continue;
        }
        count += 1;
        seen[y][x] = true;
        let mut stack = vec![(y as isize, x as isize)];
        while let Some((y, x)) = stack.pop() {
            for (dy, dx) in [(0, 1), (1, 0), (0, -1), (-1, 0), (1, 1), (1, -1), (-1, 1), (-1, -1)] {
                let (y, x) = (y + dy, x + dx);
                let is_there = (0..WIDTH as isize).contains(&y) && (0..WIDTH as isize).contains(&x);
                if !is_there || (dy * dx != 0 && !with_corners) {
                    continue;
                }
                let cell = &mut seen[y as usize][x as usize];
                if !*cell && raster[y as usize][x as usize] == value {
                    *cell = true;
                    stack.push((y, x));
                }
            }
        }
    }
    (count, raster[0][0] == value)
}

/// The set of the cells, made from their squares; if the frame is in it, from those that are not.
fn of_cells(raster: &Raster) -> YinSet {
    let mut rings = Vec::new();
    for (y, row) in raster.iter().enumerate() {
        for x in (0..WIDTH).filter(|&x| row[x] != raster[0][0]) {
            let [x, y] = [x as f64 - 1.0, y as f64 - 1.0];
            rings.push([[x, y], [x + 1.0, y], [x + 1.0, y + 1.0], [x, y + 1.0]]);
        }
    }
    let set = YinSet::from_rings(&rings, InsideRule::Nonzero).unwrap();
    if raster[0][0] { set.complement().unwrap() } else { set }
}

fn compare(set: &YinSet, raster: &Raster, place: &str) {
    assert_eq!(set.is_bounded(), !raster[0][0], "{place}");
    let cells = raster.iter().flatten().filter(|&&cell| cell != raster[0][0]).count() as f64;
    assert_eq!(set.signed_area(), if raster[0][0] { -cells } else { cells }, "{place}");
    let holes = |with_corners| {
        let (count, is_outside) = components(raster, false, with_corners);
        count - usize::from(is_outside)
    };
    assert_eq!(set.betti_open().unwrap(), [components(raster, true, false).0, holes(true)], "{place}");
    assert_eq!(set.betti_closed().unwrap(), [components(raster, true, true).0, holes(false)], "{place}");
    assert_eq!(set.component_count().unwrap(), components(raster, true, false).0, "{place}");
    assert_eq!(set.straightened().canonical(), of_cells(raster).straightened(), "{place}");
}

#[test]
fn booleans_of_lattice_rectangles_are_those_of_their_cells() {
    let usual = 2000;
    let count = std::env::var("COFACE_SOUPS").ok().and_then(|text| text.parse().ok()).unwrap_or(usual);
    for case in 0..count {
        let mut random = Random(case as u64);
        let size = [3, 6, 12][case % 3];
        let (a, cells_of_a) = rectangles(size, &mut random);
        let (b, cells_of_b) = rectangles(size, &mut random);
        let cells = |operation: fn(bool, bool) -> bool| combined(&cells_of_a, &cells_of_b, operation);
        let place = |name: &str| format!("case {case}: {name}");
        compare(&a.meet(&b).unwrap(), &cells(|a, b| a & b), &place("meet"));
        compare(&a.join(&b).unwrap(), &cells(|a, b| a | b), &place("join"));
        match case / 3 % 4 {
            0 => compare(&a, &cells_of_a, &place("operand")),
            1 => compare(&a.complement().unwrap(), &cells(|a, _| !a), &place("complement")),
            2 => compare(&a.difference(&b).unwrap(), &cells(|a, b| a & !b), &place("difference")),
            _ => compare(&a.symmetric_difference(&b).unwrap(), &cells(|a, b| a ^ b), &place("xor")),
        }
        let is_subset = cells_of_a.as_flattened().iter().zip(cells_of_b.as_flattened()).all(|(a, b)| !a | b);
        assert_eq!(a.is_subset_of(&b).unwrap(), is_subset, "case {case}: order");
    }
}
