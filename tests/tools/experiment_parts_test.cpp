#include <cmath>

#include "fits/taubin_fit.hpp"
#include "lab/experiments/cylinder_match.hpp"
#include "lab/experiments/fit_errors.hpp"
#include "lab/experiments/generated_scenes.hpp"
#include "lab/experiments/measure.hpp"
#include "lab/experiments/neighbourhood.hpp"
#include "lab/experiments/plot.hpp"
#include "lab/experiments/random_quadric.hpp"
#include "lab/experiments/sphere_errors.hpp"
#include "lab/experiments/table.hpp"
#include "search/hypotheses.hpp"
#include "support/catch.hpp"
#include "tools/support_files.hpp"
#include "tools/well_formed.hpp"

using namespace quadrille;
using namespace quadrille::experiments;
using test::contains;

TEST_CASE("lines, dots and pieces are told apart, and a single point can be seen",
          "[experiment][plot]") {
  Plot plot{"it's <b> & c", "x", "y", {}, true, true};
  plot.lines = {
      {"one", {{3, 3}}},
      {"one of three", {{1, 0}, {10, 5}, {20, std::nan("")}}},
      {"two", {{1, 1}, {100, 100}}},
      {"none", {{1, 0}}},
      {.name = "pieces", .points = {{1, 1}, {2, 2}, {3, 3}, {4, 4}}, .drawn = Drawn::kPieces}};
  const std::string script = to_gnuplot({plot});
  CHECK(contains(script, "set title 'it''s <b> & c'\n"));
  CHECK(test::count(script, "with linespoints") == 2);
  CHECK(test::count(script, "with lines lw") == 2);
  CHECK_FALSE(contains(script, "none"));
  CHECK_FALSE(contains(script, "nan"));
  CHECK(contains(script, "1 1\n2 2\n\n3 3\n4 4\n"));
  plot.lines[2].marked = true;
  CHECK(test::count(to_gnuplot({plot}), "with linespoints") == 3);
}

TEST_CASE("one way has one colour in all plots of a document", "[experiment][plot]") {
  const std::vector<std::pair<double, double>> points = {{0, 0}, {1, 1}};
  const Plot first{"", "", "", {{"a", points}, {"b, easy", points, false, false, "b"}}};
  const Plot second{"", "", "", {{"b, hard", points, true, false, "b"}, {"c", points}}};
  const std::string script = to_gnuplot({first, second});
  CHECK(test::count(script, "#1f77b4") == 1);
  CHECK(test::count(script, "#d62728") == 2);
  CHECK(test::count(script, "#2ca02c") == 1);
}

TEST_CASE("tables have a cell a column, in Markdown and CSV", "[experiment][table]") {
  Table table{"t", {"a", "b"}, {}};
  table.add({"1", "x,\"y\""});
  CHECK(to_csv(table) == "a,b\n1,\"x,\"\"y\"\"\"\n");
  CHECK(to_markdown(table) == "## t\n\n| a | b |\n| --- | --- |\n| 1 | x,\"y\" |\n");
  // A bar within a cell ends no cell.
  CHECK(to_markdown({"", {"|a|"}, {}}) == "| \\|a\\| |\n| --- |\n");
  CHECK_THROWS_AS(table.add({"1"}), std::invalid_argument);
}

TEST_CASE("quantiles are interpolated", "[experiment]") {
  CHECK(quantile({3, 1, 2}, 0.5) == 2);
  CHECK(quantile({0, 10}, 0.25) == Approx(2.5));
  CHECK(quantile({4}, 1.0) == 4);
  CHECK_THROWS_AS(quantile({}, 0.5), std::invalid_argument);
}

TEST_CASE("samples lie on the quadric within the unit ball with its gradients",
          "[experiment][sample]") {
  for (int k = 0; k < kCurvedTypes; ++k) {
    RandomStream random(1, static_cast<std::uint64_t>(k));
    const Quadric Q = random_quadric(curved_type(k), random);
    const OrientedPointsd points = sample(Q, 200, random);
    CAPTURE(to_string(curved_type(k)));
    CHECK(canonical_form(Q).type == curved_type(k));
    for (Eigen::Index i = 0; i < points.size(); ++i) {
      CHECK(std::abs(Q.value(points.points.col(i))) < 1e-9);
      CHECK(points.points.col(i).norm() <= 1.0);
      CHECK(points.normals.col(i).dot(Q.gradient(points.points.col(i)).normalized()) ==
            Approx(1.0));
    }
  }
}

TEST_CASE("samples of a sphere are uniform by area", "[experiment][sample]") {
  RandomStream random(2, 0);
  const Quadric sphere =
      from_canonical({QuadricType::kSphere, Eigen::Isometry3d::Identity(), {{"radius", 0.8}}});
  const OrientedPointsd points = sample(sphere, 20000, random);
  // Archimedes: each coordinate is uniform, so its mean square is r² / 3 and that of |z| is r / 2.
  CHECK(points.points.row(2).cwiseAbs().mean() == Approx(0.4).epsilon(0.02));
  CHECK(points.points.row(0).squaredNorm() / 20000 == Approx(0.64 / 3).epsilon(0.03));
  const Quadric far = Quadric(Eigen::Matrix4d(Eigen::Vector4d(1, 1, 1, -9).asDiagonal()));
  CHECK_THROWS_AS(sample(far, 10, random), std::invalid_argument);
}

