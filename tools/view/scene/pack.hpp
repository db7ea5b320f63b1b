#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/json/json.hpp"
#include "mesh/surface_mesh.hpp"

namespace quadrille::view {

/// Concatenates arrays of numbers; each is identified by its offset and its count.
class Arrays {
 public:
  /// Appends an array.
  /// @return {"at": byte, "count": elements}
  template <class Number>
  io::Json add(const std::vector<Number>& numbers) {
    return add_bytes(numbers.data(), numbers.size(), sizeof(Number));
  }

  /// Appends positions as multiples of a step per axis.
  /// @return {"at", "count", "min": [3], "step": [3]}
  io::Json add_positions(const std::vector<Eigen::Vector3f>& positions);

  /// Appends a mesh.
  /// @return {"vertices": …, "triangles": …, "rims": …}
  io::Json add_mesh(const Mesh& mesh);

  const std::string& bytes() const { return bytes_; }

 private:
  io::Json add_bytes(const void* data, std::size_t count, std::size_t element_bytes);

  std::string bytes_;
};

/// Returns the text of JSON; bytes of strings that are not valid UTF-8 are replaced.
std::string text_of(const io::Json& json);

/// Joins the JSON and the arrays that follow it.
std::string join_pack(const io::Json& json, const Arrays& arrays);

}  // namespace quadrille::view
