// Numbers held against references. Every comparison is a row of the table that the suite prints when it ends.
#pragma once

#include <source_location>
#include <string>

#include "cleft/support/timer.hpp"

namespace cleft::verification {

/// What a result is held against: a closed form or a law, the numbers of a program that shares nothing with this one,
/// or those of a prototype of the same method.
struct Reference {
  enum class Kind { Exact, Outside, Prototype } kind = Kind::Exact;
  double value = 0.0;
};
inline Reference exact(double value) { return {Reference::Kind::Exact, value}; }
inline Reference outside(double value) { return {Reference::Kind::Outside, value}; }
inline Reference prototype(double value) { return {Reference::Kind::Prototype, value}; }

/// The largest error that is accepted, and why it is not smaller.
struct Tolerance {
  double value = 0.0;
  bool relative = false;  ///< to the reference
  std::string reason;
};
inline Tolerance within(double error, std::string reason) { return {error, false, std::move(reason)}; }
inline Tolerance within_part(double part, std::string reason) { return {part, true, std::move(reason)}; }

struct Comparison {
  std::string subject;  ///< the case
  std::string quantity;
  Reference reference;
  double result = 0.0;
  Tolerance tolerance;
  double seconds = 0.0;  ///< of computing that the result took

  /// Distance from the reference, relative where the tolerance is.
  double error() const;
  /// False for a result that is not a number, too.
  bool holds() const { return error() <= tolerance.value; }
};

/// One case of the suite. Its clock runs from its construction.
class Case {
 public:
  explicit Case(std::string name) : name_(std::move(name)) {}

  /// Adds a row to the table, and fails the running test unless the comparison holds.
  void compare(const std::string& quantity, double result, const Reference& reference, const Tolerance& tolerance,
               const std::source_location& where = std::source_location::current());

 private:
  std::string name_;
  double unused_ = 0.0;
  PhaseTimer clock_{unused_};
};

}  // namespace cleft::verification
