// The state tables: each variable of state_table.def has its initial value, is read in every type
// with the conversions of 6.1.2, is set by each of its calls, and alone.
// SPDX-License-Identifier: MIT
#include "api/state_table.h"

#include <algorithm>
#include <iostream>
#include <set>
#include <string>

#include "api/call_fixture.h"

namespace clearpipe::api {
namespace {

using StateTables = CallTest;

// What the queries of a row write when it has those values, and that they write nothing behind.
void expect_answers(const Answers& a, const StateRow& row, const std::vector<double>& values,
                    const std::string& where) {
  const size_t count = values.size();
  for (size_t k = 0; k <= count; ++k) {
    const bool behind = k == count;
    const std::string at = where + " [" + std::to_string(k) + "]";
    const double value = behind ? Answers::kUntouched : values[k];
    if (a.has_boolean) {
      EXPECT_EQ(a.boolean[k], behind ? Answers::kUntouched : value != 0) << at;
    }
    if (a.has_integer) {
      EXPECT_EQ(a.integer[k], behind ? Answers::kUntouched : as_integer(row.kind, value)) << at;
    }
    if (a.has_fixed) {
      EXPECT_EQ(a.fixed[k], behind ? Answers::kUntouched : as_fixed(row.kind, value)) << at;
    }
    if (a.has_float) {
      EXPECT_EQ(a.number[k], static_cast<GLfloat>(value)) << at;
    }
  }
}

// Variables that are one, or that follow from one another.
const std::set<GLenum> kTogether[] = {
    {GL_MODELVIEW_MATRIX, GL_MODELVIEW_MATRIX_FLOAT_AS_INT_BITS_OES},
    {GL_PROJECTION_MATRIX, GL_PROJECTION_MATRIX_FLOAT_AS_INT_BITS_OES},
    {GL_TEXTURE_MATRIX, GL_TEXTURE_MATRIX_FLOAT_AS_INT_BITS_OES},
    {GL_AMBIENT, GL_DIFFUSE, GL_COLOR_MATERIAL},
    {GL_BLEND_SRC, GL_BLEND_SRC_RGB_OES, GL_BLEND_SRC_ALPHA_OES},
    {GL_BLEND_DST, GL_BLEND_DST_RGB_OES, GL_BLEND_DST_ALPHA_OES},
    {GL_BUFFER_SIZE, GL_BUFFER_MAPPED_OES},
    {GL_FRAMEBUFFER_BINDING_OES, GL_RED_BITS, GL_GREEN_BITS, GL_BLUE_BITS, GL_ALPHA_BITS,
     GL_DEPTH_BITS, GL_STENCIL_BITS},
    {GL_RENDERBUFFER_WIDTH_OES, GL_RENDERBUFFER_HEIGHT_OES, GL_RENDERBUFFER_INTERNAL_FORMAT_OES,
     GL_RENDERBUFFER_RED_SIZE_OES, GL_RENDERBUFFER_GREEN_SIZE_OES, GL_RENDERBUFFER_BLUE_SIZE_OES,
     GL_RENDERBUFFER_ALPHA_SIZE_OES, GL_RENDERBUFFER_DEPTH_SIZE_OES,
     GL_RENDERBUFFER_STENCIL_SIZE_OES},
    {GL_VERTEX_ARRAY_BINDING_OES, GL_MATRIX_INDEX_ARRAY_SIZE_OES, GL_WEIGHT_ARRAY_SIZE_OES},
};
bool together(GLenum a, GLenum b) {
  return a == b || std::any_of(std::begin(kTogether), std::end(kTogether), [&](const auto& names) {
           return names.count(a) != 0 && names.count(b) != 0;
         });
}

// After a setter of `set` and `instance`, all else reads as `before`.
void expect_nothing_else(const StateRow& set, GLenum instance, const std::vector<Answers>& before,
                         const std::string& where) {
  const std::vector<Answers> after = ask_all();
  size_t next = 0;
  for (const StateRow& row : state_rows()) {
    const Instances of = instances(row.query);
    for (GLenum i = of.first; i < of.end; ++i, ++next) {
      // Both faces have one material.
      const bool same = together(row.name, set.name) &&
                        (i == instance || row.query != set.query || row.query == Query::kMaterial);
      if (same) continue;
      EXPECT_TRUE(before[next] == after[next]) << where << " changes " << row.text() << " " << i;
    }
  }
}

TEST_F(StateTables, InitialValuesInEveryType) {
  std::set<std::pair<GLenum, Query>> variables;
  size_t values = 0;
  for (const StateRow& row : state_rows()) {
    variables.insert({row.name, row.query});
    const Instances of = instances(row.query);
    for (GLenum i = of.first; i < of.end; ++i, ++values) {
      expect_answers(ask(row, i), row, row.initial, row.text() + " " + std::to_string(i));
      EXPECT_ERROR(GL_NO_ERROR) << row.text();
      if (row.query == Query::kGet && row.kind == Kind::kBoolean && row.initial.size() == 1) {
        const GLboolean enabled = glIsEnabled(row.name);
        if (glGetError() == GL_NO_ERROR) {
          EXPECT_EQ(enabled, row.initial[0] != 0) << row.text();
        }
      }
    }
  }
  std::cout << "state: " << variables.size() << " variables, " << values << " with their units\n";
}

TEST_F(StateTables, EveryCallSetsItsVariableAlone) {
  // The initial sizes of these arrays are 0, which no call could bring back (OES_matrix_palette).
  glMatrixIndexPointerOES(4, GL_UNSIGNED_BYTE, 0, nullptr);
  glWeightPointerOES(4, GL_FLOAT, 0, nullptr);
  const std::vector<Answers> initial = ask_all();
  size_t setters = 0;
  for (const StateRow& row : state_rows()) {
    const Instances of = instances(row.query);
    for (GLenum i = of.first; i < of.end; ++i) {
      for (size_t n = 0; n < row.setters.size(); ++n) {
        const std::string where =
            row.text() + " " + std::to_string(i) + ", call " + std::to_string(n);
        const auto set = [&](StateRow::Setter setter, const std::vector<double>& values) {
          const Selected selected(row.query, i);
          setter(Given(row.kind, values), i);
        };
        set(row.setters[n], row.other);
        expect_answers(ask(row, i), row, row.other, where);
        expect_nothing_else(row, i, initial, where);
        set(row.setters[0], row.initial);  // the form that is exact
        EXPECT_TRUE(ask_all() == initial) << where;
        EXPECT_ERROR(GL_NO_ERROR) << where;
        if (HasFailure()) return;
      }
    }
    setters += row.setters.size();
  }
  std::cout << "state: " << setters << " calls that set it\n";
}

TEST_F(StateTables, EveryQueryHasARow) {
  const GLenum kQueries[] = {
#define QUERY(name, kind, ...) name,
#include "api/queries.def"
#undef QUERY
  };
  for (const GLenum name : kQueries) {
    EXPECT_TRUE(std::any_of(state_rows().begin(), state_rows().end(),
                            [name](const StateRow& row) { return row.name == name; }))
        << std::hex << name;
  }
}

}  // namespace
}  // namespace clearpipe::api
