# Signatures and types by hand, docstrings by `python stubs.py --write`: with them it is longer than other files.
import os
from collections.abc import Callable, ItemsView, Iterable, Iterator, KeysView, Mapping, Sequence, ValuesView
from typing import IO, Any, TypeAlias, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from scipy.sparse import csc_array, csr_array

from coface._buildings import CellGraph
from coface._models import Repaired, RepairedSurface, Subdivided
from coface._types import (
    BoundarySamples,
    CellCounts,
    ComparedWalk,
    CupTable,
    CurveBend,
    CycleClass,
    EdgeBend,
    EdgeSamples,
    ExactSequence,
    Exactness,
    GroupMap,
    IntersectionForm,
    Json,
    ManifoldFacts,
    Problem,
    Remark,
    SetComparison,
    SurfacePart,
    Witness,
)

# What `progress` may be: whether a bar is shown, or a function that is called with (stage, done, total).
_Progress: TypeAlias = bool | Callable[[str, int, int], object] | None
# Lists of ids: an array of shape (m, k) where all have one length, else (flat, offsets).
_Ids: TypeAlias = NDArray[np.int32] | NDArray[np.int64]
# A path, or a file that is open.
_File: TypeAlias = str | os.PathLike[str] | IO[Any]
_Lists: TypeAlias = _Ids | tuple[_Ids, NDArray[np.int64]]

__version__: str

class Error(Exception):
    """A fault in data or in a request: it names the place, the fault and the cure.

    Parameters
    ----------
    message
        What is wrong.

    Attributes
    ----------
    kind : str
        What sort of fault it is: the name of the class without ``Error``.
    message : str
        The fault alone, without place and cure.
    cure : str or None
        What to do about it.
    cells : list of list of int
        The cells it is about, each by the numbers of its vertices.
    file : str or None
        The file it is in.
    line : int or None
        The line, from 1.
    byte : int or None
        The byte, from 0.
    """
    message: str
    cure: str | None
    cells: list[list[int]]
    file: str | None
    line: int | None
    byte: int | None
    def __init__(
        self,
        message: str = "",
        *,
        fault: str | None = None,
        cure: str | None = None,
        cells: Sequence[Sequence[int]] = (),
        file: str | None = None,
        line: int | None = None,
        byte: int | None = None,
    ) -> None: ...
    @property
    def kind(self) -> str:
        """What sort of fault it is."""
        ...
    def __reduce__(self) -> tuple[Any, ...]: ...

class FileError(Error, OSError): ...
class ParseError(Error, ValueError): ...
class UnsupportedFormatError(Error, ValueError): ...
class InvalidInputError(Error, ValueError): ...
class InvalidTypeError(InvalidInputError, TypeError): ...
class OutOfRangeError(InvalidInputError, OverflowError): ...
class NotInComplexError(Error, LookupError): ...
class NoSuchPlaceError(NotInComplexError, IndexError): ...
class NotAComplexError(Error, ValueError): ...
class NotPureError(Error, ValueError): ...
class BoundaryOfBoundaryError(Error, ValueError): ...
class NotACycleError(Error, ValueError): ...
class ShapeError(Error, ValueError): ...
class TooLargeError(Error, OverflowError): ...
class NonManifoldError(Error, ValueError): ...
class CoefficientError(Error, ValueError): ...
class NotInstalledError(Error, ImportError):
    """Another library is needed, and it cannot be imported; the cure installs it."""
    def __init__(
        self, message: str = "", *, fault: str | None = None, cure: str | None = None, library: str | None = None, **place: Any
    ) -> None: ...
class AssumptionWarning(UserWarning): ...

@final
class Chain:
    """An integral chain or cochain: cells with coefficients.

    Made by :meth:`ChainComplex.chain` and by questions whose answers are chains.
    """
    def _repr_html_(self) -> str: ...
    def plot(self, **options: Any) -> Any:
        """Draw this with matplotlib: :func:`plot` with the same options."""
        ...
    @property
    def degree(self) -> int:
        """The degree of its cells."""
        ...
    @property
    def is_cochain(self) -> bool:
        """Whether it is a cochain."""
        ...
    @property
    def coefficients(self) -> NDArray[np.int64] | NDArray[np.object_]:
        """The coefficients: ``int64``, objects where one is larger."""
        ...
    @property
    def cells(self) -> NDArray[np.int64]:
        """The cells with a coefficient, rising, by their numbers in the complex."""
        ...
    @property
    def simplices(self) -> _Lists:
        """The vertices of those cells: an array of shape (m, k + 1), or ``(flat, offsets)`` where cells have different numbers of vertices.

        The order of the vertices is the orientation that the coefficient is for. Cells that are not named by vertices have their own
        number instead.
        """
        ...
    def as_vector(self) -> csc_array:
        """All coefficients as a column: one row for each cell of the degree.

        Returns
        -------
        scipy.sparse.csc_array
            Shape (cells, 1), ``int64``.
        """
        ...
    def terms(self) -> list[tuple[int, list[int]]]:
        """The chain as ``(coefficient, vertices)``, cell by cell."""
        ...
    def to_dict(self) -> dict[str, Json]:
        """The chain as a dictionary: ``degree``, ``cochain``, ``cell_count``, ``cells`` and ``chain``, pairs of a coefficient and vertices."""
        ...
    @staticmethod
    def from_dict(chain: Mapping[str, Any]) -> Chain:
        """The chain that :meth:`to_dict` wrote."""
        ...
    @property
    def model(self) -> Model | None:
        """The model on whose cells it is; ``None`` where cells are numbers only."""
        ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    def __len__(self) -> int: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __add__(self, other: Chain | Generator | int, /) -> Chain: ...
    def __radd__(self, other: Chain | Generator | int, /) -> Chain: ...
    def __sub__(self, other: Chain | Generator | int, /) -> Chain: ...
    def __rsub__(self, other: Chain | Generator | int, /) -> Chain: ...
    def __neg__(self) -> Chain: ...
    def __mul__(self, factor: int, /) -> Chain: ...
    def __rmul__(self, factor: int, /) -> Chain: ...
    def __matmul__(self, chain: Chain | Generator, /) -> int: ...
    def __rmatmul__(self, cochain: Chain | Generator, /) -> int: ...
    def value(self, chain: Chain | Generator) -> int:
        """The value of a cochain on a chain of the same degree: the sum of the products of their coefficients. ``cochain @ chain`` is the same.

        Parameters
        ----------
        chain : Chain or Generator
            A chain of the same complex.

        Returns
        -------
        int
            The value.
        """
        ...
    def __hash__(self) -> int: ...
    def __repr__(self) -> str: ...

@final
class ChainComplex:
    """A chain complex: for each degree a number of cells, and their boundaries as sparse integer matrices.

    Made by :meth:`Model.chain_complex`, :meth:`Complex.chain_complex` or from matrices. That the boundary of a boundary is zero is
    checked when it is made.
    """
    def _repr_html_(self) -> str: ...
    def plot(self, **options: Any) -> Any:
        """Draw this with matplotlib: :func:`plot` with the same options."""
        ...
    @staticmethod
    def from_boundaries(boundaries: Sequence[Any]) -> ChainComplex:
        """A chain complex from its boundary matrices.

        Parameters
        ----------
        boundaries : sequence of sparse arrays or array_like
            The matrices of degrees 1, 2, ...: column j is the boundary of cell j.

        Returns
        -------
        ChainComplex
            Its cells are named by their numbers.

        Raises
        ------
        BoundaryOfBoundaryError
            If the product of two of them is not zero.
        ShapeError
            If they do not fit together.
        """
        ...
    @staticmethod
    def of_points(count: int) -> ChainComplex:
        """So many points and nothing else."""
        ...
    @property
    def f_vector(self) -> tuple[int, ...]:
        """The numbers of cells of the degrees 0, 1, ..."""
        ...
    @property
    def dimension(self) -> int | None:
        """The highest degree with cells; ``None`` of the empty complex."""
        ...
    @property
    def euler_characteristic(self) -> int:
        """The alternating sum of the numbers of cells."""
        ...
    def cell_count(self, degree: int) -> int:
        """The number of cells of a degree."""
        ...
    def boundary(self, degree: int) -> csc_array:
        """The boundary matrix from degree k to k - 1, on the memory of the complex: column j is the boundary of cell j.

        Parameters
        ----------
        degree : int
            The degree k, at least 1; 0 of a reduced complex.

        Returns
        -------
        scipy.sparse.csc_array
            ``int32`` entries and indices, which cannot be written to: arithmetic on them makes new arrays.
        """
        ...
    def coboundary(self, degree: int) -> csc_array:
        """The coboundary matrix from degree k to k + 1: the transpose of the boundary matrix of degree k + 1."""
        ...
    def simplices(self, degree: int) -> _Lists:
        """The vertices of the cells of a degree: an array of shape (m, k + 1), or ``(flat, offsets)``."""
        ...
    def homology(self, coefficients: str | int = ..., *, generators: bool = False, progress: _Progress = ...) -> Homology:
        """Homology.

        Parameters
        ----------
        coefficients : str or int
            ``"z"``, ``"q"``, ``"f2"``, ``"z/4"``, or a modulus.
        generators : bool
            Whether short cycles that generate the groups are wanted.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).

        Returns
        -------
        Homology
            A group for each degree.
        """
        ...
    def cohomology(self, coefficients: str | int = ..., *, generators: bool = False, progress: _Progress = ...) -> Homology:
        """Cohomology; parameters as those of :meth:`homology`."""
        ...
    def chain(self, terms: Any, degree: int | None = None) -> Chain:
        """A chain.

        Parameters
        ----------
        terms : sequence of (int, cell), vector, or str
            Coefficients and cells, a cell being its vertices in the order of its orientation, or its number; or one number for each cell; or the
            name of a group of the mesh, whose elements count as often as they stand there, turned ones negatively.
        degree : int, optional
            The degree, where cells are numbers.

        Returns
        -------
        Chain
            The chain.
        """
        ...
    def cochain(self, terms: Any, degree: int | None = None) -> Chain:
        """A cochain; parameters as those of :meth:`chain`."""
        ...
    def boundary_of(self, chain: Any, degree: int | None = None) -> Chain:
        """The boundary of a chain."""
        ...
    def coboundary_of(self, cochain: Any, degree: int | None = None) -> Chain:
        """The coboundary of a cochain."""
        ...
    def product(self, other: ChainComplex) -> ChainComplex:
        """The product of two chain complexes.

        Parameters
        ----------
        other : ChainComplex
            The second factor.

        Returns
        -------
        ChainComplex
            Cells are pairs of cells; the boundary is that of Leibniz.
        """
        ...
    def to_dict(self) -> dict[str, Json]:
        """This as a dictionary of JSON: ``recipe`` says how it is made again by ``from_dict``."""
        ...
    @classmethod
    def from_dict(cls, facts: Mapping[str, Any]) -> ChainComplex:
        """The answer that ``to_dict()`` wrote."""
        ...
    @property
    def source(self) -> Model | None:
        """The model that it was made of, whose vertices name its cells; ``None`` where cells are numbers only."""
        ...
    def __mul__(self, other: ChainComplex, /) -> ChainComplex: ...
    def __rmul__(self, other: ChainComplex, /) -> ChainComplex: ...
    def direct_sum(self, other: ChainComplex) -> ChainComplex:
        """Both complexes side by side; also ``+``."""
        ...
    def __add__(self, other: ChainComplex, /) -> ChainComplex: ...
    def __radd__(self, other: ChainComplex, /) -> ChainComplex: ...
    def model(self) -> Model:
        """The complex as a model, for files."""
        ...
    def __len__(self) -> int: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __repr__(self) -> str: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Cocycles:
    """A basis of the first cohomology of a surface, dual to loops.

    Made by :meth:`Surface.cocycles`.
    """
    def certificate(self, path: str | os.PathLike[str] | Sequence[str | os.PathLike[str]], *, progress: _Progress = ...) -> str:
        """A proof of this answer, which :func:`coface.check` verifies without any code of what computed it.

        Parameters
        ----------
        path
            Where the input of the answer is written, which the certificate is about: ``.json``, ``.off`` or ``.obj``; ``.txt`` for points, ``.npy`` for an
            image, ``.wkt`` for a drawing. An answer of several inputs takes a path for each. A file that is there already must hold just that.
        progress
            As for :func:`homology`.

        Returns
        -------
        str
            JSON, to be kept beside the file. The checker has accepted it already.

        Raises
        ------
        InvalidInputError
            For an answer that does not know its input, such as one that was pickled; for options that no certificate proves; for a path where
            something else is. :func:`coface.certificate` asks of files.
        """
        ...
    def _repr_html_(self) -> str: ...
    def plot(self, **options: Any) -> Any:
        """Draw this with matplotlib: :func:`plot` with the same options."""
        ...
    @property
    def rank(self) -> int:
        """The rank of the first cohomology over the integers."""
        ...
    @property
    def method(self) -> str:
        """How cocycles were found."""
        ...
    @property
    def pairing(self) -> list[list[int]]:
        """The value of cocycle i on loop j."""
        ...
    @property
    def determinant(self) -> int | None:
        """Its determinant."""
        ...
    @property
    def loops(self) -> list[list[int]]:
        """The loops, each a list of vertices, the first one again at the end."""
        ...
    @property
    def intersection(self) -> list[list[int]] | None:
        """How often loops cross each other, with signs, on closed oriented surfaces."""
        ...
    @property
    def weights(self) -> str | None:
        """The weights of harmonic forms: ``cotangent`` or ``uniform``."""
        ...
    @property
    def closed_residuals(self) -> list[float] | None:
        """The largest sum of each harmonic form around a face."""
        ...
    @property
    def coclosed_residuals(self) -> list[float] | None:
        """The largest weighted sum of each harmonic form at a vertex."""
        ...
    def to_dict(self) -> dict[str, Json]:
        """The answer as a dictionary, in the words of the program's JSON, and how it was made: ``recipe``, which ``from_dict`` reads."""
        ...
    @property
    def cocycles(self) -> list[Chain]:
        """The cocycles, integral cochains of degree 1."""
        ...
    @property
    def harmonic(self) -> NDArray[np.float64] | None:
        """The harmonic forms, if they were asked for: ``float64``, shape (rank, edges)."""
        ...
    @classmethod
    def from_dict(cls, facts: Mapping[str, Any]) -> Cocycles:
        """The answer that ``to_dict()`` wrote."""
        ...
    def __hash__(self) -> int: ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __len__(self) -> int: ...
    def __repr__(self) -> str: ...

@final
class Complex:
    """A simplicial complex: simplices by their vertices, closed under faces, of any dimension.

    Vertices are any ids; simplices are listed in lexicographic order. Complexes do not change; what edits gives a new one.

    Parameters
    ----------
    facets : array_like of int, optional
        Simplices that make it up with their faces: an array of shape (m, k), a list of lists, or ``(flat, offsets)``.
    """
    def _repr_html_(self) -> str: ...
    def plot(self, **options: Any) -> Any:
        """Draw this with matplotlib: :func:`plot` with the same options."""
        ...
    def __new__(cls, facets: Any = None, *, progress: _Progress = ...) -> Complex: ...
    @property
    def f_vector(self) -> tuple[int, ...]:
        """The numbers of simplices of the dimensions 0, 1, ..."""
        ...
    @property
    def dimension(self) -> int | None:
        """The highest dimension; ``None`` of the empty complex."""
        ...
    @property
    def euler_characteristic(self) -> int:
        """The alternating sum of the numbers of simplices."""
        ...
    @property
    def vertices(self) -> NDArray[np.int64]:
        """The vertices, rising: ``int64``."""
        ...
    def simplices(self, dimension: int) -> _Lists:
        """The simplices of a dimension, in lexicographic order.

        Parameters
        ----------
        dimension : int
            The dimension k.

        Returns
        -------
        numpy.ndarray
            ``int64``, shape (m, k + 1); row i is cell i of the chain complex.
        """
        ...
    def facets(self) -> list[NDArray[np.int64]]:
        """The simplices that are no faces of others, as a list of arrays by dimension.

        Returns
        -------
        list of numpy.ndarray
            Those of dimension k at place k, shape (m, k + 1).
        """
        ...
    def index(self, simplex: ArrayLike) -> int | None:
        """The place of a simplex among those of its dimension; ``None`` if it is not there."""
        ...
    def star(self, of: Any) -> Simplices:
        """The simplices that have one of these as a face.

        Parameters
        ----------
        of : array_like of int
            One simplex, ``[0, 1]``, or several, ``[[0, 1], [3]]``.

        Returns
        -------
        Simplices
            The star; it need not be closed.

        Raises
        ------
        NotInComplexError
            If one is not there; ``.cells`` has it.
        """
        ...
    def closed_star(self, of: Any) -> Complex:
        """The simplices of the star with all their faces."""
        ...
    def closure(self, of: Any) -> Complex:
        """The simplices with all their faces: the smallest complex that holds them."""
        ...
    def link(self, of: Any) -> Complex:
        """The closure of the star without the star of the closure.

        Parameters
        ----------
        of : array_like of int
            One simplex or several.

        Returns
        -------
        Complex
            The link; of a vertex of a closed surface a cycle.
        """
        ...
    def boundary_complex(self, of: Any = None) -> Complex:
        """The complex of the facets that lie in just one simplex of the highest dimension.

        Parameters
        ----------
        of : array_like of int, optional
            A pure subcomplex instead of the whole.

        Returns
        -------
        Complex
            The boundary.

        Raises
        ------
        NotPureError
            If the simplices are not those of a pure complex.
        """
        ...
    def interior(self, of: Any = None) -> Simplices:
        """The simplices that are not in the boundary."""
        ...
    def skeleton(self, k: int) -> Complex:
        """The simplices of dimension ``k`` and lower."""
        ...
    def induced(self, vertices: ArrayLike) -> Complex:
        """The simplices all of whose vertices are among these."""
        ...
    def union(self, other: Complex) -> Complex:
        """The simplices of both complexes; also ``|``."""
        ...
    def intersection(self, other: Complex) -> Complex:
        """The simplices that both complexes have; also ``&``."""
        ...
    def difference(self, other: Any) -> Simplices:
        """The simplices of this complex that the other does not have; also ``-``. They need not be a complex."""
        ...
    def is_subcomplex(self, of: Complex) -> bool:
        """Whether every simplex is in the other complex; also ``<=``."""
        ...
    def to_dict(self) -> dict[str, Json]:
        """This as a dictionary of JSON: ``recipe`` says how it is made again by ``from_dict``."""
        ...
    @classmethod
    def from_dict(cls, facts: Mapping[str, Any]) -> Complex:
        """The answer that ``to_dict()`` wrote."""
        ...
    def __or__(self, other: Complex, /) -> Complex: ...
    def __ror__(self, other: Complex, /) -> Complex: ...
    def __and__(self, other: Complex, /) -> Complex: ...
    def __rand__(self, other: Complex, /) -> Complex: ...
    def __sub__(self, other: Any, /) -> Simplices: ...
    def __rsub__(self, other: Any, /) -> Simplices: ...
    def components(self) -> list[NDArray[np.int64]]:
        """The vertex sets of the connected components."""
        ...
    def strong_components(self) -> list[NDArray[np.int64]]:
        """The facets of dimension d, joined where they share a facet: one array of shape (m, d + 1) for each strong component."""
        ...
    def is_pure(self) -> Verdict:
        """Whether every simplex is a face of one of the highest dimension.

        Returns
        -------
        Verdict
            ``True`` or ``False`` in conditions; ``.cells`` has a facet of lower dimension.
        """
        ...
    def is_manifold(self, *, progress: _Progress = ...) -> Verdict:
        """Whether every point has a neighborhood like space or half-space.

        Returns
        -------
        Verdict
            ``True`` or ``False`` in conditions, where it could be decided; ``.cells`` has the simplices that show why not.
        """
        ...
    def is_orientable(self, *, progress: _Progress = ...) -> Verdict:
        """Whether the simplices of the highest dimension can be oriented so that neighbors agree.

        Returns
        -------
        Verdict
            ``True`` or ``False`` in conditions; if not, ``.cells`` is an odd cycle of facets, each the neighbor of the one before.
        """
        ...
    def orientation(self, *, progress: _Progress = ...) -> NDArray[np.int64] | None:
        """Signs of the simplices of the highest dimension that orient them coherently; ``None`` where there are none.

        Returns
        -------
        numpy.ndarray or None
            1 or -1 for each row of ``simplices(dimension)``: -1 reverses the order of its vertices.
        """
        ...
    def disjoint_union(self, other: Complex) -> Complex:
        """Both complexes side by side; vertices of the other get new numbers."""
        ...
    def wedge(self, at: int, other: Complex, other_at: int) -> Complex:
        """Both complexes with a vertex of one and a vertex of the other made one."""
        ...
    def join(self, other: Complex) -> Complex:
        """The simplices of both, and every simplex of one with every simplex of the other."""
        ...
    def cone(self) -> tuple[Complex, int]:
        """Every simplex joined with one new vertex.

        Returns
        -------
        complex : Complex
            The cone.
        apex : int
            The new vertex.
        """
        ...
    def suspension(self) -> tuple[Complex, list[int]]:
        """Two cones on the complex.

        Returns
        -------
        complex : Complex
            The suspension.
        apexes : list of int
            The two new vertices.
        """
        ...
    def connected_sum(self, facet: ArrayLike, other: Complex, other_facet: ArrayLike) -> Complex:
        """Both complexes without a facet each, glued along the rims."""
        ...
    def barycentric_subdivision(self) -> tuple[Complex, list[list[int]]]:
        """The barycentric subdivision.

        Returns
        -------
        complex : Complex
            A vertex for each simplex.
        simplices : list of list of int
            The simplex of each vertex.
        """
        ...
    def product(self, other: Complex) -> tuple[Complex, NDArray[np.int64]]:
        """The product, its cells cut into simplices along staircases; also ``*``.

        Returns
        -------
        complex : Complex
            The product.
        vertices : numpy.ndarray of shape (n, 2)
            The pair of vertices that each vertex is.
        """
        ...
    def __mul__(self, other: Complex, /) -> Complex: ...
    def __rmul__(self, other: Complex, /) -> Complex: ...
    def chain_complex(self, *, progress: _Progress = ...) -> ChainComplex:
        """The chain complex; cell i of degree k is row i of ``simplices(k)``."""
        ...
    def model(self) -> Model:
        """The facets as a model, for files and questions about models."""
        ...
    def incidence(self, dimension: int, *, signed: bool = False) -> csc_array:
        """Which simplices of dimension k - 1 are facets of which of dimension k.

        Parameters
        ----------
        dimension : int
            The dimension k.
        signed : bool
            Whether entries are 1 and -1, as in a boundary matrix, or 1.

        Returns
        -------
        scipy.sparse.csc_array
            One row for each (k - 1)-simplex, one column for each k-simplex.
        """
        ...
    def __contains__(self, simplex: Any, /) -> bool: ...
    def __len__(self) -> int: ...
    def __iter__(self) -> Iterator[list[int]]: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __le__(self, other: Complex, /) -> bool: ...
    def __ge__(self, other: Complex, /) -> bool: ...
    def __repr__(self) -> str: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Congruence:
    """Models merged within a tolerance: vertices nearby become one, and edges, faces and cells with them.

    Made by :func:`congruence`.
    """
    def certificate(self, path: str | os.PathLike[str] | Sequence[str | os.PathLike[str]], *, progress: _Progress = ...) -> str:
        """A proof of this answer, which :func:`coface.check` verifies without any code of what computed it.

        Parameters
        ----------
        path
            Where the input of the answer is written, which the certificate is about: ``.json``, ``.off`` or ``.obj``; ``.txt`` for points, ``.npy`` for an
            image, ``.wkt`` for a drawing. An answer of several inputs takes a path for each. A file that is there already must hold just that.
        progress
            As for :func:`homology`.

        Returns
        -------
        str
            JSON, to be kept beside the file. The checker has accepted it already.

        Raises
        ------
        InvalidInputError
            For an answer that does not know its input, such as one that was pickled; for options that no certificate proves; for a path where
            something else is. :func:`coface.certificate` asks of files.
        """
        ...
    def _repr_html_(self) -> str: ...
    def plot(self, **options: Any) -> Any:
        """Draw this with matplotlib: :func:`plot` with the same options."""
        ...
    @property
    def f_vector_before(self) -> list[int]:
        """The numbers of cells before."""
        ...
    @property
    def f_vector(self) -> list[int]:
        """The numbers of cells after."""
        ...
    @property
    def classes(self) -> list[int]:
        """The numbers of classes by degree."""
        ...
    @property
    def largest_class_diameter(self) -> float:
        """The largest distance of vertices that became one."""
        ...
    @property
    def discarded(self) -> list[int]:
        """How many cells vanished, by degree."""
        ...
    @property
    def products_zero(self) -> bool:
        """Whether products of boundary matrices are zero, found by multiplying."""
        ...
    def to_dict(self) -> dict[str, Json]:
        """The answer as a dictionary, in the words of the program's JSON, and how it was made: ``recipe``, which ``from_dict`` reads."""
        ...
    def class_of(self, degree: int) -> NDArray[np.int64]:
        """The class of each cell of a degree: ``int64``, -1 for cells that vanished or became several classes."""
        ...
    def matrix(self, degree: int) -> csc_array:
        """The chain map onto the quotient: column j is the signed sum of classes that cell j became."""
        ...
    @property
    def vertices(self) -> NDArray[np.float64]:
        """The positions of the classes of vertices."""
        ...
    def chain_complex(self) -> ChainComplex:
        """The chain complex of the quotient."""
        ...
    def model(self, *, progress: _Progress = ...) -> Model:
        """The merged mesh.

        Raises
        ------
        UnsupportedFormatError
            If its cells are no polygons and 3-cells any more; :meth:`chain_complex` has them.
        """
        ...
    @classmethod
    def from_dict(cls, facts: Mapping[str, Any]) -> Congruence:
        """The answer that ``to_dict()`` wrote."""
        ...
    @property
    def cells(self) -> Model:
        """The cells of the quotient as a chain complex with positions: what ``.json`` holds, and what homology and other questions about cells
        are asked of.
        """
        ...
    def to_bytes(self, format: str) -> bytes:
        """The quotient as a file of this format: ``json`` has the cells, others the merged mesh."""
        ...
    def write(self, path: _File, format: str | None = None) -> None:
        """Writes the quotient to a file, by its path or open for writing: ``.json`` has the cells, others the merged mesh."""
        ...
    def __hash__(self) -> int: ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __repr__(self) -> str: ...

