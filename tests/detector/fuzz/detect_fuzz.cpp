#include "detector/fuzz/detect_hostile.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  quadrille::test::Choices choices({data, size});
  quadrille::test::detect_hostile(choices);
  return 0;
}
