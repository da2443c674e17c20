# The runtime as MSVC would see it, without MSVC: clang-cl with the few headers that it needs, and with every
# identifier refused that GCC and Clang have and MSVC does not. Builds the library (.ci/msvc makes a DLL of
# it): cmake --preset msvc
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR AMD64)
set(CMAKE_C_COMPILER clang-cl-14)
set(CMAKE_CXX_COMPILER clang-cl-14)
set(CMAKE_C_COMPILER_TARGET x86_64-pc-windows-msvc)
set(CMAKE_CXX_COMPILER_TARGET x86_64-pc-windows-msvc)
set(CMAKE_LINKER lld-link)
set(CMAKE_AR llvm-lib-14)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_MSVC_RUNTIME_LIBRARY "")
set(headers "${CMAKE_CURRENT_LIST_DIR}/msvc")
set(CMAKE_C_FLAGS_INIT "/GS- /Zl -I${headers}")
set(CMAKE_CXX_FLAGS_INIT "/GS- /Zl -I${headers} /FI${headers}/refused.h")
