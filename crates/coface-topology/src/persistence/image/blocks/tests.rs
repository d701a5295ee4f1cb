//! Images by blocks against whole images.

use super::super::filtration::{ImageConstruction, ImageFiltration};
use super::*;
use crate::homology::Coefficients;
use coface_algebra::ErrorKind;
use proptest::prelude::*;

#[derive(Clone, Debug)]
struct Image {
    shape: Vec<usize>,
    is_periodic: Vec<bool>,
    numbers: Vec<f64>,
    block: Vec<usize>,
}

impl Image {
    /// The numbers of a window.
    fn window(&self, window: &[Vec<usize>]) -> Vec<f64> {
        let mut voxels = vec![0];
        for (axis, along) in window.iter().enumerate() {
            let length = self.shape[axis];
            voxels = voxels.iter().flat_map(|&v| along.iter().map(move |&x| v * length + x)).collect();
        }
        voxels.into_iter().map(|voxel| self.numbers[voxel]).collect()
    }

    fn parts(&self, blocks: &ImageBlocks) -> Vec<ImagePart> {
        let part = |number| blocks.part(number, self.window(&blocks.window(number))).unwrap();
        (0..blocks.count()).map(part).collect()
    }
}

/// Merged by so many neighbors at once, with parts written and read between.
fn merged(mut parts: Vec<ImagePart>, fan_in: usize) -> ImagePart {
    while parts.len() > 1 {
        parts = parts
            .chunks(fan_in)
            .map(|group| {
                let group: Vec<ImagePart> =
                    group.iter().map(|part| ImagePart::of_words(&part.to_words()).unwrap()).collect();
                ImagePart::merged(&group).unwrap()
            })
            .collect();
    }
    ImagePart::merged(&parts).unwrap()
}

fn shapes() -> impl Strategy<Value = Vec<usize>> {
    prop_oneof![
        prop::collection::vec(1usize..30, 1),
        prop::collection::vec(1usize..10, 2),
        prop::collection::vec(1usize..7, 3),
        prop::collection::vec(1usize..5, 4),
    ]
}

