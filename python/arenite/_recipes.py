"""Recipes that are aggregates of the C++ library. Written by python/tools/recipes.py out of its headers: change those."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Dict, Optional, Sequence, Union

from ._bases import Contact, Cone, Frictional, Kind, Law, NOT_GIVEN, Part, Policy
from ._recipe import Recipe

if TYPE_CHECKING:
    from .shapes import Region


@dataclass(frozen=True)
class LinearElastic(Law):
    """Hypoelastic law: the Jaumann rate of the Cauchy stress is Hooke's law of the strain rate. For small elastic
    strains; in large shear the stress oscillates (tau = G sin(gamma)), as is known of this rate.

    parameter  unit   range      default  meaning
    density    kg/m3  > 0        needed
    young      Pa     > 0        needed   Young's modulus
    poisson    -      (-1, 0.5)  needed   Poisson's ratio"""

    density: float = NOT_GIVEN
    young: float = NOT_GIVEN
    poisson: float = NOT_GIVEN


@dataclass(frozen=True)
class ForgetsOpening(Policy):
    """Separated matter carries stress as soon as it is compressed again, however far it had opened. Stores nothing."""


@dataclass(frozen=True)
class RemembersOpening(Policy):
    """Separated matter carries no stress until what it had opened is closed again.

    parameter  unit  range  default  meaning
    limit      -     > 0    1.0      greatest opening that is remembered, a volumetric strain"""

    limit: float = 1.0


@dataclass(frozen=True)
class ConstantFriction(Policy):
    """The angle of the law's parameters, everywhere and always. Stores nothing."""


@dataclass(frozen=True)
class LinearRateFriction(Policy):
    """tan(phi) = tan(phi_0) + time * rate, with phi_0 of the law's parameters and rate = sqrt(2 e:e) of the deviatoric
    strain rate e, smoothed.

    parameter  unit  range  default  meaning
    time       s     >= 0   0.001    0: the friction of the law's parameters
    smoothing  s     >= 0   0.0      time over which the rate is smoothed; 0: none"""

    time: float = 0.001
    smoothing: float = 0.0


@dataclass(frozen=True)
class InertialFriction(Policy):
    """tan(phi) = mu_s + rise / (I_0 / I + 1), I = rate d / sqrt(p / rho_s), with mu_s = tan(phi) of the law's
    parameters and rise = mu_2 - mu_s. Jop, Forterre & Pouliquen (2006), A constitutive law for dense granular flows,
    Nature 441, 727-730.

    parameter          unit   range  default  meaning
    rise               -      >= 0   0.261    mu_2 - mu_s; 0: the friction of the law's parameters
    reference_inertia  -      > 0    0.279    I_0
    grain_size         m      > 0    0.00053  d
    grain_density      kg/m3  > 0    2450.0   rho_s
    smoothing          s      >= 0   0.0      time over which the rate is smoothed; 0: none"""

    rise: float = 0.261
    reference_inertia: float = 0.279
    grain_size: float = 0.00053
    grain_density: float = 2450.0
    smoothing: float = 0.0


@dataclass(frozen=True)
class LogarithmicFriction(Policy):
    """phi = phi_p (1 + a log10(rate / reference)) with phi_p of the law's parameters. Zambrano-Cruzatty & Yerro (2020),
    Numerical simulation of a free fall penetrometer deployment using the material point method, Soils and Foundations
    60, 668-682. Below the reference rate it is phi_p: the formula would go to minus infinity at rest. It ends at 1.55
    rad.

    parameter       unit  range  default  meaning
    per_decade      -     >= 0   0.027    a; 0: the friction of the law's parameters
    reference_rate  1/s   > 0    2.1e-05
    smoothing       s     >= 0   0.0      time over which the rate is smoothed; 0: none"""

    per_decade: float = 0.027
    reference_rate: float = 2.1e-05
    smoothing: float = 0.0


