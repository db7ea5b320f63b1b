// The figures that pages quote. What takes many minutes is tagged [.], so that only .ci/run --full
// runs it.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>

#include "documents/document.hpp"
#include "lab/experiments/experiment.hpp"
#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using experiments::Report;
using nlohmann::json;
using test::check_says;
using test::run_quadrille;

namespace {

constexpr const char* kLaboratory = "tools/lab/README.md";
constexpr const char* kGrasps = "grasping/README.md";
constexpr const char* kPaper = "tools/lab/experiments/PAPER.md";

Report run_experiment(const char* name) { return experiments::find_experiment(name)->run({}); }

/// With commas between thousands.
std::string with_commas(int value) {
  return value < 1000 ? fmt::format("{}", value)
                      : with_commas(value / 1000) + fmt::format(",{:03}", value % 1000);
}

/// A share in per cent with one digit, but for 100.
std::string share_of(const std::string& cell) {
  const double share = std::stod(cell);
  return fmt::format("{:.{}f}", share, share == 100.0 ? 0 : 1);
}

/// "99.0 % (100)" of "99.0 %" and "100.0 %".
std::string pair_of_shares(const std::string& right, const std::string& any) {
  return fmt::format("{} % ({})", share_of(right), share_of(any));
}

}  // namespace

// Tests with the tag [figures] are hidden, because they take half a minute or more. The long run of
// continuous integration has them.

TEST_CASE("the laboratory's page lists each experiment", "[documents]") {
  for (const auto& experiment : experiments::all_experiments()) {
    check_says(kLaboratory, fmt::format("| `{}` |", experiment.name));
  }
}

TEST_CASE("the page on grasps quotes what a plan of its table gives", "[documents][slow]") {
  const test::TempFolder folder;
  const std::string table = folder.path("table.ply"), plan = folder.path("plan.json");
  REQUIRE(run_quadrille("scene " + table + " --family tabletop --seed 7").code == 0);
  const auto planned = [&](const std::string& options) {
    REQUIRE(run_quadrille("plan " + table + " --gripper franka --json " + plan + options).code ==
            0);
    return json::parse(test::content_of(plan));
  };
  const json with = planned("");
  int ways = static_cast<int>(with.at("grasps").size());
  for (const auto& [reason, count] : with.at("rejected").items()) ways += count.get<int>();
  check_says(kGrasps, fmt::format("in which {} ways to hold are considered",
                                  with_commas((ways + 50) / 100 * 100)));
  const std::string config = folder.write("c.toml", "[planner]\nclear_above = false\n");
  const json cleared = planned(" --unknown obstacle");
  const json whole = planned(" --unknown obstacle --config " + config);
  check_says(kGrasps, fmt::format("without it, `--unknown obstacle` gives {} grasps instead of {}",
                                  whole.at("grasps").size(), cleared.at("grasps").size()));
}

TEST_CASE("the laboratory's page shows what trying grasps prints", "[documents][slow]") {
  const test::TempFolder folder;
  const std::string scan = folder.path("scan.ply");
  REQUIRE(run_quadrille("scene " + scan + " --family tabletop --seed 7").code == 0);
  const test::Run run = run_quadrille("try --first --gripper franka " + scan);
  REQUIRE(run.code == 0);
  std::istringstream lines(run.out);
  int rows = 0;
  for (std::string line; std::getline(lines, line);) {
    // The rows of the table begin with the number of a target.
    std::istringstream words(line);
    int target = 0;
    double score = 0;
    if (!(words >> target >> score)) continue;
    check_says(kLaboratory, line);
    ++rows;
  }
  // No row stands there that is not printed.
  const std::string page = test::folded_document(kLaboratory);
  const std::size_t begin = page.find("slip/mm turn/deg outcome");
  const std::size_t end = page.find("```", begin);
  REQUIRE(end != std::string::npos);
  const std::string block = page.substr(begin, end - begin);
  const std::regex row("\\d+ [01]\\.\\d\\d [a-z]");
  CHECK(std::distance(std::sregex_iterator(block.begin(), block.end(), row), {}) == rows);
  CHECK(rows > 2);
}

TEST_CASE("the laboratory's page says what is found in fused clouds",
          "[.][figures][documents][slow]") {
  const Report report = run_experiment("growth");
  REQUIRE(report.data.rows.size() == 5);
  const std::string page = test::folded_document(kLaboratory);
  for (const auto& row : report.data.rows) {
    const std::string points = with_commas(std::stoi(row[0])),
                      found = fmt::format("{} of {}", row[3], row[4]);
    CAPTURE(points, found);
    const std::size_t at = page.find(fmt::format("| {} |", points));
    REQUIRE(at != std::string::npos);
    CHECK(page.find(fmt::format("| {} |", found), at) < at + 60);
  }
}

