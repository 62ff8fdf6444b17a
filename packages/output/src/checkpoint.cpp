#include "hawser/output/checkpoint.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <stdexcept>

#include "hawser/base/error.hpp"
#include "src/files.hpp"
#include "src/hdf5_file.hpp"
#include "src/rows.hpp"

// Layout: attributes of "/": format, format_version, step, time (s), complete (written last);
// group "numbers" with one attribute each; group "texts" and group "arrays" with one dataset each;
// every array has its checksum as an attribute.
namespace hawser {
namespace {

constexpr GlobalIndex format_version = 2;

std::uint64_t mixed(std::uint64_t x) {  // splitmix64: every bit of x moves every bit of the result
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}

// A sum over entries, so that it does not depend on who holds which.
GlobalIndex checksum(const Communicator& communicator, int components,
                     const std::vector<GlobalIndex>& ids, const std::vector<double>& values) {
  std::uint64_t sum = 0;
  const auto width = static_cast<std::size_t>(components);
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &values[i], sizeof bits);
    sum += mixed(mixed(static_cast<std::uint64_t>(ids[i / width]) * width + i % width) ^ bits);
  }
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_UINT64_T, MPI_SUM, communicator.mpi());
  return static_cast<GlobalIndex>(sum);
}

std::string array_path(const std::string& name) { return "arrays/" + name; }

// This rank's even share of 0 .. count-1.
std::vector<GlobalIndex> share(const Communicator& communicator, GlobalIndex count) {
  const GlobalIndex begin = count * communicator.rank() / communicator.size();
  const GlobalIndex end = count * (communicator.rank() + 1) / communicator.size();
  std::vector<GlobalIndex> ids(static_cast<std::size_t>(end - begin));
  std::iota(ids.begin(), ids.end(), begin);
  return ids;
}

// Told apart here, with the system's reason, because HDF5 calls them all "unable to open file".
void require_hdf5(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDONLY);
  if (descriptor < 0) throw_cannot("read the checkpoint", path, errno);
  char signature[8] = {};
  const ssize_t size = ::read(descriptor, signature, sizeof signature);
  close(descriptor);
  if (size != 8 || std::memcmp(signature, "\211HDF\r\n\032\n", 8) != 0) {
    throw OutputError(path + " is not a checkpoint: it is no HDF5 file");
  }
}

Hdf5File open_checkpoint(const Communicator& communicator, const std::string& path) {
  communicator.on_root([&] { require_hdf5(path); });
  return Hdf5File::open(communicator, path);
}

/// Of the names that begin with `prefix`, what is behind it.
template <class Map>
Map without_prefix(const Map& all, const std::string& prefix) {
  Map result;
  for (auto i = all.lower_bound(prefix); i != all.end(); ++i) {
    if (i->first.compare(0, prefix.size(), prefix) != 0) break;
    result.emplace(i->first.substr(prefix.size()), i->second);
  }
  return result;
}

}  // namespace

void CheckpointNotes::add(const std::string& prefix, const CheckpointNotes& notes) {
  for (const auto& [name, value] : notes.numbers) {
    numbers[prefix + name] = value;
  }
  for (const auto& [name, text] : notes.texts) {
    texts[prefix + name] = text;
  }
}

CheckpointNotes CheckpointNotes::part(const std::string& prefix) const {
  return {without_prefix(numbers, prefix), without_prefix(texts, prefix)};
}

