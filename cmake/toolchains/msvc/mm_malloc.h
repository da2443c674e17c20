/* The intrinsics of Clang ask for it; MSVC has its own. */