@final
class Cover:
    """A part of a universal cover: copies of a domain, glued.

    Made by :meth:`Surface.cover`.
    """
    def certificate(self, path: str | os.PathLike[str] | Sequence[str | os.PathLike[str]], *, progress: _Progress = ...) -> str:
        """A proof of this answer, which :func:`coface.check` verifies without any code of what computed it.

        Parameters
        ----------
        path
            Where the input of the answer is written, which the certificate is about: ``.json``, ``.off`` or ``.obj``; ``.txt`` for points, ``.npy`` for an
            image, ``.wkt`` for a drawing. An answer of several inputs takes a path for each. A file that is there already must hold just that.
        progress
            As for :func:`homology`.

        Returns
        -------
        str
            JSON, to be kept beside the file. The checker has accepted it already.

        Raises
        ------
        InvalidInputError
            For an answer that does not know its input, such as one that was pickled; for options that no certificate proves; for a path where
            something else is. :func:`coface.certificate` asks of files.
        """
        ...
    def _repr_html_(self) -> str: ...
    def plot(self, **options: Any) -> Any:
        """Draw this with matplotlib: :func:`plot` with the same options."""
        ...
    @property
    def component(self) -> int:
        """The component that is covered."""
        ...
    @property
    def surface(self) -> str:
        """What it is."""
        ...
    @property
    def group(self) -> str:
        """The name of its fundamental group."""
        ...
    @property
    def copies(self) -> int:
        """The number of copies."""
        ...
    @property
    def complete(self) -> bool:
        """Whether it is the whole cover."""
        ...
    @property
    def spheres(self) -> list[int]:
        """The number of copies at each word length."""
        ...
    @property
    def f_vector(self) -> list[int]:
        """The numbers of vertices, edges and faces."""
        ...
    @property
    def euler_characteristic(self) -> int:
        """Vertices - edges + faces: 1 of a disk."""
        ...
    @property
    def letters(self) -> list[list[int]]:
        """The edges of the surface, by their vertices, that letters cross."""
        ...
    @property
    def words(self) -> list[list[int]]:
        """The word of each copy: letters are 1, 2, .. and their inverses -1, -2, .."""
        ...
    @property
    def layout(self) -> str | None:
        """Where copies were put: ``flat``, ``disk``, ``klein`` or ``None`` for over the surface."""
        ...
    def to_dict(self) -> dict[str, Json]:
        """The answer as a dictionary, in the words of the program's JSON, and how it was made: ``recipe``, which ``from_dict`` reads."""
        ...
    @property
    def model(self) -> Model:
        """The cover as a model; its data ``source``, ``copy`` and ``length`` say what lies below."""
        ...
    @classmethod
    def from_dict(cls, facts: Mapping[str, Any]) -> Cover:
        """The answer that ``to_dict()`` wrote."""
        ...
    def __hash__(self) -> int: ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __repr__(self) -> str: ...

@final
class CuboidGrid:
    """A grid of cuboids of any dimension: cells are products of intervals and points, their faces index arithmetic.

    Parameters
    ----------
    shape : sequence of int, optional
        The numbers of unit intervals along the axes.
    lengths : sequence of sequence of float, optional
        The lengths of the intervals of each axis instead, negative where one is empty.
    """
    def to_dict(self) -> dict[str, Json]:
        """This as a dictionary of JSON: ``recipe`` says how it is made again by ``from_dict``."""
        ...
    @classmethod
    def from_dict(cls, facts: Mapping[str, Any]) -> CuboidGrid:
        """The answer that ``to_dict()`` wrote."""
        ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    def _repr_html_(self) -> str: ...
    def __new__(cls, shape: ArrayLike | None = None, *, lengths: Sequence[Sequence[float]] | None = None) -> CuboidGrid: ...
    @property
    def f_vector(self) -> tuple[int, ...]:
        """The numbers of cells of the dimensions 0, 1, ..."""
        ...
    @property
    def dimension(self) -> int | None:
        """The highest dimension of a cell; ``None`` of an empty grid."""
        ...
    def cell(self, dimension: int, cell: int) -> tuple[list[int], list[int]]:
        """The axes along which a cell extends, and its lowest corner."""
        ...
    def number(self, axes: Sequence[int], corner: Sequence[int]) -> int | None:
        """The number of the cell with these axes and this corner; ``None`` if there is none."""
        ...
    def cells(self, dimension: int) -> NDArray[np.int64]:
        """The vertices of the cells of a dimension: ``int64``, shape (m, 2^k)."""
        ...
    def facets(self, dimension: int, cell: int) -> list[tuple[int, int]]:
        """The facets of a cell with signs."""
        ...
    def cofaces(self, dimension: int, cell: int) -> list[tuple[int, int]]:
        """The cells that a cell is a facet of, with signs."""
        ...
    @property
    def vertices(self) -> NDArray[np.float64]:
        """The positions of the vertices: shape (n, d)."""
        ...
    def chain_complex(self, *, progress: _Progress = ...) -> ChainComplex:
        """The chain complex."""
        ...
    def model(self, *, simplices: bool = False) -> Model:
        """The cells of the highest dimension as a model; cut into simplices if ``simplices``."""
        ...
    def __len__(self) -> int: ...
    def __repr__(self) -> str: ...

@final
class Curve:
    """A piecewise polynomial curve of the plane: a polyline or a spline.

    Parameters
    ----------
    points : array_like, shape (n, 2)
        Points on the curve, the first one again at the end of a closed one.
    order : {2, 4, 6, 8}
        2 for polylines, 4 for cubic splines, ..
    ends : {"not-a-knot", "natural", "periodic"}
        What holds at the ends; ``"not-a-knot"`` if it is left out.
    """
    def _repr_html_(self) -> str: ...
    def __new__(cls, points: ArrayLike, order: int = 2, ends: str | None = None) -> Curve: ...
    @staticmethod
    def closed(points: ArrayLike, kinks: ArrayLike | None = None, order: int = 4, ends: str = "not-a-knot") -> Curve:
        """A closed spline through points with kinks at some of them.

        Parameters
        ----------
        points : array_like, shape (n, 2)
            Points, the first one not repeated.
        kinks : array_like of int, optional
            Places of points where the curve may turn; :class:`YinSet` takes them over.
        order : {2, 4, 6, 8}
            The order.
        ends : {"not-a-knot", "natural"}
            What holds at kinks.
        """
        ...
    @staticmethod
    def circle(center: Sequence[float], radius: float, pieces: int = 16, order: int = 4) -> Curve:
        """A circle, counterclockwise."""
        ...
    @staticmethod
    def ellipse(center: Sequence[float], axes: Sequence[float], pieces: int = 16, order: int = 4) -> Curve:
        """An ellipse, counterclockwise."""
        ...
    @property
    def order(self) -> int:
        """The order: the degree of pieces plus 1."""
        ...
    @property
    def pieces(self) -> int:
        """The number of pieces."""
        ...
    @property
    def is_closed(self) -> bool:
        """Whether it ends where it starts."""
        ...
    @property
    def knots(self) -> NDArray[np.float64]:
        """The parameters where pieces meet."""
        ...
    @property
    def kinks(self) -> NDArray[np.int64]:
        """The numbers of the knots where the curve may turn, as :meth:`closed` was told or a :class:`YinSet` has them."""
        ...
    @property
    def controls(self) -> NDArray[np.float64]:
        """The Bezier controls of all pieces: shape (n, 2)."""
        ...
    def points(self, parameters: ArrayLike) -> NDArray[np.float64]:
        """Points at parameters: shape (n, 2)."""
        ...
    def flattened(self, tolerance: float) -> NDArray[np.float64]:
        """A polyline no farther from the curve than this: shape (n, 2)."""
        ...
    @property
    def signed_area(self) -> float:
        """The area that it encloses, positive if it lies to the left."""
        ...
    def length(self, tolerance: float = 1e-12) -> float:
        """The length, to this relative tolerance."""
        ...
    @property
    def bounding_box(self) -> list[list[float]]:
        """``[low, high]`` corners of the smallest box."""
        ...
    def reversed(self) -> Curve:
        """The other way round."""
        ...
    def translated(self, by: Sequence[float]) -> Curve:
        """Moved by a vector."""
        ...
    def rotated(self, degrees: float, center: Sequence[float] = ...) -> Curve:
        """Turned by degrees about a center."""
        ...
    def locate(self, point: Sequence[float]) -> str:
        """``inside``, ``outside`` or ``boundary``: where a point lies of a closed curve."""
        ...
    def to_dict(self) -> dict[str, Json]:
        """This as a dictionary of JSON: ``recipe`` says how it is made again by ``from_dict``."""
        ...
    @classmethod
    def from_dict(cls, facts: Mapping[str, Any]) -> Curve:
        """The answer that ``to_dict()`` wrote."""
        ...
    def __len__(self) -> int: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __repr__(self) -> str: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class CutCells:
    """A set on a Cartesian grid: what of each cell it covers. Arrays have one row of cells a row.

    Made by :meth:`YinSet.cut_cells`.
    """
    def _repr_html_(self) -> str: ...
    def plot(self, **options: Any) -> Any:
        """Draw this with matplotlib: :func:`plot` with the same options."""
        ...
    @property
    def origin(self) -> list[float]:
        """The lower left corner of the grid."""
        ...
    @property
    def spacing(self) -> list[float]:
        """The size of cells."""
        ...
    @property
    def coverage(self) -> NDArray[np.int8]:
        """For each cell -1 empty, 0 cut, 1 full: ``int8``, shape (rows, columns)."""
        ...
    @property
    def areas(self) -> NDArray[np.float64]:
        """The area of the set in each cell: shape (rows, columns)."""
        ...
    @property
    def lengths(self) -> NDArray[np.float64]:
        """The length of the boundary in each cell: shape (rows, columns)."""
        ...
    @property
    def total_area(self) -> float:
        """The area in all cells."""
        ...
    @property
    def total_length(self) -> float:
        """The length of the boundary in all cells."""
        ...
    def to_dict(self) -> dict[str, Json]:
        """The answer as a dictionary, in the words of the program's JSON, and how it was made: ``recipe``, which ``from_dict`` reads."""
        ...
    @classmethod
    def from_dict(cls, facts: Mapping[str, Any]) -> CutCells:
        """The answer that ``to_dict()`` wrote."""
        ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def counts(self) -> CellCounts:
        """How many cells are full, cut and empty."""
        ...
    def __repr__(self) -> str: ...

@final
class Domain:
    """A surface cut open: a disk for each component, and seams.

    Made by :meth:`Surface.cut`.
    """
    def certificate(self, path: str | os.PathLike[str] | Sequence[str | os.PathLike[str]], *, progress: _Progress = ...) -> str:
        """A proof of this answer, which :func:`coface.check` verifies without any code of what computed it.

        Parameters
        ----------
        path
            Where the input of the answer is written, which the certificate is about: ``.json``, ``.off`` or ``.obj``; ``.txt`` for points, ``.npy`` for an
            image, ``.wkt`` for a drawing. An answer of several inputs takes a path for each. A file that is there already must hold just that.
        progress
            As for :func:`homology`.

        Returns
        -------
        str
            JSON, to be kept beside the file. The checker has accepted it already.

        Raises
        ------
        InvalidInputError
            For an answer that does not know its input, such as one that was pickled; for options that no certificate proves; for a path where
            something else is. :func:`coface.certificate` asks of files.
        """
        ...
    def _repr_html_(self) -> str: ...
    def plot(self, **options: Any) -> Any:
        """Draw this with matplotlib: :func:`plot` with the same options."""
        ...
    @property
    def components(self) -> list[dict[str, Json]]:
        """For each component ``surface``, ``f_vector``, ``cut_edges``, ``boundary_edges``, ``seams``, ``word``, ``relator`` and more."""
        ...
    @property
    def f_vector(self) -> list[int]:
        """The numbers of vertices, edges and faces of the opened surface."""
        ...
    @property
    def simplified(self) -> bool:
        """Whether the graph was made short."""
        ...
    @property
    def roles(self) -> dict[str, Json] | None:
        """The edges by ``tree``, ``cotree`` and ``generators``; ``None`` unless they were asked for."""
        ...
    @property
    def refinement(self) -> dict[str, Json] | None:
        """Of a canonical cut the ``f_vector`` of the refined surface and its new ``vertices``, each with the vertices ``of`` the file whose mean it is by ``weights``."""
        ...
    @property
    def layout(self) -> dict[str, Json] | None:
        """Of a layout its ``plane`` and ``weights``, whether it is ``texture``, and how many of its ``triangles`` are ``turned`` over; else ``None``."""
        ...
    @property
    def path(self) -> dict[str, Json] | None:
        """Of a cut along a path its ``kind`` and number of ``edges``."""
        ...
    def to_dict(self) -> dict[str, Json]:
        """The answer as a dictionary, in the words of the program's JSON, and how it was made: ``recipe``, which ``from_dict`` reads."""
        ...
    @property
    def model(self) -> Model:
        """The opened surface: its lines are the seams, with the data ``seam`` and ``source``; vertices have ``source``."""
        ...
    @classmethod
    def from_dict(cls, facts: Mapping[str, Any]) -> Domain:
        """The answer that ``to_dict()`` wrote."""
        ...
    def __hash__(self) -> int: ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __repr__(self) -> str: ...

@final
class FundamentalGroup:
    """The fundamental group of a component: generators, which are loops at a base, and relators.

    Words are lists of letters: 1, 2, .. for generators and -1, -2, .. for their inverses.
    """
    def certificate(self, path: str | os.PathLike[str] | Sequence[str | os.PathLike[str]], *, progress: _Progress = ...) -> str:
        """A proof of this answer, which :func:`coface.check` verifies without any code of what computed it.

        Parameters
        ----------
        path
            Where the input of the answer is written, which the certificate is about: ``.json``, ``.off`` or ``.obj``; ``.txt`` for points, ``.npy`` for an
            image, ``.wkt`` for a drawing. An answer of several inputs takes a path for each. A file that is there already must hold just that.
        progress
            As for :func:`homology`.

        Returns
        -------
        str
            JSON, to be kept beside the file. The checker has accepted it already.

        Raises
        ------
        InvalidInputError
            For an answer that does not know its input, such as one that was pickled; for options that no certificate proves; for a path where
            something else is. :func:`coface.certificate` asks of files.
        """
        ...
    def _repr_html_(self) -> str: ...
    def plot(self, **options: Any) -> Any:
        """Draw this with matplotlib: :func:`plot` with the same options."""
        ...
    def __new__(cls, generators: int, relators: Sequence[Sequence[int]] = ..., *, time_limit: float | None = None) -> FundamentalGroup: ...
    @property
    def base(self) -> int | None:
        """The vertex that loops start from."""
        ...
    @property
    def generators(self) -> int:
        """The number of generators."""
        ...
    @property
    def relators(self) -> list[list[int]]:
        """The relators as lists of letters."""
        ...
    @property
    def name(self) -> str | None:
        """What the group is called, where it was recognized."""
        ...
    @property
    def order(self) -> int | None:
        """The number of elements, where the group was recognized as a finite one; ``None`` where it is infinite or not recognized."""
        ...
    @property
    def loops(self) -> list[NDArray[np.int64]]:
        """The loops of the generators, each an array of vertices, the first one again at the end."""
        ...
    @property
    def abelianization(self) -> HomologyGroup:
        """The group made commutative: the first homology."""
        ...
    def subgroups(self, highest: int, *, time_limit: float | None = None, progress: _Progress = ...) -> list[tuple[int, int]] | None:
        """How many subgroups there are of each index, and how many classes of conjugate ones.

        Parameters
        ----------
        highest : int
            The highest index.
        time_limit : float, optional
            Seconds.

        Returns
        -------
        list of (int, int) or None
            Subgroups and classes of index 1, 2, ..; ``None`` if the time was too short.
        """
        ...
    def homomorphisms(self, group: str, points: int, *, time_limit: float | None = None, progress: _Progress = ...) -> tuple[int, int] | None:
        """How many homomorphisms there are to a group of permutations, and how many of them are onto.

        Parameters
        ----------
        group : {"S", "A"}
            Symmetric or alternating.
        points : int
            The number of points that are permuted.
        time_limit : float, optional
            Seconds.

        Returns
        -------
        (int, int) or None
            All, and those onto.
        """
        ...
    def index(self, words: Sequence[Sequence[int]] = ..., limit: int = 100000, *, progress: _Progress = ...) -> int | None:
        """The index of the subgroup that words generate, by enumeration of cosets.

        Parameters
        ----------
        words : sequence of sequence of int
            Generators of the subgroup; none for the trivial one, whose index is the order of the group.
        limit : int
            The number of cosets that are followed.

        Returns
        -------
        int or None
            The index; ``None`` if the limit was reached.
        """
        ...
    def simplified(self, *, time_limit: float | None = None, progress: _Progress = ...) -> FundamentalGroup:
        """The same group with a shorter presentation."""
        ...
    def to_dict(self) -> dict[str, Json]:
        """This as a dictionary of JSON: ``recipe`` says how it is made again by ``from_dict``."""
        ...
    @classmethod
    def from_dict(cls, facts: Mapping[str, Any]) -> FundamentalGroup:
        """The answer that ``to_dict()`` wrote."""
        ...
    @property
    def model(self) -> Model | None:
        """The model that the loops run in; ``None`` of a group that was made of words."""
        ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __len__(self) -> int: ...
    def __str__(self) -> str: ...
    def __repr__(self) -> str: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Generator:
    """A cycle, or a cocycle, that generates a cyclic part of a group."""
    def _repr_html_(self) -> str: ...
    def plot(self, **options: Any) -> Any:
        """Draw this with matplotlib: :func:`plot` with the same options."""
        ...
    @property
    def order(self) -> int | None:
        """The order; ``None`` where no multiple is zero."""
        ...
    @property
    def degree(self) -> int:
        """The degree."""
        ...
    @property
    def chain(self) -> Chain:
        """The cycle or cocycle."""
        ...
    @property
    def certificate(self) -> Chain | None:
        """Of a cycle of finite order m, a chain whose boundary is m times the cycle."""
        ...
    @property
    def length(self) -> int:
        """How many cells it runs through, with multiplicity."""
        ...
    @property
    def coefficients(self) -> NDArray[np.int64] | NDArray[np.object_]:
        """The coefficients: ``int64``, objects where one is larger."""
        ...
    @property
    def cells(self) -> NDArray[np.int64]:
        """The cells by their numbers."""
        ...
    @property
    def simplices(self) -> _Lists:
        """The vertices of the cells: an array of shape (m, k + 1), or ``(flat, offsets)``."""
        ...
    @property
    def loop(self) -> NDArray[np.int64] | None:
        """Of a cycle of degree 1 its vertices in order, the first one again at the end: ``int64``. ``None`` of other degrees, of cocycles, and
        of cycles that are no single closed walk.
        """
        ...
    def as_vector(self) -> csc_array:
        """All coefficients as a sparse column."""
        ...
    def to_dict(self) -> dict[str, Json]:
        """The generator as a dictionary, as :meth:`Homology.to_dict` has it."""
        ...
    @staticmethod
    def from_dict(generator: Mapping[str, Any]) -> Generator:
        """The generator that :meth:`to_dict` wrote."""
        ...
    @property
    def model(self) -> Model | None:
        """The model on whose cells it is; ``None`` where cells are numbers only."""
        ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __add__(self, other: Chain | Generator | int, /) -> Chain: ...
    def __radd__(self, other: Chain | Generator | int, /) -> Chain: ...
    def __sub__(self, other: Chain | Generator | int, /) -> Chain: ...
    def __rsub__(self, other: Chain | Generator | int, /) -> Chain: ...
    def __neg__(self) -> Chain: ...
    def __mul__(self, factor: int, /) -> Chain: ...
    def __rmul__(self, factor: int, /) -> Chain: ...
    def __matmul__(self, chain: Chain | Generator, /) -> int: ...
    def __rmatmul__(self, cochain: Chain | Generator, /) -> int: ...
    def value(self, chain: Chain | Generator) -> int:
        """The value of a cochain on a chain of the same degree: the sum of the products of their coefficients. ``cochain @ chain`` is the same.

        Parameters
        ----------
        chain : Chain or Generator
            A chain of the same complex.

        Returns
        -------
        int
            The value.
        """
        ...
    def __hash__(self) -> int: ...
    def __len__(self) -> int: ...
    def __repr__(self) -> str: ...

@final
class Homology:
    """Homology or cohomology: a group for each degree.

    Made by :meth:`ChainComplex.homology`. ``homology[k]`` is the group of degree k.
    """
    def certificate(self, path: str | os.PathLike[str] | Sequence[str | os.PathLike[str]], *, progress: _Progress = ...) -> str:
        """A proof of this answer, which :func:`coface.check` verifies without any code of what computed it.

        Parameters
        ----------
        path
            Where the input of the answer is written, which the certificate is about: ``.json``, ``.off`` or ``.obj``; ``.txt`` for points, ``.npy`` for an
            image, ``.wkt`` for a drawing. An answer of several inputs takes a path for each. A file that is there already must hold just that.
        progress
            As for :func:`homology`.

        Returns
        -------
        str
            JSON, to be kept beside the file. The checker has accepted it already.

        Raises
        ------
        InvalidInputError
            For an answer that does not know its input, such as one that was pickled; for options that no certificate proves; for a path where
            something else is. :func:`coface.certificate` asks of files.
        """
        ...
    def _repr_html_(self) -> str: ...
    def plot(self, **options: Any) -> Any:
        """Draw this with matplotlib: :func:`plot` with the same options."""
        ...
    @property
    def groups(self) -> tuple[HomologyGroup, ...]:
        """The groups of the degrees 0, 1, ..."""
        ...
    @property
    def betti_numbers(self) -> tuple[int, ...]:
        """The ranks of the free parts."""
        ...
    @property
    def torsion(self) -> tuple[tuple[int, ...], ...]:
        """The orders of the finite parts, one tuple a degree, each order dividing the next."""
        ...
    @property
    def is_cohomology(self) -> bool:
        """Whether it is cohomology."""
        ...
    @property
    def euler_characteristic(self) -> int:
        """The alternating sum of the Betti numbers."""
        ...
    @property
    def coefficients(self) -> str:
        """The ring of coefficients: ``"Z"``, ``"Q"``, ``"Z/2"``, ..."""
        ...
    def to_dict(self) -> list[dict[str, Json]]:
        """The groups as ``coface homology --json`` prints them.

        A group that is not integral also has ``coefficients``, one of cohomology ``cohomology``, and one with generators ``generators``:
        ``order`` (0 is infinite), ``length``, ``chain`` as pairs of a coefficient and vertices, ``cells`` and, of a cycle of finite order,
        ``bounding``. :meth:`from_dict` reads all of it back.
        """
        ...
    @staticmethod
    def from_dict(groups: Iterable[Mapping[str, Any]]) -> Homology:
        """The groups that :meth:`to_dict` wrote."""
        ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    def __getitem__(self, degree: int, /) -> HomologyGroup: ...
    def __iter__(self) -> Iterator[HomologyGroup]: ...
    def __len__(self) -> int: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __repr__(self) -> str: ...

