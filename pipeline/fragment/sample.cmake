# SPDX-License-Identifier: MIT
# Texture sampling and its test.
target_sources(clearpipe_pipeline PRIVATE ${CMAKE_CURRENT_LIST_DIR}/sample.cpp)
if(CLEARPIPE_TESTS)
  add_executable(sample_test ${CMAKE_CURRENT_LIST_DIR}/anisotropic_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/sample_test.cpp)
  target_link_libraries(sample_test PRIVATE clearpipe_pipeline PkgConfig::HWY GTest::gtest_main)
  compile_quickly(sample_test)
  add_test(NAME sample_test COMMAND sample_test)
endif()
