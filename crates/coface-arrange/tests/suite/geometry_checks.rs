//! Faults of faces, shells and solids: each code on a small solid, against brute force, and over collections of files
//! that others made.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a helper of a test that cannot go on is the test failing"
)]

use coface_algebra::RaggedArray;
use coface_arrange::spatial::checks::{
    CheckedFaces, CheckedPrimitive, FaultCode, FaultScope, GeometryChecks, GeometryFaults,
};
use coface_geometry::Positions;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Faces with rings, in shells.
#[derive(Clone, Default)]
struct Solid {
    points: Vec<[f64; 3]>,
    faces: Vec<Vec<Vec<u32>>>,
    shells: Option<Vec<u32>>,
}

impl Solid {
    fn new(points: &[[f64; 3]], faces: &[&[u32]]) -> Self {
        let faces = faces.iter().map(|face| vec![face.to_vec()]).collect();
        Self { points: points.to_vec(), faces, shells: None }
    }

    /// A box between two corners.
    fn cuboid(low: [f64; 3], high: [f64; 3]) -> Self {
        let corner = |i: usize| [0, 1, 2].map(|axis| if i >> axis & 1 == 0 { low[axis] } else { high[axis] });
        let points: Vec<[f64; 3]> = (0..8).map(corner).collect();
        Self::new(
            &points,
            &[&[0, 2, 3, 1], &[4, 5, 7, 6], &[0, 1, 5, 4], &[2, 6, 7, 3], &[0, 4, 6, 2], &[1, 3, 7, 5]],
        )
    }

    fn cube() -> Self {
        Self::cuboid([0.0; 3], [1.0; 3])
    }

    fn reversed(mut self) -> Self {
        self.faces.iter_mut().flatten().for_each(|ring| ring.reverse());
        self
    }

    fn push(&mut self, point: [f64; 3]) -> u32 {
        self.points.push(point);
        self.points.len() as u32 - 1
    }

    /// Adds faces of another one, with points of their own.
    fn with(mut self, other: &Self) -> Self {
        let by = self.points.len() as u32;
        self.points.extend(&other.points);
        let moved = |ring: &Vec<u32>| ring.iter().map(|vertex| vertex + by).collect();
        self.faces.extend(other.faces.iter().map(|face| face.iter().map(moved).collect::<Vec<_>>()));
        self
    }

    /// The same with given shells: the outer one, and those of voids.
    fn with_voids(self, voids: &[&Self]) -> Self {
        let mut shells = vec![0; self.faces.len()];
        let mut whole = self;
        for (void, number) in voids.iter().zip(1..) {
            shells.resize(shells.len() + void.faces.len(), number);
            whole = whole.with(void);
        }
        Self { shells: Some(shells), ..whole }
    }

    /// A hole in a face, by points.
    fn with_hole(mut self, face: usize, hole: &[[f64; 3]]) -> Self {
        let ring = hole.iter().map(|&point| self.push(point)).collect();
        self.faces[face].push(ring);
        self
    }

    fn check(&self) -> GeometryFaults {
        let flat = self.points.concat();
        let rings = RaggedArray::from_lists(self.faces.iter().flatten());
        let face_of_ring: Vec<u32> =
            self.faces.iter().zip(0..).flat_map(|(face, f)| face.iter().map(move |_| f)).collect();
        let mut faces = CheckedFaces::from_rings(rings, &face_of_ring).unwrap();
        if let Some(shells) = &self.shells {
            let count = shells.iter().max().map_or(0, |&last| last as usize + 1);
            faces = faces.with_shells(shells.clone(), vec![0; count]).unwrap();
        }
        GeometryChecks::new().check(&Positions::from_flat(3, flat).unwrap(), &faces).unwrap()
    }

    fn numbers(&self) -> Vec<u16> {
        numbers(&self.check())
    }
}

fn numbers(found: &GeometryFaults) -> Vec<u16> {
    let mut numbers: Vec<u16> = found.faults().iter().map(|fault| fault.code().number()).collect();
    numbers.dedup();
    numbers
}

/// The top of [`Solid::cube`], seen from above counterclockwise: 4, 5, 7, 6.
const TOP: usize = 1;

