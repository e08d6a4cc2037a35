// The main function of every test: Catch2's own. Version 2 compiles its implementation here.
#define CATCH_CONFIG_RUNNER
#include "catch.hpp"

int main(int argc, char* argv[]) { return Catch::Session().run(argc, argv); }
