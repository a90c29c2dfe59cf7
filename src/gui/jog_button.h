// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>

#include "core/jog.h"
#include "gui/theme.h"

namespace agv::gui {

/// One arrow of the drive pad. Mouse or finger grip it by pressing it and let it go by lifting or by sliding
/// off; sliding back grips nothing. It never takes the keyboard: that belongs to the pad.
class JogButton : public QAbstractButton {
    Q_OBJECT
public:
    JogButton(JogDirection direction, QWidget* parent);

    JogDirection direction() const { return m_direction; }
    void setTheme(const Theme& theme);
    /// The hand points this way, with the mouse or with keys.
    void setHeld(bool held);
    /// The AGV really drives; a held arrow is filled then.
    void setDriving(bool drives);
    /// The hold is over, though mouse or finger are still down; that they lift need not be heard of.
    void forget();
    QSize sizeHint() const override;

signals:
    void gripped();
    void letGo();

protected:
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void grip();
    void drop();
    bool onTouch(QEvent* event);

    JogDirection m_direction;
    Theme m_theme = Theme::light();
    bool m_isGripped = false;
    bool m_isHeld = false;
    bool m_drives = false;
};

} // namespace agv::gui
