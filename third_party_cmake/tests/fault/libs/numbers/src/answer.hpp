inline constexpr int kAnswer = 42;
int answer();
