//! Whether two surfaces of polygons are the same under other names.

use crate::answer::IsomorphicAnswer;
use coface_algebra::{Error, ErrorKind, RaggedArray, UnionFind};

/// No flag. The arrays that hold it have several entries a corner, and an `Option` would double their size.
const NONE: u32 = u32::MAX;

/// The flags of polygons: a corner with one of the two sides at it. Flag 2c is corner c, of all polygons one after the other,
/// with the side that begins there, flag 2c + 1 with the side that ends there.
struct Flags<'a> {
    polygons: &'a RaggedArray,
    polygon_of_corner: Vec<u32>,
    /// The flag with the other vertex of the side, with the other side at the corner, and beyond the side, if a polygon is there.
    neighbors: Vec<[u32; 3]>,
    components: Vec<Vec<u32>>,
    edge_count: usize,
}

impl<'a> Flags<'a> {
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] where polygons form no surface.
    fn new(polygons: &'a RaggedArray) -> Result<Self, Error> {
        let mut polygon_of_corner = Vec::with_capacity(polygons.item_count());
        let mut neighbors = vec![[NONE; 3]; 2 * polygons.item_count()];
        let mut sides: Vec<([u32; 2], u32, u32)> = Vec::with_capacity(polygons.item_count());
        for (number, polygon) in (0u32..).zip(polygons.iter()) {
            let start = polygons.start(number as usize) as u32;
            for i in 0..polygon.len() {
                let next = (i + 1) % polygon.len();
                let [corner, after] = [start + i as u32, start + next as u32];
                polygon_of_corner.push(number);
                neighbors[2 * corner as usize][0] = 2 * after + 1;
                neighbors[2 * after as usize + 1][0] = 2 * corner;
                neighbors[2 * corner as usize][1] = 2 * corner + 1;
                neighbors[2 * corner as usize + 1][1] = 2 * corner;
                let ends = [polygon[i], polygon[next]];
                sides.push(([ends[0].min(ends[1]), ends[0].max(ends[1])], corner, after));
            }
        }
        sides.sort_unstable();
        let items = polygons.items();
        let mut edge_count = 0;
        for own in sides.chunk_by(|x, y| x.0 == y.0) {
            edge_count += 1;
            match *own {
                [([a, b], ..)] if a != b => {}
                [([a, b], c, d), (_, e, f)] if a != b => {
                    // The flags of both sides at each end.
                    let flag = |from: u32, to: u32, vertex: u32| {
                        if items[from as usize] == vertex { 2 * from } else { 2 * to + 1 }
                    };
                    for vertex in [a, b] {
                        let [x, y] = [flag(c, d, vertex), flag(e, f, vertex)];
                        (neighbors[x as usize][2], neighbors[y as usize][2]) = (y, x);
                    }
                }
                [([a, b], ..), ..] => {
                    return Err(no_surface(&format!(
                        "the edge of the vertices {a} and {b} lies in {} polygons",
                        own.len()
                    )));
                }
                [] => {}
            }
        }
        let mut fans = UnionFind::new(polygons.item_count());
        let mut parts = UnionFind::new(polygons.item_count());
        for (flag, [beside, _, beyond]) in (0u32..).zip(&neighbors) {
            parts.unite(flag >> 1, beside >> 1);
            if *beyond != NONE {
                fans.unite(flag >> 1, beyond >> 1);
                parts.unite(flag >> 1, beyond >> 1);
            }
        }
        let mut roots: Vec<[u32; 2]> =
            (0u32..).zip(items).map(|(corner, &vertex)| [vertex, fans.find(corner)]).collect();
        roots.sort_unstable();
        roots.dedup();
        if let Some(pair) = roots.windows(2).find(|pair| pair[0][0] == pair[1][0]) {
            return Err(no_surface(&format!("the polygons at vertex {} form several fans", pair[0][0])));
        }
        let mut by_part: Vec<(u32, u32)> =
            (0..items.len() as u32).map(|corner| (parts.find(corner), corner)).collect();
        by_part.sort_unstable();
        let corners = |own: &[(u32, u32)]| own.iter().flat_map(|&(_, c)| [2 * c, 2 * c + 1]).collect();
        let components = by_part.chunk_by(|x, y| x.0 == y.0).map(corners).collect();
        Ok(Self { polygons, polygon_of_corner, neighbors, components, edge_count })
    }

    /// The flags of another surface that those of a component go to when the first goes to this one; `None` if there is no way.
    fn continued(&self, component: &[u32], other: &Flags<'_>, first: u32, images: &mut [u32]) -> bool {
        let mut stack = vec![(component[0], first)];
        let mut met = Vec::new();
        let mut holds = true;
        while let Some((flag, image)) = stack.pop() {
            let known = &mut images[flag as usize];
            if *known == NONE {
                *known = image;
                met.push(flag);
            } else {
                holds &= *known == image;
                if holds {
                    continue;
                }
            }
            for (own, its) in self.neighbors[flag as usize].iter().zip(&other.neighbors[image as usize]) {
                match (*own, *its) {
                    (NONE, NONE) => {}
                    (NONE, _) | (_, NONE) => holds = false,
                    pair => stack.push(pair),
                }
            }
            if !holds {
                met.iter().for_each(|&flag| images[flag as usize] = NONE);
                return false;
            }
        }
        true
    }

    /// The image of each flag under an isomorphism.
    fn isomorphism(&self, other: &Flags<'_>) -> Option<Vec<u32>> {
        let mut images = vec![NONE; self.neighbors.len()];
        let mut is_taken = vec![false; other.components.len()];
        for component in &self.components {
            let found = (0..other.components.len()).find(|&place| {
                let its = &other.components[place];
                !is_taken[place]
                    && its.len() == component.len()
                    && its.iter().any(|&first| self.continued(component, other, first, &mut images))
            })?;
            is_taken[found] = true;
        }
        Some(images)
    }

    fn vertex_count(&self) -> usize {
        let mut vertices = self.polygons.items().to_vec();
        vertices.sort_unstable();
        vertices.dedup();
        vertices.len()
    }

    fn boundary_count(&self) -> usize {
        self.neighbors.iter().filter(|own| own[2] == NONE).count() / 2
    }

    fn widths(&self) -> Vec<usize> {
        let mut widths: Vec<usize> = self.polygons.iter().map(<[u32]>::len).collect();
        widths.sort_unstable();
        widths
    }
}

