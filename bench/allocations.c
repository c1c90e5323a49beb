// SPDX-License-Identifier: MIT
//
// To be preloaded beside bench/scenes: counts the calls that ask for memory, of the program and of
// every library it uses, and tells the program by bench_allocations(). With BENCH_TRACE_ALLOCATIONS
// set, frames between bench_trace_allocations(1) and (0) print where each call comes from.
#include <execinfo.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdlib.h>
#include <unistd.h>

// glibc's own names of its functions.
void* __libc_malloc(size_t size);
void* __libc_calloc(size_t count, size_t size);
void* __libc_realloc(void* block, size_t size);
void* __libc_memalign(size_t alignment, size_t size);

__attribute__((visibility("default"))) long bench_allocations(void);
__attribute__((visibility("default"))) void bench_trace_allocations(int on);

static atomic_long count;
static atomic_int tracing;
static _Thread_local int inside;

long bench_allocations(void) { return atomic_load(&count); }

void bench_trace_allocations(int on) {
  atomic_store(&tracing, on && getenv("BENCH_TRACE_ALLOCATIONS"));
}

static void note(void) {
  atomic_fetch_add_explicit(&count, 1, memory_order_relaxed);
  if (!atomic_load_explicit(&tracing, memory_order_relaxed) || inside) return;
  inside = 1;
  void* places[12];
  const int depth = backtrace(places, 12);
  backtrace_symbols_fd(places + 2, depth - 2, 2);
  static const char end[] = "--\n";
  if (write(2, end, sizeof end - 1) < 0) abort();
  inside = 0;
}

__attribute__((visibility("default"))) void* malloc(size_t size) {
  note();
  return __libc_malloc(size);
}

__attribute__((visibility("default"))) void* calloc(size_t n, size_t size) {
  note();
  return __libc_calloc(n, size);
}

__attribute__((visibility("default"))) void* realloc(void* block, size_t size) {
  note();
  return __libc_realloc(block, size);
}

__attribute__((visibility("default"))) void* memalign(size_t alignment, size_t size) {
  note();
  return __libc_memalign(alignment, size);
}

__attribute__((visibility("default"))) void* aligned_alloc(size_t alignment, size_t size) {
  note();
  return __libc_memalign(alignment, size);
}

__attribute__((visibility("default"))) int posix_memalign(void** block, size_t alignment,
                                                          size_t size) {
  note();
  *block = __libc_memalign(alignment, size);
  return *block ? 0 : 12;  // ENOMEM
}
