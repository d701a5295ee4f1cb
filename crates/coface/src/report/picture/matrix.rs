//! The sparsity of boundary matrices as a picture.

use super::svg::escaped;
use crate::chains::ChainComplex;
use std::fmt::Write;

/// The boundary matrices of a complex side by side as SVG: a dot for each entry, one color a sign. Matrices larger than a picture has
/// room for are drawn in bins, darker where there are more entries.
///
/// # Complexity
/// Linear in the entries.
///
/// # Examples
/// ```
/// use coface::report::matrix_picture;
/// use coface::simplicial::SimplicialComplex;
/// # fn main() -> Result<(), coface::Error> {
/// let triangle = SimplicialComplex::from_facets([[0, 1, 2]])?;
/// let picture = matrix_picture("triangle", &triangle.chain_complex()?);
/// // Two entries for each edge and three for the triangle.
/// assert_eq!(picture.matches("<rect").count() - 2, 9);
/// # Ok(()) }
/// ```
pub fn matrix_picture(title: &str, complex: &ChainComplex) -> String {
    const SIDE: usize = 400;
    const GAP: usize = 60;
    let matrices = complex.boundary_matrices();
    let width = GAP + matrices.len().max(1) * (SIDE + GAP);
    let height = SIDE + 2 * GAP;
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" font-family=\"sans-serif\" font-size=\"14\">\n<title>{}</title>\n<path d=\"M0 0H{width}V{height}H0Z\" fill=\"#ffffff\"/>\n",
        escaped(title)
    );
    for (place, matrix) in matrices.iter().enumerate() {
        let degree = place + 1;
        let (rows, columns) = (matrix.row_count(), matrix.column_count());
        let longest = rows.max(columns).max(1);
        // Cells of a matrix in one square of the picture.
        let bin = longest.div_ceil(SIDE);
        let bins = [rows.div_ceil(bin), columns.div_ceil(bin)];
        let side = SIDE as f64 / longest.div_ceil(bin) as f64;
        let mut counts = vec![[0u32; 2]; bins[0] * bins[1]];
        for column in 0..columns {
            for (row, entry) in matrix.column(column).iter() {
                let count = &mut counts[(row / bin) * bins[1] + column / bin];
                count[usize::from(entry < 0)] += 1;
            }
        }
        let most = counts.iter().map(|[p, n]| p + n).max().unwrap_or(1).max(1);
        let left = GAP + place * (SIDE + GAP);
        let _ = writeln!(text, "<g transform=\"translate({left} {GAP})\">");
        let _ = writeln!(
            text,
            "<rect width=\"{:.2}\" height=\"{:.2}\" fill=\"none\" stroke=\"#5c6670\"/>",
            side * bins[1] as f64,
            side * bins[0] as f64
        );
        let _ = writeln!(
            text,
            "<text y=\"-10\">degree {degree}: {rows} rows, {columns} columns, {} entries</text>",
            matrix.entry_count()
        );
        for (at, &[positive, negative]) in counts.iter().enumerate().filter(|(_, [p, n])| p + n > 0) {
            let color = if positive >= negative { "#0072b2" } else { "#d55e00" };
            let share = f64::from(positive + negative) / f64::from(most);
            let _ = writeln!(
                text,
                "<rect x=\"{:.2}\" y=\"{:.2}\" width=\"{side:.2}\" height=\"{side:.2}\" fill=\"{color}\" fill-opacity=\"{:.2}\"/>",
                side * (at % bins[1]) as f64,
                side * (at / bins[1]) as f64,
                0.25 + 0.75 * share
            );
        }
        text += "</g>\n";
    }
    text += "</svg>\n";
    text
}
