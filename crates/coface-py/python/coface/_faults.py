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
_NUMPY = os.path.dirname(os.path.abspath(np.__file__)) + os.sep


def in_words(function: Function) -> Function:
    """A function whose faults in arguments are of this package: a ``TypeError`` becomes :class:`InvalidTypeError`, which is both.

    What functions of the user raise, such as those that show progress, goes through as it is.

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
        except (TypeError, ValueError, OverflowError) as fault:
            if not _is_own(fault.__traceback__):
                raise
            kind = InvalidInputError
            if isinstance(fault, TypeError):
                kind = InvalidTypeError
            elif isinstance(fault, OverflowError):
                kind = OutOfRangeError
            name = function.__qualname__
            # What modules with a leading underscore define is found in the package itself; compiled methods name no module.
            module = getattr(function, "__module__", None) or "coface"
            if any(part.startswith("_") for part in module.split(".")):
                module = "coface"
            message, cure = f"{name}: {fault}", f"help({module}.{name}) says what it takes"
            raise kind(f"{message}; {cure}", fault=message, cure=cure) from fault

    return asked  # type: ignore[return-value]


def _is_own(place: TracebackType | None) -> bool:
    """Whether the last function of Python that was called is one of this package or of numpy."""
    if place is None:
        return True
    while place.tb_next is not None:
        place = place.tb_next
    name = os.path.abspath(place.tb_frame.f_code.co_filename)
    return name.startswith((_OWN, _NUMPY))


def compiled_in_words(names: dict[str, Any]) -> None:
    """The same for the compiled functions and the methods of the compiled classes among these names."""
    for name, thing in list(names.items()):
        if inspect.isbuiltin(thing):
            names[name] = asked = in_words(thing)
            # Where pickles look for it.
            asked.__module__ = "coface"
        elif inspect.isclass(thing) and thing.__module__ == "coface" and not issubclass(thing, BaseException):
            for member, value in list(vars(thing).items()):
                if inspect.ismethoddescriptor(value) and not member.startswith("_") and hasattr(value, "__objclass__"):
                    setattr(thing, member, in_words(value))
