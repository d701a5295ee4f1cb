//! Sets of the plane with curved boundaries.

use super::forest::{NestedCurve, forest_pane};
use super::parts::Parts;
use super::regions::holes_text;
use super::shading::triangulated_walks;
use super::{Layer, Scene, SceneReport};
use coface_algebra::Error;
use coface_algebra::RaggedArray;
use coface_answers::PlanarSet;
use coface_answers::answer::YinCurve;
use coface_io::yin::flattened;
use coface_yin::Order;

/// So many names are written beside kinks at most.
const MOST_NAMES: usize = 200;

/// The part of the extent of a set that its chords keep from its curves.
const FINENESS: f64 = 2e-4;

impl Scene {
    /// The scene of a set in the plane: its components filled, its curves as fine chords, knots, kinks, the control points of splines, and
    /// the forest of curves in curves beside it. Vertices are the knots, curve after curve.
    ///
    /// # Errors
    /// Those of [`PlanarSet::answer`].
    ///
    /// # Examples
    /// ```
    /// use coface_answers::PlanarSet;
    /// use coface_pictures::Scene;
    /// use coface_yin::{Curve, Order, YinSet};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let circle = Curve::circle([0.0, 0.0], 1.0, 8, Order::CUBIC)?;
    /// let scene = Scene::of_set("disk", &PlanarSet::from_set(YinSet::new(&[circle])?))?;
    /// assert_eq!((scene.positions().len(), scene.panes().len()), (8, 1));
    /// # Ok(()) }
    /// ```
    pub fn of_set(title: &str, set: &PlanarSet) -> Result<Self, Error> {
        let answer = set.answer()?;
        let curves: Vec<_> = (0..set.set().curve_count()).map(|curve| set.set().curve(curve)).collect();
        let mut starts = vec![0u32];
        let mut knots: Vec<[f64; 3]> = Vec::new();
        let lift = |[x, y]: [f64; 2]| [x, y, 0.0];
        for curve in &curves {
            knots.extend((0..curve.piece_count()).map(|knot| lift(curve.knot_point(knot))));
            starts.push(knots.len() as u32);
        }
        let points: Vec<[u32; 1]> = (0..knots.len() as u32).map(|knot| [knot]).collect();
        let mut scene = Self::flat(
            title,
            knots,
            Parts { simplices: RaggedArray::from_lists(points), ..Parts::default() },
        );
        let [low, high] = set.bounding_box().unwrap_or([[0.0; 2], [1.0; 2]]);
        let extent = (high[0] - low[0]).max(high[1] - low[1]);
        let chords = curves.iter().map(|curve| match curve.order() {
            Order::LINEAR => Ok((0..curve.piece_count()).map(|knot| curve.knot_point(knot)).collect()),
            _ => flattened(curve, (FINENESS * extent).max(f64::MIN_POSITIVE)),
        });
        let mut chords: Vec<Vec<[f64; 2]>> = chords.collect::<Result<_, _>>()?;
        // What is unbounded is shown within a frame.
        let margin = 0.15 * if extent > 0.0 { extent } else { 1.0 };
        let [x, y] = low.map(|x| x - margin);
        let [u, v] = high.map(|x| x + margin);
        chords.push(vec![[x, y], [u, y], [u, v], [x, v]]);
        let frame = chords.len() - 1;
        let mut atoms: Vec<Vec<usize>> =
            set.set().atoms().iter().map(|atom| atom.curves().collect()).collect();
        if set.set().is_plane() {
            atoms.push(Vec::new());
        }
        for (number, atom) in atoms.iter_mut().enumerate() {
            let is_bounded = atom.first().is_some_and(|&curve| set.set().is_positive(curve));
            if !is_bounded {
                atom.insert(0, frame);
            }
            let mut layer = Layer::new("set", format!("component {number}"));
            let holes = atom.len() - 1;
            let bounded = if is_bounded { "bounded" } else { "unbounded, shown within a frame" };
            layer.detail =
                if holes > 0 { format!("{bounded}, {}", holes_text(holes)) } else { bounded.to_owned() };
            layer.is_on = true;
            let (points, triangles) = filled_component(atom, &chords);
            layer.triangles = triangles;
            layer.positions = Some(points);
            scene.push_layer(layer);
        }
        let mut all_kinks = Layer::new("knots", "kinks");
        let mut controls = Layer::new("knots", "control points");
        let mut control_points = Vec::new();
        for (number, curve) in curves.iter().enumerate() {
            let facts = &answer.curves[number];
            let mut layer = Layer::new("curves", format!("curve {number}"));
            let sign = if facts.sign == -1 { "clockwise" } else { "counterclockwise" };
            let name = facts.name.as_ref().map_or_else(String::new, |name| format!("{name}, "));
            layer.detail = format!("{name}{sign}, {} knots", curve.piece_count());
            layer.is_on = true;
            let line: Vec<u32> = (0..chords[number].len() as u32).chain([0]).collect();
            layer.lines.push(&line);
            layer.positions = Some(chords[number].iter().copied().map(lift).collect());
            scene.push_layer(layer);
            if curve.order() > Order::LINEAR {
                for piece in 0..curve.piece_count() {
                    let first = control_points.len() as u32;
                    control_points.extend(curve.piece(piece).iter().copied().map(lift));
                    let last = control_points.len() as u32;
                    controls.lines.push(&(first..last).collect::<Vec<_>>());
                    controls.points.extend(first + 1..last - 1);
                }
            }
        }
        for (knot, vertex) in set.set().kinks().iter() {
            let point = starts[knot.curve as usize] + knot.knot;
            all_kinks.points.push(point);
            all_kinks.labels.push((point, format!("{vertex:?}")));
        }
        if all_kinks.labels.len() > MOST_NAMES {
            all_kinks.labels.clear();
        }
        all_kinks.detail = format!("{} of them", all_kinks.points.len());
        all_kinks.is_on = true;
        let mut all_knots = Layer::new("knots", "knots");
        all_knots.points = (0..scene.positions.len() as u32).collect();
        all_knots.detail = format!("{} of them", all_knots.points.len());
        all_knots.is_on = all_knots.points.len() <= 2000;
        controls.detail = format!("of {} pieces", controls.lines.len());
        controls.positions = Some(control_points);
        for layer in [all_knots, all_kinks, controls] {
            scene.push_layer(layer);
        }
        let nested = |curve: &YinCurve| NestedCurve { parent: curve.parent, is_clockwise: curve.sign == -1 };
        scene.panes.extend(forest_pane(&answer.curves.iter().map(nested).collect::<Vec<_>>()));
        scene.report = Some(SceneReport::Set(Box::new(answer)));
        Ok(scene)
    }
}

