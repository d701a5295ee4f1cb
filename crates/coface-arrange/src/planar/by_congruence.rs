//! Segments that are cut one by one, and glued where their pieces coincide within a tolerance.

use super::near_features::{Drawing, Redrawn, once};
use super::rounding::SnappedArrangement;
use super::{PlanarArrangement, VertexSource};
use crate::congruence::{
    CellClasses, ClassRule, CongruenceOptions, Representative, VertexCongruence, chain_congruence, is_near,
    vertex_congruence,
};
use crate::near::{CoordinatePrecision, NearCounts, least_tolerance};
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, Error, ErrorKind, RaggedArray, Sign, SparseMatrix};
use coface_geometry::{AxisBox, BoxTree, Positions};
use rayon::prelude::*;

/// What [`PlanarArrangement::by_congruence`] stacked and glued.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct StackedSegments {
    /// The numbers of vertices and edges before they were glued: the points of the drawing, and those on each segment for itself.
    pub f_vector: [usize; 2],
    /// The largest distance of two vertices that became one, in the unit of the drawing: far below the tolerance if that was chosen well.
    pub largest_class_diameter: f64,
    /// The segments whose ends are different points that became one, rising. They are not in the arrangement.
    pub collapsed: Vec<u32>,
}

impl PlanarArrangement {
    /// The arrangement of the same segments by congruence: each segment is cut by all others, the pieces are stacked as one chain
    /// complex, vertices that are within the tolerance of each other become one, edges follow by the chain map, and the faces are
    /// wrapped around again.
    ///
    /// A segment is cut where another crosses it, and at the foot of each point and crossing within the tolerance of it. Classes of
    /// vertices are transitive and are at their lowest point of the drawing, where they have one. Where glued edges cross, they are
    /// cut and glued again.
    ///
    /// `tolerance` is a length in the unit of the drawing: well above the rounding of coordinates, well below the smallest distance of
    /// features that are different. Below four units of the last place of the largest coordinate it counts as that. This is the
    /// pipeline of the source texts, in rounded numbers; [`PlanarArrangement::new`] is exact, and [`PlanarArrangement::within`] leaves
    /// nothing nearer than its tolerance.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if the tolerance is negative or no number, or if there is no end to what is glued.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n pieces, if few segments and points are near each of them.
    ///
    /// # References
    /// A. Paoluzzi, V. Shapiro, A. DiCarlo, F. Furiani, G. Martella, G. Scorzelli, *Topological computing of arrangements
    /// with (co)chains* (2020). What is different: segments run through the points within the tolerance of them, and bridges are kept.
    ///
    /// # Examples
    /// Two squares with a side in common, but for a thousandth:
    /// ```
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = vec![0., 0., 1., 0., 1., 1., 0., 1., 1.001, 0., 2., 0., 2., 1., 0.999, 1.];
    /// let sides = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]];
    /// let squares = PlanarArrangement::new(&Positions::from_flat(2, corners)?, &sides)?;
    /// let glued = squares.by_congruence(0.01)?;
    /// assert_eq!(glued.arrangement().f_vector(), [6, 7, 2]);
    /// let stacked = glued.stacked().map(|stacked| (stacked.f_vector, stacked.largest_class_diameter < 0.0011));
    /// // The eight points, and both ends of each of the eight sides.
    /// assert_eq!(stacked, Some(([24, 8], true)));
    /// # Ok(()) }
    /// ```
    pub fn by_congruence(&self, tolerance: f64) -> Result<SnappedArrangement, Error> {
        let mut stacked: Option<StackedSegments> = None;
        let mut found = self.in_rounds(tolerance, |drawing, tolerance, _| {
            let (next, own, counts, is_settled) = drawing.glued(tolerance)?;
            match &mut stacked {
                None => stacked = Some(own),
                Some(first) => {
                    first.largest_class_diameter =
                        first.largest_class_diameter.max(own.largest_class_diameter);
                    first.collapsed.extend(own.collapsed);
                }
            }
            Ok((next, counts, is_settled))
        })?;
        if let Some(stacked) = &mut stacked {
            stacked.collapsed.sort_unstable();
            stacked.collapsed.dedup();
        }
        found.stacked = stacked;
        Ok(found)
    }
}

