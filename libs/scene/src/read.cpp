#include "cleft/scene/read.hpp"

#include "tables.hpp"

namespace cleft::scene {

problem::Specification read_scene(const std::string& file, const std::vector<std::string>& overrides) {
  const Document document = Document::load(file, overrides);
  problem::Specification out;
  out.file = file;
  read(scene_table(), Section(document, document.root, "", ""), out);
  return out;
}

}  // namespace cleft::scene
