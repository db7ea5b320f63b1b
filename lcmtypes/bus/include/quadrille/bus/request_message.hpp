#pragma once

#include <cstddef>
#include <lcmtypes/quadrille/grasp_request_t.hpp>
#include <span>

#include "quadrille/bus/rejection.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// Largest request that is read [byte]: some thousand ids.
inline constexpr std::size_t kMaxRequestBytes = 64 << 10;

/// Reads a request for grasps out of a message of type quadrille.grasp_request_t, with every length
/// checked before the generated decoder sees the bytes; numbers are as they came.
/// @param bytes  the message as it came, fingerprint first
QUADRILLE_EXPORT Decoded<grasp_request_t> decode_request(std::span<const std::byte> bytes);

}  // namespace quadrille::bus
