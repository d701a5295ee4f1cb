//! A generated input, and its files.

use coface::Error;
use coface::algebra::RaggedArray;
use coface::complexes::cell_mesh::CellShape;
use coface::complexes::simplicial::SimplicialComplex;
use coface::geometry::Positions;
use coface::io::Model;
use std::io::{BufWriter, Read, Write};
use std::path::Path;

/// Simplices by their vertices, with positions where the family has an embedding.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Mesh {
    pub(crate) vertex_count: usize,
    /// Three coordinates a vertex, or nothing.
    pub(crate) coordinates: Vec<f64>,
    pub(crate) lists: RaggedArray,
}

impl Mesh {
    /// The facets of a complex whose vertices are numbered from 0.
    ///
    /// # Errors
    /// For a complex without vertices.
    pub(crate) fn of_complex(complex: &SimplicialComplex) -> Result<Self, Error> {
        let last =
            complex.vertices().last().ok_or_else(|| Error::invalid("the empty complex is no input"))?;
        let lists = RaggedArray::from_lists(complex.facets().iter().map(|facet| facet.numbers()));
        Ok(Self { vertex_count: last.index() + 1, coordinates: Vec::new(), lists })
    }

    /// The number of vertices of every simplex; `None` when they differ.
    fn arity(&self) -> Option<usize> {
        let first = self.lists.iter().next()?.len();
        self.lists.iter().all(|list| list.len() == first).then_some(first)
    }

    /// Triangles as polygons, tetrahedra as cells.
    ///
    /// # Errors
    /// For simplices of mixed or other dimensions, which are no mesh.
    pub(crate) fn into_model(self) -> Result<Model, Error> {
        let arity = self.arity();
        let count = self.vertex_count;
        // The raw file has no coordinates; a model needs as many positions as vertices.
        let coordinates = if self.coordinates.is_empty() { vec![0.0; 3 * count] } else { self.coordinates };
        let positions = Positions::from_flat(3, coordinates)?;
        match arity {
            Some(3) => Model::from_polygons(positions, self.lists),
            Some(4) => {
                Model::from_cells(positions, vec![CellShape::Tetrahedron; self.lists.len()], self.lists)
            }
            _ => Err(Error::invalid("only triangles and tetrahedra make a model")),
        }
    }

    /// Writes the file; the extension says the format: `raw`, `raw3`, `obj`, `off` or `ply` (binary, little-endian, 32-bit
    /// coordinates).
    ///
    /// A raw file is little-endian 32-bit numbers: the vertices a simplex (0 when they differ), the vertex count, the
    /// simplex count; then, when they differ, where each simplex starts and where the last ends; then the vertices.
    /// In `raw3` three 64-bit coordinates of each vertex follow.
    ///
    /// # Errors
    /// If the file cannot be written, or the format cannot hold the simplices.
    pub(crate) fn write(&self, path: &Path) -> Result<(), Error> {
        let mut out = BufWriter::with_capacity(1 << 20, std::fs::File::create(path)?);
        let extension = path.extension().and_then(|e| e.to_str()).unwrap_or("");
        match extension {
            "raw" => self.write_raw(&mut out)?,
            "raw3" if self.coordinates.len() == 3 * self.vertex_count => {
                self.write_raw(&mut out)?;
                for coordinate in &self.coordinates {
                    out.write_all(&coordinate.to_le_bytes())?;
                }
            }
            "obj" | "off" | "ply" if self.arity() == Some(3) && !self.coordinates.is_empty() => {
                match extension {
                    "obj" => self.write_obj(&mut out)?,
                    "off" => self.write_off(&mut out)?,
                    _ => self.write_ply(&mut out)?,
                }
            }
            "raw3" | "obj" | "off" | "ply" => {
                return Err(Error::invalid(format!("only surfaces in space can be written as {extension}")));
            }
            _ => {
                return Err(Error::invalid(format!("{extension:?} is no format of an input"))
                    .with_cure("use raw, raw3, obj, off or ply"));
            }
        }
        out.flush()?;
        Ok(())
    }

    fn write_raw(&self, out: &mut impl Write) -> Result<(), Error> {
        let arity = self.arity();
        let header = [arity.unwrap_or(0), self.vertex_count, self.lists.len()];
        write_numbers(out, header.into_iter().map(|n| n as u32))?;
        if arity.is_none() {
            let mut end = 0;
            write_numbers(out, [0])?;
            write_numbers(
                out,
                self.lists.iter().map(|list| {
                    end += list.len() as u32;
                    end
                }),
            )?;
        }
        write_numbers(out, self.lists.items().iter().copied())
    }

    fn write_obj(&self, out: &mut impl Write) -> Result<(), Error> {
        for p in self.coordinates.chunks_exact(3) {
            writeln!(out, "v {:.6} {:.6} {:.6}", p[0], p[1], p[2])?;
        }
        for t in self.lists.iter() {
            writeln!(out, "f {} {} {}", t[0] + 1, t[1] + 1, t[2] + 1)?;
        }
        Ok(())
    }

