#include "faces_alone.hpp"

namespace cleft::tangent_check {

assembly::Model without_bulk(const assembly::Model& model) {
  assembly::Model out = model;
  out.cells.clear();
  out.f_bar_partner.clear();
  out.tip_points.clear();
  out.ties.clear();
  return out;
}

}  // namespace cleft::tangent_check
