// Real scans in other frames than the camera's; see tests/CMakeLists.txt.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "io/cloud_file.hpp"
#include "support/catch.hpp"
#include "support/rounds.hpp"
#include "tools/detections.hpp"
#include "tools/moved_scan.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using nlohmann::json;

namespace {

/// The scans of both sets.
std::vector<std::string> all_scans() {
  std::vector<std::string> scans;
  for (const std::string set : {"real", "real2"}) {
    const auto folder = std::filesystem::path(QUADRILLE_DATA_FOLDER) / "data" / set;
    if (!std::filesystem::exists(folder)) continue;
    const json manifest = test::manifest_of(folder);
    for (const json& scan : manifest["scenes"]) {
      if (scan.contains("file"))
        scans.push_back((folder / scan["file"].get<std::string>()).string());
    }
  }
  return scans;
}

}  // namespace

TEST_CASE("real scans turned and moved yield the grasps of the camera's frame",
          "[command][frames][real][slow]") {
  const test::TempFolder folder;
  std::mt19937 random(13);
  std::size_t grasps = 0, scans = 0;
  for (const std::string& scan : all_scans()) {
    const json in_K = test::plan("--gripper franka '" + scan + "'");
    const PointCloud cloud = io::read_cloud(scan);
    for (int k = 0; k < test::rounds(); ++k) {
      const Eigen::Isometry3d X_WK = test::random_camera_pose(random);
      const std::string moved = folder.write("moved.ply", test::moved_ply(cloud, X_WK));
      CAPTURE(scan, k);
      grasps += test::check_same_grasps(
          in_K,
          test::plan("--gripper franka " + moved + " --camera-pose=" + test::pose_option(X_WK)),
          X_WK);
    }
    ++scans;
  }
  CHECK(scans >= 10);
  CHECK(grasps > 10);
}
