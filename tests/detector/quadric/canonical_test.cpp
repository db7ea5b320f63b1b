#include "base/random.hpp"
#include "quadrille/detector/quadric.hpp"
#include "support/catch.hpp"

using quadrille::canonical_form;
using quadrille::CanonicalForm;
using quadrille::from_canonical;
using quadrille::Quadric;
using quadrille::QuadricType;
using quadrille::RandomStream;

namespace {

Eigen::Isometry3d random_pose(RandomStream& random) {
  const auto u = [&] { return 2.0 * random.uniform() - 1.0; };
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = Eigen::Quaterniond(u(), u(), u(), u()).normalized().toRotationMatrix();
  X.translation() = Eigen::Vector3d(u(), u(), u());
  return X;
}

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return a.cross(b).norm();
}

/// All real types with dimensions in the canonical order.
std::vector<CanonicalForm> examples() {
  using T = QuadricType;
  const Eigen::Isometry3d I = Eigen::Isometry3d::Identity();
  return {
      {T::kSphere, I, {{"radius", 0.7}}},
      {T::kEllipsoid, I, {{"a", 1.2}, {"b", 0.8}, {"c", 0.5}}},
      {T::kEllipsoid, I, {{"a", 0.5}, {"b", 0.5}, {"c", 0.9}}},
      {T::kEllipsoid, I, {{"a", 0.9}, {"b", 0.9}, {"c", 0.4}}},
      {T::kCylinder, I, {{"radius", 0.4}}},
      {T::kEllipticCylinder, I, {{"a", 0.9}, {"b", 0.4}}},
      {T::kCone, I, {{"half_angle", 0.3}}},
      {T::kEllipticCone, I, {{"half_angle_a", 0.6}, {"half_angle_b", 0.3}}},
      {T::kEllipticParaboloid, I, {{"focal_a", 0.5}, {"focal_b", 0.2}}},
      {T::kEllipticParaboloid, I, {{"focal_a", 0.3}, {"focal_b", 0.3}}},
      {T::kHyperbolicParaboloid, I, {{"focal_a", 0.5}, {"focal_b", 0.2}}},
      {T::kHyperboloidOneSheet, I, {{"a", 0.6}, {"b", 0.5}, {"c", 0.9}}},
      {T::kHyperboloidTwoSheets, I, {{"a", 0.6}, {"b", 0.5}, {"c", 0.9}}},
      {T::kHyperbolicCylinder, I, {{"a", 0.6}, {"b", 0.5}}},
      {T::kParabolicCylinder, I, {{"focal", 0.4}}},
      {T::kPlane, I, {}},
      {T::kParallelPlanes, I, {{"distance", 0.6}}},
      {T::kIntersectingPlanes, I, {{"angle", 0.8}}},
      {T::kCoincidentPlanes, I, {}},
  };
}

}  // namespace

TEST_CASE("each real type comes back from its quadric in any pose, scale and sign",
          "[canonical][law]") {
  RandomStream random(7, 0);
  for (const CanonicalForm& example : examples()) {
    for (int trial = 0; trial < 20; ++trial) {
      CanonicalForm form = example;
      form.X = random_pose(random);
      const double factor = trial % 2 ? -3.7 : 0.2;
      const Quadric Q(Eigen::Matrix4d(factor * from_canonical(form).matrix()));
      const CanonicalForm found = canonical_form(Q, 1e-8);
      CAPTURE(to_string(form.type), trial);
      REQUIRE(found.type == form.type);
      REQUIRE(found.dimensions.size() == form.dimensions.size());
      for (std::size_t i = 0; i < form.dimensions.size(); ++i) {
        CHECK(found.dimensions[i].first == form.dimensions[i].first);
        CHECK(found.dimensions[i].second == Approx(form.dimensions[i].second).epsilon(1e-6));
      }
      CHECK(found.X.linear().determinant() == Approx(1.0));
      // The form describes the same surface.
      const Eigen::Matrix4d a = from_canonical(found).normalized().matrix();
      const Eigen::Matrix4d b = Q.normalized().matrix();
      CHECK(std::min((a - b).norm(), (a + b).norm()) < 1e-6);
    }
  }
}

TEST_CASE("the canonical z axis is the axis of revolution or of the cylinder", "[canonical]") {
  RandomStream random(8, 0);
  for (const CanonicalForm& example : examples()) {
    CanonicalForm form = example;
    form.X = random_pose(random);
    const CanonicalForm found = canonical_form(from_canonical(form), 1e-8);
    if (form.type == QuadricType::kSphere) continue;
    CAPTURE(to_string(form.type));
    CHECK(angle_between(found.X.linear().col(2), form.X.linear().col(2)) < 1e-6);
  }
}

TEST_CASE("the imaginary types are told apart by rank and signature", "[canonical]") {
  const auto type_of = [](double a, double b, double c, double d) {
    return canonical_form(Quadric(Eigen::Matrix4d(Eigen::Vector4d(a, b, c, d).asDiagonal()))).type;
  };
  CHECK(type_of(1, 2, 3, 1) == QuadricType::kImaginaryEllipsoid);
  CHECK(type_of(1, 2, 3, 0) == QuadricType::kImaginaryCone);
  CHECK(type_of(1, 2, 0, 1) == QuadricType::kImaginaryEllipticCylinder);
  CHECK(type_of(1, 0, 0, 1) == QuadricType::kImaginaryParallelPlanes);
  CHECK(type_of(1, 2, 0, 0) == QuadricType::kImaginaryIntersectingPlanes);
  CHECK(type_of(-1, -2, -3, -1) == QuadricType::kImaginaryEllipsoid);
}

TEST_CASE("a zero, constant or NaN matrix has no canonical form", "[canonical][degenerate]") {
  CHECK_THROWS_AS(canonical_form(Quadric()), std::invalid_argument);
  Eigen::Matrix4d constant = Eigen::Matrix4d::Zero();
  constant(3, 3) = 1.0;
  CHECK_THROWS_AS(canonical_form(Quadric(constant)), std::invalid_argument);
  CHECK_THROWS_AS(canonical_form(Quadric(Eigen::Matrix4d(Eigen::Matrix4d::Constant(NAN)))),
                  std::invalid_argument);
}
