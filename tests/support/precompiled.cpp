// Nothing: this unit exists so that the headers of the tests are precompiled once.
#include "catch.hpp"