#[test]
fn sound_solids_have_no_fault() {
    let cube = Solid::cube();
    assert!(cube.check().is_valid_solid());
    let inner = Solid::cuboid([0.25; 3], [0.75; 3]).reversed();
    assert_eq!(cube.clone().with(&inner).numbers(), [0; 0]);
    assert_eq!(cube.clone().with_voids(&[&inner]).numbers(), [0; 0]);
    // A void that touches the outer shell in a vertex, and one that touches another along an edge.
    let spike = Solid::new(
        &[[0.3, 0.3, 0.5], [0.7, 0.3, 0.5], [0.5, 0.7, 0.5], [0.5, 0.5, 1.0]],
        &[&[0, 1, 2], &[0, 3, 1], &[1, 3, 2], &[2, 3, 0]],
    );
    assert_eq!(cube.clone().with_voids(&[&spike]).numbers(), [0; 0]);
    assert_eq!(cube.clone().with(&spike).numbers(), [0; 0]);
    let low = Solid::cuboid([0.1; 3], [0.5; 3]).reversed();
    let high = Solid::cuboid([0.5, 0.1, 0.5], [0.9, 0.5, 0.9]).reversed();
    assert_eq!(cube.clone().with_voids(&[&low, &high]).numbers(), [0; 0]);
    // Each face with vertices of its own.
    let mut apart = Solid::default();
    for face in &cube.faces {
        apart = apart.with(&Solid { faces: vec![face.clone()], ..cube.clone() });
    }
    assert_eq!(apart.numbers(), [0; 0]);
    // A frame: a face with a hole on either side.
    let frame = frame();
    assert!(frame.check().is_valid_solid(), "{:?}", frame.check());
}

/// A cube with a square channel along z.
fn frame() -> Solid {
    let low = [[0.25, 0.25, 0.], [0.25, 0.75, 0.], [0.75, 0.75, 0.], [0.75, 0.25, 0.]];
    let high = low.map(|[x, y, _]| [x, y, 1.]);
    let mut frame = Solid::cube();
    frame.points.extend(low);
    frame.points.extend(high);
    // The bottom runs clockwise seen from above, its hole the other way.
    frame.faces[0].push(vec![11, 10, 9, 8]);
    frame.faces[TOP].push(vec![12, 13, 14, 15]);
    for i in 0..4 {
        let j = (i + 1) % 4;
        frame.faces.push(vec![vec![8 + i, 8 + j, 12 + j, 12 + i]]);
    }
    frame
}

#[test]
fn faults_of_rings() {
    let cube = Solid::cube();
    // 101: the top is a line of two points.
    let mut line = cube.clone();
    line.faces[TOP] = vec![vec![4, 7]];
    assert_eq!(line.numbers(), [101, 302]);
    // 102: a point of a side stands twice, as one vertex or as two.
    let mut twice = cube.clone();
    twice.faces[TOP] = vec![vec![4, 5, 5, 7, 6]];
    assert_eq!(twice.numbers(), [102]);
    // 104: a bow tie, a spike, a ring that comes back to a vertex.
    let mut tie = cube.clone();
    tie.faces[TOP] = vec![vec![4, 5, 6, 7]];
    assert!(tie.numbers().contains(&104));
    assert_eq!(tie.check().faults()[0].code(), FaultCode::RingCrosses);
    let mut spike = cube.clone();
    let middle = spike.push([0.5, 0.5, 1.0]);
    spike.faces[TOP] = vec![vec![4, middle, 4, 5, 7, 6]];
    assert!(spike.numbers().contains(&104), "{:?}", spike.check());
    let mut flat = cube;
    let middle = flat.push([0.5, 0.0, 1.0]);
    flat.faces.push(vec![vec![4, middle, 5]]);
    assert_eq!(flat.check().faults()[0].code(), FaultCode::RingWithoutArea);
}

