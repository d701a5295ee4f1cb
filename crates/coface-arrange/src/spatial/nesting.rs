//! Which shells lie in which cells: exact rays from components.

use super::PolygonalComplex;
use super::face_planes::FacePlanes;
use super::predicates::SpatialPredicates;
use super::shells::Shells;
use coface_algebra::Error;
use coface_algebra::progress::Steps;
use rayon::prelude::*;
use std::cmp::Ordering;

/// For each component the shell that it lies directly within, a shell of another component that is not its outer one;
/// `None` for those that lie within none.
///
/// A component is tried at one point p, infinitely near the least vertex of it on one of its edges: p is on no face of
/// another component, even where components touch in vertices. The ray from p towards $-(1, \varepsilon,
/// \varepsilon^2)$ for an infinitely small $\varepsilon$ meets no vertex and no edge but by the rule that a vertex
/// level with the ray counts as above it. The winding number of a shell around p is the number of its half-faces that
/// the ray leaves through minus those that it enters by; p is within the shells of winding number one, and the deepest
/// of these is the parent. All is decided by signs of coordinates of normals and of orientations; no crossing is
/// computed, and crossings need no order along the ray.
///
/// # Errors
/// `InvalidInput` when a component crosses a face of another one at its point p, or winding numbers are not those of
/// shells.
pub(super) fn parents(
    complex: &PolygonalComplex,
    predicates: &impl SpatialPredicates,
    planes: &FacePlanes,
    shells: &Shells,
    steps: &Steps,
) -> Result<Vec<Option<u32>>, Error> {
    let count = shells.outer.len();
    if count < 2 {
        return Ok(vec![None; count]);
    }
    let columns = Columns::new(complex, predicates);
    let around: Vec<Result<Vec<u32>, Error>> = (0..count)
        .into_par_iter()
        .map(|component| {
            steps.advance(0);
            let ray = Ray { complex, predicates, planes, near: shells.anchors[component] };
            shells_around(&ray, &columns, shells, component as u32)
        })
        .collect();
    let around = around.into_iter().collect::<Result<Vec<_>, _>>()?;
    let component_of = |shell: u32| shells.component_of_shell[shell as usize];
    around
        .iter()
        .enumerate()
        .map(|(component, own)| {
            if own.is_empty() {
                return Ok(None);
            }
            let is_parent = |shell: &&u32| around[component_of(**shell) as usize].len() + 1 == own.len();
            own.iter().find(is_parent).map(|&shell| Some(shell)).ok_or_else(|| {
                crossing(&format!("the faces at v{}", shells.anchors[component][0]), "other faces")
            })
        })
        .collect()
}

fn crossing(what: &str, other: &str) -> Error {
    Error::invalid(format!("{what} cross {other} elsewhere than in common edges and vertices"))
        .with_cure("cut the faces against each other first")
}

/// The shells of other components that the point of a component lies within, rising.
fn shells_around<P: SpatialPredicates>(
    ray: &Ray<'_, P>,
    columns: &Columns,
    shells: &Shells,
    component: u32,
) -> Result<Vec<u32>, Error> {
    let mut terms: Vec<(u32, i32)> = Vec::new();
    let mut fault = None;
    columns.visit(ray.predicates, ray.near[0], |face| {
        if fault.is_some() || shells.component_of_face(face) == component {
            return;
        }
        match ray.crossing(face) {
            Ok(0) => {}
            // The front is towards the origin of the ray when the crossing is positive: the ray enters what is behind.
            Ok(sign) => {
                terms.extend([(shells.shell_of[2 * face], -sign), (shells.shell_of[2 * face + 1], sign)]);
            }
            Err(error) => fault = Some(error),
        }
    });
    if let Some(error) = fault {
        return Err(error);
    }
    terms.sort_unstable();
    let mut around = Vec::new();
    for own in terms.chunk_by(|x, y| x.0 == y.0) {
        let shell = own[0].0;
        let is_outer = shells.outer[shells.component_of_shell[shell as usize] as usize] == shell;
        match own.iter().map(|&(_, sign)| sign).sum::<i32>() {
            0 => {}
            1 if !is_outer => around.push(shell),
            -1 if is_outer => {}
            _ => {
                return Err(crossing(&format!("the faces at v{}", ray.near[0]), "each other or other faces"));
            }
        }
    }
    Ok(around)
}

/// A ray towards $-(1, \varepsilon, \varepsilon^2)$ from the point infinitely near the first of two vertices on the way
/// to the second.
struct Ray<'a, P> {
    complex: &'a PolygonalComplex,
    predicates: &'a P,
    planes: &'a FacePlanes,
    near: [u32; 2],
}

