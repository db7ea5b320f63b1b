// Finds the pixels of a camera from the points alone.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "base/quantile.hpp"
#include "quadrille/detector/pinhole.hpp"

namespace quadrille {
namespace {

// No camera has more pixels, and an image with a smaller share of filled pixels is not an image.
constexpr double kMaxPixels = 64e6, kMinFilled = 0.01;
// Bounds of a camera's pitch, as a tangent: 100,000 or 50 pixels across 53°. Smaller steps are
// rounding errors, larger ones gaps.
constexpr float kMinPitch = 1e-5f, kMaxPitch = 0.02f;
// Numbers of points looked at for the steps within a row and for the phase, enough to average out
// their rounding.
constexpr std::size_t kSteps = 10000, kPhases = 2500;
// Steps within this share of the typical one are steps of one pixel.
constexpr float kStepSpread = 0.2f;
// A step back by this share of the image's width leads to the next row.
constexpr float kMinReturn = 0.05f;
// Fewer rows do not determine the pitch across them.
constexpr std::size_t kMinRows = 10;
// Least regularity, which is that of points a tenth of a pixel off the centres (one standard
// deviation). If they were more irregular, some would share a pixel and leave others empty.
constexpr float kMinRegularity = 0.8f;
// Points in a typical pixel of a depth image whose points come in no order. If they lie at random,
// one pixel in seven is empty, few enough to be filled from its neighbours.
constexpr float kPointsPerPixel = 2.0f;
// Points in a typical block, enough to estimate their density for that purpose.
constexpr float kPointsPerBlock = 8.0f;
// Least factor by which a step coarsens the pixels. If one side is a single pixel already, only the
// other side shrinks, and the square root of the excess would converge slowly.
constexpr float kMinCoarser = 1.01f;

/// Calls visit(t, next) for roughly `about` of the seen points, spread evenly over the cloud, where
/// t is the point's (u, v, w) and `next` that of the next seen point.
template <class Visitor>
void sample_pairs(const CloudView& cloud, const PinholeView& view, std::size_t about,
                  Visitor&& visit) {
  const std::size_t step = static_cast<std::size_t>(view.stride), size = cloud.points.size();
  const std::size_t stride = step * std::max<std::size_t>(1, size / step / about);
  for (std::size_t i = 0; i + step < size; i += stride) {
    const Eigen::Vector3f t = view(cloud.points[i]);
    if (t.z() == 0.0f) continue;
    for (std::size_t k = i + step; k < size; k += step) {
      const Eigen::Vector3f next = view(cloud.points[k]);
      if (next.z() == 0.0f) continue;
      visit(t, next);
      break;
    }
  }
}

/// The typical step: the mean of all steps of one pixel, which averages out their rounding.
float usual_step(std::vector<float>& steps) {
  const float usual = median(steps);
  double sum = 0;
  int n = 0;
  for (const float s : steps) {
    if (std::abs(s - usual) < kStepSpread * usual) sum += s, ++n;
  }
  return static_cast<float>(sum / n);
}

/// Pixel pitch of a cloud in row order: the typical step between consecutive points of one row.
std::optional<float> pitch_from_order(const CloudView& cloud, const PinholeView& view) {
  std::vector<float> steps;
  std::size_t looked = 0;
  sample_pairs(cloud, view, kSteps, [&](const Eigen::Vector3f& t, const Eigen::Vector3f& next) {
    const Eigen::Vector2f d = (next - t).head<2>().cwiseAbs();
    if (d.x() > kMinPitch && d.x() < kMaxPitch) steps.push_back(d.x());
    ++looked;
  });
  if (steps.empty() || steps.size() < looked / 2) return std::nullopt;
  return usual_step(steps);
}

/// Finds the steps v from the end of a row to the beginning of the next one.
class RowSteps {
 public:
  /// @param min_return  least step back along u that leads to the next row
  explicit RowSteps(float min_return) : min_return_(min_return) {}

  /// Adds the (u, v) of a seen point.
  void add(float u, float v) {
    if (u_ - u > min_return_ && v - v_ > kMinPitch) steps_.push_back(v - v_);
    u_ = u, v_ = v;
  }
  std::vector<float>& found() { return steps_; }

