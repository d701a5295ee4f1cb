"""Certificates: proofs of answers, which anyone can check."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any, Literal, TypedDict

from coface import _coface
from coface._faults import in_words

_Path = str | os.PathLike[str]


class Verified(TypedDict):
    """What a certificate proves."""

    #: The inputs in their order.
    files: list[str]
    #: The claims that were proved.
    proved: list[str]
    #: The keys of the answer for which there is no proof.
    unchecked: list[str]


@in_words
def certificate(
    path: _Path | Sequence[_Path],
    of: Literal["homology", "info", "persistence", "arrange", "boolean", "congruence", "cut", "cover", "cocycles", "pi1", "homotopic"] = "homology",
    *,
    coefficients: str | int | None = None,
    cohomology: bool = False,
    reduced: bool = False,
    relative: _Path | None = None,
    image_of: _Path | None = None,
    generators: bool = False,
    function: str | Sequence[float] | None = None,
    upper_star: bool = False,
    extended: bool = False,
    zigzag: bool = False,
    min_persistence: float = 0.0,
    points: Literal["rips", "alpha", "cech", "image"] | None = None,
    dimension: int = 1,
    threshold: float | None = None,
    operation: str | None = None,
    tolerance: float | None = None,
    greedy: bool = False,
    rule: str | None = None,
    exact: bool = False,
    simplify: bool = False,
    along: Sequence[int] | None = None,
    walks: Sequence[Sequence[int]] | None = None,
    base: int | None = None,
    radius: int | None = None,
    copies: int | None = None,
    orientation: bool = False,
    component: int = 0,
    progress: Any = False,
) -> str:
    """A proof of an answer about a file, which :func:`check` verifies without any code of what computed the answer.

    Parameters
    ----------
    path
        The file: a facet list or a chain complex in JSON, or a surface as plain OFF or OBJ. A certificate has the hash of a file; write a model
        first: ``model.write("model.json")``. For ``"arrange"`` and ``"boolean"`` one or several drawings in the plane: WKT or GeoJSON of two
        coordinates, or lines of four numbers. In space, and for ``"congruence"``, surfaces as plain OFF or OBJ.
    of
        ``"homology"``; ``"info"`` for the report: counts, components, manifold up to dimension 3, orientability, boundary loops and genus;
        ``"persistence"`` for the diagram of a function on the vertices: pairs with their cells, and Betti numbers;
        ``"arrange"`` for the cells of drawings: counts, areas, and which files contain each face; ``"boolean"`` for a result of drawings: area,
        components, holes and pinches; or of solids: volume, and that what is inside is what the operation says; ``"arrange"`` in space for the cells with their volumes; of surfaces ``"cut"`` for the disks that components are cut to, with the words around them, or what a path leaves, and
        ``"cover"`` for copies of the universal cover and their words, or the orientation double cover; ``"cocycles"`` for a basis of the first cohomology;
        ``"pi1"`` for the presentations of the fundamental groups; ``"homotopic"`` for closed walks on a surface: which can be contracted, which bound, and which
        are homotopic or homologous to each other; ``"congruence"`` for one or several models merged within a tolerance: the classes
        of the vertices, and the map of cells to classes.
    coefficients, cohomology, reduced, generators
        As for :func:`homology` and :func:`cohomology`; with generators it is proved that they generate the groups. ``None`` are the integers, for
        persistence the field of two elements.
    relative
        ``"boundary"``, or the file of a part that is divided out; of persistence also a group of the mesh.
    image_of
        Of persistence: a part in the same way, whose classes are taken as they are seen in the whole.
    function, upper_star, extended, zigzag, min_persistence
        Of persistence: ``"x"``, ``"y"`` or ``"z"``, or a number for each vertex, by default the last coordinate; whether cells enter from high values
        to low ones; whether it is :func:`extended_persistence`; whether the file has the steps of a :func:`zigzag`; pairs whose persistence is not greater are left out.
    points, dimension, threshold
        Of persistence of points, in rows of numbers as text, or of the vertices of OFF and OBJ: the complex that they make, the highest degree (not of ``"alpha"``), and the largest value. Of
        ``"rips"``, and of ``"image"``, the voxels of a .npy or .pgm file as cubes (from high values with `upper_star`), all is proved from the file, and of ``"alpha"`` without a threshold; of ``"cech"`` that the simplices and values are those of the points is not.
    operation
        Of a Boolean: ``"union"``, ``"intersection"``, ``"difference"``, ``"xor"``, or a formula of the files such as ``"(a | b) - c"``.
    tolerance, greedy
        Of a congruence: as for :func:`congruence`.
    rule, exact
        As for :func:`arrange` and :func:`boolean`. Where rounding moves vertices, only the exact result has a certificate.
    simplify, along
        Of a cut: as for :meth:`Surface.cut`, the path by its vertices. Of fundamental groups: the presentations that simplification gives.
    walks, base
        Of ``"homotopic"``: closed walks along edges, each by its vertices, the first one again at the end; the vertex where the loops of its component start and end.
    radius, copies, component
        Of a cover: as for :meth:`Surface.cover`.
    orientation
        The orientation double cover instead of the universal one.
    progress
        As for :func:`homology`.

    Returns
    -------
    str
        JSON, to be kept beside the file. The checker has accepted it already.

    Examples
    --------
    >>> import coface
    >>> coface.generate("rp2").write("plane.json")
    >>> proof = coface.certificate("plane.json")
    >>> coface.check(proof)["proved"]
    ['H_0 = Z', 'H_1 = Z/2', 'H_2 = 0']
    >>> coface.generate("torus").write("torus.off")
    >>> coface.check(coface.certificate("torus.off", "persistence"))["proved"][:2]
    ['the values of the vertices are z', 'Betti numbers over F_2 = [1, 2, 1]']
    >>> coface.check(coface.certificate("torus.off", "persistence", extended=True))["proved"][1]
    'Betti numbers over F_2 = [1, 2, 1]'
    >>> coface.check(coface.certificate("plane.json", "homotopic", walks=[[0, 1, 3, 0], [0, 1, 2, 0]]))["proved"][2]
    'of 2 walks, numbered from 0, those that can be contracted are [0]'
    """
    if of in ("arrange", "boolean"):
        paths = [path] if isinstance(path, (str, os.PathLike)) else list(path)
        if of == "boolean" and operation is None:
            raise _coface.InvalidInputError("a Boolean has an operation; give operation=\"union\" or a formula of the files")
        return _coface._drawing_certificate(paths, operation if of == "boolean" else None, rule, exact, progress)
    if of == "congruence":
        paths = [path] if isinstance(path, (str, os.PathLike)) else list(path)
        if tolerance is None:
            raise _coface.InvalidInputError("a congruence has a tolerance; give tolerance=0.01, the length within which vertices are one")
        return _coface._congruence_certificate(paths, tolerance, greedy, progress)
    if not isinstance(path, (str, os.PathLike)):
        raise _coface.InvalidInputError(f"a certificate of {of} is of one file; give its path")
    if of == "homotopic":
        if walks is None:
            raise _coface.InvalidInputError("walks are compared; give walks=[[0, 1, 2, 0], ..], each with its first vertex again at the end")
        return _coface._walks_certificate(path, [list(walk) for walk in walks], base, progress)
    if of in ("cut", "cover", "cocycles", "pi1"):
        along = None if along is None else list(along)
        return _coface._surface_certificate(path, of, simplify, along, radius, copies, orientation, component, progress)
    if of == "persistence":
        field = "f2" if coefficients is None else coefficients
        if points is not None:
            return _coface._points_certificate(path, points, field, dimension, threshold, upper_star, min_persistence, progress)
        if zigzag:
            if extended or upper_star or function is not None or points is not None:
                raise _coface.InvalidInputError("a zigzag has its steps; leave the function, points, extended and upper_star out")
            return _coface._zigzag_certificate(path, field, min_persistence, progress)
        if extended and upper_star:
            raise _coface.InvalidInputError("extended persistence has sublevel sets and superlevel sets; leave upper_star out")
        if relative is not None and image_of is not None:
            raise _coface.InvalidInputError("persistence is relative to a part, or of its image in the whole; give one of both")
        if extended and (relative is not None or image_of is not None):
            raise _coface.InvalidInputError("extended persistence is of a whole complex; leave relative and image_of out")
        return _coface._persistence_certificate(path, field, function, upper_star, min_persistence, extended, relative, image_of, progress)
    return _coface._certificate(path, of, "z" if coefficients is None else coefficients, cohomology, reduced, relative, generators, progress)


@in_words
def check(certificate: str | bytes | os.PathLike[str], *inputs: _Path, progress: Any = False) -> Verified:
    """Checks a certificate against its input, by a checker that shares no code with what computed the answer.

    Parameters
    ----------
    certificate
        What :func:`certificate` gave or ``--certificate`` of the program wrote: its text, its bytes, or the path of its file. Both forms are read, JSON and
        the binary one.
    inputs
        The files of that run in their order; those that the certificate names if they are left out.
    progress
        As for :func:`homology`.

    Returns
    -------
    Verified
        A dictionary: ``files``, ``proved`` (claims) and ``unchecked`` (keys of the answer for which there is no proof).

    Raises
    ------
    InvalidInputError
        If a step of the proof fails, which is named, or the certificate is of another file.

    Examples
    --------
    >>> import coface
    >>> coface.generate("torus").write("torus.off")
    >>> verified = coface.check(coface.certificate("torus.off", "info"), "torus.off")
    >>> "genus = 1" in verified["proved"], "area" in verified["unchecked"]
    (True, True)
    """
    if not isinstance(certificate, (bytes, str, os.PathLike)):
        message, cure = f"a {type(certificate).__name__} is no certificate", "give its text, its bytes, or the path of its file"
        raise _coface.InvalidTypeError(f"{message}; {cure}", fault=message, cure=cure)
    if isinstance(certificate, bytes):
        text = certificate
    elif isinstance(certificate, str) and certificate.lstrip().startswith("{"):
        text = certificate.encode()
    else:
        try:
            with open(certificate, "rb") as file:
                text = file.read()
        except OSError as fault:
            message, cure = f"the certificate cannot be read: {fault.strerror}", "give its text, or the path of its file"
            raise _coface.FileError(f"{certificate!r}: {message}; {cure}", fault=message, cure=cure, file=str(certificate)) from fault
    files, proved, unchecked = _coface._check(text, list(inputs), progress)
    return {"files": files, "proved": proved, "unchecked": unchecked}
