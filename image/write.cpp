// Bytes → file, so that a reader never sees half a picture.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "image/image.h"

namespace durer::image {
namespace {

namespace fs = std::filesystem;

std::string reason() { return std::strerror(errno); }

bool write_all(int fd, std::span<const unsigned char> bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(n));
  }
  return true;
}

/// Opens a new file beside `path`, so that the rename stays within one file system. The umask
/// applies as to any new file, which mkstemp would not do.
int open_beside(const fs::path& path, std::string& name) {
  for (unsigned attempt = 0;; ++attempt) {
    const auto id = static_cast<unsigned>(::getpid());
    name = (path.parent_path() /
            fmt::format(".{}.{:x}-{}.part", path.filename().string(), id, attempt))
               .string();
    const int fd = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd >= 0 || errno != EEXIST || attempt == 100) return fd;
  }
}

/// Errors of a delayed write (quota, network) may only show on closing.
bool write_and_close(int fd, std::span<const unsigned char> bytes) {
  const bool written = write_all(fd, bytes);
  const int error = errno;
  const bool closed = ::close(fd) == 0;
  if (!written) errno = error;
  return written && closed;
}

std::optional<std::string> write_directly(const std::string& path,
                                          std::span<const unsigned char> bytes) {
  const int fd = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (fd < 0 || !write_and_close(fd, bytes)) {
    return fmt::format("cannot write `{}`: {}", path, reason());
  }
  return std::nullopt;
}

std::optional<std::string> replace_file(const fs::path& path,
                                        std::span<const unsigned char> bytes) {
  std::string part;
  const int fd = open_beside(path, part);
  if (fd < 0) return fmt::format("cannot write `{}`: {}", path.string(), reason());
  if (write_and_close(fd, bytes) && std::rename(part.c_str(), path.c_str()) == 0) {
    return std::nullopt;
  }
  const std::string why = reason();
  ::unlink(part.c_str());
  return fmt::format("cannot write `{}`: {}", path.string(), why);
}

/// What stands at a path: a link is followed, so that it stays a link.
struct Target {
  fs::path path;
  bool direct = false;  // a device or a pipe, which cannot be replaced
  std::optional<std::string> error;
};

/// An existing file that may not be written stays, even where its folder would let us replace it.
Target target_of(const std::string& path) {
  std::error_code ignored;
  Target t;
  t.path = fs::is_symlink(path, ignored) ? fs::weakly_canonical(path, ignored) : fs::path(path);
  const fs::file_status status = fs::status(t.path, ignored);
  if (fs::is_directory(status)) {
    t.error = fmt::format("cannot write `{}`: it is a folder", path);
  } else if (fs::exists(status)) {
    if (::access(t.path.c_str(), W_OK) != 0) {
      t.error = fmt::format("cannot write `{}`: {}", path, reason());
    }
    t.direct = !fs::is_regular_file(status);
  }
  return t;
}

}  // namespace

std::optional<std::string> write_file(const std::string& path,
                                      std::span<const unsigned char> bytes) {
  const Target target = target_of(path);
  if (target.error) return target.error;
  return target.direct ? write_directly(path, bytes) : replace_file(target.path, bytes);
}

std::optional<std::string> probe(const std::string& path) {
  if (path.empty() || path == "-") return std::nullopt;
  const Target target = target_of(path);
  if (target.error || target.direct) return target.error;
  std::string part;
  const int fd = open_beside(target.path, part);
  if (fd < 0) return fmt::format("cannot write `{}`: {}", path, reason());
  ::close(fd);
  ::unlink(part.c_str());
  return std::nullopt;
}

std::optional<std::string> write(const Image& image, const std::string& path, const Format& format,
                                 const Encoding& encoding) {
  const Encoded file = format.encode(image, encoding);
  if (file.error) {
    return fmt::format("cannot write `{}` as {}: {}", path, format.name, *file.error);
  }
  if (path != "-") return write_file(path, file.bytes);
  if (write_all(STDOUT_FILENO, file.bytes)) return std::nullopt;
  return fmt::format("cannot write to standard output: {}", reason());
}

}  // namespace durer::image
