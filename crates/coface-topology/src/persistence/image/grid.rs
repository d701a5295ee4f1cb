//! Grids of vertices with a layer around them, and the cells at a vertex.

/// No image has more axes.
pub(super) const MOST_AXES: usize = 4;

/// A cell of a star: its place in [`Codes`].
pub(super) type Code = u8;

/// The cells at a vertex, numbered by rising degree: number 0 is the vertex.
pub(super) struct Codes {
    axes: usize,
    /// For each axis -1, 0 or 1: whether the cell lies before, at or behind the vertex.
    digits: Vec<[i8; MOST_AXES]>,
    /// The number of a cell by its digits in base 3.
    numbers: Vec<Code>,
    degrees: Vec<u8>,
    /// The axes along which the cell extends, a bit each.
    extents: Vec<u8>,
    /// The other vertices of the cell, a bit each: that of the code of the cell in which such a vertex is opposite to the own one.
    corners: Vec<u128>,
    /// The facets that contain the vertex.
    near_facets: Vec<u128>,
    facets: Vec<Vec<Facet>>,
    cofacets: Vec<Vec<Cofacet>>,
    /// The vertices of each cell, each with the code that the cell has there.
    seen: Vec<Vec<(Code, Code)>>,
    /// See [`Codes::top_corners`].
    top_corners: Vec<(Code, Code)>,
}

/// A facet of a cell of a star.
pub(super) struct Facet {
    pub(super) is_negative: bool,
    pub(super) kind: FacetKind,
}

pub(super) enum FacetKind {
    /// It contains the vertex.
    Near(Code),
    /// It does not: the vertices of the facet by their codes, each with the code that the facet has there.
    Far(Vec<(Code, Code)>),
}

/// A cell that a cell of a star is a facet of.
pub(super) struct Cofacet {
    pub(super) is_negative: bool,
    /// Its code at the vertex.
    pub(super) code: Code,
    /// Its vertices beyond the facet by their codes, each with the code that it has there.
    pub(super) far: Vec<(Code, Code)>,
}

impl Codes {
    pub(super) fn new(axes: usize) -> Self {
        let count = 3usize.pow(axes as u32);
        let digits_of = |index: usize| {
            let mut digits = [0i8; MOST_AXES];
            let mut rest = index;
            for digit in digits.iter_mut().take(axes) {
                *digit = [0, 1, -1][rest % 3];
                rest /= 3;
            }
            digits
        };
        let degree = |digits: &[i8; MOST_AXES]| digits.iter().filter(|&&digit| digit != 0).count();
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by_key(|&index| (degree(&digits_of(index)), index));
        let mut numbers = vec![0; count];
        for (number, &index) in order.iter().enumerate() {
            numbers[index] = number as Code;
        }
        let digits: Vec<_> = order.iter().map(|&index| digits_of(index)).collect();
        let mut codes = Self {
            axes,
            degrees: digits.iter().map(|digits| degree(digits) as u8).collect(),
            extents: digits.iter().map(extent).collect(),
            digits,
            numbers,
            corners: Vec::new(),
            near_facets: Vec::new(),
            facets: Vec::new(),
            cofacets: Vec::new(),
            seen: Vec::new(),
            top_corners: Vec::new(),
        };
        for number in 0..count {
            let corners = codes.parts(number, None).into_iter().filter(|&part| part != 0);
            codes.corners.push(corners.fold(0, |mask, part| mask | 1 << part));
            let facets = codes.facets_of(number);
            let near = facets.iter().filter_map(|facet| match facet.kind {
                FacetKind::Near(code) => Some(code),
                FacetKind::Far(_) => None,
            });
            codes.near_facets.push(near.fold(0, |mask, code| mask | 1 << code));
            codes.facets.push(facets);
        }
        codes.seen = (0..count).map(|number| codes.seen_from(number, None)).collect();
        codes.cofacets = (0..count).map(|number| codes.cofacets_of(number as Code)).collect();
        // The vertices of the cell that extends behind a vertex along all axes.
        let top = codes.number(&[1; MOST_AXES]);
        let corners = codes.parts(top as usize, None);
        let opposite = |&corner: &Code| {
            let at = codes.digits[corner as usize];
            (corner, codes.number(&at.map(|digit| if digit == 0 { 1 } else { -1 })))
        };
        codes.top_corners = corners.iter().map(opposite).collect();
        codes
    }

