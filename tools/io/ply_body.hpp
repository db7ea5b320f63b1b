#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "io/ply_header.hpp"

namespace quadrille::io {

/// Walks through the data of a PLY file, element by element.
class PlyBody {
 public:
  /// All three must outlive the walker.
  PlyBody(std::span<const std::byte> bytes, const PlyHeader& header, const std::string& name);

  /// Passes over all records of an element.
  /// @throws FileError if the data ends before
  void skip(const PlyElement& element);

  /// Reads three properties of all records of an element, as packed float32 x y z.
  /// @param columns  their places among the element's properties
  /// @throws FileError if the data ends before or a value is no number
  std::vector<float> read_columns(const PlyElement& element,
                                  const std::array<std::size_t, 3>& columns);

  /// Where the next record begins [bytes].
  std::size_t offset() const { return offset_; }

  /// Checks the announced count against the bytes left.
  /// @throws FileError if they cannot hold it
  void check_count(const PlyElement& element) const;

 private:
  [[noreturn]] void fail_short(const PlyElement& element) const;
  template <class Visitor>
  void walk_binary(const PlyElement& element, Visitor&& visit);
  template <class Visitor>
  void walk_ascii(const PlyElement& element, Visitor&& visit);
  template <class Visitor>
  void walk(const PlyElement& element, Visitor&& visit);

  std::span<const std::byte> bytes_;
  const PlyHeader& header_;
  const std::string& name_;
  std::size_t offset_;
};

}  // namespace quadrille::io
