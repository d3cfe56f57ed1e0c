#include "cleft/results/checkpoint.hpp"

#include <zlib.h>

#include <stdexcept>

#include "targets.hpp"

namespace cleft::fuzz {

void checkpoint(Bytes bytes) {
  const auto refused = [](const std::string& text) {
    try {
      (void)results::checkpoint_from(text, "file");
      return false;
    } catch (const std::runtime_error&) {
      return true;
    }
  };
  const std::string body(bytes.begin(), bytes.end());
  (void)refused(body);

  // with the first line and the checksum right, what is between them is read
  static const std::string whole = results::to_bytes({});
  std::string text = whole.substr(0, whole.find('\n') + 1) + body;
  const auto sum = static_cast<std::uint32_t>(
      crc32(0L, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size())));
  text.append(reinterpret_cast<const char*>(&sum), sizeof sum);
  if (refused(text)) return;
  require(results::checkpoint_from(results::to_bytes(results::checkpoint_from(text, "file")), "file").outputs.size() <=
              text.size(),
          "what was read is written and read again");
}

}  // namespace cleft::fuzz
