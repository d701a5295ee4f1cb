//! Fundamental domains as flat pictures, their sides in the colors of the seams.

use super::shown::Shown;
use super::{Layer, Pane};
use coface_algebra::UnionFind;

/// Domains of more vertices are not laid out.
const MOST_VERTICES: usize = 200_000;

/// Where the equations of a layout are solved up to this part of their right side.
const RESIDUAL: f64 = 1e-9;

/// The faces of an answer that has a mesh of its own: walks, with the vertices of the model below.
pub(super) struct Mesh<'a> {
    pub(super) walks: Vec<&'a [u32]>,
    pub(super) source: &'a [u32],
}

impl<'a> Mesh<'a> {
    pub(super) fn of(result: &'a Shown) -> Option<Self> {
        let source = &result.source.0[..];
        let faces = result.facets.given().unwrap_or_else(|| result.polygons.list());
        let walks: Vec<&[u32]> = faces.iter().map(|face| &face.0[..]).collect();
        let is_fit = walks.iter().copied().flatten().all(|&vertex| (vertex as usize) < source.len());
        (!walks.is_empty() && is_fit).then_some(Self { walks, source })
    }

    /// The directed sides, each with its face.
    pub(super) fn sides(&self) -> impl Iterator<Item = ([u32; 2], usize)> + '_ {
        self.walks.iter().enumerate().flat_map(|(face, walk)| {
            (0..walk.len()).map(move |i| ([walk[i], walk[(i + 1) % walk.len()]], face))
        })
    }

    /// The ends of a side in the model.
    pub(super) fn below(&self, [a, b]: [u32; 2]) -> [u32; 2] {
        [self.source[a as usize], self.source[b as usize]]
    }
}

/// The domain of each component that was cut to a disk: its boundary is a circle, counterclockwise, with as much room for each seam, and
/// everything inside is where springs along the edges are in balance (W. T. Tutte, *How to draw a graph*, 1963).
pub(super) fn domain_panes(result: &Shown) -> Vec<Pane> {
    let components = result.components.list();
    let Some(mesh) = Mesh::of(result) else { return Vec::new() };
    if components.is_empty() || mesh.source.len() > MOST_VERTICES {
        return Vec::new();
    }
    // The edges of seams in the model: (rising ends, seam, whether the seam runs from the higher end), and seams one after the other.
    let mut seam_edges: Vec<([u32; 2], usize, bool)> = Vec::new();
    let mut colors = Vec::new();
    for component in components {
        for (place, seam) in component.seams.list().iter().enumerate() {
            for step in seam.vertices.0.windows(2) {
                seam_edges.push((
                    [step[0].min(step[1]), step[0].max(step[1])],
                    colors.len(),
                    step[0] > step[1],
                ));
            }
            colors.push((place as u32, seam.number.as_ref().map_or(place + 1, |number| number.0)));
        }
    }
    seam_edges.sort_unstable();
    let letter = |side: [u32; 2]| {
        let [a, b] = mesh.below(side);
        let found = seam_edges.binary_search_by_key(&[a.min(b), a.max(b)], |edge| edge.0).ok()?;
        let (_, seam, is_falling) = seam_edges[found];
        Some((seam, is_falling != (a > b)))
    };
    let mut panes = Vec::new();
    for disk in disks(&mesh) {
        let letters: Vec<Option<(usize, bool)>> = disk.rim.iter().map(|&side| letter(side)).collect();
        if letters.iter().all(Option::is_none) {
            continue;
        }
        panes.push(domain_pane(&mesh, &disk, &letters, &colors));
    }
    let count = panes.len();
    if count > 1 {
        panes.iter_mut().enumerate().for_each(|(i, pane)| pane.name = format!("{} {i}", pane.name));
    }
    panes
}

/// A component with one boundary loop, which need not be a disk to be laid out.
struct Disk {
    faces: Vec<usize>,
    /// The sides of the boundary, one after the other; where faces disagree, as they run here.
    rim: Vec<[u32; 2]>,
}

