#include "contacts/point_holds.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include "contacts/directions.hpp"
#include "contacts/hand_directions.hpp"
#include "contacts/pad_side.hpp"
#include "contacts/quality.hpp"

namespace quadrille {
namespace {

// The tips reach so deep below the highest point of the target between the fingers, in lengths of
// the fingers.
constexpr float kDepthsToFinger[] = {0.75f, 0.55f, 0.4f, 0.28f, 0.16f};
// Fewer points between the fingers may be noise.
constexpr std::size_t kMinBetween = 8;
// Weights of what makes a hold promising beside contacts that face the pads: from above, deep,
// near the middle; and against it: wide.
constexpr double kAbove = 0.5, kDeep = 0.5, kAside = 0.5, kWide = 0.3;
// More depth, or more distance from the middle, than this makes no difference [m]. A hold is wide
// above this share of the opening.
constexpr double kFullDepth = 0.03, kWideShare = 0.85;
// Behind a thin wall space must be free at the depth of the tips, as far from the wall as a finger
// is thick, at these places across the finger, in widths of it.
constexpr double kAcrossFinger[] = {-0.4, 0.0, 0.4};
// A thin wall goes on straight for so far below the tips: there most points next to the wall lie no
// farther than this beside what is held [m]. At the edges of solids sensors smear points into the
// air, but below these the surface bends away.
constexpr double kGoesOn = 0.012, kStraight = 0.002, kShareOfWall = 0.8;
// A key to sort by holds a length in units of kUnit [m] and the index of a point below kIndices.
// Points farther from the target than kFarthest [m] are of no interest.
constexpr double kUnit = 1e-8, kFarthest = 100.0;
constexpr std::int64_t kIndices = std::int64_t{1} << 26;

class PointHoldFinder {
 public:
  PointHoldFinder(const SurfacePoints& points, const std::vector<char>& own, const Gripper& gripper,
                  const ApproachSpace& space, const ThinWalls& walls, double max_friction)
      : points_(points),
        own_(own),
        gripper_(gripper),
        space_(space),
        walls_(walls),
        max_friction_(max_friction) {
    for (const Eigen::Vector3d& p_C : points.p_C) offsets_C_.push_back(p_C - space.centre_C);
  }

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

  /// A point by its index, and how far it lies along the closing direction and the approach, from
  /// the target's centre on [m].
  struct InSlice {
    float y, z;
    std::uint32_t index;
  };

  /// Points without a gap between them: the first and the last one, and how many they are.
  struct Run {
    std::size_t first, last, count;
  };

  /// Returns how far the target's own points reach along a direction; low > high if there are none.
  std::pair<double, double> range_of_own(const Eigen::Vector3d& d_C) const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = 0; i < own_.size(); ++i) {
      if (!own_[i]) continue;
      const double x = d_C.dot(offsets_C_[i]);
      low = std::min(low, x);
      high = std::max(high, x);
    }
    return {low, high};
  }

  /// Sorts the points along a closing direction, which many orientations of the hand share. One
  /// whole number as a key is sorted three times faster than a pair of a length and an index.
  void sort_along(const Eigen::Vector3d& closing_C) {
    order_.clear();
    // No hold spans more than the opening; one gap beyond it tells where a run is too wide.
    const double reach = gripper_.max_opening + gripper_.finger.y();
    const auto [low, high] = range_of_own(closing_C);
    const auto count = std::min<std::int64_t>(kIndices, std::ssize(offsets_C_));
    for (std::int64_t i = 0; i < count; ++i) {
      const double y = closing_C.dot(offsets_C_[static_cast<std::size_t>(i)]);
      if (!(y > low - reach && y < high + reach && std::abs(y) < kFarthest)) continue;
      order_.push_back(std::llround(y / kUnit) * kIndices + i);
    }
    std::sort(order_.begin(), order_.end());
  }

