# WebAssembly by Debian's emscripten: cmake --preset wasm. Its C++ library is that of LLVM 13 and lacks some
# of C++20, which wasm/library.hpp adds.
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
set(CMAKE_C_FLAGS_INIT "-fwasm-exceptions")
set(CMAKE_CXX_FLAGS_INIT "-fwasm-exceptions -include ${CMAKE_CURRENT_LIST_DIR}/wasm/library.hpp")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-fwasm-exceptions")
