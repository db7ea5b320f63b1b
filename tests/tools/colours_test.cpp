#include <cstring>
#include <vector>

#include "io/cloud_file.hpp"
#include "io/pcd/pcd.hpp"
#include "io/ply/ply.hpp"
#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using test::bytes_of;
using test::put;

namespace {

/// Of three points the second is missing.
const std::vector<Rgb> kRgb = {{1, 2, 3}, {9, 9, 9}, {250, 128, 7}};

float coordinate(int point, int axis) {
  return point == 1 ? 0.0f : static_cast<float>(1 + point + 10 * axis);
}

std::uint32_t packed_rgb(const Rgb& rgb) {
  return (std::uint32_t{rgb[0]} << 16) | (std::uint32_t{rgb[1]} << 8) | rgb[2];
}

std::string pcd_head(const std::string& colour, const std::string& type, const std::string& data) {
  return "VERSION .7\nFIELDS x " + colour + " y z\nSIZE 4 4 4 4\nTYPE F " + type +
         " F F\nCOUNT 1 1 1 1\nWIDTH 3\nHEIGHT 1\nPOINTS 3\nDATA " + data + "\n";
}

void check_colours(const PointCloud& cloud) {
  REQUIRE(cloud.points.size() == 2);
  REQUIRE(cloud.colours.size() == 2);
  CHECK(cloud.coloured());
  CHECK(cloud.points[1].x() == 3.0f);
  CHECK(cloud.colours[0] == kRgb[0]);
  CHECK(cloud.colours[1] == kRgb[2]);
}

}  // namespace

TEST_CASE("the packed colours of a PCD file stay with their points", "[pcd][colours]") {
  for (const std::string colour : {"rgb", "rgba"}) {
    for (const std::string type : {"F", "U"}) {
      std::string file = pcd_head(colour, type, "binary");
      for (int i = 0; i < 3; ++i) {
        put(&file, coordinate(i, 0), false);
        put(&file, packed_rgb(kRgb[static_cast<std::size_t>(i)]) | 0xff000000u, false);
        put(&file, coordinate(i, 1), false);
        put(&file, coordinate(i, 2), false);
      }
      CAPTURE(colour, type);
      check_colours(io::parse_pcd(bytes_of(file), "a.pcd"));
    }
  }
}

TEST_CASE("colours of a PCD file in text are numbers or the floats of their bits",
          "[pcd][colours]") {
  // 0x010203 is 66051 and 0xFA8007 is 16416775; as bits of a float 9.255716e-41 and 2.300480e-38.
  for (const auto& [first, last] :
       {std::pair("66051", "16416775"), std::pair("9.25571632e-41", "2.3004802e-38"),
        std::pair("4278256131", "4294606855")}) {
    const std::string file =
        pcd_head("rgb", "F", "ascii") + "1 " + first + " 11 21\n0 0 0 0\n3 " + last + " 13 23\n";
    CAPTURE(first);
    check_colours(io::parse_pcd(bytes_of(file), "a.pcd"));
  }
}

TEST_CASE("the colours of a PLY file stay with their points", "[ply][colours]") {
  const std::string properties =
      "element vertex 3\nproperty uchar blue\nproperty float x\nproperty float y\n"
      "property float z\nproperty uchar red\nproperty uchar green\nend_header\n";
  std::string binary = "ply\nformat binary_little_endian 1.0\n" + properties;
  std::string text = "ply\nformat ascii 1.0\n" + properties;
  for (int i = 0; i < 3; ++i) {
    const Rgb& rgb = kRgb[static_cast<std::size_t>(i)];
    put(&binary, rgb[2], false);
    text += std::to_string(rgb[2]);
    for (int axis = 0; axis < 3; ++axis) {
      put(&binary, coordinate(i, axis), false);
      text += " " + std::to_string(coordinate(i, axis));
    }
    put(&binary, rgb[0], false);
    put(&binary, rgb[1], false);
    text += " " + std::to_string(rgb[0]) + " " + std::to_string(rgb[1]) + "\n";
  }
  check_colours(io::parse_ply(bytes_of(binary), "a.ply"));
  check_colours(io::parse_ply(bytes_of(text), "a.ply"));
}

TEST_CASE("a coloured cloud is written and read as it is", "[ply][colours]") {
  PointCloud cloud;
  cloud.points = {{1, 2, 3}, {4, 5, 6}};
  cloud.colours = {{1, 2, 3}, {255, 0, 128}};
  const std::string file = io::ply_of(cloud);
  CHECK(io::parse_ply(bytes_of(file), "a.ply").colours == cloud.colours);
  cloud.colours.clear();
  CHECK(io::parse_ply(bytes_of(io::ply_of(cloud)), "a.ply").colours.empty());
  // A file that ends within the last colour.
  CHECK_THROWS(io::parse_ply(bytes_of(file.substr(0, file.size() - 1)), "a.ply"));
}

TEST_CASE("an organised cloud keeps a colour for each missing point", "[ply][colours]") {
  const std::string file =
      "ply\nformat ascii 1.0\ncomment width 2 height 2\nelement vertex 4\nproperty float x\n"
      "property float y\nproperty float z\nproperty uchar red\nproperty uchar green\n"
      "property uchar blue\nend_header\n1 1 1 10 0 0\nnan nan nan 20 0 0\n1 2 1 30 0 0\n"
      "2 2 1 999 -5 nan\n";
  const PointCloud cloud = io::parse_ply(bytes_of(file), "a.ply");
  REQUIRE(cloud.organised());
  REQUIRE(cloud.coloured());
  CHECK(cloud.colours[2] == Rgb{30, 0, 0});
  // No byte holds these.
  CHECK(cloud.colours[3] == Rgb{0, 0, 0});
}

TEST_CASE("properties that are no bytes are no colours", "[ply][pcd][colours]") {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nproperty float red\nproperty float green\nproperty float blue\n"
      "end_header\n1 1 1 1 1 1\n";
  CHECK(io::parse_ply(bytes_of(ply), "a.ply").colours.empty());
  const std::string pcd =
      "FIELDS x y z rgb\nSIZE 4 4 4 1\nTYPE F F F U\nCOUNT 1 1 1 3\nWIDTH 1\nHEIGHT 1\n"
      "POINTS 1\nDATA ascii\n1 1 1 5 6 7\n";
  CHECK(io::parse_pcd(bytes_of(pcd), "a.pcd").colours.empty());
}
