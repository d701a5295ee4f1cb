"""Models by rule: the parameters that the program has."""

from __future__ import annotations

import pytest

import coface


@pytest.mark.parametrize("family", ["torus", "cylinder", "box", "klein"])
def test_cuboids_have_the_names_of_each_dimension(family: str) -> None:
    usual = coface.generate(family, cuboids=True)
    for name in ("quadrangles", "hexahedra"):
        assert coface.generate(family, **{name: True}) == usual
        assert coface.generate(family, **{name: False}) == coface.generate(family)
    with pytest.raises(coface.InvalidInputError, match="one parameter"):
        coface.generate(family, cuboids=True, quadrangles=True)


def test_families_without_cuboids_name_what_they_have() -> None:
    with pytest.raises(coface.Error, match="quadrangles"):
        coface.generate("csaszar", quadrangles=True)
