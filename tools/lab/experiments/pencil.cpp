#include <fmt/format.h>

#include <array>
#include <cmath>

#include "lab/experiments/experiments.hpp"
#include "lab/experiments/random_quadric.hpp"
#include "lab/experiments/section.hpp"
#include "variants/gradient_scales.hpp"

namespace quadrille::experiments {
namespace {

using Eigen::Vector3d;

/// The values of λ span the range of the paper's figure.
constexpr std::array kLambdas = {-75.0, -5.0, -1.0, 0.0, 5.0, 75.0};
constexpr int kSlices = 13;
/// Distance between the centres of the drawn balls.
constexpr double kApart = 2.2;

/// Three exact oriented points of an ellipsoid. Their triangle is large, and its plane does not
/// pass through the centre.
struct ExactBasis {
  Quadric Q;
  std::array<OrientedPoint, 3> points;
};

ExactBasis exact_basis(std::uint64_t seed) {
  RandomStream random(seed, 0);
  const Quadric Q = random_quadric(QuadricType::kEllipsoid, random);
  while (true) {
    const OrientedPointsd some = sample(Q, 3, random);
    const Vector3d m = (some.points.col(1) - some.points.col(0))
                           .cross(Vector3d(some.points.col(2) - some.points.col(0)));
    const double height = std::abs(m.normalized().dot(some.points.col(0)));
    if (m.norm() > 0.6 && height > 0.1 && height < 0.3) {
      return {Q, {some.at(0), some.at(1), some.at(2)}};
    }
  }
}

/// Returns the λ at which a quadric lies in the pencil, which is that of any of its points.
double lambda_of(const Pencil& pencil, const Quadric& Q, RandomStream& random) {
  const OrientedPointsd points = sample(Q, 20, random);
  double lambda = 0.0, most = 0.0;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const Eigen::Vector4d X = points.points.col(i).homogeneous();
    const double z = pencil.plane.dot(X);
    if (std::abs(z) <= most) continue;
    most = std::abs(z);
    lambda = -X.dot(pencil.Q0 * X) / (z * z);
  }
  return lambda;
}

/// An orthographic view from a direction.
struct Eye {
  Vector3d towards, right, up;

  Eye(const Vector3d& from, const Vector3d& above)
      : towards(from.normalized()),
        right(above.cross(towards).normalized()),
        up(towards.cross(right)) {}
  std::pair<double, double> at(const Vector3d& x, double shift_x, double shift_y) const {
    return {right.dot(x) + shift_x, up.dot(x) + shift_y};
  }
  /// Returns whether the surface itself, within the unit ball, hides one of its points.
  bool is_hidden(const Quadric& Q, const Vector3d& x) const {
    // Along the line of sight, Q is t (b + t a).
    const double b = towards.dot(Q.gradient(x));
    const double a = towards.dot(Q.matrix().topLeftCorner<3, 3>() * towards);
    const double t = -b / a;
    return std::isfinite(t) && t > 1e-3 && (x + t * towards).norm() < 1.0;
  }
};

/// Draws the visible pieces of slices across three axes, within the unit ball.
void draw_mesh(const Quadric& Q, const Eigen::Matrix3d& axes, const Eye& eye, double shift_x,
               double shift_y, Series* series) {
  for (const int axis : {0, 1, 2}) {
    const Vector3d u = axes.col((axis + 1) % 3), v = axes.col((axis + 2) % 3);
    for (int k = 0; k < kSlices; ++k) {
      const double height = 1.8 * k / (kSlices - 1.0) - 0.9;
      const SectionPlane plane{height * axes.col(axis), u, v};
      const auto ends = section(Q, plane, 1.0, 100);
      for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
        const Vector3d a = plane.at(ends[i].first, ends[i].second);
        const Vector3d b = plane.at(ends[i + 1].first, ends[i + 1].second);
        if (std::max(a.norm(), b.norm()) > 1.0 || eye.is_hidden(Q, 0.5 * (a + b))) continue;
        series->points.push_back(eye.at(a, shift_x, shift_y));
        series->points.push_back(eye.at(b, shift_x, shift_y));
      }
    }
  }
}

