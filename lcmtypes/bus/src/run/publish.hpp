#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>

namespace quadrille::bus {

/// Sends the bytes of one message to their destination, the bus or a log.
using Publish = std::function<void(const std::string& channel, std::span<const std::byte> bytes)>;

}  // namespace quadrille::bus
