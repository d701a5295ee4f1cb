"""Faults in arguments are :class:`coface.Error` too, whatever found them."""

from __future__ import annotations

import functools
import inspect
import os
from collections.abc import Callable
from types import TracebackType
from typing import Any, TypeVar

import numpy as np

from coface._coface import Error, InvalidInputError, InvalidTypeError, OutOfRangeError

Function = TypeVar("Function", bound=Callable[..., Any])

_OWN = os.path.dirname(os.path.abspath(__file__)) + os.sep
#: What is called with arguments as they were given: numpy, scipy beside it, and the modules of Python for paths and texts.
_ALLOWED = (
    _OWN,
    *(os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(np.__file__))), name) + os.sep for name in ("numpy", "scipy")),
    os.path.splitext(os.path.abspath(os.__file__))[0],
    *(os.path.join(os.path.dirname(os.path.abspath(os.__file__)), name) for name in ("pathlib", "json", "re", "dataclasses.py", "functools.py")),
)


def in_words(function: Function, name: str | None = None) -> Function:
    """A function whose faults in arguments are of this package: a ``TypeError`` becomes :class:`InvalidTypeError`, which is both.

    What functions of the user raise, such as those that show progress, goes through as it is. `name` is the name by which users call the function,
    where it has another one.

    Examples
    --------
    >>> import coface
    >>> try:
    ...     coface.homology([[0, 1]], "z", 3)
    ... except coface.Error as error:
    ...     print(type(error).__name__, isinstance(error, TypeError))
    InvalidTypeError True
    """

    @functools.wraps(function)
    def asked(*arguments: Any, **options: Any) -> Any:
        try:
            return function(*arguments, **options)
        except Error:
            raise
        except (TypeError, ValueError, OverflowError, LookupError, AttributeError) as fault:
            if not _is_own(fault.__traceback__):
                raise
            kind = InvalidInputError
            if isinstance(fault, (TypeError, AttributeError)):
                kind = InvalidTypeError
            elif isinstance(fault, OverflowError):
                kind = OutOfRangeError
            known = name or _PUBLIC.get(function.__name__) or function.__qualname__
            # What modules with a leading underscore define is found in the package itself; compiled methods name no module.
            module = getattr(function, "__module__", None) or "coface"
            if name is not None or any(part.startswith("_") for part in module.split(".")):
                module = "coface"
            text = f"there is no {fault}" if isinstance(fault, KeyError) else str(fault)
            # Python names a function as it is defined.
            text = text.removeprefix(f"{function.__qualname__}() ")
            message, cure = f"{known}: {text}", f"help({module}.{known}) says what it takes"
            raise kind(f"{message}; {cure}", fault=message, cure=cure) from fault

    return asked  # type: ignore[return-value]


#: Functions that are methods by other names.
_PUBLIC = {"set_from_shapely": "YinSet.from_shapely", "set_to_shapely": "YinSet.to_shapely"}


def _is_own(place: TracebackType | None) -> bool:
    """Whether all functions of Python that were called are of this package, or of what it computes with: none is one of the user."""
    while place is not None:
        name = place.tb_frame.f_code.co_filename
        # Some functions of Python itself have no file.
        if not name.startswith("<") and not os.path.abspath(name).startswith(_ALLOWED):
            return False
        place = place.tb_next
    return True


def compiled_in_words(names: dict[str, Any]) -> None:
    """The same for the compiled functions and the methods of the compiled classes among these names."""
    for name, thing in list(names.items()):
        if inspect.isbuiltin(thing):
            names[name] = asked = in_words(thing)
            # Where pickles look for it.
            asked.__module__ = "coface"
        elif inspect.isclass(thing) and thing.__module__.partition(".")[0] == "coface" and not issubclass(thing, (BaseException, dict)):
            for member, value in list(vars(thing).items()):
                if member.startswith("_") and member not in ("__contains__", "__getitem__"):
                    continue
                called = f"{thing.__name__}.{member}"
                if isinstance(value, (staticmethod, classmethod)):
                    setattr(thing, member, type(value)(_named(in_words(value.__func__, called), thing, member)))
                elif inspect.isbuiltin(value):
                    # A compiled function of a class that takes none of its objects.
                    setattr(thing, member, staticmethod(_named(in_words(value, called), thing, member)))
                elif inspect.isfunction(value) or inspect.ismethoddescriptor(value) and hasattr(value, "__objclass__"):
                    setattr(thing, member, in_words(value, called))


def _named(function: Function, owner: type, member: str) -> Function:
    """The function with the place where pickles look for it."""
    function.__module__, function.__qualname__ = owner.__module__, f"{owner.__name__}.{member}"
    return function
