#include "cleft/assembly/assembler.hpp"

#include <algorithm>
#include <cmath>

#include "cleft/support/timer.hpp"
#include "contact_points.hpp"
#include "f_bar_forces.hpp"

namespace cleft::assembly {
namespace {

// Faces on either side of a partner for which the pattern keeps room.
constexpr int kReservedNeighbours = 2;

void add_with_neighbours(const std::vector<enrichment::Face>& faces, Index face, int reach, std::vector<Index>& out) {
  out.push_back(face);
  Index f = face;
  for (int k = 0; k < reach && (f = faces[f].previous) != kNone; ++k) out.push_back(f);
  f = face;
  for (int k = 0; k < reach && (f = faces[f].next) != kNone; ++k) out.push_back(f);
}

// Pairs of unknowns whose block of the matrix is not zero, with repetitions.
struct Couplings {
  std::vector<std::array<Index, 2>> blocks;

  void add(const auto& unknowns) {
    for (const Index i : unknowns)
      for (const Index j : unknowns) blocks.push_back({i, j});
  }

  void add_each(const auto& parts) {
    for (const auto& part : parts) add(part.unknown);
  }
};

// Points of one triangle follow each other and have the same unknowns.
void couple_tip_points(const std::vector<enrichment::TipPoint>& points, Couplings& couplings) {
  for (std::size_t p = 0; p < points.size(); ++p)
    if (p == 0 || points[p].unknown != points[p - 1].unknown) couplings.add(points[p].unknown);
}

std::array<Index, 2> multipliers_of(const contact::Surfaces& surfaces, const contact::MultiplierInterval& interval) {
  return {surfaces.first_multiplier + interval.first, surfaces.first_multiplier + interval.second};
}

void couple_multipliers(const contact::Surfaces& surfaces, Couplings& couplings) {
  for (const auto& interval : surfaces.multiplier_space.intervals) couplings.add(multipliers_of(surfaces, interval));
}

void add_unknowns(const contact::Surfaces& surfaces, Index face, std::vector<Index>& out) {
  const auto& own = surfaces.faces[face].start.unknown;
  out.insert(out.end(), own.begin(), own.end());
  const auto& space = surfaces.multiplier_space;
  if (space.empty()) return;
  for (Index k = space.first_part[face]; k < space.first_part[face + 1]; ++k) {
    const auto multipliers = multipliers_of(surfaces, space.intervals[space.interval_parts[k].interval]);
    out.insert(out.end(), multipliers.begin(), multipliers.end());
  }
}

// Ascending: displacements and multipliers of a face and of those that it may touch.
std::vector<Index> unknowns_near(const contact::Surfaces& surfaces, Index face, const std::vector<Index>& others) {
  std::vector<Index> out;
  add_unknowns(surfaces, face, out);
  for (const Index other : others) add_unknowns(surfaces, other, out);
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

// Where the matrix holds the blocks of each part's unknowns.
void find_places(const BlockMatrix& matrix, const auto& parts, auto& places) {
  places.resize(parts.size());
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const auto& unknown = parts[p].unknown;
    for (std::size_t l = 0; l < unknown.size(); ++l)
      for (std::size_t k = 0; k < unknown.size(); ++k) {
        const auto at = matrix.find(unknown[k], unknown[l]);
        places[p].start[k][l] = at.start;
        places[p].stride[l] = at.stride;
      }
  }
}

// m^2 of the reference configuration
double area_of(const enrichment::Cell& cell) { return cell.area; }
double area_of(const enrichment::TipPoint& point) { return point.weight; }

}  // namespace

AssemblySeconds& AssemblySeconds::operator+=(const AssemblySeconds& other) {
  bulk += other.bulk;
  contact += other.contact;
  pattern += other.pattern;
  assemblies += other.assemblies;
  return *this;
}

Assembler::Assembler(const Model& model)
    : model_(model), patches_(patches_of(model)), reserved_(model.surfaces.faces.size()) {
  if (model.has_contact()) {
    History rest{contact::contact_at_rest(model.surfaces)};
    if (!model.surfaces.multiplier_space.empty()) rest.multipliers = contact::multipliers_at_rest(model.surfaces);
    find_contact(VecX::Zero(model.unknowns.components()), rest, contact::Conditions::OwnState);
    reserve_couplings(rest);
  }
  build_pattern();
}

void Assembler::reserve(ReservedCouplings reserved) {
  reserved_ = std::move(reserved);
  build_pattern();
}

void Assembler::build_pattern() {
  const PhaseTimer timer(seconds_.pattern);
  Couplings couplings;
  couplings.blocks.reserve(9 * model_.cells.size());
  couplings.add_each(model_.cells);
  couplings.add_each(patches_);
  couple_tip_points(model_.tip_points, couplings);
  couplings.add_each(model_.ties);
  couple_multipliers(model_.surfaces, couplings);
  for (std::size_t f = 0; f < reserved_.size(); ++f)
    if (!reserved_[f].empty()) couplings.add(unknowns_near(model_.surfaces, static_cast<Index>(f), reserved_[f]));
  matrix_ = BlockMatrix(model_.unknowns.count, couplings.blocks);
  find_places(matrix_, model_.cells, places_);
  find_places(matrix_, patches_, patch_places_);
  find_places(matrix_, model_.tip_points, tip_places_);
  opposite_.assign(model_.surfaces.multiplier_space.interval_parts.size(), {});
  ++version_;
}

void Assembler::reserve_couplings(const History& history) {
  const auto& past = history.contact;
  for (auto& faces : reserved_) faces.clear();
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    auto& faces = reserved_[model_.surfaces.points[p].face];
    if (pairs_[p].partner_face != kNone)
      add_with_neighbours(model_.surfaces.faces, pairs_[p].partner_face, kReservedNeighbours, faces);
    if (pairs_[p].mouth_face != kNone) faces.push_back(pairs_[p].mouth_face);
    if (past[p].anchor_face != kNone) faces.push_back(past[p].anchor_face);
  }
  for (const auto& mortar_segment : multipliers_.mortar_segments())
    add_with_neighbours(model_.surfaces.faces, mortar_segment.partner, kReservedNeighbours,
                        reserved_[model_.surfaces.multiplier_space.interval_parts[mortar_segment.interval_part].face]);
  for (const auto& anchor_map : history.multipliers.anchor_maps)
    reserved_[anchor_map.face].push_back(anchor_map.anchor_face);
  for (auto& faces : reserved_) {
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  }
}

