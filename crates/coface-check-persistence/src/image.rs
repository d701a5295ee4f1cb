//! Images: arrays of numbers, and the cubes that they make.

use crate::{KNOWN, above, pairs};
use coface_check::json::{field, index, list, optional, text, truth};
use coface_check::{Complex, Fault, Verdict};
use serde_json::Value;
use std::collections::BTreeMap;

const STEP: &str = "input";
/// There may be so many cells.
const MOST_CELLS: usize = 1 << 22;

/// An array of numbers, of which those along the last axis come first.
///
/// # Examples
/// ```
/// let image = coface_check_persistence::Image::read(b"P2\n3 1\n9\n4 0 7\n").expect("a row of three pixels");
/// // Three vertices with two edges, and three squares with their sides and corners.
/// assert_eq!(image.cells(true, false).expect("few cells").0.counts(), [3, 2]);
/// assert_eq!(image.cells(false, false).expect("few cells").0.counts(), [8, 10, 3]);
/// ```
#[derive(Clone, Debug)]
pub struct Image {
    shape: Vec<usize>,
    numbers: Vec<f64>,
}

impl Image {
    /// Reads an array of NumPy whose last axis runs fastest, of numbers of up to 32 bits or doubles, or a grey map of pixels (PGM) with values below 256. Values that are
    /// no number are left out.
    ///
    /// # Errors
    /// A [`Fault`] for what is neither.
    ///
    /// # Examples
    /// See [`Image`].
    pub fn read(bytes: &[u8]) -> Result<Self, Fault> {
        let image = if bytes.starts_with(b"\x93NUMPY") { array(bytes) } else { grey_map(bytes) };
        let image =
            image.ok_or_else(|| Fault::new(STEP, "this is no plain array of numbers, and no grey map"))?;
        match image.numbers.iter().any(|number| number.is_infinite()) {
            true => Err(Fault::new(STEP, "a voxel has an infinite value")),
            false => Ok(image),
        }
    }

    /// The cubes and the value of each by degree: voxels are vertices, and a cube has the largest of their values; or voxels are cubes of the highest degree, and a
    /// face has the least value around it. Of superlevel sets values are negative.
    ///
    /// # Errors
    /// A [`Fault`] for more than 2^22 cells.
    ///
    /// # Complexity
    /// O(c 4^d) for c cells of d axes.
    ///
    /// # Examples
    /// See [`Image`].
    pub fn cells(&self, are_vertices: bool, is_superlevel: bool) -> Result<(Complex, Vec<Vec<f64>>), Fault> {
        // Cells are the points of a grid twice as fine: with an odd coordinate they reach along an axis.
        let long =
            |&length: &usize| if are_vertices { (2 * length).saturating_sub(1) } else { 2 * length + 1 };
        let shape: Vec<usize> = self.shape.iter().map(long).collect();
        let count = shape.iter().try_fold(1usize, |so_far, length| so_far.checked_mul(*length));
        let count = count.filter(|count| *count <= MOST_CELLS);
        let count =
            count.ok_or_else(|| Fault::new(STEP, format!("the image has more than {MOST_CELLS} cells")))?;
        let mut steps = vec![1; shape.len()];
        (1..shape.len()).rev().for_each(|axis| steps[axis - 1] = steps[axis] * shape[axis]);
        let mut places = vec![u32::MAX; count];
        let (mut counts, mut values) = (vec![0usize; shape.len() + 1], vec![Vec::new(); shape.len() + 1]);
        for (cell, place) in places.iter_mut().enumerate() {
            if let Some(value) = self.value(&coordinates(cell, &shape), are_vertices, is_superlevel) {
                let degree = coordinates(cell, &shape).iter().filter(|at| *at % 2 == 1).count();
                *place = counts[degree] as u32;
                counts[degree] += 1;
                values[degree].push(value);
            }
        }
        let mut columns: Vec<Vec<Vec<(u32, i64)>>> = vec![Vec::new(); shape.len()];
        for cell in (0..count).filter(|cell| places[*cell] != u32::MAX) {
            let at = coordinates(cell, &shape);
            let along: Vec<usize> = (0..shape.len()).filter(|axis| at[*axis] % 2 == 1).collect();
            if along.is_empty() {
                continue;
            }
            let mut column = Vec::new();
            for (i, axis) in along.iter().enumerate() {
                // The product rule of boundaries.
                let sign = if i % 2 == 0 { 1 } else { -1 };
                column.push((places[cell + steps[*axis]], sign));
                column.push((places[cell - steps[*axis]], -sign));
            }
            column.sort_unstable();
            columns[along.len() - 1].push(column);
        }
        while counts.len() > 1 && counts.last() == Some(&0) {
            counts.pop();
            columns.pop();
            values.pop();
        }
        Ok((Complex::of_columns(counts, columns), values))
    }

