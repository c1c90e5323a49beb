// Validators of fences (NV_fence).
// SPDX-License-Identifier: MIT
#include "api/validate.h"

namespace clearpipe::api::validate {

Invalid set_fence(const Context&, GLuint, GLenum condition) {
  return enum_unless(condition == GL_ALL_COMPLETED_NV,
                     "{1} is not ALL_COMPLETED_NV (NV_fence, 5.X)");
}

Invalid existing_fence(const Context& c, GLuint name) {
  return operation_unless(c.fences.find(name) != nullptr,
                          "{0} is no fence: it was never set (NV_fence, 5.X)");
}

Invalid get_fence(const Context& c, GLuint name, GLenum pname, const GLint*) {
  if (const Invalid wrong = existing_fence(c, name)) return wrong;
  return enum_unless(pname == GL_FENCE_STATUS_NV || pname == GL_FENCE_CONDITION_NV,
                     "{1} is no parameter of fences (NV_fence, 6.1.11)");
}

}  // namespace clearpipe::api::validate
