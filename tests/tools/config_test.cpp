#include "io/planner/config.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <type_traits>

#include "io/settings/setting_text.hpp"
#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using test::contains;
using test::error_of;

namespace {

std::string config_error(const std::string& text) {
  const test::TempFolder folder;
  const std::string path = folder.write("c.toml", text);
  const std::string error = error_of([&] { io::load_config(path); });
  if (!error.empty()) CHECK(error.find(path) == 0);
  return error;
}

/// All values of a configuration, as files have them.
std::vector<std::string> values_of(const io::Config& config) {
  std::vector<std::string> values;
  const auto add = [&](const auto& field, const Setting& setting) {
    values.push_back(setting.name + (" = " + io::toml_of(field)));
  };
  DetectorOptions::visit(config.detector, add);
  TrackOptions::visit(config.track, add);
  PlanOptions::visit(config.planner, add);
  return values;
}

/// Sets a field to a value that is not its default, and allowed.
template <class Field>
void make_odd(Field* field, const Setting& setting) {
  if constexpr (std::is_same_v<Field, bool>) {
    *field = !*field;
  } else if constexpr (std::is_same_v<Field, double>) {
    // Of many digits, and within the range, for no default lies at its upper bound.
    *field += (std::min(setting.max, 2.0 * *field + 0.1) - *field) / 3.0;
  } else if constexpr (io::Choice<Field>) {
    *field = words_of(*field).back().value;
  } else if constexpr (io::List<Field>) {
    field->push_back({});
    make_odd(&field->back(), setting);
  } else {
    ++*field;
  }
}

io::Config odd_config() {
  io::Config config;
  const auto change = [](auto& field, const Setting& setting) { make_odd(&field, setting); };
  DetectorOptions::visit(config.detector, change);
  TrackOptions::visit(config.track, change);
  PlanOptions::visit(config.planner, change);
  // Whole numbers, in fields of real ones, and lists that ascend.
  config.detector.planes.sigmas = 4.0;
  config.detector.planes.min_radius = 1e-6;
  config.detector.aggregate.effective_size = 1e9;
  config.detector.search.radii = {1.0, 100.0};
  config.planner.reach.base = {1.0, -2.5, 1.0 / 3.0};
  return config;
}

}  // namespace

TEST_CASE("a configuration sets what it names and leaves the rest", "[config]") {
  const test::TempFolder folder;
  const io::Config config =
      io::load_config(folder.write("c.toml", "# mine\nseed = 42\n[planner]\nfriction = 0.4\n"));
  CHECK(config.detector.seed == 42);
  CHECK(config.detector.threads == DetectorOptions().threads);
  CHECK(config.planner.friction == 0.4);
  CHECK(config.planner.max_grasps == PlanOptions().max_grasps);
}

TEST_CASE("each printed setting reads back as it was", "[config]") {
  const test::TempFolder folder;
  const io::Config odd = odd_config();
  for (const io::Config& config : {io::Config(), odd}) {
    const std::string text = io::to_toml(config);
    INFO(text);
    const io::Config back = io::load_config(folder.write("c.toml", text));
    CHECK(values_of(back) == values_of(config));
    CHECK(back.given.size() == values_of(config).size());
  }
  // All settings were other than the defaults.
  const std::vector<std::string> values = values_of(odd), defaults = values_of({});
  REQUIRE(values.size() == defaults.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    INFO(defaults[i]);
    CHECK(values[i] != defaults[i]);
  }
}

TEST_CASE("a printed setting has its meaning, range, unit and default beside it", "[config]") {
  io::Config config;
  config.planner.approach = 1.0;
  config.detector.planes.angle = 0.25;
  const std::string text = io::to_toml(config);
  INFO(text);
  CHECK(contains(text,
                 "\n[planes]\n# Samples that a plane has at least.\n# 4 to 1000000; default "
                 "40\nmin_samples = 40\n"));
  CHECK(contains(text, "# 0.01 to 1.5708 rad; default 0.26\nangle = 0.25\n"));
  CHECK(contains(text, "# 0 to 1 m; default 0.05\napproach = 1.0\n"));
  CHECK(contains(text, "# one of weighed, obstacle, target-shadow, free; default \"weighed\"\n"));
  CHECK(contains(text, "\n# default true\nclear_above = true\n"));
  CHECK(contains(text, "\nradii = [5.0, 9.0, 15.0]\n"));
  CHECK(contains(text, "\n[search.grow]\n"));
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) CHECK(line.size() <= 100);
  }
}

