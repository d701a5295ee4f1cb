//! Surfaces of polygons with coordinates in OFF and OBJ: as little of these formats as files need, and a refusal for the rest.

use coface_check::Fault;

const STEP: &str = "input";

/// The polygons of all inputs, one after the other.
#[derive(Default)]
pub(crate) struct Solids {
    pub(crate) polygons: Vec<Polygon>,
}

/// The corners of a polygon in order, and the input that it is of.
pub(crate) struct Polygon {
    pub(crate) corners: Vec<[f64; 3]>,
    pub(crate) input: u32,
}

impl Solids {
    pub(crate) fn read(inputs: &[&[u8]]) -> Result<Self, Fault> {
        let mut solids = Self::default();
        for (input, bytes) in (0..).zip(inputs) {
            let text = std::str::from_utf8(bytes)
                .map_err(|_| Fault::new(STEP, "the checker reads text, not this"))?;
            let (points, faces) = match text.split_whitespace().next() {
                Some("OFF") => off(text)?,
                _ => obj(text)?,
            };
            for face in faces {
                let corner = |&number: &u32| points.get(number as usize).copied();
                let corners: Option<Vec<[f64; 3]>> = face.iter().map(corner).collect();
                let corners = corners.ok_or_else(|| Fault::new(STEP, "a face has a vertex that is none"))?;
                solids.polygons.push(Polygon { corners, input });
            }
        }
        Ok(solids)
    }
}

type Mesh = (Vec<[f64; 3]>, Vec<Vec<u32>>);

fn off(text: &str) -> Result<Mesh, Fault> {
    let lines = text.lines().map(|line| line.split('#').next().unwrap_or("").trim());
    let mut lines = lines.filter(|line| !line.is_empty());
    let mut next = || lines.next().ok_or_else(|| Fault::new(STEP, "the OFF file ends early"));
    let counts = match next()?.strip_prefix("OFF").map(str::trim) {
        Some("") => next()?,
        Some(rest) => rest,
        None => return Err(Fault::new(STEP, "the OFF file does not start with OFF")),
    };
    let counts = counts.split_whitespace().map(number).collect::<Result<Vec<u32>, _>>()?;
    let [point_count, face_count, ..] = counts[..] else {
        return Err(Fault::new(STEP, "the OFF file has no counts"));
    };
    let (mut points, mut faces) = (Vec::new(), Vec::new());
    for _ in 0..point_count {
        points.push(point(next()?.split_whitespace(), true)?);
    }
    for _ in 0..face_count {
        let mut words = next()?.split_whitespace();
        let count = number(words.next().unwrap_or(""))? as usize;
        let face = words.take(count).map(number).collect::<Result<Vec<u32>, _>>()?;
        if face.len() != count {
            return Err(Fault::new(STEP, "a face of the OFF file has fewer vertices than it says"));
        }
        faces.push(face);
    }
    match lines.next() {
        None => Ok((points, faces)),
        Some(line) => Err(Fault::new(STEP, format!("{line:.40?} stands behind the last face"))),
    }
}

fn obj(text: &str) -> Result<Mesh, Fault> {
    let (mut points, mut faces) = (Vec::new(), Vec::new());
    for line in text.lines() {
        let line = line.split('#').next().unwrap_or("");
        let mut words = line.split_whitespace();
        let Some(key) = words.next() else { continue };
        if line.trim_end().ends_with('\\') {
            return Err(Fault::new(STEP, "a line of the OBJ file goes on in the next"));
        }
        match key {
            "v" => points.push(point(words, false)?),
            "f" => faces.push(words.map(|word| corner(word, points.len())).collect::<Result<_, _>>()?),
            "vt" | "vn" | "g" | "o" | "s" | "usemtl" | "mtllib" => (),
            _ => return Err(Fault::new(STEP, format!("{line:.40?} is no line that the checker knows"))),
        }
    }
    Ok((points, faces))
}

/// Three coordinates; `is_all` that nothing follows, where colors might.
fn point<'a>(mut words: impl Iterator<Item = &'a str>, is_all: bool) -> Result<[f64; 3], Fault> {
    let mut point = [0.0; 3];
    for coordinate in &mut point {
        let word = words.next().unwrap_or("");
        let number = word.parse().ok().filter(|number: &f64| number.is_finite());
        *coordinate = number.ok_or_else(|| Fault::new(STEP, format!("{word:.40?} is no coordinate")))?;
    }
    match words.next() {
        Some(word) if is_all => Err(Fault::new(STEP, format!("{word:.40?} stands behind three coordinates"))),
        _ => Ok(point),
    }
}

fn number(word: &str) -> Result<u32, Fault> {
    word.parse().map_err(|_| Fault::new(STEP, format!("{word:.40?} is no number of a vertex or a count")))
}

/// The vertex of a corner such as `3/1/2`, which counts from 1, or from the last vertex down from -1.
fn corner(word: &str, point_count: usize) -> Result<u32, Fault> {
    let fault = || Fault::new(STEP, format!("{word:.40?} is no vertex so far"));
    let given: i64 = word.split('/').next().unwrap_or("").parse().map_err(|_| fault())?;
    let position = if given < 0 { point_count as i64 + given } else { given - 1 };
    let is_there = (0..point_count as i64).contains(&position);
    u32::try_from(position).ok().filter(|_| is_there).ok_or_else(fault)
}
