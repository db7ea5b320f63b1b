#pragma once

#include <filesystem>
#include <string>

namespace quadrille::bench {

/// A temporary folder that is deleted on destruction.
class ScratchFolder {
 public:
  /// @throws std::runtime_error if it cannot be made
  ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();

  /// Path of a file in the folder.
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace quadrille::bench
