#include "contacts/slice_holds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contacts/pad_cover.hpp"
#include "contacts/quality.hpp"

namespace quadrille {
namespace {

// Fewer points between the fingers may be noise.
constexpr std::size_t kMinBetween = 8;
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

// Tips stop above what the target stands on, farther by this than hands have to keep off it [m]:
// the check for collisions must not refuse them for what rounding changes. There tips hold things
// that lie flat.
constexpr double kAboveOff = 0.0005;
// Sine of the greatest lean of the closing direction, and least cosine between the approach and
// the way down, for which the tips reach down alike.
constexpr double kMostLean = 0.05, kLeastDown = 0.5;
// Tips that reach less deep below the highest point than this hold nothing [m].
constexpr float kLeastDepth = 0.003f;

// Far more than what floats round of a height in the hand [m].
constexpr double kHeightRounding = 1e-6;

}  // namespace

SliceHolds::SliceHolds(const SurfacePoints& points, const std::vector<char>& own,
                       const Gripper& gripper, const ApproachSpace& space, const ThinWalls& walls,
                       double max_friction)
    : points_(points),
      own_(own),
      gripper_(gripper),
      space_(space),
      walls_(walls),
      max_friction_(max_friction),
      runs_(static_cast<float>(gripper.finger.y())) {
  for (const Eigen::Vector3d& p_C : points.p_C) offsets_C_.push_back(p_C - space.centre_C);
}

SliceHeights SliceHolds::heights(const Gripper& gripper) {
  const auto finger = static_cast<float>(gripper.finger.z());
  return {(1.0f - kDepthsToFinger.back()) * finger,
          kDepthsToFinger.front() * finger + static_cast<float>(kGoesOn)};
}

void SliceHolds::set_orientation(const Eigen::Matrix3d& R_CG, const SortedPoints& sorted) {
  R_CG_ = R_CG;
  sorted_ = sorted;
  if (facings_.size() <= sorted.direction) facings_.resize(sorted.direction + 1);
  Facing& facing = facings_[sorted.direction];
  facing_ = &facing;
  if (facing.cosines.size() > 0) return;
  const auto count = static_cast<Eigen::Index>(sorted.index.size());
  facing.cosines.resize(count), facing.is_own.resize(count);
  const double x = R_CG(0, 1), y = R_CG(1, 1), z = R_CG(2, 1);
  // Unlike vectors, these do not check each access.
  const std::uint32_t* index = sorted.index.data();
  const Eigen::Vector3d* normals_C = points_.n_C.data();
  const char* own = own_.data();
  double* cosines = facing.cosines.data();
  char* is_own = facing.is_own.data();
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Vector3d& n_C = normals_C[index[k]];
    cosines[k] = x * n_C.x() + y * n_C.y() + z * n_C.z();
    is_own[k] = own[index[k]];
  }
}

void SliceHolds::find(const FingerSlice& slice, std::vector<SliceHold>& found) {
  if (slice.points.size() < kMinBetween) return;
  points_of_slice_ = slice.points;
  find_runs(slice);
  for (std::size_t n = 0; n < kDepths; ++n) {
    // The support may stop the tips at one place for several depths.
    const bool repeats = n > 0 && tips_[n] == tips_[n - 1];
    if (repeats || tips_[n] - slice.top < kLeastDepth) continue;
    tip_ = tips_[n], root_ = roots_[n];
    hold_runs(runs_.at(n), slice.x, found);
  }
}

/// Returns how far the tips reach along the approach before they come too near to what the target
/// stands on; infinity if nothing tells.
double SliceHolds::lowest_tip(double x) const {
  const Eigen::Vector3d up_G = R_CG_.transpose() * space_.up_C;
  // If the hand leans much to one side, the two tips reach down differently, and if it comes
  // from the side, they hardly reach down. Then the check for collisions decides.
  if (std::abs(up_G.y()) > kMostLean || -up_G.z() < kLeastDown) {
    return std::numeric_limits<double>::infinity();
  }
  // The lower of the fingers, where the hand opens most, decides.
  const double aside = 0.5 * gripper_.max_opening + gripper_.finger.y();
  const double corner =
      up_G.x() * x - 0.5 * std::abs(up_G.x()) * gripper_.finger.x() - std::abs(up_G.y()) * aside;
  return (space_.height + corner - space_.off_support - kAboveOff) / -up_G.z();
}

/// Finds the runs of points at all depths.
void SliceHolds::find_runs(const FingerSlice& slice) {
  const auto finger = static_cast<float>(gripper_.finger.z());
  const auto lowest = static_cast<float>(lowest_tip(slice.x));
  for (std::size_t n = 0; n < kDepths; ++n) {
    tips_[n] = std::min(slice.top + kDepthsToFinger[n] * finger, lowest);
    roots_[n] = tips_[n] - finger;
  }
  runs_.find(sorted_, points_of_slice_, tips_, roots_);
}

/// Holds each run of points in which there is no gap for a finger, and neighbouring runs
/// together.
void SliceHolds::hold_runs(const std::vector<Run>& runs, double x, std::vector<SliceHold>& found) {
  for (auto first = runs.begin(); first != runs.end(); ++first) {
    const bool first_own = is_own(first->first);
    for (auto last = first; last != runs.end(); ++last) {
      // With more runs it only becomes wider.
      if (y(last->last) - y(first->first) > gripper_.max_opening) break;
      // One of the two sides at least must be the target's own.
      const Run run{first->first, last->last};
      if ((first_own || is_own(run.last)) && holds_enough(run)) hold(x, tip_, run, found);
    }
  }
}

