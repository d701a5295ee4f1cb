"""What a worker process runs: the compiled part alone, so that a worker starts soon and takes little memory."""

from __future__ import annotations

import sys
from importlib.machinery import ExtensionFileLoader
from importlib.util import module_from_spec, spec_from_loader


def fetch(url: str) -> bytes:
    """The bytes at a URL, by fsspec."""
    import fsspec

    with fsspec.open(url, "rb") as file:
        content: bytes = file.read()
    return content


def main(compiled: str) -> None:
    """Answer requests until there are no more, by the compiled part in this file."""
    loader = ExtensionFileLoader("_coface", compiled)
    spec = spec_from_loader("_coface", loader)
    if spec is None:
        raise ImportError(compiled)
    module = module_from_spec(spec)
    loader.exec_module(module)
    module._serve(fetch)


if __name__ == "__main__":
    # This folder, in which ray.py is not Ray.
    del sys.path[0]
    main(sys.argv[1])
