#pragma once

// The folder of one experiment's results:
//   jobs/<job>.json     one row a job, never half of one
//   experiment.yaml     the config, copied when a run ends
//   exchange/, lock     of the run that is going on; nothing there is a result

#include <filesystem>

namespace gcslab {

/// The right to write into a run folder, held by one process at a time, until it ends, however it ends.
class RunFolder {
 public:
  /// Makes the folder where needed and clears away what a killed run left. Throws InputError when that is not
  /// possible or when another run is going on there.
  explicit RunFolder(std::filesystem::path folder);
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  /// Where jobs and the runner exchange files.
  std::filesystem::path exchange() const { return folder_ / "exchange"; }

 private:
  std::filesystem::path folder_;
  int lock_ = -1;
};

}  // namespace gcslab
