#include "src/run_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <sstream>

#include "hawser/base/error.hpp"
#include "src/files.hpp"

namespace hawser {
namespace {

/// Who holds a lock: as text "HOST PROCESS BIRTH BOOT SINCE", SINCE to the end of the line.
struct Owner {
  std::string host;
  long process = 0;
  std::string birth, boot, since;  // birth: in ticks after the boot of that name
};

std::string host_name() {
  std::array<char, 256> name{};
  gethostname(name.data(), name.size() - 1);
  return name[0] == '\0' ? "unknown" : name.data();
}

/// When the process began, in ticks since the system's start; "-" when there is no such process. A
/// process number is given again some day, this is not.
std::string birth_of(long process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  std::getline(file, text);
  const std::size_t name_end = text.rfind(')');  // a name may hold blanks
  if (name_end == std::string::npos) return "-";
  std::istringstream fields(text.substr(name_end + 1));
  std::string field;
  for (int i = 3; i <= 22; ++i)
    fields >> field;
  return field;
}

std::string boot_name() {
  std::string name = "-";
  std::ifstream("/proc/sys/kernel/random/boot_id") >> name;
  return name;
}

Owner this_process() {
  const std::time_t now = std::time(nullptr);
  std::array<char, 64> since{};
  std::strftime(since.data(), since.size(), "%Y-%m-%d %H:%M:%S UTC", std::gmtime(&now));
  return {host_name(), getpid(), birth_of(getpid()), boot_name(), since.data()};
}

bool is_alive(const Owner& owner) {
  if (owner.boot != boot_name()) return false;
  const bool there = kill(static_cast<pid_t>(owner.process), 0) == 0 || errno == EPERM;
  return there && birth_of(owner.process) == owner.birth;
}

Owner read_owner(int fd) {
  std::array<char, 512> text{};
  const ssize_t size = pread(fd, text.data(), text.size() - 1, 0);
  std::istringstream stream(
      std::string(text.data(), size > 0 ? static_cast<std::size_t>(size) : 0));
  Owner owner;
  stream >> owner.host >> owner.process >> owner.birth >> owner.boot >> std::ws;
  std::getline(stream, owner.since);
  return owner;
}

/// Some file systems know no such locks; there the owner's own word counts.
enum class Flock { got, taken, unknown };
Flock try_flock(int fd) {
  if (flock(fd, LOCK_EX | LOCK_NB) == 0) return Flock::got;
  return errno == EWOULDBLOCK ? Flock::taken : Flock::unknown;
}

bool is_same_file(int fd, const std::string& path) {
  struct stat here = {}, there = {};
  return fstat(fd, &here) == 0 && stat(path.c_str(), &there) == 0 && here.st_ino == there.st_ino &&
         here.st_dev == there.st_dev;
}

}  // namespace

RunLock::RunLock(const std::string& folder) : folder_(folder), path_(folder + "/lock") {
  // What is there may be gone when it is looked at: its owner has just ended.
  for (int attempt = 0; attempt < 100; ++attempt)
    if (make() || take_over()) return;
  throw OutputError(folder_ + ": no lock to be had; runs come and go there");
}

RunLock::~RunLock() {
  if (is_same_file(fd_, path_)) unlink(path_.c_str());
  close(fd_);
}

void RunLock::write_owner() const {
  const Owner owner = this_process();
  const std::string text = owner.host + " " + std::to_string(owner.process) + " " + owner.birth +
                           " " + owner.boot + " " + owner.since + "\n";
  if (ftruncate(fd_, 0) != 0 ||
      pwrite(fd_, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size()) ||
      fsync(fd_) != 0)
    throw_cannot("write", path_, errno);
}

bool RunLock::make() {
  const std::string own = path_ + "." + host_name() + "." + std::to_string(getpid());
  fd_ = open(own.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (fd_ < 0) throw_cannot("write", own, errno);
  try {
    write_owner();
  } catch (const OutputError&) {
    unlink(own.c_str());
    close(fd_);
    throw;
  }
  try_flock(fd_);
  bool made = link(own.c_str(), path_.c_str()) == 0;
  int reason = made ? 0 : errno;
  // A network file system may have made the link and lost its answer.
  struct stat status = {};
  if (!made && fstat(fd_, &status) == 0 && status.st_nlink == 2) made = true;
  if (!made && reason != EEXIST) {  // no links here: making a file is atomic, filling it is not
    const int fd = open(path_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    reason = errno;
    if (fd >= 0) {
      close(fd_);
      fd_ = fd;
      made = true;
      try_flock(fd_);
      write_owner();
    }
  }
  unlink(own.c_str());
  if (made) return true;
  close(fd_);
  fd_ = -1;
  if (reason != EEXIST) throw_cannot("write", path_, reason);
  return false;
}

bool RunLock::take_over() {
  fd_ = open(path_.c_str(), O_RDWR | O_CLOEXEC);
  if (fd_ < 0) return false;
  const Flock flocked = try_flock(fd_);
  const Owner owner = read_owner(fd_);
  if (flocked == Flock::got && !is_same_file(fd_, path_)) {
    close(fd_);
    fd_ = -1;
    return false;
  }
  const bool here = owner.host == host_name();
  if (flocked == Flock::got && here && !is_alive(owner)) {
    write_owner();
    return true;
  }
  close(fd_);
  fd_ = -1;
  const std::string who = owner.host.empty() ? "another process, which has not said who it is yet"
                                             : "process " + std::to_string(owner.process) + " on " +
                                                   owner.host + ", since " + owner.since;
  const bool may_be_gone = !here || (flocked == Flock::unknown && !is_alive(owner));
  throw OutputError(folder_ + " is in use by a run: " + who +
                    (may_be_gone ? "; whether it is alive cannot be told from here: if it is gone, "
                                   "remove " +
                                       path_
                                 : "; wait for its end, or choose another folder (--force "
                                   "does not help)"));
}

}  // namespace hawser
