//! Where a condition on winding numbers is not decided yet, and the parts of rings that run there.
//!
//! A square with its sides parallel to the axes is cut into four, and these again. Rings that do not come into such a
//! box have one winding number all over it. If these numbers decide the condition whatever the rings within the box do,
//! no boundary of the selection comes into the box: its sides need not be cut. The union of many overlapping polygons
//! has almost all of its sides in such boxes.
//!
//! The sides that come into other boxes contain the boundary. Parts of rings are closed by chords, and laid over each
//! other. The condition has one value on each face of that overlay, since there is no boundary within; whether it
//! changes across an edge is decided at one point of the edge, with all sides of the box that the point is in.

use super::PlanarOverlay;
use super::chains::Rings;
use crate::planar::PlanarOptions;
use crate::planar::nesting::rising_line;
use crate::planar::tour::Step;
use coface_algebra::{Error, RaggedArray};
use coface_geometry::Positions;
use coface_geometry::predicates::{PlanarLine, PlanarPoint, direction_turn, orientation};
use rayon::prelude::*;
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// Boxes with so few sides are not cut any more.
const FEW_SIDES: usize = 6;
/// Boxes are not cut more often.
const MOST_CUTS: u32 = 24;
/// Boxes that were cut so many times are looked at one after the other.
const PARALLEL_CUTS: u32 = 4;
/// After so many cuts that did not take away a quarter of the sides a box is cut no more.
const FUTILE_CUTS: u32 = 6;

/// Winding numbers of rings, by their numbers, rising; those that are not named are zero.
type Numbers = Vec<(u32, i32)>;

/// Rings without the parts where a condition on their winding numbers is decided by other rings.
///
/// The condition gets the winding numbers that are not zero, rising by the numbers of their rings, and the numbers of
/// rings of which nothing is known; it says `None` if those may make a difference.
///
/// # Examples
/// The union of a square and many small ones within it.
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_arrange::planar::UndecidedRings;
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let (mut flat, mut rings) = (Vec::new(), Vec::new());
/// let small = (0..100).map(|i| ([40.5 + f64::from(i % 10), 41.5 + f64::from(i / 10)], 3.0));
/// for ([x, y], size) in small.chain([([0.0; 2], 100.0)]) {
///     rings.push((0..4).map(|corner| flat.len() as u32 / 2 + corner).collect::<Vec<u32>>());
///     flat.extend([x, y, x + size, y, x + size, y + size, x, y + size]);
/// }
/// let (points, rings) = (Positions::from_flat(2, flat)?, RaggedArray::from_lists(rings));
/// let numbers: Vec<u32> = (0..101).collect();
/// let union = || |known: &[(u32, i32)], unknown: &[u32]| match known {
///     [] if !unknown.is_empty() => None,
///     known => Some(!known.is_empty()),
/// };
/// let undecided = UndecidedRings::new(&points, &rings, &numbers, &[], union).expect("coordinates are small");
/// // Only the sides of the large square are laid over each other.
/// assert_eq!(undecided.side_count(), 4);
/// let overlay = undecided.overlay(&points, &Default::default())?;
/// let selection = undecided.selection(&overlay, union).expect("no edge is too short");
/// assert_eq!(selection.is_inside, [true, false]);
/// # Ok(()) }
/// ```
pub struct UndecidedRings {
    sides: Sides,
    root: Branch,
    bounds: [[f64; 2]; 2],
    /// The rings that remain, closed by chords, with their numbers.
    rings: RaggedArray,
    numbers: Vec<u32>,
    /// For each place in the lists of these rings the place of the side in the lists of the rings that were given; none
    /// for chords.
    places: Vec<Option<u32>>,
    /// The rings of which nothing remains.
    left_out: Vec<u32>,
    /// The numbers of rings of which every side remains, rising.
    kept: Vec<u32>,
}

impl std::fmt::Debug for UndecidedRings {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("UndecidedRings")
            .field("side_count", &self.side_count())
            .field("left_out", &self.left_out.len())
            .finish_non_exhaustive()
    }
}

