#include "hawser/report/expectations.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {

void check_expectations(const std::vector<ExpectDeck>& expectations,
                        const std::vector<std::string>& quantities, Diagnostics& diagnostics) {
  for (const ExpectDeck& expect : expectations) {
    const std::string& name = expect.quantity.value;
    if (std::find(quantities.begin(), quantities.end(), name) == quantities.end())
      diagnostics.error(expect.quantity.location,
                        "nothing here reports a quantity " + quoted(name) + "; there are " +
                            listed(quantities) + did_you_mean(name, quantities));
  }
}

std::vector<Judgement> judge(const std::vector<ExpectDeck>& expectations, const Summary& summary) {
  std::vector<Judgement> result;
  for (const ExpectDeck& expect : expectations) {
    const std::optional<double> got = summary.number(expect.quantity.value);
    result.push_back({expect, got, got && std::abs(*got - expect.value) <= expect.within});
  }
  return result;
}

void add_judgements(const std::vector<Judgement>& judgements, Summary& summary) {
  if (judgements.empty()) return;
  long long failed = 0;
  for (const auto& [expect, got, holds] : judgements) {
    if (!holds) ++failed;
    Summary& entry = summary.object("expectations").object(expect.quantity.value);
    entry.set("holds", holds);
    entry.set("expected", expect.value);
    entry.set("within", expect.within);
    if (got)
      entry.set("got", *got);
    else
      entry.set("got", "never evaluated: the run reports no such quantity");
    entry.set("why", expect.why);
    entry.set("where", expect.quantity.location.text());
  }
  summary.set("expectations_failed", failed);
}

}  // namespace hawser