 private:
  float min_return_, u_ = std::numeric_limits<float>::lowest(), v_ = 0.0f;
  std::vector<float> steps_;
};

/// Adds the first and the last seen point of each row of an organised cloud.
void add_ends_of_rows(const CloudView& cloud, const PinholeView& view, RowSteps* steps) {
  const auto width = static_cast<std::size_t>(cloud.width);
  for (std::size_t begin = 0; begin + width <= cloud.points.size(); begin += width) {
    const auto add_first = [&](auto from, auto to) {
      for (; from != to; ++from) {
        const Eigen::Vector3f t = view(*from);
        if (t.z() == 0.0f) continue;
        steps->add(t.x(), t.y());
        return;
      }
    };
    const std::span<const Eigen::Vector3f> row = cloud.points.subspan(begin, width);
    add_first(row.begin(), row.end());
    add_first(row.rbegin(), row.rend());
  }
}

/// Pitch across the rows: the median step from the end of one row to the beginning of the next.
/// Nullopt if there are too few rows.
std::optional<float> pitch_across_rows(const CloudView& cloud, const PinholeView& view) {
  RowSteps steps(kMinReturn * view.bounds.sizes().x());
  if (cloud.organised() && view.stride == 1) {
    add_ends_of_rows(cloud, view, &steps);
  } else {
    for (std::size_t first = 0; first < view.looked_at(cloud.points.size());
         first += SeenPoints::kSize) {
      const SeenPoints t = view.look(cloud.points, first);
      for (int k = 0; k < SeenPoints::kSize; ++k) {
        if (t.w[k] > 0.0f) steps.add(t.u[k], t.v[k]);
      }
    }
  }
  if (steps.found().size() < kMinRows) return std::nullopt;
  return median(steps.found());
}

/// Adds up blocks of a square histogram two by two.
std::vector<int> halved(const std::vector<int>& histogram, int blocks) {
  std::vector<int> halves(histogram.size() / 4, 0);
  for (int j = 0; j < blocks; ++j) {
    for (int i = 0; i < blocks; ++i) {
      halves[(j / 2) * (blocks / 2) + i / 2] += histogram[j * blocks + i];
    }
  }
  return halves;
}

/// Median number of points in those blocks that hold any.
float usual_count(const std::vector<int>& histogram) {
  std::vector<float> counts;
  for (const int n : histogram) {
    if (n > 0) counts.push_back(static_cast<float>(n));
  }
  return median(counts);
}

/// Pitch at which a typical pixel holds points_per_pixel points, from the density of points over
/// the part of the image that they cover.
/// @param points_per_block  the density is counted in blocks of which the typical one holds at
///   least this many points
float pitch_from_density(const CloudView& cloud, const PinholeView& view, float points_per_pixel,
                         float points_per_block) {
  constexpr float kReach = PinholeView::kMaxTangent;
  int blocks = 512;
  float edge = 2 * kReach / static_cast<float>(blocks);
  std::vector<int> histogram(static_cast<std::size_t>(blocks * blocks), 0);
  const auto bin = [&](float t) {
    return std::clamp(static_cast<int>((t + kReach) / edge), 0, blocks - 1);
  };
  for (std::size_t i = 0; i < cloud.points.size(); i += static_cast<std::size_t>(view.stride)) {
    const Eigen::Vector3f t = view(cloud.points[i]);
    if (t.z() > 0.0f) ++histogram[bin(t.y()) * blocks + bin(t.x())];
  }
  float usual = usual_count(histogram);
  for (; usual < points_per_block && blocks > 1; usual = usual_count(histogram)) {
    histogram = halved(histogram, blocks);
    blocks /= 2;
    edge *= 2.0f;
  }
  return edge / std::sqrt(usual / points_per_pixel);
}

/// Position of the points within pixels of a given pitch.
struct Phase {
  /// Offsets of the pixels' centres, in [0, 1) of a pixel, as circular means.
  Eigen::Array2f centre;
  /// 1 if all points fall on the centres, about 0 if they fall anywhere.
  Eigen::Array2f regularity;
};

Phase phase_of(const CloudView& cloud, const PinholeView& view, const Eigen::Array2f& pitch) {
  const Eigen::Array2f turns(static_cast<float>(2 * std::numbers::pi / pitch.x()),
                             static_cast<float>(2 * std::numbers::pi / pitch.y()));
  Eigen::Array2f c = Eigen::Array2f::Zero(), s = Eigen::Array2f::Zero();
  int n = 0;
  sample_pairs(cloud, view, kPhases, [&](const Eigen::Vector3f& t, const Eigen::Vector3f&) {
    const Eigen::Array2f a = turns * t.head<2>().array();
    c += a.cos();
    s += a.sin();
    ++n;
  });
  Phase phase;
  for (int axis = 0; axis < 2; ++axis) {
    const float turn = std::atan2(s[axis], c[axis]) / static_cast<float>(2 * std::numbers::pi);
    phase.centre[axis] = turn - std::floor(turn);
  }
  phase.regularity = (c.square() + s.square()).sqrt() / static_cast<float>(std::max(n, 1));
  return phase;
}

/// Number of columns and rows of pixels that the points fill, counted from a corner.
Eigen::Array2d count_pixels(const PinholeView& view, const Eigen::Array2f& corner,
                            const Eigen::Array2f& pitch) {
  return ((view.bounds.max().array() - corner) / pitch + 1.0f).cast<double>();
}

/// The image that the points fill, whose pixels have centres at these offsets in [0, 1) of a pixel;
/// its size stays unset.
PinholeImage place_image(const PinholeView& view, const Eigen::Array2f& pitch,
                         const Eigen::Array2f& centre) {
  // The centres of the pixels are half a pixel from the corner.
  const Eigen::Array2f phase = centre - 0.5f;
  PinholeImage image;
  image.pitch = pitch;
  image.corner = ((view.bounds.min().array() / pitch - phase).floor() + phase) * pitch;
  return image;
}

/// Pitches along and across the rows of points in row order; nullopt unless each point falls on the
/// centre of a pixel.
std::optional<Eigen::Array2f> regular_pitch(const CloudView& cloud, const PinholeView& view) {
  const std::optional<float> along = pitch_from_order(cloud, view);
  if (!along) return std::nullopt;
  const Eigen::Array2f pitch(*along, pitch_across_rows(cloud, view).value_or(*along));
  if (!(phase_of(cloud, view, pitch).regularity >= kMinRegularity).all()) return std::nullopt;
  return pitch;
}

/// The pitch, or a coarser one with which the image has at most max_pixels.
Eigen::Array2f coarse_enough(const PinholeView& view, Eigen::Array2f pitch, double max_pixels) {
  // This holds wherever within a pixel the first point lies.
  const auto excess = [&] {
    return count_pixels(view, view.bounds.min().array() - pitch, pitch).prod() / max_pixels;
  };
  for (double e = excess(); e > 1.0; e = excess()) {
    pitch *= std::max(static_cast<float>(std::sqrt(e)), kMinCoarser);
  }
  return pitch;
}

}  // namespace

std::optional<PinholeImage> find_image(const CloudView& cloud, const PinholeView& view) {
  const std::optional<float> ordered = pitch_from_order(cloud, view);
  const Eigen::Array2f pitch =
      Eigen::Array2f::Constant(ordered ? *ordered : pitch_from_density(cloud, view, 1.0f, 1.0f));
  PinholeImage image = place_image(view, pitch, phase_of(cloud, view, pitch).centre);
  const Eigen::Array2d size = count_pixels(view, image.corner, pitch);
  if (!(size.prod() < kMaxPixels) || static_cast<double>(view.seen) < kMinFilled * size.prod()) {
    return std::nullopt;
  }
  image.width = static_cast<int>(size.x());
  image.height = static_cast<int>(size.y());
  return image;
}

PinholeImage find_pixels(const CloudView& cloud, const PinholeView& view, double max_pixels) {
  const std::optional<Eigen::Array2f> regular = regular_pitch(cloud, view);
  const Eigen::Array2f pitch =
      coarse_enough(view,
                    regular ? *regular
                            : Eigen::Array2f::Constant(pitch_from_density(
                                  cloud, view, kPointsPerPixel, kPointsPerBlock)),
                    max_pixels);
  PinholeImage image = place_image(view, pitch, phase_of(cloud, view, pitch).centre);
  const Eigen::Array2d size = count_pixels(view, image.corner, pitch);
  image.width = static_cast<int>(size.x());
  image.height = static_cast<int>(size.y());
  return image;
}

}  // namespace quadrille
