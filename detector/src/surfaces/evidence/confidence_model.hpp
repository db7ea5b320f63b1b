#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace quadrille {

/// One term of the evidence as an input of the confidence models.
struct ConfidenceTerm {
  /// Name of the term; confidence_terms() returns the terms in this order.
  std::string_view name;
  std::string_view unit, meaning;
};

inline constexpr auto kConfidenceTerms = std::to_array<ConfidenceTerm>({
    {"log_count", "ln samples", "many samples agree by no accident"},
    {"spread", "rad", "what bends far shows what it is"},
    {"smooth_border", "share of the border", "a patch cut out of something else"},
    {"open_border", "share of the samples", "a scrap is all border"},
    {"depth_edge", "share of the samples", "as is what lies along a depth edge"},
    {"interior", "share of the samples", "what is torn is hardly seen"},
    {"thickness", "ratio, 0 to 1", "a cloud of samples instead of a sheet"},
    {"log_size", "ln m", "things to grasp have sizes"},
    {"log_cell", "ln of cell over size", "how finely it is seen"},
    {"two_planes", "ln of rss over rss", "two planes explain it worse"},
    {"one_plane", "ln of rss over rss", "it bends beyond its residual"},
    {"log_sigma", "ln m", "where the noise is large, less is certain"},
    {"common_noise", "share", "waves pass for surfaces"},
    {"log_residual", "ln of rms over sigma", "the fit against the noise"},
    {"log_roughness", "ln of rms over sigma", "the noise as it is on this surface"},
    {"correlation", "-1 to 1", "residuals that hang together are shape"},
    {"convexity", "curvature times size", "from inside or from outside"},
    {"log_in_front", "ln of the ratio", "something else stands in its box"},
    {"log_behind", "ln of the ratio", "something is seen through it"},
    {"log_remainder", "ln of the remainder", "an object is explained as a whole"},
    {"uprightness", "cosine", "most things stand or lie"},
    {"see_through", "share of the rays", "it would hide what is seen"},
    {"dof", "degrees of freedom", "a richer type explains more that is nothing"},
    {"log_prior", "ln of odds", "few objects have this type"},
});

/// Scaling of a term: it is clamped to the range seen in training, reduced by the mean and divided
/// by the standard deviation.
struct TermScale {
  double min, max, mean, deviation;
};

/// A model of the log odds of a surface: Σ_{i ≤ j} form_ij z_i z_j, where z_0 = 1 and z_1, z_2, …
/// are the scaled terms. The form is stored row by row.
struct ConfidenceModel {
  static constexpr std::size_t kSize = kConfidenceTerms.size();
  std::array<TermScale, kSize> scales;
  std::array<double, (kSize + 1) * (kSize + 2) / 2> form;
};

}  // namespace quadrille
