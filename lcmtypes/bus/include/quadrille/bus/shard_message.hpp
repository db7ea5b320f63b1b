#pragma once

#include <cstddef>
#include <lcmtypes/quadrille/shard_cloud_t.hpp>
#include <span>

#include "quadrille/bus/rejection.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// Reads a shard's report on a cloud from a message of type quadrille.shard_cloud_t.
/// @param bytes  the message as it came, fingerprint first
QUADRILLE_EXPORT Decoded<shard_cloud_t> decode_shard_cloud(std::span<const std::byte> bytes);

}  // namespace quadrille::bus