@dataclass(frozen=True)
class SofteningFriction(Policy):
    """phi = phi_r + (phi_p - phi_r) exp(-eta eps_p), and the dilatancy psi alike, with peak values phi_p and psi_p of
    the law's parameters. eps_p is the sum of the steps' deviatoric plastic strains sqrt(2/3 e:e); a step has the angles
    of what was sheared before it. With psi_r = 0 the matter ends at its critical state, at constant volume; all it
    dilates is finite.

    parameter           unit  range                   default  meaning
    residual_friction   rad   (0, 1.55]               needed   at most the law's friction
    residual_dilatancy  rad   [0, residual_friction]  0.0      0: ends at constant volume
    decay               -     >= 0                    needed   eta, per unit of plastic strain
    cell_size           m     >= 0                    0.0      size of the cells; 0: `decay` as it is
    reference_size      m     >= 0                    0.0      size of the cells, or thickness of the band, that has `decay`"""

    residual_friction: float = NOT_GIVEN
    residual_dilatancy: float = 0.0
    decay: float = NOT_GIVEN
    cell_size: float = 0.0
    reference_size: float = 0.0


@dataclass(frozen=True)
class RateSofteningFriction(Policy):
    """phi = phi_r + (phi_p(rate) - phi_r) exp(-eta eps_p), phi_p(rate) = phi_p (1 + a log10(rate / reference)), and the
    dilatancy alike with its own factor; peak values phi_p and psi_p of the law's parameters. Below the reference rate
    the factors are 1. Zambrano-Cruzatty & Yerro (2020), Soils and Foundations 60, 668-682, and their code for users of
    Anura3D and Abaqus. Softening: see `SofteningFriction`.

    parameter             unit  range                default            meaning
    softening             -     `SofteningFriction`  SofteningFriction
    friction_per_decade   -     >= 0                 0.027              a of phi
    dilatancy_per_decade  -     >= 0                 0.27               a of psi
    reference_rate        1/s   > 0                  2.1e-05
    smoothing             s     >= 0                 0.0                time over which the rate is smoothed; 0: none"""

    softening: SofteningFriction = field(default_factory=SofteningFriction)
    friction_per_decade: float = 0.027
    dilatancy_per_decade: float = 0.27
    reference_rate: float = 2.1e-05
    smoothing: float = 0.0


@dataclass(frozen=True)
class ConstantStiffness(Policy):
    """The moduli of the law's parameters, everywhere and always."""


@dataclass(frozen=True)
class PressureStiffness(Policy):
    """E = E_ref (p / p_ref)^n of the mean pressure p at the start of the step, E_ref of the law's parameters; not below
    that of `lowest_pressure`. Ohde (1939) and Janbu (1963), as in the hardening soil model (Schanz, Vermeer & Bonnier
    1999).

    parameter           unit  range   default   meaning
    exponent            -     [0, 1]  0.5       n; 0: the moduli of the law's parameters
    reference_pressure  Pa    > 0     100000.0  p_ref
    lowest_pressure     Pa    > 0     1000.0    below it the moduli are those at it"""

    exponent: float = 0.5
    reference_pressure: float = 100000.0
    lowest_pressure: float = 1000.0


@dataclass(frozen=True)
class RateStiffness(Policy):
    """G = G_r + (G_p (1 + a log10(rate / reference)) - G_r) exp(-eta eps_p), times (p / p_ref)^n as in
    `PressureStiffness`; G_p of the law's parameters. Below the reference rate the factor is 1. Rate and plastic strain
    are those of the step before, which the friction policy keeps: `RateSofteningFriction`, perhaps with factors of 0.
    Poisson's ratio stays, so that the bulk modulus follows G; the code of Zambrano-Cruzatty & Yerro (2020) gives it its
    own factor (0.155).

    parameter       unit  range                default                          meaning
    per_decade      -     >= 0                 0.102                            a
    reference_rate  1/s   > 0                  2.1e-05
    residual        -     (0, 1]               1.0                              G_r / G_p
    decay           -     >= 0                 0.0                              eta, per unit of plastic strain
    pressure        -     `PressureStiffness`  PressureStiffness(exponent=0.0)"""

    per_decade: float = 0.102
    reference_rate: float = 2.1e-05
    residual: float = 1.0
    decay: float = 0.0
    pressure: PressureStiffness = field(default_factory=lambda: PressureStiffness(exponent=0.0))


