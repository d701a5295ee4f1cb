//! Mouths of open inputs: their rims before anything is cut, patches that close them, and the tolerance that would.

use super::arranged::Arranged;
use super::inputs::{InputState, Inputs};
use super::{SpatialRequest, SpatialScene};
use crate::answer::{Place, Remark, RemarkCode};
use crate::near::{in_one_digit, rounded_up};
use crate::repair::near_vertices;
use crate::text;
use coface_algebra::{Error, ErrorKind};
use coface_arrange::spatial::closed_walks;
use coface_geometry::predicates::orientation;
use coface_geometry::{AxisBox, BoxTree, cross, dot};

/// Rims of more vertices are divided by short diagonals before they are triangulated.
const MOST_VERTICES: usize = 256;
/// For a rim of more vertices no tolerance is looked for.
const MOST_NEAR: usize = 1 << 12;
/// For a rim of more vertices radii are tried, each so many times the one before, instead of the distances of all pairs.
const MOST_PAIRS: usize = 1 << 9;
const RADIUS_STEP: f64 = 8.0;
/// The least radius that is tried, as a part of the extent, and to which part of itself one is found.
const LEAST_PART: f64 = 1e-14;
const RADIUS_PART: f64 = 1.05;
/// A gap is a mouth, not a crack, from this part of the extent on.
const CRACK_PART: f64 = 1e-3;

/// An input of fewer polygons may be all mouths, as two triangles that touch.
const LEAST_POLYGONS: usize = 8;

type Point = [f64; 3];

/// What was open of an input and is closed by patches.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mouths {
    pub(super) edges: usize,
}

