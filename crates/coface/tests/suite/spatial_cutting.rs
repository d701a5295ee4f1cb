//! Triangles cut against each other: known solids, and what must hold for any triangles.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface::arrange::spatial::{
    CutOptions, CutTriangles, SpatialCells, SpatialPredicates, SpatialVertexSource, gift_wrapped_shells,
};
use coface::geometry::Positions;
use coface::topology::homology;
use coface::{ErrorKind, FaceId, VertexId};
use proptest::prelude::*;
use std::cmp::Ordering;

type Point = [f64; 3];

/// Triangles by the coordinates of their corners.
#[derive(Clone, Debug, Default)]
struct Soup {
    points: Vec<Point>,
    triangles: Vec<[u32; 3]>,
}

impl Soup {
    fn of(triangles: impl IntoIterator<Item = [Point; 3]>) -> Self {
        let mut soup = Self::default();
        triangles.into_iter().for_each(|triangle| soup.add(triangle));
        soup
    }

    fn add(&mut self, triangle: [Point; 3]) {
        let first = self.points.len() as u32;
        self.points.extend(triangle);
        self.triangles.push([first, first + 1, first + 2]);
    }

    /// Adds the sides of a box, fronts outward, each as two triangles.
    fn add_box(&mut self, low: Point, high: Point) {
        self.add_moved_box(low, high, |point| point);
    }

    fn add_moved_box(&mut self, low: Point, high: Point, motion: impl Fn(Point) -> Point) {
        for axis in 0..3 {
            let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
            for (x, turned) in [(low[axis], true), (high[axis], false)] {
                let [a, b, c, d] =
                    [[low[i], low[j]], [high[i], low[j]], [high[i], high[j]], [low[i], high[j]]].map(
                        |[u, v]| {
                            let mut point = [x; 3];
                            (point[i], point[j]) = (u, v);
                            motion(point)
                        },
                    );
                for triangle in [[a, b, c], [a, c, d]] {
                    self.add(if turned { [triangle[0], triangle[2], triangle[1]] } else { triangle });
                }
            }
        }
    }

    fn positions(&self) -> Positions {
        Positions::from_flat(3, self.points.concat()).unwrap()
    }

    fn cut(&self) -> CutTriangles {
        CutTriangles::new(&self.positions(), &self.triangles, &CutOptions::default()).unwrap()
    }

    fn corners(&self, triangle: u32) -> [Point; 3] {
        self.triangles[triangle as usize].map(|point| self.points[point as usize])
    }
}

fn minus(a: Point, b: Point) -> Point {
    [0, 1, 2].map(|axis| a[axis] - b[axis])
}