@dataclass(frozen=True)
class MohrCoulomb(Frictional):
    """Mohr-Coulomb law. Where planes, edges, apex and cut-off intersect, a trial stress returns to all of them at once
    (Koiter's rule).

    parameter              unit   range                default            meaning
    density                kg/m3  > 0                  needed
    young                  Pa     > 0                  needed             Young's modulus
    poisson                -      (-1, 0.5)            needed             Poisson's ratio
    friction               rad    [0, 1.55]            needed             angle of friction; 0: Tresca
    cohesion               Pa     >= 0                 0.0                positive where friction is 0
    dilatancy              rad    [0, friction]        0.0                angle of dilatancy
    greatest_volume_ratio  -      >= 1                 1.5                V / V0 beyond which the matter dilates no further
    tension                Pa     >= 0                 inf                greatest principal stress; infinite: that of the apex, cohesion / tan(friction)
    memory                 -      a memory of opening  ForgetsOpening
    friction_law           -      a friction           ConstantFriction   by point
    stiffness_law          -      a stiffness          ConstantStiffness  by point"""

    density: float = NOT_GIVEN
    young: float = NOT_GIVEN
    poisson: float = NOT_GIVEN
    friction: float = NOT_GIVEN
    cohesion: float = 0.0
    dilatancy: float = 0.0
    greatest_volume_ratio: float = 1.5
    tension: float = float("inf")
    memory: Policy = field(default_factory=ForgetsOpening)
    friction_law: Policy = field(default_factory=ConstantFriction)
    stiffness_law: Policy = field(default_factory=ConstantStiffness)


@dataclass(frozen=True)
class DruckerPrager(Frictional):
    """Drucker-Prager law. A trial stress returns to cone and cut-off at once (Koiter's rule).

    parameter              unit   range                default            meaning
    density                kg/m3  > 0                  needed
    young                  Pa     > 0                  needed             Young's modulus
    poisson                -      (-1, 0.5)            needed             Poisson's ratio
    friction               rad    [0, 1.55]            needed             angle of friction; 0: von Mises
    cohesion               Pa     >= 0                 0.0                positive where friction is 0
    dilatancy              rad    [0, friction]        0.0                angle of dilatancy
    greatest_volume_ratio  -      >= 1                 1.5                V / V0 beyond which the matter dilates no further
    tension                Pa     >= 0                 inf                greatest mean stress; infinite: that of the apex, cohesion / tan(friction)
    cone                   -      a `Cone`             Cone.compression   which Mohr-Coulomb strength it reproduces
    memory                 -      a memory of opening  ForgetsOpening
    friction_law           -      a friction           ConstantFriction   by point
    stiffness_law          -      a stiffness          ConstantStiffness  by point"""

    density: float = NOT_GIVEN
    young: float = NOT_GIVEN
    poisson: float = NOT_GIVEN
    friction: float = NOT_GIVEN
    cohesion: float = 0.0
    dilatancy: float = 0.0
    greatest_volume_ratio: float = 1.5
    tension: float = float("inf")
    cone: Cone = Cone.compression
    memory: Policy = field(default_factory=ForgetsOpening)
    friction_law: Policy = field(default_factory=ConstantFriction)
    stiffness_law: Policy = field(default_factory=ConstantStiffness)


@dataclass(frozen=True)
class LinearSimplex(Kind):
    """Shape function of triangles (3 nodes a cell) and tetrahedra (4)."""


@dataclass(frozen=True)
class LinearGrid(Kind):
    """Linear functions on a grid."""


@dataclass(frozen=True)
class QuadraticBSpline(Kind):
    """Quadratic B-splines on a grid."""


@dataclass(frozen=True)
class CubicBSpline(Kind):
    """Cubic B-splines on a grid."""


@dataclass(frozen=True)
class UGimp(Kind):
    """Uniform GIMP on a `CartesianGrid` (Bardenhagen and Kober 2004), of bodies with `Points` points along each axis of
    a cell at first. (Of one point its functions are those of quadratic splines, half a cell away from the faces.)

    parameter  unit  range  default  meaning
    points     -     >= 1   2        along each axis of a cell at first"""

    points: int = 2