/// What satisfies a condition on winding numbers.
#[derive(Clone, Debug)]
pub struct UndecidedSelection {
    /// Whether the condition holds in each face of the overlay; the unbounded one comes last.
    pub is_inside: Vec<bool>,
    /// Winding numbers at a place within a face that is inside: of one place on the inner side of each edge of the
    /// boundary, and of both sides of edges along rings that are kept.
    pub windings: Vec<(u32, Vec<(u32, i32)>)>,
}

/// The sides of all rings that have a length.
struct Sides {
    lines: Vec<PlanarLine>,
    /// The number of the ring of each.
    numbers: Vec<u32>,
}

/// A box with what is known in it.
struct Branch {
    /// The rings that come into the box around this one, but not into this one, and wind around it.
    known: Numbers,
    content: Content,
}

enum Content {
    /// Boxes with the lower and with the upper x below this y, and above.
    Boxes { middle: [f64; 2], inner: Box<[Branch; 4]> },
    Sides {
        /// The sides that come into the box.
        sides: Vec<u32>,
        /// How often their rings wind around the lower left corner, moved right by less than any distance, and up by
        /// less than that.
        windings: Numbers,
        /// Whether it does not matter what they do.
        is_decided: bool,
    },
}

impl UndecidedRings {
    /// The rings of an overlay as [`PlanarOverlay::new`] has them: each runs through its points and back to the first,
    /// and winding numbers of rings with the same number are added. Of rings whose numbers are `kept`, which rise,
    /// everything remains.
    ///
    /// `None` where numbers are too large, or where there is nothing.
    ///
    /// # Complexity
    /// Linear in the sides for each time that boxes are cut, and in the winding numbers in the boxes; in parallel, with
    /// the same result whatever the number of threads.
    ///
    /// # Examples
    /// See [`UndecidedRings`].
    pub fn new<D: FnMut(&[(u32, i32)], &[u32]) -> Option<bool>>(
        positions: &Positions,
        rings: &RaggedArray,
        numbers: &[u32],
        kept: &[u32],
        condition: impl Fn() -> D + Sync,
    ) -> Option<Self> {
        let given = Rings::new(positions, rings);
        let number = |ring: u32| numbers[ring as usize];
        let count = given.points.len();
        let sides = Sides {
            lines: (0..count as u32).map(|side| given.soup.line(side)).collect(),
            numbers: (0..count as u32).map(|side| number(given.numbers[given.ring_of(side)])).collect(),
        };
        let [mut low, mut high] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        for point in &given.soup.points {
            for axis in 0..2 {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
        }
        // No ring comes to the lower left corner, or winds around it.
        let size = (high[0] - low[0]).max(high[1] - low[1]);
        let bounds = [low.map(|x| x - 0.01 * size), high.map(|x| x + 0.01 * size)];
        let is_around = (0..2).all(|axis| bounds[0][axis] < low[axis] && high[axis] < bounds[1][axis]);
        if count == 0 || !is_around || !bounds.as_flattened().iter().all(|x| x.abs() < 1e150) {
            return None;
        }
        let mut windings: Numbers = sides.numbers.iter().map(|&number| (number, 0)).collect();
        windings.sort_unstable();
        windings.dedup();
        let search = Search { sides: &sides, condition: &condition };
        let all = (0..count as u32).collect();
        let progress = Progress::new(count);
        let root = search.branch(bounds, progress, all, windings, (Vec::new(), &[]), &mut condition());
        let mut remains: Vec<bool> =
            sides.numbers.iter().map(|number| kept.binary_search(number).is_ok()).collect();
        root.mark_undecided(&mut remains);
        let mut found = Self {
            sides,
            root,
            bounds,
            rings: RaggedArray::new(),
            numbers: Vec::new(),
            places: Vec::new(),
            left_out: Vec::new(),
            kept: kept.to_vec(),
        };
        for ring in 0..given.numbers.len() {
            found.add_ring(&given, ring, number(given.numbers[ring]), &remains);
        }
        Some(found)
    }

    /// Adds what remains of a ring.
    fn add_ring(&mut self, given: &Rings, ring: usize, number: u32, remains: &[bool]) {
        let sides = given.sides(ring);
        let remaining = |side: &u32| remains[*side as usize];
        let Some(first) = sides.clone().find(|side| !remains[*side as usize]) else {
            let own = sides.start as usize..sides.end as usize;
            let places: Vec<Option<u32>> = given.places[own.clone()].iter().copied().map(Some).collect();
            return self.push(number, &given.points[own], &places);
        };
        // Runs of sides that remain, from one that does not.
        let order: Vec<u32> = (first..sides.end).chain(sides.start..first).collect();
        let runs: Vec<&[u32]> =
            order.chunk_by(|a, b| remaining(a) == remaining(b)).filter(|run| remaining(&run[0])).collect();
        if runs.is_empty() {
            self.left_out.push(given.numbers[ring]);
            return;
        }
        let ends = |run: &[u32]| [given.soup.line(run[0])[0], given.soup.line(run[run.len() - 1])[1]];
        let length = |[a, b]: PlanarLine| (b[0] - a[0]).hypot(b[1] - a[1]);
        let apart: f64 = runs.iter().map(|run| length(ends(run))).sum();
        let next = runs.iter().cycle().skip(1);
        let together: f64 = runs.iter().zip(next).map(|(a, b)| length([ends(a)[1], ends(b)[0]])).sum();
        let (mut points, mut places) = (Vec::new(), Vec::new());
        for run in &runs {
            for &side in *run {
                points.push(given.points[side as usize]);
                places.push(Some(given.places[side as usize]));
            }
            let end = given.soup.segments[run[run.len() - 1] as usize][1];
            points.push(given.points[end as usize]);
            places.push(None);
            if apart < together {
                self.push(number, &points, &places);
                points.clear();
                places.clear();
            }
        }
        if !points.is_empty() {
            self.push(number, &points, &places);
        }
    }

    fn push(&mut self, number: u32, points: &[u32], places: &[Option<u32>]) {
        self.rings.push(points);
        self.numbers.push(number);
        self.places.extend_from_slice(places);
    }

    /// The number of sides that remain.
    ///
    /// # Examples
    /// See [`UndecidedRings`].
    pub fn side_count(&self) -> usize {
        self.places.iter().flatten().count()
    }

    /// The places of the given rings of which nothing remains, rising.
    #[doc(hidden)]
    pub fn left_out(&self) -> &[u32] {
        &self.left_out
    }

    /// The place of a side in the lists of the given rings, by its place in the lists of those that are laid over each
    /// other; `None` for a chord.
    #[doc(hidden)]
    pub fn place(&self, side: usize) -> Option<usize> {
        self.places[side].map(|place| place as usize)
    }

    /// The overlay of what remains; winding numbers around its faces mean nothing.
    ///
    /// # Errors
    /// As [`PlanarOverlay::with_options`].
    ///
    /// # Examples
    /// See [`UndecidedRings`].
    pub fn overlay(&self, positions: &Positions, options: &PlanarOptions) -> Result<PlanarOverlay, Error> {
        let is_chord: Vec<bool> = self.places.iter().map(Option::is_none).collect();
        PlanarOverlay::with_chords(positions, &self.rings, &self.numbers, options, &is_chord)
    }

    /// The faces of that overlay where the condition holds.
    ///
    /// `None` if an edge is so short that there is no floating-point number between the coordinates of its ends.
    ///
    /// # Complexity
    /// Linear in the edges, times the sides in the smallest boxes and the length of the condition.
    ///
    /// # Examples
    /// See [`UndecidedRings`].
    pub fn selection<D: FnMut(&[(u32, i32)], &[u32]) -> Option<bool>>(
        &self,
        overlay: &PlanarOverlay,
        condition: impl Fn() -> D + Sync + Send,
    ) -> Option<UndecidedSelection> {
        let edge_count = overlay.cells.edges.ends.len() as u32;
        let found: Option<Vec<Across>> = (0..edge_count)
            .into_par_iter()
            .with_min_len(1 << 10)
            .map_init(
                || Decisions { condition: condition(), known: BTreeMap::new() },
                |decisions, edge| self.across(overlay, edge, decisions),
            )
            .collect();
        let found = found?;
        let mut is_inside = vec![false; overlay.face_count() + 1];
        let outside = condition()(&[], &[])?;
        is_inside[overlay.face_count()] = outside;
        let mut here = outside;
        overlay.tour(|step| match step {
            Step::Into { face, across } => {
                here ^= found[across as usize / 2].changes;
                is_inside[face as usize] = here;
            }
            Step::Back { across, .. } => here ^= found[across as usize / 2].changes,
        });
        let face = |halfedge: u32| (overlay.cells.face(halfedge) as usize).min(overlay.face_count());
        debug_assert!((0..edge_count).all(|edge| {
            let [left, right] = [2 * edge, 2 * edge + 1].map(|halfedge| is_inside[face(halfedge)]);
            (left != right) == found[edge as usize].changes
        }));
        let mut windings = Vec::new();
        for (edge, across) in (0..).zip(found) {
            for (side, numbers) in (0..).zip(across.windings) {
                let face = face(2 * edge + side);
                if let Some(numbers) = numbers.filter(|_| is_inside[face] && face < overlay.face_count()) {
                    windings.push((face as u32, numbers));
                }
            }
        }
        Some(UndecidedSelection { is_inside, windings })
    }

    /// What is left and right of an edge.
    fn across<D: FnMut(&[(u32, i32)], &[u32]) -> Option<bool>>(
        &self,
        overlay: &PlanarOverlay,
        edge: u32,
        decisions: &mut Decisions<D>,
    ) -> Option<Across> {
        let mut numbers = overlay.edge_numbers(edge).peekable();
        if numbers.peek().is_none() {
            return Some(Across::default());
        }
        let is_kept = numbers.any(|number| self.kept.binary_search(&number).is_ok());
        let (line, axis, at) =
            overlay.straight_parts(edge).into_iter().flatten().find_map(|(line, ends)| {
                // The axis along which the part is longer comes first.
                let [width, height] = [0, 1].map(|axis| (ends[1][axis] - ends[0][axis]).abs());
                let axes = if width >= height { [0, 1] } else { [1, 0] };
                axes.into_iter().find_map(|axis| {
                    let [a, b] = ends.map(|end| end[axis]);
                    let middle = a + (b - a) * 0.5;
                    (a.min(b) < middle && middle < a.max(b)).then_some((line, axis, middle))
                })
            })?;
        let leaf = self.leaf(line, axis, at);
        if leaf.is_decided && !is_kept {
            return Some(Across::default());
        }
        let [low, high] = leaf.around(&self.sides, line, axis, at);
        let sides = if is_above_left(line, axis) { [high, low] } else { [low, high] };
        let [left, right] = [decisions.at(&leaf, &sides[0])?, decisions.at(&leaf, &sides[1])?];
        let changes = left != right;
        let [of_left, of_right] = sides;
        let wanted = |windings: Numbers, is_in: bool| {
            ((changes || is_kept) && is_in).then(|| leaf.with_known(windings))
        };
        Some(Across { changes, windings: [wanted(of_left, left), wanted(of_right, right)] })
    }

    /// The smallest box around the point of a line that has this coordinate.
    fn leaf(&self, line: PlanarLine, axis: usize, at: f64) -> Leaf<'_> {
        let (mut branch, mut corner) = (&self.root, self.bounds[0]);
        let mut path = vec![branch];
        while let Content::Boxes { middle, inner } = &branch.content {
            // Which half of the other coordinate the point is in.
            let other = 1 - axis;
            let mut mark = [at; 2];
            mark[other] = middle[other];
            let [a, b] = rising_line(if axis == 0 { line } else { swapped(line) });
            let mark_above = orientation(a, b, if axis == 0 { mark } else { [mark[1], mark[0]] }).is_gt();
            let mut half = [0; 2];
            half[axis] = usize::from(at > middle[axis]);
            half[other] = usize::from(!mark_above);
            for axis in 0..2 {
                if half[axis] == 1 {
                    corner[axis] = middle[axis];
                }
            }
            branch = &inner[half[0] + 2 * half[1]];
            path.push(branch);
        }
        let Content::Sides { sides, windings, is_decided } = &branch.content else {
            unreachable!("boxes end in sides")
        };
        Leaf { path, sides, windings, corner, is_decided: *is_decided }
    }
}