fn cross(a: Point, b: Point) -> Point {
    [0, 1, 2].map(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
}

fn place(cut: &CutTriangles, vertex: u32) -> Point {
    cut.positions().point(VertexId::from_u32(vertex)).try_into().unwrap()
}

/// Decisions about vertices without what is known of planes, lines and orders around edges.
struct Plain<P>(P);

impl<P: SpatialPredicates> SpatialPredicates for Plain<P> {
    fn compare(&self, axis: usize, a: u32, b: u32) -> Ordering {
        self.0.compare(axis, a, b)
    }
    fn normal_sign(&self, axis: usize, triangle: [u32; 3]) -> Ordering {
        self.0.normal_sign(axis, triangle)
    }
    fn orientation(&self, points: [u32; 4]) -> Ordering {
        self.0.orientation(points)
    }
    fn range(&self, axis: usize, vertex: u32) -> [f64; 2] {
        self.0.range(axis, vertex)
    }
}

/// Everything that holds for all soups; the cells.
fn check(soup: &Soup, cut: &CutTriangles) -> SpatialCells {
    let cells = cut.cells().unwrap();
    // Products of boundary matrices are zero; bounded cells are counted by the second homology of the faces.
    let complex = cells.chain_complex().unwrap();
    let betti = homology(&cut.complex().chain_complex().unwrap()).betti_numbers();
    assert_eq!(betti.get(2).copied().unwrap_or(0), cells.cell_count());
    let betti = homology(&complex).betti_numbers();
    assert_eq!(betti.get(2..).map_or(0, |high| high.iter().sum()), 0);
    let wrapped = gift_wrapped_shells(cut.complex().face_count(), cells.radial_order()).unwrap();
    assert_eq!(wrapped.column_count(), cells.shell_count());
    let volumes = cells.volumes(cut.positions()).unwrap();
    assert!(volumes.iter().all(|&volume| volume > 0.0));
    let shells = cells.shell_volumes(cut.positions()).unwrap();
    let outside: f64 = cells.shells(None).iter().map(|&shell| shells[shell as usize]).sum();
    let total: f64 = volumes.iter().sum();
    assert!((total + outside).abs() <= 1e-9 * total.max(1.0));
    // What is known without decisions is what decisions about the vertices of faces find.
    let plain = SpatialCells::with_predicates(cut.complex().clone(), &Plain(cut.predicates())).unwrap();
    assert_eq!(plain.radial_order(), cells.radial_order());
    assert_eq!(plain.cell_boundaries().unwrap(), cells.cell_boundaries().unwrap());
    check_fragments(soup, cut);
    check_points(soup, cut);
    cells
}

/// The fragments of each triangle add up to it.
fn check_fragments(soup: &Soup, cut: &CutTriangles) {
    let mut sums = vec![[0.0; 3]; soup.triangles.len()];
    for face in 0..cut.complex().face_count() {
        let face = FaceId::new(face);
        let mut normal = [0.0; 3];
        let corner = cut.plane(face)[0];
        for (edge, sign) in cut.complex().sides(face) {
            let [a, b] = cut.complex().edges()[edge.index()].map(|end| minus(place(cut, end), corner));
            let term = cross(a, b);
            normal = [0, 1, 2].map(|axis| normal[axis] + f64::from(sign.to_i32()) * term[axis]);
        }
        let triangles = cut.triangles_of_face(face);
        assert!(!triangles.is_empty() && triangles.is_sorted());
        for &packed in triangles {
            let sign = if packed & 1 == 0 { 1.0 } else { -1.0 };
            let sum = &mut sums[packed as usize >> 1];
            *sum = [0, 1, 2].map(|axis| sum[axis] + sign * normal[axis]);
        }
    }
    for (triangle, sum) in sums.iter().enumerate() {
        let [a, b, c] = soup.corners(triangle as u32);
        let normal = cross(minus(b, a), minus(c, a));
        let size = normal.iter().chain(&[1.0]).fold(0.0, |size: f64, x| size.max(x.abs()));
        let miss = minus(*sum, normal);
        assert!(miss.iter().all(|x| x.abs() <= 1e-9 * size), "{triangle}: {sum:?} {normal:?}");
    }
}

/// Vertices are where they say, no two at one place.
fn check_points(soup: &Soup, cut: &CutTriangles) {
    let points: Vec<_> = (0..cut.complex().vertex_count()).map(|v| cut.point(VertexId::new(v))).collect();
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&a, &b| points[a].compare(&points[b]));
    assert!(order.windows(2).all(|pair| points[pair[0]].compare(&points[pair[1]]).is_lt()));
    for (vertex, point) in points.iter().enumerate() {
        assert_eq!(point.rounded(), place(cut, vertex as u32));
        match cut.source(VertexId::new(vertex)) {
            SpatialVertexSource::Given(given) => {
                assert_eq!(point.rounded(), soup.points[given].map(|x| x + 0.0));
                assert_eq!(cut.vertex_of_point()[given] as usize, vertex);
            }
            SpatialVertexSource::Triangles(three) => {
                assert!(three.iter().all(|&t| point.side_of(soup.corners(t as u32)).is_eq()));
            }
            SpatialVertexSource::EdgeAndTriangle(_, triangle) => {
                assert!(point.side_of(soup.corners(triangle as u32)).is_eq());
            }
            SpatialVertexSource::Edges(_) => {}
        }
    }
    // Predicates on vertices are those on points.
    let predicates = cut.predicates();
    for quadruple in order.windows(4) {
        let [a, b, c, d] = [0, 1, 2, 3].map(|i| quadruple[i]);
        let expected = coface::geometry::predicates::orientation_of_points([
            &points[a], &points[b], &points[c], &points[d],
        ]);
        assert_eq!(predicates.orientation([a, b, c, d].map(|v| v as u32)), expected);
    }
}

fn sorted(mut volumes: Vec<f64>) -> Vec<f64> {
    volumes.sort_by(f64::total_cmp);
    volumes
}

fn expect_volumes(soup: &Soup, volumes: &[f64]) {
    let cut = soup.cut();
    let cells = check(soup, &cut);
    let found = sorted(cells.volumes(cut.positions()).unwrap());
    let is_close = |(x, y): (&f64, &f64)| (x - y).abs() <= 1e-12 * y.max(1.0);
    assert!(found.len() == volumes.len() && found.iter().zip(volumes).all(is_close), "{found:?}");
}