@final
class HomologyGroup:
    """A group of one degree: a free part over the ring of coefficients, of rank :attr:`betti`, and cyclic groups of finite orders."""
    def _repr_html_(self) -> str: ...
    def plot(self, **options: Any) -> Any:
        """Draw this with matplotlib: :func:`plot` with the same options."""
        ...
    @property
    def degree(self) -> int:
        """The degree."""
        ...
    @property
    def betti(self) -> int:
        """The rank of the free part."""
        ...
    @property
    def torsion(self) -> tuple[int, ...]:
        """The orders of the finite part, each dividing the next."""
        ...
    @property
    def generators(self) -> tuple[Generator, ...]:
        """The generators, if they were asked for: those of finite order in the order of :attr:`torsion`, and the free ones."""
        ...
    @property
    def coefficients(self) -> str:
        """The ring of coefficients: ``"Z"``, ``"Q"``, ``"Z/2"``, ..."""
        ...
    @property
    def is_cohomology(self) -> bool:
        """Whether it is a group of cohomology."""
        ...
    @property
    def is_trivial(self) -> bool:
        """Whether it is the group of one element."""
        ...
    def to_dict(self) -> dict[str, Json]:
        """The group as a dictionary: one entry of :meth:`Homology.to_dict`."""
        ...
    @staticmethod
    def from_dict(group: Mapping[str, Any]) -> HomologyGroup:
        """The group that :meth:`to_dict` wrote."""
        ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __str__(self) -> str: ...
    def __repr__(self) -> str: ...

@final
class Interface:
    """Sets of the plane as phases that share the arcs between them: edges, junctions, areas, lengths and neighbors.

    Made by :func:`interface`.
    """
    def _repr_html_(self) -> str: ...
    def _picture(self, title: str, format: str, size: tuple[int, int], transparent: bool) -> bytes: ...
    def plot(self, **options: Any) -> Any:
        """Draw this with matplotlib: :func:`plot` with the same options."""
        ...
    @property
    def order(self) -> int:
        """The order of the edges."""
        ...
    @property
    def phases(self) -> list[dict[str, Json]]:
        """For each phase ``name``, ``area``, ``perimeter``, ``components``, ``holes`` and ``neighbors``."""
        ...
    @property
    def vertices(self) -> list[list[float]]:
        """The positions of the vertices, a list of [x, y]."""
        ...
    @property
    def edges(self) -> list[dict[str, Json]]:
        """For each edge ``ends``, the phases on its ``left`` and ``right`` (``None`` outside), ``length``, ``pieces``, ``knots`` and ``controls``."""
        ...
    @property
    def junctions(self) -> list[dict[str, Json]]:
        """For each junction ``vertex``, ``point``, ``degree``, ``smooth_pairs``, ``kind``, and ``edges`` and ``phases`` counterclockwise."""
        ...
    @property
    def smooth_pairs(self) -> list[list[list[int]]] | None:
        """The pairs of edges that go on smoothly into each other, each as (edge, direction): 1 as it runs, -1 against that."""
        ...
    @property
    def length(self) -> float | None:
        """The length of all edges, each once; ``None`` where it overflows."""
        ...
    @property
    def remarks(self) -> list[Remark]:
        """What was assumed, changed or left out, each a dictionary with ``code``, ``message``, ``count`` and ``places``; a warning said so too."""
        ...
    @property
    def names(self) -> list[str]:
        """The names of the phases."""
        ...
    @property
    def areas(self) -> list[float]:
        """The areas of the phases; ``inf`` for one that is not bounded."""
        ...
    @property
    def lengths(self) -> list[float]:
        """The lengths of the edges."""
        ...
    @property
    def neighbors(self) -> list[tuple[int, int, float]]:
        """Pairs of phases that have an edge in common, the lower number first, with the length of their common edges.

        Returns
        -------
        list of (int, int, float)
            What lies outside of all phases is no phase.
        """
        ...
    @staticmethod
    def read(path: _File, *, rule: str | None = None) -> Interface:
        """The interface in a file that :meth:`write` or ``coface yin interface -o`` wrote.

        Parameters
        ----------
        path : path-like
            A ``.json`` file.
        rule : {"nonzero", "evenodd", "positive"}, optional
            What is inside of edges that cross: they are cut and pasted by it, and the interface is in its unique form. Left out, edges that cross are an
            error.

        Returns
        -------
        Interface
            The same interface, bit for bit unless there is a rule.
        """
        ...
    def write(self, path: _File) -> None:
        """Writes the interface to a ``.json`` file, by its path or open for writing, with the control points of all edges."""
        ...
    def phase(self, name: str | int) -> YinSet:
        """The phase with this name, or with this number if none has the name, as a set.

        Parameters
        ----------
        name : str or int
            Its name or its number, from 0.

        Returns
        -------
        YinSet
            Its neighbors have the same pieces along their common edges.
        """
        ...
    def locate(self, points: ArrayLike) -> tuple[NDArray[np.int64], dict[str, Json]]:
        """Where points lie: in which phase, on an edge, or in no phase.

        Parameters
        ----------
        points : array_like of shape (n, 2)
            The points.

        Returns
        -------
        phases : ndarray of shape (n,) and type int64
            The number of the phase that each point lies in, -1 for points in no phase, -2 for points on an edge.
        facts : dict
            ``phases`` (each with its ``name`` and the number of points ``inside``), ``boundary``, ``outside``, and for each of ``points`` its
            ``location``, ``phases`` (of a point on an edge those that meet there), ``distance``, ``nearest`` point of the edges, ``edge``,
            ``piece`` and ``parameter``.
        """
        ...
    def sample(
        self, *, per_piece: int | None = ..., count: int | None = ..., spacing: float | None = ...
    ) -> EdgeSamples: ...
    def curvature(self) -> list[EdgeBend]:
        """How the edges bend: the least and the greatest curvature of each, and where it turns most at a knot between its ends.

        Returns
        -------
        list of dict
            For each edge ``edge``, the phases on its ``left`` and ``right``, ``least`` and ``greatest`` (curvatures, positive where the edge turns
            left) and ``sharpest`` (in degrees; ``None`` without a knot between its ends), each with ``piece``, ``parameter``, ``point`` and ``value``.
        """
        ...
    def transformed(self, matrix: ArrayLike, offset: tuple[float, float] = ...) -> Interface:
        """The image under an affine map of the plane: each edge once, so that phases keep their common arcs.

        Parameters
        ----------
        matrix : array_like of shape (2, 2)
            The matrix of the map, by rows. It has an inverse.
        offset : (float, float)
            Where the origin goes.

        Returns
        -------
        Interface
            The phases of all ``matrix @ point + offset``, with their names.
        """
        ...
    def normalized(self) -> Interface:
        """The interface in its unique form: edges that go on smoothly where nothing else ends become one, knots within straight parts of polylines are left
        out, and edges and vertices come in one order. Interfaces of order 2 whose phases have the same points have the same edges then.

        Returns
        -------
        Interface
            With the same phases and junctions.
        """
        ...
    def fit(self, order: int | None = None, *, kinks: str | float | Sequence[tuple[int, int]] | None = None) -> Interface:
        """Splines through the knots of the edges, smooth but for junctions and kinks. Each edge is fitted once, so phases keep their common edges.

        Parameters
        ----------
        order : {2, 4, 6, 8}, optional
            The order; that of the edges, and 4 at least, if left out.
        kinks : "none", "all", float, or list of (int, int), optional
            Where edges may turn: nowhere but at junctions, at all knots, where polylines turn by more degrees, or at these (edge, knot); at the kinks that there
            are, if left out.

        Returns
        -------
        Interface
            With the same phases and junctions.
        """
        ...
    @property
    def kinks(self) -> dict[int, tuple[int, int]]:
        """The kinks: vertices at which two edges end that do not go on smoothly into each other. A dictionary from vertices to ``(edge, knot)``, one of the
        two ways to name the knot there. Junctions are no kinks.
        """
        ...
    def insert_kink(self, edge: int, knot: int) -> tuple[Interface, int]:
        """The interface with one more kink; its edge is cut into two there.

        Parameters
        ----------
        edge : int
            The number of the edge.
        knot : int
            The number of the knot on it, 0 where it begins.

        Returns
        -------
        interface : Interface
            The splines beside the kink fitted again; phases on both sides have it.
        vertex : int
            The vertex of the kink.
        """
        ...
    def insert_kink_near(self, point: ArrayLike) -> tuple[Interface, int]:
        """The interface with one more kink, at the knot that is nearest to a point; junctions are left out.

        Parameters
        ----------
        point : array_like, shape (2,)
            The point.

        Returns
        -------
        interface : Interface
            The splines beside the kink fitted again.
        vertex : int
            The vertex of the kink.
        """
        ...
    def erase_kink(self, vertex: int) -> tuple[Interface, int]:
        """The interface without a kink; its two edges become one. Vertices and edges with higher numbers get lower ones.

        Parameters
        ----------
        vertex : int
            The vertex of the kink.

        Returns
        -------
        interface : Interface
            The splines beside the kink fitted again.
        vertex : int
            The vertex that the kink had.
        """
        ...
    def erase_kink_near(self, point: ArrayLike) -> tuple[Interface, int]:
        """The interface without the kink that is nearest to a point.

        Parameters
        ----------
        point : array_like, shape (2,)
            The point.

        Returns
        -------
        interface : Interface
            The splines beside the kink fitted again.
        vertex : int
            The vertex that the kink had.
        """
        ...
    def reset_kinks(self, kinks: str | float | Sequence[tuple[int, int]]) -> Interface:
        """The interface with these kinks and no others: ``"none"``, ``"all"``, an angle in degrees, or pairs (edge, knot)."""
        ...
    def cut_cells(self, counts: tuple[int, int] = ..., *, origin: ArrayLike | None = None, spacing: ArrayLike | None = None, progress: _Progress = ...) -> list[CutCells]:
        """The phases on one Cartesian grid. What they have of a cell adds up.

        Parameters
        ----------
        counts : (int, int)
            Columns and rows.
        origin : (float, float), optional
            The lower left corner; of the box around all edges, if left out.
        spacing : (float, float), optional
            The size of cells; so that this box is covered, if left out.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).

        Returns
        -------
        list of CutCells
            What each phase has of the cells, in the order of the phases.
        """
        ...
    def compare(self, other: Interface) -> dict[str, Json]:
        """How far the phases are from those of another interface; namesakes are compared with each other.

        Parameters
        ----------
        other : Interface
            With the same names, or as many phases.

        Returns
        -------
        dict
            ``area_xor`` (the sum over all phases), ``area_xor_error``, ``junctions`` of both, and ``phases``, each with ``numbers`` and what
            :meth:`YinSet.compare` says.
        """
        ...
    def sets(self) -> list[YinSet]:
        """The phases as sets, in their order; neighbors have the same pieces along their common edges.

        Returns
        -------
        list of YinSet
            They give the same interface again.
        """
        ...
    def advected(self, flow: str | Callable[..., Any], end: float | None = None, *, step: float | None = None, spacing: float | None = None, period: float = 4.0, vortices: int = 4, velocity: Sequence[float] = ..., center: Sequence[float] = ..., speed: float = 1.0, verify: str = "each-step", repair: str | None = None, scheme: str | None = None, parameters: str | None = None, least_ratio: float = 0.1, turn: float | None = None, keep_small: bool = False, events: bool = False, event_tolerance: float | None = None, on_contact: str | None = None, contact_distance: float | None = None, progress: _Progress = ...) -> tuple[Interface, dict[str, Json]]:
        """The interface after it moved with a flow: phases keep their common arcs, and junctions stay junctions.

        Parameters
        ----------
        flow : str or callable
            As for :meth:`YinSet.advected`.
        end : float, optional
            The time at the end; the period, or 1.
        step : float, optional
            The time step; a hundredth of the time if left out.
        spacing : float, optional
            The largest distance of points along edges; a hundredth of the size if left out.
        period : float
            Of vortex and deformation.
        vortices : int
            Of deformation.
        velocity : (float, float)
            Of translation.
        center : (float, float)
            Of rotation.
        speed : float
            Of rotation.
        verify : {"each-step", "end", "never"}
            When it is checked that edges do not cross.
        repair : {"nonzero", "evenodd", "positive"}, optional
            The rule by which edges that cross are cut and pasted, instead of refused.
        scheme : {"midpoint", "classical", "verner", "cooper-verner"}, optional
            The Runge-Kutta scheme, of order 2, 4, 6 or 8; that of the order of the edges if left out.
        parameters : {"lengths", "kept"}, optional
            What the parameters of splines are: the distances of neighbors, as in cubic MARS, or those that knots had at the beginning, which are
            more exact by far unless the velocity jumps along the boundary. Lengths in orders 2 and 4, kept in orders 6 and 8, if left out.
        least_ratio : float
            The least distance of points along edges as a part of ``spacing``, up to 1/3.
        turn : float, optional
            Points are added where the polygon through them turns by more degrees.
        keep_small : bool
            Keep closed edges that become short beside ``spacing``. Otherwise they leave the interface, with an :class:`AssumptionWarning`.
        events : bool
            List the changes of the topology, with times that are narrowed down within steps.
        event_tolerance : float, optional
            How exactly these times are found; a thousandth of the step if left out.
        on_contact : {"keep", "merge"}, optional
            What to do where edges come nearer to each other than ``contact_distance``: ``"merge"`` lets what is beyond them come together, a phase with
            itself, and two phases by an edge that they get in common; ``"keep"`` goes on with the edges as they are, with an
            :class:`AssumptionWarning`, and is an error only if they cross at the end. Left out, contacts are not looked for. Events are listed too.
        contact_distance : float, optional
            The least distance of points along edges if left out. With ``"merge"`` components of phases whose mean width is below half of it go to the
            phase that they have most of their boundary in common with.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).

        Returns
        -------
        interface : Interface
            The interface, with the same phases.
        facts : dict
            ``steps``, ``added``, ``removed``, ``vanished``, ``repairs``, and ``events``: ``None`` unless asked for, else dictionaries with
            ``time``, ``kind``, ``words``, ``place``, ``phases``, ``before`` and ``after``, as ``coface yin advect --events`` gives them.
        """
        ...
    def __len__(self) -> int: ...
    def to_dict(self) -> dict[str, Json]:
        """The interface as a dictionary, in the words of the program's JSON, with what it is made of in ``recipe``, which ``from_dict`` reads."""
        ...
    @classmethod
    def from_dict(cls, facts: Mapping[str, Any]) -> Interface:
        """The answer that ``to_dict()`` wrote."""
        ...
    def __hash__(self) -> int: ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __repr__(self) -> str: ...

@final
class Kinks:
    """The kinks of a set: knots where its boundary may turn, with names that stay.

    A mapping from names to ``(curve, knot)``: ``dict(kinks)`` has them all.
    """
    @property
    def set(self) -> YinSet:
        """The set that they are of."""
        ...
    def to_dict(self) -> dict[str, Json]:
        """The kinks as a dictionary: ``kinks`` with a name, a curve, a knot and a point each, and ``recipe``, which ``from_dict`` reads."""
        ...
    @classmethod
    def from_dict(cls, facts: Mapping[str, Any]) -> Kinks:
        """The answer that ``to_dict()`` wrote."""
        ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def _repr_html_(self) -> str: ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    @property
    def vertices(self) -> NDArray[np.int64]:
        """The names, in the order of curves and knots."""
        ...
    @property
    def knots(self) -> NDArray[np.int64]:
        """The curves and knots: ``int64``, shape (n, 2)."""
        ...
    @property
    def points(self) -> NDArray[np.float64]:
        """The points: ``float64``, shape (n, 2)."""
        ...
    def __getitem__(self, vertex: int, /) -> tuple[int, int]: ...
    def __contains__(self, vertex: Any, /) -> bool: ...
    def keys(self) -> KeysView[int]:
        """The names."""
        ...
    def values(self) -> ValuesView[tuple[int, int]]:
        """The curves and knots."""
        ...
    def items(self) -> ItemsView[int, tuple[int, int]]:
        """The names, each with its curve and knot."""
        ...
    def get(self, vertex: int, default: tuple[int, int] | None = None) -> tuple[int, int] | None:
        """The curve and the knot of a name, or something else if there is no such kink."""
        ...
    def __iter__(self) -> Iterator[int]: ...
    def __len__(self) -> int: ...
    def __repr__(self) -> str: ...

@final
class LarModel:
    """Cells of each degree as lists of vertices, as in the linear algebraic representation.

    The characteristic matrix of a degree has these lists as rows; operators such as ``VV`` or ``FE`` are products of two of them.

    Parameters
    ----------
    cells : Model, Complex, ChainComplex, or sequence of lists
        A model, or for each degree 1, 2, .. lists of vertices.
    vertex_count : int, optional
        The number of vertices, where lists are given.
    """
    def to_dict(self) -> dict[str, Json]:
        """This as a dictionary of JSON: ``recipe`` says how it is made again by ``from_dict``."""
        ...
    @classmethod
    def from_dict(cls, facts: Mapping[str, Any]) -> LarModel:
        """The answer that ``to_dict()`` wrote."""
        ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    def _repr_html_(self) -> str: ...
    def __new__(cls, cells: Any, vertex_count: int | None = None, *, progress: _Progress = ...) -> LarModel: ...
    @property
    def f_vector(self) -> tuple[int, ...]:
        """The numbers of cells of the degrees 0, 1, ..."""
        ...
    def model(self, *, progress: _Progress = ...) -> Model:
        """The cells as a model: their chain complex, with positions if there are some."""
        ...
    def cells(self, degree: int) -> _Lists:
        """The vertices of the cells of a degree."""
        ...
    def characteristic(self, degree: int) -> csc_array:
        """The characteristic matrix of a degree: one row for each cell, 1 in the columns of its vertices."""
        ...
    def incidence(self, operator: str, kind: str | None = None, *, at_least: int | None = None, exactly: int | None = None, progress: _Progress = ...) -> csr_array:
        """An operator between cells of two degrees.

        Parameters
        ----------
        operator : str
            Rows and columns: two of ``V``, ``E``, ``F``, ``C``, as in ``"FE"``.
        kind : {"counts", "incident", "signed"}, optional
            How many vertices two cells share, 1 where one is a face of the other (adjacent, if both have one degree), or the signs of
            the boundary or coboundary operator. If it is left out, ``"counts"`` between cells of one degree, as in ``FF``, and ``"incident"``
            between those of two, as in ``FE``: what ``coface incidence`` prints.
        at_least : int, optional
            1 where so many vertices are shared, instead of ``kind``.
        exactly : int, optional
            1 where exactly so many vertices are shared, instead of ``kind``.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).

        Returns
        -------
        scipy.sparse.csr_array
            One row for each cell of the first degree. Of ``counts`` between cells of one degree the diagonal is not empty: a cell shares all its
            vertices with itself. ``VV`` counts edges: an entry is the number of edges that join two vertices, the diagonal the number of
            edges at a vertex. ``incident`` has no diagonal.
        """
        ...
    def chain_complex(self, orientation: str = "given", positions: ArrayLike | None = None, *, progress: _Progress = ...) -> ChainComplex:
        """The chain complex: with the signs that the cells came with, or found by spreading signs over facets.

        Parameters
        ----------
        orientation : {"given", "lowest", "coherent", "positive"}
            How cells of the highest degree are oriented: as they came, by their lowest facet, so that neighbors agree, or with a positive
            measure.
        positions : array_like, optional
            Positions of the vertices, where measures decide.

        Returns
        -------
        ChainComplex
            The complex.
        """
        ...
    def product(self, other: LarModel) -> LarModel:
        """The product: cells are pairs of cells; also ``*``."""
        ...
    def __mul__(self, other: LarModel, /) -> LarModel: ...
    def __rmul__(self, other: LarModel, /) -> LarModel: ...
    def __repr__(self) -> str: ...

