//! What of a drawing is seen: sets that shapes and lines are clipped by, exactly.
//!
//! A **clip** is a set of the plane: what rings wind around as their rule says, or all, some or one-without-the-other of other clips. An element has the clip of
//! what is around it, together with its own. Nothing is cut while clips are read: only when a shape is drawn, its rings and those of its clip are laid over each
//! other in one exact overlay, and what is in both is read off. So a shape is rounded once, however many clips are around it, and
//! each coordinate of a corner that clipping makes is the floating-point number nearest to the exact one. Where rounding makes rings invalid they are laid over themselves
//! until they are valid.
//!
//! This is done here, and not where models are arranged, since a [`Model`](crate::Model) has rounded coordinates: all that reads the file sees the clipped shapes,
//! and writers write them. Curves are clipped by [`coface_yin`] where they are kept, else by their chords.

use super::curves::Subpath;
use coface_algebra::{Error, ErrorKind, FaceId, HalfedgeId, RaggedArray, VertexId};
use coface_arrange::boolean::InsideRule;
use coface_arrange::planar::{
    PlanarArrangement, PlanarOptions, PlanarOverlay, PlanarPolygons, PlanarRegions, are_valid_polygons,
    turned_rings,
};
use coface_geometry::Positions;
use coface_geometry::predicates::orientation;
use std::collections::HashMap;

/// Rings that rounding makes invalid are laid over themselves so many times at most.
const MOST_ROUNDS: usize = 8;

type Point = [f64; 2];

/// A set of the plane. The clips that it is made of have lower numbers.
pub(super) enum Clip {
    /// What rings wind around.
    Region(Region),
    /// What is in all of these: everything, if there are none.
    All(Vec<usize>),
    /// What is in one of these at least: nothing, if there are none.
    Any(Vec<usize>),
    /// What is in the first and not in the second.
    Without([usize; 2]),
}

/// What subpaths wind around, each closed.
pub(super) struct Region {
    pub(super) subpaths: Vec<Subpath>,
    pub(super) rule: InsideRule,
    bounds: [Point; 2],
    /// Whether it is one convex polygon.
    is_convex: bool,
    /// What is so near to a convex polygon counts as inside of it: what fills its box often does not by the last digit.
    margin: f64,
}

impl Region {
    pub(super) fn new(mut subpaths: Vec<Subpath>, rule: InsideRule) -> Self {
        subpaths.retain(Subpath::may_fill);
        for subpath in subpaths.iter_mut().filter(|subpath| subpath.cubics.is_empty()) {
            subpath.corners.dedup();
        }
        let bounds = bounds_of(subpaths.iter().flat_map(Subpath::controls));
        let is_convex = match &subpaths[..] {
            [only] => only.cubics.is_empty() && is_convex(&only.corners),
            _ => false,
        };
        Self { subpaths, rule, bounds, is_convex, margin: 0.0 }
    }

    /// The quadrilateral with these corners, of something that is to fill it.
    pub(super) fn frame(corners: [Point; 4]) -> Self {
        let subpath = Subpath { corners: corners.to_vec(), is_closed: true, ..Subpath::default() };
        let size = corners.as_flattened().iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        Self { margin: size * 2f64.powi(-44), ..Self::new(vec![subpath], InsideRule::Nonzero) }
    }

    /// Whether it holds everywhere in the convex hull of points, or nowhere; `None` if that is not seen at once.
    fn around(&self, points: &[Point], bounds: [Point; 2]) -> Option<bool> {
        if self.subpaths.is_empty() || are_apart(self.bounds, bounds) {
            return Some(false);
        }
        if self.is_convex && self.holds(points) {
            return Some(true);
        }
        let near = |side: [Point; 2]| !are_apart(bounds_of(side.iter()), bounds);
        let is_near = |subpath: &Subpath| {
            let curved = subpath.cubics.iter().any(|&(side, inner)| {
                let ends = [subpath.corners[side], subpath.corners[side + 1]];
                !are_apart(bounds_of(ends.iter().chain(&inner)), bounds)
            });
            curved || sides(&subpath.corners).any(near)
        };
        if self.subpaths.iter().any(is_near) {
            return None;
        }
        let winding = self.subpaths.iter().map(|subpath| winding(&subpath.corners, points[0])).sum();
        Some(self.rule.is_inside(winding))
    }

