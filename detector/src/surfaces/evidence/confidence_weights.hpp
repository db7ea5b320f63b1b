#pragma once

#include <array>
#include <string_view>

namespace quadrille {

/// How much one term of the evidence moves the log odds that a surface is real.
struct ConfidenceWeight {
  /// As confidence_terms() gives it.
  std::string_view term;
  /// Log odds per unit.
  double weight;
  std::string_view unit, meaning;
};

// A logistic regression over some 2800 surfaces, labelled by the truth of generated scenes, with
// waves in their noise and without, and of real scans, whose surfaces count threefold. It was made
// before tools/lab/confidence/train_confidence.py, which makes such a table anew from generated
// scenes and says how far from this one it is. The scenes hold no types that few objects have: the
// prior speaks for those, and adds to the terms.
inline constexpr auto kConfidenceWeights = std::to_array<ConfidenceWeight>({
    {"one", -8.75, "-", "what nothing is known of is most likely wrong"},
    {"log_count", 2.46, "ln samples, to ln 400", "many samples agree by no accident"},
    {"spread", -1.2, "rad", "what bends far is easily explained by too rich a type"},
    {"smooth_border", -12.8, "share of the border", "a patch cut out of something else"},
    {"open_border", -0.906, "share of the samples", "a scrap is all border"},
    {"depth_edge", -6.22, "share of the samples", "as is what lies along a depth edge"},
    {"thickness", -1.83, "ratio, 0 to 1", "a cloud of samples instead of a sheet"},
    {"two_planes", 0.645, "ln of rss over rss", "two planes explain it worse"},
    {"box_edge", -2.23, "ln samples times ln of rss over rss", "many that two planes explain"},
    {"dof", -0.66, "degree of freedom", "a richer type explains more that is nothing"},
    {"log_misfit", -3.51, "ln of the misfit", "deviates in patches: it is no quadric"},
    {"log_remainder", -0.327, "ln of the remainder", "an object is explained as a whole"},
});

}  // namespace quadrille
