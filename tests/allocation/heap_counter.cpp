#include "tests/allocation/heap_counter.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>

namespace {

std::atomic<bool> counting{false};
std::atomic<long> allocations{0};

void note() {
  if (counting) ++allocations;
}

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);

void* malloc(std::size_t size) noexcept {
  note();
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
  note();
  return __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) noexcept {
  note();
  return __libc_realloc(old, size);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept {
  note();
  static const auto original = next<int (*)(void**, std::size_t, std::size_t)>("posix_memalign");
  return original(memory, alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  note();
  static const auto original = next<void* (*)(std::size_t, std::size_t)>("aligned_alloc");
  return original(alignment, size);
}
}

namespace desmo::allocation_test {

void begin_counting() {
  allocations = 0;
  counting = true;
}

long end_counting() {
  counting = false;
  return allocations;
}

namespace {

TEST(Counter, CountsADeliberateAllocation) {
  void* volatile kept = nullptr;
  EXPECT_EQ(count([&] { kept = std::malloc(10); }), 1);
  EXPECT_EQ(count([&] { kept = std::realloc(kept, 1000); }), 1);
  std::free(kept);
  EXPECT_EQ(count([&] { kept = std::calloc(3, 3); }), 1);
  std::free(kept);
  EXPECT_EQ(count([&] { kept = std::aligned_alloc(64, 64); }), 1);
  std::free(kept);
  int* volatile made = nullptr;
  EXPECT_EQ(count([&] { made = new int(1); }), 1);
  delete made;
  EXPECT_EQ(count([] {}), 0);
}

}  // namespace
}  // namespace desmo::allocation_test