  /// Moves a hand of the present orientation across the points, in steps of half a finger's width.
  void sweep() {
    const Eigen::Vector3d x_C = R_CG_.col(0);
    const auto [low, high] = range_of_own(x_C);
    if (!(low <= high)) return;
    const double step = 0.5 * gripper_.finger.x();
    const int steps = static_cast<int>((high - low) / step) + 1;
    const double first = 0.5 * (low + high) - 0.5 * step * (steps - 1);
    // The fingers cover two steps at each place, so each point is between them at two places.
    if (slices_.size() < static_cast<std::size_t>(steps)) slices_.resize(steps);
    for (std::vector<InSlice>& slice : slices_) slice.clear();
    const Eigen::Vector3d z_C = R_CG_.col(2);
    for (const std::int64_t key : order_) {
      const auto i = static_cast<std::uint32_t>(key & (kIndices - 1));
      const Eigen::Vector3d& p_C = offsets_C_[i];
      const double place = (x_C.dot(p_C) - first) / step;
      if (!(place >= -1.0 && place < steps)) continue;
      const InSlice point{static_cast<float>(R_CG_.col(1).dot(p_C)),
                          static_cast<float>(z_C.dot(p_C)), i};
      const int before = static_cast<int>(place + 1.0) - 1;
      if (before >= 0) slices_[static_cast<std::size_t>(before)].push_back(point);
      if (before + 1 < steps) slices_[static_cast<std::size_t>(before) + 1].push_back(point);
    }
    for (int n = 0; n < steps; ++n) lower(first + n * step, slices_[static_cast<std::size_t>(n)]);
  }

  /// Lowers the fingers on the points of a slice, which are sorted along the closing direction.
  void lower(double x, const std::vector<InSlice>& slice) {
    if (slice.size() < kMinBetween) return;
    float top = std::numeric_limits<float>::infinity();
    for (const InSlice& point : slice) {
      if (own_[point.index]) top = std::min(top, point.z);
    }
    const auto finger = static_cast<float>(gripper_.finger.z());
    const auto [least, most] =
        std::minmax_element(std::begin(kDepthsToFinger), std::end(kDepthsToFinger));
    const float lowest = top + *most * finger + static_cast<float>(kGoesOn),
                highest = top + (*least - 1.0f) * finger;
    reached_.clear();
    for (const InSlice& point : slice) {
      if (point.z < lowest && point.z > highest) reached_.push_back(point);
    }
    for (const float share : kDepthsToFinger) {
      tip_ = top + share * finger;
      root_ = tip_ - finger;
      hold_runs(x);
    }
  }

  bool reached_by_fingers(const InSlice& point) const { return point.z < tip_ && point.z > root_; }

  /// Holds each run of points in which there is no gap for a finger, and neighbouring runs
  /// together.
  void hold_runs(double x) {
    const auto gap = static_cast<float>(gripper_.finger.y());
    runs_.clear();
    for (std::size_t k = 0; k < reached_.size(); ++k) {
      if (!reached_by_fingers(reached_[k])) continue;
      if (runs_.empty() || reached_[k].y - reached_[runs_.back().last].y > gap) {
        runs_.push_back({k, k, 0});
      }
      runs_.back().last = k;
      ++runs_.back().count;
    }
    for (std::size_t a = 0; a < runs_.size(); ++a) {
      Run run{runs_[a].first, 0, 0};
      for (std::size_t b = a; b < runs_.size(); ++b) {
        run.last = runs_[b].last;
        run.count += runs_[b].count;
        if (may_hold(run)) hold(x, tip_, in_hand(run));
      }
    }
  }

  bool may_hold(const Run& run) const {
    const InSlice &first = reached_[run.first], &last = reached_[run.last];
    return run.count >= kMinBetween && (own_[first.index] || own_[last.index]) &&
           last.y - first.y <= gripper_.max_opening;
  }

  /// Returns the points of a run in the frame of the hand.
  std::span<const BetweenPads> in_hand(const Run& run) {
    const Eigen::Matrix3d R_GC = R_CG_.transpose();
    between_.clear();
    for (std::size_t k = run.first; k <= run.last; ++k) {
      if (!reached_by_fingers(reached_[k])) continue;
      const std::size_t i = reached_[k].index;
      between_.push_back({R_GC * offsets_C_[i], R_GC * points_.n_C[i], own_[i] != 0});
    }
    return between_;
  }