    fn number(&self, digits: &[i8; MOST_AXES]) -> Code {
        let place = |digit: i8| [2, 0, 1][(digit + 1) as usize];
        let index = digits[..self.axes].iter().rev().fold(0, |index, &digit| 3 * index + place(digit));
        self.numbers[index]
    }

    /// The vertices of a cell, or of its facet away from the vertex along an axis: its digits, some of them made 0.
    fn parts(&self, number: usize, away: Option<usize>) -> Vec<Code> {
        let digits = self.digits[number];
        let mut parts = Vec::new();
        for choice in 0u8..1 << self.axes {
            let is_kept = |axis: usize| choice >> axis & 1 == 1;
            let is_part = (0..self.axes).all(|axis| digits[axis] != 0 || !is_kept(axis));
            if is_part && away.is_none_or(is_kept) {
                let mut part = [0; MOST_AXES];
                for axis in (0..self.axes).filter(|&axis| is_kept(axis)) {
                    part[axis] = digits[axis];
                }
                parts.push(self.number(&part));
            }
        }
        parts
    }

    fn facets_of(&self, number: usize) -> Vec<Facet> {
        let digits = self.digits[number];
        let mut facets = Vec::new();
        let along = (0..self.axes).filter(|&axis| digits[axis] != 0);
        for (place, axis) in along.enumerate() {
            let mut flat = digits;
            flat[axis] = 0;
            // The boundary is the end behind less the end before, with the sign of the place of the axis.
            let is_before = digits[axis] > 0;
            let is_odd = place % 2 == 1;
            facets
                .push(Facet { is_negative: is_before != is_odd, kind: FacetKind::Near(self.number(&flat)) });
            let seen_from = |part: Code| {
                let at = self.digits[part as usize];
                let mut code = flat;
                for other in (0..self.axes).filter(|&other| other != axis && at[other] != 0) {
                    code[other] = -code[other];
                }
                (part, self.number(&code))
            };
            let corners = self.parts(number, Some(axis)).into_iter().map(seen_from).collect();
            facets.push(Facet { is_negative: is_before == is_odd, kind: FacetKind::Far(corners) });
        }
        facets
    }

    /// The vertices of a cell, or of its facet away from the vertex along an axis, each with the code that the cell has there.
    fn seen_from(&self, number: usize, away: Option<usize>) -> Vec<(Code, Code)> {
        let digits = self.digits[number];
        let seen = |part: Code| {
            let at = self.digits[part as usize];
            let mut code = digits;
            for axis in (0..self.axes).filter(|&axis| at[axis] != 0) {
                code[axis] = -code[axis];
            }
            (part, self.number(&code))
        };
        self.parts(number, away).into_iter().map(seen).collect()
    }

    fn cofacets_of(&self, code: Code) -> Vec<Cofacet> {
        let flat = (0..self.axes).filter(|&axis| self.is_flat(code, axis));
        let both = flat.flat_map(|axis| [1, -1].map(|side| (axis, side)));
        let cofacet = |(axis, side): (usize, i8)| {
            let cell = self.extended(code, axis, side);
            let own = |facet: &&Facet| matches!(facet.kind, FacetKind::Near(near) if near == code);
            let facet = self.facets(cell).iter().find(own).expect("a cell is a facet of what extends it");
            let far = self.seen_from(cell.into(), Some(axis));
            Cofacet { is_negative: facet.is_negative, code: cell, far }
        };
        both.map(cofacet).collect()
    }

    pub(super) fn count(&self) -> usize {
        self.digits.len()
    }

    pub(super) fn degree(&self, code: Code) -> usize {
        self.degrees[code as usize].into()
    }

    pub(super) fn corners(&self, code: usize) -> u128 {
        self.corners[code]
    }

    pub(super) fn near_facets(&self, code: usize) -> u128 {
        self.near_facets[code]
    }

    pub(super) fn facets(&self, code: Code) -> &[Facet] {
        &self.facets[code as usize]
    }

    /// The vertices of a cell, each with the code that the cell has there.
    pub(super) fn seen(&self, code: Code) -> &[(Code, Code)] {
        &self.seen[code as usize]
    }

    pub(super) fn cofacets(&self, code: Code) -> &[Cofacet] {
        &self.cofacets[code as usize]
    }