#[test]
fn faults_of_faces() {
    let square = |x: f64, y: f64, size: f64| [[x, y], [x, y + size], [x + size, y + size], [x + size, y]];
    let hole = |x: f64, y: f64, size: f64| square(x, y, size).map(|[x, y]| [x, y, 1.0]);
    let top = Solid { faces: vec![Solid::cube().faces[TOP].clone()], ..Solid::cube() };
    let codes =
        |solid: &Solid| -> Vec<u16> { solid.numbers().into_iter().filter(|code| *code < 300).collect() };
    assert_eq!(codes(&top.clone().with_hole(0, &hole(0.2, 0.2, 0.3))), [0; 0]);
    assert_eq!(codes(&top.clone().with_hole(0, &hole(0.8, 0.2, 0.3))), [201]);
    let two = top.clone().with_hole(0, &hole(0.2, 0.2, 0.3));
    assert_eq!(codes(&two.clone().with_hole(0, &hole(0.2, 0.2, 0.3))), [202]);
    assert_eq!(codes(&two.clone().with_hole(0, &hole(0.4, 0.4, 0.3))), [201]);
    // Side by side: a part of a side is shared.
    assert_eq!(codes(&two.clone().with_hole(0, &hole(0.5, 0.3, 0.3))), [201]);
    assert_eq!(codes(&two.clone().with_hole(0, &hole(0.5, 0.5, 0.3))), [0; 0]);
    assert_eq!(codes(&two.with_hole(0, &hole(0.3, 0.3, 0.1))), [207]);
    assert_eq!(codes(&top.clone().with_hole(0, &hole(1.2, 0.2, 0.3))), [206]);
    let mut same_way = hole(0.2, 0.2, 0.3);
    same_way.reverse();
    assert_eq!(codes(&top.clone().with_hole(0, &same_way)), [208]);
    // 205: a triangle whose corners touch three sides.
    let corners = [[0.5, 0., 1.], [0., 0.5, 1.], [1., 0.5, 1.]];
    assert_eq!(codes(&top.with_hole(0, &corners)), [205]);
    // 203 and 204: a corner that is raised, a fold of little height.
    let mut raised = Solid::cube();
    raised.points[7][2] = 1.2;
    assert_eq!(raised.numbers(), [203]);
    let place = raised.check().faults()[0].places()[0].clone();
    assert!(place.distance.is_some_and(|distance| (0.04..0.06).contains(&distance)), "{place:?}");
    assert_eq!(raised.check().faults()[0].scope(), FaultScope::Solid);
    let mut fold = Solid::new(
        &[[0., 0., 0.], [1., 0., 0.], [1., 0.499, 0.001], [1., 0.501, -0.001], [1., 1., 0.], [0., 1., 0.]],
        &[&[0, 1, 2, 3, 4, 5, 6, 7]],
    );
    fold.push([0., 0.501, -0.001]);
    fold.push([0., 0.499, 0.001]);
    assert_eq!(codes(&fold), [204]);
    // Rounding makes no fold, and no face that is not flat.
    let (sine, cosine) = 0.3f64.sin_cos();
    let mut turned = frame();
    for point in &mut turned.points {
        let [x, y, z] = *point;
        let (x, z) = (cosine * x - sine * z, sine * x + cosine * z);
        *point = [cosine * x - sine * y, sine * x + cosine * y, z];
    }
    assert_eq!(turned.numbers(), [0; 0]);
}

#[test]
fn faults_of_shells() {
    let cube = Solid::cube();
    let pillow = Solid::new(&[[0.; 3], [1., 0., 0.], [0., 1., 0.]], &[&[0, 1, 2], &[0, 2, 1]]);
    assert_eq!(pillow.numbers(), [301, 306]);
    let mut open = cube.clone();
    open.faces.pop();
    let found = open.check();
    assert_eq!((numbers(&found), found.faults()[0].count()), (vec![302], 4));
    assert!(found.is_sound_surface() && !found.is_valid_solid());
    // 303: two cubes with one vertex in common; 304: with one edge.
    let corner = Solid::cuboid([1.0; 3], [2.0; 3]);
    let mut joined = cube.clone().with(&corner);
    for vertex in joined.faces[6..].iter_mut().flatten().flatten() {
        if *vertex == 8 {
            *vertex = 7;
        }
    }
    assert_eq!(joined.numbers(), [303]);
    let beside = Solid::cuboid([1.0, 1.0, 0.0], [2.0, 2.0, 1.0]);
    let mut joined = cube.clone().with(&beside);
    for vertex in joined.faces[6..].iter_mut().flatten().flatten() {
        match *vertex {
            8 => *vertex = 3,
            12 => *vertex = 7,
            _ => {}
        }
    }
    assert_eq!(joined.numbers(), [304]);
    // 305: a cube elsewhere; with vertices of its own it is another solid.
    let far = Solid::cuboid([2.0; 3], [3.0; 3]);
    let found = cube.clone().with(&far).check();
    assert_eq!((numbers(&found), found.is_sound_surface()), (vec![305], true));
    // 306: a roof whose top is below the floor, or on it.
    for (height, code) in [(-0.5, FaultCode::FacesCross), (0.0, FaultCode::FacesTouch)] {
        let mut house = cube.clone();
        let tip = house.push([0.5, 0.5, height]);
        house.faces[TOP] = vec![vec![4, 5, tip]];
        house.faces.extend([[5, 7], [7, 6], [6, 4]].map(|[a, b]| vec![vec![a, b, tip]]));
        let found = house.check();
        assert_eq!(numbers(&found), [306], "{found:?}");
        assert_eq!(found.faults()[0].code(), code);
        assert_eq!(found.is_sound_surface(), code == FaultCode::FacesTouch);
    }
    // 307: one face is turned over; one-sided surfaces are too.
    let mut turned = cube.clone();
    turned.faces[TOP][0].reverse();
    let found = turned.check();
    assert_eq!((numbers(&found), &found.faults()[0].places()[0].faces[..]), (vec![307], &[TOP as u32][..]));
    assert_eq!(cube.reversed().numbers(), [405]);
}

