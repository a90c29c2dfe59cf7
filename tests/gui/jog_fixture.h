// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSignalSpy>

#include "gui/jog_pad.h"
#include "gui/window_fixture.h"

#include <QAction>

namespace agv::gui {

/// A window that shows the drive pad, and what it says of the operator's hand.
class JogFixture : public WindowFixture {
    Q_OBJECT
protected:
    void prepare() override
    {
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        find<QAction>("driveAction")->trigger();
        m_window->showSnapshot(scenes::linksUp());
        QTRY_VERIFY(pad()->isVisible() && !pad()->visibleRegion().isEmpty());
        m_pressed = std::make_unique<QSignalSpy>(m_window.get(), &MainWindow::jogPressed);
        m_held = std::make_unique<QSignalSpy>(m_window.get(), &MainWindow::jogHeld);
        m_released = std::make_unique<QSignalSpy>(m_window.get(), &MainWindow::jogReleased);
    }
    JogPad* pad() const { return find<JogPad>("jogPad"); }
    QWidget* arrow(const char* name) const { return find<QWidget>(name); }
    void focusPad() const
    {
        pad()->setFocus();
        QVERIFY(pad()->hasFocus());
    }
    JogCommand lastPress() const { return m_pressed->last()[1].value<JogCommand>(); }

    std::unique_ptr<QSignalSpy> m_pressed, m_held, m_released;
};

} // namespace agv::gui
