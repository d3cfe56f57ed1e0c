// Contact on the faces of the cracks.
#pragma once

#include <vector>

#include "cleft/assembly/model.hpp"
#include "cleft/problem/specification.hpp"

namespace cleft::problem {

/// Stiffness of both methods of contact: a property of the crack, which a later cut of the same crack keeps.
struct ContactScales {
  std::vector<contact::Springs> springs;
  std::vector<contact::Mortar> mortar;
};

/// Gives a model its faces, its contact points and, with mortar contact, its multipliers. The model is cut, its
/// unknowns are numbered, its materials are there. `earlier`: of an earlier cut of the same cracks, or nothing.
void set_up_contact(const Specification& specification, const ContactScales& earlier, assembly::Model& model);

}  // namespace cleft::problem