    /// Whether points are in the convex polygon that this is.
    fn holds(&self, points: &[Point]) -> bool {
        let corners = &self.subpaths[0].corners;
        let turn = sides(corners)
            .zip(corners.iter().cycle().skip(2))
            .map(|([a, b], &c)| orientation(a, b, c))
            .find(|turn| turn.is_ne());
        let Some(turn) = turn else { return false };
        points.iter().all(|&point| {
            sides(corners).all(|[a, b]| {
                let side = orientation(a, b, point);
                side.is_eq() || side == turn || self.margin > 0.0 && distance(point, [a, b]) <= self.margin
            })
        })
    }
}

/// All clips of a drawing.
#[derive(Default)]
pub(super) struct Clips {
    clips: Vec<Clip>,
}

/// What of some points and their convex hull is seen.
pub(super) enum Seen {
    All,
    Nothing,
    Part(Part),
}

/// What decides it: clips in rising order, the last of which is asked for, and those of them that are known.
pub(super) struct Part {
    order: Vec<usize>,
    known: HashMap<usize, bool>,
    /// The regions among them that are not known.
    pub(super) regions: Vec<usize>,
}

impl Clips {
    pub(super) fn push(&mut self, clip: Clip) -> usize {
        self.clips.push(clip);
        self.clips.len() - 1
    }

    /// A clip within what is around it.
    pub(super) fn within(&mut self, around: Option<usize>, own: usize) -> usize {
        around.map_or(own, |around| self.push(Clip::All(vec![around, own])))
    }

    pub(super) fn clip(&self, number: usize) -> &Clip {
        &self.clips[number]
    }

    /// A region by its number.
    pub(super) fn region(&self, number: usize) -> Option<&Region> {
        match &self.clips[number] {
            Clip::Region(region) => Some(region),
            _ => None,
        }
    }

    /// A box around what a clip lets through.
    pub(super) fn bounds(&self, number: usize) -> [Point; 2] {
        let mut known: HashMap<usize, [Point; 2]> = HashMap::new();
        for own in self.below(number) {
            let found = match &self.clips[own] {
                Clip::Region(region) => region.bounds,
                Clip::All(parts) => parts.iter().fold(EVERYTHING, |[low, high], part| {
                    let [other_low, other_high] = known[part];
                    [
                        [0, 1].map(|axis| low[axis].max(other_low[axis])),
                        [0, 1].map(|axis| high[axis].min(other_high[axis])),
                    ]
                }),
                Clip::Any(parts) => bounds_of(parts.iter().flat_map(|part| &known[part])),
                Clip::Without([first, _]) => known[first],
            };
            known.insert(own, found);
        }
        known[&number]
    }

    /// The clips that one is made of, rising, and itself.
    pub(super) fn below(&self, number: usize) -> Vec<usize> {
        let (mut found, mut waiting) = (Vec::new(), std::collections::BinaryHeap::from([number]));
        while let Some(next) = waiting.pop() {
            if found.last() == Some(&next) {
                continue;
            }
            found.push(next);
            match &self.clips[next] {
                Clip::Region(_) => {}
                Clip::All(parts) | Clip::Any(parts) => waiting.extend(parts),
                Clip::Without(parts) => waiting.extend(parts),
            }
        }
        found.reverse();
        found
    }

    /// What of the convex hull of points is seen through a clip.
    pub(super) fn seen(&self, number: usize, points: &[Point]) -> Seen {
        let bounds = bounds_of(points.iter());
        let order = self.below(number);
        let (mut known, mut regions) = (HashMap::new(), Vec::new());
        for &own in &order {
            let value = match &self.clips[own] {
                Clip::Region(region) => {
                    let value = region.around(points, bounds);
                    regions.extend(value.is_none().then_some(own));
                    value
                }
                other => other.value(|part| known.get(&part).copied()),
            };
            if let Some(value) = value {
                known.insert(own, value);
            }
        }
        match known.get(&number) {
            Some(true) => Seen::All,
            Some(false) => Seen::Nothing,
            None => Seen::Part(Part { order, known, regions }),
        }
    }

