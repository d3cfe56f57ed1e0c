// The field files of a run, read into shapes.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "cleft/results/vtu.hpp"
#include "run_data.hpp"

namespace cleft::report {
namespace {

using results::VtuArray, results::VtuGrid;

constexpr std::array kKinds{
    FieldKind{"stress_yy", "vertical Cauchy stress, tension positive", "Pa", "cauchy_stress", 1},
    FieldKind{"stress_xx", "horizontal Cauchy stress, tension positive", "Pa", "cauchy_stress", 0},
    FieldKind{"stress_xy", "Cauchy shear stress", "Pa", "cauchy_stress", 3},
    FieldKind{"mean_stress", "mean Cauchy stress, tension positive", "Pa", "mean_stress", 0},
    FieldKind{"max_principal_stress", "largest principal Cauchy stress, tension positive", "Pa", "max_principal_stress",
              0},
    FieldKind{"plastic_strain", "plastic strain (sum of multipliers)", "", "plastic_strain", 0}};

const VtuArray* find(const std::vector<VtuArray>& arrays, const std::string& name) {
  const auto at = std::ranges::find(arrays, name, &VtuArray::name);
  return at == arrays.end() ? nullptr : &*at;
}

void add_points(const VtuGrid& grid, Shape& shape, const std::string& path) {
  const auto* u = find(grid.point_data, "displacement");
  if (!u || u->components != 3) throw std::runtime_error(path + ": has no displacement");
  shape.points.insert(shape.points.end(), grid.points.begin(), grid.points.end());
  for (std::size_t k = 0; k < grid.points.size(); ++k)
    shape.displacement.emplace_back(u->values[3 * k], u->values[3 * k + 1]);
}

void add_bulk(const std::string& path, Run& run, Shape& shape) {
  const VtuGrid grid = results::read_vtu(path);
  if (grid.cell_size != 3) throw std::runtime_error(path + ": not of triangles");
  add_points(grid, shape, path);
  shape.bulk_points = grid.points.size();
  shape.triangles = grid.connectivity;
  if (run.shapes.empty())
    for (const auto& kind : kKinds)
      if (const auto* array = find(grid.cell_data, kind.array); array && kind.component < array->components)
        run.fields.push_back(kind);
  for (const auto& kind : run.fields) {
    const auto* array = find(grid.cell_data, kind.array);
    if (!array || kind.component >= array->components) throw std::runtime_error(path + ": has no " + kind.array);
    auto& values = shape.values.emplace_back();
    for (auto k = static_cast<std::size_t>(kind.component); k < array->values.size();
         k += static_cast<std::size_t>(array->components))
      values.push_back(static_cast<float>(array->values[k]));
  }
}

Range range_of(const Run& run, std::size_t field) {
  std::vector<float> all;
  for (const auto& shape : run.shapes)
    std::ranges::copy_if(shape.values[field], std::back_inserter(all), [](float v) { return std::isfinite(v); });
  if (all.empty()) return {0.0, 0.0, 0.0, 1.0};
  const auto place = [&](double share) {
    const auto at = all.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(all.size() - 1));
    std::nth_element(all.begin(), at, all.end());
    return static_cast<double>(*at);
  };
  constexpr double kLeftOut = 0.01;
  Range range{place(0.0), place(1.0), place(kLeftOut), place(1.0 - kLeftOut)};
  if (range.low == range.high) {  // a colour bar needs a width
    range.low = range.least;
    range.high = range.most;
  }
  if (range.low == range.high) range.high += range.low == 0.0 ? 1.0 : 1e-3 * std::fabs(range.low);
  return range;
}

// Around all shapes with their displacements times `factor`.
Box box_of(const Run& run, double factor) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Box box{Vec2::Constant(kFar), Vec2::Constant(-kFar)};
  for (const auto& shape : run.shapes)
    for (std::size_t k = 0; k < shape.points.size(); ++k) {
      const Vec2 x = shape.points[k] + factor * shape.displacement[k];
      box.low = box.low.cwiseMin(x);
      box.high = box.high.cwiseMax(x);
    }
  return box;
}

