#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "support/error_of.hpp"
#include "support/temp_folder.hpp"

namespace quadrille::test {

/// What a run of the quadrille command left behind.
struct Run {
  int code = 0;
  std::string out, err;
};

/// Runs the built quadrille command through the shell.
/// @param before  what the shell does before
Run run_quadrille(const std::string& arguments, const std::string& before = "");

/// Sees to it that a run failed as it should: code 1, nothing on stdout, one line on stderr that
/// contains the part.
void check_failure(const Run& run, const std::string& part);

/// An ascii cloud of the given points.
std::string ply_of(const std::vector<std::string>& points);

int lines_of(const std::string& text);

bool contains(const std::string& text, const std::string& part);

inline std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text));
}

/// Appends the bytes of a number, least significant first or last.
template <class Number>
requires std::is_arithmetic_v<Number>
void put(std::string* to, Number value, bool big_endian = false) {
  const char* raw = reinterpret_cast<const char*>(&value);
  std::string bytes(raw, sizeof value);
  if (big_endian) bytes.assign(bytes.rbegin(), bytes.rend());
  *to += bytes;
}

}  // namespace quadrille::test