#[test]
fn faults_of_solids() {
    let cube = Solid::cube();
    let void = |low: [f64; 3], high: [f64; 3]| Solid::cuboid(low, high).reversed();
    let middle = void([0.25; 3], [0.75; 3]);
    let whole = |voids: &[&Solid]| cube.clone().with_voids(voids);
    assert_eq!(whole(&[&void([0.5; 3], [1.5; 3])]).numbers(), [401]);
    // A part of a face is shared, from inside, and from outside.
    assert_eq!(whole(&[&void([0.2, 0.2, 0.5], [0.8, 0.8, 1.0])]).numbers(), [401]);
    assert_eq!(whole(&[&void([0.2, 0.2, 1.0], [0.8, 0.8, 1.5])]).numbers(), [401]);
    // Crossing in a way that no inside of a face is crossed: a cube turned about the same middle by half a right angle
    // would; here an octahedron whose corners are on the faces, and one whose edges run through those of the cube.
    let octahedron = |r: f64| {
        let points: Vec<[f64; 3]> =
            [[-r, 0., 0.], [r, 0., 0.], [0., -r, 0.], [0., r, 0.], [0., 0., -r], [0., 0., r]]
                .map(|p| p.map(|x| x + 0.5))
                .to_vec();
        let faces: [&[u32]; 8] =
            [&[0, 2, 5], &[2, 1, 5], &[1, 3, 5], &[3, 0, 5], &[2, 0, 4], &[1, 2, 4], &[3, 1, 4], &[0, 3, 4]];
        Solid::new(&points, &faces).reversed()
    };
    assert_eq!(whole(&[&octahedron(0.5)]).numbers(), [0; 0]);
    assert_eq!(whole(&[&octahedron(1.0)]).numbers(), [401]);
    assert_eq!(whole(&[&middle, &middle]).numbers(), [402]);
    assert_eq!(whole(&[&void([2.0; 3], [3.0; 3])]).numbers(), [403]);
    assert_eq!(whole(&[&middle, &void([0.4; 3], [0.6; 3])]).numbers(), [401]);
    assert_eq!(whole(&[&middle.clone().reversed()]).numbers(), [405]);
    assert_eq!(cube.clone().with(&middle.clone().reversed()).numbers(), [405]);
    // A void is one in a shell that is pinched: two cubes on one edge have that.
    let mut pair = cube.clone();
    for [x, y, z] in [[2., 1., 0.], [1., 2., 0.], [2., 2., 0.], [2., 1., 1.], [1., 2., 1.], [2., 2., 1.]] {
        pair.push([x, y, z]);
    }
    let beside = [3, 8, 9, 10, 7, 11, 12, 13];
    for face in &cube.faces {
        let moved = |ring: &Vec<u32>| ring.iter().map(|&vertex| beside[vertex as usize]).collect();
        pair.faces.push(face.iter().map(moved).collect());
    }
    assert!(pair.numbers().contains(&304));
    assert_eq!(pair.clone().with(&middle).numbers(), pair.numbers());
    assert!(pair.clone().with(&void([3.0; 3], [4.0; 3])).numbers().contains(&405));
    // 404: a pyramid on four edges of the cube.
    let mut wedge = Solid::new(
        &[[0., 0., 0.1], [1., 0., 0.1], [1., 1., 0.1], [0., 1., 0.1], [0.5, 0.5, 0.5]],
        &[&[0, 3, 2, 1], &[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]],
    )
    .reversed();
    assert_eq!(whole(&[&wedge]).numbers(), [404]);
    assert_eq!(cube.clone().with(&wedge).numbers(), [404]);
    wedge.points[0][2] = 0.2;
    wedge.points[0][0] = 0.1;
    assert_ne!(whole(&[&wedge]).numbers(), [404]);
}

