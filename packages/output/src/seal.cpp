#include "src/seal.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <vector>

#include "hawser/base/error.hpp"
#include "src/digest.hpp"
#include "src/files.hpp"

namespace hawser {
namespace {

constexpr const char* sealed_begin = "sealed by hawser: ";

/// A file that this rank reads, or writes at its beginning.
class RawFile {
 public:
  /// Without waiting for somebody to write into it, should it be a pipe.
  RawFile(std::string path, int flags)
      : path_(std::move(path)), fd_(open(path_.c_str(), flags | O_NONBLOCK)) {
    if (fd_ < 0) throw_cannot(flags == O_RDONLY ? "read the checkpoint" : "write", path_, errno);
    struct stat status = {};
    if (fstat(fd_, &status) == 0 && S_ISREG(status.st_mode)) return;
    close(fd_);
    throw OutputError(S_ISDIR(status.st_mode)
                          ? path_ + " is a folder; a checkpoint is a file, such as " + path_ +
                                "/checkpoint.h5"
                          : path_ + " is not a checkpoint: it is no file");
  }
  ~RawFile() { close(fd_); }
  RawFile(const RawFile&) = delete;
  RawFile& operator=(const RawFile&) = delete;

  long long size() const {
    struct stat status = {};
    if (fstat(fd_, &status) != 0) throw_cannot("read", path_, errno);
    return status.st_size;
  }
  /// As many bytes as there are, up to `count`.
  std::string read(long long from, std::size_t count) const {
    std::string bytes(count, '\0');
    std::size_t done = 0;
    while (done < count) {
      const ssize_t got =
          pread(fd_, bytes.data() + done, count - done, from + static_cast<long long>(done));
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) throw_cannot("read", path_, errno);
      if (got == 0) break;
      done += static_cast<std::size_t>(got);
    }
    bytes.resize(done);
    return bytes;
  }
  void write_first(const std::string& bytes) const {
    std::size_t done = 0;
    while (done < bytes.size()) {
      const ssize_t put =
          pwrite(fd_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
      if (put < 0 && errno == EINTR) continue;
      if (put < 0) throw_cannot("write", path_, errno);
      done += static_cast<std::size_t>(put);
    }
  }

 private:
  std::string path_;
  int fd_;
};

/// What the first block must be; every rank reads its share of the rest.
std::string expected_seal(const Communicator& communicator, const std::string& path) {
  constexpr long long word = 8, piece = 1 << 20;
  Digest digest;
  long long size = 0;
  communicator.together([&] {
    const RawFile file(path, O_RDONLY);
    size = file.size();
    const long long words = std::max(0LL, (size - seal_size + word - 1) / word);
    const long long begin = seal_size + word * (words * communicator.rank() / communicator.size());
    const long long end =
        seal_size + word * (words * (communicator.rank() + 1) / communicator.size());
    for (long long at = begin; at < std::min(end, size); at += piece) {
      const auto wanted = static_cast<std::size_t>(std::min({piece, end - at, size - at}));
      const std::string bytes = file.read(at, wanted);
      digest.add_bytes(static_cast<std::uint64_t>(at / word), bytes.data(), bytes.size());
    }
  });
  char text[128];
  std::snprintf(text, sizeof text, "%s%lld bytes, checksum %016llx\n", sealed_begin, size,
                static_cast<unsigned long long>(digest.total(communicator)));
  std::string block = text;
  block.resize(seal_size, '\0');
  return block;
}

}  // namespace

void seal(const Communicator& communicator, const std::string& path) {
  const std::string block = expected_seal(communicator, path);
  communicator.on_root([&] { RawFile(path, O_WRONLY).write_first(block); });
}

Sealed check_seal(const Communicator& communicator, const std::string& path) {
  std::string found;
  communicator.on_root([&] { found = RawFile(path, O_RDONLY).read(0, seal_size); });
  const std::string begin = sealed_begin;
  if (communicator.any(communicator.is_root() && found.compare(0, begin.size(), begin) != 0))
    return Sealed::never;
  const std::string wanted = expected_seal(communicator, path);
  const bool broken = communicator.is_root() && found != wanted;
  return communicator.any(broken) ? Sealed::broken : Sealed::whole;
}

}  // namespace hawser
