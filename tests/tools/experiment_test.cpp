#include "lab/experiments/experiment.hpp"

#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using namespace quadrille::experiments;
using test::contains;

namespace {

Report run_quick(std::string_view name, std::uint64_t seed = 1) {
  Settings settings;
  settings.quick = true;
  settings.seed = seed;
  double last = 0.0;
  settings.progress = [&](double share) {
    CHECK(share <= 1.0 + 1e-9);
    last = share;
  };
  const Report report = find_experiment(name)->run(settings);
  CHECK(last > 0.2);
  CHECK_FALSE(report.findings.empty());
  for (const auto& row : report.data.rows) CHECK(row.size() == report.data.columns.size());
  return report;
}

double value_of(const std::string& cell) { return std::stod(cell); }

/// The rows whose first cells are these.
std::vector<std::vector<std::string>> rows_of(const Table& table,
                                              const std::vector<std::string>& start) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& row : table.rows) {
    if (std::equal(start.begin(), start.end(), row.begin())) rows.push_back(row);
  }
  return rows;
}

}  // namespace

TEST_CASE("exact points give exact fits, and the likelihood fit is best under noise",
          "[experiment][paper:fig5]") {
  const Report report = run_quick("fitting");
  for (const char* fit : {"full", "taubin", "tangent", "first_order_distance",
                          "orthogonal_distance", "likelihood", "pd_0", "pd_3"}) {
    for (const char* measure : {"point", "angle", "gradient"}) {
      CAPTURE(fit, measure);
      const auto rows = rows_of(report.data, {measure, fit, "exact", "0"});
      REQUIRE(rows.size() == 1);
      CHECK(value_of(rows.front()[4]) < (measure == std::string("gradient") ? 1e-4 : 1e-6));
    }
  }
  for (const char* normals : {"exact", "noisy"}) {
    const auto rows = rows_of(report.tables.front(), {normals});
    CHECK(rows.size() == 6);
    for (const auto& row : rows) {
      CHECK(row.back() == (row[1] == "0" ? "equal to rounding" : "yes"));
    }
  }
  // Error grows with noise, and time with points.
  for (const char* fit : {"taubin", "likelihood", "full"}) {
    const auto rows = rows_of(report.data, {"point", fit, "exact"});
    CHECK(value_of(rows[1][4]) < value_of(rows[5][4]));
    const auto times = rows_of(report.data, {"time_us", fit});
    CHECK(value_of(times.front()[4]) < value_of(times.back()[4]));
  }
}

TEST_CASE("the closed form is ten times faster than SVD and finds the same", "[experiment]") {
  const Report report = run_quick("minimal");
  const auto closed = rows_of(report.data, {"closed form (make_pencil, λ)"});
  REQUIRE(closed.size() == 1);
  CHECK(value_of(closed.front()[2]) > 10.0);
  for (const auto& row : report.data.rows) {
    CAPTURE(row.front());
    CHECK(value_of(row[3]) < 1e-9);
  }
}

TEST_CASE("λ is as often positive as negative, and near to atan's distribution",
          "[experiment][paper:theorem3]") {
  const Report report = run_quick("lambda");
  const auto rows = rows_of(report.tables.front(), {"on the quadric"});
  REQUIRE(rows.size() == 2);
  CHECK(std::abs(value_of(rows[0][1])) < 0.1);
  CHECK(value_of(rows[1][6]) < 0.1);
  CHECK(value_of(rows[1][6]) < value_of(rows[0][6]));
  CHECK(contains(report.findings[1], "at most 2 values"));
  // Quantiles rise with their shares.
  const auto quantiles = rows_of(report.data, {"same"});
  for (std::size_t k = 1; k < quantiles.size(); ++k) {
    CHECK(value_of(quantiles[k - 1][2]) <= value_of(quantiles[k][2]));
  }
}

TEST_CASE("three points with a vote find more in clutter than four or nine", "[experiment]") {
  const Report report = run_quick("basis");
  const auto found = [&](const std::string& sampler) {
    const auto rows = rows_of(report.data, {"0.4", sampler});
    REQUIRE_FALSE(rows.empty());
    return value_of(rows.back()[4]);
  };
  const double three = found("3 points, vote, consistency test");
  CHECK(three > 0.5);
  CHECK(found("2 points, vote in 3 dimensions") > 0.5);
  CHECK(three >= found("4 points, compact"));
  CHECK(three >= found("9 points, Taubin"));
  const auto rows = rows_of(report.tables[2], {"0 %"});
  CHECK(rows.size() == 7);
}

