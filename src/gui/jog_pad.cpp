// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/jog_pad.h"

#include "gui/hold_watch.h"
#include "gui/jog_button.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QPushButton>

#include <utility>

namespace agv::gui {
namespace {

struct ArrowName {
    JogDirection direction;
    const char* objectName;
    const char* text;
};

const ArrowName arrows[] = {
    {{1, 1}, "jogAheadLeft", QT_TRANSLATE_NOOP("agv::gui::JogPad", "Curve ahead to the left")},
    {{1, 0}, "jogAhead", QT_TRANSLATE_NOOP("agv::gui::JogPad", "Ahead")},
    {{1, -1}, "jogAheadRight", QT_TRANSLATE_NOOP("agv::gui::JogPad", "Curve ahead to the right")},
    {{0, 1}, "jogLeft", QT_TRANSLATE_NOOP("agv::gui::JogPad", "Turn left on the spot")},
    {{0, -1}, "jogRight", QT_TRANSLATE_NOOP("agv::gui::JogPad", "Turn right on the spot")},
    {{-1, 1}, "jogBackLeft", QT_TRANSLATE_NOOP("agv::gui::JogPad", "Curve back to the left")},
    {{-1, 0}, "jogBack", QT_TRANSLATE_NOOP("agv::gui::JogPad", "Back")},
    {{-1, -1}, "jogBackRight", QT_TRANSLATE_NOOP("agv::gui::JogPad", "Curve back to the right")},
};

JogDirection directionOf(int key)
{
    switch (key) {
    case Qt::Key_W:
    case Qt::Key_Up:
        return {1, 0};
    case Qt::Key_S:
    case Qt::Key_Down:
        return {-1, 0};
    case Qt::Key_A:
    case Qt::Key_Left:
        return {0, 1};
    case Qt::Key_D:
    case Qt::Key_Right:
        return {0, -1};
    default:
        return {};
    }
}

int signOf(int value) { return (value > 0) - (value < 0); }

} // namespace

JogPad::JogPad(QWidget* parent) : QWidget(parent), m_stop(new QPushButton(this)), m_watch(new HoldWatch(this))
{
    setFocusPolicy(Qt::StrongFocus);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(6, 6, 6, 6);
    grid->setSpacing(6);
    for (const ArrowName& arrow : arrows) {
        addButton(arrow.direction, arrow.objectName);
        grid->addWidget(m_buttons.last(), 1 - arrow.direction.forward, 1 - arrow.direction.left);
    }
    m_stop->setObjectName(QStringLiteral("jogStopButton"));
    m_stop->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    grid->addWidget(m_stop, 1, 1);
    connect(m_stop, &QPushButton::clicked, this, &JogPad::stopPressed);
    connect(m_watch, &HoldWatch::lost, this, &JogPad::cancel);
    retranslate();
}

void JogPad::addButton(JogDirection direction, const char* name)
{
    auto* button = new JogButton(direction, this);
    button->setObjectName(QString::fromLatin1(name));
    connect(button, &JogButton::gripped, this, [this, button] { onGrip(*button); });
    connect(button, &JogButton::letGo, this, [this] {
        if (m_source == JogSource::Pad)
            cancel(JogReason::Released);
    });
    m_buttons << button;
}

void JogPad::setTheme(const Theme& theme)
{
    m_theme = theme;
    for (JogButton* button : std::as_const(m_buttons))
        button->setTheme(theme);
    update();
}

void JogPad::setDriving(bool drives)
{
    for (JogButton* button : std::as_const(m_buttons))
        button->setDriving(drives);
}

void JogPad::retranslate()
{
    setAccessibleName(tr("Drive pad"));
    setAccessibleDescription(
        tr("Hold W, A, S, D or an arrow key to drive while this pad has the keyboard; space stops this AGV"));
    for (qsizetype i = 0; i < m_buttons.size(); ++i) {
        const QString text = tr(arrows[i].text);
        m_buttons[i]->setAccessibleName(text);
        m_buttons[i]->setToolTip(tr("%1: drives as long as you hold it").arg(text));
    }
    m_stop->setText(tr("Stop"));
    m_stop->setToolTip(
        tr("Stop this AGV, whatever it does (space). Software stop, does not replace the emergency stop."));
}

QWidget* JogPad::lastField() const { return m_stop; }

void JogPad::begin(JogSource source, JogDirection direction)
{
    // Behind another page it may keep the keyboard, but nobody sees what would drive.
    if (visibleRegion().isEmpty())
        return;
    m_source = source;
    showHeld(direction);
    m_watch->start();
    emit pressed(source, direction);
}

void JogPad::cancel(JogReason why)
{
    if (!m_source)
        return;
    m_watch->stop();
    m_source.reset();
    m_keysSpent = !m_keys.isEmpty();
    showHeld({});
    for (JogButton* button : std::as_const(m_buttons))
        button->forget();
    emit released(why);
}

void JogPad::onGrip(const JogButton& button)
{
    setFocus(Qt::MouseFocusReason); // and keep it: losing it ends the hold
    if (m_source) {
        emit refused();
        return;
    }
    begin(JogSource::Pad, button.direction());
}

JogDirection JogPad::keyDirection() const
{
    JogDirection sum;
    for (const int key : m_keys) {
        sum.forward += directionOf(key).forward;
        sum.left += directionOf(key).left;
    }
    return {signOf(sum.forward), signOf(sum.left)};
}

void JogPad::keyPressEvent(QKeyEvent* event)
{
    const bool isShortcut = event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier);
    const bool isDriveKey = directionOf(event->key()) != JogDirection{};
    // A key that reaches the pad from one of its children was meant for that child.
    if (isShortcut || !hasFocus() || (!isDriveKey && event->key() != Qt::Key_Space)) {
        QWidget::keyPressEvent(event);
        return;
    }
    if (event->isAutoRepeat())
        return;
    if (!isDriveKey) {
        emit stopPressed();
        return;
    }
    m_keys << event->key();
    onKeysChanged(true);
}

void JogPad::keyReleaseEvent(QKeyEvent* event)
{
    if (event->isAutoRepeat() || !m_keys.remove(event->key())) {
        QWidget::keyReleaseEvent(event);
        return;
    }
    onKeysChanged(false);
}

void JogPad::onKeysChanged(bool isPress)
{
    const JogDirection direction = keyDirection();
    if (m_keys.isEmpty()) {
        if (m_source == JogSource::Keys)
            cancel(JogReason::Released);
        m_keysSpent = false;
    } else if (m_source == JogSource::Keys) {
        if (direction == JogDirection{})
            return cancel(JogReason::OpposingKeys);
        showHeld(direction);
        emit directionChanged(direction);
    } else if (m_source) {
        m_keysSpent = true;
        if (isPress)
            emit refused();
    } else if (isPress && !m_keysSpent && direction != JogDirection{}) {
        begin(JogSource::Keys, direction);
    }
}

void JogPad::showHeld(JogDirection direction)
{
    for (JogButton* button : std::as_const(m_buttons))
        button->setHeld(m_source && button->direction() == direction);
}

void JogPad::focusInEvent(QFocusEvent* event)
{
    QWidget::focusInEvent(event);
    update();
}

void JogPad::focusOutEvent(QFocusEvent* event)
{
    // Their releases go elsewhere.
    m_keys.clear();
    m_keysSpent = false;
    QWidget::focusOutEvent(event);
    update();
}

void JogPad::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(hasFocus() ? QPen(m_theme.accent, 2) : QPen(m_theme.border, 1));
    painter.setBrush(m_theme.panel);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 8, 8);
}

} // namespace agv::gui
