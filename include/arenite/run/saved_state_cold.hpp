// Cold functions of saved_state.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <string>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/run/saved_state.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::detail {

ARENITE_COLD std::vector<StateTerm> state_terms(const std::array<std::string, 6>& types,
                                                const std::string& mesh, const std::vector<StateTerm>& bodies,
                                                const std::string& recipe) {
  std::vector<StateTerm> terms{
      {"version", std::string(library_version)},
      {"kinematics", types[0]},
      {"mesh", joined_text({types[1], ", ", mesh})},
      {"numerics", joined_text({types[2], ", ", types[3], ", ", types[4], ", ", types[5]})}};
  for (const auto& [name, law] : bodies) terms.emplace_back(joined_text({"body ", name}), law);
  if (!recipe.empty()) terms.emplace_back("recipe", recipe);
  return terms;
}

/// Throws the refusal of a state file of another run: its head, or its values, are not those of this one.
ARENITE_COLD void refuse_other_run(const StateSource& file, const std::vector<StateTerm>& wanted,
                                   const std::vector<StateSlot>& slots) {
  for (std::size_t k = 0; k < std::max(wanted.size(), file.terms().size()); ++k) {
    const StateTerm none_there{"nothing", "more"},
        &here = k < wanted.size() ? wanted[k] : none_there,
        &there = k < file.terms().size() ? file.terms()[k] : none_there;
    if (here != there)
      file.refuse(joined_text({"is of another run: ", there.first, ": ", there.second, "; this one has ",
                               here.first, ": ", here.second}));
  }
  for (const StateSlot& here : slots) {
    const StateSlot* there = file.find(here.name);
    if (there == nullptr) file.refuse(joined_text({"has no ", here.name, ", which this run has"}));
    if (there->type() != here.type())
      file.refuse(joined_text({here.name, " is ", there->type(), "; in this run it is ", here.type()}));
    if (here.resize == nullptr && there->count != here.count)
      file.refuse(
          joined_text({here.name, " has ", there->count, " numbers; in this run it has ", here.count}));
  }
  if (slots.size() != file.entries().size())
    file.refuse(joined_text({"holds ", file.entries().size(), " values; this run has ", slots.size()}));
}

ARENITE_COLD void write_values(StateSource& from, const std::vector<StateSlot>& slots) {
  for (const StateSlot& slot : slots) {
    const StateSlot& entry = *from.find(slot.name);
    from.read(entry, slot.resize ? slot.resize(slot.array, entry.count) : slot.data);
  }
}

ARENITE_COLD void restore_run(StateSource& file, const std::vector<StateTerm>& terms,
                              const std::function<std::vector<StateSlot>()>& slots,
                              const std::function<void()>& follow, const std::function<void()>& renew) {
  const std::vector<StateSlot> there = slots();
  refuse_other_run(file, terms, there);
  StateCopy before(there);
  try {
    write_values(file, there);
    follow();
  } catch (...) {
    write_values(before, slots());  // what follows from a state may have moved
    renew();
    throw;
  }
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::detail
