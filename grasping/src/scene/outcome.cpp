#include "scene/outcome.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "targets/resemblance.hpp"

namespace quadrille {
namespace {

/// Returns true if a check of what is in the hand's way, or one after it, refused a candidate.
bool was_obstructed(const RefusalCounts& refusals) {
  return refusals.lower_bound(Refusal::kSupport) != refusals.end();
}

}  // namespace

Outcome joined(std::vector<Outcome> parts) {
  if (parts.size() == 1) return std::move(parts.front());
  Outcome all;
  std::vector<Grasp> grasps;
  for (Outcome& part : parts) {
    std::move(part.grasps.begin(), part.grasps.end(), std::back_inserter(grasps));
    for (const auto& [why, count] : part.refusals) all.refusals[why] += count;
    all.unlikely += part.unlikely;
    all.cut |= part.cut;
  }
  std::stable_sort(grasps.begin(), grasps.end(),
                   [](const Grasp& a, const Grasp& b) { return a.score > b.score; });
  for (Grasp& grasp : grasps) {
    if (!resembles_one_of(all.grasps, grasp)) all.grasps.push_back(std::move(grasp));
  }
  return all;
}

RefusalCounts told_refusals(const Outcome& found) {
  RefusalCounts refusals = found.refusals;
  if (found.unlikely > 0 && found.grasps.empty() && !was_obstructed(refusals)) {
    refusals[Refusal::kScore] += found.unlikely;
  }
  if (found.cut) ++refusals[Refusal::kDeadline];
  return refusals;
}

}  // namespace quadrille
