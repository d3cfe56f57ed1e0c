#include "cleft/contact/law.hpp"

#include <vector>

#include "cleft/constitutive/hencky.hpp"
#include "cleft/geometry/crack.hpp"
