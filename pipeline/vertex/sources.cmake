# The vertex stages (SPDX-License-Identifier: MIT).
target_sources(clearpipe_pipeline PRIVATE
  ${CMAKE_CURRENT_LIST_DIR}/vertex_layout.cpp
  ${CMAKE_CURRENT_LIST_DIR}/vertex_plan.cpp
  ${CMAKE_CURRENT_LIST_DIR}/vertex_stage.cpp)

if(CLEARPIPE_TESTS)
  add_executable(vertex_test
    ${CMAKE_CURRENT_LIST_DIR}/vertex_test_kernels.cpp
    ${CMAKE_CURRENT_LIST_DIR}/fetch_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/lighting_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/math_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/palette_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/record_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/transform_test.cpp)
  target_link_libraries(vertex_test PRIVATE clearpipe_pipeline GTest::gtest GTest::gtest_main)
  compile_together(vertex_test ${CMAKE_CURRENT_LIST_DIR}/vertex_test_kernels.cpp)
  compile_quickly(vertex_test)
  add_test(NAME vertex_test COMMAND vertex_test)
endif()
