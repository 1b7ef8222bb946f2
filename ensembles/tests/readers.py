"""Reads the results of `flip_map --size 16` with pandas and polars: `python readers.py FLIP_MAP.parquet FOLDER`.

Needs pandas, pyarrow and polars. Fails if names, units, metadata or values are not those that were written.
"""

import json
import math
import sys

import pandas
import polars
import pyarrow.parquet

path, folder = sys.argv[1:]
names = ["member", "theta1", "theta2", "flip", "error"]
units = {"theta1": "rad", "theta2": "rad", "flip": "s"}

# pandas, and its metadata by pyarrow.
frame = pandas.read_parquet(path)
assert list(frame.columns) == names, list(frame.columns)
assert list(frame["member"]) == list(range(256))
assert frame["theta1"].iloc[-1] == 3.1 and frame["theta2"].iloc[0] == -3.1
assert frame["error"].isna().all()
flips = frame["flip"].dropna()
assert 0 < len(flips) < 256 and flips.between(0, 20).all()
schema = pyarrow.parquet.read_schema(path)
for name, unit in units.items():
    assert schema.field(name).metadata == {b"unit": unit.encode()}, schema.field(name).metadata
metadata = {key.decode(): value.decode() for key, value in schema.metadata.items()}
assert json.loads(metadata["units"]) == units
assert metadata["model"].startswith("double pendulum"), metadata
assert metadata["members"] == "256" and metadata["points"].startswith("grid: theta1 "), metadata
assert metadata["lagrangian"], metadata

# polars.
other = polars.read_parquet(path)
assert other.columns == names, other.columns
assert other.schema["flip"] == polars.Float64 and other.schema["member"] == polars.UInt64
assert other["flip"].null_count() == 256 - len(flips)
assert math.isclose(other["flip"].mean(), flips.mean(), rel_tol=1e-14)
assert json.loads(polars.read_parquet_metadata(path)["units"]) == units

# The folder as it is.
assert pandas.read_parquet(folder).equals(frame)
assert polars.read_parquet(f"{folder}/chunk-*.parquet").equals(other)

print(f"pandas {pandas.__version__} and polars {polars.__version__} read {len(frame)} rows")
