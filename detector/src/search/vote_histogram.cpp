#include "search/vote_histogram.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace quadrille {
namespace {

// Empty bins before the first and after the last, for the kernel.
constexpr int kMargin = 2;
// Sum of the triangular kernel 1 2 3 2 1.
constexpr double kKernelSum = 9.0;
// Margin at both ends of the interval, which correspond to infinite λ.
constexpr float kMinPlace = 1e-4f;

constexpr float kPi = std::numbers::pi_v<float>;

}  // namespace

constinit const Quantisation kArctangent = {
    [](float lambda) { return 0.5f + std::atan(lambda) / kPi; },
    [](float place) { return std::tan(kPi * (place - 0.5f)); },
};

VoteHistogram::VoteHistogram(const VoteOptions& options)
    : options_(options), count_(static_cast<std::size_t>(options.bins + 2 * kMargin), 0.0f) {}

void VoteHistogram::add(float lambda) {
  const float place = options_.quantisation.place_of(lambda);
  const int bin = static_cast<int>(place * static_cast<float>(options_.bins));
  const auto inside = static_cast<std::size_t>(std::clamp(bin, 0, options_.bins - 1));
  ++count_[kMargin + inside];
  is_empty_ = false;
}

std::vector<VotePeak> VoteHistogram::peaks() const {
  if (is_empty_) return {};
  const int bins = options_.bins;
  const float* const count = count_.data() + kMargin;
  const auto at = [&](int i) { return count[i]; };
  std::vector<float> density(static_cast<std::size_t>(bins));
  for (int i = 0; i < bins; ++i) {
    density[i] = at(i - 2) + 2 * at(i - 1) + 3 * at(i) + 2 * at(i + 1) + at(i + 2);
  }
  std::vector<VotePeak> peaks;
  for (int i = 0; i < bins; ++i) {
    const float left = i ? density[i - 1] : -1.0f;
    const float right = i + 1 < bins ? density[i + 1] : -1.0f;
    if (density[i] <= 0 || density[i] < left || density[i] <= right) continue;
    // The mean over the core of the kernel locates the peak more finely than a bin.
    const float mass = at(i - 1) + at(i) + at(i + 1);
    const float shift = mass > 0 ? (at(i + 1) - at(i - 1)) / mass : 0.0f;
    const float place = (static_cast<float>(i) + 0.5f + shift) / static_cast<float>(bins);
    const float within = std::clamp(place, kMinPlace, 1.0f - kMinPlace);
    peaks.push_back({options_.quantisation.lambda_at(within), density[i] / kKernelSum});
  }
  std::stable_sort(peaks.begin(), peaks.end(),
                   [](const VotePeak& a, const VotePeak& b) { return a.votes > b.votes; });
  if (static_cast<int>(peaks.size()) > options_.peaks) {
    peaks.resize(static_cast<std::size_t>(options_.peaks));
  }
  return peaks;
}

}  // namespace quadrille