TEST_CASE("noise has the deviation that is asked for", "[experiment][sample]") {
  RandomStream random(3, 0);
  const OrientedPointsd exact = sample(random_quadric(QuadricType::kSphere, random), 5000, random);
  OrientedPointsd data = exact;
  add_point_noise(&data, 0.03, random);
  CHECK(std::sqrt((data.points - exact.points).squaredNorm() / 15000) ==
        Approx(0.03).epsilon(0.03));
  add_normal_noise(&data, 0.05, random);
  CHECK(std::sqrt((data.normals - exact.normals).squaredNorm() / 10000) ==
        Approx(0.05).epsilon(0.05));
  CHECK(data.normals.colwise().norm().maxCoeff() == Approx(1.0));
  OrientedPointsd estimated = exact;
  estimate_normals(&estimated, 12);
  CHECK((estimated.normals - exact.normals).colwise().norm().mean() < 0.05);
}

TEST_CASE("fit errors are those of a sphere that is too large", "[experiment]") {
  RandomStream random(4, 0);
  const auto sphere = [](double r) {
    return from_canonical({QuadricType::kSphere, Eigen::Isometry3d::Identity(), {{"radius", r}}});
  };
  const OrientedPointsd points = sample(sphere(0.5), 100, random);
  const FitErrors none = errors_of(std::nullopt, sphere(0.5), points, 1.0);
  CHECK((none.point == 1.0 && none.angle == 1.0 && none.gradient == 1.0));
  const FitErrors exact = errors_of(sphere(0.5), sphere(0.5), points, 1.0);
  CHECK(exact.point < 1e-9);
  const FitErrors large = errors_of(sphere(0.6), sphere(0.5), points, 2.0);
  CHECK(large.point == Approx(0.05));
  CHECK(large.angle == Approx(0.0).margin(1e-9));
  CHECK(large.gradient == Approx(0.0).margin(1e-9));
  CHECK(errors_of(sphere(0.5).flipped(), sphere(0.5), points, 1.0).angle == Approx(2.0));
}

TEST_CASE("a neighbourhood has its share of outliers and knows when it is found", "[experiment]") {
  RandomStream random(5, 0);
  const Neighbourhood n = random_neighbourhood({.outliers = 0.4}, random);
  CHECK(n.points.size() == 300);
  CHECK(n.truth.size() == 180);
  CHECK(n.voters.size() == 300);
  CHECK(n.truth.points.colwise().norm().maxCoeff() <= 1.0);
  // From noise-free points any exact fit finds the quadric again.
  const Quadric Q = *fit_taubin(n.truth);
  const Quadric signed_Q = oriented(Q, n.truth);
  CHECK(is_found(signed_Q, n, 1e-3));
  CHECK_FALSE(is_found(signed_Q.flipped(), n, 1e-3));
  const int support = count_support(n.voters, signed_Q.matrix(), 0.04, 0.85);
  CHECK(support >= 170);
  CHECK(support <= 240);
}

TEST_CASE("a detection matches the known sphere that it is nearest to", "[experiment]") {
  DetectionResult result;
  result.detections.resize(3);
  result.detections[0].type = QuadricType::kCylinder;
  result.detections[1].type = QuadricType::kSphere;
  result.detections[1].dimensions = {{"radius", 0.11, 0.0}};
  result.detections[1].X_CQ.translation() << 0.01, 0, 1;
  result.detections[2] = result.detections[1];
  result.detections[2].X_CQ.translation() << 0.05, 0, 1;
  const SphereError error = match(result, {{0, 0, 1}, 0.1});
  REQUIRE(error.found);
  CHECK(error.radius == Approx(0.1));
  CHECK(error.centre == Approx(0.1));
  CHECK_FALSE(match(result, {{0, 0, 2}, 0.1}).found);
  const Report report = report_errors({{"a", {error, {}}}, {"none", {{}}}});
  CHECK(report.tables.front().rows.size() == 2);
  CHECK(contains(report.findings.front(), "1 of 2 found"));
}

TEST_CASE("each scene of each family is worked on, those of another seed are others",
          "[experiment][scene]") {
  std::vector<std::pair<scene::Family, std::uint64_t>> worked;
  std::vector<double> shares;
  Settings settings;
  settings.seed = 3;
  settings.progress = [&](double share) { shares.push_back(share); };
  for_each_scene({scene::Family::kEasy, scene::Family::kHard}, 2, settings,
                 [&](const scene::Scene& made) {
                   CHECK_FALSE(made.view.points.empty());
                   worked.emplace_back(made.options.family, made.options.seed);
                 });
  CHECK(worked == decltype(worked){{scene::Family::kEasy, 3000},
                                   {scene::Family::kEasy, 3001},
                                   {scene::Family::kHard, 3000},
                                   {scene::Family::kHard, 3001}});
  CHECK(shares == std::vector<double>{0.25, 0.5, 0.75, 1.0});
}

TEST_CASE("a cylinder is found when axis and radius agree, and counts once", "[experiment]") {
  DetectionResult result;
  result.detections.resize(1);
  Detection& found = result.detections[0];
  found.type = QuadricType::kCylinder;
  found.dimensions = {{"radius", 0.0205, 0.0}, {"length", 0.05, 0.0}};
  found.X_CQ.translation() << 0.0, 0.003, 0.54;
  const KnownCylinder truth{{0, 0, 0.5}, {0, 0, -1}, 0.02};
  const auto is_found = [&] { return found_cylinders(result, {truth}).front() != 0; };
  CHECK(is_found());
  CHECK(found_cylinders(result, {truth, truth}) == std::vector<char>{1, 0});
  const Detection good = found;
  found.dimensions[0].value = 0.0225;
  CHECK_FALSE(is_found());
  found = good;
  found.X_CQ.translation().y() = 0.0045;
  CHECK_FALSE(is_found());
  found = good;
  found.X_CQ.linear() = Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()).toRotationMatrix();
  found.X_CQ.translation() << 0.0, 0.0, 0.5;
  CHECK_FALSE(is_found());
  found = good;
  found.type = QuadricType::kEllipticCylinder;
  CHECK_FALSE(is_found());
}
