#include "bodies/find_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "bodies/add_lumps.hpp"
#include "bodies/axial_part.hpp"
#include "bodies/support.hpp"
#include "boxes/box_ends.hpp"
#include "boxes/face.hpp"

namespace quadrille {
namespace {

bool contains(const std::vector<int>& list, int value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

std::vector<Eigen::Vector3d> corners_C(const SceneBody& body) {
  std::vector<Eigen::Vector3d> corners;
  for (int n = 0; n < 8; ++n) {
    const Eigen::Vector3d side(n & 1 ? 0.5 : -0.5, n & 2 ? 0.5 : -0.5, n & 4 ? 0.5 : -0.5);
    corners.push_back(body.X_CB * Eigen::Vector3d(side.cwiseProduct(body.size)));
  }
  return corners;
}

/// Groups detections into bodies.
class BodyMaker {
 public:
  explicit BodyMaker(const BodySources& found) : found_(found) {}

  std::vector<SceneBody> make() {
    for (const Detection& d : found_.detections) last_id_ = std::max(last_id_, d.id);
    for (const Box& box : found_.boxes) add_box(box);
    add_revolved();
    for (const Detection& d : found_.detections) {
      if (is_reported(d) && d.type != QuadricType::kPlane && !contains(parts_, d.id)) add_single(d);
    }
    add_small_planes();
    supports_ = supports_of(found_.detections, parts_, found_.places_C);
    for (SceneBody& body : bodies_) {
      body.standing_on = standing_on(supports_, corners_C(body));
      if (body.standing_on && is_long(body)) stand(&body);
    }
    if (found_.all_types) add_lumps(found_, supports_, last_id_, &bodies_);
    std::stable_sort(bodies_.begin(), bodies_.end(),
                     [](const SceneBody& a, const SceneBody& b) { return a.id < b.id; });
    return std::move(bodies_);
  }

 private:
  const Detection* detection(int id) const {
    const auto found = std::find_if(found_.detections.begin(), found_.detections.end(),
                                    [&](const Detection& d) { return d.id == id; });
    return found == found_.detections.end() ? nullptr : &*found;
  }

  void add(SceneBody body) {
    for (const int id : body.parts) {
      if (const Detection* d = detection(id)) body.points += d->inliers;
    }
    parts_.insert(parts_.end(), body.parts.begin(), body.parts.end());
    bodies_.push_back(std::move(body));
  }

  void add_box(const Box& box) {
    last_id_ = std::max(last_id_, box.id);
    parts_.insert(parts_.end(), box.faces.begin(), box.faces.end());
    if (!is_reported(box)) return;
    SceneBody body;
    body.id = box.id;
    body.kind = BodyKind::kBox;
    body.parts = box.faces;
    body.X_CB = box.X_CB;
    body.size = box.size;
    body.std = box.std;
    body.seen = box.seen;
    add(std::move(body));
  }

  /// Bodies of surfaces that share an axis, and of single surfaces of revolution with a lid.
  void add_revolved() {
    std::vector<AxialPart> axial;
    for (const Detection& d : found_.detections) {
      if (!is_reported(d) || contains(parts_, d.id)) continue;
      if (const auto part = axial_part(d)) axial.push_back(*part);
    }
    std::stable_sort(axial.begin(), axial.end(), [](const AxialPart& a, const AxialPart& b) {
      return a.detection->inliers > b.detection->inliers;
    });
    std::map<int, std::vector<const AxialPart*>> groups;
    const std::vector<int> group = groups_of(axial);
    for (std::size_t k = 0; k < axial.size(); ++k) groups[group[k]].push_back(&axial[k]);
    for (const auto& [number, parts] : groups) {
      const std::vector<int> lids = lids_of(parts);
      if (parts.size() + lids.size() > 1) add(revolved(parts, lids));
    }
  }

  std::vector<int> lids_of(const std::vector<const AxialPart*>& parts) const {
    std::vector<int> lids;
    for (const Detection& d : found_.detections) {
      if (d.type != QuadricType::kPlane || !is_reported(d) || contains(parts_, d.id)) continue;
      const bool closes = std::any_of(parts.begin(), parts.end(),
                                      [&](const AxialPart* part) { return is_lid(d, *part); });
      if (closes) lids.push_back(d.id);
    }
    return lids;
  }

  /// The body of parts about the axis of the first of them that has one.
  SceneBody revolved(const std::vector<const AxialPart*>& parts,
                     const std::vector<int>& lids) const {
    const auto with_axis = std::find_if(
        parts.begin(), parts.end(), [](const AxialPart* part) { return !part->axis_C.isZero(); });
    const AxialPart& main = **(with_axis == parts.end() ? parts.begin() : with_axis);
    SceneBody body;
    body.kind = BodyKind::kRevolution;
    body.id = main.detection->id;
    body.X_CB = main.detection->X_CQ;
    const Eigen::Vector3d z_C = body.X_CB.linear().col(2);
    double low = std::numeric_limits<double>::infinity(), high = -low, radius = 0.0;
    for (const AxialPart* part : parts) {
      const double at = z_C.dot(part->middle_C - main.middle_C);
      low = std::min(low, at - part->half_length);
      high = std::max(high, at + part->half_length);
      if (part->radius > radius) {
        radius = part->radius;
        body.std.head<2>().setConstant(2.0 * radius_std(*part));
      }
      body.parts.push_back(part->detection->id);
    }
    for (const int id : lids) {
      const Detection* lid = detection(id);
      const double at = z_C.dot(lid->X_CQ.translation() - main.middle_C);
      low = std::min(low, at);
      high = std::max(high, at);
      body.parts.push_back(id);
    }
    body.wall = wall_of(body);
    body.X_CB.translation() = main.middle_C + 0.5 * (low + high) * z_C;
    body.size = {2.0 * radius, 2.0 * radius, high - low};
    body.seen[0] = body.seen[1] = std::isfinite(body.std.x());
    set_length(&body, has_lid_at(body, -1.0) && has_lid_at(body, 1.0));
    if (main.axis_C.isZero()) {
      body.std.z() = body.std.x();
      body.seen[2] = body.seen[0];
    }
    return body;
  }

  /// The wall of a body of which both sides are parts; of several the one that is known best.
  std::optional<BodyWall> wall_of(const SceneBody& body) const {
    std::optional<BodyWall> best;
    for (const SeenWall& wall : found_.walls) {
      if (!contains(body.parts, wall.outer) || !contains(body.parts, wall.inner)) continue;
      if (!best || wall.measured.std < best->std) best = wall.measured;
    }
    return best;
  }

  /// True if a lid closes the lower (−1) or upper (1) end of a body.
  bool has_lid_at(const SceneBody& body, double side) const {
    const Eigen::Vector3d end_C = body.X_CB * Eigen::Vector3d(0.0, 0.0, 0.5 * side * body.size.z());
    return std::any_of(body.parts.begin(), body.parts.end(), [&](int id) {
      const Detection* part = detection(id);
      return part != nullptr && part->type == QuadricType::kPlane &&
             std::abs(part->Q_C.distance(end_C)) < std::min(kMaxFootGap, 0.5 * body.size.z());
    });
  }

  /// Says whether the length of a body is known. What lies beyond the ends of its parts may belong
  /// to it too, unless lids or a support close it.
  static void set_length(SceneBody* body, bool closed) {
    body->seen[2] = closed;
    body->std.z() =
        closed ? kMaxFootGap / std::sqrt(12.0) : std::numeric_limits<double>::infinity();
  }

  /// Standard deviation of a part's radius: in proportion to that of its first dimension, which is
  /// a radius, a semi-axis or the angle of a cone [m].
  static double radius_std(const AxialPart& part) {
    const std::vector<Dimension>& dimensions = part.detection->dimensions;
    if (dimensions.empty() || !(dimensions[0].value > 0.0)) {
      return std::numeric_limits<double>::infinity();
    }
    return part.radius * dimensions[0].std / dimensions[0].value;
  }

  void add_single(const Detection& d) {
    SceneBody body;
    body.id = d.id;
    body.parts = {d.id};
    if (const auto part = axial_part(d)) {
      body = revolved({&*part}, {});
      body.kind = BodyKind::kSingle;
    } else {
      body.X_CB = d.X_CQ * Eigen::Translation3d(d.extent_Q.center());
      body.size = d.extent_Q.sizes();
      body.std.setConstant(std::numeric_limits<double>::infinity());
    }
    add(std::move(body));
  }

  /// Planes that are too small for a table or a wall, above a support, such as a face of a box
  /// whose other faces are hidden.
  void add_small_planes() {
    for (const Detection& d : found_.detections) {
      if (d.type != QuadricType::kPlane || !is_reported(d) || contains(parts_, d.id)) continue;
      std::vector<int> others = parts_;
      others.push_back(d.id);
      const std::vector<Support> supports = supports_of(found_.detections, others, {});
      if (d.extent_Q.sizes().maxCoeff() > 0.5 * kMaxSide) continue;
      const Eigen::Vector3d middle_C = d.X_CQ * Eigen::Vector3d(d.extent_Q.center());
      const Support* support = support_below(supports, middle_C);
      if (support == nullptr || support->height(middle_C) < kRounding) continue;
      SceneBody body;
      body.id = d.id;
      body.parts = {d.id};
      body.X_CB = d.X_CQ * Eigen::Translation3d(d.extent_Q.center());
      body.size = d.extent_Q.sizes();
      // Other things may hide its ends.
      body.std.setConstant(std::numeric_limits<double>::infinity());
      add(std::move(body));
    }
  }

  /// True if a body has an axis, unlike a ball, and is no box.
  bool is_long(const SceneBody& body) const {
    if (body.kind == BodyKind::kBox) return false;
    const auto part = body.parts.empty() ? std::nullopt : axial_part(*detection(body.id));
    return part && !part->axis_C.isZero();
  }

  /// Turns the axis of a standing body away from its support, and lets it reach down to it.
  void stand(SceneBody* body) const {
    const auto support = std::find_if(supports_.begin(), supports_.end(),
                                      [&](const Support& s) { return s.id == *body->standing_on; });
    Eigen::Vector3d z_C = body->X_CB.linear().col(2);
    if (std::abs(z_C.dot(support->n_C)) < std::cos(kMaxSkew)) return;
    if (z_C.dot(support->n_C) < 0.0) {
      body->X_CB.linear().col(1) *= -1.0;
      body->X_CB.linear().col(2) *= -1.0;
      z_C = -z_C;
    }
    const double foot = support->height(body->X_CB.translation()) - 0.5 * body->size.z();
    body->size.z() += foot;
    body->X_CB.translation() -= 0.5 * foot * z_C;
    set_length(body, has_lid_at(*body, 1.0));
  }

  const BodySources& found_;
  std::vector<SceneBody> bodies_;
  std::vector<Support> supports_;
  /// Ids of the detections that belong to a body.
  std::vector<int> parts_;
  int last_id_ = 0;
};

}  // namespace

std::vector<SceneBody> find_bodies(const BodySources& found) {
  BodyMaker maker(found);
  return maker.make();
}

}  // namespace quadrille
