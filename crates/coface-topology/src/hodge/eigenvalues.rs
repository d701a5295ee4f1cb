//! Eigenvalues of dense symmetric matrices.

/// The eigenvalues of a symmetric matrix, rising; `None` if the iteration does not converge, as with entries that are
/// no numbers.
///
/// The matrix is given by rows, of which the lower half is read. Reflections make it tridiagonal; then the implicit QL
/// iteration makes it diagonal.
///
/// # Complexity
/// $O(n^3)$ time, in place.
///
/// # References
/// J. H. Wilkinson, C. Reinsch, *Handbook for Automatic Computation II, Linear Algebra* (1971), II/2 and II/3.
pub(super) fn symmetric_eigenvalues(matrix: Vec<Vec<f64>>) -> Option<Vec<f64>> {
    let (mut diagonal, mut beside) = tridiagonal(matrix);
    for first in 0..diagonal.len() {
        // Each eigenvalue takes two or three rounds; 60 are given to each.
        let mut rounds = 0;
        loop {
            let is_small = |i: usize| {
                let scale = diagonal[i].abs() + diagonal[i + 1].abs();
                beside[i].abs() <= f64::EPSILON * scale || beside[i] == 0.0
            };
            let last = (first..diagonal.len() - 1).find(|&i| is_small(i)).unwrap_or(diagonal.len() - 1);
            if last == first {
                break;
            }
            rounds += 1;
            if rounds > 60 {
                return None;
            }
            chase(&mut diagonal, &mut beside, first, last);
        }
    }
    diagonal.sort_unstable_by(f64::total_cmp);
    diagonal.iter().all(|x| x.is_finite()).then_some(diagonal)
}

/// The diagonal, and the entries next to it, of a tridiagonal matrix with the same eigenvalues.
fn tridiagonal(mut matrix: Vec<Vec<f64>>) -> (Vec<f64>, Vec<f64>) {
    let count = matrix.len();
    let mut beside = vec![0.0; count.saturating_sub(1)];
    // From the last row up, each row is reflected to its entry next to the diagonal.
    for i in (1..count).rev() {
        let (above, below) = matrix.split_at_mut(i);
        let row = &mut below[0][..i];
        let largest = row[..i - 1].iter().map(|x| x.abs()).fold(0.0, f64::max);
        if largest == 0.0 {
            beside[i - 1] = row[i - 1];
            continue;
        }
        let scale = largest.max(row[i - 1].abs());
        row.iter_mut().for_each(|x| *x /= scale);
        let square: f64 = row.iter().map(|x| x * x).sum();
        let root = if row[i - 1] >= 0.0 { -square.sqrt() } else { square.sqrt() };
        beside[i - 1] = scale * root;
        // The vector of the reflection is the row with this entry changed; `half` is half its square.
        let half = square - row[i - 1] * root;
        row[i - 1] -= root;
        // The product of the rest of the matrix with the vector, from its lower half.
        let mut product = vec![0.0; i];
        for (j, other) in above.iter().enumerate() {
            let mut sum = 0.0;
            for (k, &x) in other[..j].iter().enumerate() {
                sum += x * row[k];
                product[k] += x * row[j];
            }
            product[j] += sum + other[j] * row[j];
        }
        product.iter_mut().for_each(|x| *x /= half);
        let factor = row.iter().zip(&product).map(|(u, p)| u * p).sum::<f64>() / (2.0 * half);
        product.iter_mut().zip(&*row).for_each(|(p, u)| *p -= factor * u);
        for (j, other) in above.iter_mut().enumerate() {
            let (u, p) = (row[j], product[j]);
            for (k, x) in other[..=j].iter_mut().enumerate() {
                *x -= u * product[k] + p * row[k];
            }
        }
    }
    ((0..count).map(|i| matrix[i][i]).collect(), beside)
}

/// One round of the implicit QL iteration between two rows, with the shift of Wilkinson.
fn chase(diagonal: &mut [f64], beside: &mut [f64], first: usize, last: usize) {
    let half = (diagonal[first + 1] - diagonal[first]) / (2.0 * beside[first]);
    let root = half.hypot(1.0).copysign(half);
    let mut g = diagonal[last] - diagonal[first] + beside[first] / (half + root);
    let (mut sine, mut cosine, mut moved) = (1.0, 1.0, 0.0);
    for i in (first..last).rev() {
        let (f, b) = (sine * beside[i], cosine * beside[i]);
        let length = f.hypot(g);
        if i + 1 < last {
            beside[i + 1] = length;
        }
        if length == 0.0 {
            // The matrix has come apart here.
            diagonal[i + 1] -= moved;
            return;
        }
        (sine, cosine) = (f / length, g / length);
        g = diagonal[i + 1] - moved;
        let step = (diagonal[i] - g) * sine + 2.0 * cosine * b;
        moved = sine * step;
        diagonal[i + 1] = g + moved;
        g = cosine * step - b;
    }
    diagonal[first] -= moved;
    beside[first] = g;
}
