//! Triangles that a flat face of an input was cut into.

use super::super::flat_polygons::{explained_deviations, first_equal_points};
use crate::near::{minus, squared};
use crate::spatial::SpatialPolygons;
use coface_geometry::{cross, dot};
use std::collections::VecDeque;

/// For each polygon the first one of the flat face that it is a part of; itself unless it is a triangle.
///
/// Triangles of one input are of one face where they run along a common side in opposite directions, no other polygon of the input has
/// that side, and all are in one plane but for what rounding of their coordinates explains. The diagonals between them are none of the
/// features of the input.
///
/// # Complexity
/// $O(n \log n)$ for n sides.
pub(in crate::spatial) fn flat_faces(polygons: &SpatialPolygons) -> Vec<u32> {
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
                if !is_taken[other as usize] && corners[other as usize].is_some_and(is_of_face) {
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

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::RaggedArray;
    use coface_geometry::Positions;

    fn firsts(flat: &[f64], lists: &[&[u32]], inputs: Option<Vec<u32>>) -> Vec<u32> {
        let positions = Positions::from_flat(3, flat.to_vec()).unwrap();
        let polygons = SpatialPolygons::from_polygons(positions, RaggedArray::from_lists(lists)).unwrap();
        flat_faces(&match inputs {
            Some(inputs) => polygons.with_inputs(inputs).unwrap(),
            None => polygons,
        })
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