    /// The vertices of the cell that extends behind a vertex along all axes, each with the code that the cell has there.
    pub(super) fn top_corners(&self) -> &[(Code, Code)] {
        &self.top_corners
    }

    /// Along which axis, and on which side of the vertex, a cell extends beyond its facet.
    pub(super) fn direction(&self, facet: Code, cell: Code) -> (usize, i8) {
        let (a, b) = (&self.digits[facet as usize], &self.digits[cell as usize]);
        let axis = (0..self.axes).find(|&axis| a[axis] != b[axis]).expect("a cell is more than its facet");
        (axis, b[axis])
    }

    /// The cell that extends beyond this one along an axis, on one side.
    pub(super) fn extended(&self, code: Code, axis: usize, side: i8) -> Code {
        let mut digits = self.digits[code as usize];
        digits[axis] = side;
        self.number(&digits)
    }

    /// The facet of a cell through the vertex, across an axis.
    pub(super) fn flattened(&self, code: Code, axis: usize) -> Code {
        self.extended(code, axis, 0)
    }

    /// Whether a cell does not extend along an axis.
    pub(super) fn is_flat(&self, code: Code, axis: usize) -> bool {
        self.digits[code as usize][axis] == 0
    }

    /// The axis along which a cell does not extend, the first one.
    pub(super) fn flat_axis(&self, code: Code) -> Option<usize> {
        (0..self.axes).find(|&axis| self.digits[code as usize][axis] == 0)
    }
}

fn extent(digits: &[i8; MOST_AXES]) -> u8 {
    digits.iter().enumerate().map(|(axis, &digit)| u8::from(digit != 0) << axis).sum()
}

/// A grid of vertices; the last axis runs fastest.
pub(super) struct Grid {
    pub(super) codes: Codes,
    /// The numbers of vertices along the axes, with the layer around.
    lengths: Vec<usize>,
    is_periodic: Vec<bool>,
    strides: Vec<usize>,
    /// How far from a vertex things are, by where it lies along the periodic axes: see [`Grid::star`].
    stars: Vec<Star>,
}

/// How far from a vertex the vertices opposite in the cells of its star are, and the first vertices of those cells.
pub(super) struct Star {
    vertices: Vec<isize>,
    bases: Vec<isize>,
}

impl Grid {
    /// The grid of an image of this shape.
    pub(super) fn new(shape: &[usize], is_periodic: &[bool]) -> Self {
        let lengths: Vec<usize> = shape
            .iter()
            .zip(is_periodic)
            .map(|(&length, &is_periodic)| if is_periodic { length } else { length + 2 })
            .collect();
        let mut strides = vec![1; shape.len()];
        for axis in (1..shape.len()).rev() {
            strides[axis - 1] = strides[axis] * lengths[axis];
        }
        let is_periodic = is_periodic.to_vec();
        let mut grid =
            Self { codes: Codes::new(shape.len()), lengths, is_periodic, strides, stars: Vec::new() };
        let patterns = if grid.is_periodic.contains(&true) { grid.codes.count() } else { 1 };
        grid.stars = (0..patterns).map(|pattern| grid.star_of_pattern(pattern)).collect();
        grid
    }

    /// How many vertices a grid has, with the layer around; `None` beyond the numbers.
    pub(super) fn vertex_count_of(shape: &[usize], is_periodic: &[bool]) -> Option<usize> {
        shape.iter().zip(is_periodic).try_fold(1usize, |count, (&length, &is_periodic)| {
            count.checked_mul(if is_periodic { length } else { length.checked_add(2)? })
        })
    }

    fn star_of_pattern(&self, pattern: usize) -> Star {
        let mut rest = pattern;
        // For each axis the steps to the vertices behind and before.
        let steps: Vec<[isize; 2]> = (0..self.lengths.len())
            .map(|axis| {
                let place = rest % 3;
                rest /= 3;
                let (stride, length) = (self.strides[axis] as isize, self.lengths[axis] as isize);
                let around = (length - 1) * stride;
                [if place == 2 { -around } else { stride }, if place == 1 { around } else { -stride }]
            })
            .collect();
        let sum = |digits: &[i8; MOST_AXES], with_behind: bool| {
            let step = |(axis, steps): (usize, &[isize; 2])| match digits[axis] {
                1 if with_behind => steps[0],
                -1 => steps[1],
                _ => 0,
            };
            steps.iter().enumerate().map(step).sum()
        };
        Star {
            vertices: self.codes.digits.iter().map(|digits| sum(digits, true)).collect(),
            bases: self.codes.digits.iter().map(|digits| sum(digits, false)).collect(),
        }
    }

