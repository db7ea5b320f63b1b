#include "boxes/upright_face.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "boxes/around_face.hpp"
#include "boxes/bend.hpp"
#include "boxes/outline.hpp"
#include "boxes/sight_lines.hpp"

namespace quadrille {
namespace {

// The lower edge of a face ends no higher than this above the plane on which the box stands [m],
// beside the face's tolerance: the box is rounded there, and the sensor mixes it with the plane.
constexpr double kMaxFootGap = 2.0 * kRounding;
// No side of the face is longer [m]: half of the longest side of a box. A single face so large may
// be a wall as well.
constexpr double kMaxFaceSide = 0.5 * kMaxSide;
// Least share of a side of the box that is flat. The strip of a cylinder that passes for a plane is
// half as wide as the cylinder.
constexpr double kMinFlat = 0.7;
// Edges have at most this radius [m].
constexpr double kMaxRadius = 0.015;
// Standard deviation of what a rounded edge adds to an outline, as a share of it: the radii of a
// box's edges differ about as much.
constexpr double kUnsureShare = 0.33;

class UprightFace {
 public:
  UprightFace(const BoxDraft& draft, const std::vector<const Detection*>& planes,
              const BoxEnds& ends)
      : draft_(draft), face_(*draft.faces.front()), planes_(planes), ends_(ends) {}

  std::optional<BoxEnds> find() {
    if (!stands()) return std::nullopt;
    const AroundFace around(draft_,
                            {{{ends_[1][0].at, ends_[1][1].at}, {ends_[2][0].at, ends_[2][1].at}}});
    if (around.turn() > kMaxTurn || !end_at_sides(around) || !has_size()) return std::nullopt;
    if (!set_depth(around) || !hides_all()) return std::nullopt;
    return ends_;
  }

 private:
  /// Rests the face on the plane on which it stands. False if there is none, or if it ends at
  /// several, as the inner walls of a tray do.
  bool stands() {
    int resting = 0;
    for (int axis = 1; axis < 3; ++axis) {
      for (int upper = 0; upper < 2; ++upper) {
        BoxEnd& end = ends_[axis][upper];
        flat_[axis - 1] += end.at;
        if (end.seen) end = rest(end, axis, upper);
        if (!end.rests) continue;
        ++resting;
        foot_ = {axis, upper, end.at};
      }
    }
    return resting == 1;
  }

  /// Moves an end onto a plane next to it. The face may as well end anywhere on the way there.
  BoxEnd rest(const BoxEnd& end, int axis, int upper) const {
    BoxEnd on_plane = rested(draft_, planes_, end, axis, upper, kMaxFootGap + face_.tolerance());
    on_plane.std = std::hypot(on_plane.std, uniform_std(on_plane.at - end.at));
    return on_plane;
  }

  /// The three edges on which the face does not stand.
  std::vector<LoneEdge> free_edges() const {
    std::vector<LoneEdge> edges;
    for (int axis = 1; axis < 3; ++axis) {
      for (int upper = 0; upper < 2; ++upper) {
        const bool is_foot = axis == foot_.axis && upper == foot_.upper;
        if (!is_foot) edges.push_back({axis, upper, ends_[axis][upper].at});
      }
    }
    return edges;
  }

  /// Moves the ends to the sides that begin at the edges. False if an edge was not seen, if
  /// something touches the upper one, or if the surface goes on beyond.
  bool end_at_sides(const AroundFace& around) {
    std::vector<LoneEdge> unseen;
    double radius = 0.0;
    for (const LoneEdge& edge : free_edges()) {
      BoxEnd& end = ends_[edge.axis][edge.upper];
      const BesideEdge beside = around.beside(edge);
      const bool is_top = edge.axis == foot_.axis;
      if (!end.seen || beside.goes_on || (is_top && !beside.free)) return false;
      if (!beside.side) {
        unseen.push_back(edge);
        continue;
      }
      end.at += *beside.side;
      end.std = std::hypot(end.std, beside.spread);
      radius = std::max(radius, radius_of(*beside.side));
    }
    for (const LoneEdge& edge : unseen) add_hidden(edge, radius);
    return true;
  }