/// What a condition said before.
struct Decisions<D> {
    condition: D,
    /// By the box: winding numbers of the rings that come into it, and what the condition said.
    known: BTreeMap<*const Branch, BTreeMap<Numbers, bool>>,
}

impl<D: FnMut(&[(u32, i32)], &[u32]) -> Option<bool>> Decisions<D> {
    /// Whether the condition holds at a place in a box with these winding numbers of the rings that come into it.
    fn at(&mut self, leaf: &Leaf<'_>, windings: &Numbers) -> Option<bool> {
        let branch: *const Branch = *leaf.path.last()?;
        let known = self.known.entry(branch).or_default();
        if let Some(&holds) = known.get(windings) {
            return Some(holds);
        }
        let holds = (self.condition)(&leaf.with_known(windings.clone()), &[])?;
        known.insert(windings.clone(), holds);
        Some(holds)
    }
}

/// What is on both sides of an edge.
#[derive(Default)]
struct Across {
    changes: bool,
    /// The winding numbers on the left and on the right, where they are of interest.
    windings: [Option<Numbers>; 2],
}

/// A smallest box.
struct Leaf<'a> {
    /// The boxes around it, the largest first, and itself.
    path: Vec<&'a Branch>,
    sides: &'a [u32],
    windings: &'a Numbers,
    corner: [f64; 2],
    is_decided: bool,
}

