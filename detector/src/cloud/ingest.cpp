#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include "base/vector_clones.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {
namespace {

/// Offset at which the last value that is read ends within a record [bytes]; SIZE_MAX on overflow.
std::size_t end_of_values(const PointLayout& layout, std::size_t scalar_size) {
  const auto end = [](std::size_t offset, std::size_t size) {
    std::size_t sum = 0;
    return __builtin_add_overflow(offset, size, &sum) ? std::numeric_limits<std::size_t>::max()
                                                      : sum;
  };
  const std::size_t coordinates = end(std::max({layout.x, layout.y, layout.z}), scalar_size);
  return layout.rgb ? std::max(coordinates, end(std::ranges::max(*layout.rgb), 1)) : coordinates;
}

/// Bytes that the layout needs; SIZE_MAX on overflow.
std::size_t bytes_needed(const PointLayout& layout, std::size_t row_step, std::size_t record_end) {
  if (layout.width == 0 || layout.height == 0) return 0;
  std::size_t rows = 0, columns = 0, end = 0;
  if (__builtin_mul_overflow(layout.height - 1, row_step, &rows) ||
      __builtin_mul_overflow(layout.width - 1, layout.point_step, &columns) ||
      __builtin_add_overflow(rows, columns, &end) ||
      __builtin_add_overflow(end, record_end, &end)) {
    return std::numeric_limits<std::size_t>::max();
  }
  return end;
}

template <class Scalar>
Scalar load(const std::byte* from, bool swap) {
  std::array<std::byte, sizeof(Scalar)> raw;
  std::memcpy(raw.data(), from, raw.size());
  if (swap) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<Scalar>(raw);
}

Rgb load_rgb(const std::byte* record, const std::array<std::size_t, 3>& offsets) {
  Rgb rgb;
  for (std::size_t i = 0; i < 3; ++i) rgb[i] = std::to_integer<std::uint8_t>(record[offsets[i]]);
  return rgb;
}

template <class Scalar>
void append_points(std::span<const std::byte> bytes, const PointLayout& layout,
                   std::size_t row_step, const Eigen::Affine3d& X_CF, PointCloud* cloud) {
  const bool moves = !X_CF.matrix().isIdentity(0.0);
  const bool swap = layout.big_endian != (std::endian::native == std::endian::big);
  const bool organised = cloud->organised();
  const Eigen::Vector3f missing =
      Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
  cloud->points.reserve(layout.width * layout.height);
  if (layout.rgb) cloud->colours.reserve(layout.width * layout.height);
  for (std::size_t row = 0; row < layout.height; ++row) {
    const std::byte* record = bytes.data() + row * row_step;
    for (std::size_t column = 0; column < layout.width; ++column, record += layout.point_step) {
      const Eigen::Matrix<Scalar, 3, 1> p_F(load<Scalar>(record + layout.x, swap),
                                            load<Scalar>(record + layout.y, swap),
                                            load<Scalar>(record + layout.z, swap));
      const Eigen::Vector3f& p = p_F.template cast<float>();
      if (p.allFinite() && !p.isZero(0.0f)) {
        cloud->points.push_back(
            moves ? (X_CF * p_F.template cast<double>()).template cast<float>().eval() : p);
      } else if (organised) {
        cloud->points.push_back(missing);
      } else {
        continue;
      }
      if (layout.rgb) cloud->colours.push_back(load_rgb(record, *layout.rgb));
    }
  }
}

/// Quick test of 16 points: true only if no coordinate is missing or zero.
QUADRILLE_VECTOR_CLONES
bool all_measured(const float* values) {
  int all = 1;
  for (int k = 0; k < 48; ++k) {
    // x − x is zero unless x is infinite or NaN.
    all &= static_cast<int>(values[k] - values[k] == 0.0f) & static_cast<int>(values[k] != 0.0f);
  }
  return all != 0;
}

/// Makes missing points NaN.
void mark_missing(std::vector<Eigen::Vector3f>* points) {
  // Most points are measured, so runs of them are tested at once.
  constexpr std::size_t kRun = 16;
  for (std::size_t i = 0; i < points->size();) {
    const std::size_t end = std::min(i + kRun, points->size());
    if (end == i + kRun && all_measured((*points)[i].data())) {
      i = end;
      continue;
    }
    for (; i < end; ++i) {
      Eigen::Vector3f& p = (*points)[i];
      if (!p.allFinite() || p.isZero(0.0f)) p.setConstant(std::numeric_limits<float>::quiet_NaN());
    }
  }
}

/// Reads an image of float32 in this machine's order of bytes, as nearly all cameras send it. It
/// takes a fifth of the steps of append_points(), which does the same.
void read_image(std::span<const std::byte> bytes, const PointLayout& layout, std::size_t row_step,
                PointCloud* cloud) {
  constexpr std::size_t kPoint = sizeof(Eigen::Vector3f);
  const bool packed =
      layout.point_step == kPoint && layout.x == 0 && layout.y == 4 && layout.z == 8;
  cloud->points.resize(layout.width * layout.height);
  Eigen::Vector3f* to = cloud->points.data();
  for (std::size_t row = 0; row < layout.height; ++row) {
    const std::byte* record = bytes.data() + row * row_step;
    if (packed) {
      std::memcpy(to->data(), record, layout.width * kPoint);
      to += layout.width;
      continue;
    }
    for (std::size_t column = 0; column < layout.width; ++column, record += layout.point_step) {
      const float x = load<float>(record + layout.x, false);
      const float y = load<float>(record + layout.y, false);
      *to++ = {x, y, load<float>(record + layout.z, false)};
    }
  }
  mark_missing(&cloud->points);
}

}  // namespace

