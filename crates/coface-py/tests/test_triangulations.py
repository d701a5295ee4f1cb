"""Moves on triangulated 3-manifolds, and sameness but for names."""

from __future__ import annotations

from pathlib import Path

import coface
import pytest

SPHERE = [[0, 1, 2, 3], [0, 1, 2, 4], [0, 1, 3, 4], [0, 2, 3, 4], [1, 2, 3, 4]]


def test_moves_keep_the_space() -> None:
    smaller, done = coface.as_model(SPHERE).simplified()
    assert done["name"] == "S3" and done["f_vector"][3] < 5
    assert [str(group) for group in coface.homology(smaller)] == [str(group) for group in coface.homology(coface.as_model(SPHERE))]
    # What comes out goes in again.
    again, _ = smaller.simplified(attempts=0)
    assert again.isomorphism(smaller)["isomorphic"]
    with pytest.raises(coface.Error, match="dimension 3"):
        coface.as_model([[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]).simplified()


def test_triangulations_are_looked_up_in_a_census(tmp_path: Path) -> None:
    census = tmp_path / "closed.sig"
    census.write_text("cMcabbgqw RP3\nbkaagb S3 : #1\nbkaagj S3 : #2\n")
    _, done = coface.as_model(SPHERE).simplified(census=census)
    found = done["census"]["found"]
    assert found["line"] in (2, 3) and found["signature"].startswith("bkaag") and found["name"] == f"S3 : #{found['line'] - 1}"
    census.write_text("cMcabbgqw RP3\n")
    _, done = coface.as_model(SPHERE).simplified(census=census)
    assert done["census"]["found"] is None and done["census"]["triangulation_count"] == 1
    with pytest.raises(coface.Error, match="none.sig"):
        coface.as_model(SPHERE).simplified(census=tmp_path / "none.sig")


def test_names_do_not_matter() -> None:
    other = [[9 - vertex for vertex in facet] for facet in reversed(SPHERE)]
    found = coface.as_model(SPHERE).isomorphism(coface.as_model(other))
    assert found["isomorphic"] and found["difference"] is None
    assert sorted(found["simplices"]) == [0, 1, 2, 3, 4]
    assert found["signatures"][0] == found["signatures"][1]
    ball = coface.as_model([[0, 1, 2, 3], [1, 2, 3, 4]])
    different = coface.as_model(SPHERE).isomorphism(ball)
    assert not different["isomorphic"] and different["difference"]
