// Catch2, version 2 or 3, whichever is found. Tests include "catch.hpp" and use what both have.
#pragma once

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#else
#include <catch2/catch.hpp>
#endif
