"""Work over Ray, with two worker processes on this machine."""

from __future__ import annotations

import os
import signal
from collections.abc import Iterator
from pathlib import Path

import pytest

import coface

ray = pytest.importorskip("ray", reason="Ray is not installed")
pytest.importorskip("ray.data", reason="Ray Data is not installed")

import coface.ray  # noqa: E402
import coface.shards  # noqa: E402


@pytest.fixture(scope="module", autouse=True)
def cluster() -> Iterator[None]:
    coface.ray.start(num_cpus=2)
    yield
    ray.shutdown()


@pytest.fixture
def models(tmp_path: Path) -> Path:
    folder = tmp_path / "models"
    folder.mkdir()
    for name in ["torus", "klein", "csaszar", "sphere"]:
        coface.generate(name).write(folder / f"{name}.off")
    (folder / "bad.off").write_text("OFF\n1 0 0\n0 0\n")
    os.mkfifo(folder / "endless.off")
    return folder


def test_rows_are_those_of_one_machine(models: Path, tmp_path: Path) -> None:
    alone = coface.batch(models, timings=False, timeout=6.0)
    assert [row["error"] and row["error"]["kind"] for row in alone] == ["parse", None, "time", None, None, None]
    assert coface.ray.batch(models, timings=False, timeout=6.0, files_per_task=2) == alone
    (models / "endless.off").unlink()
    said = coface.ray.batch(models, tmp_path / "ray.csv", timings=False, files_per_task=4)
    assert said == coface.batch(models, tmp_path / "alone.csv", timings=False)
    assert (tmp_path / "ray.csv").read_bytes() == (tmp_path / "alone.csv").read_bytes()


def test_a_worker_that_is_killed_changes_nothing(models: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (models / "endless.off").unlink()
    marker, examine = tmp_path / "killed", coface.ray._examine

    def dying(files, options):
        if not marker.exists():
            marker.touch()
            os.kill(os.getpid(), signal.SIGKILL)
        return examine(files, options)

    monkeypatch.setattr(coface.ray, "_examine", dying)
    found = coface.ray.batch(models, timings=False, files_per_task=2)
    assert marker.exists()
    assert found == coface.batch(models, timings=False)


def shards(folder: Path) -> Path:
    """A folder with the shards of a Klein bottle."""
    coface.shards.shard(coface.generate("klein"), folder, 6, fan_in=2)
    return folder


def files(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def test_homology_is_that_of_one_machine(tmp_path: Path) -> None:
    alone = coface.shards.homology(shards(tmp_path / "alone"))
    seen: list[tuple[str, int, int]] = []
    found = coface.ray.homology(shards(tmp_path / "ray").as_uri(), progress=lambda *said: seen.append(said))
    assert str(found.homology) == str(alone.homology) == "Homology(Z, Z + Z/2)"
    assert (found.cells, found.levels) == (alone.cells, alone.levels)
    assert files(tmp_path / "ray") == files(tmp_path / "alone")
    assert seen[-1][1] == seen[-1][2] and ("reducing parts", 6, 6) in seen


@pytest.mark.parametrize("task", ["_reduce_task", "_merge_task"])
def test_a_worker_that_is_killed_leaves_the_same_bytes(task: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    coface.shards.homology(shards(tmp_path / "alone"))
    marker, work = tmp_path / "killed", getattr(coface.ray, task)

    def dying(*request):
        if 1 in request and not marker.exists():
            marker.touch()
            os.kill(os.getpid(), signal.SIGKILL)
        return work(*request)

    monkeypatch.setattr(coface.ray, task, dying)
    coface.ray.homology(shards(tmp_path / "ray"))
    assert marker.exists()
    assert files(tmp_path / "ray") == files(tmp_path / "alone")
