#!/usr/bin/env python3
"""Kills `stylet run` at random moments. What each leaves behind is read by pandas in one line and drawn by `stylet plot`: a row for each
tick from the first on, every row whole but, at worst, the last."""

import argparse
import pathlib
import random
import signal
import subprocess
import tempfile
import time

import pandas

RATE = 1000.0  # [Hz] ticks of simulated time
DURATION = 10000.0  # [s] simulated: whatever the machine, a run is killed long before
LONGEST_LIFE = 0.3  # [s] six times what the recorder waits between two writes
ROUNDING = 1e-9  # of a time: the same number, written in decimal and read again
# A kill within a write may cut the last row: one in three hundred was counted on a quiet machine, more on a busy one, where a process
# waits for its turn in the middle of a write. A recorder that wrote blocks and not whole rows would cut all but one in two hundred.
MOST_CUT = 0.5  # of the kills


def killed(stylet, scene, folder, life):
    """Starts a run, kills it `life` seconds after its recording has begun, and returns the recording."""
    file = folder / f"{scene.stem}.csv"
    file.unlink(missing_ok=True)
    run = subprocess.Popen([stylet, "run", scene, "--set", f"run={{rate: {RATE:g} Hz, duration: {DURATION:g} s}}", "--out", folder, "--quiet"])
    while not (file.exists() and file.stat().st_size > 0):
        assert run.poll() is None, f"the run ended by itself with {run.returncode}"
        time.sleep(0.001)
    time.sleep(life)
    run.send_signal(signal.SIGKILL)
    assert run.wait() == -signal.SIGKILL, "the run ended before it was killed: make it longer"
    return file


def check_lines(text):
    """Every line that ends is whole. Returns how many rows those are, and whether one more was cut."""
    lines = text.split("\n")
    cut = lines.pop() != ""
    header, *rows = [line for line in lines if not line.startswith("#")]
    for number, row in enumerate(rows):
        assert row.count(",") == header.count(","), f"row {number + 1} of {len(rows)} is not whole: {row!r}"
    return len(rows), cut


def check_pandas(file, whole, cut):
    recording = pandas.read_csv(file, comment="#")

    assert len(recording) == whole + cut, f"{len(recording)} rows, wanted {whole} whole ones and {int(cut)} cut"
    numbers = recording.iloc[:whole].drop(columns="event").apply(pandas.to_numeric)
    ticks = numbers["time [s]"] * RATE
    gaps = ticks[abs(ticks - range(1, whole + 1)) > ROUNDING * ticks]
    assert gaps.empty, f"rows that are not one tick after the other: {gaps}"
    assert numbers.notna().all(axis=None), "a whole row lacks a number"


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--stylet", required=True)
    options.add_argument("--scene", required=True, type=pathlib.Path)
    options.add_argument("--kills", type=int, default=50)
    options.add_argument("--seed", type=int, default=random.randrange(1 << 32))
    given = options.parse_args()
    print(f"--seed {given.seed}")
    moments = random.Random(given.seed)
    kept, cuts = [], 0
    with tempfile.TemporaryDirectory() as name:
        for _ in range(given.kills):
            life = moments.uniform(0.0, LONGEST_LIFE)
            file = killed(given.stylet, given.scene, pathlib.Path(name), life)
            whole, cut = check_lines(file.read_text())
            print(f"killed after {life:.3f} s: {whole} rows" + (", the last one cut" if cut else ""))
            check_pandas(file, whole, cut)
            if whole > 0:
                subprocess.run([given.stylet, "plot", file], check=True, stdout=subprocess.DEVNULL)
            kept.append(whole)
            cuts += cut
    assert sum(rows > 0 for rows in kept) > given.kills / 2, "most runs were killed before their first row: nothing was tested"
    assert cuts <= MOST_CUT * given.kills, f"{cuts} of {given.kills} recordings end in half a row"
    print(f"{given.kills} kills, {cuts} rows cut, {sum(kept)} rows kept")


if __name__ == "__main__":
    main()
