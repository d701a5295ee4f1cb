"""The table "Booleans": its inputs are what they are said to be, and all tools find the same."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import coface

FOLDER = Path(__file__).parents[1] / "benchmarks"
SCRIPT = FOLDER / "booleans.py"
if not SCRIPT.exists():
    pytest.skip("the benchmarks are not in the package", allow_module_level=True)
sys.path.insert(0, str(FOLDER))

import booleans  # noqa: E402

SIZES = {"plane-smooth": 400, "plane-small": 400, "plane-overlap": 1800, "space-smooth": 600, "space-small": 324, "space-overlap": 800}


def answer(kind: str, tool: str, operands) -> float:
    _, _, _, tools, compared = booleans.KINDS[kind]
    return compared(tools[tool](operands))


@pytest.mark.parametrize("kind", [kind for kind in SIZES if "overlap" not in kind])
def test_unions_of_two_are_their_sum_without_what_they_share(kind) -> None:
    first, second = booleans.KINDS[kind][2](SIZES[kind])
    if kind.startswith("plane"):
        own = [booleans.area_of(rings) for rings in (first, second)]
        common = coface.boolean("intersection", booleans.region(first), booleans.region(second)).measure / booleans.EXTENT**2
    else:
        own = [booleans.volume_of(mesh) for mesh in (first, second)]
        common = coface.boolean("intersection", *[coface.Model.from_arrays(*mesh) for mesh in (first, second)]).measure
    assert min(own) > 0 and 0 < common < min(own)
    assert answer(kind, "coface", [first, second]) == pytest.approx(sum(own) - common, rel=1e-5)


def test_stars_cover_what_random_points_say() -> None:
    operands = booleans.stars(SIZES["plane-overlap"])
    points = np.random.default_rng(1).uniform(0, booleans.EXTENT, size=(4000, 2))
    cover = np.zeros(len(points), int)
    for (ring,) in operands:
        (x, y), (u, v) = ring.T[:, :, None], np.roll(ring, -1, axis=0).T[:, :, None]
        px, py = points.T
        crosses = (y > py) != (v > py)
        with np.errstate(divide="ignore", invalid="ignore"):
            left = px < x + (py - y) / (v - y) * (u - x)
        cover += (crosses & left).sum(axis=0) % 2
    assert answer("plane-overlap", "coface", operands) == pytest.approx((cover > 0).mean(), abs=0.03)
    # In the middle of many more there are about twenty over each point; here the rim is near.
    assert 5 < cover[cover > 0].mean() < 30


@pytest.mark.parametrize(("kind", "tool"), [(kind, tool) for kind in SIZES for tool in booleans.KINDS[kind][3] if tool != "coface"])
def test_tools_agree(kind, tool) -> None:
    pytest.importorskip(booleans.TOOLS[tool][0])
    if tool == "libigl":
        pytest.importorskip("igl.copyleft.cgal")
    operands = booleans.KINDS[kind][2](SIZES[kind])
    assert booleans.agree(tool, answer(kind, tool, operands), answer(kind, "coface", operands))


@pytest.mark.parametrize("kind", ["plane-smooth", "plane-small", "plane-overlap"])
def test_the_file_for_programs_is_that_of_the_other_benches(kind, tmp_path) -> None:
    operands = booleans.KINDS[kind][2](SIZES[kind])
    path = tmp_path / "input.raw3"
    booleans.write_raw(operands, path)
    data = np.fromfile(path, "<u4")
    width, vertices, rings = (int(number) for number in data[:3])
    starts = data[3 : 4 + rings]
    points = data[4 + rings + vertices :].view("<f8").reshape(-1, 3)
    assert (width, len(points), starts[-1]) == (0, vertices, vertices)
    assert (points[:, :2] == np.concatenate([ring for own in operands for ring in own])).all()
    assert points[:, :2].min() >= 0 and points[:, :2].max() < 2**28
    assert set(points[:, 2]) == ({0.0, 1.0} if len(operands) == 2 else {0.0})


def test_growth_is_the_exponent_of_a_power() -> None:
    assert booleans.growth([(n, 0.5 * n**1.5) for n in (10.0, 20.0, 40.0)]) == pytest.approx(1.5)
    assert math.isnan(booleans.growth([(10.0, 1.0)]))
    assert math.isnan(booleans.growth([(10.0, 0.0), (20.0, math.nan)]))


def test_one_command_makes_the_table(tmp_path) -> None:
    rows = tmp_path / "rows.json"
    words = [sys.executable, str(SCRIPT), "--size", "0.002", "--rounds", "1", "--tool", "coface", "--json", str(rows)]
    done = subprocess.run(words, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    found = [json.loads(line) for line in rows.read_text().splitlines()]
    table = [line for line in done.stdout.splitlines() if line.startswith("| ")]
    assert len(table) == 1 + 4 * len(booleans.KINDS) == 1 + len(found)
    assert all(line.count("|") == table[0].count("|") for line in table)
    measured = [row for row in found if "seconds" in row]
    assert len(measured) == 3 * len(booleans.KINDS)
    assert all(row["seconds"] > 0 and row["processor"] > 0 and row["measure"] > 0 for row in measured)


def test_what_fails_is_said(tmp_path) -> None:
    words = [sys.executable, str(SCRIPT), "--kind", "plane-small", "--size", "0.002", "--rounds", "1", "--clipper2", str(tmp_path / "none")]
    done = subprocess.run([*words, "--tool", "clipper2"], capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0
    assert "| plane-small | 200 | clipper2 | failed: " in done.stdout