bool SliceHolds::holds_enough(const Run& run) const {
  std::size_t found = 0;
  for (std::size_t k = run.first; k <= run.last && found < kMinBetween; ++k) {
    found += reached_by_fingers(k) ? 1 : 0;
  }
  return found >= kMinBetween;
}

/// Returns the last of the points of a run that lie near its first one.
std::size_t SliceHolds::end_of_head(const Run& run) const {
  const float first_y = y(run.first);
  std::size_t last = run.first;
  while (last < run.last && y(last + 1) - first_y < kEndDepth) ++last;
  return last;
}

/// Returns the first of the points of a run that lie near its last one.
std::size_t SliceHolds::start_of_tail(const Run& run) const {
  const float last_y = y(run.last);
  std::size_t first = run.last;
  while (first > run.first && last_y - y(first - 1) < kEndDepth) --first;
  return first;
}

/// Returns some of the points that the fingers reach, in the frame of the hand.
std::span<const BetweenPads> SliceHolds::in_hand(std::size_t first, std::size_t last) {
  if (between_.size() < last + 1 - first) between_.resize(last + 1 - first);
  const Eigen::Matrix3d R_GC = R_CG_.transpose();
  // Unlike vectors, these do not check each access.
  const Eigen::Vector3d *offsets_C = offsets_C_.data(), *normals_C = points_.n_C.data();
  BetweenPads* between = between_.data();
  std::size_t count = 0;
  for (std::size_t k = first; k <= last; ++k) {
    if (!reached_by_fingers(k)) continue;
    const std::size_t i = index(k);
    between[count++] = {R_GC * offsets_C[i], R_GC * normals_C[i], own_.data()[i] != 0};
  }
  return {between, count};
}

/// Looks at the points of a range of a run near the outermost one: how they face the pad there, as
/// pad_side() counts it, and how far they lie along the approach.
SliceHolds::Glance SliceHolds::glance(std::size_t first, std::size_t last, std::size_t outermost,
                                      double sign) const {
  const double outermost_y = exact_y(outermost);
  Glance found;
  for (std::size_t k = first; k <= last; ++k) {
    if (!reached_by_fingers(k) || std::abs(exact_y(k) - outermost_y) > kPadBand) continue;
    found.facing.add(sign * facing_->cosines.data()[place(k)]);
    found.z += static_cast<double>(sorted_.z[place(k)]);
  }
  found.z /= found.facing.count();
  return found;
}

/// Returns false if the two sides of a run certainly give no hold. Either neither was seen, or one
/// is hidden behind the other, which is too far away for a wall; or the contacts lie at too
/// different heights for the friction at a side that was not seen, which is assumed to face its
/// pad. Most runs end here.
bool SliceHolds::may_hold(const Run& run, std::size_t head, std::size_t tail) const {
  const Glance left = glance(run.first, head, run.first, -1.0);
  const Glance right = glance(tail, run.last, run.last, 1.0);
  if (!left.facing.seen() && !right.facing.seen()) return false;
  const double width = exact_y(run.last) - exact_y(run.first);
  if (left.facing.behind() || right.facing.behind()) return width < walls_.max;
  if (left.facing.seen() && right.facing.seen()) return true;
  return std::abs(left.z - right.z) <= max_friction_ * width + kHeightRounding;
}

void SliceHolds::hold(double x, double tip, const Run& run, std::vector<SliceHold>& holds) {
  const std::size_t head = end_of_head(run), tail = start_of_tail(run);
  if (!may_hold(run, head, tail)) return;
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
  line.centre_C = in_cloud({x, 0.5 * (left.p_G.y() + right.p_G.y()), tip - gripper_.finger_front});
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
    const Eigen::Vector3d p_G = R_GC * offsets_C_.data()[index(k)];
    top = std::min(top, p_G.z());
    cover.add(p_G);
  }
  found.evidence = {0.5 * (left.seen + right.seen),
                    0.5 * (left.facing + right.facing),
                    0.5 * (left.inner + right.inner),
                    std::min(left.height, right.height),
                    cover.filled(),
                    cover.flat()};
  holds.push_back({found, tip - top});
}

/// Returns true if the points between two sides, of which one is hidden behind the other, are the
/// rim of a thin wall: the sensor saw past the rim to the place of the finger behind the wall.
bool SliceHolds::is_thin_wall(double x, double tip, const PadSide& left,
                              const PadSide& right) const {
  const double low = left.p_G.y(), high = right.p_G.y();
  if (high - low >= walls_.max || !goes_on(tip, low, high)) return false;
  const double beside = left.behind ? low - gripper_.finger.y() : high + gripper_.finger.y();
  return std::all_of(std::begin(kAcrossFinger), std::end(kAcrossFinger), [&](double share) {
    return walls_.is_free(in_cloud({x + share * gripper_.finger.x(), beside, tip}));
  });
}

/// Returns the point in C that lies at an offset from the target's centre along the axes of G.
Eigen::Vector3d SliceHolds::in_cloud(const Eigen::Vector3d& offset_G) const {
  return space_.centre_C + R_CG_ * offset_G;
}

/// Returns true if the points of a wall go on straight below the tips.
bool SliceHolds::goes_on(double tip, double low, double high) const {
  std::size_t all = 0, straight = 0;
  for (std::size_t k = 0; k < points_of_slice_.size(); ++k) {
    const double beside = std::max(low - y(k), y(k) - high), z = sorted_.z[place(k)];
    if (z < tip || z > tip + kGoesOn || beside > gripper_.finger.y()) continue;
    ++all;
    straight += beside < kStraight;
  }
  return straight >= kMinBetween && straight >= kShareOfWall * all;
}

}  // namespace quadrille