#[test]
fn boxes_have_the_known_cells() {
    let boxes = |list: &[([f64; 3], [f64; 3])]| {
        let mut soup = Soup::default();
        list.iter().for_each(|&(low, high)| soup.add_box(low, high));
        soup
    };
    let unit = ([0.0; 3], [1.0; 3]);
    let cube = |low: f64, high: f64| ([low; 3], [high; 3]);
    assert_eq!(boxes(&[unit]).cut().complex().f_vector(), [8, 18, 12]);
    assert_eq!(boxes(&[unit, unit]).cut().complex().f_vector(), [8, 18, 12]);
    expect_volumes(&boxes(&[unit]), &[1.0]);
    expect_volumes(&boxes(&[unit, unit]), &[1.0]);
    expect_volumes(&boxes(&[unit, cube(0.5, 1.5)]), &[0.125, 0.875, 0.875]);
    expect_volumes(&boxes(&[unit, ([1., 0., 0.], [2., 1., 1.])]), &[1.0, 1.0]);
    expect_volumes(&boxes(&[unit, ([1., 0.5, 0.5], [2., 1.5, 1.5])]), &[1.0, 1.0]);
    expect_volumes(&boxes(&[unit, ([1., 1., 0.], [2., 2., 1.])]), &[1.0, 1.0]);
    expect_volumes(&boxes(&[unit, cube(1.0, 2.0)]), &[1.0, 1.0]);
    expect_volumes(&boxes(&[unit, cube(3.0, 4.0)]), &[1.0, 1.0]);
    expect_volumes(&boxes(&[unit, cube(0.25, 0.75)]), &[0.125, 0.875]);
    let rod = ([0.25, 0.25, -1.0], [0.75, 0.75, 2.0]);
    expect_volumes(&boxes(&[unit, rod]), &[0.25, 0.25, 0.25, 0.75]);
    // Thirds: no crossing is exact.
    let third = 1.0 / 3.0;
    expect_volumes(
        &boxes(&[unit, cube(third, 1.0 + third), cube(0.1, 0.4)]),
        &sorted(vec![
            (0.4 - third).powi(3),
            0.027 - (0.4 - third).powi(3),
            (1.0 - third).powi(3) - (0.4 - third).powi(3),
            1.0 - (1.0 - third).powi(3),
            1.0 - (1.0 - third).powi(3) - 0.027 + (0.4 - third).powi(3),
        ]),
    );
}

/// Rotation around an axis, then translation.
fn rotated(point: Point, axis: usize, angle: f64) -> Point {
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut turned = point;
    turned[i] = angle.cos() * point[i] - angle.sin() * point[j];
    turned[j] = angle.sin() * point[i] + angle.cos() * point[j];
    turned
}

#[test]
fn cubes_that_were_moved_overlap_in_the_known_volume() {
    use std::f64::consts::PI;
    let mut soup = Soup::default();
    soup.add_box([0.0; 3], [1.0; 3]);
    soup.add_moved_box([0.0; 3], [1.0; 3], |point| {
        let turned = rotated(rotated(point, 2, PI / 12.0), 0, PI / 5.0);
        [turned[0] + 0.3, turned[1] + 0.4, turned[2] + 0.25]
    });
    // From the intersection of half spaces.
    let common = 0.3559135818288;
    expect_volumes(&soup, &[common, 1.0 - common, 1.0 - common]);
}

#[test]
fn islands_lie_in_the_faces_around_them() {
    // A plate with a grid of posts through it, each post with a smaller one in it, and loose slits beside.
    let mut soup = Soup::default();
    let plate = [[-1., -1., 0.], [61., -1., 0.], [-1., 61., 0.]];
    soup.add(plate);
    let mut posts = 0;
    for i in 0..5 {
        for j in 0..5 {
            let (x, y) = (f64::from(6 * i), f64::from(6 * j));
            soup.add_box([x, y, -1.], [x + 3., y + 3., 1.]);
            soup.add_box([x + 1., y + 1., -2.], [x + 2., y + 2., 2.]);
            soup.add([[x + 4., y + 4., 0.], [x + 5., y + 4., 1.], [x + 4.5, y + 4.5, 1.]]);
            soup.add([[x + 4., y + 0., -1.], [x + 5., y + 0., -1.], [x + 4.5, y + 1., 1.]]);
            posts += 1;
        }
    }
    let cut = soup.cut();
    let cells = check(&soup, &cut);
    // A post has the ends of the inner one outside of it, and halves of both.
    assert_eq!(cells.cell_count(), posts * 6);
    let walls = (0..cut.complex().face_count())
        .map(FaceId::new)
        .filter(|&face| cut.triangles_of_face(face) == [0])
        .map(|face| cut.complex().sides(face).len())
        .collect::<Vec<_>>();
    // What is left of the plate, and in each post a ring with twelve sides (diagonals) and a square.
    assert_eq!(walls.len(), 2 * posts + 1);
    assert!(walls.iter().max().unwrap() > &(posts * 8));
}

