"""Voxels from arrays and files."""

from __future__ import annotations

import pickle
import struct
import zlib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import coface

RNG = np.random.default_rng(5)


@pytest.mark.parametrize("shape", [(7,), (5, 6), (4, 5, 6), (3, 3, 3, 3)])
@pytest.mark.parametrize("dtype", [np.bool_, np.uint8, np.int16, np.float32, np.float64])
def test_counts_are_those_of_the_cells(shape: tuple[int, ...], dtype: Any) -> None:
    array = (RNG.random(shape) * 3).astype(dtype)
    model = coface.volume(array)
    assert model.structure == "volume"
    # Cells by their places, twice as fine as voxels: a cell is there if a voxel around it is.
    places = np.zeros([2 * n + 1 for n in shape], dtype=bool)
    for voxel in np.argwhere(array != 0):
        places[tuple(slice(2 * x, 2 * x + 3) for x in voxel)] = True
    dimension = sum(np.indices(places.shape) % 2)
    counts = [int((places & (dimension == k)).sum()) for k in range(len(shape) + 1)]
    assert list(model.report().f_vector) == counts
    voxels, periodic = model.voxels or (None, None)
    assert np.array_equal(voxels, array != 0) and periodic == []
    again = pickle.loads(pickle.dumps(model))
    assert np.array_equal(again.voxels[0], voxels)


def test_rules_and_files_agree(tmp_path: Path) -> None:
    array = RNG.normal(size=(6, 7, 8)).astype(np.float32)
    array[2, 3, 4] = np.nan
    for order in "CF":
        np.save(tmp_path / "x.npy", np.asarray(array, order=order))
        for rule in [{"threshold": 0.25}, {"below": 0.0}, {"between": (-0.5, 0.5)}, {"value": float(array[0, 0, 0])}, {}]:
            of_array, of_file = coface.volume(array, **rule), coface.volume(tmp_path / "x.npy", **rule)
            assert of_array.voxels is not None and of_file.voxels is not None
            assert np.array_equal(of_array.voxels[0], of_file.voxels[0])
            assert not of_array.voxels[0][2, 3, 4]
    assert np.array_equal(coface.as_model(array > 0).voxels[0], array > 0)  # type: ignore[index]


