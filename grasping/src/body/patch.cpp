#include "body/patch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "body/geometry.hpp"
#include "body/polyhedron.hpp"

namespace quadrille {
namespace {

// Depth by which shapes of curved patches and pairs of planes extend behind the surface that was
// seen [m].
constexpr double kDepthBehind = 0.01;
// Largest gap between the blocks of a curved patch and its surface [m]. Blocks are made small
// enough for this, but there are at most so many along either side.
constexpr double kMaxSagitta = 0.0005;
constexpr int kMaxCells = 10;

/// A surface written as the graph h(u, v) over two axes of frame Q, within an interval of each.
struct Graph {
  int u_axis, v_axis, h_axis;
  // The height h at (u, v), its slopes, and the largest distances of the surface below and above
  // its tangent plane at the middle of a cell of these half sizes.
  virtual double value(double u, double v) const = 0;
  virtual Eigen::Vector2d slope(double u, double v) const = 0;
  virtual Eigen::Vector2d beside(double u, double half_u, double half_v) const = 0;
  // Half sizes of a cell that keep the sagitta within its limit.
  virtual Eigen::Vector2d cell() const = 0;
  Graph(int u, int v, int h) : u_axis(u), v_axis(v), h_axis(h) {}
  virtual ~Graph() = default;
};

/// The graph h = u²/4fa − v²/4fb, which is a parabolic cylinder if fb is infinite. Its distance
/// from its tangent plane is du²/4fa − dv²/4fb.
struct Saddle : Graph {
  double fa, fb;
  Saddle(double focal_a, double focal_b) : Graph(0, 1, 2), fa(focal_a), fb(focal_b) {}
  double value(double u, double v) const override {
    return u * u / (4.0 * fa) - v * v / (4.0 * fb);
  }
  Eigen::Vector2d slope(double u, double v) const override {
    return {u / (2.0 * fa), -v / (2.0 * fb)};
  }
  Eigen::Vector2d beside(double, double half_u, double half_v) const override {
    return {half_v * half_v / (4.0 * fb), half_u * half_u / (4.0 * fa)};
  }
  Eigen::Vector2d cell() const override {
    return {std::sqrt(4.0 * fa * kMaxSagitta), std::sqrt(4.0 * fb * kMaxSagitta)};
  }
};

/// One branch of a hyperbolic cylinder: x = ±a√(1 + y²/b²), whose second derivative is at most
/// a/b². The branch is convex or concave, so it is farthest from its tangent at an end of a cell.
struct Branch : Graph {
  double side, a, b;
  Branch(double sign, double semi_a, double semi_b)
      : Graph(1, 2, 0), side(sign), a(semi_a), b(semi_b) {}
  double value(double u, double) const override { return side * a * std::hypot(1.0, u / b); }
  Eigen::Vector2d slope(double u, double) const override {
    return {side * a * u / (b * b * std::hypot(1.0, u / b)), 0.0};
  }
  Eigen::Vector2d beside(double u, double half_u, double) const override {
    const double tangent = slope(u, 0.0).x() * half_u;
    const double rise = std::max(side * (value(u + half_u, 0.0) - value(u, 0.0) - tangent),
                                 side * (value(u - half_u, 0.0) - value(u, 0.0) + tangent));
    return side > 0.0 ? Eigen::Vector2d(0.0, rise) : Eigen::Vector2d(rise, 0.0);
  }
  Eigen::Vector2d cell() const override {
    return {b * std::sqrt(2.0 * kMaxSagitta / a), std::numeric_limits<double>::infinity()};
  }
};

/// Makes a block along the tangent plane that holds the graph over one cell.
CollisionShape block_of(const Graph& g, const Detection& d, const Eigen::Vector2d& middle,
                        const Eigen::Vector2d& half) {
  const double h = g.value(middle.x(), middle.y());
  const Eigen::Vector2d slope = g.slope(middle.x(), middle.y());
  const Eigen::Vector2d beside = g.beside(middle.x(), half.x(), half.y());
  Eigen::Vector3d p_Q, along_Q = Eigen::Vector3d::Unit(g.h_axis);
  p_Q[g.u_axis] = middle.x();
  p_Q[g.v_axis] = middle.y();
  p_Q[g.h_axis] = h;
  const bool from_above = d.Q_C.gradient(d.X_CQ * p_Q).dot(d.X_CQ.linear() * along_Q) >= 0.0;
  const double low = -beside.x() - (from_above ? kDepthBehind : 0.0);
  const double high = beside.y() + (from_above ? 0.0 : kDepthBehind);
  std::array<Eigen::Vector3d, 8> corners;
  for (unsigned n = 0; n < 8; ++n) {
    const Eigen::Vector2d step((n & 2) ? half.x() : -half.x(), (n & 4) ? half.y() : -half.y());
    corners[n][g.u_axis] = middle.x() + step.x();
    corners[n][g.v_axis] = middle.y() + step.y();
    corners[n][g.h_axis] = h + slope.dot(step) + ((n & 1) ? high : low);
  }
  // FCL requires centred shapes.
  Eigen::Isometry3d X_CS = d.X_CQ;
  X_CS.translation() = d.X_CQ * p_Q;
  for (Eigen::Vector3d& corner : corners) corner -= p_Q;
  CollisionShape shape = make_block(corners, X_CS);
  shape.excess = kDepthBehind + beside.sum();
  return shape;
}

std::vector<CollisionShape> blocks_of(const Graph& g, const Detection& d) {
  const Eigen::AlignedBox3d& box = d.extent_Q;
  const Eigen::Vector2d low(box.min()[g.u_axis], box.min()[g.v_axis]);
  const Eigen::Vector2d size(box.sizes()[g.u_axis], box.sizes()[g.v_axis]);
  Eigen::Vector2i count;
  for (int i = 0; i < 2; ++i) {
    count[i] = 1 + static_cast<int>(std::min<double>(kMaxCells - 1, 0.5 * size[i] / g.cell()[i]));
  }
  const Eigen::Vector2d half = 0.5 * size.cwiseQuotient(count.cast<double>());
  std::vector<CollisionShape> shapes;
  for (int j = 0; j < count.y(); ++j) {
    for (int i = 0; i < count.x(); ++i) {
      const Eigen::Vector2d middle =
          low + half.cwiseProduct(Eigen::Vector2d(2.0 * i + 1.0, 2.0 * j + 1.0));
      shapes.push_back(block_of(g, d, middle, half));
    }
  }
  return shapes;
}

/// Makes a slab from low to high along z of its frame.
CollisionShape slab(const Eigen::Isometry3d& X_CP, Eigen::AlignedBox3d box, double low,
                    double high) {
  box.min().z() = low;
  box.max().z() = high;
  CollisionShape shape = make_box(X_CP, box);
  shape.excess = std::max(-low, high);
  return shape;
}

CollisionShape plane_slab(const Detection& d) {
  const double thickness =
      std::clamp(0.25 * d.extent_Q.sizes().head<2>().minCoeff(), kDepthBehind, 0.1);
  return slab(d.X_CQ, d.extent_Q, -thickness, 0.0);
}

/// Makes a slab for half of one of two planes that meet in the z axis of Q: from that axis along
/// unit direction u_Q, within the extent. Nullopt if the half plane misses the extent.
std::optional<CollisionShape> half_slab(const Detection& d, const Eigen::Vector3d& u_Q) {
  const Eigen::AlignedBox3d& box = d.extent_Q;
  double from = 0.0, to = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 2; ++i) {
    if (u_Q[i] == 0.0) {
      if (box.min()[i] > 0.0 || box.max()[i] < 0.0) return std::nullopt;
      continue;
    }
    const double t0 = box.min()[i] / u_Q[i], t1 = box.max()[i] / u_Q[i];
    from = std::max(from, std::min(t0, t1));
    to = std::min(to, std::max(t0, t1));
  }
  if (!(to > from)) return std::nullopt;
  Eigen::Isometry3d X_QP = Eigen::Isometry3d::Identity();  // x along u, y along z of Q
  X_QP.linear() << u_Q, Eigen::Vector3d::UnitZ(), u_Q.cross(Eigen::Vector3d::UnitZ());
  const Eigen::Isometry3d X_CP = d.X_CQ * X_QP;
  const Eigen::AlignedBox3d face(Eigen::Vector3d(from, box.min().z(), 0.0),
                                 Eigen::Vector3d(to, box.max().z(), 0.0));
  const Eigen::Vector3d middle_C = X_CP * Eigen::Vector3d(face.center());
  const bool from_above = d.Q_C.gradient(middle_C).dot(X_CP.linear().col(2)) >= 0.0;
  return slab(X_CP, face, from_above ? -kDepthBehind : 0.0, from_above ? 0.0 : kDepthBehind);
}

bool sound(const Detection& d) {
  const Eigen::Vector3d sizes = d.extent_Q.sizes();
  if (!d.X_CQ.matrix().allFinite() || !sizes.allFinite()) return false;
  if (!(sizes.maxCoeff() < 100.0) || !(d.extent_Q.min().cwiseAbs().maxCoeff() < 100.0))
    return false;
  const auto positive = [&](int axis) { return sizes[axis] > 0.0; };
  switch (d.type) {
    case QuadricType::kHyperbolicCylinder:
      return positive(1) && positive(2);
    case QuadricType::kIntersectingPlanes:
      return positive(2);
    default:
      return positive(0) && positive(1);
  }
}

bool sound_sizes(double a, double b) {
  return a > 1e-5 && a < 100.0 && b > 1e-5 && (b < 100.0 || std::isinf(b));
}

std::vector<CollisionShape> curved(const Detection& d) {
  const double a = d.dimension(0);
  const double b = d.type == QuadricType::kParabolicCylinder
                       ? std::numeric_limits<double>::infinity()
                       : d.dimension(1);
  if (!sound_sizes(a, b)) return {};
  if (d.type != QuadricType::kHyperbolicCylinder) return blocks_of(Saddle(a, b), d);
  std::vector<CollisionShape> shapes;
  if (d.extent_Q.max().x() > 0.0) shapes = blocks_of(Branch(1.0, a, b), d);
  if (d.extent_Q.min().x() < 0.0) {
    const std::vector<CollisionShape> others = blocks_of(Branch(-1.0, a, b), d);
    shapes.insert(shapes.end(), others.begin(), others.end());
  }
  return shapes;
}

std::vector<CollisionShape> plane_pair(const Detection& d) {
  const double half = 0.5 * d.dimension(0);
  if (!(half >= 0.0 && half < 3.2)) return {};
  std::vector<CollisionShape> shapes;
  for (const double side : {1.0, -1.0}) {
    for (const double turn : {half, -half}) {
      const Eigen::Vector3d u_Q = side * Eigen::Vector3d(std::cos(turn), std::sin(turn), 0.0);
      if (const auto slab = half_slab(d, u_Q)) shapes.push_back(*slab);
    }
  }
  return shapes;
}

}  // namespace

CollisionShape make_box(const Eigen::Isometry3d& X_CQ, const Eigen::AlignedBox3d& box_Q) {
  CollisionShape shape;
  shape.kind = "box";
  shape.X_CS = X_CQ;
  shape.X_CS.translation() = X_CQ * Eigen::Vector3d(box_Q.center());
  const Eigen::Vector3d sides = box_Q.sizes();
  shape.dimensions = {sides.x(), sides.y(), sides.z()};
  set_geometry(shape);
  return shape;
}

std::vector<CollisionShape> make_patch(const Detection& detection) {
  if (!sound(detection)) return {};
  switch (detection.type) {
    case QuadricType::kPlane:
      return {plane_slab(detection)};
    case QuadricType::kCoincidentPlanes:  // the gradient is zero, so that the seen side is unknown
      return {slab(detection.X_CQ, detection.extent_Q, -kDepthBehind, kDepthBehind)};
    case QuadricType::kIntersectingPlanes:
      return plane_pair(detection);
    case QuadricType::kHyperbolicParaboloid:
    case QuadricType::kHyperbolicCylinder:
    case QuadricType::kParabolicCylinder:
      return curved(detection);
    default:
      return {};
  }
}

}  // namespace quadrille
