"""Complexes in shards: as bytes, in folders."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import coface
import coface.shards
from coface.shards import Tree


def test_bytes_and_folders_have_one_answer(tmp_path: Path) -> None:
    model = coface.generate("klein")
    assert coface.shards.shard(model, tmp_path, 5, fan_in=2) == 5
    found = coface.shards.homology(tmp_path)
    assert str(found.homology) == str(coface.homology(model)) == "Homology(Z, Z + Z/2)"
    assert found.cells == list(model.report().f_vector)
    assert [level.parts for level in found.levels][:4] == [5, 3, 2, 1]
    assert found.levels[0].critical_per_stratum >= 1
    assert 0 < found.bytes_sent < sum(level.bytes for level in found.levels)

    tree = Tree.of_manifest(json.loads((tmp_path / "shards.json").read_text()))
    left = [coface.shards.reduce((tmp_path / f"part-{i:06}.shard").read_bytes()) for i in range(5)]
    assert left == [(tmp_path / f"part-{i:06}.reduced").read_bytes() for i in range(5)]
    level = 0
    while not coface.shards.summary(left[0])["is_root"]:
        level += 1
        width = tree.width(level)
        left = [coface.shards.merge([left[i] for i in tree.children(level, n)], tree, level, n) for n in range(width)]
        assert left == [(tmp_path / f"level-{level}-{n:06}.reduced").read_bytes() for n in range(width)]
    assert str(coface.shards.root_homology(left[0])) == str(found.homology)


def test_finished_shards_are_kept(tmp_path: Path) -> None:
    coface.shards.shard(coface.generate("torus"), tmp_path, 3)
    first = coface.shards.homology(tmp_path)
    times = {path.name: path.stat().st_mtime_ns for path in tmp_path.iterdir()}
    again = coface.shards.homology(tmp_path)
    assert (str(again.homology), again.levels) == (str(first.homology), first.levels)
    assert {path.name: path.stat().st_mtime_ns for path in tmp_path.iterdir()} == times
    assert (first.made, again.made) == (3 + 1, 0)
    # A part that is missing, and one that is damaged: they and what lies above are made again, if its bytes change; here they do not.
    (tmp_path / "part-000001.reduced").unlink()
    damaged = tmp_path / "part-000002.reduced"
    whole = damaged.read_bytes()
    damaged.write_bytes(whole[:-3])
    assert coface.shards.homology(tmp_path).made == 2 and damaged.read_bytes() == whole
    assert coface.shards.homology(tmp_path, replace=True).made == 4


def test_checksums_are_those_that_reduced_shards_name(tmp_path: Path) -> None:
    coface.shards.shard(coface.generate("torus"), tmp_path, 3)
    shard = (tmp_path / "part-000001.shard").read_bytes()
    known = coface.shards.checksum(shard[:64], len(shard))
    assert coface.shards.summary(coface.shards.reduce(shard))["sources"] == [known]
    with pytest.raises(coface.ParseError):
        coface.shards.checksum(shard[:64], len(shard) - 1)
    with pytest.raises(coface.Error):
        coface.shards.checksum(b"", 0)


def test_what_cannot_be_is_refused(tmp_path: Path) -> None:
    coface.shards.shard(coface.generate("torus"), tmp_path / "torus", 3, fan_in=3)
    coface.shards.shard(coface.generate("klein"), tmp_path / "klein", 3, fan_in=3)
    with pytest.raises(coface.Error):
        coface.shards.shard(coface.generate("torus"), tmp_path / "none", 3, fan_in=1)
    with pytest.raises(coface.FileError):
        coface.shards.homology(tmp_path / "nowhere")
    whole = (tmp_path / "torus/part-000001.shard").read_bytes()
    with pytest.raises(coface.ParseError):
        coface.shards.reduce(whole[:-1])
    tree = Tree.of_manifest(json.loads((tmp_path / "torus/shards.json").read_text()))
    parts = [tmp_path / "torus/part-000000.shard", tmp_path / "klein/part-000001.shard", tmp_path / "torus/part-000002.shard"]
    mixed = [coface.shards.reduce(part.read_bytes()) for part in parts]
    with pytest.raises(coface.InvalidInputError):
        coface.shards.merge(mixed, tree, 1, 0)
    with pytest.raises(coface.InvalidInputError):
        coface.shards.root_homology(mixed[0])
