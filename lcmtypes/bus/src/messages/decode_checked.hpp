#pragma once

#include <cstddef>
#include <new>
#include <span>
#include <string>
#include <utility>

#include "messages/byte_reader.hpp"
#include "quadrille/bus/cloud_message.hpp"

namespace quadrille::bus {

/// Decodes a message of ours by LCM's generated code after each of its members has been checked, so
/// that the code allocates at most a small multiple of the bytes.
/// @param check    is called with a ByteReader and walks over all members after the fingerprint
/// @param convert  makes the result from the decoded message
template <class Message, class Result = Message, class Check>
Decoded<Result> decode_checked(
    std::span<const std::byte> bytes, std::size_t max_bytes, const Check& check,
    Result (*convert)(Message) = [](Message m) { return m; }) try {
  if (bytes.size() > max_bytes) {
    refuse(RejectReason::kTooLarge, std::to_string(bytes.size()) + " bytes");
  }
  ByteReader reader(bytes);
  if (reader.read_int64("the fingerprint") != Message::getHash()) {
    refuse(RejectReason::kUnknownType, std::string("not quadrille.") + Message::getTypeName());
  }
  check(reader);
  reader.expect_end();
  Message message;
  const int size = static_cast<int>(bytes.size());
  if (message.decode(bytes.data(), 0, size) != size) {
    refuse(RejectReason::kBadLength, "the decoder reads another size");
  }
  return convert(std::move(message));
} catch (const Refused& refused) {
  return refused.rejection;
} catch (const std::bad_alloc&) {
  return Rejection{RejectReason::kInternal, "out of memory"};
}

}  // namespace quadrille::bus
