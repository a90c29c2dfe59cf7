// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/choice_box.h"

#include <QPainter>
#include <QWheelEvent>

namespace agv::gui {

void ChoiceBox::paintEvent(QPaintEvent* event)
{
    QComboBox::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::Text),
                        1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    const QPointF tip(width() - 14.0, 0.5 * height() + 2.0);
    painter.drawPolyline(QPolygonF{tip - QPointF(4.0, 4.0), tip, tip - QPointF(-4.0, 4.0)});
}

// The wheel scrolls the panel; it must not change a setting that happens to lie under the pointer.
void ChoiceBox::wheelEvent(QWheelEvent* event) { event->ignore(); }

} // namespace agv::gui
