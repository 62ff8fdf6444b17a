#include <algorithm>
#include <cctype>

#include "hawser/deck/diagnostics.hpp"

namespace hawser {
namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// Insertions, deletions, replacements and exchanges of neighbours that turn a into b.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j)
    last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = last;
    last = row;
  }
  return last[b.size()];
}

}  // namespace

std::string nearest_name(const std::string& given, const std::vector<std::string>& allowed) {
  std::string nearest;
  std::size_t least = std::max<std::size_t>(1, given.size() / 3) + 1;
  for (const std::string& name : allowed) {
    // Far lengths cannot be near; this also bounds the work for absurdly long names.
    if (name.size() > given.size() + least || given.size() > name.size() + least) continue;
    const std::size_t d = distance(lower(given), lower(name));
    // Every single letter is near to every other; one letter stands for a name that it is part of.
    const bool part = lower(name).find(lower(given)) != std::string::npos;
    if (d >= least || (given.size() < 2 && !part)) continue;
    least = d;
    nearest = name;
  }
  return nearest;
}

std::string did_you_mean(const std::string& given, const std::vector<std::string>& allowed) {
  const std::string nearest = nearest_name(given, allowed);
  return nearest.empty() ? "" : "; did you mean '" + nearest + "'?";
}

}  // namespace hawser
