#include "doctor/traffic.hpp"

#include <algorithm>
#include <lcmtypes/bot_core/pointcloud2_t.hpp>
#include <lcmtypes/bot_core/pointcloud_t.hpp>
#include <lcmtypes/bot_core/pose_t.hpp>
#include <lcmtypes/drake/lcmt_point_cloud.hpp>
#include <lcmtypes/quadrille/detector_status_t.hpp>
#include <lcmtypes/quadrille/grasps_t.hpp>
#include <lcmtypes/quadrille/planner_status_t.hpp>
#include <lcmtypes/quadrille/quadrics_t.hpp>

#include "doctor/datagram.hpp"

namespace quadrille::doctor {
namespace {

void note_time(std::int64_t utime, Stream* stream) {
  if (utime == 0) {
    ++stream->zero_utimes;
  } else if (stream->messages > 1 && utime <= stream->utime) {
    ++stream->stale_utimes;
  }
  stream->utime = utime;
}

void note_message(const Datagram& datagram, std::int64_t now, Stream* stream) {
  if (stream->messages++ == 0) stream->first = now;
  stream->last = now;
  stream->max_bytes = std::max(stream->max_bytes, datagram.message_bytes);
  stream->fingerprint = read_number(datagram.start, 0).value_or(0);
  stream->kind = kind_of(stream->fingerprint);
  // All types that have a kind begin with their time.
  const auto utime = read_number(datagram.start, 8);
  if (stream->kind != Kind::kOther && utime) note_time(*utime, stream);
}

}  // namespace

Kind kind_of(std::int64_t fingerprint) {
  static const std::map<std::int64_t, Kind> kinds = {
      {drake::lcmt_point_cloud::getHash(), Kind::kCloud},
      {bot_core::pointcloud2_t::getHash(), Kind::kCloud},
      {bot_core::pointcloud_t::getHash(), Kind::kCloud},
      {bot_core::pose_t::getHash(), Kind::kPose},
      {quadrics_t::getHash(), Kind::kQuadrics},
      {grasps_t::getHash(), Kind::kGrasps},
      {detector_status_t::getHash(), Kind::kDetectorStatus},
      {planner_status_t::getHash(), Kind::kPlannerStatus}};
  const auto found = kinds.find(fingerprint);
  return found == kinds.end() ? Kind::kOther : found->second;
}

void Traffic::add(const std::string& sender, std::span<const std::byte> bytes, std::int64_t now) {
  const auto datagram = read_datagram(bytes);
  if (!datagram) {
    ++malformed_;
    return;
  }
  const std::pair key(datagram->channel, sender);
  // Only the first fragment carries the name of the channel.
  const bool is_new =
      receptions_.count(sender) == 0 || (datagram->fragment == 0 && streams_.count(key) == 0);
  if (is_new && std::max(receptions_.size(), streams_.size()) >= kMaxStreams) {
    ++crowded_out_;
    return;
  }
  count_message(sender, datagram->sequence, datagram->fragments);
  if (datagram->fragment != 0) return;
  Stream& stream = streams_[key];
  stream.channel = datagram->channel;
  stream.sender = sender;
  note_message(*datagram, now, &stream);
}

void Traffic::count_message(const std::string& name, std::uint32_t sequence,
                            std::uint32_t fragments) {
  Reception& reception = receptions_[name];
  Sender& sender = senders_[name];
  if (reception.sequence == sequence) {
    ++reception.came;
    return;
  }
  if (reception.sequence) {
    // The first message may have begun before anyone listened.
    if (sender.messages > 1 && reception.came < reception.fragments) ++sender.incomplete;
    const std::uint32_t step = sequence - *reception.sequence;
    constexpr std::uint32_t kRestarted = 1u << 20;
    if (step < kRestarted) sender.missing += step - 1;
  }
  ++sender.messages;
  reception = {sequence, 1, fragments};
}

std::vector<Stream> Traffic::streams() const {
  std::vector<Stream> all;
  for (const auto& [key, stream] : streams_) all.push_back(stream);
  return all;
}

std::uint32_t Traffic::largest_cloud() const {
  std::uint32_t largest = 0;
  for (const auto& [key, stream] : streams_) {
    if (stream.kind == Kind::kCloud) largest = std::max(largest, stream.max_bytes);
  }
  return largest;
}

}  // namespace quadrille::doctor
