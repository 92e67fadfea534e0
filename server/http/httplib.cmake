# The target httplib_header: cpp-httplib's single header, for `#include <httplib.h>`.
# `./run setup` puts it into third_party/ where the system offers a fixed version (docker/install-httplib); elsewhere the
# pinned upstream release is fetched. Plain 0.18.7 lacks fixes that Debian's 0.18.7 carries, hence the newer pin.
set(httplib_dir ${CMAKE_SOURCE_DIR}/third_party/httplib)
if(NOT EXISTS ${httplib_dir}/httplib.h)
  message(STATUS "third_party/httplib/httplib.h is missing (./run setup provides it where it can): fetching cpp-httplib")
  include(FetchContent)
  FetchContent_Declare(httplib
    URL https://github.com/yhirose/cpp-httplib/archive/refs/tags/v0.30.1.tar.gz
    URL_HASH SHA256=2818b183757e29dd52b47a185f0cea9ef2d0fba377d8710b450a26328e51c2fe
    DOWNLOAD_EXTRACT_TIMESTAMP FALSE
    SOURCE_SUBDIR header-only)  # a folder that does not exist: take the files, not the project
  FetchContent_MakeAvailable(httplib)
  set(httplib_dir ${httplib_SOURCE_DIR})
endif()

find_package(Threads REQUIRED)
add_library(httplib_header INTERFACE)
target_include_directories(httplib_header SYSTEM INTERFACE ${httplib_dir})
target_link_libraries(httplib_header INTERFACE Threads::Threads)
