//! The rings and lines of a map as one graph in the plane: borders that several features share are there once.

use super::super::settling::Settled;
use super::super::walks::vertices_along;
use super::layer::{MapLayer, Point};
use coface_algebra::{Error, RaggedArray};
use coface_arrange::planar::PlanarArrangement;
use coface_geometry::Positions;

/// Rings and lines by vertices that they have in common, which meet in these alone.
pub(super) struct Borders {
    /// Different places.
    pub(super) places: Vec<[f64; 2]>,
    /// The heights of the places, NaN for those without.
    pub(super) heights: Vec<f64>,
    /// The walks: first all rings of the features, then their lines, feature by feature. A ring does not repeat its first vertex.
    pub(super) walks: RaggedArray,
    /// How many of the walks are rings.
    pub(super) ring_count: usize,
    /// The vertices of the points of the features, or of the places where these are.
    pub(super) points: Vec<[f64; 2]>,
    /// How many vertices were put in where borders met without one.
    pub(super) added: usize,
    /// Whether sides were cut or moved at all.
    pub(super) is_cut: bool,
}

impl Borders {
    /// The borders of a map; where they meet without a vertex, one is put in.
    pub(super) fn new(layer: &MapLayer) -> Result<Self, Error> {
        let features = || layer.features.iter().map(|feature| &feature.geometry);
        let rings: Vec<&Vec<Point>> = features().flat_map(|own| own.polygons.iter().flatten()).collect();
        let lines: Vec<&Vec<Point>> = features().flat_map(|own| &own.lines).collect();
        let points = features().flat_map(|own| &own.points).map(|point| [point[0], point[1]]).collect();
        let ring_count = rings.len();
        let mut places = Places::default();
        let walks: Vec<Vec<u32>> =
            places.numbered(&rings.into_iter().chain(lines).map(Vec::as_slice).collect::<Vec<_>>());
        let Places { places, heights } = places;
        let segments: Vec<[u32; 2]> = (walks.iter().enumerate())
            .flat_map(|(number, walk)| sides(walk, number < ring_count))
            .filter(|side| side[0] != side[1])
            .collect();
        let borders = |places, heights, walks: Vec<Vec<u32>>, cut: Option<usize>| {
            let walks = RaggedArray::from_lists(walks);
            let (added, is_cut) = (cut.unwrap_or(0), cut.is_some());
            Self { places, heights, walks, ring_count, points, added, is_cut }
        };
        let positions = Positions::from_flat(2, places.as_flattened().to_vec())?;
        let drawn = PlanarArrangement::new(&positions, &segments)?;
        if (0..segments.len()).all(|segment| drawn.edges_of_segment(segment).count() == 1) {
            return Ok(borders(places, heights, walks, None));
        }
        drop(drawn);
        let settled = Settled::new(&positions, &segments)?;
        let arrangement = settled.snapped.arrangement();
        let edges = settled.snapped.segments_of_edges().transposed(segments.len());
        let mut next = 0;
        let mut cut = Vec::with_capacity(walks.len());
        for (number, walk) in walks.iter().enumerate() {
            let is_ring = number < ring_count;
            let mut found: Vec<u32> = Vec::new();
            for side in sides(walk, is_ring).filter(|side| side[0] != side[1]) {
                let ends = side.map(|end| places[end as usize]);
                let along = vertices_along(arrangement, edges.list(next), ends);
                next += 1;
                for vertex in along {
                    if found.last() != Some(&vertex) {
                        found.push(vertex);
                    }
                }
            }
            if is_ring && found.len() > 1 && found.first() == found.last() {
                found.pop();
            }
            cut.push(found);
        }
        let flat = arrangement.positions().as_flat().as_chunks::<2>().0.to_vec();
        let mut lifted = vec![f64::NAN; flat.len()];
        for (point, &height) in heights.iter().enumerate() {
            if let Some(vertex) = settled.snapped.place_of_point(point) {
                let known = &mut lifted[vertex.index()];
                *known = if known.is_nan() { height } else { *known };
            }
        }
        interpolate(&mut lifted, &flat, &cut, ring_count);
        let added = flat.len().saturating_sub(places.len());
        Ok(borders(flat, lifted, cut, Some(added)))
    }

