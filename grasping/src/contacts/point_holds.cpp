#include "contacts/point_holds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "contacts/directions.hpp"
#include "contacts/finger_runs.hpp"
#include "contacts/finger_slices.hpp"
#include "contacts/hand_directions.hpp"
#include "contacts/pad_side.hpp"
#include "contacts/quality.hpp"

namespace quadrille {
namespace {

// The tips reach so deep below the highest point of the target between the fingers, in lengths of
// the fingers; deepest first.
constexpr std::array kDepthsToFinger = {0.75f, 0.55f, 0.4f, 0.28f, 0.16f};
constexpr std::size_t kDepths = kDepthsToFinger.size();
static_assert(kDepths <= FingerRuns::kMaxDepths);
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
// The points within this distance of the end of a run tell how a pad meets it [m]: somewhat more
// than pad_side() needs, for the rounding of floats.
constexpr double kEndDepth = kPadBand + 1e-4;

/// The heights of points that fingers meet at any of the depths, and of those just below.
SliceHeights heights_of(const Gripper& gripper) {
  const auto finger = static_cast<float>(gripper.finger.z());
  return {(1.0f - kDepthsToFinger.back()) * finger,
          kDepthsToFinger.front() * finger + static_cast<float>(kGoesOn)};
}

class PointHoldFinder {
 public:
  PointHoldFinder(const SurfacePoints& points, const std::vector<char>& own, const Gripper& gripper,
                  const ApproachSpace& space, const ThinWalls& walls, double max_friction)
      : points_(points),
        own_(own),
        gripper_(gripper),
        space_(space),
        walls_(walls),
        max_friction_(max_friction),
        runs_(static_cast<float>(gripper.finger.y())) {
    for (const Eigen::Vector3d& p_C : points.p_C) offsets_C_.push_back(p_C - space.centre_C);
  }