/// A cube whose top is two triangles, and one of these is cut at the middle of the diagonal: three edges of one face each,
/// and the middle is inside of one of them.
#[test]
fn a_vertex_inside_an_edge_is_named_with_its_place() {
    let mut cube = Solid::cube();
    let middle = cube.push([0.5, 0.5, 1.0]);
    cube.faces[TOP] = vec![vec![4, 5, 7]];
    cube.faces.extend([vec![vec![4, middle, 6]], vec![vec![middle, 7, 6]]]);
    let found = cube.check();
    let inside: Vec<_> =
        found.faults().iter().filter(|fault| fault.code() == FaultCode::VertexInsideEdge).collect();
    assert_eq!((numbers(&found), inside.len(), inside[0].count()), (vec![302], 1, 1));
    let place = &inside[0].places()[0];
    assert_eq!((place.vertices[0], place.point), (middle, Some([0.5, 0.5, 1.0])));
    assert_eq!((place.faces[0], inside[0].scope()), (TOP as u32, FaultScope::Surface));
    assert!(!found.is_sound_surface());
    // The same by brute force: the vertices that are on a segment of one face, exactly.
    let on_segment = |p: [f64; 3], [a, b]: [[f64; 3]; 2]| {
        let [u, v] = [0, 1].map(|i| if i == 0 { minus(b, a) } else { minus(p, a) });
        let is_in_line = (0..3).all(|i| u[i] * v[(i + 1) % 3] == u[(i + 1) % 3] * v[i]);
        let part = (0..3).map(|i| u[i] * v[i]).sum::<f64>();
        is_in_line && part > 0.0 && part < u.iter().map(|x| x * x).sum::<f64>()
    };
    let mut pairs = 0;
    for face in cube.faces.iter().flatten() {
        for (i, &from) in face.iter().enumerate() {
            let ends = [from, face[(i + 1) % face.len()]].map(|v| cube.points[v as usize]);
            pairs += cube.points.iter().filter(|&&p| on_segment(p, ends)).count();
        }
    }
    assert_eq!(pairs, 1);
    // With the vertex in all faces there, the cube is closed.
    cube.faces[TOP] = vec![vec![4, 5, 7, middle]];
    assert!(cube.check().is_valid_solid());
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|axis| a[axis] - b[axis])
}

/// The faults of several solids, each with what it is stated to be.
fn of_primitives(solids: &[(&Solid, CheckedPrimitive)]) -> (Vec<u16>, GeometryFaults) {
    let mut whole = Solid::default();
    let (mut shell_of_face, mut solid_of_shell) = (Vec::new(), Vec::new());
    for (number, (solid, _)) in (0..).zip(solids) {
        let own = solid.shells.clone().unwrap_or_else(|| vec![0; solid.faces.len()]);
        let first = solid_of_shell.len() as u32;
        let count = own.iter().max().map_or(0, |&last| last as usize + 1);
        solid_of_shell.resize(solid_of_shell.len() + count, number);
        shell_of_face.extend(own.iter().map(|shell| shell + first));
        whole = whole.with(solid);
    }
    let rings = RaggedArray::from_lists(whole.faces.iter().flatten());
    let face_of_ring: Vec<u32> =
        whole.faces.iter().zip(0..).flat_map(|(face, f)| face.iter().map(move |_| f)).collect();
    let faces = CheckedFaces::from_rings(rings, &face_of_ring).unwrap();
    let faces = faces.with_shells(shell_of_face, solid_of_shell).unwrap();
    let faces = faces.with_primitives(solids.iter().map(|(_, primitive)| *primitive).collect()).unwrap();
    let positions = Positions::from_flat(3, whole.points.concat()).unwrap();
    let found = GeometryChecks::new().check(&positions, &faces).unwrap();
    (numbers(&found), found)
}