impl Leaf<'_> {
    /// Winding numbers of the rings that come into it with those of all others, rising by the numbers of rings.
    fn with_known(&self, mut windings: Numbers) -> Numbers {
        windings.extend(self.path.iter().flat_map(|branch| &branch.known));
        windings.sort_unstable();
        windings
    }

    /// The winding numbers, of rings that come into the box, directly below and above a line, or on the lower and the
    /// upper side of the other axis, at the place with this coordinate on one axis.
    ///
    /// The place is moved up along this axis by less than any distance, as the corner is. The way to it goes from the
    /// corner along this axis, then along the other.
    fn around(&self, sides: &Sides, line: PlanarLine, axis: usize, at: f64) -> [Numbers; 2] {
        let other = 1 - axis;
        let mut turn = self.corner;
        turn[axis] = at;
        let frame = |line: PlanarLine| if axis == 0 { line } else { swapped(line) };
        let own = rising_line(frame(line));
        let mut windings = [self.windings.clone(), self.windings.clone()];
        for &side in self.sides {
            let t = sides.lines[side as usize];
            let mut by = [0; 2];
            let [is_on_way, is_across] = [spans(t, other, self.corner[other]), spans(t, axis, at)];
            if !is_on_way && !is_across {
                continue;
            }
            let at_turn = is_left(t, turn);
            if is_on_way {
                let change = i32::from(at_turn) - i32::from(is_left(t, self.corner));
                by = [change; 2];
            }
            if is_across {
                let rising = rising_line(frame(t));
                let order = PlanarPoint::given([at, 0.0])
                    .compare_heights(rising, own)
                    .then_with(|| direction_turn(own, rising));
                let above_left = is_above_left(t, axis);
                for (by, is_below) in by.iter_mut().zip([order.is_lt(), order.is_le()]) {
                    *by += i32::from(is_below == above_left) - i32::from(at_turn);
                }
            }
            for (windings, by) in windings.iter_mut().zip(by) {
                add(windings, sides.numbers[side as usize], by);
            }
        }
        windings.map(|mut windings| {
            windings.retain(|&(_, winding)| winding != 0);
            windings
        })
    }
}

