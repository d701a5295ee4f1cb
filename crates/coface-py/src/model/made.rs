//! Models made of a model: the mesh of a volume, triangles of polygons.

use coface::algebra::RaggedArray;
use coface::answers::polygons_of_fill_rules;
use coface::complexes::cell_mesh::CellShape;
use coface::geometry::Positions;
use coface::geometry::predicates::orientation;
use coface::geometry::triangulation::triangulate;
use coface::io::{CellData, Format, Group, GroupKind, Model, ModelParts, Structure};
use coface::{Error, VertexId};
use std::borrow::Cow;

/// The voxels of a volume as hexahedra, quadrilaterals or segments, or the squares around them: where the header of their file places them, or each
/// voxel as long as `spacing` says, the first corner at `origin`.
///
/// # Errors
/// For a model of another structure, and where the axes are too many or close up.
pub(super) fn mesh_of_volume(
    model: &Model,
    surface: bool,
    spacing: Option<&[f64]>,
    origin: Option<&[f64]>,
) -> Result<Model, Error> {
    let Some(Structure::Volume(volume)) = model.structure() else {
        return Err(
            Error::invalid("only a volume of voxels is made a mesh").with_cure("give a coface.volume(..)")
        );
    };
    let axis_count = volume.shape().len();
    for (name, given) in [("spacing", spacing), ("origin", origin)] {
        if let Some(given) = given.filter(|given| given.len() != axis_count) {
            let message = format!("{name} has {} numbers, and the volume {axis_count} axes", given.len());
            return Err(Error::invalid(message).with_cure("give a number for each axis"));
        }
    }
    if spacing.is_some_and(|spacing| !spacing.iter().all(|&length| length > 0.0)) {
        return Err(Error::invalid("a voxel has no positive length").with_cure("give positive lengths"));
    }
    // What is given takes the place of what the header says.
    let is_given = spacing.is_some() || origin.is_some();
    let (mut positions, polygons, cells, lines) = if !surface {
        match is_given {
            true => voxels(&Model::from_structure(Structure::Volume(volume.clone())))?,
            false => voxels(model)?,
        }
    } else {
        let squares =
            if is_given { volume.boundary_squares()? } else { model.voxel_surface()?.unwrap_or_default() };
        (squares.0, squares.1, RaggedArray::new(), RaggedArray::new())
    };
    if is_given {
        let dimension = positions.dimension();
        let mut flat = positions.as_flat().to_vec();
        for (at, x) in flat.iter_mut().enumerate() {
            let axis = at % dimension;
            *x =
                *x * spacing.map_or(1.0, |spacing| spacing[axis]) + origin.map_or(0.0, |origin| origin[axis]);
        }
        positions = Positions::from_flat(dimension, flat)?;
    }
    let shapes = vec![CellShape::Hexahedron; cells.len()];
    Model::from_parts(positions.len(), positions, polygons, (shapes, cells), lines, Vec::new())
}

/// The model as a format holds it: of a volume the squares around its voxels, where the format has meshes alone; of a drawing with fill
/// rules outer rings and holes, where the format has these alone.
pub(super) fn writable(model: &Model, format: Option<Format>) -> Result<Cow<'_, Model>, Error> {
    match (model.structure(), format) {
        (Some(Structure::Volume(_)), Some(format))
            if !matches!(format, Format::Npy | Format::Json | Format::Container) =>
        {
            let surface = mesh_of_volume(model, true, None, None)?;
            // This format has triangles alone.
            if format == Format::Stl { triangulated(&surface) } else { Ok(surface) }.map(Cow::Owned)
        }
        // These have no rule for what is inside of rings.
        (None, Some(Format::Wkt | Format::Wkb | Format::WkbHex | Format::GeoJson)) => {
            let polygons = polygons_of_fill_rules(model)?;
            Ok(polygons.map_or(Cow::Borrowed(model), |(polygons, _)| Cow::Owned(polygons)))
        }
        _ => Ok(Cow::Borrowed(model)),
    }
}

