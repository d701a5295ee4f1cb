//! Forests of curves in curves.

use super::{Layer, Pane};

/// A curve among others.
pub(super) struct NestedCurve {
    /// The curve directly around it.
    pub(super) parent: Option<usize>,
    /// Whether it runs clockwise.
    pub(super) is_clockwise: bool,
}

/// The forest of curves in the plane: each curve below its parent, the one directly around it. None without curves, and where
/// the parents make no forest.
pub(super) fn forest_pane(curves: &[NestedCurve]) -> Option<Pane> {
    let count = curves.len();
    if count == 0 {
        return None;
    }
    let parent = |curve: usize| curves[curve].parent.unwrap_or(count);
    let mut children: Vec<Vec<usize>> = vec![Vec::new(); count + 1];
    for curve in 0..count {
        children.get_mut(parent(curve))?.push(curve);
    }
    // Leaves stand side by side, others over the middle of what lies in them; the last is what lies in no curve.
    let mut places = vec![None; count + 1];
    let mut leaf_count = 0.0;
    let mut stack = vec![(count, 0usize, false)];
    while let Some((node, depth, is_done)) = stack.pop() {
        match (children[node].first(), children[node].last()) {
            (Some(&first), Some(&last)) if is_done => {
                let [a, b]: [[f64; 2]; 2] = [places[first]?, places[last]?];
                places[node] = Some([f64::midpoint(a[0], b[0]), -(depth as f64)]);
            }
            (Some(_), _) => {
                stack.push((node, depth, true));
                stack.extend(children[node].iter().rev().map(|&child| (child, depth + 1, false)));
            }
            _ => {
                places[node] = Some([leaf_count, -(depth as f64)]);
                leaf_count += 1.0;
            }
        }
    }
    // What a walk from the outside did not come to lies in itself: no forest.
    let positions: Vec<[f64; 2]> = places.into_iter().collect::<Option<_>>()?;
    let mut pane = Pane { name: "Hasse forest".to_owned(), positions, ..Pane::default() };
    let mut arcs = Layer::new("forest", "directly around");
    (0..count).for_each(|curve| arcs.lines.push(&[parent(curve) as u32, curve as u32]));
    let mut layers = ["counterclockwise", "clockwise"].map(|name| Layer::new("forest", name));
    for (curve, nested) in curves.iter().enumerate() {
        let place = usize::from(nested.is_clockwise);
        layers[place].points.push(curve as u32);
        layers[place].labels.push((curve as u32, curve.to_string()));
    }
    let mut outside = Layer::new("forest", "outside");
    outside.points.push(count as u32);
    outside.labels.push((count as u32, "outside".to_owned()));
    let [positive, negative] = layers;
    for mut layer in [arcs, positive, negative, outside] {
        layer.is_on = true;
        if !layer.is_empty() {
            pane.layers.push(layer);
        }
    }
    Some(pane)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nested<const N: usize>(parents: [Option<usize>; N]) -> [NestedCurve; N] {
        parents.map(|parent| NestedCurve { parent, is_clockwise: false })
    }

    #[test]
    fn curves_stand_below_what_is_around_them() {
        let pane = forest_pane(&nested([None, Some(0), Some(0), Some(2)])).unwrap();
        let heights: Vec<f64> = pane.positions.iter().map(|place| place[1]).collect();
        assert_eq!(heights, [-1.0, -2.0, -2.0, -3.0, 0.0]);
        assert_eq!(pane.positions[0][0], 0.5);
    }

    #[test]
    fn a_circle_of_parents_is_no_forest() {
        assert!(forest_pane(&nested([Some(1), Some(0)])).is_none());
        assert!(forest_pane(&nested([Some(7)])).is_none());
    }
}
