// Only the header of xxHash is used, so no program needs its library at run time.
#define XXH_INLINE_ALL
#include <xxhash.h>

#include "quadrille/bus/cloud_message.hpp"

namespace quadrille::bus {

std::int64_t digest_of(const PointCloud& cloud) {
  static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float));
  const std::uint64_t rows = static_cast<std::uint64_t>(static_cast<std::uint32_t>(cloud.width))
                                 << 32 |
                             static_cast<std::uint32_t>(cloud.height);
  const std::uint64_t digest = XXH3_64bits_withSeed(
      cloud.points.data(), cloud.points.size() * sizeof(Eigen::Vector3f), rows);
  return digest == 0 ? 1 : static_cast<std::int64_t>(digest);
}

}  // namespace quadrille::bus