@final
class Model:
    """What a file holds: vertices with or without positions, polygons, 3-cells, lines, groups, data, or an abstract structure.

    Models do not change; methods that edit give a new one.

    Parameters
    ----------
    vertices : array_like, shape (n, d), optional
        Positions.
    faces : array_like of int, optional
        Polygons: an array of shape (m, k), a list of lists, or ``(flat, offsets)``.
    """
    def _repr_html_(self) -> str: ...
    def plot(self, **options: Any) -> Any:
        """Draw this with matplotlib: :func:`plot` with the same options."""
        ...
    def __new__(cls, vertices: ArrayLike | None = None, faces: Any = None) -> Model: ...
    @staticmethod
    def from_arrays(vertices: ArrayLike | None = None, faces: Any = None, cells: Mapping[str, Any] | None = None, *, vertex_count: int | None = None) -> Model:
        """A model from arrays.

        Parameters
        ----------
        vertices : array_like, shape (n, d), optional
            Positions. Without them the vertices are numbers only.
        faces : array_like of int, optional
            Polygons: an array of shape (m, k), a list of lists, or ``(flat, offsets)``.
        cells : dict of str to array_like, optional
            Cells by kind, in the words of meshio: ``vertex``, ``line``, ``triangle``, ``quad``, ``polygon``, ``tetra``, ``hexahedron``,
            ``wedge``, ``pyramid``.
        vertex_count : int, optional
            How many vertices there are, where there are no positions and the last ones are in no cell.

        Returns
        -------
        Model
            Vertices and cells keep their numbers and order.

        Raises
        ------
        InvalidInputError
            For ids that are no integers, negative or beyond the vertices, repeated vertices, coordinates that are not finite.
        """
        ...
    @staticmethod
    def from_facets(facets: Any) -> Model:
        """A simplicial complex by its facets, of any dimensions; vertices are any ids.

        Parameters
        ----------
        facets : array_like of int
            An array of shape (m, k), a list of lists, or ``(flat, offsets)``.

        Returns
        -------
        Model
            All faces of the facets are meant to be there too.
        """
        ...
    @staticmethod
    def from_halfedges(next: ArrayLike, twin: ArrayLike | Sequence[int | None] | None = None, *, outer: ArrayLike | None = None, vertices: ArrayLike | None = None) -> Model:
        """A surface as permutations of its halfedges.

        Parameters
        ----------
        next : array_like of int
            The next halfedge around the face.
        twin : array_like of int, optional
            The other halfedge of the edge; ``h ^ 1`` if left out. ``None`` or -1 on the boundary, where there is none.
        outer : array_like of int, optional
            The faces that fill boundary loops: orbits of ``next``, numbered by their smallest halfedges.
        vertices : array_like of float, optional
            The position of each vertex: orbits of "twin, then next", numbered by their smallest halfedges.

        Returns
        -------
        Model
            The surface.
        """
        ...
    @staticmethod
    def from_gluings(rows: Sequence[Sequence[tuple[int, Sequence[int]] | None]]) -> Model:
        """Simplices with their facets glued in pairs.

        Parameters
        ----------
        rows : list
            For each simplex and each of its facets ``None`` or ``(neighbor, permutation)``, where the permutation sends vertex i of the
            simplex to a vertex of the neighbor.

        Returns
        -------
        Model
            The gluing table.
        """
        ...
    @staticmethod
    def from_signature(signature: str, dimension: int = 3) -> Model:
        """A gluing table by its isomorphism signature.

        Parameters
        ----------
        signature : str
            The signature.
        dimension : int
            The dimension of the simplices.

        Returns
        -------
        Model
            The gluing table.
        """
        ...
    @staticmethod
    def from_bytes(data: bytes | str, format: str | None = None, *, flatten: float | None = None, strict: bool = False, partial: bool = False, progress: _Progress = ...) -> Model:
        """Reads a model from bytes or text.

        Parameters
        ----------
        data : bytes or str
            What a file would hold.
        format : str, optional
            The format, if it is not to be found out.
        flatten : float, optional
            How far the polylines of curved SVG paths may be from the curves.
        strict, partial : bool
            As those of :func:`read`.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).

        Returns
        -------
        Model
            What the bytes hold.
        """
        ...
    @property
    def vertices(self) -> NDArray[np.float64] | None:
        """The positions of the vertices: ``float64``, shape (n, d), on the memory of the model; ``None`` if it has none. A file may hold
        coordinates that are NaN or infinite; they stand here as they are. Those of a volume are the corners of its voxels, in units of voxels.
        """
        ...
    @property
    def vertex_count(self) -> int:
        """The number of vertices of the file; those that nothing uses count."""
        ...
    @property
    def faces(self) -> _Lists:
        """The polygons: ``int32`` of shape (m, k) on the memory of the model where all have k corners, else ``(flat, offsets)``."""
        ...
    @property
    def lines(self) -> _Lists:
        """The polylines, as :attr:`faces` has the polygons. A closed line has its first vertex again at its end."""
        ...
    @property
    def cells(self) -> dict[str, _Ids]:
        """The 3-cells by kind: ``tetra``, ``hexahedron``, ``wedge``, ``pyramid``, each an array of shape (m, k)."""
        ...
    @property
    def points(self) -> NDArray[np.int64]:
        """The vertices that the file names as points."""
        ...
    @property
    def edges(self) -> _Lists:
        """The edges of all cells: ``int64``, shape (m, 2), in the order of the chain complex."""
        ...
    def simplices(self, degree: int) -> _Lists:
        """The vertices of all cells of a degree, in the order of the chain complex.

        Parameters
        ----------
        degree : int
            The dimension of the cells.

        Returns
        -------
        numpy.ndarray or tuple of numpy.ndarray
            ``int64`` of shape (m, k), or ``(flat, offsets)`` where cells have different numbers of vertices.
        """
        ...
    @property
    def f_vector(self) -> tuple[int, ...]:
        """The numbers of cells of the dimensions 0, 1, ..., faces shared by cells counted once."""
        ...
    @property
    def dimension(self) -> int | None:
        """The highest dimension of a cell; ``None`` of the empty model."""
        ...
    @property
    def euler_characteristic(self) -> int:
        """The alternating sum of the numbers of cells."""
        ...
    @property
    def format(self) -> str | None:
        """The name of the format that the model came from."""
        ...
    @property
    def structure(self) -> str | None:
        """What the file holds instead of vertices and cells: ``facets``, ``halfedges``, ``chains``, ``gluings``, ``volume`` or ``None``."""
        ...
    @property
    def __geo_interface__(self) -> dict[str, Json]: ...
    @property
    def srid(self) -> int | None:
        """The number of the reference system that a map names (``SRID`` of EWKT and EWKB, ``crs`` of GeoJSON), if it has one."""
        ...
    @property
    def crs(self) -> str | None:
        """The reference system that a map names, as :mod:`pyproj` takes it: ``"EPSG:25832"``, the name of another authority such as ``"ESRI:54009"``,
        or WKT.
        """
        ...
    @property
    def facets(self) -> _Lists | None:
        """The facets of a model of facets: an array of shape (m, k) or ``(flat, offsets)``; ``None`` of other models."""
        ...
    @property
    def halfedges(self) -> tuple[NDArray[np.int32], NDArray[np.int32]] | None:
        """The permutations ``(next, twin)`` of a model of halfedges; ``None`` of other models."""
        ...
    @property
    def gluings(self) -> list[list[tuple[int, list[int]] | None]] | None:
        """The rows of a gluing table; ``None`` of other models."""
        ...
    @property
    def voxels(self) -> tuple[NDArray[np.bool_], list[int]] | None:
        """The voxels of a volume, truth values, and the numbers of its axes that close up; ``None`` of other models."""
        ...
    def signature(self) -> str:
        """The isomorphism signature of a gluing table; the same for tables that differ by names only."""
        ...
    @property
    def groups(self) -> list[tuple[str, str, NDArray[np.int64]]]:
        """The named groups of the file: a list of (name, kind, members), kinds being ``vertices``, ``lines``, ``faces``, ``cells``."""
        ...
    @property
    def data(self) -> list[tuple[str, str, NDArray[np.int64] | NDArray[np.float64]]]:
        """The named data of the file: a list of (name, kind, array), the array of shape (m,) or (m, components)."""
        ...
    @property
    def warnings(self) -> list[str]:
        """What was odd about the file."""
        ...
    def with_data(self, name: str, values: ArrayLike, on: str = "vertices") -> Model:
        """The model with one more array of numbers on its cells.

        Parameters
        ----------
        name : str
            The name of the array.
        values : array_like
            Integers or reals, one row for each cell.
        on : {"vertices", "lines", "faces", "cells"}
            What the rows belong to.

        Returns
        -------
        Model
            The model with the data; :meth:`write` keeps them where the format does.
        """
        ...
    def with_group(self, name: str, members: ArrayLike, kind: str = "faces") -> Model:
        """The model with one more named group.

        Parameters
        ----------
        name : str
            The name.
        members : array_like of int
            Numbers of vertices, lines, faces or cells.
        kind : {"vertices", "lines", "faces", "cells"}
            What the members are.

        Returns
        -------
        Model
            The model with the group.
        """
        ...
    def with_chain(self, name: str, chain: Chain | Generator) -> Model:
        """The mesh with one more group for a chain or cochain of it, as Gmsh writes generators of homology.

        A cell of the chain stands as an element as often as its coefficient says, turned if it is negative. Of a cochain the values are data too:
        at the first element of each cell, for its direction. ``write("out.msh")`` makes it a physical group, and
        :meth:`ChainComplex.chain` reads it back by its name.

        Parameters
        ----------
        name : str
            The name of the group; Gmsh uses ``"H_1{1},{70,71}1"`` and ``"H^1{1},{70,71}1"``.
        chain : Chain or Generator
            A chain or cochain of a chain complex of this model.

        Returns
        -------
        Model
            The mesh with the group.
        """
        ...
    def with_lines(self, lines: ArrayLike) -> Model:
        """The model with these polylines instead of its own.

        Parameters
        ----------
        lines : array_like of int
            Each a list of vertices; a closed line has its first vertex again at its end.

        Returns
        -------
        Model
            The model with the lines.
        """
        ...
    def write(self, path: _File, format: str | None = None, *, progress: _Progress = ...) -> None:
        """Writes the model to a file, which appears whole or not at all.

        Parameters
        ----------
        path : str, os.PathLike or file
            The file; its extension decides the format. A file that is open for writing gets all at once.
        format : str, optional
            The format, instead of that of the extension.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).

        Raises
        ------
        UnsupportedFormatError
            If the format cannot hold the model.
        """
        ...
    def to_bytes(self, format: str) -> bytes:
        """The model as a file of this format would hold it.

        Parameters
        ----------
        format : str
            The format, such as ``"off"``.

        Returns
        -------
        bytes
            The content of the file.
        """
        ...
    def report(self, moments: Sequence[Sequence[int]] = ..., *, check: str = "usual", flatness: float | None = None, progress: _Progress = ...) -> Report:
        """Everything that ``coface info`` says: what it is, whether it is sound, what is wrong and where.

        Parameters
        ----------
        moments : sequence of (int, int, int), optional
            Exponents of further moments, each x^a y^b z^c over the volume and the surface.
        check : {"usual", "geometry", "topology"}
            Whether faces in space are checked, as :attr:`Report.geometry`: on surfaces of up to 200,000 faces, always, never.
        flatness : float, optional
            How far points of a flat face may be from its plane; by default a hundredth of the face.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).

        Returns
        -------
        Report
            The report.
        """
        ...
    def complex(self, *, progress: _Progress = ...) -> Complex:
        """The simplicial complex of a model of simplices.

        Returns
        -------
        Complex
            The facets, triangles, tetrahedra, segments and vertices with all their faces.

        Raises
        ------
        InvalidInputError
            If a cell is no simplex.
        """
        ...
    def chain_complex(self, relative: str | int | list[str | int] | Model | Complex | ChainComplex | None = None, *, domain: str | int | list[str | int] | None = None, reduced: bool = False, progress: _Progress = ...) -> ChainComplex:
        """The chain complex of the cells, or of a pair.

        Parameters
        ----------
        relative : "boundary", Model, str, int or list of these words, optional
            A part that is divided out: the boundary of the domain, the cells of a model with the same vertex numbers, or groups of the mesh by
            name or number, such as physical groups of a ``.msh``. A word that is a group and "boundary" is the group.
        domain : str, int or list of these, optional
            Groups of the mesh, by name or number, whose cells and faces are the complex; the whole model by default.
        reduced : bool
            Whether a cell of degree -1 below all vertices is added, so that a point has no homology. Degrees then count from it.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).

        Returns
        -------
        ChainComplex
            Its cells are named by the vertices of the model.
        """
        ...
    def surface(self, *, boundary: bool = False, progress: _Progress = ...) -> Surface:
        """The faces as a surface.

        Parameters
        ----------
        boundary : bool
            Of a model with 3-cells, whether its boundary is meant.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).

        Returns
        -------
        Surface
            The surface.

        Raises
        ------
        NonManifoldError
            If it is not a surface; ``.cells`` has the edge or vertex that shows it.
        """
        ...
    def welded(self, radius: float, *, progress: _Progress = ...) -> Model:
        """The model with vertices merged that are at most ``radius`` apart; none moves farther, and the order of vertices does not matter.

        Parameters
        ----------
        radius : float
            A length in the unit of the positions; 0 merges equal positions.

        Returns
        -------
        Model
            Polygons without enough corners are left out; a remark says what was merged.
        """
        ...
    def repaired(self, *, split_edges: str | None = None, split_vertices: bool = False, orient: bool = False, keep_repeated: bool = False, progress: _Progress = ...) -> Repaired:
        """The model as a mesh that is a surface: edges with more than two faces and vertices with several fans are split.

        Parameters
        ----------
        split_edges : {"apart", "pairs"}, optional
            What becomes of edges in three and more faces: each face gets the edge for itself, or coherent pairs stay together.
        split_vertices : bool
            Whether a vertex with several fans is duplicated, one copy for each fan.
        orient : bool
            Whether faces are turned so that neighbors agree.
        keep_repeated : bool
            Whether faces that repeat an earlier one stay; they are left out otherwise, and faces are numbered anew.

        Returns
        -------
        model : Model
            The repaired model; the same repair again does nothing.
        vertex_sources : numpy.ndarray
            For each vertex the one that it was.
        """
        ...
    def to_model(self, *, surface: bool = False, spacing: Sequence[float] | None = None, origin: Sequence[float] | None = None) -> Model:
        """The voxels of a volume as a mesh.

        Parameters
        ----------
        surface : bool
            Whether the squares around the voxels are made, turned outward; the voxels themselves otherwise: hexahedra, quadrilaterals or
            segments.
        spacing, origin : sequence of float, optional
            How long a voxel is along each axis, and where the first corner is; without both as the header of the file says, else 1 and 0.

        Returns
        -------
        Model
            Vertices are the corners of voxels.
        """
        ...
    def triangulated(self, *, progress: _Progress = ...) -> Model:
        """The model with each face cut into triangles on its own corners; data and groups follow."""
        ...
    def repaired_surface(self, *, tolerance: float = 0.0, closed: bool = False, progress: _Progress = ...) -> RepairedSurface:
        """A surface made of the polygons of the model: merged, cleaned, split, turned and, on request, closed.

        Parameters
        ----------
        tolerance : float
            Vertices within this distance are merged, in the unit of the positions; 0 merges equal positions.
        closed : bool
            Whether holes are filled.

        Returns
        -------
        model : Model
        done : dict
            How much was done: the keys ``vertices_merged``, ``vertices_left_out``, ``polygons_collapsed``, ``polygons_repeated``,
            ``lines_left_out``, ``edges_split``, ``vertices_split``, ``faces_turned``, ``holes_filled`` and ``triangles_added``.
        """
        ...
    def handles(self, *, shorter_than: float | None = None, progress: _Progress = ...) -> dict[str, Json]:
        """The handles of closed surfaces in space, each by a short handle loop, which bounds on the inside, and a short tunnel loop, which bounds
        on the outside.

        Parameters
        ----------
        shorter_than : float, optional
            List only handles whose shorter loop is shorter than this, in the unit of the positions.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).

        Returns
        -------
        dict
            ``genus``, the number of all handles, and ``handles``, that with the shortest loop first: dictionaries with ``length``,
            ``shorter``, ``component``, ``handle`` and ``tunnel``; loops have ``length`` and ``vertices``, the first one again at the end.
        """
        ...
    def handles_filled(self, *, shorter_than: float | None = None, progress: _Progress = ...) -> tuple[Model, dict[str, Json]]:
        """Closed surfaces in space without their short handles: cut along handle loops and tunnel loops, the cuts filled with triangles, until
        no such loop is left.

        Parameters
        ----------
        shorter_than : float, optional
            Fill only handles with a loop shorter than this, in the unit of the positions; all of them otherwise.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).

        Returns
        -------
        model : Model
            Vertices keep their numbers; no triangles meet beside their common vertices, which is decided exactly.
        done : dict
            ``before`` and ``after`` with ``genus``, ``euler_characteristic``, ``components``, ``closed`` and ``orientable``; ``filled``, the
            loops in their order; ``left``, the loops on which no patch fits.
        """
        ...
    def simplified(self, *, attempts: int = 200, census: str | os.PathLike[str] | None = None, progress: _Progress = ...) -> tuple[Model, dict[str, Json]]:
        """A triangulated 3-manifold with fewer tetrahedra, by moves that keep the space.

        The moves 4-1, 3-2 and 2-0 and collapses of edges remove tetrahedra; 2-3 adds one on the way to others. The same input gives the same triangulation on every
        machine. The homology before and after is compared, and a boundary stays as it is.

        Parameters
        ----------
        attempts : int
            How often moves that add a tetrahedron are tried, when none removes one.
        census : path-like, optional
            A file of lines "signature name": the triangulation is looked up there, and moves go on until it is one of them.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).

        Returns
        -------
        model : Model
            A gluing table.
        done : dict
            ``f_vector_before`` and ``f_vector``, ``moves`` in their order, ``homology``, ``signature``, and ``name`` with ``name_proof`` where it is
            proved which manifold it is; ``census`` with the line that was ``found`` in the census.
        """
        ...
    def isomorphism(self, other: Model, *, progress: _Progress = ...) -> dict[str, Json]:
        """Whether another triangulation is the same as this one but for the names of simplices and vertices, and with which names.

        Parameters
        ----------
        other : Model
            A gluing table, a facet list, or a mesh of triangles or tetrahedra.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).

        Returns
        -------
        dict
            ``isomorphic``; ``difference``, the first thing in which they differ; ``simplices``, for each of this model the one of the other, and
            ``vertices``, the places of its vertices there; ``signatures`` of both, which are equal if and only if the triangulations are the same.
        """
        ...
    def subdivided(self, *, progress: _Progress = ...) -> Subdivided:
        """A gluing table or a surface of halfedges as a facet list, subdivided where that is needed to keep simplices apart.

        Returns
        -------
        model : Model
            The facet list.
        carriers : numpy.ndarray of shape (n, 2)
            For each vertex the dimension and the number of the cell that it lies in the interior of.
        """
        ...
    def to_dict(self) -> dict[str, Json]:
        """This as a dictionary of JSON: ``recipe`` says how it is made again by ``from_dict``."""
        ...
    @classmethod
    def from_dict(cls, facts: Mapping[str, Any]) -> Model:
        """The answer that ``to_dict()`` wrote."""
        ...
    def __len__(self) -> int: ...
    def __bool__(self) -> bool: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __repr__(self) -> str: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Persistence:
    """Births and deaths of homology classes along a filtration, over a prime field.

    Made by :func:`persistence`.
    """
    def certificate(self, path: str | os.PathLike[str] | Sequence[str | os.PathLike[str]], *, progress: _Progress = ...) -> str:
        """A proof of this answer, which :func:`coface.check` verifies without any code of what computed it.

        Parameters
        ----------
        path
            Where the input of the answer is written, which the certificate is about: ``.json``, ``.off`` or ``.obj``; ``.txt`` for points, ``.npy`` for an
            image, ``.wkt`` for a drawing. An answer of several inputs takes a path for each. A file that is there already must hold just that.
        progress
            As for :func:`homology`.

        Returns
        -------
        str
            JSON, to be kept beside the file. The checker has accepted it already.

        Raises
        ------
        InvalidInputError
            For an answer that does not know its input, such as one that was pickled; for options that no certificate proves; for a path where
            something else is. :func:`coface.certificate` asks of files.
        """
        ...
    def _repr_html_(self) -> str: ...
    def plot(self, **options: Any) -> Any:
        """Draw this with matplotlib: :func:`plot` with the same options."""
        ...
    @property
    def prime(self) -> int:
        """The prime of the field."""
        ...
    @property
    def vertex_names(self) -> tuple[str, ...] | None:
        """The names of the vertices of a graph by their numbers; ``None`` where vertices have numbers."""
        ...
    @property
    def is_falling(self) -> bool:
        """Whether values fall along the filtration."""
        ...
    @property
    def collapsed(self) -> tuple[int, int] | None:
        """The numbers of edges before and after their collapse; ``None`` if they were not collapsed."""
        ...
    @property
    def betti_numbers(self) -> tuple[int, ...]:
        """The numbers of classes that never die, by degree."""
        ...
    def diagram(self, degree: int) -> NDArray[np.float64]:
        """Births and deaths of a degree.

        Parameters
        ----------
        degree : int
            The degree.

        Returns
        -------
        numpy.ndarray
            ``float64``, shape (n, 2); a class that never dies has the death inf, where values fall -inf.
        """
        ...
    @property
    def threshold(self) -> float | None:
        """The largest diameter of the simplices that were looked at; ``None`` unless the diagram is of points."""
        ...
    @property
    def diagrams(self) -> list[NDArray[np.float64]]:
        """The diagrams of all degrees, as Ripser's users have them."""
        ...
    def to_gudhi(self) -> list[tuple[int, tuple[float, float]]]:
        """All pairs as ``(degree, (birth, death))``, as GUDHI's users have them."""
        ...
    def betti_curve(self, degree: int, *, at: Any = None, end: float | None = None) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The Betti curve of a degree: how many classes live at a value.

        Parameters
        ----------
        degree : int
            The degree.
        at : int or array_like, optional
            Values, or the number of values from the first birth or death to the last; all births and deaths if not given.
        end : float, optional
            Where classes that never die, die.

        Returns
        -------
        tuple of numpy.ndarray
            The values and the numbers of classes, ``float64``.
        """
        ...
    def euler_curve(self, *, at: Any = None) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The Euler characteristic curve: the alternating sum of the numbers of classes that live at a value.

        Parameters
        ----------
        at : int or array_like, optional
            Values, or the number of values from the first birth or death to the last; all births and deaths if not given.

        Returns
        -------
        tuple of numpy.ndarray
            The values and the Euler characteristics, ``float64``.
        """
        ...
    def landscapes(self, degree: int, count: int = ..., *, at: Any = None, end: float | None = None) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The first persistence landscapes of a degree (Bubenik, 2015). GUDHI multiplies them by the root of 2.

        Parameters
        ----------
        degree : int
            The degree.
        count : int
            How many.
        at : int or array_like, optional
            Values, or the number of values from the first birth or death to the last; 100 if not given.
        end : float, optional
            Where classes that never die, die.

        Returns
        -------
        tuple of numpy.ndarray
            The values, and an array with a row for each landscape, from the largest one on.
        """
        ...
    def silhouette(self, degree: int, power: float = 1.0, *, at: Any = None, end: float | None = None) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The silhouette of a degree: the mean of the tents over the intervals of births and deaths (Chazal et al., 2014).

        Parameters
        ----------
        degree : int
            The degree.
        power : float
            The power of the persistence that is the weight of a class.
        at : int or array_like, optional
            Values, or the number of values from the first birth or death to the last; 100 if not given.
        end : float, optional
            Where classes that never die, die; they are left out if not given.

        Returns
        -------
        tuple of numpy.ndarray
            The values and the silhouette.
        """
        ...
    def persistence_image(self, degree: int, *, resolution: tuple[int, int] = ..., bandwidth: float | None = None, births: tuple[float, float] | None = None, persistences: tuple[float, float] | None = None, power: float = 1.0, end: float | None = None) -> NDArray[np.float64]:
        """The persistence image of a degree (Adams et al., 2017).

        Parameters
        ----------
        degree : int
            The degree.
        resolution : tuple of int
            The numbers of pixels in the direction of births and of persistences.
        bandwidth : float, optional
            The standard deviation of the normal distribution around a class; the longer side of a pixel if not given.
        births, persistences : tuple of float, optional
            The first and the last; by default those of the classes, persistences from 0 on.
        power : float
            The power of the persistence that is the weight of a class.
        end : float, optional
            Where classes that never die, die; they are left out if not given.

        Returns
        -------
        numpy.ndarray
            ``float64``, a row for each range of persistences, from the shortest on, in which births run. A pixel is the volume over it.
        """
        ...
    def pairs(self, degree: int) -> NDArray[np.int64]:
        """The cells that make and end the classes of a degree.

        Parameters
        ----------
        degree : int
            The degree.

        Returns
        -------
        numpy.ndarray
            ``int64``, shape (n, 2): the numbers of a cell of this degree and of one of the next, -1 where there is none.
        """
        ...
    def simplices(self, degree: int) -> list[tuple[list[int], list[int] | None]]:
        """The vertices of the cells that make and end the classes of a degree: a list of pairs."""
        ...
    def voxels(self, degree: int) -> NDArray[np.int64]:
        """The voxels of an image whose values are the births and deaths of the classes of a degree.

        Parameters
        ----------
        degree : int
            The degree.

        Returns
        -------
        numpy.ndarray
            ``int64``, shape (n, 2, axes): for each class the place of the voxel of its birth and of that of its death along each axis, -1 where there is none.
        """
        ...
    def cycles(self, degree: int, *, progress: _Progress = ...) -> list[tuple[Chain, Chain | None, Chain]]:
        """What proves the classes of a degree: for each a cycle, the chain that it bounds, and a cocycle, over the field.

        Each is a :class:`Chain` with ``cells``, ``coefficients`` and ``simplices`` as arrays. The cycle is there from the birth on, and bounds from the death
        on, not before; the cocycle is one of the cells before the death, with the value 1 on the cycle. Over the field of p elements coefficients are the
        whole numbers of least absolute value. Cycles are made shorter by boundaries of
        cells that are there at the birth; the shortest ones are not promised.

        Parameters
        ----------
        degree : int
            The degree.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).

        Returns
        -------
        list of tuple
            ``(cycle, bounding_chain, cocycle)`` for each row of :meth:`diagram`; the bounding chain is ``None`` for a class that never dies.
        """
        ...
    def torsion_primes(self) -> list[int]:
        """The primes over whose fields other cells are paired than over the rational numbers: those of torsion along the way.

        Returns
        -------
        list of int
            The primes, rising.
        """
        ...
    def dying_cycle(self, degree: int, place: int) -> Chain | None:
        """The cycle that a death cell fills: its boundary.

        Parameters
        ----------
        degree : int
            The degree of the class.
        place : int
            Its row in :meth:`diagram`.

        Returns
        -------
        Chain or None
            The boundary of the cell that ends the class; ``None`` if it never ends.
        """
        ...
    def longer_than(self, length: float) -> Persistence:
        """The diagram without classes that live no longer than this."""
        ...
    def to_bytes(self, format: str) -> bytes:
        """The diagram as a file has it.

        Parameters
        ----------
        format : {"gudhi", "ripser", "csv"}
            The format.

        Returns
        -------
        bytes
            The content of the file.
        """
        ...
    def to_svg(self, title: str = "persistence diagram") -> str:
        """The diagram as a picture: SVG."""
        ...
    def _picture(self, title: str, format: str, size: tuple[int, int], transparent: bool) -> bytes: ...
    def to_dict(self) -> dict[str, Json]:
        """The answer as a dictionary, in the words of the program's JSON, and how it was made: ``recipe``, which ``from_dict`` reads."""
        ...
    @classmethod
    def from_dict(cls, facts: Mapping[str, Any]) -> Persistence:
        """The answer that ``to_dict()`` wrote."""
        ...
    def __hash__(self) -> int: ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __len__(self) -> int: ...
    def __repr__(self) -> str: ...

