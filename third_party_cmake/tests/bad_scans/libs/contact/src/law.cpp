#include "cleft/contact/loading.steps"

// A key such as loading.steps may stand in a comment.
const char* const kAdvice = "smaller increments (loading.steps)";
const char* const kMethod = "or contact.method = \"mortar\"";
const char* const kRaw = R"(of crack[main])";
const char* const kBuilt = "crack.{}";
const char* const kPrefix = "boundary.";
const char* const kInnocent = "a finer mesh. Each increment of the loading.stepsize";
