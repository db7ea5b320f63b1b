#include "targets/target_order.hpp"

#include <algorithm>
#include <numeric>

#include "targets/target_surfaces.hpp"

namespace quadrille {

std::vector<int> as_given(std::size_t count) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  return order;
}

std::vector<int> costliest_first(const std::vector<const Target*>& targets,
                                 const SceneParts& parts) {
  std::vector<std::size_t> points;
  for (const Target* target : targets) {
    const Eigen::AlignedBox3f about = surroundings_of(*target, parts).cast<float>();
    points.push_back(parts.points.runs.count_near(about));
  }
  std::vector<int> order = as_given(targets.size());
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return points[a] > points[b]; });
  return order;
}

}  // namespace quadrille
