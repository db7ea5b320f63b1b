#include "scene/kept_grasps.hpp"

#include <algorithm>
#include <utility>

#include "targets/spread.hpp"

namespace quadrille {

void KeptGrasps::add(const std::vector<Grasp>& grasps, double reach) {
  if (per_target_ > 0) {
    std::size_t rank = 0;
    for (Grasp& pick : spread(grasps, per_target_, reach)) {
      kept_.push_back({std::move(pick), rank++});
    }
    return;
  }
  const auto best =
      std::max_element(grasps.begin(), grasps.end(),
                       [](const Grasp& a, const Grasp& b) { return a.score < b.score; });
  for (auto grasp = grasps.begin(); grasp != grasps.end(); ++grasp) {
    kept_.push_back({*grasp, grasp == best ? 0u : 1u});
  }
}

std::vector<Grasp> KeptGrasps::best(int max_grasps, std::vector<std::string>* warnings) && {
  const auto better = [](const Kept& a, const Kept& b) { return a.grasp.score > b.grasp.score; };
  const auto earlier = [](const Kept& a, const Kept& b) { return a.rank < b.rank; };
  std::stable_sort(kept_.begin(), kept_.end(), better);
  const std::size_t found = kept_.size(), most = static_cast<std::size_t>(max_grasps);
  if (found > most) {
    std::stable_sort(kept_.begin(), kept_.end(), earlier);
    kept_.resize(most);
    std::stable_sort(kept_.begin(), kept_.end(), better);
    if (per_target_ > 0) {
      warnings->push_back("of " + std::to_string(found) + " grasps only " + std::to_string(most) +
                          " are given; raise planner.max_grasps (--best)");
    }
  }
  std::vector<Grasp> grasps;
  for (Kept& kept : kept_) grasps.push_back(std::move(kept.grasp));
  return grasps;
}

}  // namespace quadrille