impl Branch {
    fn mark_undecided(&self, remains: &mut [bool]) {
        match &self.content {
            Content::Boxes { inner, .. } => inner.iter().for_each(|branch| branch.mark_undecided(remains)),
            Content::Sides { is_decided: true, .. } => {}
            Content::Sides { sides, .. } => sides.iter().for_each(|&side| remains[side as usize] = true),
        }
    }
}

/// Cuts boxes until the condition is decided in them.
struct Search<'a, C> {
    sides: &'a Sides,
    condition: &'a C,
}

impl<D: FnMut(&[(u32, i32)], &[u32]) -> Option<bool>, C: Fn() -> D + Sync> Search<'_, C> {
    /// A box with the sides that may come into it, and the winding numbers of their rings around its lower left
    /// corner; `own` are those of rings that do not come into it, of which `known` are not known of the box around it.
    fn branch(
        &self,
        bounds: [[f64; 2]; 2],
        progress: Progress,
        sides: Vec<u32>,
        windings: Numbers,
        (known, own): (Numbers, &[(u32, i32)]),
        condition: &mut D,
    ) -> Branch {
        let unknown: Vec<u32> = windings.iter().map(|&(number, _)| number).collect();
        let is_decided = condition(own, &unknown).is_some();
        let [low, high] = bounds;
        let middle = [0, 1].map(|axis| low[axis] + (high[axis] - low[axis]) * 0.5);
        let can_be_cut = (0..2).all(|axis| low[axis] < middle[axis] && middle[axis] < high[axis]);
        let progress = progress.with(sides.len());
        if is_decided || sides.len() <= FEW_SIDES || progress.is_futile() || !can_be_cut {
            return Branch { known, content: Content::Sides { sides, windings, is_decided } };
        }
        let parts = [0, 1, 2, 3].map(|part: usize| {
            let half = [part % 2, part / 2];
            let corner = [0, 1].map(|axis| if half[axis] == 0 { low[axis] } else { middle[axis] });
            let end = [0, 1].map(|axis| if half[axis] == 0 { middle[axis] } else { high[axis] });
            self.part(&sides, &windings, low, [corner, end])
        });
        drop((sides, windings));
        let inner = |(inside, windings, known, bounds): Part, condition: &mut D| {
            let mut own: Numbers = own.iter().chain(&known).copied().collect();
            own.sort_unstable();
            self.branch(bounds, progress.cut(), inside, windings, (known, &own), condition)
        };
        let [a, b, c, d] = parts;
        let inner = if progress.cuts < PARALLEL_CUTS {
            let with_new = |part: Part| inner(part, &mut (self.condition)());
            let ((a, b), (c, d)) = rayon::join(
                || rayon::join(|| with_new(a), || with_new(b)),
                || rayon::join(|| with_new(c), || with_new(d)),
            );
            [a, b, c, d]
        } else {
            [a, b, c, d].map(|part| inner(part, condition))
        };
        Branch { known, content: Content::Boxes { middle, inner: Box::new(inner) } }
    }

    /// The sides that may come into a part of a box, the winding numbers of their rings, and those of the others that
    /// are not zero. `from` is the corner that the winding numbers are of.
    fn part(&self, sides: &[u32], windings: &Numbers, from: [f64; 2], bounds: [[f64; 2]; 2]) -> Part {
        let mut windings = windings.clone();
        let mut comes_in = vec![false; windings.len()];
        let mut inside = Vec::new();
        let to = bounds[0];
        let turn = [to[0], from[1]];
        // Sides of one ring mostly follow each other.
        let (mut own, mut own_number) = (0, windings.first().map(|&(number, _)| number));
        for &side in sides {
            let (line, number) = (self.sides.lines[side as usize], self.sides.numbers[side as usize]);
            if own_number != Some(number) {
                (own, own_number) = (place(&windings, number), Some(number));
            }
            if may_meet(line, bounds) {
                inside.push(side);
                comes_in[own] = true;
            }
            // Along the lower side of the box around, then up.
            let mut by = 0;
            if to[0] != from[0] && spans(line, 1, from[1]) {
                by += i32::from(is_left(line, turn)) - i32::from(is_left(line, from));
            }
            if to[1] != from[1] && spans(line, 0, to[0]) {
                by += i32::from(is_left(line, to)) - i32::from(is_left(line, turn));
            }
            windings[own].1 += by;
        }
        let mut known = Vec::new();
        let mut is_inside = comes_in.into_iter();
        windings.retain(|&(number, winding)| {
            let comes_in = is_inside.next().unwrap_or(false);
            if !comes_in && winding != 0 {
                known.push((number, winding));
            }
            comes_in
        });
        (inside, windings, known, bounds)
    }
}