#[test]
fn faults_and_oddities_are_named() {
    let positions =
        Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 2., 0., 0., -0., 0., 0.]).unwrap();
    let options = CutOptions::default();
    let cut = CutTriangles::new(&positions, &[[0, 1, 3], [0, 4, 1], [0, 1, 2], [1, 4, 2]], &options).unwrap();
    assert_eq!(cut.degenerate_triangles(), [0, 1]);
    assert_eq!(cut.vertex_of_point(), [0, 1, 2, 3, 0]);
    assert_eq!(cut.complex().f_vector(), [4, 3, 1]);
    assert_eq!(cut.triangles_of_face(FaceId::new(0)), [4, 7]);
    let error = CutTriangles::new(&positions, &[[0, 1, 5]], &options).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::NotInComplex);
    let flat = Positions::from_flat(2, vec![0., 0.]).unwrap();
    assert_eq!(CutTriangles::new(&flat, &[], &options).unwrap_err().kind(), ErrorKind::Shape);
    let nothing = CutTriangles::new(&Positions::default(), &[], &options).unwrap();
    assert_eq!(nothing.complex().f_vector(), [0, 0, 0]);
    assert_eq!(nothing.cells().unwrap().cell_count(), 0);
    let mut soup = Soup::default();
    (0..9).for_each(|i| soup.add_box([0.1 * f64::from(i); 3], [1.0 + f64::from(i); 3]));
    for max_cells in [0, 20, 200, 500] {
        let bounded = CutOptions::new().max_cells(max_cells);
        let error = CutTriangles::new(&soup.positions(), &soup.triangles, &bounded).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::TooLarge);
    }
}

#[test]
fn pencils_and_bundles_of_triangles_meet_in_one_line_and_one_point() {
    // Triangles through one line, none in a given position, and one across.
    let pencil = (0..7).map(|i| {
        let (x, y) = (f64::from(i) - 3.3, 1.0 + 0.7 * f64::from(i % 3));
        [[-x, -y, -3.0], [x, y, -3.0], [0.3 * x, 0.3 * y, 4.0]]
    });
    let mut soup = Soup::of(pencil);
    soup.add([[-9., -9., 0.5], [9., -9., 0.2], [0., 9., 0.7]]);
    let cut = soup.cut();
    check(&soup, &cut);
    // Planes 2x + y = 1 with coordinates exchanged, and x + y + z = 1: all go through (1/3, 1/3, 1/3).
    let mut bundle = Soup::of([[[3., -1., -1.], [-1., 3., -1.], [-1., -1., 3.]]]);
    for [i, j, k] in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
        bundle.add([[-2., -4.], [3., -4.], [0., 6.]].map(|[x, z]| {
            let mut point = [0.0; 3];
            (point[i], point[j], point[k]) = (x, 1.0 - 2.0 * x, z);
            point
        }));
    }
    let cut = bundle.cut();
    check(&bundle, &cut);
    let thirds = (0..cut.complex().vertex_count() as u32).filter(|&v| place(&cut, v) == [1.0 / 3.0; 3]);
    assert_eq!(thirds.count(), 1);
}

#[test]
fn scale_does_not_matter() {
    let mut soup = Soup::default();
    soup.add_box([0.0; 3], [1.0; 3]);
    soup.add_box([0.5; 3], [1.5; 3]);
    soup.add([[-1., -1., -1.], [2., 2., 2.5], [2., 1.5, 2.]]);
    let counts = soup.cut().complex().f_vector();
    for exponent in [-300, 300] {
        let mut moved = soup.clone();
        moved.points.iter_mut().flatten().for_each(|x| *x *= 2f64.powi(exponent));
        assert_eq!(moved.cut().complex().f_vector(), counts);
        assert_eq!(moved.cut().cells().unwrap().cell_count(), soup.cut().cells().unwrap().cell_count());
    }
    // A small cube at a corner of a large one, and one through its face.
    let mut mixed = Soup::default();
    mixed.add_box([0.0; 3], [1e6; 3]);
    mixed.add_box([-1e-6; 3], [1e-6; 3]);
    mixed.add_box([3e5, 3e5, -1e-6], [3e5 + 1e-6, 3e5 + 1e-6, 1e-6]);
    assert_eq!(mixed.cut().cells().unwrap().cell_count(), 5);
}

