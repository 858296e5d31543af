#include "tools/listen/board_key.hpp"

namespace articam::listen {

std::shared_ptr<wire::Verifier> make_verifier(const std::string& key_file, const std::string&, std::string& problem) {
  problem = key_file + ": cannot be used: this program was built without libsodium (package libsodium-dev)";
  return nullptr;
}

}  // namespace articam::listen
