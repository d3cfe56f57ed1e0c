#include "cleft/geometry/cut.hpp"

#include <algorithm>

#include "cleft/support/error.hpp"
#include "crack_check.hpp"
#include "face_segments.hpp"
#include "split.hpp"
#include "tip_balls.hpp"
#include "tips.hpp"
#include "trace.hpp"

namespace cleft::geometry {

namespace {

[[noreturn]] void winds(const Crack& crack) {
  throw CrackError(
      crack,
      "winds so tightly that a node or a piece of an element would lie on both of its sides; refine the mesh there");
}

class Cutter {
 public:
  Cutter(const Mesh& mesh, const std::vector<Crack>& cracks)
      : cracks_(cracks),
        terrain_(mesh),
        node_crack_(mesh.nodes.size(), kNone),
        node_side_(mesh.nodes.size(), Side::Right) {}

  void run(CutMesh& result) {
    const auto ends = locate_ends(terrain_, cracks_);
    for (std::size_t c = 0; c < cracks_.size(); ++c) {
      Tracer tracer(terrain_, cracks_[c]);
      Trace trace = tracer.trace(ends[c]);
      std::vector<Index> tip_nodes;
      settle_tips(terrain_, tracer, cracks_[c], trace, tip_nodes);
      add_elements(result, static_cast<Index>(c), trace);
      check_opens(result, static_cast<Index>(c), tip_nodes);
      for (const TipPassage& tip : trace.tips)
        result.tips.push_back(make_ball(terrain_, cracks_[c], static_cast<Index>(c), trace, tip));
      add_segments(terrain_, cracks_[c], static_cast<Index>(c), trace, result);
      result.tip_nodes.insert(result.tip_nodes.end(), tip_nodes.begin(), tip_nodes.end());
    }
    std::sort(result.tip_nodes.begin(), result.tip_nodes.end());
    result.tip_nodes.erase(std::unique(result.tip_nodes.begin(), result.tip_nodes.end()), result.tip_nodes.end());
    if (result.tips.empty()) return;
    check_balls(cracks_, result.tips);
    result.tip_of_element = balls_of_elements(mesh(), cracks_, result.tips);
  }

 private:
  const Mesh& mesh() const { return terrain_.topology.mesh(); }

  void add_elements(CutMesh& result, Index c, const Trace& trace) {
    const Crack& crack = cracks_[static_cast<std::size_t>(c)];
    const std::size_t first = result.elements.size();
    std::vector<std::vector<Path>> paths;
    for (const Chain& chain : trace.chains) {
      for (const Passage& passage : chain.passages) {
        Index& cut = result.cut_of_element[static_cast<std::size_t>(passage.element)];
        if (cut == kNone) {
          cut = static_cast<Index>(result.elements.size());
          result.elements.emplace_back();
          result.elements.back().element = passage.element;
          result.elements.back().crack = c;
          paths.emplace_back();
        } else if (const Index owner = result.elements[static_cast<std::size_t>(cut)].crack; owner != c) {
          too_near(owner, c);
        }
        paths[static_cast<std::size_t>(cut) - first].push_back({passage.in_edge, passage.out_edge,
                                                                &trace.crossings[static_cast<std::size_t>(passage.in)],
                                                                &trace.crossings[static_cast<std::size_t>(passage.out)],
                                                                kinks_of(terrain_.topology, trace, crack, passage)});
      }
    }
    for (std::size_t e = first; e < result.elements.size(); ++e) {
      CutElement& element = result.elements[e];
      auto division = divide(mesh(), element.element, paths[e - first]);
      if (!division) winds(crack);
      element.node_side = division->node_side;
      element.area = division->area;
      element.sub_triangles = std::move(division->sub_triangles);
      claim_nodes(element);
    }
  }

  void claim_nodes(const CutElement& element) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto n = static_cast<std::size_t>(mesh().triangles[static_cast<std::size_t>(element.element)][k]);
      if (node_crack_[n] == kNone) {
        node_crack_[n] = element.crack;
        node_side_[n] = element.node_side[k];
      } else if (node_crack_[n] != element.crack) {
        too_near(node_crack_[n], element.crack);
      } else if (node_side_[n] != element.node_side[k]) {
        winds(cracks_[static_cast<std::size_t>(element.crack)]);
      }
    }
  }

  [[noreturn]] void too_near(Index one, Index two) const {
    const Crack &a = cracks_[static_cast<std::size_t>(one)], &b = cracks_[static_cast<std::size_t>(two)];
    throw CrackError(b, "cracks " + a.name + " and " + b.name +
                            " are too near each other for this mesh: they cut elements with a common node; refine the "
                            "mesh between them");
  }

  // A node opens if some element has a part on the other side of the crack.
  void check_opens(const CutMesh& result, Index c, const std::vector<Index>& tip_nodes) const {
    for (auto element = result.elements.rbegin(); element != result.elements.rend() && element->crack == c; ++element) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Index node = mesh().triangles[static_cast<std::size_t>(element->element)][k];
        const bool divided = element->area[static_cast<std::size_t>(other(element->node_side[k]))] > 0.0;
        if (divided && std::find(tip_nodes.begin(), tip_nodes.end(), node) == tip_nodes.end()) return;
      }
    }
    throw CrackError(cracks_[static_cast<std::size_t>(c)],
                     "is too short for the mesh: no node can open; refine the mesh around it or make it longer");
  }

  const std::vector<Crack>& cracks_;
  Terrain terrain_;
  std::vector<Index> node_crack_;
  std::vector<Side> node_side_;
};

}  // namespace

CutMesh cut(const Mesh& mesh, const std::vector<Crack>& cracks) {
  CutMesh result;
  result.cut_of_element.assign(mesh.triangles.size(), kNone);
  if (cracks.empty()) return result;  // without a crack a mesh need not be looked at
  check_cracks(cracks);
  Cutter(mesh, cracks).run(result);
  return result;
}

Index ball_at(const CutMesh& cut, Index crack, int end) {
  for (std::size_t tip = 0; tip < cut.tips.size(); ++tip)
    if (cut.tips[tip].crack == crack && cut.tips[tip].end == end) return static_cast<Index>(tip);
  return kNone;
}

}  // namespace cleft::geometry
