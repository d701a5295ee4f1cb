//! Groups of a mesh: the cells of those that the user names, and chains as more groups.

use super::{Cells, Producer, Term};
use coface_algebra::chains::Chain;
use coface_algebra::{CellId, Error, FaceId, Integer};
use coface_complexes::cell_mesh::CellShape;
use coface_io::{CellData, Group, GroupKind, Model, ModelParts, msh};

/// The groups of a model with these names or numbers, of any kind: all groups with the name; if there is none, all with the number; if
/// there is none, those of the parts between commas.
///
/// # Errors
/// [`InvalidInput`](coface_algebra::ErrorKind::InvalidInput) naming a word that is no group, with the groups that there are.
///
/// # Examples
/// ```
/// use coface_io::{Format, Group, GroupKind};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let square = coface_io::read(&b"OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"[..], Format::Off)?;
/// let square = square.with_group(Group::new("lid", GroupKind::Polygons, vec![1]).with_number(7))?;
/// for words in [["lid"], ["7"]] {
///     let found = coface_answers::named_groups(&square, &words.map(str::to_owned))?;
///     assert_eq!(found[0].members(), [1]);
/// }
/// let error = coface_answers::named_groups(&square, &["rim".to_owned()]).unwrap_err();
/// assert_eq!(error.message(), "the model has no group \"rim\": it has \"lid\" (7, polygons)");
/// # Ok(()) }
/// ```
pub fn named_groups<'m>(model: &'m Model, words: &[String]) -> Result<Vec<&'m Group>, Error> {
    let mut found: Vec<&Group> = Vec::new();
    for word in words {
        let mut groups = groups_of_word(model, word);
        if groups.is_empty() && word.contains(',') {
            for part in word.split(',').map(str::trim) {
                let of_part = groups_of_word(model, part);
                if of_part.is_empty() {
                    return Err(no_group(model, part));
                }
                groups.extend(of_part);
            }
        }
        if groups.is_empty() {
            return Err(no_group(model, word));
        }
        for group in groups {
            if !found.iter().any(|known| std::ptr::eq(*known, group)) {
                found.push(group);
            }
        }
    }
    Ok(found)
}

fn groups_of_word<'m>(model: &'m Model, word: &str) -> Vec<&'m Group> {
    let named: Vec<&Group> = model.groups().iter().filter(|group| group.name() == word).collect();
    match word.parse::<i32>() {
        Ok(number) if named.is_empty() => {
            model.groups().iter().filter(|group| group.number() == Some(number)).collect()
        }
        _ => named,
    }
}

fn no_group(model: &Model, word: &str) -> Error {
    const SHOWN: usize = 24;
    let groups = model.groups();
    if groups.is_empty() {
        return Error::invalid(format!("the model has no group {word:?}: it has no groups"))
            .with_cure("give a mesh with physical groups, as Gmsh writes them");
    }
    let shown = groups.iter().take(SHOWN).map(|group| {
        let number = group.number().map_or(String::new(), |number| format!("{number}, "));
        format!("{:?} ({number}{})", group.name(), group.kind())
    });
    let more =
        if groups.len() > SHOWN { format!(" and {} more", groups.len() - SHOWN) } else { String::new() };
    let shown: Vec<String> = shown.collect();
    Error::invalid(format!("the model has no group {word:?}: it has {}{more}", shown.join(", ")))
        .with_cure("give the name or the number of a group")
}

