//! The polygons and closed lines of a model as curves that bound a set.

use super::{BoundaryCurve, BoundaryDrawing, Filling};
use crate::{GroupKind, Model, Shape, shapes};
use crate::{Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind, VertexId};
use coface_arrange::boolean::InsideRule;
use coface_yin::Order;

/// The curves of order 2 that a model in the plane draws: its polygons, with holes or of a mesh, each a group. Lines beside polygons are
/// passed over; lines alone are what they enclose an odd number of times.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] for an abstract structure, 3-cells or vertices without positions; [`ErrorKind::InvalidInput`] naming a
/// vertex that is not in the plane z = 0; [`ErrorKind::NotACycle`] naming where lines end.
///
/// # Complexity
/// Linear, and $O(n \log n)$ for n segments of lines alone.
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::{Format, yin};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let model = io::read(&b"POLYGON ((0 0, 9 0, 9 9, 0 0), (5 1, 8 1, 8 4, 5 1))"[..], Format::Wkt)?;
/// let drawing = yin::drawing_of_model(&model)?;
/// assert_eq!(drawing.groups(), [(yin::Filling::OuterWithoutHoles, 0..2)]);
/// assert_eq!(drawing.curves()[0].points(), [[0., 0.], [9., 0.], [9., 9.]]);
/// # Ok(()) }
/// ```
pub fn drawing_of_model(model: &Model) -> Result<BoundaryDrawing, Error> {
    check_plane(model)?;
    let mut drawing = BoundaryDrawing::new(Order::LINEAR);
    if let Some(system) = model.reference_system() {
        let message = format!("sets of the plane keep no reference system: {system} is left out");
        drawing.remark(Remark::new(RemarkCode::FormatKeepsLess, message));
    }
    let rules = model.data_named("fill_rule", GroupKind::Lines);
    let place = |vertex: u32| {
        let point = model.positions().point(VertexId::from_u32(vertex));
        [point[0], point[1]]
    };
    let shapes = shapes(model);
    let bounds = |shape: &Shape| matches!(shape, Shape::Rings(_) | Shape::Face(_));
    if !shapes.iter().any(|(shape, _)| bounds(shape)) {
        let walks = closed_walks(model)?;
        let points = |walk: &Vec<u32>| walk.iter().map(|&vertex| place(vertex)).collect();
        let curves: Vec<BoundaryCurve> = walks.iter().map(|walk| BoundaryCurve::new(points(walk))).collect();
        if curves.is_empty() && model.vertex_count() > 0 {
            drawing.remark(Remark::new(
                RemarkCode::ElementsLeftOut,
                "points alone bound nothing and are passed over",
            ));
        }
        if !curves.is_empty() {
            drawing.push(Filling::Stated(InsideRule::Odd), curves);
        }
        return Ok(drawing);
    }
    let (mut passed_over, mut points) = (0, 0);
    for (shape, group) in shapes {
        let curve = |ring: &[u32]| {
            let mut curve = BoundaryCurve::new(ring.iter().map(|&vertex| place(vertex)).collect());
            curve.set_name(group.map(|group| model.groups()[group].name().to_owned()));
            curve
        };
        match shape {
            Shape::Rings(lines) => {
                let rule = rules.and_then(|rules| rules.integer_row(lines.start)).map(|row| row[0]);
                let filling = match rule {
                    Some(0) => Filling::Stated(InsideRule::Nonzero),
                    Some(1) => Filling::Stated(InsideRule::Odd),
                    _ => Filling::OuterWithoutHoles,
                };
                let rings = lines.map(|line| {
                    let ring = model.lines().list(line);
                    curve(&ring[..ring.len() - 1])
                });
                drawing.push(filling, rings.collect());
            }
            Shape::Face(polygon) => {
                let ring = curve(model.polygons().list(polygon));
                drawing.push(Filling::OuterWithoutHoles, vec![ring]);
            }
            Shape::Line(_) => passed_over += 1,
            Shape::Point(_) => points += 1,
        }
    }
    if passed_over > 0 {
        let what =
            if passed_over == 1 { "line beside polygons bounds" } else { "lines beside polygons bound" };
        drawing.remark(
            Remark::new(RemarkCode::ElementsLeftOut, format!("{passed_over} {what} nothing and passed over"))
                .at(passed_over, []),
        );
    }
    if points > 0 {
        let what = if points == 1 { "point beside polygons bounds" } else { "points beside polygons bound" };
        let message = format!("{points} {what} nothing and passed over");
        drawing.remark(Remark::new(RemarkCode::ElementsLeftOut, message).at(points, []));
    }
    for remark in model.remarks() {
        drawing.remark(remark.clone());
    }
    Ok(drawing)
}

