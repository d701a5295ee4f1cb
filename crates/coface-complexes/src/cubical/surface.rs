//! The squares between voxels that are set and the others.

use super::volume::CubicalVolume;
use coface_algebra::RaggedArray;
use coface_algebra::{Error, ErrorKind};
use coface_geometry::Positions;

impl CubicalVolume {
    /// The squares between a voxel that is set and one that is not, or the outside: turned so that their normals point out of what is set. Voxel
    /// (i, j, k) is the cube from there to (i + 1, j + 1, k + 1). Vertices are those of the squares, by rising places.
    ///
    /// Where voxels meet in an edge or a corner only, so do the squares: the polygons are the boundary of the chain of all voxels, and no surface
    /// there.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] unless there are three axes, none of them periodic; [`ErrorKind::TooLarge`] for more than 2^32 places of
    /// corners, or than 2^30 squares.
    ///
    /// # Complexity
    /// Linear in the voxels.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::cubical::CubicalVolume;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let (positions, squares) = CubicalVolume::full(&[2, 1, 1], &[false; 3])?.boundary_squares()?;
    /// assert_eq!((positions.len(), squares.len()), (12, 10));
    /// # Ok(()) }
    /// ```
    pub fn boundary_squares(&self) -> Result<(Positions, RaggedArray), Error> {
        let &[nx, ny, nz] = self.shape() else {
            return Err(Error::invalid(format!(
                "a volume of {} axes has no boundary of squares",
                self.shape().len()
            ))
            .with_cure("take one of three axes"));
        };
        if self.is_periodic().contains(&true) {
            return Err(Error::invalid("a volume with a periodic axis lies not in space")
                .with_cure("leave out --periodic"));
        }
        let too_large = || Error::new(ErrorKind::TooLarge, "the volume has too many corners for one surface");
        // The corners of one axis after the other.
        let strides = [(u64::from(ny) + 1) * (u64::from(nz) + 1), u64::from(nz) + 1, 1];
        if strides[0].checked_mul(u64::from(nx) + 1).is_none_or(|corners| u32::try_from(corners).is_err()) {
            return Err(too_large());
        }
        let strides = strides.map(|stride| stride as u32);
        let mut corners: Vec<u32> = Vec::new();
        for x in 0..nx {
            for y in 0..ny {
                for z in 0..nz {
                    if !self.is_set(&[x, y, z]) {
                        continue;
                    }
                    let corner = x * strides[0] + y * strides[1] + z;
                    for axis in 0..3 {
                        // Seen from the end of the axis, first u then v turns counterclockwise.
                        let (u, v) = (strides[(axis + 1) % 3], strides[(axis + 2) % 3]);
                        let mut beside = [x, y, z];
                        if beside[axis] > 0 {
                            beside[axis] -= 1;
                        }
                        if [x, y, z][axis] == 0 || !self.is_set(&beside) {
                            corners.extend([corner, corner + v, corner + u + v, corner + u]);
                        }
                        beside = [x, y, z];
                        beside[axis] += 1;
                        if beside[axis] == self.shape()[axis] || !self.is_set(&beside) {
                            let corner = corner + strides[axis];
                            corners.extend([corner, corner + u, corner + u + v, corner + v]);
                        }
                    }
                }
            }
            if u32::try_from(corners.len()).is_err() {
                return Err(too_large());
            }
        }
        let mut used = corners.clone();
        used.sort_unstable();
        used.dedup();
        let points: Vec<f64> = used
            .iter()
            .flat_map(|&corner| {
                let rest = corner % strides[0];
                [corner / strides[0], rest / strides[1], rest % strides[1]].map(f64::from)
            })
            .collect();
        for corner in &mut corners {
            *corner = used.binary_search(corner).expect("every corner was gathered") as u32;
        }
        Ok((Positions::from_flat(3, points)?, RaggedArray::uniform(4, corners)?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::PolygonMesh;
    use proptest::prelude::*;

    proptest! {
        /// The boundary of the chain of voxels: closed, and of the volume of the voxels.
        #[test]
        fn squares_close_and_enclose(bits in any::<u64>(), shape in prop::array::uniform3(1u32..4)) {
            let mut at = 0;
            let volume = CubicalVolume::new(&shape, &[false; 3], |_| { at += 1; bits.rotate_left(at) & 1 == 1 }).unwrap();
            let (positions, squares) = volume.boundary_squares().unwrap();
            let mut sum = 0.0;
            let mut ends = std::collections::BTreeMap::new();
            for square in squares.iter() {
                let [a, b, c, _] = [0, 1, 2, 3].map(|i| positions.point(coface_algebra::VertexId::from_u32(square[i])));
                // A sixth of the determinant of each triangle: the cone to the origin. Both triangles have the same.
                let cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
                sum += (cross[0] * c[0] + cross[1] * c[1] + cross[2] * c[2]) / 3.0;
                for i in 0..4 {
                    *ends.entry((square[i].min(square[(i + 1) % 4]), square[i].max(square[(i + 1) % 4]))).or_insert(0) +=
                        if square[i] < square[(i + 1) % 4] { 1 } else { -1 };
                }
            }
            prop_assert!((sum - volume.set_count() as f64).abs() < 1e-9);
            prop_assert!(ends.values().all(|&sum| sum == 0));
        }
    }

    #[test]
    fn a_hollow_ball_has_two_spheres() {
        let ball = CubicalVolume::new(&[3; 3], &[false; 3], |voxel| voxel != [1, 1, 1]).unwrap();
        let (positions, squares) = ball.boundary_squares().unwrap();
        assert_eq!(squares.len(), 54 + 6);
        let mesh = PolygonMesh::new(positions.len(), squares, &[]).unwrap();
        assert_eq!(mesh.chain_complex().unwrap().euler_characteristic(), 2 + 2);
        // The inner one, a cube, is apart from the outer one.
        let [inner, outer] = [0, 1].map(|is_outer| {
            let is_on = |point: &[f64]| point.iter().any(|x| [0.0, 3.0].contains(x)) == (is_outer == 1);
            (0..positions.len()).filter(|&i| is_on(positions.point(coface_algebra::VertexId::new(i)))).count()
        });
        assert_eq!((inner, outer), (8, 56));
        assert!(CubicalVolume::full(&[2, 2], &[false; 2]).unwrap().boundary_squares().is_err());
        assert!(CubicalVolume::full(&[2; 3], &[true; 3]).unwrap().boundary_squares().is_err());
    }
}