@final
class PlanarArrangement:
    """What segments cut the plane into: vertices, edges and bounded faces.

    Made by :func:`arrange`.
    """
    def certificate(self, path: str | os.PathLike[str] | Sequence[str | os.PathLike[str]], *, progress: _Progress = ...) -> str:
        """A proof of this answer, which :func:`coface.check` verifies without any code of what computed it.

        Parameters
        ----------
        path
            Where the input of the answer is written, which the certificate is about: ``.json``, ``.off`` or ``.obj``; ``.txt`` for points, ``.npy`` for an
            image, ``.wkt`` for a drawing. An answer of several inputs takes a path for each. A file that is there already must hold just that.
        progress
            As for :func:`homology`.

        Returns
        -------
        str
            JSON, to be kept beside the file. The checker has accepted it already.

        Raises
        ------
        InvalidInputError
            For an answer that does not know its input, such as one that was pickled; for options that no certificate proves; for a path where
            something else is. :func:`coface.certificate` asks of files.
        """
        ...
    def _repr_html_(self) -> str: ...
    def plot(self, **options: Any) -> Any:
        """Draw this with matplotlib: :func:`plot` with the same options."""
        ...
    @property
    def joined(self) -> dict[str, Json] | None:
        """What was put together, where that was asked for."""
        ...
    @property
    def congruence(self) -> dict[str, Json] | None:
        """What congruence put together, with ``method="congruence"``."""
        ...
    @property
    def f_vector(self) -> list[int]:
        """The numbers of vertices, edges and bounded faces."""
        ...
    @property
    def measures(self) -> list[float]:
        """The areas of the bounded faces."""
        ...
    @property
    def inside(self) -> list[list[int]]:
        """For each bounded face the inputs that contain it."""
        ...
    @property
    def holes(self) -> int:
        """The number of holes of bounded faces."""
        ...
    @property
    def components(self) -> int:
        """The number of connected components of vertices and edges."""
        ...
    @property
    def euler_characteristic(self) -> int:
        """Vertices - edges + bounded faces."""
        ...
    @property
    def bridges(self) -> int:
        """The number of edges with one face on both sides."""
        ...
    @property
    def dangling_edges(self) -> int:
        """The number of those of them that hang on the rest by one end."""
        ...
    @property
    def rounding(self) -> dict[str, Json] | None:
        """What rounding of coordinates does."""
        ...
    @property
    def products_zero(self) -> bool:
        """Whether products of boundary matrices are zero, found by multiplying."""
        ...
    @property
    def regions(self) -> list[str]:
        """The names of the inputs that contain faces."""
        ...
    @property
    def remarks(self) -> list[Remark]:
        """What was assumed, changed or left out, each a dictionary with ``code``, ``message``, ``count`` and ``places``; a warning said so too."""
        ...
    def to_dict(self) -> dict[str, Json]:
        """The answer as a dictionary, in the words of the program's JSON, and how it was made: ``recipe``, which ``from_dict`` reads."""
        ...
    @property
    def warnings(self) -> list[str]:
        """What is odd about the inputs."""
        ...
    @property
    def vertices(self) -> NDArray[np.float64]:
        """The positions of the vertices: ``float64``, shape (n, 2)."""
        ...
    @property
    def edges(self) -> NDArray[np.int64]:
        """The ends of the edges: ``int64``, shape (m, 2)."""
        ...
    def walks(self, face: int) -> list[NDArray[np.int64]]:
        """The walks around a bounded face, each an array of vertices with the face on the left: the outer one and those of holes.

        Parameters
        ----------
        face : int
            The number of the face.

        Returns
        -------
        list of numpy.ndarray
            Walks may run along an edge twice where it has the face on both sides.
        """
        ...
    def properties(self, face: int) -> dict[str, Json]:
        """The properties of all features of GeoJSON or TopoJSON that contain a bounded face.

        Parameters
        ----------
        face : int
            The number of the face.

        Returns
        -------
        dict of str
            A key with equal values has that value, a key with different values the list of them in the order of the
            inputs.
        """
        ...
    def attributes(self) -> Model:
        """The bounded faces that inputs contain as a map: each with the properties of all features that contain it.

        Returns
        -------
        Model
            All faces have the same keys; a key of several inputs is one for each, such as ``use_1`` and ``use_2``, and the value is ``None``
            where no feature of that input contains the face. ``GeoDataFrame.from_features`` of geopandas takes it.
        """
        ...
    def provenance(self) -> dict[str, Json] | None:
        """Where everything comes from: ``vertices``, ``edges`` (segments along each) and ``faces`` (inputs around each)."""
        ...
    def chain_complex(self) -> ChainComplex:
        """The chain complex of vertices, edges and bounded faces, refined until each face is a disk: its homology is that of
        the union of all edges, vertices and bounded faces.
        """
        ...
    def to_bytes(self, format: str) -> bytes:
        """The arrangement as a file of this format."""
        ...
    def write(self, path: _File, format: str | None = None) -> None:
        """Writes the arrangement to a file, by its path or open for writing."""
        ...
    def model(self) -> Model:
        """The faces as a model: polygons with the plane's coordinates. With ``exact=True`` it keeps exact points."""
        ...
    @classmethod
    def from_dict(cls, facts: Mapping[str, Any]) -> PlanarArrangement:
        """The answer that ``to_dict()`` wrote."""
        ...
    @property
    def cells(self) -> Model:
        """The cells as a chain complex with positions whose faces are disks: what ``.json`` holds, and what homology and other questions about
        cells are asked of.
        """
        ...
    def __hash__(self) -> int: ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __len__(self) -> int: ...
    def __repr__(self) -> str: ...

@final
class PlanarBoolean:
    """Regions of the plane combined: polygons with holes.

    Made by :func:`boolean`.
    """
    def certificate(self, path: str | os.PathLike[str] | Sequence[str | os.PathLike[str]], *, progress: _Progress = ...) -> str:
        """A proof of this answer, which :func:`coface.check` verifies without any code of what computed it.

        Parameters
        ----------
        path
            Where the input of the answer is written, which the certificate is about: ``.json``, ``.off`` or ``.obj``; ``.txt`` for points, ``.npy`` for an
            image, ``.wkt`` for a drawing. An answer of several inputs takes a path for each. A file that is there already must hold just that.
        progress
            As for :func:`homology`.

        Returns
        -------
        str
            JSON, to be kept beside the file. The checker has accepted it already.

        Raises
        ------
        InvalidInputError
            For an answer that does not know its input, such as one that was pickled; for options that no certificate proves; for a path where
            something else is. :func:`coface.certificate` asks of files.
        """
        ...
    def _repr_html_(self) -> str: ...
    def plot(self, **options: Any) -> Any:
        """Draw this with matplotlib: :func:`plot` with the same options."""
        ...
    @property
    def joined(self) -> dict[str, Json] | None:
        """What was put together, where that was asked for."""
        ...
    @property
    def congruence(self) -> dict[str, Json] | None:
        """What congruence put together, with ``method="congruence"``."""
        ...
    @property
    def measure(self) -> float:
        """The area."""
        ...
    @property
    def f_vector(self) -> list[int]:
        """The numbers of vertices, edges and polygons."""
        ...
    @property
    def components(self) -> int:
        """The number of parts; those that touch in points only are different ones."""
        ...
    @property
    def closed(self) -> bool:
        """Whether every edge has the result on one side."""
        ...
    @property
    def manifold(self) -> ManifoldFacts:
        """Whether the boundary is a curve everywhere; ``witness`` has pinched vertices."""
        ...
    @property
    def rounding(self) -> dict[str, Json] | None:
        """What rounding of coordinates does."""
        ...
    @property
    def remarks(self) -> list[Remark]:
        """What was assumed, changed or left out, each a dictionary with ``code``, ``message``, ``count`` and ``places``; a warning said so too."""
        ...
    def to_dict(self) -> dict[str, Json]:
        """The answer as a dictionary, in the words of the program's JSON, and how it was made: ``recipe``, which ``from_dict`` reads."""
        ...
    @property
    def holes(self) -> int:
        """The number of holes."""
        ...
    @property
    def areas(self) -> NDArray[np.float64]:
        """The areas of the polygons."""
        ...
    @property
    def vertices(self) -> NDArray[np.float64]:
        """The positions of the vertices: ``float64``, shape (n, 2)."""
        ...
    @property
    def polygons(self) -> list[list[NDArray[np.int64]]]:
        """For each polygon its rings, each an array of vertices: the outer one and those of holes."""
        ...
    @property
    def pinches(self) -> NDArray[np.int64]:
        """Vertices where parts of the result touch."""
        ...
    @property
    def warnings(self) -> list[str]:
        """What is odd about the inputs."""
        ...
    def properties(self, polygon: int) -> dict[str, Json]:
        """The properties of all features of GeoJSON or TopoJSON that contain some of a polygon.

        Parameters
        ----------
        polygon : int
            The number of the polygon.

        Returns
        -------
        dict of str
            A key with equal values has that value, a key with different values the list of them in the order of the
            inputs.
        """
        ...
    def provenance(self) -> dict[str, Json] | None:
        """Where everything comes from."""
        ...
    def to_bytes(self, format: str) -> bytes:
        """The result as a file of this format."""
        ...
    def write(self, path: _File, format: str | None = None) -> None:
        """Writes the result to a file, by its path or open for writing."""
        ...
    def model(self) -> Model:
        """The rings as a model of closed lines, which is input again. With ``exact=True`` it keeps exact points, and has no
        properties of features.
        """
        ...
    @classmethod
    def from_dict(cls, facts: Mapping[str, Any]) -> PlanarBoolean:
        """The answer that ``to_dict()`` wrote."""
        ...
    @property
    def cells(self) -> Model:
        """The cells as a chain complex with positions whose faces are disks: what ``.json`` holds, and what homology and other questions about
        cells are asked of.
        """
        ...
    def __hash__(self) -> int: ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __len__(self) -> int: ...
    def __repr__(self) -> str: ...

@final
class Report:
    """Everything that ``coface info`` says about a model.

    Made by :meth:`Model.report`. A notion that does not apply is ``None``.
    """
    def certificate(self, path: str | os.PathLike[str] | Sequence[str | os.PathLike[str]], *, progress: _Progress = ...) -> str:
        """A proof of this answer, which :func:`coface.check` verifies without any code of what computed it.

        Parameters
        ----------
        path
            Where the input of the answer is written, which the certificate is about: ``.json``, ``.off`` or ``.obj``; ``.txt`` for points, ``.npy`` for an
            image, ``.wkt`` for a drawing. An answer of several inputs takes a path for each. A file that is there already must hold just that.
        progress
            As for :func:`homology`.

        Returns
        -------
        str
            JSON, to be kept beside the file. The checker has accepted it already.

        Raises
        ------
        InvalidInputError
            For an answer that does not know its input, such as one that was pickled; for options that no certificate proves; for a path where
            something else is. :func:`coface.certificate` asks of files.
        """
        ...
    def _repr_html_(self) -> str: ...
    @property
    def kind(self) -> str:
        """``complex``, ``surface``, ``volume`` or ``planar``."""
        ...
    @property
    def dimension(self) -> int | None:
        """The highest dimension of a cell."""
        ...
    @property
    def f_vector(self) -> tuple[int, ...]:
        """The numbers of cells of the dimensions 0, 1, ..."""
        ...
    @property
    def pure(self) -> bool | None:
        """Whether every cell lies in one of the highest dimension."""
        ...
    @property
    def components(self) -> int:
        """The number of connected components."""
        ...
    @property
    def euler_characteristic(self) -> int:
        """The alternating sum of the numbers of cells."""
        ...
    @property
    def manifold(self) -> str:
        """Whether it is a manifold: ``yes``, ``no`` or ``unknown``."""
        ...
    @property
    def closed(self) -> bool | None:
        """Whether it is a manifold without boundary."""
        ...
    @property
    def witness(self) -> Witness | None:
        """Why it is no manifold: a dictionary with ``kind``, ``cells`` (lists of vertices) and ``message``."""
        ...
    @property
    def boundary_loops(self) -> list[NDArray[np.int64]] | None:
        """The boundary loops of a surface, each an array of its vertices in order."""
        ...
    @property
    def boundary_surface(self) -> dict[str, Json] | None:
        """The boundary surface of a volume: a dictionary with ``faces``, ``components``, ``euler_characteristic``, ``manifold``, ``name``."""
        ...
    @property
    def orientable(self) -> bool | None:
        """Whether it can be oriented."""
        ...
    @property
    def coherently_oriented(self) -> bool | None:
        """Whether its cells are oriented coherently as they stand."""
        ...
    @property
    def genus(self) -> int | None:
        """The genus of a connected surface; of one that cannot be oriented the number of cross-caps."""
        ...
    @property
    def name(self) -> str | None:
        """What a connected surface is called, such as ``torus``."""
        ...
    @property
    def surfaces(self) -> list[dict[str, Json]]:
        """The components of a surface: dictionaries with ``f_vector``, ``euler_characteristic``, ``boundary_loops``, ``orientable``, ``genus``, ``name``."""
        ...
    @property
    def homology(self) -> Homology:
        """The integral homology."""
        ...
    @property
    def area(self) -> float | None:
        """The area, in the unit of the file squared."""
        ...
    @property
    def signed_volume(self) -> float | None:
        """The volume, positive where normals point outward."""
        ...
    @property
    def surface_centroid(self) -> list[float] | None:
        """The center of the surface."""
        ...
    @property
    def mass(self) -> dict[str, Json] | None:
        """What it encloses, at density 1: ``volume``, ``centroid`` and ``inertia`` about the centroid."""
        ...
    @property
    def moments(self) -> list[dict[str, Json]]:
        """The moments that were asked for: dictionaries with ``exponents``, ``volume`` and ``surface``."""
        ...
    @property
    def geometry(self) -> dict[str, Json] | None:
        """Whether faces in space are sound: a dictionary with ``checked``, ``reason``, ``sound_surface``, ``valid_solid``, and
        ``faults``, each with ``code`` (of ISO 19107), ``name``, ``of``, ``count``, ``message`` and ``places``.
        """
        ...
    @property
    def polygons(self) -> dict[str, Json] | None:
        """Whether the polygons with rings of a drawing are valid, as OGC's Simple feature access says: a dictionary with ``count``, ``valid``,
        ``reason`` (as ``shapely.is_valid_reason``), ``faults``, each with ``name``, ``reason``, ``count``, ``message`` and
        ``places``, and ``reversed_rings``; ``None`` for what has no such polygons.
        """
        ...
    @property
    def problems(self) -> list[Problem]:
        """What is wrong and where: dictionaries with ``kind``, ``count``, ``message``, ``cells`` and ``top_cells`` (lists of vertices), and ``points`` where
        cells are not the places: with the cells, with the faces in space, with the polygons of a drawing.
        """
        ...
    @property
    def warnings(self) -> list[str]:
        """What was odd about the file."""
        ...
    def to_dict(self, limit: int = 100, *, model: bool = False) -> dict[str, Json]:
        """The report as ``coface info --json`` prints it, but for ``file``.

        Parameters
        ----------
        limit
            How many places of each problem are listed.
        model
            Whether the model stands in it too, as ``recipe``, which ``from_dict`` needs.

        Returns
        -------
        dict
            ``kind``, ``dimension``, ``f_vector``, ..., with ``format`` if the model came from a file.
        """
        ...
    def to_text(self, title: str = "model", limit: int = ...) -> str:
        """The report for people, at 80 columns.

        Parameters
        ----------
        title : str
            What it is about.
        limit : int
            How many places of each problem are listed.

        Returns
        -------
        str
            The text that ``coface info`` prints.
        """
        ...
    def to_html(self, title: str = "model", figures: Sequence[tuple[str, str]] = ...) -> str:
        """The report as a page for browsers: tables of facts, and pictures given as SVG.

        Parameters
        ----------
        title : str
            What it is about.
        figures : sequence of (str, str)
            Pictures as SVG, each with its caption.

        Returns
        -------
        str
            One page that needs no network.
        """
        ...
    @classmethod
    def from_dict(cls, facts: Mapping[str, Any]) -> Report:
        """The answer that ``to_dict()`` wrote."""
        ...
    @property
    def model(self) -> Model:
        """The model that was asked about."""
        ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __str__(self) -> str: ...
    def __repr__(self) -> str: ...

@final
class Simplices:
    """A set of simplices that need not be closed under faces: a star, an interior, a selection.

    Parameters
    ----------
    simplices : array_like of int
        One simplex, ``[0, 1]``, or several, ``[[0, 1], [3]]``.
    """
    def to_dict(self) -> dict[str, Json]:
        """The simplices in the words of the program's JSON, and ``recipe``, which ``from_dict`` reads."""
        ...
    @classmethod
    def from_dict(cls, facts: Mapping[str, Any]) -> Simplices:
        """The answer that ``to_dict()`` wrote."""
        ...
    def _repr_html_(self) -> str: ...
    def plot(self, **options: Any) -> Any:
        """Draw this with matplotlib: :func:`plot` with the same options."""
        ...
    def __new__(cls, simplices: Any) -> Simplices: ...
    @property
    def f_vector(self) -> tuple[int, ...]:
        """The numbers of simplices of the dimensions 0, 1, ..."""
        ...
    @property
    def dimension(self) -> int | None:
        """The highest dimension; ``None`` of the empty set."""
        ...
    @property
    def vertices(self) -> NDArray[np.int64]:
        """The vertices of all members, rising."""
        ...
    @property
    def is_complex(self) -> bool:
        """Whether all faces of members are members."""
        ...
    def simplices(self, dimension: int) -> _Lists:
        """The members of a dimension: ``int64``, shape (m, k + 1)."""
        ...
    def closure(self) -> Complex:
        """The members with all their faces."""
        ...
    def complex(self) -> Complex:
        """The members as a complex.

        Raises
        ------
        NotAComplexError
            If a face is missing.
        """
        ...
    def missing_faces(self) -> Simplices:
        """The faces of members that are no members."""
        ...
    def maximal(self) -> Simplices:
        """The members that are no faces of others."""
        ...
    def skeleton(self, k: int) -> Simplices:
        """The members of dimension ``k`` and lower."""
        ...
    def model(self, source: Model, *, as_facets: bool = False) -> Model:
        """The members as a model; facets only if ``as_facets``."""
        ...
    def __or__(self, other: Any, /) -> Simplices: ...
    def __ror__(self, other: Any, /) -> Simplices: ...
    def __and__(self, other: Any, /) -> Simplices: ...
    def __rand__(self, other: Any, /) -> Simplices: ...
    def __sub__(self, other: Any, /) -> Simplices: ...
    def __rsub__(self, other: Any, /) -> Simplices: ...
    def __le__(self, other: Simplices, /) -> bool: ...
    def __ge__(self, other: Simplices, /) -> bool: ...
    def __contains__(self, simplex: Any, /) -> bool: ...
    def __len__(self) -> int: ...
    def __iter__(self) -> Iterator[list[int]]: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __repr__(self) -> str: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class SimplicialGrid:
    """A grid of cubes, each cut into simplices along its diagonal.

    Parameters
    ----------
    shape : sequence of int
        The numbers of cubes along the axes.
    """
    def to_dict(self) -> dict[str, Json]:
        """This as a dictionary of JSON: ``recipe`` says how it is made again by ``from_dict``."""
        ...
    @classmethod
    def from_dict(cls, facts: Mapping[str, Any]) -> SimplicialGrid:
        """The answer that ``to_dict()`` wrote."""
        ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    def _repr_html_(self) -> str: ...
    def __new__(cls, shape: ArrayLike) -> SimplicialGrid: ...
    @property
    def shape(self) -> tuple[int, ...]:
        """The numbers of cubes along the axes."""
        ...
    @property
    def simplices(self) -> NDArray[np.int64]:
        """The simplices, vertices rising: ``int64``, shape (m, d + 1)."""
        ...
    @property
    def signs(self) -> NDArray[np.int64]:
        """The signs that orient the simplices coherently: 1 or -1."""
        ...
    @property
    def vertices(self) -> NDArray[np.float64]:
        """The positions of the vertices: shape (n, d)."""
        ...
    def model(self) -> Model:
        """The simplices as a model."""
        ...
    def __len__(self) -> int: ...
    def __repr__(self) -> str: ...

@final
class SolidBoolean:
    """Solids combined: a surface.

    Made by :func:`boolean`.
    """
    def certificate(self, path: str | os.PathLike[str] | Sequence[str | os.PathLike[str]], *, progress: _Progress = ...) -> str:
        """A proof of this answer, which :func:`coface.check` verifies without any code of what computed it.

        Parameters
        ----------
        path
            Where the input of the answer is written, which the certificate is about: ``.json``, ``.off`` or ``.obj``; ``.txt`` for points, ``.npy`` for an
            image, ``.wkt`` for a drawing. An answer of several inputs takes a path for each. A file that is there already must hold just that.
        progress
            As for :func:`homology`.

        Returns
        -------
        str
            JSON, to be kept beside the file. The checker has accepted it already.

        Raises
        ------
        InvalidInputError
            For an answer that does not know its input, such as one that was pickled; for options that no certificate proves; for a path where
            something else is. :func:`coface.certificate` asks of files.
        """
        ...
    def _repr_html_(self) -> str: ...
    def plot(self, **options: Any) -> Any:
        """Draw this with matplotlib: :func:`plot` with the same options."""
        ...
    @property
    def congruence(self) -> dict[str, Json] | None:
        """What congruence put together, with ``method="congruence"``."""
        ...
    @property
    def measure(self) -> float | None:
        """The volume; ``None`` if the exterior is in the result."""
        ...
    @property
    def f_vector(self) -> list[int]:
        """The numbers of vertices, edges and faces of the surface."""
        ...
    @property
    def components(self) -> int:
        """The number of components of the surface."""
        ...
    @property
    def closed(self) -> bool:
        """Whether the surface has no rim."""
        ...
    @property
    def manifold(self) -> ManifoldFacts:
        """Whether the surface is a manifold, with a witness if not."""
        ...
    @property
    def area(self) -> float | None:
        """The area of the surface."""
        ...
    @property
    def genus(self) -> int | None:
        """The genus of a connected surface."""
        ...
    @property
    def solids(self) -> int:
        """The number of parts that are connected through faces."""
        ...
    @property
    def voids(self) -> int:
        """The number of voids."""
        ...
    @property
    def unbounded(self) -> bool:
        """Whether the exterior is in the result."""
        ...
    @property
    def pinches(self) -> dict[str, Json]:
        """Edges and vertices where the result is no surface."""
        ...
    @property
    def rounding(self) -> dict[str, Json] | None:
        """What rounding of coordinates does."""
        ...
    @property
    def joined(self) -> dict[str, Json] | None:
        """What was put together, where that was asked for or needed."""
        ...
    @property
    def euler_characteristic(self) -> int:
        """Vertices - edges + faces."""
        ...
    @property
    def remarks(self) -> list[Remark]:
        """What was assumed, changed or left out, each a dictionary with ``code``, ``message``, ``count`` and ``places``; a warning said so too."""
        ...
    def to_dict(self) -> dict[str, Json]:
        """The answer as a dictionary, in the words of the program's JSON, and how it was made: ``recipe``, which ``from_dict`` reads."""
        ...
    @property
    def model(self) -> Model:
        """The surface."""
        ...
    @property
    def cells(self) -> Model:
        """The cells of the result as a chain complex with positions, refined until each is a ball, so that its homology is
        that of the result.
        """
        ...
    def provenance(self) -> dict[str, Json] | None:
        """Where everything comes from."""
        ...
    @classmethod
    def from_dict(cls, facts: Mapping[str, Any]) -> SolidBoolean:
        """The answer that ``to_dict()`` wrote."""
        ...
    def to_bytes(self, format: str) -> bytes:
        """The result as a file of this format: ``json`` has the cells, others the surface."""
        ...
    def write(self, path: _File, format: str | None = None) -> None:
        """Writes the result to a file, by its path or open for writing: ``.json`` has the cells, others the surface."""
        ...
    def __hash__(self) -> int: ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __repr__(self) -> str: ...

