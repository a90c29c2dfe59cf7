// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTest>

#include "gui/application_setup.h"
#include "gui/main_window.h"
#include "gui/scenes.h"

#include <QAbstractButton>
#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>

#include <memory>

namespace agv::gui {

/// A new English window with settings of its own for every test; its parts are found by object name.
class WindowFixture : public QObject {
    Q_OBJECT
protected:
    template<typename T>
    T* find(const char* name) const
    {
        T* found = m_window->findChild<T*>(QString::fromLatin1(name));
        Q_ASSERT(found);
        return found;
    }
    void click(const char* button) const { QTest::mouseClick(find<QAbstractButton>(button), Qt::LeftButton); }

    /// Once the window of a test is there.
    virtual void prepare() {}

    std::unique_ptr<MainWindow> m_window;

private slots:
    void initTestCase()
    {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_settings.path());
        setUpApplication(*qApp, QLocale(QStringLiteral("en_GB")));
    }
    void init()
    {
        QSettings().clear();
        m_window = std::make_unique<MainWindow>(scenes::wholePlant());
        m_window->resize(1280, 800);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        prepare();
    }
    void cleanup()
    {
        m_window.reset();
        setUpApplication(*qApp, QLocale(QStringLiteral("en_GB")));
    }

private:
    QTemporaryDir m_settings;
};

} // namespace agv::gui
