#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrille::bus {

/// Returns the bytes of a message of a generated type.
/// @param message  message whose arrays have the lengths given by their counts; the generated
///   encoder reads past the end of a shorter array
/// @throws std::invalid_argument if the generated encoder fails
template <class Message>
std::vector<std::byte> encode(const Message& message) {
  std::vector<std::byte> bytes(static_cast<std::size_t>(message.getEncodedSize()));
  const int size = message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  if (size < 0 || static_cast<std::size_t>(size) != bytes.size()) {
    throw std::invalid_argument(std::string(Message::getTypeName()) + ": cannot be encoded");
  }
  return bytes;
}

}  // namespace quadrille::bus