/// The chords around a component of a set, and triangles of their ends that fill it.
pub(super) fn filled_component(atom: &[usize], chords: &[Vec<[f64; 2]>]) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let points: Vec<[f64; 2]> = atom.iter().flat_map(|&curve| &chords[curve]).copied().collect();
    let mut start = 0;
    let walks = atom.iter().map(|&curve| {
        start += chords[curve].len() as u32;
        (start - chords[curve].len() as u32..start).collect()
    });
    let walks: Vec<Vec<u32>> = walks.collect();
    // Chords that cross where curves only touch leave a component unfilled.
    let triangles = triangulated_walks(walks, &|i| points[i as usize]).unwrap_or_default();
    (points.into_iter().map(|[x, y]| [x, y, 0.0]).collect(), triangles)
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_io as io;
    use coface_io::Format;
    use coface_yin::{Curve, YinSet};

    fn area(layer: &Layer, positions: &[[f64; 3]]) -> f64 {
        let positions = layer.positions.as_deref().unwrap_or(positions);
        let at = |vertex: u32| [positions[vertex as usize][0], positions[vertex as usize][1]];
        let cross = |[[a, b], [c, d], [e, f]]: [[f64; 2]; 3]| (c - a) * (f - b) - (e - a) * (d - b);
        layer.triangles.iter().map(|triangle| 0.5 * cross(triangle.map(at))).sum()
    }

    #[test]
    fn polygons_with_holes_are_filled_whatever_way_their_rings_run() {
        let text = b"POLYGON ((0 0, 0 9, 9 9, 9 0, 0 0), (1 1, 2 1, 2 2, 1 2, 1 1))";
        let scene = Scene::of("polygon", &io::read(&text[..], Format::Wkt).unwrap()).unwrap();
        assert_eq!(scene.layers().len(), 1);
        assert_eq!(area(&scene.layers()[0], scene.positions()), 80.0);
    }

    #[test]
    fn sets_have_components_curves_knots_and_a_forest() {
        let outer = Curve::circle([0.0, 0.0], 2.0, 8, Order::CUBIC).unwrap();
        let inner = Curve::circle([0.0, 0.0], 1.0, 4, Order::CUBIC).unwrap().reversed();
        let set = PlanarSet::from_set(YinSet::new(&[outer, inner]).unwrap());
        let scene = Scene::of_set("ring", &set).unwrap();
        let names: Vec<&str> = scene.layers().iter().map(|layer| &layer.name[..]).collect();
        assert_eq!(names, ["component 0", "curve 0", "curve 1", "knots", "control points"]);
        let found = area(&scene.layers()[0], scene.positions());
        assert!((found - set.set().area().unwrap()).abs() < 1e-2, "{found}");
        assert_eq!(scene.panes()[0].name, "Hasse forest");
        // The complement is filled up to a frame.
        let outside = PlanarSet::from_set(set.set().complement().unwrap());
        let scene = Scene::of_set("outside", &outside).unwrap();
        let filled: f64 = scene.layers()[..2].iter().map(|layer| area(layer, scene.positions())).sum();
        assert!((filled - (5.2 * 5.2 - found)).abs() < 1e-2, "{filled}");
    }
}
