// In place of ../drop_other.cpp: `arenite-ffp-default` has no other drops.
#include "../drop.hpp"

const bool arenite::ffp::has_other_drops = false;

void arenite::ffp::drop_other(const DropOptions&) { throw NotBuilt(); }
