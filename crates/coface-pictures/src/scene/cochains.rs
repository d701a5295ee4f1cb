//! Cochains on edges: arrows, and lines of equal potential.

use super::numbering::Numbering;
use super::shown::{Chain, Harmonic, Number, Shown};
use super::{Layer, Scene};

/// Arrows are drawn on the strongest edges, at most so many.
const MOST_ARROWS: usize = 20_000;

/// Lines of equal potential are drawn so often between one integer and the next.
const LEVELS: f64 = 8.0;

/// A real value on the direction from the lower to the higher end of each edge.
struct Form {
    values: Vec<([u32; 2], f64)>,
}

impl Form {
    /// The form with these values on edges, whose ends have the numbers of the model.
    fn new<'a>(terms: impl Iterator<Item = (&'a [u32], f64)>, numbering: &Numbering) -> Self {
        let mut values: Vec<([u32; 2], f64)> = terms
            .map(|(ends, value)| (ends.iter().map(|&end| numbering.of(end)).collect::<Vec<u32>>(), value))
            .filter_map(|(ends, value)| match *ends {
                [a, b] if a <= b => Some(([a, b], value)),
                [a, b] => Some(([b, a], -value)),
                _ => None,
            })
            .collect();
        values.sort_by_key(|term| term.0);
        Self { values }
    }

    /// The value on the way from one vertex to another, 0 where there is no edge.
    fn value(&self, from: u32, to: u32) -> f64 {
        let key = [from.min(to), from.max(to)];
        let found = self.values.binary_search_by_key(&key, |term| term.0);
        found.map_or(0.0, |at| if from <= to { self.values[at].1 } else { -self.values[at].1 })
    }

    fn largest(&self) -> f64 {
        self.values.iter().map(|term| term.1.abs()).fold(0.0, f64::max)
    }

    fn last_vertex(&self) -> Option<u32> {
        self.values.iter().map(|term| term.0[1]).max()
    }
}

/// Cocycles of integers: arrows on the edges where they are not zero.
pub(super) fn cocycle_layers(result: &Shown, layers: &mut Vec<Layer>) {
    for (number, cocycle) in result.cocycles.list().iter().enumerate() {
        let mut layer = Layer::new("cocycles", format!("cocycle {}", number + 1));
        cocycle.push_onto(&mut layer);
        layer.detail = format!("not zero on {} edges", cocycle.0.len());
        layer.has_arrows = true;
        layer.is_on = number == 0 && result.harmonic.given().is_none();
        layers.push(layer);
    }
}

impl Scene {
    /// Harmonic forms: arrows as long as they are strong, and lines of equal potential, which cross the loops that the form counts.
    pub(super) fn harmonic_layers(&self, result: &Shown) -> Vec<Layer> {
        let edges = result.edges.list();
        let with_values = result.harmonic.list().iter().filter_map(|form| match form {
            Harmonic::Values(form) => {
                let values = form.values.given().filter(|values| values.len() == edges.len())?;
                let terms = edges.iter().zip(values).map(|(edge, value)| (&edge.0[..], value.0));
                Some(Form::new(terms, &self.numbering))
            }
            Harmonic::Degree(_) => None,
        });
        // Those of degree 1 are on edges.
        let of_edges = match result.harmonic.list().get(1) {
            Some(Harmonic::Degree(forms)) => &forms[..],
            _ => &[],
        };
        let with_chains = of_edges.iter().map(|form| {
            let terms = form.chain.0.iter().map(|term| (&term.cell[..], term.coefficient.0));
            Form::new(terms, &self.numbering)
        });
        let mut layers = Vec::new();
        for (number, form) in with_values.chain(with_chains).enumerate() {
            let mut arrows = self.arrows(&form, form.largest());
            arrows.name = format!("harmonic form {}, arrows", number + 1);
            arrows.is_on = number == 0;
            arrows.color = Some(number as u32);
            let mut lines = self.level_lines(&form);
            lines.name = format!("harmonic form {}, isolines", number + 1);
            lines.detail = format!("{LEVELS} to a period");
            lines.color = Some(number as u32);
            layers.extend([arrows, lines]);
        }
        layers
    }

