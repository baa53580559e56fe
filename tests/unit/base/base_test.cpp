#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <set>
#include <unistd.h>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/content_hash.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "base/outcome.h"
#include "base/random.h"
#include "base/registry.h"

namespace gcslab {
namespace {

TEST(NearestName, DistanceCountsSwapsOnce) {
  EXPECT_EQ(edit_distance("natrual", "natural"), 1u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
}

TEST(NearestName, FarNamesAreNotProposed) {
  const std::vector<std::string> known = {"natural", "bernstein"};
  EXPECT_EQ(nearest_name("bernstien", known), "bernstein");
  EXPECT_EQ(nearest_name("xyz", known), std::nullopt);
  EXPECT_EQ(unknown_name_message("method", "xyz", known), "unknown method 'xyz' (known: natural, bernstein)");
}

TEST(Outcome, NamesRoundTrip) {
  for (const Status status :
       {Status::complete, Status::partial, Status::budget_exhausted, Status::not_applicable, Status::failed,
        Status::out_of_memory, Status::crashed}) {
    EXPECT_EQ(status_from_name(name_of(status)), status);
  }
  EXPECT_THROW(status_from_name("done"), InputError);
}

TEST(Random, StreamsDependOnSeedAndComponentOnly) {
  Random a(7, "x"), again(7, "x"), other_seed(8, "x"), other_component(7, "y");
  const std::uint64_t first = a.next();
  EXPECT_EQ(first, again.next());
  EXPECT_NE(first, other_seed.next());
  EXPECT_NE(first, other_component.next());
}

TEST(Random, FirstWordsAreTheSameOnEveryMachine) {
  Random random(1, "random_polynomial");
  EXPECT_EQ(random.integer(-1000000, 1000000), Random(1, "random_polynomial").integer(-1000000, 1000000));
  Random below(3, "below");
  std::set<std::uint64_t> seen;
  for (int i = 0; i < 200; ++i) seen.insert(below.below(5));
  EXPECT_EQ(seen, (std::set<std::uint64_t>{0, 1, 2, 3, 4}));
}

TEST(Random, UniformStaysInside) {
  Random random(2, "uniform");
  for (int i = 0; i < 10000; ++i) {
    const double value = random.uniform(-3, 5);
    EXPECT_TRUE(-3 <= value && value <= 5);
  }
}

TEST(ContentHash, DistinguishesTexts) {
  EXPECT_EQ(content_hash("abc"), content_hash("abc"));
  EXPECT_NE(content_hash("abc"), content_hash("abd"));
  EXPECT_EQ(content_hash("").size(), 32u);
}

TEST(ContentHasher, PartsHashAsTheirWhole) {
  ContentHasher hasher;
  EXPECT_EQ(hasher.hash(), content_hash(""));
  hasher.add("ab");
  hasher.add("c");
  EXPECT_EQ(hasher.hash(), content_hash("abc"));
  hasher.add("d");
  EXPECT_EQ(hasher.hash(), content_hash("abcd"));
}

TEST(AtomicFile, WritesWholeFilesAndLeavesNoDraft) {
  const auto folder = std::filesystem::temp_directory_path() / ("gcslab-base-" + std::to_string(::getpid()));
  make_folder(folder);
  write_file_atomically(folder / "a", "first");
  write_file_atomically(folder / "a", "second");
  EXPECT_EQ(read_file(folder / "a"), "second");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
  std::filesystem::remove_all(folder);
}

TEST(AtomicFile, FullDiskAndBadPlacesAreInputErrors) {
  EXPECT_THROW(write_file_atomically("/dev/full", "text"), InputError);
  EXPECT_THROW(write_file_atomically("/dev/null/x", "text"), InputError);
  EXPECT_THROW(make_folder("/dev/null/x"), InputError);
  EXPECT_THROW(read_file("/nonexistent/file"), InputError);
  EXPECT_THROW(read_file("/"), InputError);
}

struct Entry {
  std::string name;
};

TEST(Registry, NamesAreUniqueAndMisspellingsGetTheNearest) {
  const Registry<Entry> registry("bound", {{"natural"}, {"centred"}});
  EXPECT_EQ(registry.at("natural").name, "natural");
  EXPECT_EQ(registry.find("other"), nullptr);
  EXPECT_THROW(registry.at("centered"), InputError);
  EXPECT_THROW(Registry<Entry>("bound", {{"a"}, {"a"}}), InvariantError);
}

}  // namespace
}  // namespace gcslab
