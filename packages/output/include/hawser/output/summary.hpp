#pragma once
// What a run amounts to: named numbers and words in the order they were set, written as JSON.
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "hawser/base/communicator.hpp"

namespace hawser {

class Summary {
 public:
  /// Keys are snake_case with the unit last, e.g. end_error_m. Setting a key again replaces its
  /// value.
  void set(const std::string& key, double value);
  void set(const std::string& key, int value);
  void set(const std::string& key, long long value);
  void set(const std::string& key, bool value);
  void set(const std::string& key, const std::vector<double>& values);
  void set(const std::string& key, const std::vector<std::string>& values);
  void set(const std::string& key, const std::string& value);
  void set(const std::string& key, const char* value);
  Summary& object(const std::string& key);  ///< the nested object of that name, made if need be

  std::optional<double> number(const std::string& key) const;  ///< none when absent or no number
  std::string json() const;  ///< doubles exactly; one that is not finite becomes null

  /// What rank 0 holds, all or nothing. Collective; OutputError on all ranks.
  void write(const Communicator& communicator, const std::string& path) const;

 private:
  using Value = std::variant<double, long long, bool, std::string, std::vector<double>,
                             std::vector<std::string>, std::shared_ptr<Summary>>;
  friend struct SummaryToJson;
  Value& value(const std::string& key);
  std::vector<std::pair<std::string, Value>> values_;
};

}  // namespace hawser
