#pragma once

#include <cstdint>
#include <lcmtypes/quadrille/count_t.hpp>
#include <lcmtypes/quadrille/process_t.hpp>
#include <lcmtypes/quadrille/stage_t.hpp>
#include <lcmtypes/quadrille/transport_t.hpp>
#include <string>
#include <utility>
#include <vector>

namespace quadrille {

/// Formats a status in the text format that Prometheus and its node exporter read, in base units:
/// seconds and bytes.
class Exposition {
 public:
  using Labels = std::vector<std::pair<std::string, std::string>>;

  /// @param prefix  prefix of all names, such as "quadrille_detector"
  /// @param labels  labels of all samples, which distinguish processes of one kind
  explicit Exposition(std::string prefix, const Labels& labels = {});

  /// Adds a value that only grows; "_total" is appended to the name.
  void add_counter(const std::string& name, const std::string& help, std::int64_t value);
  void add_gauge(const std::string& name, const std::string& help, double value);
  /// Adds a counter for each entry, labelled with its reason, such as that of a refused message.
  void add_counters(const std::string& name, const std::string& help,
                    const std::vector<count_t>& counts);
  void add_stages(const std::vector<stage_t>& stages);
  /// @param ms  value of the status message [ms]; left out if it is negative
  void add_pose_age(double ms);
  void add_process(const process_t& process);
  void add_transport(const transport_t& transport);

  /// Adds what is remembered, and what came of the clouds of further cameras.
  template <class Status>
  void add_views(const Status& status) {
    add_counter("views_decoded", "Clouds of further cameras that passed all checks.",
                status.decoded_views);
    add_counters("views_refused", "Clouds of further cameras refused.", status.rejected_views);
    add_counters("views_unplaced", "Clouds of further cameras without a pose.",
                 status.unplaced_views);
    add_gauge("views_remembered", "Views that are remembered for later clouds.",
              static_cast<double>(status.remembered_views));
    add_gauge("pose_correction_metres", "How far the last pose was moved to fit the views.",
              status.pose_correction);
  }

  /// Adds the values that the status messages of all processes have in common.
  template <class Status>
  void add_common(const Status& status) {
    add_counter("received_bytes", "Bytes of messages received.", status.received_bytes);
    add_counter("published_bytes", "Bytes of results published.", status.published_bytes);
    add_gauge("warnings", "What is wrong, in sentences of the status.", status.num_warnings);
    add_transport(status.transport);
    add_stages(status.stages);
    add_process(status.process);
  }

  const std::string& text() const { return text_; }

 private:
  void start(const std::string& name, const std::string& help, const char* type);
  void add_sample(const std::string& name, const std::string& labels, double value);

  std::string prefix_, labels_, text_;
};

}  // namespace quadrille
