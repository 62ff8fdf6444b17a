#pragma once
// What an attribute's value must satisfy, with the words that messages and the reference manual
// use. Rules add up: required() && positive().
#include <functional>
#include <string>
#include <vector>

namespace hawser {

struct Rules {
  struct NumberCheck {
    std::string text;  ///< completes "must be …", such as "> 0"
    std::function<bool(double)> holds;
  };

  bool is_required = false;
  bool is_any = false;  ///< said outright: there is no bound
  std::string absent;   ///< what it means to leave the attribute out, when it has no default
  std::vector<NumberCheck> numbers;  ///< for every number of the value
  std::vector<std::string> words;    ///< when not empty, the words allowed
  int least_length = 1;              ///< of lists
  int greatest_length = 0;           ///< of lists; 0: no limit

  std::string range_text() const;  ///< "> 0, 2 values"; empty when anything goes
};

Rules operator&&(Rules a, const Rules& b);

Rules required();
Rules any();                               ///< there is no bound
Rules absent(const std::string& meaning);  ///< leaving it out means this; it has no default
Rules positive();
Rules non_negative();
Rules greater_than(double bound);
Rules less_than(double bound);
Rules at_least(double bound);
Rules at_most(double bound);
Rules between(double low, double high);        ///< both included
Rules one_of(std::vector<std::string> words);  ///< for texts and lists of names
Rules length(int count);                       ///< a list has that many values
Rules length(int least, int greatest);

}  // namespace hawser
