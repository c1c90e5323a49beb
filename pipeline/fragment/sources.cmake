# SPDX-License-Identifier: MIT
# The fragment stages.
target_sources(clearpipe_pipeline PRIVATE
  ${CMAKE_CURRENT_LIST_DIR}/chain.cpp
  ${CMAKE_CURRENT_LIST_DIR}/select.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../simd.cpp)
include(${CMAKE_CURRENT_LIST_DIR}/sample.cmake)
