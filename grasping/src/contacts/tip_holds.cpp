#include "contacts/tip_holds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <tuple>

#include "contacts/pad_meeting.hpp"

namespace quadrille {

namespace {

constexpr double kPi = std::numbers::pi;
// How far the tips reach beyond the nearest point of the body [m]: from the least that holds, by
// steps that grow, to most of a finger.
constexpr double kDips[] = {0.004, 0.008, 0.013, 0.019, 0.027, 0.037};
// Where along the body's breadth: at its middle, near it [m], by about the doubt about where that
// is, and as a share of half of it, for what is blocked or too wide there.
constexpr double kNear[] = {0.0, -0.005, 0.005};
constexpr double kBeside[] = {-0.35, 0.35, -0.7, 0.7};
// The tips may end as far beyond the body [m]: their own front face needs no hold.
constexpr double kBelow = 0.005;
// The closing may lift the hand by as much [m]: what it moves along y, if y is not level. Deeper
// hands are left out here, all others meet the exact test later.
constexpr double kSunk = 0.005;
// What lies so near to the body's nearest point tells where its middle is [m]: less has hardly a
// point of the surface.
constexpr double kMinReached = 0.01;

// Points all over the surface, in frame C.
Eigen::Matrix3Xd surface(const Body& body) {
  constexpr int kHeights = 9, kAround = 16;
  Eigen::Matrix3Xd points(3, kHeights * kAround);
  for (int i = 0; i < kHeights; ++i) {
    // Denser towards the ends, where a profile may close fast.
    const double u = 0.5 - 0.5 * std::cos(kPi * i / (kHeights - 1));
    const double z = (1.0 - u) * body.z_min + u * body.z_max, s = body.scale(z);
    for (int k = 0; k < kAround; ++k) {
      const double t = 2.0 * kPi * k / kAround;
      points.col(i * kAround + k) =
          body.X_CQ * Eigen::Vector3d(body.a * s * std::cos(t), body.b * s * std::sin(t), z);
    }
  }
  return points;
}

// Closing directions over half a sphere: all of it for ellipsoids, else up to 22° askew.
std::vector<Eigen::Vector3d> closings(const Body& body, const Eigen::Vector3d& up_C) {
  std::vector<Eigen::Vector3d> directions;
  const Eigen::Matrix3d& R = body.X_CQ.linear();
  if (body.profile == Body::Profile::kEllipse) {
    constexpr int kSpiral = 110;
    for (int i = 0; i < kSpiral; ++i) {
      const double z = (i + 0.5) / kSpiral, r = std::sqrt(1.0 - z * z);
      const double t = i * kPi * (3.0 - std::sqrt(5.0));
      directions.push_back(R * Eigen::Vector3d(r * std::cos(t), r * std::sin(t), z));
    }
  } else {
    constexpr int kAround = 16;
    for (int k = 0; k < kAround; ++k) {
      const double t = kPi * k / kAround;
      for (const double tilt : {0.0, -0.2, 0.2, -0.4, 0.4}) {
        // Askew, straight sides lean by as much.
        if (body.profile == Body::Profile::kConstant && std::abs(tilt) > 0.3) continue;
        directions.push_back(R * Eigen::Vector3d(std::cos(t), std::sin(t), tilt).normalized());
      }
    }
  }
  if (up_C.isZero()) return directions;
  const Eigen::Vector3d level = up_C.unitOrthogonal(), other = up_C.cross(level);
  constexpr int kLevel = 12;
  for (int k = 0; k < kLevel; ++k) {
    const double t = kPi * k / kLevel;
    directions.push_back(std::cos(t) * level + std::sin(t) * other);
  }
  return directions;
}

struct Rated {
  TipHold hold;
  int band;
  double prior;
};

// Steps of friction: what needs less comes first, whatever else it is.
int band(double friction) { return static_cast<int>(friction / 0.1); }

// The holds on one body.
class Search {
 public:
  Search(const Body& body, const Gripper& gripper, const TipLimits& limits)
      : gripper_(gripper), limits_(limits), points_(surface(body)), finder_(body, gripper) {}

  // All depths and places of one orientation of the hand.
  void add(const Eigen::Vector3d& closing_C, const Eigen::Vector3d& approach_C, double prior) {
    Eigen::Isometry3d X_CG = Eigen::Isometry3d::Identity();
    X_CG.linear() << closing_C.cross(approach_C), closing_C, approach_C;
    const std::vector<Eigen::Vector3d> places_G = places(X_CG);
    if (blocked(X_CG, places_G)) return;
    finder_.turn(closing_C, approach_C);
    for (const Eigen::Vector3d& p_G : places_G) {
      X_CG.translation() = X_CG.linear() * p_G;
      if (sinks(X_CG)) continue;
      const std::optional<PadMeeting> met = finder_.at(X_CG.translation(), limits_.friction);
      if (!met || met->line.width < gripper_.min_opening) continue;
      const double value = prior - 2.0 * met->friction;
      rated_.push_back(
          {{met->line, approach_C, met->friction}, std::max(2, band(met->friction)), value});
    }
  }

