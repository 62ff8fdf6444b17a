#pragma once
// Stable: part of the interface for programs that embed Hawser (doc/embedding.md).
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hawser/base/domain.hpp"
#include "hawser/base/scratch_folder.hpp"
#include "hawser/deck/read_deck.hpp"
#include "hawser/output/checkpoint.hpp"
#include "hawser/simulation/environment.hpp"

namespace hawser {

struct Mesh;
struct RunDeck;

struct CaseOptions {
  std::vector<DeckChange> changes{};  ///< of the deck: {"tow_speed", "0.3"}, {"time/step", "5"}
  std::optional<double> end{};        ///< s, instead of the deck's end
  bool expects = true;                ///< judge by the deck's expectations
};

/// What is to be computed, read and checked, from where on; nothing is built and nothing written
/// yet. It is not changed by what is done with it, and cheap to copy.
class Case {
 public:
  /// All of these are collective; DeckError with every fault, or PluginError, on all ranks.
  static Case from_file(const Environment& environment, const std::string& deck,
                        const CaseOptions& options = {});
  /// The same for a deck at hand; `name` stands for its file in messages and says by its folder
  /// where files lie that it names, such as a mesh.
  static Case from_text(const Environment& environment, const std::string& text,
                        const std::string& name = "deck", const CaseOptions& options = {});
  /// Goes on from a checkpoint, or from the one before it when that is damaged, with the deck, the
  /// tables and the mesh that are kept in it. OutputError when it cannot be read, Error (usage)
  /// when nothing is left to do, DeckError for changes of what a run that goes on must keep.
  static Case from_checkpoint(const Environment& environment, const std::string& file,
                              const CaseOptions& options = {});

  /// The same under another deck: changes as `--set` has them, expectations left out. DeckError.
  Case changed(const std::vector<DeckChange>& changes) const;

  const Communicator& communicator() const;
  std::string resolved_deck() const;  ///< XML with every default
  bool has_mesh_file() const;         ///< the deck names one
  bool has_line_mesh() const;         ///< which is made at once, without the mesher

  const Deck& text() const;     ///< as read, what it extends and the changes worked in
  const RunDeck& deck() const;  ///< as parameters
  std::vector<PhysicsModule> make_modules() const;  ///< new ones at each call
  const std::vector<PlannedReport>& reports() const;
  const CheckpointReader* checkpoint() const;  ///< null when it starts from the deck
  std::optional<double> end() const;           ///< s, when the options, now or before, had one
  /// s, of the deck, when the run ends before it, where the deck's expectations do not apply.
  std::optional<double> end_of_deck() const;
  /// Of the checkpoint; empty when there is none.
  const std::string& home() const;
  /// That the checkpoint is not the one that was asked for, which is damaged; empty otherwise.
  const std::string& damage() const;
  /// What a checkpoint must hold beside the state, so that nothing else is needed to go on. The
  /// files are rank 0's.
  void save(CheckpointHeader& header, std::vector<KeptFile>& files) const;

 private:
  struct Content;
  explicit Case(std::shared_ptr<const Content> content);
  /// With the files from there and with exactly these changes.
  static std::shared_ptr<Content> read(const Environment& environment,
                                       const std::shared_ptr<InputFiles>& files,
                                       const std::string& deck, std::vector<DeckChange> changes,
                                       const CaseOptions& options);
  std::shared_ptr<const Content> content_;
};

/// Path of a case's mesh file; one that must be made is made at `place`, and `made` is what the
/// mesher says about it; one that is kept in a checkpoint is there as long as this is. Collective;
/// MeshError on all ranks.
struct ProvidedMesh {
  std::string file;
  std::string made;  ///< empty for a mesh that was there
  std::shared_ptr<ScratchFolder> scratch = {};
};
ProvidedMesh provide_mesh(const Case& run_case, const std::string& place);
/// The mesh of that file, as the deck wants it read, with the domains beside its regions.
/// Collective; MeshError on all ranks.
Mesh read_mesh(const Case& run_case, const std::string& file, std::vector<Domain> domains = {});

}  // namespace hawser
