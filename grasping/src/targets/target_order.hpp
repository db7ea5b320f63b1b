#pragma once

#include <cstddef>
#include <vector>

#include "targets/scene_parts.hpp"
#include "targets/target.hpp"

namespace quadrille {

/// Returns the indices from 0 up to, and without, `count` in ascending order. With a deadline,
/// targets are tried in the order in which they are given, which decides which are left out.
std::vector<int> as_given(std::size_t count);

/// Returns the indices of the targets, those with most points about them first. These take longest:
/// if one of them came last, all threads but one would have to wait for it.
std::vector<int> costliest_first(const std::vector<const Target*>& targets,
                                 const SceneParts& parts);

}  // namespace quadrille
