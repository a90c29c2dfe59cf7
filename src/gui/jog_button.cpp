// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/jog_button.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QTouchEvent>

#include <utility>

namespace agv::gui {
namespace {

/// A line and the head at its end, for the direction ahead, ahead left, or left, in a square from -1 to 1
/// with y down.
struct Arrow {
    QPainterPath line;
    QPolygonF head;
};

Arrow arrowFor(JogDirection direction)
{
    Arrow arrow;
    if (direction.left == 0) {
        arrow.line.moveTo(0, 0.6);
        arrow.line.lineTo(0, -0.2);
        arrow.head << QPointF(0, -0.65) << QPointF(0.36, -0.15) << QPointF(-0.36, -0.15);
    } else if (direction.forward != 0) {
        arrow.line.moveTo(0.35, 0.6);
        arrow.line.cubicTo(0.35, 0.0, 0.15, -0.25, -0.2, -0.25);
        arrow.head << QPointF(-0.65, -0.25) << QPointF(-0.15, 0.11) << QPointF(-0.15, -0.61);
    } else {
        // Three quarters round the centre, counter-clockwise, ending on the left and pointing down.
        const QRectF circle(-0.48, -0.48, 0.96, 0.96);
        arrow.line.arcMoveTo(circle, -80);
        arrow.line.arcTo(circle, -80, 250);
        arrow.head << QPointF(-0.48, 0.42) << QPointF(-0.82, -0.08) << QPointF(-0.14, -0.08);
    }
    return arrow;
}

} // namespace

JogButton::JogButton(JogDirection direction, QWidget* parent)
    : QAbstractButton(parent),
      m_direction(direction)
{
    setFocusPolicy(Qt::NoFocus);
    setAttribute(Qt::WA_AcceptTouchEvents);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

QSize JogButton::sizeHint() const
{
    const int em = fontMetrics().height();
    return {4 * em, 3 * em};
}

void JogButton::setTheme(const Theme& theme)
{
    m_theme = theme;
    update();
}

void JogButton::setHeld(bool held)
{
    if (std::exchange(m_isHeld, held) != held)
        update();
}

void JogButton::setDriving(bool drives)
{
    if (std::exchange(m_drives, drives) != drives)
        update();
}

void JogButton::forget()
{
    if (std::exchange(m_isGripped, false))
        update();
}

void JogButton::grip()
{
    m_isGripped = true;
    update();
    emit gripped();
}

void JogButton::drop()
{
    if (!std::exchange(m_isGripped, false))
        return;
    update();
    emit letGo();
}

bool JogButton::onTouch(QEvent* event)
{
    const auto* touch = static_cast<QTouchEvent*>(event);
    const bool isInside =
        touch->pointCount() > 0 && rect().contains(touch->points().first().position().toPoint());
    if (event->type() == QEvent::TouchBegin && isEnabled())
        grip();
    else if (event->type() != QEvent::TouchUpdate || !isInside)
        drop();
    event->accept();
    return true;
}

bool JogButton::event(QEvent* event)
{
    switch (event->type()) {
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
        return onTouch(event);
    default:
        break;
    }
    return QAbstractButton::event(event);
}

void JogButton::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        grip();
}

void JogButton::mouseMoveEvent(QMouseEvent* event)
{
    if (!rect().contains(event->position().toPoint()))
        drop();
}

void JogButton::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        drop();
}

/// A button that somebody gave the focus all the same leaves every key to the pad.
void JogButton::keyPressEvent(QKeyEvent* event) { event->ignore(); }

void JogButton::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool isHeld = isEnabled() && (m_isGripped || m_isHeld);
    const bool isFilled = isHeld && m_drives;
    const QColor ink = !isEnabled() ? m_theme.disabledText : isFilled ? m_theme.accentText : m_theme.text;
    const QColor edge = isHeld ? m_theme.accent : isEnabled() ? m_theme.strongBorder : m_theme.border;
    painter.setPen(QPen(edge, isHeld ? 2 : 1));
    painter.setBrush(isFilled                                  ? m_theme.accent
                     : isHeld || (isEnabled() && underMouse()) ? m_theme.sunken
                                                               : m_theme.raised);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 6, 6);
    const Arrow arrow = arrowFor(m_direction);
    const double half = 0.42 * std::min(width(), height());
    painter.translate(QRectF(rect()).center());
    painter.scale(m_direction.left < 0 ? -half : half, m_direction.forward < 0 ? -half : half);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(ink, 0.2, Qt::SolidLine, Qt::FlatCap));
    painter.drawPath(arrow.line);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    painter.drawPolygon(arrow.head);
}

} // namespace agv::gui
