#pragma once

#include <cstddef>
#include <new>
#include <span>
#include <string>
#include <utility>

#include "messages/byte_reader.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/quadrics_message.hpp"

namespace quadrille::bus {

/// Checks the members of a message that has a stamp and one list: utime, seq, frame and the list.
/// @param count              name of the list's length
/// @param min_element_bytes  size of an element whose own lists are empty
/// @param check              is called with the reader for each element
template <class Check>
void check_stamped_list(ByteReader& reader, const char* count, std::size_t min_element_bytes,
                        const Check& check) {
  reader.read_int64("utime");
  reader.read_int32("seq");
  reader.read_string("frame", kMaxFrameBytes);
  const std::int32_t size = reader.read_count(count, min_element_bytes);
  if (static_cast<std::size_t>(size) > kMaxQuadrics) {
    refuse(RejectReason::kTooLarge, std::string(count) + " " + std::to_string(size));
  }
  for (std::int32_t i = 0; i < size; ++i) check(reader);
}

/// A message with the stamp of a cloud, empty otherwise.
template <class Message>
Message stamped_as(const CloudMessage& cloud) {
  Message m;
  m.utime = cloud.utime;
  m.seq = cloud.seq;
  m.frame = cloud.cloud.frame;
  return m;
}

/// Decodes a message of ours by LCM's generated code after each of its members has been checked, so
/// that the code allocates at most a small multiple of the bytes.
/// @param check    is called with a ByteReader and walks over all members after the fingerprint
/// @param convert  makes the result from the decoded message
template <class Message, class Result = Message, class Check>
Decoded<Result> decode_checked(
    std::span<const std::byte> bytes, std::size_t max_bytes, const Check& check,
    Result (*convert)(Message) = [](Message m) { return m; }) try {
  ByteReader reader(bytes);
  if (reader.read_int64("the fingerprint") != Message::getHash()) {
    refuse(RejectReason::kUnknownType, std::string("not quadrille.") + Message::getTypeName());
  }
  if (bytes.size() > max_bytes) {
    refuse(RejectReason::kTooLarge, std::to_string(bytes.size()) + " bytes");
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
