#pragma once
// One run in one folder at a time.
#include <string>

namespace hawser {

/// Holds FOLDER/lock, which says who holds it, while it lives. For one rank of a run.
///
/// The file is made complete under a name of its own and then linked, which is atomic on network
/// file systems, too, and it is locked (flock) as long as its process lives. A lock of this host
/// whose file nobody has locked and whose process is gone is taken over; one of another host never
/// is: nothing tells from here whether that one lives.
class RunLock {
 public:
  /// OutputError when another run holds the lock, or when none can be made.
  explicit RunLock(const std::string& folder);
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

 private:
  /// Whether it is ours now; what is there belongs to nobody and may be gone when it is not.
  bool make();
  bool take_over();
  void write_owner() const;

  std::string folder_, path_;
  int fd_ = -1;
};

}  // namespace hawser
