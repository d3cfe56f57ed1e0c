#include "element_tangent.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace cleft::tangent_check {
namespace {

using Kind = BodyPiece::Kind;

// Steps of the differences over the first ones. The last two are for pieces with a kink of their law close by.
constexpr std::array<double, 5> kFactors{1.0, 1.0 / 16, 16.0, 1.0 / 256, 1.0 / 4096};
constexpr std::size_t kOrdinaryFactors = 3;

// Collects the pieces and numbers their unknowns.
class Separation {
 public:
  explicit Separation(double reach) : reach_(reach) {}

  // `slope`: per unknown, how fast the strain grows with it, 1/m; `stiffness`: modulus times area, N.
  void add(Kind kind, std::vector<Index> points, std::vector<Index> unknowns, const std::vector<double>& slope,
           double stiffness) {
    BodyPiece piece{kind, std::move(points), std::move(unknowns), {}, {}, next_};
    for (const double by : slope) {
      piece.step.push_back(first_step(by > 0.0 ? 1.0 / by : 1.0, reach_));
      piece.least.push_back(kFaint * stiffness * by * std::ranges::max(slope));
    }
    next_ += static_cast<Index>(piece.unknowns.size());
    pieces_.push_back(std::move(piece));
  }

  // The unknowns and gradients of one or two cells, or of a point of branch functions.
  template <class Point>
  void add(Kind kind, const std::vector<Index>& numbers, const std::vector<const Point*>& points, double stiffness) {
    std::vector<Index> unknowns;
    std::vector<double> slope;
    for (const Point* point : points)
      for (std::size_t k = 0; k < point->unknown.size(); ++k) {
        const auto at = static_cast<std::size_t>(std::ranges::find(unknowns, point->unknown[k]) - unknowns.begin());
        if (at == unknowns.size()) {
          unknowns.push_back(point->unknown[k]);
          slope.push_back(0.0);
        }
        slope[at] = std::max(slope[at], point->gradient[k].norm());
      }
    add(kind, numbers, std::move(unknowns), slope, stiffness);
  }

  std::vector<BodyPiece> pieces() { return std::move(pieces_); }

 private:
  double reach_;
  Index next_ = 0;
  std::vector<BodyPiece> pieces_;
};

std::vector<BodyPiece> pieces_of(const assembly::Model& model, double reach) {
  Separation out(reach);
  const auto modulus = [&](Index point) { return constitutive::uniaxial_strain_modulus(model.constants(point)); };
  const auto cells = static_cast<Index>(model.cells.size());
  for (Index c = 0; c < cells; ++c) {
    const Index partner = model.f_bar_partner.empty() ? kNone : model.f_bar_partner[c];
    const auto* cell = &model.cells[c];
    if (partner == kNone)
      out.add<enrichment::Cell>(Kind::Bulk, {c}, {cell}, modulus(c) * cell->area);
    else if (c < partner)
      out.add<enrichment::Cell>(Kind::Patch, {c, partner}, {cell, &model.cells[partner]}, modulus(c) * cell->area);
  }
  for (Index p = 0; p < static_cast<Index>(model.tip_points.size()); ++p)
    out.add<enrichment::TipPoint>(Kind::Tip, {cells + p}, {&model.tip_points[p]},
                                  modulus(cells + p) * model.tip_points[p].weight);
  for (const auto& tie : model.ties) {
    std::vector<double> slope;
    for (const double s : tie.slope) slope.push_back(std::fabs(s));
    out.add(Kind::Tie, {tie.cell}, {tie.unknown.begin(), tie.unknown.end()}, slope,
            assembly::tie_stiffness(model, tie));
  }
  return out.pieces();
}

// Of a piece's unknowns in the separated body.
void renumber(const BodyPiece& piece, auto& unknowns) {
  for (Index& unknown : unknowns)
    unknown = piece.first + static_cast<Index>(std::ranges::find(piece.unknowns, unknown) - piece.unknowns.begin());
}

}  // namespace

std::string block_of(BodyPiece::Kind kind, const std::vector<FlowBranch>& branches) {
  if (kind == Kind::Tie) return "ghost tie";
  const char* what = kind == Kind::Bulk ? "bulk" : kind == Kind::Patch ? "patch" : "tip";
  const bool mixed = std::ranges::any_of(branches, [&](FlowBranch b) { return b != branches.front(); });
  return fmt::format("{} {}", what, mixed ? "mixed" : cleft::name_of(branches.front()));
}

assembly::Model ElementTangents::separated(const assembly::Model& model, const std::vector<BodyPiece>& pieces) {
  assembly::Model out;
  out.mesh = model.mesh;  // for messages
  out.materials = model.materials;
  out.material_of = model.material_of;
  out.cells = model.cells;
  out.f_bar_partner = model.f_bar_partner;
  out.tip_points = model.tip_points;
  out.ties = model.ties;
  auto tie = out.ties.begin();
  for (const auto& piece : pieces) {
    out.unknowns.count += static_cast<Index>(piece.unknowns.size());
    if (piece.kind == Kind::Tie)
      renumber(piece, (tie++)->unknown);
    else if (piece.kind == Kind::Tip)
      renumber(piece, out.tip_points[piece.points[0] - static_cast<Index>(out.cells.size())].unknown);
    else
      for (const Index c : piece.points) renumber(piece, out.cells[c].unknown);
  }
  out.unknowns.nodes = out.unknowns.count;
  return out;
}

