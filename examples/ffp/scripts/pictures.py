"""What the driver's pictures share: matplotlib, which draws into files, the colours, and how a picture is written."""

import os
import sys

from regular_file import replaced

try:
    import matplotlib
except ImportError:
    sys.exit(f"{os.path.basename(sys.argv[0])}: needs matplotlib; on Debian: apt install python3-matplotlib, and "
             "/usr/bin/python3 finds it")

matplotlib.use("Agg")
import matplotlib.pyplot as pyplot  # noqa: E402

COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"]  # Okabe and Ito
REFERENCE = "#6b6b6b"

#: What decides the paper's drop, beside the friction of the penetrometer and the numerics; keys that are not there are at their defaults.
PAPER = {"tip": "cone", "velocity_m_s": 5.6, "mass_kg": 7.71, "friction_deg": 40, "dilatancy_deg": 0, "cohesion_Pa": 0, "young_Pa": 5e6,
         "poisson": 0.33, "unit_weight_N_m3": 15100, "law": "mohr-coulomb"}
OTHERS = ["penetrometer", "device_profile", "chamber_radius_m", "soil_depth_m"]


def is_of_paper(inputs):
    """Whether the inputs of a drop are those that the paper's values belong to."""
    return all(inputs.get(key, value) == value for key, value in PAPER.items()) and not any(key in inputs for key in OTHERS) \
        and not inputs.get("tilt_deg")


def device_name(summary):
    """Name of the penetrometer of a summary.json or reduced.json."""
    return summary.get("penetrometer", {}).get("name", "bluedrop")


def legend_below(figure, axes, columns, share):
    """One legend for all panels, from the lines of one, in the lowest `share` of the figure's height."""
    figure.legend(*axes.get_legend_handles_labels(), loc="lower center", ncol=columns, frameon=False, fontsize=9)
    figure.get_layout_engine().set(rect=(0, share, 1, 1 - share))


def save(figure, path, dpi="figure"):
    """Writes a picture; a link at its name is replaced, not followed."""
    with replaced(path) as file:
        figure.savefig(file, dpi=dpi, format=os.path.splitext(path)[1].lstrip(".") or "png")


def save_pictures(figure, folder, name):
    """Writes name.png and name.svg; returns their paths. Ends the script with a sentence if they cannot be written."""
    paths = [os.path.join(folder, f"{name}.{kind}") for kind in ("png", "svg")]
    try:
        os.makedirs(folder, exist_ok=True)
        for path in paths:
            save(figure, path, dpi=130)
    except OSError as problem:
        sys.exit(f"{os.path.basename(sys.argv[0])}: {problem.filename}: cannot be written: {problem.strerror}")
    pyplot.close(figure)
    return paths
