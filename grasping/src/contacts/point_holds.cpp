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
#include "contacts/pad_cover.hpp"
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
// Weights of what makes a hold promising beside contacts that face the pads: much between the
// pads, flat, from above, deep, near the middle; and against it: wide.
constexpr double kFilled = 1.0, kFlat = 0.5;
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
      const std::vector<FingerSlice>& cut = slices.cut(R_CG);
      set_orientation(R_CG, slices.sorted());
      for (const FingerSlice& slice : cut) lower(slice);
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

  void set_orientation(const Eigen::Matrix3d& R_CG, const SortedPoints& sorted) {
    const bool same_closing = R_CG.col(1) == R_CG_.col(1);
    R_CG_ = R_CG;
    sorted_ = sorted;
    if (same_closing && !cosines_.empty()) return;
    cosines_.resize(sorted.index.size()), is_own_.resize(sorted.index.size());
    const double x = R_CG(0, 1), y = R_CG(1, 1), z = R_CG(2, 1);
    for (std::size_t k = 0; k < cosines_.size(); ++k) {
      // Unlike vectors, these do not check each access.
      const std::uint32_t i = sorted.index.data()[k];
      const Eigen::Vector3d& n_C = points_.n_C.data()[i];
      cosines_.data()[k] = x * n_C.x() + y * n_C.y() + z * n_C.z();
      is_own_.data()[k] = own_.data()[i];
    }
  }

  /// Lowers the fingers on the points of a slice.
  void lower(const FingerSlice& slice) {
    if (slice.points.size() < kMinBetween) return;
    points_of_slice_ = slice.points;
    find_runs(slice.top);
    for (std::size_t n = 0; n < kDepths; ++n) {
      tip_ = tips_[n], root_ = roots_[n];
      hold_runs(runs_.at(n), slice.x);
    }
  }

  /// Returns the place among the sorted points of the k-th point of the slice.
  std::uint32_t place(std::size_t k) const { return points_of_slice_.data()[k]; }
  float y(std::size_t k) const { return sorted_.y[place(k)]; }
  double exact_y(std::size_t k) const { return sorted_.exact_y[place(k)]; }
  std::size_t index(std::size_t k) const { return sorted_.index.data()[place(k)]; }
  bool is_own(std::size_t k) const { return is_own_.data()[place(k)] != 0; }
  bool reached_by_fingers(std::size_t k) const {
    const float z = sorted_.z[place(k)];
    return (z < tip_) & (z > root_);
  }

  /// Finds the runs of points at all depths.
  void find_runs(float top) {
    const auto finger = static_cast<float>(gripper_.finger.z());
    for (std::size_t n = 0; n < kDepths; ++n) {
      tips_[n] = top + kDepthsToFinger[n] * finger;
      roots_[n] = tips_[n] - finger;
    }
    runs_.find(sorted_, points_of_slice_, tips_, roots_);
  }

  /// Holds each run of points in which there is no gap for a finger, and neighbouring runs
  /// together.
  void hold_runs(const std::vector<Run>& runs, double x) {
    for (auto first = runs.begin(); first != runs.end(); ++first) {
      const bool first_own = is_own(first->first);
      for (auto last = first; last != runs.end(); ++last) {
        // With more runs it only becomes wider.
        if (y(last->last) - y(first->first) > gripper_.max_opening) break;
        // One of the two sides at least must be the target's own.
        const Run run{first->first, last->last};
        if ((first_own || is_own(run.last)) && holds_enough(run)) hold(x, tip_, run);
      }
    }
  }

  bool holds_enough(const Run& run) const {
    std::size_t found = 0;
    for (std::size_t k = run.first; k <= run.last && found < kMinBetween; ++k) {
      found += reached_by_fingers(k) ? 1 : 0;
    }
    return found >= kMinBetween;
  }

  /// Returns the last of the points of a run that lie near its first one.
  std::size_t end_of_head(const Run& run) const {
    const float first_y = y(run.first);
    std::size_t last = run.first;
    while (last < run.last && y(last + 1) - first_y < kEndDepth) ++last;
    return last;
  }

  /// Returns the first of the points of a run that lie near its last one.
  std::size_t start_of_tail(const Run& run) const {
    const float last_y = y(run.last);
    std::size_t first = run.last;
    while (first > run.first && last_y - y(first - 1) < kEndDepth) --first;
    return first;
  }

  /// Returns some of the points that the fingers reach, in the frame of the hand.
  std::span<const BetweenPads> in_hand(std::size_t first, std::size_t last) {
    const Eigen::Matrix3d R_GC = R_CG_.transpose();
    between_.clear();
    for (std::size_t k = first; k <= last; ++k) {
      if (!reached_by_fingers(k)) continue;
      const std::size_t i = index(k);
      between_.push_back({R_GC * offsets_C_[i], R_GC * points_.n_C[i], own_[i] != 0});
    }
    return between_;
  }

  /// Counts how the points of a range of a run face the pad at `outermost`, as pad_side() does.
  FacingCount facing(std::size_t first, std::size_t last, std::size_t outermost,
                     double sign) const {
    const double outermost_y = exact_y(outermost);
    FacingCount found;
    for (std::size_t k = first; k <= last; ++k) {
      if (!reached_by_fingers(k)) continue;
      if (std::abs(exact_y(k) - outermost_y) <= kPadBand) {
        found.add(sign * cosines_.data()[place(k)]);
      }
    }
    return found;
  }

  /// Returns false if the two sides of a run certainly give no hold: neither was seen, or one is
  /// hidden behind the other, which is too far away for a wall. Most runs end here.
  bool may_touch(const Run& run, std::size_t head, std::size_t tail) const {
    const FacingCount left = facing(run.first, head, run.first, -1.0);
    const FacingCount right = facing(tail, run.last, run.last, 1.0);
    if (!left.seen() && !right.seen()) return false;
    const double width = exact_y(run.last) - exact_y(run.first);
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
    // The highest point of the run, along the approach.
    double top = tip;
    PadCover cover(x, tip, gripper_);
    const Eigen::Matrix3d R_GC = R_CG_.transpose();
    for (std::size_t k = run.first; k <= run.last; ++k) {
      if (!reached_by_fingers(k)) continue;
      const Eigen::Vector3d p_G = R_GC * offsets_C_[index(k)];
      top = std::min(top, p_G.z());
      cover.add(p_G);
    }
    found.evidence = {0.5 * (left.seen + right.seen),
                      0.5 * (left.facing + right.facing),
                      0.5 * (left.inner + right.inner),
                      std::min(left.height, right.height),
                      cover.filled(),
                      cover.flat()};
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
    for (std::size_t k = 0; k < points_of_slice_.size(); ++k) {
      const double beside = std::max(low - y(k), y(k) - high), z = sorted_.z[place(k)];
      if (z < tip || z > tip + kGoesOn || beside > gripper_.finger.y()) continue;
      ++all;
      straight += beside < kStraight;
    }
    return straight >= kMinBetween && straight >= kShareOfWall * all;
  }

  double rank(const Hold& hold, double depth) const {
    const double aside = std::abs(R_CG_.col(0).dot(hold.line.centre_C - space_.centre_C));
    const bool wide = hold.line.width > kWideShare * gripper_.max_opening;
    return 2.0 * hold.evidence.facing + kFilled * hold.evidence.filled +
           kFlat * hold.evidence.flat - kAbove * hold.approach_C.dot(space_.up_C) +
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
  /// The points as they are sorted along the closing direction that is being tried; for each of
  /// them, the part of its normal along it, and whether it is own.
  SortedPoints sorted_;
  std::vector<double> cosines_;
  std::vector<char> is_own_;
  /// How far the tips and the roots of the fingers reach along the approach, at the depth that is
  /// being tried [m].
  float tip_ = 0.0f, root_ = 0.0f;
  /// The points of one slice that the fingers reach at any depth, and those just below, by their
  /// places among the sorted ones.
  std::span<const std::uint32_t> points_of_slice_;
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
