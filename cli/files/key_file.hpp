// Keys for signatures on the disk. A secret key's file is made for its owner alone, and refused where others may read it.
#pragma once

#include "image/signature.hpp"

#include <string>

namespace axisc::cli {

/// Writes the secret key to `path` and the public one to `path`.pub. Failure AX9002, and neither file is there, if one of
/// them exists already or cannot be written.
void write_keys(std::string const& path, image::SecretKey const& key);

/// Failure AX9001 for a file that cannot be read, is no secret key, or may be read by others than its owner.
[[nodiscard]] image::SecretKey load_secret_key(std::string const& path);

/// Failure AX9001 for a file that cannot be read or is no public key.
[[nodiscard]] image::PublicKey load_public_key(std::string const& path);

/// Sixteen hexadecimal digits.
[[nodiscard]] std::string key_name(image::KeyId const& id);

}  // namespace axisc::cli
