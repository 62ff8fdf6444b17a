#include "hawser/output/checkpoint.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "hawser/base/error.hpp"
#include "sample.hpp"

namespace hawser {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr GlobalIndex count = 23;

double value(GlobalIndex id, int component) {
  return 1.0 / (3.0 + static_cast<double>(id)) + 100.0 * component;
}

void write_sample(const Communicator& all, const std::string& path,
                  const std::vector<KeptFile>& files = {}, const std::string& previous = "") {
  CheckpointHeader header;
  header.step = 12;
  header.time = 120.5;
  header.numbers = {{"time_step", 0.1}, {"least", std::numeric_limits<double>::min()}};
  header.texts = {{"deck", std::string(100000, 'x')}, {"note", ""}};
  NamedArray displacement{"displacement", 2, count, {}, {}};
  NamedArray pressure{"pressure", 1, count, {}, {}};
  for (GlobalIndex id = count - 1; id >= 0; --id) {
    if (!sample::is_mine(all, id)) continue;
    displacement.ids.push_back(id);
    displacement.values.insert(displacement.values.end(), {value(id, 0), value(id, 1)});
    pressure.ids.push_back(id);
    pressure.values.push_back(value(id, 2));
  }
  write_checkpoint(all, path, {header, {displacement, pressure}}, files, previous);
}

// Overwrites the first place where the file holds the given value.
void damage(const std::string& path, double held) {
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(file)), {});
  const std::string bytes(reinterpret_cast<const char*>(&held), sizeof held);
  const auto at = text.find(bytes);
  ASSERT_NE(at, std::string::npos);
  file.seekp(static_cast<std::streamoff>(at));
  file.put('\x55');
}

TEST(Checkpoint, GivesBackEveryBitInAnyDistribution) {
  const Communicator all;
  write_sample(all, "state.h5");
  const CheckpointReader reader(all, "state.h5");
  EXPECT_EQ(reader.header().step, 12);
  EXPECT_EQ(reader.header().time, 120.5);
  EXPECT_EQ(reader.header().numbers.at("time_step"), 0.1);
  EXPECT_EQ(reader.header().numbers.at("least"), std::numeric_limits<double>::min());
  EXPECT_EQ(reader.header().texts.at("deck"), std::string(100000, 'x'));
  EXPECT_EQ(reader.header().texts.at("note"), "");
  EXPECT_TRUE(reader.has("pressure"));
  EXPECT_FALSE(reader.has("velocity"));
  EXPECT_EQ(reader.global_count("pressure"), count);

  // Overlapping, unordered, with a repetition; nothing at all on the last of several ranks.
  std::vector<GlobalIndex> ids = {7, 3, 22, 3, all.rank()};
  if (all.size() > 1 && all.rank() == all.size() - 1) ids.clear();
  const auto values = reader.read("displacement", ids, 2);
  ASSERT_EQ(values.size(), 2 * ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    EXPECT_EQ(values[2 * i], value(ids[i], 0));
    EXPECT_EQ(values[2 * i + 1], value(ids[i], 1));
  }
}

TEST(Checkpoint, RefusesWhatItCannotTrust) {
  const Communicator all;
  const auto reading = [&](const std::string& path) {
    return [&all, path] { CheckpointReader(all, path); };
  };
  EXPECT_THAT(reading("none.h5"), ThrowsMessage<OutputError>(HasSubstr("No such file")));

  EXPECT_THAT(reading("."), ThrowsMessage<OutputError>(HasSubstr("such as ./checkpoint.h5")));
  EXPECT_THAT(reading("/dev/zero"),
              ThrowsMessage<OutputError>("/dev/zero is not a checkpoint: it is no file"));

  all.on_root([] { std::ofstream("deck.xml") << "<deck>some text</deck>"; });
  EXPECT_THAT(reading("deck.xml"),
              ThrowsMessage<OutputError>(HasSubstr("deck.xml is not a checkpoint")));

  write_sample(all, "cut.h5");
  all.on_root([] { std::filesystem::resize_file("cut.h5", 3000); });
  EXPECT_THAT(reading("cut.h5"), ThrowsMessage<OutputError>(HasSubstr("cut.h5 is damaged")));

  write_sample(all, "damaged.h5");
  all.on_root([] { damage("damaged.h5", value(5, 1)); });
  EXPECT_THAT(reading("damaged.h5"),
              ThrowsMessage<OutputError>("damaged.h5 is damaged: it is not what was written"));
}