@dataclass(frozen=True)
class Flip(Kind):
    """PIC and FLIP in any blend: v_p = fraction (v_p + sum w (v_i^new - v_i^old)) + (1 - fraction) sum w v_i^new. FLIP
    (fraction 1; Brackbill and Ruppel 1986, doi:10.1016/0021-9991(86)90211-1) keeps energy and noise, PIC (fraction 0;
    Harlow 1964) damps both, at a rate that grows with the number of steps. With a time constant the fraction of a step
    dt is fraction exp(-dt / time), so that what points keep of their own velocity decays in time, whatever the step.

    parameter  unit  range   default  meaning
    fraction   -     [0, 1]  1.0      FLIP fraction; 0: PIC
    time       s     > 0     inf      time constant of the fraction; infinite: the fraction is that of each step"""

    fraction: float = 1.0
    time: float = float("inf")


@dataclass(frozen=True)
class Apic(Kind):
    """Affine particle-in-cell (Jiang et al. 2015, doi:10.1145/2766996): a point computes B = sum w v_i (x_i - x_p)^T,
    carries C = B D^-1, D = sum w (x_i - x_p)(x_i - x_p)^T, and returns w (v_p + C (x_i - x_p)). Conserves angular
    momentum to round-off if D is the same everywhere: not in the outermost cells of a grid."""


@dataclass(frozen=True)
class Tpic(Kind):
    """Taylor particle-in-cell: a point carries the velocity gradient L and returns w (v_p + L (x_i - x_p)) (Wallstedt
    and Guilkey 2007, doi:10.1016/j.jcp.2007.08.023, their velocity projection). No inertia tensor to invert."""


@dataclass(frozen=True)
class Aflip(Kind):
    """Affine FLIP (Fei, Guo, Wu, Huang and Gao 2021, ACM Trans. Graph. 40(4)): the velocity of FLIP in any blend, v_p =
    s (v_p + sum w (v_i^new - v_i^old)) + (1 - s) sum w v_i^new, and the velocity gradient of APIC.

    parameter  unit  range   default  meaning
    fraction   -     [0, 1]  1.0      FLIP fraction s"""

    fraction: float = 1.0


@dataclass(frozen=True)
class Fmpm(Kind):
    """FMPM of order k (Nairn and Hammerquist 2021, Comput. Methods Appl. Mech. Eng. 377, 113667): points interpolate
    the velocities that the momentum of the nodes gives with the full mass matrix M_ij = sum m w_i w_j in place of the
    lumped one, its inverse approximated by the first k terms of the series (I - S+ S)^l. Accelerations are corrected,
    too. Strains and positions follow the lumped velocities: with the corrected ones the stable step would fall as 1 /
    sqrt(k), for they multiply the velocities of light nodes by k.

    parameter  unit  range     default  meaning
    order      -     [1, 1e6]  2.0      a whole number; 1: PIC
    time       s     >= 0      0.0      time constant; 0: all of it in each step"""

    order: float = 2.0
    time: float = 0.0


@dataclass(frozen=True)
class Xpic(Kind):
    """Extended particle-in-cell of order m (Hammerquist and Nairn 2017, Comput. Methods Appl. Mech. Eng. 318, 724-738):
    FLIP with damping of the noise that the nodes do not see; the higher the order, the weaker the damping of anything
    else. Accelerations are those of FLIP.

    parameter  unit  range     default  meaning
    order      -     [1, 1e6]  2.0      a whole number; 1: PIC
    time       s     >= 0      0.0      time constant; 0: all of it in each step"""

    order: float = 2.0
    time: float = 0.0


@dataclass(frozen=True)
class Musl(Kind):
    """Update of stress last, from point velocities mapped back to the nodes once more (modified USL; Sulsky, Zhou,
    Schreyer 1995, doi:10.1016/0010-4655(94)00170-7): nodes of little mass get no spurious strain. On grids points move
    with the mapped velocities, too, unless the transfer is affine, so that positions and strains agree
    (docs/decisions.md, Kernels). Elastic bodies on simplices, without averages, use the stress at the middle of the
    step."""


@dataclass(frozen=True)
class Usl(Kind):
    """Update of stress last, from the nodal velocities of the step (update stress last, USL)."""


@dataclass(frozen=True)
class Usf(Kind):
    """Update of stress first, from the node velocities at the start of the step, so that the forces are those of the
    new stress (update stress first, USF; Bardenhagen 2002, doi:10.1006/jcph.2002.7103). It strains as MUSL does, but
    with the weights after the motion in place of those before it, and conserves energy with FLIP. P2G runs twice."""


