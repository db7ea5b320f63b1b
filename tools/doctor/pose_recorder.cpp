#include "doctor/pose_recorder.hpp"

#include <utility>
#include <variant>

#include "doctor/traffic.hpp"
#include "quadrille/bus/pose_message.hpp"

namespace quadrille::doctor {
namespace {

void keep(const Arrival& arrival, std::deque<Arrival>* all) {
  all->push_back(arrival);
  if (all->size() > PoseRecorder::kMaxArrivals) all->pop_front();
}

}  // namespace

PoseRecorder::PoseRecorder(std::string pose_channel, std::string cloud_channel, std::int64_t begin)
    : cloud_channel_(std::move(cloud_channel)) {
  heard_.channel = std::move(pose_channel);
  heard_.begin = begin;
}

void PoseRecorder::add(const std::string& sender, std::span<const std::byte> bytes,
                       std::int64_t now) {
  if (heard_.channel.empty()) return;
  const auto datagram = read_datagram(bytes);
  if (!datagram) return;
  if (datagram->fragment == 0) add_start(sender, *datagram, now);
  add_fragment(sender, *datagram, now);
}

PoseArrivals PoseRecorder::heard(std::int64_t now) const {
  PoseArrivals heard = heard_;
  heard.end = now;
  return heard;
}

/// Only the first fragment of a message says what it is.
void PoseRecorder::add_start(const std::string& sender, const Datagram& datagram,
                             std::int64_t now) {
  const Kind kind = kind_of(read_number(datagram.start, 0).value_or(0));
  if (datagram.channel == heard_.channel) {
    add_pose(datagram.start, now);
  } else if (kind == Kind::kPose && heard_.other_channels.size() < kMaxNames) {
    heard_.other_channels.insert(datagram.channel);
  } else if (kind == Kind::kCloud && datagram.channel == cloud_channel_) {
    if (parts_.size() >= kMaxParts) parts_.clear();
    parts_[sender] = {datagram.sequence, 0, read_number(datagram.start, 8).value_or(0)};
  }
}

void PoseRecorder::add_pose(std::span<const std::byte> message, std::int64_t now) {
  const auto decoded = bus::decode_pose(message);
  if (const auto* refusal = std::get_if<bus::Rejection>(&decoded)) {
    ++heard_.refused;
    heard_.refusal = *refusal;
    return;
  }
  keep({std::get<bus::PoseMessage>(decoded).utime, now}, &heard_.poses);
  if (heard_.poses.size() < kMaxArrivals) return;
  // The poses around earlier clouds may no longer be known.
  std::deque<Arrival>& clouds = heard_.clouds;
  while (!clouds.empty() && clouds.front().at < heard_.poses.front().at) clouds.pop_front();
}

/// A cloud arrives with its last fragment, which may be much later than its first.
void PoseRecorder::add_fragment(const std::string& sender, const Datagram& datagram,
                                std::int64_t now) {
  const auto part = parts_.find(sender);
  if (part == parts_.end() || part->second.sequence != datagram.sequence) return;
  if (++part->second.came < datagram.fragments) return;
  keep({part->second.utime, now}, &heard_.clouds);
  parts_.erase(part);
}

}  // namespace quadrille::doctor
