//! Bing's house with two rooms.

use super::from_rule;
use crate::simplicial::SimplicialComplex;
use coface_algebra::Error;

/// Bing's house with two rooms: a contractible 2-complex in which no triangle has a free edge.
///
/// The house is a block of 5 x 3 x 2 cubes, one storey a room. The upper room is entered from below through a shaft that
/// crosses the lower one, and the lower from above; a wall joins each shaft to the outside, so that both rooms are simply
/// connected. All squares are cut along the diagonal from their lowest corner. Vertices are the points of the grid that
/// lie on walls, in the order z, y, x.
///
/// # Errors
/// None: the rule is sound.
///
/// # References
/// R. H. Bing, *Some aspects of the topology of 3-manifolds related to the Poincare conjecture* (1964).
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// let house = known_spaces::house_with_two_rooms()?;
/// assert_eq!((house.dimension(), house.euler_characteristic()), (Some(2), 1));
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn house_with_two_rooms() -> Result<SimplicialComplex, Error> {
    /// What a unit cube is filled with. The shaft to a room runs through the other.
    #[derive(Clone, Copy, PartialEq)]
    enum Space {
        Outside,
        Upper,
        Lower,
        ShaftToUpper,
        ShaftToLower,
    }
    let space = |[x, y, z]: [i32; 3]| match (x, y, z) {
        (1, 1, 1) => Space::ShaftToLower,
        (3, 1, 0) => Space::ShaftToUpper,
        (0..5, 0..3, 1) => Space::Upper,
        (0..5, 0..3, 0) => Space::Lower,
        _ => Space::Outside,
    };
    let is_door = |a: Space, b: Space| {
        use Space::{Lower, Outside, ShaftToLower, ShaftToUpper, Upper};
        let pair = |x, y| (a, b) == (x, y) || (a, b) == (y, x);
        a == b
            || pair(ShaftToLower, Lower)
            || pair(ShaftToUpper, Upper)
            || pair(ShaftToLower, Outside)
            || pair(ShaftToUpper, Outside)
    };
    let mut walls: Vec<[[i32; 3]; 4]> = Vec::new();
    for z in 0..=2 {
        for y in 0..=3 {
            for x in 0..=5 {
                let cube = [x, y, z];
                for axis in 0..3 {
                    let mut before = cube;
                    before[axis] -= 1;
                    // The two walls that join the shafts to the outside stand across x, in front of each shaft.
                    let is_inner_wall = axis == 0 && (cube == [1, 0, 1] || cube == [3, 0, 0]);
                    if is_door(space(cube), space(before)) && !is_inner_wall {
                        continue;
                    }
                    let corner = |u: i32, v: i32| {
                        let mut corner = cube;
                        corner[(axis + 1) % 3] += u;
                        corner[(axis + 2) % 3] += v;
                        corner
                    };
                    walls.push([corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)]);
                }
            }
        }
    }
    let mut points: Vec<[i32; 3]> = walls.concat().iter().map(|&[x, y, z]| [z, y, x]).collect();
    points.sort_unstable();
    points.dedup();
    let number =
        |[x, y, z]: [i32; 3]| points.binary_search(&[z, y, x]).expect("corners of walls are listed") as u32;
    from_rule(walls.into_iter().flat_map(|wall| {
        let [a, b, c, d] = wall.map(number);
        [vec![a, b, d], vec![a, c, d]]
    }))
}