@dataclass(frozen=True)
class NoAntiLocking(Kind):
    """The strain of each point as the shape functions give it."""


@dataclass(frozen=True)
class NodalAveraging(Kind):
    """Volumetric strain of a cell averaged with its neighbours' through the nodes: a node takes the mean of its cells,
    weighted by the volume of their points, a cell the mean of its nodes (Detournay and Dzik 2006, nodal mixed
    discretization; in MPM: Al-Kafaji 2013, Formulation of a dynamic material point method, sec. 4.1.3). For linear
    simplices."""


@dataclass(frozen=True)
class ElementAverage(Kind):
    """In a filled cell, the points get their mean stress, weighted by volume, once they are in their cells at the start
    of a step, and carry it over the whole volume of the cell (Gauss integration in filled cells; Beuth, Wieckowski,
    Vermeer 2011, doi:10.1002/nag.961); those of a partly filled cell keep their own stresses, and open points carry
    none.

    parameter  unit  range  default  meaning
    fill       -     > 0    0.5      a cell counts as filled from this fraction on"""

    fill: float = 0.5


@dataclass(frozen=True)
class NodalAndElementAverage(Kind):
    """Both: volumetric strains averaged over nodes, stresses over filled cells. With averaged strains a cell cannot
    even out the pressure errors that the scatter of its number of points causes; the mean stress over the whole volume
    of the cell does, so that the number of points affects the result far less than with either of the two.

    parameter  unit  range  default  meaning
    fill       -     > 0    0.5      a cell counts as filled from this fraction on"""

    fill: float = 0.5


@dataclass(frozen=True)
class ViscousDamping(Part):
    """Viscous damping: velocities decay as exp(-rate t), whatever the step. Critical for a mode of angular frequency w
    at rate = 2 w; below that the mode oscillates. It opposes all motion, free fall too.

    parameter  unit  range  default
    rate       1/s   >= 0   needed"""

    rate: float = NOT_GIVEN


@dataclass(frozen=True)
class LocalDamping(Part):
    """Local damping (Cundall 1987): at each node and along each axis a force of `factor` times the force out of balance
    there, against the velocity. It does not slow a steady motion down, but a free one: matter falls with 1 - factor of
    gravity. It needs no frequency: each mode loses the share 4 factor / (1 + factor)^2 of its energy in a cycle. The
    force out of balance is that of the whole step, impulses of contact and walls included: a body in quasi-static
    equilibrium, such as a slowly pushed footing, is not damped.

    parameter  unit  range   default  meaning
    factor     -     [0, 1)  0.7      share of the force out of balance"""

    factor: float = 0.7


@dataclass(frozen=True)
class Guided(Recipe):
    """A mass that slides along one axis without friction, under gravity, a load and the contact forces (the paper's
    eqs. 1 to 4).

    parameter  unit  range                            default          meaning
    mass       kg    > 0                              needed           of what the scene models (a slice, a metre, the full circle)
    axis       -     any                              (0.0, 1.0, 0.0)  direction of the guide; its length does not count
    velocity   m/s   any                              0.0              initial velocity along the axis
    load       N     a number, or a function of time  0.0              external force along the axis; a step takes that of its start"""

    functions = ("load",)

    mass: float = NOT_GIVEN
    axis: Sequence[float] = (0.0, 1.0, 0.0)
    velocity: float = 0.0
    load: Any = 0.0


