#pragma once
// Checksums of 64 bits for what a disk may spoil; no defence against what a person means to do.
#include <cstdint>
#include <string>

#include "hawser/base/communicator.hpp"

namespace hawser {

/// A sum over words that each know their place, so that it does not matter who adds which, or when.
class Digest {
 public:
  void add(std::uint64_t place, std::uint64_t word);
  /// Bytes, of which the first one stands at 8 `place`; and how many they are.
  void add_bytes(std::uint64_t place, const char* bytes, std::size_t count);

  std::uint64_t value() const { return sum_; }
  /// Over all ranks. Collective.
  std::uint64_t total(const Communicator& communicator) const;

 private:
  std::uint64_t sum_ = 0;
};

std::uint64_t digest_of(const std::string& text);

}  // namespace hawser
