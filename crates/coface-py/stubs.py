"""Writes the docstrings of the compiled part into its stub, where editors look for them: ``python stubs.py --write``.

Without ``--write`` it says whether the stub has them. Signatures and types are written by hand; examples stay in the compiled part.
"""

from __future__ import annotations

import inspect
import re
import sys
from pathlib import Path
from typing import Any

STUB = Path(__file__).parent / "python" / "coface" / "_coface.pyi"
_DOC = re.compile(r'\n[ \t]*r?"""(?:[^\\]|\\.)*?"""(?=\n)', re.S)


def without(text: str) -> str:
    """The stub without docstrings."""
    text = _DOC.sub("", text)
    # A function of which nothing is left, and a class.
    text = re.sub(r"(?m)^( *def [^\n]*):\n +\.\.\.$", r"\1: ...", text)
    return re.sub(r"(?m)^(\s*def [^\n]*[^.:\s]):$", r"\1: ...", text)


def told(thing: Any) -> str | None:
    """The docstring of a thing up to its examples."""
    text = inspect.getdoc(getattr(thing, "__func__", thing))
    if not text:
        return None
    return re.split(r"\n+Examples\n-+\n", "\n" + text.strip())[0].strip() or None


def quoted(text: str, indent: str) -> list[str]:
    """The lines of a docstring."""
    mark = "r" if "\\" in text else ""
    lines = text.splitlines()
    if len(lines) == 1:
        return [f'{indent}{mark}"""{lines[0]}"""']
    body = [f"{indent}{line}".rstrip() for line in lines[1:]]
    return [f'{indent}{mark}"""{lines[0]}', *body, f'{indent}"""']


def documented(text: str) -> str:
    """The stub with the docstrings of the compiled part."""
    from coface import _coface

    found: list[str] = []
    owner: Any = None
    for line in without(text).splitlines():
        opened = re.match(r"class (\w+)[^\n]*:$", line)
        if opened:
            owner = getattr(_coface, opened.group(1), None)
            found.append(line)
            doc = told(owner) if owner is not None else None
            if doc:
                found.extend(quoted(doc, "    "))
            continue
        if line and not line.startswith((" ", "@")):
            owner = None
        function = re.match(r"( *)def (\w+)\((.*): \.\.\.$", line)
        if function:
            indent, name, rest = function.groups()
            thing = vars(owner).get(name) if owner is not None else getattr(_coface, name, None)
            doc = told(thing) if thing is not None and not name.startswith("_") else None
            if doc:
                found.append(f"{indent}def {name}({rest}:")
                found.extend(quoted(doc, indent + "    "))
                found.append(f"{indent}    ...")
                continue
        found.append(line)
    return "\n".join(found) + "\n"


def main() -> int:
    """Writes the stub, or says whether it is as it would be written."""
    text = STUB.read_text(encoding="utf-8")
    made = documented(text)
    if "--write" in sys.argv:
        STUB.write_text(made, encoding="utf-8")
        return 0
    if made != text:
        print("the stub has other docstrings than the compiled part: python stubs.py --write")
    return int(made != text)


if __name__ == "__main__":
    raise SystemExit(main())
