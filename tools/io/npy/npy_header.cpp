#include "io/npy/npy_header.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string_view>

#include "io/file_bytes.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille::io {
namespace {

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr std::size_t kMaxFields = 1000, kMaxDimensions = 8;

std::string_view text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Parses the header's text, a dict of Python literals.
class Literals {
 public:
  Literals(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  [[noreturn]] void fail(const std::string& what) const {
    throw FileError(name_, "header", what + "; write it anew with numpy.save");
  }

  /// Consumes a character if it comes next.
  bool take(char c) {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) ++at_;
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  void expect(char c) {
    if (!take(c)) fail(fmt::format("'{}' is missing at byte {} of its dict", c, at_));
  }

  std::string string() {
    const char quote = take('\'') ? '\'' : '"';
    if (quote == '"') expect('"');
    const std::size_t end = text_.find(quote, at_);
    if (end == std::string_view::npos) fail("a string does not end");
    const std::string_view word = text_.substr(at_, end - at_);
    at_ = end + 1;
    return std::string(word);
  }

  bool truth() {
    take(' ');
    for (const std::string_view word : {"True", "False"}) {
      if (!text_.substr(at_).starts_with(word)) continue;
      at_ += word.size();
      return word == "True";
    }
    fail("fortran_order is neither True nor False");
  }

  /// Parses a tuple of counts, such as (480, 640, 3), (5,) or ().
  std::vector<std::uint64_t> counts() {
    std::vector<std::uint64_t> counts;
    expect('(');
    while (!take(')')) {
      if (counts.size() == kMaxDimensions) fail("the array has too many dimensions");
      take(' ');
      std::uint64_t count = 0;
      const char* const first = text_.data() + at_;
      const auto [end, error] = std::from_chars(first, text_.data() + text_.size(), count);
      if (error != std::errc{}) fail("the shape is no tuple of counts");
      at_ += static_cast<std::size_t>(end - first);
      counts.push_back(count);
      if (!take(',') && !take(' ') && at_ < text_.size() && text_[at_] != ')') expect(')');
    }
    return counts;
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  const std::string& name_;
};

/// Returns the number of bytes of a type, such as 4 for "<f4".
std::size_t size_of_type(const std::string& type, const Literals& literals) {
  std::size_t size = 0;
  const char* const end = type.data() + type.size();
  if (type.size() < 3 || type[1] == 'O' ||
      std::from_chars(type.data() + 2, end, size).ptr == type.data() + 2 || size > 1u << 20) {
    literals.fail(fmt::format("values of type '{}' are no numbers", printable(type)));
  }
  return type[1] == 'U' ? 4 * size : size;
}

/// Parses one field ('x', '<f4') or ('x', '<f4', (3,)) of records.
NpyField parse_field(Literals& literals) {
  NpyField field;
  literals.expect('(');
  field.name = literals.string();
  literals.expect(',');
  field.type = literals.string();
  field.size = size_of_type(field.type, literals);
  if (literals.take(',')) {
    for (const std::uint64_t count : literals.counts()) {
      if (__builtin_mul_overflow(field.size, count, &field.size))
        literals.fail("a field is too large");
    }
    field.type.clear();
  }
  literals.expect(')');
  return field;
}

void parse_type(Literals& literals, NpyHeader* header) {
  if (literals.take('[')) {
    while (!literals.take(']')) {
      if (header->fields.size() == kMaxFields) literals.fail("the records have too many fields");
      header->fields.push_back(parse_field(literals));
      if (!literals.take(',')) {
        literals.expect(']');
        break;
      }
    }
  } else {
    NpyField field;
    field.type = literals.string();
    field.size = size_of_type(field.type, literals);
    header->fields.push_back(field);
  }
  for (NpyField& field : header->fields) {
    field.offset = header->record_size;
    if (__builtin_add_overflow(header->record_size, field.size, &header->record_size)) {
      literals.fail("the records are too large");
    }
  }
}

void parse_dict(Literals literals, NpyHeader* header) {
  bool has_shape = false;
  literals.expect('{');
  while (!literals.take('}')) {
    const std::string key = literals.string();
    literals.expect(':');
    if (key == "descr" && header->fields.empty()) {
      parse_type(literals, header);
    } else if (key == "fortran_order") {
      header->fortran_order = literals.truth();
    } else if (key == "shape") {
      header->shape = literals.counts();
      has_shape = true;
    } else {
      literals.fail(fmt::format("the key '{}' is not expected", printable(key)));
    }
    if (!literals.take(',')) {
      literals.expect('}');
      break;
    }
  }
  if (header->fields.empty() || !has_shape) literals.fail("descr or shape is missing");
}

/// Returns the bytes of the dict.
std::span<const std::byte> dict_of(std::span<const std::byte> bytes, const std::string& name) {
  constexpr std::size_t kVersion = 6, kCount = 8;
  const std::size_t begin =
      kCount + (bytes.size() > kVersion && bytes[kVersion] == std::byte{1} ? 2 : 4);
  if (bytes.size() < begin) throw FileError(name, "", "is cut short; copy the file again");
  std::size_t size = 0;
  for (std::size_t n = kCount; n < begin; ++n) {
    size |= std::to_integer<std::size_t>(bytes[n]) << (8 * (n - kCount));
  }
  const std::span<const std::byte> rest = bytes.subspan(begin);
  if (size > rest.size()) {
    throw FileError(name, "header",
                    fmt::format("says that it has {} bytes, and {} follow; copy the file again",
                                size, rest.size()));
  }
  return rest.first(size);
}

void check_size(const NpyHeader& header, std::size_t available, const std::string& name) {
  std::size_t needed = header.record_size;
  bool fits = true;
  for (const std::uint64_t count : header.shape) {
    fits = fits && !__builtin_mul_overflow(needed, count, &needed);
  }
  if (fits && needed <= available) return;
  throw FileError(name, fmt::format("byte {}", header.data_offset),
                  fmt::format("the array needs {} bytes, and {} follow; copy the file again",
                              fits ? std::to_string(needed) : "too many", available));
}

}  // namespace

bool is_npy(std::span<const std::byte> bytes) { return text_of(bytes).starts_with(kMagic); }

NpyHeader parse_npy_header(std::span<const std::byte> bytes, const std::string& name) {
  if (!is_npy(bytes)) {
    throw FileError(name, "byte 0", "does not begin as a .npy file; write it with numpy.save");
  }
  const std::span<const std::byte> dict = dict_of(bytes, name);
  NpyHeader header;
  header.data_offset = static_cast<std::size_t>(dict.data() - bytes.data()) + dict.size();
  parse_dict(Literals(text_of(dict), name), &header);
  check_size(header, bytes.size() - header.data_offset, name);
  return header;
}

}  // namespace quadrille::io
