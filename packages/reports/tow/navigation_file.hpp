#pragma once
#include "hawser/mesh/mesh.hpp"
#include "tow_deck.hpp"

namespace hawser {

/// The shots of receivers.csv, `table`, as a navigation file in the folder. Read back from there,
/// so that a restarted run has those of before, too. Collective; OutputError, DeckError.
void write_navigation(const Mesh& mesh, const std::string& table, const std::string& folder,
                      const NavigationFileDeck& deck);

}  // namespace hawser
