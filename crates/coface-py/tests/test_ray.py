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
    (folder / "bad.off").write_text("OFF\n1 0 0\n0 0 nan\n")
    os.mkfifo(folder / "endless.off")
    return folder


def test_rows_are_those_of_one_machine(models: Path, tmp_path: Path) -> None:
    alone = coface.batch(models, timings=False, timeout=3.0)
    assert [row["error"] and row["error"]["kind"] for row in alone] == ["parse", None, "time", None, None, None]
    assert coface.ray.batch(models, timings=False, timeout=3.0, files_per_task=2) == alone
    said = coface.ray.batch(models, tmp_path / "ray.csv", timings=False, timeout=3.0, files_per_task=4)
    assert said == coface.batch(models, tmp_path / "alone.csv", timings=False, timeout=3.0)
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
