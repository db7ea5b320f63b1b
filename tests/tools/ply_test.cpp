#include "io/ply/ply.hpp"

#include <limits>
#include <vector>

#include "io/cloud_file.hpp"
#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using test::bytes_of;
using test::error_of;
using test::put;

namespace {

const std::vector<Eigen::Vector3d> kPoints = {{1.5, -2.25, 3.0}, {0.125, 4.0, -5.5}, {7, 8, 9}};

PointCloud parse_ply(const std::string& file) { return io::parse_ply(bytes_of(file), "a.ply"); }

std::string ply_error(const std::string& file) {
  return error_of([&] { parse_ply(file); });
}

void check_points(const PointCloud& cloud) {
  REQUIRE(cloud.points.size() == kPoints.size());
  CHECK(cloud.read == kPoints.size());
  for (std::size_t i = 0; i < kPoints.size(); ++i)
    CHECK(cloud.points[i] == kPoints[i].cast<float>());
}

/// A file with a face element before the vertices, and among the vertex properties a list, a colour
/// and positions of the given type in the order z, x, y.
template <class Scalar>
std::string mixed_file(const std::string& format, const std::string& type, bool big, bool list) {
  std::string file = "ply\r\nformat " + format + " 1.0\r\nelement face 2\r\n" +
                     "property list uchar int vertex_indices\r\nelement vertex 3\r\n" +
                     "property " + type + " z\r\nproperty uchar red\r\n" +
                     (list ? "property list ushort float rays\r\n" : "") + "property " + type +
                     " x\r\nproperty " + type + " y\r\nelement edge 1\r\nproperty int a\r\n" +
                     "end_header\r\n";
  for (const std::uint8_t count : {3, 0}) {
    put(&file, count, big);
    for (std::int32_t i = 0; i < count; ++i) put(&file, i, big);
  }
  for (const Eigen::Vector3d& p : kPoints) {
    put(&file, static_cast<Scalar>(p.z()), big);
    put(&file, std::uint8_t{200}, big);
    if (list) {
      put(&file, std::uint16_t{2}, big);
      put(&file, 1.0f, big);
      put(&file, 2.0f, big);
    }
    put(&file, static_cast<Scalar>(p.x()), big);
    put(&file, static_cast<Scalar>(p.y()), big);
  }
  put(&file, std::int32_t{1}, big);
  return file;
}

std::string ascii_file(const std::string& comments, const std::string& count = "3") {
  return "ply\nformat ascii 1.0\n" + comments + "element vertex " + count +
         "\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
         "1.5 -2.25 3\n0.125 +4 -5.5\n7 8e0 9\n";
}

std::string binary_file(const std::string& count) {
  std::string file = "ply\nformat binary_little_endian 1.0\nelement vertex " + count +
                     "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  for (const Eigen::Vector3d& p : kPoints) {
    for (int i = 0; i < 3; ++i) put(&file, static_cast<float>(p[i]));
  }
  return file;
}

}  // namespace

TEST_CASE("binary PLY is read in both byte orders, both widths and any property order", "[ply]") {
  for (const bool list : {false, true}) {
    check_points(parse_ply(mixed_file<float>("binary_little_endian", "float", false, list)));
    check_points(parse_ply(mixed_file<float>("binary_big_endian", "float32", true, list)));
    check_points(parse_ply(mixed_file<double>("binary_little_endian", "double", false, list)));
    check_points(parse_ply(mixed_file<double>("binary_big_endian", "float64", true, list)));
  }
}

TEST_CASE("ascii PLY is read with other elements and lists around the positions", "[ply]") {
  check_points(parse_ply(ascii_file("")));
  check_points(parse_ply(
      "ply\nformat ascii 1.0\nelement face 2\nproperty list uchar int i\nelement vertex 3\n"
      "property double y\nproperty list uchar float l\nproperty float x\nproperty uchar c\n"
      "property float z\nend_header\n3 0 1 2\n0\n-2.25 1 9 1.5 7 3\n4 0 0.125 7 -5.5\n"
      "8 2 1 1 7 7 9"));
}

TEST_CASE("positions of different widths are read from binary PLY", "[ply]") {
  std::string file =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\n"
      "property double y\nproperty float z\nend_header\n";
  put(&file, 1.0f);
  put(&file, 2.0);
  put(&file, 3.0f);
  CHECK(parse_ply(file).points.at(0) == Eigen::Vector3f(1, 2, 3));
}

