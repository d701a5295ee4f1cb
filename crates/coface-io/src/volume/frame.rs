//! Where voxels are: steps along the axes, and the place of the first one.

use coface_algebra::Error;
use coface_geometry::Positions;

/// The steps from a voxel of three axes to the next along each, in the unit of the file, and the center of the first voxel if the file says it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VoxelFrame {
    steps: [[f64; 3]; 3],
    origin: Option<[f64; 3]>,
}

impl VoxelFrame {
    /// The frame of these steps; `None` if it makes no difference, or if the steps span no space.
    pub(crate) fn new(steps: [[f64; 3]; 3], origin: Option<[f64; 3]>) -> Option<Self> {
        let frame = Self { steps, origin };
        let is_finite = steps.iter().flatten().chain(origin.iter().flatten()).all(|x| x.is_finite());
        let is_plain = steps == [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] && origin.is_none();
        (is_finite && frame.determinant() != 0.0 && !is_plain).then_some(frame)
    }

    /// The steps and the center of the first voxel.
    pub(crate) fn numbers(&self) -> ([[f64; 3]; 3], Option<[f64; 3]>) {
        (self.steps, self.origin)
    }

    /// The frame of steps along the axes.
    pub(super) fn of_spacing(spacing: &[f64], origin: Option<[f64; 3]>) -> Option<Self> {
        let &[x, y, z] = spacing else { return None };
        // Some programs write 0 for what is not known, and signs for directions that they do not have.
        let [x, y, z] = [x, y, z].map(f64::abs);
        Self::new([[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]], origin)
    }

    fn determinant(&self) -> f64 {
        let [a, b, c] = self.steps;
        a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
            + a[2] * (b[0] * c[1] - b[1] * c[0])
    }

    /// The lengths of the steps.
    fn spacing(&self) -> [f64; 3] {
        self.steps.map(|step| step.iter().map(|x| x * x).sum::<f64>().sqrt())
    }

    /// Moves corners of voxels, which are at whole numbers, to where they are.
    ///
    /// # Errors
    /// For corners in another dimension than 3.
    pub fn place(&self, corners: &Positions) -> Result<Positions, Error> {
        let mut flat = Vec::with_capacity(corners.as_flat().len());
        for corner in corners.as_flat().chunks_exact(3) {
            // The first voxel has its center in the middle between corners 0 and 1.
            let shift = if self.origin.is_some() { 0.5 } else { 0.0 };
            for axis in 0..3 {
                let along = |step: usize| (corner[step] - shift) * self.steps[step][axis];
                flat.push(along(0) + along(1) + along(2) + self.origin.map_or(0.0, |origin| origin[axis]));
            }
        }
        Positions::from_flat(3, flat)
    }

    /// Whether the steps are left-handed: what looked outward looks inward where [`Self::place`] moves it.
    pub fn is_mirrored(&self) -> bool {
        self.determinant() < 0.0
    }

    /// What was done, for people.
    pub(crate) fn description(&self) -> String {
        let [x, y, z] = self.spacing();
        let place = match self.origin {
            Some([a, b, c]) => format!(", the center of the first at ({a}, {b}, {c})"),
            None => String::new(),
        };
        format!("vertices are where the header places voxels: {x} x {y} x {z} each{place}")
    }
}

#[cfg(test)]
mod tests {
    use crate::{Format, Structure, read};
    use coface_geometry::enclosed_volume;

    /// The volume and the lowest corner of a block of 2 x 3 x 1 voxels.
    fn measured(bytes: &[u8], format: Format) -> (f64, [f64; 3]) {
        let model = read(bytes, format).unwrap();
        assert!(matches!(model.structure(), Some(Structure::Volume(_))));
        let (positions, faces) = model.voxel_surface().unwrap().unwrap();
        let flat = positions.as_flat();
        let low =
            [0, 1, 2].map(|axis| flat.iter().skip(axis).step_by(3).copied().fold(f64::INFINITY, f64::min));
        (enclosed_volume(&positions, &faces).unwrap(), low)
    }

    #[test]
    fn headers_place_voxels() {
        let nrrd = |fields: &str| {
            let text = format!(
                "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 3 1\nencoding: ascii\n{fields}\n1 1 1 1 1 1\n"
            );
            measured(text.as_bytes(), Format::Nrrd)
        };
        assert_eq!(nrrd(""), (6.0, [0.0; 3]));
        assert_eq!(nrrd("spacings: 0.5 2 3\n"), (18.0, [0.0; 3]));
        let turned =
            "space dimension: 3\nspace directions: (0,0.5,0) (2,0,0) (0,0,3)\nspace origin: (10,20,30)\n";
        assert_eq!(
            nrrd(turned),
            (18.0, [9.0, 19.75, 28.5]),
            "faces look outward though the axes are swapped"
        );
        let meta = |fields: &str| {
            let text = format!(
                "ObjectType = Image\nNDims = 3\nDimSize = 2 3 1\n{fields}ElementType = MET_UCHAR\nBinaryData = False\nElementDataFile = LOCAL\n1 1 1 1 1 1\n"
            );
            measured(text.as_bytes(), Format::MetaImage)
        };
        assert_eq!(meta("ElementSpacing = 0.5 2 3\n"), (18.0, [0.0; 3]));
        let turned = "TransformMatrix = 0 1 0 1 0 0 0 0 1\nOffset = 10 20 30\nElementSpacing = 0.5 2 3\n";
        assert_eq!(meta(turned), (18.0, [9.0, 19.75, 28.5]));
        // NIfTI: spacing alone, an affine map, a rotation by a quaternion.
        let nifti = |change: &dyn Fn(&mut Vec<u8>)| {
            let mut bytes = vec![0; 352];
            bytes[..4].copy_from_slice(&348i32.to_le_bytes());
            for (i, length) in [3i16, 2, 3, 1, 1, 1, 1, 1].iter().enumerate() {
                bytes[40 + 2 * i..42 + 2 * i].copy_from_slice(&length.to_le_bytes());
            }
            bytes[70..74].copy_from_slice(&[2, 0, 8, 0]);
            for (i, size) in [1.0f32, 0.5, 2.0, 3.0].iter().enumerate() {
                bytes[76 + 4 * i..80 + 4 * i].copy_from_slice(&size.to_le_bytes());
            }
            bytes[108..112].copy_from_slice(&352f32.to_le_bytes());
            bytes[344..348].copy_from_slice(b"n+1\0");
            change(&mut bytes);
            bytes.extend([1; 6]);
            measured(&bytes, Format::Nifti)
        };
        let put = |bytes: &mut Vec<u8>, at: usize, numbers: &[f32]| {
            for (i, number) in numbers.iter().enumerate() {
                bytes[at + 4 * i..at + 4 * i + 4].copy_from_slice(&number.to_le_bytes());
            }
        };
        assert_eq!(nifti(&|_| {}), (18.0, [0.0; 3]));
        let affine = nifti(&|bytes| {
            bytes[254] = 1;
            put(bytes, 280, &[0.0, 2.0, 0.0, 10.0, 0.5, 0.0, 0.0, 20.0, 0.0, 0.0, 3.0, 30.0]);
        });
        assert_eq!(affine, (18.0, [9.0, 19.75, 28.5]));
        // A half turn about the third axis.
        let rotated = nifti(&|bytes| {
            bytes[252] = 1;
            put(bytes, 256, &[0.0, 0.0, 1.0, 10.0, 20.0, 30.0]);
        });
        assert_eq!(rotated, (18.0, [9.25, 15.0, 28.5]));
    }
}