fn disks(mesh: &Mesh<'_>) -> Vec<Disk> {
    let mut sides: Vec<([u32; 2], [u32; 2])> =
        mesh.sides().map(|(side, _)| ([side[0].min(side[1]), side[0].max(side[1])], side)).collect();
    sides.sort_unstable();
    let loose: Vec<[u32; 2]> =
        sides.chunk_by(|a, b| a.0 == b.0).filter(|uses| uses.len() == 1).map(|uses| uses[0].1).collect();
    let mut classes = UnionFind::new(mesh.source.len());
    for walk in &mesh.walks {
        walk.windows(2).for_each(|pair| {
            classes.unite(pair[0], pair[1]);
        });
    }
    let mut disks: Vec<Option<Disk>> = Vec::new();
    let class_of = classes.class_numbers();
    disks.resize_with(classes.class_count(), || Some(Disk { faces: Vec::new(), rim: Vec::new() }));
    for walk in super::boundary::chained(&loose) {
        let slot = &mut disks[class_of[walk[0] as usize] as usize];
        match slot {
            Some(disk) if disk.rim.is_empty() => {
                disk.rim = walk.windows(2).map(|pair| [pair[0], pair[1]]).collect();
            }
            _ => *slot = None,
        }
    }
    for (face, walk) in mesh.walks.iter().enumerate() {
        if let Some(Some(disk)) = walk.first().map(|&vertex| &mut disks[class_of[vertex as usize] as usize]) {
            disk.faces.push(face);
        }
    }
    disks.into_iter().flatten().filter(|disk| disk.rim.len() > 2).collect()
}

fn domain_pane(
    mesh: &Mesh<'_>,
    disk: &Disk,
    letters: &[Option<(usize, bool)>],
    colors: &[(u32, usize)],
) -> Pane {
    let count = disk.rim.len();
    // Where one letter ends and another begins.
    let begins = |i: usize| letters[i] != letters[(i + count - 1) % count];
    let start = (0..count).find(|&i| begins(i)).unwrap_or(0);
    let order: Vec<usize> = (0..count).map(|i| (start + i) % count).collect();
    let mut runs: Vec<Vec<usize>> = Vec::new();
    for (place, &side) in order.iter().enumerate() {
        match runs.last_mut() {
            Some(run) if place > 0 && !begins(side) => run.push(side),
            _ => runs.push(vec![side]),
        }
    }
    // The vertices that occur, renumbered.
    let mut used: Vec<u32> = disk.faces.iter().flat_map(|&face| mesh.walks[face]).copied().collect();
    used.sort_unstable();
    used.dedup();
    let number = |vertex: u32| used.partition_point(|&other| other < vertex) as u32;
    let mut positions = vec![[0.0; 2]; used.len()];
    let mut is_fixed = vec![false; used.len()];
    let mut labels = Vec::new();
    for (place, run) in runs.iter().enumerate() {
        let angle = |share: f64| {
            std::f64::consts::TAU * (place as f64 + share) / runs.len() as f64 - 0.75 * std::f64::consts::PI
        };
        for (step, &side) in run.iter().enumerate() {
            let vertex = number(disk.rim[side][0]) as usize;
            let turn = angle(step as f64 / run.len() as f64);
            positions[vertex] = [turn.cos(), turn.sin()];
            is_fixed[vertex] = true;
        }
        let turn = angle(0.5);
        if let Some((seam, is_backwards)) = letters[run[0]] {
            let name = format!("{}{}", colors[seam].1, if is_backwards { "\u{207b}\u{b9}" } else { "" });
            labels.push(([1.09 * turn.cos(), 1.09 * turn.sin()], name));
        }
    }
    let mut edges: Vec<[u32; 2]> = disk
        .faces
        .iter()
        .flat_map(|&face| {
            let walk = mesh.walks[face];
            (0..walk.len()).map(|i| [walk[i], walk[(i + 1) % walk.len()]].map(number))
        })
        .map(|[a, b]| [a.min(b), a.max(b)])
        .collect();
    edges.sort_unstable();
    edges.dedup();
    balance(&mut positions, &is_fixed, &edges);
    let mut pane = Pane { name: "fundamental domain".to_owned(), positions, ..Pane::default() };
    let mut faces = Layer::new("domain", "faces");
    for &face in &disk.faces {
        faces.push_fan(&mesh.walks[face].iter().map(|&vertex| number(vertex)).collect::<Vec<_>>());
    }
    let mut inner = Layer::new("domain", "edges");
    edges.iter().for_each(|edge| inner.lines.push(edge));
    let mut layers = vec![faces, inner];
    for (seam, &(color, name)) in colors.iter().enumerate() {
        let mut layer = Layer::new("domain", format!("seam {name}"));
        layer.color = Some(color);
        layer.has_arrows = true;
        for run in runs.iter().filter(|run| letters[run[0]].is_some_and(|letter| letter.0 == seam)) {
            let mut walk: Vec<u32> = run.iter().map(|&side| number(disk.rim[side][0])).collect();
            walk.push(number(disk.rim[run[run.len() - 1]][1]));
            if letters[run[0]].is_some_and(|letter| letter.1) {
                walk.reverse();
            }
            layer.lines.push(&walk);
        }
        layers.push(layer);
    }
    let mut rest = Layer::new("domain", "boundary and loose ends");
    for run in runs.iter().filter(|run| letters[run[0]].is_none()) {
        run.iter().for_each(|&side| rest.lines.push(&disk.rim[side].map(number)));
    }
    let mut names = Layer::new("domain", "letters");
    for (place, name) in labels {
        names.labels.push((pane.positions.len() as u32, name));
        pane.positions.push(place);
    }
    layers.push(rest);
    for mut layer in layers {
        layer.is_on = true;
        if !layer.is_empty() {
            pane.layers.push(layer);
        }
    }
    pane.layers.push(names);
    pane
}

