//! Oddities of ordinary files, counted while a file is read and said in one remark each at its end.

use crate::{Place, Remark, RemarkCode};
use std::collections::HashSet;

/// What a reader meets and reads on from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Oddity {
    /// A cell repeats a vertex; the repetition is dropped.
    Repeated,
    /// A cell has too few different vertices and is left out.
    Collapsed,
    /// A face has two different vertices and is kept as an edge.
    FaceIsEdge,
    /// A 3-cell repeats a vertex and is a cell of another shape.
    CellIsSimpler,
    /// A label is written as a fraction.
    Fraction,
    /// A vertex has a coordinate that is not finite.
    Unplaced,
    /// A line has more words than its record.
    MoreWords,
    /// A line is no statement of the format.
    NoStatement,
    /// A line is of geometry that is not read.
    FreeForm,
}

impl Oddity {
    fn code(self) -> RemarkCode {
        match self {
            Self::Repeated => RemarkCode::RepeatedVertex,
            Self::Collapsed | Self::FaceIsEdge | Self::CellIsSimpler => RemarkCode::CollapsedCell,
            Self::Fraction => RemarkCode::FractionalLabel,
            Self::Unplaced => RemarkCode::NonfiniteCoordinate,
            Self::MoreWords => RemarkCode::TrailingContent,
            Self::NoStatement | Self::FreeForm => RemarkCode::UnknownSection,
        }
    }

    fn message(self, count: usize) -> String {
        let [s, repeats, has, is, its] = if count == 1 {
            ["", "repeats", "has", "is", "its"]
        } else {
            ["s", "repeat", "have", "are", "their"]
        };
        match self {
            Self::Repeated => format!("{count} cell{s} {repeats} a vertex; the repetition is dropped"),
            Self::Collapsed => format!("{count} cell{s} {has} too few different vertices and {is} left out"),
            Self::FaceIsEdge => {
                format!(
                    "{count} face{s} {has} two different vertices and {is} kept as {}",
                    if count == 1 { "an edge" } else { "edges" }
                )
            }
            Self::CellIsSimpler => {
                format!("{count} cell{s} {repeats} a vertex and {is} read by {its} different vertices")
            }
            Self::Fraction => {
                format!(
                    "{count} reference{s} {is} written as a fraction, such as 0.0, and {is} taken as a whole number"
                )
            }
            Self::MoreWords => {
                format!("{count} line{s} {has} more words than belong there, which are left out")
            }
            Self::NoStatement => {
                format!("{count} line{s} {is} no statement{s} of the format and {is} passed over")
            }
            Self::FreeForm => {
                format!("{count} line{s} {is} of free-form geometry or of other files, and {is} passed over")
            }
            Self::Unplaced => {
                let (what, has, position) = match count {
                    1 => ("1 vertex".to_owned(), "has", "its position"),
                    _ => (format!("{count} vertices"), "have", "their positions"),
                };
                format!(
                    "{what} {has} a coordinate that is not finite (NaN, infinite or beyond the range of numbers); \
                     measures that need {position} are left out"
                )
            }
        }
    }
}

/// So many places of each oddity are kept, to tell those of a part of the file.
const KEPT_PLACES: usize = 1 << 10;

/// The oddities of a file so far, with the first places of each.
#[derive(Clone, Debug, Default)]
pub(crate) struct Oddities {
    found: Vec<(Oddity, usize, Vec<Place>)>,
}

impl Oddities {
    /// Notes one more; the place is made only where it is listed.
    pub(crate) fn note(&mut self, oddity: Oddity, place: impl FnOnce() -> Place) {
        let (count, places) = self.of(oddity);
        *count += 1;
        if places.len() < KEPT_PLACES {
            places.push(place());
        }
    }

    /// Notes those of the next piece of the file.
    pub(crate) fn append(&mut self, other: Self) {
        for (oddity, more, new) in other.found {
            let (count, places) = self.of(oddity);
            *count += more;
            places.extend(new);
            places.truncate(KEPT_PLACES);
        }
    }

    fn of(&mut self, oddity: Oddity) -> (&mut usize, &mut Vec<Place>) {
        let at = self.found.iter().position(|&(known, ..)| known == oddity).unwrap_or_else(|| {
            self.found.push((oddity, 0, Vec::new()));
            self.found.len() - 1
        });
        let (_, count, places) = &mut self.found[at];
        (count, places)
    }

    /// One remark for each oddity.
    pub(crate) fn into_remarks(self) -> Vec<Remark> {
        self.remarks()
    }