  void hold(double x, double tip, std::span<const BetweenPads> run) {
    PadSide left = pad_side(run, -1.0, x, tip, gripper_);
    PadSide right = pad_side(run, 1.0, x, tip, gripper_);
    if (!left.seen && !right.seen) return;
    double top = tip;
    for (const BetweenPads& point : run) top = std::min(top, point.p_G.z());
    const bool behind = left.behind || right.behind;
    double width = right.p_G.y() - left.p_G.y(), opening = width;
    if (behind) {
      if (!is_thin_wall(x, tip, left, right)) return;
      const double more = std::max(0.0, walls_.min - width);
      PadSide& hidden = left.behind ? left : right;
      hidden.p_G.y() += left.behind ? -more : more;
      // Nothing of the hidden side was measured.
      hidden.inner = false;
      width += more, opening = walls_.max;
    }
    Hold found;
    ContactLine& line = found.line;
    line.closing_C = R_CG_.col(1);
    line.centre_C =
        in_cloud({x, 0.5 * (left.p_G.y() + right.p_G.y()), tip - gripper_.finger_front});
    line.contacts_C = {in_cloud(right.p_G), in_cloud(left.p_G)};
    line.normals_C = {R_CG_ * right.n_G, R_CG_ * left.n_G};
    line.width = width, line.opening = opening;
    found.approach_C = R_CG_.col(2);
    found.friction = friction_needed(line);
    if (found.friction > max_friction_) return;
    found.guessed = behind;
    found.evidence = {0.5 * (left.seen + right.seen), 0.5 * (left.facing + right.facing),
                      0.5 * (left.inner + right.inner), std::min(left.height, right.height)};
    ranked_.push_back({found, rank(found, tip - top)});
  }

  /// Returns true if the points between two sides, of which one is hidden behind the other, are the
  /// rim of a thin wall: the sensor saw past the rim to the place of the finger behind the wall.
  bool is_thin_wall(double x, double tip, const PadSide& left, const PadSide& right) const {
    const double low = left.p_G.y(), high = right.p_G.y();
    if (high - low >= walls_.max || !goes_on(tip, low, high)) return false;
    const double beside = left.behind ? low - gripper_.finger.y() : high + gripper_.finger.y();
    return std::all_of(std::begin(kAcrossFinger), std::end(kAcrossFinger), [&](double share) {
      return walls_.is_free(in_cloud({x + share * gripper_.finger.x(), beside, tip}));
    });
  }

  /// Returns the point in C that lies at an offset from the target's centre along the axes of G.
  Eigen::Vector3d in_cloud(const Eigen::Vector3d& offset_G) const {
    return space_.centre_C + R_CG_ * offset_G;
  }

  /// Returns true if the points of a wall go on straight below the tips.
  bool goes_on(double tip, double low, double high) const {
    std::size_t all = 0, straight = 0;
    for (const InSlice& point : reached_) {
      const double beside = std::max(low - point.y, point.y - high);
      if (point.z < tip || point.z > tip + kGoesOn || beside > gripper_.finger.y()) continue;
      ++all;
      straight += beside < kStraight;
    }
    return straight >= kMinBetween && straight >= kShareOfWall * all;
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
  const ThinWalls& walls_;
  const double max_friction_;
  /// The points, from the target's centre on.
  std::vector<Eigen::Vector3d> offsets_C_;
  Eigen::Matrix3d R_CG_ = Eigen::Matrix3d::Identity();
  /// How far the points lie along the closing direction, in units, times kIndices, plus the index
  /// of the point; sorted.
  std::vector<std::int64_t> order_;
  /// How far the tips and the roots of the fingers reach along the approach, at the depth that is
  /// being tried [m].
  float tip_ = 0.0f, root_ = 0.0f;
  // Kept to reuse their memory:
  /// The points between the fingers' sides at each place.
  std::vector<std::vector<InSlice>> slices_;
  /// The points of one slice that the fingers reach at any depth, and those just below; and the
  /// runs of the points that they reach at the depth that is being tried.
  std::vector<InSlice> reached_;
  std::vector<Run> runs_;
  /// The points of one run.
  std::vector<BetweenPads> between_;
  std::vector<Ranked> ranked_;
};

}  // namespace

std::vector<Hold> point_holds(const SurfacePoints& points, const std::vector<char>& own,
                              const Gripper& gripper, const ApproachSpace& space,
                              const ThinWalls& walls, double max_friction) {
  return PointHoldFinder(points, own, gripper, space, walls, max_friction).find();
}

}  // namespace quadrille
