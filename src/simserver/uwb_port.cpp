// SPDX-License-Identifier: GPL-3.0-or-later
#include "simserver/uwb_port.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <poll.h>
#include <termios.h>
#include <unistd.h>
#include <utility>

namespace agv::simserver {
namespace {

namespace fs = std::filesystem;

constexpr Duration untilPlugged = std::chrono::hours(24 * 365);

std::unexpected<Error> ioFailure(const std::string& what, const std::string& why)
{
    return failure(ErrorCode::Io, what + ": " + why);
}

/// A terminal without line discipline: bytes pass as they are and are not echoed. Set at the far end, so
/// that it holds whoever opens the near one.
bool makeRaw(int master)
{
    termios settings{};
    if (::tcgetattr(master, &settings) != 0)
        return false;
    ::cfmakeraw(&settings);
    return ::tcsetattr(master, TCSANOW, &settings) == 0;
}

/// Only after the first opening does the system tell whether somebody has the near end open.
bool openOnce(const char* path)
{
    const int descriptor = ::open(path, O_RDWR | O_NOCTTY | O_CLOEXEC);
    return descriptor >= 0 && ::close(descriptor) == 0;
}

/// The link leads to the old or the new device at every instant.
Result<void> replaceLink(const std::string& target, const std::string& link)
{
    std::error_code error;
    const fs::file_status status = fs::symlink_status(link, error);
    if (fs::exists(status) && !fs::is_symlink(status))
        return failure(ErrorCode::InUse,
                       link + " is there already and is no link: name another path for the UWB port");
    const std::string fresh = link + ".new";
    fs::remove(fresh, error);
    fs::create_symlink(target, fresh, error);
    if (!error)
        fs::rename(fresh, link, error);
    if (error)
        return ioFailure("the link " + link + " to the UWB port cannot be made", error.message());
    return {};
}

} // namespace

Result<std::unique_ptr<UwbPort>> UwbPort::create(simulation::UwbKitSettings settings,
                                                 std::optional<std::string> link, Time start)
{
    std::unique_ptr<UwbPort> port(new UwbPort(std::move(settings), std::move(link), start));
    if (auto opened = port->openTerminal(); !opened)
        return std::unexpected(opened.error());
    return port;
}

UwbPort::UwbPort(simulation::UwbKitSettings settings, std::optional<std::string> link, Time start)
    : m_kit(std::move(settings), start),
      m_link(std::move(link))
{}

UwbPort::~UwbPort() { closeTerminal(); }

Result<void> UwbPort::openTerminal()
{
    m_master = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    std::array<char, 128> path{};
    const bool isGood = m_master >= 0 && ::grantpt(m_master) == 0 && ::unlockpt(m_master) == 0 &&
                        ::ptsname_r(m_master, path.data(), path.size()) == 0 && makeRaw(m_master) &&
                        openOnce(path.data());
    if (!isGood) {
        const std::string why = std::strerror(errno);
        closeTerminal();
        return ioFailure("no pseudo-terminal can be had for the UWB port", why);
    }
    m_path = path.data();
    if (!m_link)
        return {};
    auto linked = replaceLink(m_path, *m_link);
    if (!linked) {
        m_path.clear(); // the link is not ours to remove
        closeTerminal();
    }
    return linked;
}

void UwbPort::closeTerminal()
{
    std::error_code ignored;
    // Another program may have made the link its own by now.
    if (m_link && !m_path.empty() && fs::read_symlink(*m_link, ignored) == m_path)
        fs::remove(*m_link, ignored);
    m_path.clear();
    if (m_master >= 0)
        ::close(std::exchange(m_master, -1));
}

void UwbPort::advance(Time now, std::span<const simulation::UwbTagPlace> tags)
{
    // Where no pseudo-terminal can be had, the next call tries again.
    if (m_backAt && now >= *m_backAt && openTerminal())
        m_backAt.reset();
    if (isPlugged())
        readCommands(now);
    m_kit.step(now, tags);
    const std::vector<simulation::UwbOutput> output = m_kit.take(now);
    if (!isPlugged() || !isOpenedBySomebody())
        return;
    for (const simulation::UwbOutput& piece : output)
        // A reader that does not keep up loses bytes, as on a real port.
        if (::write(m_master, piece.bytes.data(), piece.bytes.size()) < 0)
            return;
}

void UwbPort::unplug(std::optional<Duration> away, Time now)
{
    m_backAt.reset();
    if (away)
        m_backAt = now + *away;
    m_kit.unplug(away.value_or(untilPlugged), now);
    closeTerminal();
}

Result<void> UwbPort::plug(Time now)
{
    if (isPlugged())
        return {};
    if (auto opened = openTerminal(); !opened)
        return opened;
    m_backAt.reset();
    m_kit.unplug(Duration{}, now); // starts anew now
    return {};
}

bool UwbPort::isOpenedBySomebody() const
{
    pollfd state{m_master, POLLOUT, 0};
    return ::poll(&state, 1, 0) >= 0 && (state.revents & POLLHUP) == 0;
}

void UwbPort::readCommands(Time now)
{
    std::array<char, 256> bytes{};
    for (;;) {
        const ssize_t count = ::read(m_master, bytes.data(), bytes.size());
        if (count <= 0)
            return; // nothing more, or nobody has it open
        m_kit.receive({bytes.data(), static_cast<std::size_t>(count)}, now);
    }
}

} // namespace agv::simserver
