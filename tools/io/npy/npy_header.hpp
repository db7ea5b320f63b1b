#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace quadrille::io {

/// One field of the records of a .npy file; a plain array has just one, without a name.
struct NpyField {
  std::string name;
  /// Type as numpy writes it, such as "<f4" or "|u1"; empty if the field holds several numbers.
  std::string type;
  /// Offset from the beginning of a record, and size [bytes].
  std::size_t offset = 0, size = 0;
};

/// The description of the array in a .npy file.
struct NpyHeader {
  std::vector<NpyField> fields;
  bool fortran_order = false;
  std::vector<std::uint64_t> shape;
  /// Size of a record, and offset of the first one [bytes].
  std::size_t record_size = 0, data_offset = 0;

  /// Returns true if the array has no named fields.
  bool is_plain() const { return fields.size() == 1 && fields.front().name.empty(); }
};

/// Returns true if the bytes begin like a .npy file.
bool is_npy(std::span<const std::byte> bytes);

/// Reads the header of a .npy file (versions 1 to 3), and checks that as many bytes follow as its
/// records have.
/// @param name  name of the file in errors
/// @throws FileError if it is not such a file, is truncated, or holds Python objects
NpyHeader parse_npy_header(std::span<const std::byte> bytes, const std::string& name);

}  // namespace quadrille::io
