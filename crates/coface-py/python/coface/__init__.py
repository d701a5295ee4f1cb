"""Exact computational topology of meshes and cell complexes.

A file, arrays or an object of another library become a :class:`Model` (:func:`read`, :func:`as_model`). A model reports what it is
(:meth:`Model.report`), and makes a :class:`ChainComplex`, of which homology and everything else is asked.

* Ids count from 0. Arrays of ids are integers; coordinates are ``float64`` with a row for each vertex.
* The boundary matrix of degree k has a column for each k-cell and a row for each (k-1)-cell.
* Nothing here has a tolerance but where one is an argument.
* Faults are :class:`Error`: they name the place, the fault and the cure, and carry cells as data.

Examples
--------
>>> import coface
>>> torus = coface.generate("torus")
>>> torus.report().name
'torus'
>>> coface.homology(torus)
Homology(Z, Z^2, Z)
"""

from coface._coface import (
    AssumptionWarning,
    BoundaryOfBoundaryError,
    Chain,
    ChainComplex,
    Cocycles,
    CoefficientError,
    Complex,
    Congruence,
    Cover,
    CuboidGrid,
    Curve,
    CutCells,
    Domain,
    Error,
    FileError,
    FundamentalGroup,
    Generator,
    Homology,
    HomologyGroup,
    InvalidInputError,
    InvalidTypeError,
    Kinks,
    LarModel,
    Model,
    NoSuchPlaceError,
    NonManifoldError,
    NotAComplexError,
    NotACycleError,
    NotInComplexError,
    NotPureError,
    OutOfRangeError,
    ParseError,
    Persistence,
    PlanarArrangement,
    PlanarBoolean,
    Report,
    ShapeError,
    Simplices,
    SimplicialGrid,
    SolidBoolean,
    SpatialArrangement,
    Surface,
    TooLargeError,
    UnsupportedFormatError,
    Verdict,
    YinSet,
    __version__,
    entries,
    families,
    generate,
    invariant_factors,
    matrix_svg,
    read,
)
from coface._batch import BatchRow, BatchSummary, batch
from coface._chains import (
    classes,
    cup_products,
    decompose,
    extruded,
    induced_map,
    intersection_form,
    is_exact,
    laplacian,
    long_exact_sequence,
    matching,
    product,
)
from coface._models import as_chain_complex, as_complex, as_model, as_surface
from coface._models import geo_interface as _geo_interface
from coface._questions import (
    arrange,
    boolean,
    classify,
    cocycles,
    cohomology,
    congruence,
    cover,
    cut,
    dissolve,
    harmonic,
    homology,
    incidence,
    persistence,
    pi1,
    polygon,
)
from coface import _faults, _records
from coface._notebook import repr_html as _repr_html
from coface._view import page, render, view
from coface._volumes import volume

# The adapters import the names above.
from coface._buildings import (  # isort: skip
    CellEdge,
    CellGraph,
    CellNode,
    from_ifcopenshell,
    from_topologic,
    to_topologic,
)
from coface._doors import (  # isort: skip
    from_gudhi,
    from_meshio,
    from_networkx,
    from_open3d,
    from_pymeshlab,
    from_pyvista,
    from_shapely,
    from_trimesh,
    to_geopandas,
    to_gudhi,
    to_meshio,
    to_networkx,
    to_open3d,
    to_pymeshlab,
    to_pyvista,
    to_shapely,
    to_trimesh,
)
from coface.interop.skimage import from_labels
from coface._plot import plot
from coface._plot import plot_method as _plot_method

__all__ = [
    "AssumptionWarning",
    "BatchRow",
    "BatchSummary",
    "BoundaryOfBoundaryError",
    "CellEdge",
    "CellGraph",
    "CellNode",
    "Chain",
    "ChainComplex",
    "Cocycles",
    "CoefficientError",
    "Complex",
    "Congruence",
    "Cover",
    "CuboidGrid",
    "Curve",
    "CutCells",
    "Domain",
    "Error",
    "FileError",
    "FundamentalGroup",
    "Generator",
    "Homology",
    "HomologyGroup",
    "InvalidInputError",
    "InvalidTypeError",
    "Kinks",
    "LarModel",
    "Model",
    "NoSuchPlaceError",
    "NonManifoldError",
    "NotAComplexError",
    "NotACycleError",
    "NotInComplexError",
    "NotPureError",
    "OutOfRangeError",
    "ParseError",
    "Persistence",
    "PlanarArrangement",
    "PlanarBoolean",
    "Report",
    "ShapeError",
    "Simplices",
    "SimplicialGrid",
    "SolidBoolean",
    "SpatialArrangement",
    "Surface",
    "TooLargeError",
    "UnsupportedFormatError",
    "Verdict",
    "YinSet",
    "__version__",
    "arrange",
    "as_chain_complex",
    "as_complex",
    "as_model",
    "as_surface",
    "batch",
    "boolean",
    "classes",
    "classify",
    "cocycles",
    "cohomology",
    "congruence",
    "cover",
    "cup_products",
    "cut",
    "decompose",
    "dissolve",
    "entries",
    "extruded",
    "families",
    "from_gudhi",
    "from_ifcopenshell",
    "from_labels",
    "from_meshio",
    "from_networkx",
    "from_open3d",
    "from_pymeshlab",
    "from_pyvista",
    "from_shapely",
    "from_topologic",
    "from_trimesh",
    "generate",
    "harmonic",
    "homology",
    "incidence",
    "induced_map",
    "intersection_form",
    "invariant_factors",
    "is_exact",
    "laplacian",
    "long_exact_sequence",
    "matching",
    "matrix_svg",
    "page",
    "persistence",
    "pi1",
    "plot",
    "polygon",
    "product",
    "read",
    "render",
    "to_geopandas",
    "to_gudhi",
    "to_meshio",
    "to_networkx",
    "to_open3d",
    "to_pymeshlab",
    "to_pyvista",
    "to_shapely",
    "to_topologic",
    "to_trimesh",
    "view",
    "volume",
]

_records.install()

# What notebooks and plots need stands here, so that the compiled part knows neither.
for _shown in (
    Chain,
    ChainComplex,
    Cocycles,
    Complex,
    Congruence,
    Cover,
    CutCells,
    Domain,
    FundamentalGroup,
    Generator,
    Homology,
    HomologyGroup,
    Model,
    Persistence,
    PlanarArrangement,
    PlanarBoolean,
    Report,
    Simplices,
    SolidBoolean,
    SpatialArrangement,
    Surface,
    Verdict,
    YinSet,
):
    setattr(_shown, "_repr_html_", _repr_html)
    if _shown not in (Report, Verdict):
        setattr(_shown, "plot", _plot_method)
del _shown
setattr(Model, "__geo_interface__", property(_geo_interface))

# Faults in arguments of what is compiled are faults of this package.
_faults.compiled_in_words(globals())
