# The web client, built by Vite and written into a C++ source: sets web_source. Node is the system's if it is new
# enough, else the one of docker/install-web, which also installs the packages.
foreach(candidate node ${CMAKE_SOURCE_DIR}/third_party/node/bin/node)
  execute_process(COMMAND ${candidate} -e
    "const [a, b] = process.versions.node.split('.').map(Number); process.exit((a === 20 && b >= 19) || (a === 22 && b >= 12) || a > 22 ? 0 : 1)"
    RESULT_VARIABLE too_old OUTPUT_QUIET ERROR_QUIET)
  if(too_old EQUAL 0)
    set(web_node ${candidate})
    break()
  endif()
endforeach()
set(web_dir ${CMAKE_SOURCE_DIR}/client/web)
if(NOT web_node OR NOT EXISTS ${web_dir}/node_modules/raywalk-stamp)
  message(FATAL_ERROR "Node 20.19 or newer, or a package of client/web, is missing: run docker/install-web, or ./run setup.")
endif()

set(web_site ${CMAKE_CURRENT_BINARY_DIR}/web)
set(web_source ${CMAKE_CURRENT_BINARY_DIR}/embedded_site.cpp)
file(GLOB_RECURSE web_files CONFIGURE_DEPENDS ${web_dir}/src/* ${web_dir}/public/*)
add_custom_command(OUTPUT ${web_source}
  COMMAND ${web_node} ${web_dir}/build.mjs ${web_site}
  COMMAND ${embed_python} ${web_dir}/embed ${web_site} ${web_source}
  DEPENDS ${web_files} ${web_dir}/index.html ${web_dir}/build.mjs ${web_dir}/embed ${web_dir}/tsconfig.json
    ${web_dir}/package-lock.json ${CMAKE_SOURCE_DIR}/proto/openapi.yaml
  COMMENT "Building the web client" VERBATIM)