@dataclass(frozen=True)
class PrescribedPose(Recipe):
    """A motion given in time, with rotation: the velocity of one point of the body, and the spin about it. No impulse
    changes them; the work of the drive is recorded. Values are those of the end of each step, in which the body turns
    by spin times dt about their axis.

    parameter  unit   range                                               default          meaning
    centre     m      any                                                 (0.0, 0.0, 0.0)  the point, at the start
    velocity   m/s    up to 3 numbers, a `Signal`, or a function of time  (0.0, 0.0, 0.0)  of the point
    spin       rad/s  up to 3 numbers, a `Signal`, or a function of time  (0.0, 0.0, 0.0)  angular velocity; in the plane (0, 0, z)"""

    functions = ("velocity", "spin",)

    centre: Sequence[float] = (0.0, 0.0, 0.0)
    velocity: Any = (0.0, 0.0, 0.0)
    spin: Any = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Anchor(Recipe):
    """Springs and dashpots that tie a body to its place and orientation at the start, {x, y, z}. Rotational ones act on
    the rotation vector (axis times angle), in space below a turn of pi.

    parameter             unit       range  default          meaning
    stiffness             N/m        >= 0   (0.0, 0.0, 0.0)  along each axis
    damping               N s/m      >= 0   (0.0, 0.0, 0.0)  along each axis
    rotational_stiffness  N m/rad    >= 0   (0.0, 0.0, 0.0)  about each axis; in the plane only about z
    rotational_damping    N m s/rad  >= 0   (0.0, 0.0, 0.0)  about each axis; in the plane only about z"""

    stiffness: Sequence[float] = (0.0, 0.0, 0.0)
    damping: Sequence[float] = (0.0, 0.0, 0.0)
    rotational_stiffness: Sequence[float] = (0.0, 0.0, 0.0)
    rotational_damping: Sequence[float] = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Free(Recipe):
    """A mass that moves and turns freely: in the plane with three degrees of freedom, in space with six, in axisymmetry
    only along the axis. Vectors are {x, y, z}; in the plane spins and moments have only z.

    parameter  unit   range                                               default          meaning
    mass       kg     > 0                                                 needed           of what the scene models (a slice, a metre, the full circle)
    inertia    kg m2  > 0                                                 None             about the centre of mass; in axisymmetry none is needed
    centre     m      any                                                 needed           of mass, at the start
    velocity   m/s    any                                                 (0.0, 0.0, 0.0)  of the centre at the start
    spin       rad/s  any                                                 (0.0, 0.0, 0.0)  angular velocity at the start; in the plane (0, 0, z)
    anchor     -      `Anchor`                                            Anchor           springs and dashpots to the world
    force      N      up to 3 numbers, a `Signal`, or a function of time  (0.0, 0.0, 0.0)  on the centre
    moment     N m    up to 3 numbers, a `Signal`, or a function of time  (0.0, 0.0, 0.0)
    symmetry   -      [-1, 2]                                             -1               axis normal to a plane of symmetry; -1: there is none"""

    functions = ("force", "moment",)

    mass: float = NOT_GIVEN
    inertia: Union[float, Sequence[float], None] = None
    centre: Sequence[float] = (NOT_GIVEN, NOT_GIVEN, 0.0)
    velocity: Sequence[float] = (0.0, 0.0, 0.0)
    spin: Sequence[float] = (0.0, 0.0, 0.0)
    anchor: Anchor = field(default_factory=Anchor)
    force: Any = (0.0, 0.0, 0.0)
    moment: Any = (0.0, 0.0, 0.0)
    symmetry: int = -1


@dataclass(frozen=True)
class RigidVelocity(Contact):
    """`NodalGap` without the gap: a touched node may not move into the body. It is a ratchet: gaps that vibration opens
    do not close, and matter that rests or rubs on the body is lifted."""


@dataclass(frozen=True)
class NodalGap(Contact):
    """The default: contact at nodes by the body's velocity, with the gap that matter has opened at each. Matter that
    has parted from the body there may come back by as much, whatever the masses: (v - v_body) . n >= -gap / dt with
    gap' = max(0, gap + dt (v - v_body) . n). The body's new velocity and all impulses are found together, so that a
    light body is as stable as a heavy one. Costs a number a touched node."""


@dataclass(frozen=True)
class CentreOfMass(Contact):
    """Contact through the centre-of-mass velocity of the soil's and the body's nodal mass (the paper's choice): softer,
    and nodes may move into the body. Needs a `MeshSurface`, which spreads the body's mass over its nodes."""


@dataclass(frozen=True)
class PointContact(Contact):
    """Contact at the material points: none may move into the body, whatever the masses, with Coulomb friction. It acts
    where the points are, whatever the grid, and so without the gap that contact at nodes leaves (see
    `DistanceSurface`); a point represents matter around it, of which half its size is inside the body when it touches.
    Needs a `DistanceSurface`, and points whose velocities are not mapped back (no MUSL). Impulses are found by sweeps
    of projected Gauss-Seidel, the body's velocity with them."""


