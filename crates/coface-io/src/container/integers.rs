//! Integers of any size in sections.

use super::{Container, ContainerWriter, Role};
use coface_algebra::Error;
use coface_algebra::Integer;

/// Appends integers: in a section of one byte each if all fit, else of eight, where the lowest value means the next of the wide ones.
pub fn push_integers<'i>(
    writer: &mut ContainerWriter<'_>,
    (role, wide): (Role, Role),
    index: usize,
    integers: impl Iterator<Item = &'i Integer> + Clone,
) {
    let mut short = Vec::new();
    for x in integers.clone() {
        match x.to_i64().and_then(|x| i8::try_from(x).ok()) {
            Some(x) if x != i8::MIN => short.push(x),
            _ => {
                short.clear();
                break;
            }
        }
    }
    if !short.is_empty() || integers.clone().next().is_none() {
        return writer.push_owned(role, index, &short);
    }
    let mut bytes = Vec::new();
    let long: Vec<i64> = integers
        .map(|x| {
            x.to_i64().filter(|&x| x != i64::MIN).unwrap_or_else(|| {
                let digits = x.to_le_bytes();
                bytes.extend((digits.len() as u32).to_le_bytes());
                bytes.extend(digits);
                i64::MIN
            })
        })
        .collect();
    writer.push_owned(role, index, &long);
    writer.push_owned(wide, index, &bytes);
}

/// The integers of a section.
///
/// # Errors
/// [`coface_algebra::ErrorKind::Parse`] where there are none, or wide ones are missing or not needed.
pub fn integers(
    container: &Container<'_>,
    (role, wide): (Role, Role),
    index: usize,
) -> Result<Vec<Integer>, Error> {
    if container.width(role, index)? == 1 {
        return Ok(container
            .array::<i8>(role, index)?
            .iter()
            .map(|&x| Integer::from(i64::from(x)))
            .collect());
    }
    let long = container.array::<i64>(role, index)?;
    let bytes = container.array::<u8>(wide, index)?;
    let mut rest = &bytes[..];
    let mut next = || {
        let (length, after) = rest.split_first_chunk::<4>()?;
        let (digits, after) = after.split_at_checked(u32::from_le_bytes(*length) as usize)?;
        rest = after;
        let value = Integer::from_le_bytes(digits);
        value.to_i64().is_none_or(|x| x == i64::MIN).then_some(value)
    };
    let values: Option<Vec<Integer>> =
        long.iter().map(|&x| if x == i64::MIN { next() } else { Some(Integer::from(x)) }).collect();
    values
        .filter(|_| rest.is_empty())
        .ok_or_else(|| container.lie(wide, index, "the wide numbers are not those that are called for"))
}