TEST_CASE("lists hold numbers or words", "[config]") {
  const test::TempFolder folder;
  const DetectorOptions options =
      io::load_config(folder.write("c.toml",
                                   "only = [\"sphere\", \"cone\"]\n[search]\nradii = [4, "
                                   "8.5]\n[aggregate]\nfamilies = []\n"))
          .detector;
  CHECK(options.only == std::vector{QuadricType::kSphere, QuadricType::kCone});
  CHECK(options.search.radii == std::vector{4.0, 8.5});
  CHECK(options.aggregate.families.empty());
  CHECK(contains(config_error("only = [\"cube\"]\n"),
                 "line 1: key 'only' must be a list, each element one of sphere, ellipsoid"));
  CHECK(contains(config_error("only = [\"imaginary_cone\"]\n"), "key 'only' must be"));
  CHECK(contains(config_error("only = \"sphere\"\n"), "key 'only' must be a list"));
  CHECK(contains(config_error("search.radii = [4, \"far\"]\n"), "each element a number"));
  CHECK(
      contains(config_error("search.radii = [4, 0.1]\n"), "search.radii = 0.1: must lie between"));
  CHECK(contains(config_error("search.radii = []\n"), "must not be empty"));
  CHECK(contains(config_error("search.grow.families = []\n"), "must not be empty"));
}

TEST_CASE("keys as earlier versions spelt them are read", "[config]") {
  const test::TempFolder folder;
  const io::Config config = io::load_config(
      folder.write("c.toml",
                   "[planes]\nleast_samples = 50\nleast_proven_radius = "
                   "0.2\n[search.grow]\nleast_samples = 30\n[aggregate]\n"
                   "largest_residual_plane = 3\nleast_confidence_early = 0.7\n[planner]\n"
                   "wall_least = 0.001\nwall_most = 0.006\n"));
  CHECK(config.detector.planes.min_samples == 50);
  CHECK(config.detector.planes.min_proven_radius == 0.2);
  CHECK(config.detector.search.grow.min_samples == 30);
  CHECK(config.detector.aggregate.max_residual_plane == 3.0);
  CHECK(config.detector.aggregate.min_confidence_early == 0.7);
  CHECK(config.planner.min_wall == 0.001);
  CHECK(config.planner.max_wall == 0.006);
  CHECK(config.given.contains("planes.min_samples"));
  CHECK_FALSE(config.given.contains("planes.least_samples"));
}

TEST_CASE("errors about keys name the present ones", "[config][hostile]") {
  CHECK(
      contains(config_error("[planes]\nleast_samples = 2\n"), "planes.min_samples = 2: must lie"));
  CHECK(contains(config_error("[planes]\nleast_samples = 50\nmin_samples = 50\n"),
                 "line 2: key 'planes.least_samples' is the old name of 'planes.min_samples'"));
  const std::string unknown = config_error("[planes]\nleast_angle = 1\n");
  CHECK(contains(unknown, "unknown key 'planes.least_angle'; there are planes.angle, planes.min_"));
  CHECK_FALSE(contains(unknown, "least_samples"));
}

TEST_CASE("the detector leaves the planner's table alone, and checks all else", "[config]") {
  const test::TempFolder folder;
  const std::string path =
      folder.write("c.toml", "seed = 4\n[planner]\nnonsense = 1\n[planner.more]\nfriction = -1\n");
  CHECK(io::load_detector_config(path).detector.seed == 4);
  CHECK(contains(error_of([&] { io::load_config(path); }), "'planner."));
  const auto detector_error = [&](const std::string& text) {
    return error_of([&] { io::load_detector_config(folder.write("d.toml", text)); });
  };
  CHECK(contains(detector_error("[plans]\na = 1\n"), "unknown key 'plans.a'"));
  CHECK(contains(detector_error("planner = 1\n"), "unknown key 'planner'"));
  CHECK(contains(detector_error("[track]\ngate = 0\n"), "track.gate = 0: must lie between"));
  CHECK(contains(detector_error("[track]\nspeed = -1\n"), "between 0 and 1000 m/s"));
}

TEST_CASE("each kind of basis has its word, and others are refused with the list", "[config]") {
  const test::TempFolder folder;
  const auto basis = [&](const std::string& word) {
    return io::load_config(folder.write("c.toml", "[search]\nbasis = \"" + word + "\"\n"))
        .detector.search.basis;
  };
  CHECK(basis("three_points") == BasisKind::kThreePoints);
  CHECK(basis("sphere") == BasisKind::kSphere);
  CHECK(contains(config_error("[search]\nbasis = \"five_points\"\n"), "three_points, sphere"));
}

