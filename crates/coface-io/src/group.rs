//! Named sets of vertices, lines, polygons or cells.

use std::fmt;

/// A named set of things of one kind: an OBJ group, a physical group of Gmsh, a reference number of MEDIT.
///
/// Groups are equal if their names, kinds, members and roles are: the number is how one file refers to the group.
#[derive(Clone, Debug)]
pub struct Group {
    pub(crate) name: String,
    pub(crate) kind: GroupKind,
    pub(crate) members: Vec<u32>,
    pub(crate) roles: Roles,
    pub(crate) number: Option<i32>,
}

impl PartialEq for Group {
    fn eq(&self, other: &Self) -> bool {
        let parts = |group: &Self| (group.kind, group.roles);
        parts(self) == parts(other) && self.name == other.name && self.members == other.members
    }
}

impl Eq for Group {}

/// What a file says that a group is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum GroupRole {
    /// A group and no more: `g` of OBJ, a physical group of Gmsh, a reference number of MEDIT.
    Group,
    /// An object: `o` of OBJ, a named mesh of a scene, an object of a city.
    Object,
    /// What has one material: `usemtl` of OBJ.
    Material,
}

/// A set of roles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub(crate) struct Roles(pub(crate) u8);

impl Roles {
    pub(crate) const fn of(role: GroupRole) -> Self {
        Self(1 << role as u8)
    }

    pub(crate) const fn with(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    const fn contains(self, role: GroupRole) -> bool {
        self.0 & (1 << role as u8) != 0
    }
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
        Self { name: name.into(), kind, members, roles: Roles::of(GroupRole::Group), number: None }
    }

    /// The same group with other members: it keeps its name, its kind, its roles and its number.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{Group, GroupKind, GroupRole};
    /// let wall = Group::new("wall", GroupKind::Polygons, vec![0, 3]).with_role(GroupRole::Object);
    /// let split = wall.with_members(vec![0, 1, 5, 6]);
    /// assert!(split.has_role(GroupRole::Object) && split.members().len() == 4);
    /// ```
    #[must_use]
    pub fn with_members(&self, members: Vec<u32>) -> Self {
        Self { name: self.name.clone(), members, ..*self }
    }

    /// The same with the number by which files refer to it: the tag of a physical group of Gmsh.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{Group, GroupKind};
    /// let terminal = Group::new("terminal", GroupKind::Polygons, vec![0, 3]).with_number(70);
    /// assert_eq!(terminal.number(), Some(70));
    /// ```
    pub fn with_number(mut self, number: i32) -> Self {
        self.number = Some(number);
        self
    }

    /// The number by which its file refers to it, if it has one: the tag of a physical group of Gmsh, the reference number of MEDIT.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{Group, GroupKind};
    /// let group = Group::new("lid", GroupKind::Polygons, vec![0, 3]);
    /// assert_eq!(group.number(), None);
    /// ```
    pub fn number(&self) -> Option<i32> {
        self.number
    }

    /// The same as an object, or as what has one material; [`Self::new`] makes a group and no more.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{Group, GroupKind, GroupRole};
    /// let wall = Group::new("wall", GroupKind::Polygons, vec![0, 3]).with_role(GroupRole::Object);
    /// assert!(wall.has_role(GroupRole::Object) && !wall.has_role(GroupRole::Group));
    /// ```
    pub fn with_role(mut self, role: GroupRole) -> Self {
        self.roles = Roles::of(role);
        self
    }

    /// Whether a statement of the file makes it this. It may be several: an object and a group of one name with the
    /// same members are one.
    ///
    /// # Examples
    /// ```
    /// use coface_io::GroupRole;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\no wall\nusemtl brick\nf 1 2 3\n";
    /// let model = coface_io::obj::read(text.as_bytes())?;
    /// assert!(model.groups()[0].has_role(GroupRole::Object));
    /// assert!(model.groups()[1].has_role(GroupRole::Material));
    /// # Ok(()) }
    /// ```
    pub fn has_role(&self, role: GroupRole) -> bool {
        self.roles.contains(role)
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