/// How often a box was cut, and what came of it. Sides that lie on each other, or nearly, come into all boxes along them: cut to the end these
/// would be millions.
#[derive(Clone, Copy)]
struct Progress {
    cuts: u32,
    /// The number of sides when it last fell by a quarter, and the cuts until then.
    sides: usize,
    cuts_until: u32,
}

impl Progress {
    fn new(sides: usize) -> Self {
        Self { cuts: 0, sides, cuts_until: 0 }
    }

    /// The same when a box has so many sides.
    fn with(self, sides: usize) -> Self {
        if sides <= self.sides / 4 * 3 { Self { sides, cuts_until: self.cuts, ..self } } else { self }
    }

    /// Whether cuts did not help, or there were many.
    fn is_futile(self) -> bool {
        self.cuts == MOST_CUTS || self.cuts - self.cuts_until == FUTILE_CUTS
    }

    fn cut(self) -> Self {
        Self { cuts: self.cuts + 1, ..self }
    }
}

/// Sides, winding numbers of their rings, those of rings that do not come in, and a box.
type Part = (Vec<u32>, Numbers, Numbers, [[f64; 2]; 2]);

fn place(windings: &Numbers, number: u32) -> usize {
    let found = windings.binary_search_by_key(&number, |&(number, _)| number);
    found.expect("the rings of all sides of a box have winding numbers")
}

