#include "contacts/tip_holds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <tuple>

#include "contacts/directions.hpp"
#include "contacts/pad_meeting.hpp"
#include "contacts/surface_grid.hpp"

namespace quadrille {
namespace {

constexpr double kPi = std::numbers::pi;
// Depths by which the tips reach beyond the nearest point of the body [m]: from the least that
// holds, in growing steps, up to a share of the finger's length. The Franka Hand uses the first
// six.
constexpr std::array kDips = {0.004, 0.008, 0.013, 0.019, 0.027, 0.037, 0.049, 0.063};
constexpr double kMaxDipToFinger = 0.75;
// Offsets of the tips from the middle of what they reach: by about the uncertainty of that middle
// [m], and by shares of half its breadth, for bodies that are blocked or too wide in the middle.
constexpr double kOffMiddle[] = {0.0, -0.005, 0.005};
constexpr double kSharesBeside[] = {-0.35, 0.35, -0.7, 0.7};
// Greatest distance between the body's far side and the tips beyond it [m]; the front face of the
// tips holds nothing.
constexpr double kMaxBeyond = 0.005;
// Depth below a plane that is still accepted here [m]: the hand may rise by about as much while it
// closes, since it moves along y, which need not be level. The exact test comes later.
constexpr double kMaxSunk = 0.005;
// The middle of what the tips reach is taken over at least this depth of the body [m]: a thinner
// slice holds hardly any points of the surface.
constexpr double kMinReached = 0.01;
// Numbers of closing directions that are tried, and the angles by which they are tilted.
constexpr int kSpiral = 110, kAround = 16, kLevel = 12;
constexpr double kTilts[] = {0.0, -0.2, 0.2, -0.4, 0.4};
// On straight sides, a hold needs friction of about the tilt itself, so larger tilts would not
// hold.
constexpr double kMaxTiltOnStraight = 0.3;

/// Returns closing directions over half a sphere: all of it for ellipsoids, otherwise up to 22°
/// askew.
std::vector<Eigen::Vector3d> closings(const Body& body, const Eigen::Vector3d& up_C) {
  std::vector<Eigen::Vector3d> directions;
  const Eigen::Matrix3d& R = body.X_CQ.linear();
  if (body.profile == Body::Profile::kEllipse) {
    for (const Eigen::Vector3d& d : half_sphere(kSpiral)) directions.emplace_back(R * d);
  } else {
    const bool straight = body.profile == Body::Profile::kConstant;
    for (int k = 0; k < kAround; ++k) {
      const double t = kPi * k / kAround;
      for (const double tilt : kTilts) {
        if (straight && std::abs(tilt) > kMaxTiltOnStraight) continue;
        directions.emplace_back(R * Eigen::Vector3d(std::cos(t), std::sin(t), tilt).normalized());
      }
    }
  }
  const std::vector<Eigen::Vector3d> level = level_directions(up_C, kLevel);
  directions.insert(directions.end(), level.begin(), level.end());
  return directions;
}

/// An orientation of the hand, how promising it is, and the greatest width of its holds [m].
struct Orientation {
  Eigen::Vector3d closing_C, approach_C;
  double prior, max_width;
};

struct Rated {
  Hold hold;
  int band;
  double prior;
  std::size_t orientation;
};

// Holds are ranked by the friction that they need, in bands of this width. Holds that need less
// than the first band count as in it.
constexpr double kFrictionBand = 0.1;
constexpr int kFirstBand = 2;

int band(double friction) {
  return std::max(kFirstBand, static_cast<int>(friction / kFrictionBand));
}

/// The search for holds on one body.
class Search {
 public:
  Search(const Body& body, const Gripper& gripper, const TipLimits& limits)
      : body_(body),
        gripper_(gripper),
        limits_(limits),
        points_(surface_grid(body)),
        points_G_(points_) {
    for (const double dip : kDips) {
      if (dips_.empty() || dip <= kMaxDipToFinger * gripper.finger.z()) dips_.push_back(dip);
    }
  }

