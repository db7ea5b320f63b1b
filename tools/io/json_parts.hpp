#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <vector>

#include "io/json.hpp"

namespace quadrille::io {

/// The elements of a vector.
template <class Vector>
Json array_of(const Vector& v) {
  Json array = Json::array();
  for (Eigen::Index i = 0; i < v.size(); ++i) array.push_back(v[i]);
  return array;
}

/// The keys that begin each object: the input, with what it was worked on, and its frame.
Json begin_json(const InputInfo& input, const RunInfo& run);

/// Adds "STAGE_ms" for each stage.
void add_stages(const std::vector<StageTime>& stages, Json* timings);

}  // namespace quadrille::io
