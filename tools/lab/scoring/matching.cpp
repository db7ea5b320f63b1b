#include "lab/scoring/matching.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace quadrille::scoring {
namespace {

using Ranked = std::vector<std::pair<int, double>>;

Ranked best_first(const std::map<int, double>& qualities) {
  Ranked ranked(qualities.begin(), qualities.end());
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  return ranked;
}

/// Finds a surface for the finding, moving other findings to other surfaces if needed.
bool augment(int finding, const Candidates& candidates, std::set<int>* tried,
             std::map<int, int>* finding_of) {
  for (const auto& [surface, quality] : best_first(candidates.at(finding))) {
    if (!tried->insert(surface).second) continue;
    const auto owner = finding_of->find(surface);
    if (owner != finding_of->end() && !augment(owner->second, candidates, tried, finding_of)) {
      continue;
    }
    (*finding_of)[surface] = finding;
    return true;
  }
  return false;
}

}  // namespace

std::map<int, int> match_most(const Candidates& candidates) {
  std::map<int, double> best;
  for (const auto& [finding, qualities] : candidates) {
    for (const auto& [surface, quality] : qualities) {
      best[finding] = std::max(best[finding], quality);
    }
  }
  std::map<int, int> finding_of;
  for (const auto& [finding, quality] : best_first(best)) {
    std::set<int> tried;
    augment(finding, candidates, &tried, &finding_of);
  }
  return finding_of;
}

}  // namespace quadrille::scoring