    /// The same, of oddities that are kept.
    pub(crate) fn remarks(&self) -> Vec<Remark> {
        let mut found: Vec<&(Oddity, usize, Vec<Place>)> = self.found.iter().collect();
        found.sort_by_key(|own| own.0);
        let remark = |&(oddity, count, ref places): &(Oddity, usize, Vec<Place>)| {
            let mut message = oddity.message(count);
            match places.first() {
                Some(Place { line: Some(line), .. }) => message += &format!("; the first is on line {line}"),
                Some(Place { cell: Some(cell), .. }) if oddity == Oddity::Unplaced => {
                    message += &format!("; the first is v{}", cell[0]);
                }
                _ => {}
            }
            Remark::new(oddity.code(), message).at(count, places.iter().cloned())
        };
        found.into_iter().map(remark).collect()
    }

    /// Those of a part of the file: of cells whose vertices are all in it, by their new numbers; `number` has none for others. An
    /// oddity of which not all places are kept, or of no cells, stays as it is.
    pub(crate) fn of_part(&self, number: impl Fn(u32) -> Option<u32>) -> Self {
        let mut part = Self::default();
        for (oddity, count, places) in &self.found {
            let cells = places.iter().filter(|place| place.cell.is_some()).count();
            if places.len() < *count || cells < *count {
                part.found.push((*oddity, *count, places.clone()));
                continue;
            }
            let own = places.iter().filter_map(|place| {
                let cell =
                    place.cell.iter().flatten().map(|&vertex| number(vertex)).collect::<Option<_>>()?;
                Some(Place { cell: Some(cell), ..place.clone() })
            });
            let own: Vec<Place> = own.collect();
            if !own.is_empty() {
                part.found.push((*oddity, own.len(), own));
            }
        }
        part
    }
}

impl Oddities {
    /// Notes the vertex with this number if one of its coordinates is not finite.
    pub(crate) fn note_unplaced(&mut self, coordinates: &[f64], vertex: u64, line: Option<u64>) {
        if !coordinates.iter().all(|x| x.is_finite()) {
            // Readers refuse more vertices than have numbers.
            let place = Place::cell(&[u32::try_from(vertex).unwrap_or(u32::MAX)]);
            self.note(Oddity::Unplaced, || Place { line, ..place });
        }
    }
}

/// The vertices of a cell without those that stood before.
pub(crate) fn without_repetition(vertices: &[u32]) -> Vec<u32> {
    if vertices.len() <= 16 {
        let first = |&(i, vertex): &(usize, &u32)| !vertices[..i].contains(vertex);
        return vertices.iter().enumerate().filter(first).map(|(_, &vertex)| vertex).collect();
    }
    let mut seen = HashSet::with_capacity(vertices.len());
    vertices.iter().copied().filter(|&vertex| seen.insert(vertex)).collect()
}

/// The vertices of a path without those that are where the path is already.
pub(crate) fn without_standing_still(path: &[u32]) -> Vec<u32> {
    let mut moving = path.to_vec();
    moving.dedup();
    moving
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::remark::LISTED_PLACES;

    #[test]
    fn oddities_of_pieces_are_counted_together() {
        let mut whole = Oddities::default();
        for piece in 0..3u32 {
            let mut part = Oddities::default();
            for i in 0..3 {
                part.note(Oddity::Collapsed, || Place::cell(&[3 * piece + i]).on_line(u64::from(i)));
            }
            whole.append(part);
        }
        whole.note(Oddity::Repeated, || Place::cell(&[7, 7]));
        let remarks = whole.into_remarks();
        assert_eq!(remarks[0].message, "1 cell repeats a vertex; the repetition is dropped");
        assert_eq!(
            remarks[1].message,
            "9 cells have too few different vertices and are left out; the first is on line 0"
        );
        assert_eq!((remarks[1].count, remarks[1].places.len()), (9, LISTED_PLACES));
        assert_eq!(remarks[1].places[4].cell, Some(vec![4]));
    }

    #[test]
    fn long_and_short_lists_lose_their_repetitions() {
        assert_eq!(without_repetition(&[4, 2, 4, 4, 3]), [4, 2, 3]);
        let long: Vec<u32> = (0..40).chain([17, 3, 40]).collect();
        assert_eq!(without_repetition(&long), (0..41).collect::<Vec<_>>());
        assert_eq!(without_standing_still(&[1, 1, 2, 1, 1]), [1, 2, 1]);
    }
}