TEST_CASE("the page on the paper quotes the distribution of lambda", "[documents][slow]") {
  const Report report = run_experiment("lambda");
  const auto& rows = report.tables.front().rows;
  const auto short_form = [](const std::string& number, int digits) {
    const long units = std::lround(std::abs(std::stod(number)) * std::pow(10.0, digits));
    return fmt::format(".{:0{}}", units, digits);
  };
  check_says(kPaper, fmt::format("atan(λ / λ₀) is off by {} at most for λ₀ = 1, by {} for λ₀ = "
                                 "median \\|λ\\| = {}; median λ −{}",
                                 short_form(rows[0][6], 3), short_form(rows[1][6], 3),
                                 short_form(rows[1][5], 2), short_form(rows[0][1], 4)));
}

TEST_CASE("what a twelfth of the bins shows does not contradict the page's shares of cylinders",
          "[documents][slow]") {
  experiments::Settings settings;
  settings.quick = true;
  const Report report = experiments::find_experiment("cylinders")->run(settings);
  const auto& rows = report.tables.front().rows;
  REQUIRE(rows.size() == 9);
  const std::string page = test::folded_document(kPaper);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    // The row of the page, by the number of cylinders; then three shares of two numbers.
    const std::regex quoted(
        fmt::format(R"(\| {} \([0-9]+[^)]*\) \|(?: [0-9.]+ % \([0-9.]+\) \|){{{}}} ([0-9.]+) %)",
                    rows[k][0], k % 3));
    CAPTURE(rows[k][0], k);
    std::smatch match;
    REQUIRE(std::regex_search(page, match, quoted));
    const double share = std::stod(match[1]) / 100.0, asked = std::stod(rows[k][2]);
    // Three deviations of the share among as many, and one more miss.
    const double margin = 3.0 * std::sqrt(share * (1.0 - share) / asked) + 1.0 / asked;
    CHECK(std::stod(rows[k][3]) / 100.0 > share - margin);
    CHECK(std::stod(rows[k][3]) / 100.0 < share + margin);
    const std::vector<std::string>& counts = report.data.rows[k];
    const double known = std::stod(counts[2]), any = std::stod(counts[4]);
    CHECK(known >= 6);
    CHECK(known <= std::stod(counts[0]));
    CHECK(any <= known);
    CHECK(std::stod(counts[5]) <= 0.2 * any);
  }
}

TEST_CASE("the page on the paper quotes the shares of cylinders in bins",
          "[.][figures][documents][slow]") {
  const Report report = run_experiment("cylinders");
  const auto& rows = report.tables.front().rows;
  REQUIRE(rows.size() == 9);
  for (std::size_t i = 0; i < rows.size(); i += 3) {
    std::string sentence =
        fmt::format("| {} ({}{}) |", rows[i][0], rows[i][2], i > 0 ? "" : " asked for");
    for (std::size_t k = i; k < i + 3; ++k) {
      sentence += fmt::format(" {} |", pair_of_shares(rows[k][3], rows[k][4]));
    }
    check_says(kPaper, sentence);
  }
}

TEST_CASE("the page on the paper quotes the errors of spheres", "[.][figures][documents][slow]") {
  const Report report = run_experiment("spheres");
  std::map<std::string, std::vector<std::string>> rows;
  for (const auto& row : report.tables.front().rows) rows[row[0]] = row;
  const auto of = [&](const char* set, std::size_t column) {
    const double share = std::stod(rows.at(set).at(column));
    return share >= 1.0 ? fmt::format("{:.1f}", share)
                        : fmt::format(".{:02}", static_cast<int>(std::lround(100.0 * share)));
  };
  check_says(kPaper,
             fmt::format("medians of the radius {}, {}, {} % and of the centre {}, {}, {} %",
                         of("easy", 4), of("medium", 4), of("hard", 4), of("easy", 6),
                         of("medium", 6), of("hard", 6)));
  check_says(kPaper, fmt::format("finds {}, {} and {} spheres, that for all types {}, {} and {}.",
                                 report.tables[1].rows[0][6], report.tables[1].rows[2][6],
                                 report.tables[1].rows[1][6], rows["easy"][2], rows["medium"][2],
                                 rows["hard"][2]));
}
