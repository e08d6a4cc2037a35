#!/usr/bin/env python3
"""Draws docs/images/penetrometers.png: the penetrometers of arenite-ffp, each dropped into the paper's sand. Needs numpy and matplotlib.

    docs/penetrometers.py ARENITE_FFP
"""

import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "examples" / "ffp" / "scripts"))

from pictures import pyplot, save  # noqa: E402
from plot import Drop, nearest_fields, paint  # noqa: E402

#: As in the table of docs/ffp_practice.md.
DEVICES = [["--penetrometer", "bluedrop"], ["--tip", "cone-truncated"], ["--tip", "parabolic"], ["--tip", "blunt"],
           ["--penetrometer", "cone-10cm2", "--length", "0.4", "--mass", "1.2", "--soil-depth", "0.4"],
           ["--penetrometer", "cone-15cm2", "--length", "0.5", "--mass", "2", "--soil-depth", "0.4"],
           ["--penetrometer", "ball-100cm2", "--mass", "8"], ["--penetrometer", "sphere-25cm", "--mass", "50"]]


def main():
    if len(sys.argv) != 2:
        sys.exit("docs/penetrometers.py: needs the program arenite-ffp")
    figure, rows = pyplot.subplots(2, 4, figsize=(12, 5.2), constrained_layout=True, dpi=110)
    with tempfile.TemporaryDirectory() as folder:
        for k, (axes, device) in enumerate(zip(rows.flat, DEVICES)):
            out = str(Path(folder) / str(k))
            subprocess.run([sys.argv[1], "drop", *device, "--fields-every", "0.1", "--quiet", "--accuracy", "coarse", "--out", out], check=True)
            drop = Drop(out)
            wide = max(0.6 * drop.chamber["radius_m"], 1.6 * drop.summary["final_penetration_m"])
            axes.set(xlim=(-wide, wide), ylim=(-0.8 * wide, 0.8 * wide), aspect="equal")
            axes.set_title(f"{drop.name}: {100 * drop.summary['final_penetration_m']:.1f} cm", fontsize=10)
            axes.set_ylabel("height [m]" if k % 4 == 0 else "", fontsize=9)
            axes.drop, axes.field = drop, nearest_fields(drop, [1.0])[-1]
        figure.canvas.draw()  # fixes the sizes, which the markers follow
        for axes in rows.flat:
            image = paint(axes, axes.drop, axes.field)
    figure.colorbar(image, ax=rows, extend="max", shrink=0.8, pad=0.01).set_label("deviatoric strain at 0.1 s [-]")
    save(figure, str(ROOT / "docs" / "images" / "penetrometers.png"))


if __name__ == "__main__":
    main()
