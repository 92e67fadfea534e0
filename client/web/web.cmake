# The web client, built by Vite and written into a C++ source: sets web_source. docker/install-web has installed its
# packages and says which Node builds it.
set(web_dir ${CMAKE_SOURCE_DIR}/client/web)
if(NOT EXISTS ${web_dir}/node_modules/raywalk-node)
  message(FATAL_ERROR "The packages of client/web are missing: run docker/install-web, or ./run setup.")
endif()
file(STRINGS ${web_dir}/node_modules/raywalk-node web_node LIMIT_COUNT 1)

set(web_site ${CMAKE_CURRENT_BINARY_DIR}/web)
set(web_source ${CMAKE_CURRENT_BINARY_DIR}/embedded_site.cpp)
file(GLOB_RECURSE web_files CONFIGURE_DEPENDS ${web_dir}/src/* ${web_dir}/public/*)
add_custom_command(OUTPUT ${web_source}
  COMMAND ${web_node} ${web_dir}/build.mjs ${web_site}
  COMMAND ${embed_python} ${web_dir}/embed ${web_site} ${web_source}
  DEPENDS ${web_files} ${web_dir}/index.html ${web_dir}/build.mjs ${web_dir}/embed ${web_dir}/tsconfig.json
    ${web_dir}/package-lock.json ${CMAKE_SOURCE_DIR}/proto/openapi.yaml
  COMMENT "Building the web client" VERBATIM)