    /// A cochain of the user's own, and the parts that one is the sum of: arrows on edges, as long as they are strong beside the strongest
    /// of all; cells of other degrees where the value is not zero.
    pub(super) fn real_layers(&self, result: &Shown) -> Vec<Layer> {
        let mut layers: Vec<Layer> =
            result.chain.iter().map(|chain| self.real_layer(chain, "chain", largest(chain))).collect();
        if let Some(parts) = &result.decomposition {
            let named = [
                ("exact part", &parts.exact),
                ("coexact part", &parts.coexact),
                ("harmonic part", &parts.harmonic),
            ];
            let most = named.iter().map(|(_, chain)| largest(chain)).fold(0.0, f64::max);
            layers.extend(named.map(|(name, chain)| self.real_layer(chain, name, most)));
        }
        for (place, layer) in (0..).zip(&mut layers) {
            layer.color = Some(place);
            layer.is_on = true;
        }
        layers
    }

    fn real_layer(&self, chain: &Chain<Number>, name: &str, most: f64) -> Layer {
        let terms = || chain.0.iter().map(|term| (&term.cell[..], term.coefficient.0));
        let mut layer = if terms().all(|(cell, _)| cell.len() == 2) {
            self.arrows(&Form::new(terms(), &self.numbering), most)
        } else {
            let mut layer = Layer::new("", "");
            // Zero but for rounding is not drawn.
            for (cell, value) in terms().filter(|term| term.1.abs() > 1e-9 * most) {
                layer.push_term(cell, value < 0.0);
            }
            layer.detail = format!("largest value {:.4}", largest(chain));
            layer
        };
        layer.group = "cochains".to_owned();
        layer.name = name.to_owned();
        layer
    }

    fn arrows(&self, form: &Form, most: f64) -> Layer {
        let mut layer = Layer::new("harmonic forms", "");
        layer.has_arrows = true;
        let mut terms = form.values.clone();
        terms.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
        let mut positions = Vec::new();
        if form.last_vertex().is_none_or(|last| last as usize >= self.positions.len()) {
            // It belongs to another model; who asks says so.
            layer.points.push(form.last_vertex().unwrap_or(0));
            return layer;
        }
        for (ends, value) in terms.into_iter().take(MOST_ARROWS) {
            let share = value / most;
            // Below the hundredth part nothing would be seen.
            if share.abs() < 0.01 || !share.is_finite() {
                break;
            }
            if ends.iter().any(|&end| self.is_hidden(end)) {
                continue;
            }
            let [a, b] = ends.map(|end| self.positions[end as usize]);
            let at = |t: f64| [0, 1, 2].map(|axis| (1.0 - t) * a[axis] + t * b[axis]);
            let first = positions.len() as u32;
            positions.extend([at(0.5 - 0.5 * share), at(0.5 + 0.5 * share)]);
            layer.lines.push(&[first, first + 1]);
        }
        layer.detail = format!("largest value {:.4}", form.largest());
        layer.positions = Some(positions);
        layer
    }

    /// Where a potential of the form is a multiple of a part of 1. On closed walks the form has integer sums, so lines meet across edges.
    fn level_lines(&self, form: &Form) -> Layer {
        let mut layer = Layer::new("harmonic forms", "");
        let count = self.positions.len();
        let mut positions = Vec::new();
        if form.last_vertex().is_some_and(|last| (last as usize) < count) {
            let potential = potential(count, form);
            for &[a, b, c] in &self.triangles {
                let base = potential[a as usize];
                let heights = [0.0, form.value(a, b), form.value(a, c)].map(|step| LEVELS * (base + step));
                let corners = [a, b, c].map(|v| self.positions[v as usize]);
                let low = heights.iter().copied().fold(f64::INFINITY, f64::min).ceil();
                let high = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                // A form that goes around more than that within one triangle has no lines to be seen.
                for level in (0..64).map(|i| low + f64::from(i)).take_while(|&level| level < high) {
                    let mut ends = Vec::with_capacity(2);
                    for (i, j) in [(0, 1), (1, 2), (2, 0)] {
                        if (heights[i] <= level) != (heights[j] <= level) {
                            let t = (level - heights[i]) / (heights[j] - heights[i]);
                            ends.push(
                                [0, 1, 2].map(|axis| corners[i][axis] * (1.0 - t) + corners[j][axis] * t),
                            );
                        }
                    }
                    if ends.len() == 2 {
                        let first = positions.len() as u32;
                        positions.extend(ends);
                        layer.lines.push(&[first, first + 1]);
                    }
                }
            }
        }
        layer.positions = Some(positions);
        layer
    }
}

/// The largest absolute value.
fn largest(chain: &Chain<Number>) -> f64 {
    chain.0.iter().map(|term| term.coefficient.0.abs()).fold(0.0, f64::max)
}

