//! Universal covers as flat pictures: copies of the domain in the plane or in the disk of Poincare, with their deck transformations. Edges in
//! the disk are lines of the hyperbolic plane.

use super::domain::Mesh;
use super::geodesics::Disk;
use super::reading::Entries;
use super::shown::{Letter, Shown};
use super::{Layer, Pane};

/// Covers of more faces are shown by the edges between copies only.
const MOST_FACES: usize = 100_000;

/// So many copies have their words written on them.
const MOST_WORDS: usize = 200;

/// So many words can be read beside each other.
const FEW_WORDS: usize = 40;

/// The circle around the hyperbolic plane has so many sides.
const CIRCLE: u32 = 256;

/// The picture of a cover that has a layout.
pub(super) fn cover_pane(result: &Shown) -> Option<Pane> {
    let words: Vec<&[Letter]> = result.words.given()?.iter().map(Entries::list).collect();
    let copy = &result.copy.0;
    let mesh = Mesh::of(result)?;
    let positions: Vec<[f64; 2]> = result
        .positions
        .list()
        .iter()
        .map(|point| match point.list() {
            [x, y, ..] => Some([x.0, y.0]),
            _ => None,
        })
        .collect::<Option<_>>()?;
    let (is_disk, plane) = match result.layout.0.as_deref()? {
        "disk" => (true, "disk of Poincare"),
        "klein" => (false, "disk of Klein"),
        "flat" => (false, "plane"),
        _ => return None,
    };
    let is_fit = copy.len() == mesh.walks.len() && copy.iter().all(|&copy| (copy as usize) < words.len());
    if positions.len() != mesh.source.len() || !is_fit {
        return None;
    }
    let mut pane = Pane { name: format!("universal cover in the {plane}"), positions, ..Pane::default() };
    let mut layers = Vec::new();
    if mesh.walks.len() <= MOST_FACES {
        // Copies alternate in color by the length of their words.
        for parity in 0..2 {
            let word = if parity == 0 { "even" } else { "odd" };
            let mut layer = Layer::new("cover", format!("copies at {word} distance"));
            for (walk, &copy) in mesh.walks.iter().zip(copy) {
                if words[copy as usize].len() % 2 != parity {
                    continue;
                }
                let mut fan = Layer::default();
                fan.push_fan(walk);
                for triangle in fan.triangles {
                    match is_disk {
                        true => {
                            let mut disk = Disk { positions: &mut pane.positions };
                            disk.triangle(triangle, &mut layer.triangles);
                        }
                        false => layer.triangles.push(triangle),
                    }
                }
            }
            layer.color = Some(if parity == 0 { 5 } else { 4 });
            layers.push(layer);
        }
    }
    // Sides of two faces: within a copy they are edges, else they are in the color of their letter.
    let mut sides: Vec<([u32; 2], usize)> =
        mesh.sides().map(|([a, b], face)| ([a.min(b), a.max(b)], face)).collect();
    sides.sort_unstable();
    let mut letters: Vec<([u32; 2], usize)> = result
        .letters
        .list()
        .iter()
        .enumerate()
        .filter_map(|(letter, edge)| match edge.0[..] {
            [a, b] => Some(([a.min(b), a.max(b)], letter)),
            _ => None,
        })
        .collect();
    letters.sort_unstable();
    let mut edges = Layer::new("cover", "edges");
    let mut seams = Layer::new("cover", "sides of copies");
    let mut by_letter: Vec<Layer> = (0..letters.len())
        .map(|letter| {
            let mut layer = Layer::new("cover", format!("side {}", letter_name(letter + 1)));
            layer.color = Some(letter as u32);
            layer
        })
        .collect();
    for uses in sides.chunk_by(|a, b| a.0 == b.0) {
        let side = uses[0].0;
        let line = match is_disk {
            true => Disk { positions: &mut pane.positions }.line(side[0], side[1]),
            false => side.to_vec(),
        };
        if uses.len() == 2 && copy[uses[0].1] == copy[uses[1].1] {
            if mesh.walks.len() <= MOST_FACES {
                edges.lines.push(&line);
            }
            continue;
        }
        let [a, b] = mesh.below(side);
        match letters.binary_search_by_key(&[a.min(b), a.max(b)], |letter| letter.0) {
            Ok(found) => by_letter[letters[found].1].lines.push(&line),
            Err(_) => seams.lines.push(&line),
        }
    }
    layers.push(edges);
    layers.push(seams);
    layers.extend(by_letter);
    if is_disk {
        let mut circle = Layer::new("cover", "circle at infinity");
        let first = pane.positions.len() as u32;
        pane.positions.extend((0..CIRCLE).map(|i| {
            let turn = std::f64::consts::TAU * f64::from(i) / f64::from(CIRCLE);
            [turn.cos(), turn.sin()]
        }));
        circle.lines.push(&(first..first + CIRCLE).chain([first]).collect::<Vec<_>>());
        layers.push(circle);
    }
    for mut layer in layers {
        layer.is_on = true;
        if !layer.is_empty() {
            pane.layers.push(layer);
        }
    }
    let mut names = Layer::new("cover", "deck transformations");
    names.is_on = words.len() <= FEW_WORDS;
    for (place, word) in
        middles(&mesh, copy, &pane.positions, words.len()).into_iter().zip(words).take(MOST_WORDS)
    {
        names.labels.push((pane.positions.len() as u32, word_text(word)));
        pane.positions.push(place);
    }
    pane.layers.push(names);
    Some(pane)
}

