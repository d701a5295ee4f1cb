//! Forests of curves in curves.

use super::{Layer, Pane};
use serde_json::Value;

/// The forest that a report on a set in the plane tells: each curve below the one directly around it.
pub(super) fn forest_pane(report: &Value) -> Option<Pane> {
    let curves = report["curves"].as_array().filter(|curves| !curves.is_empty())?;
    let count = curves.len();
    let parent = |curve: usize| curves[curve]["parent"].as_u64().map_or(count, |parent| parent as usize);
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
    for (curve, facts) in curves.iter().enumerate() {
        let place = usize::from(facts["sign"].as_i64() == Some(-1));
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
    use serde_json::json;

    #[test]
    fn curves_stand_below_what_is_around_them() {
        let report = json!({"curves": [
            {"sign": 1, "parent": null}, {"sign": -1, "parent": 0}, {"sign": -1, "parent": 0}, {"sign": 1, "parent": 2},
        ]});
        let pane = forest_pane(&report).unwrap();
        let heights: Vec<f64> = pane.positions.iter().map(|place| place[1]).collect();
        assert_eq!(heights, [-1.0, -2.0, -2.0, -3.0, 0.0]);
        assert_eq!(pane.positions[0][0], 0.5);
    }

    #[test]
    fn a_circle_of_parents_is_no_forest() {
        let report = json!({"curves": [{"parent": 1}, {"parent": 0}]});
        assert!(forest_pane(&report).is_none());
        assert!(forest_pane(&json!({"curves": [{"parent": 7}]})).is_none());
    }
}
