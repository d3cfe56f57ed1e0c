// The table of a section's keys. A row says all of a key: its name, the member that it fills, its default, what is
// allowed and its help. Reading, JSON and documentation walk the rows.
#pragma once

#include <algorithm>
#include <functional>
#include <variant>

#include "cleft/scene/keys.hpp"
#include "cleft/support/names.hpp"
#include "values.hpp"

namespace cleft::scene {

/// Holds a value itself or, while it may be absent, a std::optional of it.
template <class Held>
struct Optional {
  using Value = Held;
  static constexpr bool is = false;
};
template <class Held>
struct Optional<std::optional<Held>> {
  using Value = Held;
  static constexpr bool is = true;
};

/// A member of what a variant or an optional of a specification holds; its key belongs to that alternative (Row::of).
template <class Alternative, class Holder, class Member>
struct Within {
  Holder holder;
  Member member;

  template <class Spec>
  auto& operator()(Spec& spec) const {
    auto& held = spec.*holder;
    if constexpr (Optional<std::remove_cvref_t<decltype(held)>>::is)
      return std::invoke(member, *held);
    else
      return std::invoke(member, std::get<Alternative>(held));
  }
  auto standard() const {
    static const Alternative alternative{};
    return std::invoke(member, alternative);
  }
};
template <class Alternative, class Holder, class Member>
auto within(Holder holder, Member member) {
  return Within<Alternative, Holder, Member>{holder, member};
}

/// What a specification has before it is read.
template <class Spec, class Member>
auto default_of(const Member& member) {
  const Spec spec;
  if constexpr (requires { member.standard(); })
    return member.standard();
  else
    return std::invoke(member, spec);
}

/// The member is the specification itself: its keys stand in a section of their own in the file only.
inline constexpr auto kItself = [](auto& spec) -> auto& { return spec; };

/// Texts that are their own names.
std::vector<Named<std::string>> texts(std::initializer_list<const char*> all);

/// `help: first (note) | second`
std::string with_names(const std::string& help, const std::vector<std::string>& names);

/// The unit follows the first clause: `radius, m; 0: none`.
std::string with_unit(std::string help, const char* unit);

template <class Spec>
struct Table;

/// How an array of sections is written.
enum class Listed {
  Always,      ///< as an array, even an empty one
  IfAny,       ///< as an array, unless it is empty
  AloneItself  ///< as an array, or as the section itself where there is one only
};

/// A key of a section that describes a `Spec`.
template <class Spec>
struct Row {
  using Read = std::function<void(const Section&, Spec&)>;
  using Write = std::function<void(const Spec&, Json&)>;
  using Describe = std::function<void(const std::string& section, std::vector<Key>&)>;

  std::string name, type, help;
  std::string standard{};             ///< the default as documentation says it
  bool required = false;              ///< wherever it belongs
  std::vector<std::string> owners{};  ///< values of the table's selector that it belongs to; empty: to all
  Read read{};                        ///< of a key that is there
  Read fill{};                        ///< sets a default that follows from what was read before
  Write write{};                      ///< into the section's JSON
  Describe below{};                   ///< the keys of its section

  /// \name Kinds of values. `member` is a pointer to a member, or callable as one; it may be a std::optional.
  ///@{
  template <class Member>
  static Row number(const char* name, Member member, const Allowed& allowed, const std::string& help) {
    return holding(name, "number", with_unit(help, allowed.unit), member,
                   [=](const Section& s) { return s.number(name, allowed); });
  }
  template <class Member>
  static Row integer(const char* name, Member member, const Limits& limits, const std::string& help) {
    return holding(name, "integer", help, member, [=](const Section& s) { return s.integer(name, limits); });
  }
  template <class Member>
  static Row integers(const char* name, Member member, const Limits& limits, const std::string& help) {
    return holding(name, "2 integers", help, member, [=](const Section& s) { return s.integers(name, limits); });
  }
  /// Of a type that Kind knows.
  template <class Member>
  static Row value(const char* name, Member member, const std::string& help) {
    using K = Kind<typename Optional<std::remove_cvref_t<std::invoke_result_t<Member, Spec&>>>::Value>;
    return holding(name, K::type, help, member, [=](const Section& s) { return K::read(s, name); });
  }
  /// One of an enumeration's names, or of the `names` given.
  template <class Member>
  static Row choice(const char* name, Member member, const std::string& help) {
    using Value = typename Optional<std::remove_cvref_t<std::invoke_result_t<Member, Spec&>>>::Value;
    const auto names = names_of(Value{});
    return choice(name, member, std::vector<Named<Value>>(names.begin(), names.end()), help);
  }
  template <class Member, class Value>
  static Row choice(const char* name, Member member, const std::vector<Named<Value>>& names, const std::string& help);
  /// The alternative that a variant holds, by one name for each.
  template <class Variant>
  static Row alternative(const char* name, Variant Spec::*member, std::vector<std::string_view> names,
                         const std::string& help);
  static Row custom(const char* name, const char* type, const std::string& help, Read read, Write write = {}) {
    Row row{name, type, help};
    row.read = std::move(read);
    row.write = std::move(write);
    return row;
  }
  template <class Member, class Sub>
  static Row section(const char* name, Member member, const Table<Sub>& table, const std::string& help);
  template <class Member, class Sub>
  static Row sections(const char* name, Member member, const Table<Sub>& table, Listed listed, const std::string& help);
  ///@}

