//! Names for sets of polygons, lines and points while a file is read.

use crate::group::Roles;
use crate::{Group, GroupKind, GroupRole};
use coface_algebra::{Error, ErrorKind, VertexId};
use std::collections::BTreeMap;

/// The most names that one `g` may give: each polygon is a member of all of them.
pub(super) const MOST_NAMES: usize = 64;

/// The statement that gives a name to what follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Statement {
    Group,
    Object,
    Material,
}

impl Statement {
    pub(super) const fn keyword(self) -> &'static str {
        match self {
            Self::Group => "g",
            Self::Object => "o",
            Self::Material => "usemtl",
        }
    }

    pub(super) const fn role(self) -> GroupRole {
        match self {
            Self::Group => GroupRole::Group,
            Self::Object => GroupRole::Object,
            Self::Material => GroupRole::Material,
        }
    }
}

/// A change of names in front of an element.
#[derive(Debug)]
pub(super) struct Change {
    pub(super) statement: Statement,
    pub(super) names: Vec<String>,
}

impl Change {
    /// What the rest of a statement says: any number of names behind `g`, one name with its blanks otherwise.
    pub(super) fn new(statement: Statement, rest: &[u8]) -> Result<Self, Error> {
        let rest = String::from_utf8_lossy(rest);
        let names: Vec<String> = match statement {
            Statement::Group => rest.split_whitespace().map(str::to_owned).collect(),
            _ => Some(rest.trim().to_owned()).filter(|name| !name.is_empty()).into_iter().collect(),
        };
        if names.len() > MOST_NAMES {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("{} groups in one statement; the limit is {MOST_NAMES}", names.len()),
            )
            .with_cure("give the polygons fewer names"));
        }
        Ok(Self { statement, names })
    }
}

/// The numbers of polygons, lines and points.
pub(super) type Counts = [u32; 3];

/// The groups so far and those that the next element belongs to.
#[derive(Debug, Default)]
pub(super) struct Groups {
    known: BTreeMap<(Statement, String), usize>,
    /// The polygons, the lines and the points of each.
    members: Vec<[Vec<u32>; 3]>,
    active: Vec<(Statement, usize)>,
    /// What stands before these has been given to its groups.
    settled: Counts,
}

impl Groups {
    /// The names change behind so many elements.
    pub(super) fn change(&mut self, change: Change, before: Counts) {
        self.settle(before);
        self.active.retain(|&(statement, _)| statement != change.statement);
        for name in change.names {
            let next = self.members.len();
            let group = *self.known.entry((change.statement, name)).or_insert(next);
            if group == next {
                self.members.push(Default::default());
            }
            if !self.active.contains(&(change.statement, group)) {
                self.active.push((change.statement, group));
            }
        }
    }

    fn settle(&mut self, before: Counts) {
        for &(_, group) in &self.active {
            for (kind, members) in self.members[group].iter_mut().enumerate() {
                members.extend(self.settled[kind]..before[kind]);
            }
        }
        self.settled = before;
    }

    /// The groups of polygons, then those of lines, then those of the vertices that are points, each in the order of their first statements; what
    /// has no member is a group of polygons. Where two statements give one name, the same members are one
    /// group, and other members have the keyword put in front of the name.
    pub(super) fn finish(mut self, counts: Counts, points: &[VertexId]) -> Vec<Group> {
        self.settle(counts);
        let mut keys: Vec<((Statement, String), usize)> = self.known.into_iter().collect();
        keys.sort_unstable_by_key(|&(_, group)| group);
        let mut groups: Vec<Group> = Vec::with_capacity(keys.len());
        for (place, kind) in
            [GroupKind::Polygons, GroupKind::Lines, GroupKind::Vertices].into_iter().enumerate()
        {
            let mut first_of_name: BTreeMap<&str, usize> = BTreeMap::new();
            for ((statement, name), index) in &keys {
                let all = &mut self.members[*index];
                if all[place].is_empty() && (place > 0 || all.iter().any(|members| !members.is_empty())) {
                    continue;
                }
                let mut members = std::mem::take(&mut all[place]);
                if kind == GroupKind::Vertices {
                    members.iter_mut().for_each(|point| *point = points[*point as usize].to_u32());
                    members.sort_unstable();
                    members.dedup();
                }
                match first_of_name.get(&name[..]) {
                    Some(&first) if groups[first].members == members => {
                        groups[first].roles = groups[first].roles.with(Roles::of(statement.role()));
                    }
                    Some(_) => {
                        let qualified = format!("{}:{name}", statement.keyword());
                        groups.push(Group::new(qualified, kind, members).with_role(statement.role()));
                    }
                    None => {
                        first_of_name.insert(name, groups.len());
                        groups.push(Group::new(name.clone(), kind, members).with_role(statement.role()));
                    }
                }
            }
        }
        groups
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_hold_until_the_same_statement_comes_again() {
        let mut groups = Groups::default();
        let change = |statement, rest: &[u8]| Change::new(statement, rest).unwrap();
        groups.change(change(Statement::Object, b" car \n"), [0, 0, 0]);
        groups.change(change(Statement::Group, b"left front"), [1, 0, 0]);
        groups.change(change(Statement::Material, b"front"), [2, 1, 0]);
        groups.change(change(Statement::Group, b""), [3, 1, 1]);
        let groups = groups.finish([4, 2, 2], &[VertexId::new(8), VertexId::new(5)]);
        let found: Vec<(&str, &[u32])> = groups.iter().map(|g| (g.name(), g.members())).collect();
        assert_eq!(
            found,
            [
                ("car", &[0, 1, 2, 3][..]),
                ("left", &[1, 2]),
                ("front", &[1, 2]),
                ("usemtl:front", &[2, 3]),
                ("car", &[0, 1]),
                ("left", &[0]),
                ("front", &[0]),
                ("usemtl:front", &[1]),
                ("car", &[5, 8]),
                ("left", &[8]),
                ("front", &[8]),
                ("usemtl:front", &[5, 8])
            ]
        );
    }

    #[test]
    fn too_many_names_are_refused() {
        assert!(Change::new(Statement::Group, "a ".repeat(65).as_bytes()).is_err());
        assert!(Change::new(Statement::Object, "a ".repeat(65).as_bytes()).is_ok());
    }
}
