//! Volumes of two axes: pixels as squares of the plane.

use coface_algebra::{Error, RaggedArray};
use coface_complexes::cubical::CubicalVolume;
use coface_geometry::Positions;
use coface_io::Model;

/// The pixels that are set as squares: pixel (i, j) is the square from (i, j) to (i + 1, j + 1).
///
/// # Errors
/// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a periodic axis, which lies in no plane.
pub(super) fn model_of_pixels(volume: &CubicalVolume, [width, height]: [u32; 2]) -> Result<Model, Error> {
    if volume.is_periodic().contains(&true) {
        return Err(Error::invalid("an image with a periodic axis lies not in the plane")
            .with_cure("leave out --periodic"));
    }
    let mut corners: Vec<[u32; 4]> = Vec::new();
    let stride = u64::from(height) + 1;
    let number = |x: u32, y: u32| u64::from(x) * stride + u64::from(y);
    let mut used: Vec<u64> = Vec::new();
    let mut squares: Vec<[u64; 4]> = Vec::new();
    for x in 0..width {
        for y in (0..height).filter(|&y| volume.is_set(&[x, y])) {
            squares.push([number(x, y), number(x + 1, y), number(x + 1, y + 1), number(x, y + 1)]);
        }
    }
    used.extend(squares.iter().flatten());
    used.sort_unstable();
    used.dedup();
    let place = |corner: &u64| used.partition_point(|other| other < corner) as u32;
    corners.extend(squares.iter().map(|square| square.each_ref().map(place)));
    let flat = used.iter().flat_map(|corner| [(corner / stride) as f64, (corner % stride) as f64]);
    Model::from_polygons(Positions::from_flat(2, flat.collect())?, RaggedArray::from_lists(corners))
}

#[cfg(test)]
mod tests {
    use crate::Scene;
    use coface_complexes::cubical::CubicalVolume;
    use coface_io::{Model, Structure};

    #[test]
    fn pixels_are_squares_of_the_plane() {
        let image = CubicalVolume::full(&[3, 2], &[false; 2]).unwrap();
        let scene = Scene::of("image", &Model::from_structure(Structure::Volume(image))).unwrap();
        assert_eq!((scene.dimension(), scene.polygons().len(), scene.positions().len()), (2, 6, 12));
        assert!(scene.remarks()[0].message.contains("the 6 pixels"));
        let round = CubicalVolume::full(&[3, 2], &[true, false]).unwrap();
        assert!(Scene::of("round", &Model::from_structure(Structure::Volume(round))).is_err());
    }
}
