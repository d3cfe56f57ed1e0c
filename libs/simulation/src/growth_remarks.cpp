#include "growth_remarks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cleft::simulation {
namespace {

using Lines = std::vector<std::string>;

constexpr double kZigzag = 30.0;  // degrees

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

std::string name_of_tip(const std::string& crack, int end) {
  return fmt::format("crack '{}', {}", crack, end == 0 ? "start" : "end");
}

// The largest angle (degrees) by which a path turns and turns back in the next point; of its last `pieces` pieces.
double to_and_fro(const std::vector<Vec2>& path, std::size_t pieces) {
  double largest = 0.0, last = 0.0;
  const std::size_t first = path.size() > pieces + 1 ? path.size() - pieces - 1 : 1;
  for (std::size_t k = first; k + 1 < path.size(); ++k) {
    const Vec2 before = path[k] - path[k - 1], after = path[k + 1] - path[k];
    const double turn = degrees(std::atan2(cross(before, after), before.dot(after)));
    if (turn * last < 0.0) largest = std::max(largest, std::min(std::fabs(turn), std::fabs(last)));
    last = turn;
  }
  return largest;
}

void about_growing_tip(const std::string& tip, const growth::Record::Tip& record, std::vector<Vec2> path, Lines& out) {
  if (record.stop == growth::Stop::Hindered)
    out.push_back(fmt::format("{}: hindered after {} advances; growth.csv says where", tip, record.advances));
  const double turn = to_and_fro(path, static_cast<std::size_t>(record.advances));
  if (turn > kZigzag)
    out.push_back(fmt::format(
        "{}: its path turns to and fro by {:.0f} degrees, as advances that are too long do; shorter ones, or "
        "growth.correct_direction = true",
        tip, turn));
}

}  // namespace

long advances_of(const growth::Record& record) {
  long out = 0;
  for (const auto& tips : record.tips) out += tips[0].advances + tips[1].advances;
  return out;
}

std::string remark_on(const growth::Advance& a, const assembly::Model& model, double load) {
  const std::string tip = name_of_tip(model.cracks[a.tip.crack].name, a.tip.end);
  if (a.length == 0.0) return fmt::format("{}: no advance at load {:.6g}: {}", tip, load, a.hindrance);
  std::string out = fmt::format("{}: advance {} at load {:.6g} to {}, turned by {:.1f} degrees", tip, a.number, load,
                                model.words_for(a.point), degrees(a.turn));
  if (a.stop == growth::Stop::Boundary) out += "; it cuts through the boundary";
  if (a.stop == growth::Stop::Hindered) out += "; no farther: " + a.hindrance;
  return out;
}

std::vector<std::string> remarks_on_growth(const problem::Specification& specification, const growth::Record& record) {
  Lines out;
  bool may = false, did = false;
  for (std::size_t k = 0; k < specification.cracks.size() && k < record.tips.size(); ++k) {
    if (!specification.cracks[k].growth) continue;
    may = true;
    std::vector<Vec2> path = record.points[k];
    for (const int end : {1, 0}) {
      const auto& tip = record.tips[k][end];
      did = did || tip.advances > 0;
      about_growing_tip(name_of_tip(specification.cracks[k].name, end), tip, path, out);
      std::ranges::reverse(path);
    }
  }
  if (may && !did)
    out.push_back(fmt::format(
        "no tip advanced; the largest demand at the end is {:.3g}, and 1 is what the criteria ask for", record.ratio));
  return out;
}

}  // namespace cleft::simulation