#[test]
fn threads_do_not_matter() {
    let mut soup = Soup::default();
    (0..40).for_each(|i| {
        let at = |k: i32| f64::from((i * k) % 17) * 0.3;
        soup.add_box([at(3), at(5), at(7)], [at(3) + 2.0, at(5) + 1.7, at(7) + 1.1]);
    });
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| soup.cut())
    };
    let (one, four) = (with(1), with(4));
    assert_eq!(one.complex(), four.complex());
    assert_eq!(one.positions(), four.positions());
    for face in (0..one.complex().face_count()).map(FaceId::new) {
        assert_eq!(one.triangles_of_face(face), four.triangles_of_face(face));
    }
    assert_eq!(one.cells().unwrap().radial_order(), four.cells().unwrap().radial_order());
}

fn integers(n: std::ops::Range<usize>) -> impl Strategy<Value = Vec<[Point; 3]>> {
    let point = || prop::array::uniform3((-2i32..3).prop_map(f64::from));
    prop::collection::vec(prop::array::uniform3(point()), n)
}

/// Triangles of which many are in a few planes.
fn flat_triangles() -> impl Strategy<Value = Vec<[Point; 3]>> {
    let point = prop::array::uniform2((-3i32..4).prop_map(f64::from));
    let triangle = (0usize..4, prop::array::uniform3(point)).prop_map(|(plane, corners)| {
        corners.map(|[u, v]| match plane {
            0 => [u, v, 0.0],
            1 => [u, 0.0, v],
            2 => [u, v, u + v],
            _ => [u, v, 1.0],
        })
    });
    prop::collection::vec(triangle, 2..9)
}

/// Triangles whose corners are no fractions of small numbers.
fn tenths() -> impl Strategy<Value = Vec<[Point; 3]>> {
    let point = || prop::array::uniform3((-20i32..20).prop_map(|x| f64::from(x) * 0.1));
    prop::collection::vec(prop::array::uniform3(point()), 2..9)
}

fn check_soup(triangles: &[[Point; 3]]) {
    let soup = Soup::of(triangles.iter().copied());
    let cut = soup.cut();
    let cells = check(&soup, &cut);
    // The same in another order, with other corners first and some turned around.
    let count = triangles.len();
    let permuted = (0..count).map(|i| {
        let [a, b, c] = triangles[(i * 7 + 3) % count];
        [[b, c, a], [c, b, a], [a, b, c]][i % 3]
    });
    if !count.is_multiple_of(7) {
        let permuted = Soup::of(permuted);
        let again = permuted.cut();
        assert_eq!(again.complex().f_vector(), cut.complex().f_vector());
        let volumes =
            |cut: &CutTriangles, cells: &SpatialCells| sorted(cells.volumes(cut.positions()).unwrap());
        let (x, y) = (volumes(&cut, &cells), volumes(&again, &again.cells().unwrap()));
        assert!(x.len() == y.len() && x.iter().zip(&y).all(|(x, y)| (x - y).abs() <= 1e-12), "{x:?} {y:?}");
    }
    // Axes exchanged and turned around.
    let moved = Soup::of(triangles.iter().map(|own| own.map(|[x, y, z]| [-z, x, 2.0 * y])));
    assert_eq!(moved.cut().complex().f_vector(), cut.complex().f_vector());
    assert_eq!(moved.cut().cells().unwrap().cell_count(), cells.cell_count());
    // Vertices are as they are sorted.
    let new: Vec<_> = (0..cut.complex().vertex_count())
        .map(VertexId::new)
        .filter(|&v| !matches!(cut.source(v), SpatialVertexSource::Given(_)))
        .map(|v| cut.point(v))
        .collect();
    assert!(
        new.windows(2)
            .all(|pair| pair[0].rounded().partial_cmp(&pair[1].rounded()) != Some(Ordering::Greater))
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]
    #[test]
    fn soups_of_small_integers_have_cells(triangles in integers(2..10)) {
        check_soup(&triangles);
    }

    #[test]
    fn soups_in_few_planes_have_cells(triangles in flat_triangles()) {
        check_soup(&triangles);
    }

    #[test]
    fn soups_of_tenths_have_cells(triangles in tenths()) {
        check_soup(&triangles);
    }
}
