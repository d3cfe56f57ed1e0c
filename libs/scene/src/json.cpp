#include "cleft/scene/json.hpp"

#include "tables.hpp"

namespace cleft::scene {

std::string to_json(const problem::Specification& scene) {
  Json j{{"title", scene.title}, {"file", scene.file}};
  j.update(write(scene_table(), scene));
  return j.dump(2, ' ', false, Json::error_handler_t::replace);  // file names may be anything
}

std::string solved_json(const problem::Specification& scene) {
  Json j = write(scene_table(), scene);
  j.erase("title");
  return j.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string scene_hash(const problem::Specification& scene) { return hash_of(solved_json(scene)); }

std::string hash_of(std::string_view bytes) {
  std::uint64_t hash = 14695981039346656037ULL;  // FNV-1a
  for (const unsigned char c : bytes) hash = (hash ^ c) * 1099511628211ULL;
  return fmt::format("{:016x}", hash);
}

}  // namespace cleft::scene
