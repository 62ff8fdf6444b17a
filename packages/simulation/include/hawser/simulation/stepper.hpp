#pragma once
// Stable: part of the interface for programs that embed Hawser (doc/embedding.md).
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hawser/base/stopwatch.hpp"
#include "hawser/output/summary.hpp"
#include "hawser/simulation/case.hpp"
#include "hawser/solve/nonlinear_driver.hpp"

namespace hawser {

class ScratchFolder;
class StepControl;
class Stepper;
struct Step;
struct System;

/// One attempt at a step.
struct Attempt {
  bool accepted = false;
  std::string why{};                    ///< it was not
  double length = 0;                    ///< s
  double time = 0;                      ///< s, at which the stepper stands after it
  std::optional<double> local_error{};  ///< relative, of the time scheme; none in the first steps
  NonlinearReport newton{};             ///< empty where there is no solution
};

/// A solve on the way to the state at which a run begins.
struct StartSolve {
  std::string what{};        ///< "steady state"
  std::string why{};         ///< it found nothing; empty when it did
  NonlinearReport newton{};  ///< empty where there is no solution
};

/// What looks on while a stepper steps, such as results on disk or a log.
class Observer {
 public:
  virtual ~Observer() = default;
  /// After every solve of start(), on all ranks together.
  virtual void starting(Stepper& /*stepper*/, const StartSolve& /*solve*/) {}
  /// After every attempt, on all ranks together; an accepted one has been measured by the reports.
  virtual void attempted(Stepper& stepper, const Attempt& attempt) = 0;
};

/// A field at the nodes that this rank owns; over all ranks each node occurs once.
struct FieldValues {
  std::string unit{};
  int components = 1;
  int dimension = 2;
  std::vector<long long> ids{};     ///< rank-independent numbers of the nodes
  std::vector<double> positions{};  ///< [node][dimension], m, on the reference mesh
  std::vector<double> values{};     ///< [node][component]
};

/// A case being stepped through time. Everything is built at the start; nothing is written but what
/// save() is asked to. All members are collective unless said otherwise.
class Stepper {
 public:
  /// A mesh that must be made is made in a folder that is gone with the stepper. MeshError, or
  /// DeckError with every name that the mesh or the modules do not know.
  explicit Stepper(const Case& run_case);
  /// With a mesh that provide_mesh() gave.
  Stepper(const Case& run_case, ProvidedMesh mesh);
  ~Stepper();
  Stepper(const Stepper&) = delete;
  Stepper& operator=(const Stepper&) = delete;

  const Case& run_case() const { return case_; }
  /// What a user may not expect of the mesh, the deck or the start; on rank 0. Not collective.
  const std::vector<std::string>& notes() const;
  /// Finds the state at which the run begins, where the deck's <start> asks for more than initial
  /// values; advance() does it first when nobody did. SolveError when there is none.
  void start();
  bool finished() const;
  double time() const;  ///< s, of the last accepted state
  int steps() const;    ///< accepted, those before a restart included
  /// Tries one step, at most `longest` s; the next one is shorter when it was not accepted.
  /// SolveError when there is no shorter one; the last accepted state stays as it is.
  Attempt advance(double longest = std::numeric_limits<double>::infinity());

  /// `observer` must outlive the stepper, or be told of nothing more. Called in this order.
  void observe(Observer& observer) { observers_.push_back(&observer); }

  /// Of the last accepted state. DeckError when no module solves for it. Not collective.
  FieldValues field(const std::string& name) const;
  /// Figures of all reports in the last accepted step, by the names they have in summary.json; none
  /// before the first. Not collective.
  std::vector<std::pair<std::string, double>> quantities() const;
  std::optional<double> quantity(const std::string& name) const;
  /// What the reports say of the run so far; the title alone before the first step.
  Summary summary() const;

  /// The last accepted state, with all that Case::from_checkpoint needs. A file of that name goes
  /// to `previous`, unless that is empty. A restarted run begins without a Jacobian or factor; to
  /// be equal to it, this one goes on without them, too. OutputError.
  void save(const std::string& checkpoint, const std::string& previous = "");

  // Not stable: for what looks inside.
  /// The last accepted state in memory, to be saved when something has gone wrong after it.
  Checkpoint state() const;
  void save(Checkpoint state, const std::string& checkpoint, const std::string& previous) const;
  System& system() { return *system_; }
  const System& system() const { return *system_; }
  const Step& last() const { return *last_; }  ///< accepted
  double newton_seconds() const { return newton_watch_.seconds(); }

 private:
  void build();
  void check_sources() const;
  NonlinearReport solve(double length);
  void accept(const Attempt& attempt);
  void find_equilibrium();
  Attempt told(Attempt attempt);
  /// Tells of a rejected step and shortens the next; SolveError when it cannot be shorter.
  Attempt cut(Attempt attempt);

  Case case_;
  std::unique_ptr<ScratchFolder> scratch_;  // of a mesh made here
  ProvidedMesh mesh_;
  std::unique_ptr<System> system_;
  std::unique_ptr<StepControl> control_;
  std::unique_ptr<Step> last_;
  int number_ = 0;
  bool started_ = false;
  long long start_iterations_ = 0;  // of Newton's method, on the way to the start
  std::vector<Observer*> observers_;
  Stopwatch newton_watch_;
};

}  // namespace hawser
