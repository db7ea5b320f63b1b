#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/planner/config.hpp"
#include "quadrille/inputs.hpp"
#include "view/report_file.hpp"

namespace quadrille {

/// The page of --report-html, if it is wanted.
class CommandReport {
 public:
  /// @param path  path of the page; empty if it is not wanted
  /// @param inputs  the inputs of the command
  /// @param settings  the settings, including those of the command line
  /// @throws io::FileError if the file cannot be created
  CommandReport(const std::string& path, const std::vector<std::string>& inputs,
                const io::Config& settings);

  bool wanted() const { return file_.has_value(); }

  /// Adds the scene under its cloud's name.
  /// @pre wanted()
  void add(const InputCloud& input, view::Scene scene);
  /// @pre wanted()
  void add_table(view::ReportTable table) { file_->report().add_table(std::move(table)); }

  /// Writes the page, if it is wanted, and warns of anything that it leaves out.
  /// @param failed  number of inputs that could not be read
  /// @throws io::FileError if it cannot be written
  void finish(std::size_t failed = 0);

 private:
  std::string path_;
  bool several_;
  std::optional<view::ReportFile> file_;
};

}  // namespace quadrille