#[test]
fn solids_of_a_composite_touch_in_faces_and_nowhere_else() {
    use CheckedPrimitive::{CompositeSolid, MultiSurface, Solid as Alone};
    let cube = Solid::cube();
    let moved = |by: [f64; 3]| Solid::cuboid(by, by.map(|x| x + 1.0));
    let (half, beside, at_edge, far) =
        (moved([0.5, 0.0, 0.0]), moved([1.0, 0.0, 0.0]), moved([1.0, 1.0, 0.0]), moved([5.0; 3]));
    let pair = |other: &Solid, primitive| of_primitives(&[(&cube, primitive), (other, primitive)]).0;
    for (other, expected) in [(&half, 501), (&cube, 502), (&at_edge, 503), (&far, 503)] {
        assert_eq!(pair(other, CompositeSolid(0)), [expected]);
        assert_eq!(pair(other, Alone), [0; 0]);
        let apart = of_primitives(&[(&cube, CompositeSolid(0)), (other, CompositeSolid(1))]);
        assert!(apart.0.is_empty() && apart.1.is_valid_solid());
    }
    assert_eq!(pair(&beside, CompositeSolid(0)), [0; 0]);
    // A part of a face is enough; a chain of solids connects its ends; a solid fits into the void of another.
    assert_eq!(pair(&moved([1.0, 0.5, 0.5]), CompositeSolid(0)), [0; 0]);
    let last = moved([2.0, 0.0, 0.0]);
    let chain = [&cube, &beside, &last].map(|own| (own, CompositeSolid(3)));
    assert_eq!(of_primitives(&chain).0, [0; 0]);
    let low = Solid::cuboid([0.25; 3], [0.75; 3]);
    let hollow = cube.clone().with_voids(&[&low.clone().reversed()]);
    let nested = |own: &Solid| of_primitives(&[(&hollow, CompositeSolid(0)), (own, CompositeSolid(0))]).0;
    assert_eq!(nested(&low), [0; 0]);
    assert_eq!(nested(&Solid::cuboid([0.4; 3], [0.6; 3])), [503]);
    assert_eq!(nested(&Solid::cuboid([0.2; 3], [0.6; 3])), [501]);
    // A solid at fault is not compared with others.
    let mut open = half;
    open.faces.pop();
    assert_eq!(pair(&open, CompositeSolid(0)), [302]);
    // Faces of a multi-surface may cross and touch; they bound nothing.
    let (codes, found) = of_primitives(&[(&cube, MultiSurface), (&open, MultiSurface)]);
    assert!(codes.is_empty() && !found.is_valid_solid());
    let mut crossing = cube.clone();
    let tip = crossing.push([0.5, 0.5, -0.5]);
    crossing.faces[TOP] = vec![vec![4, 5, tip]];
    assert_eq!(of_primitives(&[(&crossing, MultiSurface)]).0, [0; 0]);
    assert_eq!(of_primitives(&[(&crossing, CheckedPrimitive::CompositeSurface)]).0, [306]);
    assert_eq!(of_primitives(&[(&open, CheckedPrimitive::CompositeSurface)]).0, [0; 0]);
}

/// Rows and blocks of many boxes, and boxes in boxes, have the counts that are known.
#[test]
fn many_shells_are_counted() {
    let mut row = Solid::default();
    let mut dolls = Solid::default();
    for i in 0..60 {
        let x = f64::from(i);
        row = row.with(&Solid::cuboid([2.0 * x, 0.0, 0.0], [2.0 * x + 1.0, 1.0, 1.0]));
        let doll = Solid::cuboid([x / 128.0; 3], [1.0 - x / 128.0; 3]);
        dolls = dolls.with(&if i % 2 == 1 { doll.reversed() } else { doll });
    }
    let found = row.check();
    assert_eq!((numbers(&found), found.faults()[0].count()), (vec![305], 59));
    // Every second one is a solid in the void of another.
    let found = dolls.check();
    assert_eq!((numbers(&found), found.faults()[0].count()), (vec![305], 29));
}

