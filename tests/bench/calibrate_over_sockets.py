#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Calibrates every AGV of the simulated plant in a row through the program itself, over real sockets and in real
time, seed after seed, and prints the errors of pose and sleeptime as a Markdown table.

    tests/bench/calibrate_over_sockets.py [--seeds N] [--first SEED] [--at-once N] [--program FILE] [-- OPTION...]

OPTIONs behind "--" go to "agv-console calibrate". bench_simulated_calibration does the same in virtual time.
"""
import argparse
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor


def quantile(values, share):
    ordered = sorted(values)
    return ordered[max(0, math.ceil(share * len(ordered)) - 1)] if ordered else float("nan")


def spread(values, digits):
    if not values:
        return "-"
    numbers = (sum(values) / len(values), quantile(values, 0.95), max(values))
    return " / ".join(f"{number:.{digits}f}" for number in numbers)


def calibrate(program, seed, options):
    """One row per AGV: what the program said and how far from the truth it was."""
    with tempfile.TemporaryDirectory() as folder:
        begin = time.monotonic()
        run = subprocess.run([program, "calibrate", "--simulate", "--seed", str(seed), "--out", folder, *options],
                             capture_output=True, text=True)
        duration = time.monotonic() - begin
        out = pathlib.Path(folder)
        if not (out / "truth.json").exists():
            sys.exit(f"seed {seed}: exit status {run.returncode}\n{run.stderr}")
        truths = {entry["robot"]: entry for entry in json.loads((out / "truth.json").read_text())}
        rows = []
        for result in csv.DictReader((out / "result.csv").open()):
            robot = int(result["id"].removeprefix("agv").split("-")[0])
            rows.append({"seed": seed, "robot": robot, "status": result["status"], "flags": result["flags"],
                         "direction": result["direction"], "duration_s": turn_time(out / f"agv{robot}-capture.txt"),
                         "share_of_run_s": duration / max(1, len(truths)), **truths.get(robot, {})})
        return rows


def turn_time(capture):
    """From the press to the end of the last reading, s; the solver follows."""
    ends = [line for line in capture.read_text(errors="replace").splitlines() if line.startswith("# end at_ms=")]
    return float(ends[-1].split("=")[1]) * 1e-3 if ends else float("nan")


def print_row(name, rows):
    solved = [row for row in rows if row["status"] == "ok"]
    position = [row["error_mm"] for row in solved]
    heading = [abs(row["error_deg"]) for row in solved]
    bad = [row for row in solved if row["error_mm"] > 20.0 or abs(row["error_deg"]) > 15.0]
    unflagged = sum(not row["flags"] for row in bad)
    wrong_way = sum(row["direction"] != "ccw" for row in solved)
    flagged = sum(bool(row["flags"]) for row in solved)
    reading = [row["duration_s"] for row in solved]
    whole = [row["share_of_run_s"] for row in rows]
    print(f"| {name} | {len(solved)}/{len(rows)} | {spread(position, 1)} | {spread(heading, 2)} "
          f"| {len(bad)} ({unflagged}) | {flagged} | {wrong_way} | {spread(reading, 1)} | {max(whole):.1f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    root = pathlib.Path(__file__).resolve().parents[2]
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--at-once", type=int, default=5, help="programs that run at the same time")
    parser.add_argument("--program", default=str(root / "build/release/bin/agv-console"))
    parser.add_argument("options", nargs="*", help="for agv-console calibrate")
    arguments = parser.parse_args()
    seeds = range(arguments.first, arguments.first + arguments.seeds)
    with ThreadPoolExecutor(arguments.at_once) as pool:
        runs = pool.map(lambda seed: calibrate(arguments.program, seed, arguments.options), seeds)
        rows = [row for run in runs for row in run]
    print("| AGV | solved | position mean / p95 / max, mm | heading mean / p95 / max, deg | bad (unflagged) | flagged "
          "| wrong way | press to last reading mean / p95 / max, s | slowest run, s per AGV |")
    print("|---|---|---|---|---|---|---|---|---|")
    for robot in sorted({row["robot"] for row in rows}):
        print_row(str(robot), [row for row in rows if row["robot"] == robot])
    print_row("all", rows)


if __name__ == "__main__":
    main()