@dataclass(frozen=True)
class MovingMesh(Recipe):
    """Nodes of a simplex mesh, or lines of a `RectilinearGrid`, move along one axis by a share of the leader's travel
    that depends on their initial place on the axis: 0 up to `fixed_below`, then linearly up to 1 at `moving_from`, 1 up
    to `moving_to`, then linearly down to 0 at `fixed_above`; without the last two everything above `moving_from` moves.

    parameter    unit  range           default  meaning
    fixed_below  m     any             needed   no motion below it
    moving_from  m     > fixed_below   needed   its top, and what is above, moves
    moving_to    m     >= moving_from  inf      up to here
    fixed_above  m     > moving_to     inf      no motion above it
    axis         -     [0, 2]          1
    least        -     (0, 1)          0.05     share of its height that a zone keeps; below it the run stops
    leader       -     >= 0            0        number of the rigid body that leads it"""

    fixed_below: float = NOT_GIVEN
    moving_from: float = NOT_GIVEN
    moving_to: float = float("inf")
    fixed_above: float = float("inf")
    axis: int = 1
    least: float = 0.05
    leader: int = 0


@dataclass(frozen=True)
class ConeCylinder(Recipe):
    """Cylinder about the y axis with a conical tip that points down, its lowest point at `tip` on the axis. In two
    dimensions the radius is |x|: a cone in axisymmetry, a wedge in plane strain. The tip may be cut off flat, and the
    edge between cone and cylinder rounded. A region too.

    parameter   unit  range        default  meaning
    radius      m     > 0          needed   of the cylinder
    apex        rad   (0, pi)      needed   full angle of the cone
    length      m     > 0          needed   from the lowest point to the upper end
    tip         m     any          0.0      height of the lowest point
    tip_radius  m     [0, radius)  0.0      of the flat tip of a truncated cone; 0: a point
    fillet      m     >= 0         0.0      radius of the edge between cone and cylinder; 0: sharp"""

    radius: float = NOT_GIVEN
    apex: float = NOT_GIVEN
    length: float = NOT_GIVEN
    tip: float = 0.0
    tip_radius: float = 0.0
    fillet: float = 0.0


@dataclass(frozen=True)
class Geostatic(Recipe):
    """Initial stress of level ground at rest under the scene's gravity: vertical stress from the weight above,
    horizontal stress k0 times that. The weight is that of the body's own matter up to the surface, and of the layers
    above it: other bodies with a `Geostatic`, by the bounds of their regions.

    parameter  unit  range        default  meaning
    surface    m     any          needed   height of the free surface
    k0         -     >= 0         needed   horizontal over vertical stress
    surcharge  Pa    >= 0         0.0      pressure on the surface
    may_move   -     True, False  False    ground that is not at rest is no mistake: a dam breaks"""

    surface: float = NOT_GIVEN
    k0: float = NOT_GIVEN
    surcharge: float = 0.0
    may_move: bool = False


@dataclass(frozen=True)
class Fill(Recipe):
    """The recipe that `fill` returns: a region, a law and how to fill; the scene makes a `Body` of it, once it knows
    the mesh.

    parameter     unit  range                                        default          meaning
    name          -     a name                                       needed
    region        -     a shape, `Cells`, or a test of positions     needed
    law           -     a law                                        needed
    per_cell      -     >= 1                                         None             points a cell; on a grid a square or cube; none: 4, in the cells of a grid in space 8
    velocity      m/s   up to 3 numbers, or a function of positions  (0.0, 0.0, 0.0)  at the start
    stress        Pa    `Geostatic`, or a function of positions      None             at the start; none: unstressed
    may_be_empty  -     True, False                                  False            a region without points is no mistake: some come later
    history       -     numbers or functions of positions, by name   {}               initial values of the law's history; those not named begin as the law says
    jitter        -     [0, 1]                                       0.0              share of its sub-cell within which each point is moved at random
    seed          -     >= 0                                         0                of the jitter
    even          -     True, False                                  False            equal spacing along all axes, in cells of unequal edges
    exact_volume  -     True, False                                  False            points represent the part of their sub-cells in the region"""

    name: str
    region: Region
    law: Law
    per_cell: Optional[int] = None
    velocity: Any = (0.0, 0.0, 0.0)
    stress: Any = None
    may_be_empty: bool = False
    history: Dict[str, Any] = field(default_factory=dict)
    jitter: float = 0.0
    seed: int = 0
    even: bool = False
    exact_volume: bool = False


