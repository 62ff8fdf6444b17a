#include "hawser/deck/diagnostics.hpp"

#include <algorithm>

#include "hawser/base/error.hpp"
#include "src/shortened.hpp"

namespace hawser {
namespace {

// A list of all names that are allowed fits; what a broken deck repeats for pages does not.
constexpr std::size_t longest_sentence = 2000;

}  // namespace

void Diagnostics::add(std::vector<Entry>& entries, const Location& where,
                      const std::string& sentence) {
  const std::string text = shortened(sentence, longest_sentence);
  // Two kernels of one module may stumble over the same name: it is one fault.
  const auto same = [&](const Entry& e) { return e.where == where && e.sentence == text; };
  if (std::none_of(entries.begin(), entries.end(), same)) entries.push_back({where, text});
}

void Diagnostics::error(const Location& where, const std::string& sentence) {
  add(errors_, where, sentence);
}

void Diagnostics::note(const Location& where, const std::string& sentence) {
  add(notes_, where, sentence);
}

std::vector<std::string> Diagnostics::texts(std::vector<Entry> entries) {
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& a, const Entry& b) { return a.where < b.where; });
  std::vector<std::string> result;
  for (const Entry& entry : entries)
    result.push_back(entry.where.text() + ": " + entry.sentence);
  return result;
}

std::string Diagnostics::error_text() const {
  std::string result;
  for (const std::string& line : texts(errors_))
    result += (result.empty() ? "" : "\n") + line;
  return result;
}

std::vector<std::string> Diagnostics::notes() const { return texts(notes_); }

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
