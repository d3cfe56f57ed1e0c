#include "cleft/simulation/failure_words.hpp"

#include <fmt/format.h>

namespace cleft::simulation {
namespace {

using assembly::CrackEnd, assembly::Failure, assembly::FailureKind, assembly::FarCorrection, assembly::ForceNotFinite,
    assembly::GrownTip, assembly::HeldPart, assembly::InvertedPoint, assembly::LastArc, assembly::LastIncrement,
    assembly::LoadTooLow, assembly::LostPart, assembly::Model, assembly::NoCorrection, assembly::NoDemand,
    assembly::PassedPoint, assembly::PathBack, assembly::PathEnd, assembly::RefusedCracks, assembly::RoundingOfForces,
    assembly::RoundingOfSprings, assembly::Unbalanced, assembly::UnknownPosition;

const char* what_happened(FailureKind kind) {
  switch (kind) {
    case FailureKind::NoConvergence:
      return "the iteration did not converge";
    case FailureKind::Inverted:
      return "an element turned inside out (J <= 0)";
    case FailureKind::Singular:
      return "the tangent matrix is singular";
    case FailureKind::NotFinite:
      return "a value is not finite";
    case FailureKind::Unloaded:
      return "the path of equilibrium leads back to load 0";
    case FailureKind::Unloads:
      return "beyond its limit load the body only unloads elastically";
    case FailureKind::LedBack:
      return "the path of equilibrium leads back to where an amplitude turned";
    case FailureKind::Wanders:
      return "the path wanders among loads that it has passed";
    case FailureKind::Plateau:
      return "plateau: the body flows or slides on and bears no more";
    case FailureKind::Tunnelling:
      return "faces in contact have passed through each other unseen";
    case FailureKind::Refused:
      return "the cracks that have grown cannot be cut";
  }
  return "unknown failure";
}

const char* words_for(geometry::MaybeSide side) {
  return !side ? "" : *side == geometry::Side::Left ? ", left side" : ", right side";
}

// Where a failure happened, and the numbers that tell of it.
struct FailurePlace {
  const Model& model;
  FailureKind kind;

  std::string tip(const CrackEnd& at) const {
    return fmt::format("crack '{}', {}", model.cracks[at.crack].name, at.end == 0 ? "start" : "end");
  }
  std::string unknown(const UnknownPosition& at) const {
    switch (at.of) {
      case UnknownPosition::Of::Multiplier:
        return "a contact multiplier";
      case UnknownPosition::Of::Amplitude:
        return "a branch function's amplitude";
      case UnknownPosition::Of::Displacement:
        break;
    }
    return fmt::format("node {} at {}{}", at.node, model.words_for(at.reference), words_for(at.side));
  }
  std::string motion(const UnknownPosition& at, double size) const {
    if (size == 0.0) return {};
    const char* unit = at.of == UnknownPosition::Of::Multiplier ? " m times its stiffness" : " m";
    return fmt::format("{} would move by {:.1e}{}", unknown(at), size, unit);
  }

