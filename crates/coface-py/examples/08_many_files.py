"""A corpus: one row a file, errors as rows, a table at the end."""

# %% Some models, one that is damaged and one that no memory holds
import csv
import tempfile
from pathlib import Path

import coface

folder = Path(tempfile.mkdtemp())
for family in ["torus", "klein", "csaszar", "sphere"]:
    coface.generate(family).write(folder / f"{family}.off")
(folder / "damaged.off").write_text("OFF\n1 0 0\n0 0 oops\n")
(folder / "huge.json").write_text(str([list(range(20 * i, 20 * i + 20)) for i in range(12)]))

# %% Rows as dictionaries: what a file costs is limited, and what it costs too much it costs alone
rows = {Path(row["path"]).stem: row for row in coface.batch(folder, memory=1 << 30, timeout=600.0)}
for name, row in rows.items():
    print(name, row["error"]["message"] if row["error"] else row["name"])
assert rows["klein"]["homology"][1] == {"degree": 1, "betti": 1, "torsion": [2]}
assert rows["huge"]["error"]["kind"] == "memory"
assert rows["damaged"]["error"]["kind"] == "parse"

# %% The same as a table; a run that is cut short goes on where it was
(folder / "huge.json").unlink()
summary = coface.batch(str(folder / "*.off"), folder / "models.csv", timings=False)
print(summary)
assert summary["files"] == 5 and summary["errors"] == {"parse": 1}
with (folder / "models.csv").open(newline="", encoding="utf-8") as file:
    genera = {Path(row["path"]).stem: row["genus"] for row in csv.DictReader(file)}
assert genera == {"csaszar": "1", "damaged": "", "klein": "2", "sphere": "0", "torus": "1"}
