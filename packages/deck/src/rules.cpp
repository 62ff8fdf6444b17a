#include "hawser/deck/rules.hpp"

#include <algorithm>

#include "hawser/deck/diagnostics.hpp"
#include "hawser/deck/value.hpp"

namespace hawser {
namespace {

Rules number_rule(const std::string& text, std::function<bool(double)> holds) {
  Rules rules;
  rules.numbers.push_back({text, std::move(holds)});
  return rules;
}

}  // namespace

std::string Rules::range_text() const {
  std::string result;
  const auto append = [&](const std::string& text) {
    if (!result.empty()) result += ", ";
    result += text;
  };
  for (const NumberCheck& check : numbers)
    append(check.text);
  if (!words.empty()) append("one of " + listed(words));
  if (is_any && result.empty()) append("any");
  const std::string least = std::to_string(least_length);
  if (greatest_length == least_length)
    append(least + (least_length == 1 ? " value" : " values"));
  else if (greatest_length > 0)
    append(least + " to " + std::to_string(greatest_length) + " values");
  else if (least_length > 1)
    append("at least " + least + " values");
  return result;
}

Rules operator&&(Rules a, const Rules& b) {
  a.is_required = a.is_required || b.is_required;
  a.is_any = a.is_any || b.is_any;
  if (a.absent.empty()) a.absent = b.absent;
  a.numbers.insert(a.numbers.end(), b.numbers.begin(), b.numbers.end());
  a.words.insert(a.words.end(), b.words.begin(), b.words.end());
  a.least_length = std::max(a.least_length, b.least_length);
  if (a.greatest_length == 0) a.greatest_length = b.greatest_length;
  return a;
}

Rules required() {
  Rules rules;
  rules.is_required = true;
  return rules;
}

Rules any() {
  Rules rules;
  rules.is_any = true;
  return rules;
}

Rules absent(const std::string& meaning) {
  Rules rules;
  rules.absent = meaning;
  return rules;
}

Rules positive() { return greater_than(0); }
Rules non_negative() { return at_least(0); }

Rules greater_than(double bound) {
  return number_rule("> " + write_value(bound), [bound](double value) { return value > bound; });
}
Rules less_than(double bound) {
  return number_rule("< " + write_value(bound), [bound](double value) { return value < bound; });
}
Rules at_least(double bound) {
  return number_rule(">= " + write_value(bound), [bound](double value) { return value >= bound; });
}
Rules at_most(double bound) {
  return number_rule("<= " + write_value(bound), [bound](double value) { return value <= bound; });
}
Rules between(double low, double high) {
  return number_rule("from " + write_value(low) + " to " + write_value(high),
                     [low, high](double value) { return low <= value && value <= high; });
}

Rules one_of(std::vector<std::string> words) {
  Rules rules;
  rules.words = std::move(words);
  return rules;
}

Rules length(int count) { return length(count, count); }

Rules length(int least, int greatest) {
  Rules rules;
  rules.least_length = least;
  rules.greatest_length = greatest;
  return rules;
}

}  // namespace hawser
