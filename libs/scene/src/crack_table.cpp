#include <fmt/format.h>

#include "tables.hpp"

namespace cleft::scene {
namespace {

using problem::CrackSpec;
using problem::GrowthLaw;
using problem::HoopStress;
using problem::Rankine;
using Sine = CrackSpec::Sine;

const std::vector<std::string_view> kCriteria{"rankine", "hoop-stress"};  // as the alternatives of GrowthCriterion

const auto kTips =
    std::vector<Named<std::array<bool, 2>>>{{{true, true}, "both"}, {{true, false}, "start"}, {{false, true}, "end"}};

const std::vector<Named<bool>> kMethods{{false, "penalty"}, {true, "mortar"}};  // Mortar::on

const Table<GrowthLaw>& growth_table() {
  using Row = Row<GrowthLaw>;
  constexpr Allowed kTolerance{[](double x) { return x >= 1e-10 && x <= 1.0; }, "1e-10 to 1"};
  const auto rankine = [](double Rankine::*member) { return within<Rankine>(&GrowthLaw::criterion, member); };
  const auto toughness = within<HoopStress>(&GrowthLaw::criterion, &HoopStress::toughness);
  static const Table<GrowthLaw> table{
      {Row::alternative("criterion", &GrowthLaw::criterion, kCriteria, "").needed(),
       Row::number("strength", rankine(&Rankine::strength), kPositive.in("Pa"), "largest principal stress around a tip")
           .needed()
           .of({"rankine"}),
       Row::number("radius", rankine(&Rankine::radius), kPositive.in("m"),
                   "around a tip, where stress and deformation are averaged")
           .needed()
           .of({"rankine"}),
       Row::number("toughness", toughness, kPositive.in("Pa m^0.5"), "critical stress intensity factor")
           .needed()
           .of({"hoop-stress"}),
       Row::number("advance", &GrowthLaw::advance, kPositive.in("m"), "length of one advance").needed(),
       Row::integer("most", &GrowthLaw::max_advances, {1, 1000000}, "advances of each tip"),
       Row::choice("tips", &GrowthLaw::tips, kTips, "which ends grow"),
       Row::value("correct_direction", &GrowthLaw::correct_direction,
                  "try an advance, then make it in the mean direction"),
       Row::number("load_tolerance", &GrowthLaw::load_tolerance, kTolerance, "of the load at which a tip advances")},
      {"criterion", [](const GrowthLaw& law) { return std::string(kCriteria[law.criterion.index()]); }}};
  return table;
}

void default_method(const Section& s, CrackSpec& crack) {
  crack.mortar.on = !s.has("normal_penalty") && !s.has("tangential_penalty");
}

void default_hat_width(const Section&, CrackSpec& crack) {
  crack.mortar.hat_width = crack.mortar.smoothing > 0.0 ? 1.0 : 2.0;
}

const Table<CrackSpec>& contact_table() {
  using Row = Row<CrackSpec>;
  constexpr Allowed kSizes{kPositive.holds, "a positive number of element sizes"};
  const auto on = [](auto& crack) -> auto& { return crack.mortar.on; };
  const auto smoothing = [](auto& crack) -> auto& { return crack.mortar.smoothing; };
  const auto hat_width = [](auto& crack) -> auto& { return crack.mortar.hat_width; };
  static const Table<CrackSpec> table{
      {Row::choice("method", on, kMethods, "")
           .otherwise("mortar, or penalty where one is given")
           .filled(default_method),
       Row::number("smoothing", smoothing, kNotNegative, "of the tractions; 0: exact constraints").of({"mortar"}),
       Row::number("hat_width", hat_width, kSizes, "element sizes")
           .otherwise("1, without smoothing 2")
           .filled(default_hat_width)
           .of({"mortar"}),
       Row::number("normal_penalty", &CrackSpec::normal_penalty, kPositive.in("Pa/m"), "of the gap")
           .otherwise("E/h")
           .of({"penalty"}),
       Row::number("tangential_penalty", &CrackSpec::tangential_penalty, kPositive.in("Pa/m"), "of the slip")
           .otherwise("E/h")
           .of({"penalty"})},
      {"method", [](const CrackSpec& crack) { return std::string(crack.mortar.on ? "mortar" : "penalty"); }}};
  return table;
}

void check_points(const Section& s, const std::vector<Vec2>& points) {
  if (points.size() < 2) s.fail("points", "a crack needs at least two points");
  for (std::size_t k = 1; k < points.size(); ++k)
    if (points[k] == points[k - 1])
      s.fail("points", fmt::format("point {} repeats the one before; allowed: distinct points", k));
}

void check_name(const Section& s, const std::string& name) {
  const bool usable = !name.empty() && std::ranges::all_of(name, [](unsigned char c) {
    return std::isalnum(c) || c == '_' || c == '-';
  });
  if (!usable) s.fail("name", "not usable in a file name; allowed: letters, digits, _ and -");
}

void finish(const Section& s, CrackSpec& crack) {
  if (s.has("name")) check_name(s, crack.name);
  if (crack.sine && crack.sine->start == crack.sine->end)
    s.fail("end", "the curve has no length; allowed: an end apart from the start");
  if (!crack.sine) {
    s.require("points");
    check_points(s, crack.points);
  }
  // mortar contact treats both faces alike for a few hundredths of the time; springs are the paper's
  if (crack.mortar.on && !s.has("negative_side")) crack.negative_side = contact::NegativeSide::Both;
  if (crack.growth) crack.growth_at = s.section("growth")->at();
}

}  // namespace

const Table<CrackSpec>& crack_table() {
  using Row = Row<CrackSpec>;
  const auto sine = [](auto member) { return within<Sine>(&CrackSpec::sine, member); };
  const auto read_curve = [](const Section& s, CrackSpec& crack) {
    s.choice("curve", {"sine"});
    if (s.has("points")) s.fail("points", "a crack is either a polyline or a curve; allowed: points or curve");
    crack.sine = Sine{.start = Vec2::Zero(), .end = Vec2::Zero()};
  };
  const auto write_curve = [](const CrackSpec& crack, Json& j) {
    if (crack.sine) j["curve"]["kind"] = "sine";
  };
  static const Table<CrackSpec> table{
      {Row::value("name", &CrackSpec::name, "names its result file").otherwise("crack1, crack2, ..."),
       Row::choice("negative_side", &CrackSpec::negative_side, "side whose face carries the contact quadrature")
           .otherwise("both by mortar, right by penalty"),
       Row::number("friction", within<contact::Coulomb>(&CrackSpec::law, &contact::Coulomb::friction), kNotNegative,
                   "Coulomb's coefficient")
           .written_if([](const CrackSpec& crack) { return std::holds_alternative<contact::Coulomb>(crack.law); }),
       Row::value("points", &CrackSpec::points, "polyline in the reference configuration, m")
           .written_if([](const CrackSpec& crack) { return !crack.sine; }),
       Row::custom("curve", "text", "in place of points: sine", read_curve, write_curve),
       Row::value("start", sine(&Sine::start), "first point of the curve, m").needed().of({"sine"}).inside("curve"),
       Row::value("end", sine(&Sine::end), "last point of the curve, m").needed().of({"sine"}).inside("curve"),
       Row::number("amplitude", sine(&Sine::amplitude), kAny.in("m"), "first wave to the left")
           .needed()
           .of({"sine"})
           .inside("curve"),
       Row::number("periods", sine(&Sine::periods), kPositive, "waves").of({"sine"}).inside("curve"),
       Row::value("intensities", &CrackSpec::intensities, "stress intensity factors of its tips, in history.csv")
           .written_if([](const CrackSpec& crack) { return crack.intensities; }),
       Row::section("contact", kItself, contact_table(), "method and penalties"),
       Row::section("growth", &CrackSpec::growth, growth_table(),
                    "when and how far its tips advance; without it, never")},
      {"curve", [](const CrackSpec& crack) { return std::string(crack.sine ? "sine" : ""); }},
      finish};
  return table;
}

}  // namespace cleft::scene
