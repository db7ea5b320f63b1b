#include "contacts/quality.hpp"

#include <cmath>
#include <limits>

#include "grasping/scenes.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Contacts on the y axis, the normals leaning by these angles about x.
ContactLine line(double width, double lean0, double lean1) {
  ContactLine made;
  made.width = width;
  made.contacts_C = {Eigen::Vector3d(0, 0.5 * width, 0), Eigen::Vector3d(0, -0.5 * width, 0)};
  made.normals_C = {Eigen::Vector3d(0, std::cos(lean0), std::sin(lean0)),
                    Eigen::Vector3d(0, -std::cos(lean1), std::sin(lean1))};
  return made;
}

/// ε by search over wrench directions: the least, over unit u, of the largest of what either
/// contact gives, with soft fingers: h(u) = q·n + √(μ²|q_t|² + γ²(b·n)²), q = a + b × r.
double searched_epsilon(const ContactLine& grasp, const ContactModel& model, std::mt19937& random) {
  double least = std::numeric_limits<double>::infinity();
  const auto value = [&](const Eigen::Matrix<double, 6, 1>& u) {
    double most = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < 2; ++i) {
      const Eigen::Vector3d n = -grasp.normals_C[i];  // pushes inward
      const Eigen::Vector3d a = u.head<3>(), b = u.tail<3>() / model.torque_scale;
      const Eigen::Vector3d q = a + b.cross(grasp.contacts_C[i]);
      const double along = q.dot(n), across = (q - along * n).norm();
      most = std::max(most, along + std::hypot(model.friction * across, model.torsion * b.dot(n)));
    }
    return most;
  };
  for (int n = 0; n < 40; ++n) {
    Eigen::Matrix<double, 6, 1> u;
    for (int i = 0; i < 6; ++i) u[i] = uniform(random, -1, 1);
    u.normalize();
    double best = value(u);
    for (double step = 0.5; step > 1e-7; step *= 0.998) {
      Eigen::Matrix<double, 6, 1> v = u;
      for (int i = 0; i < 6; ++i) v[i] += step * uniform(random, -1, 1);
      v.normalize();
      if (value(v) < best) best = value(u = v);
    }
    least = std::min(least, best);
  }
  return least;
}

}  // namespace

TEST_CASE("the friction needed is the tangent of the larger lean", "[quality]") {
  CHECK(friction_needed(line(0.05, 0.0, 0.0)) == Approx(0.0).margin(1e-12));
  CHECK(friction_needed(line(0.05, 0.2, 0.0)) == Approx(std::tan(0.2)));
  CHECK(friction_needed(line(0.05, 0.1, -0.3)) == Approx(std::tan(0.3)));
  CHECK(std::isinf(friction_needed(line(0.05, 1.6, 0.0))));
  CHECK(std::isinf(friction_needed(line(0.05, 3.1, 0.0))));
}

TEST_CASE("a lean that is not well known may need the friction of a larger one", "[quality]") {
  ContactLine doubted = line(0.04, 0.2, 0.1);
  doubted.lean_std = 0.05;
  CHECK(doubted_friction(doubted) == Approx(std::tan(0.25)));
  // The published friction and quality are those of the lean itself, without its deviation.
  CHECK(friction_needed(doubted) == Approx(std::tan(0.2)));
  CHECK(grasp_epsilon(doubted, {}) == grasp_epsilon(line(0.04, 0.2, 0.1), {}));
  CHECK(doubted_friction(0.3, 0.0) == 0.3);
  CHECK(doubted_friction(std::tan(1.5), 0.1) == std::numeric_limits<double>::infinity());
}

TEST_CASE("the quality of an aligned pair is what a search over all wrenches finds",
          "[quality][slow]") {
  std::mt19937 random(61);
  for (const double width : {0.01, 0.04, 0.09}) {
    for (const double friction : {0.3, 0.8}) {
      const ContactModel model{friction, 0.002, 0.03};
      const double closed = grasp_epsilon(line(width, 0.0, 0.0), model);
      CAPTURE(width, friction);
      CHECK(closed == Approx(searched_epsilon(line(width, 0.0, 0.0), model, random)).epsilon(0.04));
    }
  }
}

TEST_CASE("the quality is bounded by friction or by torsion, whichever gives way first",
          "[quality]") {
  CHECK(grasp_epsilon(line(0.06, 0.0, 0.0), {0.5, 1.0, 0.03}) == Approx(0.5 / std::sqrt(2.25)));
  CHECK(grasp_epsilon(line(0.06, 0.0, 0.0), {0.5, 0.003, 0.03}) == Approx(0.1));
}

TEST_CASE("leaning normals lower the quality, to nothing where the grasp does not close",
          "[quality]") {
  const ContactModel model{0.5, 0.05, 0.05};  // hard to twist: friction decides
  double before = grasp_epsilon(line(0.04, 0.0, 0.0), model);
  for (const double lean : {0.1, 0.2, 0.3, 0.4}) {
    const double now = grasp_epsilon(line(0.04, lean, -lean), model);
    CHECK(now < before);
    before = now;
  }
  CHECK(grasp_epsilon(line(0.04, std::atan(0.5) + 0.01, 0.0), model) == Approx(0.0).margin(1e-12));
}
