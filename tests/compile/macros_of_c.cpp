// must compile
// Headers of C, X11 and Windows define short lower-case words, and I; `using namespace std` takes names, too.
#include <complex.h>
#include <math.h>
#include <netdb.h>
#include <sys/param.h>
#include <sys/sysmacros.h>
#include <termios.h>
#if __has_include(<X11/Xlib.h>)
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#undef Success  // Eigen refuses it, with its own message
#endif
#include <complex>
#include <filesystem>
#include <functional>

// As X11/X.h and X11/Xlib.h have them, where they are not installed.
#define None 0L
#define Always 2
#define Bool int
#define Status int
// As windows.h has them.
#define near
#define far
#define small char
#define interface struct
#define pascal
#define IN
#define OUT
#define CONST const
#define VOID void
#define DELETE 0x00010000
#define ERROR 0
#define OPAQUE 2
#define TRANSPARENT 1
#define ABSOLUTE 1
#define RELATIVE 2
#define TRUE 1
#define FALSE 0
// As programs have them.
#define PI 3.14159265358979
#define EPS 1e-12
#define DOMAIN 1
#define verify(x) ((void)(x))
#undef M_PI

using namespace std;

#include <arenite/arenite.hpp>
#include <arenite/io/csv.hpp>
#include <arenite/io/gmsh.hpp>
#include <arenite/io/stl.hpp>
#include <arenite/observe/vtu.hpp>

int main() {
  const arenite::LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};
  arenite::Scene scene{arenite::PlaneStrain{},
                       arenite::CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}},
                       arenite::Numerics<arenite::QuadraticBSpline>{},
                       arenite::bodies(arenite::fill(arenite::Box{{0., 0.}, {1., 1.}}, steel))};
  return static_cast<int>(scene.steps);
}
