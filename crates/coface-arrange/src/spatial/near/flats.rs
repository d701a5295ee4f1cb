//! Triangles that a flat face of an input was cut into.

use super::super::flat_polygons::{explained_deviations, first_equal_points};
use crate::near::{minus, plus, squared};
use crate::spatial::SpatialPolygons;
use coface_geometry::{cross, dot};
use std::collections::{BTreeSet, VecDeque};

/// For each polygon the first one of the flat face that it is a part of; itself unless it is a triangle.
///
/// Triangles of one input are of one face where they run along a common side in opposite directions, no other polygon of the input has
/// that side, and all are in one plane but for what rounding of their coordinates explains. The diagonals between them are none of the
/// features of the input. Triangles of one surface, as of a face with holes, are of one face too where all its corners are within
/// `tolerance` of a plane.
///
/// # Complexity
/// $O(n \log n)$ for n sides.
pub(in crate::spatial) fn flat_faces(polygons: &SpatialPolygons, tolerance: f64) -> Vec<u32> {
    let mut first_of: Vec<u32> = (0..polygons.polygon_count() as u32).collect();
    let points = polygons.positions().as_flat().as_chunks::<3>().0;
    let first_equal = first_equal_points(polygons.positions());
    let inputs = polygons.input_of_polygon();
    let mut walk_counts = vec![0u32; polygons.polygon_count()];
    polygons.polygon_of_walk().iter().for_each(|&polygon| walk_counts[polygon as usize] += 1);
    let mut corners: Vec<Option<[u32; 3]>> = vec![None; polygons.polygon_count()];
    // By input and ends: the polygon, and whether it runs from the lower end to the higher.
    let mut sides: Vec<(u32, [u32; 2], u32, bool)> = Vec::with_capacity(polygons.walks().item_count());
    for (walk, &polygon) in polygons.walks().iter().zip(polygons.polygon_of_walk()) {
        let own: Vec<u32> = walk.iter().map(|&corner| first_equal[corner as usize]).collect();
        for (&a, &b) in own.iter().zip(own.iter().cycle().skip(1)).filter(|(a, b)| a != b) {
            sides.push((inputs[polygon as usize], [a.min(b), a.max(b)], polygon, a < b));
        }
        if let [a, b, c] = own[..]
            && walk_counts[polygon as usize] == 1
        {
            corners[polygon as usize] = Some([a, b, c]);
        }
    }
    sides.sort_unstable();
    let mut neighbors: Vec<[u32; 2]> = Vec::new();
    for same in sides.chunk_by(|x, y| (x.0, x.1) == (y.0, y.1)) {
        if let [(.., f, up), (.., g, down)] = *same
            && up != down
            && corners[f as usize].is_some()
            && corners[g as usize].is_some()
        {
            neighbors.extend([[f, g], [g, f]]);
        }
    }
    neighbors.sort_unstable();
    let normal = |[a, b, c]: [u32; 3]| {
        let [a, b, c] = [a, b, c].map(|corner| points[corner as usize]);
        cross(minus(b, a), minus(c, a))
    };
    let mut order: Vec<(f64, u32)> =
        (0..).zip(&corners).filter_map(|(polygon, own)| Some((squared(normal((*own)?)), polygon))).collect();
    order.retain(|&(area, _)| area > 0.0);
    order.sort_unstable_by(|x, y| y.0.total_cmp(&x.0).then(x.1.cmp(&y.1)));
    let rounding = explained_deviations(polygons);
    let flat_surfaces = flat_surfaces(polygons, &corners, tolerance);
    let surface = |polygon: u32| {
        let own = polygons.surface_of(polygon)?;
        flat_surfaces.contains(&(inputs[polygon as usize], own)).then_some(own)
    };
    let mut is_taken = vec![false; corners.len()];
    let mut due = VecDeque::new();
    for (area, seed) in order {
        if std::mem::replace(&mut is_taken[seed as usize], true) {
            continue;
        }
        let Some(own) = corners[seed as usize] else { continue };
        let (origin, length) = (points[own[0] as usize], area.sqrt());
        let unit = normal(own).map(|x| x / length);
        let most = rounding[inputs[seed as usize] as usize];
        let is_of_face = |own: [u32; 3]| {
            dot(normal(own), unit) > 0.0
                && own.iter().all(|&corner| dot(unit, minus(points[corner as usize], origin)).abs() <= most)
        };
        let mut members = vec![seed];
        due.push_back(seed);
        while let Some(polygon) = due.pop_front() {
            let start = neighbors.partition_point(|pair| pair[0] < polygon);
            for &[_, other] in neighbors[start..].iter().take_while(|pair| pair[0] == polygon) {
                let is_of_surface = || surface(seed).is_some() && surface(other) == surface(seed);
                if !is_taken[other as usize]
                    && (is_of_surface() || corners[other as usize].is_some_and(is_of_face))
                {
                    is_taken[other as usize] = true;
                    members.push(other);
                    due.push_back(other);
                }
            }
        }
        let first = members.iter().copied().min().unwrap_or(seed);
        members.into_iter().for_each(|member| first_of[member as usize] = first);
    }
    first_of
}

/// An input, and the number of a surface that it states.
type InputSurface = (u32, u32);

