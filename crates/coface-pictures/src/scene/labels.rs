//! Numbers of cells as texts in pictures.

use super::{Layer, Scene};
use coface_algebra::{Error, ErrorKind};

/// More texts would hide the model.
const MOST_LABELS: usize = 2000;

impl Scene {
    /// Writes the numbers of the cells of a dimension beside them: of vertices as the model has them, of edges in the order of their ends, of
    /// polygons as they stand in the file, with the letters v, e and f before them. Texts at places that the model hides are left out of pictures.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for a dimension above 2, and if there is no such cell; [`ErrorKind::TooLarge`] for more than 2000 of them.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::{Picture, PictureStyle, Scene};
    /// let square = &b"v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n"[..];
    /// let square = coface_io::read(square, coface_io::Format::Obj)?;
    /// let mut scene = Scene::of("square", &square)?;
    /// scene.label_cells(0)?;
    /// assert!(Picture::new(&scene, &PictureStyle::default())?.svg().contains(">v3</text>"));
    /// # Ok(()) }
    /// ```
    pub fn label_cells(&mut self, dimension: usize) -> Result<(), Error> {
        let (name, letter, cells): (_, _, Vec<Vec<u32>>) = match dimension {
            0 => {
                let seen = (0..self.positions.len() as u32).filter(|&vertex| !self.is_hidden(vertex));
                ("vertices", 'v', seen.map(|vertex| vec![vertex]).collect())
            }
            1 => ("edges", 'e', self.edges().iter().map(|ends| ends.to_vec()).collect()),
            2 => ("faces", 'f', self.polygons().iter().map(<[u32]>::to_vec).collect()),
            _ => {
                return Err(Error::invalid(format!("cells of dimension {dimension} have no texts"))
                    .with_cure("label vertices, edges or faces"));
            }
        };
        if cells.is_empty() {
            return Err(
                Error::invalid(format!("there are no {name} to label")).with_cure("label other cells")
            );
        }
        if cells.len() > MOST_LABELS {
            let message = format!("{} {name} are more than the {MOST_LABELS} that have texts", cells.len());
            return Err(
                Error::new(ErrorKind::TooLarge, message).with_cure("label other cells, or a smaller model")
            );
        }
        let mut layer = Layer::new(crate::picture::LABELS, name);
        layer.is_on = true;
        let middle = |cell: &Vec<u32>| {
            [0, 1, 2].map(|axis| {
                let sum: f64 = cell.iter().map(|&vertex| self.positions[vertex as usize][axis]).sum();
                sum / cell.len() as f64
            })
        };
        layer.positions = Some(cells.iter().map(middle).collect());
        layer.labels = (0..)
            .zip(&cells)
            .map(|(place, cell)| {
                let number = if dimension == 0 { self.numbering.of_model(cell[0]) } else { place };
                (place, format!("{letter}{number}"))
            })
            .collect();
        self.add_layer(layer);
        Ok(())
    }
}
