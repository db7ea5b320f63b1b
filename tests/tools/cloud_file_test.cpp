#include "io/cloud_file.hpp"

#include <cstdlib>
#include <string>

#include "io/file_bytes.hpp"
#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using test::contains;
using test::run_quadrille;
using test::TempFolder;

namespace {

/// Packed by the real gzip.
std::string packed(const std::string& path) {
  REQUIRE(std::system(("gzip -kf '" + path + "'").c_str()) == 0);
  return path + ".gz";
}

std::string read_error(const std::string& path) {
  return test::error_of([&] { io::read_cloud(path); });
}

}  // namespace

TEST_CASE("points as text are read as they stand", "[io]") {
  const TempFolder folder;
  const std::string path =
      folder.write("a.xyz", "# x y z r\n1 2 3 255\n\n-0.5,1e-1, 4\r\n\tnan nan nan\n");
  const PointCloud cloud = io::read_cloud(path);
  REQUIRE(cloud.points.size() == 3);
  CHECK(cloud.points[0] == Eigen::Vector3f(1, 2, 3));
  CHECK(cloud.points[1] == Eigen::Vector3f(-0.5F, 0.1F, 4));
  CHECK_FALSE(cloud.points[2].allFinite());
  CHECK(cloud.viewpoint.isZero());
  CHECK_FALSE(cloud.organised());
  Eigen::Isometry3d X_CF = Eigen::Isometry3d::Identity();
  X_CF.translation() = Eigen::Vector3d(0, 0, 1);
  const PointCloud moved = io::read_cloud(path, X_CF);
  CHECK(moved.points[0] == Eigen::Vector3f(1, 2, 4));
  CHECK(moved.viewpoint == Eigen::Vector3d(0, 0, 1));
  const PointCloud scaled = io::read_cloud(path, X_CF * Eigen::Scaling(0.5));
  CHECK(scaled.points[0] == Eigen::Vector3f(0.5F, 1.0F, 2.5F));
  CHECK(contains(read_error(folder.write("b.xyz", "1 2 3\n1 2\n")), "line 2"));
  CHECK(contains(read_error(folder.write("c.xyz", "1 2 3x\n")), "line 1"));
}

TEST_CASE("packed clouds are read, damaged ones refused", "[io]") {
  const TempFolder folder;
  const std::string plain = folder.write("a.ply", test::ply_of({"1 2 3", "4 5 6"}));
  const std::string path = packed(plain);
  CHECK(io::read_cloud(path).points == io::read_cloud(plain).points);
  const std::vector<std::byte> bytes = io::read_file(path);
  const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  CHECK(
      contains(read_error(folder.write("b.ply.gz", text.substr(0, text.size() / 2))), "cut short"));
  std::string damaged = text;
  damaged[text.size() / 2] ^= 0x55;
  CHECK(contains(read_error(folder.write("c.ply.gz", damaged)), "damaged"));
  CHECK(contains(read_error(folder.write("d.bin.gz", text)), "unknown kind of file"));
}

TEST_CASE("a cloud may come on the standard input", "[io][command]") {
  const TempFolder folder;
  REQUIRE(run_quadrille("scene --family easy --seed 2 " + folder.path("a.ply")).code == 0);
  const std::string path = folder.path("a.ply");
  const auto table = [](const test::Run& run) { return run.out.substr(run.out.find('\n')); };
  const test::Run named = run_quadrille("detect " + path);
  REQUIRE(contains(named.out, "score"));
  for (const std::string& file : {path, packed(path)}) {
    const test::Run piped = run_quadrille("detect - < '" + file + "'");
    CHECK(piped.code == 0);
    CHECK(contains(piped.out, "-: "));
    CHECK(table(piped) == table(named));
  }
  const test::Run nothing = run_quadrille("detect - < /dev/null");
  CHECK(nothing.code == 1);
  CHECK(contains(nothing.err, "standard input"));
}

TEST_CASE("help and the version may be asked for in any place", "[command]") {
  CHECK(run_quadrille("help").out == run_quadrille("--help").out);
  CHECK(run_quadrille("help detect").out == run_quadrille("detect --help").out);
  CHECK(run_quadrille("detect --version").out == run_quadrille("--version").out);
}
