"""On a slope of 30 deg a soft block slides over a rigid bed, and a rigid ball rolls over a soft one. Gives: friction of
tan(20 deg) of the block's normal force, and an acceleration of 2/3 g sin (in the plane a ball is a cylinder), within 1 %.

block_and_ball.py [PICTURE]"""

import sys

import numpy as np

import arenite as ar

g, slope, cell, radius, mass = 9.81, np.radians(30), 0.02, 0.2, 500.0  # kg a metre
rubber = ar.MohrCoulomb(density=2000, young=3e6, poisson=0.2, friction=np.radians(45), cohesion=1e6)  # too strong to yield


def scene(shape, rigid):
    return ar.Scene(ar.PlaneStrain(), ar.CartesianGrid((0, 0), (1.6, 0.4), cell=cell), ar.Numerics(ar.QuadraticBSpline, ar.Apic),
                    bodies=[ar.fill("rubber", shape, rubber)], walls=[ar.left("roller"), ar.right("roller"), ar.bottom("fixed")],
                    gravity=(g * np.sin(slope), -g * np.cos(slope)), rigids=[rigid])  # tilted in place of the bed


def acceleration(scene, velocity):
    """Mean along and across the slope, m/s2, from 0.2 s, when the bodies have settled, to 0.5 s."""
    ar.run(scene, end=0.2, courant=0.4)
    begin, before = scene.time, np.array(velocity())
    ar.run(scene, end=0.5, courant=0.4)
    return (np.asarray(velocity()) - before) / (scene.time - begin)


friction = np.radians(20)
bed = ar.Rigid(ar.Box((-1, -1), (3, 0.1)), ar.Prescribed((0, 0)), friction=friction)
slides = scene(ar.Box((0.2, 0.1 + cell / 2), (0.6, 0.3 + cell / 2)), bed)
along, across = acceleration(slides, lambda: slides.bodies["rubber"].velocity.mean(axis=0))
# The block is elastic and bounces a little: friction is compared with the mean of the normal force.
rubbed = (g * np.sin(slope) - along) / (g * np.cos(slope) + across)

high = 0.1 + radius + cell / 2  # contact acts half a cell outside of the ball
ball = ar.Rigid(ar.Ball((0.4, high), radius), ar.Free(mass=mass, inertia=mass * radius**2 / 2, centre=(0.4, high, 0)),
                friction=np.radians(35), name="ball")
rolls = scene(ar.Box((0, 0), (1.6, 0.1)), ball)
rolled = acceleration(rolls, lambda: rolls.rigids["ball"].velocity)[0]

for name, found, exact in (("block friction", rubbed, np.tan(friction)), ("ball m/s2", rolled, g * np.sin(slope) * 2 / 3)):
    print(f"{name} {found:.3f}, exact {exact:.3f}, {100 * (found / exact - 1):+.2f} %")

if len(sys.argv) > 1:
    import matplotlib.pyplot as plt
    from matplotlib.patches import Circle

    def turned(x):  # the slope as it is seen
        return x @ np.array([[np.cos(slope), -np.sin(slope)], [np.sin(slope), np.cos(slope)]])

    figure, axes = plt.subplots(1, 2, figsize=(7, 3), sharex=True, sharey=True, constrained_layout=True)
    for side, of, title in zip(axes, (slides, rolls), (f"friction of the block {rubbed:.3f}", f"ball {rolled:.2f} m/s2")):
        x = turned(np.asarray(of.bodies["rubber"].position))
        side.scatter(x[:, 0], x[:, 1], s=2)
        side.set(aspect="equal", xlabel="x [m]", title=f"{title} after {of.time:.1f} s")
    axes[0].fill(*turned(np.array([(0, 0.1), (1.6, 0.1), (1.6, 0), (0, 0)])).T, color="grey")
    start, moved = np.array([0.4, high]), rolls.rigids["ball"].displacement[:2]
    for centre, style in ((start, ":"), (start + moved, "-")):
        axes[1].add_patch(Circle(tuple(turned(centre)), radius, fill=False, ls=style))
    corners = np.array([(0.2, 0.11), (0.6, 0.11), (0.6, 0.31), (0.2, 0.31), (0.2, 0.11)])
    axes[0].plot(*turned(corners).T, "k:")
    axes[0].set(ylabel="y [m]")
    figure.savefig(sys.argv[1])
