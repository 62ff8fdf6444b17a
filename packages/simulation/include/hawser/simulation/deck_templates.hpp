#pragma once
#include <string>
#include <vector>

namespace hawser {

/// A commented deck to begin with; it runs as it is.
struct DeckTemplate {
  std::string name;
  std::string text;
  std::string summary() const;  ///< the first sentence of its comment
};

/// Those in packages/simulation/templates.
const std::vector<DeckTemplate>& deck_templates();

}  // namespace hawser
