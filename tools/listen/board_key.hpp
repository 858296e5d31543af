#pragma once
/// @file  The judge of packets for --key.

#include <memory>
#include <string>

#include "hal/wire/authentication.hpp"

namespace articam::listen {

/// From the key file of the board; `state_file`, unless empty, remembers the newest counter over restarts. Null, and
/// `problem` a sentence, when one of both cannot be used, or when this build knows no cryptography.
std::shared_ptr<wire::Verifier> make_verifier(const std::string& key_file, const std::string& state_file,
                                              std::string& problem);

}  // namespace articam::listen