bool Assembler::has_couplings(const History& history) const {
  const auto& past = history.contact;
  for (const auto& mortar_segment : multipliers_.mortar_segments()) {
    const auto& faces = reserved_[model_.surfaces.multiplier_space.interval_parts[mortar_segment.interval_part].face];
    const auto holds = [&](Index f) { return std::binary_search(faces.begin(), faces.end(), f); };
    if (!holds(mortar_segment.partner)) return false;
    if (mortar_segment.anchor_map != kNone &&
        !holds(history.multipliers.anchor_maps[mortar_segment.anchor_map].anchor_face))
      return false;
  }
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    const auto& pair = pairs_[p];
    if (!contact::presses(pair) || is_mortar(model_.surfaces, p)) continue;
    const auto& faces = reserved_[model_.surfaces.points[p].face];
    const auto holds = [&](Index f) { return f == kNone || std::binary_search(faces.begin(), faces.end(), f); };
    if (!holds(pair.partner_face) || !holds(pair.mouth_face)) return false;
    if (pulls_anchor(model_.surfaces, pair) && !holds(past[p].anchor_face)) return false;
  }
  return true;
}

std::optional<Failure> Assembler::assemble(const VecX& displacement, const History& history,
                                           contact::Conditions conditions) {
  ++seconds_.assemblies;
  if (model_.has_contact()) {
    {
      const PhaseTimer timer(seconds_.contact);
      find_contact(displacement, history, conditions);
    }
    if (!has_couplings(history)) {
      reserve_couplings(history);
      build_pattern();
    }
  }
  force_.setZero(model_.unknowns.components());
  contact_force_.setZero(model_.has_contact() ? model_.unknowns.components() : 0);
  if (!matrix_is_final_) matrix_.set_zero();
  if (auto failure = assemble_bulk(displacement, history)) return failure;
  add_ties(displacement);
  matrix_is_final_ = model_.is_linear();
  if (model_.has_contact()) {
    assemble_contact(history.contact);
    if (!model_.surfaces.multiplier_space.empty()) assemble_multipliers(history.multipliers);
    force_ += contact_force_;
  }
  for (Eigen::Index c = 0; c < force_.size(); ++c)
    if (!std::isfinite(force_[c]))
      return Failure{FailureKind::NotFinite, ForceNotFinite{position_of(model_, static_cast<Index>(c))}};
  return std::nullopt;
}

template <class Law>
constitutive::Response Assembler::respond(const Law& law, const Mat2& deformation, const History& history,
                                          std::size_t number) {
  if constexpr (constitutive::PathDependent<Law>)
    return law.respond(deformation, history.plastic[number], plastic_[number], history.duration);
  else
    return law.respond(deformation);
}

// theory (1.3), (1.4). False where the point is turned inside out.
template <class Law, class Point, std::size_t unknowns>
bool Assembler::add_point(const Law& law, const VecX& displacement, const History& history, std::size_t number,
                          const Point& point, const Places<unknowns>& places) {
  const Mat2 F = deformation_for<Law>(point, displacement);
  if (!constitutive::kIsSmallStrain<Law> && !(det(F) > 0.0)) return false;
  const constitutive::Response r = respond(law, F, history, number);
  const auto& g = point.gradient;
  const double weight = area_of(point);
  for (std::size_t l = 0; l < unknowns; ++l) {
    force_.segment<2>(2 * point.unknown[l]).noalias() += weight * (r.piola * g[l]);
    if (matrix_is_final_) continue;
    // D g_l: columns k of dP/dF contracted with the gradient of the column's unknown
    const Eigen::Matrix<double, 4, 2> d =
        weight * (g[l](0) * r.tangent.leftCols<2>() + g[l](1) * r.tangent.rightCols<2>());
    for (std::size_t k = 0; k < unknowns; ++k)
      matrix_.add({places.start[k][l], places.stride[l]}, g[k](0) * d.topRows<2>() + g[k](1) * d.bottomRows<2>());
  }
  return true;
}

