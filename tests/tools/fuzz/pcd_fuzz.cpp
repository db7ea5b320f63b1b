#include <cstdint>
#include <span>

#include "io/file_bytes.hpp"
#include "io/pcd/pcd.hpp"

/// Whatever the bytes, the reader returns a cloud or throws a FileError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    quadrille::io::parse_pcd(std::as_bytes(std::span(data, size)), "fuzz.pcd");
  } catch (const quadrille::io::FileError&) {
  }
  return 0;
}
