//! Nodes and elements of version 2: each element carries its tags, the first of which is its physical group.

use super::reader::Reader;
use crate::values::NumberType;
use coface_algebra::Error;
use std::io::Read;

pub(super) fn read_nodes<R: Read>(reader: &mut Reader<R>) -> Result<(), Error> {
    let count = reader.values.scanner.expect_u64("the count of nodes")?;
    reader.values.end_line()?;
    for _ in 0..count {
        let tag = reader.values.integer(NumberType::Int32, "the number of a node")?;
        reader.nodes.add(tag).map_err(|fault| reader.values.located(fault))?;
        let mut point = [0.0; 3];
        for coordinate in &mut point {
            *coordinate = reader.values.coordinate(NumberType::Float64, "a coordinate")?;
        }
        let line = reader.values.line();
        reader.assembly.add_vertex_on_line(&point, line).map_err(|fault| reader.values.located(fault))?;
    }
    Ok(())
}

/// In a binary file elements of one type stand together behind a header; in a text each has its own.
pub(super) fn read_elements<R: Read>(reader: &mut Reader<R>) -> Result<(), Error> {
    const INT: NumberType = NumberType::Int32;
    let count = reader.values.scanner.expect_u64("the count of elements")?;
    reader.values.end_line()?;
    let mut left = count;
    while left > 0 {
        let is_ascii = reader.values.is_ascii();
        let mut tag = 0;
        if is_ascii {
            tag = reader.values.integer(INT, "the number of an element")?;
        }
        let number = reader.values.integer(INT, "the type of an element")?;
        let element = reader.element_type(number)?;
        let together = if is_ascii { 1 } else { reader.values.count(INT, "the count of a block")? };
        if together == 0 || together > left {
            return Err(reader
                .values
                .error(format!("a block has {together} elements, but {left} are left"))
                .with_cure("the file is damaged: write it again"));
        }
        let tag_count = reader.values.count(INT, "the count of tags")?;
        for _ in 0..together {
            if !is_ascii {
                tag = reader.values.integer(INT, "the number of an element")?;
            }
            let mut physical = 0;
            for i in 0..tag_count {
                let entity = reader.values.integer(INT, "a tag of an element")?;
                if i == 0 {
                    physical = entity.saturating_abs();
                }
            }
            let groups = [physical];
            reader.read_element(element, tag, INT, if physical == 0 { &[] } else { &groups })?;
        }
        left -= together;
    }
    Ok(())
}

/// Elements of version 1: number, type, physical group, entity, the number of nodes, and these.
pub(super) fn read_elements_of_version_1<R: Read>(reader: &mut Reader<R>) -> Result<(), Error> {
    const INT: NumberType = NumberType::Int32;
    let count = reader.values.scanner.expect_u64("the count of elements")?;
    reader.values.end_line()?;
    for _ in 0..count {
        let tag = reader.values.integer(INT, "the number of an element")?;
        let number = reader.values.integer(INT, "the type of an element")?;
        let element = reader.element_type(number)?;
        let physical = reader.values.integer(INT, "the physical group of an element")?.saturating_abs();
        reader.values.integer(INT, "the entity of an element")?;
        let nodes = reader.values.integer(INT, "the number of the nodes of an element")?;
        if usize::try_from(nodes) != Ok(element.node_count) {
            let message =
                format!("an element of type {number} has {nodes} nodes, not {}", element.node_count);
            return Err(reader.values.error(message).with_cure("the file is damaged: write it again"));
        }
        reader.read_element(
            element,
            tag,
            INT,
            if physical == 0 { &[] } else { std::slice::from_ref(&physical) },
        )?;
    }
    Ok(())
}