fn no_surface(fault: &str) -> Error {
    Error::new(
        ErrorKind::UnsupportedFormat,
        format!("polygons that form no surface are not compared: {fault}"),
    )
    .with_cure("split it first: coface convert INPUT --split-edges pairs --split-vertices -o OUT")
}

/// Whether two surfaces of polygons are the same but for names and directions. `simplices` are the images of polygons, `vertices` for each
/// the corners of its image that its corners go to.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] naming the file of polygons that form no surface.
///
/// # Complexity
/// $O(n^2)$ for n corners at most; linear where surfaces differ early or have few symmetries.
pub(crate) fn polygon_isomorphism(
    names: [&str; 2],
    polygons: [&RaggedArray; 2],
) -> Result<IsomorphicAnswer, Error> {
    let flags = |at: usize| Flags::new(polygons[at]).map_err(|error| error.in_file(names[at]));
    let (a, b) = (flags(0)?, flags(1)?);
    let counts = |what: &str, x: usize, y: usize| (x != y).then(|| format!("{x} and {y} {what}"));
    let difference = counts("polygons", a.polygons.len(), b.polygons.len())
        .or_else(|| counts("vertices", a.vertex_count(), b.vertex_count()))
        .or_else(|| counts("edges", a.edge_count, b.edge_count))
        .or_else(|| counts("components", a.components.len(), b.components.len()))
        .or_else(|| counts("edges in the boundary", a.boundary_count(), b.boundary_count()))
        .or_else(|| {
            let (a, b) = (a.widths(), b.widths());
            let (x, y) = a.iter().zip(&b).find(|(x, y)| x != y)?;
            Some(format!("numbers of corners of polygons, from the fewest: first {x} and {y}"))
        });
    let images = if difference.is_some() { None } else { a.isomorphism(&b) };
    let polygon_image = |polygon: usize, images: &[u32]| {
        let start = a.polygons.start(polygon);
        b.polygon_of_corner[(images[2 * start] >> 1) as usize]
    };
    let corners = |polygon: usize, images: &[u32]| {
        let first = b.polygons.start(polygon_image(polygon, images) as usize);
        let start = a.polygons.start(polygon);
        let own = start..start + a.polygons.list(polygon).len();
        own.map(|corner| ((images[2 * corner] >> 1) as usize - first) as u32).collect::<Vec<u32>>()
    };
    let all = || 0..a.polygons.len();
    let difference = match (&images, difference) {
        (Some(_), _) => None,
        (None, Some(difference)) => Some(difference),
        (None, None) => Some("no image of the first polygon of a component can be continued".to_owned()),
    };
    Ok(IsomorphicAnswer {
        files: names.map(str::to_owned),
        isomorphic: images.is_some(),
        difference,
        simplices: images.as_ref().map(|images| all().map(|own| polygon_image(own, images)).collect()),
        vertices: images.as_ref().map(|images| all().map(|own| corners(own, images)).collect()),
        signatures: [None, None],
        remarks: Vec::new(),
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

    use super::*;
    use proptest::prelude::*;

    const CUBE: [[u32; 4]; 6] =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];

    fn of(a: &[Vec<u32>], b: &[Vec<u32>]) -> Result<IsomorphicAnswer, Error> {
        polygon_isomorphism(["a", "b"], [&RaggedArray::from_lists(a), &RaggedArray::from_lists(b)])
    }

    fn cube() -> Vec<Vec<u32>> {
        CUBE.map(|face| face.to_vec()).to_vec()
    }

    /// By brute force: whether a bijection of vertices takes the polygons to polygons, in any direction.
    fn is_isomorphism(a: &[Vec<u32>], b: &[Vec<u32>], answer: &IsomorphicAnswer) -> bool {
        let (faces, corners) = (answer.simplices.as_ref().unwrap(), answer.vertices.as_ref().unwrap());
        let mut image = std::collections::BTreeMap::new();
        (0..a.len()).all(|face| {
            let its = &b[faces[face] as usize];
            a[face].iter().zip(&corners[face]).all(|(vertex, &corner)| {
                *image.entry(*vertex).or_insert(its[corner as usize]) == its[corner as usize]
            })
        })
    }

    proptest! {
        #[test]
        fn other_names_are_found(
            order in Just((0..8u32).collect::<Vec<u32>>()).prop_shuffle(),
            faces in Just((0..6usize).collect::<Vec<usize>>()).prop_shuffle(),
            turns in prop::collection::vec((0usize..4, any::<bool>()), 6),
        ) {
            let renamed: Vec<Vec<u32>> = faces
                .iter()
                .zip(turns)
                .map(|(&face, (turn, is_reversed))| {
                    let mut own = CUBE[face].map(|vertex| order[vertex as usize]).to_vec();
                    own.rotate_left(turn);
                    if is_reversed {
                        own.reverse();
                    }
                    own
                })
                .collect();
            let answer = of(&cube(), &renamed).unwrap();
            prop_assert!(answer.isomorphic && is_isomorphism(&cube(), &renamed, &answer));
        }
    }

    #[test]
    fn differences_are_named() {
        // A torus of 3 by 3 squares and one with a twist, which have the same counts.
        let torus = |twist: u32| -> Vec<Vec<u32>> {
            let at = |i: u32, j: u32| (i % 4) * 5 + (j + if i >= 4 { twist } else { 0 }) % 5;
            let square = |i, j| vec![at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            (0..4).flat_map(|i| (0..5).map(move |j| (i, j))).map(|(i, j)| square(i, j)).collect()
        };
        assert!(of(&torus(1), &torus(4)).unwrap().isomorphic, "mirror images");
        assert!(!of(&torus(0), &torus(1)).unwrap().isomorphic);
        let open = cube()[1..].to_vec();
        let answer = of(&cube(), &open).unwrap();
        assert_eq!(answer.difference.as_deref(), Some("6 and 5 polygons"));
        let book = vec![vec![0, 1, 2, 3], vec![0, 1, 4, 5], vec![1, 0, 6, 7]];
        assert!(of(&book, &book).unwrap_err().to_string().contains("lies in 3 polygons"));
        let bow = vec![vec![0, 1, 2, 3], vec![0, 4, 5, 6]];
        assert!(of(&bow, &bow).unwrap_err().to_string().contains("vertex 0 form several fans"));
    }
}
