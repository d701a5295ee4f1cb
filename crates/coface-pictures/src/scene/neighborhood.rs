//! Figures of stars, closures and links.

use super::{Layer, Scene};
use crate::picture::{COMPLEX, NEIGHBORHOOD};
use coface_algebra::Error;
use coface_answers::{Neighborhood, simplicial_complex};
use coface_complexes::simplicial::{Simplex, SimplexSet};
use coface_io::Model;

/// A complex of more vertices has no dots at them.
const MOST_DOTS: usize = 2000;

/// The part of a tetrahedron of a star that is drawn: it does not reach its faces, which need not be in the star.
const TETRAHEDRON: f64 = 0.8;

/// So many simplices are named in the legend at most.
const MOST_NAMES: usize = 3;

impl Scene {
    /// Draws stars, closures and links of simplices of the model, each as a layer of its own color over a pale complex with dots at its vertices.
    /// A star has no boundary: the vertices of its closure that are not in it are rings, and its tetrahedra do not reach their faces. Of a
    /// complex of dimension 3 or more the edges alone are drawn, so that what lies inside is seen.
    ///
    /// # Errors
    /// Those of [`simplicial_complex`] and [`Neighborhood::found`].
    ///
    /// # Complexity
    /// That of the stars, closures and links, beside making the complex.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::Neighborhood;
    /// use coface_complexes::simplicial::{Simplex, SimplexSet};
    /// use coface_pictures::Scene;
    /// let two = &b"v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3\nf 1 3 4\n"[..];
    /// let two = coface_io::read(two, coface_io::Format::Obj)?;
    /// let mut scene = Scene::of("two triangles", &two)?;
    /// let vertex: SimplexSet = [Simplex::from([1])].into_iter().collect();
    /// scene.add_neighborhoods(&two, &[(Neighborhood::Star, vertex.clone()), (Neighborhood::Link, vertex)])?;
    /// let [dots, star, link] = scene.layers() else { unreachable!() };
    /// assert_eq!((dots.points.len(), star.name.as_str(), star.triangles.len()), (4, "open star of {1}", 1));
    /// assert_eq!((star.rings.as_slice(), link.points.as_slice()), (&[0, 2][..], &[0, 2][..]));
    /// # Ok(()) }
    /// ```
    pub fn add_neighborhoods(
        &mut self,
        model: &Model,
        asked: &[(Neighborhood, SimplexSet)],
    ) -> Result<(), Error> {
        let complex = simplicial_complex(model)?;
        self.is_pale = true;
        self.has_wires_only = complex.dimension() >= Some(3);
        let vertices = 0..self.positions.len() as u32;
        let seen: Vec<u32> = vertices.filter(|&vertex| !self.is_hidden(vertex)).collect();
        if seen.len() <= MOST_DOTS {
            let mut dots = Layer::new(COMPLEX, "vertices");
            (dots.is_on, dots.points) = (true, seen);
            self.add_layer(dots);
        }
        let has_star = asked.iter().any(|(neighborhood, _)| *neighborhood == Neighborhood::Star);
        // Closures are the smallest, stars the largest: what is drawn later hides the others.
        let kinds = [Neighborhood::Star, Neighborhood::Link, Neighborhood::Closure];
        let of_kinds = (0..).zip(kinds).flat_map(|(color, kind)| {
            asked
                .iter()
                .filter(move |(neighborhood, _)| *neighborhood == kind)
                .map(move |asked| (color, asked))
        });
        for (color, (neighborhood, simplices)) in of_kinds {
            let set = neighborhood.found(&complex, simplices)?;
            let mut layer = Layer::new(NEIGHBORHOOD, title(*neighborhood, simplices));
            layer.detail = set.f_vector().iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
            (layer.is_on, layer.color) = (true, Some(color));
            let is_star = *neighborhood == Neighborhood::Star;
            // Triangles would hide what lies behind them.
            let has_triangles = !self.has_wires_only || !is_star && !has_star;
            self.fill(&mut layer, &set, has_triangles, is_star && self.has_wires_only);
            if is_star {
                let rim = set.closure().difference(&set);
                layer.rings = self.drawn(rim.simplices(0)).flatten().collect();
            }
            // What is asked about is there, though there may be nothing to be seen of it.
            self.layers.push(layer);
        }
        Ok(())
    }

    /// The vertices of those simplices that are drawn, by their numbers in the scene.
    fn drawn<'s>(&'s self, simplices: &'s [Simplex]) -> impl Iterator<Item = Vec<u32>> + 's {
        let numbered = |simplex: &Simplex| -> Vec<u32> {
            simplex.numbers().iter().map(|&vertex| self.numbering.of(vertex)).collect()
        };
        let is_seen = |vertices: &Vec<u32>| {
            let is_drawn =
                |&vertex: &u32| (vertex as usize) < self.positions.len() && !self.is_hidden(vertex);
            vertices.iter().all(is_drawn)
        };
        simplices.iter().map(numbered).filter(is_seen)
    }

