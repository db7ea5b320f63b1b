#include <cstdint>
#include <span>

#include "io/file_bytes.hpp"
#include "io/gzip.hpp"
#include "io/xyz.hpp"

/// Whatever the bytes, packed or not, the reader returns a cloud or throws a FileError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  try {
    if (quadrille::io::is_gzip(bytes)) {
      quadrille::io::parse_xyz(quadrille::io::gunzip(bytes, "fuzz.xyz.gz"), "fuzz.xyz.gz");
    } else {
      quadrille::io::parse_xyz(bytes, "fuzz.xyz");
    }
  } catch (const quadrille::io::FileError&) {
  }
  return 0;
}
