#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "detector/table_scene.hpp"
#include "io/settings/setting_text.hpp"
#include "lab/printed/cluster.hpp"
#include "lab/printed/detect_printed.hpp"
#include "lab/printed/pool.hpp"
#include "lab/printed/steps.hpp"
#include "support/catch.hpp"
#include "support/error_of.hpp"

using namespace quadrille;
using namespace quadrille::printed;
using namespace quadrille::test;

namespace {

/// All values of settings, as files have them.
std::vector<std::string> values_of(const Settings& settings) {
  std::vector<std::string> values;
  const auto add = [&](const auto& field, const Setting& setting) {
    values.push_back(setting.name + (" = " + io::toml_of(field)));
  };
  DetectorOptions::visit(settings.detector, add);
  PrintedOptions::visit(settings.printed, add);
  return values;
}

std::string refusal_of(const std::string& text) {
  return error_of([&] { parse_settings(text, "some.toml"); });
}

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The curved detection on the most samples, and the root mean square distance of the cloud's
/// points from it [m].
struct Best {
  Detection detection;
  double rms = 0.0;
};

Best best_of(const PointCloud& cloud) {
  const DetectionResult result = detect_printed(cloud, printed_settings());
  const auto all = curved(result);
  REQUIRE_FALSE(all.empty());
  double sum = 0.0;
  int count = 0;
  for (const Eigen::Vector3f& p : cloud.points) {
    if (!p.allFinite()) continue;
    const double distance = all.front()->Q_C.distance(p.cast<double>());
    sum += distance * distance;
    ++count;
  }
  return {*all.front(), std::sqrt(sum / count)};
}

}  // namespace

TEST_CASE("the printed pipeline finds a single sphere in a clean cloud", "[printed]") {
  const Eigen::Vector3d centre(0.02, -0.01, 0.6);
  const Best best =
      best_of(render({sphere(Eigen::Isometry3d(Eigen::Translation3d(centre)), kBall)}));
  CHECK(best.rms < 0.02 * kBall);
  CHECK(best.detection.score > 0.9);
  // A general quadric near to a sphere is an ellipsoid. The paper's errors too are as large as its
  // cells, 2.5 to 5 % of the diameter.
  CHECK((best.detection.X_CQ.translation() - centre).norm() < 0.1 * kBall);
  REQUIRE_FALSE(best.detection.dimensions.empty());
  for (const Dimension& semi_axis : best.detection.dimensions) {
    CHECK(semi_axis.value == Approx(kBall).epsilon(0.1));
  }
}

TEST_CASE("the printed pipeline finds a single cylinder in a clean cloud", "[printed]") {
  const Eigen::Isometry3d X_CB =
      translation(0.0, 0.01, 0.6) *
      Eigen::Isometry3d(Eigen::AngleAxisd(0.5 * M_PI, Eigen::Vector3d::UnitX()));
  const Best best = best_of(render({mantle(X_CB, kCan, kCanLength)}));
  CHECK(best.rms < 0.03 * kCan);
  CHECK(best.detection.score > 0.9);
}

TEST_CASE("the printed pencil is the solution space of the compact system", "[printed]") {
  // A unit sphere: the common scale is exact there.
  const std::array<Eigen::Vector3d, 4> x = {
      Eigen::Vector3d(1, 0.1, 0).normalized(), Eigen::Vector3d(0.2, 1, 0).normalized(),
      Eigen::Vector3d(0, 0.1, 1).normalized(), Eigen::Vector3d(1, 1, 1).normalized()};
  const std::array<OrientedPoint, 3> basis = {OrientedPoint{x[0], x[0]}, OrientedPoint{x[1], x[1]},
                                              OrientedPoint{x[2], x[2]}};
  for (const double weight : {0.3, 1.0, 4.0}) {
    for (const double lambda_scale : {0.5, 1.0, 20.0}) {
      const auto pencil = printed_pencil(basis, weight, lambda_scale);
      REQUIRE(pencil);
      const double norm =
          Quadric(Eigen::Matrix4d(pencil->plane * pencil->plane.transpose())).coefficients().norm();
      CHECK(norm == Approx(lambda_scale));
      const double height = pencil->plane.dot(x[3].homogeneous());
      const double lambda = -Quadric(pencil->Q0).value(x[3]) / (height * height);
      const Eigen::Matrix4d Q = pencil->at(lambda);
      // Half of the gradient of x² + y² + z² − 1 has unit length.
      CHECK((2.0 * Q - diagonal(1, 1, 1, -1)).norm() < 1e-9);
    }
  }
  const OrientedPoint& one = basis[0];
  CHECK_FALSE(printed_pencil({one, one, basis[1]}, 1.0, 1.0));
}

TEST_CASE("hypotheses on the same samples are one cluster, and small clusters are dropped",
          "[printed]") {
  const auto hypothesis = [](double radius, std::vector<int> region) {
    Candidate candidate;
    candidate.Q = Quadric(diagonal(1, 1, 1, -radius * radius)).normalized();
    candidate.region = std::move(region);
    return candidate;
  };
  const std::vector<Candidate> three = {hypothesis(1.0, {0, 1, 2, 3}),
                                        hypothesis(3.0, {0, 1, 2, 3, 4}),
                                        hypothesis(0.2, {60, 64, 65})};
  const auto all = cluster(three, {}, 70, 1);
  REQUIRE(all.size() == 2);
  CHECK(all[0].region == std::vector<int>{0, 1, 2, 3, 4});
  CHECK(all[1].region == std::vector<int>{60, 64, 65});
  CHECK(cluster(three, {}, 70, 2).size() == 1);
  CHECK(cluster(three, {}, 70, 3).empty());
  // By their coefficients.
  CHECK(cluster({hypothesis(1.0, {1, 2}), hypothesis(1.01, {5, 6, 7})}, {}, 70, 1).size() == 1);
}