#[test]
fn the_table_of_codes_is_whole() {
    let page = include_str!("../../../../docs/geometry-checks.md");
    let rows: Vec<[&str; 2]> = page
        .lines()
        .filter_map(|line| line.strip_prefix("| ")?.split_once(" | `"))
        .filter_map(|(number, rest)| Some([number, rest.split('`').next()?]))
        .collect();
    let codes: Vec<[String; 2]> =
        FaultCode::ALL.iter().map(|code| [code.number().to_string(), code.name().to_owned()]).collect();
    assert_eq!(rows, codes);
}

/// Where the collection of the program val3dity is (github.com/tudelft3d/val3dity, GPL 3; its folder `data`).
fn collection() -> Option<PathBuf> {
    let folder = std::env::var_os("COFACE_VAL3DITY").map(PathBuf::from);
    if folder.is_none() {
        println!("skipped: COFACE_VAL3DITY names no folder");
    }
    folder
}

/// A solid of a `.poly`, `.obj`, `.off` or `.gml` file of the collection.
fn read(path: &Path) -> Solid {
    let text = std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut solid = Solid::default();
    let extension = path.extension().and_then(|extension| extension.to_str()).unwrap();
    let words = || text.lines().map(|line| line.split_whitespace().collect::<Vec<&str>>());
    let numbers =
        |words: &[&str]| -> Vec<f64> { words.iter().filter_map(|word| word.parse().ok()).collect() };
    let point = |n: &[f64]| [n[0], n[1], n[2]];
    match extension {
        "obj" => {
            for line in words() {
                match line[..] {
                    ["v", ref rest @ ..] => solid.points.push(point(&numbers(rest))),
                    ["f", ref rest @ ..] => {
                        let index = |word: &&str| word.split('/').next().unwrap().parse::<u32>().unwrap() - 1;
                        solid.faces.push(vec![rest.iter().map(index).collect()]);
                    }
                    _ => {}
                }
            }
        }
        "off" => {
            let mut tokens =
                text.lines().filter(|line| !line.starts_with('#')).flat_map(str::split_whitespace);
            assert_eq!(tokens.next(), Some("OFF"));
            let mut next = || tokens.next().unwrap().parse::<f64>().unwrap();
            let (vertices, faces) = (next() as usize, next() as usize);
            next();
            solid.points = (0..vertices).map(|_| [next(), next(), next()]).collect();
            solid.faces = (0..faces)
                .map(|_| {
                    let count = next() as usize;
                    vec![(0..count).map(|_| next() as u32).collect()]
                })
                .collect();
        }
        "gml" => {
            for polygon in text.split("<gml:Polygon").skip(1) {
                let mut rings = Vec::new();
                for ring in polygon.split("<gml:LinearRing").skip(1) {
                    let cut = ring.split("</gml:LinearRing").next().unwrap();
                    let clean: String = cut
                        .split('<')
                        .map(|piece| piece.split_once('>').map_or("", |(_, rest)| rest))
                        .collect::<Vec<_>>()
                        .join(" ");
                    let values = numbers(&clean.split_whitespace().collect::<Vec<_>>());
                    let mut own: Vec<[f64; 3]> = values.chunks(3).map(point).collect();
                    own.pop();
                    rings.push(own.into_iter().map(|p| solid.push(p)).collect());
                }
                solid.faces.push(rings);
            }
        }
        _ => {
            let mut lines = words().filter(|line| !line.is_empty());
            let mut next = || numbers(&lines.next().unwrap());
            let count = next()[0] as usize;
            let mut ids = BTreeMap::new();
            for vertex in 0..count {
                let line = next();
                ids.insert(line[0] as i64, vertex as u32);
                solid.points.push(point(&line[1..]));
            }
            let faces = next()[0] as usize;
            for _ in 0..faces {
                let head = next();
                let ring = |line: Vec<f64>| {
                    line[1..=line[0] as usize].iter().map(|&id| ids[&(id as i64)]).collect::<Vec<u32>>()
                };
                let rings = (0..head[0] as usize).map(|_| ring(next())).collect();
                (0..head.get(1).map_or(0, |&holes| holes as usize)).for_each(|_| drop(next()));
                solid.faces.push(rings);
            }
        }
    }
    solid
}

