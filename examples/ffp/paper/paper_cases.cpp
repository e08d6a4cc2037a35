#include "paper_cases.hpp"

#include <filesystem>

namespace arenite::ffp {

std::string name_of_case(Kinematics kinematics, DeviceKind device, int delta, LawKind law) {
  std::string name = kinematics == Kinematics::slice ? "slice-" : "";
  name += word_of(device_words, device) + "-" + std::to_string(delta);
  return law == LawKind::mohr_coulomb ? name : name + "-" + word_of(law_words, law);
}

std::vector<PaperCase> paper_cases(const PaperOptions& o) {
  std::vector<PaperCase> cases;
  const auto add = [&](Kinematics kinematics, DeviceKind device, int delta, const LawOptions& law) {
    DropOptions d;
    d.kinematics = kinematics;
    d.device = device;
    d.delta = delta;
    d.law = law;
    d.cell = o.cell;
    d.threads = o.threads;
    d.fields_every = device == DeviceKind::rigid && delta == 20 ? 0.02 : 0;  // those of figure 4
    d.error_bar = o.error_bar && kinematics == Kinematics::axisymmetric && device == DeviceKind::rigid &&
                  (delta == 20 || delta == 40);
    d.resume = !o.anew;
    d.quiet = true;
    const std::string name = name_of_case(kinematics, device, delta, law.kind);
    d.out = (std::filesystem::path{o.out} / name).string();
    cases.push_back({name, d});
  };
  const LawOptions plain;
  for (const int delta : paper_deltas) add(Kinematics::axisymmetric, DeviceKind::rigid, delta, plain);
  for (const int delta : {20, 40}) add(Kinematics::axisymmetric, DeviceKind::elastic, delta, plain);
  if (o.law.kind != LawKind::mohr_coulomb)
    for (const int delta : paper_deltas) add(Kinematics::axisymmetric, DeviceKind::rigid, delta, o.law);
  if (!o.quick)
    for (const DeviceKind device : {DeviceKind::rigid, DeviceKind::elastic})
      for (const int delta : {20, 40}) add(Kinematics::slice, device, delta, plain);
  return cases;
}

}  // namespace arenite::ffp
