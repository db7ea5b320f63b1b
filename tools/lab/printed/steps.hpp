#pragma once

#include <string_view>
#include <vector>

#include "lab/printed/settings.hpp"

namespace quadrille::printed {

/// A pipeline, named by what it has more of the detector than the one before.
struct Step {
  std::string_view name;
  Settings settings;
};

/// The steps from a printed pipeline, the first, to the detector, the last. Each takes one way of
/// the detector and keeps those of the steps before.
std::vector<Step> steps_from(const Settings& printed);

}  // namespace quadrille::printed
