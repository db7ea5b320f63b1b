#include "io/npy/npy.hpp"

#include <bit>
#include <cstdint>
#include <string>

#include "io/file_bytes.hpp"
#include "io/npy/npz.hpp"
#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using test::contains;

namespace {

/// A .npy file of version 1 whatever its header says.
std::string npy(const std::string& header, const std::string& data) {
  std::string text = "\x93NUMPY";
  text += {'\x01', '\x00', static_cast<char>(header.size() & 0xff),
           static_cast<char>(header.size() >> 8)};
  return text + header + data;
}

std::string bytes_of_floats(std::initializer_list<float> values) {
  std::string data;
  for (const float value : values) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (int shift = 0; shift < 32; shift += 8) data += static_cast<char>((bits >> shift) & 0xff);
  }
  return data;
}

std::string numpy_header(const std::string& type, const std::string& shape,
                         const std::string& fortran = "False") {
  return "{'descr': " + type + ", 'fortran_order': " + fortran + ", 'shape': " + shape + ", }   \n";
}

PointCloud parse_numpy(const std::string& text) {
  return io::parse_npy(std::as_bytes(std::span(text)), "a.npy");
}

std::string npy_error(const std::string& text) {
  return test::error_of([&] { parse_numpy(text); });
}

}  // namespace

TEST_CASE("arrays of numpy are read in the order in which they are stored", "[io]") {
  const std::string data = bytes_of_floats({1, 2, 3, 4, 5, 6});
  const PointCloud rows = parse_numpy(npy(numpy_header("'<f4'", "(2, 3)"), data));
  REQUIRE(rows.points.size() == 2);
  CHECK(rows.points[1] == Eigen::Vector3f(4, 5, 6));
  CHECK_FALSE(rows.organised());
  const PointCloud columns = parse_numpy(npy(numpy_header("'<f4'", "(2, 3)", "True"), data));
  REQUIRE(columns.points.size() == 2);
  CHECK(columns.points[1] == Eigen::Vector3f(2, 4, 6));
  const PointCloud image = parse_numpy(npy(numpy_header("'<f4'", "(2, 1, 3)"), data));
  CHECK(image.height == 2);
  CHECK(image.width == 1);
  const std::string record =
      "[('r', '|u1'), ('x', '<f4'), ('y', '<f4'), ('k', '<i2', (2,)), ('z', '<f4')]";
  const std::string bytes = "r" + bytes_of_floats({1, 2}) + "kkkk" + bytes_of_floats({3});
  const PointCloud records = parse_numpy(npy(numpy_header(record, "(1,)"), bytes));
  REQUIRE(records.points.size() == 1);
  CHECK(records.points[0] == Eigen::Vector3f(1, 2, 3));
  // The keys may come in any order.
  CHECK(parse_numpy(npy("{'shape':(2,3),'fortran_order':False,\"descr\":'<f4'}", data)).points ==
        rows.points);
}

TEST_CASE("files of numpy that are no cloud are refused in one line", "[io][hostile]") {
  const std::string data = bytes_of_floats({1, 2, 3, 4, 5, 6});
  CHECK(contains(npy_error("PLY"), "numpy.save"));
  for (const char* const begun : {"\x93NUMPY", "\x93NUMPY\x02", "\x93NUMPY\x03    "}) {
    CHECK(contains(npy_error(begun), "cut short"));
  }
  CHECK(contains(npy_error(npy(numpy_header("'<f4'", "(2, 3)"), data.substr(1))),
                 "24 bytes, and 23"));
  CHECK(contains(npy_error(npy(numpy_header("'<f4'", "(2, 3)"), "").substr(0, 40)), "header"));
  CHECK(contains(npy_error(npy(numpy_header("'<i2'", "(2, 3)"), data)), "'<i2' is no float"));
  CHECK(contains(npy_error(npy(numpy_header("'<f4'", "(3, 2)"), data)), "(3, 2) is no cloud"));
  CHECK(contains(npy_error(npy(numpy_header("'<f4'", "()"), data)), "shape"));
  CHECK(contains(npy_error(npy(numpy_header("'<f3f4'", "(2, 3)"), data)), "'<f3f4' is no float"));
  CHECK(contains(npy_error(npy(numpy_header("'|O'", "(2, 3)"), data)), "'|O'"));
  CHECK(contains(npy_error(npy(numpy_header("[('x', '<f4'), ('y', '<f4')]", "(3,)"), data)),
                 "field z"));
  for (const char* const hostile :
       {"(9223372036854775807, 3)", "(18446744073709551615, 18446744073709551615, 3)",
        "(6148914691236517206, 3)", "(99999999999999999999999, 3)", "(-1, 3)", "(2, 3", "2"}) {
    INFO(hostile);
    CHECK(contains(npy_error(npy(numpy_header("'<f4'", hostile), data)), "a.npy: "));
  }
  for (const char* const hostile :
       {"", "{", "{'descr'", "{'descr': '<f4",
        "{'descr': [('x', '<f99999999999999')], 'shape': (1,)}",
        "{'descr': [('x', '<f4', (9223372036854775807, 9))], 'shape': (1,)}",
        "{'descr': '<f4', 'fortran_order': Maybe, 'shape': (2, 3)}", "{'other': 1}"}) {
    INFO(hostile);
    CHECK(contains(npy_error(npy(hostile, data)), "header"));
  }
}

TEST_CASE("what only begins as a file of several arrays is refused", "[io][hostile]") {
  const std::string text = "PK\x03\x04 and so on";
  CHECK(io::is_npz(std::as_bytes(std::span(text))));
  CHECK_THROWS_WITH(io::parse_npz(std::as_bytes(std::span(text)), "a.npz"),
                    "a.npz: is a damaged .npz file; write it anew with numpy.savez");
}
