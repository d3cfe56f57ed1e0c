// The makers of the registered fields, which are asked at places that count from `origin`.
#pragma once

#include "cleft/problem/field.hpp"

namespace cleft::problem {

/// Values of a field's parameters, defaults filled in. Throws InputError on one that the field does not have.
struct Parameters {
  const FieldSpec& spec;
  std::map<std::string, double> values;

  Parameters(const FieldSpec& s, std::map<std::string, double> defaults);
  double operator()(const char* key) const { return values.at(key); }
  /// A place whose coordinates are two of them, counted from `origin`.
  Vec2 place(const char* x, const char* y, const Vec2& origin) const;
};

/// A frame with its first axis turned by `degrees` against x.
struct Frame {
  Vec2 origin;
  Mat2 turn;
  Frame(const Vec2& at, double degrees);
  Vec2 local(const Vec2& X) const { return turn.transpose() * (X - origin); }
};

Field mode_one(const FieldSpec& spec, const constitutive::Lame& constants, const Vec2& origin);
Field mode_two(const FieldSpec& spec, const constitutive::Lame& constants, const Vec2& origin);
Field closed_crack(const FieldSpec& spec, const constitutive::Lame& constants, const Vec2& origin);
Field open_crack(const FieldSpec& spec, const constitutive::Lame& constants, const Vec2& origin);
Field waves(const FieldSpec& spec, const constitutive::Lame& constants, const Vec2& origin);
Field parted_waves(const FieldSpec& spec, const constitutive::Lame& constants, const Vec2& origin);

}  // namespace cleft::problem
