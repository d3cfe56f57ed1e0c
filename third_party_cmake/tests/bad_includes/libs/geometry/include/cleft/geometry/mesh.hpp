#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "cleft/support/types.hpp"
