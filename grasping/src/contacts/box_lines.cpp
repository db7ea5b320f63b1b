#include "contacts/box_lines.hpp"

#include <algorithm>
#include <cmath>

#include "body/body.hpp"

namespace quadrille {
namespace {

// A hand does not close on faces whose distance is less certain than this [m]: one finger would
// push the box before the other one touches it.
constexpr double kMaxDoubt = 0.015;
// Contacts lie at a share of half the side from the middle of a face, and near its border: half a
// pad and this distance away from it [m].
constexpr double kInner = 0.5, kOffBorder = 0.003;
// Places nearer to each other than this add nothing [m].
constexpr double kMinStep = 0.004;

/// Returns the places along a side of half length h, the middle first.
std::vector<double> places(double h, const Gripper& gripper) {
  const double border = h - 0.5 * gripper.pad.maxCoeff() - kOffBorder;
  std::vector<double> all = {0.0};
  for (const double place : {kInner * h, border}) {
    const bool new_one = place > kMinStep && std::all_of(all.begin(), all.end(), [&](double other) {
                           return std::abs(std::abs(other) - place) > kMinStep;
                         });
    if (new_one) all.insert(all.end(), {place, -place});
  }
  return all;
}

}  // namespace

BoxLines box_lines(const Box& box, const Gripper& gripper) {
  BoxLines found;
  const Eigen::Vector3d middle_B = box.outer_B.center();
  for (int axis = 0; axis < 3; ++axis) {
    const double width = box.outer_B.sizes()[axis];
    const double doubt = width - box.inner_B.sizes()[axis];
    if (doubt > kMaxDoubt) {
      ++found.unmeasured;
      continue;
    }
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double known = box.seen[axis] ? box.std[axis] : 0.0;
    ContactLine line;
    line.closing_C = box.X_CB.linear().col(axis);
    line.normals_C = {line.closing_C, -line.closing_C};
    line.width = line.opening = width;
    line.std = std::min(0.5 * std::max(known, doubt), Body::kMaxStd);
    for (const double along_u : places(0.5 * box.size[u], gripper)) {
      for (const double along_v : places(0.5 * box.size[v], gripper)) {
        Eigen::Vector3d centre_B;
        centre_B[axis] = middle_B[axis];
        centre_B[u] = along_u;
        centre_B[v] = along_v;
        line.centre_C = box.X_CB * centre_B;
        line.contacts_C = {line.centre_C + 0.5 * width * line.closing_C,
                           line.centre_C - 0.5 * width * line.closing_C};
        found.lines.push_back(line);
      }
    }
  }
  return found;
}

}  // namespace quadrille
