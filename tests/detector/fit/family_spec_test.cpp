#include "fit/family_spec.hpp"

#include <Eigen/QR>
#include <set>
#include <string>

#include "support/catch.hpp"
#include "support/quadric_points.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("the parameters of a family change its surface in as many ways as it has freedoms",
          "[family][law]") {
  RandomStream random(61, 0);
  std::set<std::string_view> names;
  for (const FamilyExample& example : family_examples()) {
    const FamilySpec& spec = family_spec(example.family);
    CAPTURE(spec.name);
    names.insert(spec.name);
    const ExamplePoints data = make_points(example, 60, 0.0, random);
    const auto size = static_cast<Eigen::Index>(spec.shapes.size() + spec.motions.size());
    // How the distance of points changes: what leaves the surface as it is changes none. A round
    // conic does not feel its rotation, so the pose is that of a generic member.
    Eigen::MatrixXd J(data.points.size(), size);
    for (Eigen::Index k = 0; k < size; ++k) {
      const Eigen::VectorXd step = 1e-5 * Eigen::VectorXd::Unit(size, k);
      const Quadric moved_Q(moved(example.family, data.truth, step).matrix());
      for (Eigen::Index i = 0; i < data.points.size(); ++i) {
        J(i, k) = moved_Q.distance(data.points.at(i).x) / 1e-5;
      }
    }
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(J);
    qr.setThreshold(1e-2);
    CHECK(qr.rank() == spec.dof);
  }
  CHECK(names.size() == kFamilyCount);
}

TEST_CASE("families stand in the order of their degrees of freedom", "[family]") {
  for (int k = 1; k < kFamilyCount; ++k) {
    CHECK(family_spec(static_cast<Family>(k)).dof >= family_spec(static_cast<Family>(k - 1)).dof);
  }
}
