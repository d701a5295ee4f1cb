//! The groups of a surface in OBJ: as much of them as proves what a part is.

use coface_check::Surface;
use std::collections::BTreeSet;

/// The polygons of the groups that a name says, where `g` alone gives the names; `None` where the file does not settle which these are.
///
/// A name is that of a group, or several with commas between.
pub(crate) fn of_name(input: &[u8], name: &str) -> Option<Vec<Vec<u32>>> {
    let text = std::str::from_utf8(input).ok()?;
    let surface = Surface::read(input).ok()?;
    // The names behind each `g`, and at which polygon they begin.
    let mut names: Vec<(usize, Vec<&str>)> = Vec::new();
    let mut others: BTreeSet<&str> = BTreeSet::new();
    let mut polygons = 0;
    for line in text.lines() {
        let line = line.split('#').next().unwrap_or_default().trim();
        let (key, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
        match key {
            "f" => polygons += 1,
            "g" => names.push((polygons, rest.split_whitespace().collect())),
            "o" | "usemtl" => drop(others.insert(rest.trim())),
            // Lines may be in groups too.
            "l" => return None,
            _ => (),
        }
    }
    if polygons != surface.polygons.len() {
        return None;
    }
    let is_group = |word: &str| names.iter().any(|(_, names)| names.contains(&word));
    let words = if is_group(name) { vec![name] } else { name.split(',').map(str::trim).collect() };
    if words.iter().any(|word| !is_group(word) || others.contains(word)) {
        return None;
    }
    let end = |place: usize| names.get(place + 1).map_or(polygons, |next| next.0);
    let own =
        names.iter().enumerate().filter(|(_, (_, names))| words.iter().any(|word| names.contains(word)));
    let own = own.flat_map(|(place, &(start, _))| &surface.polygons[start..end(place)]);
    Some(own.cloned().collect())
}
