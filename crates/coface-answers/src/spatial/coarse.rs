//! Whether numbers of 32 bits are fine enough for a shape.

use super::boolean::{part_counts, regions, sides_of_faces};
use super::{SceneArrangement, SolidRequest};
use crate::answer::{Remark, RemarkCode};
use crate::text;
use coface_algebra::{CellId, Error, ErrorKind};
use coface_arrange::CoordinatePrecision;
use coface_arrange::boolean::CellSelection;
use coface_geometry::{Positions, Sum, enclosed_volume, frame_around, polygon_area};
use coface_io::{Format, Model};

/// Numbers of 32 bits are too coarse for a shape of which they move points by this part of the extent.
const COARSE_PART: f64 = 1e-3;
/// They are too coarse for a result whose volume they change by more than this part.
const CHANGED_PART: f64 = 1e-2;
/// What is thinner than this part of the extent vanishes in numbers of 32 bits, wherever it lies.
const VANISHING_PART: f64 = 4e-6;
/// Coordinates are far from the origin where they are so many times the extent.
const FAR: f64 = 100.0;

/// The largest side of the box around points, and the largest coordinate.
fn extent(positions: &Positions) -> [f64; 2] {
    let points = positions.as_flat().as_chunks::<3>().0;
    let frame = frame_around(points.len(), |point| points[point].map(|x| [x; 2]));
    let extent = frame.iter().map(|[low, high]| high - low).fold(0.0, f64::max);
    [extent, positions.as_flat().iter().fold(0.0, |most: f64, x| x.abs().max(most))]
}

/// The refusal, with what would become of the shape.
fn too_coarse(what: &str, positions: &Positions) -> Error {
    let [extent, largest] = extent(positions);
    let fault = format!("numbers of 32 bits, as STL has, are too coarse here: {what}");
    let cure = "write .off, .ply or .obj, which hold numbers of 64 bits";
    let cure = match largest > FAR * extent {
        true => format!(
            "{cure}; coordinates up to {largest:.1e} beside an extent of {extent:.1e} cause it: near the origin STL would do"
        ),
        false => cure.to_owned(),
    };
    Error::new(ErrorKind::UnsupportedFormat, fault).with_cure(cure)
}

/// Refuses numbers of 32 bits where points would move by more than a part of the extent.
pub(super) fn refuse_movement(positions: &Positions, moved: f64) -> Result<(), Error> {
    let [extent, _] = extent(positions);
    if moved <= COARSE_PART * extent {
        return Ok(());
    }
    let what = format!("points would move by {moved:.1e} beside an extent of {extent:.1e}");
    Err(too_coarse(&what, positions))
}

/// Refuses them where rounding alone moves points by more than that.
pub(super) fn refuse_rounding(positions: &Positions, precision: CoordinatePrecision) -> Result<(), Error> {
    if precision == CoordinatePrecision::Double {
        return Ok(());
    }
    let way =
        |point: &[f64; 3]| point.iter().map(|&x| (precision.rounded(x) - x).powi(2)).sum::<f64>().sqrt();
    let moved = positions.as_flat().as_chunks::<3>().0.iter().map(way).fold(0.0, f64::max);
    refuse_movement(positions, moved)
}

/// What rounding the coordinates of a model to 32 bits changes, as remarks; nothing is put together.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] where points move by more than a thousandth of the extent, or the volume that the polygons
/// enclose changes by more than a hundredth; [`ErrorKind::InvalidInput`] for polygons that have no triangles.
///
/// # Complexity
/// Linear.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// use coface_answers::remarks_of_single_precision;
/// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
/// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
/// assert!(remarks_of_single_precision(&solid)?.is_empty());
/// let text = "v 1e7 0 0\nv 10000000.3 0 0\nv 1e7 1 0\nv 1e7 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
/// let far = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
/// assert!(remarks_of_single_precision(&far).is_err());
/// # Ok(()) }
/// ```
pub fn remarks_of_single_precision(model: &Model) -> Result<Vec<Remark>, Error> {
    let (precision, before) = (CoordinatePrecision::Single, model.positions());
    if before.dimension() == 3 {
        refuse_rounding(before, precision)?;
        let rounded = before.as_flat().iter().map(|&x| precision.rounded(x)).collect();
        let after = Positions::from_flat(3, rounded)?;
        let volumes = [before, &after].map(|own| enclosed_volume(own, model.polygons()).unwrap_or(0.0));
        let area = polygon_area(before, model.polygons()).unwrap_or(f64::INFINITY);
        refuse_other_volume(before, volumes, VANISHING_PART * extent(before)[0] * area)?;
    }
    let mut remarks = coface_io::losses(model, Format::Stl);
    remarks.retain(|own| matches!(own.code, RemarkCode::NumbersRounded | RemarkCode::RoundedInvalid));
    Ok(remarks)
}

/// Refuses an arrangement of rounded coordinates whose cells together are not as large as those before.
pub(super) fn refuse_other_cells(exact: &SceneArrangement, rounded: &SceneArrangement) -> Result<(), Error> {
    let [before, after] = [exact, rounded].map(|own| own.volumes().iter().copied().sum::<f64>());
    let [extent, _] = extent(exact.positions());
    let unseen = VANISHING_PART * extent.powi(3);
    refuse_other_volume(exact.positions(), [before, after], unseen)
}

fn refuse_other_volume(positions: &Positions, [before, after]: [f64; 2], unseen: f64) -> Result<(), Error> {
    if (after - before).abs() <= unseen.max(CHANGED_PART * before.abs()) {
        return Ok(());
    }
    let what = format!("the volume would be {} instead of {}", text::number(after), text::number(before));
    Err(too_coarse(&what, positions))
}

/// Refuses a combination on rounded coordinates that is another one than on exact ones: its volume changes by more than what
/// is too thin to be seen, or solids are lost that are not. `rounded` has the volume of the combination, and its solids.
pub(super) fn refuse_other_result(
    exact: &SceneArrangement,
    request: &SolidRequest,
    (after, solids_after): (f64, usize),
) -> Result<(), Error> {
    let membership = exact.inputs.membership(
        &exact.scene,
        &exact.arranged,
        request.rule,
        request.open,
        &exact.request,
        |input| request.formula.names(input),
    )?;
    let complex = exact.complex();
    let selection = CellSelection::by_membership(complex.cell_count(3), &request.formula, |cell, input| {
        membership.is_inside(cell, input)
    });
    if selection.has_exterior() {
        return Ok(());
    }
    let cells: Vec<CellId> = selection.cells().collect();
    let volumes = exact.arranged.volumes_of(&cells);
    let mut before = Sum::default();
    volumes.iter().for_each(|&volume| before.add(volume));
    let surface = exact.mesh_of(selection.boundary_without_pinches(complex)?.facets(), true)?;
    let positions = surface.positions(exact.arranged.drawn_positions())?;
    let area = polygon_area(&positions, surface.polygons()).unwrap_or(f64::INFINITY);
    let [extent, largest] = extent(exact.positions());
    let thickness = VANISHING_PART * extent;
    refuse_other_volume(exact.positions(), [before.value(), after], thickness * area)?;
    let sides = sides_of_faces(complex);
    let regions = regions(&selection, &sides, complex.cell_count(3));
    let [solids, _] = part_counts(&selection, &regions);
    // Gaps as thin as rounding close, and slivers as thin vanish.
    let is_seen = 4.0 * exact.request.precision.unit() * largest > thickness;
    if is_seen && solids != solids_after {
        let what =
            format!("the result would have {} instead of {solids}", text::count(solids_after, "solid"));
        return Err(too_coarse(&what, exact.positions()));
    }
    Ok(())
}
