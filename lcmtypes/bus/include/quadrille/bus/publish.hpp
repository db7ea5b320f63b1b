#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>

namespace quadrille::bus {

/// Takes the bytes of one message to where they are wanted, the bus or a log.
using Publish = std::function<void(const std::string& channel, std::span<const std::byte> bytes)>;

}  // namespace quadrille::bus