def _png(pixels: np.ndarray) -> bytes:
    """An image of bytes, by the specification."""

    def chunk(name: bytes, content: bytes) -> bytes:
        return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))

    rows = b"".join(b"\0" + row.tobytes() for row in pixels)
    header = struct.pack(">IIBBBBB", pixels.shape[1], pixels.shape[0], 8, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def test_images_are_volumes_and_diagrams_do_not_depend_on_their_format(tmp_path: Path) -> None:
    pixels = RNG.integers(0, 256, (9, 13)).astype(np.uint8)
    (tmp_path / "x.png").write_bytes(_png(pixels))
    voxels = coface.volume(tmp_path / "x.png", threshold=100).voxels
    # Axis 0 of an image goes along its rows.
    assert voxels is not None and np.array_equal(voxels[0], pixels.T >= 100)
    of_array, of_file = coface.cubical(pixels), coface.cubical(tmp_path / "x.png")
    for degree in range(2):
        assert sorted(map(tuple, of_array.diagram(degree))) == sorted(map(tuple, of_file.diagram(degree)))
    (tmp_path / "cut.png").write_bytes(_png(pixels)[:60])
    with pytest.raises(coface.Error, match="cut short"):
        coface.volume(tmp_path / "cut.png")


def test_integers_and_short_numbers_are_compared_exactly(tmp_path: Path) -> None:
    wide = np.array([2**53, 2**53 + 1, -(2**53) - 1], dtype=np.int64)
    short = np.array([0.1, 0.5], dtype=np.float32)
    cases = [
        (wide, {"threshold": float(2**53 + 2)}, [False] * 3),
        (wide, {"below": float(-(2**53))}, [False, False, True]),
        (wide, {"value": float(2**53)}, [True, False, False]),
        (wide, {"value": 0.5}, [False] * 3),
        # The 32-bit number next to 0.1 is above it.
        (short, {"between": (0.0, 0.1)}, [False, False]),
        (short, {"value": 0.1}, [True, False]),
    ]
    for array, rule, expected in cases:
        np.save(tmp_path / "x.npy", array)
        for volume in [coface.volume(array, **rule), coface.volume(tmp_path / "x.npy", **rule)]:
            assert volume.voxels is not None and volume.voxels[0].tolist() == expected, rule


def test_axes_that_close_up() -> None:
    torus = coface.volume(np.ones((3, 4)), periodic=[0, 1])
    assert str(coface.homology(torus)) == "Homology(Z, Z^2, Z)"
    assert torus.voxels is not None and torus.voxels[1] == [0, 1]
    assert str(coface.homology(pickle.loads(pickle.dumps(torus)))) == "Homology(Z, Z^2, Z)"


def test_wrong_requests_say_what_to_do(tmp_path: Path) -> None:
    with pytest.raises(coface.InvalidInputError, match="one rule"):
        coface.volume(np.ones(3), threshold=1, below=2)
    with pytest.raises(coface.InvalidInputError, match="from 0"):
        coface.volume(np.ones(3), periodic=[1])
    with pytest.raises(coface.InvalidInputError, match="from 0"):
        coface.volume(np.ones(3), periodic=[-1])
    with pytest.raises(coface.InvalidInputError, match="numbers"):
        coface.volume(np.array(["a"]))
    with pytest.raises(coface.Error):
        coface.volume(np.ones(()))
    path = tmp_path / "triangle.off"
    path.write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
    with pytest.raises(coface.InvalidInputError, match="no voxels"):
        coface.volume(path)


def test_masked_voxels_are_not_set() -> None:
    middle = np.arange(27).reshape(3, 3, 3) == 13
    for rule in ({}, {"threshold": 0.5}, {"below": 2}, {"value": 1}):
        hollow = coface.volume(np.ma.array(np.ones((3, 3, 3)), mask=middle), **rule)
        assert hollow.voxels is not None and np.array_equal(hollow.voxels[0], ~middle)
    assert coface.homology(hollow).betti_numbers == (1, 0, 1, 0)


@pytest.mark.parametrize("is_mirrored", [False, True])
def test_headers_place_voxels(tmp_path: Path, is_mirrored: bool) -> None:
    """Two voxels, 0.5 x 2 x 3 each, the center of the first at (10, 20, 30); mirrored along the first axis, or not."""
    first = -0.5 if is_mirrored else 0.5
    path = tmp_path / "two.nrrd"
    path.write_text(
        "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 1 1\nencoding: ascii\nspace dimension: 3\n"
        f"space directions: ({first},0,0) (0,2,0) (0,0,3)\nspace origin: (10,20,30)\n\n1 1\n"
    )
    model = coface.volume(path)
    low = [9.25 if is_mirrored else 9.75, 19, 28.5]
    for surface in (False, True):
        placed = model.to_model(surface=surface)
        assert placed.vertices.min(axis=0).tolist() == low
        assert placed.vertices.max(axis=0).tolist() == [low[0] + 1, 21, 31.5]
    assert model.to_model(surface=True).report().signed_volume == 6.0
    corners = model.to_model().cells["hexahedron"]
    for voxel in model.to_model().vertices[corners]:
        # Hexahedra of VTK: the last four corners are above the first four, which run round counterclockwise.
        assert np.linalg.det([voxel[1] - voxel[0], voxel[3] - voxel[0], voxel[4] - voxel[0]]) == pytest.approx(3.0)
    # What is written is placed too; what is asked for takes the place of the header.
    model.write(tmp_path / "two.obj")
    assert coface.read(tmp_path / "two.obj").report().signed_volume == 6.0
    given = model.to_model(surface=True, spacing=(1, 1, 1))
    assert given.report().signed_volume == 2.0 and given.vertices.min() == 0.0