  /// \name What else is to be said of a key
  ///@{
  Row needed() && { return required = true, standard.clear(), std::move(*this); }
  Row of(std::vector<std::string> values) && { return owners = std::move(values), std::move(*this); }
  /// Says the default in words.
  Row otherwise(std::string words) && { return standard = std::move(words), std::move(*this); }
  /// Sets a default that follows from what was read before; without that it is the specification's own.
  Row filled(Read how) && { return fill = std::move(how), std::move(*this); }
  Row written_if(std::function<bool(const Spec&)> wanted) && {
    write = [inner = std::move(write), wanted = std::move(wanted)](const Spec& spec, Json& j) {
      if (wanted(spec)) inner(spec, j);
    };
    return std::move(*this);
  }
  /// The keys of its section, where it is one.
  template <class Sub>
  Row with_keys_of(const Table<Sub>& table) && {
    below = [&table](const std::string& section, std::vector<Key>& out) { describe(table, section, out); };
    return std::move(*this);
  }
  /// Written into an object of that name.
  Row inside(const char* object) && {
    write = [inner = std::move(write), object](const Spec& spec, Json& j) { inner(spec, j[object]); };
    return std::move(*this);
  }
  ///@}

  Key key(const std::string& section) const {
    std::string meaning = help;
    if (!owners.empty()) meaning = fmt::format("of {}: {}", fmt::join(owners, ", "), help);
    if (!standard.empty()) meaning += "; default " + standard;
    return {section, name, type, meaning};
  }

 private:
  template <class Member, class ReadValue>
  static Row holding(const char* name, const char* type, const std::string& help, Member member, ReadValue read);
};

/// The keys of a section.
template <class Spec>
struct Table {
  std::vector<Row<Spec>> rows;

  /// The key whose value decides which of the others belong to the section.
  struct Selector {
    const char* key = "";
    std::string (*value)(const Spec&) = nullptr;
  } selector{};

  /// Defaults and rules that concern several keys; called once all are read.
  void (*finish)(const Section&, Spec&) = nullptr;

