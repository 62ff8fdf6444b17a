#include <algorithm>
#include <fstream>
#include <numeric>

#include "hawser/base/error.hpp"
#include "hawser/output/checkpoint.hpp"
#include "src/checkpoint_layout.hpp"
#include "src/hdf5_file.hpp"
#include "src/seal.hpp"

namespace hawser {
namespace {

// This rank's even share of 0 .. count-1.
std::vector<GlobalIndex> share(const Communicator& communicator, GlobalIndex count) {
  const GlobalIndex begin = count * communicator.rank() / communicator.size();
  const GlobalIndex end = count * (communicator.rank() + 1) / communicator.size();
  std::vector<GlobalIndex> ids(static_cast<std::size_t>(end - begin));
  std::iota(ids.begin(), ids.end(), begin);
  return ids;
}

bool is_hdf5(const std::string& path) {
  std::string signature(8, '\0');
  std::ifstream(path, std::ios::binary).read(signature.data(), 8);
  return signature == "\211HDF\r\n\032\n";
}

/// Checkpoints before format 3 have no seal; to say so is all that is done with them.
[[noreturn]] void refuse_unsealed(const Communicator& communicator, const std::string& path) {
  const std::string refused = path + " is not a checkpoint";
  if (!communicator.any(communicator.is_root() && is_hdf5(path)))
    throw OutputError(refused + ": it is no HDF5 file");
  const Hdf5File file = Hdf5File::open(communicator, path);
  if (!file.has("/", "format_version")) throw OutputError(refused);
  throw OutputError(path + " has checkpoint format " +
                    std::to_string(file.integer("/", "format_version")) +
                    "; this program reads format " + std::to_string(layout::format_version));
}

/// Nothing of a file is given to HDF5 before its every byte is known to be right.
Hdf5File open_sealed(const Communicator& communicator, const std::string& path) {
  switch (check_seal(communicator, path)) {
    case Sealed::whole: return Hdf5File::open(communicator, path);
    case Sealed::never: refuse_unsealed(communicator, path);
    default: throw OutputError(path + " is damaged: it is not what was written");
  }
}

}  // namespace

class CheckpointReader::File {
 public:
  File(const Communicator& communicator, const std::string& path)
      : communicator_(communicator), path_(path), file_(open_sealed(communicator, path)) {}

  CheckpointHeader read_header() const {
    const GlobalIndex version = file_.integer("/", "format_version");
    if (version != layout::format_version)
      throw OutputError(path_ + " has checkpoint format " + std::to_string(version) +
                        "; this program reads format " + std::to_string(layout::format_version));
    CheckpointHeader header;
    header.step = static_cast<int>(file_.integer("/", "step"));
    header.time = file_.number("/", "time");
    for (const std::string& name : file_.attributes("numbers"))
      header.numbers[name] = file_.number("numbers", name);
    for (const std::string& name : file_.names("texts")) {
      header.texts[name] = file_.read_text(layout::text_path(name));
      require_same(layout::text_path(name), layout::text_checksum(header.texts[name]));
    }
    std::vector<KeptFile> known;
    for (std::size_t i = 0; i < file_.names("files").size(); ++i)
      known.push_back(named_file(i));
    require_same("/", layout::header_checksum(header, names(), known));
    return header;
  }

  void verify() const {
    for (const std::string& name : names()) {
      const std::string place = layout::array_path(name);
      const Hdf5File::Shape shape = file_.shape(place);
      const auto ids = share(communicator_, shape.rows);
      const auto values = file_.read(place, ids);
      require_same(place, layout::array_checksum(communicator_, shape.components, ids, values));
    }
    for (std::size_t i = 0; i < file_.names("files").size(); ++i)
      read_file(i);
  }

  bool has(const std::string& name) const { return file_.has(layout::array_path(name)); }
  std::vector<std::string> names() const { return file_.names("arrays"); }

  Hdf5File::Shape shape(const std::string& name) const {
    if (!has(name)) throw OutputError(path_ + " has no array '" + name + "'");
    return file_.shape(layout::array_path(name));
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
    return file_.read(layout::array_path(name), ids);
  }

  std::vector<KeptFile> files() const {
    std::vector<KeptFile> result;
    for (std::size_t i = 0; i < file_.names("files").size(); ++i)
      result.push_back(read_file(i));
    if (!communicator_.is_root()) result.clear();
    return result;
  }

 private:
  void require_same(const std::string& place, GlobalIndex sum) const {
    if (sum != file_.integer(place, layout::checksum))
      throw OutputError(path_ + " is damaged: '" + place + "' is not what was written");
  }

  KeptFile named_file(std::size_t number) const {
    const std::string place = layout::file_path(number);
    return {file_.text(place, "name"), file_.text(place, "path"), ""};
  }

  KeptFile read_file(std::size_t number) const {
    KeptFile file = named_file(number);
    const std::string place = layout::file_path(number);
    file.text = file_.read_bytes(place);
    const auto sum = communicator_.sum(
        static_cast<long long>(communicator_.is_root() ? layout::text_checksum(file.text) : 0));
    require_same(place, GlobalIndex{sum});
    return file;
  }

  Communicator communicator_;
  std::string path_;
  Hdf5File file_;
};

CheckpointReader::CheckpointReader(const Communicator& communicator, const std::string& path)
    : path_(path),
      file_(std::make_unique<File>(communicator, path)),
      header_(file_->read_header()) {
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

std::vector<KeptFile> CheckpointReader::files() const { return file_->files(); }

}  // namespace hawser