/// The chain that the first group of this name is: its degree, and each element with coefficient 1 in the order of its vertices; a cell that
/// stands several times, or against its orientation, counts as often, or negatively. `None` if there is no such group.
///
/// # Examples
/// ```
/// use coface_io::{Format, Group, GroupKind};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let edge = coface_io::read(&b"v 0 0 0\nv 1 0 0\nl 1 2\nl 2 1\nl 2 1\n"[..], Format::Obj)?;
/// let edge = edge.with_group(Group::new("H_1{0}1", GroupKind::Lines, vec![1, 2]))?;
/// let (degree, terms) = coface_answers::group_chain(&edge, "H_1{0}1").unwrap_or_default();
/// assert_eq!((degree, terms.len(), &terms[0].1[..]), (1, 2, &[1, 0][..]));
/// # Ok(()) }
/// ```
pub fn group_chain(model: &Model, name: &str) -> Option<(usize, Vec<Term>)> {
    let group = model.groups().iter().find(|group| group.name() == name)?;
    let members = group.members().iter();
    let (degree, lists) = match group.kind() {
        GroupKind::Vertices => {
            return Some((0, members.map(|&vertex| (Integer::ONE, vec![vertex])).collect()));
        }
        GroupKind::Lines => {
            let edges = members.flat_map(|&line| model.lines().list(line as usize).windows(2));
            return Some((1, edges.map(|edge| (Integer::ONE, edge.to_vec())).collect()));
        }
        GroupKind::Polygons => (2, model.polygons()),
        GroupKind::Cells => (3, model.cells()),
    };
    Some((degree, members.map(|&i| (Integer::ONE, lists.list(i as usize).to_vec())).collect()))
}

/// Chains are written so that a cell stands as often as its coefficient says, at most so often.
const MOST_TIMES: u64 = 1000;

impl Producer {
    /// The cells that the members of groups are, as (degree, cell). The model is the one that the producer was made of.
    ///
    /// # Errors
    /// [`InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if the model is no mesh.
    ///
    /// # Complexity
    /// Linear in the mesh.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::Producer;
    /// use coface_io::{Format, Group, GroupKind};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = coface_io::read(&b"OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"[..], Format::Off)?;
    /// let square = square.with_group(Group::new("lid", GroupKind::Polygons, vec![1]))?;
    /// let producer = Producer::of(square.clone())?;
    /// let groups: Vec<_> = square.groups().iter().collect();
    /// assert_eq!(producer.cells_of_groups(&square, &groups)?, [(2, coface_algebra::CellId::new(1))]);
    /// # Ok(()) }
    /// ```
    pub fn cells_of_groups(&self, model: &Model, groups: &[&Group]) -> Result<Vec<(usize, CellId)>, Error> {
        let places = Members::of(self, model)?;
        let members = groups.iter().flat_map(|group| group.members().iter().map(|&i| (group.kind(), i)));
        let mut cells = Vec::new();
        for (kind, member) in members {
            places.push_cells(kind, member as usize, &mut cells);
        }
        Ok(cells)
    }

