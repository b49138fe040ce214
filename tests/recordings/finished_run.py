#!/usr/bin/env python3
"""A finished run's recording is read by pandas in one line: the columns that the scene asks for, numbers as numbers, events as text."""

import argparse
import json
import pathlib
import subprocess
import tempfile

import pandas

COLUMNS = ["time [s]", "depth [m]", "hand_force [N]", "contacts [1]"]
RECORD = "[depth, hand_force, contacts]"


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--stylet", required=True)
    options.add_argument("--scene", required=True, type=pathlib.Path)
    given = options.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        summary = pathlib.Path(folder) / "summary.json"
        subprocess.run([given.stylet, "run", given.scene, "--set", f"record={RECORD}", "--out", folder, "--json", summary, "--quiet"],
                       check=True)
        report = json.loads(summary.read_text())
        file = f"{folder}/{given.scene.stem}.csv"

        recording = pandas.read_csv(file, comment="#")

    assert list(recording.columns) == [*COLUMNS, "event"], recording.columns
    for column in COLUMNS:
        assert pandas.api.types.is_numeric_dtype(recording[column]), f"{column}: {recording[column].dtype}"
        assert recording[column].notna().all(), f"{column} has gaps"
    assert len(recording) == report["ticks"], f"{len(recording)} rows of {report['ticks']} ticks"

    events = recording["event"].dropna()
    assert all(isinstance(event, str) for event in events), events
    recorded = [event for cell in events for event in cell.split("; ")]
    reported = [event["name"] for event in report["events"] if event["name"] != "never punctured"]
    assert recorded == reported and "punctured" in recorded, f"recorded {recorded}, reported {reported}"
    print(f"{len(recording)} rows, events: {', '.join(recorded)}")


if __name__ == "__main__":
    main()
