#pragma once
// Everything a deck can say outside of the modules, with one declaration per parameter.
#include <optional>
#include <string>
#include <vector>

#include "hawser/conditions/conditions_deck.hpp"
#include "hawser/deck/spec.hpp"
#include "hawser/fields/field_deck.hpp"
#include "hawser/mesh/mesh_deck.hpp"
#include "hawser/report/output_deck.hpp"
#include "hawser/report/verification_deck.hpp"
#include "hawser/simulation/start_deck.hpp"
#include "hawser/solve/solver_deck.hpp"
#include "hawser/time/time_deck.hpp"
#include "hawser/values/table_deck.hpp"
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

struct RunDeck {
  std::string title, extends;
  std::vector<ParameterDeck> parameters;
  MeshDeck mesh;
  std::vector<PluginDeck> plugins;
  ModulesDeck modules;
  std::vector<FieldDeck> fields;
  std::vector<TrackDeck> tracks;
  std::vector<TableDeck> tables;
  ConditionsDeck conditions;
  StartDeck start;
  TimeDeck time;
  SolverDeck solver;
  OutputDeck output;
  std::vector<ExpectDeck> expectations;
  std::optional<ConvergeDeck> converge;
  std::vector<DeckNode> reports;
  static Spec<RunDeck> spec();
};

}  // namespace hawser
