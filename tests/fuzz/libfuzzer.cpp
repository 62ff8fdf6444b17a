// For libFuzzer of clang, with a reader: tests/fuzz/run compiles and runs it. The inputs to begin
// with are written into the folder HAWSER_SEEDS.
#include <mpi.h>

#include <fstream>

#include "fuzz.hpp"

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  MPI_Init(argc, argv);
  if (const char* const folder = std::getenv("HAWSER_SEEDS")) {
    int number = 0;
    for (const std::string& input : good_inputs())
      std::ofstream(folder + ("/good_" + std::to_string(number++)), std::ios::binary) << input;
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  answer_to({reinterpret_cast<const char*>(data), size});
  return 0;
}
