#include "fit/family_spec.hpp"

#include <array>

namespace quadrille {
namespace {

/// Symmetric matrix with ones at (i, j) and (j, i).
Eigen::Matrix4d unit(int i, int j) {
  Eigen::Matrix4d E = Eigen::Matrix4d::Zero();
  E(i, j) = E(j, i) = 1.0;
  return E;
}

std::vector<Eigen::Matrix4d> all_units() {
  std::vector<Eigen::Matrix4d> shapes;
  for (int i = 0; i < 4; ++i) {
    for (int j = i; j < 4; ++j) shapes.push_back(unit(i, j));
  }
  return shapes;
}

std::array<FamilySpec, kFamilyCount> make_specs() {
  constexpr int tx = 0, ty = 1, tz = 2, rx = 3, ry = 4;
  return {{
      {"plane", {}, {tz, rx, ry}, 3},
      {"sphere", {unit(3, 3)}, {tx, ty, tz}, 4},
      {"cylinder", {unit(3, 3)}, {tx, ty, rx, ry}, 5},
      {"cone", {unit(2, 2)}, {tx, ty, tz, rx, ry}, 6},
      {"paraboloid", {unit(2, 3)}, {tx, ty, tz, rx, ry}, 6},
      {"revolution", {unit(2, 2), unit(2, 3), unit(3, 3)}, {tx, ty, rx, ry}, 7},
      {"elliptic_cylinder", {unit(0, 0), unit(0, 1), unit(1, 1)}, {tx, ty, rx, ry}, 7},
      {"parabolic", {unit(0, 0), unit(0, 1), unit(1, 1)}, {tx, ty, tz, rx, ry}, 8},
      {"general", all_units(), {}, 9},
  }};
}

}  // namespace

const FamilySpec& family_spec(Family family) {
  static const std::array<FamilySpec, kFamilyCount> specs = make_specs();
  return specs[static_cast<int>(family)];
}

}  // namespace quadrille
