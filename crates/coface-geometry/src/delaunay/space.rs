//! The flat that points span, and where points of it lie.

use crate::predicates::{
    WeightedPoint, circle_side, ordinary_circle_side, ordinary_sphere_side, orientation, spatial_orientation,
    sphere_side,
};
use rayon::prelude::*;
use std::cmp::{Ordering, Reverse};

/// Points in the order of their insertion, and what makes a flat of less dimension whole: points outside of it. With them a simplex of the flat becomes
/// one of the plane or of space, whose orientation, and whose sphere where it meets the flat, are those of the simplex.
pub(super) struct Space {
    pub(super) points: Vec<WeightedPoint>,
    /// The places of the points in lexicographic order of their coordinates, which decide where spheres pass through further points.
    ranks: Vec<u32>,
    is_planar: bool,
    /// None, one or two points, by what the dimension of the flat is short of.
    outside: [WeightedPoint; 2],
    is_ordinary: bool,
}

impl Space {
    /// The space of these points, and the first points that span their flat: one more than its dimension.
    pub(super) fn new(points: Vec<WeightedPoint>, is_planar: bool) -> (Self, Vec<u32>) {
        let is_ordinary = points.iter().all(WeightedPoint::is_ordinary);
        let outside = [WeightedPoint::new([0.0; 3], 0.0); 2];
        let ranks = lexicographic_ranks(&points);
        let mut space = Self { points, ranks, is_planar, outside, is_ordinary };
        let mut corners: Vec<[f64; 3]> = Vec::new();
        let mut spanning = Vec::new();
        for (id, point) in space.points.iter().enumerate() {
            if spanning.len() == space.corner_count() {
                break;
            }
            if space.spans(&corners, point.point()) {
                corners.push(point.point());
                spanning.push(id as u32);
            }
        }
        space.look_outside(&mut corners);
        (space, spanning)
    }

    /// The corners of a simplex of the whole space.
    fn corner_count(&self) -> usize {
        if self.is_planar { 3 } else { 4 }
    }

    /// Whether a point lies outside of the flat of others, which are independent.
    fn spans(&self, corners: &[[f64; 3]], point: [f64; 3]) -> bool {
        match *corners {
            [] => true,
            [a] => a != point,
            [a, b] => (0..3).any(|axis| {
                let [a, b, c] = [a, b, point].map(|p| [p[(axis + 1) % 3], p[(axis + 2) % 3]]);
                orientation(a, b, c).is_ne()
            }),
            [a, b, c, ..] => spatial_orientation(a, b, c, point).is_ne(),
        }
    }

    /// Finds points outside of the flat of these corners, which have a place if there are points.
    fn look_outside(&mut self, corners: &mut Vec<[f64; 3]>) {
        let Some(&first) = corners.first() else { return };
        let size =
            self.points.iter().flat_map(WeightedPoint::point).fold(0.0, |size: f64, x| size.max(x.abs()));
        let size = if size == 0.0 { 1.0 } else { size };
        let axes = if self.is_planar { 2 } else { 3 };
        let mut found = 0;
        for axis in 0..axes {
            if corners.len() == self.corner_count() {
                return;
            }
            let mut point = first;
            point[axis] += if point[axis] > 0.0 { -size } else { size };
            if self.spans(corners, point) {
                corners.push(point);
                // At one place nobody asks for orientations.
                self.outside[found % 2] = WeightedPoint::new(point, 0.0);
                found += 1;
            }
        }
    }

    fn corner<const N: usize>(&self, corners: &[WeightedPoint; N], i: usize) -> WeightedPoint {
        if i < N { corners[i] } else { self.outside[i - N] }
    }

    /// The orientation of a simplex of the flat.
    pub(super) fn orientation<const N: usize>(&self, corners: &[WeightedPoint; N]) -> Ordering {
        if self.is_planar {
            let [a, b, c] = [0, 1, 2].map(|i| {
                let [x, y, _] = self.corner(corners, i).point();
                [x, y]
            });
            return orientation(a, b, c);
        }
        let [a, b, c, d] = [0, 1, 2, 3].map(|i| self.corner(corners, i).point());
        spatial_orientation(a, b, c, d)
    }

    /// Whether a point of the flat lies inside the sphere of a positive simplex of it.
    ///
    /// A point on the sphere lies inside if it does when each point is moved away a little, as by less weight: a later one in lexicographic order
    /// more than all earlier ones together. So what is inside depends neither on the numbers of points nor on where all of them are moved to.
    ///
    /// # References
    /// O. Devillers, M. Teillaud, *Perturbations for Delaunay and weighted Delaunay 3D triangulations* (2011): no simplex is flat then.
    pub(super) fn is_inside<const N: usize>(&self, ids: [u32; N], id: u32) -> bool {
        let corners = ids.map(|id| self.points[id as usize]);
        match self.side(&corners, self.points[id as usize]) {
            Ordering::Greater => true,
            Ordering::Less => false,
            Ordering::Equal => self.is_inside_moved(ids, corners, id),
        }
    }

    /// Whether a point on the sphere of a positive simplex lies inside when points are moved away.
    fn is_inside_moved<const N: usize>(&self, ids: [u32; N], corners: [WeightedPoint; N], id: u32) -> bool {
        let rank = |id: u32| self.ranks[id as usize];
        let mut places: [usize; N] = std::array::from_fn(|place| place);
        places.sort_unstable_by_key(|&place| Reverse(rank(ids[place])));
        for place in places {
            if rank(ids[place]) < rank(id) {
                return false;
            }
            // The sphere grows on that side of the facet without the corner where the corner is.
            let mut replaced = corners;
            replaced[place] = self.points[id as usize];
            match self.orientation(&replaced) {
                Ordering::Greater => return true,
                Ordering::Less => return false,
                Ordering::Equal => {}
            }
        }
        false
    }

    /// On which side of the sphere of a positive simplex a point of the flat lies: greater inside.
    fn side<const N: usize>(&self, corners: &[WeightedPoint; N], q: WeightedPoint) -> Ordering {
        if self.is_planar {
            let triangle = [0, 1, 2].map(|i| self.corner(corners, i));
            let filtered = if self.is_ordinary { ordinary_circle_side(triangle, q) } else { None };
            filtered.unwrap_or_else(|| circle_side(triangle, q))
        } else {
            let tetrahedron = [0, 1, 2, 3].map(|i| self.corner(corners, i));
            let filtered = if self.is_ordinary { ordinary_sphere_side(tetrahedron, q) } else { None };
            filtered.unwrap_or_else(|| sphere_side(tetrahedron, q))
        }
    }
}

/// The place of each of different points in lexicographic order of their coordinates.
fn lexicographic_ranks(points: &[WeightedPoint]) -> Vec<u32> {
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    order.par_sort_unstable_by(|&a, &b| {
        let [a, b] = [a, b].map(|id| points[id as usize].point());
        a.partial_cmp(&b).expect("coordinates are numbers")
    });
    let mut ranks = vec![0; points.len()];
    for (rank, &id) in (0..).zip(&order) {
        ranks[id as usize] = rank;
    }
    ranks
}
