"""The report over many files: rows, limits, tables."""

from __future__ import annotations

import csv
import json
import os
import pickle
from pathlib import Path

import numpy as np
import pytest

import coface

pytestmark = pytest.mark.skipif(os.name != "posix", reason="limits of memory are those of POSIX")


@pytest.fixture
def models(tmp_path: Path) -> Path:
    """A folder with two models and a file that is none."""
    folder = tmp_path / "models"
    folder.mkdir()
    coface.generate("torus").write(folder / "torus.off")
    coface.generate("klein").write(folder / "klein.obj")
    (folder / "bad.off").write_text("OFF\n1 0 0\n0 0\n")
    return folder


def test_rows_are_reports(models: Path) -> None:
    bad, klein, torus, missing = coface.batch([models, models / "missing.off"])
    assert [bad["error"]["kind"], missing["error"]["kind"]] == ["parse", "io"]
    assert bad["error"]["cure"] and bad["error"]["message"].startswith(str(models / "bad.off") + ":3:")
    report = coface.read(models / "torus.off").report().to_dict()
    # Rows name the file themselves, have one value a column, and no remarks.
    keys = report.keys() - {"file", "remarks"}
    assert {key: torus.report[key] for key in keys} == {key: report[key] for key in keys}
    assert (klein["name"], klein["error"], klein["bytes"]) == ("Klein bottle", None, (models / "klein.obj").stat().st_size)
    assert torus["seconds"] >= 0
    assert "seconds" not in coface.batch(str(models / "*.obj"), timings=False)[0]


def test_rows_are_flat(models: Path) -> None:
    rows = coface.batch(models, timings=False)
    values = [value for row in rows for value in row.values()]
    assert all(value is None or isinstance(value, (str, int, float, bool)) for value in values)
    assert [row.get("betti_1") for row in rows] == [None, 1, 2]
    assert [row["error_kind"] for row in rows] == ["parse", None, None]
    # The whole report is found too.
    assert rows[2]["f_vector"] == rows[2].report["f_vector"] and rows[0]["error"]["kind"] == "parse"
    with pytest.raises(KeyError):
        rows[2]["no such key"]
    assert pickle.loads(pickle.dumps(rows[2])).report == rows[2].report
    assert coface.batch(models, timings=False, flat=False) == [row.report for row in rows]
    pandas = pytest.importorskip("pandas")
    table = pandas.DataFrame(rows)
    assert list(table["betti_1"])[1:] == [1, 2] and "homology" not in table


def test_tables_are_the_same_for_any_number_of_jobs(models: Path, tmp_path: Path) -> None:
    said = coface.batch(models, tmp_path / "one.csv", jobs=1, timings=False)
    assert said == {"files": 3, "errors": {"parse": 1}, "resumed": 0}
    coface.batch(models, tmp_path / "two.csv", jobs=2, timings=False)
    assert (tmp_path / "one.csv").read_bytes() == (tmp_path / "two.csv").read_bytes()
    with (tmp_path / "one.csv").open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [(row["name"], row["betti_1"], row["torsion_1"]) for row in rows[1:]] == [("Klein bottle", "1", "2"), ("torus", "2", "")]
    coface.batch(models, tmp_path / "rows.jsonl", timings=False)
    lines = [json.loads(line) for line in (tmp_path / "rows.jsonl").read_text().splitlines()]
    assert lines == coface.batch(models, timings=False, flat=False)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["models", "one.csv", "rows.jsonl", "two.csv"]


def test_parquet_has_a_column_a_value(models: Path, tmp_path: Path) -> None:
    parquet = pytest.importorskip("pyarrow.parquet")
    coface.batch(models, tmp_path / "rows.parquet", timings=False)
    table = parquet.read_table(tmp_path / "rows.parquet")
    assert table.column_names[:4] == ["path", "bytes", "error_kind", "error_message"]
    assert table["betti_1"].to_pylist() == [None, 1, 2]
    assert table["error_kind"].to_pylist() == ["parse", None, None]
    assert str(table.schema.field("area").type) == "double"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["models", "rows.parquet"]


def test_what_never_ends_costs_its_row_alone(models: Path) -> None:
    os.mkfifo(models / "endless.off")
    found = {Path(row["path"]).name: row for row in coface.batch(models, timeout=5.0)}
    assert found["endless.off"]["error"] == {"kind": "time", "message": "took longer than 5 s", "cure": "allow more time"}
    assert found["torus.off"]["name"] == "torus"