impl Drawing {
    /// Each edge is cut by all others, and the pieces are glued once; with whether they meet in their ends alone.
    fn glued(&self, tolerance: f64) -> Result<(Self, StackedSegments, NearCounts, bool), Error> {
        let cut = CutSegments::of(self, tolerance);
        let mut flat = cut.places.clone();
        flat.extend(cut.feet.iter().map(|foot| foot.at));
        let positions = Positions::from_flat(2, flat.as_flattened().to_vec())?;
        let classes =
            vertex_congruence(&positions, tolerance, ClassRule::Transitive, Representative::Lowest)?;
        let stack = Stack::of(&cut, &classes, self.ends.len())?;
        let glued = stack.glued(self)?;
        let collapsed = (stack.collapsed.iter())
            .flat_map(|&edge| self.segments.list(edge as usize))
            .map(|packed| packed >> 1)
            .collect();
        let stacked = StackedSegments {
            f_vector: [stack.class_of.len(), stack.edge_count],
            largest_class_diameter: classes.largest_diameter(),
            collapsed,
        };
        let source = |class: &u32| match classes.members().list(*class as usize)[0] as usize {
            point if point < cut.point_count => self.sources[point],
            // A foot is near what it is the foot of.
            place => {
                let crossed = cut.crossed.get(place - cut.point_count).copied().unwrap_or_default();
                VertexSource::Crossing(crossed.map(|edge| self.segments.list(edge as usize)[0] as usize >> 1))
            }
        };
        let points: &[[f64; 2]] = classes.positions().as_flat().as_chunks::<2>().0;
        let counts = cut.counts(&classes, least_tolerance(&self.points, CoordinatePrecision::Double));
        let glued_count = glued.0.len();
        let next = Redrawn {
            points: stack.used.iter().map(|&class| points[class as usize]).collect(),
            sources: stack.used.iter().map(source).collect(),
            places: stack.class_of[..cut.point_count].to_vec(),
            ends: glued.0,
            segments: glued.1,
        };
        let point_count = next.points.len();
        let next = next.cut(self)?;
        let is_settled =
            next.arrangement.vertex_count() == point_count && next.arrangement.edge_count() == glued_count;
        Ok((next, stacked, counts, is_settled))
    }
}

/// The places at which segments are cut.
struct CutSegments<'a> {
    ends: &'a [[u32; 2]],
    /// The points of the drawing, then the crossings.
    places: Vec<[f64; 2]>,
    point_count: usize,
    /// The two segments of each crossing.
    crossed: Vec<[u32; 2]>,
    /// How far along its two segments each crossing is.
    along: Vec<[f64; 2]>,
    feet: Vec<Foot>,
}

/// Where a place is nearest to a segment.
struct Foot {
    segment: u32,
    place: u32,
    at: [f64; 2],
    along: f64,
}

/// A segment with its direction.
#[derive(Clone, Copy)]
struct Line {
    ends: [[f64; 2]; 2],
    /// Of length 1; zero for a point.
    direction: [f64; 2],
    length: f64,
}

impl Line {
    fn new(ends: [[f64; 2]; 2]) -> Self {
        let [[ax, ay], [bx, by]] = ends;
        let length = (bx - ax).hypot(by - ay);
        let direction = if length > 0.0 { [(bx - ax) / length, (by - ay) / length] } else { [0.0; 2] };
        Self { ends, direction, length }
    }

    /// How far along the line a point is, and how far to the left of it.
    fn seen([x, y]: [f64; 2], line: &Self) -> [f64; 2] {
        let ([ox, oy], [dx, dy]) = (line.ends[0], line.direction);
        [(x - ox) * dx + (y - oy) * dy, (y - oy) * dx - (x - ox) * dy]
    }

    fn at(&self, along: f64) -> [f64; 2] {
        [0, 1].map(|axis| self.ends[0][axis] + along * self.direction[axis])
    }

    /// Where the line crosses another, if both have ends beyond the tolerance on both sides of the other: how far along both.
    fn crossing(&self, other: &Self, tolerance: f64) -> Option<[f64; 2]> {
        let heights = |line: &Self, over: &Self| line.ends.map(|end| Self::seen(end, over)[1]);
        let parts = |[from, to]: [f64; 2]| {
            let is_across = from.abs() > tolerance && to.abs() > tolerance && (from > 0.0) != (to > 0.0);
            is_across.then(|| from / (from - to))
        };
        let (own, others) = (parts(heights(self, other))?, parts(heights(other, self))?);
        Some([own * self.length, others * other.length])
    }

