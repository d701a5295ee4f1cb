//! Boolean combinations of Yin sets of order 2, and splines through points.

use super::planar::drawing;
use super::{Clock, Task, Work};
use coface::Error;
use coface::arrange::boolean::{BooleanFormula, InsideRule};
use coface::yin::{CartesianGrid, Curve, CutCells, EndCondition, Order, YinSet};
use std::path::Path;

pub(super) const MEET: Task = Task {
    name: "yin-meet",
    about: "the meet of two Yin sets, with forest, kinks and sources",
    extension: "raw3",
    inputs: INPUTS,
    work: Work::Inside(|path, clock| combined(path, clock, "a & b")),
};

pub(super) const JOIN: Task = Task {
    name: "yin-join",
    about: "the join of two Yin sets, with forest, kinks and sources",
    extension: "raw3",
    inputs: INPUTS,
    work: Work::Inside(|path, clock| combined(path, clock, "a | b")),
};

pub(super) const FLOWERS: Task = Task {
    name: "yin-flowers",
    about: "meet and join of two flowers of cubic pieces, two a lobe, and the residual of their areas",
    extension: "raw3",
    inputs: &["flower_2000", "flower_4000", "flower_8000"],
    work: Work::Inside(flowers),
};

pub(super) const FIT: Task = Task {
    name: "spline-fit",
    about: "the periodic cubic spline through the points of a polygon",
    extension: "raw3",
    inputs: &["circle_250000", "circle_500000", "circle_1000000"],
    work: Work::Inside(fitted),
};

pub(super) const NESTED: Task = Task {
    name: "yin-nested",
    about: "the Yin set of squares one around the other, with forest, and the check that they are its boundary",
    extension: "raw3",
    inputs: &["nested_8000", "nested_16000", "nested_32000", "nested_64000"],
    work: Work::Inside(nested),
};

pub(super) const RINGS: Task = Task {
    name: "yin-rings",
    about: "the Yin set of cubic splines one around the other, with forest, and the check that they are its boundary",
    extension: "raw3",
    inputs: &["nested_500", "nested_1000", "nested_2000", "nested_4000"],
    work: Work::Inside(splines),
};

pub(super) const DISKS: Task = Task {
    name: "yin-disks",
    about: "the Yin set of cubic splines beside each other, one for four edges, with forest, and the check that they are its boundary",
    extension: "raw3",
    inputs: &["grid_16000", "grid_64000", "grid_256000"],
    work: Work::Inside(splines),
};

pub(super) const CUT: Task = Task {
    name: "yin-cut-cells",
    about: "a cubic spline on a grid of 256 x 256 cells, at the origin and moved by 100 and 10,000 times its radius",
    extension: "raw3",
    inputs: &["circle_1000", "circle_10000", "circle_100000"],
    work: Work::Inside(cut),
};

const INPUTS: &[&str] = &["gear_100000", "random_100000", "circle_1000000", "grid_1000000"];

fn combined(path: &Path, clock: &mut Clock, formula: &str) -> Result<String, Error> {
    let (positions, mesh) = drawing(path)?;
    let points = positions.as_flat().as_chunks::<2>().0;
    let mut rings: [Vec<Vec<[f64; 2]>>; 2] = Default::default();
    for ring in mesh.lists.iter() {
        let region = mesh.coordinates[3 * ring[0] as usize + 2] as usize;
        rings[region].push(ring.iter().map(|&point| points[point as usize]).collect());
    }
    let sets = [
        YinSet::from_rings(&rings[0], InsideRule::Nonzero)?,
        YinSet::from_rings(&rings[1], InsideRule::Nonzero)?,
    ];
    let formula = BooleanFormula::parse(formula, &[])?;
    let found = clock.time(mesh.vertex_count, || YinSet::combine(&[&sets[0], &sets[1]], &formula))?;
    let [positive, negative] = found.set().curve_counts();
    let signed_area = found.set().signed_area();
    Ok(format!("curves {positive}+{negative} pieces {} area {signed_area:e}", found.sources().len()))
}

