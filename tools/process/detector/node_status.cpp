// Reports on the detector's node: status messages, statistics, the last line of a run.
#include <fmt/format.h>

#include <utility>

#include "process/detector/node.hpp"
#include "process/runtime/status/exposition.hpp"
#include "process/runtime/status/status.hpp"
#include "process/runtime/watch/other_senders.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/status_message.hpp"

namespace quadrille {

namespace {

std::string to_exposition(const detector_status_t& status, const DetectorSettings& settings) {
  Exposition out("quadrille_detector",
                 {{"channel", settings.in_channel}, {"status_channel", settings.status_channel}});
  out.add_counter("clouds_received", "Messages on the channel of the clouds.", status.received);
  out.add_counter("clouds_decoded", "Clouds that passed all checks.", status.decoded);
  out.add_counter("clouds_missing", "Clouds that never came, by gaps in their seq.",
                  status.missing);
  out.add_counter("clouds_superseded", "Clouds dropped for a newer one.", status.superseded);
  out.add_counter("clouds_failed", "Clouds on which the detection failed, also of further cameras.",
                  status.failed);
  out.add_counter("quadrics_published", "Messages of quadrics.", status.published);
  out.add_counters("messages_refused", "Messages of clouds and poses refused.", status.rejected);
  out.add_counters("knowledge_refused", "Messages on the robot and on what to forget refused.",
                   status.rejected_knowledge);
  out.add_counters("clouds_untracked", "Clouds without tracks.", status.untracked);
  out.add_views(status);
  out.add_pose_age(status.pose_age);
  out.add_gauge("clouds_per_second", "Over the last ten seconds.", status.received_rate);
  out.add_gauge("quadrics_per_second", "Over the last ten seconds.", status.published_rate);
  out.add_common(status);
  return out.text();
}

}  // namespace

std::string DetectorNode::publish_status(const RunState& run) {
  detector_status_t status{};
  fill_counts(&status);
  write_common(run, settings_hash_, &status);
  publish_(settings_.status_channel, bus::encode(status));
  return to_exposition(status, settings_);
}

void DetectorNode::fill_counts(detector_status_t* status) {
  const std::lock_guard lock(mutex_);
  *status = counts_;
  status->sender = own_sender();
  status->failed = failed();
  status->missing = gaps_.missing();
  status->received_rate = received_rate_.update(counts_.received);
  status->published_rate = published_rate_.update(counts_.published);
  status->rejected = bus::to_message(refusals_.counts());
  status->num_rejected = static_cast<std::int32_t>(status->rejected.size());
  status->rejected_knowledge = bus::to_message(refused_knowledge_.counts());
  status->num_rejected_knowledge = static_cast<std::int32_t>(status->rejected_knowledge.size());
  status->pose_age = posed_clouds_.last_age_ms();
  status->untracked = posed_clouds_.count_poseless();
  status->num_untracked = static_cast<std::int32_t>(status->untracked.size());
  posed_views_.fill(status);
  set_stages(stages_, status);
}

std::string DetectorNode::summary() const {
  const std::lock_guard lock(mutex_);
  const std::string poses =
      settings_.pose_channel.empty() ? "" : fmt::format("poses in: {}, ", posed_clouds_.poses());
  const std::string views = settings_.view_cameras.empty()
                                ? ""
                                : fmt::format("of further cameras: {}, ", posed_views_.decoded());
  return fmt::format("clouds in: {}, {}{}{}; quadrics out: {}", counts_.received, views, poses,
                     describe(refusals_.counts()), detections_);
}

std::vector<std::string> DetectorNode::find_oddities() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::string> oddities = posed_views_.find_oddities();
  const std::string oddity = posed_clouds_.find_oddity(counts_.decoded);
  if (!oddity.empty()) oddities.push_back(oddity);
  if (refused_knowledge_.counts().total() > 0) {
    oddities.push_back(fmt::format("of the messages on the robot and on what to forget {}",
                                   describe(refused_knowledge_.counts())));
  }
  return oddities;
}

}  // namespace quadrille
