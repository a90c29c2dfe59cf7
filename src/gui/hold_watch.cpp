// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/hold_watch.h"

#include <QEvent>
#include <QGuiApplication>

namespace agv::gui {

HoldWatch::HoldWatch(QWidget* pad) : QObject(pad), m_pad(pad)
{
    connect(qGuiApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
        if (m_window && state != Qt::ApplicationActive)
            emit lost(state == Qt::ApplicationInactive ? JogReason::FocusLost : JogReason::Suspended);
    });
}

void HoldWatch::start()
{
    stop();
    m_window = m_pad->window();
    m_pad->installEventFilter(this);
    m_window->installEventFilter(this);
}

void HoldWatch::stop()
{
    m_pad->removeEventFilter(this);
    if (m_window)
        m_window->removeEventFilter(this);
    m_window.clear();
}

JogReason HoldWatch::reasonOf(const QObject* watched, const QEvent& event) const
{
    switch (event.type()) {
    case QEvent::FocusOut:
        return watched == m_pad ? JogReason::FocusLost : JogReason::None;
    case QEvent::WindowDeactivate:
        return JogReason::FocusLost;
    case QEvent::WindowBlocked:
        return JogReason::DialogOpened;
    case QEvent::WindowStateChange:
        return m_window->isMinimized() ? JogReason::WindowHidden : JogReason::None;
    case QEvent::Hide:
    case QEvent::Close:
    case QEvent::ParentChange: // the dock was torn off or put back
        return JogReason::WindowHidden;
    case QEvent::EnabledChange:
        return m_pad->isEnabled() ? JogReason::None : JogReason::FocusLost;
    default:
        return JogReason::None;
    }
}

bool HoldWatch::eventFilter(QObject* watched, QEvent* event)
{
    const JogReason why = m_window ? reasonOf(watched, *event) : JogReason::None;
    if (why != JogReason::None)
        emit lost(why);
    return false;
}

} // namespace agv::gui
