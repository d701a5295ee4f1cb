"""Work over Ray, with two worker processes on this machine."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

import coface

ray = pytest.importorskip("ray", reason="Ray is not installed")
pytest.importorskip("ray.data", reason="Ray Data is not installed")

import coface._journal  # noqa: E402
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


def test_a_batch_that_was_cut_short_goes_on_where_it_was(models: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (models / "endless.off").unlink()
    out, journal = tmp_path / "rows.csv", tmp_path / ".rows.csv.ray-journal"
    marks, allowed, examine = tmp_path / "marks", tmp_path / "allowed", coface.ray._examine
    marks.mkdir()

    def dying(files, options):
        names = [Path(path).name for path in files["path"]]
        if "sphere.off" in names and not allowed.exists():
            # Not before a row has come back.
            for _ in range(600):
                if journal.exists() and journal.read_bytes().count(b"\n") >= 2:
                    break
                time.sleep(0.05)
            raise ValueError("the cluster went away")
        if allowed.exists():
            for name in names:
                (marks / name).touch()
        return examine(files, options)

    monkeypatch.setattr(coface.ray, "_examine", dying)
    with pytest.raises(Exception, match="went away"):
        coface.ray.batch(models, out, timings=False, files_per_task=1)
    assert journal.is_file() and not out.exists()
    # What was still at work comes to its end.
    time.sleep(1.0)
    allowed.touch()
    # What has changed is looked at again.
    (models / "bad.off").write_bytes((models / "klein.off").read_bytes())
    said = coface.ray.batch(models, out, timings=False, files_per_task=1)
    assert said["files"] == 5 and not journal.exists()
    again = {path.name for path in marks.iterdir()}
    assert {"bad.off", "sphere.off", "torus.off"} <= again and len(again) == 5 - said["resumed"]
    coface.batch(models, tmp_path / "alone.csv", timings=False)
    assert out.read_bytes() == (tmp_path / "alone.csv").read_bytes()
    # All of it once more, and with nothing left to do.
    with coface._journal.Journal(out, {}, False) as empty:
        assert empty.rows([str(models / "bad.off")]) == {}
        empty.remove()


def test_journals_of_other_options_are_not_taken(tmp_path: Path) -> None:
    from coface._journal import Journal

    file = str(tmp_path / "a.off")
    Path(file).write_text("OFF")
    with Journal(tmp_path / "rows.csv", {"strict": True}, False) as journal:
        journal.add(file, '{"error":null}')
        journal.add(file + "#none", '{"error":{"kind":"killed"}}')
        with pytest.raises(coface.FileError, match="another run"):
            Journal(tmp_path / "rows.csv", {}, False).__enter__()
    whole = (tmp_path / ".rows.csv.ray-journal").read_bytes()
    with Journal(tmp_path / "rows.csv", {"strict": True}, False) as journal:
        assert journal.rows([file, file + "#none"]) == {file: '{"error":null}'}
    # A line that was cut short, or changed, is no line.
    for damaged in (whole[:-2], whole.replace(b"a.off", b"b.off")):
        (tmp_path / ".rows.csv.ray-journal").write_bytes(damaged)
        with Journal(tmp_path / "rows.csv", {"strict": True}, False) as journal:
            assert set(journal.rows([file, str(tmp_path / "b.off")])) <= {file}
    for options, restart in (({}, False), ({"strict": True}, True)):
        (tmp_path / ".rows.csv.ray-journal").write_bytes(whole)
        with Journal(tmp_path / "rows.csv", options, restart) as journal:
            assert journal.rows([file]) == {}
    with pytest.raises(coface.FileError, match="folder"):
        coface.ray.batch(file, tmp_path / "none" / "rows.csv")


def test_finished_shards_are_kept(tmp_path: Path) -> None:
    shards(tmp_path / "ray")
    first = coface.ray.homology(tmp_path / "ray")
    before = {path.name: path.stat().st_mtime_ns for path in (tmp_path / "ray").iterdir()}
    again = coface.ray.homology(tmp_path / "ray")
    assert (first.made, again.made) == (sum(level.parts for level in first.levels), 0) and again.levels == first.levels
    assert {path.name: path.stat().st_mtime_ns for path in (tmp_path / "ray").iterdir()} == before
    (tmp_path / "ray" / "part-000002.reduced").write_bytes(b"no shard")
    (tmp_path / "ray" / "part-000003.reduced").unlink()
    mended = coface.ray.homology(tmp_path / "ray")
    assert mended.made == 2 and files(tmp_path / "ray") == files(shards_reduced(tmp_path / "alone"))
    assert coface.ray.homology(tmp_path / "ray", replace=True).made == first.made
    # Of what the machine made alone, the cluster makes nothing again.
    assert coface.ray.homology(tmp_path / "alone").made == 0


def shards_reduced(folder: Path) -> Path:
    """The same shards, reduced on this machine."""
    coface.shards.homology(shards(folder))
    return folder


def image(shape: tuple[int, ...]) -> np.ndarray:
    """Waves and noise, with ties and voxels outside."""
    random = np.random.default_rng(5)
    waves = sum(np.sin(0.9 * axis) for axis in np.indices(shape))
    x = np.round(waves * 4 + random.normal(size=shape), 1)
    x[random.random(shape) < 0.05] = np.nan
    return x


def same(a: coface.Persistence, b: coface.Persistence) -> bool:
    degrees = range(len(a.betti_numbers))
    return a.betti_numbers == b.betti_numbers and all(
        np.array_equal(a.diagram(k), b.diagram(k)) and np.array_equal(a.voxels(k), b.voxels(k)) for k in degrees
    )


@pytest.mark.parametrize("shape, block", [((40,), 7), ((17, 23), (5, 8)), ((12, 11, 10), 5), ((5, 4, 6, 5), (3, 4, 2, 5))])
def test_persistence_is_that_of_the_whole_image(shape: tuple[int, ...], block: int | tuple[int, ...], tmp_path: Path) -> None:
    x = image(shape)
    np.save(tmp_path / "x.npy", x)
    for options in ({}, {"construction": "v", "superlevel": True, "coefficients": "f3"}, {"periodic": [0]}):
        whole = coface.cubical(x, **options)
        assert sum(len(whole.diagram(k)) for k in range(len(shape))) > 5
        assert same(coface.ray.persistence(x, block, fan_in=3, **options), whole)
        assert same(coface.shards.persistence(tmp_path / "x.npy", block, **options), whole)
    assert same(coface.ray.persistence(tmp_path / "x.npy", block, least=1.0), coface.cubical(x, least=1.0))


def test_finished_blocks_are_kept(tmp_path: Path) -> None:
    x, folder = image((12, 10, 9)), tmp_path / "parts"
    first = coface.ray.persistence(x, 5, folder=folder)

    def times() -> dict[str, int]:
        return {path.name: path.stat().st_mtime_ns for path in folder.iterdir()}

    before, content = times(), files(folder)
    assert len(before) == 12 + 2 + 1
    assert same(coface.ray.persistence(x, 5, folder=folder.as_uri()), first) and times() == before
    # What is damaged or gone is made again, with the same bytes.
    (folder / "block-000002.part").write_bytes(b"no part")
    (folder / "block-000003.part").unlink()
    assert same(coface.ray.persistence(x, 5, folder=folder), first) and files(folder) == content
    assert sum(time != before[name] for name, time in times().items()) == 2
    # Other numbers and other questions are others.
    x[0, 0, 0] += 1.0
    assert same(coface.ray.persistence(x, 5, folder=folder), coface.cubical(x))
    assert same(coface.ray.persistence(x, 5, folder=folder, superlevel=True), coface.cubical(x, superlevel=True))
    assert same(coface.ray.persistence(x, 5, folder=folder, superlevel=True, replace=True), coface.cubical(x, superlevel=True))


def test_faults_of_blocks_are_named(tmp_path: Path) -> None:
    x = np.zeros((4, 4))
    for block in [0, (2,), (2, 0)]:
        with pytest.raises(coface.Error, match="blocks of shape"):
            coface.ray.persistence(x, block)
    with pytest.raises(coface.Error, match="groups of 1"):
        coface.ray.persistence(x, 2, fan_in=1)
    with pytest.raises(coface.Error, match="axis 2 of an image with 2 axes"):
        coface.shards.persistence(x, 2, periodic=[2])
    with pytest.raises(coface.Error, match="no file"):
        coface.shards.persistence(tmp_path / "none.npy", 2)
    x[3, 3] = -np.inf
    with pytest.raises(coface.Error, match=r"voxel \[3, 3\] is at -inf"):
        coface.shards.persistence(x, 2)
