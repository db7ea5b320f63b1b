#include "lab/study/study_files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "io/file_bytes.hpp"
#include "lab/study/csv.hpp"

namespace quadrille::study {
namespace {

namespace fs = std::filesystem;

std::string text_of(const std::string& path) {
  if (!fs::exists(path)) return "";
  const std::vector<std::byte> bytes = io::read_file(path);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void append_to(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::app | std::ios::binary);
  file << text << std::flush;
  if (!file)
    throw io::FileError(path, "", "cannot be written; check the folder and the space left");
}

void cut(const std::string& path, std::size_t size) {
  std::error_code error;
  fs::resize_file(path, size, error);
  if (error) throw io::FileError(path, "", "cannot be cut back (" + error.message() + ")");
}

/// Describes how a row's settings differ from those of this run; empty if they are the same.
std::string difference(const CsvTable& table, std::size_t row, const Label& label) {
  for (const auto& [column, value] : label) {
    const std::string& there = table.cell(row, column);
    if (there == value) continue;
    if (column == "settings") return "other settings (--config, or the gripper's sizes)";
    return fmt::format("{} '{}' where this run has '{}'", column, there, value);
  }
  return "";
}

void check_rows(const std::string& path, const CsvTable& table, const Label& label,
                const std::vector<SceneName>& names) {
  const auto refuse = [&](std::size_t row, const std::string& what) {
    throw io::FileError(path, fmt::format("row {}", row + 1),
                        fmt::format("{}; give another --csv, or the settings of before", what));
  };
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string other = difference(table, row, label);
    if (!other.empty()) refuse(row, fmt::format("has {}", other));
    const std::string there =
        fmt::format("scene {} ({})", table.cell(row, "scene"), table.cell(row, "input"));
    if (row >= names.size()) refuse(row, fmt::format("{} is none of this run", there));
    const std::string here = fmt::format("scene {} ({})", names[row].number, names[row].input);
    if (there != here) refuse(row, fmt::format("is {} where this run has {}", there, here));
  }
}

}  // namespace

std::string scenes_path(const std::string& csv_path) {
  return fs::path(csv_path).replace_extension(".scenes.csv").string();
}

StudyFiles::StudyFiles(const std::string& csv_path, const Label& label,
                       const std::vector<SceneName>& names)
    : grasps_path_(csv_path), scenes_path_(scenes_path(csv_path)) {
  lock();
  try {
    take_up(label, names);
  } catch (...) {
    close(lock_);
    throw;
  }
}

StudyFiles::~StudyFiles() { close(lock_); }

void StudyFiles::lock() {
  lock_ = open(grasps_path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (lock_ < 0) {
    throw io::FileError(grasps_path_, "",
                        fmt::format("cannot be written ({}); check the folder and its permissions",
                                    std::strerror(errno)));
  }
  if (flock(lock_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(lock_);
  throw io::FileError(grasps_path_, "", "is being written by another study; give another --csv");
}

void StudyFiles::begin() {
  append_to(grasps_path_, csv_line(grasp_columns()));
  append_to(scenes_path_, csv_line(scene_columns()));
}

void StudyFiles::take_up(const Label& label, const std::vector<SceneName>& names) {
  const std::string scenes_text = text_of(scenes_path_), grasps_text = text_of(grasps_path_);
  if (scenes_text.empty() && grasps_text.empty()) return begin();
  // An interruption between writing the two headers leaves only one of them.
  if (scenes_text.empty() && grasps_text == csv_line(grasp_columns())) {
    return append_to(scenes_path_, csv_line(scene_columns()));
  }
  if (scenes_text.empty()) {
    throw io::FileError(
        grasps_path_, "",
        fmt::format("is there, and {} is not: no study to go on with; give another --csv",
                    scenes_path_));
  }
  const CsvTable scenes(scenes_path_, scenes_text, scene_columns());
  const CsvTable grasps(grasps_path_, grasps_text, grasp_columns());
  check_rows(scenes_path_, scenes, label, names);
  finished_ = scenes.rows();
  std::size_t count = 0;
  for (std::size_t row = 0; row < finished_; ++row) {
    count += static_cast<std::size_t>(scenes.count(row, "grasps"));
  }
  if (grasps.rows() < count) {
    throw io::FileError(grasps_path_, "",
                        fmt::format("has {} rows where {} are counted in {}; delete both files",
                                    grasps.rows(), count, scenes_path_));
  }
  cut(scenes_path_, scenes.end_of(finished_));
  cut(grasps_path_, grasps.end_of(count));
}

void StudyFiles::append(const std::vector<std::vector<std::string>>& grasps,
                        const std::vector<std::string>& scene) {
  std::string text;
  for (const std::vector<std::string>& row : grasps) text += csv_line(row);
  append_to(grasps_path_, text);
  append_to(scenes_path_, csv_line(scene));
}

}  // namespace quadrille::study
