#include "io/config.hpp"

#include <stdexcept>

#include "io/gripper_file.hpp"
#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using test::contains;
using test::error_of;

namespace {

std::string config_error(const std::string& text) {
  const test::TempFolder folder;
  const std::string path = folder.write("c.toml", text);
  const std::string error = error_of([&] { io::load_settings(path); });
  if (!error.empty()) CHECK(error.find(path) == 0);
  return error;
}

const std::string kGripper =
    "name = \"pinch\"\nmax_opening = 0.1\nmin_opening = 0.0\nfinger = [0.02, 0.015, 0.05]\n"
    "finger_front = 0.01\npad = [0.02, 0.02]\npalm = [0.06, 0.2, 0.06]\nmax_force = 70\n";

std::string gripper_error(const std::string& text) {
  const test::TempFolder folder;
  return error_of([&] { io::read_gripper(folder.write("g.toml", text)); });
}

}  // namespace

TEST_CASE("a configuration sets what it names and leaves the rest", "[config]") {
  const test::TempFolder folder;
  const DetectorOptions options =
      io::load_settings(folder.write("c.toml", "# mine\nseed = 42\n")).detector;
  CHECK(options.seed == 42);
  CHECK(options.threads == DetectorOptions().threads);
}

TEST_CASE("the printed defaults read back as the defaults", "[config]") {
  const test::TempFolder folder;
  DetectorOptions back =
      io::load_settings(folder.write("c.toml", io::default_detector_config())).detector;
  DetectorOptions defaults;
  const TrackOptions track =
      io::load_settings(folder.write("c.toml", io::default_detector_config())).track;
  CHECK(track.forget_after == TrackOptions().forget_after);
  std::vector<double> a, b;
  visit_options(back, [&](const char*, auto& field) { a.push_back(static_cast<double>(field)); });
  visit_options(defaults,
                [&](const char*, auto& field) { b.push_back(static_cast<double>(field)); });
  CHECK(a == b);
}

TEST_CASE("each kind of basis has its word, and others are refused with the list", "[config]") {
  const test::TempFolder folder;
  const auto basis = [&](const std::string& word) {
    return io::load_settings(folder.write("c.toml", "[search]\nbasis = \"" + word + "\"\n"))
        .detector.search.basis;
  };
  CHECK(basis("two_points") == BasisKind::kTwoPoints);
  CHECK(basis("three_points") == BasisKind::kThreePoints);
  CHECK(basis("four_points") == BasisKind::kFourPoints);
  CHECK(basis("nine_points") == BasisKind::kNinePoints);
  CHECK(basis("sphere") == BasisKind::kSphere);
  CHECK(contains(config_error("[search]\nbasis = \"five_points\"\n"), "two_points, sphere"));
}

TEST_CASE("a wrong configuration is refused with its key and line", "[config][hostile]") {
  const std::string unknown = config_error("seed = 1\n\nnonsense = 3\n");
  CHECK(contains(unknown, "line 3"));
  CHECK(contains(unknown, "'nonsense'"));
  CHECK(contains(config_error("[planes]\nno_such_key = 1\n"), "'planes.no_such_key'"));
  CHECK(contains(config_error("\nthreads = \"two\"\n"), "line 2: key 'threads'"));
  CHECK(contains(config_error("threads = 1.5\n"), "'threads'"));
  CHECK(contains(config_error("threads = 99999999999\n"), "'threads'"));
  CHECK(contains(config_error("seed = -1\n"), "'seed'"));
  CHECK(contains(config_error("seed = true\n"), "'seed'"));
  CHECK(contains(config_error("threads = 0\n"), "threads"));
  CHECK(contains(config_error("seed = 1\nseed = \n"), "line 2"));
  CHECK(contains(error_of([] { io::load_settings("/no/such.toml"); }), "no such file"));
}

TEST_CASE("a gripper is read from its file", "[gripper]") {
  const test::TempFolder folder;
  const Gripper gripper = io::load_gripper(folder.write("g.toml", kGripper));
  CHECK(gripper.name == "pinch");
  CHECK(gripper.max_opening == 0.1);
  CHECK(gripper.finger == Eigen::Vector3d(0.02, 0.015, 0.05));
  CHECK(gripper.pad == Eigen::Vector2d(0.02, 0.02));
  CHECK(gripper.palm == Eigen::Vector3d(0.06, 0.2, 0.06));
  CHECK(gripper.finger_front == 0.01);
  CHECK(gripper.max_force == 70.0);
}

