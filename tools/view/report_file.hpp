#pragma once

#include <string>

#include "io/new_file.hpp"
#include "view/report.hpp"

namespace quadrille::view {

/// A report and its file, which appears once it is complete.
class ReportFile {
 public:
  /// @param title, command, settings  as for Report
  /// @throws io::FileError if the file cannot be created
  ReportFile(const std::string& path, std::string title, std::string command, std::string settings)
      : report_(std::move(title), std::move(command), std::move(settings)), file_(path) {}

  Report& report() { return report_; }

  /// Writes the file.
  /// @throws io::FileError if it cannot be written
  void finish() {
    file_.write(report_.html());
    file_.commit();
  }

 private:
  Report report_;
  io::NewFile file_;
};

}  // namespace quadrille::view
