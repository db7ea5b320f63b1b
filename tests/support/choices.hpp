#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>

namespace quadrille::test {

/// Reads a fuzzer's bytes as choices; when they are used up each choice is the first one.
class Choices {
 public:
  explicit Choices(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::uint8_t byte() { return at_ < bytes_.size() ? bytes_[at_++] : 0; }
  /// 0 … n − 1, where n is at most 65536.
  std::size_t below(std::size_t n) {
    const std::size_t high = n > 256 ? byte() : 0;
    return (256 * high + byte()) % n;
  }
  /// True in one case of n.
  bool one_in(std::size_t n) { return below(n) == n - 1; }
  /// One of 256 values from low to high.
  double between(double low, double high) { return low + (high - low) / 255.0 * byte(); }
  template <class T, std::size_t n>
  T pick(const std::array<T, n>& values) {
    return values[below(n)];
  }

  /// A number that no sensor means: codes for missing points, all magnitudes, any four bytes.
  double hostile() {
    using Float = std::numeric_limits<float>;
    static constexpr std::array<double, 26> kCodes = {0.0,
                                                      Float::quiet_NaN(),
                                                      Float::infinity(),
                                                      -Float::infinity(),
                                                      Float::max(),
                                                      1e30,
                                                      Float::lowest(),
                                                      -1.0,
                                                      65.535,
                                                      1e22,
                                                      1e23,
                                                      -1e30,
                                                      1e19,
                                                      1e9,
                                                      1e5,
                                                      1001.0,
                                                      999.0,
                                                      50.0,
                                                      1e-3,
                                                      1e-9,
                                                      -1e-9,
                                                      1e-30,
                                                      Float::min(),
                                                      Float::denorm_min(),
                                                      -0.0,
                                                      1e300};
    const std::size_t which = below(kCodes.size() + 2);
    return which < kCodes.size() ? kCodes[which] : any_float();
  }

 private:
  float any_float() {
    std::array<std::uint8_t, 4> raw;
    for (std::uint8_t& b : raw) b = byte();
    float value;
    std::memcpy(&value, raw.data(), raw.size());
    return value;
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

}  // namespace quadrille::test
