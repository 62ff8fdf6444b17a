#pragma once
// The composition root: everything is built from the deck here, and nothing else sees the whole.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hawser/base/communicator.hpp"
#include "hawser/deck/read_deck.hpp"
#include "hawser/output/summary.hpp"
#include "hawser/report/verification_deck.hpp"
#include "hawser/simulation/registries.hpp"

namespace hawser {

enum class LogDetail {
  quiet,      ///< what went wrong only
  steps,      ///< a line per step
  iterations  ///< and one per Newton iteration and output
};

struct RunOptions {
  std::string output;  ///< result folder
  std::string plugin_folder;
  std::vector<DeckChange> changes;  ///< of the deck; a restarted run has them in its checkpoint
  bool force = false;               ///< write over the results of another run
  LogDetail detail = LogDetail::steps;
  bool log_json = false;      ///< one JSON object per line instead of text
  std::optional<double> end;  ///< s, instead of the deck's end
  bool expects = true;        ///< judge by the deck's expectations
};

class Simulation {
 public:
  /// Reads and checks the deck; nothing is written yet. Collective; DeckError or PluginError on all
  /// ranks.
  Simulation(const Communicator& communicator, Registries registries, const std::string& deck_file,
             const RunOptions& options);
  /// Continues from a checkpoint with the deck that is kept in it.
  static Simulation restart(const Communicator& communicator, Registries registries,
                            const std::string& checkpoint, const RunOptions& options);
  ~Simulation();
  Simulation(Simulation&&) noexcept;

  /// Makes or reads the mesh, builds the system, steps to the end. Returns what summary.json says.
  /// Collective; any Error on all ranks.
  Summary run();

  /// What a run would need: unknowns, memory, mesh quality, Courant number. Makes the mesh in a
  /// folder of its own, which it removes. Collective.
  std::string preview();
  /// Makes the deck's mesh, unless it is a file already, and says what it is like. Collective.
  std::string make_mesh(const std::string& file);
  bool has_mesh_file() const;  ///< the deck names one

  std::string resolved_deck() const;  ///< XML with every default

 private:
  struct Implementation;
  explicit Simulation(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace hawser
