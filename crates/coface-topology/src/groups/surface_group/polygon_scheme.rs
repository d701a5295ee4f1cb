//! Polygons whose sides are glued in pairs.

use coface_algebra::Error;
use coface_algebra::{Sign, Word};

/// A polygon with sides 0, ..., d - 1 in order, glued in pairs so that all corners are one vertex.
///
/// Corner c lies between the sides c - 1 and c. The polygon is seen counterclockwise.
#[derive(Clone, Debug)]
pub(super) struct PolygonScheme {
    letters: Vec<i32>,
    mates: Vec<u32>,
    /// The first side of each generator.
    first_sides: Vec<u32>,
    /// The corners as they lie around the vertex, counterclockwise by the polygon's orientation at corner 0.
    rotation: Vec<u32>,
    /// Whether the orientation of the vertex and that of the polygon agree at each corner.
    signs: Vec<Sign>,
}

impl PolygonScheme {
    /// The polygon with this word around its boundary.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] if a generator does not occur exactly twice, or the corners are
    /// several vertices.
    pub(super) fn new(generator_count: usize, relator: &Word) -> Result<Self, Error> {
        let letters = relator.letters().to_vec();
        let degree = letters.len();
        let mut sides: Vec<Vec<u32>> = vec![Vec::new(); generator_count];
        for (side, letter) in letters.iter().enumerate() {
            let generator = letter.unsigned_abs() as usize;
            let Some(own) = sides.get_mut(generator - 1) else {
                return Err(Error::invalid(format!(
                    "the relator {relator} has the letter x{generator}, but there are {generator_count} generators"
                )));
            };
            own.push(side as u32);
        }
        let mut mates = vec![0; degree];
        for (generator, own) in sides.iter().enumerate() {
            let &[a, b] = own.as_slice() else {
                return Err(Error::invalid(format!(
                    "the generator x{} occurs {} times in the relator {relator}; on a closed surface it occurs twice",
                    generator + 1,
                    own.len()
                ))
                .with_cure("eliminate generators that occur once, and give free factors groups of their own"));
            };
            (mates[a as usize], mates[b as usize]) = (b, a);
        }
        let first_sides = sides.iter().map(|own| own[0]).collect();
        let mut scheme =
            Self { letters, mates, first_sides, rotation: Vec::new(), signs: vec![Sign::Plus; degree] };
        scheme.turn_around_vertices(relator)?;
        Ok(scheme)
    }

    /// Goes around the vertices; refuses a second one.
    fn turn_around_vertices(&mut self, relator: &Word) -> Result<(), Error> {
        let degree = self.letters.len();
        let mut is_seen = vec![false; degree];
        let mut vertex_count = 0;
        for start in 0..degree {
            if is_seen[start] {
                continue;
            }
            vertex_count += 1;
            // Leaving a corner across the side after it turns clockwise.
            let (mut corner, mut sign) = (start, Sign::Plus);
            while !is_seen[corner] {
                is_seen[corner] = true;
                if vertex_count == 1 {
                    self.rotation.push(corner as u32);
                    self.signs[corner] = sign;
                }
                (corner, sign) = self.across(corner, sign);
            }
        }
        if vertex_count > 1 {
            return Err(Error::invalid(format!(
                "the corners of the polygon {relator} are {vertex_count} vertices of its surface, which needs one"
            ))
            .with_cure("contract edges between different vertices, as the tree of a tree-cotree does"));
        }
        self.rotation.reverse();
        Ok(())
    }

    /// The next corner around the vertex: across the side after the corner if the sign is plus, before it if minus.
    fn across(&self, corner: usize, sign: Sign) -> (usize, Sign) {
        let degree = self.letters.len();
        let side = if sign == Sign::Plus { corner } else { (corner + degree - 1) % degree };
        let mate = self.mates[side] as usize;
        // Sides with opposite letters are glued head to tail.
        let sign = if self.letters[side] == -self.letters[mate] { sign } else { sign.opposite() };
        (if sign == Sign::Plus { (mate + 1) % degree } else { mate }, sign)
    }

    /// The letters around the polygon.
    pub(super) fn letters(&self) -> &[i32] {
        &self.letters
    }

    /// The number of sides.
    pub(super) fn side_count(&self) -> usize {
        self.letters.len()
    }

    /// The number of generators.
    pub(super) fn generator_count(&self) -> usize {
        self.first_sides.len()
    }

    /// The first side with this letter or its inverse.
    pub(super) fn first_side(&self, letter: i32) -> usize {
        self.first_sides[letter.unsigned_abs() as usize - 1] as usize
    }

    /// The side that a side is glued to.
    pub(super) fn mate(&self, side: usize) -> usize {
        self.mates[side] as usize
    }

    /// The corners counterclockwise around the vertex.
    pub(super) fn rotation(&self) -> &[u32] {
        &self.rotation
    }

    /// Whether vertex and polygon agree in orientation at each corner.
    pub(super) fn signs(&self) -> &[Sign] {
        &self.signs
    }

    /// Whether no two letters are equal: each generator occurs with both signs.
    pub(super) fn is_orientable(&self) -> bool {
        (0..self.side_count()).all(|side| self.letters[side] == -self.letters[self.mate(side)])
    }

    /// The two corners that a letter runs between, along the polygon's first side with it.
    pub(super) fn corners_of_letter(&self, letter: i32) -> [u32; 2] {
        let side = self.first_side(letter);
        let ends = [side as u32, ((side + 1) % self.side_count()) as u32];
        if self.letters[side] == letter { ends } else { [ends[1], ends[0]] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn message(count: usize, letters: &[i32]) -> String {
        PolygonScheme::new(count, &Word::from_letters(letters.iter().copied())).unwrap_err().to_string()
    }

    #[test]
    fn what_is_no_closed_surface_of_one_vertex_is_refused() {
        assert!(message(2, &[1, 1]).starts_with("the generator x2 occurs 0 times in the relator x1^2"));
        assert!(message(2, &[1, 2, 1, -2, 1]).starts_with("the generator x1 occurs 3 times"));
        assert!(
            message(2, &[1, 2, 1, 2]).starts_with("the corners of the polygon x1 x2 x1 x2 are 2 vertices")
        );
        assert_eq!(message(1, &[1, 3]), "the relator x1 x3 has the letter x3, but there are 1 generators");
    }

    #[test]
    fn corners_of_the_torus_lie_in_reverse() {
        let torus = PolygonScheme::new(2, &Word::from_letters([1, 2, -1, -2])).unwrap();
        assert_eq!(torus.rotation(), [1, 2, 3, 0]);
        assert!(torus.is_orientable());
        assert_eq!(torus.signs(), [Sign::Plus; 4]);
        assert_eq!((torus.corners_of_letter(2), torus.corners_of_letter(-2)), ([1, 2], [2, 1]));
        let klein = PolygonScheme::new(2, &Word::from_letters([1, 2, 1, -2])).unwrap();
        assert_eq!(klein.signs().iter().filter(|&&sign| sign == Sign::Minus).count(), 2);
    }
}
