#include <atomic>
#include <cstdlib>
#include <new>
#include <random>

#include "decoders.hpp"
#include "put_int32.hpp"
#include "support/catch.hpp"

namespace {

std::atomic<std::size_t> allocated{0};

}  // namespace

// Counts what is allocated, freed or not. Never inlined, for compilers that saw only one half of a
// pair would take it for mismatched.
[[gnu::noinline]] void* operator new(std::size_t size) {
  allocated += size;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
// With its like that does not throw, or the address sanitizer's would meet our delete.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  allocated += size;
  return std::malloc(size);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace quadrille::bus {
namespace {

using Bytes = std::vector<std::byte>;

/// Changes, cuts or lengthens a message at random places, mostly with numbers that make trouble.
Bytes mutate(Bytes bytes, std::mt19937& random) {
  const std::int32_t troublesome[] = {-1, 0, 1, 2, 0x7fffffff, 0x40000001, 1 << 20, INT32_MIN};
  const int changes = 1 + static_cast<int>(random() % 3);
  for (int i = 0; i < changes; ++i) {
    const std::size_t at = 8 + random() % (bytes.size() - 12);
    switch (random() % 4) {
      case 0:
        bytes[at] = static_cast<std::byte>(random());
        break;
      case 1:
        bytes[at] ^= static_cast<std::byte>(1u << random() % 8);
        break;
      default:
        test::put_int32(bytes, at, troublesome[random() % std::size(troublesome)]);
    }
  }
  if (random() % 8 == 0) bytes.resize(12 + random() % bytes.size());
  return bytes;
}

TEST_CASE("no change of a valid message makes its decoder crash or take memory", "[bus][hostile]") {
  constexpr int kChanges = 100000;
  std::mt19937 random(1);
  for (const test::Decoder& decoder : test::all_decoders()) {
    CAPTURE(decoder.type);
    int accepted = 0;
    for (int i = 0; i < kChanges; ++i) {
      const Bytes bytes = mutate(decoder.valid, random);
      const std::size_t before = allocated;
      accepted += decoder.refusal(bytes) ? 0 : 1;
      const std::size_t taken = allocated - before;
      // The rest is for names and details.
      if (taken > decoder.memory * bytes.size() + 4096) {
        FAIL("took " << taken << " for " << bytes.size());
      }
    }
    CHECK(accepted > kChanges / 1000);
    CHECK(accepted < 0.99 * kChanges);
  }
}

}  // namespace
}  // namespace quadrille::bus