    /// Whether a point is seen of which this is told: the regions around it.
    fn is_seen(&self, part: &Part, is_in: impl Fn(usize) -> bool) -> bool {
        let mut values: HashMap<usize, bool> = HashMap::new();
        for &own in &part.order {
            let value = part.known.get(&own).copied().or_else(|| match &self.clips[own] {
                Clip::Region(_) => Some(is_in(own)),
                other => other.value(|below| values.get(&below).copied()),
            });
            values.insert(own, value == Some(true));
        }
        part.order.last().is_some_and(|last| values[last])
    }

    /// Whether the winding numbers of rings, `1 + i` for the region i of those that matter, are those of a point that is seen.
    fn lets_through(&self, part: &Part, windings: &[(u32, i32)]) -> bool {
        self.is_seen(part, |own| {
            let number = 1 + part.regions.binary_search(&own).unwrap_or_default() as u32;
            let found = windings.iter().find(|(region, _)| *region == number);
            self.region(own).is_some_and(|region| region.rule.is_inside(found.map_or(0, |(_, by)| *by)))
        })
    }

    /// The rings of the regions that matter behind some other rings, which are region 0.
    fn rings(&self, part: &Part, own: &[Vec<Point>]) -> Result<(Positions, RaggedArray, Vec<u32>), Error> {
        let mut rings = Rings::default();
        own.iter().for_each(|ring| rings.push(0, ring));
        for (number, &region) in (1..).zip(&part.regions) {
            let subpaths = self.region(region).map_or(&[][..], |region| &region.subpaths);
            subpaths.iter().for_each(|subpath| rings.push(number, &subpath.corners));
        }
        Ok((Positions::from_flat(2, rings.flat)?, rings.rings, rings.regions))
    }

    /// What of a region of rings is seen: polygons, each by its outer ring, counterclockwise, and its holes, clockwise.
    ///
    /// # Errors
    /// `TooLarge` if the rings of it and of the clip meet more often than `most` times.
    pub(super) fn clipped_rings(
        &self,
        part: &Part,
        rings: &[Vec<Point>],
        rule: InsideRule,
        most: usize,
    ) -> Result<Vec<Vec<Vec<Point>>>, Error> {
        let (positions, rings, regions) = self.rings(part, rings)?;
        let options = options(&rings, most);
        let overlay =
            PlanarOverlay::with_options(&positions, &rings, &regions, &options).map_err(too_many)?;
        let own =
            |windings: &[(u32, i32)]| windings.first().filter(|(region, _)| *region == 0).map(|(_, by)| *by);
        let found = overlay.select(|windings| {
            own(windings).is_some_and(|winding| rule.is_inside(winding)) && self.lets_through(part, windings)
        })?;
        let mut result = Polygons::of(&found);
        let mut is_exact = found.is_exactly_rounded();
        drop(found);
        for _ in 0..MOST_ROUNDS {
            if is_exact || result.is_valid()? {
                break;
            }
            // What was turned inside out by rounding is not wound around.
            let regions = vec![0; result.rings.len()];
            let overlay = PlanarOverlay::new(&result.positions, &result.rings, &regions)?;
            let found =
                overlay.select(|windings| windings.first().is_some_and(|(_, winding)| *winding > 0))?;
            is_exact = found.is_exactly_rounded();
            result = Polygons::of(&found);
        }
        Ok(result.lists())
    }

