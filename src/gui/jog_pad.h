// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QSet>
#include <QWidget>

#include "core/jog.h"
#include "gui/theme.h"

#include <optional>

class QPushButton;

namespace agv::gui {

class HoldWatch;
class JogButton;

/// The drive pad: eight arrows for mouse and finger, and W A S D or the arrow keys while the pad itself has
/// the keyboard. Knows what the hand holds and nothing of AGVs. GUI thread.
/// One hand at a time: what comes second is told and ignored. A hold ends when the hand lets go, when
/// HoldWatch finds the hand no longer counts, and when keys cancel each other; after each end only a fresh
/// press begins anew: keys that are still down must all come up first, and key repeats are never a press.
class JogPad : public QWidget {
    Q_OBJECT
public:
    explicit JogPad(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    void retranslate();
    /// The AGV really drives, by whatever the hand holds.
    void setDriving(bool drives);
    QWidget* lastField() const; ///< in the order of the tabulator; the pad itself is the first
    bool isHeld() const { return m_source.has_value(); }
    /// Ends a hold; the hand has to press anew.
    void cancel(JogReason why);

signals:
    void pressed(agv::JogSource source, agv::JogDirection direction);
    void directionChanged(agv::JogDirection direction);
    void released(agv::JogReason why);
    /// A second hand while the first holds.
    void refused();
    void stopPressed();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void addButton(JogDirection direction, const char* name);
    void begin(JogSource source, JogDirection direction);
    void onGrip(const JogButton& button);
    void onKeysChanged(bool isPress);
    JogDirection keyDirection() const;
    void showHeld(JogDirection direction);

    QList<JogButton*> m_buttons;
    QPushButton* m_stop;
    HoldWatch* m_watch;
    QSet<int> m_keys;                  ///< that are down, since the pad has the keyboard
    std::optional<JogSource> m_source; ///< of the hand that holds
    bool m_keysSpent = false;          ///< a hold by keys ended while some were down
    Theme m_theme = Theme::light();
};

} // namespace agv::gui