def test_what_takes_all_memory_costs_its_row_alone(models: Path) -> None:
    # Each simplex of dimension 19 has a million faces; one of dimension 25 has too many for what is free, and is refused at once.
    (models / "many.json").write_text(str([list(range(20 * i, 20 * i + 20)) for i in range(10)]))
    (models / "huge.json").write_text(str([list(range(26))]))
    found = {Path(row["path"]).name: row for row in coface.batch(models, timeout=None, memory=512 << 20)}
    assert found["many.json"]["error"]["message"] == "needed more than 512 MiB of memory"
    assert found["huge.json"]["error"]["kind"] == "too_large"
    assert "67108863 faces" in found["huge.json"]["error"]["message"]
    assert found["torus.off"]["name"] == "torus"


def test_urls_are_read_by_fsspec(models: Path) -> None:
    pytest.importorskip("fsspec")
    url = (models / "torus.off").as_uri()
    torus, missing = coface.batch([url, url + ".missing"])
    assert (torus["path"], torus["name"], torus["bytes"]) == (url, "torus", None)
    assert missing["error"]["kind"] == "io" and "missing" in missing["error"]["message"]
    assert [row["name"] for row in coface.batch(models.as_uri() + "/*.obj")] == ["Klein bottle"]


def test_what_cannot_be_is_refused(models: Path, tmp_path: Path) -> None:
    with pytest.raises(coface.InvalidInputError):
        coface.batch([])
    with pytest.raises(coface.InvalidInputError):
        coface.batch(models, timeout=0.0)
    with pytest.raises(coface.UnsupportedFormatError):
        coface.batch(models, tmp_path / "rows.xlsx")
    with pytest.raises(coface.FileError, match="folder"):
        coface.batch(models, tmp_path / "none" / "rows.csv")


def test_progress_is_told_and_a_fault_in_it_ends_the_workers(models: Path) -> None:
    os.mkfifo(models / "endless.off")

    def refuse(stage: str, done: int, total: int) -> None:
        assert (stage, total) == ("examining files", 4)
        raise RuntimeError("no more")

    with pytest.raises(RuntimeError, match="no more"):
        coface.batch(models, progress=refuse)


def test_voxels_are_set_as_asked(tmp_path: Path) -> None:
    array = np.arange(27, dtype=np.int16).reshape(3, 3, 3)
    np.save(tmp_path / "x.npy", array)
    (row,) = coface.batch(tmp_path / "x.npy", voxels={"threshold": 25, "periodic": [2]})
    assert row["f_vector"] == list(coface.volume(array, threshold=25, periodic=[2]).report().f_vector)
    assert row["f_vector"][3] == 2
    with pytest.raises(coface.InvalidInputError, match="one rule"):
        coface.batch(tmp_path / "x.npy", voxels={"threshold": 1, "below": 2})


@pytest.mark.parametrize("rule", [{"threshold": 20}, {"below": 5}, {"between": (4, 9)}, {"value": 13}, {"threshold": 25, "periodic": [2]}])
def test_rules_for_voxels_are_parameters_too(rule, tmp_path: Path) -> None:
    array = np.arange(27, dtype=np.int16).reshape(3, 3, 3)
    np.save(tmp_path / "x.npy", array)
    (row,) = coface.batch(tmp_path / "x.npy", timings=False, **rule)
    assert row["f_vector"] == list(coface.volume(array, **rule).report().f_vector)
    assert row == coface.batch(tmp_path / "x.npy", timings=False, voxels=rule)[0]
    said = coface.batch(tmp_path / "x.npy", tmp_path / "rows.jsonl", timings=False, **rule)
    assert said["files"] == 1 and json.loads((tmp_path / "rows.jsonl").read_text())["f_vector"] == row["f_vector"]
    with pytest.raises(coface.InvalidInputError, match="given together"):
        coface.batch(tmp_path / "x.npy", voxels={}, **rule)
    for wrong in ({"threshold": "otsu"}, {"between": 3}, {"periodic": True}):
        with pytest.raises(coface.InvalidInputError):
            coface.batch(tmp_path / "x.npy", **wrong)


def test_lists_of_signatures_are_streams(tmp_path: Path) -> None:
    census = tmp_path / "census.txt"
    census.write_text("# closed\ncMcabbjak L(3,1)\nL(8,3)\tcMcabbjqs\ncPcbbbiht\nxyz\n")
    rows = coface.signatures(census, groups=True, jobs=1)
    assert next(rows)["groups"][0]["name"] == "Z/3"
    assert [row["line"] for row in rows] == [3, 4, 5]
    said = coface.signatures([census, tmp_path / "none.sig"], tmp_path / "rows.csv")
    assert said == {"files": 5, "errors": {"io": 1, "parse": 1}, "resumed": 0}
    knot = list(coface.signatures(census, pseudomanifold=True))[2]
    assert (knot["manifold"], knot["homology"][1]["betti"]) == ("no", 0)
    with pytest.raises(coface.UnsupportedFormatError):
        coface.signatures(census, tmp_path / "rows.xlsx")