    /// What of a line is seen: its pieces from its beginning to its end. What runs along the rim of a clip is seen.
    ///
    /// A line that ends where it begins, and is seen there, has the piece through this point first.
    ///
    /// # Errors
    /// `TooLarge` if it and the rings of the clip meet more often than `most` times.
    pub(super) fn clipped_line(
        &self,
        part: &Part,
        mut line: Vec<Point>,
        most: usize,
    ) -> Result<Vec<Vec<Point>>, Error> {
        line.dedup();
        if line.len() < 2 {
            return Ok(Vec::new());
        }
        let side_count = line.len() - 1;
        let (from, is_closed) = (line[0], line.first() == line.last());
        // There and back: so it winds around nothing.
        let back: Vec<Point> = line[1..side_count].iter().rev().copied().collect();
        line.extend(back);
        let (positions, rings, regions) = self.rings(part, std::slice::from_ref(&line))?;
        let corners = line;
        if side_count.saturating_mul(rings.item_count()) > most {
            let sides = rings
                .iter()
                .flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&from, &to)| [from, to]));
            let sides: Vec<[u32; 2]> = sides.collect();
            PlanarArrangement::with_options(&positions, &sides, &options(&rings, most)).map_err(too_many)?;
        }
        let regions = PlanarRegions::new(&positions, &rings, &regions)?;
        let arrangement = regions.arrangement();
        let mut faces: HashMap<Option<usize>, bool> = HashMap::new();
        let mut is_seen = |halfedge: usize| {
            let face = arrangement.face_of(HalfedgeId::new(halfedge));
            let windings = face.map_or(&[][..], |face| regions.winding_numbers(face));
            *faces.entry(face.map(FaceId::index)).or_insert_with(|| self.lets_through(part, windings))
        };
        let place = |vertex: VertexId| {
            let point = arrangement.positions().point(vertex);
            [point[0], point[1]]
        };
        let mut pieces: Vec<Vec<Point>> = Vec::new();
        // Whether the last piece goes on where the next side begins.
        let mut goes_on = false;
        let mut begins_at_start = false;
        for side in 0..side_count {
            let [start, end] = [corners[side], corners[(side + 1) % corners.len()]];
            let rises = (start[0], start[1]) < (end[0], end[1]);
            let mut edges: Vec<_> = arrangement.edges_of_segment(side).collect();
            if !rises {
                edges.reverse();
            }
            let last = edges.len().saturating_sub(1);
            let mut is_open = false;
            for (i, edge) in edges.into_iter().enumerate() {
                let number = 2 * edge.index();
                if !(is_seen(number) || is_seen(number + 1)) {
                    (is_open, goes_on) = (false, false);
                    continue;
                }
                let mut ends = arrangement.ends(edge).map(place);
                if !rises {
                    ends.reverse();
                }
                if side == 0 && i == 0 {
                    begins_at_start = true;
                }
                match pieces.last_mut() {
                    // Another edge of this side, or the first one of the next.
                    Some(piece) if is_open => {
                        piece.pop();
                        piece.push(ends[1]);
                    }
                    Some(piece) if goes_on => piece.push(ends[1]),
                    _ => pieces.push(ends.to_vec()),
                }
                is_open = true;
                goes_on = i == last;
            }
        }
        // The last piece comes to where the first one begins.
        let ends_at_start = goes_on && is_closed && begins_at_start;
        if ends_at_start && pieces.len() > 1 && pieces[0].first() == Some(&from) {
            let first = std::mem::take(&mut pieces[0]);
            let mut last = pieces.pop().unwrap_or_default();
            last.extend(first.into_iter().skip(1));
            pieces[0] = last;
        }
        pieces.iter_mut().for_each(Vec::dedup);
        pieces.retain(|piece| piece.len() > 1);
        Ok(pieces)
    }
}

impl Clip {
    /// Whether a point is in it, of which this is known of its parts, if that decides it.
    fn value(&self, known: impl Fn(usize) -> Option<bool>) -> Option<bool> {
        let all = |parts: &mut dyn Iterator<Item = Option<bool>>| {
            let values: Vec<Option<bool>> = parts.collect();
            if values.contains(&Some(false)) {
                Some(false)
            } else {
                values.into_iter().collect::<Option<Vec<_>>>().map(|_| true)
            }
        };
        let not = |value: Option<bool>| value.map(|value| !value);
        match self {
            Self::Region(_) => None,
            Self::All(parts) => all(&mut parts.iter().map(|&part| known(part))),
            Self::Any(parts) => not(all(&mut parts.iter().map(|&part| not(known(part))))),
            Self::Without([first, second]) => all(&mut [known(*first), not(known(*second))].into_iter()),
        }
    }
}

/// So many cells at most as rings have that meet so often.
fn options(rings: &RaggedArray, most: usize) -> PlanarOptions {
    PlanarOptions::new().max_cells(4 * rings.item_count() + most.saturating_mul(4))
}

/// The error of too many cells, in the words of drawings.
pub(super) fn too_many(error: Error) -> Error {
    match error.kind() {
        ErrorKind::TooLarge => {
            Error::new(ErrorKind::TooLarge, "shapes and what they are clipped by cross too often")
                .with_cure("divide the drawing")
        }
        _ => error,
    }
}

