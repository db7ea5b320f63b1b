#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace quadrille::io {

/// One field of the records of a .npy file; of a plain array the only one, without a name.
struct NpyField {
  std::string name;
  /// As numpy writes it, such as "<f4" or "|u1"; empty if there are several numbers in the field.
  std::string type;
  /// From the beginning of a record, and its size [bytes].
  std::size_t offset = 0, size = 0;
};

/// What a .npy file says about its array.
struct NpyHeader {
  std::vector<NpyField> fields;
  bool fortran_order = false;
  std::vector<std::uint64_t> shape;
  /// Of a record, and where the first one stands [bytes].
  std::size_t record_size = 0, data_offset = 0;

  /// True if the array has no named fields.
  bool is_plain() const { return fields.size() == 1 && fields.front().name.empty(); }
};

/// True if bytes begin as a .npy file does.
bool is_npy(std::span<const std::byte> bytes);

/// Reads the header of a .npy file (versions 1 to 3), after which as many bytes follow as its
/// records have.
/// @param name  stands for the path in errors
/// @throws FileError if it is none, is cut short, or holds Python objects
NpyHeader parse_npy_header(std::span<const std::byte> bytes, const std::string& name);

}  // namespace quadrille::io
