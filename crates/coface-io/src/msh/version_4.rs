//! Entities, nodes and elements of version 4: blocks of nodes and of elements lie on entities, which have the physical
//! groups.

use super::reader::{FileVersion, Reader};
use crate::values::NumberType;
use coface_algebra::Error;
use std::io::Read;

const INT: NumberType = NumberType::Int32;
const DOUBLE: NumberType = NumberType::Float64;

/// Of each entity, only its physical groups are kept.
pub(super) fn read_entities<R: Read>(reader: &mut Reader<R>, version: FileVersion) -> Result<(), Error> {
    let size = reader.size;
    let mut counts = [0; 4];
    for count in &mut counts {
        *count = reader.values.count(size, "the count of entities")?;
    }
    for (dimension, count) in counts.into_iter().enumerate() {
        // A point has its position in version 4.1, the others their box.
        let number_count = if dimension == 0 && version == FileVersion::FourOne { 3 } else { 6 };
        for _ in 0..count {
            let tag = reader.values.integer(INT, "the tag of an entity")?;
            reader.values.skip(number_count, DOUBLE, "the box of an entity")?;
            let group_count = reader.values.count(size, "the count of physical groups")?;
            let mut groups = Vec::new();
            for _ in 0..group_count {
                let group = reader.values.integer(INT, "a physical group")?.saturating_abs();
                if group != 0 && !groups.contains(&group) {
                    groups.push(group);
                }
            }
            if dimension > 0 {
                let bounding = reader.values.count(size, "the count of bounding entities")?;
                reader.values.skip(bounding, INT, "a bounding entity")?;
            }
            if !groups.is_empty() {
                reader.physical.insert((dimension, tag), groups);
            }
        }
    }
    Ok(())
}

/// The dimension and tag of the entity of a block; version 4.0 has them the other way round.
fn read_entity<R: Read>(reader: &mut Reader<R>, version: FileVersion) -> Result<(usize, i64), Error> {
    let first = reader.values.integer(INT, "the entity of a block")?;
    let second = reader.values.integer(INT, "the entity of a block")?;
    let (dimension, tag) = if version == FileVersion::FourOne { (first, second) } else { (second, first) };
    match usize::try_from(dimension) {
        Ok(dimension @ 0..=3) => Ok((dimension, tag)),
        _ => Err(reader.values.error(format!("an entity has dimension {dimension}; 0 to 3 are possible"))),
    }
}

/// The number of blocks, behind which there are counts and bounds that the blocks repeat.
fn read_block_count<R: Read>(reader: &mut Reader<R>, version: FileVersion) -> Result<u64, Error> {
    let size = reader.size;
    let count = reader.values.count(size, "the count of blocks")?;
    reader.values.skip(
        if version == FileVersion::FourOne { 3 } else { 1 },
        size,
        "the count of a section",
    )?;
    Ok(count)
}

pub(super) fn read_nodes<R: Read>(reader: &mut Reader<R>, version: FileVersion) -> Result<(), Error> {
    let size = reader.size;
    for _ in 0..read_block_count(reader, version)? {
        let (dimension, _) = read_entity(reader, version)?;
        let is_parametric = reader.values.integer(INT, "whether a block is parametric")? != 0;
        let count = reader.values.count(size, "the count of nodes in a block")?;
        let parameters = if is_parametric { dimension as u64 } else { 0 };
        // In version 4.1 all tags of a block come first.
        if version == FileVersion::FourOne {
            for _ in 0..count {
                let tag = reader.values.integer(size, "the tag of a node")?;
                reader.nodes.add(tag).map_err(|fault| reader.values.located(fault))?;
            }
        }
        for _ in 0..count {
            if version == FileVersion::FourZero {
                let tag = reader.values.integer(INT, "the tag of a node")?;
                reader.nodes.add(tag).map_err(|fault| reader.values.located(fault))?;
            }
            let mut point = [0.0; 3];
            for coordinate in &mut point {
                *coordinate = reader.values.coordinate(DOUBLE, "a coordinate")?;
            }
            let line = reader.values.line();
            reader.assembly.add_vertex_on_line(&point, line).map_err(|fault| reader.values.located(fault))?;
            reader.values.skip(parameters, DOUBLE, "a parameter")?;
        }
    }
    Ok(())
}

pub(super) fn read_elements<R: Read>(reader: &mut Reader<R>, version: FileVersion) -> Result<(), Error> {
    let size = reader.size;
    let tag_type = if version == FileVersion::FourOne { size } else { INT };
    for _ in 0..read_block_count(reader, version)? {
        let entity = read_entity(reader, version)?;
        let number = reader.values.integer(INT, "the type of a block")?;
        let element = reader.element_type(number)?;
        let count = reader.values.count(size, "the count of elements in a block")?;
        let groups = reader.physical.get(&entity).cloned().unwrap_or_default();
        for _ in 0..count {
            let tag = reader.values.integer(tag_type, "the tag of an element")?;
            reader.read_element(element, tag, tag_type, &groups)?;
        }
    }
    Ok(())
}