    /// The value of a cell of the fine grid; none where it is not there.
    fn value(&self, at: &[usize], are_vertices: bool, is_superlevel: bool) -> Option<f64> {
        let mut voxels = vec![0];
        for (&place, &length) in at.iter().zip(&self.shape) {
            let half = place / 2;
            let around = match (are_vertices, place % 2 == 1) {
                // A vertex, or the inside of a voxel.
                (true, false) | (false, true) => vec![half],
                // An edge between two vertices, or a face between two voxels, of which one may not be there.
                (true, true) => vec![half, half + 1],
                (false, false) => vec![half.wrapping_sub(1), half],
            };
            let around: Vec<usize> = around.into_iter().filter(|&one| one < length).collect();
            voxels = voxels
                .iter()
                .flat_map(|so_far| around.iter().map(move |one| so_far * length + one))
                .collect();
        }
        let numbers = voxels.iter().map(|&voxel| self.numbers[voxel]);
        let numbers: Vec<f64> = numbers
            .filter(|number| !number.is_nan())
            .map(|number| if is_superlevel { -number } else { number })
            .collect();
        match are_vertices {
            true if numbers.len() < voxels.len() => None,
            true => numbers.into_iter().reduce(f64::max),
            false => numbers.into_iter().reduce(f64::min),
        }
    }
}

/// The coordinates of a cell, of which the last one runs fastest.
fn coordinates(mut cell: usize, shape: &[usize]) -> Vec<usize> {
    let mut at = vec![0; shape.len()];
    for axis in (0..shape.len()).rev() {
        at[axis] = cell % shape[axis];
        cell /= shape[axis];
    }
    at
}

/// An array of NumPy.
fn array(bytes: &[u8]) -> Option<Image> {
    let (start, length): (usize, usize) = match bytes.get(6)? {
        1 => (10, usize::from(u16::from_le_bytes(bytes.get(8..10)?.try_into().ok()?))),
        _ => (12, u32::from_le_bytes(bytes.get(8..12)?.try_into().ok()?) as usize),
    };
    let header = std::str::from_utf8(bytes.get(start..start.checked_add(length)?)?).ok()?;
    let after = |key: &str| Some(header.split_once(key)?.1.trim_start().trim_start_matches(':').trim_start());
    if !after("'fortran_order'")?.starts_with("False") {
        return None;
    }
    let shape = after("'shape'")?.strip_prefix('(')?.split_once(')')?.0;
    let shape = shape.split(',').map(str::trim).filter(|word| !word.is_empty()).map(str::parse);
    let shape = shape.collect::<Result<Vec<usize>, _>>().ok()?;
    let data = &bytes[start + length..];
    // Numbers of so many bytes, from the lowest one on.
    fn read<const N: usize>(data: &[u8], number: impl Fn([u8; N]) -> f64) -> Option<Vec<f64>> {
        let (numbers, rest) = data.as_chunks::<N>();
        rest.is_empty().then(|| numbers.iter().map(|bytes| number(*bytes)).collect())
    }
    let numbers = match after("'descr'")?.get(..5)? {
        "'|u1'" => read(data, |[byte]: [u8; 1]| byte.into()),
        "'|i1'" => read(data, |bytes| i8::from_le_bytes(bytes).into()),
        "'<u2'" => read(data, |bytes| u16::from_le_bytes(bytes).into()),
        "'<i2'" => read(data, |bytes| i16::from_le_bytes(bytes).into()),
        "'<u4'" => read(data, |bytes| u32::from_le_bytes(bytes).into()),
        "'<i4'" => read(data, |bytes| i32::from_le_bytes(bytes).into()),
        "'<f4'" => read(data, |bytes| f32::from_le_bytes(bytes).into()),
        "'<f8'" => read(data, f64::from_le_bytes),
        _ => None,
    }?;
    let count = shape.iter().try_fold(1usize, |so_far, length| so_far.checked_mul(*length));
    (count == Some(numbers.len()) && !shape.is_empty()).then_some(Image { shape, numbers })
}

