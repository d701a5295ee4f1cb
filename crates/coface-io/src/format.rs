//! The formats and their names.

use crate::ReferenceSystem;
use crate::unpacking::Packing;
use coface_algebra::{Error, ErrorKind};
use std::path::Path;

/// A file format that is read and written here.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Format {
    /// The OFF family: polygons with positions of any dimension.
    Off,
    /// Wavefront OBJ: polygons, polylines, groups.
    Obj,
    /// The Stanford polygon format, ascii and binary.
    Ply,
    /// Stereolithography: loose triangles, ascii and binary.
    Stl,
    /// MEDIT `.mesh` and `.meshb`: polygons and 3-cells with reference numbers.
    Medit,
    /// Gmsh MSH 2 and 4: polygons and 3-cells with physical groups.
    Msh,
    /// Legacy VTK: polygons, 3-cells, structured grids.
    Vtk,
    /// Facet lists, halfedge permutations, chain complexes and gluing tables as JSON.
    Json,
    /// Isomorphism signatures of gluing tables of tetrahedra.
    Isosig,
    /// Segments in the plane as text, four numbers a line.
    Lines,
    /// GeoJSON: points, lines and polygons with holes, with names.
    GeoJson,
    /// Well-known text: points, lines and polygons with holes.
    Wkt,
    /// Well-known binary: points, lines and polygons with holes.
    Wkb,
    /// Well-known binary as hexadecimal digits.
    WkbHex,
    /// SVG: paths, polygons and lines.
    Svg,
    /// Binary curves of sets in the plane.
    Dat,
    /// VTK XML, unstructured grids: polygons and 3-cells.
    VtkGrid,
    /// VTK XML, polygonal data.
    VtkPolygons,
    /// The binary container of chain complexes.
    Container,
    /// NumPy arrays of voxels.
    Npy,
    /// NRRD arrays of voxels.
    Nrrd,
    /// NIfTI-1 and -2: arrays of voxels, compressed or not, in one file or two.
    Nifti,
    /// MetaImage of ITK: arrays of voxels, in one file or two, read only.
    MetaImage,
    /// Grey images of Netpbm: arrays of pixels, read only.
    Pgm,
    /// Images as PNG: arrays of pixels, read only.
    Png,
    /// glTF and GLB: placed meshes, read only.
    Gltf,
    /// 3MF: placed meshes.
    ThreeMf,
    /// COLLADA: placed meshes, read only.
    Collada,
    /// AMF: placed meshes, plain or in an archive.
    Amf,
    /// Abaqus input: nodes, elements and sets, read only.
    Abaqus,
    /// Text files of TetGen and Triangle: nodes, elements, facets, read only.
    TetGen,
    /// Points as text, one a line, read only.
    Points,
    /// CityJSON and its text sequences: `.city.json`, `.city.jsonl`. It is read only.
    CityJson,
    /// Matrix Market: a boundary matrix, read only; with `--flag` a graph, with `--rips` distances.
    MatrixMarket,
}

impl Format {
    /// All formats.
    pub const ALL: [Self; 34] = [
        Self::Off,
        Self::Obj,
        Self::Ply,
        Self::Stl,
        Self::Medit,
        Self::Msh,
        Self::Vtk,
        Self::VtkGrid,
        Self::VtkPolygons,
        Self::Json,
        Self::Isosig,
        Self::Lines,
        Self::GeoJson,
        Self::Wkt,
        Self::Wkb,
        Self::WkbHex,
        Self::Svg,
        Self::Dat,
        Self::Container,
        Self::Npy,
        Self::Nrrd,
        Self::Nifti,
        Self::MetaImage,
        Self::Pgm,
        Self::Png,
        Self::Gltf,
        Self::ThreeMf,
        Self::Collada,
        Self::Amf,
        Self::Abaqus,
        Self::TetGen,
        Self::Points,
        Self::CityJson,
        Self::MatrixMarket,
    ];

