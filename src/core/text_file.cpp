// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text_file.h"

#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <istream>
#include <optional>
#include <ostream>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace agv {
namespace {

class Descriptor {
public:
    explicit Descriptor(int number) : m_number(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() { close(); }

    int number() const { return m_number; }
    bool isOpen() const { return m_number >= 0; }

    /// False when the system reports only now that something was not written.
    bool close()
    {
        const int number = std::exchange(m_number, -1);
        return number < 0 || ::close(number) == 0;
    }

private:
    int m_number;
};

/// Removes the half-made file unless it has become the real one.
class TemporaryName {
public:
    explicit TemporaryName(std::string name) : m_name(std::move(name)) {}
    TemporaryName(const TemporaryName&) = delete;
    TemporaryName& operator=(const TemporaryName&) = delete;
    ~TemporaryName()
    {
        if (!m_name.empty())
            ::unlink(m_name.c_str());
    }
    void release() { m_name.clear(); }

private:
    std::string m_name;
};

std::unexpected<Error> systemFailure(const std::filesystem::path& path, const char* what, int number)
{
    const ErrorCode code = number == ENOENT || number == ENOTDIR                    ? ErrorCode::NotFound
                           : number == EACCES || number == EPERM || number == EROFS ? ErrorCode::Permission
                                                                                    : ErrorCode::Io;
    return failure(code,
                   path.string() + ": cannot be " + what + ": " + std::generic_category().message(number));
}

std::unexpected<Error> tooLarge(const std::filesystem::path& path, std::size_t limit)
{
    return failure(ErrorCode::BadInput, path.string() + ": is larger than " +
                                            std::to_string(limit / (std::size_t{1024} * 1024)) +
                                            " MB; this is hardly the file you meant");
}

bool writeAll(int descriptor, std::string_view text)
{
    while (!text.empty()) {
        const ssize_t written = ::write(descriptor, text.data(), text.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            return false;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

/// The rename itself must reach the disk too; file systems that cannot do it are no reason to fail.
void synchroniseFolder(const std::filesystem::path& folder)
{
    const Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (descriptor.isOpen())
        ::fsync(descriptor.number());
}

mode_t permissionsFor(const std::filesystem::path& target)
{
    struct stat status{};
    if (::stat(target.c_str(), &status) == 0)
        return status.st_mode & 07777;
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return 0666 & ~mask;
}

std::filesystem::path folderOf(const std::filesystem::path& file)
{
    return file.has_parent_path() ? file.parent_path() : ".";
}

/// N of /dev/fd/N, /dev/stdout and the like. Such a link names an open file, not its path: that file may have
/// been opened for appending, or be none that has a path.
std::optional<int> ownDescriptor(const std::filesystem::path& path)
{
    std::error_code error;
    const std::filesystem::path own = "/proc/" + std::to_string(::getpid()) + "/fd";
    if (std::filesystem::canonical(folderOf(path), error) != own)
        return std::nullopt;
    const std::string name = path.filename().string();
    int number = 0;
    const auto [end, wrong] = std::from_chars(name.data(), name.data() + name.size(), number);
    return wrong == std::errc{} && end == name.data() + name.size() ? std::optional(number) : std::nullopt;
}

/// What stands where a text is to go, behind all symbolic links.
struct Target {
    enum class Kind {
        None,         ///< nothing yet
        File,         ///< a regular file
        Device,       ///< a pipe, a terminal, a null device: takes the text and cannot be replaced
        OwnDescriptor ///< a file that this process has open
    };
    Kind kind = Kind::None;
    std::filesystem::path path;
    int descriptor = -1; ///< of OwnDescriptor
};

Result<Target> targetOf(const std::filesystem::path& path)
{
    constexpr int mostLinks = 40; // as the kernel
    Target target{Target::Kind::None, path};
    std::error_code error;
    for (int links = 0; links <= mostLinks; ++links) {
        if (const auto number = ownDescriptor(target.path))
            return Target{Target::Kind::OwnDescriptor, target.path, *number};
        struct stat status{};
        if (::lstat(target.path.c_str(), &status) != 0)
            return target; // what is in the way, writing will tell
        if (S_ISDIR(status.st_mode))
            return failure(ErrorCode::BadInput, path.string() + ": is a directory; name a file in it");
        if (!S_ISLNK(status.st_mode)) {
            target.kind = S_ISREG(status.st_mode) ? Target::Kind::File : Target::Kind::Device;
            return target;
        }
        target.path = folderOf(target.path) / std::filesystem::read_symlink(target.path, error);
        if (error)
            return systemFailure(path, "written", error.value());
    }
    return systemFailure(path, "written", ELOOP);
}

/// Writes beside the file, then renames.
Result<void> replaceFile(const std::filesystem::path& path, const std::filesystem::path& target,
                         std::string_view text)
{
    std::string pattern = target.string() + ".XXXXXX";
    Descriptor descriptor(::mkostemp(pattern.data(), O_CLOEXEC));
    if (!descriptor.isOpen())
        return systemFailure(path, "written", errno);
    TemporaryName temporary(pattern);
    if (::fchmod(descriptor.number(), permissionsFor(target)) != 0 || !writeAll(descriptor.number(), text) ||
        ::fsync(descriptor.number()) != 0 || !descriptor.close() ||
        ::rename(pattern.c_str(), target.c_str()) != 0)
        return systemFailure(path, "written", errno);
    temporary.release();
    synchroniseFolder(folderOf(target));
    return {};
}

/// Writes into what is open as `number`, which is closed; negative: `errno` says why it is not.
Result<void> writeInto(const std::filesystem::path& path, int number, std::string_view text)
{
    Descriptor descriptor(number);
    if (!descriptor.isOpen() || !writeAll(descriptor.number(), text) || !descriptor.close())
        return systemFailure(path, "written", errno);
    return {};
}

enum class OnlyRegular { Yes, No };

/// The rest of what is open as `number`, which is closed; negative: `errno` says why it is not.
Result<std::string> readOpen(const std::filesystem::path& path, int number, std::size_t limit,
                             OnlyRegular onlyRegular)
{
    const Descriptor descriptor(number);
    struct stat status{};
    if (!descriptor.isOpen() || ::fstat(descriptor.number(), &status) != 0)
        return systemFailure(path, "opened", errno);
    if (S_ISDIR(status.st_mode))
        return failure(ErrorCode::BadInput, path.string() + ": is a directory; name a file in it");
    if (onlyRegular == OnlyRegular::Yes && !S_ISREG(status.st_mode))
        return failure(ErrorCode::BadInput, path.string() + ": is not a regular file");
    std::string text;
    std::string block(std::size_t{64} * 1024, '\0');
    while (true) {
        const ssize_t got = ::read(descriptor.number(), block.data(), block.size());
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            return systemFailure(path, "read", errno);
        if (got == 0)
            return text;
        text.append(block, 0, static_cast<std::size_t>(got));
        if (text.size() > limit)
            return tooLarge(path, limit);
    }
}

} // namespace

Result<std::string> readTextFile(const std::filesystem::path& path, std::size_t limit)
{
    // Without O_NONBLOCK the opening of a pipe would wait for a writer for ever.
    return readOpen(path, ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK), limit, OnlyRegular::Yes);
}

Result<std::string> readTextStream(const std::filesystem::path& path, std::size_t limit)
{
    return readOpen(path, ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY), limit, OnlyRegular::No);
}

Result<std::string> readTextStream(std::istream& in, const std::string& name, std::size_t limit)
{
    std::string text;
    std::string block(std::size_t{64} * 1024, '\0');
    while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0) {
        text.append(block, 0, static_cast<std::size_t>(in.gcount()));
        if (text.size() > limit)
            return tooLarge(name, limit);
    }
    if (in.bad())
        return systemFailure(name, "read", errno);
    return text;
}

Result<void> flushStandardOutput(std::ostream& out)
{
    if (out) // else `errno` is still that of the writing
        errno = 0;
    if (out.flush())
        return {};
    return errno != 0 ? systemFailure("standard output", "written", errno)
                      : failure(ErrorCode::Io, "standard output: cannot be written");
}

Result<void> checkWritable(const std::filesystem::path& path)
{
    const Result<Target> target = targetOf(path);
    if (!target)
        return std::unexpected(target.error());
    const auto allows = [](const std::filesystem::path& what) {
        return ::faccessat(AT_FDCWD, what.c_str(), W_OK, AT_EACCESS) == 0;
    };
    const bool isNew = target->kind == Target::Kind::None;
    const bool isReplaced = isNew || target->kind == Target::Kind::File;
    if (target->kind != Target::Kind::OwnDescriptor &&
        ((!isNew && !allows(target->path)) || (isReplaced && !allows(folderOf(target->path) / "."))))
        return systemFailure(path, "written", errno);
    return {};
}

Result<void> writeTextFile(const std::filesystem::path& path, std::string_view text)
{
    if (Result<void> writable = checkWritable(path); !writable)
        return writable;
    const Result<Target> target = targetOf(path);
    if (!target)
        return std::unexpected(target.error());
    switch (target->kind) {
    case Target::Kind::None:
    case Target::Kind::File:
        return replaceFile(path, target->path, text);
    case Target::Kind::Device:
        return writeInto(path, ::open(target->path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY), text);
    case Target::Kind::OwnDescriptor:
        return writeInto(path, ::fcntl(target->descriptor, F_DUPFD_CLOEXEC, 0), text);
    }
    return {};
}

} // namespace agv
