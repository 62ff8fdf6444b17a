#pragma once
// Makes mutants of texts. Deterministic: those of one seed are the same every time.
#include <algorithm>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace hawser {

/// What a format is made of, for mutants that a reader does not refuse at first sight.
struct MutantParts {
  std::vector<std::string> words;  ///< odd ones to put in
  /// Begin and length of a part, a cell or a value, somewhere at or behind a place; length 0: none.
  std::function<std::pair<std::size_t, std::size_t>(const std::string& text, std::size_t from)>
      part;
  std::size_t kept = 0;  ///< bytes at the beginning that stay
};

class Mutator {
 public:
  Mutator(unsigned seed, const MutantParts& parts) : random_(seed), parts_(parts) {}

  std::size_t below(std::size_t bound) { return bound == 0 ? 0 : random_() % bound; }

  std::string mutated(std::string text) {
    for (std::size_t i = 0, count = 1 + below(3); i < count; ++i)
      mutate(text);
    return text;
  }

 private:
  void mutate(std::string& text) {
    constexpr std::size_t kinds = 10, most_copied = 200, most_cut = 300, most_inserted = 5000;
    const std::size_t at = place(text);
    switch (below(kinds)) {
      case 0: text.erase(at, below(8)); break;
      case 1: text.insert(at, word()); break;
      case 2:
        if (at < text.size()) text[at] = static_cast<char>(random_() & 0xFFU);
        break;
      case 3: text.insert(at, text.substr(place(text), below(most_copied))); break;
      case 4: text.erase(at, below(most_cut)); break;
      case 5: replace_part(text, word()); break;
      case 6: {
        const auto [begin, length] = parts_.part(text, place(text));
        replace_part(text, text.substr(begin, length));
        break;
      }
      case 7:
        if (at + 1 < text.size()) std::swap(text[at], text[at + 1]);
        break;
      case 8: swap_lines(text); break;
      default: text.insert(at, std::string(below(most_inserted), word()[0])); break;
    }
  }

  std::size_t place(const std::string& text) {
    const std::size_t kept = std::min(parts_.kept, text.size());
    return kept + below(text.size() - kept + 1);
  }
  const std::string& word() { return parts_.words[below(parts_.words.size())]; }

  void replace_part(std::string& text, const std::string& by) {
    const auto [begin, length] = parts_.part(text, place(text));
    text.replace(begin, length, by);
  }

  /// Of those that are not kept.
  void swap_lines(std::string& text) {
    std::vector<std::pair<std::size_t, std::size_t>> lines;
    for (std::size_t begin = std::min(parts_.kept, text.size()); begin < text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      lines.emplace_back(begin, end - begin);
      begin = end + 1;
    }
    if (lines.empty()) return;
    auto first = lines[below(lines.size())], second = lines[below(lines.size())];
    if (first.first > second.first) std::swap(first, second);
    if (first.first == second.first) return;
    const std::string moved = text.substr(first.first, first.second);
    const std::string other = text.substr(second.first, second.second);
    text.replace(second.first, second.second, moved);
    text.replace(first.first, first.second, other);
  }

  std::mt19937 random_;
  const MutantParts& parts_;
};

}  // namespace hawser
