//! Where triangles meet otherwise than in common corners and sides.

use super::cut_triangles::check_input;
use super::meetings::{Meetings, Place};
use super::sheets::Sheets;
use coface_algebra::Error;
use coface_geometry::Positions;

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

/// Decides exactly where triangles meet otherwise than in common corners and sides. A corner that touches the inside of a
/// triangle is no crossing.
///
/// # Errors
/// As [`CutTriangles::new`](super::CutTriangles::new).
pub(in crate::spatial) fn crossings(
    positions: &Positions,
    triangles: &[[u32; 3]],
    most_listed: usize,
) -> Result<Crossings, Error> {
    check_input(positions, triangles)?;
    let (sheets, tree) = Sheets::new(positions, triangles);
    let meetings = Meetings::new(&sheets, &tree, |_| Ok(()))?;
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
) -> Result<Vec<u32>, Error> {
    check_input(positions, triangles)?;
    let (sheets, tree) = Sheets::new(positions, triangles);
    let meetings = Meetings::new(&sheets, &tree, |_| Ok(()))?;
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
    let mut found = sheets.degenerate.clone();
    for (sheet, sources) in sheets.sources.iter().enumerate() {
        if is_found[sheet]
            || sheets.edges_of[sheet].iter().any(|&edge| is_edge_found[edge as usize])
            || sheets.corners[sheet].iter().any(|&corner| is_corner_found[corner as usize])
        {
            found.extend(sources.iter().map(|&triangle| triangle >> 1));
        }
    }
    found.sort_unstable();
    Ok(found)
}
