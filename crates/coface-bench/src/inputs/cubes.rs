//! Blocks of cubes cut into simplices: the cube, the solid torus, tori, in dimension 4 as well.

use super::Mesh;
use coface::Error;
use coface::algebra::RaggedArray;
use coface::complexes::grids::CuboidGrid;

/// A block of cubes, each cut into the six tetrahedra of its monotone paths from the lowest corner to the highest
/// (H. W. Kuhn, 1960), so that neighbors match; a direction that is `periodic` closes up.
///
/// A periodic direction needs at least three cubes, or the result is no simplicial complex.
pub(super) fn kuhn_cubes(cubes: [usize; 3], periodic: [bool; 3]) -> Mesh {
    let points: [usize; 3] = std::array::from_fn(|i| cubes[i] + usize::from(!periodic[i]));
    let id = |at: [usize; 3]| {
        let [x, y, z] = std::array::from_fn(|i| at[i] % points[i]);
        ((z * points[1] + y) * points[0] + x) as u32
    };
    let mut tetrahedra: Vec<[u32; 4]> = Vec::with_capacity(6 * cubes.iter().product::<usize>());
    for z in 0..cubes[2] {
        for y in 0..cubes[1] {
            for x in 0..cubes[0] {
                for path in [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]] {
                    let mut at = [x, y, z];
                    let mut tetrahedron = [id(at); 4];
                    for (step, direction) in path.into_iter().enumerate() {
                        at[direction] += 1;
                        tetrahedron[step + 1] = id(at);
                    }
                    tetrahedra.push(tetrahedron);
                }
            }
        }
    }
    let mut coordinates = Vec::with_capacity(3 * points.iter().product::<usize>());
    for z in 0..points[2] {
        for y in 0..points[1] {
            for x in 0..points[0] {
                coordinates.extend([x as f64, y as f64, z as f64]);
            }
        }
    }
    Mesh { vertex_count: coordinates.len() / 3, coordinates, lists: RaggedArray::from_lists(tetrahedra) }
}

/// A block of cubes of any dimension, as many along each axis, cut in the same way into one simplex for each order of the
/// axes; all directions are `periodic`, or none. Without coordinates.
pub(super) fn kuhn_grid(dimension: usize, side: usize, periodic: bool) -> Mesh {
    let points = side + usize::from(!periodic);
    let id = |at: &[usize]| at.iter().rev().fold(0, |sum, &x| sum * points + x % points) as u32;
    let mut orders: Vec<Vec<usize>> = vec![Vec::new()];
    for _ in 0..dimension {
        let longer = |order: &Vec<usize>| {
            let free: Vec<usize> = (0..dimension).filter(|axis| !order.contains(axis)).collect();
            let order = order.clone();
            free.into_iter().map(move |axis| order.iter().copied().chain([axis]).collect())
        };
        orders = orders.iter().flat_map(longer).collect();
    }
    let mut simplices: Vec<u32> =
        Vec::with_capacity(orders.len() * (dimension + 1) * side.pow(dimension as u32));
    for cube in 0..side.pow(dimension as u32) {
        let corner: Vec<usize> = (0..dimension).map(|axis| cube / side.pow(axis as u32) % side).collect();
        for order in &orders {
            let mut at = corner.clone();
            simplices.push(id(&at));
            for &axis in order {
                at[axis] += 1;
                simplices.push(id(&at));
            }
        }
    }
    let lists = RaggedArray::uniform(dimension + 1, simplices).expect("each simplex has its vertices");
    Mesh { vertex_count: points.pow(dimension as u32), coordinates: Vec::new(), lists }
}

/// The cells of this dimension of a cuboid grid, with their vertices in the order of the grid.
///
/// # Errors
/// For a grid beyond 32 bits.
pub(super) fn cuboid_cells(side: usize, dimension: usize) -> Result<Mesh, Error> {
    let grid = CuboidGrid::new(&[side as u32; 3])?;
    Ok(Mesh { vertex_count: grid.cell_count(0), coordinates: Vec::new(), lists: grid.cells(dimension)? })
}
