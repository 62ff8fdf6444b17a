#pragma once
// What a checkpoint knows of the case whose state it holds: the deck with all files that it names,
// and what the command line changed in it.
#include <vector>

#include "hawser/deck/input_files.hpp"
#include "hawser/deck/read_deck.hpp"
#include "hawser/output/checkpoint.hpp"

namespace hawser {

/// Among the files of a run, its mesh; no deck can give a file this name.
constexpr const char* kept_mesh = "<mesh>";

/// One change per path, the later ones winning.
std::vector<DeckChange> joined(std::vector<DeckChange> changes,
                               const std::vector<DeckChange>& later);

void keep_changes(const std::vector<DeckChange>& changes, CheckpointHeader& header);
std::vector<DeckChange> kept_changes(const CheckpointHeader& header);

/// Faults for changes of what makes a state what it is: a run that goes on keeps its mesh, its
/// modules, its conditions and the way in which it steps.
void check_restart(const std::vector<DeckChange>& changes, Diagnostics& diagnostics);

bool sets_end(const std::vector<DeckChange>& changes);
/// Works another end, in s, into the deck, which is to say what was run.
void set_end(DeckNode& root, double end);

std::vector<KeptFile> files_to_keep(const InputFiles::Kept& kept);
InputFiles::Kept kept_files(const CheckpointReader& reader);

}  // namespace hawser
