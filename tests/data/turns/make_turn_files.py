#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the emulator files and the reader capture of this folder.

The emulator files follow the program printed in appendix A of the seed, its defect included: in mode 2 (changes
only) a tag that leaves the range is logged with the RSSI of the last tag that was found in range.
"""
import math
import pathlib

HERE = pathlib.Path(__file__).parent
EDGES_CM = [14, 9.75, 9.0, 8.0, 7.0, 6.0, 5.8, 5.5, 5.3, 5.1, 5.0, 4.7, 4.5, 4.3, 4.2, 4.0, 3.5, 2.75, 0]
RSSI = [0, 1, 2, 3, 4, 5, 4, 3, 2, 1, 0, 1, 2, 3, 4, 5, 6, 7, 7]
SHORT_UIDS = ["AE4", "586", "BF4", "689", "785", "691", "47A", "ADC", "78D"]


def rssi_at(distance_cm):
    steps = [r for edge, r in zip(EDGES_CM, RSSI) if edge >= distance_cm]
    return steps[-1] if steps else None


def emulate(columns, rows, x, y, bearing, mode, stops=9, step=45, direction=1):
    """Yields (angle, tag number, logged RSSI)."""
    old = [0] * (columns * rows)
    last_found = 0
    for stop in range(stops):
        angle = stop * step
        a = math.radians(bearing + direction * angle)
        ax, ay = x + 10 * math.cos(a), y + 10 * math.sin(a)
        new = list(old)
        for m in range(columns * rows):
            rssi = rssi_at(math.hypot(10 * (m // rows) - ax, 10 * (m % rows) - ay))
            new[m] = 0 if rssi is None else rssi
            if rssi is not None:
                last_found = rssi
            changed = new[m] != old[m]
            if (mode == 1 and rssi is not None) or (mode == 2 and changed):
                yield angle, m + 1, last_found
        old = new


def write(name, lines, end="\n"):
    (HERE / name).write_bytes("".join(line + end for line in lines).encode())


def side_file(number, tags, length, bearing, x, y):
    def decimal(value):  # %6d of MATLAB: exponents for what is no integer
        return f"{value:6d}" if float(value).is_integer() else f"{value:e}"
    write(f"NumTags{number}.txt", [f"{tags:6d}", f"{length:6d}", f"{math.radians(bearing):6.4f}", decimal(x), decimal(y)])


DEFAULT = dict(columns=11, rows=11, x=22.5, y=51.5, bearing=22.5)
write("emulator_filtered11.txt", [f"{a}  {m} {r} " for a, m, r in emulate(**DEFAULT, mode=1)])
write("emulator_reader12.txt", [f"{a} SCAN:+UID={m:016X}+RSSI={r}<\\r>" for a, m, r in emulate(**DEFAULT, mode=1)])
write("emulator_changes13.txt", [f"{a}  {m} {r} " for a, m, r in emulate(**DEFAULT, mode=2)], "\r\n")
write("emulator_reader_changes14.txt", [f"{a} SCAN:+UID={m}+RSSI={r}<\\r>" for a, m, r in emulate(**DEFAULT, mode=2)])
for number in (11, 12, 13, 14):
    side_file(number, 121, 100, 22.5, 22.5, 51.5)

lines = ["# agv-capture 1", "# turn step_deg=45 turn_time_ms=1125 rotation=cw kind=timed at_ms=0"]
time = 200.0
for stop in range(9):
    lines.append(f"# stop {stop + 1} at_ms={time:g}")
    reads = [(m, r) for a, m, r in emulate(3, 3, 10.6, 9.3, 130, 1, direction=-1) if a == stop * 45]
    for repeat in range(3):
        for m, r in reads:
            time += 31.25
            lines.append(f"@{time:g} SCAN:+UID=E00401503A5BD{SHORT_UIDS[m - 1]},+RSSI={r}/{max(0, r - 1)}")
        time += 31.25
        lines.append(f"@{time:g} SCAN:-UID=E00401503A5BD{SHORT_UIDS[reads[0][0] - 1]}")
    lines.append(f"# moving at_ms={time:g}")
    lines.append(f"@{time + 100:g} SCAN:+UID=E00401503A5BD{SHORT_UIDS[reads[-1][0] - 1]},+RSSI=0/0")
    lines.append(f"@{time + 200:g} SCAN:+UID=E0040150\\xFF")
    time += 1325
lines.append(f"# end at_ms={time:g}")
write("capture_small_field.txt", lines)
