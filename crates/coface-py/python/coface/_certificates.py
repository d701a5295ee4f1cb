"""Certificates: proofs of answers, which anyone can check."""

from __future__ import annotations

import os
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
    path: _Path,
    of: Literal["homology", "info"] = "homology",
    *,
    coefficients: str | int = "z",
    cohomology: bool = False,
    reduced: bool = False,
    relative: _Path | None = None,
    generators: bool = False,
    progress: Any = False,
) -> str:
    """A proof of an answer about a file, which :func:`check` verifies without any code of what computed the answer.

    Parameters
    ----------
    path
        The file: a facet list or a chain complex in JSON, or a surface as plain OFF or OBJ. A certificate has the hash of a file; write a model
        first: ``model.write("model.json")``.
    of
        ``"homology"``, or ``"info"`` for the report: counts, components, manifold up to dimension 3, orientability, boundary loops and genus.
    coefficients, cohomology, reduced, generators
        As for :func:`homology` and :func:`cohomology`; with generators it is proved that they generate the groups.
    relative
        ``"boundary"``, or the file of a part that is divided out.
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
    """
    return _coface._certificate(path, of, coefficients, cohomology, reduced, relative, generators, progress)


@in_words
def check(certificate: str | bytes | os.PathLike[str], *inputs: _Path, progress: Any = False) -> Verified:
    """Checks a certificate against its input, by a checker that shares no code with what computed the answer.

    Parameters
    ----------
    certificate
        What :func:`certificate` gave or ``coface homology --certificate`` wrote: its text, or the path of its file.
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
    if isinstance(certificate, bytes):
        text = certificate
    elif isinstance(certificate, str) and certificate.lstrip().startswith("{"):
        text = certificate.encode()
    else:
        with open(certificate, "rb") as file:
            text = file.read()
    files, proved, unchecked = _coface._check(text, list(inputs), progress)
    return {"files": files, "proved": proved, "unchecked": unchecked}
