#include "fit/family_spec.hpp"

#include <array>

namespace quadrille {
namespace {

std::vector<std::pair<int, int>> all_entries() {
  std::vector<std::pair<int, int>> entries;
  for (int i = 0; i < 4; ++i) {
    for (int j = i; j < 4; ++j) entries.emplace_back(i, j);
  }
  return entries;
}

std::array<FamilySpec, kFamilyCount> make_specs() {
  constexpr int tx = 0, ty = 1, tz = 2, rx = 3, ry = 4;
  return {{
      {"plane", {}, {tz, rx, ry}, 3},
      {"sphere", {{3, 3}}, {tx, ty, tz}, 4},
      {"cylinder", {{3, 3}}, {tx, ty, rx, ry}, 5},
      {"cone", {{2, 2}}, {tx, ty, tz, rx, ry}, 6},
      {"paraboloid", {{2, 3}}, {tx, ty, tz, rx, ry}, 6},
      {"revolution", {{2, 2}, {2, 3}, {3, 3}}, {tx, ty, rx, ry}, 7},
      {"elliptic_cylinder", {{0, 0}, {0, 1}, {1, 1}}, {tx, ty, rx, ry}, 7},
      {"parabolic", {{0, 0}, {0, 1}, {1, 1}}, {tx, ty, tz, rx, ry}, 8},
      {"general", all_entries(), {}, 9},
  }};
}

}  // namespace

const FamilySpec& family_spec(Family family) {
  static const std::array<FamilySpec, kFamilyCount> specs = make_specs();
  return specs[static_cast<int>(family)];
}

}  // namespace quadrille
