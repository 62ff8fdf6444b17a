#include "hawser/deck/diagnostics.hpp"

#include <algorithm>

#include "hawser/base/error.hpp"
#include "src/shortened.hpp"

namespace hawser {
namespace {

// A list of all names that are allowed fits; what a broken deck repeats for pages does not.
constexpr std::size_t longest_sentence = 2000;

}  // namespace

void Diagnostics::error(const Location& where, const std::string& sentence) {
  const std::string text = shortened(sentence, longest_sentence);
  // Two kernels of one module may stumble over the same name: it is one fault.
  const auto same = [&](const Entry& e) { return e.where == where && e.sentence == text; };
  if (std::none_of(errors_.begin(), errors_.end(), same)) errors_.push_back({where, text});
}

std::string Diagnostics::error_text() const {
  std::vector<Entry> entries = errors_;
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& a, const Entry& b) { return a.where < b.where; });
  std::string result;
  for (const Entry& entry : entries) {
    if (!result.empty()) result += '\n';
    result += entry.where.text() + ": " + entry.sentence;
  }
  return result;
}

void Diagnostics::throw_if_any() const {
  if (!ok()) throw DeckError(error_text());
}

std::string listed(const std::vector<std::string>& words) {
  if (words.empty()) return "none";
  std::string result = words.front();
  for (std::size_t i = 1; i < words.size(); ++i)
    result += ", " + words[i];
  return result;
}

std::string shortened(const std::string& given, std::size_t longest) {
  std::string text = given.substr(0, longest);
  if (given.size() > longest) {
    // A character of several bytes is not cut in two.
    while (!text.empty() && (static_cast<unsigned char>(given[text.size()]) & 0xC0) == 0x80)
      text.pop_back();
    text += "...";
  }
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' '; }, ' ');
  return text;
}

std::string quoted(const std::string& given) { return "'" + shortened(given, 60) + "'"; }

}  // namespace hawser
