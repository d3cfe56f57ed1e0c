// cleft man, cleft completion: the manual page and bash's completion, made from the command line's own descriptions.
#include <fmt/format.h>

#include <string>
#include <vector>

#include "cleft/scene/keys.hpp"
#include "verbs.hpp"

namespace cleft::tools {
namespace {

std::vector<const CLI::App*> verbs_of(const CLI::App& app) {
  std::vector<const CLI::App*> out;
  for (const auto* verb : app.get_subcommands([](const CLI::App*) { return true; })) out.push_back(verb);
  return out;
}

// Text as roff shows it as it is.
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') out += "\\e";
    if (c == '-') out += "\\-";
    if (c != '\\' && c != '-') out += c;
  }
  return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

// -o, --output TEXT; a positional as it is called.
std::string name_of(const CLI::Option& option) {
  std::string names;
  for (const char c : option.get_name(option.get_positional(), !option.get_positional()))
    names += c == ',' ? std::string(", ") : std::string(1, c);
  const std::string type = option.get_type_name();
  return "\\fB" + roff(names) + "\\fR" + (option.get_positional() || type.empty() ? "" : " " + roff(type));
}

std::string manual(const CLI::App& app) {
  std::string out = fmt::format(
      ".TH CLEFT 1 \"\" \"cleft {}\" \"User Commands\"\n.SH NAME\n{}\n.SH SYNOPSIS\n.B cleft\n\\fIVERB\\fR "
      "[\\fIOPTIONS\\fR]\n.SH VERBS\n",
      CLEFT_VERSION, "cleft \\- " + roff(app.get_description()));
  for (const auto* verb : verbs_of(app)) {
    out += fmt::format(".SS cleft {}\n{}\n", roff(verb->get_name()), roff(verb->get_description()));
    for (const auto* option : verb->get_options())
      out += fmt::format(".TP\n{}\n{}{}\n", name_of(*option), roff(option->get_description()),
                         option->get_required() ? " (required)" : "");
  }
  out += ".SH SCENES\nA scene is a TOML file; its keys, as \\fBcleft scene\\fR lists them:\n";
  for (const auto& key : scene::scene_keys()) {
    if (key.section.starts_with("study")) continue;
    const std::string dotted = fmt::format("{}{}{}", key.section, key.section.empty() ? "" : ".", key.name);
    out += fmt::format(".TP\n\\fB{}\\fR ({})\n{}\n", roff(dotted), roff(std::string(key.type)),
                       roff(std::string(key.meaning)));
  }
  return out + ".SH EXIT STATUS\n" + roff(app.get_footer()) + "\n";
}

std::string options_of(const CLI::App& verb) {
  std::string out;
  for (const auto* option : verb.get_options())
    for (const auto& name : option->get_lnames()) out += " --" + name;
  return out;
}

// What no description tells: which words are files, and that keys follow --set. Keys of cracks and boundaries are those
// of the scene on the line, by their names.
const char* const kCompletion = R"bash(
_cleft_keys() {
  local scene names
  for scene in "${COMP_WORDS[@]}"; do [[ $scene == *.toml && -f $scene ]] && break; done
  names=$([[ -f $scene ]] && awk -F'"' '
    /^ *\[/ { section = $0 ~ /crack/ ? "crack" : $0 ~ /boundary/ ? "boundary" : "" }
    section && /^ *(name|on) *=/ { print section "." $2 "." }' "$scene" | sort -u)
  cleft scene | awk -v names="$names" '
    BEGIN { count = split(names, named, "\n") }
    $1 ~ /^study/ || $1 !~ /[.]/ { next }
    $1 !~ /^(crack|boundary)[.]/ { print $1 "="; next }
    { for (k = 1; k <= count; ++k) {
        section = named[k]; sub(/[.].*/, "", section)
        if (index($1, section ".") == 1) print named[k] substr($1, length(section) + 2) "=" } }'
}

_cleft() {
  local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W "$_cleft_verbs" -- "$current")
  elif [[ $before == --set ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(_cleft_keys)" -- "$current")
    compopt -o nospace 2> /dev/null
  elif [[ $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "${_cleft_options[${COMP_WORDS[1]}]}" -- "$current")
  elif [[ ${COMP_WORDS[1]} == scene ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(cleft scene | cut -d' ' -f1)" -- "$current")
  else
    mapfile -t COMPREPLY < <(compgen -d -- "$current"; compgen -f -X '!*.toml' -- "$current")
    compopt -o filenames 2> /dev/null
  fi
}
complete -F _cleft cleft
)bash";

std::string completion(const CLI::App& app) {
  std::string verbs, options;
  for (const auto* verb : verbs_of(app)) {
    verbs += (verbs.empty() ? "" : " ") + verb->get_name();
    options += fmt::format("  [{}]=\"{}\"\n", verb->get_name(), options_of(*verb).substr(1));
  }
  return fmt::format(
      "# bash completion for cleft, made by `cleft completion`\n_cleft_verbs=\"{}\"\n"
      "declare -gA _cleft_options=(\n{})\n{}",
      verbs, options, kCompletion + 1);
}

void add(CLI::App& app, const char* name, const char* description, std::string (*text)(const CLI::App&), int& result) {
  auto* verb = app.add_subcommand(name, description);
  verb->callback([&app, text, &result] {
    fmt::print("{}", text(app));
    result = kDone;
  });
}

}  // namespace

void add_manual(CLI::App& app, int& result) {
  add(app, "man", "print the manual page", manual, result);
  add(app, "completion", "print the completion for bash: source <(cleft completion)", completion, result);
}

}  // namespace cleft::tools