impl SpatialScene {
    /// Closes the mouths of all inputs with patches, which are polygons of these inputs from then on: for each rim the
    /// triangles on its vertices that have the least area in sum. A remark says how many there were, and their area.
    ///
    /// Patches are numbered after the polygons of their file.
    ///
    /// # Errors
    /// [`ErrorKind::NotACycle`] for an input of polygons that hardly share a side, so that patches would cover them and enclose
    /// nothing; [`ErrorKind::TooLarge`] for 2^32 or more corners.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n corners, and $O(k^3)$ for a rim of k vertices, up to 256.
    ///
    /// # Examples
    /// A tetrahedron without the face on the plane x + y + z / 6 = 1:
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SpatialRequest, SpatialScene};
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 3 1 4\n";
    /// let open = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let mut scene = SpatialScene::of([("open", &open)], true)?;
    /// scene.close_mouths()?;
    /// assert_eq!(scene.polygon_count(), 4);
    /// assert_eq!(SceneArrangement::of_scene(scene, &SpatialRequest::default())?.volumes(), [1.0]);
    /// # Ok(()) }
    /// ```
    pub fn close_mouths(&mut self) -> Result<(), Error> {
        let rims = self.rims(&self.classes_of_points(), |_| true);
        self.first_patch = Some(self.polygon_count());
        self.mouths = vec![None; self.names().len()];
        let mut next_source = vec![0; self.files.len()];
        for (polygon, &source) in self.source_of_polygon.iter().enumerate() {
            let file = self.parts[self.input_of_polygon[polygon] as usize].0 as usize;
            next_source[file] = next_source[file].max(source + 1);
        }
        for own in rims.chunk_by(|x, y| x.0 == y.0) {
            let input = own[0].0;
            let mut sides: Vec<[u32; 2]> = own.iter().map(|side| side.1).collect();
            let edges = sides.len();
            let walks = closed_walks(&mut sides);
            self.refuse_loose_polygons(input, walks.len(), edges)?;
            let mut triangles = Vec::new();
            walks.iter().for_each(|walk| self.triangulate(walk, &mut triangles));
            let mut area = 0.0;
            for [a, b, c] in triangles {
                area += self.area([a, b, c]);
                if self.are_on_a_line([a, b, c]) {
                    continue;
                }
                let file = self.parts[input as usize].0 as usize;
                let polygon = self.polygon_count() as u32;
                // Against the rim, which then cancels.
                self.walks.push(&[c, b, a]);
                self.polygon_of_walk.push(polygon);
                self.input_of_polygon.push(input);
                self.source_of_polygon.push(next_source[file]);
                self.is_wall.push(false);
                next_source[file] += 1;
            }
            self.mouths[input as usize] = Some(Mouths { edges });
            let rims = text::count(walks.len(), "mouth");
            let edges = text::count(edges, "edge");
            let message = format!(
                "{} is open: {rims} with {edges} closed by patches of area {}",
                self.label(input as usize),
                text::number(area)
            );
            let file = self.file_of_input(input as usize).to_owned();
            self.remarks
                .push(Remark::new(RemarkCode::OpenInput, message).at(walks.len(), [Place::file(file)]));
        }
        if u32::try_from(self.walks.item_count()).is_err() {
            return Err(Error::new(ErrorKind::TooLarge, "2^32 or more corners of polygons and patches"));
        }
        Ok(())
    }

    /// Refuses to close an input that is nothing but mouths: patches would cover its polygons, and enclose nothing.
    fn refuse_loose_polygons(&self, input: u32, mouth_count: usize, edges: usize) -> Result<(), Error> {
        let is_own = |polygon: &usize| self.input_of_polygon[*polygon] == input && !self.is_wall[*polygon];
        let own = (0..self.first_patch.unwrap_or(self.polygon_count())).filter(is_own).count();
        let walks = self.walks.iter().zip(&self.polygon_of_walk);
        let sides: usize =
            walks.filter(|(_, polygon)| is_own(&(**polygon as usize))).map(|(walk, _)| walk.len()).sum();
        if own < LEAST_POLYGONS || mouth_count < own.div_ceil(2) || 4 * edges <= 3 * sides {
            return Ok(());
        }
        let fault = format!(
            "{own} polygons have {mouth_count} mouths, since they hardly share a side: patches would cover them and enclose nothing"
        );
        let error = Error::new(ErrorKind::NotACycle, fault).in_file(self.label(input as usize));
        Err(match self.weld_of(input as usize) {
            Some(radius) => {
                error.with_cure(format!("merge vertices that nearly coincide (--weld {radius:.2e})"))
            }
            None => error.with_cure("give a mesh whose polygons share their sides"),
        })
    }

    /// The tolerance, to one digit, with which an open input is closed; none if there is none that is small beside the
    /// input.
    pub(super) fn closing_tolerance(&self, input: usize, request: &SpatialRequest) -> Option<f64> {
        if request.tolerance.is_some() || self.first_patch.is_some() {
            return None;
        }
        let rim = self.rims(&self.classes_of_points(), |other| other as usize == input);
        let mut vertices: Vec<u32> = rim.iter().map(|side| side.1[0]).collect();
        vertices.sort_unstable();
        vertices.dedup();
        if vertices.len() > MOST_NEAR {
            return None;
        }
        // How far each vertex of the rim is from what else there is of it.
        let gap = |&vertex: &u32| {
            let others = rim.iter().filter(|side| !side.1.contains(&vertex));
            others.map(|side| self.distance(vertex, side.1)).fold(f64::INFINITY, f64::min)
        };
        // A vertex in which a crack ends is far from the rest.
        let crack = CRACK_PART * self.extent_of(input);
        let gap = vertices.iter().map(gap).filter(|&gap| gap <= crack).fold(0.0, f64::max);
        let points = vertices.iter().map(|&vertex| self.point(vertex));
        let largest = points.flatten().fold(f64::MIN_POSITIVE, |most: f64, x| most.max(x.abs()));
        let needed = (2.0 * gap).max(8.0 * f64::EPSILON * largest);
        let tolerance = in_one_digit(needed);
        let request = SpatialRequest { tolerance: Some(tolerance), snap: false, ..*request };
        let arranged = Arranged::new(self, &request).ok()?;
        let state = Inputs::new(self, &arranged).ok()?.state(input);
        (state == InputState::Closed).then_some(tolerance)
    }

    /// The least radius within which vertices have to be merged, as [`welded`](crate::welded) does, so that an open input is
    /// closed, to three digits, or to two for rims of many vertices; none if none closes it that is small beside the input.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n points of the file, a bounded number of times.
    pub(super) fn closing_weld(&self, input: usize) -> Option<f64> {
        if self.first_patch.is_some() { None } else { self.weld_of(input) }
    }

    fn weld_of(&self, input: usize) -> Option<f64> {
        let is_own = |other: u32| other as usize == input;
        let mut vertices: Vec<u32> =
            self.rims(&self.classes_of_points(), is_own).iter().map(|side| side.1[0]).collect();
        vertices.sort_unstable();
        vertices.dedup();
        let crack = CRACK_PART * self.extent_of(input);
        let closes = |radius: f64| {
            self.welded_points(input, radius).is_ok_and(|class| self.rims(&class, is_own).is_empty())
        };
        if vertices.len() > MOST_PAIRS {
            return least_radius(LEAST_PART * self.extent_of(input), crack, closes);
        }
        let mut gaps: Vec<f64> = Vec::new();
        for (place, &a) in vertices.iter().enumerate() {
            let near = vertices[place + 1..].iter().map(|&b| {
                let way = minus(self.point(a), self.point(b));
                dot(way, way).sqrt()
            });
            gaps.extend(near.filter(|&gap| gap <= crack));
        }
        gaps.sort_by(f64::total_cmp);
        gaps.dedup();
        let radii: Vec<f64> = gaps.iter().map(|&gap| rounded_up(gap, 3)).collect();
        // What closes it at some radius does so at longer ones, unless features vanish.
        let least = radii.partition_point(|&radius| !closes(radius));
        radii.get(least).copied().filter(|&radius| closes(radius))
    }

    /// The radius within which vertices have to be merged so that an input has mouths alone and no cracks: the least one that is
    /// tried with the shortest rim, if that is at most half as long as without; none if there is none that is small beside the
    /// input. What is left open are mouths.
    ///
    /// # Complexity
    /// As [`Self::closing_weld`].
    pub(super) fn crack_weld(&self, input: usize) -> Option<f64> {
        let is_own = |other: u32| other as usize == input;
        let length = |radius: f64| Some(self.rims(&self.welded_points(input, radius).ok()?, is_own).len());
        self.shortest(input, self.rims(&self.classes_of_points(), is_own).len(), length)
    }

    /// The radius within which vertices have to be merged so that each side is one of an even number of polygons, whatever their
    /// directions; none where that is so as it is, by the numbers of vertices, or is with no radius that is small beside the input.
    pub(super) fn pairing_weld(&self, input: usize) -> Option<f64> {
        let whole: Vec<u32> = (0..(self.flat.len() / 3) as u32).collect();
        let odd = self.odd_side_count(input, &whole);
        let length = |radius: f64| Some(self.odd_side_count(input, &self.welded_points(input, radius).ok()?));
        self.shortest(input, odd, length).filter(|&radius| length(radius) == Some(0))
    }

    /// The least radius of those that are tried for which a length is least, if that is at most half of another one.
    fn shortest(&self, input: usize, without: usize, length: impl Fn(f64) -> Option<usize>) -> Option<f64> {
        let extent = self.extent_of(input);
        let (crack, mut radius) = (CRACK_PART * extent, LEAST_PART * extent);
        let mut best: Option<(usize, f64)> = None;
        while radius > 0.0 && radius <= crack {
            let tried = in_one_digit(radius);
            let own = length(tried)?;
            if 2 * own <= without && without > 0 && best.is_none_or(|(least, _)| own < least) {
                best = Some((own, tried));
            }
            radius *= RADIUS_STEP;
        }
        best.map(|(_, radius)| radius)
    }

    /// The largest side of the box around an input.
    fn extent_of(&self, input: usize) -> f64 {
        let mut frame = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
        for (walk, &polygon) in self.walks.iter().zip(&self.polygon_of_walk) {
            if self.input_of_polygon[polygon as usize] as usize != input {
                continue;
            }
            for &vertex in walk {
                for (side, x) in frame.iter_mut().zip(self.point(vertex)) {
                    *side = [side[0].min(x), side[1].max(x)];
                }
            }
        }
        frame.iter().map(|[low, high]| high - low).fold(0.0, f64::max)
    }

    /// The number of sides that an odd number of polygons of an input have.
    fn odd_side_count(&self, input: usize, class: &[u32]) -> usize {
        let mut sides: Vec<[u32; 2]> = Vec::new();
        for (walk, &polygon) in self.walks.iter().zip(&self.polygon_of_walk) {
            if self.is_wall[polygon as usize] || self.input_of_polygon[polygon as usize] as usize != input {
                continue;
            }
            let ends = walk.iter().zip(walk.iter().cycle().skip(1));
            let ends = ends.map(|(&a, &b)| [a, b].map(|vertex| class[vertex as usize]));
            sides.extend(ends.filter(|[a, b]| a != b).map(|[a, b]| [a.min(b), a.max(b)]));
        }
        sides.sort_unstable();
        sides.chunk_by(|x, y| x == y).filter(|same| same.len() % 2 == 1).count()
    }

    /// For each point the one that it is merged with within a radius, in the file of an input.
    fn welded_points(&self, input: usize, radius: f64) -> Result<Vec<u32>, Error> {
        let mut class: Vec<u32> = (0..(self.flat.len() / 3) as u32).collect();
        let file = self.parts[input].0 as usize;
        let start = self.point_starts[file];
        let end = self.point_starts.get(file + 1).copied().unwrap_or(class.len() as u32);
        let point = |vertex: u32| &self.flat[3 * vertex as usize..][..3];
        for [vertex, first] in near_vertices((start..end).collect(), 3, point, radius)? {
            class[vertex as usize] = first;
        }
        Ok(class)
    }

    /// The sides along which inputs are open, each with its input, as often as polygons have it more in this direction than
    /// in the other one; rising. Points of a file that coincide are one, and sides are divided where others end on them.
    fn rims(&self, class: &[u32], is_asked: impl Fn(u32) -> bool) -> Vec<(u32, [u32; 2])> {
        let mut sides: Vec<(u32, [u32; 2], i32)> = Vec::new();
        for (walk, &polygon) in self.walks.iter().zip(&self.polygon_of_walk) {
            let input = self.input_of_polygon[polygon as usize];
            if self.is_wall[polygon as usize] || !is_asked(input) {
                continue;
            }
            for (i, &from) in walk.iter().enumerate() {
                let [a, b] = [from, walk[(i + 1) % walk.len()]].map(|vertex| class[vertex as usize]);
                sides.push((input, [a.min(b), a.max(b)], if a < b { 1 } else { -1 }));
            }
        }
        let rims = sums(sides);
        let mut divided = Vec::new();
        for own in rims.chunk_by(|x, y| x.0 == y.0) {
            let mut vertices: Vec<u32> = own.iter().flat_map(|side| side.1).collect();
            vertices.sort_unstable();
            vertices.dedup();
            let boxes: Vec<AxisBox> = vertices.iter().map(|&vertex| self.box_of([vertex; 2])).collect();
            let tree = BoxTree::new(&boxes);
            for &(input, [a, b], count) in own {
                let mut path = vec![a, b];
                tree.visit(&self.box_of([a, b]), |place| {
                    let vertex = vertices[place as usize];
                    if vertex != a && vertex != b && self.are_on_a_line([a, b, vertex]) {
                        path.push(vertex);
                    }
                });
                // Along a line points are in the order of their coordinates.
                path.sort_by(|&x, &y| self.compare(x, y));
                let sign = if path[0] == a { 1 } else { -1 };
                divided.extend(path.windows(2).map(|pair| {
                    let [x, y] = [pair[0], pair[1]];
                    (input, [x.min(y), x.max(y)], if x < y { sign * count } else { -sign * count })
                }));
            }
        }
        let directed = |&(input, [a, b], count): &(u32, [u32; 2], i32)| {
            std::iter::repeat_n(
                (input, if count > 0 { [a, b] } else { [b, a] }),
                count.unsigned_abs() as usize,
            )
        };
        sums(divided).iter().flat_map(directed).collect()
    }

    /// For each point the first one of its file in the same place.
    fn classes_of_points(&self) -> Vec<u32> {
        let count = self.flat.len() / 3;
        let mut class: Vec<u32> = (0..count as u32).collect();
        for (file, &start) in self.point_starts.iter().enumerate() {
            let end = self.point_starts.get(file + 1).map_or(count, |&next| next as usize);
            let mut order: Vec<u32> = (start..end as u32).collect();
            order.sort_by(|&a, &b| self.compare(a, b).then(a.cmp(&b)));
            for same in order.chunk_by(|&a, &b| self.point(a) == self.point(b)) {
                same.iter().for_each(|&point| class[point as usize] = same[0]);
            }
        }
        class
    }

    /// The triangles on the vertices of a closed walk that have the least area in sum, in the direction of the walk.
    fn triangulate(&self, walk: &[u32], triangles: &mut Vec<[u32; 3]>) {
        let count = walk.len();
        if count > MOST_VERTICES {
            // Along the shortest diagonal between opposite vertices.
            let length = |i: usize| {
                let way = minus(self.point(walk[i + count / 2]), self.point(walk[i]));
                dot(way, way)
            };
            let first = (0..count / 2).min_by(|&i, &j| length(i).total_cmp(&length(j))).unwrap_or(0);
            let last = first + count / 2;
            self.triangulate(&walk[first..=last], triangles);
            self.triangulate(&[&walk[last..], &walk[..=first]].concat(), triangles);
            return;
        }
        // For each pair of vertices the least area of triangles between them, and the third corner that has it.
        let mut best = vec![(0.0, 0usize); count * count];
        for width in 2..count {
            for from in 0..count - width {
                let to = from + width;
                let area = |middle: usize| {
                    let own = self.area([from, middle, to].map(|place| walk[place]));
                    best[from * count + middle].0 + best[middle * count + to].0 + own
                };
                let least = (from + 1..to).map(|middle| (area(middle), middle));
                let least = least.min_by(|x, y| x.0.total_cmp(&y.0).then(x.1.cmp(&y.1)));
                best[from * count + to] = least.unwrap_or_default();
            }
        }
        let mut rest = if count < 3 { Vec::new() } else { vec![[0, count - 1]] };
        while let Some([from, to]) = rest.pop() {
            if to - from >= 2 {
                let middle = best[from * count + to].1;
                triangles.push([from, middle, to].map(|place| walk[place]));
                rest.extend([[from, middle], [middle, to]]);
            }
        }
    }

    fn point(&self, vertex: u32) -> Point {
        let at = 3 * vertex as usize;
        [self.flat[at], self.flat[at + 1], self.flat[at + 2]]
    }

    fn compare(&self, a: u32, b: u32) -> std::cmp::Ordering {
        let [p, q] = [a, b].map(|vertex| self.point(vertex).map(|x| x + 0.0));
        (0..3).fold(std::cmp::Ordering::Equal, |order, axis| order.then(p[axis].total_cmp(&q[axis])))
    }

    fn box_of(&self, ends: [u32; 2]) -> AxisBox {
        let [p, q] = ends.map(|vertex| self.point(vertex));
        [0, 1, 2].map(|axis| [p[axis].min(q[axis]), p[axis].max(q[axis])])
    }

    /// Exactly.
    fn are_on_a_line(&self, corners: [u32; 3]) -> bool {
        let points = corners.map(|corner| self.point(corner));
        [[0, 1], [1, 2], [2, 0]].into_iter().all(|[i, j]| {
            let [a, b, c] = points.map(|point| [point[i], point[j]]);
            orientation(a, b, c).is_eq()
        })
    }

    fn area(&self, corners: [u32; 3]) -> f64 {
        let [a, b, c] = corners.map(|corner| self.point(corner));
        let normal = cross(minus(b, a), minus(c, a));
        dot(normal, normal).sqrt() / 2.0
    }

    /// From a vertex to a side.
    fn distance(&self, vertex: u32, side: [u32; 2]) -> f64 {
        let [a, b] = side.map(|end| self.point(end));
        let (along, to) = (minus(b, a), minus(self.point(vertex), a));
        let part = (dot(to, along) / dot(along, along)).clamp(0.0, 1.0);
        let off = [0, 1, 2].map(|axis| to[axis] - part * along[axis]);
        dot(off, off).sqrt()
    }
}

