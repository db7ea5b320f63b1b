#pragma once

#include <cstddef>
#include <lcmtypes/quadrille/grasp_request_t.hpp>
#include <span>

#include "quadrille/bus/rejection.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// Size of the largest request that is read [byte], which holds some thousand ids.
inline constexpr std::size_t kMaxRequestBytes = 64 << 10;

/// Reads a request for grasps from a message of type quadrille.grasp_request_t. Every length is
/// checked before the generated decoder sees the bytes; other numbers are not checked.
/// @param bytes  the message as it came, fingerprint first
QUADRILLE_EXPORT Decoded<grasp_request_t> decode_request(std::span<const std::byte> bytes);

}  // namespace quadrille::bus
