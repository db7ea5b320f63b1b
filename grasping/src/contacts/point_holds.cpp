#include "contacts/point_holds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <span>

#include "contacts/directions.hpp"
#include "contacts/hand_directions.hpp"
#include "contacts/pad_side.hpp"
#include "contacts/quality.hpp"

namespace quadrille {
namespace {

// The tips reach so deep below the highest point of the target between the fingers, in lengths of
// the fingers.
constexpr double kDepthsToFinger[] = {0.75, 0.55, 0.4, 0.28, 0.16};
// Fewer points between the fingers may be noise.
constexpr std::size_t kMinBetween = 8;
// Weights of what makes a hold promising beside contacts that face the pads: from above, deep,
// near the middle; and against it: wide.
constexpr double kAbove = 0.5, kDeep = 0.5, kAside = 0.5, kWide = 0.3;
// More depth, or more distance from the middle, than this makes no difference [m]. A hold is wide
// above this share of the opening.
constexpr double kFullDepth = 0.03, kWideShare = 0.85;

class PointHoldFinder {
 public:
  PointHoldFinder(const SurfacePoints& points, const std::vector<char>& own, const Gripper& gripper,
                  const ApproachSpace& space, double max_friction)
      : points_(points), own_(own), gripper_(gripper), space_(space), max_friction_(max_friction) {}

  std::vector<Hold> find() {
    std::vector<Eigen::Vector3d> normals;
    for (std::size_t i = 0; i < own_.size(); ++i) {
      if (own_[i] && !points_.n_C[i].isZero()) normals.push_back(points_.n_C[i]);
    }
    for (const Eigen::Matrix3d& R_CG : hand_directions(std::move(normals), space_)) {
      if (order_.empty() || R_CG.col(1) != R_CG_.col(1)) sort_along(R_CG.col(1));
      R_CG_ = R_CG;
      sweep();
    }
    std::stable_sort(ranked_.begin(), ranked_.end(),
                     [](const Ranked& a, const Ranked& b) { return a.rank > b.rank; });
    std::vector<Hold> holds;
    visit_in_passes(ranked_.begin(), ranked_.end(),
                    [&](const Ranked& ranked) { holds.push_back(ranked.hold); });
    return holds;
  }

 private:
  struct Ranked {
    Hold hold;
    double rank;
  };

  /// A point by its index, and how far it lies along the approach.
  struct InSlice {
    double z;
    std::size_t index;
  };

  /// Sorts the points along a closing direction, which many orientations of the hand share.
  void sort_along(const Eigen::Vector3d& closing_C) {
    std::vector<double> along;
    for (const Eigen::Vector3d& p : points_.p_C) along.push_back(closing_C.dot(p));
    order_.resize(along.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::size_t a, std::size_t b) { return along[a] < along[b]; });
  }

  /// Moves a hand of the present orientation across the points, in steps of half a finger's width.
  void sweep() {
    const Eigen::Vector3d x_C = R_CG_.col(0);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = 0; i < own_.size(); ++i) {
      if (!own_[i]) continue;
      const double x = x_C.dot(points_.p_C[i]);
      low = std::min(low, x);
      high = std::max(high, x);
    }
    if (!(low <= high)) return;
    const double step = 0.5 * gripper_.finger.x();
    const int steps = static_cast<int>((high - low) / step) + 1;
    const double first = 0.5 * (low + high) - 0.5 * step * (steps - 1);
    // The fingers cover two steps at each place, so each point is between them at two places.
    if (slices_.size() < static_cast<std::size_t>(steps)) slices_.resize(steps);
    for (std::vector<InSlice>& slice : slices_) slice.clear();
    const Eigen::Vector3d z_C = R_CG_.col(2);
    for (const std::size_t i : order_) {
      const double place = std::floor((x_C.dot(points_.p_C[i]) - first) / step);
      if (!(place >= -1.0 && place < steps)) continue;
      const InSlice point{z_C.dot(points_.p_C[i]), i};
      const int before = static_cast<int>(place);
      if (before >= 0) slices_[static_cast<std::size_t>(before)].push_back(point);
      if (before + 1 < steps) slices_[static_cast<std::size_t>(before) + 1].push_back(point);
    }
    for (int n = 0; n < steps; ++n) lower(first + n * step, slices_[static_cast<std::size_t>(n)]);
  }

