#include "system/process.hpp"

#include <cstring>
#include <elf.h>
#include <link.h>

namespace axisc::system {
namespace {

constexpr std::size_t rounded(std::size_t size) {
  return (size + 3) / 4 * 4;
}

/// With the zero after it.
constexpr std::string_view gnu_name{ELF_NOTE_GNU, sizeof ELF_NOTE_GNU};

/// The identity among the notes of a program segment; empty where it is not there.
std::string_view identity_among(std::string_view notes) {
  while (notes.size() >= sizeof(ElfW(Nhdr))) {
    ElfW(Nhdr) note;
    std::memcpy(&note, notes.data(), sizeof(note));
    auto const name = sizeof(note);
    auto const content = name + rounded(note.n_namesz);
    auto const end = content + rounded(note.n_descsz);
    if (end > notes.size()) break;
    bool const is_gnu = notes.substr(name, note.n_namesz) == gnu_name;
    if (is_gnu && note.n_type == NT_GNU_BUILD_ID) return notes.substr(content, note.n_descsz);
    notes.remove_prefix(end);
  }
  return {};
}

/// Looks at the first object, which is the program, and stops there.
int find_identity(dl_phdr_info* object, std::size_t /*size*/, void* identity) {
  for (unsigned i = 0; i < object->dlpi_phnum; ++i) {
    auto const& segment = object->dlpi_phdr[i];
    if (segment.p_type != PT_NOTE) continue;
    // The notes are where the program was loaded.
    // NOLINTNEXTLINE(performance-no-int-to-ptr)
    auto const* const notes = reinterpret_cast<char const*>(object->dlpi_addr + segment.p_vaddr);
    auto const found = identity_among({notes, segment.p_memsz});
    if (!found.empty()) *static_cast<std::string*>(identity) = found;
  }
  return 1;
}

}  // namespace

std::string build_identity() {
  std::string identity;
  ::dl_iterate_phdr(find_identity, &identity);
  return identity;
}

}  // namespace axisc::system
