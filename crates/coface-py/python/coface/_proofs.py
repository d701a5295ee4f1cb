"""Certificates of answers that are there already: the input is written to files, and the proof is about those."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from inspect import signature
from pathlib import Path
from typing import Any, NoReturn

import numpy as np

from coface import _coface, _questions
from coface._arrays import raise_invalid
from coface._certificates import certificate
from coface._coface import (
    Cocycles,
    Congruence,
    Cover,
    Domain,
    FundamentalGroup,
    Homology,
    Model,
    Persistence,
    PlanarArrangement,
    PlanarBoolean,
    Report,
    SolidBoolean,
    SpatialArrangement,
)
from coface._models import as_chain_complex, as_model

#: The answers that have a proof.
CERTIFIED = (
    Cocycles,
    Congruence,
    Cover,
    Domain,
    FundamentalGroup,
    Homology,
    Persistence,
    PlanarArrangement,
    PlanarBoolean,
    Report,
    SolidBoolean,
    SpatialArrangement,
)
_File = str | os.PathLike[str]
#: From the arguments and options of a recipe: the word of a certificate, its inputs, and its options.
_Question = Callable[[Any, dict[str, Any]], tuple[str, list[Any], dict[str, Any]]]


def _method(self: Any, path: _File | Sequence[_File], *, progress: Any = False) -> str:
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

    Examples
    --------
    >>> import coface
    >>> proof = coface.homology(coface.generate("rp2")).certificate("rp2.json")
    >>> coface.check(proof)["proved"]
    ['H_0 = Z', 'H_1 = Z/2', 'H_2 = 0']
    """
    name, inputs, options = _question(self)
    asked = {key: value for key, value in options.items() if value is not None}
    paths = [path] if isinstance(path, (str, os.PathLike)) else list(path)
    if len(paths) != len(inputs):
        raise_invalid(
            f"the answer is of {len(inputs)} {'input' if len(inputs) == 1 else 'inputs'}, and {len(paths)} {'path is' if len(paths) == 1 else 'paths are'} given",
            "give a path for each, in their order",
        )
    for x, at in zip(inputs, paths):
        _put(x, Path(at), is_surface=name in _OF_SURFACES)
    return certificate(paths if len(paths) > 1 or name in ("arrange", "boolean", "congruence") else paths[0], name, progress=progress, **asked)  # type: ignore[arg-type]


#: The questions whose certificates are of surfaces.
_OF_SURFACES = ("cut", "cover", "cocycles", "pi1", "info")


def _question(answer: Any) -> tuple[str, list[Any], dict[str, Any]]:
    """What was asked: the word of the certificate, the inputs, and its options."""
    if isinstance(answer, Report):
        return "info", [answer.__reduce__()[1][0]], {}
    told = getattr(answer, "__dict__", {})
    if "asked" in told:
        name, x, options = told["asked"]
        return name, [x], dict(options)
    if "recipe" not in told:
        raise_invalid(f"this {type(answer).__name__} does not know what it was asked of", "write the input to a file and ask coface.certificate(path, ..)")
    name, arguments, options = told["recipe"]
    return _OF_RECIPES[name](arguments, dict(options)) if name in _OF_RECIPES else _refuse(f"the answer of {name}")


def _refuse(what: str) -> NoReturn:
    raise_invalid(f"{what} has no certificate", "see help(coface.certificate) for the questions that have one")


def _only(asker: Callable[..., Any], options: Mapping[str, Any], **takes: str) -> dict[str, Any]:
    """The options by their names in a certificate; refuses those that it does not know, unless they have the value that nobody need give."""
    usual = {name: parameter.default for name, parameter in signature(asker).parameters.items()}
    for key, value in options.items():
        plain = tuple(value) if isinstance(value, list) else value
        if key not in takes and value is not None and plain != usual.get(key):
            _refuse(f"an answer with {key}={value!r}")
    return {new: options[old] for old, new in takes.items() if options.get(old) is not None}


def _of_models(models: Any) -> list[Any]:
    return list(models.values()) if isinstance(models, Mapping) else list(models)


def _arranged(arguments: Any, options: dict[str, Any]) -> tuple[str, list[Any], dict[str, Any]]:
    return "arrange", _of_models(arguments[0]), _only(_questions.arrange, options, rule="rule", exact="exact")


