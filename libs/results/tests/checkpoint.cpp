#include "cleft/results/checkpoint.hpp"

#include <gtest/gtest.h>

namespace cleft::results {
namespace {

Checkpoint example() {
  Checkpoint c;
  c.scene = R"({"mesh":{"kind":"structured"}})";
  c.state.load = 0.3;
  c.state.displacement = VecX::LinSpaced(10, 0.0, 1.0 / 3.0);
  c.state.previous_displacement = -c.state.displacement;
  c.state.history.contact = {{3, 0.25, {1e-3}, -7.0}, {kNone, 0.0, {0.0}, 0.0}};
  c.state.history.plastic = {{{1e-3, -2e-3, 3e-4, 1e-4}, 0.02}, {}};
  c.state.prescribed_force = VecX::Ones(4);
  c.state.energies.elastic = 5.0;
  c.place.number = 7;
  c.place.step = 0.01;
  c.place.arc_increment = 1.5;
  c.place.furthest = 0.6;
  c.place.longest = 0.25;
  c.place.wandered = 11;
  c.place.plateau = {0.5, 2.0, 1.0};
  c.state.progress = VecX::LinSpaced(10, 1.0, 2.0);
  c.counts.jumps = {2, 0.4};
  c.reserved = {{1, 2, 3}, {}, {4}};
  c.counts.iterations = 21;
  c.log_bytes = {{"history.csv", 1234}, {"newton.csv", 99}};
  c.outputs = {{0.25, 0, "fields_0000.vtu"}};
  return c;
}

TEST(Checkpoint, ComesBackBitForBit) {
  const Checkpoint c = example();
  const Checkpoint back = checkpoint_from(to_bytes(c), "checkpoint");
  EXPECT_EQ(to_bytes(back), to_bytes(c));
  EXPECT_EQ(back.state.displacement, c.state.displacement);
  EXPECT_EQ(back.state.history.contact[0].anchor_face, 3);
  ASSERT_EQ(back.state.history.plastic.size(), 2u);
  EXPECT_EQ(back.state.history.plastic[0].deformation, c.state.history.plastic[0].deformation);
  EXPECT_EQ(back.state.history.plastic[0].accumulated, 0.02);
  EXPECT_EQ(back.state.progress, c.state.progress);
  EXPECT_EQ(back.place.arc_increment, 1.5);
  EXPECT_EQ(back.place.furthest, 0.6);
  EXPECT_EQ(back.place.longest, 0.25);
  EXPECT_EQ(back.place.wandered, 11);
  EXPECT_EQ(back.place.plateau.load, 0.5);
  EXPECT_EQ(back.place.plateau.extent, 2.0);
  EXPECT_EQ(back.place.plateau.travelled, 1.0);
  EXPECT_EQ(back.counts.jumps.increments, 2);
  EXPECT_EQ(back.counts.jumps.load, 0.4);
  EXPECT_EQ(back.counts.iterations, 21);
  EXPECT_EQ(back.counts.increments, 7) << "as many as the place has";
  EXPECT_EQ(back.reserved, c.reserved);
  EXPECT_EQ(back.log_bytes, c.log_bytes);
  EXPECT_EQ(back.outputs[0].file, "fields_0000.vtu");
}

TEST(Checkpoint, DamagedOnesAreRefusedByName) {
  const std::string bytes = to_bytes(example());
  const auto refused = [](const std::string& b) {
    try {
      checkpoint_from(b, "folder/checkpoint");
      return false;
    } catch (const std::runtime_error& error) {
      return std::string(error.what()).starts_with("folder/checkpoint: ");
    }
  };
  for (std::size_t n = 0; n < bytes.size(); ++n) EXPECT_TRUE(refused(bytes.substr(0, n))) << "cut to " << n;
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    std::string altered = bytes;
    altered[n] = static_cast<char>(altered[n] ^ 0x40);
    EXPECT_TRUE(refused(altered)) << "byte " << n;
  }
}

}  // namespace
}  // namespace cleft::results
