//! What was put together because it was nearly one, in words.

use crate::answer::{JoinedFeatures, Remark, RemarkCode};
use crate::text;

impl JoinedFeatures {
    /// Of features; `vanished` is how many cells are not there any more.
    pub(crate) fn of(joined: &coface_arrange::JoinedFeatures, vanished: Option<usize>) -> Self {
        let counts = joined.counts;
        Self {
            tolerance: joined.tolerance,
            planes: counts.planes,
            vertices: counts.vertices,
            edges: counts.edges,
            crossings: counts.crossings,
            faces: counts.faces,
            moved: joined.moved.len(),
            largest_movement: joined.largest_movement,
            classes: joined.classes.iter().map(<[u32]>::to_vec).collect(),
            vanished_cells: vanished,
        }
    }

    /// Says that features were put together, because that was asked for or else needed, if it changed anything.
    pub(crate) fn remark(&self, is_asked: bool, cell: &str) -> Option<Remark> {
        let count = self.vertices + self.edges + self.crossings + self.faces;
        let vanishes = self.vanished_cells.is_some_and(|vanished| vanished > 0);
        if count == 0 && self.largest_movement == 0.0 && !vanishes {
            return None;
        }
        let mut message = match is_asked {
            true => format!("features up to {:.2e} apart were put together", self.tolerance),
            false => format!(
                "rounded coordinates would make faces cross, so features up to {:.2e} apart were put together",
                self.tolerance
            ),
        };
        message += &match self.largest_movement {
            0.0 => "; no point moved".to_owned(),
            way => format!("; points moved by at most {way:.1e}"),
        };
        if let Some(vanished) = self.vanished_cells.filter(|&count| count > 0) {
            message += &format!("; {} vanished, thinner than that", text::count(vanished, cell));
        }
        Some(Remark::new(RemarkCode::FeaturesJoined, message).at(count, []))
    }
}

/// Cells that are thinner than a part of the extent of their model that nobody means.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ThinCells {
    least: f64,
    extent: f64,
    unit: f64,
}

/// Cells count as thin below this part of the extent.
const THIN_PART: f64 = 1e-9;

impl ThinCells {
    /// For a model on points of so many coordinates.
    pub(crate) fn of(flat: &[f64], dimension: usize) -> Self {
        let extent = (0..dimension).map(|axis| {
            let range = flat.iter().skip(axis).step_by(dimension);
            range.clone().fold(f64::MIN, |most, &x| most.max(x))
                - range.fold(f64::MAX, |least, &x| least.min(x))
        });
        let largest = flat.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let extent = extent.fold(0.0, f64::max);
        Self { least: THIN_PART * extent, extent, unit: 4.0 * f64::EPSILON * largest }
    }

    /// The thickness below which a cell is thin.
    pub(crate) fn least(&self) -> f64 {
        self.least
    }

    /// The area or volume below which a cell may be thin.
    pub(crate) fn largest_measure(&self, dimension: i32) -> f64 {
        self.least * self.extent.powi(dimension - 1)
    }

    /// Tells of thin cells, and of what would remove them.
    pub(crate) fn remark(&self, thicknesses: &[f64], cell: &str) -> Option<Remark> {
        let thickest = thicknesses.iter().copied().reduce(f64::max)?;
        // A wedge is twice as thick as a slab, where it is thickest; to one digit, upwards.
        let needed = in_one_digit((3.0 * thickest).max(self.unit));
        let subject = match thicknesses.len() {
            1 => format!("1 {cell} is"),
            count => format!("{} are", text::count(count, cell)),
        };
        let message = format!(
            "{subject} thinner than {THIN_PART:e} of the extent; --tolerance {needed:.0e} puts together what is so near"
        );
        Some(Remark::new(RemarkCode::ThinCells, message).at(thicknesses.len(), []))
    }
}

/// The tolerance of congruence where none is given, and the remark that says so: a part of the extent that nobody means, but more
/// than what rounding explains; in one digit.
pub(crate) fn assumed_tolerance(flat: &[f64], dimension: usize) -> (f64, Remark) {
    let ThinCells { least, unit, .. } = ThinCells::of(flat, dimension);
    let length = least.max(16.0 * unit);
    let tolerance = if length > 0.0 { in_one_digit(length) } else { 0.0 };
    let message = format!(
        "pieces within {tolerance:.0e} of each other become one, {THIN_PART:e} of the extent or what rounding explains, since no --tolerance is given"
    );
    (tolerance, Remark::new(RemarkCode::ToleranceAssumed, message))
}

/// A length in one digit that is at least this one, to be named as a tolerance.
pub(crate) fn in_one_digit(length: f64) -> f64 {
    rounded_up(length, 1)
}

/// A length in so many digits that is at least this one, to be named.
pub(crate) fn rounded_up(length: f64, digits: i32) -> f64 {
    let scale = 10f64.powf(length.log10().floor() + 1.0 - f64::from(digits));
    (length / scale).ceil() * scale
}
