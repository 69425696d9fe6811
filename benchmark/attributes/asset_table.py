#!/usr/bin/env python3
# The table of doc/benchmarks.md, of what assets.py has measured: python3 asset_table.py assets.csv
import csv
import math
import sys
from collections import defaultdict

ERRORS = ("shape", "colour", "normal")
SHOWN = ("gltfpack", "gltfpack -sv -sp")


def pairs(path):
    """Rows of gltfpack, and of the program at the same count."""
    with open(path) as file:
        for row in csv.DictReader(file):
            if row["contender"].startswith("gltfpack"):
                theirs = row
            elif row["contender"] == "quadrille" and theirs:
                yield theirs, row


def errors(row):
    return " / ".join(f"{float(row[key]):.3g}" for key in ERRORS)


def main():
    rows, ratios = defaultdict(dict), defaultdict(list)
    for theirs, own in pairs(sys.argv[1]):
        rows[theirs["model"], theirs["part"]][theirs["contender"]] = theirs, own
        for key in ERRORS + ("ms",):
            if float(theirs[key]) > 0 and float(own[key]) > 0 and int(own["faces"]) < 1.02 * int(theirs["faces"]):
                ratios[theirs["contender"], key].append(float(own[key]) / float(theirs[key]))
    print("| model | faces | gltfpack | `-sv -sp` | Quadrille |\n|---|--:|---|---|---|")
    for (model, _), found in rows.items():
        if SHOWN[1] in found:
            theirs, own = found[SHOWN[1]]
            plain = found[SHOWN[0]][0] if SHOWN[0] in found else None
            near = plain and abs(int(plain["faces"]) / int(theirs["faces"]) - 1) < 0.02
            print(f"| {model} | {int(own['faces']):,} | {errors(plain) if near else '–'} | {errors(theirs)} | {errors(own)} |")
    print("\n| ours / theirs | shape | colours | normals |\n|---|--:|--:|--:|")
    for contender in dict.fromkeys(c for c, _ in ratios):
        cells = []
        for key in ERRORS:
            found = ratios[contender, key]
            mean = math.exp(sum(map(math.log, found)) / len(found))
            cells.append(f"{mean:.2f}, above in {sum(x > 1.005 for x in found)} of {len(found)}")
        print(f"| `{contender}` | " + " | ".join(cells) + " |")


main()
