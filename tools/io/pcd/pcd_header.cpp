#include "io/pcd/pcd_header.hpp"

#include <algorithm>
#include <limits>
#include <string_view>

#include "io/file_bytes.hpp"
#include "io/header_lines.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille::io {
namespace {

using Words = std::vector<std::string_view>;

/// Limit of the values in a field: more than any sensor's record has, and small enough that
/// products of sizes do not overflow.
constexpr std::uint64_t kMaxFieldValues = 1 << 20;
constexpr std::size_t kMaxFields = 4096;

class PcdHeaderReader {
 public:
  PcdHeaderReader(std::span<const std::byte> bytes, const std::string& name)
      : cursor_(bytes), name_(name) {}

  PcdHeader read() {
    bool has_data = false;
    while (!has_data) {
      const auto line = cursor_.next_line();
      if (!line) fail("DATA", "the file ends before this header line; is it a PCD file?");
      const Words words = split_words(*line);
      if (words.empty() || words[0].front() == '#') continue;
      has_data = words[0] == "DATA";
      read_entry(words);
    }
    header_.size = cursor_.offset();
    check_size();
    find_position();
    find_colour();
    return header_;
  }

 private:
  [[noreturn]] void fail(std::string_view field, const std::string& what) const {
    throw FileError(name_, std::string(field), what);
  }

  void read_entry(const Words& words) {
    if (words[0] == "VERSION") return;
    if (words[0] == "FIELDS" || words[0] == "COLUMNS") return read_fields(words);
    if (words[0] == "SIZE" || words[0] == "TYPE" || words[0] == "COUNT") return read_row(words);
    if (words[0] == "WIDTH") return read_count(words, &header_.width);
    if (words[0] == "HEIGHT") return read_count(words, &header_.height);
    if (words[0] == "POINTS") {
      read_count(words, &header_.points);
      has_points_ = true;
      return;
    }
    if (words[0] == "VIEWPOINT") return read_viewpoint(words);
    if (words[0] == "DATA") return read_data(words);
    fail("header", "unknown entry '" + printable(words[0]) + "'; is it a PCD file?");
  }

  void read_fields(const Words& words) {
    if (words.size() < 2 || words.size() > kMaxFields) fail(words[0], "names no fields");
    header_.fields.clear();
    for (std::size_t i = 1; i < words.size(); ++i) {
      header_.fields.push_back({std::string(words[i]), 4, 'F', 1});
    }
  }

  void read_row(const Words& words) {
    if (words.size() != header_.fields.size() + 1) {
      fail(words[0], "must have one value for each of the " +
                         std::to_string(header_.fields.size()) + " FIELDS");
    }
    for (std::size_t i = 0; i < header_.fields.size(); ++i) {
      set_value(words[0], words[i + 1], &header_.fields[i]);
    }
  }

  void set_value(std::string_view row, std::string_view word, PcdField* field) const {
    if (row == "TYPE") {
      if (word != "F" && word != "I" && word != "U") fail(row, "must hold F, I or U only");
      field->type = word.front();
      return;
    }
    const auto value = to_count(word);
    if (row == "SIZE") {
      if (!value || (*value != 1 && *value != 2 && *value != 4 && *value != 8)) {
        fail(row, "must hold 1, 2, 4 or 8 only");
      }
      field->size = *value;
    } else {
      if (!value || *value > kMaxFieldValues) fail(row, "must hold small positive numbers");
      field->count = *value;
    }
  }

  void read_count(const Words& words, std::uint64_t* count) const {
    const auto value = words.size() == 2 ? to_count(words[1]) : std::nullopt;
    if (!value) fail(words[0], "must be one non-negative integer");
    *count = *value;
  }

  void read_viewpoint(const Words& words) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto value = words.size() > 3 ? to_number(words[i + 1]) : std::nullopt;
      if (!value || std::abs(*value) > std::numeric_limits<float>::max() || *value != *value) {
        fail(words[0], "must be finite numbers: tx ty tz qw qx qy qz");
      }
      header_.viewpoint[static_cast<Eigen::Index>(i)] = *value;
    }
  }

  void read_data(const Words& words) {
    const std::string_view data = words.size() > 1 ? words[1] : "";
    if (data == "ascii") {
      header_.data = PcdHeader::Data::kAscii;
    } else if (data == "binary") {
      header_.data = PcdHeader::Data::kBinary;
    } else if (data == "binary_compressed") {
      header_.data = PcdHeader::Data::kCompressed;
    } else {
      fail(words[0], "must be ascii, binary or binary_compressed");
    }
  }

  void check_size() {
    std::uint64_t product = 0;
    constexpr std::uint64_t kMax = std::numeric_limits<int>::max();
    if (header_.width > kMax || header_.height > kMax) {
      fail("WIDTH", "WIDTH and HEIGHT must be below 2^31; correct them");
    }
    product = header_.width * header_.height;
    if (!has_points_) header_.points = product;
    if (header_.points != product) {
      fail("POINTS", std::to_string(header_.points) + " is not WIDTH x HEIGHT = " +
                         std::to_string(product) + "; correct one of them");
    }
  }

  void find_position() {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string wanted(1, "xyz"[axis]);
      const auto found = std::find_if(header_.fields.begin(), header_.fields.end(),
                                      [&](const PcdField& f) { return f.name == wanted; });
      if (found == header_.fields.end() || found->type != 'F' || found->size < 4 ||
          found->count != 1) {
        fail("FIELDS", "field " + wanted +
                           " must be there as one float of 4 or 8 bytes; export the cloud so");
      }
      header_.position[axis] = static_cast<std::size_t>(found - header_.fields.begin());
    }
  }

  void find_colour() {
    const auto found =
        std::find_if(header_.fields.begin(), header_.fields.end(), [](const PcdField& f) {
          return (f.name == "rgb" || f.name == "rgba") && f.size == 4 && f.count == 1;
        });
    if (found == header_.fields.end()) return;
    header_.rgb = static_cast<std::size_t>(found - header_.fields.begin());
  }

  TextCursor cursor_;
  const std::string& name_;
  PcdHeader header_;
  bool has_points_ = false;
};

}  // namespace

std::uint64_t PcdHeader::point_step() const { return offset_of(fields.size()); }

std::uint64_t PcdHeader::values_per_point() const {
  std::uint64_t values = 0;
  for (const PcdField& field : fields) values += field.count;
  return values;
}

std::uint64_t PcdHeader::offset_of(std::size_t field) const {
  std::uint64_t offset = 0;
  for (std::size_t i = 0; i < field; ++i) offset += fields[i].size * fields[i].count;
  return offset;
}

PcdHeader parse_pcd_header(std::span<const std::byte> bytes, const std::string& name) {
  return PcdHeaderReader(bytes, name).read();
}

}  // namespace quadrille::io
