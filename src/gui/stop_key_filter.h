// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace agv::gui {

/// Emits stopPressed() once for each press of Esc or Pause, whichever widget, menu or dialog of the program
/// has the focus. It never eats the key: closing a dialog with Esc and stopping the AGVs is harmless.
/// An event filter of the application rather than a shortcut, because a modal dialog blocks shortcuts of the
/// window behind it.
class StopKeyFilter : public QObject {
    Q_OBJECT
public:
    explicit StopKeyFilter(QObject* parent = nullptr);

signals:
    void stopPressed();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool m_handling = false; ///< a press is on its way through the widgets
};

} // namespace agv::gui
