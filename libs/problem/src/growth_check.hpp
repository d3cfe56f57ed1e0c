// Whether what is to grow can.
#pragma once

#include "cleft/assembly/model.hpp"
#include "cleft/problem/specification.hpp"

namespace cleft::problem {

/// What grows needs a tip, and means around it something to average over. Throws InputError.
void refuse_idle_growth(const Specification& specification, const assembly::Model& model);

}  // namespace cleft::problem
