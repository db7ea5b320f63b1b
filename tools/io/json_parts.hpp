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

/// Adds "STAGE_ms" for each stage.
void add_stages(const std::vector<StageTime>& stages, Json* timings);

}  // namespace quadrille::io
