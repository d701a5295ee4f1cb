//! Where triangles meet otherwise than in common corners and sides.

use super::cut_triangles::check_input;
use super::meetings::{Meetings, Place};
use super::sheets::{Sheets, box_around};
use crate::near::NONE;
use coface_algebra::Error;
use coface_geometry::{BoxTree, Positions};
use rayon::prelude::*;

/// Where faces meet otherwise than in common corners and sides: they cross, overlap, have no area, or have a corner inside
/// a side of another one.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Crossings {
    /// The number of places; a segment that two faces have in common is one, with its ends.
    pub count: usize,
    /// A point of each of the first of them.
    pub places: Vec<[f64; 3]>,
}

impl Crossings {
    /// One more, at a place, which is listed if not that many are.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::Crossings;
    /// let mut found = Crossings::default();
    /// found.add([0.0; 3], 1);
    /// found.add([1.0; 3], 1);
    /// assert_eq!((found.count, found.places), (2, vec![[0.0; 3]]));
    /// ```
    pub fn add(&mut self, place: [f64; 3], most_listed: usize) {
        self.count += 1;
        if self.places.len() < most_listed {
            self.places.push(place);
        }
    }
}

/// Triangles that changed, and those near them: the others are known to meet in common corners and sides alone.
struct Changed {
    positions: Positions,
    triangles: Vec<[u32; 3]>,
    /// The triangle of before that each is.
    numbers: Vec<u32>,
    is_changed: Vec<bool>,
}

impl Changed {
    fn new(
        positions: &Positions,
        triangles: &[[u32; 3]],
        is_changed: impl Fn(usize) -> bool + Sync,
    ) -> Result<Self, Error> {
        check_input(positions, triangles)?;
        let points = positions.as_flat().as_chunks::<3>().0;
        let changed: Vec<u32> =
            (0..triangles.len() as u32).into_par_iter().filter(|&own| is_changed(own as usize)).collect();
        let numbers: Vec<u32> = if changed.len() == triangles.len() {
            changed
        } else {
            let boxes: Vec<_> =
                changed.par_iter().map(|&own| box_around(points, triangles[own as usize])).collect();
            let tree = BoxTree::new(&boxes);
            let is_near = |&own: &u32| {
                let mut is_near = is_changed(own as usize);
                if !is_near {
                    tree.visit(&box_around(points, triangles[own as usize]), |_| is_near = true);
                }
                is_near
            };
            (0..triangles.len() as u32).into_par_iter().filter(is_near).collect()
        };
        let mut number = vec![NONE; points.len()];
        let (mut flat, mut count) = (Vec::new(), 0);
        let mut own_triangles = Vec::with_capacity(numbers.len());
        for &own in &numbers {
            own_triangles.push(triangles[own as usize].map(|corner| {
                let known = &mut number[corner as usize];
                if *known == NONE {
                    *known = count;
                    count += 1;
                    flat.extend(points[corner as usize]);
                }
                *known
            }));
        }
        let is_changed = numbers.iter().map(|&own| is_changed(own as usize)).collect();
        Ok(Self { positions: Positions::from_flat(3, flat)?, triangles: own_triangles, numbers, is_changed })
    }

    /// The meetings of pairs of which at least one changed.
    fn meetings(&self) -> Result<(Sheets, Meetings), Error> {
        let (sheets, tree) = Sheets::new(&self.positions, &self.triangles);
        let is_changed = |sheet: u32| {
            sheets.sources.list(sheet as usize).iter().any(|&own| self.is_changed[(own >> 1) as usize])
        };
        let meetings = Meetings::new(&sheets, &tree, is_changed, |_| Ok(()))?;
        Ok((sheets, meetings))
    }
}