    /// Puts the simplices of a set into a layer.
    fn fill(&self, layer: &mut Layer, set: &SimplexSet, has_triangles: bool, has_tetrahedra: bool) {
        let of = |dimension: usize| -> &[Simplex] {
            if set.dimension() >= Some(dimension) { set.simplices(dimension) } else { &[] }
        };
        layer.points = self.drawn(of(0)).flatten().collect();
        self.drawn(of(1)).for_each(|edge| layer.lines.push(&edge));
        if has_triangles {
            self.drawn(of(2)).for_each(|triangle| layer.push_simplex(&triangle));
        }
        if has_tetrahedra && !of(3).is_empty() {
            let mut positions = self.positions.clone();
            for tetrahedron in self.drawn(of(3)) {
                let corners = tetrahedron.iter().map(|&vertex| self.positions[vertex as usize]);
                let middle =
                    [0, 1, 2].map(|axis| corners.clone().map(|corner| corner[axis] / 4.0).sum::<f64>());
                let first = positions.len() as u32;
                positions.extend(corners.map(|corner| {
                    [0, 1, 2].map(|axis| middle[axis] + TETRAHEDRON * (corner[axis] - middle[axis]))
                }));
                layer.push_simplex(&[first, first + 1, first + 2, first + 3]);
            }
            layer.positions = Some(positions);
        }
    }
}

/// What a layer is called: "link of {0, 1}, {3}".
fn title(neighborhood: Neighborhood, simplices: &SimplexSet) -> String {
    let openness = if neighborhood == Neighborhood::Star { "open " } else { "" };
    let of = if simplices.len() > MOST_NAMES {
        format!("{} simplices", simplices.len())
    } else {
        let name = |simplex: &Simplex| {
            let vertices: Vec<String> = simplex.numbers().iter().map(ToString::to_string).collect();
            format!("{{{}}}", vertices.join(", "))
        };
        simplices.iter().map(name).collect::<Vec<_>>().join(", ")
    };
    format!("{openness}{} of {of}", neighborhood.name())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Picture, PictureStyle};
    use coface_io::{Format, read};

    fn set(simplices: &[&[u32]]) -> SimplexSet {
        simplices.iter().map(|numbers| Simplex::from_numbers(numbers).unwrap()).collect()
    }

    /// The boundary of an octahedron: vertices 0 and 5 are poles of the circle 1 2 3 4.
    const OCTAHEDRON: &[u8] = b"[[0,1,2],[0,2,3],[0,3,4],[0,1,4],[5,1,2],[5,2,3],[5,3,4],[5,1,4]]";

    #[test]
    fn layers_have_the_simplices_of_their_sets() {
        let model = read(OCTAHEDRON, Format::Json).unwrap();
        let mut scene = Scene::of("octahedron", &model).unwrap();
        let asked =
            [Neighborhood::Star, Neighborhood::Closure, Neighborhood::Link].map(|n| (n, set(&[&[0]])));
        scene.add_neighborhoods(&model, &asked).unwrap();
        let [dots, star, link, closure] = scene.layers() else { panic!("four layers") };
        assert_eq!(dots.points.len(), 6);
        assert_eq!((star.triangles.len(), star.lines.len(), star.points.as_slice()), (4, 4, &[0][..]));
        assert_eq!(star.rings, [1, 2, 3, 4]);
        assert_eq!((closure.points.as_slice(), closure.lines.len()), (&[0][..], 0));
        assert_eq!((link.triangles.len(), link.lines.len(), link.points.len()), (0, 4, 4));
        let style = PictureStyle { has_legend: true, ..PictureStyle::default() };
        let svg = Picture::new(&scene, &style).unwrap().svg();
        for words in [">open star of {0}<", ">closure of {0}<", ">link of {0}<"] {
            assert_eq!(svg.matches(words).count(), 2, "a name of a group and a line of the legend: {words}");
        }
    }

    #[test]
    fn inside_a_solid_tetrahedra_of_a_star_do_not_reach_their_faces() {
        // The cone over an octahedron with an inner vertex: 8 tetrahedra.
        let facets = "[[6,0,1,2],[6,0,2,3],[6,0,3,4],[6,0,1,4],[6,5,1,2],[6,5,2,3],[6,5,3,4],[6,5,1,4]]";
        let model = read(facets.as_bytes(), Format::Json).unwrap();
        let mut scene = Scene::of("ball", &model).unwrap();
        let asked = [(Neighborhood::Star, set(&[&[6]])), (Neighborhood::Link, set(&[&[6]]))];
        scene.add_neighborhoods(&model, &asked).unwrap();
        let [_, star, link] = scene.layers() else { panic!("three layers") };
        assert_eq!((star.triangles.len(), star.lines.len(), star.rings.len()), (8 * 4, 6, 6));
        assert_eq!((link.triangles.len(), link.lines.len()), (0, 12), "triangles would hide the star");
        assert!(scene.has_wires_only);
    }

    #[test]
    fn what_is_not_in_the_complex_is_refused() {
        let model = read(OCTAHEDRON, Format::Json).unwrap();
        let mut scene = Scene::of("octahedron", &model).unwrap();
        let asked = [(Neighborhood::Star, set(&[&[0, 5]]))];
        assert!(scene.add_neighborhoods(&model, &asked).is_err());
    }
}