// Laws without memory share what of their pressure depends on the volume.
template <class Law>
constitutive::PatchResponse Assembler::respond(const Law& law, const DeformedPatch& deformed, const Patch& patch,
                                               const History& history) {
  constitutive::PatchResponse out;
  if constexpr (constitutive::PathDependent<Law>) {
    out = law.respond(deformed.strained, past_of(deformed.share, patch.cell, history.plastic, history.duration));
    for (int i = 0; i < 2; ++i) plastic_[patch.cell[i]] = out.updated[i];
  } else {
    for (int i = 0; i < 2; ++i) {
      const constitutive::Response own = law.respond(deformed.strained[i]);
      out.piola[i] = own.piola;
      out.tangent[i] = own.tangent;
      out.by_pressure[i] = out.pressure_rate[i] = Mat2::Zero();
    }
  }
  return out;
}

// The cell that is turned inside out, or kNone.
template <class Law>
Index Assembler::add_patch(const Law& law, const VecX& displacement, const History& history, std::size_t number) {
  const Patch& patch = patches_[number];
  const DeformedPatch at = deformed(model_, patch.cell, displacement);
  for (int i = 0; i < 2; ++i)
    if (!(at.J[i] > 0.0)) return patch.cell[i];
  const PatchForces forces =
      patch_forces(model_, patch, at, respond(law, at, patch, history), constitutive::kIsSmallStrain<Law>);
  for (int k = 0; k < 4; ++k) {
    force_.segment<2>(2 * patch.unknown[k]) += forces.force.segment<2>(2 * k);
    if (matrix_is_final_) continue;
    for (int l = 0; l < 4; ++l)
      matrix_.add({patch_places_[number].start[k][l], patch_places_[number].stride[l]},
                  forces.matrix.block<2, 2>(2 * k, 2 * l));
  }
  return kNone;
}

// The material point that is turned inside out, or kNone.
template <class Law>
Index Assembler::bulk_loop(const Law& law, const PointRange& range, const VecX& displacement, const History& history) {
  const std::size_t cells = model_.cells.size();
  const bool patches = !patches_.empty();
  std::size_t c = range.first;
  const auto first_cell = [](const Patch& patch) { return static_cast<std::size_t>(patch.cell[0]); };
  auto patch = std::ranges::lower_bound(patches_, c, {}, first_cell);
  for (; c < std::min(range.last, cells); ++c) {
    if (patches && model_.f_bar_partner[c] != kNone) {
      if (patch == patches_.end() || first_cell(*patch) != c) continue;  // with its first cell
      const auto number = static_cast<std::size_t>(patch++ - patches_.begin());
      if (const Index bad = add_patch(law, displacement, history, number); bad != kNone) return bad;
      continue;
    }
    if (!add_point(law, displacement, history, c, model_.cells[c], places_[c])) return static_cast<Index>(c);
  }
  for (; c < range.last; ++c) {
    const auto& point = model_.tip_points[c - cells];
    if (!add_point(law, displacement, history, c, point, tip_places_[c - cells])) return static_cast<Index>(c);
  }
  return kNone;
}

std::optional<Failure> Assembler::assemble_bulk(const VecX& displacement, const History& history) {
  const PhaseTimer timer(seconds_.bulk);
  if (model_.has_memory()) plastic_.resize(model_.material_points());
  Index bad = kNone;
  for_each_run(model_, [&](const auto& law, const PointRange& range) {
    if (bad == kNone) bad = bulk_loop(law, range, displacement, history);
  });
  if (bad == kNone) return std::nullopt;
  return Failure{FailureKind::Inverted, InvertedPoint{material_point(model_, bad)}};
}

// theory (3.1)
void Assembler::add_ties(const VecX& displacement) {
  const PhaseTimer timer(seconds_.bulk);
  for (const auto& tie : model_.ties) {
    const double stiffness = tie_stiffness(model_, tie);
    const Vec2 jump = tie.jump(displacement);
    for (std::size_t k = 0; k < tie.unknown.size(); ++k) {
      force_.segment<2>(2 * tie.unknown[k]) += stiffness * tie.slope[k] * jump;
      if (matrix_is_final_) continue;
      for (std::size_t l = 0; l < tie.unknown.size(); ++l)
        matrix_.add(matrix_.find(tie.unknown[k], tie.unknown[l]),
                    stiffness * tie.slope[k] * tie.slope[l] * Mat2::Identity());
    }
  }
}

}  // namespace cleft::assembly
