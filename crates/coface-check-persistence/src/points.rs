//! Distances of points, read from a file.

use coface_check::{Fault, Surface};

const STEP: &str = "input";
/// There may be so many points.
const MOST_POINTS: usize = 1 << 15;
/// There may be so many edges.
const MOST_EDGES: usize = 1 << 24;

/// For each point the others within a distance, from the last one down.
pub(crate) struct Near {
    pub(crate) lists: Vec<Vec<(u32, f64)>>,
    /// What the numbers of the file are.
    pub(crate) claim: String,
}

impl Near {
    /// Reads points, or the distances themselves, by the layout of the file.
    pub(crate) fn read(bytes: &[u8], layout: &str, threshold: f64) -> Result<Self, Fault> {
        let rows = rows(bytes, layout)?;
        let count = if layout == "lower" { rows.len() + 1 } else { rows.len() };
        if count > MOST_POINTS {
            return Err(Fault::new(
                STEP,
                format!("there are {count} points, and at most {MOST_POINTS} are compared"),
            ));
        }
        let width = rows.first().map_or(0, Vec::len);
        let is_regular = match layout {
            "vertices" | "points" => width > 0 && rows.iter().all(|row| row.len() == width),
            "square" => is_symmetric(&rows),
            "lower" => rows.iter().zip(1..).all(|(row, length)| row.len() == length),
            _ => return Err(Fault::new(STEP, format!("the layout {layout:.20?} is not known"))),
        };
        let distance = |i: usize, j: usize| match layout {
            "lower" => rows[i - 1][j],
            "square" => rows[i][j],
            // Rounded to doubles in this order.
            _ => rows[i].iter().zip(&rows[j]).fold(0.0f64, |sum, (x, y)| sum + (x - y) * (x - y)).sqrt(),
        };
        if !is_regular {
            return Err(Fault::new(
                STEP,
                format!("the rows of the file are not those of the layout {layout:?}"),
            ));
        }
        let mut lists: Vec<Vec<(u32, f64)>> = vec![Vec::new(); count];
        let mut edges = 0;
        for i in (0..count).rev() {
            for j in (0..i).rev() {
                // Zero has one sign.
                let length = distance(i, j) + 0.0;
                if !(0.0..).contains(&length) || length.is_infinite() {
                    return Err(Fault::new(STEP, format!("the distance of points {j} and {i} is {length}")));
                }
                if length <= threshold {
                    lists[i].push((j as u32, length));
                    lists[j].push((i as u32, length));
                    edges += 1;
                }
            }
            if edges > MOST_EDGES {
                return Err(Fault::new(
                    STEP,
                    format!("more than {MOST_EDGES} pairs of points are within {threshold}"),
                ));
            }
        }
        // Those above a point came before those below it, and each of both from the last one down.
        let claim = match layout {
            "points" => format!(
                "the rows of the file are {count} points with {width} coordinates, at Euclidean distances"
            ),
            "vertices" => format!("the vertices of the file are {count} points, at Euclidean distances"),
            _ => format!("the file has the distances of {count} points"),
        };
        Ok(Self { lists, claim })
    }
}

/// The rows of numbers of a file, or its vertices.
pub(crate) fn rows(bytes: &[u8], layout: &str) -> Result<Vec<Vec<f64>>, Fault> {
    match layout {
        "vertices" => {
            let points = Surface::read(bytes)?.points;
            let is_finite = points.iter().flatten().all(|number| number.is_finite());
            let rows = points.iter().map(|point| point.to_vec()).collect();
            if is_finite {
                Ok(rows)
            } else {
                Err(Fault::new(STEP, "a vertex has coordinates that are no numbers"))
            }
        }
        _ => table(bytes),
    }
}

fn is_symmetric(rows: &[Vec<f64>]) -> bool {
    let count = rows.len();
    let is_even = |i: usize| rows[i].len() == count && rows[i][i] == 0.0;
    (0..count).all(is_even) && (0..count).all(|i| (0..i).all(|j| rows[i][j] == rows[j][i]))
}

/// A row of numbers for each line; a first line of words, empty lines, and those that begin with # or // are passed over.
fn table(bytes: &[u8]) -> Result<Vec<Vec<f64>>, Fault> {
    let text = std::str::from_utf8(bytes).map_err(|_| Fault::new(STEP, "this is no text"))?;
    let mut rows = Vec::new();
    for (number, line) in text.lines().enumerate() {
        let line = line.trim();
        if line.is_empty() || line.starts_with('#') || line.starts_with("//") {
            continue;
        }
        let words = line.split([',', ';', ' ', '\t']).filter(|word| !word.is_empty());
        match words.map(str::parse).collect::<Result<Vec<f64>, _>>() {
            Ok(row) if row.iter().all(|number| number.is_finite()) => rows.push(row),
            _ if rows.is_empty()
                && line.split([',', ';', ' ', '\t']).all(|word| word.parse::<f64>().is_err()) => {}
            _ => return Err(Fault::new(STEP, format!("line {} is not a row of numbers", number + 1))),
        }
    }
    Ok(rows)
}