    fn write_off(&self, out: &mut impl Write) -> Result<(), Error> {
        writeln!(out, "OFF\n{} {} 0", self.vertex_count, self.lists.len())?;
        for p in self.coordinates.chunks_exact(3) {
            writeln!(out, "{:.6} {:.6} {:.6}", p[0], p[1], p[2])?;
        }
        for t in self.lists.iter() {
            writeln!(out, "3 {} {} {}", t[0], t[1], t[2])?;
        }
        Ok(())
    }

    fn write_ply(&self, out: &mut impl Write) -> Result<(), Error> {
        writeln!(out, "ply\nformat binary_little_endian 1.0\nelement vertex {}", self.vertex_count)?;
        writeln!(out, "property float x\nproperty float y\nproperty float z")?;
        writeln!(
            out,
            "element face {}\nproperty list uchar int vertex_indices\nend_header",
            self.lists.len()
        )?;
        for x in &self.coordinates {
            out.write_all(&(*x as f32).to_le_bytes())?;
        }
        for t in self.lists.iter() {
            out.write_all(&[3])?;
            write_numbers(out, t.iter().copied())?;
        }
        Ok(())
    }

    /// Reads what [`Self::write`] wrote as `raw`. The file is our own, so it is trusted.
    ///
    /// # Errors
    /// If the file cannot be read or is cut short.
    pub(crate) fn read_raw(path: &Path) -> Result<Self, Error> {
        Self::read_lists(&mut std::fs::File::open(path)?)
    }

    /// Reads what [`Self::write`] wrote as `raw3`.
    ///
    /// # Errors
    /// If the file cannot be read or is cut short.
    pub(crate) fn read_raw3(path: &Path) -> Result<Self, Error> {
        let mut file = std::fs::File::open(path)?;
        let mut mesh = Self::read_lists(&mut file)?;
        let halves = read_numbers(&mut file, 6 * mesh.vertex_count)?;
        let coordinate = |&[low, high]: &[u32; 2]| f64::from_bits(u64::from(low) | u64::from(high) << 32);
        mesh.coordinates = halves.as_chunks::<2>().0.iter().map(coordinate).collect();
        Ok(mesh)
    }

    fn read_lists(mut file: &mut std::fs::File) -> Result<Self, Error> {
        let header = read_numbers(&mut file, 3)?;
        let [arity, vertex_count, count] = [0, 1, 2].map(|i| header[i] as usize);
        let lists = if arity > 0 {
            RaggedArray::uniform(arity, read_numbers(&mut file, arity * count)?)?
        } else {
            let starts = read_numbers(&mut file, count + 1)?;
            let members = read_numbers(&mut file, starts[count] as usize)?;
            RaggedArray::from_parts(starts, members)?
        };
        Ok(Self { vertex_count, coordinates: Vec::new(), lists })
    }
}

fn write_numbers(out: &mut impl Write, numbers: impl IntoIterator<Item = u32>) -> Result<(), Error> {
    for number in numbers {
        out.write_all(&number.to_le_bytes())?;
    }
    Ok(())
}

fn read_numbers(file: &mut impl Read, count: usize) -> Result<Vec<u32>, Error> {
    let mut numbers = Vec::with_capacity(count);
    let mut block = vec![0; 1 << 20];
    while numbers.len() < count {
        let size = (4 * (count - numbers.len())).min(block.len());
        file.read_exact(&mut block[..size])?;
        numbers.extend(block[..size].chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])));
    }
    Ok(numbers)
}

#[cfg(test)]
mod tests {
    use super::Mesh;
    use crate::inputs::generate;

    #[test]
    fn a_raw_file_gives_the_same_simplices() {
        for name in ["ico1", "t3_3", "simp_200", "t4_3", "lm_9x20"] {
            let path =
                std::env::temp_dir().join(format!("coface-bench-test-{}-{name}.raw", std::process::id()));
            let mesh = generate(name).unwrap();
            mesh.write(&path).unwrap();
            let read = Mesh::read_raw(&path).unwrap();
            std::fs::remove_file(&path).unwrap();
            assert_eq!((read.vertex_count, read.lists), (mesh.vertex_count, mesh.lists));
        }
        let path = std::env::temp_dir().join(format!("coface-bench-test-{}.raw3", std::process::id()));
        let soup = generate("soup1").unwrap();
        soup.write(&path).unwrap();
        let read = Mesh::read_raw3(&path).unwrap();
        std::fs::remove_file(&path).unwrap();
        assert_eq!(read, soup);
        assert!(generate("lm_9x20").unwrap().write(&path).is_err());
        std::fs::remove_file(&path).unwrap();
    }
}
