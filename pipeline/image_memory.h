// The memory of images, planes, buffer objects and arenas.
//
// Programs that stream - video, text, maps - give an image of the same size anew every frame, and
// buffer objects as well. What the image before it was made of is kept for it: a new image then
// costs neither page faults nor the zeroing of pages by the system. What is kept is bounded, and
// given back when a share group goes or memory runs out.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <new>

namespace clearpipe::pipeline {

// Uninitialised, for vectors to be loaded from as it lies: at multiples of 64 bytes. Large memory
// lies in huge pages where the system has some: the first frame then takes a few page faults
// instead of hundreds, which is most of its time. Throws std::bad_alloc.
void* allocate_memory(size_t bytes);
void free_memory(void* memory, size_t bytes) noexcept;

// The same, from what images of that size have left.
void* allocate_image(size_t bytes);
void free_image(void* memory, size_t bytes) noexcept;

// Gives back what no image uses.
void forget_free_images() noexcept;

// For vectors, and for std::allocate_shared of texels: the texels and the count of those who hold
// them are one piece of memory.
template <typename T>
struct ImageAllocator {
  using value_type = T;
  ImageAllocator() = default;
  template <typename U>
  ImageAllocator(const ImageAllocator<U>&) {}
  T* allocate(size_t count) { return static_cast<T*>(allocate_image(count * sizeof(T))); }
  void deallocate(T* memory, size_t count) noexcept { free_image(memory, count * sizeof(T)); }
  // Elements that get no value are left as they are.
  template <typename U>
  void construct(U* element) noexcept {
    ::new (static_cast<void*>(element)) U;
  }
  template <typename U>
  bool operator==(const ImageAllocator<U>&) const {
    return true;
  }
};

}  // namespace clearpipe::pipeline
