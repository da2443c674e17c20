// Files of signature keys. A secret key's file is created readable by its owner only, and refused if others
// may read it.
#pragma once

#include "image/signature.hpp"

#include <string>

namespace axisc {

/// Writes the secret key to `path` and the public one to `path`.pub. Failure AX9002, with neither file
/// written, if one of them exists already or cannot be written.
void write_keys(std::string const& path, image::SecretKey const& key);

/// Failure AX9001 for a file that cannot be read, is not a secret key, or is readable by others than its
/// owner.
[[nodiscard]] image::SecretKey load_secret_key(std::string const& path);

/// Failure AX9001 for a file that cannot be read or is not a public key.
[[nodiscard]] image::PublicKey load_public_key(std::string const& path);

/// True for a file that load_secret_key() would read, or refuse only for its permissions.
[[nodiscard]] bool is_secret_key(std::string const& path);

/// Sixteen hexadecimal digits.
[[nodiscard]] std::string key_name(image::KeyId const& id);

}  // namespace axisc
