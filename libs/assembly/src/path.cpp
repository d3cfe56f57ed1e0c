#include "path.hpp"

namespace cleft::assembly {

// theory (9.3)
VecX path_progress(const Model& model, const State& before, const VecX& displacement,
                   const std::vector<constitutive::PlasticState>& plastic) {
  const VecX moved = displacement - before.displacement;
  const auto flow = [&](std::size_t p) { return plastic[p].accumulated - before.history.plastic[p].accumulated; };
  bool flows = false;
  for (std::size_t p = 0; p < plastic.size() && !flows; ++p) flows = flow(p) > 0.0;

  VecX progress = VecX::Zero(displacement.size());
  double grown = 0.0;
  for_each_material_point(model, [&](std::size_t p, const auto& point, double weight) {
    const double share = flows ? weight * flow(p) : weight;
    if (!(share > 0.0)) return;
    const Mat2 D = displacement_gradient(point, moved);
    grown += share * D.squaredNorm();
    for (std::size_t k = 0; k < point.unknown.size(); ++k)
      progress.segment<2>(2 * point.unknown[k]) += share * (D * point.gradient[k]);
  });
  if (!(grown > 0.0)) return {};
  return progress / grown;
}

}  // namespace cleft::assembly