  /// Adds the holds at all depths and places for one orientation of the hand.
  /// @param number  of the orientation; it decides the order of equals
  void add(const Orientation& orientation, std::size_t number) {
    const Eigen::Vector3d &closing_C = orientation.closing_C, &approach_C = orientation.approach_C;
    Eigen::Isometry3d X_CG = Eigen::Isometry3d::Identity();
    X_CG.linear() << closing_C.cross(approach_C), closing_C, approach_C;
    const std::vector<Eigen::Vector3d> places_G = places(X_CG);
    if (places_G.empty()) return;
    const Eigen::AlignedBox3d bounds_G = bounds(places_G);
    if (limits_.out_of_reach && limits_.out_of_reach(X_CG, bounds_G)) return;
    if (blocked(X_CG, bounds_G)) return;
    const std::vector<double> heights = safe_heights(X_CG.linear());
    PadMeetingFinder finder(body_, gripper_, closing_C, approach_C);
    for (const Eigen::Vector3d& p_G : places_G) {
      X_CG.translation() = X_CG.linear() * p_G;
      if (may_sink(X_CG.translation(), heights) && sinks(X_CG)) continue;
      const std::optional<PadMeeting> met =
          finder.at(X_CG.translation(), limits_.friction, orientation.max_width);
      if (!met || met->line.width < gripper_.min_opening) continue;
      const double value = orientation.prior - 2.0 * met->friction;
      rated_.push_back(
          {{met->line, approach_C, met->friction}, band(met->friction), value, number});
    }
  }

  /// Returns true if one of the holds so far is promising.
  bool is_promising() const {
    return std::any_of(rated_.begin(), rated_.end(),
                       [&](const Rated& rated) { return limits_.is_promising(rated.hold); });
  }

  /// Returns all holds, band by band, each band in the order of visit_in_passes().
  std::vector<Hold> ordered() {
    std::stable_sort(rated_.begin(), rated_.end(), [](const Rated& a, const Rated& b) {
      return std::tuple(a.band, -a.prior, a.orientation) <
             std::tuple(b.band, -b.prior, b.orientation);
    });
    std::vector<Hold> holds;
    for (auto first = rated_.begin(), last = first; first != rated_.end(); first = last) {
      last = std::find_if(first, rated_.end(),
                          [&](const Rated& other) { return other.band != first->band; });
      visit_in_passes(first, last, [&](const Rated& rated) { holds.push_back(rated.hold); });
    }
    return holds;
  }

 private:
  /// Returns the places at which the origin of G is put, in the axes of an orientation.
  std::vector<Eigen::Vector3d> places(const Eigen::Isometry3d& X_CG) {
    turn_points(points_, X_CG.linear(), &points_G_);
    const GridSpan along = span_of(points_G_.z);
    const double nearest = along.least, farthest = along.greatest;
    std::vector<Eigen::Vector3d> places;
    places.reserve(dips_.size() * (std::size(kOffMiddle) + std::size(kSharesBeside)));
    double reached_depth = -1.0;
    Eigen::AlignedBox2d reached_G;
    for (std::size_t n = 0; n < dips_.size(); ++n) {
      if (nearest + dips_[n] > farthest + kMaxBeyond) break;
      const double depth = std::max(dips_[n], kMinReached);
      if (depth != reached_depth) reached_G = reached(nearest, depth);
      reached_depth = depth;
      const Eigen::Vector2d middle = reached_G.center();
      const Eigen::Vector3d p_G(middle.x(), middle.y(), nearest + dips_[n] - gripper_.finger_front);
      const auto add = [&](double beside) {
        places.emplace_back(p_G + beside * Eigen::Vector3d::UnitX());
      };
      for (const double beside : kOffMiddle) add(beside);
      for (const double share : kSharesBeside) add(0.5 * share * reached_G.sizes().x());
    }
    return places;
  }

  /// Returns the bounds, across the approach, of the surface down to a depth.
  Eigen::AlignedBox2d reached(double nearest, double depth) const {
    const GridBounds bounds = bounds_within(points_G_, depth, nearest);
    return {Eigen::Vector2d(bounds.x_min, bounds.y_min),
            Eigen::Vector2d(bounds.x_max, bounds.y_max)};
  }

  /// Returns the bounds of these places, wherever along y they end up.
  Eigen::AlignedBox3d bounds(const std::vector<Eigen::Vector3d>& places_G) const {
    Eigen::AlignedBox3d bounds_G;
    for (const Eigen::Vector3d& p_G : places_G) bounds_G.extend(p_G);
    const GridSpan across = span_of(points_G_.y);
    bounds_G.min().y() = across.least;
    bounds_G.max().y() = across.greatest;
    return bounds_G;
  }