    pub(super) fn axes(&self) -> usize {
        self.lengths.len()
    }

    pub(super) fn vertex_count(&self) -> usize {
        self.lengths.iter().product()
    }

    /// The number of places of cells: for each vertex one for each choice of axes along which a cell extends behind it.
    pub(super) fn cell_count(&self) -> usize {
        self.vertex_count() << self.axes()
    }

    /// How things lie around a vertex.
    pub(super) fn star(&self, vertex: usize) -> &Star {
        if self.stars.len() == 1 {
            return &self.stars[0];
        }
        let mut pattern = 0;
        for axis in (0..self.lengths.len()).rev() {
            let at = vertex / self.strides[axis] % self.lengths[axis];
            let place = match at {
                _ if !self.is_periodic[axis] => 0,
                0 => 1,
                _ if at + 1 == self.lengths[axis] => 2,
                _ => 0,
            };
            pattern = 3 * pattern + place;
        }
        &self.stars[pattern]
    }

    /// The vertex opposite to this one in a cell of its star.
    pub(super) fn opposite(star: &Star, vertex: usize, code: Code) -> usize {
        vertex.wrapping_add_signed(star.vertices[code as usize])
    }

    /// The place of a cell of the star of a vertex.
    pub(super) fn place(&self, star: &Star, vertex: usize, code: Code) -> usize {
        let base = vertex.wrapping_add_signed(star.bases[code as usize]);
        base << self.axes() | self.codes.extents[code as usize] as usize
    }

    /// The first vertex of a cell of the star of a vertex.
    pub(super) fn base(star: &Star, vertex: usize, code: Code) -> usize {
        vertex.wrapping_add_signed(star.bases[code as usize])
    }

    /// The place of the cell that extends behind a vertex along all axes.
    pub(super) fn top_place(&self, base: usize) -> usize {
        (base << self.axes()) | ((1 << self.axes()) - 1)
    }

    /// The next vertex behind or before this one along an axis.
    pub(super) fn next(&self, vertex: usize, axis: usize, side: i8) -> usize {
        let star = self.star(vertex);
        Self::opposite(star, vertex, self.codes.extended(0, axis, side))
    }

    /// The number of vertices along the last axis.
    pub(super) fn row_length(&self) -> usize {
        self.lengths.last().copied().unwrap_or(1)
    }

    /// Whether an axis is periodic.
    pub(super) fn is_periodic(&self) -> bool {
        self.is_periodic.contains(&true)
    }

    /// Where the voxel of a vertex lies along an axis; -1 and the number of voxels in the layer around.
    pub(super) fn along(&self, vertex: usize, axis: usize) -> i64 {
        let margin = i64::from(!self.is_periodic[axis]);
        (vertex / self.strides[axis] % self.lengths[axis]) as i64 - margin
    }

    /// The first vertex of the cell at a place, and a bit for each axis along which the cell extends.
    pub(super) fn first_vertex(&self, place: usize) -> (usize, usize) {
        (place >> self.axes(), place & ((1 << self.axes()) - 1))
    }

    /// The vertex of a voxel, by its number in the image.
    pub(super) fn vertex_of_voxel(&self, voxel: usize) -> usize {
        let (mut rest, mut vertex) = (voxel, 0);
        for axis in (0..self.lengths.len()).rev() {
            let margin = usize::from(!self.is_periodic[axis]);
            let length = self.lengths[axis] - 2 * margin;
            vertex += (rest % length + margin) * self.strides[axis];
            rest /= length;
        }
        vertex
    }

    /// The number of the voxel of a vertex, which is not in the layer around.
    pub(super) fn voxel_of_vertex(&self, vertex: usize) -> usize {
        (0..self.lengths.len()).fold(0, |voxel, axis| {
            let margin = usize::from(!self.is_periodic[axis]);
            let at = vertex / self.strides[axis] % self.lengths[axis] - margin;
            voxel * (self.lengths[axis] - 2 * margin) + at
        })
    }
}