@final
class SpatialArrangement:
    """What polygons cut space into: vertices, edges, faces and bounded cells.

    Made by :func:`arrange`.
    """
    def certificate(self, path: str | os.PathLike[str] | Sequence[str | os.PathLike[str]], *, progress: _Progress = ...) -> str:
        """A proof of this answer, which :func:`coface.check` verifies without any code of what computed it.

        Parameters
        ----------
        path
            Where the input of the answer is written, which the certificate is about: ``.json``, ``.off`` or ``.obj``; ``.txt`` for points, ``.npy`` for an
            image, ``.wkt`` for a drawing. An answer of several inputs takes a path for each. A file that is there already must hold just that.
        progress
            As for :func:`homology`.

        Returns
        -------
        str
            JSON, to be kept beside the file. The checker has accepted it already.

        Raises
        ------
        InvalidInputError
            For an answer that does not know its input, such as one that was pickled; for options that no certificate proves; for a path where
            something else is. :func:`coface.certificate` asks of files.
        """
        ...
    def _repr_html_(self) -> str: ...
    def plot(self, **options: Any) -> Any:
        """Draw this with matplotlib: :func:`plot` with the same options."""
        ...
    @property
    def f_vector(self) -> list[int]:
        """The numbers of vertices, edges, faces and bounded cells."""
        ...
    @property
    def measures(self) -> list[float]:
        """The volumes of the bounded cells."""
        ...
    @property
    def inside(self) -> list[list[int]]:
        """For each bounded cell the inputs that contain it."""
        ...
    @property
    def holes(self) -> int:
        """The number of holes of faces."""
        ...
    @property
    def voids(self) -> int:
        """The number of voids of cells."""
        ...
    @property
    def components(self) -> int:
        """The number of connected components of faces."""
        ...
    @property
    def euler_characteristic(self) -> int:
        """Vertices - edges + faces - bounded cells."""
        ...
    @property
    def dangling_faces(self) -> int:
        """The number of faces with one cell, or the exterior, on both sides."""
        ...
    @property
    def rounding(self) -> dict[str, Json] | None:
        """What rounding of coordinates does."""
        ...
    @property
    def joined(self) -> dict[str, Json] | None:
        """What was put together, where that was asked for or needed."""
        ...
    @property
    def products_zero(self) -> bool:
        """Whether products of boundary matrices are zero, found by multiplying."""
        ...
    @property
    def regions(self) -> list[str]:
        """The names of the inputs, if objects, groups, features or components are inputs."""
        ...
    @property
    def inputs_of_faces(self) -> list[list[int]] | None:
        """For each face the inputs that have a polygon there, if objects, groups, features or components are inputs."""
        ...
    @property
    def files(self) -> list[dict[str, Json]]:
        """The inputs: names, numbers of polygons, and whether each is closed."""
        ...
    @property
    def remarks(self) -> list[Remark]:
        """What was assumed, changed or left out, each a dictionary with ``code``, ``message``, ``count`` and ``places``; a warning said so too."""
        ...
    @property
    def congruence(self) -> dict[str, Json] | None:
        """What congruence put together, with ``method="congruence"``."""
        ...
    def to_dict(self) -> dict[str, Json]:
        """The answer as a dictionary, in the words of the program's JSON, and how it was made: ``recipe``, which ``from_dict`` reads."""
        ...
    @property
    def vertices(self) -> NDArray[np.float64]:
        """The positions of the vertices: ``float64``, shape (n, 3)."""
        ...
    def provenance(self) -> dict[str, Json] | None:
        """Where everything comes from."""
        ...
    def chain_complex(self) -> ChainComplex:
        """The chain complex of vertices, edges, faces and bounded cells, refined until each is a ball: its homology is that of
        the union of all faces and bounded cells. Those found by congruence are as they are.
        """
        ...
    def graph(self) -> CellGraph:
        """The graph of the bounded cells: which are adjacent, and across how much area.

        Returns
        -------
        CellGraph
            Cells with volumes, centers and the inputs that contain them; pairs of cells with the area between them.
        """
        ...
    def model(self, *, triangles: bool | None = None) -> Model:
        """The faces as a model.

        Parameters
        ----------
        triangles : bool, optional
            Whether faces are cut into triangles; if all inputs are triangles, if left out.

        Returns
        -------
        Model
            The faces, in groups by the input that they come from.
        """
        ...
    @classmethod
    def from_dict(cls, facts: Mapping[str, Any]) -> SpatialArrangement:
        """The answer that ``to_dict()`` wrote."""
        ...
    @property
    def cells(self) -> Model:
        """The vertices, edges, faces and bounded cells as a chain complex with positions, refined until each is a ball: what ``.json`` holds,
        and what homology and other questions about cells are asked of.
        """
        ...
    def to_bytes(self, format: str) -> bytes:
        """The arrangement as a file of this format: ``json`` has the cells, others the faces."""
        ...
    def write(self, path: _File, format: str | None = None) -> None:
        """Writes the arrangement to a file: ``.json`` has the cells, others the faces."""
        ...
    def __hash__(self) -> int: ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __len__(self) -> int: ...
    def __repr__(self) -> str: ...

@final
class Surface:
    """A surface: faces with sides, glued along edges.

    Made by :meth:`Model.surface`. Side s runs along edge ``edge[s]`` of face ``face[s]``, from vertex ``vertex[s]``; the arrays have one
    entry for each side. Vertices have numbers from 0; ``vertex_numbers`` has those of the file.

    Parameters
    ----------
    model : Model
        A model whose faces are a surface.
    boundary : bool
        Of a model with 3-cells, whether its boundary is meant.
    """
    def _repr_html_(self) -> str: ...
    def plot(self, **options: Any) -> Any:
        """Draw this with matplotlib: :func:`plot` with the same options."""
        ...
    def __new__(cls, model: Any, *, boundary: bool = False, progress: _Progress = ...) -> Surface: ...
    @property
    def f_vector(self) -> tuple[int, int, int]:
        """The numbers of vertices, edges and faces."""
        ...
    @property
    def euler_characteristic(self) -> int:
        """Vertices - edges + faces."""
        ...
    @property
    def previous(self) -> NDArray[np.int64]:
        """The side before each side around its face."""
        ...
    def halfedges_of_face(self, face: int) -> NDArray[np.int64]:
        """The sides of a face in their order, as numbers of halfedges."""
        ...
    def halfedges_of_edge(self, edge: int) -> NDArray[np.int64]:
        """The one or two sides along an edge."""
        ...
    def halfedges_from_vertex(self, vertex: int) -> NDArray[np.int64]:
        """The sides that start from a vertex, in the order in which their faces lie around it."""
        ...
    def dual(self) -> Model:
        """The dual mesh: a vertex in the middle of each face, and a face around each vertex inside."""
        ...
    def dual_graph(self) -> Model:
        """The dual graph: a vertex in the middle of each face, and a line across each edge between two faces."""
        ...
    @property
    def next(self) -> NDArray[np.int64]:
        """The next side around the face of each side."""
        ...
    @property
    def twin(self) -> NDArray[np.int64]:
        """The other side at the edge of each side; -1 on the boundary."""
        ...
    @property
    def vertex(self) -> NDArray[np.int64]:
        """The vertex that each side starts from."""
        ...
    @property
    def edge(self) -> NDArray[np.int64]:
        """The edge of each side."""
        ...
    @property
    def face(self) -> NDArray[np.int64]:
        """The face of each side."""
        ...
    @property
    def edge_ends(self) -> NDArray[np.int32]:
        """The ends of each edge: ``int32``, shape (edges, 2), on the memory of the surface."""
        ...
    @property
    def vertex_numbers(self) -> NDArray[np.int64]:
        """The numbers in the file of the vertices."""
        ...
    @property
    def component_count(self) -> int:
        """The number of connected components with faces."""
        ...
    @property
    def components(self) -> NDArray[np.int64]:
        """The component of each face."""
        ...
    def boundary_loops(self) -> list[NDArray[np.int64]]:
        """The boundary loops, each an array of its vertices in order, as numbers of the file."""
        ...
    @property
    def is_orientable(self) -> bool:
        """Whether faces can be turned so that neighbors agree."""
        ...
    @property
    def is_closed(self) -> bool:
        """Whether there is no boundary."""
        ...
    def orientation(self) -> NDArray[np.int64]:
        """Signs of the faces that make neighbors agree, as far as that is possible: 1 or -1."""
        ...
    @property
    def genus(self) -> int | None:
        """The genus of a connected surface; of one that cannot be oriented the number of cross-caps; ``None`` if not connected."""
        ...
    def classify(self) -> list[SurfacePart]:
        """What each component is, by the classification of surfaces.

        Returns
        -------
        list of dict
            ``name``, ``orientable``, ``genus``, ``boundary_loops``, ``euler_characteristic``, ``f_vector``.
        """
        ...
    def cut(self, along: ArrayLike | None = None, *, simplify: bool = False, rounds: int | None = None, base: int | None = None, roles: bool = False, canonical: bool = False, layout: str | None = None, weights: str = "uniform", uv: bool = False, progress: _Progress = ...) -> Domain:
        """The surface cut open to disks along a short graph, or along a path.

        Parameters
        ----------
        along : array_like of int, optional
            A path of vertices; if left out, a graph that leaves a disk of each component.
        simplify : bool
            Whether the graph is made short.
        rounds : int, optional
            How often every seam is made shorter.
        base : int, optional
            The vertex that the graph is grown from.
        roles : bool
            Whether ``roles`` is wanted: which edges are in the spanning tree, which the tree of faces crosses, and which close generators.
        canonical : bool
            Whether edges and faces are split so that the cut is along disjoint simple loops through one vertex, and the word around the
            domain is canonical: ``a1 b1 a1^-1 b1^-1 a2 ..``, or ``c1 c1 c2 c2 ..`` where the surface is not orientable. ``refinement``
            has the new vertices.
        layout : {"polygon", "klein"}, optional
            Draws the domain of a canonical cut as a regular polygon: in the unit circle, or in the disk of Klein, where hyperbolic lines are straight.
            Polygons of several components are 2.5 apart. The attribute ``layout`` says how many triangles are turned over, decided exactly.
        weights : {"uniform", "cotangent"}
            Of a layout: each vertex inside is the mean of its neighbors, by the cotangents of the intrinsic Delaunay triangulation or all alike.
        uv : bool
            Of a layout: whether it becomes texture coordinates, the data ``s`` and ``t``, of a mesh that stays where it is.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).

        Returns
        -------
        Domain
            The opened surface, and what each seam is for.
        """
        ...
    def flip_edge(self, edge: int | tuple[int, int]) -> Surface:
        """The surface with an edge turned by one corner counterclockwise: between two triangles, the other diagonal.

        Edges are given by their numbers or by their ends, ``(3, 5)``. Surfaces do not change: each edit gives a new one. :attr:`edits` has
        what was done, and :meth:`undo` takes it back.
        """
        ...
    def flip_edge_back(self, edge: int | tuple[int, int]) -> Surface:
        """The surface with an edge turned by one corner clockwise: the inverse of :meth:`flip_edge`."""
        ...
    def split_edge(self, edge: int | tuple[int, int]) -> Surface:
        """The surface with a vertex in the middle of an edge; the inverse is :meth:`remove_vertex`."""
        ...
    def remove_vertex(self, vertex: int) -> Surface:
        """The surface without a vertex that has exactly two edges, which become one."""
        ...
    def split_face(self, start: int | tuple[int, int], end: int | tuple[int, int]) -> Surface:
        """The surface with a face split by an edge between the sources of two of its halfedges, each given by its number or as ``(from, to)``."""
        ...
    def remove_edge(self, edge: int | tuple[int, int]) -> Surface:
        """The surface without an edge between two faces, which become one; the inverse is :meth:`split_face`."""
        ...
    def split_vertex(self, start: int | tuple[int, int], end: int | tuple[int, int]) -> Surface:
        """The surface with a vertex drawn out to an edge, between the corners of two halfedges that leave it."""
        ...
    def contract_edge(self, edge: int | tuple[int, int]) -> Surface:
        """The surface with an edge contracted to a vertex: its faces lose a side each. The inverse of :meth:`split_vertex`."""
        ...
    def collapse_edge(self, edge: int | tuple[int, int]) -> Surface:
        """The surface with an edge and the triangles beside it collapsed, where it stays a simplicial complex."""
        ...
    def poke_face(self, face: int) -> Surface:
        """The surface with a vertex inside a face, joined to each corner."""
        ...
    def undo(self, count: int = 1) -> Surface:
        """The surface before its last edits, with the same numbers."""
        ...
    @property
    def edits(self) -> list[dict[str, Json]]:
        """What was done to the surface: each edit with its ``inverse``."""
        ...
    def cover(self, *, radius: int | None = None, copies: int | None = None, component: int = 0, layout: str = "auto", most_cells: int = 100000000, progress: _Progress = ...) -> Cover:
        """The universal cover of a component, as far as it is asked for.

        Parameters
        ----------
        radius : int, optional
            All copies of the domain at words of this length at most.
        copies : int, optional
            So many copies, instead.
        component : int
            The component.
        layout : {"auto", "flat", "disk", "klein", "none"}
            Where copies are put: in the plane, in the disk of Poincare or of Klein, in the plane or the first disk, whichever there is, or over the
            surface.
        most_cells : int
            More cells than this are refused.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).

        Returns
        -------
        Cover
            The copies glued together, with the element of the group of each.
        """
        ...
    def double_cover(self, *, progress: _Progress = ...) -> Model:
        """The cover that has each face twice, once for each of its sides; it can be oriented.

        Returns
        -------
        Model
            The cover; the data ``source`` and ``copy`` say what lies below.
        """
        ...
    def cocycles(self, *, method: str = "crossing", harmonic: bool = False, weights: str = "auto", progress: _Progress = ...) -> Cocycles:
        """A basis of the first cohomology dual to loops.

        Parameters
        ----------
        method : {"crossing", "slicing"}
            How cocycles are found: by the dual tree that crosses edges, or by slicing along loops.
        harmonic : bool
            Whether harmonic forms of the same classes are wanted.
        weights : {"auto", "cotangent", "uniform"}
            The weights of edges for harmonic forms.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).

        Returns
        -------
        Cocycles
            Loops, cocycles, their pairing, and harmonic forms.
        """
        ...
    def pi1(self, *, canonical: bool = False, shortest: bool = False, base: int | None = None, progress: _Progress = ...) -> list[FundamentalGroup]:
        """The fundamental groups of the components in generators of the surface, with their loops.

        Parameters
        ----------
        canonical : bool
            Whether generators are those of the normal form: a b a^-1 b^-1 ... or a a b b ...
        shortest : bool
            Whether loops are the shortest at the base.
        base : int, optional
            The vertex that loops start from.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).

        Returns
        -------
        list of FundamentalGroup
            One for each component with faces.
        """
        ...
    def shortest_cycles(self, kind: str = "non-contractible", *, through: int | None = None, progress: _Progress = ...) -> list[tuple[float, NDArray[np.int64]]]:
        """Shortest closed paths: one that cannot be contracted, one that does not separate, or a basis of homology.

        Parameters
        ----------
        kind : {"non-contractible", "non-separating", "homology-basis"}
            What is looked for.
        through : int, optional
            A vertex that it has to go through.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).

        Returns
        -------
        list of (float, numpy.ndarray)
            Lengths and vertices, the first one again at the end. Without positions each edge has the length 1.
        """
        ...
    def shortest_cycle_within(self, seconds: float, kind: str = "non-contractible", *, progress: _Progress = ...) -> tuple[float, NDArray[np.int64], float] | None:
        """The best closed path of a kind that is found in some time, and a length that none falls below.

        Parameters
        ----------
        seconds : float
            For how long a shorter path is looked for; one is found in any case, if there is one.
        kind : {"non-contractible", "non-separating"}
            What is looked for.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).

        Returns
        -------
        (float, numpy.ndarray, float), optional
            The length, the vertices, the first one again at the end, and the lower bound; the path is a shortest one if the bound is its
            length. ``None`` if there is no such path.
        """
        ...
    def compare(self, walks: Iterable[ArrayLike], *, progress: _Progress = ...) -> list[ComparedWalk]:
        """What closed walks are: whether they can be contracted, bound, and which are homotopic.

        Parameters
        ----------
        walks : sequence of array_like of int
            Closed paths of vertices along edges, the first one again at the end.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).

        Returns
        -------
        list of dict
            ``contractible``, ``bounds``, ``word``, ``homotopic`` and ``freely_homotopic`` (numbers of other walks that are).
        """
        ...
    def model(self) -> Model:
        """The surface as a model."""
        ...
    def to_dict(self) -> dict[str, Json]:
        """This as a dictionary of JSON: ``recipe`` says how it is made again by ``from_dict``."""
        ...
    @classmethod
    def from_dict(cls, facts: Mapping[str, Any]) -> Surface:
        """The answer that ``to_dict()`` wrote."""
        ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __len__(self) -> int: ...
    def __repr__(self) -> str: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Verdict:
    """An answer with what shows that it is right: true, false, or unknown.

    In conditions it is its answer; ``bool`` of an unknown one raises.
    """
    def _repr_html_(self) -> str: ...
    @property
    def answer(self) -> bool | None:
        """``True``, ``False``, or ``None`` where it could not be decided or the notion does not apply."""
        ...
    @property
    def kind(self) -> str | None:
        """What sort of thing is in the way."""
        ...
    @property
    def message(self) -> str | None:
        """The same in words."""
        ...
    @property
    def cells(self) -> list[list[int]]:
        """The cells that show it, each by its vertices."""
        ...
    @property
    def closed(self) -> bool | None:
        """Whether a manifold has no boundary."""
        ...
    def __bool__(self) -> bool: ...
    def __repr__(self) -> str: ...
    def to_dict(self) -> dict[str, Json]:
        """The verdict as a dictionary."""
        ...
    @staticmethod
    def from_dict(verdict: Any) -> Verdict:
        """The verdict that :meth:`to_dict` wrote."""
        ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class YinSet:
    """A set of the plane that is regular, open and semianalytic: bounded by polylines or splines, itself bounded or not.

    Sets do not change; an edit gives a new one, and one that fails leaves everything as it was.

    Parameters
    ----------
    curves : sequence of Curve
        Boundaries with the set on their left, pairwise disjoint but for single points. Outermost ones that run clockwise leave everything
        outside of them, with an :class:`AssumptionWarning`. Their kinks are kinks of the set; so are corners of splines, with a warning.
    orient : bool
        Whether curves are turned so that they bound what is inside of them: those in no other counterclockwise, those in others against the one
        around them.
    """
    def _repr_html_(self) -> str: ...
    def plot(self, **options: Any) -> Any:
        """Draw this with matplotlib: :func:`plot` with the same options."""
        ...
    @property
    def bounding_box(self) -> list[list[float]] | None:
        """The lower left and upper right corners of the smallest box; ``None`` without curves."""
        ...
    @property
    def perimeter(self) -> float:
        """The length of the boundary."""
        ...
    @property
    def curve_counts(self) -> list[int]:
        """How many curves have the set inside, and how many outside."""
        ...
    @property
    def betti_open(self) -> list[int]:
        """Components and holes of the open set."""
        ...
    @property
    def betti_closed(self) -> list[int]:
        """Components and holes of the closed set."""
        ...
    @property
    def atoms(self) -> list[list[int]]:
        """For each connected component the numbers of its curves."""
        ...
    def _picture(self, format: str, size: tuple[int, int], transparent: bool) -> bytes: ...
    def to_dict(self) -> dict[str, Json]:
        """The set as a dictionary, in the words of the program's JSON, with its curves in ``recipe``, which ``from_dict`` reads."""
        ...
    @property
    def curve_facts(self) -> list[dict[str, Json]]:
        """For each curve ``sign``, ``area``, ``length``, ``knots``, ``kinks``, ``parent``, ``depth``, ``name``."""
        ...
    def __new__(cls, curves: Sequence[Curve], *, orient: bool = False) -> YinSet: ...
    @staticmethod
    def read(path: str | os.PathLike[str], format: str | None = None, *, order: int | None = None, rule: str | None = None, kinks: str | float | Sequence[tuple[int, int]] | None = None, ends: str = "not-a-knot", fit: bool = False, canonical: bool = False, flatten: float | None = None, allow_outside: bool = False, progress: _Progress = ...) -> YinSet:
        """Reads a set from a file: SVG, GeoJSON, WKT, JSON, ``.dat`` or any drawing with rings.

        Parameters
        ----------
        path : str or os.PathLike
            The file.
        format : str, optional
            The format, if it is not to be found out.
        order : {2, 4, 6, 8}, optional
            The order of the curves.
        rule : {"nonzero", "evenodd", "positive"}, optional
            What rings that cross contain.
        kinks : "none", "all", float, or list of (int, int), optional
            Where curves may turn: nowhere, everywhere, where polylines turn by more degrees, or at these (curve, knot).
        ends : {"not-a-knot", "natural"}
            What holds at kinks.
        fit : bool
            Whether points are fitted again.
        canonical : bool
            Whether the unique form is made.
        flatten : float, optional
            How far the polylines of curved paths may be from the curves, where the order is 2.
        allow_outside : bool
            Whether other files that the file names may lie outside of its folder: allow it for files that you trust.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).
        """
        ...
    @staticmethod
    def from_rings(rings: Sequence[ArrayLike], *, order: int = 2, rule: str | None = None, kinks: str | float | Sequence[tuple[int, int]] | None = None, ends: str = "not-a-knot", canonical: bool = False, progress: _Progress = ...) -> YinSet:
        """A set bounded by rings of points.

        Parameters
        ----------
        rings : sequence of array_like, each of shape (n, 2)
            Rings; the first point may stand at the end again.
        order : {2, 4, 6, 8}
            2 for polylines, 4 for cubic splines through the points, ..
        rule : {"nonzero", "evenodd", "positive"}, optional
            What rings that cross contain; without it the set lies to the left of each ring: inside of one that runs counterclockwise. Outermost
            rings that run clockwise leave everything outside of them, with an :class:`AssumptionWarning`.
        kinks : "none", "all", float, or list of (int, int), optional
            Where splines may turn.
        ends : {"not-a-knot", "natural"}
            What holds at kinks.
        canonical : bool
            Whether the unique form is made.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).
        """
        ...
    @staticmethod
    def from_model(model: Any, *, order: int | None = None, rule: str | None = None, kinks: str | float | Sequence[tuple[int, int]] | None = None, progress: _Progress = ...) -> YinSet:
        """The rings of a planar model as a set."""
        ...
    @staticmethod
    def from_shapely(geometry: Any, *, order: int = 2, rule: str | None = None, kinks: str | float | Sequence[tuple[int, int]] | None = None, progress: _Progress = ...) -> YinSet:
        """The polygons of a geometry of shapely, or of a list of them, as a set.

        Parameters
        ----------
        geometry
            Polygons with holes, in any direction.
        order
            2 for polylines, 4 for cubic splines through the points, ...
        rule
            What is inside rings that cross: ``"nonzero"``, ``"evenodd"`` or ``"positive"``.
        kinks
            Where splines may turn, as in :meth:`YinSet.from_rings`.
        progress
            As for :func:`homology`.

        Returns
        -------
        YinSet
            Coordinates go over exactly.
        """
        ...
    def to_shapely(self, *, flatten: float | None = None) -> Any:
        """The set as polygons of shapely, with holes.

        Parameters
        ----------
        flatten
            How far chords may be from curves; not needed for polylines, whose coordinates go over exactly.

        Returns
        -------
        shapely.Polygon or shapely.MultiPolygon
        """
        ...
    @staticmethod
    def empty(order: int = 2) -> YinSet:
        """The set without points."""
        ...
    @staticmethod
    def plane(order: int = 2) -> YinSet:
        """The whole plane."""
        ...
    @staticmethod
    def combine(operation: str, sets: Sequence[YinSet], *, progress: _Progress = ...) -> YinSet:
        """Any formula on any number of sets.

        Parameters
        ----------
        operation : str
            ``"meet"``, ``"join"``, ``"difference"``, ``"xor"``, or a formula of sets by number, such as ``"(0 | 1) & !2"``.
        sets : sequence of YinSet
            The sets.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).

        Returns
        -------
        YinSet
            The set; its :attr:`provenance` says where each piece of the boundary comes from.
        """
        ...
    def complement(self) -> YinSet:
        """The set of all points not in its closure; also ``~``."""
        ...
    def meet(self, other: YinSet) -> YinSet:
        """The regularized intersection; also ``&``."""
        ...
    def join(self, other: YinSet) -> YinSet:
        """The regularized union; also ``|``."""
        ...
    def difference(self, other: YinSet) -> YinSet:
        """The regularized difference; also ``-``."""
        ...
    def symmetric_difference(self, other: YinSet) -> YinSet:
        """What lies in exactly one of the two; also ``^``."""
        ...
    def sample(
        self, *, per_piece: int | None = ..., count: int | None = ..., spacing: float | None = ...
    ) -> BoundarySamples: ...
    def curvature(self) -> list[CurveBend]:
        """How the curves bend: the least and the greatest curvature of each, and where it turns most at a knot.

        Returns
        -------
        list of dict
            For each curve ``curve``, ``least`` and ``greatest`` (curvatures, positive where the curve turns left, with the set on its left),
            ``sharpest`` (the knot at which it turns most, in degrees) and ``roughest`` (the same among knots that are no kinks; ``None`` if all
            are), each with ``piece``, ``parameter``, ``point`` and ``value``.
        """
        ...
    def transformed(self, matrix: ArrayLike, offset: tuple[float, float] = ...) -> YinSet:
        """The image under an affine map of the plane; curves and kinks keep their names.

        Parameters
        ----------
        matrix : array_like of shape (2, 2)
            The matrix of the map, by rows. It has an inverse.
        offset : (float, float)
            Where the origin goes.

        Returns
        -------
        YinSet
            The set of all ``matrix @ point + offset``.
        """
        ...
    def compare(self, other: YinSet) -> SetComparison:
        """How far another set is from this one: ``area_xor`` (the area of the symmetric difference; ``None`` if it is infinite) and
        ``area_xor_error`` (an estimate from above, about 1e-14 of the box), ``area_signed``, ``area_signed_error``, ``hausdorff`` (of the
        boundaries), ``along_normals`` (the greatest distance along the normals of this boundary) and ``curvature`` (the greatest difference of
        curvatures where these normals meet the other), each with its ``_error``; ``normals_left_out`` (the part of this boundary whose normals
        do not meet the other within twice the Hausdorff distance), ``components`` and ``holes`` of both.
        """
        ...
    @classmethod
    def from_dict(cls, facts: Mapping[str, Any]) -> YinSet:
        """The answer that ``to_dict()`` wrote."""
        ...
    def __invert__(self) -> YinSet: ...
    def __and__(self, other: YinSet, /) -> YinSet: ...
    def __rand__(self, other: YinSet, /) -> YinSet: ...
    def __or__(self, other: YinSet, /) -> YinSet: ...
    def __ror__(self, other: YinSet, /) -> YinSet: ...
    def __sub__(self, other: YinSet, /) -> YinSet: ...
    def __rsub__(self, other: YinSet, /) -> YinSet: ...
    def __xor__(self, other: YinSet, /) -> YinSet: ...
    def __rxor__(self, other: YinSet, /) -> YinSet: ...
    def is_subset_of(self, other: YinSet) -> bool:
        """Whether every point is in the other set; also ``<=``."""
        ...
    def __le__(self, other: YinSet, /) -> bool: ...
    def __ge__(self, other: YinSet, /) -> bool: ...
    @property
    def is_empty(self) -> bool:
        """Whether it has no points."""
        ...
    @property
    def is_plane(self) -> bool:
        """Whether it is the whole plane."""
        ...
    @property
    def is_bounded(self) -> bool:
        """Whether it lies in some disk."""
        ...
    @property
    def area(self) -> float:
        """The area; inf of an unbounded set. That of a bounded set which is beyond the range of numbers is an error."""
        ...
    @property
    def order(self) -> int:
        """The order of its curves."""
        ...
    @property
    def curves(self) -> list[Curve]:
        """The boundary curves, with the set on their left."""
        ...
    @property
    def remarks(self) -> list[str]:
        """What was odd about the input."""
        ...
    @property
    def provenance(self) -> dict[str, Json] | None:
        """Of a combination, ``sources``: for each curve and piece ``[operand, curve, piece, from, to]``; and ``uncertified`` decisions."""
        ...
    @property
    def kinks(self) -> Kinks:
        """The kinks."""
        ...
    def insert_kink(self, curve: int | str, knot: int) -> tuple[YinSet, int]:
        """The set with one more kink.

        Parameters
        ----------
        curve : int or str
            The number of the curve, or its name.
        knot : int
            The number of the knot.

        Returns
        -------
        set : YinSet
            The curve fitted again.
        vertex : int
            The name of the kink.
        """
        ...
    def insert_kink_near(self, point: ArrayLike) -> tuple[YinSet, int]:
        """The set with one more kink, at the knot that is nearest to a point.

        Parameters
        ----------
        point : array_like, shape (2,)
            The point.

        Returns
        -------
        set : YinSet
            The curve fitted again.
        vertex : int
            The name of the kink.
        """
        ...
    def erase_kink(self, vertex: int) -> tuple[YinSet, int]:
        """The set without the kink of this name.

        Parameters
        ----------
        vertex : int
            The name of the kink.

        Returns
        -------
        set : YinSet
            The curve fitted again.
        vertex : int
            The name of the kink that is gone.
        """
        ...
    def erase_kink_near(self, point: ArrayLike) -> tuple[YinSet, int]:
        """The set without the kink that is nearest to a point.

        Parameters
        ----------
        point : array_like, shape (2,)
            The point.

        Returns
        -------
        set : YinSet
            The curve fitted again.
        vertex : int
            The name of the kink that is gone.
        """
        ...
    def reset_kinks(self, kinks: str | float | Sequence[tuple[int, int]] | None) -> YinSet:
        """The set with these kinks and no others: ``"none"``, ``"all"``, an angle in degrees, or pairs (curve, knot)."""
        ...
    def canonical(self) -> YinSet:
        """The unique form: curves in order, each from its least knot."""
        ...
    def locate(self, points: ArrayLike) -> NDArray[np.int8]:
        """Where points lie.

        Parameters
        ----------
        points : array_like, shape (n, 2)
            The points.

        Returns
        -------
        numpy.ndarray of int8
            1 inside, 0 on the boundary, -1 outside.
        """
        ...
    def __contains__(self, point: Any, /) -> bool: ...
    def cut_cells(self, counts: tuple[int, int] = ..., *, origin: Sequence[float] | None = None, spacing: Sequence[float] | None = None, progress: _Progress = ...) -> CutCells:
        """The set on a Cartesian grid.

        Parameters
        ----------
        counts : (int, int)
            Columns and rows.
        origin : (float, float), optional
            The lower left corner; of the bounding box, if left out.
        spacing : (float, float), optional
            The size of cells; so that the bounding box is covered, if left out.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).

        Returns
        -------
        CutCells
            The part of each cell that the set covers.
        """
        ...
    def advected(self, flow: str | Callable[..., Any], end: float | None = None, *, step: float | None = None, spacing: float | None = None, period: float = 4.0, vortices: int = 4, velocity: Sequence[float] = ..., center: Sequence[float] = ..., speed: float = 1.0, verify: str = "each-step", repair: str | None = None, scheme: str | None = None, parameters: str | None = None, least_ratio: float = 0.1, turn: float | None = None, keep_small: bool = False, events: bool = False, event_tolerance: float | None = None, on_contact: str | None = None, contact_distance: float | None = None, progress: _Progress = ...) -> tuple[YinSet, dict[str, Json]]:
        """The set after it moved with a flow.

        Parameters
        ----------
        flow : str or callable
            ``"vortex"``, ``"deformation"``, ``"rotation"``, ``"translation"``, two expressions of x, y, t and T (the period) as in
            ``"-y*cos(pi*t/T); x*cos(pi*t/T)"``, or a function. One of (points, t) gets an array of shape (n, 2) and gives one of velocities,
            all at once; one of (x, y, t) gives the velocity of one point, and is called for each. The first call tells which it is.
        end : float, optional
            The time at the end; the period, or 1.
        step : float, optional
            The time step; a hundredth of the time if left out.
        spacing : float, optional
            The largest distance of points along curves; a hundredth of the size if left out.
        period : float
            Of vortex and deformation.
        vortices : int
            Of deformation.
        velocity : (float, float)
            Of translation.
        center : (float, float)
            Of rotation.
        speed : float
            Of rotation.
        verify : {"each-step", "end", "never"}
            When it is checked that curves do not cross.
        repair : {"nonzero", "evenodd", "positive"}, optional
            The rule by which curves that cross are cut and pasted, instead of refused.
        scheme : {"midpoint", "classical", "verner", "cooper-verner"}, optional
            The Runge-Kutta scheme, of order 2, 4, 6 or 8; that of the order of the set if left out.
        parameters : {"lengths", "kept"}, optional
            What the parameters of splines are: the distances of neighbors, as in cubic MARS, or those that knots had at the beginning, which are
            more exact by far unless the velocity jumps along the boundary. Lengths in orders 2 and 4, kept in orders 6 and 8, if left out.
        least_ratio : float
            The least distance of points along curves as a part of ``spacing``, up to 1/3.
        turn : float, optional
            Points are added where the polygon through them turns by more degrees.
        keep_small : bool
            Keep curves that become short beside ``spacing``: they have points nearer together. Otherwise they leave the set, with an
            :class:`AssumptionWarning`, when they are shorter than three times the least distance.
        events : bool
            Whether changes of the topology are listed, with their times narrowed down within steps.
        event_tolerance : float, optional
            How exactly; a thousandth of the step if left out.
        on_contact : {"keep", "merge"}, optional
            What to do where parts of the boundary come nearer to each other than ``contact_distance``: ``"merge"`` joins the set across gaps
            and cuts it through necks, ``"keep"`` goes on with the curves as they are, with an :class:`AssumptionWarning`, and is an error only
            if they cross at the end. Left out, contacts are not looked for, and crossing is an error at once. Events are listed too.
        contact_distance : float, optional
            The least distance of points along curves if left out. With ``"merge"`` curves whose mean width is below half of it vanish.
        progress : bool or callable, optional
            ``True`` shows a bar; a function is called with (stage, done, total).

        Returns
        -------
        set : YinSet
            The set.
        facts : dict
            ``steps``, ``added``, ``removed``, ``vanished``, ``repairs``, and ``events``: ``None`` unless asked for, else dictionaries with
            ``time``, ``kind``, ``words``, ``place``, ``before`` and ``after``, as ``coface yin advect --events`` gives them.
        """
        ...
    def to_bytes(self, format: str, *, flatten: float | None = None) -> bytes:
        """The set as a file of this format.

        Parameters
        ----------
        format : str
            ``"json"`` keeps everything; ``"svg"``, ``"geojson"``, ``"wkt"``, ``"dat"``, ..
        flatten : float, optional
            How far polylines may be from curves, where the format has polylines only.
        """
        ...
    def write(self, path: _File, format: str | None = None, *, flatten: float | None = None) -> None:
        """Writes the set to a file, by its path or open for writing."""
        ...
    def to_svg(self, kind: str = "kinks") -> str:
        """A picture: SVG.

        Parameters
        ----------
        kind : {"set", "kinks", "forest"}
            The set, the set with its kinks, or how curves lie in each other.
        """
        ...
    def __bool__(self) -> bool: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __repr__(self) -> str: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class _Memory:
    """Keeps memory of the library alive as long as an array looks at it."""
    ...