/// A grey map of pixels, as text (P2) or bytes (P5): rows from above, each from the left.
fn grey_map(bytes: &[u8]) -> Option<Image> {
    let (mut at, mut is_note) = (0, false);
    let mut word = || {
        let start = loop {
            match bytes.get(at)? {
                b'#' => is_note = true,
                b'\n' => is_note = false,
                byte if !is_note && !byte.is_ascii_whitespace() => break at,
                _ => {}
            }
            at += 1;
        };
        let length = bytes[start..].iter().take_while(|byte| !byte.is_ascii_whitespace()).count();
        at = start + length;
        std::str::from_utf8(&bytes[start..at]).ok()
    };
    let kind = word()?;
    let mut number = || word()?.parse::<usize>().ok();
    let [width, height, most] = [number()?, number()?, number()?];
    let count = width.checked_mul(height).filter(|count| *count <= bytes.len() && most < 256)?;
    let numbers: Vec<f64> = match kind {
        "P2" => (0..count).map(|_| Some(number()? as f64)).collect::<Option<Vec<f64>>>()?,
        // One blank, and then a byte for each pixel.
        "P5" => bytes
            .get(at + 1..)
            .filter(|rest| rest.len() == count)?
            .iter()
            .map(|byte| f64::from(*byte))
            .collect(),
        _ => return None,
    };
    Some(Image { shape: vec![height, width], numbers })
}

