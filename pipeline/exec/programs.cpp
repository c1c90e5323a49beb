// Programs by state: see programs.h.
// SPDX-License-Identifier: MIT
#include "pipeline/exec/programs.h"

#include <bit>

namespace clearpipe::pipeline {

namespace {

template <typename... Values>
uint64_t packed(Values... values) {
  uint64_t bits = 0;
  ((bits = bits << 6 ^ static_cast<uint64_t>(values)), ...);
  return bits;
}

uint64_t mixed(uint64_t hash, uint64_t bits) {
  hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
  return hash ^ hash >> 29;
}

// Of what programs change by often from draw to draw; equality has the last word.
uint64_t hash_of(const FragmentState& s) {
  uint64_t hash = packed(s.blend.enabled, s.blend.src_rgb, s.blend.dst_rgb, s.blend.src_alpha,
                         s.blend.dst_alpha, s.blend.rgb, s.depth_test, s.depth_write, s.depth_func);
  hash = mixed(hash, packed(s.alpha_test, s.alpha_func, s.colour_mask, s.fog, s.stencil.enabled,
                            s.stencil.func, s.stencil.fail, s.stencil.depth_fail, s.stencil.pass));
  hash = mixed(hash, packed(s.logic_op_enabled, s.logic_op, s.stencil.reference) ^
                         uint64_t{std::bit_cast<uint32_t>(s.alpha_reference)} << 32);
  if (s.fog != FogMode::kNone) {
    hash = mixed(hash, uint64_t{std::bit_cast<uint32_t>(s.fog_density)} << 32 ^
                           std::bit_cast<uint32_t>(s.fog_end));
    hash = mixed(hash, uint64_t{std::bit_cast<uint32_t>(s.fog_colour.x)} << 32 ^
                           std::bit_cast<uint32_t>(s.fog_colour.y));
  }
  for (const TextureUnit& unit : s.unit) {
    if (!unit.enabled) continue;
    const Sampler& sampler = unit.sampler;
    hash = mixed(hash, std::bit_cast<uintptr_t>(unit.image.get()));
    hash = mixed(hash, packed(sampler.min, sampler.mag, sampler.mip, sampler.wrap_s, sampler.wrap_t,
                              unit.combiner.rgb, unit.combiner.alpha));
    hash = mixed(hash, uint64_t{std::bit_cast<uint32_t>(unit.constant.x)} << 32 ^
                           std::bit_cast<uint32_t>(unit.constant.y));
    hash = mixed(hash, uint64_t{std::bit_cast<uint32_t>(unit.constant.z)} << 32 ^
                           std::bit_cast<uint32_t>(unit.constant.w));
  }
  return hash;
}

}  // namespace

void ProgramHolder::assign(const FragmentState& state, const FragmentTarget& target) {
  copy_fragment_state(state, state_);
  target_ = target;
  made_.fill(false);
  draw_states_ = {};
}

const FragmentProgram* ProgramHolder::program(FragmentCoverage coverage) {
  const auto i = static_cast<size_t>(coverage);
  if (!made_[i]) {
    if (programs_[i]) {
      remake_fragment_program(*programs_[i], state_, target_, coverage);
    } else {
      programs_[i].reset(make_fragment_program(state_, target_, coverage));
    }
    made_[i] = true;
  }
  return programs_[i].get();
}

void ProgramHolder::release_images() {
  for (TextureUnit& unit : state_.unit) unit.image.reset();
}

ProgramHolder& ProgramTable::find(const FragmentState& state, const FragmentTarget& target) {
  if (slots_.empty()) {
    taken_.reserve(kMaxStates + 1);
    slots_.resize(kSlots);
  }
  size_t slot = hash_of(state) & (kSlots - 1);
  for (; slots_[slot] != 0; slot = (slot + 1) & (kSlots - 1)) {
    ProgramHolder& holder = *holders_[slots_[slot] - 1];
    if (holder.is_of(state, target)) return holder;
  }
  if (used_ == holders_.size()) holders_.push_back(std::make_unique<ProgramHolder>());
  ProgramHolder& holder = *holders_[used_];
  holder.assign(state, target);
  taken_.push_back(static_cast<uint16_t>(slot));
  slots_[slot] = static_cast<uint16_t>(++used_);
  return holder;
}

void ProgramTable::reset() {
  for (size_t i = 0; i < used_; ++i) holders_[i]->release_images();
  for (const uint16_t slot : taken_) slots_[slot] = 0;
  taken_.clear();
  used_ = 0;
}

}  // namespace clearpipe::pipeline
