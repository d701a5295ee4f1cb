//! The cone over a complex.

use coface_check::{Complex, Fault};

fn own(complex: &Complex, degree: usize) -> usize {
    complex.counts().get(degree).copied().unwrap_or(0)
}

/// The cone: in each degree the cells of the complex, then the cones over those of the degree below; in degree 0 the apex is last. The boundary of the cone over
/// a cell is the cell less the cone over its boundary.
pub(crate) fn made(complex: &Complex) -> Result<Complex, Fault> {
    let degree_count = complex.counts().len() + 1;
    let over = |degree: usize| degree.checked_sub(1).map_or(1, |below| own(complex, below));
    let counts = (0..degree_count).map(|degree| own(complex, degree) + over(degree)).collect();
    let mut columns = Vec::new();
    for degree in 1..degree_count {
        let below = own(complex, degree - 1);
        let mut of_degree: Vec<Vec<(u32, i64)>> =
            (0..own(complex, degree)).map(|cell| complex.boundary(degree, cell).to_vec()).collect();
        for cell in 0..below {
            let mut column = vec![(cell as u32, 1)];
            if degree == 1 {
                column.push((below as u32, -1));
            } else {
                let faces = complex.boundary(degree - 1, cell);
                if degree == 2 && faces.iter().map(|face| i128::from(face.1)).sum::<i128>() != 0 {
                    return Err(Fault::new("cone", format!("the ends of edge {cell} do not cancel")));
                }
                column.extend(faces.iter().map(|(face, incidence)| (below as u32 + face, -incidence)));
            }
            of_degree.push(column);
        }
        columns.push(of_degree);
    }
    Ok(Complex::of_columns(counts, columns))
}

/// The cell of the complex that a cell of the cone is, or is the cone over, with its degree; `None` for the apex.
pub(crate) fn below(complex: &Complex, degree: usize, cell: u32) -> Option<(bool, usize, u32)> {
    match cell.checked_sub(own(complex, degree) as u32) {
        None => Some((false, degree, cell)),
        Some(over) => Some((true, degree.checked_sub(1)?, over)),
    }
}
