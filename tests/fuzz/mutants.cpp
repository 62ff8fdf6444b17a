// Mutants of good inputs through a reader, with sanitizers: each is read or refused with its
// place, none crashes, none takes 10 s. Deterministic: mutant n is the same every time.
//
//   table_mutants COUNT [FIRST]
#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <csignal>

#include "fuzz.hpp"
#include "mutator.hpp"

namespace {

constexpr double longest_seconds = 10;
std::string current;  // what is being read, for who looks at a crash
unsigned number = 0;

void on_abort(int) {
  std::fprintf(stderr, "mutant %u:\n%s\n", number, current.c_str());
  std::_Exit(1);
}

/// The first byte is the reader's and stays.
const hawser::MutantParts parts = {{"nan",
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
                                    std::string(8, '\x7f'),
                                    "-999",
                                    "1e20",
                                    "direction_deg",
                                    "speed_kn",
                                    "_per_",
                                    "2024-05-01",
                                    "12:30",
                                    "'",
                                    "|",
                                    ",,"},
                                   [](const std::string& text, std::size_t from) {
                                     const char* const ends = " ,\n";
                                     const std::size_t begin = text.find_first_of(ends, from);
                                     if (begin == std::string::npos)
                                       return std::pair(text.size(), std::size_t{0});
                                     const std::size_t end =
                                         std::min(text.find_first_of(ends, begin + 1), text.size());
                                     return std::pair(begin + 1, end - begin - 1);
                                   },
                                   1};

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
    hawser::Mutator mutator(number, parts);
    current = mutator.mutated(good[mutator.below(good.size())]);
    const auto start = std::chrono::steady_clock::now();
    refused += answer_to(current) == Answer::refused ? 1 : 0;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    slowest = std::max(slowest, seconds.count());
    if (slowest > longest_seconds) broken("takes " + std::to_string(slowest) + " s");
  }
  if (2 * refused < count) broken("few mutants are refused: " + std::to_string(refused));
  std::printf(
      "%u of %u mutants read or refused with their place, %u refused; the slowest took %.2f s\n",
      count, count, refused, slowest);
  MPI_Finalize();
  return 0;
}
