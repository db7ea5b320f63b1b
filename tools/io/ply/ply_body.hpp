#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/packed_point.hpp"
#include "io/ply/ply_header.hpp"

namespace quadrille::io {

/// Reads the data of a PLY file, element by element.
class PlyBody {
 public:
  /// All three parameters must outlive this object.
  PlyBody(std::span<const std::byte> bytes, const PlyHeader& header, const std::string& name);

  /// Skips all records of an element.
  /// @throws FileError if the data ends too early
  void skip(const PlyElement& element);

  /// Reads the positions, and the colours if there are any, of all records of an element.
  /// @param columns  positions of x, y and z among the element's properties
  /// @param colours  positions of red, green and blue, a byte each
  /// @throws FileError if the data ends too early or a value is not a number
  std::vector<PackedPoint> read_points(const PlyElement& element,
                                       const std::array<std::size_t, 3>& columns,
                                       const std::optional<std::array<std::size_t, 3>>& colours);

  /// Offset at which the next record begins [bytes].
  std::size_t offset() const { return offset_; }

  /// Checks the announced number of records against the bytes left.
  /// @throws FileError if the bytes cannot hold them
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
