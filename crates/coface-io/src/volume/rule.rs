//! Which numbers set their voxels.

use coface_algebra::Error;
use coface_complexes::cubical::CubicalVolume;
use serde::{Deserialize, Serialize};
use std::fmt;

/// Which numbers set their voxels; those that are no number (NaN) never do.
///
/// Bounds are 64-bit floating point numbers, and integers are compared with them exactly, whatever their width.
///
/// # Examples
/// ```
/// use coface_io::VoxelRule;
/// assert!(VoxelRule::AtLeast(0.5).holds(0.5) && !VoxelRule::AtLeast(0.5).holds(f64::NAN));
/// assert!(!VoxelRule::Below(0.5).holds(0.5));
/// assert!(VoxelRule::Between(1.0, 2.0).holds(2.0));
/// assert!(VoxelRule::Nonzero.holds(-1.0));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum VoxelRule {
    /// All but zero.
    #[default]
    Nonzero,
    /// This number and those above.
    AtLeast(f64),
    /// Those below this number.
    Below(f64),
    /// These two numbers and those between them.
    Between(f64, f64),
    /// This number alone; of a file of 32-bit or 16-bit floating point numbers, the one next to it.
    Equal(f64),
}

impl VoxelRule {
    /// Whether a number sets its voxel.
    pub fn holds(self, number: f64) -> bool {
        match self {
            Self::Nonzero => number != 0.0 && !number.is_nan(),
            Self::AtLeast(bound) => number >= bound,
            Self::Below(bound) => number < bound,
            Self::Between(low, high) => low <= number && number <= high,
            Self::Equal(value) => number == value,
        }
    }

    /// The integers that set their voxels, from the first to the last; `None` for all but zero.
    pub fn integers(self) -> Option<(i128, i128)> {
        // Casts go to the ends of the range beyond it, and nothing is there.
        const EMPTY: (i128, i128) = (1, 0);
        Some(match self {
            Self::Nonzero => return None,
            Self::AtLeast(bound) => (bound.ceil() as i128, i128::MAX),
            Self::Below(bound) => (i128::MIN, (bound.ceil() as i128).saturating_sub(1)),
            Self::Between(low, high) => (low.ceil() as i128, high.floor() as i128),
            Self::Equal(value) if value.fract() == 0.0 => (value as i128, value as i128),
            Self::Equal(_) => EMPTY,
        })
    }

    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for bounds that are no numbers, or the wrong way round.
    pub(super) fn check(self) -> Result<(), Error> {
        let bounds = match self {
            Self::Nonzero => return Ok(()),
            Self::AtLeast(bound) | Self::Below(bound) | Self::Equal(bound) => [bound, bound],
            Self::Between(low, high) => [low, high],
        };
        if bounds.iter().any(|bound| bound.is_nan()) {
            return Err(Error::invalid("no voxel can be compared with what is no number")
                .with_cure("give a number as threshold"));
        }
        if bounds[0] > bounds[1] {
            return Err(Error::invalid(format!("no number is between {} and {}", bounds[0], bounds[1]))
                .with_cure("give the lower bound first"));
        }
        Ok(())
    }
}

impl fmt::Display for VoxelRule {
    /// `not 0`, `0.5 and above`, `below 0.5`, `from 1 to 2`, `7`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Nonzero => f.write_str("not 0"),
            Self::AtLeast(bound) => write!(f, "{bound} and above"),
            Self::Below(bound) => write!(f, "below {bound}"),
            Self::Between(low, high) => write!(f, "from {low} to {high}"),
            Self::Equal(value) => write!(f, "{value}"),
        }
    }
}

/// How the numbers of a volume file become voxels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct VolumeReading {
    /// Which voxels are set.
    pub rule: VoxelRule,
    /// Which axes are periodic, by their numbers in the file.
    pub periodic: [bool; CubicalVolume::MOST_AXES],
}

impl VolumeReading {
    /// The axes of a volume that are periodic.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for an axis that the volume has not.
    pub fn periodic_axes(&self, axis_count: usize) -> Result<Vec<bool>, Error> {
        match self.periodic.iter().skip(axis_count).position(|&periodic| periodic) {
            Some(at) => Err(Error::invalid(format!(
                "axis {} cannot be periodic: the volume has {axis_count}",
                at + axis_count
            ))
            .with_cure("number the axes from 0, or name the first three x, y, z")),
            None => Ok(self.periodic[..axis_count.min(self.periodic.len())].to_vec()),
        }
    }
}
