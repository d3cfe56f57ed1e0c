#include "answer.hpp"

// A word that stands here twice cannot be replaced: twice.
int answer() { return kAnswer; }