/// Moves what is not fixed to where springs along the edges are in balance, by conjugate gradients; the work is bounded.
fn balance(positions: &mut [[f64; 2]], is_fixed: &[bool], edges: &[[u32; 2]]) {
    let count = positions.len();
    let apply = |x: &[f64], out: &mut [f64]| {
        out.fill(0.0);
        for edge in edges {
            let [a, b] = edge.map(|end| end as usize);
            let pull = x[a] - x[b];
            out[a] += pull;
            out[b] -= pull;
        }
        out.iter_mut().zip(is_fixed).filter(|(_, is_fixed)| **is_fixed).for_each(|(value, _)| *value = 0.0);
    };
    let dot = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(a, b)| a * b).sum::<f64>();
    for axis in 0..2 {
        let mut x: Vec<f64> = positions.iter().map(|point| point[axis]).collect();
        let mut product = vec![0.0; count];
        apply(&x, &mut product);
        let mut residual: Vec<f64> = product.iter().map(|value| -value).collect();
        let mut direction = residual.clone();
        let mut square = dot(&residual, &residual);
        let goal = RESIDUAL * RESIDUAL * square;
        for _ in 0..4000.min(4 * count) {
            if square <= goal || square == 0.0 {
                break;
            }
            apply(&direction, &mut product);
            let step = square / dot(&direction, &product);
            for i in 0..count {
                x[i] += step * direction[i];
                residual[i] -= step * product[i];
            }
            let next = dot(&residual, &residual);
            for i in 0..count {
                direction[i] = residual[i] + next / square * direction[i];
            }
            square = next;
        }
        positions.iter_mut().zip(x).for_each(|(point, value)| point[axis] = value);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn shown(answer: serde_json::Value) -> Shown {
        Shown::of("r", answer).unwrap()
    }

    /// A torus of nine squares, cut along a row and a column of the grid: vertex (i, j) of the domain is over (i mod 3, j mod 3).
    fn torus() -> Shown {
        let vertex = |i: usize, j: usize| i + 4 * j;
        let below = |i: usize, j: usize| i % 3 + 3 * (j % 3);
        let source: Vec<usize> = (0..16).map(|v| below(v % 4, v / 4)).collect();
        let mut squares = Vec::new();
        for j in 0..3 {
            for i in 0..3 {
                squares.push([vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)]);
            }
        }
        shown(json!({"polygons": squares, "source": source, "components": [{"seams": [
            {"number": 1, "vertices": [0, 1, 2, 0]}, {"number": 2, "vertices": [0, 3, 6, 0]},
        ]}]}))
    }

    #[test]
    fn a_torus_has_a_square_with_two_letters() {
        let panes = domain_panes(&torus());
        assert_eq!(panes.len(), 1);
        let pane = &panes[0];
        let names = pane.layers.iter().find(|layer| layer.name == "letters").unwrap();
        let mut words: Vec<&str> = names.labels.iter().map(|label| &label.1[..]).collect();
        // Around: 1, 2, then both backwards, from whichever side.
        while words[0] != "1" {
            words.rotate_left(1);
        }
        assert_eq!(words, ["1", "2", "1\u{207b}\u{b9}", "2\u{207b}\u{b9}"]);
        for seam in ["seam 1", "seam 2"] {
            let layer = pane.layers.iter().find(|layer| layer.name == seam).unwrap();
            assert_eq!(layer.lines.iter().map(<[u32]>::len).collect::<Vec<_>>(), [4, 4]);
        }
        // Everything is in the disk, and all faces turn one way.
        let faces = pane.layers.iter().find(|layer| layer.name == "faces").unwrap();
        for triangle in &faces.triangles {
            let [a, b, c] = triangle.map(|v| pane.positions[v as usize]);
            assert!((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]) > 0.0);
            assert!(a[0].hypot(a[1]) < 1.0 + 1e-9);
        }
    }

    #[test]
    fn what_is_no_disk_has_no_domain() {
        let tetrahedron = json!({"facets": [[0, 1, 2], [0, 3, 1], [1, 3, 2], [0, 2, 3]], "source": [0, 1, 2, 3], "components": [{"seams": []}]});
        assert!(domain_panes(&shown(tetrahedron)).is_empty());
        assert!(
            domain_panes(&shown(json!({"facets": [[0, 1, 9]], "source": [0, 1], "components": [{}]})))
                .is_empty()
        );
    }
}