impl<P: SpatialPredicates> Ray<'_, P> {
    /// A sign that is linear in the point: that at the first vertex or, if it vanishes there, at the second.
    fn linear(&self, sign: impl Fn(u32) -> Ordering) -> Ordering {
        let [v, w] = self.near;
        sign(v).then_with(|| sign(w))
    }

    /// Whether a vertex is above the ray: $y - \varepsilon x$ is not less than that of the point.
    fn is_above(&self, vertex: u32) -> bool {
        let compare = |axis| self.linear(|from| self.predicates.compare(axis, vertex, from));
        compare(1).then_with(|| compare(0).reverse()).is_ge()
    }

    /// The sign of the winding of the face's walks around the ray, if it meets the face: plus when the front of the
    /// face is towards the far end of the first axis; 0 if it passes by.
    fn crossing(&self, face: usize) -> Result<i32, Error> {
        let mut winding = 0;
        for &side in self.complex.packed_sides().list(face) {
            let [a, b] = self.complex.side_ends(side);
            let (from, to) = (self.is_above(a), self.is_above(b));
            if from == to {
                continue;
            }
            let normal = |axis| self.linear(|point| self.predicates.normal_sign(axis, [point, a, b]));
            let turn = normal(0).then_with(|| normal(1)).then_with(|| normal(2));
            // A side that goes up has the ray to its left when it passes on one side of it; down, on the other.
            match (to, turn) {
                (_, Ordering::Equal) => {
                    return Err(crossing(&format!("edges at v{}", self.near[0]), &format!("face f{face}")));
                }
                (true, Ordering::Less) => winding -= 1,
                (false, Ordering::Greater) => winding += 1,
                _ => {}
            }
        }
        if winding == 0 {
            return Ok(0);
        }
        let [p, q, r] = self.planes.of(self.predicates, face).corners;
        let side = self.linear(|point| self.predicates.orientation([p, q, r, point]));
        match (winding, side) {
            (1, Ordering::Greater) | (-1, Ordering::Less) => Ok(winding),
            (1 | -1, Ordering::Less | Ordering::Greater) => Ok(0),
            (1 | -1, Ordering::Equal) => {
                let [v, w] = self.near;
                Err(crossing(&format!("the faces at the edge of v{v} and v{w}"), &format!("face f{face}")))
            }
            _ => Err(Error::invalid(format!("the walks of face f{face} wind around {winding} times"))
                .with_cure("let the outer walk run one way and holes the other, without crossings")),
        }
    }
}

/// Faces by the boxes around them seen along the first axis, in grids that are finer for smaller faces.
struct Columns {
    /// Where coordinates on the other two axes begin, halved, and the larger extent, halved.
    origin: [f64; 2],
    extent: f64,
    /// The place in the grid of a level, and a face, sorted.
    entries: Vec<(u64, u32)>,
}

/// The finest level: at level k the grid has $2^k$ places on each axis.
const FINEST: u32 = 24;

impl Columns {
    fn new(complex: &PolygonalComplex, predicates: &impl SpatialPredicates) -> Self {
        let boxes: Vec<[[f64; 2]; 2]> = (0..complex.face_count())
            .into_par_iter()
            .map(|face| {
                let mut own = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
                for &side in complex.packed_sides().list(face) {
                    for (axis, [least, most]) in own.iter_mut().enumerate() {
                        let [low, high] = predicates.range(axis + 1, complex.side_ends(side)[0]);
                        (*least, *most) = (least.min(low), most.max(high));
                    }
                }
                own
            })
            .collect();
        // Halved, so that no difference leaves the range.
        let origin =
            [0, 1].map(|axis| boxes.iter().map(|own| own[axis][0] / 2.0).fold(f64::INFINITY, f64::min));
        let end = |axis: usize| boxes.iter().map(|own| own[axis][1] / 2.0).fold(f64::NEG_INFINITY, f64::max);
        let extent = (end(0) - origin[0]).max(end(1) - origin[1]);
        let mut columns = Self { origin, extent, entries: Vec::new() };
        let mut entries = Vec::with_capacity(2 * boxes.len());
        for (face, own) in boxes.iter().enumerate() {
            let places = [0, 1].map(|axis| own[axis].map(|x| columns.place(axis, x)));
            let size = places.iter().map(|[low, high]| high - low).max().unwrap_or(0);
            // So coarse that the box is in at most two places on each axis.
            let level = FINEST - (u32::BITS - size.leading_zeros()).min(FINEST);
            for_each_key(level, places, |key| entries.push((key, face as u32)));
        }
        entries.sort_unstable();
        columns.entries = entries;
        columns
    }

    /// The place of a coordinate at the finest level. It rises with the coordinate, whatever rounding does.
    fn place(&self, axis: usize, x: f64) -> u32 {
        if self.extent <= 0.0 {
            return 0;
        }
        let part = (x / 2.0 - self.origin[axis]) / self.extent;
        // A cast of what is outside goes to the nearest end.
        ((part * f64::from(1u32 << FINEST)) as u32).min((1 << FINEST) - 1)
    }

    /// Calls for each face whose box has the vertex in it, or nearly, seen along the first axis.
    fn visit(&self, predicates: &impl SpatialPredicates, vertex: u32, mut call: impl FnMut(usize)) {
        let places = [0, 1].map(|axis| predicates.range(axis + 1, vertex).map(|x| self.place(axis, x)));
        let mut faces = Vec::new();
        for level in 0..=FINEST {
            for_each_key(level, places, |key| {
                let start = self.entries.partition_point(|entry| entry.0 < key);
                faces.extend(
                    self.entries[start..].iter().take_while(|entry| entry.0 == key).map(|entry| entry.1),
                );
            });
        }
        faces.sort_unstable();
        faces.dedup();
        faces.into_iter().for_each(|face| call(face as usize));
    }
}

/// Calls for the keys of the places between these at a level.
fn for_each_key(level: u32, places: [[u32; 2]; 2], mut call: impl FnMut(u64)) {
    let [rows, columns] = places.map(|ends| ends.map(|place| u64::from(place >> (FINEST - level))));
    for row in rows[0]..=rows[1] {
        for column in columns[0]..=columns[1] {
            call(u64::from(level) << (2 * FINEST) | row << FINEST | column);
        }
    }
}