TEST_CASE("the Robotiq hands are known by name, with links that close them", "[gripper]") {
  const Gripper small = io::load_gripper("robotiq_2f85");
  CHECK(small.max_opening == 0.085);
  CHECK(small.extension(0.0) == Approx(0.0139).margin(3e-4));
  const Gripper large = io::load_gripper("robotiq_2f140");
  CHECK(large.max_opening == 0.1285);
  CHECK(large.extension(0.0) == Approx(0.0237).margin(3e-4));
  std::string unknown;
  try {
    io::load_gripper("claw");
  } catch (const std::invalid_argument& error) {
    unknown = error.what();
  }
  CHECK(contains(unknown, "known: franka, wsg50, robotiq_2f140, robotiq_2f85"));
}

TEST_CASE("a contradiction in a gripper file is one line with file, field and remedy",
          "[gripper][hostile]") {
  const test::TempFolder folder;
  std::string text = kGripper;
  text.replace(text.find("max_opening = 0.1"), 17, "max_opening = 0.0");
  const std::string path = folder.write("g.toml", text);
  const std::string error = error_of([&] { io::load_gripper(path); });
  CHECK(contains(error, path));
  CHECK(contains(error, "max_opening must be positive; measure it on the hand"));
  CHECK_FALSE(contains(error, "\n"));
  CHECK(contains(gripper_error(kGripper + "link_angle = 0.5\n"), "link_length is missing"));
  CHECK(contains(gripper_error(kGripper + "tcp = \"far\"\n"), "'tcp' must be a number"));
}

TEST_CASE("a wrong gripper file is refused with its key", "[gripper][hostile]") {
  CHECK(gripper_error(kGripper).empty());
  CHECK(contains(gripper_error(kGripper + "thumb = 1\n"), "line 9: unknown key 'thumb'"));
  CHECK(contains(gripper_error("max_opening = 0.1\n"), "'min_opening' is missing"));
  CHECK(contains(gripper_error("max_opening = \"wide\"\n"), "line 1: key 'max_opening'"));
  std::string two = kGripper;
  two.replace(two.find("[0.02, 0.015, 0.05]"), 19, "[0.02, 0.015]");
  CHECK(contains(gripper_error(two), "line 4: key 'finger'"));
}

TEST_CASE("one configuration holds the settings of the detector and of the planner", "[config]") {
  const test::TempFolder folder;
  const io::Settings settings = io::load_settings(
      folder.write("c.toml",
                   "seed = 5\n[planner]\nunknown = \"free\"\nresolution = 0.004\nfriction = 0.4\n"
                   "approach = 0.08\npad_margin = 0.001\nbaseline = 0\nmin_wall = 0.001\n"
                   "max_wall = 0.005\nclear_above = false\n[planes]\nsigmas = 2.5\n"));
  CHECK(settings.detector.seed == 5);
  CHECK(settings.detector.planes.sigmas == 2.5);
  CHECK(settings.planner.unknown == UnknownPolicy::kFree);
  CHECK(settings.planner.resolution == 0.004);
  CHECK(settings.planner.friction == 0.4);
  CHECK(settings.planner.approach == 0.08);
  CHECK(settings.planner.pad_margin == 0.001);
  CHECK(settings.planner.baseline == 0.0);
  CHECK(settings.planner.min_wall == 0.001);
  CHECK(settings.planner.max_wall == 0.005);
  CHECK_FALSE(settings.planner.clear_above);
  CHECK(settings.planner.max_grasps == PlanOptions().max_grasps);
}

TEST_CASE("a wrong setting of the planner is refused with its line or field", "[config][hostile]") {
  CHECK(contains(config_error("[planner]\nnonsense = 1\n"), "line 2: unknown key 'planner.non"));
  CHECK(contains(config_error("approach = 0.1\n"), "unknown key 'approach'; there are [agg"));
  CHECK(contains(config_error("[inlier]\nsigma = 3\n"),
                 "'inlier.sigma'; there are inlier.cells, inlier.min_cosine, inlier.sigmas"));
  CHECK_FALSE(contains(config_error("[inlier]\nsigma = 3\n"), "seed"));
  CHECK(contains(config_error("[planner]\napproach = \"far\"\n"), "must be a number"));
  CHECK(contains(config_error("[planner]\nmax_grasps = 1.5\n"), "must be an integer"));
  CHECK(contains(config_error("[planner]\nunknown = \"maybe\"\n"), "target-shadow or free"));
  CHECK(contains(config_error("[planner]\napproach = -1.0\n"), "approach must lie in"));
  CHECK(contains(config_error("[planner]\nbaseline = 2\n"), "baseline must lie in 0 to 1 m"));
  CHECK(contains(config_error("[planner]\nbaseline = nan\n"), "baseline must lie in 0 to 1 m"));
  CHECK(contains(config_error("[planner]\nmax_wall = 0.06\n"), "max_wall must lie in"));
  CHECK(contains(config_error("[planner]\nmin_wall = 0.009\n"), "in this order"));
}
