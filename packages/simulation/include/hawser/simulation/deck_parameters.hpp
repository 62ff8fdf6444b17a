#pragma once
// Everything a deck can say outside of the modules, with one declaration per parameter.
#include <optional>
#include <string>
#include <vector>

#include "hawser/conditions/conditions_deck.hpp"
#include "hawser/deck/spec.hpp"
#include "hawser/fields/field_deck.hpp"
#include "hawser/mesh/mesh_deck.hpp"
#include "hawser/simulation/verification_deck.hpp"
#include "hawser/solve/solver_deck.hpp"
#include "hawser/time/time_deck.hpp"
#include "hawser/values/track.hpp"

namespace hawser {

/// A named value for use in the rest of the deck; read_deck() has evaluated it already.
struct ParameterDeck {
  std::string name, value, unit, meaning;
  static Spec<ParameterDeck> spec();
};

struct PluginDeck {
  Located<std::string> name;
  static Spec<PluginDeck> spec();
};

struct ModulesDeck {
  std::vector<DeckNode> modules;
  static Spec<ModulesDeck> spec();
};

/// Receivers along the towed cable, as a table over time.
struct ReceiversDeck {
  double spacing = 12.5, first = 0;  ///< m along the cable at rest
  std::vector<double> times;         ///< s
  int every = 0;                     ///< steps
  static Spec<ReceiversDeck> spec();
};

/// The towed cable's report: positioning errors and the tow force.
struct TowDeck {
  Located<std::string> cable, tow_point;
  double angle = 0;                           ///< degrees, of the tow axis from upstream
  double speed = 0;                           ///< m/s
  double current = 0;                         ///< m/s, along -y
  std::optional<Located<std::string>> track;  ///< instead of angle and speed
  std::optional<ReceiversDeck> receivers;
  static Spec<TowDeck> spec();
};

struct ForceDeck {
  std::string name;
  Located<std::string> on;
  Located<std::string> module{"all", {}};
  Located<std::vector<double>> axis;  ///< +x when empty
  static Spec<ForceDeck> spec();
};

struct ProbeDeck {
  std::string name;
  Located<std::string> on, field;
  static Spec<ProbeDeck> spec();
};

struct OutputDeck {
  int fields_every = 0, history_every = 1,
      checkpoint_every = 0;  ///< steps; 0: never, but fields at the end
  std::vector<ProbeDeck> probes;
  static Spec<OutputDeck> spec();
};

struct ExpectDeck {
  Located<std::string> quantity;
  double value = 0, within = 0;
  std::string why;
  static Spec<ExpectDeck> spec();
};

struct RunDeck {
  std::string title, extends;
  std::vector<ParameterDeck> parameters;
  MeshDeck mesh;
  std::vector<PluginDeck> plugins;
  ModulesDeck modules;
  std::vector<FieldDeck> fields;
  std::vector<TrackDeck> tracks;
  ConditionsDeck conditions;
  TimeDeck time;
  SolverDeck solver;
  OutputDeck output;
  std::optional<TowDeck> tow;
  std::vector<ForceDeck> forces;
  std::vector<ExpectDeck> expectations;
  std::vector<ErrorDeck> errors;
  std::optional<ConvergeDeck> converge;
  static Spec<RunDeck> spec();
};

}  // namespace hawser
