#include <cstdint>
#include <span>

#include "io/file_bytes.hpp"
#include "io/ply/ply.hpp"

/// Whatever the bytes, the reader returns a cloud or throws a FileError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    quadrille::io::parse_ply(std::as_bytes(std::span(data, size)), "fuzz.ply");
  } catch (const quadrille::io::FileError&) {
  }
  return 0;
}
