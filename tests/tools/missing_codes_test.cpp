// Codes for missing points in files.
#include "support/missing_codes.hpp"

#include <array>
#include <utility>

#include "detector/table_scene.hpp"
#include "io/cloud_file.hpp"
#include "io/ply/ply.hpp"
#include "quadrille/detector/detector.hpp"
#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

std::string pcd_of(const PointCloud& cloud) {
  const std::string width = std::to_string(cloud.width), height = std::to_string(cloud.height);
  std::string file = "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " +
                     width + "\nHEIGHT " + height + "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
                     std::to_string(cloud.points.size()) + "\nDATA binary\n";
  for (const Eigen::Vector3f& p : cloud.points) {
    for (const float x : p) put(&file, x);
  }
  return file;
}

}  // namespace

TEST_CASE("codes for missing points in files are told of, and read as gaps", "[io][hostile]") {
  const TempFolder folder;
  using Writer = std::string (*)(const PointCloud&);
  const std::array<std::pair<std::string, Writer>, 2> formats = {
      {{"cloud.pcd", pcd_of}, {"cloud.ply", io::ply_of}}};
  for (const auto& format : formats) {
    const auto found = [&](const PointCloud& cloud) {
      return detect(io::read_cloud(folder.write(format.first, format.second(cloud))));
    };
    const DetectionResult truth = found(with_gaps(table_cloud()));
    REQUIRE(find(truth, QuadricType::kSphere));
    CHECK(truth.warnings.empty());
    for (const float code : kMissingCodes) {
      CAPTURE(format.first, code);
      const DetectionResult result = found(with_code(table_cloud(), code));
      CHECK(numbers(result) == numbers(truth));
      CHECK(warns(result, "farther than 1 km") == std::isfinite(code));
    }
  }
}

TEST_CASE("the command plans on a scan with codes for missing points, and tells of them once",
          "[command][hostile]") {
  const TempFolder folder;
  const std::string path =
      folder.write("coded.pcd", pcd_of(with_code(table_cloud(), kMissingCodes[1])));
  for (const std::string command : {"detect ", "plan --gripper franka "}) {
    const Run run = run_quadrille(command + path);
    CHECK(run.code == 0);
    const std::size_t first = run.err.find("farther than 1 km");
    REQUIRE(first != std::string::npos);
    CHECK(run.err.find("farther than 1 km", first + 1) == std::string::npos);
  }
}
