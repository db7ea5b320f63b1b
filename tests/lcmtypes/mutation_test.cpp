#include <atomic>
#include <cstdlib>
#include <new>
#include <random>

#include "quadrille/bus/boxes_message.hpp"
#include "quadrille/bus/request_message.hpp"
#include "samples.hpp"
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

TEST_CASE("no change of a valid cloud makes the decoder crash or take memory", "[bus][hostile]") {
  std::mt19937 random(1);
  const Bytes valid[] = {encode_cloud(test::make_cloud(), CloudFormat::kDrake),
                         encode_cloud(test::make_cloud(), CloudFormat::kPointCloud2),
                         encode_cloud(test::make_cloud(), CloudFormat::kPointCloud),
                         encode(test::make_wide_message(true))};
  int accepted = 0;
  for (int i = 0; i < 200000; ++i) {
    const Bytes bytes = mutate(valid[static_cast<std::size_t>(i) % std::size(valid)], random);
    const std::size_t before = allocated;
    const auto decoded = decode_cloud(bytes);
    const std::size_t taken = allocated - before;
    accepted += std::holds_alternative<CloudMessage>(decoded) ? 1 : 0;
    // The points take at most three times the bytes; the rest is for names and details.
    if (taken > 3 * bytes.size() + 4096) FAIL("took " << taken << " for " << bytes.size());
  }
  CHECK(accepted > 1000);
  CHECK(accepted < 199000);
}

TEST_CASE("no change of valid quadrics makes the decoder crash or take memory", "[bus][hostile]") {
  std::mt19937 random(2);
  const Bytes valid = test::make_quadrics_bytes();
  int accepted = 0;
  for (int i = 0; i < 100000; ++i) {
    const Bytes bytes = mutate(valid, random);
    const std::size_t before = allocated;
    const auto decoded = decode_quadrics(bytes);
    const std::size_t taken = allocated - before;
    accepted += std::holds_alternative<QuadricsMessage>(decoded) ? 1 : 0;
    if (taken > 16 * bytes.size() + 4096) FAIL("took " << taken << " for " << bytes.size());
  }
  CHECK(accepted > 100);
  CHECK(accepted < 99000);
}

TEST_CASE("no change of valid boxes makes the decoder crash or take memory", "[bus][hostile]") {
  std::mt19937 random(3);
  Box box;
  box.faces = {1, 2, 3};
  const Bytes valid = encode(to_message(test::make_cloud(), std::vector<Box>(3, box)));
  int accepted = 0;
  for (int i = 0; i < 100000; ++i) {
    const Bytes bytes = mutate(valid, random);
    const std::size_t before = allocated;
    const auto decoded = decode_boxes(bytes);
    const std::size_t taken = allocated - before;
    accepted += std::holds_alternative<BoxesMessage>(decoded) ? 1 : 0;
    if (taken > 16 * bytes.size() + 4096) FAIL("took " << taken << " for " << bytes.size());
  }
  CHECK(accepted > 100);
  CHECK(accepted < 99000);
}

TEST_CASE("no change of a valid request makes the decoder crash or take memory",
          "[bus][hostile][request]") {
  std::mt19937 random(4);
  grasp_request_t request{};
  request.request_id = 1;
  request.targets = request.tracks = {1, 2, 3};
  request.num_targets = request.num_tracks = 3;
  request.types = {"sphere", "cone"};
  request.num_types = 2;
  const Bytes valid = encode(request);
  int accepted = 0;
  for (int i = 0; i < 100000; ++i) {
    const Bytes bytes = mutate(valid, random);
    const std::size_t before = allocated;
    const auto decoded = decode_request(bytes);
    const std::size_t taken = allocated - before;
    accepted += std::holds_alternative<grasp_request_t>(decoded) ? 1 : 0;
    if (taken > 32 * bytes.size() + 4096) FAIL("took " << taken << " for " << bytes.size());
  }
  CHECK(accepted > 100);
  CHECK(accepted < 99000);
}

}  // namespace
}  // namespace quadrille::bus