double factor_of(const Run& run) {
  constexpr double kVisible = 0.02, kWanted = 0.05;  // of the body's diagonal
  double largest = 0.0;
  for (const auto& shape : run.shapes)
    for (const Vec2& u : shape.displacement) largest = std::max(largest, u.norm());
  const double size = (run.reference.high - run.reference.low).norm();
  if (largest == 0.0 || largest > kVisible * size) return 1.0;
  const double wanted = kWanted * size / largest, power = std::pow(10.0, std::floor(std::log10(wanted)));
  return power * (wanted >= 5.0 * power ? 5.0 : wanted >= 2.0 * power ? 2.0 : 1.0);
}

struct Output {
  int number = 0;
  double load = 0.0;
  std::optional<std::size_t> row;    // of history.csv
  std::array<std::string, 2> files;  // of the bulk and, if there are cracks, of their faces
};

// The increments of the outputs as the profile along a crack tells them, one after the other.
std::vector<double> steps_of(const Run::Crack& crack, const std::string& directory) {
  auto steps = column_of(crack.profile, "step", directory + "/crack_" + crack.name + ".csv");
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
  return steps;
}

// Without a crack no two increments have one load. With one the profile tells the increment; the collection's loads
// then differ by crumbs from those of the increments.
void find_rows(const Run& run, std::vector<Output>& outputs) {
  const auto load = run.column("load"), step = run.column("step");
  for (auto& output : outputs)
    if (std::ranges::count(load, output.load) == 1)
      output.row = static_cast<std::size_t>(std::ranges::find(load, output.load) - load.begin());
  for (const auto& crack : run.cracks) {
    const auto steps = steps_of(crack, run.directory);
    if (steps.size() != outputs.size()) continue;
    for (std::size_t k = 0; k < steps.size(); ++k)
      if (const auto at = std::ranges::find(step, steps[k]); at != step.end())
        outputs[k].row = static_cast<std::size_t>(at - step.begin());
    break;
  }
  for (auto& output : outputs)
    if (output.row) output.load = load[*output.row];
}

// Those whose files are there, with the numbers that they have among all.
std::vector<Output> outputs_of(const Run& run) {
  const std::string collection = run.directory + "/fields.pvd";
  std::vector<Output> out;
  if (!std::filesystem::exists(collection)) return out;
  for (const auto& entry : results::read_pvd(collection)) {
    if (entry.part == 0) out.push_back({out.empty() ? 0 : out.back().number + 1, entry.load, {}, {}});
    if (out.empty() || entry.part < 0 || entry.part > 1)
      throw std::runtime_error(collection + ": has a part that a run does not write");
    if (std::filesystem::exists(run.directory + "/" + entry.file))
      out.back().files[static_cast<std::size_t>(entry.part)] = run.directory + "/" + entry.file;
  }
  find_rows(run, out);
  std::erase_if(out, [](const Output& output) { return output.files[0].empty(); });
  return out;
}

// So that figures and page keep a size that a phone still takes.
std::size_t stride_of(const Shape& first, std::size_t outputs) {
  constexpr std::size_t kMostTriangles = 300'000;
  return 1 + outputs * (first.triangles.size() / 3) / kMostTriangles;
}

}  // namespace

void read_shapes(Run& run) {
  const auto outputs = outputs_of(run);
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    if (run.shapes.size() == 1) run.stride = stride_of(run.shapes.front(), outputs.size());
    if (!run.shapes.empty() && (outputs.size() - 1 - k) % run.stride != 0) continue;
    Shape shape;
    shape.number = outputs[k].number;
    shape.load = outputs[k].load;
    shape.row = outputs[k].row;
    add_bulk(outputs[k].files[0], run, shape);
    if (!outputs[k].files[1].empty()) add_points(results::read_vtu(outputs[k].files[1]), shape, outputs[k].files[1]);
    run.shapes.push_back(std::move(shape));
  }
  if (run.shapes.empty()) return;
  for (std::size_t field = 0; field < run.fields.size(); ++field) run.ranges.push_back(range_of(run, field));
  run.reference = box_of(run, 0.0);
  run.factor = factor_of(run);
  run.drawn = box_of(run, run.factor);
}

}  // namespace cleft::report