  /// Radius of an edge from how far beyond it the side lies [m]. The face seems to end where the
  /// edge leaves its tolerance δ, so this is r − √(δ(2r − δ)), as in Outline::hidden().
  double radius_of(double side) const {
    if (side <= 0.0) return 0.0;
    const double tolerance = face_.tolerance();
    return std::min(kMaxRadius, side + tolerance + std::sqrt(2.0 * tolerance * side));
  }

  /// Adds what the rounding hides of an edge beyond which no side was seen. It likely is as round
  /// as the roundest edge that was seen, or sharp if none was, but may be as round as any.
  void add_hidden(const LoneEdge& edge, double radius) {
    const Eigen::Vector3d out_C = draft_.out_C(edge.axis, edge.upper);
    const Outline outline{&face_, edge.axis, edge.upper, out_C, {}};
    BoxEnd& end = ends_[edge.axis][edge.upper];
    end.hidden = outline.hidden(radius, *draft_.sight);
    end.may_reach = std::max(0.0, outline.hidden(kMaxRadius, *draft_.sight) - end.hidden);
    end.at += end.hidden;
    end.std = std::hypot(end.std, kUnsureShare * end.hidden);
  }

  bool has_size() const {
    const Eigen::Vector3d size = seen_part(ends_).sizes();
    for (int axis = 1; axis < 3; ++axis) {
      const double doubt = std::hypot(ends_[axis][0].std, ends_[axis][1].std);
      if (!(size[axis] <= kMaxFaceSide && doubt <= kMaxDoubt * size[axis])) return false;
      if (flat_[axis - 1] < kMinFlat * size[axis]) return false;
    }
    return true;
  }

  /// Sets the end behind the face as the surest edge shows it. False if no edge bounds the depth,
  /// or if one shows that the face is that of a sheet. Lines over the upper edge must be sure that
  /// it is none: seen obliquely from above, the wall of an open box looks as if it were a pixel
  /// thick.
  bool set_depth(const AroundFace& around) {
    std::optional<DepthPastEdge> surest;
    double seen = 0.0;
    for (const LoneEdge& edge : free_edges()) {
      const auto depth = around.depth_past(edge);
      if (!depth) continue;
      const bool is_top = edge.axis == foot_.axis;
      const double least = kRounding + (is_top ? depth->unsure : 0.0);
      if (depth->bound < least) return false;
      if (!surest || depth->unsure < surest->unsure) surest = depth;
      seen = std::max(seen, depth->seen);
    }
    if (!surest || surest->bound < kRounding + surest->unsure) return false;
    BoxEnd& back = ends_[0][0];
    back.at += seen;
    ends_ = bounded(draft_, planes_, ends_);
    // Lines of sight pass the rounding of the farther edge. It is between none and the most, and so
    // is what the box is deeper than they tell.
    const double likely = surest->bound + 0.5 * kRounding;
    back.likely = std::clamp(likely - seen, 0.0, back.may_reach);
    return true;
  }

  /// True if nothing but strays was seen in or through the likely box.
  bool hides_all() const {
    Eigen::AlignedBox3d likely_A = seen_part(ends_);
    likely_A.min()[0] -= ends_[0][0].likely;
    const auto points_C = draft_.sight->points_towards(draft_.corners_C(likely_A), 0.0);
    return count_seen_within(draft_.core_A(likely_A), draft_.X_CA(), points_C, *draft_.sight) <=
           draft_.max_strays();
  }

  const BoxDraft& draft_;
  const Face& face_;
  const std::vector<const Detection*>& planes_;
  BoxEnds ends_;
  /// Sizes of the flat part along axes 1 and 2 [m].
  std::array<double, 2> flat_ = {0.0, 0.0};
  LoneEdge foot_;
};

}  // namespace

std::optional<BoxEnds> find_upright_ends(const BoxDraft& draft,
                                         const std::vector<const Detection*>& planes,
                                         const BoxEnds& ends) {
  // Only a single view has lines of sight.
  if (!draft.sight->single()) return std::nullopt;
  return UprightFace(draft, planes, ends).find();
}

}  // namespace quadrille
