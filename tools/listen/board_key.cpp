#include "tools/listen/board_key.hpp"

#include "hal/authentication/key.hpp"
#include "hal/authentication/keyed_verifier.hpp"

namespace articam::listen {

std::shared_ptr<wire::Verifier> make_verifier(const std::string& key_file, const std::string& state_file,
                                              std::string& problem) {
  hal::Key key;
  if (key.load(key_file, problem) != Status::ok) return nullptr;
  auto verifier = std::make_shared<hal::KeyedVerifier>(key);
  if (state_file.empty() || verifier->open(state_file) == Status::ok) return verifier;
  problem = verifier->problem();
  return nullptr;
}

}  // namespace articam::listen
