"""A complex in shards: cut, reduced one by one, merged up a tree; over Ray where that is installed."""

# %% Shards of a Klein bottle
import tempfile
from pathlib import Path

import coface
import coface.shards

folder = Path(tempfile.mkdtemp())
model = coface.generate("klein")
count = coface.shards.shard(model, folder / "shards", 16, fan_in=4)
assert count == 16

# %% What is left of each shard is small, and is all that is sent on
found = coface.shards.homology(folder / "shards")
for number, level in enumerate(found.levels):
    print(f"level {number}: {level.parts} parts, {level.strata} strata, {sum(level.critical)} critical cells, {level.bytes} bytes")
print(found.homology)
assert str(found.homology) == str(coface.homology(model)) == "Homology(Z, Z + Z/2)"
assert [level.parts for level in found.levels][:3] == [16, 4, 1]

# %% The same as tasks of Ray: pip install "ray[data]" fsspec
try:
    import coface.ray
except ModuleNotFoundError as error:
    print("without", error.name)
else:
    coface.shards.shard(model, folder / "again", 16, fan_in=4)
    again = coface.ray.homology(folder / "again")
    assert (str(again.homology), again.levels) == (str(found.homology), found.levels)
    for path in (folder / "shards").iterdir():
        assert path.read_bytes() == (folder / "again" / path.name).read_bytes()
    print("the same bytes over Ray")
