// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/display_probe.h"

#include <QGuiApplication>

#include <array>
#include <csignal>
#include <cstdlib>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace agv::app {
namespace {

constexpr unsigned patience_s = 10;

std::string variable(const char* name)
{
    const char* const value = std::getenv(name);
    return value ? value : "";
}

/// What the operator set and Qt tries: "the display ":0" (DISPLAY)"; empty when nothing is set.
std::string triedDisplay()
{
    struct Source {
        const char* variable;
        const char* what;
    };
    constexpr std::array sources{Source{"QT_QPA_PLATFORM", "the platform"}, Source{"DISPLAY", "the display"},
                                 Source{"WAYLAND_DISPLAY", "the display"}};
    std::string text;
    for (const Source& source : sources) {
        const std::string value = variable(source.variable);
        if (value.empty())
            continue;
        text += (text.empty() ? "" : " and ") + std::string(source.what) + " \"" + value + "\" (" +
                source.variable + ")";
    }
    return text;
}

/// The child: ends with 0 once Qt has its display, otherwise by Qt's abort or the alarm. Silently, the parent
/// says it in one line; without a core dump.
[[noreturn]] void tryDisplay()
{
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere >= 0) {
        ::dup2(nowhere, STDOUT_FILENO);
        ::dup2(nowhere, STDERR_FILENO);
    }
    std::signal(SIGABRT, [](int) { ::_exit(1); });
    std::signal(SIGALRM, SIG_DFL);
    ::alarm(patience_s);
    int count = 1;
    char name[] = "agv-console";
    char* arguments[] = {name, nullptr};
    const QGuiApplication application(count, arguments);
    ::_exit(0);
}

} // namespace

std::optional<std::string> displayTrouble()
{
    const std::string tried = triedDisplay();
    if (tried.empty())
        return "no display is set (DISPLAY and WAYLAND_DISPLAY are empty)";
    const pid_t child = ::fork();
    if (child < 0)
        return "no process could be started to look for the display: " + std::string(std::strerror(errno));
    if (child == 0)
        tryDisplay();
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR)
            return "the process that looked for the display was lost: " + std::string(std::strerror(errno));
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
        return std::nullopt;
    const bool timedOut = WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM;
    return tried + (timedOut ? " did not answer within " + std::to_string(patience_s) + " s"
                             : " cannot be used: it is not there or refuses this user");
}

} // namespace agv::app
