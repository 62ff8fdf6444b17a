#pragma once
// Initial and prescribed values, resolved to rows.
#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "hawser/assembly/constraints.hpp"
#include "hawser/conditions/conditions_deck.hpp"

namespace hawser {

/// When a run is, s.
struct RunSpan {
  double begin = 0, end = 0, first_step = 0;
  bool steady = false;       ///< its solves have no velocity: nothing jumps
  bool finds_start = false;  ///< by <start>, not by the initial values alone
  bool shortened = false;    ///< the end is not the deck's
};

class Conditions {
 public:
  /// Faults (unknown field, region, component, a bad table) go to `diagnostics`; the same on all
  /// ranks. Collective.
  Conditions(const Assembler& assembler, const std::vector<RateRule>& rate_rules,
             const ConditionsDeck& deck, const NamedSources& named, Diagnostics& diagnostics);

  /// What a run from `start` to `end` (s) would find out too late: a table that does not reach as
  /// far in time, or over the places where its nodes are at the start; a table that would move a
  /// point in the first step to where it begins, unless `jump_is_meant`. Collective (DeckError).
  void check_sources(const State& start, double first_step, double end, bool jump_is_meant) const;

  /// Values at the start and, where a value depends on time, its rate.
  void set_initial(State& state) const;

  /// The prescribed rows of a step whose equations stand at `state` and which ends with `end`: the
  /// values at its end, but for fields without a rate at the equations' instant. A structure's
  /// prescribed displacement prescribes its velocity too: the displacement's derivative in time.
  /// Collective (SolveError).
  std::vector<PrescribedRow> prescribed(const State& state, const State& end) const;

  /// True when some value depends on the moved position: prescribed() then changes within a step.
  bool follow_the_mesh() const { return follow_the_mesh_; }

  /// What does not fit together, before the first step from `start`: prescriptions that disagree at
  /// a node, that never hold, that begin far from the initial values. Collective.
  void look_ahead(const State& start, const RunSpan& span, Diagnostics& diagnostics) const;

  /// The velocity, per component, m/s, that displacements and velocities prescribe a vertex to have
  /// at a time; moved positions stand as in `state`. Nothing where a component is free, or on ranks
  /// that do not know the vertex. Not collective.
  std::optional<std::vector<double>> prescribed_velocity(LocalIndex vertex, double time,
                                                         const State& state) const;

  /// Edges of the windows of time, s.
  std::vector<double> events() const;

 private:
  struct Entry {
    std::vector<LocalIndex> first_rows;  // local, owned and ghost
    bool is_displacement = false;
    bool has_rate = true;
    int first_component = 0;
    std::shared_ptr<const ValueSource> source;
    Location location;
    std::string field, on;  // for messages
    bool replaces = false;
    bool is_table = false;
    Location place;  // of the source in the deck
    double from = -std::numeric_limits<double>::infinity();
    double until = std::numeric_limits<double>::infinity();
  };
  struct Disagreement;
  std::vector<Disagreement> disagreements(const State& start, const RunSpan& span) const;
  void find_jumps(const State& start, const RunSpan& span, Diagnostics& diagnostics) const;
  Entry resolve(const ConditionDeck& deck, const NamedSources& named,
                Diagnostics& diagnostics) const;
  void set_initial(const Entry& entry, State& state) const;
  void prescribe(const Entry& entry, const State& state, const State& end,
                 std::vector<PrescribedRow>& result) const;
  SpaceTime point(LocalIndex row, const State& state) const;
  /// A DeckError of the source gets the place where the deck asks for it.
  static void at_its_place(const Entry& entry, const std::function<void()>& work);
  /// [first, last] s, in which a run needs the values; none when first > last.
  static Span needed_times(const Entry& entry, const State& start, double first_step, double end);
  /// Of all ranks' nodes, along x, y, z. On all ranks.
  std::array<Span, 3> needed_places(const Entry& entry, const State& start) const;
  /// m, of a displacement, on this rank: from where the nodes are to where they are prescribed to
  /// be at `first`, and on to where they are to be at `next`.
  struct Moves {
    double jump = 0, way = 0;
  };
  Moves moves(const Entry& entry, const State& start, double first, double next) const;
  void check_source(const Entry& entry, const State& start, double first_step, double end,
                    bool jump_is_meant) const;

  const Assembler& assembler_;
  const DofMap& dofs_;
  MovedPosition moved_;
  std::vector<RateRule> rate_rules_;  // per field
  std::vector<LocalIndex>
      velocity_of_;  // per local row: a structure displacement's velocity row, or -1
  std::vector<Entry> initial_, prescribed_;
  bool follow_the_mesh_ = false;
};

}  // namespace hawser