/// The faulty solids of the collection, each with the codes that its tests accept. Voids stand behind a plus sign and
/// belong to the cube of its folder of valid solids. Where its present edition has one number, 303, for edges and
/// vertices, both are accepted here.
const FAULTY: &[(&str, &[u16])] = &[
    ("101.poly", &[101]),
    ("102.poly", &[102]),
    ("104.poly", &[104]),
    ("104_1.poly", &[104]),
    ("104_2.poly", &[104]),
    ("104_3.poly", &[104]),
    ("104_4.poly", &[104]),
    ("201.poly", &[201]),
    ("201_1.poly", &[201]),
    ("202.poly", &[202]),
    ("203.poly", &[203]),
    ("203_1.poly", &[203]),
    ("203_2.poly", &[203]),
    ("204_1.poly", &[204]),
    ("205.poly", &[205]),
    ("206.poly", &[206]),
    ("206_1.poly", &[206, 201]),
    ("207.poly", &[207]),
    ("207_1.poly", &[207]),
    ("208.poly", &[208]),
    ("301.poly", &[301]),
    ("301_1.poly", &[301]),
    ("302.poly", &[302]),
    ("302_1.poly", &[302]),
    ("302_2.gml", &[302]),
    ("303.poly", &[303]),
    ("303_1.poly", &[303]),
    ("303_2.poly", &[303, 304]),
    ("303_cs.poly", &[302]),
    ("304_1.poly", &[303, 304]),
    ("304_2.obj", &[303, 304]),
    ("305.poly", &[305]),
    ("305_1.poly", &[305]),
    ("306.poly", &[306]),
    ("306_1.poly", &[306]),
    ("307.poly", &[307]),
    ("307_1.poly", &[307]),
    ("+401.poly", &[401]),
    ("+401_1.poly", &[401]),
    ("+401_2.poly+inner_shell.poly", &[401]),
    ("+401_3.poly+inner_shell.poly", &[401]),
    ("+401_4.poly", &[401]),
    ("+401_5.poly", &[401]),
    ("+401_6.poly", &[401]),
    ("+402_in_1.poly+inner_shell.poly", &[401, 402]),
    ("+403.poly", &[403]),
    ("+404.poly", &[404]),
    ("405.poly", &[405]),
];

/// The valid solids of the collection.
const VALID: &[&str] = &[
    "test_geometry_generic/204_valid_1.poly",
    "test_geometry_generic/204_valid_2.poly",
    "test_valid/basecube.obj",
    "test_valid/basecube.off",
    "test_valid/basecube.poly",
    "test_valid/basecube_large_coords.poly",
    "test_valid/closed_top.poly",
    "test_valid/nearly-collinear.off",
    "test_valid/self_fold.obj",
    "test_valid/v405.off",
    "+test_valid/inner_shell.poly",
    "+test_valid/inner_shell_1.poly",
    "+test_valid/inner_shell_2.poly+test_valid/inner_shell.poly",
    "+test_valid/inner_shell_3.poly+test_valid/inner_shell.poly",
    "+test_valid/inner_shell_4.poly+test_valid/inner_shell.poly",
];

fn named(data: &Path, folder: &str, name: &str) -> Solid {
    let mut parts = name.split('+');
    let first = parts.next().unwrap();
    if name.starts_with('+') {
        let voids: Vec<Solid> = parts.map(|part| read(&data.join(folder).join(part))).collect();
        let outer = read(&data.join("test_valid/basecube.poly"));
        outer.with_voids(&voids.iter().collect::<Vec<_>>())
    } else {
        read(&data.join(folder).join(first))
    }
}

#[test]
fn faults_of_a_published_collection_are_named() {
    let Some(data) = collection() else { return };
    let mut missed = Vec::new();
    for &(name, codes) in FAULTY {
        let found = named(&data, "test_geometry_generic", name).check();
        println!("{name}: {:?}", numbers(&found));
        if !numbers(&found).iter().any(|number| codes.contains(number)) {
            missed.push((name, numbers(&found)));
        }
    }
    for name in VALID {
        let found = named(&data, "", name).check();
        println!("{name}: {:?}", numbers(&found));
        if !found.is_valid_solid() {
            missed.push((name, numbers(&found)));
        }
    }
    assert!(missed.is_empty(), "{missed:?}");
}
