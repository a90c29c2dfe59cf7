#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the UWB files of this folder: four anchors in a room of 4 m x 3 m, a tag that stands at three points (one
anchor hidden for a time at one of them), and a vehicle that drives on a circle while its anchors answer in turns.
Ranges have 3 cm of noise, wheels 3 % of noise and 2 % too much on the right. Seeded: the files come out the same."""
import math
import random
from pathlib import Path

FOLDER = Path(__file__).parent
ANCHORS = [(0, 0.0, 0.0, 1.6), (1, 4.0, 0.0, 1.8), (2, 4.0, 3.0, 1.6), (3, 0.0, 3.0, 1.8)]
HEIGHT = 0.2
POINTS = {"north-west": (0.8, 2.4), "middle": (2.0, 1.5), "east": (3.3, 1.1)}
WHEELS = 0.2865
PITCH = 0.1


def distance(x, y, anchor, excess=0.0):
    return math.dist((x, y, HEIGHT), anchor[1:]) + random.gauss(0.0, 0.03) + excess


def write(name, lines):
    (FOLDER / name).write_text("\n".join(lines) + "\n")


def points():
    ranges = ["point,t_s,tag,anchor,range_m,seq"]
    time, sequence = 10.0, 250
    for name, (x, y) in POINTS.items():
        for k in range(12):
            for a in ANCHORS:
                excess = 0.5 if name == "east" and a[0] == 3 and 3 <= k < 9 else 0.0
                ranges.append(f"{name},{time:.3f},0,{a[0]},{distance(x, y, a, excess):.3f},{sequence % 256}")
            time += 0.28
            sequence += 1
    write("points.csv", ranges)
    truth = ["point,x_m,y_m,z_m,place"]
    truth += [f"{n},{x:g},{y:g},{HEIGHT:g},{'rack' if n == 'east' else 'open'}" for n, (x, y) in POINTS.items()]
    write("points-truth.csv", truth)


def drive():
    x, y, heading, step = 1.8, 0.6, math.radians(20.0), 0.125
    ranges, truth = ["t_s,tag,anchor,range_m"], ["t_s,tag,x_m,y_m,z_m"]
    wheels, reads, tags = ["t_s,v_left_mps,v_right_mps"], ["t_s,uid,rssi"], {}
    for k in range(240):
        time = step * (k + 1)
        speed, turn = (0.0, 0.0) if k < 8 else (0.12, 0.12)
        x += speed * step * math.cos(heading + 0.5 * turn * step)
        y += speed * step * math.sin(heading + 0.5 * turn * step)
        heading += turn * step
        a = ANCHORS[k % 4]
        ranges.append(f"{time:.3f},5,{a[0]},{distance(x, y, a, 0.4 if a[0] == 2 and 90 < k < 150 else 0.0):.3f}")
        truth.append(f"{time:.3f},5,{x:.4f},{y:.4f},{HEIGHT:g}")
        left = (speed - 0.5 * WHEELS * turn) * (1.0 + random.gauss(0.0, 0.03))
        right = (speed + 0.5 * WHEELS * turn) * (1.02 + random.gauss(0.0, 0.03))
        wheels.append(f"{time:.3f},{left:.4f},{right:.4f}")
        if k % 10 == 0:
            column, row = round(x / PITCH), round(y / PITCH)
            uid = f"E00401503B00{column:02X}{row:02X}"
            tags[uid] = (column, row)
            reads.append(f"{time:.3f},{uid},5")
    write("drive.csv", ranges)
    write("drive-truth.csv", truth)
    write("drive-odometry.csv", wheels)
    write("drive-reads.csv", reads)
    write("drive-tags.csv", ["uid,x_mm,y_mm"] + [f"{u},{c * 100},{r * 100}" for u, (c, r) in sorted(tags.items())])


if __name__ == "__main__":
    random.seed(7)
    write("anchors.csv", ["anchor,x_m,y_m,z_m"] + ["%d,%g,%g,%g" % a for a in ANCHORS])
    points()
    drive()