void write_checkpoint(const Communicator& communicator, const std::string& path,
                      const CheckpointHeader& header, const std::vector<NamedArray>& arrays) {
  GlobalIndex numbers = 0;
  for (const NamedArray& array : arrays) {
    numbers += array.global_count * array.components;
  }
  for (const auto& [name, text] : header.texts) {
    numbers += static_cast<GlobalIndex>(text.size() / sizeof(double)) + 1;
  }
  communicator.on_root([&] { try_room(unfinished(path), room_for(numbers)); });
  Hdf5File file = Hdf5File::create(communicator, unfinished(path));
  file.set("/", "format", "hawser checkpoint");
  file.set("/", "format_version", format_version);
  file.set("/", "step", GlobalIndex{header.step});
  file.set("/", "time", header.time);
  file.make_group("numbers");
  for (const auto& [name, value] : header.numbers) {
    file.set("numbers", name, value);
  }
  file.make_group("texts");
  for (const auto& [name, text] : header.texts) {
    file.write_text("texts/" + name, text);
  }
  file.make_group("arrays");
  for (const NamedArray& array : arrays) {
    const Rows rows(communicator, array.global_count, array.ids);
    file.write(array_path(array.name), {array.global_count, array.components}, rows.positions(),
               array.values);
    file.set(array_path(array.name), "checksum",
             checksum(communicator, array.components, array.ids, array.values));
  }
  file.set("/", "complete", GlobalIndex{1});
  file.close();
  communicator.on_root([&] { finish(path); });
}

class CheckpointReader::File {
 public:
  File(const Communicator& communicator, const std::string& path)
      : communicator_(communicator), path_(path), file_(open_checkpoint(communicator, path)) {}

  CheckpointHeader read_header() const {
    if (!file_.has("/", "format_version")) throw OutputError(path_ + " is not a checkpoint");
    const GlobalIndex version = file_.integer("/", "format_version");
    if (version != format_version) {
      throw OutputError(path_ + " has checkpoint format " + std::to_string(version) +
                        "; this program reads format " + std::to_string(format_version));
    }
    if (!file_.has("/", "complete")) throw OutputError(path_ + " is an incomplete checkpoint");
    CheckpointHeader header;
    header.step = static_cast<int>(file_.integer("/", "step"));
    header.time = file_.number("/", "time");
    for (const std::string& name : file_.attributes("numbers")) {
      header.numbers[name] = file_.number("numbers", name);
    }
    for (const std::string& name : file_.names("texts")) {
      header.texts[name] = file_.read_text("texts/" + name);
    }
    return header;
  }

  void verify() const {
    for (const std::string& name : file_.names("arrays")) {
      const Hdf5File::Shape shape = file_.shape(array_path(name));
      const auto ids = share(communicator_, shape.rows);
      const auto values = file_.read(array_path(name), ids);
      if (checksum(communicator_, shape.components, ids, values) !=
          file_.integer(array_path(name), "checksum")) {
        throw OutputError(path_ + " is corrupt: array '" + name + "' is not what was written");
      }
    }
  }

  bool has(const std::string& name) const { return file_.has(array_path(name)); }
  std::vector<std::string> names() const { return file_.names("arrays"); }

  Hdf5File::Shape shape(const std::string& name) const {
    if (!has(name)) throw OutputError(path_ + " has no array '" + name + "'");
    return file_.shape(array_path(name));
  }

  std::vector<double> read(const std::string& name, const std::vector<GlobalIndex>& ids,
                           int components) const {
    const Hdf5File::Shape found = shape(name);
    if (found.components != components) {
      throw OutputError(path_ + ": array '" + name + "' has " + std::to_string(found.components) +
                        " components, not " + std::to_string(components));
    }
    communicator_.together([&] {
      for (const GlobalIndex id : ids) {
        if (id >= 0 && id < found.rows) continue;
        throw OutputError(path_ + ": array '" + name + "' has " + std::to_string(found.rows) +
                          " entries, and number " + std::to_string(id) + " is asked for");
      }
    });
    return file_.read(array_path(name), ids);
  }

 private:
  Communicator communicator_;
  std::string path_;
  Hdf5File file_;
};

CheckpointReader::CheckpointReader(const Communicator& communicator, const std::string& path)
    : file_(std::make_unique<File>(communicator, path)), header_(file_->read_header()) {
  file_->verify();
}

CheckpointReader::~CheckpointReader() = default;

bool CheckpointReader::has(const std::string& name) const { return file_->has(name); }

std::vector<std::string> CheckpointReader::names() const { return file_->names(); }

GlobalIndex CheckpointReader::global_count(const std::string& name) const {
  return file_->shape(name).rows;
}

std::vector<double> CheckpointReader::read(const std::string& name,
                                           const std::vector<GlobalIndex>& ids,
                                           int components) const {
  return file_->read(name, ids, components);
}

}  // namespace hawser