  bool has(const Row<Spec>& row, const Spec& spec) const {
    return row.owners.empty() || std::ranges::find(row.owners, selector.value(spec)) != row.owners.end();
  }
};

/// Says what the key belongs to. `value` is what the selector has; empty: it is absent.
[[noreturn]] void refuse_owner(const Section& s, const std::string& key, const std::vector<std::string>& owners,
                               const std::string& selector, const std::string& value);

/// Fills `spec` from a section, row by row. What is wrong with a key that is there is said before what is missing.
/// Throws InputError.
template <class Spec>
void read(const Table<Spec>& table, const Section& s, Spec& spec) {
  for (const Row<Spec>& row : table.rows) {
    const bool given = s.has(row.name), belongs = table.has(row, spec);
    if (given && !belongs) refuse_owner(s, row.name, row.owners, table.selector.key, table.selector.value(spec));
    if (given) row.read(s, spec);
    if (row.required && row.name == table.selector.key) s.require(row.name);  // before what depends on it
    if (!given && belongs && row.fill) row.fill(s, spec);
  }
  for (const Row<Spec>& row : table.rows)
    if (row.required && table.has(row, spec)) s.require(row.name);
  if (table.finish) table.finish(s, spec);
}

template <class Spec>
Json write(const Table<Spec>& table, const Spec& spec) {
  Json out = Json::object();
  for (const Row<Spec>& row : table.rows)
    if (row.write && table.has(row, spec)) row.write(spec, out);
  return out;
}

/// Appends the keys of a section and of those below it.
template <class Spec>
void describe(const Table<Spec>& table, const std::string& section, std::vector<Key>& out) {
  for (const Row<Spec>& row : table.rows) {
    out.push_back(row.key(section));
    if (row.below) row.below(section.empty() ? row.name : section + "." + row.name, out);
  }
}

/// Reads a section as `spec`, with its place where `Spec` has one.
template <class Spec>
void read_located(const Table<Spec>& table, const Section& s, Spec& spec) {
  if constexpr (requires { spec.at; }) spec.at = s.at();
  read(table, s, spec);
}

template <class Spec>
template <class Member, class ReadValue>
Row<Spec> Row<Spec>::holding(const char* name, const char* type, const std::string& help, Member member,
                             ReadValue read) {
  using Held = Optional<std::remove_cvref_t<std::invoke_result_t<Member, Spec&>>>;
  Row row{name, type, help};
  if constexpr (!Held::is) row.standard = shown(default_of<Spec>(member));
  row.read = [=](const Section& s, Spec& spec) { std::invoke(member, spec) = read(s); };
  row.write = [=](const Spec& spec, Json& j) {
    const auto& value = std::invoke(member, spec);
    if constexpr (!Held::is)
      j[name] = Kind<typename Held::Value>::json(value);
    else if (value)
      j[name] = Kind<typename Held::Value>::json(*value);
  };
  return row;
}

template <class Spec>
template <class Member, class Value>
Row<Spec> Row<Spec>::choice(const char* name, Member member, const std::vector<Named<Value>>& names,
                            const std::string& help) {
  std::vector<std::string_view> allowed;
  std::vector<std::string> noted;
  for (const auto& each : names) {
    allowed.push_back(each.name);
    noted.push_back(std::string(each.name) + (each.note.empty() ? "" : fmt::format(" ({})", each.note)));
  }
  const auto called = [names](const Value& value) {
    const auto at = std::ranges::find(names, value, &Named<Value>::value);
    return at == names.end() ? std::string() : std::string(at->name);
  };
  Row row{name, "text", with_names(help, noted)};
  row.standard = called(default_of<Spec>(member));
  row.read = [=](const Section& s, Spec& spec) { std::invoke(member, spec) = names[s.choice(name, allowed)].value; };
  row.write = [=](const Spec& spec, Json& j) { j[name] = called(std::invoke(member, spec)); };
  return row;
}

/// Makes the variant hold its alternative of that number.
template <class Variant, std::size_t... Number>
void hold(Variant& variant, std::size_t number, std::index_sequence<Number...>) {
  ((number == Number ? static_cast<void>(variant.template emplace<Number>()) : void()), ...);
}

template <class Spec>
template <class Variant>
Row<Spec> Row<Spec>::alternative(const char* name, Variant Spec::*member, std::vector<std::string_view> names,
                                 const std::string& help) {
  Row row{name, "text", with_names(help, {names.begin(), names.end()}), std::string(names.front())};
  row.read = [=](const Section& s, Spec& spec) {
    hold(spec.*member, s.choice(name, names), std::make_index_sequence<std::variant_size_v<Variant>>());
  };
  row.write = [=](const Spec& spec, Json& j) { j[name] = names[(spec.*member).index()]; };
  return row;
}

template <class Spec>
template <class Member, class Sub>
Row<Spec> Row<Spec>::section(const char* name, Member member, const Table<Sub>& table, const std::string& help) {
  using Held = Optional<std::remove_cvref_t<std::invoke_result_t<Member, Spec&>>>;
  Row row{name, "section", help};
  row.read = [=, &table](const Section& s, Spec& spec) {
    if constexpr (Held::is) {
      auto& held = std::invoke(member, spec);
      held = typename Held::Value{};
      read_located(table, *s.section(name), *held);
    } else if constexpr (std::is_same_v<Spec, Sub>)
      scene::read(table, *s.section(name), spec);
    else
      read_located(table, *s.section(name), std::invoke(member, spec));
  };
  row.write = [=, &table](const Spec& spec, Json& j) {
    const auto& held = std::invoke(member, spec);
    if constexpr (!Held::is)
      j[name] = scene::write(table, held);
    else if (held)
      j[name] = scene::write(table, *held);
  };
  return std::move(row).with_keys_of(table);
}

template <class Spec>
template <class Member, class Sub>
Row<Spec> Row<Spec>::sections(const char* name, Member member, const Table<Sub>& table, Listed listed,
                              const std::string& help) {
  Row row{name, "array of sections", help};
  row.read = [=, &table](const Section& s, Spec& spec) {
    for (const Section& each : s.sections(name)) read_located(table, each, std::invoke(member, spec).emplace_back());
  };
  row.write = [=, &table](const Spec& spec, Json& j) {
    Json all = Json::array();
    for (const Sub& each : std::invoke(member, spec)) all.push_back(scene::write(table, each));
    if (listed == Listed::AloneItself && all.size() == 1)
      j[name] = all.front();
    else if (listed != Listed::IfAny || !all.empty())
      j[name] = std::move(all);
  };
  return std::move(row).with_keys_of(table);
}

}  // namespace cleft::scene
