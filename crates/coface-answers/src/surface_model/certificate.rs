//! Certificates of surfaces that were cut open, and of their covers.

use super::{SurfaceCover, SurfaceCut};
use crate::answer::DoubleCoverAnswer;
use crate::homology::certificate::{Input, checked, refused};
use coface_algebra::{EdgeId, Error, FaceId, VertexId};
use serde::Serialize;
use std::collections::HashMap;

/// A certificate, as `docs/certificates.md` describes it.
#[derive(Serialize)]
struct Certificate<A, P> {
    coface_certificate: u64,
    coface: &'static str,
    kind: &'static str,
    inputs: Vec<Input>,
    /// The path along which the surface was cut.
    #[serde(skip_serializing_if = "Option::is_none")]
    along: Option<Vec<u32>>,
    answer: A,
    #[serde(skip_serializing_if = "Option::is_none")]
    proof: Option<P>,
}

/// What was cut to disks.
#[derive(Serialize)]
struct Edges {
    /// All edges that were cut, with those that are in no seam.
    edges: Vec<[u32; 2]>,
}

/// What was cut along a path.
#[derive(Serialize)]
struct Faces {
    /// For each component a face of it.
    faces: Vec<Vec<u32>>,
}

impl SurfaceCut<'_> {
    /// A certificate of the cut, from the name and the bytes of the file that the model was read from: what each component is, that it was cut to a disk,
    /// and that the way around the disk passes each seam twice as the word says; or what is left after a cut along a path.
    /// [`coface_check_walks::check`] derives that without any code of this library, as `docs/certificates.md` says. It has been checked.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::UnsupportedFormat`] if the checker does not read the file as this library does: it reads facet lists, and plain OFF and
    /// OBJ. [`coface_algebra::ErrorKind::InvalidInput`] for a canonical cut, which is of a refined surface that no file has.
    ///
    /// # Complexity
    /// $O(n \log n)$.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CutRequest, SurfaceModel};
    /// let input = &b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"[..];
    /// let surface = SurfaceModel::of(coface_io::read(input, coface_io::Format::Json)?)?;
    /// let cut = surface.cut_open(&CutRequest { simplify: true, ..CutRequest::default() })?;
    /// let certificate = cut.certificate(&[("sphere.json", input)])?;
    /// let verdict = coface_check_walks::check(certificate.as_bytes(), &[input]).expect("the proof holds");
    /// assert!(verdict.proved()[0].contains("sphere, cut along 2 edges to a disk"));
    /// # Ok(()) }
    /// ```
    pub fn certificate(&self, inputs: &[(&str, &[u8])]) -> Result<String, Error> {
        let [(name, _)] = inputs else {
            return Err(Error::invalid("a certificate of a cut is of one input"));
        };
        if self.refinement.is_some() {
            return Err(Error::invalid("a canonical cut is of a refined surface, and has no certificate")
                .with_cure("leave the loops on the edges of the file"));
        }
        let mut answer = self.answer();
        answer.file = Some((*name).to_owned());
        let text = if self.is_along_path() {
            let along = Some(self.seam_vertices(0));
            let faces = Faces { faces: self.faces() };
            checked(&Certificate { along, ..certificate("cut", answer, inputs, Some(faces)) }, inputs)
        } else {
            let edges = self.edges.iter().map(|&edge| self.surface.edge_numbers(edge)).collect();
            checked(&certificate("cut", answer, inputs, Some(Edges { edges })), inputs)
        };
        text.map_err(|fault| refused(&fault.to_string()))
    }

    /// For each piece a face of it, by its vertices in the file.
    fn faces(&self) -> Vec<Vec<u32>> {
        let open = self.slice.surface();
        let orientation = open.orientation();
        let mut first: Vec<Option<FaceId>> = vec![None; self.components.len()];
        for face in (0..open.skeleton().face_count()).map(FaceId::new) {
            first[orientation.component(face)].get_or_insert(face);
        }
        let numbers = |face| self.surface.face_numbers(face);
        first.into_iter().flatten().map(numbers).collect()
    }
}

/// The part of a cover.
#[derive(Serialize)]
struct Sheets {
    /// For each vertex of the cover the vertex below.
    vertices: Vec<u32>,
    /// The faces of the cover by its vertices, one copy after the other.
    faces: Vec<Vec<u32>>,
    /// For each letter the face on the side that it leaves; none where no copy needs it.
    from: Vec<Option<Vec<u32>>>,
}

