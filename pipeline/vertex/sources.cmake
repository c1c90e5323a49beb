# The vertex stages (SPDX-License-Identifier: MIT).
target_sources(clearpipe_pipeline PRIVATE
  ${CMAKE_CURRENT_LIST_DIR}/vertex_layout.cpp
  ${CMAKE_CURRENT_LIST_DIR}/vertex_plan.cpp
  ${CMAKE_CURRENT_LIST_DIR}/vertex_stage.cpp)