def arrange(models: Any, *, dimension: int | None = None, rule: str | None = None, features: bool = False, inputs: str | None = None, prune: bool = False, snap: bool = False, exact: bool = False, grid: float | None = None, close: bool = False, tolerance: float | None = None, weld: float | None = None, method: str | None = None, max_cells: int | None = None, split: bool = True, merge_coplanar: bool = True, precision: str = "double", progress: _Progress = ...) -> PlanarArrangement | SpatialArrangement:
    """What segments cut the plane into, or polygons space, exactly.

    Parameters
    ----------
    models : Model, sequence of Model, or dict of str to Model
        The inputs.
    dimension : {2, 3}, optional
        The plane or space; by the models if left out. 2 leaves out the heights of maps.
    rule : {"nonzero", "evenodd", "positive"}, optional
        What is inside an input.
    features : bool
        The same as ``inputs="features"``.
    inputs : {"files", "features", "objects", "groups", "components"}, optional
        What an input is: a model, or its polygons of one name, its objects, groups or connected components.
    prune : bool
        In the plane, whether edges that hang on the rest by one end are left out.
    snap : bool
        Whether coordinates are rounded so that the result stays as it is.
    exact : bool
        Whether the exact result is kept where rounding its coordinates makes edges or faces cross; otherwise these are cut and bent
        there by a few units of the last digit. Its model, and ``.json`` written of it, keep exact points, so that the next call takes it
        as it is.
    grid : float, optional
        In the plane, all coordinates are multiples of this length.
    close : bool
        In the plane, whether lines that end where they begin are rings of polygons.
    tolerance : float, optional
        Vertices, edges, in space faces and planes too, at most so far apart are put together, in the unit of the inputs.
    weld : float, optional
        Before anything else, vertices of each model that are at most so far apart are merged; none moves farther.
    method : {"exact", "congruence"}, optional
        How cells are found: ``"congruence"`` cuts each segment, in space each polygon in its own plane, for itself, in rounded numbers,
        and pieces that are within ``tolerance`` of each other become one; without it within 1e-9 of the extent, with a warning.
    max_cells : int, optional
        More cells than this are refused.
    split : bool
        In space, whether polygons that are not flat are split into triangles; otherwise they are refused.
    merge_coplanar : bool
        In space, whether faces of polygons in one plane are merged.
    precision : {"double", "single"}
        In space, which numbers coordinates of the result are, of 64 bits or of 32: it is valid with these.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    PlanarArrangement or SpatialArrangement
        The cells, what contains them, and where they come from.
    """
    ...
def graphml(graph: str) -> str:
    """A graph of cells, the text of its JSON, as GraphML.

    Parameters
    ----------
    graph : str
        What ``json.dumps(graph.to_dict())`` gives.

    Returns
    -------
    str
        The text of the file.
    """
    ...
def boolean(operation: str, models: Any, *, dimension: int | None = None, rule: str | None = None, features: bool = False, inputs: str | None = None, keep_walls: bool = False, snap: bool = False, exact: bool = False, grid: float | None = None, close: bool = False, tolerance: float | None = None, weld: float | None = None, method: str | None = None, max_cells: int | None = None, split: bool = True, merge_coplanar: bool = True, triangles: bool | None = None, open: str = "refuse", split_pinches: bool = False, precision: str = "double", progress: _Progress = ...) -> PlanarBoolean | SolidBoolean:
    """Combines regions of the plane, or solids, exactly.

    Parameters
    ----------
    operation : str
        ``"union"``, ``"intersection"``, ``"difference"``, ``"xor"``, or a formula of inputs by number, such as ``"(0 | 1) & !2"``.
    models : sequence of Model, or dict of str to Model
        The inputs.
    dimension : {2, 3}, optional
        The plane or space; by the models if left out. 2 leaves out the heights of maps.
    rule : {"nonzero", "evenodd", "positive"}, optional
        What is inside an input.
    features : bool
        The same as ``inputs="features"``.
    inputs : {"files", "features", "objects", "groups", "components"}, optional
        What an input is: a model, or its polygons of one name, its objects, groups or connected components.
    keep_walls : bool
        Whether what lies inside the result is kept.
    snap : bool
        Whether coordinates are rounded so that the result stays as it is.
    exact : bool
        Whether the exact result is kept where rounding its coordinates makes edges or faces cross; otherwise these are cut and bent
        there by a few units of the last digit. Its model, and ``.json`` written of it, keep exact points, so that the next call takes it
        as it is.
    grid : float, optional
        In the plane, all coordinates are multiples of this length.
    close : bool
        In the plane, whether lines that end where they begin are rings of polygons.
    tolerance : float, optional
        Vertices, edges, in space faces and planes too, at most so far apart are put together, in the unit of the inputs.
    weld : float, optional
        Before anything else, vertices of each model that are at most so far apart are merged; none moves farther.
    method : {"exact", "congruence"}, optional
        How cells are found, as for :func:`arrange`.
    max_cells : int, optional
        More cells than this are refused.
    split : bool
        In space, whether polygons that are not flat are split into triangles; otherwise they are refused.
    merge_coplanar : bool
        In space, whether faces of polygons in one plane are merged.
    triangles : bool, optional
        In space, whether faces are cut into triangles; if all inputs are triangles, if left out.
    open : {"refuse", "close"}
        In space, what becomes of an input with a rim: it is refused, or its mouths are closed with patches of least area.
    split_pinches : bool
        In space, whether edges and vertices where the result is no surface are duplicated.
    precision : {"double", "single"}
        In space, which numbers coordinates of the result are, of 64 bits or of 32: it is valid with these.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    PlanarBoolean or SolidBoolean
        The result, which is input again.

    Raises
    ------
    NotACycleError
        If an input is open; the message names its rim.
    """
    ...
def dissolve(models: Any, names: Sequence[str], *, dimension: int | None = None, rule: str | None = None, snap: bool = False, exact: bool = False, grid: float | None = None, close: bool = False, max_cells: int | None = None, progress: _Progress = ...) -> Model:
    """Features of maps with the same values of properties, united: one feature for each list of values.

    Parameters
    ----------
    models : sequence of Model, or dict of str to Model
        The maps.
    names : sequence of str
        The names of the properties.
    dimension : {2}, optional
        2 leaves out the heights of maps.
    rule : {"nonzero", "evenodd", "positive"}, optional
        What is inside a ring.
    snap : bool
        Whether coordinates are rounded so that the result stays as it is.
    exact : bool
        Whether the exact result is kept where rounding its coordinates makes edges cross.
    grid : float, optional
        All coordinates are multiples of this length.
    close : bool
        Whether lines that end where they begin are rings of polygons.
    max_cells : int, optional
        More cells than this are refused.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    Model
        A map with a feature for each list of values.
    """
    ...
def map_task(models: Any, task: str, *, method: str = "structure", length: float | None = None, error: float | None = None, joins: str = "round", mitre_limit: float = 5.0, caps: str = "round", frame: Sequence[float] | None = None, snap: bool = False, grid: float | None = None, tolerance: float | None = None, progress: _Progress = ...) -> tuple[Model, dict[str, Json]]:
    """A map repaired, buffered, clipped, noded, made polygons, simplified, or examined as a coverage.

    Parameters
    ----------
    models : sequence of Model, or dict of str to Model
        The maps.
    task : {"repair", "buffer", "clip", "node", "polygonize", "simplify", "coverage"}
        What is done.
    method : {"structure", "linework"}
        What is inside of a polygon that is not valid.
    length : float, optional
        The distance of a buffer, the tolerance of a simplification, the width of gaps that are faults.
    error : float, optional
        How far flattened arcs of a buffer may be from true ones; a thousandth of the distance if left out.
    joins : {"round", "mitre", "bevel"}
        How corners of a buffer are joined.
    mitre_limit : float
        How many times the distance a mitred corner may be away.
    caps : {"round", "flat", "square"}
        How the ends of lines are closed.
    frame : sequence of four float, optional
        The box of clip: least x, least y, greatest x, greatest y.
    snap : bool
        Whether coordinates of node and polygonize are rounded, and lines cut again, until all vertices are where their coordinates say.
    grid : float, optional
        The length of which all coordinates of node and polygonize are multiples.
    tolerance : float, optional
        How far apart vertices and lines of node and polygonize may be that are put together.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    tuple of Model and dict
        The new map, and what was done in numbers.
    """
    ...
def _chains(of: Model | Complex) -> ChainComplex: ...
def _named_chains(boundaries: Any, names: Sequence[Sequence[Sequence[int]]]) -> ChainComplex: ...
def congruence(models: Any, tolerance: float, *, greedy: bool = False, representative: str = "lowest", stable: bool = False, collisions: str = "rewrap", blocks: str = "models", within_blocks: str = "allow", method: str = "lists", progress: _Progress = ...) -> Congruence:
    """Merges models within a tolerance.

    Parameters
    ----------
    models : Model, sequence of Model, or dict of str to Model
        The models.
    tolerance : float
        How near vertices become one, in the unit of the models.
    greedy : bool
        Whether a class is what is near its first vertex, instead of chains of near vertices.
    representative : {"lowest", "mean", "median"}
        Where a class is.
    stable : bool
        Whether classes are merged again until none are near.
    collisions : {"rewrap", "keep", "refuse"}
        What becomes of cells that lose terms without vanishing.
    blocks : {"models", "components", "none"}
        What a block is, for merges within one.
    within_blocks : {"allow", "warn", "forbid"}
        Whether vertices of one block may become one.
    method : {"lists", "matrices"}
        How it is computed; the result is the same.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    Congruence
        The quotient, with the classes and signs of all cells.
    """
    ...
def generate(family: str, *, boundary: bool = False, skeleton: int | None = None, progress: _Progress = ..., **parameters: Any) -> Model:
    """A model made by rule: a grid, a shape with positions, or a known space.

    Shapes are oriented coherently where that is possible, closed surfaces with the normal outward, solids positively.

    Parameters
    ----------
    family : str
        The name of the family, or another name of it such as ``cube``; :func:`families` lists them. ``_`` and ``-`` are the same.
    boundary : bool
        The boundary of the model instead: the facets of exactly one cell.
    skeleton : int, optional
        The cells of this dimension instead, after ``boundary``.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).
    **parameters
        Those of ``coface generate FAMILY``, with ``_`` for ``-``: ``major_radius=3.0``, ``columns=64``, ``shape=(2, 3)``, ``cuboids=True``, which
        is also called ``quadrangles`` and ``hexahedra``.

    Returns
    -------
    Model
        The model.
    """
    ...
def families() -> list[str]:
    """The families that :func:`generate` knows.

    Returns
    -------
    list of str
        Their names.
    """
    ...
def extruded(model: Any, heights: Sequence[float], *, progress: _Progress = ...) -> Model:
    """A model of points, segments, triangles or facets swept through layers: segments become triangles, triangles tetrahedra.

    Parameters
    ----------
    model : Model or Complex
        The model.
    heights : sequence of float
        The heights of the layers, negative where a layer is empty.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    Model
        The sweep, with one more axis; of facets a facet list.
    """
    ...
def product(first: Any, second: Any, *, chains: bool = False, progress: _Progress = ...) -> Model:
    """The product of two models: of simplices a simplicial complex, its cells cut along staircases; else a chain complex.

    Parameters
    ----------
    first, second : Model or Complex
        The factors.
    chains : bool
        Whether products of cells are kept as they are, for simplices too.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    Model
        A facet list, or a chain complex.
    """
    ...
def _bytes_of(model: Model, format: str) -> bytes: ...
def entries(path: str | os.PathLike[str], format: str | None = None) -> list[str]:
    """The models of a file that holds several.

    Parameters
    ----------
    path : str or os.PathLike
        The file: a list of models in JSON, JSON lines, or isomorphism signatures.
    format : str, optional
        The format, such as ``"json"``, if it is not to be found out.

    Returns
    -------
    list of str
        Their names, or their places from 1: what :func:`read` takes behind a ``#``. Empty for a file of one model.
    """
    ...
def read(path: str | os.PathLike[str], format: str | None = None, *, flatten: float | None = None, lod: float | None = None, strict: bool = False, partial: bool = False, allow_outside: bool = False, pseudomanifold: bool = False, progress: _Progress = ...) -> Model:
    """Reads a model from a file; its content and its name decide the format.

    Parameters
    ----------
    path : str, os.PathLike or file
        The file, or one that is open for reading. One model of several is ``file.json#name``: see :func:`entries`.
    format : str, optional
        The format, such as ``"off"``, if it is not to be found out.
    flatten : float, optional
        How far the polylines of curved SVG paths may be from the curves.
    lod : float, optional
        The level of detail of CityJSON; the highest of each object if left out.
    strict : bool
        Whether everything that the reader would assume, with an :class:`AssumptionWarning`, is an error instead.
    partial : bool
        Whether a damaged file is read up to its first fault.
    allow_outside : bool
        Whether other files that the file names may lie outside of its folder: allow it for files that you trust.
    pseudomanifold : bool
        Whether ideal vertices of a triangulation of a 3-manifold are points; otherwise they are cut off, which leaves a manifold with boundary.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    Model
        What the file holds.

    Raises
    ------
    FileError
        If the file cannot be read.
    ParseError
        If it breaks the rules of its format, with the line or byte.
    """
    ...
def _model(parts: Mapping[str, Any]) -> Model: ...
def _volume(voxels: NDArray[np.bool_], periodic: Sequence[int]) -> Model: ...
def _read_volume(path: str | os.PathLike[str], voxels: tuple[str, tuple[float, float], Sequence[int]], allow_outside: bool = False, progress: _Progress = ...) -> Model: ...
def persistence(complex: ChainComplex, *, vertex_values: ArrayLike | None = None, cell_values: Sequence[ArrayLike] | None = None, coefficients: str | int = ..., upper: bool = False, least: float = 0.0, part: Sequence[Sequence[int]] | None = None, image: bool = False, progress: _Progress = ...) -> Persistence:
    """Persistent homology of a filtration by values.

    Parameters
    ----------
    complex : ChainComplex
        The complex.
    vertex_values : array_like of float, optional
        A value for each vertex in the order of the complex; a cell enters with its last vertex.
    cell_values : sequence of array_like, optional
        For each degree a value for each cell; NaN where a cell enters as late as its cofaces allow.
    coefficients : str or int
        A prime field: ``"f2"``, ``"f3"``, ...
    upper : bool
        Whether a cell enters with its first vertex and values fall.
    least : float
        Classes that live no longer than this are left out.
    part : list of list of int, optional
        For each degree the cells of a part, relative to which persistence is.
    image : bool
        Whether it is that of the part, as the complex sees it.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    Persistence
        The diagram.
    """
    ...
def _diagram_distance(first: Any, second: Any, *, order: float | None = None, internal_p: float = ..., degree: int | None = None) -> tuple[float, list[NDArray[np.int64]]]: ...
def alpha(table: Any, *, weighted: bool = False, bound: float | None = None, radii: bool = False, periods: ArrayLike | None = None, coefficients: str | int = ..., least: float = 0.0, progress: _Progress = ...) -> Persistence:
    """Persistent homology of the alpha complex of points.

    Parameters
    ----------
    table : array_like of float
        Rows of at most three coordinates, and the weight behind them if points have weights.
    weighted : bool
        Whether points have weights.
    bound : float, optional
        The value at which the complex ends.
    radii : bool
        Whether values are radii instead of squared radii.
    periods : array_like of float, optional
        The lengths after which the points repeat, one for each coordinate.
    coefficients : str or int
        A prime field: ``"f2"``, ``"f3"``, ...
    least : float
        Classes that live no longer than this are left out.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    Persistence
        The diagram.
    """
    ...