/// The surfaces of inputs whose triangles look the same way, with all corners within a distance from the plane through the middle
/// of their triangles, by area.
fn flat_surfaces(
    polygons: &SpatialPolygons,
    corners: &[Option<[u32; 3]>],
    tolerance: f64,
) -> BTreeSet<InputSurface> {
    let points = polygons.positions().as_flat().as_chunks::<3>().0;
    let mut triangles: Vec<(InputSurface, [[f64; 3]; 3])> = (0..)
        .zip(corners)
        .filter_map(|(polygon, own)| {
            let surface = polygons.surface_of(polygon)?;
            let own = (*own)?.map(|corner| points[corner as usize]);
            Some(((polygons.input_of_polygon()[polygon as usize], surface), own))
        })
        .collect();
    triangles.sort_by_key(|own| own.0);
    let mut flat = BTreeSet::new();
    for own in triangles.chunk_by(|x, y| x.0 == y.0) {
        let origin = own[0].1[0];
        let normals: Vec<[f64; 3]> =
            own.iter().map(|(_, [a, b, c])| cross(minus(*b, *a), minus(*c, *a))).collect();
        let sum = normals.iter().fold([0.0; 3], |sum, &normal| plus(sum, 1.0, normal));
        let length = squared(sum).sqrt();
        let unit = sum.map(|x| x / length);
        let (mut middle, mut weight) = ([0.0; 3], 0.0);
        for ((_, triangle), normal) in own.iter().zip(&normals) {
            let area = squared(*normal).sqrt();
            weight += 3.0 * area;
            triangle.iter().for_each(|&corner| middle = plus(middle, area, minus(corner, origin)));
        }
        let middle = plus(origin, 1.0 / weight, middle);
        let is_near = |&corner: &[f64; 3]| dot(unit, minus(corner, middle)).abs() <= tolerance;
        if own.iter().all(|(_, triangle)| triangle.iter().all(is_near))
            && normals.iter().all(|&normal| dot(normal, unit) > 0.0)
        {
            flat.insert(own[0].0);
        }
    }
    flat
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::RaggedArray;
    use coface_geometry::Positions;

    fn firsts(flat: &[f64], lists: &[&[u32]], inputs: Option<Vec<u32>>) -> Vec<u32> {
        let positions = Positions::from_flat(3, flat.to_vec()).unwrap();
        let polygons = SpatialPolygons::from_polygons(positions, RaggedArray::from_lists(lists)).unwrap();
        flat_faces(
            &match inputs {
                Some(inputs) => polygons.with_inputs(inputs).unwrap(),
                None => polygons,
            },
            0.0,
        )
    }

    #[test]
    fn triangles_of_one_surface_are_one_face_within_the_tolerance() {
        let flat = vec![0., 0., 0., 1., 0., 0., 1., 1., 0.01, 0., 1., 0., 2., 0.5, 0.5];
        let positions = Positions::from_flat(3, flat).unwrap();
        let lists = RaggedArray::from_lists([[0, 2, 3], [0, 1, 2], [2, 1, 4]]);
        let bent = SpatialPolygons::from_polygons(positions, lists).unwrap();
        let of = |surfaces: Vec<u32>, tolerance| {
            flat_faces(&bent.clone().with_surfaces(surfaces).unwrap(), tolerance)
        };
        assert_eq!(of(vec![7, 7, u32::MAX], 0.01), [0, 0, 2]);
        // Not within the tolerance, of two surfaces, of a surface that is bent.
        assert_eq!(of(vec![7, 7, u32::MAX], 0.001), [0, 1, 2]);
        assert_eq!(of(vec![7, 8, u32::MAX], 0.01), [0, 1, 2]);
        assert_eq!(of(vec![7, 7, 7], 0.01), [0, 1, 2]);
        assert_eq!(flat_faces(&bent, 0.01), [0, 1, 2]);
    }

    #[test]
    fn triangles_in_one_plane_are_one_face() {
        // A square and a flap that is bent, then one that is not.
        let flap = |height: f64| [0., 0., 0., 1., 0., 0., 1., 1., 0., 0., 1., 0., 2., 0.5, height];
        let lists: [&[u32]; 3] = [&[0, 2, 3], &[0, 1, 2], &[2, 1, 4]];
        assert_eq!(firsts(&flap(0.1), &lists, None), [0, 0, 2]);
        assert_eq!(firsts(&flap(0.0), &lists, None), [0, 0, 0]);
        assert_eq!(firsts(&flap(1e-16), &lists, None), [0, 0, 0]);
        // Of another input, in the other direction, and with a third triangle at the side.
        assert_eq!(firsts(&flap(0.0), &lists, Some(vec![0, 0, 1])), [0, 0, 2]);
        assert_eq!(firsts(&flap(0.0), &[&[0, 2, 3], &[0, 2, 1], &[2, 1, 4]], None), [0, 1, 2]);
        assert_eq!(firsts(&flap(0.0), &[&[0, 2, 3], &[0, 1, 2], &[0, 2, 4]], None), [0, 1, 2]);
        // What is no triangle stays itself, and so does what has no area.
        assert_eq!(firsts(&flap(0.0), &[&[0, 1, 2, 3], &[2, 1, 4]], None), [0, 1]);
        assert_eq!(firsts(&[0., 0., 0., 1., 0., 0., 2., 0., 0.], &[&[0, 1, 2]], None), [0]);
    }
}
