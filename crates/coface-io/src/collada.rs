//! COLLADA (`.dae`): the meshes of its scene.

use crate::Model;
use coface_algebra::Error;
use std::io::Read;

/// Reads all meshes that the scene of a COLLADA file places; without a scene, all meshes as they stand. The mesh of a node with a name is a
/// [`Group`](crate::Group) of polygons. The unit and the axis that points up are those of the file; skins are at rest.
///
/// # Errors
/// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) for what is no XML or a number out of place;
/// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a source that is not there, a node that contains itself, or an
/// index that is out of range.
///
/// # Complexity
/// Linear in the file and the placed meshes.
///
/// # References
/// M. Barnes and E. L. Finch, *COLLADA: digital asset schema release 1.4.1* (2008).
///
/// # Examples
/// ```
/// # #[cfg(feature = "xml")]
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = br##"<COLLADA><library_geometries><geometry id="g"><mesh>
/// <source id="s"><float_array>0 0 0 1 0 0 0 1 0</float_array></source>
/// <vertices id="v"><input semantic="POSITION" source="#s"/></vertices>
/// <triangles><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
/// </mesh></geometry></library_geometries></COLLADA>"##;
/// assert_eq!(coface_io::collada::read(&text[..])?.polygons().list(0), [0, 1, 2]);
/// # Ok(()) }
/// # #[cfg(not(feature = "xml"))]
/// # fn main() {}
/// ```
#[cfg(feature = "xml")]
pub fn read(input: impl Read) -> Result<Model, Error> {
    reading::read(input)
}

/// Refuses every file: this build lacks the feature `xml`.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat), always.
#[cfg(not(feature = "xml"))]
pub fn read(_input: impl Read) -> Result<Model, Error> {
    Err(crate::features::without_xml("COLLADA"))
}

#[cfg(feature = "xml")]
mod reading {
    use crate::Model;
    use crate::scene::{LooseMesh, Placement, Scene};
    use crate::xml_text::{document, numbers};
    use coface_algebra::Error;
    use roxmltree::Node;
    use std::collections::HashMap;
    use std::io::Read;

    /// The elements by their identifiers.
    type Ids<'a, 'i> = HashMap<&'a str, Node<'a, 'i>>;

    pub(super) fn read(mut input: impl Read) -> Result<Model, Error> {
        let mut text = String::new();
        input.read_to_string(&mut text)?;
        let document = document(&text)?;
        let elements = || document.descendants().filter(|node| node.is_element());
        let ids: Ids<'_, '_> = elements().filter_map(|node| Some((node.attribute("id")?, node))).collect();
        let mut meshes = HashMap::new();
        for geometry in elements().filter(|node| node.has_tag_name_of("geometry")) {
            let mut mesh = LooseMesh::default();
            for node in geometry.children().filter(|node| node.has_tag_name_of("mesh")) {
                add_mesh(node, &ids, &mut mesh)?;
            }
            meshes.insert(geometry.id(), mesh.welded());
        }
        let mut scene = Scene::of_size(text.len());
        let start = elements().find(|node| node.has_tag_name_of("instance_visual_scene"));
        let start = start
            .and_then(|node| target(node, "url", &ids))
            .or_else(|| elements().find(|node| node.has_tag_name_of("visual_scene")));
        match start {
            Some(start) => {
                let mut walk = Walk { ids: &ids, meshes: &meshes, scene: &mut scene };
                for node in start.children().filter(|node| node.has_tag_name_of("node")) {
                    walk.place(node, Placement::IDENTITY, 0)?;
                }
            }
            None => {
                for geometry in elements().filter(|node| node.has_tag_name_of("geometry")) {
                    let name = geometry.attribute("name").unwrap_or_default();
                    scene.place(&meshes[&geometry.id()], Placement::IDENTITY, name)?;
                }
            }
        }
        scene.finish()
    }

    /// The name of an element whatever its namespace.
    trait TagName {
        fn has_tag_name_of(&self, name: &str) -> bool;
    }

    impl TagName for Node<'_, '_> {
        fn has_tag_name_of(&self, name: &str) -> bool {
            self.is_element() && self.tag_name().name() == name
        }
    }

    /// The element that an attribute `#id` names.
    fn target<'a, 'i>(node: Node<'a, 'i>, attribute: &str, ids: &Ids<'a, 'i>) -> Option<Node<'a, 'i>> {
        ids.get(node.attribute(attribute)?.strip_prefix('#')?).copied()
    }

