// The steady clock: time stands still within a frame and goes on by 1/HZ after it, so that a
// program which moves things by the time draws the same on every run. Who sleeps lets it go on by
// as much, without sleeping; who only asks again and again lets it go on a little, or would wait
// for ever. SPDX-License-Identifier: MIT
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#include "tools/validate/capture/capture.h"

#define EXPORT __attribute__((visibility("default")))

enum { kNanoseconds = 1000000000, kPatience = 100000, kNudge = 1000000 };

static int64_t frame_length = 0;  // 0: the real clock
static int64_t start_time = 0, start_steady = 0;
static _Atomic int64_t passed = 0;
static _Atomic int asked = 0;  // since the clock has moved

__attribute__((constructor)) static void start(void) {
  const char* text = getenv("CLEARPIPE_CAPTURE_CLOCK");
  double frequency = 0;
  long long time = 0, steady = 0;
  if (!text || sscanf(text, "%lf %lld %lld", &frequency, &time, &steady) != 3) return;
  if (frequency <= 0) return;
  start_time = (int64_t)time * kNanoseconds;
  start_steady = (int64_t)steady * kNanoseconds;
  frame_length = (int64_t)(kNanoseconds / frequency);
}

static bool is_steady(void) { return frame_length > 0 && capture_inside == 0; }

static void advance(int64_t by) {
  passed += by;
  asked = 0;
}

void capture_clock_advance(void) {
  if (frame_length > 0) advance(frame_length);
}

static int64_t start_of(clockid_t clock) {
  return clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE || clock == CLOCK_TAI
             ? start_time
             : start_steady;
}

static int64_t now(clockid_t clock) {
  if (++asked > kPatience) advance(kNudge);
  return start_of(clock) + passed;
}

EXPORT int clock_gettime(clockid_t clock, struct timespec* time) {
  static int (*real)(clockid_t, struct timespec*);
  if (!real) *(void**)&real = capture_dlsym(RTLD_NEXT, "clock_gettime");
  // The processor's time of a process or thread is not what moves pictures.
  if (!is_steady() || clock == CLOCK_PROCESS_CPUTIME_ID || clock == CLOCK_THREAD_CPUTIME_ID ||
      clock < 0) {
    return real(clock, time);
  }
  const int64_t t = now(clock);
  time->tv_sec = (time_t)(t / kNanoseconds);
  time->tv_nsec = (long)(t % kNanoseconds);
  return 0;
}

EXPORT int gettimeofday(struct timeval* restrict time, void* restrict zone) {
  static int (*real)(struct timeval*, void*);
  if (!real) *(void**)&real = capture_dlsym(RTLD_NEXT, "gettimeofday");
  if (!is_steady()) return real(time, zone);
  const int64_t t = now(CLOCK_REALTIME);
  time->tv_sec = (time_t)(t / kNanoseconds);
  time->tv_usec = (suseconds_t)(t % kNanoseconds / 1000);
  return 0;
}

EXPORT time_t time(time_t* result) {
  static time_t (*real)(time_t*);
  if (!real) *(void**)&real = capture_dlsym(RTLD_NEXT, "time");
  if (!is_steady()) return real(result);
  const time_t t = (time_t)(now(CLOCK_REALTIME) / kNanoseconds);
  if (result) *result = t;
  return t;
}

// Sleeping. Only the thread that began the program may move the clock, others really sleep: when
// they do is another matter on every run.
static bool sleeps_steadily(void) { return is_steady() && gettid() == getpid(); }

static int64_t length_of(const struct timespec* time) {
  return (int64_t)time->tv_sec * kNanoseconds + time->tv_nsec;
}

EXPORT int nanosleep(const struct timespec* time, struct timespec* rest) {
  static int (*real)(const struct timespec*, struct timespec*);
  if (!real) *(void**)&real = capture_dlsym(RTLD_NEXT, "nanosleep");
  if (!sleeps_steadily()) return real(time, rest);
  advance(length_of(time));
  return 0;
}

EXPORT int clock_nanosleep(clockid_t clock, int flags, const struct timespec* time,
                           struct timespec* rest) {
  static int (*real)(clockid_t, int, const struct timespec*, struct timespec*);
  if (!real) *(void**)&real = capture_dlsym(RTLD_NEXT, "clock_nanosleep");
  if (!sleeps_steadily()) return real(clock, flags, time, rest);
  const int64_t length = length_of(time) - (flags & TIMER_ABSTIME ? start_of(clock) + passed : 0);
  if (length > 0) advance(length);
  return 0;
}

EXPORT int usleep(useconds_t time) {
  static int (*real)(useconds_t);
  if (!real) *(void**)&real = capture_dlsym(RTLD_NEXT, "usleep");
  if (!sleeps_steadily()) return real(time);
  advance((int64_t)time * 1000);
  return 0;
}
