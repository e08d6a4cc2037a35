// The parameters of recipes, which the host may ask for.
#define ARENITE_COLD_LIBRARY
#define ARENITE_HOST_ELSEWHERE
#include <arenite/host/plugin.hpp>
#include <arenite/host/read_recipes.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace {

template <class Parameters>
shared_detail::Registration parameters(const char* of) {
  return shared_detail::Registration(Plugin::Recipe{of, &members_of<Parameters>});
}
/// Those of a family of policies.
template <class Family>
struct Policies {
  Policies() {
    Family::each([]<class P>(std::type_identity<P>) {
      if constexpr (requires { typename P::Parameters; })
        parameters<typename P::Parameters>(type_words<P>().c_str());
    });
  }
};
const Policies<Memories> memories;
const Policies<Frictions> frictions;
const Policies<Stiffnesses> stiffnesses;
const shared_detail::Registration recipes[]{
    parameters<LinearElasticParameters>("LinearElastic"),
    parameters<MohrCoulombParameters>("MohrCoulomb"),
    parameters<DruckerPragerParameters>("DruckerPrager"),
    parameters<Flip>("Flip"),
    parameters<Aflip>("Aflip"),
    parameters<Fmpm>("Fmpm"),
    parameters<Xpic>("Xpic"),
    parameters<ElementAverage>("ElementAverage"),
    parameters<NodalAndElementAverage>("NodalAndElementAverage"),
    parameters<FillOptions>("Fill"),
    parameters<Geostatic>("Geostatic"),
    parameters<Guided>("Guided"),
    parameters<Free>("Free"),
    parameters<Anchor>("Anchor"),
    parameters<PrescribedPose>("PrescribedPose"),
    parameters<ConeCylinder::Parameters>("ConeCylinder"),
    parameters<MovingMesh<>>("MovingMesh"),
    parameters<LocalDamping>("LocalDamping"),
    parameters<WatchLimits>("Watch"),
};

}  // namespace
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

ARENITE_PLUGIN
