#!/usr/bin/env python3
"""Draws docs/images/sand_paths.svg from the sand_paths.csv that examples/sand_paths.cpp writes: sand_paths.py FILE"""

import csv
import pathlib
import sys

COLOURS = ["#555555", "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00"]  # Okabe and Ito
WIDTH, HEIGHT, LEFT, BOTTOM, TOP = 640, 400, 60, 50, 15
X_END, Y_START, Y_END = 0.5, 0.5, 0.75


def x_of(gamma):
    return LEFT + (WIDTH - LEFT - 190) * gamma / X_END


def y_of(ratio):
    return HEIGHT - BOTTOM - (HEIGHT - BOTTOM - TOP) * (ratio - Y_START) / (Y_END - Y_START)


def text(x, y, words, anchor="middle", colour="#000000"):
    return f'<text x="{x:.0f}" y="{y:.0f}" text-anchor="{anchor}" fill="{colour}">{words}</text>'


def main():
    curves = {}
    with open(sys.argv[1], newline="") as file:
        for row in csv.DictReader(file):
            curves.setdefault(row["policy"], []).append((float(row["gamma"]), float(row["tau over p"])))
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="13">',
           f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#ffffff"/>']
    for k in range(6):
        gamma, ratio = X_END * k / 5, Y_START + (Y_END - Y_START) * k / 5
        out.append(f'<path d="M{x_of(0):.1f} {y_of(ratio):.1f}H{x_of(X_END):.1f}" stroke="#dddddd"/>')
        out.append(text(x_of(gamma), HEIGHT - BOTTOM + 18, f"{gamma:.1f}"))
        out.append(text(LEFT - 8, y_of(ratio) + 4, f"{ratio:.2f}", "end"))
    out.append(text(x_of(X_END / 2), HEIGHT - 12, "shear strain gamma"))
    out.append(text(16, TOP + 36, "tau / p", "start"))
    heights = {}
    for (name, points), colour in zip(curves.items(), COLOURS):
        points = [point for point in points if point[1] >= Y_START]
        path = "L".join(f"{x_of(gamma):.1f} {y_of(ratio):.1f}" for gamma, ratio in points[:: max(1, len(points) // 150)])
        out.append(f'<path d="M{path}" fill="none" stroke="{colour}" stroke-width="2"/>')
        heights[name] = (y_of(points[-1][1]) + 4, colour)
    last = -100.0
    for name, (height, colour) in sorted(heights.items(), key=lambda item: item[1][0]):
        last = max(height, last + 15)
        out.append(text(x_of(X_END) + 8, last, name, "start", colour))
    target = pathlib.Path(__file__).resolve().parent / "images" / "sand_paths.svg"
    target.write_text("\n".join(out + ["</svg>", ""]))


main()