PointCloud read_points(std::span<const std::byte> bytes, const PointLayout& layout,
                       const Eigen::Affine3d& X_CF) {
  const bool wide = layout.scalar == PointLayout::Scalar::kFloat64;
  const std::size_t scalar_size = wide ? 8 : 4;
  const std::size_t record_end = end_of_values(layout, scalar_size);
  if (record_end > layout.point_step) {
    throw std::invalid_argument("point layout: a value ends at byte " + std::to_string(record_end) +
                                " of records of " + std::to_string(layout.point_step) + " bytes");
  }
  std::size_t row_step = layout.row_step;
  if (row_step == 0 && __builtin_mul_overflow(layout.width, layout.point_step, &row_step)) {
    throw std::invalid_argument("point layout: width * point_step overflows");
  }
  if (layout.height > 1 && row_step / layout.point_step < layout.width) {
    throw std::invalid_argument("point layout: rows of " + std::to_string(row_step) +
                                " bytes do not hold " + std::to_string(layout.width) + " points");
  }
  if (bytes_needed(layout, row_step, record_end) > bytes.size()) {
    throw std::invalid_argument("point layout: " + std::to_string(layout.width) + " x " +
                                std::to_string(layout.height) + " points do not fit into " +
                                std::to_string(bytes.size()) + " bytes");
  }
  PointCloud cloud;
  cloud.read = layout.width * layout.height;
  if (layout.height > 1) {
    cloud.width = static_cast<int>(layout.width);
    cloud.height = static_cast<int>(layout.height);
  }
  const bool native = layout.big_endian == (std::endian::native == std::endian::big);
  const bool moves = !X_CF.matrix().isIdentity(0.0);
  if (cloud.organised() && layout.width > 0 && !wide && native && !moves && !layout.rgb) {
    read_image(bytes, layout, row_step, &cloud);
  } else if (wide) {
    append_points<double>(bytes, layout, row_step, X_CF, &cloud);
  } else {
    append_points<float>(bytes, layout, row_step, X_CF, &cloud);
  }
  return cloud;
}

}  // namespace quadrille
