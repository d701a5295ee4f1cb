//! The shapes of three-dimensional cells that files hold.

/// The shape of a 3-cell, with the vertex order of Gmsh and MEDIT, and of legacy VTK but for its wedge, whose bottom
/// triangle VTK lists the other way around.
///
/// Tetrahedron: 0 1 2 is a face, 3 the apex. Hexahedron: 0 1 2 3 the bottom quadrangle, 4 5 6 7 above it. Wedge: 0 1 2
/// the bottom triangle, 3 4 5 above it. Pyramid: 0 1 2 3 the base, 4 the apex. In a right-handed frame a cell is
/// positive when its bottom (0 1 2 ..) runs counterclockwise seen from the top.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum CellShape {
    /// Four vertices, four triangles.
    Tetrahedron,
    /// Eight vertices, six quadrangles.
    Hexahedron,
    /// Six vertices, two triangles and three quadrangles; also called a prism.
    Wedge,
    /// Five vertices, one quadrangle and four triangles.
    Pyramid,
}

impl CellShape {
    /// All shapes.
    pub const ALL: [Self; 4] = [Self::Tetrahedron, Self::Hexahedron, Self::Wedge, Self::Pyramid];

    /// The number of vertices.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::cell_mesh::CellShape;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(CellShape::Pyramid.vertex_count(), 5);
    /// # Ok(()) }
    /// ```
    pub const fn vertex_count(self) -> usize {
        match self {
            Self::Tetrahedron => 4,
            Self::Hexahedron => 8,
            Self::Wedge => 6,
            Self::Pyramid => 5,
        }
    }

    /// The faces as cycles of local vertex numbers, each counterclockwise seen from outside a positive cell, so that
    /// the boundary of the cell is the sum of its faces.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::cell_mesh::CellShape;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(CellShape::Hexahedron.faces().len(), 6);
    /// # Ok(()) }
    /// ```
    pub const fn faces(self) -> &'static [&'static [usize]] {
        match self {
            Self::Tetrahedron => &[&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[2, 0, 3]],
            Self::Hexahedron => {
                &[&[0, 3, 2, 1], &[4, 5, 6, 7], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]]
            }
            Self::Wedge => &[&[0, 2, 1], &[3, 4, 5], &[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]],
            Self::Pyramid => &[&[0, 3, 2, 1], &[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]],
        }
    }

    /// The name of one such cell.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Tetrahedron => "tetrahedron",
            Self::Hexahedron => "hexahedron",
            Self::Wedge => "wedge",
            Self::Pyramid => "pyramid",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;

    #[test]
    fn each_edge_is_run_once_each_way() {
        for shape in CellShape::ALL {
            let mut runs: BTreeMap<(usize, usize), i32> = BTreeMap::new();
            for face in shape.faces() {
                for (i, &a) in face.iter().enumerate() {
                    *runs.entry((a, face[(i + 1) % face.len()])).or_default() += 1;
                }
            }
            assert!(
                runs.iter().all(|(&(a, b), &count)| count == 1 && runs.contains_key(&(b, a))),
                "{shape:?}"
            );
            let (v, e, f) = (shape.vertex_count(), runs.len() / 2, shape.faces().len());
            assert_eq!(v + f - e, 2, "{shape:?} is a sphere");
        }
    }
}