TEST_CASE("cells as large as the bodies find less than the default ones, and take less time",
          "[experiment]") {
  const Report report = run_quick("sampling");
  for (const char* family : {"medium", "hard"}) {
    for (const char* way : {"2 points, vote", "3 points, vote", "4 points", "9 points"}) {
      CAPTURE(family, way);
      const auto fine = rows_of(report.data, {family, "0.0031", "5", way});
      const auto coarse = rows_of(report.data, {family, "0.0124", "5", way});
      REQUIRE((fine.size() == 1 && coarse.size() == 1));
      const double known = value_of(fine[0][4]), found = value_of(fine[0][5]);
      CHECK(known >= 6);
      CHECK(found >= 0.6 * known);
      CHECK(found <= known);
      CHECK(value_of(coarse[0][5]) < found);
      CHECK(value_of(coarse[0][7]) < value_of(fine[0][7]));
    }
  }
  CHECK(rows_of(report.data, {"medium", "0.0031", "1"}).size() == 4);
}

TEST_CASE("triplets repeat more often with more bases, and count only with the hash",
          "[experiment]") {
  const Report report = run_quick("triplets");
  for (const char* family : {"medium", "hard"}) {
    std::vector<double> shares;
    for (const char* bases : {"5", "50"}) {
      CAPTURE(family, bases);
      const auto without = rows_of(report.data, {family, bases, "plain"});
      const auto with = rows_of(report.data, {family, bases, "hashed"});
      const auto single = rows_of(report.data, {family, bases, "one radius"});
      REQUIRE(single.size() == 1);
      CHECK(value_of(single[0][4]) <= value_of(with[0][4]));
      REQUIRE((without.size() == 1 && with.size() == 1));
      CHECK(value_of(without[0][3]) + value_of(without[0][4]) == 0);
      CHECK(value_of(with[0][3]) > 100);
      shares.push_back(value_of(with[0][4]) / value_of(with[0][3]));
      CHECK(std::abs(value_of(with[0][7]) - value_of(without[0][7])) <= 3);
    }
    CHECK(shares[1] > 0.01);
    CHECK(shares[0] < shares[1]);
    CHECK(shares[1] < 0.5);
  }
}

TEST_CASE("the detector finds more than the printed pipeline, with fewer false surfaces",
          "[experiment]") {
  const Report report = run_quick("printed");
  REQUIRE(report.data.rows.size() % 2 == 0);
  const auto medium = rows_of(report.data, {"medium"});
  REQUIRE(medium.size() == report.data.rows.size() / 2);
  CHECK(medium.front()[1] == "as printed");
  CHECK(value_of(medium.front()[3]) < value_of(medium.back()[3]));
  // With smaller cells alone.
  CHECK(value_of(medium[1][3]) >= 3);
  CHECK(value_of(medium[1][4]) > value_of(medium.back()[4]));
  CHECK(value_of(medium[1][7]) > value_of(medium.back()[7]));
}

TEST_CASE("spheres of generated scenes are measured to a few per cent", "[experiment]") {
  const Report report = run_quick("spheres");
  int found = 0;
  for (const auto& row : report.data.rows) {
    if (row[1] != "1") continue;
    ++found;
    CHECK(std::abs(value_of(row[2])) < 0.2);
  }
  CHECK(found >= 3);
  REQUIRE(report.tables.size() == 2);
  for (const auto& row : report.tables[1].rows) {
    CAPTURE(row[0]);
    CHECK(row[1] == "3");
    CHECK(value_of(row[2]) > value_of(row[3]));
    CHECK(value_of(row[4]) == Approx(value_of(row[2]) / value_of(row[3])).epsilon(0.01));
  }
}

TEST_CASE("published standard deviations are about as large as the errors", "[experiment]") {
  const Report report = run_quick("deviations");
  REQUIRE(report.data.rows.size() > 20);
  int within = 0, far_within = 0;
  for (const auto& row : report.data.rows) {
    CAPTURE(row[1], row[2]);
    const double error = std::abs(value_of(row[3]) - value_of(row[4])), std = value_of(row[5]);
    CHECK(std > 0.0);
    within += error <= 2.0 * std;
    far_within += error <= 0.1 * std;
  }
  const int all = static_cast<int>(report.data.rows.size());
  // 95 % and 8 % of a normal distribution.
  CHECK(within > 0.8 * all);
  CHECK(far_within < 0.3 * all);
}

TEST_CASE("what stands on the table of a fused cloud is found once there are points enough",
          "[experiment]") {
  const Report report = run_quick("growth");
  REQUIRE(report.data.rows.size() == 2);
  const auto& small = report.data.rows[0];
  const auto& large = report.data.rows[1];
  CHECK(value_of(small[3]) < value_of(large[3]));
  CHECK(large[3] == "12");
  for (const auto& row : report.data.rows) {
    CHECK(row[4] == "12");
    CHECK(value_of(row[1]) > 0.0);
    CHECK(value_of(row[2]) > 0.0);
  }
}