/// Checks a certificate of the persistence of an image.
pub(crate) fn check(whole: &Value, inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    let (answer, proof) = (field(whole, "answer", "answer")?, field(whole, "proof", "proof")?);
    let refuse = |message: String| Err(Fault::new("answer", message));
    let prime = index(field(answer, "field", "answer")?, "\"field\"", "answer")?;
    if !coface_check::is_prime(prime) {
        return refuse(format!("{prime} is not prime"));
    }
    let are_vertices = match text(field(answer, "function", "answer")?, "\"function\"", "answer")? {
        "voxels, v-construction" => true,
        "voxels, t-construction" => false,
        _ => return refuse("the answer is of no image".to_owned()),
    };
    let is_superlevel = match text(field(answer, "star", "answer")?, "\"star\"", "answer")? {
        "lower" => false,
        "upper" => true,
        _ => return refuse("\"star\" is neither lower nor upper".to_owned()),
    };
    let image = Image::read(inputs[0])?;
    let (complex, values) = image.cells(are_vertices, is_superlevel)?;
    let orders = pairs::orders(&complex, &values, field(proof, "order", "order")?, false)?;
    let pairs = pairs::pairs(&complex, &orders, field(proof, "chains", "chains")?, prime.into())?;
    let mut betti = vec![0u64; image.shape.len() + 1];
    pairs.iter().filter(|pair| pair.2.is_none()).for_each(|pair| betti[pair.0] += 1);
    let claimed = list(field(answer, "betti", "answer")?, "\"betti\"", "answer")?;
    if !claimed.iter().map(Value::as_u64).eq(betti.iter().map(|count| Some(*count))) {
        return refuse(format!("the Betti numbers over F_{prime} are {betti:?}"));
    }
    let least = field(whole, "min_persistence", "answer")?.as_f64();
    let least = least.ok_or_else(|| Fault::new("answer", "\"min_persistence\" is not a number"))?;
    let mut expected: BTreeMap<(usize, u64, Option<u64>), i64> = BTreeMap::new();
    let sign = if is_superlevel { -1.0 } else { 1.0 };
    // Zero has one sign.
    let bits = |value: f64| (value + 0.0).to_bits();
    for (degree, birth, death) in pairs {
        let birth = values[degree][birth as usize];
        let death = death.map(|cell| values[degree + 1][cell as usize]);
        let length = death.map_or(f64::INFINITY, |death| death - birth);
        if length > 0.0 && length > least {
            *expected
                .entry((degree, bits(sign * birth), death.map(|death| bits(sign * death))))
                .or_default() += 1;
        }
    }
    let is_first_fastest = truth(field(whole, "first_fastest", "answer")?, "\"first_fastest\"", "answer")?;
    let mut counts = vec![0; betti.len()];
    for pair in list(field(answer, "diagram", "answer")?, "\"diagram\"", "answer")? {
        let number = |key: &str, cell: &str| -> Result<Option<u64>, Fault> {
            let (Some(value), Some(cell)) = (optional(pair, key), optional(pair, cell)) else {
                return Ok(None);
            };
            let voxel =
                list(cell, "a voxel", "answer")?.iter().map(|place| index(place, "a place", "answer"));
            let mut voxel = voxel.collect::<Result<Vec<u32>, Fault>>()?;
            if is_first_fastest {
                voxel.reverse();
            }
            let value = value.as_f64().map(bits);
            match value == image.number(&voxel).map(bits) {
                true => Ok(value),
                false => {
                    Err(Fault::new("answer", format!("the voxel {cell} has not the value of the {key}")))
                }
            }
        };
        let keys = pair.as_object().into_iter().flat_map(|object| object.keys());
        if let Some(key) = keys.into_iter().find(|key| !crate::PAIR_KEYS.contains(&key.as_str())) {
            return refuse(format!("a pair has the key {key:?}, of which nothing is proved"));
        }
        let degree = index(field(pair, "degree", "answer")?, "\"degree\"", "answer")? as usize;
        let birth =
            number("birth", "birth_cell")?.ok_or_else(|| Fault::new("answer", "a pair has no birth"))?;
        let death = number("death", "death_cell")?;
        if optional(pair, "death").is_some() != death.is_some()
            || optional(pair, "death_cell").is_some() != death.is_some()
        {
            return refuse("a pair has half a death".to_owned());
        }
        *expected.entry((degree, birth, death)).or_default() -= 1;
        if let Some(count) = counts.get_mut(degree) {
            *count += 1;
        }
    }
    if expected.values().any(|count| *count != 0) {
        return refuse(
            "the pairs of the chains have other births and deaths than those of the answer".to_owned(),
        );
    }
    let what = if are_vertices { "vertices" } else { "cubes" };
    let shape: Vec<String> = image.shape.iter().map(usize::to_string).collect();
    let sets = if is_superlevel { "superlevel" } else { "sublevel" };
    let mut proved = vec![
        format!(
            "the image has {} voxels, which are {what}, and {sets} sets of their values grow",
            shape.join(" x ")
        ),
        format!("Betti numbers over F_{prime} = {betti:?}"),
    ];
    for (k, count) in counts.iter().enumerate() {
        proved.push(format!(
            "degree {k}: the births and deaths of the {count} pairs whose persistence is {}, and no others, each the value of its voxel",
            above(least)
        ));
    }
    Ok(Verdict::of(proved, answer, &[&KNOWN[..], &["function"]].concat()))
}

impl Image {
    /// The number of a voxel, by its place along each axis.
    fn number(&self, voxel: &[u32]) -> Option<f64> {
        let is_there = voxel.len() == self.shape.len()
            && voxel.iter().zip(&self.shape).all(|(at, length)| (*at as usize) < *length);
        let place =
            voxel.iter().zip(&self.shape).fold(0, |so_far, (at, length)| so_far * length + *at as usize);
        is_there.then(|| self.numbers[place])
    }
}
