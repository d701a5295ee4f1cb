"""What questions answer with where that is a dictionary."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, TypeAlias, TypedDict

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from coface._coface import Chain, Homology

#: What JSON holds: facts in the words of the program.
Json: TypeAlias = "dict[str, Json] | list[Json] | str | int | float | bool | None"
#: A group that is infinite has the order 0 in lists of orders.
Orders = list[int]


class SurfacePart(TypedDict):
    """What a component of a surface is."""

    #: Its name, such as ``torus``; ``None`` where it is no surface.
    name: str | None
    orientable: bool | None
    #: The genus; of a component that cannot be oriented the number of cross-caps.
    genus: int | None
    boundary_loops: int
    euler_characteristic: int
    f_vector: tuple[int, int, int]


# The first key is a word of Python.
CycleClass = TypedDict(
    "CycleClass",
    {
        "degree": int,
        "class": list[int],
        "orders": Orders,
        "bounds": bool,
        "multiple": "int | None",
        "bounding": "Chain | None",
        "cocycle": "Chain | None",
        "value": "int | None",
    },
)

#: A cocycle as pairs of a coefficient and vertices.
Terms = list[tuple[int, list[int]]]


class CupTable(TypedDict):
    """Cup products of two bases."""

    #: ``table[i][j]``: the coefficients of the product of class i and class j.
    table: list[list[list[int]]]
    first: list[Terms]
    second: list[Terms]
    target: list[Terms]
    first_orders: Orders
    second_orders: Orders
    target_orders: Orders


class IntersectionForm(TypedDict):
    """The pairing of the middle cohomology of a closed oriented manifold."""

    matrix: NDArray[np.int64]
    rank: int
    determinant: int
    symmetric: bool
    signature: int | None
    parity: str | None
    definiteness: str | None
    name: str | None
    basis: list[Terms]


class GroupMap(TypedDict):
    """A map of homology groups by its matrix: columns are images of generators."""

    matrix: NDArray[np.int64]
    source_orders: Orders
    target_orders: Orders
    kernel: str
    cokernel: str


class ExactSequence(TypedDict):
    """The long exact sequence of a pair: groups, and for each degree the maps between them."""

    part: Homology
    whole: Homology
    pair: Homology
    inclusion: list[GroupMap | None]
    projection: list[GroupMap | None]
    connecting: list[GroupMap | None]


class Exactness(TypedDict, total=False):
    """Whether a cochain of degree 1 is closed and exact, and what shows it."""

    closed: bool
    exact: bool
    potential: NDArray[np.int64] | NDArray[np.float64]
    walk: list[int]
    period: int | float
    face: list[int]
    sum: int | float


class Witness(TypedDict):
    """Cells that show why something is no manifold."""

    kind: str
    cells: list[list[int]]
    message: str


class Problem(TypedDict):
    """What is wrong with a model, and where."""

    kind: str
    count: int
    message: str
    cells: list[list[int]]
    top_cells: list[list[int]]
    points: list[list[float]]


class Remark(TypedDict):
    """What was assumed or left out."""

    code: str
    message: str
    count: int | None
    places: list[Json]


# The second key is a word of Python.
ComparedWalk = TypedDict(
    "ComparedWalk",
    {
        "contractible": bool,
        "bounds": bool,
        "class": list[int],
        "component": "int | None",
        "word": list[int],
        "homotopic": list[int],
        "freely_homotopic": list[int],
    },
)


class SetComparison(TypedDict):
    """How far two sets of the plane are from each other."""

    area_xor: float | None
    area_xor_error: float | None
    area_signed: float | None
    area_signed_error: float | None
    hausdorff: float | None
    hausdorff_error: float | None
    along_normals: float | None
    along_normals_error: float | None
    normals_left_out: float | None
    curvature: float | None
    curvature_error: float | None
    components: list[int]
    holes: list[int]
    files: list[str]
    remarks: list[Remark]


class CurveSamples(TypedDict):
    """Points along curves, as columns."""

    piece: NDArray[np.int64]
    parameter: NDArray[np.float64]
    length: NDArray[np.float64]
    point: NDArray[np.float64]
    tangent: NDArray[np.float64]
    curvature: NDArray[np.float64]


class BoundarySamples(CurveSamples):
    """Points along the boundary of a set, as columns."""

    curve: NDArray[np.int64]


class EdgeSamples(CurveSamples):
    """Points along the edges of an interface, as columns."""

    edge: NDArray[np.int64]
    left: NDArray[np.int64]
    right: NDArray[np.int64]


class BendPlace(TypedDict):
    """A place on a curve, and a curvature or an angle in degrees there."""

    piece: int
    parameter: float
    point: list[float]
    value: float


class CurveBend(TypedDict):
    """How a curve of a boundary bends."""

    curve: int
    least: BendPlace
    greatest: BendPlace
    sharpest: BendPlace
    roughest: BendPlace | None


class EdgeBend(TypedDict):
    """How an edge of an interface bends."""

    edge: int
    left: int | None
    right: int | None
    least: BendPlace
    greatest: BendPlace
    sharpest: BendPlace | None


class CellCounts(TypedDict):
    """How many cells of a grid a set leaves empty, cuts and fills."""

    empty: int
    cut: int
    full: int


class ManifoldFacts(TypedDict):
    """Whether a result is a manifold, with a witness if not."""

    verdict: Literal["yes", "no", "unknown"]
    closed: bool | None
    witness: Witness | None