    /// Which vertices lines end at.
    pub(super) fn line_ends(&self) -> Vec<bool> {
        let mut is_end = vec![false; self.places.len()];
        for line in (self.ring_count..self.walks.len()).map(|walk| self.walks.list(walk)) {
            if let (Some(&a), Some(&b)) = (line.first(), line.last())
                && a != b
            {
                is_end[a as usize] = true;
                is_end[b as usize] = true;
            }
        }
        is_end
    }

    /// The sides of all walks.
    pub(super) fn sides(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        let walks = self.walks.iter().enumerate();
        walks
            .flat_map(|(number, walk)| sides(walk, number < self.ring_count))
            .filter(|side| side[0] != side[1])
    }

    /// A vertex with its height.
    pub(super) fn point(&self, vertex: u32) -> Point {
        let [x, y] = self.places[vertex as usize];
        [x, y, self.heights[vertex as usize]]
    }
}

/// Heights of vertices that have none, from those before and behind them on a walk.
fn interpolate(heights: &mut [f64], places: &[[f64; 2]], walks: &[Vec<u32>], ring_count: usize) {
    if heights.iter().all(|height| height.is_nan()) {
        return;
    }
    let distance = |a: u32, b: u32| {
        let [p, q] = [a, b].map(|vertex| places[vertex as usize]);
        (p[0] - q[0]).hypot(p[1] - q[1])
    };
    for (number, walk) in walks.iter().enumerate() {
        let count = walk.len();
        for i in 0..count {
            if !heights[walk[i] as usize].is_nan() {
                continue;
            }
            let step = |back: bool| {
                let mut length = 0.0;
                let mut at = i;
                for _ in 0..count {
                    let next = match (back, number < ring_count) {
                        (false, true) => (at + 1) % count,
                        (true, true) => (at + count - 1) % count,
                        (false, false) if at + 1 < count => at + 1,
                        (true, false) if at > 0 => at - 1,
                        _ => return None,
                    };
                    length += distance(walk[at], walk[next]);
                    at = next;
                    if !heights[walk[at] as usize].is_nan() {
                        return Some((length, heights[walk[at] as usize]));
                    }
                }
                None
            };
            heights[walk[i] as usize] = match (step(true), step(false)) {
                (Some((a, low)), Some((b, high))) if a + b > 0.0 => (low * b + high * a) / (a + b),
                (Some((_, height)), _) | (_, Some((_, height))) => height,
                (None, None) => continue,
            };
        }
    }
}

/// The sides of a walk, the closing one of a ring too.
fn sides(walk: &[u32], is_ring: bool) -> impl Iterator<Item = [u32; 2]> + '_ {
    let closing = (is_ring && walk.len() > 1).then(|| [walk[walk.len() - 1], walk[0]]);
    walk.windows(2).map(|side| [side[0], side[1]]).chain(closing)
}

/// Different places with their heights.
#[derive(Default)]
struct Places {
    places: Vec<[f64; 2]>,
    heights: Vec<f64>,
}

impl Places {
    /// The numbers of the places along walks; of equal places the height is that of the first which has one.
    fn numbered(&mut self, walks: &[&[Point]]) -> Vec<Vec<u32>> {
        let corners: Vec<&Point> = walks.iter().flat_map(|walk| walk.iter()).collect();
        let key = |corner: u32| {
            let corner = corners[corner as usize];
            // Zeros of both signs are equal.
            [corner[0] + 0.0, corner[1] + 0.0].map(f64::to_bits)
        };
        let mut order: Vec<u32> = (0..corners.len() as u32).collect();
        order.sort_unstable_by_key(|&corner| (key(corner), corner));
        let mut firsts = vec![0; corners.len()];
        for same in order.chunk_by(|&a, &b| key(a) == key(b)) {
            same.iter().for_each(|&corner| firsts[corner as usize] = same[0]);
        }
        let mut numbers = vec![u32::MAX; corners.len()];
        for (corner, &first) in firsts.iter().enumerate() {
            if first as usize == corner {
                numbers[corner] = self.places.len() as u32;
                let &[x, y, height] = corners[corner];
                self.places.push([x + 0.0, y + 0.0]);
                self.heights.push(height);
            }
            let number = numbers[first as usize];
            numbers[corner] = number;
            let height = &mut self.heights[number as usize];
            *height = if height.is_nan() { corners[corner][2] } else { *height };
        }
        let mut numbers = numbers.into_iter();
        walks.iter().map(|walk| numbers.by_ref().take(walk.len()).collect()).collect()
    }
}
