// Mutants of good inputs through a reader, with sanitizers: each is read or refused with its
// place, none crashes, none takes 10 s. Deterministic: mutant n is the same every time.
//
//   table_mutants COUNT [FIRST]
#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <random>

#include "fuzz.hpp"

namespace {

constexpr double longest_seconds = 10;
std::string current;  // what is being read, for who looks at a crash
unsigned number = 0;

void on_abort(int) {
  std::fprintf(stderr, "mutant %u:\n%s\n", number, current.c_str());
  std::_Exit(1);
}

class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}
  std::size_t below(std::size_t bound) { return bound == 0 ? 0 : random_() % bound; }

  /// The first byte is the reader's and stays.
  std::string mutated(std::string text) {
    for (std::size_t i = 0, count = 1 + below(3); i < count; ++i)
      mutate(text);
    return text;
  }

 private:
  void mutate(std::string& text) {
    static const std::vector<std::string> odd = {"nan",
                                                 "inf",
                                                 "1e400",
                                                 "-1e-400",
                                                 "1e200",
                                                 "99999999999999",
                                                 "4294967296",
                                                 "-1",
                                                 "0",
                                                 "0x10",
                                                 "\"",
                                                 ";",
                                                 ",",
                                                 "\t",
                                                 "\n",
                                                 "\n\n",
                                                 "\r\n",
                                                 "#",
                                                 "$End",
                                                 "$Nodes",
                                                 "e",
                                                 ".",
                                                 "-",
                                                 "+",
                                                 "[m/s]",
                                                 "time",
                                                 "_kn",
                                                 "_m",
                                                 "4.1",
                                                 "2.2",
                                                 "\xEF\xBB\xBF",
                                                 "\xff",
                                                 "2 1 0 1\n",
                                                 "9223372036854775807",
                                                 std::string(4, '\0'),
                                                 std::string(8, '\x7f')};
    const std::size_t at = 1 + below(text.size());
    switch (below(9)) {
      case 0: text.erase(std::min(at, text.size()), below(8)); break;
      case 1: text.insert(at, odd[below(odd.size())]); break;
      case 2:
        if (at < text.size()) text[at] = static_cast<char>(random_() & 0xFFU);
        break;
      case 3: text.insert(at, text.substr(1 + below(text.size()), below(200))); break;
      case 4: text.erase(std::min(at, text.size()), below(300)); break;
      case 5: replace_word(text, odd[below(odd.size())]); break;
      case 6: replace_word(text, word(text)); break;
      case 7:
        if (at + 1 < text.size()) std::swap(text[at], text[at + 1]);
        break;
      default: text.insert(at, std::string(below(5000), odd[below(odd.size())][0])); break;
    }
  }

  /// Begin and length of one somewhere.
  std::pair<std::size_t, std::size_t> place(const std::string& text) {
    const char* const ends = " ,\n";
    const std::size_t begin = text.find_first_of(ends, 1 + below(text.size()));
    if (begin == std::string::npos) return {text.size(), 0};
    const std::size_t end = std::min(text.find_first_of(ends, begin + 1), text.size());
    return {begin + 1, end - begin - 1};
  }
  std::string word(const std::string& text) {
    const auto [begin, length] = place(text);
    return text.substr(begin, length);
  }
  void replace_word(std::string& text, const std::string& by) {
    const auto [begin, length] = place(text);
    text.replace(begin, length, by);
  }

  std::mt19937 random_;
};

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  if (argc < 2) return 2;
  std::signal(SIGABRT, on_abort);
  const auto count = static_cast<unsigned>(std::atoi(argv[1]));
  const auto first = static_cast<unsigned>(argc > 2 ? std::atoi(argv[2]) : 0);
  std::vector<std::string> good;  // those that are read: others would mostly stay refused
  for (const std::string& input : good_inputs()) {
    current = input;
    if (answer_to(input) == Answer::read) good.push_back(input);
  }
  if (good.empty()) broken("no input is read");
  unsigned refused = 0;
  double slowest = 0;
  for (number = first; number < first + count; ++number) {
    Mutator mutator(number);
    current = mutator.mutated(good[mutator.below(good.size())]);
    const auto start = std::chrono::steady_clock::now();
    refused += answer_to(current) == Answer::refused ? 1 : 0;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    slowest = std::max(slowest, seconds.count());
    if (slowest > longest_seconds) broken("takes " + std::to_string(slowest) + " s");
  }
  std::printf(
      "%u of %u mutants read or refused with their place, %u refused; the slowest took %.2f s\n",
      count, count, refused, slowest);
  MPI_Finalize();
  return 0;
}
