#include "io/pcd/pcd.hpp"

#include <liblzf/lzf.h>

#include <limits>
#include <vector>

#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using test::bytes_of;
using test::error_of;
using test::put;

namespace {

PointCloud parse(const std::string& file) { return io::parse_pcd(bytes_of(file), "a.pcd"); }

std::string pcd_error(const std::string& file) {
  return error_of([&] { parse(file); });
}

/// Header of a cloud with a normal of three values and a colour among the positions.
std::string header(const std::string& data, int size, int width, int height) {
  const std::string s = std::to_string(size);
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS rgb z n x y\nSIZE 4 " +
         s + " 4 " + s + " " + s + "\nTYPE U F F F F\nCOUNT 1 1 3 1 1\nWIDTH " +
         std::to_string(width) + "\nHEIGHT " + std::to_string(height) +
         "\nVIEWPOINT 1 2 3 1 0 0 0\nPOINTS " + std::to_string(width * height) + "\nDATA " + data +
         "\n";
}

/// Coordinates of point i.
Eigen::Vector3d point(int i) { return {i + 0.5, -i - 1.0, 2.0 * i + 1}; }

template <class Scalar>
std::string record(int i) {
  std::string bytes;
  put(&bytes, std::uint32_t{0xff00ff});
  put(&bytes, static_cast<Scalar>(point(i).z()));
  for (int k = 0; k < 3; ++k) put(&bytes, 0.25f);
  put(&bytes, static_cast<Scalar>(point(i).x()));
  put(&bytes, static_cast<Scalar>(point(i).y()));
  return bytes;
}

template <class Scalar>
std::string binary_file(int width, int height) {
  std::string file = header("binary", sizeof(Scalar), width, height);
  for (int i = 0; i < width * height; ++i) file += record<Scalar>(i);
  return file;
}

/// All values of one field after the other.
template <class Scalar>
std::string columns(int count) {
  std::string all;
  for (int i = 0; i < count; ++i) put(&all, std::uint32_t{7});
  for (int i = 0; i < count; ++i) put(&all, static_cast<Scalar>(point(i).z()));
  for (int i = 0; i < 3 * count; ++i) put(&all, 0.25f);
  for (int i = 0; i < count; ++i) put(&all, static_cast<Scalar>(point(i).x()));
  for (int i = 0; i < count; ++i) put(&all, static_cast<Scalar>(point(i).y()));
  return all;
}

std::string compressed(const std::string& head, const std::string& raw) {
  std::string packed(raw.size() + 64, '\0');
  packed.resize(lzf_compress(raw.data(), static_cast<unsigned>(raw.size()), packed.data(),
                             static_cast<unsigned>(packed.size())));
  REQUIRE_FALSE(packed.empty());
  std::string file = head;
  put(&file, static_cast<std::uint32_t>(packed.size()));
  put(&file, static_cast<std::uint32_t>(raw.size()));
  return file + packed;
}

template <class Scalar>
std::string compressed_file(int width, int height) {
  return compressed(header("binary_compressed", sizeof(Scalar), width, height),
                    columns<Scalar>(width * height));
}

std::string ascii_file(int width, int height) {
  std::string file = header("ascii", 4, width, height);
  for (int i = 0; i < width * height; ++i) {
    const Eigen::Vector3d p = point(i);
    file += "4278190335 " + std::to_string(p.z()) + " 1 nan 3 " + std::to_string(p.x()) + " " +
            std::to_string(p.y()) + "\n";
  }
  return file;
}

void check_points(const PointCloud& cloud, int count) {
  REQUIRE(cloud.points.size() == static_cast<std::size_t>(count));
  CHECK(cloud.read == static_cast<std::size_t>(count));
  CHECK(cloud.viewpoint == Eigen::Vector3d(1, 2, 3));
  for (int i = 0; i < count; ++i) CHECK(cloud.points[i] == point(i).cast<float>());
}

}  // namespace

TEST_CASE("PCD is read as ascii, binary and compressed, with floats and doubles", "[pcd]") {
  check_points(parse(ascii_file(5, 1)), 5);
  check_points(parse(binary_file<float>(5, 1)), 5);
  check_points(parse(binary_file<double>(5, 1)), 5);
  check_points(parse(compressed_file<float>(50, 1)), 50);
  check_points(parse(compressed_file<double>(50, 1)), 50);
}

TEST_CASE("a PCD file of several rows is organised", "[pcd]") {
  for (const std::string& file :
       {ascii_file(4, 3), binary_file<float>(4, 3), compressed_file<double>(4, 3)}) {
    const PointCloud cloud = parse(file);
    CHECK(cloud.width == 4);
    CHECK(cloud.height == 3);
    check_points(cloud, 12);
  }
  CHECK_FALSE(parse(binary_file<float>(1, 12)).organised());
}

TEST_CASE("missing points stay in organised PCD clouds and leave others", "[pcd]") {
  const std::string fields = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n";
  const std::string points = "DATA ascii\nnan nan nan\n1 2 3\n0 0 0\n4 5 inf\n";
  CHECK(parse(fields + "WIDTH 2\nHEIGHT 2\nPOINTS 4\n" + points).points.size() == 4);
  const PointCloud flat = parse(fields + "WIDTH 4\nHEIGHT 1\nPOINTS 4\n" + points);
  REQUIRE(flat.points.size() == 1);
  CHECK(flat.points[0] == Eigen::Vector3f(1, 2, 3));
  CHECK(flat.read == 4);
}