std::string name_of_lambda(double lambda) { return fmt::format("λ = {:.3g}", lambda); }

/// Draws the surfaces side by side, with the basis on each.
Plot meshes(const Pencil& pencil, const ExactBasis& basis) {
  Plot plot{"Surfaces of one pencil, within the unit ball", "", "", {}};
  plot.equal_axes = true;
  Eigen::Matrix3d axes;
  axes.col(2) = pencil.plane.head<3>().normalized();
  axes.col(0) = axes.col(2).unitOrthogonal();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  const Eye eye(axes * Vector3d(0.5, 0.9, 0.7), axes.col(2));
  Series dots{.name = "basis", .points = {}, .drawn = Drawn::kDots};
  for (std::size_t k = 0; k < kLambdas.size(); ++k) {
    const double x = kApart * static_cast<double>(k % 3), y = k < 3 ? kApart : 0.0;
    Series series{.name = name_of_lambda(kLambdas[k]), .points = {}, .drawn = Drawn::kPieces};
    draw_mesh(Quadric(pencil.at(kLambdas[k])), axes, eye, x, y, &series);
    plot.lines.push_back(series);
    for (const OrientedPoint& point : basis.points) dots.points.push_back(eye.at(point.x, x, y));
  }
  plot.lines.push_back(dots);
  return plot;
}

/// Draws all surfaces in the plane through two points of the basis, perpendicular to the plane of
/// all three, where the surfaces touch each other.
Plot fan(const Pencil& pencil, const ExactBasis& basis, double truth) {
  Plot plot{"Section across the plane of the basis",
            "along two points of the basis",
            "across their plane",
            {}};
  plot.equal_axes = true;
  const Vector3d a = basis.points[0].x, b = basis.points[1].x;
  const SectionPlane plane{0.5 * (a + b), (b - a).normalized(),
                           pencil.plane.head<3>().normalized()};
  const auto add = [&](const std::string& name, double lambda, bool dashed) {
    plot.lines.push_back({.name = name,
                          .points = section(Quadric(pencil.at(lambda)), plane, 1.2, 120),
                          .dashed = dashed,
                          .drawn = Drawn::kPieces});
  };
  for (const double lambda : kLambdas) add(name_of_lambda(lambda), lambda, false);
  add(fmt::format("the ellipsoid, {}", name_of_lambda(truth)), truth, true);
  const double half = 0.5 * (b - a).norm();
  plot.lines.push_back({.name = "basis", .points = {{-half, 0}, {half, 0}}, .drawn = Drawn::kDots});
  return plot;
}

}  // namespace

Report run_pencil(const Settings& settings) {
  const ExactBasis basis = exact_basis(settings.seed);
  const auto pencil = make_scaled_pencil(basis.points, 0.0);
  settings.progress(1.0);
  if (!pencil) return {{"The basis leaves no pencil."}, {}, {}, {}};
  RandomStream random(settings.seed, 1);
  const double truth = lambda_of(*pencil, basis.Q, random);
  Report report;
  report.data.columns = {"lambda", "type", "value_at_basis", "sine_of_normals"};
  for (const double lambda : kLambdas) {
    const Quadric Q(pencil->at(lambda));
    double value = 0.0, sine = 0.0;
    for (const OrientedPoint& point : basis.points) {
      value = std::max(value, std::abs(Q.value(point.x)));
      sine = std::max(sine, Q.gradient(point.x).normalized().cross(point.n).norm());
    }
    report.data.row(lambda, to_string(canonical_form(Q).type), value, sine);
  }
  report.findings = {
      fmt::format("Three exact oriented points of an ellipsoid leave a pencil; the "
                  "ellipsoid is at {}. All surfaces touch in the three points.",
                  name_of_lambda(truth))};
  Table table = report.data;
  table.title = "The surfaces";
  report.tables = {table};
  report.plots = {fan(*pencil, basis, truth), meshes(*pencil, basis)};
  return report;
}

}  // namespace quadrille::experiments
