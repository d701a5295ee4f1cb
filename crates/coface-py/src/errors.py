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

    Examples
    --------
    >>> import coface
    >>> try:
    ...     coface.Complex([[0, 1, 2]]).star([[0, 7]])
    ... except coface.Error as error:
    ...     print(type(error).__name__, error.kind)
    NotInComplexError NotInComplex
    """

    _kind = None

    def __init__(self, message="", *, fault=None, cure=None, cells=(), file=None, line=None, byte=None):
        super().__init__(message)
        self.message = message if fault is None else fault
        self.cure = cure
        self.cells = [list(cell) for cell in cells]
        self.file = file
        self.line = line
        self.byte = byte

    @property
    def kind(self):
        """What sort of fault it is."""
        return (self._kind or type(self).__name__).removesuffix("Error")

    def __str__(self):
        return Exception.__str__(self)

    def __reduce__(self):
        state = {name: self.__dict__[name] for name in ("message", "cure", "cells", "file", "line", "byte")}
        return type(self), self.args, state


class FileError(Error, OSError):
    """A file or stream could not be opened, read or written."""


class ParseError(Error, ValueError):
    """The text or bytes break the rules of their format."""


class UnsupportedFormatError(Error, ValueError):
    """The format is unknown, or this part of it is not supported."""


class InvalidInputError(Error, ValueError):
    """The data is readable but cannot be what is asked for."""


class InvalidTypeError(InvalidInputError, TypeError):
    """An argument is of a type that cannot be what is asked for. Its kind is ``InvalidInput``."""

    _kind = "InvalidInput"


class OutOfRangeError(InvalidInputError, OverflowError):
    """A number is negative or too large where that cannot be. Its kind is ``InvalidInput``."""

    _kind = "InvalidInput"


class NotInComplexError(Error, KeyError):
    """A simplex, cell or vertex that was named is not there."""


class NoSuchPlaceError(NotInComplexError, IndexError):
    """A place beyond the ends of a list of answers. Its kind is ``NotInComplex``."""

    _kind = "NotInComplex"


class NotAComplexError(Error, ValueError):
    """A set of cells that had to be closed under faces is not."""


class NotPureError(Error, ValueError):
    """A complex that had to be pure is not."""


class BoundaryOfBoundaryError(Error, ValueError):
    """The boundary of a boundary is not zero."""


class NotACycleError(Error, ValueError):
    """A chain that had to be a cycle has a boundary."""


class ShapeError(Error, ValueError):
    """Matrices or chains of shapes that do not fit together."""


class TooLargeError(Error, OverflowError):
    """More cells, or larger numbers, than the representation holds."""


class NonManifoldError(Error, ValueError):
    """A surface operation met an edge or vertex that no surface has."""


class CoefficientError(Error, ValueError):
    """A coefficient that must be invertible is not, or two coefficients come from different rings."""


class NotInstalledError(Error, ImportError):
    """Another library is needed, and it cannot be imported; the cure installs it."""

    def __init__(self, message="", *, fault=None, cure=None, library=None, **place):
        super().__init__(message, fault=fault, cure=cure, **place)
        self.name = library


class AssumptionWarning(UserWarning):
    """What was assumed, changed or left out, of an input that says too little or contradicts itself, or on the way to an answer: what the program prints
    as a remark. Of reading, ``strict=True`` makes it an error.

    Examples
    --------
    >>> import coface, warnings
    >>> with warnings.catch_warnings(record=True) as found:
    ...     warnings.simplefilter("always")
    ...     _ = coface.Model.from_bytes("OFF\\n3 1 0\\n0 0 0\\n1 0 0\\n0 1 0\\n4 0 1 2 2\\n")
    >>> found[0].category.__name__
    'AssumptionWarning'
    """
