#pragma once

#include <cstddef>
#include <cstdint>
#include <lcmtypes/quadrille/collision_shapes_t.hpp>
#include <lcmtypes/quadrille/forget_t.hpp>
#include <lcmtypes/quadrille/robot_t.hpp>
#include <lcmtypes/quadrille/support_t.hpp>
#include <span>

#include "quadrille/bus/rejection.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/solid_shape.hpp"

namespace quadrille::bus {

/// Limit of the messages below [byte], of the shapes in one, and of the vertices of a shape and the
/// numbers of its faces: each point of a cloud is compared with them.
inline constexpr std::size_t kMaxSceneBytes = std::size_t{1} << 20;
inline constexpr std::int32_t kMaxShapes = 256, kMaxVertices = 1024;

/// Reads what a robot says of its scene. Every length, sign and value is checked before the
/// generated decoder sees the bytes; whether shapes are solids is left to SolidShape::check().
/// @param bytes  the message as it came, fingerprint first; more than kMaxSceneBytes are refused
QUADRILLE_EXPORT Decoded<collision_shapes_t> decode_shapes(std::span<const std::byte> bytes);
QUADRILLE_EXPORT Decoded<robot_t> decode_robot(std::span<const std::byte> bytes);
QUADRILLE_EXPORT Decoded<support_t> decode_support(std::span<const std::byte> bytes);
QUADRILLE_EXPORT Decoded<forget_t> decode_forget(std::span<const std::byte> bytes);

/// Makes the solid of a message.
/// @throws std::invalid_argument if its fields make no solid
QUADRILLE_EXPORT SolidShape from_message(const collision_shape_t& shape);

}  // namespace quadrille::bus
