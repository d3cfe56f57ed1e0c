#include <fmt/format.h>

#include "read_parts.hpp"

namespace cleft::scene {

problem::GrowthLaw read_growth(const Section& s) {
  problem::GrowthLaw out;
  const bool rankine = s.choice("criterion", {"rankine", "hoop-stress"}) == "rankine";
  for (const auto& [key, belongs] : {std::pair{"strength", rankine}, {"radius", rankine}, {"toughness", !rankine}})
    if (s.has(key) && !belongs)
      s.fail(key, fmt::format("belongs to the other criterion; allowed with \"{}\": {}, advance, most, tips, "
                              "correct_direction, load_tolerance",
                              s.text("criterion"), rankine ? "strength, radius" : "toughness"));
  if (rankine)
    out.criterion = problem::Rankine{s.number("strength", kPositive, "a positive number, Pa"),
                                     s.number("radius", kPositive, "a positive number, m")};
  else
    out.criterion = problem::HoopStress{s.number("toughness", kPositive, "a positive number, Pa m^0.5")};
  out.advance = s.number("advance", kPositive, "a positive number, m");
  out.most = s.integer_or("most", out.most, 1, 1000000);
  if (s.has("tips")) {
    const auto tips = s.choice("tips", {"both", "start", "end"});
    out.tips = {tips != "end", tips != "start"};
  }
  out.correct_direction = s.flag_or("correct_direction", out.correct_direction);
  out.load_tolerance = s.number_or(
      "load_tolerance", out.load_tolerance, [](double x) { return x >= 1e-10 && x <= 1.0; }, "1e-10 to 1");
  return out;
}

}  // namespace cleft::scene