    fn missing(what: &str) -> Error {
        Error::invalid(format!("{what} is not in the file")).with_cure("export the file again")
    }

    /// The points of a source of positions.
    fn points(source: Node<'_, '_>) -> Result<Vec<[f64; 3]>, Error> {
        let array = source.children().find(|node| node.has_tag_name_of("float_array"));
        let values = numbers(array.and_then(|node| node.text()).unwrap_or_default())?;
        let accessor = source.descendants().find(|node| node.has_tag_name_of("accessor"));
        let count_of = |name: &str, usual: usize| {
            accessor
                .and_then(|node| node.attribute(name))
                .and_then(|text| text.trim().parse().ok())
                .unwrap_or(usual)
        };
        let (stride, offset) = (count_of("stride", 3).max(1), count_of("offset", 0));
        let rows = values.get(offset..).unwrap_or_default().chunks_exact(stride);
        Ok(rows.map(|row| std::array::from_fn(|axis| row.get(axis).copied().unwrap_or(0.0))).collect())
    }

    /// Adds the primitives of a mesh.
    fn add_mesh<'a, 'i>(node: Node<'a, 'i>, ids: &Ids<'a, 'i>, mesh: &mut LooseMesh) -> Result<(), Error> {
        let mut firsts: HashMap<roxmltree::NodeId, (u32, u32)> = HashMap::new();
        for primitive in node.children().filter(Node::is_element) {
            let kind = primitive.tag_name().name();
            if !matches!(
                kind,
                "triangles" | "polylist" | "polygons" | "tristrips" | "trifans" | "lines" | "linestrips"
            ) {
                continue;
            }
            let inputs: Vec<Node<'_, '_>> =
                primitive.children().filter(|node| node.has_tag_name_of("input")).collect();
            let offset_of = |node: &Node<'_, '_>| {
                node.attribute("offset").and_then(|text| text.trim().parse::<usize>().ok()).unwrap_or(0)
            };
            let stride = inputs.iter().map(offset_of).max().map_or(1, |most| most.saturating_add(1));
            let Some(input) = inputs.iter().find(|node| node.attribute("semantic") == Some("VERTEX")) else {
                continue;
            };
            let vertices = target(*input, "source", ids).ok_or_else(|| missing("the source of VERTEX"))?;
            let position = vertices
                .children()
                .find(|node| node.has_tag_name_of("input") && node.attribute("semantic") == Some("POSITION"));
            let source = position
                .and_then(|node| target(node, "source", ids))
                .ok_or_else(|| missing("the source of POSITION"))?;
            let (first, count) = match firsts.get(&source.id()) {
                Some(&known) => known,
                None => {
                    let points = points(source)?;
                    let known = (mesh.points.len() as u32, points.len() as u32);
                    mesh.points.extend(points);
                    firsts.insert(source.id(), known);
                    known
                }
            };
            let mut lists: Vec<Vec<u32>> = Vec::new();
            for p in primitive.descendants().filter(|node| node.has_tag_name_of("p")) {
                let indices = naturals(p.text().unwrap_or_default())?;
                let corners = indices.into_iter().skip(offset_of(input)).step_by(stride);
                let list: Result<Vec<u32>, Error> = corners
                    .map(|index| match u32::try_from(index) {
                        Ok(index) if index < count => Ok(first + index),
                        _ => Err(Error::invalid(format!(
                            "a face names vertex {index}, but there are {count} vertices, numbered from 0"
                        ))
                        .with_cure("export the file again")),
                    })
                    .collect();
                lists.push(list?);
            }
            match kind {
                "triangles" => {
                    mesh.polygons
                        .extend(lists.iter().flat_map(|list| list.chunks_exact(3)).map(<[u32]>::to_vec));
                }
                "polygons" => mesh.polygons.extend(lists),
                "polylist" => {
                    let counts = primitive.children().find(|node| node.has_tag_name_of("vcount"));
                    let counts = naturals(counts.and_then(|node| node.text()).unwrap_or_default())?;
                    let mut left = lists.first().map(Vec::as_slice).unwrap_or_default();
                    for count in counts {
                        let split =
                            usize::try_from(count).ok().and_then(|count| left.split_at_checked(count));
                        let Some((polygon, rest)) = split else {
                            return Err(Error::parse("a polylist has fewer corners than its counts say")
                                .with_cure("export the file again"));
                        };
                        mesh.polygons.push(polygon.to_vec());
                        left = rest;
                    }
                }
                "tristrips" => {
                    for list in &lists {
                        mesh.polygons.extend(
                            list.windows(3)
                                .enumerate()
                                .map(|(i, triangle)| vec![triangle[i % 2], triangle[1 - i % 2], triangle[2]]),
                        );
                    }
                }
                "trifans" => {
                    for list in lists.iter().filter(|list| !list.is_empty()) {
                        mesh.polygons
                            .extend(list[1..].windows(2).map(|pair| vec![list[0], pair[0], pair[1]]));
                    }
                }
                "lines" => {
                    mesh.lines
                        .extend(lists.iter().flat_map(|list| list.chunks_exact(2)).map(<[u32]>::to_vec));
                }
                _ => mesh.lines.extend(lists.into_iter().filter(|list| list.len() > 1)),
            }
        }
        Ok(())
    }

