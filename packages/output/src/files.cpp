#include "src/files.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "hawser/base/error.hpp"

namespace hawser {
namespace {

class Descriptor {
 public:
  Descriptor(const std::string& path, int flags)
      : path_(path), fd_(open(path.c_str(), flags, 0666)) {
    if (fd_ < 0) throw_cannot("open", path_, errno);
  }
  ~Descriptor() { close(fd_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  void write_all(const std::string& text) const {
    std::size_t done = 0;
    while (done < text.size()) {
      const ssize_t count = ::write(fd_, text.data() + done, text.size() - done);
      if (count < 0 && errno != EINTR) throw_cannot("write", path_, errno);
      if (count > 0) done += static_cast<std::size_t>(count);
    }
  }
  void reserve(std::size_t bytes) const {
    if (bytes == 0 || fallocate(fd_, 0, 0, static_cast<off_t>(bytes)) == 0) return;
    if (errno == EOPNOTSUPP || errno == ENOSYS) return;  // some file systems cannot promise
    const int reason = errno;
    unlink(path_.c_str());
    throw_cannot("write", path_, reason);
  }
  void sync() const {
    // EINVAL: a file system that cannot sync has nothing further to promise.
    if (fsync(fd_) != 0 && errno != EINVAL) throw_cannot("write", path_, errno);
  }

 private:
  std::string path_;
  int fd_;
};

}  // namespace

std::string unfinished(const std::string& path) { return path + ".unfinished"; }

void throw_cannot(const std::string& verb, const std::string& path, int error_number) {
  throw OutputError("cannot " + verb + " " + path + ": " + std::strerror(error_number));
}

std::size_t room_for(GlobalIndex numbers) {
  return (64U << 10U) + 8 * static_cast<std::size_t>(numbers);
}

void try_room(const std::string& path, std::size_t bytes) {
  Descriptor(path, O_WRONLY | O_CREAT | O_TRUNC).reserve(bytes);
}

void sync(const std::string& path) { Descriptor(path, O_RDONLY).sync(); }

void finish(const std::string& path) {
  sync(unfinished(path));
  if (std::rename(unfinished(path).c_str(), path.c_str()) != 0) throw_cannot("write", path, errno);
  // The new name is on disk only when its folder is.
  const std::string folder = std::filesystem::path(path).parent_path();
  Descriptor(folder.empty() ? "." : folder, O_RDONLY).sync();
}

void write_atomically(const std::string& path, const std::string& text) {
  Descriptor(unfinished(path), O_WRONLY | O_CREAT | O_TRUNC).write_all(text);
  finish(path);
}

}  // namespace hawser
