#include "validator/loading/unreadable_file.hpp"

namespace axisc::validator::says {

constexpr Sentence not_found{"the file \"{file}\" does not exist", "die Datei „{file}“ gibt es nicht"};
constexpr Sentence is_folder{"\"{file}\" is a folder", "„{file}“ ist ein Ordner"};
constexpr Sentence no_permission{"access to the file \"{file}\" is denied",
                                 "der Zugriff auf die Datei „{file}“ ist verweigert"};
constexpr Sentence not_readable{"the file \"{file}\" cannot be read", "die Datei „{file}“ ist nicht lesbar"};
constexpr Sentence too_large{"the file \"{file}\" is larger than 1 GiB",
                             "die Datei „{file}“ ist größer als 1 GiB"};
constexpr Sentence line_too_long{"the file \"{file}\" has a line of more than 1 MiB",
                                 "die Datei „{file}“ hat eine Zeile von mehr als 1 MiB"};
constexpr Sentence binary{"the file \"{file}\" is not a text file", "die Datei „{file}“ ist keine Textdatei"};
constexpr Sentence utf16{"the file \"{file}\" is UTF-16; lists are UTF-8 or windows-1252",
                         "die Datei „{file}“ ist UTF-16; Listen sind UTF-8 oder windows-1252"};
constexpr Sentence not_regular{"\"{file}\" is not a regular file", "„{file}“ ist keine gewöhnliche Datei"};
constexpr Sentence link_loop{"the symbolic links of \"{file}\" lead in a circle",
                             "die symbolischen Links von „{file}“ führen im Kreis"};
constexpr Sentence image{"the file \"{file}\" is a coefficient image, not a list",
                         "die Datei „{file}“ ist ein Koeffizientenabbild, keine Liste"};

}  // namespace axisc::validator::says

namespace axisc::validator {

SentenceRef sentence_of(configuration::FileError error) {
  switch (error) {
    case configuration::FileError::not_found: return says::not_found;
    case configuration::FileError::is_folder: return says::is_folder;
    case configuration::FileError::no_permission: return says::no_permission;
    case configuration::FileError::not_readable: return says::not_readable;
    case configuration::FileError::too_large: return says::too_large;
    case configuration::FileError::line_too_long: return says::line_too_long;
    case configuration::FileError::binary: return says::binary;
    case configuration::FileError::utf16: return says::utf16;
    case configuration::FileError::image: return says::image;
    case configuration::FileError::not_regular: return says::not_regular;
    case configuration::FileError::link_loop: return says::link_loop;
  }
  return says::not_readable;
}

}  // namespace axisc::validator