/// The middle of the corners of the faces of each copy.
fn middles(mesh: &Mesh<'_>, copy: &[u32], positions: &[[f64; 2]], count: usize) -> Vec<[f64; 2]> {
    let mut sums = vec![[0.0; 3]; count];
    for (walk, &copy) in mesh.walks.iter().zip(copy) {
        for &vertex in *walk {
            let [x, y] = positions[vertex as usize];
            let sum = &mut sums[copy as usize];
            *sum = [sum[0] + x, sum[1] + y, sum[2] + 1.0];
        }
    }
    sums.into_iter().map(|[x, y, n]| [x / n.max(1.0), y / n.max(1.0)]).collect()
}

/// a, b, .., then x27, x28, ..
fn letter_name(letter: usize) -> String {
    match u32::try_from(letter).ok().filter(|letter| (1..=26).contains(letter)) {
        Some(letter) => char::from_u32('a' as u32 + letter - 1).unwrap_or('?').to_string(),
        None => format!("x{letter}"),
    }
}

/// A word of letters such as a b⁻¹; 1 if it is empty.
fn word_text(word: &[Letter]) -> String {
    let letters: Vec<String> = word
        .iter()
        .map(|letter| {
            let name = letter_name(letter.0.unsigned_abs() as usize);
            if letter.0 < 0 { format!("{name}\u{207b}\u{b9}") } else { name }
        })
        .collect();
    if letters.is_empty() { "1".to_owned() } else { letters.join("") }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn copies_have_their_words() {
        let mut result = json!({
            "facets": [[0, 1, 2], [1, 3, 2]], "source": [0, 1, 2, 0], "copy": [0, 1], "words": [[], [-1]],
            "positions": [[0.0, 0.0], [0.5, 0.0], [0.0, 0.5], [0.5, 0.5]], "letters": [[1, 2]], "layout": "flat",
        });
        let pane = cover_pane(&Shown::of("r", result.clone()).unwrap()).unwrap();
        assert_eq!(pane.name, "universal cover in the plane");
        let names = &pane.layers.last().unwrap().labels;
        assert_eq!([&names[0].1[..], &names[1].1[..]], ["1", "a\u{207b}\u{b9}"]);
        let side = pane.layers.iter().find(|layer| layer.name == "side a").unwrap();
        assert_eq!(side.lines.items(), [1, 2]);
        result["copy"] = json!([0, 7]);
        assert!(cover_pane(&Shown::of("r", result).unwrap()).is_none());
    }
}
