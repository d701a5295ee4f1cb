"""Ideal triangulations: manifolds with boundary, unless the points at infinity are kept."""

import pathlib

import coface


def test_the_figure_eight_knot(tmp_path: pathlib.Path) -> None:
    path = tmp_path / "knot.sig"
    path.write_text("cPcbbbiht\n")
    knot = coface.read(path)
    assert coface.homology(knot).betti_numbers[1] == 1
    report = knot.report()
    assert report.manifold == "yes"
    assert any("pseudomanifold=True" in warning for warning in report.warnings)
    whole = coface.read(path, pseudomanifold=True)
    assert coface.homology(whole).betti_numbers[1] == 0
    assert [str(group) for group in coface.pi1(whole)] == ["trivial"]
