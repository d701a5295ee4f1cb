"""Files of strangers, and files that are written: what the library promises holds in Python too."""

from __future__ import annotations

import os
import stat
from pathlib import Path

import pytest

import coface

SPHERE = "[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"


def header(folder: Path, data: str) -> Path:
    """The header of a volume whose numbers are in another file."""
    path = folder / "a.nhdr"
    path.write_text(f"NRRD0004\ntype: uchar\ndimension: 2\nsizes: 4 2\nencoding: raw\ndata file: {data}\n\n")
    return path


@pytest.fixture
def outside(tmp_path: Path) -> Path:
    """A header that names a file outside of its folder."""
    (tmp_path / "secret").write_bytes(bytes([1] * 8))
    (tmp_path / "in").mkdir()
    return header(tmp_path / "in", "../secret")


def test_files_outside_of_the_folder_are_read_by_leave_alone(outside: Path) -> None:
    for refused in [coface.read, coface.volume]:
        with pytest.raises(coface.InvalidInputError, match="allow it by allow_outside") as caught:
            refused(outside)
        assert "--" not in str(caught.value)
        assert refused(outside, allow_outside=True).f_vector[2] == 8
    assert [row["error"]["kind"] for row in coface.batch(outside)] == ["invalid_input"]
    assert [row["error"] for row in coface.batch(outside, allow_outside=True)] == [None]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no named pipes here")
def test_pipes_are_not_waited_for(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    for allowed in [False, True]:
        with pytest.raises(coface.Error, match="regular file"):
            coface.read(header(tmp_path, "pipe"), allow_outside=allowed)


def test_names_stay_in_their_line(tmp_path: Path) -> None:
    with pytest.raises(coface.FileError) as caught:
        coface.read(tmp_path / "a\n\x1b[31mred\u202e.off")
    assert "a\\n\\u{1b}[31mred\\u{202e}.off" in str(caught.value)
    assert caught.value.file.endswith("a\n\x1b[31mred\u202e.off")


def test_outputs_that_may_not_be_written_are_not_replaced(tmp_path: Path) -> None:
    model = coface.Model.from_bytes(SPHERE)
    (tmp_path / "many").mkdir()
    (tmp_path / "many" / "a.json").write_text(SPHERE)
    names = ["a.json", "a.html", "a.jsonl", "a.csv"]
    for name in names:
        path = tmp_path / name
        path.write_text("precious")
        path.chmod(stat.S_IRUSR)
        with pytest.raises(coface.FileError, match="may not be written"):
            if name == "a.json":
                model.write(path)
            elif name == "a.html":
                coface.view(model, path)
            else:
                coface.batch(tmp_path / "many", path)
        assert path.read_text() == "precious"
        path.chmod(0o640)
        if name == "a.html":
            coface.view(model, path)
        elif name != "a.json":
            coface.batch(tmp_path / "many", path)
        else:
            model.write(path)
        assert path.read_text() != "precious"
        assert stat.S_IMODE(path.stat().st_mode) == 0o640
    assert sorted(os.listdir(tmp_path)) == sorted([*names, "many"])


def test_tables_of_parquet_appear_whole_or_not_at_all(tmp_path: Path) -> None:
    (tmp_path / "a.json").write_text(SPHERE)
    path = tmp_path / "rows.parquet"
    path.write_text("precious")
    path.chmod(stat.S_IRUSR)
    with pytest.raises(coface.FileError, match="may not be written"):
        coface.batch(tmp_path / "a.json", path)
    assert path.read_text() == "precious"
    assert sorted(os.listdir(tmp_path)) == ["a.json", "rows.parquet"]


def test_two_calls_do_not_write_one_table(tmp_path: Path) -> None:
    import fcntl

    (tmp_path / "a.json").write_text(SPHERE)
    with (tmp_path / ".rows.parquet.journal").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        with pytest.raises(coface.FileError, match="another run is writing this output"):
            coface.batch(tmp_path / "a.json", tmp_path / "rows.parquet")
    coface.batch(tmp_path / "a.json", tmp_path / "rows.parquet")
    assert sorted(os.listdir(tmp_path)) == ["a.json", "rows.parquet"]


def test_numbers_beyond_int32_are_not_negative_ones() -> None:
    model = coface.Model.from_bytes("[[0,1,2147483647],[1,2,3]]")
    assert model.facets.max() == 2**31 - 1
    model = coface.Model.from_bytes("[[0,1,2147483648],[1,2,3]]")
    with pytest.raises(coface.TooLargeError, match="int32"):
        _ = model.facets


def test_two_calls_do_not_write_one_folder_of_shards(tmp_path: Path) -> None:
    import fcntl

    folder = tmp_path / "shards"
    coface.shards.shard(coface.Model.from_bytes(SPHERE), folder, 2)
    before = sorted(os.listdir(folder))
    with (folder / ".coface-shards.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        with pytest.raises(coface.FileError, match="another run works in this folder"):
            coface.shards.shard(coface.Model.from_bytes(SPHERE), folder, 2)
    coface.shards.shard(coface.Model.from_bytes(SPHERE), folder, 2)
    assert sorted(os.listdir(folder)) == before
