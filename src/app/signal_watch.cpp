// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/signal_watch.h"

#include <array>
#include <csignal>
#include <fcntl.h>
#include <unistd.h>

namespace agv::app {
namespace {

// A signal handler can reach nothing but static data; this is the only such thing in the program.
std::array<int, 2> pipeEnds{-1, -1};

// Ctrl-C, kill, the terminal has been closed, Ctrl-backslash.
constexpr std::array watched{SIGINT, SIGTERM, SIGHUP, SIGQUIT};

void onSignal(int number)
{
    const auto byte = static_cast<unsigned char>(number);
    [[maybe_unused]] const auto written = ::write(pipeEnds[1], &byte, 1);
}

void setHandler(void (*handler)(int), int flags)
{
    struct sigaction action{};
    action.sa_handler = handler;
    action.sa_flags = flags;
    ::sigemptyset(&action.sa_mask);
    for (const int number : watched)
        ::sigaction(number, &action, nullptr);
}

} // namespace

SignalWatch::SignalWatch(QObject* parent) : QObject(parent)
{
    if (::pipe2(pipeEnds.data(), O_CLOEXEC | O_NONBLOCK) != 0)
        return;
    m_notifier = std::make_unique<QSocketNotifier>(pipeEnds[0], QSocketNotifier::Read);
    connect(m_notifier.get(), &QSocketNotifier::activated, this, &SignalWatch::onReadable);
    setHandler(onSignal, SA_RESTART | static_cast<int>(SA_RESETHAND));
}

SignalWatch::~SignalWatch()
{
    setHandler(SIG_DFL, 0);
    m_notifier.reset();
    for (int& end : pipeEnds) {
        ::close(end);
        end = -1;
    }
}

void SignalWatch::onReadable()
{
    unsigned char number = 0;
    if (::read(pipeEnds[0], &number, 1) == 1)
        emit caught(number);
}

} // namespace agv::app
