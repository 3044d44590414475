// The program's own memory for small blocks, behind `new` and `delete`.
//
// Scenes are made of very many small things: names, numbers, operands, textures, nodes of objects.
// They come and go by the million while a scene is read, on one thread at a time, and most of them
// stay. So blocks are handed out from lists by size, one set for each thread, without a lock and
// without a header; and their memory is taken from the system in pieces large enough for it to use
// large pages. Freed blocks are kept for the next of their size. Large blocks are malloc's.
#include <sys/mman.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <mutex>
#include <new>

namespace {

constexpr std::size_t largest = std::size_t{1} << 16U;  // bytes of a block
constexpr std::size_t fine = 512;                       // sizes up to here differ by 16 bytes
constexpr std::size_t classes = fine / 16 + 1 + 8 * 7;  // above, by an eighth of a power of two

constexpr unsigned region_bits = 25;  // a region: 32 MiB, aligned
constexpr std::size_t region_size = std::size_t{1} << region_bits;
constexpr std::size_t step = std::size_t{1} << 21U;   // committed at once: a large page
constexpr std::size_t small_steps = 4;                // before large pages are asked for
constexpr unsigned page_bits = 16;                    // blocks of one page have one size
constexpr std::size_t page_size = std::size_t{1} << page_bits;
constexpr std::size_t small = std::size_t{1} << 12U;  // larger blocks come from several pages
constexpr std::size_t pages_of_large = 4;
constexpr unsigned address_bits = 47;

/// The list that blocks of `size` bytes are on; 1 … largest.
constexpr std::size_t class_of(std::size_t size) {
  if (size <= fine) return (size + 15) / 16;
  const auto power = static_cast<unsigned>(std::bit_width(size - 1)) - 1;  // 2^power < size
  const std::size_t eighth = (size - 1) >> (power - 3U);                   // 8 … 15
  return fine / 16 + 1 + 8 * (power - 9) + (eighth - 8);
}

constexpr std::size_t size_of_class(std::size_t c) {
  if (c <= fine / 16) return c * 16;
  const std::size_t k = c - (fine / 16 + 1);
  return (8 + k % 8 + 1) << (k / 8 + 6);
}
static_assert(class_of(largest) == classes - 1 && size_of_class(classes - 1) == largest);
static_assert(size_of_class(class_of(513)) == 576 && size_of_class(class_of(576)) == 576);

struct FreeBlock {
  FreeBlock* next;
};

/// The blocks of one thread.
struct Cache {
  std::array<FreeBlock*, classes> free;
  std::array<char*, classes> next;  // of the page that is being handed out
  std::array<char*, classes> end;
};
thread_local constinit Cache cache{};

/// Pages for all threads, cut from regions.
struct Store {
  std::mutex mutex;
  char* next = nullptr;
  char* committed = nullptr;
  char* end = nullptr;
  std::size_t steps = 0;
};
constinit Store store{};

/// By region: its blocks are ours.
std::array<bool, std::size_t{1} << (address_bits - region_bits)> is_ours{};

/// A region begins with the classes of its pages; its first page has room for that much less.
constexpr std::size_t header_size = region_size / page_size;
static_assert(header_size % 16 == 0);

std::uintptr_t address(const void* p) { return reinterpret_cast<std::uintptr_t>(p); }

std::uint8_t& class_of_page(char* p) {
  const std::uintptr_t within = address(p) % region_size;
  return reinterpret_cast<std::uint8_t*>(p - within)[within >> page_bits];
}

/// Reserves the next region; false if there is none to be had.
bool open_region() {
  void* p = ::mmap(nullptr, 2 * region_size, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE,
                   -1, 0);
  if (p == MAP_FAILED) return false;  // NOLINT: the system's constant
  char* const begin = static_cast<char*>(p);
  const std::size_t skip = (region_size - address(begin) % region_size) % region_size;
  if (skip > 0) ::munmap(begin, skip);
  ::munmap(begin + skip + region_size, region_size - skip);
  store.next = begin + skip;
  store.committed = store.next;
  store.end = store.next + region_size;
  if (address(store.next) >> address_bits != 0) return false;
  is_ours[address(store.next) >> region_bits] = true;
  return true;
}

constexpr std::size_t room_for(std::size_t c) {
  return (size_of_class(c) > small ? pages_of_large : 1) * page_size;
}

/// Room for blocks of class `c`; null if the system gives no more.
char* take_pages(std::size_t c) {
  const std::scoped_lock lock(store.mutex);
  const std::size_t room = room_for(c);
  if (static_cast<std::size_t>(store.end - store.next) < room && !open_region()) return nullptr;
  while (static_cast<std::size_t>(store.committed - store.next) < room) {
    if (::mprotect(store.committed, step, PROT_READ | PROT_WRITE) != 0) return nullptr;
    if (store.steps++ >= small_steps) ::madvise(store.committed, step, MADV_HUGEPAGE);
    store.committed += step;
  }
  char* const first = store.next;
  store.next += room;
  for (char* page = first; page < store.next; page += page_size) {
    class_of_page(page) = static_cast<std::uint8_t>(c);
  }
  return first;
}

/// The first block of new pages.
void* refill(std::size_t c) {
  char* const pages = take_pages(c);
  if (pages == nullptr) return nullptr;
  const std::size_t header = address(pages) % region_size == 0 ? header_size : 0;
  const std::size_t size = size_of_class(c);
  cache.next[c] = pages + header + size;
  cache.end[c] = pages + header + (room_for(c) - header) / size * size;
  return pages + header;
}

void* take_large(std::size_t size) {
  for (;;) {
    if (void* p = std::malloc(size)) return p;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}

void* take(std::size_t size) {
  if (size > largest) return take_large(size);
  const std::size_t c = class_of(size == 0 ? 1 : size);
  if (FreeBlock* const block = cache.free[c]) {
    cache.free[c] = block->next;
    return block;
  }
  if (cache.next[c] != cache.end[c]) {
    char* const block = cache.next[c];
    cache.next[c] += size_of_class(c);
    return block;
  }
  if (void* const block = refill(c)) return block;
  return take_large(size_of_class(c));
}

void give_back(void* p, std::size_t c) {
  auto* const block = static_cast<FreeBlock*>(p);
  block->next = cache.free[c];
  cache.free[c] = block;
}

void give_back(void* p) {
  if (p == nullptr) return;
  if (address(p) >> address_bits != 0 || !is_ours[address(p) >> region_bits]) return std::free(p);
  give_back(p, class_of_page(static_cast<char*>(p)));
}

}  // namespace

void* operator new(std::size_t size) { return take(size); }
void* operator new[](std::size_t size) { return take(size); }
void operator delete(void* p) noexcept { give_back(p); }
void operator delete[](void* p) noexcept { give_back(p); }
void operator delete(void* p, std::size_t) noexcept { give_back(p); }
void operator delete[](void* p, std::size_t) noexcept { give_back(p); }
