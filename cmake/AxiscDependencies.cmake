# Everything comes from packages; setup.sh names the Debian ones, vcpkg.json the same for other systems.
find_package(Boost 1.81 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(fmt 9 REQUIRED)
find_package(CLI11 2.1 REQUIRED)
find_package(Threads REQUIRED)
find_package(valijson REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(sodium REQUIRED IMPORTED_TARGET libsodium)

# Debian's libfmt-dev has no static library: a static program uses the header-only form.
if(AXISC_STATIC)
  set(AXISC_FMT fmt::fmt-header-only)
else()
  set(AXISC_FMT fmt::fmt)
endif()