    fn naturals(text: &str) -> Result<Vec<u64>, Error> {
        text.split_ascii_whitespace()
            .map(|word| {
                word.parse().map_err(|_| {
                    Error::parse(format!("{} is no index", crate::scanner::quoted(word.as_bytes())))
                        .with_cure("export the file again")
                })
            })
            .collect()
    }

    struct Walk<'w, 'a, 'i> {
        ids: &'w Ids<'a, 'i>,
        meshes: &'w HashMap<roxmltree::NodeId, LooseMesh>,
        scene: &'w mut Scene,
    }

    impl<'a, 'i> Walk<'_, 'a, 'i> {
        fn place(&mut self, node: Node<'a, 'i>, outer: Placement, depth: usize) -> Result<(), Error> {
            self.scene.step(depth)?;
            let mut placement = outer;
            for child in node.children().filter(Node::is_element) {
                let kind = child.tag_name().name();
                match kind {
                    "matrix" | "translate" | "rotate" | "scale" => {
                        let values = numbers(child.text().unwrap_or_default())?;
                        placement = placement.after(transformation(kind, &values)?);
                    }
                    "node" => self.place(child, placement, depth + 1)?,
                    "instance_node" => {
                        if let Some(node) = target(child, "url", self.ids) {
                            self.place(node, placement, depth + 1)?;
                        }
                    }
                    "instance_geometry" | "instance_controller" => {
                        let mut geometry = target(child, "url", self.ids);
                        for _ in 0..8 {
                            // The skin of a controller is put on a geometry, or on another controller.
                            let Some(controller) = geometry.filter(|node| node.has_tag_name_of("controller"))
                            else {
                                break;
                            };
                            let skin = controller.children().find(Node::is_element);
                            geometry = skin.and_then(|skin| target(skin, "source", self.ids));
                        }
                        let mesh = geometry.and_then(|geometry| self.meshes.get(&geometry.id()));
                        let mesh = mesh.ok_or_else(|| missing("the geometry of a node"))?;
                        let name = node.attribute("name").or(node.attribute("id")).unwrap_or_default();
                        self.scene.place(mesh, placement, name)?;
                    }
                    _ => {}
                }
            }
            Ok(())
        }
    }

    fn transformation(kind: &str, values: &[f64]) -> Result<Placement, Error> {
        let [i, j, k] = Placement::IDENTITY.0;
        match (kind, values) {
            ("matrix", values) if values.len() == 16 => Ok(Placement(std::array::from_fn(|row| {
                std::array::from_fn(|column| values[4 * row + column])
            }))),
            ("translate", &[x, y, z]) => {
                Ok(Placement([[i[0], i[1], i[2], x], [j[0], j[1], j[2], y], [k[0], k[1], k[2], z]]))
            }
            ("scale", &[x, y, z]) => {
                Ok(Placement([[x, 0.0, 0.0, 0.0], [0.0, y, 0.0, 0.0], [0.0, 0.0, z, 0.0]]))
            }
            ("rotate", &[x, y, z, degrees]) => {
                let length = x.hypot(y).hypot(z);
                if length == 0.0 {
                    return Ok(Placement::IDENTITY);
                }
                let (x, y, z) = (x / length, y / length, z / length);
                let (s, c) = degrees.to_radians().sin_cos();
                let t = 1.0 - c;
                Ok(Placement([
                    [t * x * x + c, t * x * y - s * z, t * x * z + s * y, 0.0],
                    [t * x * y + s * z, t * y * y + c, t * y * z - s * x, 0.0],
                    [t * x * z - s * y, t * y * z + s * x, t * z * z + c, 0.0],
                ]))
            }
            _ => Err(Error::parse(format!("a {kind} of a node has {} numbers", values.len()))
                .with_cure("export the file again")),
        }
    }
}
