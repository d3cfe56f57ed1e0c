// The quadrature in the ball of a tip, and the interaction integral over it; the radius is range(0) elements.
#include <benchmark/benchmark.h>

#include "cleft/enrichment/sif.hpp"

namespace {

using namespace cleft;

struct Ball {
  geometry::Mesh mesh;
  geometry::CutMesh cut;
  enrichment::Unknowns unknowns;

  explicit Ball(std::int64_t elements)
      : mesh(geometry::structured_mesh({-1, -1, 1, 1}, {64, 64}, geometry::Diagonal::Right)),
        cut(geometry::cut(mesh, {{"crack", {{-1.0, -0.213}, {0.0312, 0.0137}}, static_cast<double>(elements) / 32.0}})),
        unknowns(enrichment::number_unknowns(mesh, cut)) {}
};

void tip_quadrature(benchmark::State& state) {
  const Ball ball(state.range(0));
  std::size_t points = 0;
  for (auto _ : state) {
    const auto all = enrichment::make_tip_points(ball.mesh, ball.cut, ball.unknowns);
    points = all.size();
    benchmark::DoNotOptimize(all.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points));
  state.counters["points"] = static_cast<double>(points);
}
BENCHMARK(tip_quadrature)->Arg(4)->Arg(10)->Unit(benchmark::kMillisecond);

void interaction_integral(benchmark::State& state) {
  const Ball ball(state.range(0));
  const auto points = enrichment::make_tip_points(ball.mesh, ball.cut, ball.unknowns);
  const enrichment::PlaneStrain body{1.0, 0.3};
  const VecX u = 1e-3 * VecX::LinSpaced(ball.unknowns.components(), -1.0, 1.0);
  const auto computed = [&](const enrichment::TipPoint& point) -> enrichment::PointState {
    const Mat2 gradient = point.deformation(u) - Mat2::Identity();
    return {gradient, body.stress(gradient)};
  };
  enrichment::TipLoads loads;
  for (const auto& face : enrichment::make_faces(ball.mesh, ball.cut, ball.unknowns))
    loads.faces.push_back({face.reference_start, face.reference_end, face.side, Vec2(0.3, -0.4)});
  for (auto _ : state)
    benchmark::DoNotOptimize(enrichment::interaction_integral(ball.cut.tips[0], 0, points, computed, loads, body));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
}
BENCHMARK(interaction_integral)->Arg(4)->Arg(10)->Unit(benchmark::kMicrosecond);

}  // namespace
