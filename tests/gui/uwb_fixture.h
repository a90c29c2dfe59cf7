// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gui/hint_table_view.h"
#include "gui/uwb_scenes.h"
#include "gui/window_fixture.h"

#include <QAction>
#include <QDockWidget>

namespace agv::gui {

/// WindowFixture on a plant with a UWB kit that runs, its panels in sight.
class UwbFixture : public WindowFixture {
    Q_OBJECT
protected:
    void open(const PlantLayout& plant)
    {
        m_window = std::make_unique<MainWindow>(plant);
        m_window->resize(1280, 800);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        m_edited.clear();
        QObject::connect(m_window.get(), &MainWindow::uwbEdited, this,
                         [this](const std::vector<UwbAnchor>& anchors, const UwbSettings& settings) {
                             m_edited.emplace_back(anchors, settings);
                         });
    }
    void openRunning()
    {
        open(scenes::uwbPlant());
        m_window->showSnapshot(scenes::uwbRunning());
    }
    void trigger(const char* action) const { find<QAction>(action)->trigger(); }
    void raise(const char* dock) const
    {
        find<QDockWidget>(dock)->raise();
        QCoreApplication::processEvents();
    }
    /// Through the delegate's setModelData(), as a person's input.
    bool enter(const char* table, int row, int column, const QString& text) const
    {
        QAbstractItemModel* model = find<HintTableView>(table)->model();
        return model->setData(model->index(row, column), text, Qt::EditRole);
    }
    QString cell(const char* table, int row, int column) const
    {
        return find<HintTableView>(table)->model()->index(row, column).data().toString();
    }
    bool undoes(const std::vector<UwbAnchor>& anchors, const UwbSettings& settings)
    {
        trigger("undoUwbAction");
        return m_edited.back().first == anchors && m_edited.back().second == settings;
    }

    std::vector<std::pair<std::vector<UwbAnchor>, UwbSettings>> m_edited; ///< uwbEdited(), in order
};

} // namespace agv::gui
