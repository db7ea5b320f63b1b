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
// Bounds nearer to each other than this are the same, but for rounding [m].
constexpr double kSame = 1e-6;

/// A part of a side of a box, from low to high in frame B [m].
struct Part {
  double low = 0.0, high = 0.0;
};

/// The part of a side on which contacts may lie. Where the likely end of the box is a guess, short
/// of its outer bound, it ends where the side was last seen.
Part known_part(const Box& box, int axis) {
  const double half = 0.5 * box.size[axis];
  const double low = box.inner_B.min()[axis], high = box.inner_B.max()[axis];
  Part part{-half, half};
  if (low > -half + kSame && box.outer_B.min()[axis] < -half - kSame) part.low = low;
  if (high < half - kSame && box.outer_B.max()[axis] > half + kSame) part.high = high;
  return part;
}

/// Returns the places along a part of a side, its middle first.
std::vector<double> places(const Part& part, const Gripper& gripper) {
  const double middle = 0.5 * (part.low + part.high), h = 0.5 * (part.high - part.low);
  const double border = h - 0.5 * gripper.pad.maxCoeff() - kOffBorder;
  std::vector<double> all = {0.0};
  for (const double place : {kInner * h, border}) {
    const bool new_one = place > kMinStep && std::all_of(all.begin(), all.end(), [&](double other) {
                           return std::abs(std::abs(other) - place) > kMinStep;
                         });
    if (new_one) all.insert(all.end(), {place, -place});
  }
  for (double& place : all) place += middle;
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
    for (const double along_u : places(known_part(box, u), gripper)) {
      for (const double along_v : places(known_part(box, v), gripper)) {
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