  std::string operator()(std::monostate) const { return {}; }
  std::string operator()(const Unbalanced& f) const {
    std::string out = fmt::format("relative residual {:.2e} after {} iterations, largest at {}", f.residual,
                                  f.iterations, unknown(f.largest));
    if (f.changing > 0) out += fmt::format(", {} points still changing between open, stick, slip or flow", f.changing);
    if (f.halved > 0) out += fmt::format(" (the active set cycles; {} corrections were halved)", f.halved);
    return out;
  }
  std::string operator()(const LoadTooLow& f) const { return fmt::format("its load fell below {:.6g}", f.lowest); }
  std::string operator()(const RoundingOfSprings& f) const {
    return fmt::format("the rounding of the contact springs, {:.1e} N/m, hides the forces, {:.1e} N/m", f.rounding,
                       f.forces);
  }
  std::string operator()(const RoundingOfForces& f) const {
    return fmt::format("rounding leaves a residual of {:.1e} N/m, {:.1e} of the forces", f.residual, f.part);
  }
  std::string operator()(const InvertedPoint& f) const {
    return fmt::format("element {} at {}{}", f.at.element, model.words_for(f.at.reference), words_for(f.at.side));
  }
  std::string operator()(const ForceNotFinite& f) const { return "the internal force at " + unknown(f.at); }
  std::string operator()(const NoCorrection&) const { return "no factors, or none that are finite"; }
  std::string operator()(const FarCorrection& f) const { return motion(f.at, f.size); }
  std::string operator()(const LostPart& f) const { return motion(f.at, f.moved); }
  std::string operator()(const PassedPoint& f) const {
    return fmt::format("the contact point at {} of crack '{}' lies {:.2g} m deep in the other side",
                       model.words_for(f.at), model.cracks[f.crack].name, f.depth);
  }
  std::string operator()(const PathBack& f) const {
    const std::string from = fmt::format("from load {:.6g}", f.from);
    return kind == FailureKind::LedBack ? fmt::format("load {:.6g}, {}", f.lowest, from) : from;
  }
  std::string operator()(const PathEnd& f) const {
    const std::string furthest = fmt::format("no load above {:.6g}", f.furthest);
    return kind == FailureKind::Wanders ? fmt::format("{} in {} increments", furthest, f.increments) : furthest;
  }
  std::string operator()(const NoDemand& f) const {
    return fmt::format("at the {}: {}", tip(f.tip),
                       f.why == NoDemand::Why::SmallDisc
                           ? "the disc around the tip is smaller than an element"
                           : "the body ends, or the crack bends, within half an element size: too near for stress "
                             "intensities");
  }
  std::string operator()(const RefusedCracks& f) const { return f.why; }

  std::string operator()(const LastIncrement& a) const {
    return fmt::format("at load {:.6g} (last converged: {:.6g}), increments down to {:.1e}", a.load, a.converged,
                       a.size);
  }
  std::string operator()(const LastArc& a) const {
    return fmt::format("on the path from load {:.6g} (largest: {:.6g}), increments down to {:.1e} of the longest",
                       a.load, a.furthest, a.part);
  }
  std::string operator()(const HeldPart& a) const {
    return fmt::format("at load {:.6g}, with {:.3g} of what the new faces held still there", a.load, a.part);
  }

  std::string growth(const std::vector<GrownTip>& tips) const {
    std::string out;
    for (const GrownTip& grown : tips)
      out += fmt::format("{}{} to {}{}", out.empty() ? "after growth of " : " and ", tip(grown.tip),
                         model.words_for(grown.to), grown.through_boundary ? " through the boundary" : "");
    return out.empty() ? out : out + ": ";
  }
};

std::string joined(const std::string& a, const std::string& b) { return a.empty() || b.empty() ? a + b : a + ", " + b; }

bool has_springs(const Model& model) {
  for (Index crack = 0; crack < static_cast<Index>(model.surfaces.laws.size()); ++crack)
    if (!model.surfaces.is_mortar(crack)) return true;
  return false;
}

constexpr const char* kHold = "(is every part of the body held?)";

// What to try, by what was found.
struct FailureAdvice {
  const Model& model;
  FailureKind kind;

  // Smaller increments, softer contact as the method of each crack has it, a finer mesh.
  std::string softer(const char* where) const {
    std::string out = "smaller increments (loading.steps), ";
    if (has_springs(model)) out += "a softer penalty, ";
    // on a crack with a step across its way smoothing 1, 2, 4 and 8 take 75, 69, 66 and 64 iterations
    if (!model.surfaces.multiplier_space.nodes.empty()) out += "more smoothing of mortar contact (contact.smoothing), ";
    return out + "or a finer mesh" + where;
  }
  std::string easier() const { return softer(model.cracks.empty() ? "" : " at the crack"); }
  std::string held() const {
    return fmt::format("prescribing more components, or bringing the parts into contact {}", kHold);
  }
  std::string stable() const {
    if (!model.has_memory()) return held();
    return fmt::format(
        "hardening or a lower load (the body may have reached its limit load), or prescribing more components {}",
        kHold);
  }