impl SurfaceCover<'_> {
    /// A certificate of the cover, from the name and the bytes of the file that the model was read from: copies glued to a disk or a sphere, on which the
    /// way down is a local isomorphism; the words of the copies; and whether it is the whole cover, whose degree is then proved.
    /// [`coface_check_walks::check`] derives that without any code of this library, as `docs/certificates.md` says. It has been checked.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::UnsupportedFormat`] if the checker does not read the file as this library does: it reads facet lists, and plain OFF and
    /// OBJ.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n cells of the cover.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::SurfaceModel;
    /// use coface_topology::CoverExtent;
    /// let input = &b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"[..];
    /// let surface = SurfaceModel::of(coface_io::read(input, coface_io::Format::Json)?)?;
    /// let cover = surface.cover(0, CoverExtent::Radius(3), 1000)?;
    /// let certificate = cover.certificate(&[("sphere.json", input)])?;
    /// let verdict = coface_check_walks::check(certificate.as_bytes(), &[input]).expect("the proof holds");
    /// assert!(verdict.proved().contains(&"complete = true".to_owned()));
    /// # Ok(()) }
    /// ```
    pub fn certificate(&self, inputs: &[(&str, &[u8])]) -> Result<String, Error> {
        let [(name, _)] = inputs else {
            return Err(Error::invalid("a certificate of a cover is of one input"));
        };
        let mut answer = self.answer(None);
        answer.file = Some((*name).to_owned());
        let vertices = (0..self.cover().skeleton().vertex_count())
            .map(|vertex| self.surface().number(self.cover().vertex_below(VertexId::new(vertex))))
            .collect();
        let faces = self.cover().polygons().iter().map(<[u32]>::to_vec).collect();
        let from = self.sides_left(&answer.words);
        let sheets = Sheets { vertices, faces, from };
        checked(&certificate("cover", answer, inputs, Some(sheets)), inputs)
            .map_err(|fault| refused(&fault.to_string()))
    }

    /// For each letter the face below, by its vertices, on the side of the copy whose word does not have the letter yet.
    fn sides_left(&self, words: &[Vec<i32>]) -> Vec<Option<Vec<u32>>> {
        let (cover, skeleton) = (self.cover(), self.cover().skeleton());
        let letters = cover.letters();
        let place: HashMap<EdgeId, usize> = letters.iter().copied().zip(0..).collect();
        let mut faces_at: HashMap<EdgeId, Vec<FaceId>> = HashMap::new();
        for face in (0..skeleton.face_count()).map(FaceId::new) {
            for step in skeleton.faces().list(face.index()) {
                let edge = EdgeId::from_u32(step >> 1);
                if place.contains_key(&cover.edge_below(edge)) {
                    faces_at.entry(edge).or_default().push(face);
                }
            }
        }
        let mut edges: Vec<EdgeId> = faces_at.keys().copied().collect();
        edges.sort_unstable();
        let mut from = vec![None; letters.len()];
        for edge in edges {
            let letter = place[&cover.edge_below(edge)];
            let number = letter as i32 + 1;
            let [a, b] = faces_at[&edge][..] else { continue };
            for [here, there] in [[a, b], [b, a]] {
                let [before, after] = [here, there].map(|face| &words[cover.face_copy(face)]);
                let is_along = after.split_last() == Some((&number, &before[..]));
                let is_back = before.split_last() == Some((&-number, &after[..]));
                if is_along || is_back {
                    from[letter].get_or_insert_with(|| self.surface().face_numbers(cover.face_below(here)));
                }
            }
        }
        from
    }
}

impl DoubleCoverAnswer {
    /// A certificate of the orientation double cover, from the name and the bytes of the file that the model was read from.
    /// [`coface_check_walks::check`] derives it without any code of this library, as `docs/certificates.md` says. It has been checked.
    ///
    /// # Errors
    /// As of [`SurfaceCover::certificate`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::SurfaceModel;
    /// // A Moebius band.
    /// let input = &b"[[0,1,2],[1,2,3],[2,3,4],[3,4,0],[4,0,1]]"[..];
    /// let surface = SurfaceModel::of(coface_io::read(input, coface_io::Format::Json)?)?;
    /// let (answer, _) = surface.double_cover("band.json")?;
    /// let certificate = answer.certificate(&[("band.json", input)])?;
    /// let verdict = coface_check_walks::check(certificate.as_bytes(), &[input]).expect("it is an annulus");
    /// assert_eq!(verdict.proved()[1], "surfaces, in some order: annulus");
    /// # Ok(()) }
    /// ```
    pub fn certificate(&self, inputs: &[(&str, &[u8])]) -> Result<String, Error> {
        if inputs.len() != 1 {
            return Err(Error::invalid("a certificate of a cover is of one input"));
        }
        let certificate = certificate("orientation cover", self.clone(), inputs, None::<Sheets>);
        checked(&certificate, inputs).map_err(|fault| refused(&fault.to_string()))
    }
}

fn certificate<A, P>(
    kind: &'static str,
    answer: A,
    inputs: &[(&str, &[u8])],
    proof: Option<P>,
) -> Certificate<A, P> {
    Certificate {
        coface_certificate: coface_check::VERSION,
        coface: env!("CARGO_PKG_VERSION"),
        kind,
        inputs: Input::list(inputs),
        along: None,
        answer,
        proof,
    }
}