TEST_CASE("older PCD headers without COUNT, VIEWPOINT or POINTS are read", "[pcd]") {
  const PointCloud cloud = parse(
      "VERSION .6\nCOLUMNS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 1\nDATA ascii\n"
      "1 2 3\n4 5 6");
  REQUIRE(cloud.points.size() == 2);
  CHECK(cloud.viewpoint.isZero());
}

TEST_CASE("positions of different widths are read from binary PCD", "[pcd]") {
  std::string file =
      "FIELDS x y z\nSIZE 4 8 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\nDATA binary\n";
  put(&file, 1.0f);
  put(&file, 2.0);
  put(&file, 3.0f);
  CHECK(parse(file).points.at(0) == Eigen::Vector3f(1, 2, 3));
}

TEST_CASE("wrong PCD files are refused with one line that names file and field", "[pcd][hostile]") {
  const std::string fields = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n";
  const std::string one = "WIDTH 1\nHEIGHT 1\nPOINTS 1\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "DATA"},
      {"ply\n", "header"},
      {"FIELDS\n", "FIELDS"},
      {"FIELDS x y\nSIZE 4 4\nTYPE F F\nCOUNT 1 1\n" + one + "DATA ascii\n1 2\n", "FIELDS"},
      {"FIELDS x y z\nSIZE 4 4\n", "SIZE"},
      {"FIELDS x y z\nSIZE 4 4 3\n", "SIZE"},
      {"FIELDS x y z\nTYPE F F Q\n", "TYPE"},
      {"FIELDS x y z\nCOUNT 1 1 99999999999\n", "COUNT"},
      {"FIELDS x y z\nSIZE 2 2 2\nTYPE I I I\nCOUNT 1 1 1\n" + one + "DATA ascii\n1 2 3\n",
       "FIELDS"},
      {fields + "WIDTH -1\nHEIGHT 1\nDATA ascii\n", "WIDTH"},
      {fields + "WIDTH 4294967296\nHEIGHT 4294967296\nPOINTS 0\nDATA binary\n", "WIDTH"},
      {fields + "WIDTH 2\nHEIGHT 2\nPOINTS 5\nDATA ascii\n", "POINTS"},
      {fields + one + "VIEWPOINT 0 nan 0 1 0 0 0\nDATA ascii\n1 2 3\n", "VIEWPOINT"},
      {fields + one + "DATA zip\n", "DATA"},
      {fields + one + "DATA ascii\n1 2\n", "byte"},
      {fields + one + "DATA ascii\n1 x 3\n", "byte"},
      {fields + "WIDTH 2000000000\nHEIGHT 2000000000\nDATA ascii\n1 2 3\n", "byte"},
      {fields + "WIDTH 2000000000\nHEIGHT 2000000000\nDATA binary\n123456789012", "byte"},
      {fields + "WIDTH 2000000000\nHEIGHT 1\nDATA binary_compressed\n123456789012", "byte"},
      {fields + one + "DATA binary_compressed\n123", "byte"},
  };
  for (const auto& [file, place] : cases) {
    const std::string error = pcd_error(file);
    INFO(file << "\n-> " << error);
    CHECK(error.find("a.pcd: ") == 0);
    CHECK(error.find(place) != std::string::npos);
    CHECK(error.find('\n') == std::string::npos);
  }
}

TEST_CASE("damaged compressed PCD data is refused", "[pcd][hostile]") {
  const std::string file = compressed_file<float>(50, 1);
  const std::string head = header("binary_compressed", 4, 50, 1);
  const auto with_sizes = [&](std::uint32_t packed, std::uint32_t raw) {
    std::string changed = head;
    put(&changed, packed);
    put(&changed, raw);
    return changed + file.substr(changed.size());
  };
  const auto packed = static_cast<std::uint32_t>(file.size() - head.size() - 8);
  CHECK(pcd_error(with_sizes(packed, 28 * 50)).empty());
  CHECK_FALSE(pcd_error(with_sizes(packed + 1, 28 * 50)).empty());
  CHECK_FALSE(pcd_error(with_sizes(packed - 1, 28 * 50)).empty());
  CHECK_FALSE(pcd_error(with_sizes(packed, 28 * 51)).empty());
  CHECK_FALSE(pcd_error(with_sizes(2, 28 * 50)).empty());
}

TEST_CASE("a compressed PCD file cannot demand more memory than it can fill", "[pcd][hostile]") {
  std::string file =
      "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 300000000\nHEIGHT 1\n"
      "DATA binary_compressed\n";
  put(&file, std::uint32_t{100});
  put(&file, std::uint32_t{3600000000u});
  file.append(100, '\0');
  CHECK(pcd_error(file).find("can hold") != std::string::npos);
}

TEST_CASE("no beginning of a PCD file is taken for a whole one", "[pcd][hostile]") {
  for (const std::string& file : {binary_file<float>(3, 1), compressed_file<float>(9, 1)}) {
    for (std::size_t size = 0; size < file.size(); ++size) {
      INFO("first " << size << " bytes");
      REQUIRE_FALSE(pcd_error(file.substr(0, size)).empty());
    }
  }
}
