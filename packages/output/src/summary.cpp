#include "hawser/output/summary.hpp"

#include <nlohmann/json.hpp>

#include "src/files.hpp"

namespace hawser {

struct SummaryToJson {
  static nlohmann::ordered_json convert(const Summary& summary) {
    auto json = nlohmann::ordered_json::object();
    for (const auto& [key, value] : summary.values_) {
      std::visit([&json, &key = key](const auto& held) { json[key] = plain(held); }, value);
    }
    return json;
  }
  template <class T>
  static const T& plain(const T& value) {
    return value;
  }
  static nlohmann::ordered_json plain(const std::shared_ptr<Summary>& object) {
    return convert(*object);
  }
};

Summary::Value& Summary::value(const std::string& key) {
  for (auto& [name, held] : values_) {
    if (name == key) return held;
  }
  return values_.emplace_back(key, Value{}).second;
}

void Summary::set(const std::string& key, double number) { value(key) = number; }
void Summary::set(const std::string& key, int number) {
  value(key) = static_cast<long long>(number);
}
void Summary::set(const std::string& key, long long number) { value(key) = number; }
void Summary::set(const std::string& key, bool flag) { value(key) = flag; }
void Summary::set(const std::string& key, const std::vector<double>& numbers) {
  value(key) = numbers;
}
void Summary::set(const std::string& key, const std::vector<std::string>& texts) {
  value(key) = texts;
}
void Summary::set(const std::string& key, const std::string& text) { value(key) = text; }
void Summary::set(const std::string& key, const char* text) { value(key) = std::string(text); }

Summary& Summary::object(const std::string& key) {
  Value& held = value(key);
  if (!std::holds_alternative<std::shared_ptr<Summary>>(held)) held = std::make_shared<Summary>();
  return *std::get<std::shared_ptr<Summary>>(held);
}

std::optional<double> Summary::number(const std::string& key) const {
  for (const auto& [name, held] : values_) {
    if (name != key) continue;
    if (const auto* real = std::get_if<double>(&held)) return *real;
    if (const auto* count = std::get_if<long long>(&held)) return static_cast<double>(*count);
  }
  return {};
}

std::string Summary::json() const { return SummaryToJson::convert(*this).dump(2) + "\n"; }

void Summary::write(const Communicator& communicator, const std::string& path) const {
  communicator.on_root([&] { write_atomically(path, json()); });
}

}  // namespace hawser