/// Small images with many ties, some voxels outside, some axes periodic; white noise or a few waves.
fn images() -> impl Strategy<Value = Image> {
    let shapes = (shapes(), any::<[bool; 4]>(), any::<[u8; 4]>());
    let kinds =
        (prop::sample::select(vec![2i32, 9, 1000]), prop::sample::select(vec![0u8, 30, 120]), any::<bool>());
    (shapes, kinds).prop_flat_map(|((shape, periodic, sides), (most, missing, is_smooth))| {
        let count: usize = shape.iter().product();
        let is_periodic: Vec<bool> = periodic.into_iter().take(shape.len()).collect();
        let block: Vec<usize> =
            shape.iter().zip(sides).map(|(&length, side)| usize::from(side) % (length + 1) + 1).collect();
        prop::collection::vec((0..most, any::<u8>()), count).prop_map(move |numbers| {
            let number = |(place, (x, lot)): (usize, (i32, u8))| match is_smooth {
                _ if lot < missing => f64::NAN,
                true => ((place as f64 * 0.7).sin() * f64::from(most.min(40))).round(),
                false => f64::from(x) - 3.0,
            };
            Image {
                shape: shape.clone(),
                is_periodic: is_periodic.clone(),
                numbers: numbers.into_iter().enumerate().map(number).collect(),
                block: block.clone(),
            }
        })
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]
    #[test]
    fn diagrams_by_blocks_are_those_of_whole_images(
        image in images(),
        p in prop::sample::select(vec![2u64, 3, 5]),
        fan_in in 2usize..9,
    ) {
        let coefficients = Coefficients::Modulo(p);
        for construction in [ImageConstruction::Vertices, ImageConstruction::TopCells] {
            for is_superlevel in [false, true] {
                let whole = ImageFiltration::new(&image.shape, image.numbers.iter().copied()).unwrap();
                let whole = whole.construction(construction).superlevel(is_superlevel);
                let whole = whole.periodic(&image.is_periodic).unwrap().persistence(coefficients).unwrap();
                let blocks = ImageBlocks::new(&image.shape, &image.block).unwrap();
                let blocks = blocks.construction(construction).superlevel(is_superlevel);
                let blocks = blocks.periodic(&image.is_periodic).unwrap().coefficients(coefficients).unwrap();
                let root = merged(image.parts(&blocks), fan_in);
                prop_assert_eq!(root.rule_count(), 0);
                let found = root.diagram().unwrap();
                prop_assert_eq!(&found, &whole);
                let bits = |diagram: &super::super::ImageDiagram| -> Vec<(u64, Option<u64>)> {
                    let pairs = diagram.pairs().iter();
                    pairs.map(|pair| (pair.birth().to_bits(), pair.death().map(f64::to_bits))).collect()
                };
                prop_assert_eq!(bits(&found), bits(&whole));
            }
        }
    }

    /// Words that were changed are refused, or make some diagram or an error: nothing panics or runs forever.
    #[test]
    fn damaged_parts_are_refused(image in images(), at in any::<prop::sample::Index>(), word in any::<u64>()) {
        let blocks = ImageBlocks::new(&image.shape, &image.block).unwrap();
        let mut parts = image.parts(&blocks);
        let mut words = parts[0].to_words();
        let place = at.index(words.len());
        words[place] = if word % 2 == 0 { word } else { words[place] ^ (word % 16) };
        if let Some(part) = ImagePart::of_words(&words) {
            parts[0] = part;
            if let Ok(root) = ImagePart::merged(&parts) {
                let _ = root.diagram();
            }
        }
    }
}

#[test]
fn faults_are_named() {
    let kind = |shape: &[usize], block: &[usize]| ImageBlocks::new(shape, block).unwrap_err().kind();
    assert_eq!(kind(&[2; 5], &[1; 5]), ErrorKind::Shape);
    assert_eq!(kind(&[4, 4], &[2]), ErrorKind::Shape);
    assert_eq!(kind(&[4, 4], &[2, 0]), ErrorKind::Shape);
    assert_eq!(kind(&[1 << 20, 1 << 20], &[1, 1]), ErrorKind::TooLarge);
    assert_eq!(kind(&[1 << 30, 1 << 30], &[1 << 20; 2]), ErrorKind::TooLarge);
    assert_eq!(kind(&[1 << 20, 1 << 20], &[1 << 18; 2]), ErrorKind::TooLarge);
    let blocks = ImageBlocks::new(&[4], &[2]).unwrap();
    assert_eq!(blocks.part(0, [1.0; 2]).unwrap_err().kind(), ErrorKind::Shape);
    assert_eq!(blocks.part(0, [1.0; 9]).unwrap_err().kind(), ErrorKind::Shape);
    let error = blocks.part(1, [1.0, f64::NEG_INFINITY, 0.0]).unwrap_err();
    assert!(error.message().contains("voxel [2] is at -inf"), "{error}");
    assert_eq!(
        blocks.clone().coefficients(Coefficients::Integers).unwrap_err().kind(),
        ErrorKind::Coefficient
    );
    assert_eq!(blocks.clone().periodic(&[]).unwrap_err().kind(), ErrorKind::Shape);
    let [first, last] = [0, 1].map(|number| blocks.part(number, [0.0, 1.0, 0.0]).unwrap());
    let kind = |parts: &[ImagePart]| ImagePart::merged(parts).unwrap_err().kind();
    assert_eq!(kind(&[]), ErrorKind::InvalidInput);
    assert_eq!(kind(&[last.clone(), first.clone()]), ErrorKind::InvalidInput);
    let other = blocks.superlevel(true).part(1, [0.0, 1.0, 0.0]).unwrap();
    assert_eq!(kind(&[first.clone(), other]), ErrorKind::InvalidInput);
    assert_eq!(last.diagram().unwrap_err().kind(), ErrorKind::InvalidInput);
    assert!(first.diagram().is_err());
}

/// Pairs that no other block can change are taken out as soon as they are seen, whatever the order in which parts are merged: what is left of white noise is
/// its rim.
#[test]
fn what_is_left_of_noise_is_its_rim() {
    let mut lot = 1u64;
    let mut number = || {
        lot = lot.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from((lot >> 40) as u32)
    };
    let image = Image {
        shape: vec![32, 32, 32],
        is_periodic: vec![false, true, false],
        numbers: (0..1 << 15).map(|_| number()).collect(),
        block: vec![16; 3],
    };
    for construction in [ImageConstruction::Vertices, ImageConstruction::TopCells] {
        let blocks = ImageBlocks::new(&image.shape, &image.block).unwrap().construction(construction);
        let blocks = blocks.periodic(&image.is_periodic).unwrap();
        let parts = image.parts(&blocks);
        let left = |part: &ImagePart| part.critical_counts().iter().sum::<usize>();
        // Some 6 x 16 x 16 voxels lie at the rim of a block, of 4,096.
        for part in &parts {
            assert!(left(part) < 1536, "{:?}", part.critical_counts());
            assert!(part.pair_count() > 500, "{}", part.pair_count());
        }
        let half = ImagePart::merged(&parts[..4]).unwrap();
        let sum: usize = parts[..4].iter().map(left).sum();
        assert!(left(&half) * 3 < sum * 2, "{} of {sum}", left(&half));
        let pairs: usize = parts[..4].iter().map(ImagePart::pair_count).sum();
        assert!(half.pair_count() > pairs);
        let root = ImagePart::merged(&parts).unwrap();
        // A component and a loop around the periodic axis.
        assert_eq!(left(&root), 2);
        let whole = ImageFiltration::new(&image.shape, image.numbers.iter().copied()).unwrap();
        let whole = whole.construction(construction).periodic(&image.is_periodic).unwrap();
        assert_eq!(root.diagram().unwrap(), whole.persistence(Coefficients::Modulo(2)).unwrap());
    }
}

/// Pairs that are kept elsewhere are those of the diagram.
#[test]
fn pairs_may_be_kept_elsewhere() {
    let row = [3.0, 0.0, 5.0, 1.0, 2.0, 7.0, 4.0, 6.0];
    let blocks = ImageBlocks::new(&[8], &[4]).unwrap();
    let window = |number: u32| blocks.window(number)[0].iter().map(|&voxel| row[voxel]).collect::<Vec<_>>();
    let mut parts = [0, 1].map(|number| blocks.part(number, window(number)).unwrap());
    let whole = ImagePart::merged(&parts).unwrap();
    let kept: Vec<Vec<u64>> = parts.iter_mut().map(ImagePart::take_pairs).collect();
    let mut root = ImagePart::merged(&parts).unwrap();
    assert!(root.pair_count() < whole.pair_count());
    assert!(kept.iter().all(|words| root.add_pairs(words)));
    assert_eq!(root.diagram().unwrap(), whole.diagram().unwrap());
    assert!(!root.add_pairs(&[1, 2]) && !root.add_pairs(&[]) && !root.add_pairs(&[4, 0, 0, 0, 0, 9]));
}

/// Rules of blocks within a union are dropped, and long paths are followed through many blocks.
#[test]
fn a_slope_through_all_blocks_flows_to_its_end() {
    let image = Image {
        shape: vec![40, 3],
        is_periodic: vec![false; 2],
        numbers: (0..120).map(|place| f64::from(120 - place)).collect(),
        block: vec![3, 2],
    };
    let blocks = ImageBlocks::new(&image.shape, &image.block).unwrap();
    let root = merged(image.parts(&blocks), 2);
    assert_eq!(root.critical_counts().iter().sum::<usize>() % 2, 1);
    assert_eq!(root.diagram().unwrap().pairs().len(), 1);
}