/// Decides exactly where triangles meet otherwise than in common corners and sides, of pairs of which at least one changed.
/// A corner that touches the inside of a triangle is no crossing.
///
/// # Errors
/// As [`CutTriangles::new`](super::CutTriangles::new).
pub(in crate::spatial) fn crossings(
    positions: &Positions,
    triangles: &[[u32; 3]],
    is_changed: impl Fn(usize) -> bool + Sync,
    most_listed: usize,
) -> Result<Crossings, Error> {
    let changed = Changed::new(positions, triangles, is_changed)?;
    let triangles = &changed.triangles;
    let (sheets, meetings) = changed.meetings()?;
    let corner = |triangle: u32| {
        let vertex = sheets.vertex_of_point[triangles[triangle as usize][0] as usize];
        sheets.point(vertex)
    };
    let degenerate = sheets.degenerate.iter().map(|&triangle| corner(triangle));
    let touching = meetings.vertices_on_edges.iter().map(|&[_, vertex]| sheets.point(vertex));
    let mut ends: Vec<Place> = meetings.cuts.iter().flat_map(|cut| cut.ends).collect();
    ends.sort_unstable();
    let alone = meetings.places.iter().filter(|place| ends.binary_search(place).is_err());
    let crossing = alone.clone().map(|place| place.point(&sheets).rounded());
    let common = meetings.cuts.iter().map(|cut| cut.ends[0].point(&sheets).rounded());
    let overlapping = overlapping_sheets(&sheets, &meetings);
    let overlapping = overlapping.iter().map(|&sheet| sheets.point(sheets.corners[sheet as usize][0]));
    let count = degenerate.len() + touching.len() + alone.count() + common.len() + overlapping.len();
    let all = degenerate.chain(touching).chain(crossing).chain(common).chain(overlapping);
    Ok(Crossings { count, places: all.take(most_listed).collect() })
}

/// The sheets that have an area in common with another one in their plane, rising: then an edge of one runs inside of the other.
/// Those that [`Meetings`] lists may touch in a corner alone, with edges on one line.
fn overlapping_sheets(sheets: &Sheets, meetings: &Meetings) -> Vec<u32> {
    let mut edges: Vec<u32> = meetings.runs.iter().map(|run| run.edge).collect();
    edges.sort_unstable();
    let mut own: Vec<u32> = meetings.runs.iter().map(|run| run.sheet).collect();
    own.sort_unstable();
    let is_found = |&sheet: &u32| {
        own.binary_search(&sheet).is_ok()
            || sheets.edges_of[sheet as usize].iter().any(|edge| edges.binary_search(edge).is_ok())
    };
    meetings.overlapping.iter().copied().filter(is_found).collect()
}

/// The triangles at which [`crossings`] finds something, rising.
pub(in crate::spatial) fn crossing_triangles(
    positions: &Positions,
    triangles: &[[u32; 3]],
    is_changed: impl Fn(usize) -> bool + Sync,
) -> Result<Vec<u32>, Error> {
    let changed = Changed::new(positions, triangles, is_changed)?;
    let (sheets, meetings) = changed.meetings()?;
    let mut is_found = vec![false; sheets.count()];
    let mut is_edge_found = vec![false; sheets.edges.len()];
    let mut is_corner_found = vec![false; sheets.points.len()];
    for &[edge, vertex] in &meetings.vertices_on_edges {
        (is_edge_found[edge as usize], is_corner_found[vertex as usize]) = (true, true);
    }
    let mut find = |place: &Place| match *place {
        Place::Corner(_) => {}
        Place::Edges(edges) => edges.iter().for_each(|&edge| is_edge_found[edge as usize] = true),
        Place::EdgeAndSheet([edge, sheet]) => {
            (is_edge_found[edge as usize], is_found[sheet as usize]) = (true, true);
        }
        Place::Sheets(own) => own.iter().for_each(|&sheet| is_found[sheet as usize] = true),
    };
    meetings.places.iter().for_each(&mut find);
    let pairs = meetings.cuts.iter().flat_map(|cut| cut.sheets);
    pairs.chain(overlapping_sheets(&sheets, &meetings)).for_each(|sheet| is_found[sheet as usize] = true);
    let number = |&triangle: &u32| changed.numbers[triangle as usize];
    let mut found: Vec<u32> = sheets.degenerate.iter().map(number).collect();
    for (sheet, sources) in sheets.sources.iter().enumerate() {
        if is_found[sheet]
            || sheets.edges_of[sheet].iter().any(|&edge| is_edge_found[edge as usize])
            || sheets.corners[sheet].iter().any(|&corner| is_corner_found[corner as usize])
        {
            found.extend(sources.iter().map(|&packed| number(&(packed >> 1))));
        }
    }
    found.sort_unstable();
    Ok(found)
}
