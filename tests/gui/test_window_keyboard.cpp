// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>

#include "gui/map/map_widget.h"
#include "gui/window_fixture.h"

#include <QAccessible>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>

using namespace agv;
using namespace agv::gui;

/// The window without a mouse, and for people who do not see it.
class WindowKeyboardTest : public WindowFixture {
    Q_OBJECT
private slots:
    void escStopsAllWhileATextFieldHasTheFocus();
    void escStopsAllWhileADialogIsOpen();
    void everyControlHasANameAndAToolTip();
    void everyWidgetThatTakesTheKeyboardHasAnAccessibleName();
    void tabVisitsTheFieldsOfACalibrationInReadingOrder();
    void f6WalksThroughThePanels();
    void altAndANumberChooseAnAgv();
    void theToolBarCalibratesTheChosenAgv();
};

void WindowKeyboardTest::escStopsAllWhileATextFieldHasTheFocus()
{
    m_window->showSnapshot(scenes::linksUp());
    QSignalSpy stops(m_window.get(), &MainWindow::stopAllRequested);
    auto* field = find<QSpinBox>("sleeptimeSpin");
    field->setFocus();
    QTest::keyClicks(field, QStringLiteral("12"));
    QTest::keyClick(field, Qt::Key_Escape);
    QCOMPARE(stops.count(), 1);
    // Through the window system as well, where the key passes window, field and parents.
    QCoreApplication::processEvents();
    QTest::keyClick(m_window->windowHandle(), Qt::Key_Escape);
    QCOMPARE(stops.count(), 2);
}

void WindowKeyboardTest::escStopsAllWhileADialogIsOpen()
{
    QSignalSpy stops(m_window.get(), &MainWindow::stopAllRequested);
    find<QAction>("shortcutsAction")->trigger();
    auto* dialog = m_window->findChild<QDialog*>();
    QVERIFY(dialog && dialog->isModal());
    QTest::keyClick(dialog, Qt::Key_Escape);
    QCOMPARE(stops.count(), 1);
}

void WindowKeyboardTest::everyControlHasANameAndAToolTip()
{
    // Push buttons and boxes are ours; tool buttons inside tab bars and docks are Qt's own.
    QList<const QAbstractButton*> buttons;
    for (const QPushButton* button : m_window->findChildren<QPushButton*>())
        buttons << button;
    for (const QCheckBox* box : m_window->findChildren<QCheckBox*>())
        buttons << box;
    QVERIFY(buttons.size() >= 8);
    for (const QAbstractButton* button : buttons) {
        QVERIFY2(!button->text().isEmpty(), qPrintable(button->objectName()));
        QVERIFY2(!button->toolTip().isEmpty(), qPrintable(button->objectName()));
    }
    for (const char* name : {"map", "linkTable", "vehicleTable", "stopTable", "table", "progress"})
        QVERIFY2(!find<QWidget>(name)->accessibleName().isEmpty(), name);
}

void WindowKeyboardTest::everyWidgetThatTakesTheKeyboardHasAnAccessibleName()
{
    m_window->showSnapshot(scenes::ambiguous());
    m_window->showListenFailure(QStringLiteral("in use"));
    find<QTabWidget>("tabs")->setCurrentIndex(1);
    int checked = 0;
    for (QWidget* widget : m_window->findChildren<QWidget*>()) {
        const bool inner = widget->objectName().startsWith(QLatin1String("qt_")) || widget->focusProxy();
        if (inner || !(widget->focusPolicy() & Qt::TabFocus) || !widget->isVisibleTo(m_window.get()))
            continue;
        const QAccessibleInterface* accessible = QAccessible::queryAccessibleInterface(widget);
        QVERIFY2(accessible && !accessible->text(QAccessible::Name).isEmpty(),
                 qPrintable(widget->objectName() + QLatin1Char(' ') +
                            QLatin1String(widget->metaObject()->className())));
        ++checked;
    }
    QVERIFY(checked > 15);
}

void WindowKeyboardTest::tabVisitsTheFieldsOfACalibrationInReadingOrder()
{
    m_window->showSnapshot(scenes::linksUp());
    QWidget* widget = find<QComboBox>("robotCombo");
    widget->setFocus();
    for (const char* next : {"sleeptimeSpin", "kindCombo", "directionCombo", "stopsCombo", "wheelSpeedSpin",
                             "dwellSpin", "adaptiveCheck", "initialiseButton"}) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QCOMPARE(QApplication::focusWidget()->objectName(), QString::fromLatin1(next));
    }
}

void WindowKeyboardTest::f6WalksThroughThePanels()
{
    find<MapWidget>("map")->setFocus();
    for (const char* next : {"linkTable", "robotCombo", "table", "map"}) {
        find<QAction>("nextPanelAction")->trigger();
        QCOMPARE(QApplication::focusWidget()->objectName(), QString::fromLatin1(next));
    }
    find<QDockWidget>("linksDock")->hide();
    find<QAction>("nextPanelAction")->trigger();
    QCOMPARE(QApplication::focusWidget()->objectName(), QStringLiteral("robotCombo"));
}

void WindowKeyboardTest::altAndANumberChooseAnAgv()
{
    QCOMPARE(find<QAction>("chooseAgv3Action")->shortcut(), QKeySequence(Qt::ALT | Qt::Key_3));
    find<QAction>("chooseAgv3Action")->trigger();
    QCOMPARE(find<QComboBox>("robotCombo")->currentText(), QStringLiteral("AGV 3"));
}

void WindowKeyboardTest::theToolBarCalibratesTheChosenAgv()
{
    m_window->showSnapshot(scenes::linksUp());
    find<QComboBox>("robotCombo")->setCurrentIndex(2);
    auto* action = find<QAction>("initialiseAction");
    QCOMPARE(action->iconText(), QStringLiteral("Calibrate AGV 3"));
    QSignalSpy starts(m_window.get(), &MainWindow::startTurnRequested);
    action->trigger();
    QCOMPARE(starts.count(), 1);
    QCOMPARE(starts[0][0].toInt(), 3);
}

QTEST_MAIN(WindowKeyboardTest)
#include "test_window_keyboard.moc"
