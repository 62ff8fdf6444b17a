#include "hawser/output/checkpoint.hpp"

#include <unistd.h>

#include <cstring>
#include <filesystem>

#include "hawser/base/error.hpp"
#include "src/checkpoint_layout.hpp"
#include "src/digest.hpp"
#include "src/files.hpp"
#include "src/hdf5_file.hpp"
#include "src/rows.hpp"
#include "src/seal.hpp"

namespace hawser {
namespace {

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

std::uint64_t bits_of(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

std::string words(double value) { return std::to_string(bits_of(value)); }

std::size_t room(const Checkpoint& checkpoint, const std::vector<KeptFile>& files) {
  std::size_t bytes = seal_size;
  GlobalIndex numbers = 0;
  for (const NamedArray& array : checkpoint.arrays)
    numbers += array.global_count * array.components;
  for (const auto& [name, text] : checkpoint.header.texts)
    bytes += text.size();
  for (const KeptFile& file : files)
    bytes += file.text.size();
  return bytes + room_for(numbers);
}

void write_header(Hdf5File& file, const CheckpointHeader& header) {
  file.set("/", "format_version", layout::format_version);
  file.set("/", "step", GlobalIndex{header.step});
  file.set("/", "time", header.time);
  file.make_group("numbers");
  for (const auto& [name, value] : header.numbers)
    file.set("numbers", name, value);
  file.make_group("texts");
  for (const auto& [name, text] : header.texts) {
    file.write_text(layout::text_path(name), text);
    file.set(layout::text_path(name), layout::checksum, layout::text_checksum(text));
  }
}

/// Returns names and paths, on all ranks.
std::vector<KeptFile> write_files(const Communicator& communicator, Hdf5File& file,
                                  const std::vector<KeptFile>& files) {
  file.make_group("files");
  const auto count = static_cast<std::size_t>(
      communicator.sum(static_cast<long long>(communicator.is_root() ? files.size() : 0)));
  std::vector<KeptFile> known(count);
  for (std::size_t i = 0; i < count; ++i) {
    const KeptFile given = communicator.is_root() ? files[i] : KeptFile{};
    known[i].name = communicator.broadcast(given.name);
    known[i].path = communicator.broadcast(given.path);
    const auto sum = communicator.sum(
        static_cast<long long>(communicator.is_root() ? layout::text_checksum(given.text) : 0));
    file.write_bytes(layout::file_path(i), given.text);
    file.set(layout::file_path(i), "name", known[i].name);
    file.set(layout::file_path(i), "path", known[i].path);
    file.set(layout::file_path(i), layout::checksum, GlobalIndex{sum});
  }
  return known;
}

void write_hdf5(const Communicator& communicator, const std::string& path,
                const Checkpoint& checkpoint, const std::vector<KeptFile>& files) {
  Hdf5File file = Hdf5File::create(communicator, path, seal_size);
  write_header(file, checkpoint.header);
  const std::vector<KeptFile> known = write_files(communicator, file, files);
  file.make_group("arrays");
  std::vector<std::string> names;
  for (const NamedArray& array : checkpoint.arrays) {
    names.push_back(array.name);
    const Rows rows(communicator, array.global_count, array.ids);
    const std::string place = layout::array_path(array.name);
    file.write(place, {array.global_count, array.components}, rows.positions(), array.values);
    file.set(place, layout::checksum,
             layout::array_checksum(communicator, array.components, array.ids, array.values));
  }
  file.set("/", layout::checksum, layout::header_checksum(checkpoint.header, names, known));
  file.close();
}

/// What is at `path` keeps its name until the next file takes it, where the file system has links.
void keep_as(const std::string& path, const std::string& previous) {
  if (previous.empty() || access(path.c_str(), F_OK) != 0) return;
  const std::string link_name = unfinished(previous);
  unlink(link_name.c_str());
  const bool linked = link(path.c_str(), link_name.c_str()) == 0;
  if (std::rename((linked ? link_name : path).c_str(), previous.c_str()) != 0)
    throw_cannot("write", previous, errno);
}

}  // namespace

namespace layout {

GlobalIndex header_checksum(const CheckpointHeader& header, const std::vector<std::string>& arrays,
                            const std::vector<KeptFile>& files) {
  std::string all = std::to_string(header.step) + " " + words(header.time) + "\n";
  for (const auto& [name, value] : header.numbers)
    all += name + " " + words(value) + "\n";
  for (const auto& [name, text] : header.texts)
    all += "text " + name + "\n";
  // HDF5 gives the names back in an order of its own.
  std::uint64_t names = 0;
  for (const std::string& name : arrays)
    names += digest_of("array " + name);
  for (const KeptFile& file : files)
    names += digest_of("file " + file.name + " " + file.path);
  return static_cast<GlobalIndex>(digest_of(all) + names);
}

GlobalIndex text_checksum(const std::string& text) {
  return static_cast<GlobalIndex>(digest_of(text));
}

GlobalIndex array_checksum(const Communicator& communicator, int components,
                           const std::vector<GlobalIndex>& ids, const std::vector<double>& values) {
  Digest digest;
  const auto width = static_cast<std::size_t>(components);
  for (std::size_t i = 0; i < values.size(); ++i)
    digest.add(static_cast<std::uint64_t>(ids[i / width]) * width + i % width, bits_of(values[i]));
  return static_cast<GlobalIndex>(digest.total(communicator));
}

}  // namespace layout

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
                      const Checkpoint& checkpoint, const std::vector<KeptFile>& files,
                      const std::string& previous) {
  const std::string next = unfinished(path);
  try {
    communicator.on_root([&] { try_room(next, room(checkpoint, files)); });
    write_hdf5(communicator, next, checkpoint, files);
    seal(communicator, next);
    // Not every layer below tells of a write that went wrong.
    const CheckpointReader again(communicator, next);
    communicator.on_root([&] {
      sync(next);
      keep_as(path, previous);
      finish(path);
    });
  } catch (const OutputError&) {
    if (communicator.is_root()) unlink(next.c_str());
    throw;
  }
}

std::string previous_checkpoint(const std::string& path) {
  return std::filesystem::path(path).replace_extension(".previous.h5").string();
}

OpenedCheckpoint open_checkpoint(const Communicator& communicator, const std::string& path) {
  const std::string previous = previous_checkpoint(path);
  std::string damage;
  try {
    return {std::make_unique<CheckpointReader>(communicator, path), ""};
  } catch (const OutputError& error) {
    damage = error.what();
  }
  std::error_code none;
  if (!communicator.any(communicator.is_root() && std::filesystem::exists(previous, none)))
    throw OutputError(damage);
  try {
    return {std::make_unique<CheckpointReader>(communicator, previous), damage};
  } catch (const OutputError& error) {
    throw OutputError(damage + "; and the one before it is of no use, either: " + error.what());
  }
}

}  // namespace hawser
