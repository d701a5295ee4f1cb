"""What a release has to have, as far as that can be read without building one."""

from __future__ import annotations

from pathlib import Path

import pytest

import coface

PACKAGE = Path(__file__).resolve().parents[1]
FACTS = (PACKAGE / "pyproject.toml").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", ["LICENSE-APACHE", "LICENSE-MIT"])
def test_licences_are_those_of_the_repository(name) -> None:
    assert f'"{name}"' in FACTS
    assert (PACKAGE / name).read_bytes() == (PACKAGE.parents[1] / name).read_bytes()


def test_types_are_marked() -> None:
    assert (Path(coface.__file__).parent / "py.typed").is_file()
    assert '"Typing :: Typed"' in FACTS


def test_classifiers_and_the_licence_do_not_contradict() -> None:
    # PEP 639: with an expression of SPDX there is no classifier of a licence.
    assert 'license = "MIT OR Apache-2.0"' in FACTS
    assert "License ::" not in FACTS
    least = 'requires-python = ">=3.10"'
    assert least in FACTS and '"Programming Language :: Python :: 3.10"' in FACTS