/// Walks along all segments of the lines, each once, that come back to where they began.
fn closed_walks(model: &Model) -> Result<Vec<Vec<u32>>, Error> {
    let segments: Vec<[u32; 2]> =
        model.lines().iter().flat_map(|line| line.windows(2).map(|pair| [pair[0], pair[1]])).collect();
    // The segments at each vertex, one vertex after the other.
    let mut starts = vec![0u32; model.vertex_count() + 1];
    for &vertex in segments.as_flattened() {
        starts[vertex as usize + 1] += 1;
    }
    if let Some(vertex) = starts.iter().position(|count| count % 2 == 1) {
        let point = model.positions().point(VertexId::new(vertex - 1));
        return Err(Error::new(
            ErrorKind::NotACycle,
            format!("lines end at ({}, {}), so they bound no set", point[0], point[1]),
        )
        .with_cure("close them, or give polygons"));
    }
    for vertex in 1..starts.len() {
        starts[vertex] += starts[vertex - 1];
    }
    let mut next = starts.clone();
    let mut at = vec![0u32; 2 * segments.len()];
    for (i, &vertex) in segments.as_flattened().iter().enumerate() {
        at[next[vertex as usize] as usize] = (i / 2) as u32;
        next[vertex as usize] += 1;
    }
    next.copy_from_slice(&starts);
    let mut is_used = vec![false; segments.len()];
    let mut walks = Vec::new();
    for start in 0..segments.len() {
        if is_used[start] {
            continue;
        }
        let first = segments[start][0];
        let (mut walk, mut vertex) = (Vec::new(), first);
        loop {
            // Every vertex has an even number of ends: there is a way out until the walk is closed.
            let place = &mut next[vertex as usize];
            while *place < starts[vertex as usize + 1] && is_used[at[*place as usize] as usize] {
                *place += 1;
            }
            if *place == starts[vertex as usize + 1] {
                break;
            }
            let segment = at[*place as usize] as usize;
            is_used[segment] = true;
            walk.push(vertex);
            let [a, b] = segments[segment];
            vertex = if a == vertex { b } else { a };
            if vertex == first {
                break;
            }
        }
        walks.push(walk);
    }
    Ok(walks)
}

/// Refuses a model that does not lie in the plane.
fn check_plane(model: &Model) -> Result<(), Error> {
    let refuse = |what: &str, cure: &str| Err(Error::new(ErrorKind::UnsupportedFormat, what).with_cure(cure));
    if model.structure().is_some() {
        return refuse("an abstract structure bounds no set in the plane", "give curves or polygons");
    }
    if !model.cells().is_empty() {
        return refuse("3-cells do not lie in the plane", "give curves or polygons");
    }
    model.require_finite()?;
    let positions = model.positions();
    match positions.dimension() {
        2 => Ok(()),
        0 if model.is_empty() => Ok(()),
        3 => match positions.as_flat().iter().skip(2).step_by(3).position(|&height| height != 0.0) {
            None => Ok(()),
            Some(vertex) => Err(Error::invalid(format!(
                "v{vertex} is at height {}, not in the plane z = 0",
                positions.as_flat()[3 * vertex + 2]
            ))
            .with_cure("set all heights to 0")),
        },
        dimension => refuse(
            &format!("points with {dimension} coordinates do not lie in the plane"),
            "give two coordinates for each point, or three of which the last is 0",
        ),
    }
}