  /// Lowers the fingers on the points of a slice, which are sorted along the closing direction.
  void lower(double x, const std::vector<InSlice>& slice) {
    if (slice.size() < kMinBetween) return;
    double top = std::numeric_limits<double>::infinity();
    for (const InSlice& point : slice) {
      if (own_[point.index]) top = std::min(top, point.z);
    }
    const double finger = gripper_.finger.z();
    const auto [least, most] =
        std::minmax_element(std::begin(kDepthsToFinger), std::end(kDepthsToFinger));
    const Eigen::Matrix3d R_GC = R_CG_.transpose();
    reached_.clear();
    for (const auto& [z, i] : slice) {
      if (!(z < top + *most * finger && z > top + (*least - 1.0) * finger)) continue;
      reached_.push_back({R_GC * points_.p_C[i], R_GC * points_.n_C[i], own_[i] != 0});
    }
    for (const double share : kDepthsToFinger) {
      const double tip = top + share * finger;
      between_.clear();
      std::copy_if(reached_.begin(), reached_.end(), std::back_inserter(between_),
                   [&](const BetweenPads& point) {
                     return point.p_G.z() < tip && point.p_G.z() > tip - finger;
                   });
      hold_runs(x, tip, between_);
    }
  }

  /// Holds each run of points in which there is no gap for a finger, and neighbouring runs
  /// together.
  void hold_runs(double x, double tip, std::span<const BetweenPads> between) {
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < between.size(); ++i) {
      if (i == 0 || between[i].p_G.y() - between[i - 1].p_G.y() > gripper_.finger.y()) {
        starts.push_back(i);
      }
    }
    starts.push_back(between.size());
    for (std::size_t a = 0; a + 1 < starts.size(); ++a) {
      for (std::size_t b = a + 1; b < starts.size(); ++b) {
        hold(x, tip, between.subspan(starts[a], starts[b] - starts[a]));
      }
    }
  }

  void hold(double x, double tip, std::span<const BetweenPads> run) {
    if (run.size() < kMinBetween || !(run.front().own || run.back().own)) return;
    const double low = run.front().p_G.y(), high = run.back().p_G.y(), width = high - low;
    if (width > gripper_.max_opening || width < gripper_.min_opening) return;
    const std::optional<PadSide> left = pad_side(run, -1.0, x, tip, gripper_);
    const std::optional<PadSide> right = pad_side(run, 1.0, x, tip, gripper_);
    if (!left || !right || !(left->seen || right->seen)) return;
    Hold found;
    ContactLine& line = found.line;
    line.closing_C = R_CG_.col(1);
    line.centre_C = R_CG_ * Eigen::Vector3d(x, 0.5 * (low + high), tip - gripper_.finger_front);
    line.contacts_C = {R_CG_ * right->p_G, R_CG_ * left->p_G};
    line.normals_C = {R_CG_ * right->n_G, R_CG_ * left->n_G};
    line.width = line.opening = width;
    found.approach_C = R_CG_.col(2);
    found.friction = friction_needed(line);
    if (found.friction > max_friction_) return;
    found.evidence = {0.5 * (left->seen + right->seen), 0.5 * (left->facing + right->facing),
                      0.5 * (left->inner + right->inner), std::min(left->height, right->height)};
    double top = tip;
    for (const BetweenPads& point : run) top = std::min(top, point.p_G.z());
    ranked_.push_back({found, rank(found, tip - top)});
  }

  double rank(const Hold& hold, double depth) const {
    const double aside = std::abs(R_CG_.col(0).dot(hold.line.centre_C - space_.centre_C));
    const bool wide = hold.line.width > kWideShare * gripper_.max_opening;
    return 2.0 * hold.evidence.facing - kAbove * hold.approach_C.dot(space_.up_C) +
           kDeep * std::min(1.0, depth / kFullDepth) - kAside * std::min(1.0, aside / kFullDepth) -
           (wide ? kWide : 0.0);
  }

  const SurfacePoints& points_;
  const std::vector<char>& own_;
  const Gripper& gripper_;
  const ApproachSpace& space_;
  const double max_friction_;
  Eigen::Matrix3d R_CG_ = Eigen::Matrix3d::Identity();
  /// Indices of the points, sorted along the closing direction.
  std::vector<std::size_t> order_;
  // Kept to reuse their memory:
  /// The points between the fingers' sides at each place.
  std::vector<std::vector<InSlice>> slices_;
  /// Those points of a slice that the fingers reach at some depth, and those that they reach at the
  /// depth that is being tried.
  std::vector<BetweenPads> reached_, between_;
  std::vector<Ranked> ranked_;
};

}  // namespace

std::vector<Hold> point_holds(const SurfacePoints& points, const std::vector<char>& own,
                              const Gripper& gripper, const ApproachSpace& space,
                              double max_friction) {
  return PointHoldFinder(points, own, gripper, space, max_friction).find();
}

}  // namespace quadrille
