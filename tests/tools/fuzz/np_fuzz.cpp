#include <cstdint>
#include <span>

#include "io/file_bytes.hpp"
#include "io/npy/npy.hpp"
#include "io/npy/npz.hpp"

/// Whatever the bytes, both readers return a cloud or throw a FileError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  try {
    if (quadrille::io::is_npz(bytes)) {
      quadrille::io::parse_npz(bytes, "fuzz.npz");
    } else {
      quadrille::io::parse_npy(bytes, "fuzz.npy");
    }
  } catch (const quadrille::io::FileError&) {
  }
  return 0;
}
