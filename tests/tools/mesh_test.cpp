#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/surface_mesh.hpp"
#include "support/catch.hpp"

using namespace quadrille;

namespace {

Detection sphere_of(double radius, const Eigen::Vector3d& centre, double cut) {
  Detection d;
  d.type = QuadricType::kSphere;
  Vector10d q;
  q << 1, 1, 1, 0, 0, 0, -centre.x(), -centre.y(), -centre.z(),
      centre.squaredNorm() - radius * radius;
  d.Q_C = Quadric(q).normalized();
  d.X_CQ = Eigen::Translation3d(centre);
  d.extent_Q = Eigen::AlignedBox3d(Eigen::Vector3d(-radius, -radius, cut),
                                   Eigen::Vector3d::Constant(radius));
  return d;
}

double area_of(const Mesh& mesh) {
  double area = 0.0;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3f a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
    area += 0.5 * (b - a).cross(c - a).norm();
  }
  return area;
}

}  // namespace

TEST_CASE("the mesh of a whole sphere is closed, lies on it and has its area", "[mesh]") {
  const double radius = 0.05;
  const Mesh mesh = mesh_of(sphere_of(radius, {0.1, -0.2, 0.8}, -radius));
  for (const Eigen::Vector3f& p : mesh.vertices) CHECK(p.norm() == Approx(radius).epsilon(1e-4));
  CHECK(mesh.rims.empty());
  // Euler's formula for a closed surface without handles.
  CHECK(mesh.vertices.size() - mesh.triangles.size() / 2 == 2);
  CHECK(area_of(mesh) == Approx(4 * std::numbers::pi * radius * radius).epsilon(0.02));
}

TEST_CASE("the mesh of half a sphere ends at a circle", "[mesh]") {
  const double radius = 0.05;
  const Mesh mesh = mesh_of(sphere_of(radius, {0.1, -0.2, 0.8}, 0.0));
  CHECK(area_of(mesh) == Approx(2 * std::numbers::pi * radius * radius).epsilon(0.04));
  double length = 0.0;
  for (const auto& [a, b] : mesh.rims) {
    length += (mesh.vertices[a] - mesh.vertices[b]).norm();
    // The extent is grown by a hundredth of its longest side.
    CHECK(std::abs(mesh.vertices[a].z()) < 0.02 * 2 * radius);
  }
  CHECK(length == Approx(2 * std::numbers::pi * radius).epsilon(0.02));
}

TEST_CASE("vertices lie on the quadric, and triangles turn their front to the gradient's side",
          "[mesh]") {
  Vector10d saddle = Vector10d::Zero(), neck = Vector10d::Zero();
  saddle[0] = 5.0, saddle[1] = -3.0, saddle[8] = -0.5;
  neck.head<3>() = Eigen::Vector3d(1, 1, -0.5);
  neck[9] = -0.01;
  for (const Vector10d& q : {saddle, neck}) {
    Detection d;
    d.Q_C = Quadric(q);
    d.extent_Q = {Eigen::Vector3d(-0.2, -0.15, -0.1), Eigen::Vector3d(0.2, 0.15, 0.1)};
    const Mesh mesh = mesh_of(d, 12);
    REQUIRE(mesh.triangles.size() > 100);
    double farthest = 0.0;
    for (const Eigen::Vector3f& v : mesh.vertices) {
      farthest = std::max(farthest, std::abs(d.Q_C.value(v.cast<double>())));
    }
    CHECK(farthest < 1e-7);
    for (const auto& t : mesh.triangles) {
      const Eigen::Vector3f a = mesh.vertices[t[0]], b = mesh.vertices[t[1]],
                            c = mesh.vertices[t[2]];
      const Eigen::Vector3d middle = (a + b + c).cast<double>() / 3.0;
      CHECK((b - a).cross(c - a).cast<double>().dot(d.Q_C.gradient(middle)) > -1e-9);
    }
  }
}

TEST_CASE("a detection without extent or with numbers that are none has no mesh",
          "[mesh][hostile]") {
  Detection d = sphere_of(0.05, {0, 0, 1}, -0.05);
  d.extent_Q.setEmpty();
  CHECK(mesh_of(d).triangles.empty());
  d = sphere_of(0.05, {0, 0, 1}, -0.05);
  d.extent_Q.max().x() = std::nan("");
  CHECK(mesh_of(d).triangles.empty());
  d = sphere_of(std::nan(""), {0, 0, 1}, -0.05);
  CHECK(mesh_of(d).triangles.empty());
}

TEST_CASE("the outline of points in a square is the square", "[mesh]") {
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i <= 10; ++i) {
    for (int j = 0; j <= 10; ++j) points.push_back({0.1 * i, 0.1 * j});
  }
  const Mesh mesh = mesh_of_outline(points);
  CHECK(mesh.vertices.size() == 4);
  CHECK(area_of(mesh) == Approx(1.0));
  CHECK(mesh_of_outline({{0, 0}, {1, 1}, {2, 2}}).triangles.empty());
  CHECK(mesh_of_outline({}).triangles.empty());
}
