"""Conversions from and to other libraries, one file a library.

Nothing here is imported before it is needed: an object of another library is recognized by the name of the module that its class comes
from, and only a conversion *to* a library imports it.
"""

from __future__ import annotations

import importlib
from types import ModuleType
from typing import Any

import numpy as np

from coface._coface import NotInstalledError

#: The first part of a class's module, or its first two parts, and the file here that reads it.
ADAPTERS = {
    "gudhi": "gudhi",
    "ifcopenshell": "ifcopenshell",
    "meshio": "meshio",
    "networkx": "networkx",
    "open3d": "open3d",
    "pymeshlab": "pymeshlab",
    "pyvista": "pyvista",
    "scipy.spatial": "scipy",
    "vtkmodules": "pyvista",
    "shapely": "shapely",
    "topologic_core": "topologic",
    "trimesh": "trimesh",
}

#: What to install, where it is not the name that is imported.
_PACKAGES = {"skimage": "scikit-image", "sklearn": "scikit-learn", "vtkmodules": "vtk"}


def adapter_of(value: Any) -> ModuleType | None:
    """The file that reads objects of this class, or of a class that it comes from; ``None`` if there is none, and of arrays, such as the ``faces`` of trimesh."""
    if isinstance(value, np.ndarray):
        return None
    for base in type(value).__mro__:
        module = str(getattr(base, "__module__", ""))
        for name in (module.partition(".")[0], ".".join(module.split(".")[:2])):
            if name in ADAPTERS:
                return importlib.import_module(f"coface.interop.{ADAPTERS[name]}")
    return None


def needed(name: str, purpose: str) -> Any:
    """The module of this name.

    Raises
    ------
    NotInstalledError
        With the command that installs it; an ``ImportError`` too.

    Examples
    --------
    >>> needed("json", "writing JSON").dumps([1])
    '[1]'
    >>> needed("no_such_module", "an example")
    Traceback (most recent call last):
    ...
    coface.NotInstalledError: an example needs no_such_module, which is not installed; pip install no_such_module
    """
    try:
        return importlib.import_module(name)
    except ImportError as error:
        root = name.partition(".")[0]
        package = _PACKAGES.get(root, root)
        if isinstance(error, ModuleNotFoundError) and (error.name or "").partition(".")[0] == root:
            why = "which is not installed"
        else:
            why = f"which cannot be imported ({error})"
        message, cure = f"{purpose} needs {root}, {why}", f"pip install {package}"
        raise NotInstalledError(f"{message}; {cure}", fault=message, cure=cure, library=root) from error
