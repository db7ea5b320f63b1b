#include "io/ply/ply_header.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "io/file_bytes.hpp"
#include "io/header_lines.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille::io {
namespace {

using Words = std::vector<std::string_view>;

std::optional<PlyScalar> scalar_of(std::string_view word) {
  static constexpr std::array<std::pair<std::string_view, PlyScalar>, 16> kNames = {{
      {"char", PlyScalar::kInt8},
      {"int8", PlyScalar::kInt8},
      {"uchar", PlyScalar::kUint8},
      {"uint8", PlyScalar::kUint8},
      {"short", PlyScalar::kInt16},
      {"int16", PlyScalar::kInt16},
      {"ushort", PlyScalar::kUint16},
      {"uint16", PlyScalar::kUint16},
      {"int", PlyScalar::kInt32},
      {"int32", PlyScalar::kInt32},
      {"uint", PlyScalar::kUint32},
      {"uint32", PlyScalar::kUint32},
      {"float", PlyScalar::kFloat32},
      {"float32", PlyScalar::kFloat32},
      {"double", PlyScalar::kFloat64},
      {"float64", PlyScalar::kFloat64},
  }};
  for (const auto& [name, scalar] : kNames) {
    if (name == word) return scalar;
  }
  return std::nullopt;
}

/// Reads one header line after the other and keeps its position for errors.
class PlyHeaderReader {
 public:
  PlyHeaderReader(std::span<const std::byte> bytes, const std::string& name)
      : cursor_(bytes), name_(name) {}

  PlyHeader read() {
    if (next() != "ply") fail("not a PLY file, it must begin with the line 'ply'");
    bool has_format = false;
    for (std::string_view line = next(); line != "end_header"; line = next()) {
      const Words words = split_words(line);
      if (words.empty()) continue;
      if (words[0] == "format") {
        read_format(words);
        has_format = true;
      } else {
        read_entry(words);
      }
    }
    if (!has_format) fail("the header has no 'format' line; add e.g. 'format ascii 1.0'");
    header_.size = cursor_.offset();
    return header_;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw FileError(name_, "line " + std::to_string(line_number_), what);
  }

  std::string_view next() {
    ++line_number_;
    const auto line = cursor_.next_line();
    if (!line) fail("the file ends within its header, before 'end_header'; copy it again");
    return *line;
  }

  void read_format(const Words& words) {
    const std::string_view format = words.size() > 1 ? words[1] : "";
    if (format == "ascii") {
      header_.format = PlyHeader::Format::kAscii;
    } else if (format == "binary_little_endian") {
      header_.format = PlyHeader::Format::kLittleEndian;
    } else if (format == "binary_big_endian") {
      header_.format = PlyHeader::Format::kBigEndian;
    } else {
      fail("unknown format '" + printable(format) +
           "'; it must be ascii, binary_little_endian or binary_big_endian");
    }
  }

  void read_entry(const Words& words) {
    if (words[0] == "element") {
      read_element(words);
    } else if (words[0] == "property") {
      read_property(words);
    } else if (words[0] == "comment" || words[0] == "obj_info") {
      read_comment(words);
    } else {
      fail("unknown header entry '" + printable(words[0]) + "'; remove it");
    }
  }

  void read_element(const Words& words) {
    const auto count = words.size() == 3 ? to_count(words[2]) : std::nullopt;
    if (!count) fail("an element needs a name and a count, such as 'element vertex 1200'");
    header_.elements.push_back({std::string(words[1]), *count, {}});
  }

  void read_property(const Words& words) {
    if (header_.elements.empty()) fail("a property stands before the first element");
    PlyProperty property;
    property.is_list = words.size() > 1 && words[1] == "list";
    const std::size_t expected = property.is_list ? 5 : 3;
    if (words.size() != expected) {
      fail("a property needs a type and a name, such as 'property float x'");
    }
    property.name = words.back();
    property.scalar = known_scalar(words[expected - 2]);
    if (property.is_list) property.count = known_scalar(words[2]);
    if (property.is_list && property.count >= PlyScalar::kFloat32) {
      fail("the count of a list must be an integer");
    }
    header_.elements.back().properties.push_back(property);
  }

  PlyScalar known_scalar(std::string_view word) const {
    const auto scalar = scalar_of(word);
    if (!scalar) fail("unknown type '" + printable(word) + "'");
    return *scalar;
  }

  /// Reads a comment. Comments are free text, so one that does not parse is no error.
  void read_comment(const Words& words) {
    if (words.size() >= 5 && words[1] == "viewpoint") {
      const auto x = to_number(words[2]), y = to_number(words[3]), z = to_number(words[4]);
      if (x && y && z && Eigen::Vector3d(*x, *y, *z).allFinite()) header_.viewpoint << *x, *y, *z;
    } else if (words.size() == 3 && words[1] == "frame") {
      header_.frame = words[2];
    }
    for (std::size_t i = 1; i + 1 < words.size(); ++i) {
      const auto count = to_count(words[i + 1]);
      if (!count) continue;
      if (words[i] == "width" || words[i] == "num_cols") header_.width = *count;
      if (words[i] == "height" || words[i] == "num_rows") header_.height = *count;
    }
  }

  TextCursor cursor_;
  const std::string& name_;
  PlyHeader header_;
  int line_number_ = 0;
};

}  // namespace

std::size_t size_of(PlyScalar scalar) {
  static constexpr std::array<std::size_t, 8> kSizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(scalar)];
}

bool PlyElement::has_list() const {
  return std::any_of(properties.begin(), properties.end(),
                     [](const PlyProperty& property) { return property.is_list; });
}

std::uint64_t PlyElement::min_bytes(bool ascii) const {
  if (ascii) return 2 * properties.size();
  std::uint64_t bytes = 0;
  for (const PlyProperty& p : properties) bytes += size_of(p.is_list ? p.count : p.scalar);
  return bytes;
}

PlyHeader parse_ply_header(std::span<const std::byte> bytes, const std::string& name) {
  return PlyHeaderReader(bytes, name).read();
}

}  // namespace quadrille::io
