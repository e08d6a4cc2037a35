// Refusals: the sentences about parts that do not go together. Each stands here once, for the static_assert
// that refuses a composition and for a host that refuses it before it compiles. A macro, since C++20 wants a
// string literal in a static_assert.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#define ARENITE_SAYS_POINT_CONTACT_MUSL \
  "Rigid: PointContact needs Usl: it does not hold the velocities that MUSL maps back"
#define ARENITE_SAYS_MUSL_WITHOUT_GRADIENT                                                           \
  "Numerics: on linear simplices MUSL maps back velocities without a gradient; use Usl, or let the " \
  "transfer say returns_unchanged<Shape> if its points hand each node just what it gave them"
#define ARENITE_SAYS_TRANSFER_SHAPE                                                                    \
  "Numerics: APIC needs B-splines (its inertia tensor is singular at a node of a linear simplex: use " \
  "Tpic there); Tpic needs linear simplices (use Apic on B-splines)"
#define ARENITE_SAYS_AVERAGES_SHAPE \
  "Numerics: NodalAveraging and ElementAverage work on linear simplices; on B-splines use NoAntiLocking"
#define ARENITE_SAYS_SHAPE_MESH                                                                        \
  "Scene: the shape function does not fit the mesh: LinearSimplex goes with SimplexMesh; LinearGrid, " \
  "QuadraticBSpline and CubicBSpline with CartesianGrid"
#define ARENITE_SAYS_STIFFNESS_HISTORY \
  "Stiffness: reads a history that the friction policy must keep, such as RateSofteningFriction"
#define ARENITE_SAYS_MESH_SURFACE_ON_GRID \
  "Rigid: a MeshSurface needs a simplex mesh; on a grid use a DistanceSurface"
#define ARENITE_SAYS_RESTING_GRID \
  "MovingMesh: a simplex mesh or a RectilinearGrid moves, a CartesianGrid rests"
#define ARENITE_SAYS_CENTRE_OF_MASS                                                                 \
  "Rigid: CentreOfMass needs a MeshSurface and a Guided motion, which give the body's nodes their " \
  "masses"
#define ARENITE_SAYS_RESTING_SURFACE                                                         \
  "Rigid: the body rotates, and its surface does not: visit must take a Pose, as that of a " \
  "DistanceSurface does; the nodes of a MeshSurface stay where the mesh is"
#define ARENITE_SAYS_POINT_CONTACT_SURFACE \
  "Rigid: PointContact needs a DistanceSurface, which tells the distance of a point"
#define ARENITE_SAYS_RIGID_CONTACT_SURFACE \
  "RigidContact: each rigid body of the scene needs a DistanceSurface"
#define ARENITE_SAYS_RIGID_CONTACT_CENTRE "RigidContact: CentreOfMass cannot be joined with it"
#define ARENITE_SAYS_RIGID_CONTACT_POINTS "RigidContact: PointContact cannot be joined with it"
#define ARENITE_SAYS_DIMENSIONS "Scene: mesh and kinematics must have the same dimension"
