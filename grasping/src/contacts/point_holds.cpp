#include "contacts/point_holds.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "contacts/directions.hpp"
#include "contacts/finger_slices.hpp"
#include "contacts/hand_directions.hpp"

namespace quadrille {
namespace {

// Weights of what makes a hold promising beside contacts that face the pads: much between the
// pads, flat, from above, deep, near the middle; and against it: wide.
constexpr double kFilled = 1.0, kFlat = 0.5;
constexpr double kAbove = 0.5, kDeep = 0.5, kAside = 0.5, kWide = 0.3;
// More depth, or more distance from the middle, than this makes no difference [m]. A hold is wide
// above this share of the opening.
constexpr double kFullDepth = 0.03, kWideShare = 0.85;

class PointHoldFinder {
 public:
  PointHoldFinder(const SurfacePoints& points, const std::vector<char>& own, const Gripper& gripper,
                  const ApproachSpace& space, const ThinWalls& walls, double max_friction)
      : points_(points),
        own_(own),
        gripper_(gripper),
        space_(space),
        on_slice_(points, own, gripper, space, walls, max_friction),
        slices_(on_slice_.offsets_C(), own, gripper, SliceHolds::heights(gripper)) {}

  std::vector<Hold> find(const GoesOn& goes_on) {
    const std::vector<Eigen::Matrix3d> directions = hand_directions(own_normals(), space_);
    for (std::size_t round = 0; round < kHoldRounds; ++round) {
      for (std::size_t n = round; n < directions.size(); n += kHoldRounds) {
        add_holds(directions[n], n);
      }
      const bool is_last = round + 1 == kHoldRounds;
      if (!is_last && goes_on && !goes_on(static_cast<int>(round) + 1, holds_)) break;
    }
    return ranked();
  }

 private:
  struct Place {
    double rank;
    std::size_t direction, hold;
  };

  std::vector<Eigen::Vector3d> own_normals() const {
    std::vector<Eigen::Vector3d> normals;
    for (std::size_t i = 0; i < own_.size(); ++i) {
      if (own_[i] && !points_.n_C[i].isZero()) normals.push_back(points_.n_C[i]);
    }
    return normals;
  }

  void add_holds(const Eigen::Matrix3d& R_CG, std::size_t direction) {
    const std::vector<FingerSlice>& cut = slices_.cut(R_CG);
    on_slice_.set_orientation(R_CG, slices_.sorted());
    found_.clear();
    for (const FingerSlice& slice : cut) on_slice_.find(slice, found_);
    for (const SliceHold& found : found_) {
      places_.push_back({rank(found, R_CG), direction, holds_.size()});
      holds_.push_back(found.hold);
    }
  }

  double rank(const SliceHold& found, const Eigen::Matrix3d& R_CG) const {
    const Hold& hold = found.hold;
    const double aside = std::abs(R_CG.col(0).dot(hold.line.centre_C - space_.centre_C));
    const bool wide = hold.line.width > kWideShare * gripper_.max_opening;
    return 2.0 * hold.evidence.facing + kFilled * hold.evidence.filled +
           kFlat * hold.evidence.flat - kAbove * hold.approach_C.dot(space_.up_C) +
           kDeep * std::min(1.0, found.depth / kFullDepth) -
           kAside * std::min(1.0, aside / kFullDepth) - (wide ? kWide : 0.0);
  }

  /// Returns the holds, the most promising first, in passes of unlike ones.
  std::vector<Hold> ranked() {
    std::stable_sort(places_.begin(), places_.end(), [](const Place& a, const Place& b) {
      return a.rank > b.rank || (a.rank == b.rank && a.direction < b.direction);
    });
    std::vector<Hold> holds;
    visit_in_passes(places_.begin(), places_.end(),
                    [&](const Place& place) { holds.push_back(holds_[place.hold]); });
    return holds;
  }

  const SurfacePoints& points_;
  const std::vector<char>& own_;
  const Gripper& gripper_;
  const ApproachSpace& space_;
  SliceHolds on_slice_;
  FingerSlices slices_;
  /// The holds so far, and where they come in the order of the result.
  std::vector<Hold> holds_;
  std::vector<Place> places_;
  /// The holds for one orientation.
  std::vector<SliceHold> found_;
};

}  // namespace

std::vector<Hold> point_holds(const SurfacePoints& points, const std::vector<char>& own,
                              const Gripper& gripper, const ApproachSpace& space,
                              const ThinWalls& walls, double max_friction, const GoesOn& goes_on) {
  return PointHoldFinder(points, own, gripper, space, walls, max_friction).find(goes_on);
}

}  // namespace quadrille