/// Rings of points.
#[derive(Default)]
struct Rings {
    flat: Vec<f64>,
    rings: RaggedArray,
    regions: Vec<u32>,
}

impl Rings {
    fn push(&mut self, region: u32, ring: &[Point]) {
        let start = (self.flat.len() / 2) as u32;
        self.flat.extend(ring.as_flattened());
        let numbers: Vec<u32> = (start..(self.flat.len() / 2) as u32).collect();
        self.rings.push(&numbers);
        self.regions.push(region);
    }
}

/// Polygons with holes on rounded points.
struct Polygons {
    positions: Positions,
    rings: RaggedArray,
    polygons: RaggedArray,
}

impl Polygons {
    fn of(found: &PlanarPolygons<'_>) -> Self {
        Self {
            positions: found.positions().clone(),
            rings: found.rings().clone(),
            polygons: found.polygons().clone(),
        }
    }

    fn is_valid(&self) -> Result<bool, Error> {
        let Self { positions, rings, polygons } = self;
        Ok(are_valid_polygons(positions, rings, polygons, false)?
            && !turned_rings(positions, rings, polygons).contains(&true))
    }

    fn lists(&self) -> Vec<Vec<Vec<Point>>> {
        let flat = self.positions.as_flat().as_chunks::<2>().0;
        let ring = |&ring: &u32| self.rings.list(ring as usize).iter().map(|&v| flat[v as usize]).collect();
        self.polygons.iter().map(|own| own.iter().map(ring).collect()).collect()
    }
}

const EVERYTHING: [Point; 2] = [[f64::NEG_INFINITY; 2], [f64::INFINITY; 2]];

/// The lowest and the highest corner of a box around points; of none the box is inside out.
pub(super) fn bounds_of<'a>(points: impl IntoIterator<Item = &'a Point>) -> [Point; 2] {
    let [lowest, highest] = EVERYTHING;
    points.into_iter().fold([highest, lowest], |[low, high], point| {
        [[0, 1].map(|axis| low[axis].min(point[axis])), [0, 1].map(|axis| high[axis].max(point[axis]))]
    })
}

/// Whether boxes have no point in common.
fn are_apart(a: [Point; 2], b: [Point; 2]) -> bool {
    (0..2).any(|axis| a[1][axis] < b[0][axis] || b[1][axis] < a[0][axis])
}

/// The sides of a closed polygon.
fn sides(corners: &[Point]) -> impl Iterator<Item = [Point; 2]> + '_ {
    corners.iter().zip(corners.iter().cycle().skip(1)).map(|(&a, &b)| [a, b])
}

/// Whether a closed polygon bounds a convex set and goes around it once.
fn is_convex(corners: &[Point]) -> bool {
    let mut corners = corners.to_vec();
    corners.dedup();
    if corners.first() == corners.last() {
        corners.pop();
    }
    let count = corners.len();
    let at = |i: usize| corners[i % count];
    let turns = (0..count).map(|i| orientation(at(i), at(i + 1), at(i + 2)));
    let turns: Vec<_> = turns.filter(|turn| turn.is_ne()).collect();
    let rises = |i: usize| (at(i)[0], at(i)[1]) < (at(i + 1)[0], at(i + 1)[1]);
    count > 2
        && turns.first().is_some_and(|first| turns.iter().all(|turn| turn == first))
        && (0..count).filter(|&i| rises(i) != rises(i + 1)).count() == 2
}

/// How often a closed polygon winds around a point that is on none of its sides.
fn winding(corners: &[Point], point: Point) -> i32 {
    let by = |[a, b]: [Point; 2]| match (a[1] <= point[1], b[1] <= point[1]) {
        (true, false) => i32::from(orientation(a, b, point).is_gt()),
        (false, true) => -i32::from(orientation(a, b, point).is_lt()),
        _ => 0,
    };
    sides(corners).map(by).sum()
}

/// The distance of a point from a line through two others.
fn distance([x, y]: Point, [[ax, ay], [bx, by]]: [Point; 2]) -> f64 {
    let [dx, dy] = [bx - ax, by - ay];
    ((x - ax) * dy - (y - ay) * dx).abs() / dx.hypot(dy)
}