TEST(Checkpoint, ThatHasAnyByteChangedIsRefused) {
  const Communicator all;
  write_sample(all, "whole.h5");
  std::string whole;
  {
    std::ifstream file("whole.h5", std::ios::binary);
    whole.assign(std::istreambuf_iterator<char>(file), {});
  }
  const std::size_t stride = whole.size() / 97;  // no divisor of what is laid out in it
  for (std::size_t at = 0; at < whole.size(); at += at < 200 ? 1 : stride) {
    all.on_root([&] {
      std::string changed = whole;
      changed[at] = static_cast<char>(changed[at] ^ 1);
      std::ofstream("changed.h5", std::ios::binary) << changed;
    });
    EXPECT_THROW(CheckpointReader(all, "changed.h5"), OutputError) << "byte " << at;
  }
}

TEST(Checkpoint, HoldsFilesOfAnyBytes) {
  const Communicator all;
  const std::string bytes("\0binary\0\xff\n\0", 11);
  std::vector<KeptFile> files;
  if (all.is_root())
    files = {{"../tables/track.csv", "/home/tables/track.csv", bytes}, {"empty", "", ""}};
  write_sample(all, "files.h5", files);
  const std::vector<KeptFile> found = CheckpointReader(all, "files.h5").files();
  ASSERT_EQ(found.size(), all.is_root() ? 2u : 0u);
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].name, files[i].name);
    EXPECT_EQ(found[i].path, files[i].path);
    EXPECT_EQ(found[i].text, files[i].text);
  }
}

TEST(Checkpoint, TheOneBeforeIsKeptAndUsedWhenTheLastIsDamaged) {
  const Communicator all;
  const std::string before = previous_checkpoint("last.h5");
  EXPECT_EQ(before, "last.previous.h5");
  all.on_root([&] {
    std::filesystem::remove("last.h5");
    std::filesystem::remove(before);
  });
  write_sample(all, "last.h5", {}, before);
  EXPECT_THROW(CheckpointReader(all, before), OutputError) << "there was none";
  write_sample(all, "last.h5", {}, before);
  EXPECT_EQ(CheckpointReader(all, before).header().step, 12);
  EXPECT_EQ(open_checkpoint(all, "last.h5").damage, "");

  all.on_root([] { damage("last.h5", value(5, 1)); });
  const OpenedCheckpoint opened = open_checkpoint(all, "last.h5");
  EXPECT_EQ(opened.reader->path(), before);
  EXPECT_EQ(opened.damage, "last.h5 is damaged: it is not what was written");
  all.on_root([] { std::filesystem::remove("last.h5"); });
  EXPECT_THAT(open_checkpoint(all, "last.h5").damage, HasSubstr("No such file"));
  all.on_root([&] { damage(before, value(5, 1)); });
  EXPECT_THAT([&] { open_checkpoint(all, "last.h5"); },
              ThrowsMessage<OutputError>(testing::AllOf(HasSubstr("No such file"),
                                                        HasSubstr("last.previous.h5 is damaged"))));
}

TEST(Checkpoint, NamesWhatIsMissing) {
  const Communicator all;
  write_sample(all, "asked.h5");
  const CheckpointReader reader(all, "asked.h5");
  EXPECT_THAT([&] { reader.read("velocity", {0}, 2); },
              ThrowsMessage<OutputError>("asked.h5 has no array 'velocity'"));
  EXPECT_THROW(reader.read("pressure", {0}, 2), OutputError);
  EXPECT_THROW(reader.read("pressure", {count}, 1), OutputError);
}

TEST(Checkpoint, LeavesTheOldOneWhenItFails) {
  const Communicator all;
  // A path below a regular file: not writable by root either.
  all.on_root([] { std::ofstream("a_file") << "text"; });
  EXPECT_THAT([&] { write_sample(all, "a_file/state.h5"); },
              ThrowsMessage<OutputError>(
                  testing::AllOf(HasSubstr("a_file/state.h5"), HasSubstr("Not a directory"))));
}

}  // namespace
}  // namespace hawser