fn flowers(path: &Path, clock: &mut Clock) -> Result<String, Error> {
    let (positions, mesh) = drawing(path)?;
    let points = positions.as_flat().as_chunks::<2>().0;
    let mut sets = Vec::with_capacity(2);
    for ring in mesh.lists.iter() {
        let mut knots: Vec<[f64; 2]> = ring.iter().map(|&point| points[point as usize]).collect();
        knots.push(knots[0]);
        sets.push(YinSet::new(&[Curve::fit(&knots, Order::CUBIC, &EndCondition::Periodic)?])?);
    }
    let [a, b] = &sets[..] else { return Err(Error::invalid("there are not two polygons")) };
    let [meet, join] = clock.time(mesh.vertex_count, || {
        let found = ["a & b", "a | b"].map(|formula| {
            BooleanFormula::parse(formula, &[]).and_then(|formula| YinSet::combine(&[a, b], &formula))
        });
        let [meet, join] = found;
        Ok::<_, Error>([meet?, join?])
    })?;
    let area = |set: &YinSet| set.signed_area();
    let whole = area(a) + area(b);
    let residual = (whole - area(meet.set()) - area(join.set())).abs() / whole;
    let [crossings, uncertified] = [meet.set().kinks().len(), meet.report().len() + join.report().len()];
    Ok(format!("kinks {crossings} uncertified {uncertified} residual {residual:.1e}"))
}

fn nested(path: &Path, clock: &mut Clock) -> Result<String, Error> {
    let (positions, mesh) = drawing(path)?;
    let points = positions.as_flat().as_chunks::<2>().0;
    let rings: Vec<Vec<[f64; 2]>> =
        mesh.lists.iter().map(|ring| ring.iter().map(|&point| points[point as usize]).collect()).collect();
    let (set, fault) = clock.time(mesh.vertex_count, || {
        let set = YinSet::from_rings(&rings, InsideRule::Odd)?;
        let fault = set.validate()?;
        Ok::<_, Error>((set, fault))
    })?;
    let [positive, negative] = set.curve_counts();
    let depth = (0..set.curve_count()).map(|curve| set.forest().depth(curve)).max();
    Ok(format!("curves {positive}+{negative} depth {} fault {fault:?}", depth.unwrap_or(0)))
}

fn splines(path: &Path, clock: &mut Clock) -> Result<String, Error> {
    let (positions, mesh) = drawing(path)?;
    let points = positions.as_flat().as_chunks::<2>().0;
    let curve = |ring: &[u32]| {
        let ring: Vec<[f64; 2]> = ring.iter().map(|&point| points[point as usize]).collect();
        Curve::fit_closed(&ring, &[], Order::CUBIC, &EndCondition::NotAKnot)
    };
    // Grids of squares are drawn twice, moved: the first is taken.
    let first = mesh.coordinates[2];
    let own = mesh.lists.iter().filter(|ring| mesh.coordinates[3 * ring[0] as usize + 2] == first);
    let curves = own.map(curve).collect::<Result<Vec<_>, _>>()?;
    let (set, fault) = clock.time(curves.iter().map(Curve::piece_count).sum(), || {
        let set = YinSet::new(&curves)?;
        let fault = set.validate()?;
        Ok::<_, Error>((set, fault))
    })?;
    let [positive, negative] = set.curve_counts();
    Ok(format!("curves {positive}+{negative} area {:e} fault {fault:?}", set.signed_area()))
}

fn cut(path: &Path, clock: &mut Clock) -> Result<String, Error> {
    let (positions, mesh) = drawing(path)?;
    let points = positions.as_flat().as_chunks::<2>().0;
    let ring: Vec<[f64; 2]> = mesh.lists.list(0).iter().map(|&point| points[point as usize]).collect();
    let curve = Curve::fit_closed(&ring, &[], Order::CUBIC, &EndCondition::NotAKnot)?;
    let [low, high] = curve.bounding_box();
    let radius = 0.5 * (high[0] - low[0]);
    let sets = [0.0, 100.0, 10_000.0].map(|times| YinSet::new(&[curve.translated([times * radius; 2])]));
    let mut found = String::new();
    clock.time(ring.len(), || {
        for set in sets {
            let set = set?;
            let [low, high] = set.bounding_box().ok_or_else(|| Error::invalid("there is no curve"))?;
            let spacing = [0, 1].map(|axis| (high[axis] - low[axis]) * 1.01 / 256.0);
            let cells = CutCells::new(&set, CartesianGrid::new(low, spacing, [256; 2])?)?;
            found = format!("area {:.9e} length {:.9e}", cells.total_area(), cells.total_length());
        }
        Ok::<_, Error>(())
    })?;
    Ok(found)
}

fn fitted(path: &Path, clock: &mut Clock) -> Result<String, Error> {
    let (positions, mesh) = drawing(path)?;
    let points = positions.as_flat().as_chunks::<2>().0;
    let ring = mesh.lists.iter().next().ok_or_else(|| Error::invalid("there is no polygon"))?;
    let mut closed: Vec<[f64; 2]> = ring.iter().map(|&point| points[point as usize]).collect();
    closed.push(closed[0]);
    let count = closed.len() - 1;
    let curve = clock.time(count, || Curve::fit(&closed, Order::CUBIC, &EndCondition::Periodic))?;
    Ok(format!("pieces {} area {:e}", curve.piece_count(), curve.signed_area()))
}