/// The positions of the corners of voxels, and the voxels as polygons, 3-cells or lines.
fn voxels(model: &Model) -> Result<(Positions, RaggedArray, RaggedArray, RaggedArray), Error> {
    let producer = coface::answers::Producer::of(model.clone())?;
    let positions = producer.positions().clone();
    let Some(dimension @ 1..=3) = (!positions.is_empty()).then(|| positions.dimension()) else {
        return Err(Error::invalid(
            "voxels with more than three axes, or axes that close up, lie not in space",
        )
        .with_cure("leave out periodic, and take up to three axes"));
    };
    // Around the lower face, then around the upper one, as VTK has them; where the header mirrors, the other one first.
    let order = match model.voxel_frame().is_some_and(|frame| frame.is_mirrored()) {
        false => [0, 4, 6, 2, 1, 5, 7, 3],
        true => [1, 5, 7, 3, 0, 4, 6, 2],
    };
    let chains = producer.chain_complex()?;
    let corners = (0..chains.cell_count(dimension)).map(|cell| {
        let list = producer.cell_vertices(dimension, coface::CellId::new(cell));
        match dimension {
            3 => order.map(|at| list[at]).to_vec(),
            _ => list,
        }
    });
    let lists = RaggedArray::from_lists(corners.collect::<Vec<_>>());
    let none = RaggedArray::new;
    Ok(match dimension {
        3 => (positions, none(), lists, none()),
        2 => (positions, lists, none(), none()),
        _ => (positions, none(), none(), lists),
    })
}

/// The model with each polygon cut into triangles on its own corners; groups and data follow.
///
/// # Errors
/// For polygons of four and more corners without positions, and for those that cross themselves seen along their normal.
pub(super) fn triangulated(model: &Model) -> Result<Model, Error> {
    let (mut triangles, mut sources): (Vec<[u32; 3]>, Vec<usize>) = (Vec::new(), Vec::new());
    for (number, polygon) in model.polygons().iter().enumerate() {
        let parts = match *polygon {
            [a, b, c] => vec![[a, b, c]],
            _ => triangles_of(model, number, polygon)?,
        };
        sources.extend(std::iter::repeat_n(number, parts.len()));
        triangles.extend(parts);
    }
    let mut starts = vec![0u32; model.polygons().len() + 1];
    sources.iter().for_each(|&source| starts[source + 1] += 1);
    for at in 1..starts.len() {
        starts[at] += starts[at - 1];
    }
    let data = |data: &CellData| match data.kind() {
        GroupKind::Polygons => data.taken_from(sources.iter().copied()),
        _ => data.clone(),
    };
    let group = |group: &Group| match group.kind() {
        GroupKind::Polygons => {
            let of = |&member: &u32| starts[member as usize]..starts[member as usize + 1];
            group.with_members(group.members().iter().flat_map(of).collect())
        }
        _ => group.clone(),
    };
    Ok(ModelParts {
        polygons: RaggedArray::from_lists(&triangles),
        groups: model.groups().iter().map(group).collect(),
        data: model.data().iter().map(data).collect(),
        ..model.clone().into_parts()
    }
    .into_model()
    .with_features_of(model, &sources)?
    .with_reference_system(model.reference_system().cloned()))
}

fn triangles_of(model: &Model, number: usize, polygon: &[u32]) -> Result<Vec<[u32; 3]>, Error> {
    let positions = model.positions();
    if positions.is_empty() || !(2..=3).contains(&positions.dimension()) {
        return Err(Error::invalid(format!(
            "face {number} has {} corners, and no positions in the plane or in space",
            polygon.len()
        ))
        .with_cure("give vertices to Model.from_arrays, or triangles"));
    }
    let place = |vertex: u32| {
        let point = positions.point(VertexId::new(vertex as usize));
        [point[0], point[1], point.get(2).copied().unwrap_or(0.0)]
    };
    // Seen along the axis that the sum of its normals is nearest to.
    let mut normal = [0.0; 3];
    for (i, &vertex) in polygon.iter().enumerate() {
        let (p, q) = (place(vertex), place(polygon[(i + 1) % polygon.len()]));
        for (axis, sum) in normal.iter_mut().enumerate() {
            let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
            *sum += (p[u] - q[u]) * (p[v] + q[v]);
        }
    }
    let axis = (0..3).max_by(|&a, &b| f64::total_cmp(&normal[a].abs(), &normal[b].abs())).unwrap_or(2);
    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
    let is_turned = normal[axis] < 0.0;
    let flat = |vertex: u32| {
        if is_turned { [place(vertex)[v], place(vertex)[u]] } else { [place(vertex)[u], place(vertex)[v]] }
    };
    let compare = |a: u32, b: u32| {
        let ([ax, ay], [bx, by]) = (flat(a), flat(b));
        ax.total_cmp(&bx).then(ay.total_cmp(&by))
    };
    let turn = |a: u32, b: u32, c: u32| orientation(flat(a), flat(b), flat(c));
    triangulate(&[polygon], compare, turn).map_err(|_| {
        Error::invalid(format!("face {number} crosses itself, seen along its normal"))
            .with_cells([polygon.to_vec()])
            .with_cure("split it, or give triangles")
    })
}