def alpha_complex(table: Any, *, weighted: bool = False, bound: float | None = None, radii: bool = False, periods: ArrayLike | None = None) -> Model:
    """The alpha complex of points as a model.

    Parameters
    ----------
    table : array_like of float
        As of :func:`alpha`.
    weighted : bool
        As of :func:`alpha`.
    bound : float, optional
        As of :func:`alpha`.
    radii : bool
        As of :func:`alpha`.
    periods : array_like of float, optional
        As of :func:`alpha`.

    Returns
    -------
    Model
        Tetrahedra, triangles, edges and points; with periods a list of simplices, or of few points a chain complex, without positions.
    """
    ...
def _cells_of_part(complex: ChainComplex, pair: ChainComplex) -> list[list[int]]: ...
def _extended_persistence(complex: ChainComplex, vertex_values: ArrayLike, *, coefficients: str | int = ..., least: float = 0.0) -> list[tuple[str, int, float, float]]: ...
def _euler_curve(complex: ChainComplex, *, vertex_values: ArrayLike | None = None, cell_values: Sequence[ArrayLike] | None = None, upper: bool = False, at: int | ArrayLike | None = None, smooth: bool = False, progress: _Progress = ...) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...
def _euler_curve_of_image(values: NDArray[Any], *, construction: str = "t", superlevel: bool = False, periodic: Sequence[int] = ..., mask: NDArray[np.bool_] | None = None, at: int | ArrayLike | None = None, smooth: bool = False, progress: _Progress = ...) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...
def _euler_transform(complex: ChainComplex, positions: NDArray[np.float64], directions: int | NDArray[np.float64], *, at: int | ArrayLike | None = None, normalize: bool = False, smooth: bool = False, progress: _Progress = ...) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]: ...
def _vineyard(complex: ChainComplex, functions: Sequence[ArrayLike], *, coefficients: str | int = ..., least: float = 0.0, progress: _Progress = ...) -> list[tuple[int, NDArray[np.float64]]]: ...
def _zigzag(steps: Any, times: list[list[float]] | None = None, *, coefficients: str | int = ..., least: float = 0.0) -> list[tuple[str, int, float, float]]: ...
def cech(table: Any, *, threshold: float | None = None, dimension: int = ..., coefficients: str | int = ..., least: float = 0.0, progress: _Progress = ...) -> Persistence:
    """Persistent homology of the Čech complex of points.

    Parameters
    ----------
    table : array_like of float
        Rows of coordinates.
    threshold : float, optional
        The largest radius of balls.
    dimension : int
        The highest degree of classes.
    coefficients : str or int
        A prime field: ``"f2"``, ``"f3"``, ...
    least : float
        Classes that live no longer than this are left out.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    Persistence
        The diagram.
    """
    ...
def cech_complex(table: Any, *, threshold: float | None = None, dimension: int | None = None) -> Model:
    """The Čech complex of points as a model.

    Parameters
    ----------
    table : array_like of float
        Rows of coordinates.
    threshold : float, optional
        As of :func:`cech`.
    dimension : int, optional
        The highest dimension of simplices, 2 if not given.

    Returns
    -------
    Model
        Tetrahedra, triangles, edges and points, or simplices.
    """
    ...
def flag(graph: Any, *, directed: bool = False, dimension: int = ..., threshold: float | None = None, coefficients: str | int = ..., least: float = 0.0, collapse: bool = False, progress: _Progress = ...) -> Persistence:
    """Persistent homology of the flag complex of a weighted graph.

    Parameters
    ----------
    graph : str or array_like of float
        The path of a file, or rows of two vertices and the value of their edge, or of a vertex twice and its value.
    directed : bool
        Whether edges have directions.
    dimension : int
        The highest degree of classes.
    threshold : float, optional
        The largest value of simplices.
    coefficients : str or int
        A prime field: ``"f2"``, ``"f3"``, ...
    least : float
        Classes that live no longer than this are left out.
    collapse : bool
        Whether edges are collapsed before.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    Persistence
        The diagram.
    """
    ...
def flag_complex(graph: Any, *, directed: bool = False, threshold: float | None = None, dimension: int | None = None) -> Model:
    """The flag complex of a graph as a model.

    Parameters
    ----------
    graph : str or array_like of float
        As of :func:`flag`.
    directed : bool
        As of :func:`flag`.
    threshold : float, optional
        As of :func:`flag`.
    dimension : int, optional
        The highest dimension of simplices, 2 if not given.

    Returns
    -------
    Model
        Simplices, or a chain complex if edges have directions.
    """
    ...
def rips_complex(table: Any, *, form: str | None = None, threshold: float | None = None, dimension: int | None = None) -> Model:
    """The Vietoris-Rips complex of points or distances as a model.

    Parameters
    ----------
    table : array_like of float
        As of :func:`rips`.
    form : str, optional
        As of :func:`rips`.
    threshold : float, optional
        As of :func:`rips`.
    dimension : int, optional
        The highest dimension of simplices, 2 if not given.

    Returns
    -------
    Model
        Tetrahedra, triangles, edges and points, or simplices.
    """
    ...
def witness(table: Any, landmarks: int, *, strong: bool = False, threshold: float | None = None, dimension: int = ..., coefficients: str | int = ..., least: float = 0.0, progress: _Progress = ...) -> Persistence:
    """Persistent homology of the witness complex of landmarks.

    Parameters
    ----------
    table : array_like of float
        Rows of coordinates.
    landmarks : int
        How many landmarks are chosen.
    strong : bool
        Whether all landmarks of a simplex are as near to a witness as the nearest one.
    threshold : float, optional
        The largest value.
    dimension : int
        The highest degree of classes.
    coefficients : str or int
        A prime field: ``"f2"``, ``"f3"``, ...
    least : float
        Classes that live no longer than this are left out.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    Persistence
        The diagram.
    """
    ...
def mapper(table: Any, values: ArrayLike | None, *, intervals: int, overlap: float, threshold: float | None = None) -> tuple[Model, list[NDArray[np.int64]]]:
    """The Mapper complex of points as a model, and the points of its vertices.

    Parameters
    ----------
    table : array_like of float
        Rows of coordinates.
    values : array_like of float, optional
        The function on the points; the largest distance to another point if not given.
    intervals : int
        How many intervals cover the range of the function.
    overlap : float
        How much of each interval lies in the next.
    threshold : float, optional
        Points within this distance are neighbors.

    Returns
    -------
    tuple of Model and list of numpy.ndarray
        The model, and for each vertex the numbers of its points.
    """
    ...
def witness_complex(table: Any, landmarks: int, *, strong: bool = False, threshold: float | None = None, dimension: int | None = None) -> Model:
    """The witness complex of landmarks as a model.

    Parameters
    ----------
    table : array_like of float
        Rows of coordinates.
    landmarks : int
        As of :func:`witness`.
    strong : bool
        As of :func:`witness`.
    threshold : float, optional
        As of :func:`witness`.
    dimension : int, optional
        The highest dimension of simplices, 2 if not given.

    Returns
    -------
    Model
        Tetrahedra, triangles, edges and points, or simplices.
    """
    ...
def rips(table: Any, *, form: str | None = None, dimension: int = ..., threshold: float | None = None, coefficients: str | int = ..., least: float = 0.0, collapse: bool = False, progress: _Progress = ...) -> Persistence:
    """Persistent homology of the Vietoris-Rips filtration of points or distances.

    Parameters
    ----------
    table : array_like of float
        Rows of numbers.
    form : {"points", "lower", "upper", "square", "sparse"}, optional
        What the rows are: coordinates, distances to the points before or behind or to all, or two points and their distance; by default what they
        look like.
    dimension : int
        The highest degree of classes.
    threshold : float, optional
        The largest diameter of simplices; the enclosing radius if not given.
    coefficients : str or int
        A prime field: ``"f2"``, ``"f3"``, ...
    least : float
        Classes that live no longer than this are left out.
    collapse : bool
        Whether edges are collapsed before.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    Persistence
        The diagram.
    """
    ...
def cubical(values: NDArray[Any], *, construction: str = "t", superlevel: bool = False, periodic: Sequence[int] = ..., mask: NDArray[np.bool_] | None = None, coefficients: str | int = ..., least: float = 0.0, cycles: bool = False, progress: _Progress = ...) -> Persistence:
    """Persistent homology of the sublevel or superlevel sets of an image.

    Parameters
    ----------
    values : numpy.ndarray
        ``float64`` or ``float32``, contiguous.
    construction : {"t", "v"}
        Whether voxels are top cells or vertices.
    superlevel : bool
        Whether superlevel sets grow.
    periodic : sequence of int
        The axes whose last voxels meet the first.
    mask : numpy.ndarray, optional
        ``bool``, contiguous: the voxels that are inside.
    coefficients : str or int
        A prime field: ``"f2"``, ``"f3"``, ...
    least : float
        Classes that live no longer than this are left out.
    cycles : bool
        Whether the cubes are kept, for cycles.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    Persistence
        The diagram.
    """
    ...
def _values_of_volume(path: str | os.PathLike[str]) -> NDArray[np.float64] | None: ...
def _certificate(path: str | os.PathLike[str], of: str, coefficients: str | int, cohomology: bool, reduced: bool, relative: str | os.PathLike[str] | None, generators: bool, progress: _Progress = ...) -> str: ...
def _persistence_certificate(path: str | os.PathLike[str], coefficients: str | int, function: str | Sequence[float] | None, upper_star: bool, min_persistence: float, extended: bool = False, relative: str | os.PathLike[str] | None = None, image_of: str | os.PathLike[str] | None = None, progress: _Progress = ...) -> str: ...
def _zigzag_certificate(path: str | os.PathLike[str], coefficients: str | int, min_persistence: float, progress: _Progress = ...) -> str: ...
def _points_certificate(path: str | os.PathLike[str], kind: str, coefficients: str | int, dimension: int, threshold: float | None, superlevel: bool, min_persistence: float, progress: _Progress = ...) -> str: ...
def _surface_certificate(path: str | os.PathLike[str], of: str, simplify: bool, along: Sequence[int] | None, radius: int | None, copies: int | None, orientation: bool, component: int, progress: _Progress = ...) -> str: ...
def _walks_certificate(path: str | os.PathLike[str], walks: list[list[int]], base: int | None, progress: _Progress = ...) -> str: ...
def _congruence_certificate(paths: list[str | os.PathLike[str]], tolerance: float, greedy: bool, progress: _Progress = ...) -> str: ...
def _drawing_certificate(paths: list[str | os.PathLike[str]], operation: str | None, rule: str | None, exact: bool, progress: _Progress = ...) -> str: ...
def _check(certificate: bytes, inputs: Sequence[str | os.PathLike[str]], progress: _Progress = ...) -> tuple[list[str], list[str], list[str]]: ...
def _interface_of_text(text: bytes) -> Interface: ...
def _interface(names: Sequence[str], sets: Sequence[YinSet], overlaps: str, smooth: float, progress: _Progress = ...) -> Interface: ...
def _label_sets(width: int, labels: Sequence[int]) -> list[tuple[str, YinSet]]: ...
def _feature_sets(model: Model, order: int | None = None) -> list[tuple[str, YinSet]] | None: ...
def fundamental_groups(model: Any, *, simplify: bool = True, base: int | None = None, time_limit: float | None = None, progress: _Progress = ...) -> list[FundamentalGroup]:
    """The fundamental groups of the components of a complex.

    Parameters
    ----------
    model : Model, Complex or ChainComplex
        What is asked about; cells have to say how they are attached.
    simplify : bool
        Whether presentations are made short by Tietze moves.
    base : int, optional
        The vertex that loops of its component start from.
    time_limit : float, optional
        Seconds for simplifying and recognizing a group.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    list of FundamentalGroup
        One for each component.
    """
    ...
def render(model: Any, format: str = "svg", *, results: Sequence[Any] = ..., size: tuple[int, int] = ..., camera: Sequence[float] | None = None, up: Sequence[float] | None = None, perspective: float | None = None, edges: bool | None = None, dark: bool = False, transparent: bool = False, line_width: float | None = None, edge_width: float | None = None, label: Sequence[str] = ..., star: Any = None, closure: Any = None, link: Any = None, legend: bool = False, spin: int | None = None, witness: bool = False, title: str = "model", members: Sequence[tuple[str, int, int, tuple[int, int, int] | None]] = ..., progress: _Progress = ...) -> bytes:
    """A still picture of a model, hidden lines removed, or an animation.

    Parameters
    ----------
    model : Model, Complex or ChainComplex
        What is shown.
    format : {"svg", "png", "pdf", "gif", "webp"}
        The format; PDF has vectors, a pixel is 0.75 points; GIF is an animation.
    results : sequence of dict
        Answers to be shown over it, as ``to_dict()`` gives them.
    size : (int, int)
        Width and height in pixels.
    camera : (float, float, float), optional
        The direction from which it is seen.
    up : (float, float, float), optional
        What is up.
    perspective : float, optional
        The angle of view in degrees; parallel if left out.
    edges : bool, optional
        Whether edges are drawn; if left out, where they can be distinguished.
    dark : bool
        Whether the background is dark.
    transparent : bool
        Whether what lies behind the picture shows through, in place of a background.
    line_width, edge_width : float, optional
        The widths of the lines of answers and of edges, in points; 2.25 and 0.45 if left out.
    label : sequence of {"vertices", "edges", "faces"}
        Cells whose numbers are written beside them.
    star, closure, link : simplices, optional
        Simplices; what they have around them is drawn over the pale complex.
    legend : bool
        Whether the names of what is drawn over the model stand above it.
    spin : int, optional
        So many frames, in which the model turns once about what is up: an animated GIF, PNG or WebP, 24 frames a second.
    witness : bool
        Whether what is wrong is marked.
    title : str
        What it is called.
    members : sequence of (str, int, int, (int, int, int) or None)
        Of several models that stand in one: the name of each, its first vertex, the one behind its last, its color as red, green and blue.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    bytes
        The content of the file.
    """
    ...
def _matrix_picture(complex: ChainComplex, format: str, size: tuple[int, int], transparent: bool) -> bytes: ...
def _schema_picture(of: Any, format: str, size: tuple[int, int], transparent: bool, title: str) -> bytes: ...
def _sequence_picture(model: Any, part: Any, format: str, size: tuple[int, int], transparent: bool, title: str) -> bytes: ...
def _blocked_matrix_picture(model: Any, degree: int, blocks: str, format: str, size: tuple[int, int], transparent: bool, title: str) -> bytes: ...
def matrix_svg(complex: ChainComplex, title: str = "boundary matrices") -> str:
    """The boundary matrices of a complex as a picture: blue entries are positive, orange ones negative.

    Parameters
    ----------
    complex : ChainComplex
        The complex.
    title : str
        What it is called.

    Returns
    -------
    str
        SVG.
    """
    ...
def classes(complex: ChainComplex, cycles: Sequence[Any], *, degree: int | None = None, progress: _Progress = ...) -> list[CycleClass]:
    """The classes of cycles in integral homology, and whether they bound.

    Parameters
    ----------
    complex : ChainComplex
        The complex.
    cycles : sequence
        Cycles as :meth:`ChainComplex.chain` takes them.
    degree : int, optional
        Their degree, where they do not say it.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    list of dict
        ``class``: coefficients in the generators; ``orders`` of these, 0 for infinite; ``bounds``; ``multiple``: the least that bounds;
        ``bounding``: a chain whose boundary is that multiple; ``cocycle`` and ``value``: what shows that no multiple bounds.
    """
    ...
def harmonic(complex: ChainComplex, degree: int, *, weights: Sequence[ArrayLike] | None = None, progress: _Progress = ...) -> NDArray[np.float64]:
    """Harmonic cochains of a degree, dual to the free generators of homology.

    Parameters
    ----------
    complex : ChainComplex
        The complex.
    degree : int
        The degree.
    weights : sequence of array_like, optional
        For each degree a positive weight for each cell; 1 if left out.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    numpy.ndarray
        ``float64``, shape (rank, cells): one row for each cochain.
    """
    ...
def decompose(complex: ChainComplex, degree: int, values: ArrayLike, *, weights: Sequence[ArrayLike] | None = None, progress: _Progress = ...) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """The Hodge decomposition of a real cochain.

    Parameters
    ----------
    complex : ChainComplex
        The complex.
    degree : int
        The degree.
    values : array_like
        A value for each cell.
    weights : sequence of array_like, optional
        For each degree a positive weight for each cell; 1 if left out.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    exact, coexact, harmonic : numpy.ndarray
        Orthogonal parts that add up to the cochain.
    """
    ...
def laplacian(complex: ChainComplex, degree: int, *, progress: _Progress = ...) -> csc_array:
    """The combinatorial Laplacian of a degree: boundary times coboundary and coboundary times boundary.

    Parameters
    ----------
    complex : ChainComplex
        The complex.
    degree : int
        The degree.

    Returns
    -------
    scipy.sparse.csc_array
        Symmetric, with integer entries.
    """
    ...
def matching(complex: ChainComplex, degree: int, *, progress: _Progress = ...) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """A discrete gradient field: cells matched with faces, and critical cells.

    Parameters
    ----------
    complex : ChainComplex
        The complex.
    degree : int
        The degree of the faces.

    Returns
    -------
    critical : numpy.ndarray
        The critical cells of the degree.
    pairs : numpy.ndarray of shape (n, 2)
        Faces of the degree and the cells of the next one that they are matched with.
    """
    ...
def invariant_factors(matrix: Any, *, progress: _Progress = ...) -> list[int]:
    """The diagonal of the Smith normal form of an integer matrix, each entry dividing the next.

    Parameters
    ----------
    matrix : sparse array or array_like
        Integers of 32 bits.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    list of int
        The entries that are not zero.
    """
    ...
def cup_products(model: Any, p: int, q: int, coefficients: str | int = ..., *, progress: _Progress = ...) -> CupTable:
    """Cup products of a basis of cohomology in degree p with one in degree q, in a basis of degree p + q.

    Parameters
    ----------
    model : Model or Complex
        Simplices, or a gluing table.
    p, q : int
        The degrees.
    coefficients : str or int
        ``"z"``, ``"f2"``, ..
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    dict
        ``table[i][j]``: the coefficients of the product of class i and class j; ``first``, ``second``, ``target``: cocycles as lists of
        (coefficient, vertices); ``first_orders``, ``second_orders``, ``target_orders``.
    """
    ...
def intersection_form(model: Any, *, progress: _Progress = ...) -> IntersectionForm:
    """The intersection form of a closed oriented manifold of even dimension.

    Parameters
    ----------
    model : Model or Complex
        The manifold, of simplices.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    dict
        ``matrix``, ``rank``, ``determinant``, ``symmetric``, ``signature``, ``parity``, ``definiteness``, ``name``, ``basis``.
    """
    ...
def long_exact_sequence(model: Any, part: Any, *, progress: _Progress = ...) -> ExactSequence:
    """The long exact sequence of a pair, checked to be exact.

    Parameters
    ----------
    model : Model or Complex
        The whole.
    part : "boundary", Model or Complex
        The part.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    dict
        ``part``, ``whole`` and ``pair``: homology; ``inclusion``, ``projection`` and ``connecting``: for each degree a map or ``None``, with
        ``matrix`` (columns are images of generators), ``image``, ``kernel`` and ``cokernel``.
    """
    ...
def induced_map(source: Any, target: Any, vertices: Any, *, progress: _Progress = ...) -> list[GroupMap]:
    """The maps on integral homology that a simplicial map induces.

    Parameters
    ----------
    source, target : Model or Complex
        Simplicial complexes.
    vertices : dict of int to int, or sequence of (int, int)
        The image of each vertex.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    list of dict
        For each degree ``matrix`` (columns are images of generators), ``source_orders``, ``target_orders``, ``kernel``, ``cokernel``.
    """
    ...
def is_exact(model: Any, values: ArrayLike, *, tolerance: float | None = None, progress: _Progress = ...) -> Exactness:
    """Whether a cochain of degree 1 is closed, and whether it is exact.

    Parameters
    ----------
    model : Model or Complex
        What it is a cochain on.
    values : array_like
        A value for each edge, in the order of the chain complex; integers are decided exactly.
    tolerance : float, optional
        Which sums count as zero, for real values.
    progress : bool or callable, optional
        ``True`` shows a bar; a function is called with (stage, done, total).

    Returns
    -------
    dict
        ``closed`` and ``exact``; ``potential`` of an exact one; ``walk`` and ``period`` of a closed one that is not; ``face`` and ``sum`` of one
        that is not closed.
    """
    ...
def _group(generators: int, relators: Sequence[Sequence[int]], base: int | None, loops: Sequence[Sequence[int]], model: Model | None) -> FundamentalGroup: ...
def _surface(model: Any, boundary: bool) -> Surface: ...
def _page(model: Any, title: str, results: Sequence[Any], report: bool, members: Sequence[tuple[str, int, int, tuple[int, int, int] | None]] = ..., progress: _Progress = ...) -> str: ...
def _curve(order: int, controls: ArrayLike, knots: ArrayLike, kinks: ArrayLike | None = None) -> Curve: ...
def _yin_set(bytes: bytes, provenance: str | None = None) -> YinSet: ...
def _report(model: Model, asked: tuple[Sequence[Sequence[int]], str, float | None]) -> Report: ...
def _in_python(message: str) -> str: ...
def _batch_lines(files: Sequence[str | os.PathLike[str]], options: Mapping[str, Any], progress: _Progress = ...) -> list[str]: ...
def _batch_write(files: Sequence[str | os.PathLike[str]], out: str | os.PathLike[str], options: Mapping[str, Any], progress: _Progress = ...) -> tuple[int, dict[str, int], int]: ...
def _signatures_write(files: Sequence[str | os.PathLike[str]], out: str | os.PathLike[str], groups: bool, pseudomanifold: bool, jobs: int | None, progress: _Progress = ...) -> tuple[int, dict[str, int], int]: ...
@final
class _SignatureRows:
    """The rows of lists of signatures as lines of JSON, as they are asked for."""
    def __new__(cls, files: Sequence[str | os.PathLike[str]], groups: bool, pseudomanifold: bool, jobs: int | None) -> _SignatureRows: ...
    def __iter__(self) -> _SignatureRows: ...
    def __next__(self) -> str: ...
def _replace_file(path: str | os.PathLike[str], data: bytes) -> None: ...
def _copy_file(source: str | os.PathLike[str], target: str | os.PathLike[str]) -> None: ...
def _table_of_lines(lines: str | os.PathLike[str], out: str | os.PathLike[str], timings: bool) -> None: ...
def _find_files(words: Sequence[str | os.PathLike[str]], recursive: bool) -> list[os.PathLike[str]]: ...
def _flat_line(line: str, timings: bool) -> str: ...
def _serve(fetch: Callable[[str], bytes]) -> None: ...
def _shard(model: Any, folder: str | os.PathLike[str], parts: int, memory: int | None, fan_in: int, name: str, replace: bool, progress: _Progress = ...) -> int: ...
def _reduce(shard: bytes, progress: _Progress = ...) -> bytes: ...
def _merge(children: Sequence[bytes], complex: int, parts: int, fan_in: int, level: int, number: int, progress: _Progress = ...) -> bytes: ...
def _summary(reduced: bytes) -> dict[str, Any]: ...
def _shard_checksum(start: bytes, length: int) -> int: ...
def _root_homology(root: bytes) -> Homology: ...
def _folder_homology(folder: str | os.PathLike[str], replace: bool, progress: _Progress = ...) -> tuple[Homology, list[int], list[dict[str, Any]], int]: ...
def _image_block_count(cut: tuple[Any, ...]) -> int: ...
def _image_window(cut: tuple[Any, ...], number: int) -> list[list[int]]: ...
def _image_window_checksum(cut: tuple[Any, ...], number: int, values: NDArray[np.float64]) -> int: ...
def _image_part(cut: tuple[Any, ...], number: int, values: NDArray[np.float64]) -> bytes: ...
def _merge_image_parts(parts: Sequence[bytes]) -> bytes: ...
def _image_part_summary(part: bytes) -> dict[str, Any]: ...
def _image_part_diagram(part: bytes, construction: str, periodic: bool, least: float, progress: _Progress = ...) -> Persistence: ...