TEST_CASE("the settings file of the printed pipeline is read", "[printed][config]") {
  const Settings settings = printed_settings();
  CHECK(settings.printed.pool > 0);
  CHECK(settings.printed.levels == 1);
  CHECK(settings.printed.surfaces == Surfaces::kInliers);
  CHECK(settings.detector.sampling.relative_cell == 0.025);
  CHECK(settings.detector.search.grow.rounds == 0);
  const Settings read = parse_settings(
      "search.bases = 7\n[printed]\nweight = 2.5\nlambda_scale = 3\nbins = 64\n"
      "surfaces = \"evidence\"\n",
      "some.toml");
  CHECK(read.detector.search.bases == 7);
  CHECK(read.printed.weight == 2.5);
  CHECK(read.printed.lambda_scale == 3.0);
  CHECK(read.printed.bins == 64);
  CHECK(read.printed.surfaces == Surfaces::kEvidence);
  CHECK(read.printed.pool == 0);
}

TEST_CASE("unknown and wrong settings of the printed pipeline are refused",
          "[printed][config][hostile]") {
  CHECK(says(refusal_of("[printed]\nwieght = 1.0\n"), "line 2: unknown key 'printed.wieght'"));
  CHECK(says(refusal_of("[planner]\nthreads = 1\n"), "unknown key"));
  CHECK(says(refusal_of("[printed]\nsurfaces = \"votes\"\n"), "inliers, evidence, refitted"));
  CHECK(
      says(refusal_of("[printed]\nlevels = 4\n"), "printed.levels = 4: must lie between 1 and 3"));
  CHECK(says(refusal_of("[printed]\nweight = 0\n"), "printed.weight"));
  CHECK(says(refusal_of("only = [\"sphere\"]\n"), "key 'only'"));
  CHECK(says(refusal_of("[printed\n"), "no valid TOML"));
  CHECK(says(error_of([] { load_settings("/nowhere/some.toml"); }), "/nowhere/some.toml"));
}

TEST_CASE("the steps lead from the printed pipeline to the detector, and all differ", "[printed]") {
  Settings refitted = printed_settings();
  refitted.printed.surfaces = Surfaces::kRefitted;
  for (const Step& step : steps_from(refitted)) {
    CHECK(step.settings.printed.surfaces == Surfaces::kRefitted);
  }
  const std::vector<Step> steps = steps_from(printed_settings());
  REQUIRE(steps.size() > 5);
  CHECK(values_of(steps.front().settings) == values_of(printed_settings()));
  CHECK(values_of(steps.back().settings) == values_of(Settings()));
  std::set<std::vector<std::string>> different;
  std::set<std::string_view> names;
  const auto still_as_printed = [&](const Step& step) {
    const auto first = values_of(steps.front().settings), now = values_of(step.settings);
    int count = 0;
    for (std::size_t k = 0; k < first.size(); ++k) count += first[k] == now[k];
    return count;
  };
  for (std::size_t k = 0; k < steps.size(); ++k) {
    CHECK(different.insert(values_of(steps[k].settings)).second);
    CHECK(names.insert(steps[k].name).second);
    if (k > 0) CHECK(still_as_printed(steps[k]) <= still_as_printed(steps[k - 1]));
  }
}

TEST_CASE("by default the pipeline is the detector, bit by bit", "[printed][law]") {
  CHECK(numbers(detect_printed(table_cloud(), {})) == numbers(table_result()));
}

TEST_CASE(
    "each step finds planes, and with a pool or growth the ball of a table, the same each time",
    "[printed][determinism]") {
  Settings printed = printed_settings();
  printed.printed.pool = 500;
  printed.printed.min_members = 3;
  std::vector<Step> steps = steps_from(printed);
  // The printed cells are as large as the ball.
  steps.erase(steps.begin());
  for (const Step& step : steps) {
    CAPTURE(step.name);
    const DetectionResult result = detect_printed(table_cloud(), step.settings);
    CHECK(numbers(result) == numbers(detect_printed(table_cloud(), step.settings)));
    CHECK(find(result, QuadricType::kPlane));
    const Settings& settings = step.settings;
    if (settings.printed.pool == 0 && settings.detector.search.grow.rounds == 0) continue;
    const Eigen::Vector3d centre = TableScene().p_CBall;
    const auto all = curved(result);
    CHECK(std::any_of(all.begin(), all.end(), [&](const Detection* d) {
      const Eigen::Vector3d front = centre - kBall * centre.normalized();
      return std::abs(d->Q_C.distance(front)) < 0.1 * kBall;
    }));
  }
}

TEST_CASE("clouds without surfaces give an empty result", "[printed][hostile]") {
  CHECK(detect_printed({}, printed_settings()).detections.empty());
  PointCloud cloud;
  cloud.points.assign(5, Eigen::Vector3f(0, 0, 1));
  CHECK(detect_printed(cloud, printed_settings()).detections.empty());
}