fn add(windings: &mut Numbers, number: u32, by: i32) {
    if by != 0 {
        let place = place(windings, number);
        windings[place].1 += by;
    }
}

fn swapped(line: PlanarLine) -> PlanarLine {
    line.map(|[x, y]| [y, x])
}

/// Whether a line goes from one side of this coordinate to the other; up to it and at it is one side.
fn spans([a, b]: PlanarLine, axis: usize, at: f64) -> bool {
    (a[axis] <= at) != (b[axis] <= at)
}

/// Whether points with a greater other coordinate are on the left of a line.
fn is_above_left([a, b]: PlanarLine, axis: usize) -> bool {
    (a[axis] < b[axis]) == (axis == 0)
}

/// Whether a point is left of a line when it is moved right by less than any distance, and up by less than that.
fn is_left([a, b]: PlanarLine, point: [f64; 2]) -> bool {
    match orientation(a, b, point) {
        Ordering::Greater => true,
        Ordering::Less => false,
        Ordering::Equal if a[1] != b[1] => b[1] < a[1],
        Ordering::Equal => a[0] < b[0],
    }
}

/// Whether a segment has a point in a box with its sides; in doubt it has.
fn may_meet([a, b]: PlanarLine, [low, high]: [[f64; 2]; 2]) -> bool {
    let is_apart = |axis: usize| a[axis].max(b[axis]) < low[axis] || high[axis] < a[axis].min(b[axis]);
    if is_apart(0) || is_apart(1) {
        return false;
    }
    // All corners on one side of the line, by more than rounding does.
    let d = [b[0] - a[0], b[1] - a[1]];
    let center = [0, 1].map(|axis| low[axis] * 0.5 + high[axis] * 0.5 - a[axis]);
    let reach = [0, 1].map(|axis| (high[axis] - low[axis]) * 0.5);
    let distance = (d[0] * center[1] - d[1] * center[0]).abs();
    let half_width = d[0].abs() * reach[1] + d[1].abs() * reach[0];
    let size = [0, 1].map(|axis| low[axis].abs().max(high[axis].abs()).max(a[axis].abs()));
    let slack = 1e-14 * (d[0].abs() * size[1] + d[1].abs() * size[0]);
    distance <= half_width + slack
}
