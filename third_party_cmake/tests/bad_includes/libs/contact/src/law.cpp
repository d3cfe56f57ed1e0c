#include <vector>

#include "cleft/constitutive/hencky.hpp"
#include "cleft/contact/law.hpp"
#include "cleft/geometry/crack.hpp"