    /// Whether a file is lines of text without a mark at its end, so that a cut within the last line can look like a whole file.
    pub(crate) const fn is_lines_of_text(self) -> bool {
        matches!(
            self,
            Self::Off
                | Self::Obj
                | Self::Ply
                | Self::Vtk
                | Self::Lines
                | Self::Dat
                | Self::Isosig
                | Self::Abaqus
                | Self::TetGen
                | Self::Points
        )
    }

    /// The name of the format, which is its usual file extension: `off`, `obj`, `ply`, `stl`, `mesh`, `msh`, `vtk`,
    /// `vtu`, `vtp`, `json`, `isosig`, `lines`, `geojson`, `wkt`, `wkb`, `hex`, `svg`, `dat`, `npy`, `nrrd`, `nii`,
    /// `cfc`, `gltf`, `3mf`, `dae`, `inp`, `node`, `xyz`, `cityjson`, `mtx`.
    ///
    /// # Examples
    /// ```
    /// use coface_io::Format;
    /// assert_eq!(Format::Medit.name(), "mesh");
    /// ```
    pub const fn name(self) -> &'static str {
        self.extensions()[0]
    }

    /// The file extensions of the format, the usual one first.
    ///
    /// # Examples
    /// ```
    /// use coface_io::Format;
    /// assert_eq!(Format::Medit.extensions(), ["mesh", "meshb"]);
    /// ```
    pub const fn extensions(self) -> &'static [&'static str] {
        match self {
            Self::Off => &["off", "coff", "noff", "cnoff", "stoff", "4off", "noff4"],
            Self::Obj => &["obj"],
            Self::Ply => &["ply"],
            Self::Stl => &["stl", "stla", "stlb"],
            Self::Medit => &["mesh", "meshb"],
            Self::Msh => &["msh"],
            Self::Vtk => &["vtk"],
            Self::Json => &["json", "jsonl", "ndjson"],
            Self::Isosig => &["isosig", "sig"],
            Self::Lines => &["lines"],
            Self::GeoJson => &["geojson", "geojsonl", "geojsons"],
            Self::Wkt => &["wkt"],
            Self::Wkb => &["wkb", "ewkb"],
            Self::WkbHex => &["hex", "wkbhex"],
            Self::Svg => &["svg"],
            Self::Dat => &["dat"],
            Self::VtkGrid => &["vtu"],
            Self::VtkPolygons => &["vtp"],
            Self::Container => &["cfc"],
            Self::Npy => &["npy"],
            Self::Nrrd => &["nrrd", "nhdr"],
            Self::Nifti => &["nii", "nii.gz", "hdr", "img"],
            Self::MetaImage => &["mha", "mhd"],
            Self::Pgm => &["pgm"],
            Self::Png => &["png"],
            Self::Gltf => &["gltf", "glb"],
            Self::ThreeMf => &["3mf"],
            Self::Collada => &["dae"],
            Self::Amf => &["amf"],
            Self::Abaqus => &["inp"],
            Self::TetGen => &["node", "ele", "face", "edge", "poly"],
            Self::Points => &["xyz", "csv", "pts", "asc"],
            Self::CityJson => &["cityjson"],
            Self::MatrixMarket => &["mtx"],
        }
    }

    /// The name of the format in a sentence.
    ///
    /// # Examples
    /// ```
    /// use coface_io::Format;
    /// assert_eq!(Format::Msh.title(), "Gmsh MSH");
    /// ```
    pub const fn title(self) -> &'static str {
        match self {
            Self::Off => "OFF",
            Self::Obj => "OBJ",
            Self::Ply => "PLY",
            Self::Stl => "STL",
            Self::Medit => "MEDIT mesh",
            Self::Msh => "Gmsh MSH",
            Self::Vtk => "legacy VTK",
            Self::Json => "JSON",
            Self::Isosig => "isomorphism signatures",
            Self::Lines => "line segments",
            Self::GeoJson => "GeoJSON",
            Self::Wkt => "WKT",
            Self::Wkb => "WKB",
            Self::WkbHex => "WKB as digits",
            Self::Svg => "SVG",
            Self::Dat => "binary curves",
            Self::VtkGrid => "VTK XML",
            Self::VtkPolygons => "VTK XML of polygons",
            Self::Container => "container of chain complexes",
            Self::Npy => "NumPy array",
            Self::Nrrd => "NRRD",
            Self::Nifti => "NIfTI",
            Self::MetaImage => "MetaImage",
            Self::Pgm => "PGM image",
            Self::Png => "PNG image",
            Self::Gltf => "glTF",
            Self::ThreeMf => "3MF",
            Self::Collada => "COLLADA",
            Self::Amf => "AMF",
            Self::Abaqus => "Abaqus input",
            Self::TetGen => "TetGen text",
            Self::Points => "points as text",
            Self::CityJson => "CityJSON",
            Self::MatrixMarket => "Matrix Market",
        }
    }

    /// The format of this name: any of [`Self::extensions`], or `medit`, `gmsh`, `numpy`, `nifti`, `metaimage`, `collada`, `abaqus`,
    /// `tetgen` or `points`, in any case.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] listing the names.
    ///
    /// # Examples
    /// ```
    /// use coface_io::Format;
    /// assert_eq!(Format::from_name("OFF").ok(), Some(Format::Off));
    /// assert!(Format::from_name("docx").is_err());
    /// ```
    pub fn from_name(name: &str) -> Result<Self, Error> {
        let lower = name.trim_start_matches('.').to_ascii_lowercase();
        match lower.as_str() {
            "medit" => return Ok(Self::Medit),
            "gmsh" => return Ok(Self::Msh),
            "numpy" => return Ok(Self::Npy),
            "nifti" => return Ok(Self::Nifti),
            "metaimage" => return Ok(Self::MetaImage),
            "collada" => return Ok(Self::Collada),
            "abaqus" => return Ok(Self::Abaqus),
            "tetgen" => return Ok(Self::TetGen),
            "points" => return Ok(Self::Points),
            "city.json" | "city.jsonl" => return Ok(Self::CityJson),
            _ => {}
        }
        Self::ALL.into_iter().find(|format| format.extensions().contains(&lower.as_str())).ok_or_else(|| {
            Error::new(
                ErrorKind::UnsupportedFormat,
                format!("\"{}\" is no format known here", lower.escape_debug()),
            )
            .with_cure(format!("choose one of {}", names()))
        })
    }

    /// Whether [`crate::write`] writes the named groups of a model in this format; the others leave them out.
    ///
    /// # Examples
    /// ```
    /// use coface_io::Format;
    /// assert!(Format::Obj.keeps_groups() && !Format::Off.keeps_groups());
    /// ```
    pub const fn keeps_groups(self) -> bool {
        matches!(self, Self::Obj | Self::Medit | Self::Msh | Self::GeoJson | Self::ThreeMf | Self::Amf)
    }

    /// Whether [`crate::write`] writes the data on cells of a model in this format; the others leave them out.
    ///
    /// # Examples
    /// ```
    /// use coface_io::Format;
    /// assert!(Format::Vtk.keeps_data() && Format::Ply.keeps_data() && !Format::Obj.keeps_data());
    /// ```
    pub const fn keeps_data(self) -> bool {
        matches!(self, Self::Ply | Self::Vtk | Self::VtkGrid | Self::VtkPolygons | Self::Msh)
    }

    /// Whether files of the format are maps: polygons with holes, lines and points, with heights that do not decide what meets.
    ///
    /// # Examples
    /// ```
    /// use coface_io::Format;
    /// assert!(Format::GeoJson.keeps_heights() && !Format::Obj.keeps_heights() && !Format::Svg.keeps_heights());
    /// ```
    pub const fn keeps_heights(self) -> bool {
        matches!(self, Self::GeoJson | Self::Wkt | Self::Wkb | Self::WkbHex)
    }

    /// Whether [`crate::write`] writes this reference system of a model in this format: the number in WKT and WKB, any in GeoJSON.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{Format, ReferenceSystem};
    /// let named = ReferenceSystem::from_crs(r#"{"type":"name","properties":{"name":"ESRI:102008"}}"#)?;
    /// let keeps = |format: Format| named.as_ref().map(|system| format.keeps_reference(system));
    /// assert_eq!([Format::GeoJson, Format::Wkt].map(keeps), [Some(true), Some(false)]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn keeps_reference(self, system: &ReferenceSystem) -> bool {
        match self {
            Self::GeoJson => true,
            Self::Wkt | Self::Wkb | Self::WkbHex => system.srid().is_some(),
            _ => false,
        }
    }

    /// Whether files of the format hold arrays of voxels.
    ///
    /// # Examples
    /// ```
    /// use coface_io::Format;
    /// assert!(Format::Nifti.is_volume() && !Format::Vtk.is_volume());
    /// ```
    pub const fn is_volume(self) -> bool {
        matches!(self, Self::Npy | Self::Nrrd | Self::Nifti | Self::MetaImage | Self::Pgm | Self::Png)
    }

    /// Whether models are only read in this format, not written.
    ///
    /// # Examples
    /// ```
    /// use coface_io::Format;
    /// assert!(Format::Collada.is_read_only() && !Format::Obj.is_read_only());
    /// ```
    pub const fn is_read_only(self) -> bool {
        matches!(
            self,
            Self::Gltf
                | Self::Collada
                | Self::Abaqus
                | Self::TetGen
                | Self::Points
                | Self::CityJson
                | Self::MatrixMarket
                | Self::Nrrd
                | Self::Nifti
                | Self::MetaImage
                | Self::Pgm
                | Self::Png
        )
    }

    /// The format to which the extension of a path belongs.
    ///
    /// # Examples
    /// ```
    /// use coface_io::Format;
    /// assert_eq!(Format::from_path("part.STL".as_ref()), Some(Format::Stl));
    /// assert_eq!(Format::from_path("part".as_ref()), None);
    /// ```
    pub fn from_path(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        if extension == "gz" {
            // `.nii.gz`, and pairs of `.hdr.gz` and `.img.gz`.
            return Self::from_input_path(path).filter(|&format| format == Self::Nifti);
        }
        Self::of_extension(&extension)
    }

    /// The format to which the extension of a path that is read belongs: where the file is compressed, the extension
    /// before `.gz`, `.zst`, `.bz2` or `.xz`.
    ///
    /// # Examples
    /// ```
    /// use coface_io::Format;
    /// assert_eq!(Format::from_input_path("part.stl.gz".as_ref()), Some(Format::Stl));
    /// assert_eq!(Format::from_path("part.stl.gz".as_ref()), None);
    /// ```
    pub fn from_input_path(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        if Packing::of_extension(&extension) {
            let inner = Path::new(path.file_stem()?).extension()?.to_str()?.to_ascii_lowercase();
            return Self::of_extension(&inner);
        }
        if extension == "svgz" {
            return Some(Self::Svg);
        }
        Self::of_extension(&extension)
    }

    fn of_extension(extension: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.extensions().contains(&extension))
    }
}

/// The names of all formats, for an error message.
pub(super) fn names() -> String {
    Format::ALL.map(Format::name).join(", ")
}

/// The names of the formats that are written, for an error message.
pub(super) fn names_of_written() -> String {
    let written = Format::ALL.into_iter().filter(|format| !format.is_read_only());
    written.map(Format::name).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_extensions_are_distinct() {
        let mut all: Vec<&str> = Format::ALL.into_iter().flat_map(Format::extensions).copied().collect();
        for format in Format::ALL {
            assert_eq!(Format::from_name(format.name()).unwrap(), format);
            assert_eq!(Format::from_path(format!("a.b.{}", format.name()).as_ref()), Some(format));
        }
        let count = all.len();
        all.sort_unstable();
        all.dedup();
        assert_eq!(all.len(), count);
        assert!(Format::from_name("docx").unwrap_err().to_string().contains(
            "off, obj, ply, stl, mesh, msh, vtk, vtu, vtp, json, isosig, lines, geojson, wkt, wkb, hex, svg, dat, cfc"
        ));
    }
}
