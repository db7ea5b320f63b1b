#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>

#include "io/file_bytes.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille::io {

/// Returns the line of a node as "line 7".
inline std::string line_of(const toml::node& node) {
  return "line " + std::to_string(node.source().begin.line);
}

/// Parses TOML from the file `path`.
/// @throws FileError naming the line
inline toml::table parse_toml(std::string_view text, const std::string& path) {
  try {
    return toml::parse(text, path);
  } catch (const toml::parse_error& error) {
    throw FileError(path, "line " + std::to_string(error.source().begin.line),
                    "no valid TOML: " + printable(error.description(), 200));
  }
}

/// Parses a TOML file.
/// @throws FileError naming the line
inline toml::table read_toml(const std::string& path) {
  const std::vector<std::byte> bytes = read_file(path);
  return parse_toml({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path);
}

}  // namespace quadrille::io
