// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/stop_key_filter.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QMetaObject>

namespace agv::gui {

StopKeyFilter::StopKeyFilter(QObject* parent) : QObject(parent)
{
    QCoreApplication::instance()->installEventFilter(this);
}

bool StopKeyFilter::eventFilter(QObject*, QEvent* event)
{
    if (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride)
        return false;
    const auto* key = static_cast<QKeyEvent*>(event);
    if ((key->key() != Qt::Key_Escape && key->key() != Qt::Key_Pause) || key->isAutoRepeat() || m_handling)
        return false;
    // One press visits the window, the focus widget and its parents before the event loop turns again.
    m_handling = true;
    QMetaObject::invokeMethod(this, [this] { m_handling = false; }, Qt::QueuedConnection);
    emit stopPressed();
    return false;
}

} // namespace agv::gui
