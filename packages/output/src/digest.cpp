#include "src/digest.hpp"

#include <algorithm>
#include <cstring>

namespace hawser {
namespace {

std::uint64_t mixed(std::uint64_t x) {  // splitmix64: every bit of x moves every bit of the result
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}

}  // namespace

void Digest::add(std::uint64_t place, std::uint64_t word) { sum_ += mixed(mixed(place) ^ word); }

void Digest::add_bytes(std::uint64_t place, const char* bytes, std::size_t count) {
  for (std::size_t begin = 0; begin < count; begin += sizeof(std::uint64_t)) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes + begin, std::min(sizeof word, count - begin));
    add(place++, word);
  }
}

std::uint64_t Digest::total(const Communicator& communicator) const {
  std::uint64_t sum = sum_;
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_UINT64_T, MPI_SUM, communicator.mpi());
  return sum;
}

std::uint64_t digest_of(const std::string& text) {
  Digest digest;
  digest.add_bytes(1, text.data(), text.size());
  digest.add(0, text.size());
  return digest.value();
}

}  // namespace hawser
