#include "search/axes/profile_support.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/vector_clones.hpp"
#include "search/axes/set_flags.hpp"

namespace quadrille {
namespace {

/// Compares all points with a line; see Profile.
/// @param rows  the five rows of ProfileSupport
/// @return number of points that support it
QUADRILLE_VECTOR_CLONES
int compare_with_line(float k, float r0, float min_square, int size, const float* rows,
                      float* __restrict share, int* __restrict is_on) {
  const float *r = rows, *h = r + size, *nr = h + size, *nh = nr + size, *limit = nh + size;
  const float square = 1.0f + k * k, length = std::sqrt(square);
  int count = 0;
  for (int i = 0; i < size; ++i) {
    const float distance = (r[i] - r0 - k * h[i]) / length, cosine = nr[i] - k * nh[i];
    share[i] = distance / limit[i];
    is_on[i] = (std::abs(distance) <= limit[i]) & (cosine * cosine >= min_square * square);
    count += is_on[i];
  }
  return count;
}

/// Compares points of a profile, as compare_with_line() does, with the arc of a sphere whose centre
/// is on the axis.
QUADRILLE_VECTOR_CLONES
int compare_with_arc(float c, float R, float min_square, int size, const float* rows,
                     float* __restrict share, int* __restrict is_on) {
  const float *r = rows, *h = r + size, *nr = h + size, *nh = nr + size, *limit = nh + size;
  int count = 0;
  for (int i = 0; i < size; ++i) {
    const float height = h[i] - c, square = r[i] * r[i] + height * height;
    const float distance = std::sqrt(square) - R, cosine = r[i] * nr[i] + height * nh[i];
    share[i] = distance / limit[i];
    is_on[i] = (std::abs(distance) <= limit[i]) & (cosine * cosine >= min_square * square);
    count += is_on[i];
  }
  return count;
}

// An arc fits a low ring of samples as well as a line, which is then the simpler answer.
constexpr float kFactorOfArc = 0.9f;

}  // namespace

bool supports(const ProfilePoint& m, const Profile& profile, float min_cosine) {
  if (!(std::abs(profile.distance(m)) <= m.limit)) return false;
  const Eigen::Vector2f normal = profile.normal(m);
  const float cosine = normal.dot(m.n);
  return cosine * cosine >= min_cosine * min_cosine * normal.squaredNorm();
}

ProfileSupport::ProfileSupport(std::span<const ProfilePoint> points, const SupportTest& test)
    : test_(test),
      size_(points.size()),
      rows_(5 * size_),
      sector_(size_),
      share_(size_),
      is_on_(size_),
      on_(size_) {
  for (std::size_t i = 0; i < size_; ++i) {
    const ProfilePoint& m = points[i];
    const float values[] = {m.r, m.h, m.n.x(), m.n.y(), m.limit};
    for (std::size_t k = 0; k < std::size(values); ++k) rows_[k * size_ + i] = values[k];
    sector_[i] = std::uint64_t{1} << m.sector;
  }
}

float ProfileSupport::of(const Profile& profile, float least) {
  const bool is_arc = profile.kind == Profile::Kind::kArc;
  const float min_square = test_.min_cosine * test_.min_cosine;
  const int size = static_cast<int>(size_);
  const auto compare = is_arc ? compare_with_arc : compare_with_line;
  const int count = compare(is_arc ? profile.c : profile.k, is_arc ? profile.R : profile.r0,
                            min_square, size, rows_.data(), share_.data(), is_on_.data());
  const float factor = is_arc ? kFactorOfArc : 1.0f;
  // No point adds more than one.
  if (static_cast<std::size_t>(count) < test_.min_points ||
      factor * static_cast<float>(count) <= least) {
    return 0.0f;
  }
  const std::span<const int> on(
      on_.data(), static_cast<std::size_t>(list_set_flags(is_on_.data(), size, on_.data())));
  std::uint64_t seen = 0;
  float sum = 0.0f;
  for (const int i : on) {
    sum += 1.0f - share_[i] * share_[i];
    seen |= sector_[i];
  }
  return std::popcount(seen) < test_.min_sectors ? 0.0f : factor * sum;
}

}  // namespace quadrille