def _booleans(arguments: Any, options: dict[str, Any]) -> tuple[str, list[Any], dict[str, Any]]:
    told = _only(_questions.boolean, options, rule="rule", exact="exact")
    return "boolean", _of_models(arguments[1]), {**told, "operation": arguments[0]}


def _congruence(arguments: Any, options: dict[str, Any]) -> tuple[str, list[Any], dict[str, Any]]:
    told = _only(_questions.congruence, options, greedy="greedy")
    return "congruence", _of_models(arguments[0]), {**told, "tolerance": arguments[1]}


def _points(kind: str, asker: Callable[..., Any], **takes: str) -> _Question:
    def question(arguments: Any, options: dict[str, Any]) -> tuple[str, list[Any], dict[str, Any]]:
        # Whether cells are kept makes no other answer.
        options.pop("cycles", None)
        if options.pop("form", None) is not None:
            _refuse("persistence of distances")
        if kind == "alpha" and not options.pop("radii"):
            raise_invalid("certificates of alpha complexes have radii, and this answer their squares", "ask coface.alpha(points, radii=True)")
        told = _only(asker, {**options, "weighted": options.get("weighted") or None}, coefficients="coefficients", least="min_persistence", **takes)
        return "persistence", [np.asarray(arguments[0])], {**told, "points": kind}

    return question


def _surface(name: str, asker: Callable[..., Any], **takes: str) -> _Question:
    def question(arguments: Any, options: dict[str, Any]) -> tuple[str, list[Any], dict[str, Any]]:
        if len(arguments) > 1:
            options["along"] = arguments[1]
        return name, [arguments[0].model()], _only(asker, options, **takes)

    return question


#: How the recipes of answers are asked as certificates.
_OF_RECIPES: dict[str, _Question] = {
    "alpha": _points("alpha", _questions.alpha, bound="threshold"),
    "arrange": _arranged,
    "boolean": _booleans,
    "cech": _points("cech", _questions.cech, threshold="threshold", dimension="dimension"),
    "congruence": _congruence,
    "cubical": _points("image", _questions.cubical, superlevel="upper_star"),
    "rips": _points("rips", _questions.rips, threshold="threshold", dimension="dimension"),
    "Surface.cocycles": _surface("cocycles", _questions.cocycles),
    "Surface.cover": _surface("cover", _questions.cover, radius="radius", copies="copies", component="component"),
    "Surface.cut": _surface("cut", _questions.cut, simplify="simplify", along="along"),
}


def _put(x: Any, path: Path, *, is_surface: bool) -> None:
    """Writes an input where a certificate reads it, unless it is there."""
    content = _bytes_of(x, path, is_surface=is_surface)
    try:
        with open(path, "xb") as file:
            file.write(content)
    except FileExistsError:
        if path.read_bytes() != content:
            raise_invalid(f"{os.fspath(path)!r} is there and does not hold the input of this answer", "give a path where nothing is")
    except OSError as fault:
        message, cure = f"the input cannot be written: {fault.strerror}", "give a path in a folder that is there"
        raise _coface.FileError(f"{os.fspath(path)!r}: {message}; {cure}", fault=message, cure=cure, file=os.fspath(path)) from fault


def _bytes_of(x: Any, path: Path, *, is_surface: bool) -> bytes:
    kind = path.suffix.lower()
    if isinstance(x, np.ndarray):
        if kind == ".npy":
            import io

            file = io.BytesIO()
            np.save(file, x)
            return file.getvalue()
        if kind not in (".txt", ".csv", ".xyz"):
            raise_invalid(f"{path.name!r} is no name of a file of points or voxels", "give a name such as points.txt, or image.npy for an image")
        return "".join(" ".join(map(repr, map(float, row))) + "\n" for row in x).encode()
    if kind not in (".json", ".off", ".obj", ".wkt", ".geojson"):
        raise_invalid(f"certificates are not about files named {path.name!r}", "give a name that ends with .json, .off or .obj, or .wkt for a drawing")
    model = as_model(x)
    # Halfedges, gluings, voxels and cells are checked as what they are: cells with boundaries.
    if kind == ".json" and not is_surface and (model.structure not in (None, "facets") or model.cells.keys() & _SOLID):
        model = as_model(as_chain_complex(model))
    return Model.to_bytes(model, kind[1:])


#: The kinds of 3-cells, as models name them.
_SOLID = {"tetra", "pyramid", "wedge", "hexahedron"}


def install() -> None:
    """Gives the classes their method."""
    for cls in CERTIFIED:
        setattr(cls, "certificate", _method)
