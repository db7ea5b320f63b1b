#include "lab/scene/family.hpp"

namespace quadrille::scene {

const FamilyTraits& traits_of(Family family) {
  static constexpr FamilyTraits kTraits[] = {
      {"easy", 1, 3, 0, 0, 1.0, 1.3, 0.25, 0.46, 0.28, 0.04, 0.2, 0.0, 0.1, 1.0, false},
      {"medium", 3, 6, 0, 2, 0.9, 1.2, 0.21, 0.38, 0.32, 0.015, 0.6, 0.08, 0.4, 1.0, false},
      {"hard", 6, 10, 2, 4, 0.75, 1.1, 0.14, 0.3, 0.4, 0.005, 0.75, 0.18, 0.5, 2.0, true},
      {"tabletop", 4, 8, 0, 2, 0.4, 0.6, 0.25, 0.46, 0.22, 0.02, 0.6, 0.0, 0.4, 0.5, false},
      // Only the noise: the tray is filled and seen as BinOptions say.
      {"bin", 0, 0, 0, 0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.5, false},
  };
  return kTraits[static_cast<int>(family)];
}

}  // namespace quadrille::scene