  std::string operator()(std::monostate) const {
    return kind == FailureKind::Unloads ? "hardening, or a finer mesh: this is where the path of flow ends" : "";
  }
  // Springs of one side's points jump where these pass a corner of the other; mortar contact and springs of both sides
  // share it.
  std::string operator()(const Unbalanced& f) const {
    return f.halved > 0 && has_springs(model)
               ? easier() + "; or, where corners pass each other, contact.method = \"mortar\""
               : easier();
  }
  std::string operator()(const LoadTooLow&) const { return easier(); }
  std::string operator()(const RoundingOfSprings&) const { return "a softer penalty"; }
  std::string operator()(const RoundingOfForces& f) const {
    if (f.of == RoundingOfForces::Of::Springs) return "a softer penalty";
    return model.is_small_strain() ? "displacements that move the body less as a whole, or a softer material"
                                   : "larger strains, a softer material, or formulation.kinematics = \"small\"";
  }
  std::string operator()(const InvertedPoint& f) const {
    if (!f.at.at_tip) return softer(" there");
    return "smaller loads, or formulation.tip_enrichment = 0: near a tip branch functions turn inside out where "
           "strains are large";
  }
  std::string operator()(const ForceNotFinite&) const {
    return "smaller increments (loading.steps), or moduli, penalties and lengths whose products are numbers";
  }
  std::string operator()(const NoCorrection&) const { return stable(); }
  std::string operator()(const FarCorrection&) const { return stable(); }
  std::string operator()(const LostPart&) const { return held(); }
  std::string operator()(const PassedPoint& f) const {
    return std::string("no solver.search_radius of your own, ") +
           (model.surfaces.is_mortar(f.crack) ? "or smaller increments (loading.steps)"
                                              : "smaller increments (loading.steps), or a stiffer penalty");
  }
  std::string operator()(const PathBack&) const {
    return "a finer mesh, hardening, or another measure of the load: nothing can bear it any more";
  }
  std::string operator()(const PathEnd&) const {
    return kind == FailureKind::Plateau
               ? "hardening, or prescribed displacements instead of the loads, to see where the motion leads"
               : "an imperfection where another path branches off, hardening, or other increments (loading.steps)";
  }
  std::string operator()(const NoDemand& f) const {
    return f.why == NoDemand::Why::SmallDisc
               ? "a larger growth.radius, or a finer mesh where the crack grows"
               : "longer advances (growth.advance), or a finer mesh where the crack grows";
  }
  std::string operator()(const RefusedCracks&) const { return "fewer advances (growth.most)"; }
};

bool may_follow_path(const Failure& failure, const Model& model) {
  const auto* last = std::get_if<LastIncrement>(&failure.attempt);
  return last && last->path_untried && model.has_memory();
}

}  // namespace

std::string describe(const Failure& failure, const Model& model) {
  const FailurePlace place{model, failure.kind};
  const std::string found = std::visit(place, failure.finding), tried = std::visit(place, failure.attempt);
  return joined(what_happened(failure.kind), place.growth(failure.grown) + joined(found, tried));
}

std::string advice(const Failure& failure, const Model& model) {
  std::string out = std::visit(FailureAdvice{model, failure.kind}, failure.finding);
  if (may_follow_path(failure, model))
    out +=
        "; the body may be at a limit load: loading.control = \"path\" goes beyond it, material.viscosity delays flow "
        "that localises";
  if (!failure.grown.empty() && failure.kind != FailureKind::Refused) out += "; or shorter advances (growth.advance)";
  return out;
}

}  // namespace cleft::simulation