/// A radius that closes, and is hardly longer than the least one, between two bounds: what closes at some radius does so at longer ones.
fn least_radius(least: f64, most: f64, closes: impl Fn(f64) -> bool) -> Option<f64> {
    let (mut low, mut high) = (least, least);
    while !closes(high) {
        if high >= most {
            return None;
        }
        (low, high) = (high, (high * RADIUS_STEP).min(most));
    }
    while high > RADIUS_PART * low {
        let middle = (low * high).sqrt();
        if closes(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    let rounded = rounded_up(high, 2);
    closes(rounded).then_some(rounded)
}

fn minus(a: Point, b: Point) -> Point {
    [0, 1, 2].map(|axis| a[axis] - b[axis])
}

/// Equal sides with the sum of their numbers, rising, without those that cancel.
fn sums(mut sides: Vec<(u32, [u32; 2], i32)>) -> Vec<(u32, [u32; 2], i32)> {
    sides.retain(|side| side.1[0] != side.1[1]);
    sides.sort_unstable();
    let equal = sides.chunk_by(|x, y| (x.0, x.1) == (y.0, y.1));
    equal
        .map(|own| (own[0].0, own[0].1, own.iter().map(|side| side.2).sum()))
        .filter(|side: &(u32, [u32; 2], i32)| side.2 != 0)
        .collect()
}
