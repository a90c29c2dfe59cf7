// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QWidget>

#include "core/jog.h"

namespace agv::gui {

/// Notices that the operator's hand no longer counts, though nothing was let go: the pad lost the keyboard,
/// its window was left, hidden, minimised or lies under a dialog, the program was put aside. GUI thread.
class HoldWatch : public QObject {
    Q_OBJECT
public:
    explicit HoldWatch(QWidget* pad);

    /// While a hand holds.
    void start();
    void stop();

signals:
    void lost(agv::JogReason why);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    JogReason reasonOf(const QObject* watched, const QEvent& event) const;

    QWidget* m_pad;
    QPointer<QWidget> m_window; ///< the pad's at the time of start(): its dock may float
};

} // namespace agv::gui
