#pragma once

namespace quadrille {

/// A line on a terminal that shows how far it is; nothing elsewhere. Wiped when it goes.
class ProgressLine {
 public:
  ProgressLine() = default;
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  /// @param share  of the work that is done, 0 to 1
  void show(double share);

 private:
  int shown_ = -1;
};

}  // namespace quadrille