    /// The mesh that the producer was made of with one more group of lines, polygons, 3-cells or points for each chain, as Gmsh writes chains
    /// of homology: a cell of the chain stands as an element as often as its coefficient says, turned if it is negative. The groups get
    /// numbers above all others.
    ///
    /// Of cochains the values are data of the same name too: at the first element of each cell, for the direction of that element.
    ///
    /// Groups and arrays of the model that have one of these names are replaced.
    ///
    /// # Errors
    /// [`InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if the model is no mesh, and for a coefficient beyond 1000.
    ///
    /// # References
    /// M. Pellikka, S. Suuriniemi, L. Kettunen and C. Geuzaine, *Homology and cohomology computation in finite element modeling* (2013),
    /// section 5.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::Producer;
    /// use coface_algebra::{CellId, chains::Chain};
    /// use coface_io::Format;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = coface_io::read(&b"v 0 0 0\nv 1 0 0\nl 1 2\n"[..], Format::Obj)?;
    /// let producer = Producer::of(edge.clone())?;
    /// let twice = Chain::new(&producer.chain_complex()?, 1, [(CellId::new(0), (-2).into())])?;
    /// let with = producer.mesh_with_chains(edge, &[("H_1{0}1".to_owned(), twice)], false)?;
    /// assert_eq!(with.lines().iter().collect::<Vec<_>>(), [[0, 1], [1, 0], [1, 0]]);
    /// assert_eq!(with.groups()[0].members(), [1, 2]);
    /// # Ok(()) }
    /// ```
    pub fn mesh_with_chains(
        &self,
        model: Model,
        chains: &[(String, Chain<Integer>)],
        are_cochains: bool,
    ) -> Result<Model, Error> {
        Members::of(self, &model)?;
        let tags = msh::physical_tags(&model);
        let mut parts = model.into_parts();
        let groups = std::mem::take(&mut parts.groups).into_iter().zip(&tags);
        parts.groups = groups.map(|(group, &tag)| group.with_number(tag)).collect();
        let mut next = tags.iter().copied().max().unwrap_or(0);
        // What was asked before on the same mesh gives way to what is asked now.
        for (name, chain) in chains {
            let kind = kind_of(chain.degree())?;
            parts.groups.retain(|group| group.name() != name || group.kind() != kind);
            parts.data.retain(|data| data.name() != name || data.kind() != kind);
        }
        let mut added: Vec<Values> = Vec::new();
        for (name, chain) in chains {
            next = next.checked_add(1).ok_or_else(|| {
                Error::invalid("the largest number of a group is taken")
                    .with_cure("give groups smaller numbers")
            })?;
            let kind = kind_of(chain.degree())?;
            let (mut members, mut values) = (Vec::new(), Vec::new());
            for (cell, coefficient) in chain.terms() {
                let value = coefficient.to_i64().filter(|value| value.unsigned_abs() <= MOST_TIMES);
                let value = value.ok_or_else(|| {
                    Error::invalid(format!(
                        "{name:?} has the coefficient {coefficient} on a cell, and a group repeats a cell at most {MOST_TIMES} times"
                    ))
                    .with_cure("write the generators as .json")
                })?;
                if kind == GroupKind::Vertices && !are_cochains && value != 1 {
                    return Err(Error::invalid(format!(
                        "{name:?} has the coefficient {coefficient} on a vertex, and a group holds a point once"
                    ))
                    .with_cure("write the generators as .json"));
                }
                // Points are not turned.
                let own = if kind == GroupKind::Vertices { value } else { value.abs() } as f64;
                for time in 0..value.unsigned_abs().max(1) {
                    let member = self.push_element(&mut parts, chain.degree(), *cell, value < 0);
                    members.push(member);
                    if time == 0 {
                        values.push((member, own));
                    }
                    if kind == GroupKind::Vertices {
                        break;
                    }
                }
            }
            parts.groups.push(Group::new(name, kind, members).with_number(next));
            if are_cochains {
                added.push((name.clone(), kind, values));
            }
        }
        lengthen_data(&mut parts)?;
        for (name, kind, values) in added {
            let mut numbers = vec![f64::NAN; count_of(&parts, kind)];
            for (member, value) in values {
                numbers[member as usize] = value;
            }
            parts.data.push(CellData::reals(name, kind, 1, numbers)?);
        }
        let model = parts.into_model();
        model.check()?;
        Ok(model)
    }

    /// Adds a cell as an element, turned or not; gives the member for a group.
    fn push_element(&self, parts: &mut ModelParts, degree: usize, cell: CellId, is_turned: bool) -> u32 {
        let mut vertices = self.cell_vertices(degree, cell);
        let position = match degree {
            0 => return vertices[0],
            1 | 2 => {
                if is_turned {
                    vertices.reverse();
                }
                let lists = if degree == 1 { &mut parts.lines } else { &mut parts.polygons };
                lists.push(&vertices);
                lists.len() - 1
            }
            _ => {
                let shape = match &self.cells {
                    Cells::Solids(mesh) => mesh.shapes()[cell.index()],
                    _ => CellShape::Tetrahedron,
                };
                if is_turned {
                    turn(shape, &mut vertices);
                }
                parts.shapes.push(shape);
                parts.cells.push(&vertices);
                parts.cells.len() - 1
            }
        };
        position as u32
    }
}

/// The name and the kind of a group, and the values of a cochain on members of it.
type Values = (String, GroupKind, Vec<(u32, f64)>);

fn kind_of(degree: usize) -> Result<GroupKind, Error> {
    [GroupKind::Vertices, GroupKind::Lines, GroupKind::Polygons, GroupKind::Cells]
        .get(degree)
        .copied()
        .ok_or_else(|| {
            Error::invalid(format!("a chain of degree {degree} is no group of a mesh"))
                .with_cure("write the generators as .json")
        })
}