  /// Returns true if the palm collides at all places within these bounds.
  bool blocked(const Eigen::Isometry3d& X_CG, const Eigen::AlignedBox3d& bounds_G) const {
    const auto palm = common_palm(gripper_, X_CG, bounds_G, limits_.approach);
    return palm && limits_.scene.palm_obstruction(*palm);
  }

  /// Returns true if the closed hand's fingers or palm lie below a plane, wherever along y the hand
  /// ends up.
  bool sinks(const Eigen::Isometry3d& X_CG) const {
    const double front = gripper_.finger_front, back = front - gripper_.finger.z();
    const Eigen::Vector3d palm(0.5 * gripper_.palm.x(), 0.5 * gripper_.palm.y(), 0.0);
    const double x = 0.5 * gripper_.finger.x(), y = gripper_.finger.y();
    const OrientedBox fingers = box_between(X_CG, {-x, -y, back}, {x, y, front});
    const OrientedBox behind =
        box_between(X_CG, -palm - Eigen::Vector3d(0, 0, gripper_.palm.z() - back),
                    palm + Eigen::Vector3d(0, 0, back));
    const std::vector<SupportPlane>& planes = limits_.scene.planes;
    return std::any_of(planes.begin(), planes.end(), [&](const SupportPlane& plane) {
      return plane.meets(fingers, -kMaxSunk) || plane.meets(behind, -kMaxSunk);
    });
  }

  /// For each plane, the height above which a hand of an orientation, given by that of its origin,
  /// certainly does not sink [m].
  std::vector<double> safe_heights(const Eigen::Matrix3d& R_CG) const {
    // Far more than what rounding changes in heights of some metres [m].
    constexpr double kRounding = 1e-6;
    std::vector<double> heights;
    const double front = gripper_.finger_front, back = front - gripper_.finger.z();
    const double side = std::max(0.5 * gripper_.palm.y(), gripper_.finger.y());
    const double across = std::max(0.5 * gripper_.palm.x(), 0.5 * gripper_.finger.x());
    for (const SupportPlane& plane : limits_.scene.planes) {
      const Eigen::Vector3d n_G = R_CG.transpose() * plane.n_C();
      const double deepest = std::max(-n_G.z() * front, -n_G.z() * (back - gripper_.palm.z()));
      heights.push_back(std::abs(n_G.x()) * across + std::abs(n_G.y()) * side + deepest - kMaxSunk +
                        kRounding);
    }
    return heights;
  }

  /// Returns true if a hand may sink; safe_heights() tell for most that they do not.
  bool may_sink(const Eigen::Vector3d& p_CG, const std::vector<double>& heights) const {
    for (std::size_t n = 0; n < heights.size(); ++n) {
      if (limits_.scene.planes[n].distance(p_CG) < heights[n]) return true;
    }
    return false;
  }

  const Body& body_;
  const Gripper& gripper_;
  const TipLimits& limits_;
  std::vector<double> dips_;
  const SurfaceGrid points_;
  SurfaceGrid points_G_;
  std::vector<Rated> rated_;
};

}  // namespace

std::vector<Hold> tip_holds(const Body& body, const Gripper& gripper, const ApproachSpace& space,
                            const TipLimits& limits) {
  if (body.profile == Body::Profile::kBox) return {};
  std::vector<Orientation> orientations;
  for (const Eigen::Vector3d& d : closings(body, space.up_C)) {
    const double max_width = limits.max_width ? limits.max_width(d) : gripper.max_opening;
    if (max_width <= 0.0) continue;
    const double across = 0.5 * (1.0 - std::abs(d.dot(space.view_C)));
    for (const Eigen::Vector3d& a : around_closing(d, d.unitOrthogonal())) {
      if (!wanted(a, space) || !reachable(a, space)) continue;
      const double from = std::max(-a.dot(space.view_C), -a.dot(space.up_C));
      orientations.push_back({d, a, across + 0.3 * from, max_width});
    }
  }
  Search search(body, gripper, limits);
  constexpr std::size_t kRounds = 2;
  for (std::size_t round = 0; round < kRounds; ++round) {
    if (round == 1 && limits.is_promising && !search.is_promising()) break;
    for (std::size_t n = round; n < orientations.size(); n += kRounds) {
      search.add(orientations[n], n);
    }
  }
  return search.ordered();
}

}  // namespace quadrille
