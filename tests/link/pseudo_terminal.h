// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <cstdlib>
#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

namespace agv {

/// The device end of a serial line: what is written here arrives at path(), and the other way round. It is
/// unplugged when it ends.
class PseudoTerminal {
public:
    PseudoTerminal() : m_master(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC))
    {
        char name[128] = "";
        termios settings{};
        m_isGood = m_master >= 0 && ::grantpt(m_master) == 0 && ::unlockpt(m_master) == 0 &&
                   ::ptsname_r(m_master, name, sizeof name) == 0 && ::tcgetattr(m_master, &settings) == 0;
        ::cfmakeraw(&settings);
        m_isGood = m_isGood && ::tcsetattr(m_master, TCSANOW, &settings) == 0;
        m_path = QString::fromLocal8Bit(name);
    }
    ~PseudoTerminal()
    {
        if (m_master >= 0)
            ::close(m_master);
    }
    PseudoTerminal(const PseudoTerminal&) = delete;
    PseudoTerminal& operator=(const PseudoTerminal&) = delete;

    bool isGood() const { return m_isGood; }
    int descriptor() const { return m_master; } ///< to write from another thread
    const QString& path() const { return m_path; }
    bool write(const QByteArray& bytes)
    {
        return ::write(m_master, bytes.constData(), static_cast<std::size_t>(bytes.size())) == bytes.size();
    }
    /// What has arrived by now.
    QByteArray read()
    {
        char bytes[4096];
        const ssize_t count = ::read(m_master, bytes, sizeof bytes);
        return {bytes, std::max<ssize_t>(count, 0)};
    }

private:
    int m_master;
    bool m_isGood = false;
    QString m_path;
};

} // namespace agv
