// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QSocketNotifier>

#include <memory>

namespace agv::app {

/// SIGINT, SIGTERM, SIGHUP and SIGQUIT as a Qt signal, so that the program ends in order: robots stopped,
/// files closed. A second one of the same kind ends it at once. One object per process.
class SignalWatch : public QObject {
    Q_OBJECT
public:
    explicit SignalWatch(QObject* parent = nullptr);
    ~SignalWatch() override;

    /// Exit status of a program that was ended by `number`: 130 for SIGINT, 143 for SIGTERM, 129, 131.
    static int exitStatus(int number) { return 128 + number; }

signals:
    void caught(int number);

private:
    void onReadable();

    std::unique_ptr<QSocketNotifier> m_notifier;
};

} // namespace agv::app
