# stylet_add_plugin(NAME [SOURCES …] [LIBRARIES …]): the whole of a plugin's CMakeLists.txt, in this tree as outside it. Builds NAME.cpp
# and any further SOURCES into NAME.so, in the plugin folder of this tree, or in the folder `plugins` of another's build. Where
# NAME_test.cpp exists, builds that too, with the SOURCES, the contract tests and GoogleTest.
function(stylet_add_plugin name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES")
  add_library(${name} MODULE ${name}.cpp ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE Stylet::sdk ${arg_LIBRARIES})
  # g++'s unique symbols (one std::to_string is enough) would keep a library mapped after core has closed it. A sum that is regrouped or
  # fused differently in two builds would break "same scene, same recording".
  target_compile_options(${name} PRIVATE -ffp-contract=off $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)
  target_link_options(${name} PRIVATE -Wl,-z,defs)
  set_target_properties(${name} PROPERTIES PREFIX "" SUFFIX ".so" CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
    LIBRARY_OUTPUT_DIRECTORY ${STYLET_PLUGIN_OUTPUT_DIRECTORY})
  if(STYLET_SANITIZE)
    target_link_options(${name} PRIVATE -Wl,-z,undefs)    # the sanitizer's runtime lives in the executable
  endif()
  install(TARGETS ${name} LIBRARY DESTINATION lib/stylet/plugins)

  if(NOT EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${name}_test.cpp)
    return()
  endif()
  if(NOT TARGET Stylet::contract)
    if(STYLET_NO_CONTRACT)
      message(STATUS "${name}: its tests are left out, because ${STYLET_NO_CONTRACT}")
    endif()
    return()
  endif()
  add_executable(${name}_test ${name}_test.cpp ${arg_SOURCES})
  target_link_libraries(${name}_test PRIVATE Stylet::contract ${arg_LIBRARIES})
  add_dependencies(${name}_test ${name})
  target_compile_definitions(${name}_test PRIVATE STYLET_PLUGIN_FILE="$<TARGET_FILE:${name}>")
  gtest_discover_tests(${name}_test TEST_PREFIX "plugins/${name}: " DISCOVERY_TIMEOUT 60)
endfunction()
