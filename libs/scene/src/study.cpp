#include "cleft/scene/study.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <sstream>

#include "document.hpp"

namespace cleft::scene {
namespace {

// Paths in a study are relative to it.
std::string beside(const std::string& study, const std::string& path) {
  return (std::filesystem::path(study).parent_path() / path).lexically_normal().string();
}

std::string toml_text(const toml::node& node) {
  std::ostringstream out;
  node.visit([&](const auto& value) { out << value; });
  return out.str();
}

std::array<double, 2> interval(const Section& s, std::string_view key) {
  const auto v = s.numbers(key, 2);
  if (!(v[1] > v[0])) s.fail(key, "the interval is empty; allowed: [least, most] with least < most");
  return {v[0], v[1]};
}

std::string default_name(const Quantity& q) {
  if (q.kind == Quantity::Kind::Error) return q.column + " error";
  if (q.kind == Quantity::Kind::History) return fmt::format("{} at {}", q.column, q.load);
  std::string out = fmt::format("{}.{} at {}", q.crack, q.column, q.load);
  if (!q.side.empty()) out += ", " + q.side;
  if (q.along != "s") out += " along " + q.along;
  if (q.range) out += fmt::format(" in [{}, {}]", (*q.range)[0], (*q.range)[1]);
  return q.largest ? out + ", largest" : out;
}

Quantity read_quantity(const Section& s, const std::string& file) {
  Quantity q;
  q.at = s.at();
  if (s.has("error") + s.has("column") != 1)
    throw InputError(s.at(), s.path("column"), "says what is followed; allowed: exactly one of column and error");
  const auto only_with = [&](const char* owner, std::initializer_list<const char*> keys) {
    for (const char* key : keys)
      if (s.has(key) && !s.has(owner)) s.fail(key, fmt::format("allowed together with {} only", owner));
  };
  only_with("crack", {"along", "norm", "reference", "range", "side"});
  only_with("column", {"load", "crack", "exact"});
  if (s.has("error")) {
    q.kind = Quantity::Kind::Error;
    q.column = s.choice("error", {"l2", "energy"});
  } else {
    q.column = s.text("column");
    q.load = s.number_or(
        "load", 1.0, [](double x) { return x > 0.0 && x <= 1.0; }, "greater than 0, up to 1");
  }
  if (s.has("crack")) {
    q.kind = Quantity::Kind::Profile;
    q.crack = s.text("crack");
    if (s.has("along")) q.along = s.choice("along", {"s", "X", "Y", "x", "y"});
    if (s.has("side")) q.side = s.choice("side", {"left", "right"});
    if (s.has("norm")) q.largest = s.choice("norm", {"l2", "max"}) == "max";
    if (s.has("reference")) q.reference = beside(file, s.text("reference"));
    if (s.has("range")) q.range = interval(s, "range");
    if (s.has("exact")) s.fail("exact", "a profile has no single value; allowed: reference");
  }
  q.exact = s.maybe_number("exact");
  if (s.has("order_within")) q.order_within = interval(s, "order_within");
  if (s.has("limit_within")) q.limit_within = interval(s, "limit_within");
  if (q.limit_within && (q.exact || q.kind != Quantity::Kind::History))
    s.fail("limit_within", "the limit is known here; allowed: for a column without exact");
  q.name = s.has("name") ? s.text("name") : default_name(q);
  return q;
}

}  // namespace

Study read_study(const std::string& file) {
  const Document document = Document::load(file, {});
  const Section root(document, document.root, "", "study");
  Study out;
  out.file = file;
  if (root.has("title")) out.title = root.text("title");
  out.scene = beside(file, root.text("scene"));
  out.scene_at = root.at("scene");
  if (root.has("set")) out.set = root.texts("set");
  for (std::size_t k = 0; k < out.set.size(); ++k) out.overrides_at[out.set[k]] = root.at("set", k);
  const char* const meshes = root.has("refine") ? "refine" : "cells";
  if (root.has("refine") && root.has("cells"))
    root.fail("refine", "says what the meshes are; allowed: one of cells and refine");
  out.mesh_key = std::string("mesh.") + meshes;
  if (root.has("refine"))
    for (const double value : root.numbers("refine", std::nullopt)) out.meshes.push_back(fmt::format("{}", value));
  else
    for (const auto& row : root.pairs("cells")) out.meshes.push_back(fmt::format("[{}, {}]", row[0], row[1]));
  if (out.meshes.size() < 2) root.fail(meshes, "a sequence needs at least two meshes");
  for (std::size_t k = 0; k < out.meshes.size(); ++k)
    out.overrides_at[out.mesh_key + "=" + out.meshes[k]] = root.at(meshes, k);
  out.variants = {""};
  if (const auto sweep = root.section("sweep", "study.sweep")) {
    out.sweep_key = sweep->text("key");
    out.variants.clear();
    for (const auto& value : *sweep->array("values")) {
      const Location at = sweep->at("values", out.variants.size());
      out.variants.push_back(toml_text(value));
      out.overrides_at[out.sweep_key + "=" + out.variants.back()] = at;
    }
    if (out.variants.empty()) sweep->fail("values", "empty; allowed: at least one value");
  }
  for (const auto& s : root.sections("quantity", "study.quantity")) {
    out.quantities.push_back(read_quantity(s, file));
    for (std::size_t k = 0; k + 1 < out.quantities.size(); ++k)
      if (out.quantities[k].name == out.quantities.back().name)
        s.fail("name",
               fmt::format("'{}' names another quantity, too; allowed: distinct names", out.quantities[k].name));
  }
  if (out.quantities.empty())
    throw InputError(root.at(), "quantity", "missing; allowed: at least one [[quantity]] section");
  return out;
}

}  // namespace cleft::scene
