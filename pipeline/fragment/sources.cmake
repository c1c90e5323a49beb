# SPDX-License-Identifier: MIT
# The fragment stages.
target_sources(clearpipe_pipeline PRIVATE
  ${CMAKE_CURRENT_LIST_DIR}/chain.cpp
  ${CMAKE_CURRENT_LIST_DIR}/fused.cpp
  ${CMAKE_CURRENT_LIST_DIR}/select.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../simd.cpp)
include(${CMAKE_CURRENT_LIST_DIR}/sample.cmake)

if(CLEARPIPE_TESTS)
  add_executable(shade_test ${CMAKE_CURRENT_LIST_DIR}/shade_test.cpp)
  target_link_libraries(shade_test PRIVATE clearpipe_pipeline GTest::gtest_main)
  foreach(simd scalar sse4 avx2 avx512)
    add_test(NAME shade_${simd} COMMAND shade_test)
    set_tests_properties(shade_${simd} PROPERTIES ENVIRONMENT CLEARPIPE_SIMD=${simd})
  endforeach()
endif()
