//! The fundamental cycle of a closed oriented pseudomanifold.

use crate::homology::cup::CochainAlgebra;
use coface_algebra::Integer;
use coface_algebra::chains::Chain;
use coface_algebra::{CellId, Error, ErrorKind};
use coface_complexes::simplicial::DeltaComplex;
use std::collections::VecDeque;

impl CochainAlgebra {
    /// The fundamental cycle: all simplices of the top dimension n with coefficients 1 and -1, so that the boundary
    /// is zero.
    ///
    /// The complex has to be a closed orientable pseudomanifold: every simplex is a face of one of dimension n, and
    /// every one of dimension n - 1 is a face of two, counted with multiplicity. The lowest simplex of each strongly
    /// connected component has the coefficient 1; that is the orientation which all signs derive from.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for the empty complex and, naming a closed chain of top simplices that reverses
    /// orientation, for one that is not orientable; [`ErrorKind::NotPure`] naming a simplex that is in none of
    /// dimension n; [`ErrorKind::NonManifold`] naming a simplex of dimension n - 1 that is on a boundary or in three
    /// facets or more.
    ///
    /// # Complexity
    /// Linear in the number of faces.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_topology::CochainAlgebra;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sphere = CochainAlgebra::new(known_spaces::simplex_boundary(1)?.freeze().to_delta()?)?;
    /// // The edges 01, 02, 12.
    /// assert_eq!(sphere.fundamental_cycle()?.to_string(), "c0 - c1 + c2");
    /// let plane = CochainAlgebra::new(known_spaces::projective_plane()?.freeze().to_delta()?)?;
    /// assert!(plane.fundamental_cycle().is_err());
    /// # Ok(()) }
    /// ```
    pub fn fundamental_cycle(&self) -> Result<Chain<Integer>, Error> {
        let complex = self.complex();
        let Some(dimension) = complex.dimension() else {
            return Err(Error::invalid("the empty complex has no fundamental cycle"));
        };
        check_pure(complex, dimension)?;
        let signs = orient(complex, dimension, &ridge_sides(complex, dimension)?)?;
        let terms = signs.into_iter().enumerate();
        Chain::new(self.chains(), dimension, terms.map(|(cell, sign)| (CellId::new(cell), sign.into())))
    }
}

fn check_pure(complex: &DeltaComplex, dimension: usize) -> Result<(), Error> {
    for degree in 0..dimension {
        let mut covered = vec![false; complex.simplex_count(degree)];
        for cell in 0..complex.simplex_count(degree + 1) {
            complex
                .faces(degree + 1, CellId::new(cell))
                .iter()
                .for_each(|&face| covered[face as usize] = true);
        }
        if let Some(cell) = covered.iter().position(|&covered| !covered) {
            return Err(Error::new(
                ErrorKind::NotPure,
                format!("simplex {cell} of dimension {degree} is a face of none of dimension {dimension}"),
            )
            .with_cure("take a closed manifold, all of whose simplices lie in facets"));
        }
    }
    Ok(())
}

/// One side of a ridge: face `face` of a facet.
#[derive(Clone, Copy)]
struct Side {
    facet: u32,
    face: u32,
}

/// The two sides of each ridge.
fn ridge_sides(complex: &DeltaComplex, dimension: usize) -> Result<Vec<[Side; 2]>, Error> {
    let Some(below) = dimension.checked_sub(1) else { return Ok(Vec::new()) };
    let facets = || 0..complex.simplex_count(dimension);
    let ridge_count = complex.simplex_count(below);
    let mut counts = vec![0u32; ridge_count];
    let mut sides = vec![[Side { facet: 0, face: 0 }; 2]; ridge_count];
    for facet in facets() {
        for (face, &ridge) in (0..).zip(complex.faces(dimension, CellId::new(facet))) {
            let count = &mut counts[ridge as usize];
            if let Some(side) = sides[ridge as usize].get_mut(*count as usize) {
                *side = Side { facet: facet as u32, face };
            }
            *count += 1;
        }
    }
    let Some(ridge) = counts.iter().position(|&count| count != 2) else { return Ok(sides) };
    let has_ridge = |facet: &usize| complex.faces(dimension, CellId::new(*facet)).contains(&(ridge as u32));
    let names: Vec<String> = facets().filter(has_ridge).map(|facet| facet.to_string()).collect();
    let fault = match counts[ridge] {
        1 => format!("is in facet {} alone, so it lies on the boundary", names[0]),
        count => format!("is a face of facets {count} times (facets {})", names.join(", ")),
    };
    Err(Error::new(ErrorKind::NonManifold, format!("simplex {ridge} of dimension {below} {fault}"))
        .with_cure("take a closed manifold; each such simplex must be in two facets"))
}

/// Signs of all facets for which the sides of every ridge cancel, breadth first from the lowest of each component.
fn orient(complex: &DeltaComplex, dimension: usize, ridges: &[[Side; 2]]) -> Result<Vec<i32>, Error> {
    let count = complex.simplex_count(dimension);
    let mut signs = vec![0i32; count];
    let mut parents: Vec<u32> = (0..count as u32).collect();
    let mut queue = VecDeque::new();
    for root in 0..count {
        if signs[root] != 0 {
            continue;
        }
        signs[root] = 1;
        queue.push_back(root);
        while let Some(facet) = queue.pop_front() {
            // A vertex has the empty face, which is no ridge.
            let faces = if dimension == 0 { &[][..] } else { complex.faces(dimension, CellId::new(facet)) };
            for (face, &ridge) in (0..).zip(faces) {
                let [a, b] = ridges[ridge as usize];
                let other = if (a.facet as usize, a.face) == (facet, face) { b } else { a };
                let sign = if (face + other.face) % 2 == 0 { -signs[facet] } else { signs[facet] };
                let neighbor = other.facet as usize;
                if signs[neighbor] == 0 {
                    signs[neighbor] = sign;
                    parents[neighbor] = facet as u32;
                    queue.push_back(neighbor);
                } else if signs[neighbor] != sign {
                    return Err(reversed(&parents, facet as u32, other.facet));
                }
            }
        }
    }
    Ok(signs)
}

/// The error that names the closed chain of facets through two neighbors and the tree.
fn reversed(parents: &[u32], first: u32, second: u32) -> Error {
    let path = |mut facet: u32| {
        let mut path = vec![facet];
        while parents[facet as usize] != facet {
            facet = parents[facet as usize];
            path.push(facet);
        }
        path
    };
    let (mut up, mut down) = (path(first), path(second));
    // Cut off what both have in common, but for the lowest.
    while up.len() > 1 && down.len() > 1 && up[up.len() - 2] == down[down.len() - 2] {
        up.pop();
        down.pop();
    }
    down.pop();
    down.reverse();
    up.extend(down);
    let names: Vec<String> = up.iter().map(u32::to_string).collect();
    Error::invalid(format!(
        "the complex is not orientable: the closed chain of facets {} reverses orientation",
        names.join(", ")
    ))
    .with_cure("take an orientable manifold, or its orientable double cover")
}