TEST_CASE("a search for spheres alone starts from the preset, and a file stands above it",
          "[config]") {
  const test::TempFolder folder;
  const auto options_of = [&](const std::string& text) {
    return io::search_options(io::load_detector_config(folder.write("c.toml", text)));
  };
  const auto toml_of = [](const DetectorOptions& options) {
    io::Config config;
    config.detector = options;
    return io::to_toml(config);
  };
  CHECK(toml_of(options_of("only = [\"sphere\"]\n")) == toml_of(sphere_preset()));
  DetectorOptions wanted = sphere_preset();
  wanted.seed = 7;
  wanted.sampling.cell = 0.0031;
  wanted.search.radii = {5.0, 9.0, 15.0};
  wanted.search.basis = BasisKind::kThreePoints;
  CHECK(toml_of(options_of("only = [\"sphere\"]\nseed = 7\n[sampling]\ncell = 0.0031\n[search]\n"
                           "radii = [5, 9, 15]\nbasis = \"three_points\"\n")) == toml_of(wanted));
  DetectorOptions both;
  both.only = {QuadricType::kSphere, QuadricType::kCone};
  CHECK(toml_of(options_of("only = [\"sphere\", \"cone\"]\n")) == toml_of(both));
  // The printed settings are read back unchanged.
  CHECK(toml_of(options_of(toml_of(sphere_preset()))) == toml_of(sphere_preset()));
}

TEST_CASE("where all types count, settings that choose some are refused", "[config]") {
  for (const std::string key : {"only", "report"}) {
    const std::string text = key + " = [\"sphere\"]\n";
    const io::DetectorConfig config = io::parse_detector_config(text, "c.toml");
    const std::string refusal =
        test::error_of([&] { io::refuse_choice_of_types(config.given, "c.toml"); });
    CHECK(refusal == "c.toml: key '" + key + "': here surfaces of all types count");
  }
  io::refuse_choice_of_types({"seed", "planes.sigmas"}, "c.toml");
}

TEST_CASE("a wrong configuration is refused with its key and its line or range",
          "[config][hostile]") {
  const std::vector<std::pair<const char*, const char*>> cases = {
      {"seed = 1\n\nnonsense = 3\n", "line 3: unknown key 'nonsense'"},
      {"[planes]\nno_such_key = 1\n", "'planes.no_such_key'"},
      {"[planner]\nnonsense = 1\n", "line 2: unknown key 'planner.non"},
      {"approach = 0.1\n", "unknown key 'approach'; there are [agg"},
      {"[inlier]\nsigma = 3\n",
       "'inlier.sigma'; there are inlier.cells, inlier.min_cosine, inlier.sigmas"},
      {"\nthreads = \"two\"\n", "line 2: key 'threads'"},
      {"threads = 1.5\n", "'threads'"},
      {"threads = 99999999999\n", "'threads'"},
      {"threads = 0\n", "threads"},
      {"seed = -1\n", "'seed'"},
      {"seed = true\n", "'seed'"},
      {"seed = 1\nseed = \n", "line 2"},
      {"[planner]\napproach = \"far\"\n", "must be a number"},
      {"[planner]\nmax_grasps = 1.5\n", "must be an integer"},
      {"[planner.reach]\nbase = 1.0\n", "must be a list, each element a number"},
      {"[planner.reach]\nbase = [1.0, 2.0]\n", "planner.reach.base has 2 numbers: must have 3"},
      {"[planner.reach]\nmin = 2.0\nmax = 1.0\n", "planner.reach.min = 2: must not exceed"},
      {"[planner]\nunknown = \"maybe\"\n", "one of weighed, obstacle, target-shadow, free"},
      {"[planner]\napproach = -1.0\n", "approach = -1: must lie between 0 and 1 m"},
      {"[planner]\nbaseline = 2\n", "planner.baseline = 2: must lie between"},
      {"[planner]\nbaseline = nan\n", "planner.baseline = nan: must lie"},
      {"[planner]\nmax_wall = 0.06\n", "max_wall = 0.06: must lie between"},
      {"[planner]\nmin_wall = 0.009\n",
       "planner.min_wall = 0.009: must not exceed planner.max_wall = 0.008"}};
  for (const auto& [text, part] : cases) {
    const std::string error = config_error(text);
    INFO(text << "-> " << error);
    CHECK(contains(error, part));
  }
  CHECK_FALSE(contains(config_error("[inlier]\nsigma = 3\n"), "seed"));
  CHECK(contains(error_of([] { io::load_config("/no/such.toml"); }), "no such file"));
}
