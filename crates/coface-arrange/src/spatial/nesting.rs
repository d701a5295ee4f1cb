//! Which shells lie in which cells: exact rays from components.

use super::PolygonalComplex;
use super::face_planes::FacePlanes;
use super::predicates::SpatialPredicates;
use super::shells::Shells;
use coface_algebra::progress::Steps;
use coface_algebra::{Error, RaggedArray};
use coface_geometry::{AxisBox, BoxTree};
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
/// What lies within a shell has its box within the box of that. So only components with p in their boxes are tried, the
/// smallest boxes first, and the first that p is within is the parent.
///
/// # Complexity
/// $O(n \log n)$ for n faces and components, where few boxes that have the point of a component in them are smaller
/// than that of its parent; boxes that have it in them are counted without a look at their faces.
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
    let components = Components::new(complex, predicates, shells);
    let nesting = Nesting { complex, predicates, planes, shells, components: &components };
    let tree = BoxTree::new(&components.boxes);
    (0..count as u32)
        .into_par_iter()
        .map(|component| {
            steps.advance(0);
            nesting.parent(component, &tree)
        })
        .collect()
}

/// The components with their boxes and faces.
struct Components {
    boxes: Vec<AxisBox>,
    /// A measure of each box that is no larger for boxes inside of it, but for rounding.
    sizes: Vec<f64>,
    faces: RaggedArray,
    /// The faces of components with many.
    columns: Columns,
}

/// Components of up to so many faces are looked at face by face.
const FEW_FACES: usize = 48;
/// What rounding may do to the size of a box.
const SLACK: f64 = 1.0 + 1e-9;

impl Components {
    fn new(complex: &PolygonalComplex, predicates: &impl SpatialPredicates, shells: &Shells) -> Self {
        let component_of = |face: usize| shells.component_of_face(face);
        let faces = RaggedArray::grouped(shells.outer.len(), (0..complex.face_count()).map(component_of));
        let box_of = |own: &[u32]| {
            let mut around: AxisBox = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
            for &face in own {
                for &side in complex.packed_sides().list(face as usize) {
                    for (axis, [least, most]) in around.iter_mut().enumerate() {
                        let [low, high] = predicates.range(axis, complex.side_ends(side)[0]);
                        (*least, *most) = (least.min(low), most.max(high));
                    }
                }
            }
            around
        };
        let boxes: Vec<AxisBox> =
            (0..faces.len()).into_par_iter().map(|component| box_of(faces.list(component))).collect();
        // Divided, so that no sum leaves the range.
        let sizes = boxes.iter().map(|own| own.iter().map(|[low, high]| high / 8.0 - low / 8.0).sum());
        let sizes = sizes.collect();
        let columns = Columns::new(complex, predicates, &faces);
        Self { boxes, sizes, faces, columns }
    }
}

struct Nesting<'a, P> {
    complex: &'a PolygonalComplex,
    predicates: &'a P,
    planes: &'a FacePlanes,
    shells: &'a Shells,
    components: &'a Components,
}