/// A potential along a spanning forest of the edges: 0 at the lowest vertex of each component. $O(n \log n)$.
fn potential(vertex_count: usize, form: &Form) -> Vec<f64> {
    let mut steps: Vec<(u32, u32, f64)> = Vec::with_capacity(2 * form.values.len());
    for &([a, b], value) in &form.values {
        steps.extend([(a, b, value), (b, a, -value)]);
    }
    steps.sort_by_key(|step| (step.0, step.1));
    let mut found: Vec<Option<f64>> = vec![None; vertex_count];
    for root in 0..vertex_count {
        if found[root].is_some() {
            continue;
        }
        found[root] = Some(0.0);
        let mut queue = std::collections::VecDeque::from([(root as u32, 0.0)]);
        while let Some((vertex, height)) = queue.pop_front() {
            let first = steps.partition_point(|step| step.0 < vertex);
            for &(_, next, value) in steps[first..].iter().take_while(|step| step.0 == vertex) {
                if found[next as usize].is_none() {
                    found[next as usize] = Some(height + value);
                    queue.push_back((next, height + value));
                }
            }
        }
    }
    found.into_iter().map(|height| height.unwrap_or(0.0)).collect()
}

#[cfg(test)]
mod tests {
    use crate::Scene;
    use coface_io as io;
    use coface_io::Format;
    use serde_json::json;

    /// Three arrows beside one of twice their length, and the parts of a sum beside each other.
    #[test]
    fn cochains_of_the_user_are_drawn_by_their_values() {
        let triangle = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj).unwrap();
        let mut scene = Scene::of("triangle", &triangle).unwrap();
        scene.add_result("own", &json!([[1, [0, 1]], [-0.5, [1, 2]]])).unwrap();
        let points = scene.layers()[0].positions.clone().unwrap();
        assert_eq!(points, [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.25, 0.75, 0.0], [0.75, 0.25, 0.0]]);
        let part = |value: f64| json!([[value, [0, 1]]]);
        let parts = json!({"exact": part(2.0), "coexact": part(1e-15), "harmonic": part(1.0)});
        scene.add_result("parts", &json!({"decomposition": parts})).unwrap();
        let lines: Vec<usize> = scene.layers()[1..].iter().map(|layer| layer.lines.len()).collect();
        // A part that is zero but for rounding is none.
        assert_eq!(lines, [1, 1]);
        scene.add_result("faces", &json!({"degree": 2, "chain": [[3, [0, 1, 2]]]})).unwrap();
        assert_eq!(scene.layers()[3].triangles, [[0, 1, 2]]);
        let fault = scene.add_result("other", &json!([[1, [0, 9]]])).unwrap_err();
        assert!(fault.message().contains("has vertex 9"), "{fault}");
    }

    /// A closed band of four squares, each cut into two triangles, and the form that goes around it once.
    #[test]
    fn lines_of_equal_potential_cross_the_band() {
        let mut text = String::new();
        for (x, y) in [(0, 0), (1, 0), (1, 1), (0, 1)] {
            text += &format!("v {x} {y} 0\nv {x} {y} 1\n");
        }
        let mut terms = Vec::new();
        for i in 0..4 {
            let [a, b, c, d] = [2 * i, 2 * i + 1, (2 * i + 2) % 8, (2 * i + 3) % 8];
            text += &format!("f {} {} {}\nf {} {} {}\n", a + 1, c + 1, d + 1, a + 1, d + 1, b + 1);
            terms.extend([(0.25, [a, c]), (0.25, [a, d]), (0.25, [b, d]), (0.0, [a, b])]);
        }
        let mut with = Scene::of("band", &io::read(text.as_bytes(), Format::Obj).unwrap()).unwrap();
        with.add_result("forms", &json!({"harmonic": [[], [{"chain": terms}]]})).unwrap();
        let lines = with.layers().iter().find(|layer| layer.name.ends_with("isolines")).unwrap();
        // Eight levels, each through two triangles or along an edge.
        let positions = lines.positions.as_ref().unwrap();
        assert!((8..=16).contains(&lines.lines.len()), "{}", lines.lines.len());
        assert!(positions.iter().all(|p| [p[0], p[1]].iter().all(|x| (0.0..=1.0).contains(x))));
        let arrows = with.layers().iter().find(|layer| layer.name.ends_with("arrows")).unwrap();
        assert!(arrows.has_arrows && arrows.lines.len() == 12);
        // The same form does not fit a smaller model.
        let triangle = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj).unwrap();
        let mut other = Scene::of("triangle", &triangle).unwrap();
        let fault =
            other.add_result("forms", &json!({"harmonic": [[], [{"chain": [[1.0, [0, 7]]]}]]})).unwrap_err();
        assert!(fault.to_string().contains("vertex 7"), "{fault}");
    }
}