    fn bounds(&self, tolerance: f64) -> AxisBox {
        let side = |axis: usize| {
            let [a, b] = self.ends.map(|end| end[axis]);
            [a.min(b) - tolerance, a.max(b) + tolerance]
        };
        [side(0), side(1), [0.0; 2]]
    }
}

impl<'a> CutSegments<'a> {
    fn of(drawing: &'a Drawing, tolerance: f64) -> Self {
        let mut places: Vec<[f64; 2]> = drawing.points.iter().map(|&[x, y, _]| [x, y]).collect();
        let point_count = places.len();
        let lines: Vec<Line> =
            drawing.ends.iter().map(|ends| Line::new(ends.map(|end| places[end as usize]))).collect();
        let boxes: Vec<AxisBox> = lines.iter().map(|line| line.bounds(tolerance)).collect();
        let tree = BoxTree::new(&boxes);
        let crossings_of = |(own, line): (usize, &Line)| {
            let mut found = Vec::new();
            tree.visit(&line.bounds(0.0), |other| {
                if other as usize > own {
                    let crossing = line.crossing(&lines[other as usize], tolerance);
                    found.extend(crossing.map(|along| ([own as u32, other], along)));
                }
            });
            found.sort_unstable_by_key(|&(pair, _)| pair);
            found
        };
        let crossings: Vec<Vec<_>> = lines.par_iter().enumerate().map(crossings_of).collect();
        let (crossed, along): (Vec<[u32; 2]>, Vec<[f64; 2]>) = crossings.into_iter().flatten().unzip();
        places.extend(crossed.iter().zip(&along).map(|(pair, along)| lines[pair[0] as usize].at(along[0])));
        let feet_of = |(place, &at): (usize, &[f64; 2])| {
            let mut found = Vec::new();
            let is_on = |segment: u32| match place.checked_sub(point_count) {
                None => drawing.ends[segment as usize].contains(&(place as u32)),
                Some(crossing) => crossed[crossing].contains(&segment),
            };
            tree.visit(&Line::new([at; 2]).bounds(0.0), |segment| {
                let line = &lines[segment as usize];
                let [along, _] = Line::seen(at, line);
                let foot = line.at(along);
                if along > 0.0 && along < line.length && !is_on(segment) && is_near(&foot, &at, tolerance) {
                    found.push(Foot { segment, place: place as u32, at: foot, along });
                }
            });
            found.sort_unstable_by_key(|foot| foot.segment);
            found
        };
        let feet: Vec<Vec<Foot>> = places.par_iter().enumerate().map(feet_of).collect();
        let feet = feet.into_iter().flatten().collect();
        Self { ends: &drawing.ends, places, point_count, crossed, along, feet }
    }

    /// What was farther apart than this and became one.
    fn counts(&self, classes: &VertexCongruence, least: f64) -> NearCounts {
        let at = classes.positions().as_flat().as_chunks::<2>().0;
        let is_moved = |place: usize| {
            let class = classes.class_of()[place] as usize;
            !is_near(&self.places[place], &at[class], least)
        };
        let crossings = (self.point_count..self.places.len()).filter(|&place| is_moved(place)).count();
        let vertices = (0..self.point_count).filter(|&place| is_moved(place)).count();
        let is_beside = |foot: &&Foot| {
            let ends = self.ends[foot.segment as usize].map(|end| classes.class_of()[end as usize]);
            (foot.place as usize) < self.point_count
                && !ends.contains(&classes.class_of()[foot.place as usize])
                && !is_near(&self.places[foot.place as usize], &foot.at, least)
        };
        let mut counts = NearCounts::default();
        (counts.vertices, counts.edges) = (vertices, self.feet.iter().filter(is_beside).count());
        counts.crossings = crossings;
        counts
    }
}

/// All pieces of segments side by side, after the points of the drawing: so that points give their positions to the vertices at them.
struct Stack {
    /// The class of each vertex, numbered by place in `used`.
    class_of: Vec<u32>,
    /// The classes that are there, in the order of their first vertices.
    used: Vec<u32>,
    /// The segment of each edge.
    segment_of_edge: Vec<u32>,
    edge_count: usize,
    /// The segments whose ends are different vertices of one class.
    collapsed: Vec<u32>,
    complex: ChainComplex,
}