fn count_of(parts: &ModelParts, kind: GroupKind) -> usize {
    match kind {
        GroupKind::Vertices => parts.vertex_count,
        GroupKind::Lines => parts.lines.len(),
        GroupKind::Polygons => parts.polygons.len(),
        GroupKind::Cells => parts.cells.len(),
    }
}

/// Gives data on the cells that there were no numbers on the new ones: NaN.
fn lengthen_data(parts: &mut ModelParts) -> Result<(), Error> {
    for i in 0..parts.data.len() {
        let data = &parts.data[i];
        let count = count_of(parts, data.kind());
        if data.len() == count {
            continue;
        }
        let mut numbers: Vec<f64> = (0..data.len()).flat_map(|cell| data.real_row(cell)).collect();
        numbers.resize(count * data.components(), f64::NAN);
        parts.data[i] = CellData::reals(data.name(), data.kind(), data.components(), numbers)?;
    }
    Ok(())
}

/// The same cell with the opposite orientation.
fn turn(shape: CellShape, vertices: &mut [u32]) {
    match shape {
        CellShape::Hexahedron => {
            vertices.swap(1, 3);
            vertices.swap(5, 7);
        }
        CellShape::Wedge => {
            vertices.swap(1, 2);
            vertices.swap(4, 5);
        }
        CellShape::Pyramid => vertices.swap(1, 3),
        _ => vertices.swap(1, 2),
    }
}

/// Which cells the lines, polygons and 3-cells of a mesh are.
struct Members<'p> {
    cells: &'p Cells,
    /// Where the edges of each line begin among all segments of lines, and their number at the end.
    first_segments: Vec<usize>,
    /// The face of each polygon; empty where the cell mesh says it.
    faces: Vec<FaceId>,
    /// The cell of each 3-cell of the model.
    solids: Vec<CellId>,
}

impl<'p> Members<'p> {
    fn of(producer: &'p Producer, model: &Model) -> Result<Self, Error> {
        let mut first_segments = Vec::with_capacity(model.lines().len());
        let mut count = 0;
        for line in model.lines().iter() {
            first_segments.push(count);
            count += line.len().saturating_sub(1);
        }
        first_segments.push(count);
        let (mut faces, mut solids) = (Vec::new(), Vec::new());
        match &producer.cells {
            Cells::Polygons(mesh) => {
                faces = vec![FaceId::new(0); model.polygons().len()];
                for face in (0..mesh.face_count()).map(FaceId::new) {
                    faces[mesh.polygon_of_face(face)] = face;
                }
                for &(face, later) in mesh.duplicate_faces() {
                    faces[later] = face;
                }
            }
            Cells::Solids(mesh) => {
                solids = vec![CellId::new(0); model.cells().len()];
                for cell in (0..mesh.cell_count()).map(CellId::new) {
                    solids[mesh.source_of_cell(cell)] = cell;
                }
                for &(cell, later) in mesh.duplicate_cells() {
                    solids[later] = cell;
                }
            }
            _ => {
                return Err(Error::invalid("the model is no mesh, so its cells are in no groups")
                    .with_cure("give a mesh with groups, such as .msh, .mesh or .obj"));
            }
        }
        Ok(Self { cells: &producer.cells, first_segments, faces, solids })
    }

    /// Adds the cells that one member of a group is: of a polyline all edges.
    fn push_cells(&self, kind: GroupKind, member: usize, cells: &mut Vec<(usize, CellId)>) {
        let skeleton = match self.cells {
            Cells::Polygons(mesh) => mesh,
            Cells::Solids(mesh) => mesh.skeleton(),
            _ => return,
        };
        match kind {
            GroupKind::Vertices => cells.push((0, CellId::new(member))),
            GroupKind::Lines => {
                let edges = self.first_segments[member]..self.first_segments[member + 1];
                cells.extend(edges.map(|i| (1, CellId::new(skeleton.loose_edge(i).index()))));
            }
            GroupKind::Polygons => {
                let face = match self.cells {
                    Cells::Solids(mesh) => mesh.face_of_polygon(member).0,
                    _ => self.faces[member],
                };
                cells.push((2, CellId::new(face.index())));
            }
            GroupKind::Cells => cells.push((3, self.solids[member])),
        }
    }
}
