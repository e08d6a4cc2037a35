#!/usr/bin/env python3
"""Prints what a drop came to, as a short table. Standard library only.

    report.py out/ffp
"""

import math
import os
import sys

from regular_file import read_json


def rows(found):
    """[(quantity, text)] of a summary.json."""
    ended = {"done": "ran to its end", "running": "has not ended, or was killed"}.get(found["status"], found["status"])
    table = [("run", ended)]
    if "penetrometer" in found:
        table.insert(0, ("penetrometer", penetrometer(found["penetrometer"])))
    if "failure" in found:
        table.append(("", found["failure"]))
    if "final_penetration_m" in found:
        table += [
            ("depth", f"{found['final_penetration_m']:.3f} m at {found['end_s'] * 1e3:.0f} ms"),
            ("greatest depth", f"{found['max_penetration_m']:.3f} m at {found['max_penetration_time_s'] * 1e3:.0f} ms"),
            *tilted(found),
            ("peak deceleration", peak(found, "peak")),
            ("second peak", peak(found, "second_peak")),
            ("peak reaction", f"{found['peak_reaction_N'] / 1e3:.2f} kN (2 ms mean)"),
            ("energy taken by the transfer", f"{round(found['energy_transfer'] * 100, 1) + 0:.1f} % of the energy put in"),
            ("energy residual", f"{round(found['energy_residual'] * 100, 1) + 0:.1f} % of the energy put in"),
            ("points", f"{found['points']:,}, of which {found['lost_points']:,} left the mesh"),
            ("steps", f"{found['steps']:,} of {found['dt_min_s'] * 1e6:.0f} to {found['dt_max_s'] * 1e6:.0f} us in {found['wall_s']:.1f} s"),
        ]
    if "uncertainty" in found:
        table += error_bars(found["uncertainty"])
    warnings = found.get("warnings", [])
    table.append(("warnings", "none" if not warnings else f"{len(warnings)}"))
    table += [("", text) for text in warnings]
    return table


def tilted(found):
    """How a penetrometer that may turn came to rest."""
    if found.get("final_tilt_deg") is None:
        return []
    return [("at its end", f"tilted by {found['final_tilt_deg']:.1f} deg, its tip {found['final_aside_m'] * 100:.1f} cm to the side that it pointed to")]


def penetrometer(one):
    """Name and sizes of the penetrometer."""
    sizes = f"{one['diameter_m'] * 100:.3g} cm wide, {one['length_m'] * 100:.3g} cm long, {one['mass_kg']:.3g} kg"
    return f"{one['name']}: {sizes} ({one['mean_density_kg_m3']:,.0f} kg/m3)"


def error_bars(bar):
    """Lines of the drop's error bar: value, uncertainty and its parts, of depth and peak."""
    table = []
    for name, key, unit in (("depth with bar", "final_penetration_m", "m"), ("peak with bar", "peak_deceleration_g", "g")):
        result = bar[key]
        if result["u"] is None:
            text = f"{result['value']:.3g} {unit} +- unknown (at least {result['u_at_least']:.2g} {unit})"
        else:
            text = f"{with_bar(result['value'], result['u'])} {unit}"
        parts = ", ".join(f"{part} {'unknown' if u is None else f'{u:.2g}'}" for part, u in result["parts"].items())
        table += [(name, text + ("" if result["converged"] else ", not converged")), ("", parts)]
    return table


def with_bar(value, u):
    """"0.195 +- 0.012": two digits of the uncertainty, and the value as far."""
    decimals = min(max(1 - math.floor(math.log10(u)), 0), 9) if u > 0 else 6
    return f"{value:.{decimals}f} +- {u:.{decimals}f}"


def peak(found, name):
    """One peak of the deceleration in words."""
    value = found[f"{name}_deceleration_g"]
    if value is None:
        return "none"
    return f"{value:.1f} g at {found[f'{name}_time_s'] * 1e3:.1f} ms and {found[f'{name}_penetration_m']:.3f} m (2 ms mean)"


def main():
    if len(sys.argv) != 2:
        sys.exit("report.py: needs one folder, that of a drop")
    folder = sys.argv[1]
    try:
        found = read_json(os.path.join(folder, "summary.json"))
        for name, text in rows(found):
            print(f"{name:<18} {text}")
    except (OSError, ValueError, KeyError, TypeError) as problem:
        sys.exit(f"report.py: {folder}: must hold the summary.json of a drop ({problem!r})")
    files = (("summary", "summary.json"), ("history", "history.csv"), ("for ParaView", "fields.pvd"),
             ("pictures", "histories.png"), ("", "strain.png"))
    for name, file in files:
        if os.path.exists(os.path.join(folder, file)):
            print(f"{name:<18} {os.path.join(folder, file)}")


if __name__ == "__main__":
    main()