  // Band by band; of each every kStride-th of the ranking first, then those between.
  std::vector<TipHold> spread_out() {
    constexpr std::ptrdiff_t kStride = 16;
    std::stable_sort(rated_.begin(), rated_.end(), [](const Rated& a, const Rated& b) {
      return std::tuple(a.band, -a.prior) < std::tuple(b.band, -b.prior);
    });
    std::vector<TipHold> holds;
    for (auto first = rated_.begin(), last = first; first != rated_.end(); first = last) {
      last = std::find_if(first, rated_.end(),
                          [&](const Rated& other) { return other.band != first->band; });
      for (std::ptrdiff_t start = 0; start < kStride; ++start) {
        for (auto n = start; n < last - first; n += kStride) holds.push_back(first[n].hold);
      }
    }
    return holds;
  }

 private:
  // Where the origin of G is put, along the axes of an orientation.
  std::vector<Eigen::Vector3d> places(const Eigen::Isometry3d& X_CG) {
    points_G_.noalias() = X_CG.linear().transpose() * points_;
    const Eigen::RowVectorXd& ahead = points_G_.row(2);
    const double nearest = ahead.minCoeff(), farthest = ahead.maxCoeff();
    // What each dip reaches beyond those before it.
    std::array<Eigen::AlignedBox3d, std::size(kDips)> reached;
    for (const auto& p_G : points_G_.colwise()) {
      const double deep = p_G.z() - nearest;
      const auto dip = deep <= kMinReached
                           ? std::begin(kDips)
                           : std::lower_bound(std::begin(kDips), std::end(kDips), deep);
      if (dip != std::end(kDips)) reached[dip - std::begin(kDips)].extend(Eigen::Vector3d(p_G));
    }
    std::vector<Eigen::Vector3d> places;
    Eigen::AlignedBox3d reached_G;
    for (std::size_t n = 0; n < std::size(kDips); ++n) {
      const double dip = kDips[n];
      if (nearest + dip > farthest + kBelow) break;
      reached_G.extend(reached[n]);
      Eigen::Vector3d p_G = reached_G.center();
      p_G.z() = nearest + dip - gripper_.finger_front;
      const auto add = [&](double beside) {
        places.emplace_back(p_G + beside * Eigen::Vector3d::UnitX());
      };
      for (const double beside : kNear) add(beside);
      for (const double share : kBeside) add(0.5 * share * reached_G.sizes().x());
    }
    return places;
  }

  // True if the palm runs into something in all of these places, wherever along y they end up.
  bool blocked(const Eigen::Isometry3d& X_CG, const std::vector<Eigen::Vector3d>& places_G) const {
    Eigen::AlignedBox3d places;
    for (const Eigen::Vector3d& p_G : places_G) places.extend(p_G);
    places.min().y() = points_G_.row(1).minCoeff();
    places.max().y() = points_G_.row(1).maxCoeff();
    const auto palm = common_palm(gripper_, X_CG, places, limits_.approach);
    return palm && limits_.scene.palm_obstruction(*palm);
  }

  // True if the closed hand's fingers or palm lie below a plane, wherever along y it ends up.
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
      return plane.meets(fingers, -kSunk) || plane.meets(behind, -kSunk);
    });
  }

  const Gripper& gripper_;
  const TipLimits& limits_;
  Eigen::Matrix3Xd points_, points_G_;
  PadMeetingFinder finder_;
  std::vector<Rated> rated_;
};

}  // namespace

std::vector<TipHold> tip_holds(const Body& body, const Gripper& gripper, const ApproachSpace& space,
                               const TipLimits& limits) {
  if (body.profile == Body::Profile::kBox) return {};
  Search search(body, gripper, limits);
  for (const Eigen::Vector3d& d : closings(body, space.up_C)) {
    const Eigen::Vector3d first = d.unitOrthogonal(), second = d.cross(first);
    constexpr int kDirections = 24;
    const double across = 0.5 * (1.0 - std::abs(d.dot(space.view_C)));
    for (int k = 0; k < kDirections; ++k) {
      const double t = 2.0 * kPi * k / kDirections;
      const Eigen::Vector3d a = std::cos(t) * first + std::sin(t) * second;
      if (!reachable(a, space)) continue;
      const double from = std::max(-a.dot(space.view_C), -a.dot(space.up_C));
      search.add(d, a, across + 0.3 * from);
    }
  }
  return search.spread_out();
}

}  // namespace quadrille
