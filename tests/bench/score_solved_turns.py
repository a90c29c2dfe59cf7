#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Solves recorded turns with the program itself and holds the answers against the truth in the same files; prints a
Markdown table. FILE: JSON lines of turns with their truth (x, y in mm, heading and step in degrees), named after their
scenario as rfid_<scenario>.jsonl; B* stands on the 3 x 3 field, everything else on the 11 x 11 field.

    tests/bench/score_solved_turns.py [--method auto|fast|classic] [--program FILE] FILE...
"""
import argparse
import csv
import io
import json
import math
import pathlib
import subprocess
import sys

CHI_SQUARED_2_AT_95 = 5.991464547


def quantile(values, share):
    """Linear between the order statistics, as in numpy."""
    ordered = sorted(values)
    place = share * (len(ordered) - 1)
    low = math.floor(place)
    high = min(low + 1, len(ordered) - 1)
    return ordered[low] + (place - low) * (ordered[high] - ordered[low])


def mean(values):
    return sum(values) / len(values)


def wrapped(degrees):
    return (degrees + 180.0) % 360.0 - 180.0


def inside(row, dx, dy):
    xx, xy, yy = (float(row[name]) for name in ("cov_xx_mm2", "cov_xy_mm2", "cov_yy_mm2"))
    determinant = xx * yy - xy * xy
    return (yy * dx * dx - 2.0 * xy * dx * dy + xx * dy * dy) / determinant < CHI_SQUARED_2_AT_95


def solved(program, method, path):
    field = "3x3" if path.stem.startswith("rfid_B") else "11x11"
    run = subprocess.run([program, "solve-turn", str(path), "--field", field, "--method", method],
                         capture_output=True, text=True, check=False)
    if run.returncode not in (0, 1):
        sys.exit(run.stderr)
    return list(csv.DictReader(io.StringIO(run.stdout)))


def score(program, method, path):
    truths = [json.loads(line) for line in path.read_text().splitlines() if line.strip()]
    rows = solved(program, method, path)
    if len(rows) != len(truths):
        sys.exit(f"{path}: {len(truths)} turns, {len(rows)} rows")
    position, heading, step, elapsed = [], [], [], []
    hits = gross = wrong_way = 0
    for truth, row in zip(truths, rows):
        if row["status"] != "ok":
            continue
        dx, dy = float(row["x_mm"]) - truth["x"], float(row["y_mm"]) - truth["y"]
        position.append(math.hypot(dx, dy))
        heading.append(abs(wrapped(float(row["heading_deg"]) - truth["heading"])))
        step.append(float(row["step_deg"]) - abs(truth["step"]))
        elapsed.append(float(row["elapsed_ms"]))
        hits += inside(row, dx, dy)
        gross += (position[-1] > 20.0 or heading[-1] > 15.0) and not row["flags"]
        wrong_way += row["direction"] != ("ccw" if truth["step"] > 0 else "cw")
    if not position:
        return f"| {path.stem.removeprefix('rfid_')} | 0/{len(rows)} |" + " - |" * 8
    rms = math.sqrt(mean([value * value for value in step]))
    return (f"| {path.stem.removeprefix('rfid_')} | {len(position)}/{len(rows)} "
            f"| {mean(position):.2f} / {quantile(position, 0.95):.2f} / {max(position):.1f} "
            f"| {mean(heading):.2f} / {quantile(heading, 0.95):.2f} / {max(heading):.1f} "
            f"| {rms:.2f} | {hits / len(position):.2f} | {gross} | {wrong_way} | {quantile(elapsed, 0.5):.0f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", type=pathlib.Path, metavar="FILE")
    parser.add_argument("--method", default="auto", choices=["auto", "fast", "classic"])
    parser.add_argument("--program", default="build/release/bin/agv-console")
    arguments = parser.parse_args()
    print("| file | solved | position mean / p95 / max, mm | heading mean / p95 / max, deg | step rms, deg "
          "| inside 95 % | gross, not flagged | wrong way | median, ms |")
    print("|---|---|---|---|---|---|---|---|---|")
    for path in arguments.files:
        print(score(arguments.program, arguments.method, path), flush=True)


if __name__ == "__main__":
    main()
