#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace quadrille {

/// Names of the terms of the evidence that the models weigh, in the order of confidence_terms().
inline constexpr auto kConfidenceTerms = std::to_array<std::string_view>({
    "log_count",    "spread",        "smooth_border", "open_border", "depth_edge", "interior",
    "thickness",    "log_size",      "log_cell",      "two_planes",  "one_plane",  "log_sigma",
    "common_noise", "log_residual",  "log_roughness", "correlation", "convexity",  "log_in_front",
    "log_behind",   "log_remainder", "uprightness",   "see_through", "log_meet",   "log_miss",
    "dof",          "log_prior",
});

/// Values of the terms.
using ConfidenceTerms = std::array<double, kConfidenceTerms.size()>;

/// Range of a term in training. Beyond it nothing is known, so terms are clamped to it.
struct TermRange {
  double min, max;
};

/// A weight in the log odds of a surface, times one term, or two, or none.
struct ConfidenceWeight {
  double value;
  /// Indices of the terms; kConfidenceTerms.size() for none.
  std::size_t first, second;

  // A number alone is the constant of a model.
  // NOLINTNEXTLINE(google-explicit-constructor)
  constexpr ConfidenceWeight(double value) : ConfidenceWeight("", "", value) {}
  constexpr ConfidenceWeight(std::string_view term, double value)
      : ConfidenceWeight(term, "", value) {}
  constexpr ConfidenceWeight(std::string_view first_term, std::string_view second_term,
                             double weight)
      : value(weight), first(index_of(first_term)), second(index_of(second_term)) {}

 private:
  static constexpr std::size_t index_of(std::string_view term) {
    const auto* at = std::find(kConfidenceTerms.begin(), kConfidenceTerms.end(), term);
    // A wrong name does not compile, since the models are constants.
    if (at == kConfidenceTerms.end() && !term.empty()) throw "no such term";
    return static_cast<std::size_t>(at - kConfidenceTerms.begin());
  }
};

}  // namespace quadrille
