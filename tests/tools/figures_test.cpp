#include <cmath>

#include "lab/experiments/ball_scene.hpp"
#include "lab/experiments/experiment.hpp"
#include "lab/experiments/section.hpp"
#include "quadrille/detector/quadric.hpp"
#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using namespace quadrille::experiments;

namespace {

Report quick_figure(std::string_view name) {
  Settings settings;
  settings.quick = true;
  const Report report = find_experiment(name)->run(settings);
  CHECK_FALSE(report.findings.empty());
  REQUIRE_FALSE(report.data.rows.empty());
  return report;
}

Quadric ball_of(double radius) {
  return from_canonical(
      {QuadricType::kSphere, Eigen::Isometry3d::Identity(), {{"radius", radius}}});
}

const SectionPlane kLevel{{0, 0, 0.3}, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()};

}  // namespace

TEST_CASE("the section of a sphere is a circle of known radius and length", "[experiment][plot]") {
  const double radius = std::sqrt(0.5 * 0.5 - 0.3 * 0.3);
  const auto ends = section(ball_of(0.5), kLevel, 1.0);
  REQUIRE(ends.size() > 50);
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
    for (const auto& [a, b] : {ends[i], ends[i + 1]}) {
      CHECK(std::hypot(a, b) == Approx(radius).epsilon(1e-12));
    }
    length += std::hypot(ends[i].first - ends[i + 1].first, ends[i].second - ends[i + 1].second);
  }
  CHECK(length == Approx(2.0 * M_PI * radius).epsilon(1e-3));
  CHECK(section(ball_of(0.29), kLevel, 1.0).empty());
}

TEST_CASE("a section has all branches, a plane's is a straight line", "[experiment][plot]") {
  // x² − y² = .04: two branches, on both sides.
  Vector10d q = Vector10d::Zero();
  q[0] = 1, q[1] = -1, q[9] = -0.04;
  int left = 0, right = 0;
  for (const auto& [a, b] : section(Quadric(q), kLevel, 1.0)) {
    CHECK(a * a - b * b == Approx(0.04).margin(1e-12));
    ++(a < 0.0 ? left : right);
  }
  CHECK(std::abs(left - right) < 10);
  CHECK(left > 40);
  q.setZero();
  q[6] = 0.5, q[9] = -0.25;
  for (const auto& end : section(Quadric(q), kLevel, 1.0)) CHECK(end.first == Approx(0.25));
}

TEST_CASE("all surfaces of a pencil touch in the basis", "[experiment][paper:fig4a]") {
  const Report report = quick_figure("pencil");
  CHECK(report.data.rows.front().front() == "-75");
  CHECK(report.data.rows.back().front() == "75");
  for (const auto& row : report.data.rows) {
    CAPTURE(row[0], row[1]);
    CHECK(std::stod(row[2]) < 1e-12);
    CHECK(std::stod(row[3]) < 1e-9);
  }
  CHECK(report.data.rows.front()[1] == "hyperboloid_one_sheet");
  CHECK(report.data.rows.back()[1] == "ellipsoid");
}

TEST_CASE("votes of a clear basis are where the quadric is", "[experiment][paper:fig3]") {
  const Report report = quick_figure("votes");
  double all = 0.0, votes = 0.0;
  for (const auto& row : report.data.rows) {
    CHECK(std::stod(row[2]) <= std::stod(row[1]));
    all += std::stod(row[1]), votes += std::stod(row[2]);
  }
  CHECK(all > 150);
  CHECK(all <= 300);
  CHECK(votes > 0.4 * all);
  CHECK(test::contains(report.findings.front(), "the quadric is found"));
}

TEST_CASE("drawn fits lie near the truth", "[experiment][paper:fig5]") {
  const Report report = quick_figure("examples");
  CHECK(report.plots.size() == 5);
  for (const auto& row : report.data.rows) {
    CAPTURE(row[0], row[1]);
    // The noise is 3 %.
    CHECK(std::stod(row[2]) < 0.03);
  }
}

TEST_CASE("a quadric that is no plane stands in for two", "[experiment][paper:fig9]") {
  const Report report = quick_figure("planes");
  CHECK(report.data.rows.size() == 3);
  for (const auto& row : report.data.rows) {
    CAPTURE(row[0], row[1]);
    CHECK(std::stod(row[2]) > 0.8 * std::stod(row[3]));
    CHECK_FALSE(test::contains(row[1], "plane"));
  }
}

TEST_CASE("a ball is where its sequence says, all the way", "[experiment][scene]") {
  for (const GeneratedSequence& sequence : ball_sequences()) {
    for (const double time : {0.0, 0.5, 1.0}) {
      CAPTURE(sequence.name, time);
      const BallFrameScene frame = ball_scene(sequence, time, 5);
      const int ball = static_cast<int>(frame.made.ideal.visible.size()) - 1;
      int seen = 0, nearby = 0;
      for (std::size_t i = 0; i < frame.made.view.points.size(); ++i) {
        if (frame.made.view.labels[i] != ball) continue;
        ++seen;
        const double away = (frame.made.view.points[i].cast<double>() - frame.centre_C).norm();
        nearby += away > sequence.axes.minCoeff() - 0.02 && away < sequence.axes.maxCoeff() + 0.02;
      }
      CHECK(seen > 100);
      CHECK(nearby > 0.99 * seen);
    }
  }
}

TEST_CASE("a ball is found within a share of its diameter, whatever the order of its axes",
          "[experiment]") {
  Detection found;
  found.type = QuadricType::kEllipsoid;
  found.dimensions = {{"a", 0.095}, {"b", 0.14}, {"c", 0.095}};
  const Eigen::Vector3d centre(0.1, 0, 1), axes(0.14, 0.095, 0.095);
  const auto at = [&](double x) {
    found.X_CQ.translation() = centre + Eigen::Vector3d(x, 0, 0);
    return is_ball(found, centre, axes, 0.05);
  };
  CHECK(at(0.0));
  CHECK(at(0.0139));
  CHECK_FALSE(at(0.0141));
  found.dimensions[1].value = 0.14 + 0.0141;
  CHECK_FALSE(at(0.0));
  found.type = QuadricType::kSphere;
  found.dimensions = {{"radius", 0.1}};
  CHECK_FALSE(at(0.0));
  CHECK(is_ball(found, found.X_CQ.translation(), {0.1, 0.1, 0.1}, 0.05));
  found.type = QuadricType::kCylinder;
  CHECK_FALSE(is_ball(found, found.X_CQ.translation(), {0.1, 0.1, 0.1}, 0.05));
}

TEST_CASE("each scene of an object asks for that object alone", "[experiment][scene]") {
  const Report report = quick_figure("objects");
  CHECK(report.data.rows.size() == 10);
  int found = 0;
  for (const auto& row : report.data.rows) {
    CAPTURE(row[0], row[1]);
    CHECK(row[2] == "1");
    found += row[3] == "1";
  }
  CHECK(found >= 7);
}
