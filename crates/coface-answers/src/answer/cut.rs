//! The answer of `cut`: surfaces cut open.

use super::{Place, RefinementAnswer, Remark, RemarkCode, TreesAnswer};
use crate::{CutComponent, PlacedPolygons, SurfaceCut};
use coface_algebra::Word;
use serde::{Deserialize, Serialize};

/// A surface cut open.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CutAnswer {
    /// The name of the input; absent for a model that was made in memory.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub file: Option<String>,
    /// Whether loose ends were left out and seams made short.
    pub simplified: bool,
    /// The path along which the surface was cut; `null` when it was cut to disks.
    pub path: Option<CutPath>,
    /// The pieces, each with its counts.
    pub components: Vec<CutPiece>,
    /// The numbers of vertices, edges and faces of all pieces together.
    pub f_vector: Vec<usize>,
    /// What each edge is in the tree-cotree decomposition; absent unless it was asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub roles: Option<TreesAnswer>,
    /// Of a canonical cut what was added to the surface; the numbers of vertices in seams are those of the refined surface.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub refinement: Option<RefinementAnswer>,
    /// How the polygons of a canonical cut were drawn; absent unless a layout was asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub layout: Option<LayoutAnswer>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// Canonical polygons drawn as regular polygons.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LayoutAnswer {
    /// `polygon`: in the unit circle of the Euclidean plane; `klein`: in the disk of Klein, where geodesics are straight, so that the corners make
    /// one full turn together. Polygons of several components are 2.5 apart.
    pub plane: String,
    /// `uniform`: vertices inside are means of their neighbors; `cotangent`: weighted means, by the cotangents of the intrinsic Delaunay triangulation.
    pub weights: String,
    /// Whether the layout is texture coordinates `s` and `t` of the mesh in space, and not its positions.
    pub texture: bool,
    /// The number of triangles.
    pub triangles: usize,
    /// How many of them are turned over or flat, decided exactly.
    pub turned: usize,
}

/// A path along which a surface was cut.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CutPath {
    /// `two-sided`, `one-sided` or `open`.
    pub kind: String,
    /// The number of its edges.
    pub edges: usize,
}

/// One component after the cut.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CutPiece {
    /// The surface: before it was cut to a disk, or after it was cut along a path.
    pub surface: String,
    /// The number of edges along which it was cut.
    pub cut_edges: usize,
    /// The number of edges around it now.
    pub boundary_edges: usize,
    /// Vertices minus edges plus faces: 1 of a disk.
    pub euler_characteristic: i64,
    /// The numbers of vertices, edges and faces now.
    pub f_vector: [usize; 3],
    /// The fundamental domain; absent when the surface was cut along a path.
    #[serde(flatten)]
    pub domain: Option<FundamentalDomain>,
}

/// The disk that a component was cut to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FundamentalDomain {
    /// The vertex where loops start, by its number in the file.
    pub base: u32,
    /// The number of generators of the fundamental group.
    pub generators: usize,
    /// The word of generators around the disk, where there is one: i for generator i, counted from 1, -i for its inverse.
    pub relator: Option<Vec<i32>>,
    /// The seams of the component.
    pub seams: Vec<SeamAnswer>,
    /// The seams around the disk: i for the i-th of them, counted from 1, -i backwards.
    pub word: Vec<i32>,
    /// Of a canonical cut the word around the disk by the names of seams and of boundary loops: `a1 b1 a1^-1 b1^-1 ..` of handles,
    /// `c1 c1 c2 c2 ..` of cross-caps, `e1 d1 e1^-1 ..` of boundary loops d1, .. to which seams e1, .. lead; `s1 s1^-1` of a sphere, `d1` of a disk.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub canonical: Option<String>,
}

/// A path of edges along which a component was cut.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SeamAnswer {
    /// The number among all seams, counted from 1.
    pub number: usize,
    /// Its name in the canonical word; absent unless the cut is canonical.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// `handle`: with the others of this kind it opens the handles of an orientable component; `crosscap`: with the others it opens the
    /// cross-caps of one that is not orientable; `join`, `slit`.
    pub kind: String,
    /// What the disk becomes when it is glued together again at this seam alone: `annulus` or `moebius`.
    #[serde(default)]
    pub glued: String,
    /// The number of its edges.
    pub edges: usize,
    /// Its length in the unit of the file; `null` without positions.
    pub length: Option<f64>,
    /// Its vertices in their order, by their numbers in the file.
    pub vertices: Vec<u32>,
}

impl SurfaceCut<'_> {
    /// The cut as plain data, without the name of a file.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CutRequest, SurfaceModel};
    /// // The torus of seven vertices.
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let surface = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let cut = surface.cut_open(&CutRequest { simplify: true, ..CutRequest::default() })?;
    /// assert_eq!(cut.answer().f_vector, cut.components()[0].f_vector);
    /// # Ok(()) }
    /// ```
    pub fn answer(&self) -> CutAnswer {
        CutAnswer {
            file: None,
            simplified: self.is_simplified(),
            path: self
                .is_along_path()
                .then(|| CutPath { kind: self.seams()[0].kind().to_owned(), edges: self.edges().len() }),
            components: self.components().iter().map(|component| self.piece(component)).collect(),
            f_vector: self.f_vector(),
            roles: self.roles().cloned(),
            refinement: self.refinement().cloned(),
            layout: self.placed().map(|placed| LayoutAnswer {
                plane: placed.plane_word().to_owned(),
                weights: placed.request().weights.word().to_owned(),
                texture: placed.request().as_texture,
                triangles: placed.triangle_count(),
                turned: placed.turned(),
            }),
            remarks: self.remarks(),
        }
    }

    /// What the components leave out.
    pub(crate) fn remarks(&self) -> Vec<Remark> {
        let mut remarks: Vec<Remark> = self.placed().and_then(PlacedPolygons::remark).into_iter().collect();
        let isolated = self.isolated_vertices();
        if isolated.is_empty() {
            return remarks;
        }
        let few: Vec<String> = isolated.iter().take(10).map(u32::to_string).collect();
        let more = if isolated.len() > few.len() { ", .." } else { "" };
        let vertices = crate::text::count(isolated.len(), "isolated vertex");
        let message = format!(
            "{vertices} in no face: no component has them, and nothing is cut there ({}{more})",
            few.join(", ")
        );
        let places = isolated.iter().take(10).map(|&vertex| Place::cell(&[vertex]));
        remarks.push(Remark::new(RemarkCode::IsolatedVertex, message).at(isolated.len(), places));
        remarks
    }

    fn piece(&self, component: &CutComponent) -> CutPiece {
        CutPiece {
            surface: component.surface.clone(),
            cut_edges: component.cut_edges,
            boundary_edges: component.boundary_edges,
            euler_characteristic: component.euler_characteristic(),
            f_vector: component.f_vector,
            domain: component.base.map(|base| FundamentalDomain {
                base,
                generators: component.generators,
                relator: component.relator.as_ref().map(Word::letters).map(<[i32]>::to_vec),
                seams: component.seams.iter().map(|&seam| self.seam(seam)).collect(),
                word: component.word.clone(),
                canonical: component.canonical.clone(),
            }),
        }
    }

    fn seam(&self, number: usize) -> SeamAnswer {
        let seam = &self.seams()[number];
        SeamAnswer {
            number: number + 1,
            name: seam.name().map(str::to_owned),
            kind: seam.kind().to_owned(),
            glued: if seam.is_reversing() { "moebius" } else { "annulus" }.to_owned(),
            edges: seam.steps().len(),
            length: seam.length(),
            vertices: self.seam_vertices(number),
        }
    }
}
