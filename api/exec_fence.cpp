// Fences (NV_fence). A fence is passed when the frame it was set in has been executed. Nobody else
// would execute it, so asking does: a program that asks again and again comes to an end.
// SPDX-License-Identifier: MIT
#include "api/exec.h"
#include "api/validate.h"

namespace clearpipe::api::exec {

void gen_fences(Context& c, GLsizei n, GLuint* names) {
  for (GLsizei i = 0; i < n; ++i) names[i] = c.fences.generate();
}

void delete_fences(Context& c, GLsizei n, const GLuint* names) {
  for (GLsizei i = 0; i < n; ++i) c.fences.erase(names[i]);
}

GLboolean is_fence(Context& c, GLuint name) { return c.fences.find(name) != nullptr; }

void set_fence(Context& c, GLuint name, GLenum condition) {
  FenceObject& fence = *c.fences.bind(name);
  fence.condition = condition;
  fence.frame = c.clock->now();
}

// The one call that returns something other than zero when it is refused.
GLboolean test_fence(Context& c, GLuint name) {
  if (const Invalid wrong = validate::existing_fence(c, name)) {
    c.set_error(wrong);
  } else {
    finish_fence(c, name);
  }
  return GL_TRUE;
}

void finish_fence(Context& c, GLuint name) {
  if (!c.clock->is_over(c.fences.find(name)->frame)) c.finish_frame(Slow::kWaits);
}

void get_fence(Context& c, GLuint name, GLenum pname, GLint* params) {
  *params = pname == GL_FENCE_STATUS_NV ? test_fence(c, name)
                                        : static_cast<GLint>(c.fences.find(name)->condition);
}

}  // namespace clearpipe::api::exec
