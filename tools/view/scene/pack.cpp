#include "view/scene/pack.hpp"

#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/json/json_parts.hpp"

namespace quadrille::view {
namespace {

static_assert(std::endian::native == std::endian::little, "the page reads little-endian arrays");

/// Arrays begin at multiples of this, because the page maps them as typed arrays.
constexpr std::size_t kAlignment = 4;
/// Largest multiple of a step that a position can have.
constexpr float kMaxStep = 65535.0f;

}  // namespace

io::Json Arrays::add_bytes(const void* data, std::size_t count, std::size_t element_bytes) {
  bytes_.resize((bytes_.size() + kAlignment - 1) / kAlignment * kAlignment, '\0');
  io::Json place = {{"at", bytes_.size()}, {"count", count}};
  bytes_.append(static_cast<const char*>(data), count * element_bytes);
  return place;
}

io::Json Arrays::add_positions(const std::vector<Eigen::Vector3f>& positions) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& p : positions) box.extend(p);
  if (box.isEmpty()) box.extend(Eigen::Vector3f::Zero().eval());
  const Eigen::Vector3f step = box.sizes() / kMaxStep;
  std::vector<std::uint16_t> steps;
  steps.reserve(3 * positions.size());
  for (const Eigen::Vector3f& p : positions) {
    for (int i = 0; i < 3; ++i) {
      const float n = step[i] > 0.0f ? std::round((p[i] - box.min()[i]) / step[i]) : 0.0f;
      steps.push_back(static_cast<std::uint16_t>(n < kMaxStep ? n : kMaxStep));
    }
  }
  io::Json place = add(steps);
  place["min"] = io::array_of(box.min());
  place["step"] = io::array_of(step);
  return place;
}

io::Json Arrays::add_mesh(const Mesh& mesh) {
  std::vector<std::uint32_t> triangles, rims;
  for (const auto& triangle : mesh.triangles)
    triangles.insert(triangles.end(), triangle.begin(), triangle.end());
  for (const auto& rim : mesh.rims) rims.insert(rims.end(), rim.begin(), rim.end());
  return {{"vertices", add_positions(mesh.vertices)},
          {"triangles", add(triangles)},
          {"rims", add(rims)}};
}

std::string text_of(const io::Json& json) {
  return json.dump(-1, ' ', false, io::Json::error_handler_t::replace);
}

std::string join_pack(const io::Json& json, const Arrays& arrays) {
  std::string text = text_of(json);
  text.resize((text.size() + kAlignment - 1) / kAlignment * kAlignment, ' ');
  const auto size = static_cast<std::uint32_t>(text.size());
  std::string pack = "QVW1";
  pack.append(reinterpret_cast<const char*>(&size), sizeof size);
  return pack + text + arrays.bytes();
}

}  // namespace quadrille::view
