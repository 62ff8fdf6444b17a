#include "hawser/deck/input_files.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include "hawser/base/error.hpp"

namespace hawser {

std::optional<std::string> read_bytes(const std::string& file, std::size_t limit) {
  std::error_code none;
  const auto status = std::filesystem::status(file, none);
  // A pipe may stand for a file (bash's <(...)); a device may have no end.
  if (!std::filesystem::is_regular_file(status) && !std::filesystem::is_fifo(status))
    return std::nullopt;
  std::ifstream stream(file, std::ios::binary);
  if (!stream.is_open()) return std::nullopt;
  std::string text;
  std::array<char, 1U << 16U> piece;
  while (text.size() <= limit && stream) {
    const std::size_t wanted = std::min(piece.size(), limit + 1 - text.size());
    stream.read(piece.data(), static_cast<std::streamsize>(wanted));
    text.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) return std::nullopt;
  return text;
}

InputFiles::InputFiles(const Communicator& communicator, Kept kept)
    : communicator_(communicator), kept_(std::move(kept)) {
  if (!communicator_.is_root()) kept_.clear();
}

std::optional<std::string> InputFiles::read(const std::string& name, std::size_t limit) {
  std::optional<std::string> text;
  if (communicator_.is_root()) {
    const auto known = kept_.find(name);
    text = known == kept_.end() ? read_bytes(name, limit) : known->second.text;
    std::error_code none;
    if (text && known == kept_.end())
      kept_[name] = {std::filesystem::absolute(name, none).lexically_normal().string(), *text};
  }
  const std::string all = communicator_.broadcast(text ? "+" + *text : "-");
  return all[0] == '+' ? std::optional<std::string>(all.substr(1)) : std::nullopt;
}

void InputFiles::keep(const std::string& name, const std::string& file, const std::string& path) {
  communicator_.on_root([&] {
    if (kept_.count(name) > 0) return;
    std::optional<std::string> bytes = read_bytes(file);
    if (!bytes) throw OutputError("cannot read " + file);
    kept_[name] = {path, std::move(*bytes)};
  });
}

std::vector<std::string> InputFiles::edited(const Communicator& communicator, const Kept& kept) {
  std::string names;  // a line each
  if (communicator.is_root())
    for (const auto& [name, file] : kept) {
      if (file.path.empty()) continue;
      std::error_code none;
      if (!std::filesystem::is_regular_file(file.path, none)) continue;
      const std::optional<std::string> now = read_bytes(file.path);
      if (now && *now != file.text) names += file.path + "\n";
    }
  names = communicator.broadcast(names);
  std::vector<std::string> result;
  for (std::size_t begin = 0; begin < names.size();) {
    const std::size_t end = names.find('\n', begin);
    result.push_back(names.substr(begin, end - begin));
    begin = end + 1;
  }
  return result;
}

}  // namespace hawser