@dataclass(frozen=True)
class Watch(Recipe):
    """Limits of a `Watch`. Past a limit the run stops; past a tenth of it the watch warns once. Infinity switches a
    quantity off: it is not computed. The watch that `run` adds itself has an `energy_gain` of 1, a `volume` of 5 and
    `lost` 1.

    parameter    unit  range  default  meaning
    energy_gain  -     > 0    0.1      energy gained from nothing over the energy put in
    transfer     -     > 0    1.0      energy lost in the transfer over the energy put in; needs the energy balance (`TrackEnergy`)
    residual     -     > 0    0.5      residual of the energy balance over the energy put in; needs `TrackEnergy`
    volume       -     > 0    0.5      change of a body's mean volume, |V/V0 - 1|, voids included
    speed        -     > 0    10.0     greatest speed of a point over the wave speed of its body
    strength     -     > 0    0.1      how far a stress lies outside the yield surface of its law
    lost         -     > 0    0.1      share of a body's points that left the mesh
    every        -     >= 1   100      steps from one check to the next"""

    energy_gain: float = 0.1
    transfer: float = 1.0
    residual: float = 0.5
    volume: float = 0.5
    speed: float = 10.0
    strength: float = 0.1
    lost: float = 0.1
    every: int = 100


@dataclass(frozen=True)
class Ramp(Recipe):
    """From one value to another, linearly in time, constant before and after.

    parameter    unit  range  default  meaning
    to           any   any    1.0      value at the end
    over         s     >= 0   needed   duration; 0: a step at `start`
    start_value  any   any    0.0      value at the start
    start        s     any    0.0      when it begins"""

    to: float = 1.0
    over: float = NOT_GIVEN
    start_value: float = 0.0
    start: float = 0.0


# The modules that show them, which pickles name.
LinearElastic.__module__ = "arenite.laws"
ForgetsOpening.__module__ = "arenite.laws"
RemembersOpening.__module__ = "arenite.laws"
ConstantFriction.__module__ = "arenite.laws"
LinearRateFriction.__module__ = "arenite.laws"
InertialFriction.__module__ = "arenite.laws"
LogarithmicFriction.__module__ = "arenite.laws"
SofteningFriction.__module__ = "arenite.laws"
RateSofteningFriction.__module__ = "arenite.laws"
ConstantStiffness.__module__ = "arenite.laws"
PressureStiffness.__module__ = "arenite.laws"
RateStiffness.__module__ = "arenite.laws"
MohrCoulomb.__module__ = "arenite.laws"
LinearSimplex.__module__ = "arenite.numerics"
LinearGrid.__module__ = "arenite.numerics"
QuadraticBSpline.__module__ = "arenite.numerics"
CubicBSpline.__module__ = "arenite.numerics"
Flip.__module__ = "arenite.numerics"
Apic.__module__ = "arenite.numerics"
Tpic.__module__ = "arenite.numerics"
Aflip.__module__ = "arenite.numerics"
Fmpm.__module__ = "arenite.numerics"
Xpic.__module__ = "arenite.numerics"
Musl.__module__ = "arenite.numerics"
Usl.__module__ = "arenite.numerics"
Usf.__module__ = "arenite.numerics"
NoAntiLocking.__module__ = "arenite.numerics"
NodalAveraging.__module__ = "arenite.numerics"
ElementAverage.__module__ = "arenite.numerics"
NodalAndElementAverage.__module__ = "arenite.numerics"
ViscousDamping.__module__ = "arenite.boundary"
LocalDamping.__module__ = "arenite.boundary"
Guided.__module__ = "arenite.rigid"
PrescribedPose.__module__ = "arenite.rigid"
Anchor.__module__ = "arenite.rigid"
RigidVelocity.__module__ = "arenite.rigid"
NodalGap.__module__ = "arenite.rigid"
CentreOfMass.__module__ = "arenite.rigid"
PointContact.__module__ = "arenite.rigid"
Watch.__module__ = "arenite.watch"
