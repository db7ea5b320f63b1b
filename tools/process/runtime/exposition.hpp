#pragma once

#include <cstdint>
#include <lcmtypes/quadrille/count_t.hpp>
#include <lcmtypes/quadrille/process_t.hpp>
#include <lcmtypes/quadrille/stage_t.hpp>
#include <lcmtypes/quadrille/transport_t.hpp>
#include <string>
#include <vector>

namespace quadrille {

/// A status in the text format that Prometheus and its node exporter read, in base units: seconds
/// and bytes.
class Exposition {
 public:
  /// @param prefix  of all names, such as "quadrille_detector"
  explicit Exposition(std::string prefix) : prefix_(std::move(prefix)) {}

  /// What only grows; "_total" is added to the name.
  void add_counter(const std::string& name, const std::string& help, std::int64_t value);
  void add_gauge(const std::string& name, const std::string& help, double value);
  /// One counter for each cause, or whatever else the label says.
  void add_counters(const std::string& name, const std::string& help,
                    const std::vector<count_t>& counts, const std::string& label = "reason");
  void add_gauges(const std::string& name, const std::string& help, const std::string& label,
                  const std::vector<count_t>& values);
  void add_stages(const std::vector<stage_t>& stages);
  void add_process(const process_t& process);
  void add_transport(const transport_t& transport);

  const std::string& text() const { return text_; }

 private:
  void start(const std::string& name, const std::string& help, const char* type);
  void add_labelled(const std::string& name, const std::string& label,
                    const std::vector<count_t>& values);
  void add_sample(const std::string& name, const std::string& labels, double value);

  std::string prefix_, text_;
};

/// Replaces a file as a whole, so that no reader meets half of it.
/// @throws io::FileError if that fails
void replace_file(const std::string& path, const std::string& text);

}  // namespace quadrille
