// The tangents of all contact points, each by itself.
#pragma once

#include <Eigen/Core>

#include "cleft/assembly/assembler.hpp"
#include "cleft/tangent_check/tangent.hpp"
#include "difference.hpp"

namespace cleft::tangent_check {

/// The faces without the body and with one contact point at a time, so that every force and entry that the assembler
/// makes is that point's.
class ContactPointTangents {
 public:
  ContactPointTangents(const assembly::Model& model, const assembly::History& history, const VecX& u,
                       const Lengths& lengths);

  /// Compares every point and sums up by its status. Lowers `step`, per unknown, to what the points needed to stay on
  /// their branches.
  void check(double load, double tolerance, TangentReport& report, std::vector<double>& step);

 private:
  struct Column {
    std::vector<Quotient> row;
    double step = 0.0;
    const char* kink = nullptr;  // why there is none
  };
  void check_point(Index point, double load, double tolerance, TangentReport& report, std::vector<double>& step);
  Column difference(assembly::Assembler& assembler, const contact::Pair& base, const std::vector<Index>& rows,
                    Index component, const Eigen::VectorXd& scale, double tolerance);
  // Forces on `rows` with `component` moved; the kink in between, if there is one.
  const char* force(assembly::Assembler& assembler, const contact::Pair& base, const std::vector<Index>& rows,
                    Index component, double move, std::vector<double>& out);

  const assembly::Model& whole_;
  const assembly::History& history_;
  const VecX& u_;
  const Lengths& lengths_;

  // The point at hand, with everything moved so that it is at the origin.
  assembly::Model one_;
  assembly::History one_history_;
  VecX moved_;
  double reach_ = 0.0;  // as in Lengths, of the faces that matter to it
};

}  // namespace cleft::tangent_check