impl Stack {
    fn of(cut: &CutSegments<'_>, classes: &VertexCongruence, segment_count: usize) -> Result<Self, Error> {
        let class = |place: usize| classes.class_of()[place];
        // What is on each segment between its ends: how far along, and the class.
        let on = (cut.crossed.iter().zip(&cut.along).enumerate())
            .flat_map(|(i, (pair, along))| {
                let class = class(cut.point_count + i);
                [0, 1].map(|side| (pair[side], along[side], class))
            })
            .chain(
                (cut.feet.iter().enumerate())
                    .map(|(i, foot)| (foot.segment, foot.along, class(cut.places.len() + i))),
            );
        let mut on: Vec<(u32, f64, u32)> = on.collect();
        on.par_sort_unstable_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.cmp(&b.2)));
        let mut class_of: Vec<u32> = (0..cut.point_count).map(class).collect();
        let (mut entries, mut segment_of_edge, mut collapsed) = (Vec::new(), Vec::new(), Vec::new());
        let mut rest = &on[..];
        for segment in 0..segment_count as u32 {
            let (own, others) = rest.split_at(rest.partition_point(|own| own.0 <= segment));
            rest = others;
            let ends = cut.ends[segment as usize];
            let [start, end] = ends.map(|end| class(end as usize));
            if start == end {
                let [a, b] = ends.map(|end| cut.places[end as usize]);
                if a != b {
                    collapsed.push(segment);
                }
                continue;
            }
            let between =
                first_of_each(own.iter().map(|own| own.2).filter(|own| ![start, end].contains(own)));
            let first = class_of.len();
            class_of.extend([start].into_iter().chain(between).chain([end]));
            for vertex in first..class_of.len() - 1 {
                let edge = segment_of_edge.len();
                entries.extend([(vertex, edge, -1i64), (vertex + 1, edge, 1)]);
                segment_of_edge.push(segment);
            }
            if class_of.len() >= 1 << 31 {
                return Err(Error::new(ErrorKind::TooLarge, "2^31 or more pieces of segments")
                    .with_cure("arrange the segments in parts"));
            }
        }
        let used = first_of_each(class_of.iter().copied());
        let mut number = vec![0; classes.class_count()];
        (0..).zip(&used).for_each(|(place, &class)| number[class as usize] = place);
        class_of.iter_mut().for_each(|class| *class = number[*class as usize]);
        let edge_count = segment_of_edge.len();
        let edges = SparseMatrix::from_entries(class_of.len(), edge_count, entries)?;
        let complex = ChainComplex::new(vec![edges])?;
        Ok(Self { class_of, used, segment_of_edge, edge_count, collapsed, complex })
    }

    /// The ends of the glued edges, and the segments along each, packed.
    fn glued(&self, drawing: &Drawing) -> Result<(Vec<[u32; 2]>, RaggedArray), Error> {
        let classes = CellClasses::unsigned(self.class_of.clone())?;
        let merged = chain_congruence(&self.complex, classes, None, CongruenceOptions::new())?;
        let (Some(edges), Some(classes)) = (merged.complex().boundary_matrix(1), merged.classes().get(1))
        else {
            return Ok((Vec::new(), RaggedArray::new()));
        };
        let ends = edges.columns().map(|column| {
            let rows = column.rows();
            if column.entries()[0] < 0 { [rows[0], rows[1]] } else { [rows[1], rows[0]] }
        });
        let mut along: Vec<(u32, u32)> = Vec::new();
        for (edge, &segment) in self.segment_of_edge.iter().enumerate() {
            for (class, sign) in classes.image(CellId::new(edge)) {
                let against = u32::from(sign == Sign::Minus);
                let own = drawing.segments.list(segment as usize).iter();
                along.extend(own.map(|packed| (class as u32, packed ^ against)));
            }
        }
        let segments = RaggedArray::grouped(edges.column_count(), along.iter().map(|own| own.0));
        let lists =
            segments.iter().map(|own| once(own.iter().map(|&place| along[place as usize].1).collect()));
        let (mut kept, mut lists_of_kept) = (Vec::new(), RaggedArray::new());
        for (ends, list) in ends.zip(lists).filter(|(_, list)| !list.is_empty()) {
            kept.push(ends);
            lists_of_kept.push(&list);
        }
        Ok((kept, lists_of_kept))
    }
}

/// The first of each, in order.
fn first_of_each(classes: impl Iterator<Item = u32>) -> Vec<u32> {
    let mut firsts: Vec<(u32, u32)> = classes.zip(0..).collect();
    firsts.sort_unstable();
    firsts.dedup_by_key(|own| own.0);
    firsts.sort_unstable_by_key(|own| own.1);
    firsts.into_iter().map(|own| own.0).collect()
}
