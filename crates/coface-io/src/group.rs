//! Named sets of vertices, lines, polygons or cells.

use std::fmt;

/// A named set of things of one kind: an OBJ group, a physical group of Gmsh, a reference number of MEDIT.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    pub(crate) name: String,
    pub(crate) kind: GroupKind,
    pub(crate) members: Vec<u32>,
}

/// What the members of a [`Group`] are, and what [`CellData`](crate::CellData) are on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum GroupKind {
    /// Vertices.
    Vertices,
    /// Lines.
    Lines,
    /// Polygons.
    Polygons,
    /// 3-cells.
    Cells,
}

impl fmt::Display for GroupKind {
    /// The plural: `vertices`, `lines`, `polygons`, `cells`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Vertices => "vertices",
            Self::Lines => "lines",
            Self::Polygons => "polygons",
            Self::Cells => "cells",
        })
    }
}

impl Group {
    /// A group with these members.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{Group, GroupKind};
    /// let group = Group::new("lid", GroupKind::Polygons, vec![0, 3]);
    /// assert_eq!(group.members().len(), 2);
    /// ```
    pub fn new(name: impl Into<String>, kind: GroupKind, members: Vec<u32>) -> Self {
        Self { name: name.into(), kind, members }
    }

    /// The name, or the number, that the file gives it.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{Group, GroupKind};
    /// let group = Group::new("lid", GroupKind::Polygons, vec![0, 3]);
    /// assert_eq!(group.name(), "lid");
    /// ```
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What the members are.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{Group, GroupKind};
    /// let group = Group::new("lid", GroupKind::Polygons, vec![0, 3]);
    /// assert_eq!(group.kind().to_string(), "polygons");
    /// ```
    pub fn kind(&self) -> GroupKind {
        self.kind
    }

    /// The positions of the members among the vertices, lines, polygons or cells of the model.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{Group, GroupKind};
    /// let group = Group::new("lid", GroupKind::Polygons, vec![0, 3]);
    /// assert_eq!(group.members(), [0, 3]);
    /// ```
    pub fn members(&self) -> &[u32] {
        &self.members
    }
}
