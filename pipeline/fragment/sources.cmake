# SPDX-License-Identifier: MIT
# The fragment stages.
target_sources(clearpipe_pipeline PRIVATE
  ${CMAKE_CURRENT_LIST_DIR}/chain.cpp
  ${CMAKE_CURRENT_LIST_DIR}/fused.cpp
  ${CMAKE_CURRENT_LIST_DIR}/sample_chain.cpp
  ${CMAKE_CURRENT_LIST_DIR}/select.cpp
  ${CMAKE_CURRENT_LIST_DIR}/usage.cpp
  ${CMAKE_CURRENT_LIST_DIR}/write_srgb.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../simd.cpp)
include(${CMAKE_CURRENT_LIST_DIR}/sample.cmake)
if(CLEARPIPE_SANITIZE)
  # Loops of thousands of vector operations: unoptimised checks of each take the compiler many minutes.
  set_source_files_properties(${CMAKE_CURRENT_LIST_DIR}/fused.cpp ${CMAKE_CURRENT_LIST_DIR}/sample.cpp PROPERTIES COMPILE_OPTIONS "-O1;-fno-sanitize=undefined")
endif()

if(CLEARPIPE_TESTS)
  foreach(test shade fused antialias cube multisample srgb format)
    add_executable(${test}_test ${CMAKE_CURRENT_LIST_DIR}/${test}_test.cpp)
    target_link_libraries(${test}_test PRIVATE clearpipe_pipeline GTest::gtest_main)
    compile_quickly(${test}_test)
    foreach(simd ${simd_targets})
      add_test(NAME ${test}_${simd} COMMAND ${test}_test)
      set_tests_properties(${test}_${simd} PROPERTIES ENVIRONMENT CLEARPIPE_SIMD=${simd})
    endforeach()
  endforeach()
endif()
