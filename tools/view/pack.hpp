#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/json.hpp"
#include "view/mesh.hpp"

namespace quadrille::view {

/// Gathers arrays of numbers behind one another; each is known by its place and its count.
class Arrays {
 public:
  /// @return {"at": byte, "count": elements}
  template <class Number>
  io::Json add(const std::vector<Number>& numbers) {
    return add_bytes(numbers.data(), numbers.size(), sizeof(Number));
  }

  /// Positions as multiples of a step per axis: {"at", "count", "min": [3], "step": [3]}.
  io::Json add_positions(const std::vector<Eigen::Vector3f>& positions);

  /// {"vertices": …, "triangles": …, "rims": …}
  io::Json add_mesh(const Mesh& mesh);

  const std::string& bytes() const { return bytes_; }

 private:
  io::Json add_bytes(const void* data, std::size_t count, std::size_t element_bytes);

  std::string bytes_;
};

/// The text of JSON, whatever bytes its strings have: what is no UTF-8 is replaced.
std::string text_of(const io::Json& json);

/// Puts the JSON before the arrays.
std::string join_pack(const io::Json& json, const Arrays& arrays);

}  // namespace quadrille::view