TEST_CASE("comments of a PLY file give viewpoint, frame and size", "[ply]") {
  const PointCloud cloud = parse_ply(ascii_file("comment viewpoint 1 -2 0.5\ncomment frame arm\n"));
  CHECK(cloud.viewpoint == Eigen::Vector3d(1, -2, 0.5));
  CHECK(cloud.frame == "arm");
  CHECK_FALSE(cloud.organised());
  const auto grid = [](const std::string& comments) {
    return parse_ply("ply\nformat ascii 1.0\n" + comments +
                     "element vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
                     "end_header\n1 1 1 2 2 2 nan nan nan 0 0 0 5 5 5 6 6 6\n");
  };
  for (const char* comments : {"comment width 3 height 2\n", "comment width 3\ncomment height 2\n",
                               "obj_info num_cols 3\nobj_info num_rows 2\n"}) {
    const PointCloud organised = grid(comments);
    CHECK(organised.width == 3);
    CHECK(organised.height == 2);
    REQUIRE(organised.points.size() == 6);
    CHECK(organised.points[2].array().isNaN().all());
    CHECK(organised.points[3].array().isNaN().all());
    CHECK(organised.points[4] == Eigen::Vector3f(5, 5, 5));
  }
  for (const char* comments :
       {"", "comment width 4 height 2\n", "comment width 4294967296 height 4294967296\n"}) {
    const PointCloud unorganised = grid(comments);
    CHECK_FALSE(unorganised.organised());
    CHECK(unorganised.points.size() == 4);
    CHECK(unorganised.read == 6);
  }
}

TEST_CASE("a written PLY file reads back bit for bit", "[ply]") {
  const test::TempFolder folder;
  PointCloud cloud;
  cloud.points = {{0.1f, 0.2f, 0.3f}, {1e-30f, -1, 2}, {3, 4, 5}, {6, 7, 8}};
  cloud.points[3].setConstant(std::numeric_limits<float>::quiet_NaN());
  cloud.width = cloud.height = 2;
  cloud.viewpoint = {0.1, 0.2, -0.3};
  cloud.frame = "camera";
  io::write_ply(folder.path("a.ply"), cloud);
  const PointCloud back = io::read_cloud(folder.path("a.ply"));
  CHECK(back.width == 2);
  CHECK(back.height == 2);
  CHECK(back.viewpoint == cloud.viewpoint);
  CHECK(back.frame == "camera");
  REQUIRE(back.points.size() == 4);
  for (int i = 0; i < 3; ++i) CHECK(back.points[i] == cloud.points[i]);
  CHECK(back.points[3].array().isNaN().all());
  CHECK_THROWS_AS(io::write_ply(folder.path("none/a.ply"), cloud), std::runtime_error);
}

TEST_CASE("wrong PLY files are refused with one line that names file and place", "[ply][hostile]") {
  const std::string head = "ply\nformat ascii 1.0\n";
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "line 1"},
      {"PNG", "line 1"},
      {"ply\n", "line 2"},
      {"ply\nformat utf8 1.0\nend_header\n", "line 2"},
      {"ply\nelement vertex 0\nend_header\n", "format"},
      {head + "end_header\n", "vertex"},
      {head + "element vertex 1\nproperty float x\nproperty float y\nend_header\n1 2\n",
       "property z"},
      {head + "element vertex 1\nproperty int x\nproperty float y\nproperty float z\nend_header\n",
       "property x"},
      {head + "element vertex -1\n" + xyz + "end_header\n", "line 3"},
      {head + "element vertex 99999999999999999999999\n" + xyz + "end_header\n", "line 3"},
      {head + "property float x\nend_header\n", "line 3"},
      {head + "element vertex 1\nproperty quaternion x\nend_header\n", "line 4"},
      {head + "element vertex 1\nproperty list float int x\nend_header\n", "line 4"},
      {head + "nonsense\nend_header\n", "line 3"},
      {head + "element vertex 1\n" + xyz + "end_header\n1 two 3\n", "byte 102"},
      {head + "element vertex 2\n" + xyz + "end_header\n1 2 3\n", "byte"},
      {ascii_file("", "18446744073709551615"), "byte"},
      {ascii_file("", "1000000000"), "byte"},
      {binary_file("4"), "byte 151"},
      {binary_file("18446744073709551615"), "byte"},
      {binary_file("1537228672809129302"), "byte"},
  };
  for (const auto& [file, place] : cases) {
    const std::string error = ply_error(file);
    INFO(file << "\n-> " << error);
    CHECK(error.find("a.ply: ") == 0);
    CHECK(error.find(place) != std::string::npos);
    CHECK(error.find('\n') == std::string::npos);
  }
}

TEST_CASE("lists of wrong length are refused, not followed", "[ply][hostile]") {
  std::string file =
      "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list int double i\n"
      "element vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  std::string negative = file, huge = file;
  put(&negative, std::int32_t{-1});
  put(&huge, std::int32_t{0x7fffffff});
  for (std::string* f : {&negative, &huge}) f->append(16, '\0');
  CHECK(ply_error(negative).find("negative") != std::string::npos);
  CHECK(ply_error(huge).find("the file ends") != std::string::npos);
}

TEST_CASE("no beginning of a PLY file is taken for a whole one", "[ply][hostile]") {
  for (const std::string& file :
       {mixed_file<float>("binary_little_endian", "float", false, true), binary_file("3")}) {
    const std::string vertices_end =
        file.substr(0, file.size() - (file.find("edge") < 999 ? 4 : 0));
    for (std::size_t size = 0; size < vertices_end.size(); ++size) {
      INFO("first " << size << " bytes");
      REQUIRE_FALSE(ply_error(file.substr(0, size)).empty());
    }
  }
}

TEST_CASE("a PLY file without points gives an empty cloud", "[ply]") {
  CHECK(parse_ply(binary_file("0")).points.empty());
  CHECK(parse_ply("ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
                  "property float z\nend_header\n")
            .points.empty());
}