  std::vector<Hold> find() {
    std::vector<Eigen::Vector3d> normals;
    for (std::size_t i = 0; i < own_.size(); ++i) {
      if (own_[i] && !points_.n_C[i].isZero()) normals.push_back(points_.n_C[i]);
    }
    FingerSlices slices(offsets_C_, own_, gripper_, heights_of(gripper_));
    for (const Eigen::Matrix3d& R_CG : hand_directions(std::move(normals), space_)) {
      set_orientation(R_CG);
      for (const FingerSlice& slice : slices.cut(R_CG)) lower(slice);
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

  /// How far a point lies along the closing direction [m], and the part of its normal along it.
  struct AlongClosing {
    double y = 0.0, n_y = 0.0;
  };

  void set_orientation(const Eigen::Matrix3d& R_CG) {
    const bool same_closing = !along_.empty() && R_CG.col(1) == R_CG_.col(1);
    R_CG_ = R_CG;
    if (same_closing) return;
    const Eigen::Matrix3d R_GC = R_CG_.transpose();
    along_.resize(offsets_C_.size());
    for (std::size_t i = 0; i < along_.size(); ++i) {
      const Eigen::Vector3d p_G = R_GC * offsets_C_[i], n_G = R_GC * points_.n_C[i];
      along_[i] = {p_G.y(), n_G.y()};
    }
  }

  /// Lowers the fingers on the points of a slice.
  void lower(const FingerSlice& slice) {
    if (slice.points.size() < kMinBetween) return;
    reached_ = slice.points;
    find_runs(slice.top);
    for (std::size_t n = 0; n < kDepths; ++n) {
      tip_ = tips_[n], root_ = roots_[n];
      hold_runs(runs_.at(n), slice.x);
    }
  }

  bool reached_by_fingers(const InSlice& point) const {
    return (point.z < tip_) & (point.z > root_);
  }

  /// Finds the runs of points at all depths.
  void find_runs(float top) {
    const auto finger = static_cast<float>(gripper_.finger.z());
    for (std::size_t n = 0; n < kDepths; ++n) {
      tips_[n] = top + kDepthsToFinger[n] * finger;
      roots_[n] = tips_[n] - finger;
    }
    runs_.find(reached_, tips_, roots_);
  }

  /// Holds each run of points in which there is no gap for a finger, and neighbouring runs
  /// together.
  void hold_runs(const std::vector<Run>& runs, double x) {
    for (std::size_t a = 0; a < runs.size(); ++a) {
      Run run{runs[a].first, 0, 0};
      for (std::size_t b = a; b < runs.size(); ++b) {
        run.last = runs[b].last;
        run.count += runs[b].count;
        // With more runs it only becomes wider.
        if (reached_[run.last].y - reached_[run.first].y > gripper_.max_opening) break;
        if (may_hold(run)) hold(x, tip_, run);
      }
    }
  }

  bool may_hold(const Run& run) const {
    const InSlice &first = reached_[run.first], &last = reached_[run.last];
    return run.count >= kMinBetween && (own_[first.index] || own_[last.index]);
  }

  /// Returns the last of the points of a run that lie near its first one.
  std::size_t end_of_head(const Run& run) const {
    // Unlike spans, this does not check each access.
    const InSlice* reached = reached_.data();
    const float y = reached[run.first].y;
    std::size_t last = run.first;
    while (last < run.last && reached[last + 1].y - y < kEndDepth) ++last;
    return last;
  }

  /// Returns the first of the points of a run that lie near its last one.
  std::size_t start_of_tail(const Run& run) const {
    const InSlice* reached = reached_.data();
    const float y = reached[run.last].y;
    std::size_t first = run.last;
    while (first > run.first && y - reached[first - 1].y < kEndDepth) --first;
    return first;
  }

  /// Returns some of the points that the fingers reach, in the frame of the hand.
  std::span<const BetweenPads> in_hand(std::size_t first, std::size_t last) {
    const Eigen::Matrix3d R_GC = R_CG_.transpose();
    between_.clear();
    for (std::size_t k = first; k <= last; ++k) {
      if (!reached_by_fingers(reached_[k])) continue;
      const std::size_t i = reached_[k].index;
      between_.push_back({R_GC * offsets_C_[i], R_GC * points_.n_C[i], own_[i] != 0});
    }
    return between_;
  }

  /// Counts how the points of a range of a run face the pad at `outermost`, as pad_side() does.
  FacingCount facing(std::size_t first, std::size_t last, std::size_t outermost,
                     double sign) const {
    // Unlike vectors, these do not check each access.
    const AlongClosing* along = along_.data();
    const InSlice* reached = reached_.data();
    const double y = along[reached[outermost].index].y;
    FacingCount found;
    for (std::size_t k = first; k <= last; ++k) {
      if (!reached_by_fingers(reached[k])) continue;
      const AlongClosing& point = along[reached[k].index];
      if (std::abs(point.y - y) <= kPadBand) found.add(sign * point.n_y);
    }
    return found;
  }

  /// Returns false if the two sides of a run certainly give no hold: neither was seen, or one is
  /// hidden behind the other, which is too far away for a wall. Most runs end here.
  bool may_touch(const Run& run, std::size_t head, std::size_t tail) const {
    const FacingCount left = facing(run.first, head, run.first, -1.0);
    const FacingCount right = facing(tail, run.last, run.last, 1.0);
    if (!left.seen() && !right.seen()) return false;
    const double width = along_[reached_[run.last].index].y - along_[reached_[run.first].index].y;
    return !(left.behind() || right.behind()) || width < walls_.max;
  }

  void hold(double x, double tip, const Run& run) {
    const std::size_t head = end_of_head(run), tail = start_of_tail(run);
    if (!may_touch(run, head, tail)) return;
    PadSide left = pad_side(in_hand(run.first, head), -1.0, x, tip, gripper_);
    PadSide right = pad_side(in_hand(tail, run.last), 1.0, x, tip, gripper_);
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
    ranked_.push_back({found, rank(found, tip - top_of(run, tip))});
  }

  /// Returns how far the highest point of a run lies along the approach.
  double top_of(const Run& run, double tip) const {
    const Eigen::Matrix3d R_GC = R_CG_.transpose();
    double top = tip;
    for (std::size_t k = run.first; k <= run.last; ++k) {
      if (!reached_by_fingers(reached_[k])) continue;
      const Eigen::Vector3d p_G = R_GC * offsets_C_[reached_[k].index];
      top = std::min(top, p_G.z());
    }
    return top;
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
  /// The position and the normal of each point along the closing direction that is being tried.
  std::vector<AlongClosing> along_;
  /// How far the tips and the roots of the fingers reach along the approach, at the depth that is
  /// being tried [m].
  float tip_ = 0.0f, root_ = 0.0f;
  /// The points of one slice that the fingers reach at any depth, and those just below.
  std::span<const InSlice> reached_;
  /// How far tips and roots reach at each depth [m], and the runs of the points in between.
  std::array<float, kDepths> tips_{}, roots_{};
  FingerRuns runs_;
  /// Points of one run.
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
