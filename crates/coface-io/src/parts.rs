//! One part of a mesh: the polygons of a group.

use crate::{Format, GroupKind, Model};
use coface_algebra::{Error, RaggedArray};
use coface_geometry::Positions;

/// The polygons of the group of this name, or at this place among the groups of polygons from 1, with their vertices.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] naming the groups that there are.
pub(crate) fn part(model: Model, entry: &str) -> Result<Model, Error> {
    let groups: Vec<_> = model.groups().iter().filter(|group| group.kind() == GroupKind::Polygons).collect();
    let place = entry.parse::<usize>().ok().and_then(|place| place.checked_sub(1));
    let found =
        groups.iter().find(|group| group.name() == entry).or(place.and_then(|place| groups.get(place)));
    let Some(group) = found else {
        let names: Vec<String> = groups
            .iter()
            .take(20)
            .map(|group| group.name().chars().take(60).flat_map(char::escape_debug).collect())
            .collect();
        return Err(Error::invalid(format!("there is no part {}", entry.escape_debug())).with_cure(
            if names.is_empty() {
                "leave the part out: the file has no groups of polygons".to_owned()
            } else {
                format!("choose one of: {}", names.join(", "))
            },
        ));
    };
    let mut new = vec![u32::MAX; model.vertex_count()];
    let (mut vertices, mut polygons) = (Vec::new(), RaggedArray::new());
    for &polygon in group.members() {
        let corners: Vec<u32> = model
            .polygons()
            .list(polygon as usize)
            .iter()
            .map(|&vertex| {
                let place = &mut new[vertex as usize];
                if *place == u32::MAX {
                    *place = vertices.len() as u32;
                    vertices.push(vertex);
                }
                *place
            })
            .collect();
        polygons.push(&corners);
    }
    let (dimension, flat) = (model.positions().dimension(), model.positions().as_flat());
    let coordinates = vertices.iter().flat_map(|&vertex| {
        let start = vertex as usize * dimension;
        flat[start..start + dimension].iter().copied()
    });
    let positions = Positions::from_flat(dimension, coordinates.collect())?;
    let part = Model { vertex_count: vertices.len(), positions, polygons, ..Model::default() };
    part.check()?;
    let format = model.format().unwrap_or(Format::Obj);
    Ok(Model { remarks: model.remarks, ..part }.with_format(format))
}