ElementTangents::ElementTangents(const assembly::Model& model, const assembly::History& history, const VecX& u,
                                 double reach)
    : whole_(model),
      pieces_(pieces_of(model, reach)),
      separated_(separated(model, pieces_)),
      history_{.contact = {}, .plastic = history.plastic, .duration = history.duration},
      u_(separated_.unknowns.components()),
      assembler_(separated_) {
  for (const BodyPiece& piece : pieces_)
    for (std::size_t k = 0; k < piece.unknowns.size(); ++k)
      u_.segment<2>(2 * (piece.first + static_cast<Index>(k))) = u.segment<2>(2 * piece.unknowns[k]);
  branch_ = flow_branches(separated_, history_, u_);
}

std::string ElementTangents::block_name(const BodyPiece& piece) const {
  std::vector<FlowBranch> branches;
  for (const Index p : piece.points) branches.push_back(branch_.empty() ? FlowBranch::Elastic : branch_[p]);
  std::string out = block_of(piece.kind, branches);
  for (const Index p : piece.points)
    if (const auto side = assembly::material_point(whole_, p).side)
      return out + (*side == geometry::Side::Left ? " left" : " right");
  return out;
}

double ElementTangents::entry(const BodyPiece& piece, int row, int column) const {
  return matrix_.entry(2 * piece.first + row, 2 * piece.first + column);
}

double ElementTangents::scale(const BodyPiece& piece, int row) const {
  double out = piece.least[row / 2];
  for (int column = 0; column < piece.components(); ++column) out = std::max(out, std::fabs(entry(piece, row, column)));
  return out;
}

std::optional<ElementTangents::Forces> ElementTangents::forces(int column, double factor) {
  Forces out;
  for (std::size_t k = 0; k < kOffsets.size(); ++k) {
    VecX there = u_;
    for (const BodyPiece& piece : pieces_)
      if (column < piece.components()) there[2 * piece.first + column] += kOffsets[k] * factor * piece.step[column / 2];
    if (assembler_.assemble(there, history_)) return std::nullopt;
    out.force[k] = assembler_.internal_force();
    out.branch[k] = flow_branches(separated_, history_, there);
  }
  return out;
}

void ElementTangents::improve(const BodyPiece& piece, int column, double factor, const Forces& at,
                              Differences& out) const {
  if (!branch_.empty() && piece.kind != Kind::Tie)
    for (std::size_t p = 0; p < piece.points.size(); ++p)
      for (const auto& branch : at.branch)
        if (branch[piece.points[p]] != branch_[piece.points[p]]) {
          out.other = branch[piece.points[p]];
          out.other_point = p;
          return;
        }
  const int n = piece.components();
  for (int row = 0; row < n; ++row) {
    const Index r = 2 * piece.first + row;
    const auto& f = at.force;
    const auto q = quotient({f[0][r], f[1][r], f[2][r], f[3][r]}, factor * piece.step[column / 2]);
    if (auto& best = out.of[column * n + row]; q.uncertainty < best.uncertainty) best = q;
  }
}

void ElementTangents::difference(double factor) {
  const int columns = pieces_.empty() ? 0 : std::ranges::max(pieces_, {}, &BodyPiece::components).components();
  for (int column = 0; column < columns; ++column) {
    const auto at = forces(column, factor);
    if (!at) continue;
    for (std::size_t p = 0; p < pieces_.size(); ++p)
      if (column < pieces_[p].components() && !differences_[p].certain)
        improve(pieces_[p], column, factor, *at, differences_[p]);
  }
}

bool ElementTangents::all_certain(double tolerance) {
  bool out = true;
  for (std::size_t p = 0; p < pieces_.size(); ++p) {
    const BodyPiece& piece = pieces_[p];
    bool& certain = differences_[p].certain;
    if (certain) continue;
    const int n = piece.components();
    certain = true;
    for (int row = 0; row < n && certain; ++row) {
      const double largest = scale(piece, row);
      for (int column = 0; column < n && certain; ++column)
        certain = is_certain(differences_[p].of[column * n + row], largest, tolerance);
    }
    out &= certain;
  }
  return out;
}

bool ElementTangents::any_kinked() const {
  return std::ranges::any_of(differences_, [](const Differences& d) { return d.other && !d.certain; });
}

void ElementTangents::sum_up(std::size_t number, double load, double tolerance, TangentReport& report) const {
  const BodyPiece& piece = pieces_[number];
  const Differences& differences = differences_[number];
  auto& block = report.blocks[block_name(piece)];
  ++block.pieces;
  const int n = piece.components();
  bool certain = true;
  for (int row = 0; row < n; ++row) {
    const double largest = scale(piece, row);
    for (int column = 0; column < n; ++column)
      certain &= count(block,
                       {load, 2 * piece.unknowns[row / 2] + row % 2, 2 * piece.unknowns[column / 2] + column % 2,
                        entry(piece, row, column), 0, 0, largest, piece.points[0], kNone},
                       differences.of[column * n + row], tolerance);
  }
  if (certain) return;
  const Index point = piece.points[differences.other_point];
  report.kinks.push_back({differences.other ? fmt::format("between {} and {}", cleft::name_of(branch_[point]),
                                                          cleft::name_of(*differences.other))
                                            : std::string(kUnclear),
                          load, point, kNone});
}

std::optional<assembly::Failure> ElementTangents::check(double load, double tolerance, TangentReport& report) {
  if (auto failure = assembler_.assemble(u_, history_)) return failure;
  matrix_ = assembler_.matrix();
  differences_.clear();
  for (const BodyPiece& piece : pieces_)
    differences_.push_back({std::vector<Quotient>(piece.components() * piece.components())});
  for (std::size_t k = 0; k < kFactors.size(); ++k) {
    difference(kFactors[k]);
    if (all_certain(tolerance) || (k + 1 >= kOrdinaryFactors && !any_kinked())) break;
  }
  for (std::size_t p = 0; p < pieces_.size(); ++p) sum_up(p, load, tolerance, report);
  return std::nullopt;
}

}  // namespace cleft::tangent_check
