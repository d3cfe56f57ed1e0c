#include "table.hpp"

namespace cleft::scene {

std::vector<Named<std::string>> texts(std::initializer_list<const char*> all) {
  std::vector<Named<std::string>> out;
  for (const char* text : all) out.push_back({text, text});
  return out;
}

std::string with_names(const std::string& help, const std::vector<std::string>& names) {
  return fmt::format("{}{}{}", help, help.empty() ? "" : ": ", fmt::join(names, " | "));
}

std::string with_unit(std::string help, const char* unit) {
  if (*unit) help.insert(std::min(help.find(';'), help.size()), std::string(", ") + unit);
  return help;
}

void refuse_owner(const Section& s, const std::string& key, const std::vector<std::string>& owners,
                  const std::string& selector, const std::string& value) {
  const std::string allowed = fmt::format("{}", fmt::join(owners, ", "));
  s.fail(key, value.empty() ? fmt::format("belongs to a {0}; allowed with {0} = \"{1}\" only", selector, allowed)
                            : fmt::format("does not apply to {} = \"{}\"; allowed with {}", selector, value, allowed));
}

}  // namespace cleft::scene