impl<P: SpatialPredicates> Nesting<'_, P> {
    fn parent(&self, component: u32, tree: &BoxTree) -> Result<Option<u32>, Error> {
        let sizes = &self.components.sizes;
        let size = |other: &u32| sizes[*other as usize];
        let vertex = self.shells.anchors[component as usize][0];
        let least = size(&component) / SLACK;
        let mut around = Vec::new();
        tree.visit(&[0, 1, 2].map(|axis| self.predicates.range(axis, vertex)), |other| {
            if other != component && size(&other) >= least {
                around.push(other);
            }
        });
        around.sort_by(|a, b| size(a).total_cmp(&size(b)).then(a.cmp(b)));
        let mut found: Option<(u32, u32)> = None;
        for other in around {
            if found.is_some_and(|(known, _)| size(&other) > size(&known) * SLACK) {
                break;
            }
            let Some(shell) = self.shell_around(component, other)? else { continue };
            // Of two that are as large as each other, the one that is within the other.
            let is_deeper = match found {
                None => true,
                Some((known, _)) => self.shell_around(other, known)?.is_some(),
            };
            if is_deeper {
                found = Some((other, shell));
            }
        }
        Ok(found.map(|(_, shell)| shell))
    }

    /// The shell of another component, not its outer one, that the point of a component lies within.
    fn shell_around(&self, component: u32, other: u32) -> Result<Option<u32>, Error> {
        let Self { complex, predicates, planes, shells, components } = *self;
        let ray = Ray { complex, predicates, planes, near: shells.anchors[component as usize] };
        let mut terms: Vec<(u32, i32)> = Vec::new();
        let mut add = |face: usize| {
            let sign = ray.crossing(face)?;
            // The front is towards the origin of the ray when the crossing is positive: the ray enters what is behind.
            if sign != 0 {
                terms.extend([(shells.shell_of[2 * face], -sign), (shells.shell_of[2 * face + 1], sign)]);
            }
            Ok::<_, Error>(())
        };
        let faces = components.faces.list(other as usize);
        if faces.len() <= FEW_FACES {
            faces.iter().try_for_each(|&face| add(face as usize))?;
        } else {
            components.columns.faces_at(other, predicates, ray.near[0]).into_iter().try_for_each(add)?;
        }
        terms.sort_unstable();
        let mut around = None;
        for own in terms.chunk_by(|x, y| x.0 == y.0) {
            let shell = own[0].0;
            let is_outer = shells.outer[other as usize] == shell;
            match own.iter().map(|&(_, sign)| sign).sum::<i32>() {
                0 => {}
                1 if !is_outer && around.is_none() => around = Some(shell),
                -1 if is_outer => {}
                _ => {
                    return Err(crossing(
                        &format!("the faces at v{}", ray.near[0]),
                        "each other or other faces",
                    ));
                }
            }
        }
        Ok(around)
    }
}

fn crossing(what: &str, other: &str) -> Error {
    Error::invalid(format!("{what} cross {other} elsewhere than in common edges and vertices"))
        .with_cure("cut the faces against each other first")
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

/// Faces by the boxes around them seen along the first axis, in grids that are finer for smaller faces; of components
/// with many faces, each by itself.
struct Columns {
    /// Where coordinates on the other two axes begin, halved, and the larger extent, halved.
    origin: [f64; 2],
    extent: f64,
    /// The component, the place in the grid of a level, and a face, sorted.
    entries: Vec<(u32, u64, u32)>,
}

/// The finest level: at level k the grid has $2^k$ places on each axis.
const FINEST: u32 = 24;

impl Columns {
    fn new(complex: &PolygonalComplex, predicates: &impl SpatialPredicates, faces: &RaggedArray) -> Self {
        let many = (0u32..).zip(faces.iter()).filter(|(_, own)| own.len() > FEW_FACES);
        let many: Vec<(u32, u32)> =
            many.flat_map(|(component, own)| own.iter().map(move |&face| (component, face))).collect();
        let boxes: Vec<[[f64; 2]; 2]> = many
            .par_iter()
            .map(|&(_, face)| {
                let mut own = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
                for &side in complex.packed_sides().list(face as usize) {
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
        for (&(component, face), own) in many.iter().zip(&boxes) {
            let places = [0, 1].map(|axis| own[axis].map(|x| columns.place(axis, x)));
            let size = places.iter().map(|[low, high]| high - low).max().unwrap_or(0);
            // So coarse that the box is in at most two places on each axis.
            let level = FINEST - (u32::BITS - size.leading_zeros()).min(FINEST);
            for_each_key(level, places, |key| entries.push((component, key, face)));
        }
        entries.par_sort_unstable();
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

    /// The faces of a component whose boxes have the vertex in them, or nearly, seen along the first axis.
    fn faces_at(&self, component: u32, predicates: &impl SpatialPredicates, vertex: u32) -> Vec<usize> {
        let places = [0, 1].map(|axis| predicates.range(axis + 1, vertex).map(|x| self.place(axis, x)));
        let mut faces = Vec::new();
        for level in 0..=FINEST {
            for_each_key(level, places, |key| {
                let start = self.entries.partition_point(|entry| (entry.0, entry.1) < (component, key));
                let own =
                    self.entries[start..].iter().take_while(|entry| (entry.0, entry.1) == (component, key));
                faces.extend(own.map(|entry| entry.2 as usize));
            });
        }
        faces.sort_unstable();
        faces.dedup();
        faces
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
