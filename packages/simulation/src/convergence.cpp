#include "hawser/simulation/convergence.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "hawser/base/error.hpp"
#include "hawser/output/result_folder.hpp"
#include "hawser/report/observed_order.hpp"
#include "hawser/simulation/deck_language.hpp"
#include "hawser/simulation/run_deck.hpp"
#include "src/refinement.hpp"

namespace hawser {
namespace {

const char* word(Refinement refinement) {
  if (refinement == Refinement::both) return "both";
  return refinement == Refinement::space ? "space" : "time";
}

struct Quantity {
  std::string name;
  const OrderDeck* order = nullptr;  ///< null when nothing is expected of it
  std::vector<double> errors{};      ///< coarse to fine
};

class OrderStudy {
 public:
  OrderStudy(const Environment& environment, std::string deck_file,
             const ConvergenceOptions& options)
      : environment_(environment),
        communicator_(environment.communicator()),
        deck_file_(std::move(deck_file)),
        options_(options) {
    Diagnostics diagnostics;
    const Deck text = read_deck(communicator_, deck_file_, options.changes,
                                deck_language(environment.registries), diagnostics);
    deck_ = RunDeck::spec().read(text.root, diagnostics);
    diagnostics.throw_if_any();
    if (deck_.converge) converge_ = *deck_.converge;
    // What the deck expects holds for its own way of refining.
    if (options.refine && deck_.converge && *options.refine != converge_.refine)
      converge_.orders.clear();
    converge_.refine = options.refine.value_or(converge_.refine);
    converge_.levels = options.levels.value_or(converge_.levels);
    choose_quantities(text);
  }

  Summary run() {
    const ResultFolder folder(
        communicator_, options_.run.output,
        options_.run.force ? ExistingResults::replace : ExistingResults::keep);
    print(fmt::format("{}\nrefined in {}, {} levels", deck_.title, word(converge_.refine),
                      converge_.levels));
    std::string csv = "level,factor,nodes,steps,steps_rejected";
    for (const Quantity& quantity : quantities_)
      csv += "," + quantity.name;
    for (int level = 0; level < converge_.levels; ++level)
      csv += "\n" + run_level(level, folder);
    folder.write("converge.csv", csv + "\n");
    Summary result = judge();
    result.write(communicator_, folder.file("converge.json"));
    print("results: " + folder.path());
    return result;
  }

 private:
  void choose_quantities(const Deck& text) {
    for (const std::string& name : error_quantities(deck_.reports))
      quantities_.push_back({name});
    for (const OrderDeck& order : converge_.orders) {
      Quantity* found = nullptr;
      for (Quantity& quantity : quantities_)
        if (quantity.name == order.quantity.value) found = &quantity;
      if (found == nullptr) found = &quantities_.emplace_back(Quantity{order.quantity.value});
      found->order = &order;
    }
    if (quantities_.empty())
      throw DeckError(text.root.location.text() +
                      ": no error is there that could converge; <error> compares a field with an "
                      "exact solution, <order> in <converge> names a reported quantity");
  }

  /// Returns the level's line of the CSV file.
  std::string run_level(int level, const ResultFolder& folder) {
    RunOptions run = options_.run;
    run.output = folder.file(fmt::format("level-{}", level));
    run.detail = LogDetail::quiet;
    CaseOptions finer{options_.changes, {}, false};  // expectations are about the deck as it stands
    for (DeckChange& change : refinement(deck_, converge_.refine, level))
      finer.changes.push_back(std::move(change));
    const Summary summary = hawser::run(Case::from_file(environment_, deck_file_, finer), run);
    const auto number = [&](const char* key) { return summary.number(key).value_or(0); };
    rejected_ = rejected_ || number("steps_rejected") > 0;
    std::string line = fmt::format("{},{},{},{},{}", level, std::ldexp(1.0, -level),
                                   number("nodes"), number("steps"), number("steps_rejected"));
    std::string shown = fmt::format("level {}: {:.0f} nodes, {:.0f} steps, {:.1f} s", level,
                                    number("nodes"), number("steps"), number("wall_s"));
    for (Quantity& quantity : quantities_) {
      const std::optional<double> error = summary.number(quantity.name);
      if (!error)
        throw DeckError((quantity.order ? quantity.order->quantity.location.text() : deck_file_) +
                        ": the run reports no quantity '" + quantity.name + "'");
      quantity.errors.push_back(*error);
      line += fmt::format(",{:.17g}", *error);
      shown += fmt::format("  {} {:.3e}", quantity.name, *error);
    }
    print(shown);
    return line;
  }

  Summary judge() const {
    Summary result;
    result.set("title", deck_.title);
    result.set("refine", word(converge_.refine));
    result.set("levels", converge_.levels);
    result.set("ranks", communicator_.size());
    result.set("steps_were_rejected", rejected_);
    long long failed = 0;
    print(
        fmt::format("\n{:<24} {:>12} {:>18} {:>12}", "order", "finest pair", "fitted", "at least"));
    for (const Quantity& quantity : quantities_) {
      const ObservedOrder order = observed_order(quantity.errors);
      // A step that was cut has not the length that the level stands for.
      const bool holds = quantity.order == nullptr ||
                         (order.pairs.back() >= quantity.order->at_least && !rejected_);
      failed += holds ? 0 : 1;
      Summary& entry = result.object("quantities").object(quantity.name);
      entry.set("errors", quantity.errors);
      entry.set("orders", order.pairs);
      entry.set("finest_pair", order.pairs.back());
      entry.set("fitted", order.fitted);
      if (order.standard_error) entry.set("fitted_standard_error", *order.standard_error);
      if (quantity.order != nullptr) {
        entry.set("at_least", quantity.order->at_least);
        entry.set("holds", holds);
        entry.set("why", quantity.order->why);
        entry.set("where", quantity.order->quantity.location.text());
      }
      print(fmt::format("{:<24} {:>12.3f} {:>9.3f} +- {:.3f} {:>12} {}", quantity.name,
                        order.pairs.back(), order.fitted,
                        order.standard_error.value_or(std::nan("")),
                        quantity.order ? fmt::format("{:g}", quantity.order->at_least) : "-",
                        quantity.order == nullptr ? "" : (holds ? "holds" : "FAILS")));
    }
    if (rejected_) print("steps were rejected and cut: the orders in time mean nothing");
    result.set("orders_failed", failed);
    return result;
  }

  void print(const std::string& line) const {
    if (!communicator_.is_root() || options_.run.detail == LogDetail::quiet) return;
    std::fputs((line + "\n").c_str(), stdout);
    std::fflush(stdout);
  }

  const Environment& environment_;
  const Communicator& communicator_;
  std::string deck_file_;
  const ConvergenceOptions& options_;
  RunDeck deck_;
  ConvergeDeck converge_;
  std::vector<Quantity> quantities_;
  bool rejected_ = false;
};

}  // namespace

Summary converge(const Environment& environment, const std::string& deck_file,
                 const ConvergenceOptions& options) {
  return OrderStudy(environment, deck_file, options).run();
}

}  // namespace hawser
