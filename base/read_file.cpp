#include "base/read_file.h"

#include <cstdio>
#include <memory>
#include <system_error>

#include <sys/stat.h>

namespace durer {

std::optional<std::string> read_file(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  struct stat about {};
  if (file == nullptr || fstat(fileno(file.get()), &about) != 0 || S_ISDIR(about.st_mode)) {
    return std::nullopt;
  }
  std::string text;
  // One byte more than the size, so that the end shows at once. Pipes have no size: they grow.
  constexpr std::size_t step = 65536;
  std::size_t room = about.st_size > 0 ? static_cast<std::size_t>(about.st_size) + 1 : step;
  std::size_t size = 0;
  for (;;) {
    text.resize(size + room);
    const std::size_t read = std::fread(text.data() + size, 1, room, file.get());
    size += read;
    if (read < room) break;
    room = size;
  }
  if (std::ferror(file.get()) != 0) return std::nullopt;
  text.resize(size);
  return text;
}

}  // namespace durer
